//! Which fields of a type tell what: by their names and what they hold, whatever the type is called.

use super::Kind;
use super::plan::{Part, Plan};
use super::points;
use crate::definition::{Base, Definition, Field, Shape, Structure};

/// How a message of this type is read, if it is of a kind.
pub(super) fn reading(definition: &Definition) -> Option<(Kind, Plan)> {
    find(definition, 0, &mut vec![None; definition.count()])
}

/// How the stamp of a message is found: in its header, or as a field of the name.
pub(super) fn stamp(definition: &Definition) -> Option<Plan> {
    let root = definition.root();
    let (place, part) = root.fields.iter().enumerate().find_map(|(place, field)| {
        let part = about(definition, field);
        (!matches!(part, Part::Other)).then_some((place, part))
    })?;
    // What comes after it need not be walked over.
    let mut fields = vec![Part::Other; place];
    fields.push(part);
    Some(Plan { structure: 0, fields })
}

type Found = Option<(Kind, Plan)>;

/// A type of a kind, or one that wraps such a type beside a header and plain values. `known` remembers what was looked at, since a type may
/// stand in many places.
fn find(definition: &Definition, number: usize, known: &mut Vec<Option<Found>>) -> Found {
    if let Some(Some(found)) = known.get(number) {
        return found.clone();
    }
    let structure = definition.structure(number);
    let found = own(definition, number, structure).or_else(|| wrapped(definition, number, structure, known));
    if let Some(place) = known.get_mut(number) {
        *place = Some(found.clone());
    }
    found
}

fn own(definition: &Definition, number: usize, structure: &Structure) -> Found {
    let mut plan = blank(number, structure);
    if let [field] = structure.fields.as_slice()
        && field.name == "data"
        && (field.base, field.shape) == (Base::Text, Shape::One)
    {
        plan.fields = vec![Part::Text];
        return Some((Kind::Text, plan));
    }
    if let Some((names, name)) = structure.field("name")
        && let Some((positions, position)) = structure.field("position")
        && name.base == Base::Text
        && is_float(position)
        && name.shape != Shape::One
        && position.shape != Shape::One
    {
        for (place, field) in structure.fields.iter().enumerate() {
            let part = if place == names {
                Part::Names
            } else if place == positions {
                Part::Positions
            } else {
                about(definition, field)
            };
            put(&mut plan, place, part);
        }
        return Some((Kind::Joints, plan));
    }
    if let Some(found) = points::parts(definition, structure) {
        for (place, field) in structure.fields.iter().enumerate() {
            put(&mut plan, place, about(definition, field));
        }
        for (place, part) in found {
            put(&mut plan, place, part);
        }
        return Some((Kind::Points, plan));
    }
    if let [_, _] = structure.fields.as_slice() {
        for (name, from) in [("force", 0), ("torque", 3)] {
            let (place, field) = structure.field(name)?;
            put(&mut plan, place, Part::Inside(vector(definition, field, from)?));
        }
        return Some((Kind::Wrench, plan));
    }
    None
}

fn wrapped(
    definition: &Definition,
    number: usize,
    structure: &Structure,
    known: &mut Vec<Option<Found>>,
) -> Found {
    let mut plan = blank(number, structure);
    let mut payload = None;
    for (place, field) in structure.fields.iter().enumerate() {
        if field.shape != Shape::One {
            return None;
        }
        let part = match (about(definition, field), field.base) {
            (Part::Other, Base::Structure(inner)) if payload.is_none() => {
                let (kind, inner) = find(definition, inner, known)?;
                payload = Some(kind);
                Part::Inside(inner)
            }
            (Part::Other, Base::Structure(_)) => return None,
            (part, _) => part,
        };
        put(&mut plan, place, part);
    }
    payload.map(|kind| (kind, plan))
}

/// What a field that is no measurement tells about one.
fn about(definition: &Definition, field: &Field) -> Part {
    match header(definition, field) {
        Some(plan) => Part::Inside(plan),
        None if is_stamp(field) => Part::Stamp,
        None => Part::Other,
    }
}

/// A header has a stamp and a frame, and else plain values.
pub(super) fn header(definition: &Definition, field: &Field) -> Option<Plan> {
    let (Base::Structure(number), Shape::One) = (field.base, field.shape) else { return None };
    let structure = definition.structure(number);
    let (stamp, _) = structure.fields.iter().enumerate().find(|(_, field)| is_stamp(field))?;
    let (frame, named) = structure.field("frame_id")?;
    let plain = |field: &Field| field.shape == Shape::One && !matches!(field.base, Base::Structure(_));
    if named.base != Base::Text || !structure.fields.iter().all(plain) {
        return None;
    }
    let mut plan = blank(number, structure);
    put(&mut plan, stamp, Part::Stamp);
    put(&mut plan, frame, Part::Frame);
    Some(plan)
}

fn vector(definition: &Definition, field: &Field, from: usize) -> Option<Plan> {
    let (Base::Structure(number), Shape::One) = (field.base, field.shape) else { return None };
    let structure = definition.structure(number);
    let mut plan = blank(number, structure);
    if structure.fields.len() != 3 {
        return None;
    }
    for (i, name) in ["x", "y", "z"].into_iter().enumerate() {
        let (place, field) = structure.field(name)?;
        if !is_float(field) || field.shape != Shape::One {
            return None;
        }
        put(&mut plan, place, Part::Number(from + i));
    }
    Some(plan)
}

fn is_stamp(field: &Field) -> bool {
    field.name == "stamp" && (field.base, field.shape) == (Base::Time, Shape::One)
}

fn is_float(field: &Field) -> bool {
    matches!(field.base, Base::Float32 | Base::Float64)
}

fn blank(number: usize, structure: &Structure) -> Plan {
    Plan { structure: number, fields: vec![Part::Other; structure.fields.len()] }
}

fn put(plan: &mut Plan, place: usize, part: Part) {
    if let Some(field) = plan.fields.get_mut(place) {
        *field = part;
    }
}
