//! Boreholes in the format of the Association of Geotechnical and Geoenvironmental Specialists, AGS 4, as a cross-section.

mod section;
mod site;
mod tables;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use site::{Hole, Property, Test};

use crate::{Drawing, DrawingError, Reading, Unit};

/// Most holes of a section, and strata of a hole.
const MOST_HOLES: usize = 200;
const MOST_STRATA: usize = 500;
/// Holes that are farther from the line of the section are told of (m).
const OFF_LINE_M: f64 = 1.0;

/// The section through the holes that are named, or through all of them.
pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Drawing, DrawingError> {
    if reading.unit.is_some_and(|unit| unit != Unit::Metre) {
        return Err(DrawingError::Kind("AGS files are in metres: leave out the unit".into()));
    }
    let groups = tables::read(bytes)?;
    let holes = site::holes(&groups, &reading.holes)?;
    let (placed, off_m) = section::placed(&holes, &reading.holes)?;
    limit("holes", placed.len(), MOST_HOLES)?;
    for it in &placed {
        limit("strata in a hole", it.hole.strata.len(), MOST_STRATA)?;
    }
    let names: Vec<&str> = placed.iter().map(|it| it.hole.name.as_str()).collect();
    let mut drawing = Drawing { unit: Some(Unit::Metre), ..Drawing::default() };
    match placed.as_slice() {
        [] => return Err(DrawingError::Kind("no hole has strata".into())),
        [only] => {
            drawing.shapes = section::around(only.hole);
            drawing.notes.push(format!(
                "the file has one hole with strata, or one was named: {} in level layers, as far to either side as it is deep",
                only.hole.name
            ));
        }
        _ => {
            for two in placed.windows(2) {
                let [left, right] = two else { continue };
                if right.x_m - left.x_m <= reading.join_m {
                    return Err(DrawingError::Kind(format!(
                        "holes {} and {} are at one place of the section; name the holes that are wanted with --holes",
                        left.hole.name, right.hole.name
                    )));
                }
                drawing.shapes.extend(section::between(left, right));
            }
            drawing.notes.push(format!(
                "a section through {}: strata of the same code are joined by straight lines, and one that the next hole lacks tapers out there, \
                 which is a guess as good as the holes are near; no ground is known below the holes and beyond the outer ones",
                names.join(", ")
            ));
        }
    }
    if off_m > OFF_LINE_M {
        drawing.notes.push(format!(
            "the line of the section goes through the two holes that are farthest apart, and holes are up to {off_m:.1} m beside it; --holes \
             names those that are wanted, in order"
        ));
    }
    let meanings = site::meanings(&groups);
    let mut codes: Vec<&str> = drawing.shapes.iter().map(|shape| shape.layer.as_str()).collect();
    codes.sort_unstable();
    codes.dedup();
    let told: Vec<String> =
        codes.iter().filter_map(|code| Some(format!("{code} is {}", meanings.get(code)?))).collect();
    if !told.is_empty() {
        drawing.notes.push(told.join(", "));
    }
    let tests = site::tests(&groups)?;
    let through: Vec<&Hole> = placed.iter().map(|it| it.hole).collect();
    drawing.notes.extend(strengths(&through, &tests));
    if ["WSTG", "WSTK", "MONG", "MOND"].iter().any(|group| groups.contains_key(*group)) {
        drawing.notes.push("what it says of ground water is not read: a strike is no water table; put it into the problem file".into());
    }
    Ok(drawing)
}

fn limit(what: &'static str, count: usize, limit: usize) -> Result<(), DrawingError> {
    if count > limit { Err(DrawingError::TooLarge { what, count, limit }) } else { Ok(()) }
}

/// What tests in the holes of the section say of each stratum, for whoever chooses its strength.
fn strengths(holes: &[&Hole], tests: &[Test]) -> Vec<String> {
    let mut found: BTreeMap<(&str, Property), Vec<f64>> = BTreeMap::new();
    for test in tests {
        let stratum = holes.iter().find(|hole| hole.name == test.hole).and_then(|hole| {
            let level = hole.ground_m - test.depth_m;
            hole.strata.iter().find(|stratum| stratum.base_m <= level && level <= stratum.top_m)
        });
        if let Some(stratum) = stratum {
            found.entry((stratum.code.as_str(), test.of)).or_default().push(test.value);
        }
    }
    let words = |((code, of), values): ((&str, Property), Vec<f64>)| {
        let (name, unit) = of.words();
        let ends = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
        format!("{code}: {name} {:.1} to {:.1} {unit} in {} tests", ends.0, ends.1, values.len())
    };
    found.into_iter().map(words).collect()
}
