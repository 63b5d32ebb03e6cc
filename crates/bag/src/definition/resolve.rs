use std::collections::BTreeMap;

use super::line::{What, line};
use super::sections::Sections;
use super::{Base, Definition, Field, Ros, Shape, Structure, known, short_name};

/// Most types inside a type.
const MOST_TYPES: usize = 1000;
/// Most fields of all of them together.
const MOST_FIELDS: usize = 20_000;
/// Deepest nesting. Messages of ROS have 8 levels or so.
const MOST_LEVELS: usize = 32;

/// Looks up all types inside a type.
///
/// # Errors
/// In words.
pub(super) fn resolve(ros: Ros, message_type: &str, sections: &Sections<'_>) -> Result<Definition, String> {
    let mut lookup = Lookup::default();
    lookup.number(&short_name(message_type));
    let mut fields = 0;
    let mut next = 0;
    while let Some(name) = lookup.names.get(next).cloned() {
        let own = match next {
            // Writers that found no definition leave the text empty.
            0 => (!sections.first.trim().is_empty()).then_some(sections.first),
            _ => sections.others.get(&name).copied(),
        };
        let body = own
            .or_else(|| known::body(ros, &name))
            .ok_or_else(|| format!("the recording has no definition of the type {name}"))?;
        let package = name.split('/').next().unwrap_or_default();
        let mut structure = Structure { name: name.clone(), fields: Vec::new() };
        for text in body.lines() {
            let Some(line) = line(ros, package, text)? else { continue };
            fields += 1;
            let base = match line.what {
                What::Plain(base) => base,
                What::Named(name) => Base::Structure(lookup.number(&name)),
            };
            structure.fields.push(Field { name: line.name, base, shape: line.shape });
        }
        lookup.structures.push(structure);
        if lookup.names.len() > MOST_TYPES || fields > MOST_FIELDS {
            return Err(format!(
                "its definition has more than {MOST_TYPES} types or {MOST_FIELDS} fields, more than any message"
            ));
        }
        next += 1;
    }
    let mut structures = lookup.structures;
    let mut levels = vec![Level::Unknown; structures.len()];
    measure(ros, &mut structures, &mut levels, 0, 0)?;
    Ok(Definition { structures })
}

#[derive(Default)]
struct Lookup {
    names: Vec<String>,
    numbers: BTreeMap<String, usize>,
    structures: Vec<Structure>,
}

impl Lookup {
    fn number(&mut self, name: &str) -> usize {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = self.names.len();
        self.names.push(name.to_owned());
        self.numbers.insert(name.to_owned(), number);
        number
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Level {
    Unknown,
    Inside,
    Is(usize),
}

/// Refuses rings and deep nesting, and leaves out what takes no bytes: so each value takes at least one, and a message cannot ask for
/// more work than it has bytes. Returns how deep the nesting is.
fn measure(
    ros: Ros,
    structures: &mut [Structure],
    levels: &mut [Level],
    number: usize,
    above: usize,
) -> Result<usize, String> {
    let name = || structures.get(number).map(|structure| structure.name.clone()).unwrap_or_default();
    match levels.get(number) {
        Some(Level::Is(level)) => return Ok(*level),
        Some(Level::Inside) => return Err(format!("its type {} contains itself", name())),
        _ if above > MOST_LEVELS => {
            return Err(format!("its types are nested more than {MOST_LEVELS} deep"));
        }
        _ => {}
    }
    set(levels, number, Level::Inside);
    let mut fields =
        structures.get_mut(number).map(|known| std::mem::take(&mut known.fields)).unwrap_or_default();
    let mut deepest = 0;
    let mut kept = Vec::with_capacity(fields.len());
    for field in fields.drain(..) {
        if let Base::Structure(inner) = field.base {
            deepest = deepest.max(1 + measure(ros, structures, levels, inner, above + 1)?);
            if structures.get(inner).is_none_or(|inner| inner.fields.is_empty()) {
                continue;
            }
        }
        if field.shape != Shape::Fixed(0) {
            kept.push(field);
        }
    }
    // ROS 2 gives a type without fields one of a byte, since IDL knows no empty structures.
    if kept.is_empty() && ros == Ros::Two {
        let name = "structure_needs_at_least_one_member".to_owned();
        kept.push(Field { name, base: Base::Uint8, shape: Shape::One });
    }
    if above + deepest > MOST_LEVELS {
        return Err(format!("its types are nested more than {MOST_LEVELS} deep"));
    }
    if let Some(structure) = structures.get_mut(number) {
        structure.fields = kept;
    }
    set(levels, number, Level::Is(deepest));
    Ok(deepest)
}

fn set(levels: &mut [Level], number: usize, level: Level) {
    if let Some(place) = levels.get_mut(number) {
        *place = level;
    }
}
