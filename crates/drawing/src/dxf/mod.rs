//! DXF as text: pairs of lines, a code and its value. Entities are read by a handful of codes, which have been the same since 1988.

mod arc;
mod entity;
mod pairs;
mod write;

use std::collections::BTreeSet;

use entity::{Entity, Line};
pub(crate) use write::write;

use self::pairs::{Pair, pairs, text_of};
use crate::chain::join;
use crate::{Drawing, DrawingError, Reading, Shape, Unit, Why};

/// Reads polygons and lines of the model space.
pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Drawing, DrawingError> {
    let text = text_of(bytes)?;
    let pairs = pairs(&text)?;
    let told = unit(&pairs);
    let unit = reading.unit.or(told);
    let metres = unit.map_or(1.0, Unit::metres);
    let hidden = hidden_layers(&pairs);
    let mut drawing = Drawing { unit, ..Drawing::default() };
    let (mut shapes, mut lines) = (Vec::new(), Vec::new());
    let mut corners = 0;
    for entity in entities(&pairs)? {
        let layer = entity.layer();
        if hidden.contains(&layer) {
            drawing.leave_out(&layer, entity.kind, Why::other("its layer is off or frozen"));
            continue;
        }
        match entity.line(metres, reading.chord_m)? {
            Ok(Line { shape, has_arcs }) => {
                drawing.has_chords |= has_arcs;
                corners += shape.corners.len();
                if corners > crate::MOST_CORNERS {
                    let (what, limit) = ("corners", crate::MOST_CORNERS);
                    return Err(DrawingError::TooLarge { what, count: corners, limit });
                }
                match shape.outline {
                    crate::Outline::Closed => shapes.push(shape),
                    crate::Outline::Open | crate::Outline::Unsaid => lines.push(shape),
                }
            }
            Err(why) => drawing.leave_out(&layer, entity.kind, why),
        }
    }
    shapes.extend(join(lines, reading.join_m));
    shapes.retain(|shape: &Shape| shape.corners.len() > 1);
    drawing.shapes = shapes;
    Ok(drawing)
}

/// The unit of `$INSUNITS`; `None` if there is none, or it is none of ours.
fn unit(pairs: &[Pair<'_>]) -> Option<Unit> {
    let at = pairs.iter().position(|pair| pair.code == 9 && pair.value == "$INSUNITS")?;
    let number: u16 = pairs.get(at + 1).filter(|pair| pair.code == 70)?.value.trim().parse().ok()?;
    Unit::ALL.into_iter().find(|unit| unit.of_dxf() == number)
}

/// Names of layers that are off (a negative colour) or frozen.
fn hidden_layers(pairs: &[Pair<'_>]) -> BTreeSet<String> {
    let layers = section(pairs, "TABLES").split(|pair| pair.code == 0).zip(names(section(pairs, "TABLES")));
    let hidden = layers.filter_map(|(pairs, kind)| {
        let value = |code: i32| pairs.iter().find(|pair| pair.code == code).map(|pair| pair.value.trim());
        let is_hidden = || {
            let number = |code| value(code).and_then(|text| text.parse::<i32>().ok()).unwrap_or_default();
            number(62) < 0 || number(70) & 1 == 1
        };
        (kind == "LAYER" && is_hidden()).then(|| value(2).map(pairs::unescaped))?
    });
    hidden.collect()
}

/// What stands behind each code 0, beside the pairs up to the next one; those before the first have no name.
fn names<'a>(pairs: &[Pair<'a>]) -> impl Iterator<Item = &'a str> {
    let names: Vec<&str> = pairs.iter().filter(|pair| pair.code == 0).map(|pair| pair.value.trim()).collect();
    std::iter::once("").chain(names)
}

/// Pairs of a section; none if it is missing.
fn section<'p, 'a>(pairs: &'p [Pair<'a>], name: &str) -> &'p [Pair<'a>] {
    let is_it = |two: &[Pair<'_>]| {
        two[0].code == 0
            && two[0].value.trim() == "SECTION"
            && two[1].code == 2
            && two[1].value.trim() == name
    };
    let Some(from) = pairs.windows(2).position(is_it) else { return &[] };
    let rest = &pairs[from + 2..];
    let to = rest.iter().position(|pair| pair.code == 0 && pair.value.trim() == "ENDSEC");
    &rest[..to.unwrap_or(rest.len())]
}

/// All entities, vertices with the polyline that they belong to.
fn entities<'p, 'a>(pairs: &'p [Pair<'a>]) -> Result<Vec<Entity<'p, 'a>>, DrawingError> {
    let pairs = section(pairs, "ENTITIES");
    if pairs.is_empty() {
        return Err(DrawingError::Kind("it has no section ENTITIES; save it as DXF again".into()));
    }
    let mut found: Vec<Entity<'p, 'a>> = Vec::new();
    for (pairs, kind) in pairs.split(|pair| pair.code == 0).zip(names(pairs)).skip(1) {
        match (kind, found.last_mut()) {
            ("VERTEX", Some(last)) if last.kind == "POLYLINE" => last.vertices.push(pairs),
            ("VERTEX" | "SEQEND" | "ATTRIB", _) => {}
            _ => found.push(Entity { kind, pairs, vertices: Vec::new() }),
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests;
