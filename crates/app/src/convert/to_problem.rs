//! A drawing as a problem: areas are soils, named after their layers; a line is the water table if its layer says so.

use std::collections::BTreeSet;
use std::path::Path;

use soilctl_drawing::{Drawing, Outline, Shape, Unit, signed_area_m2};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, BoundaryEntry, Kind, RegionEntry, Side, SoilEntry, Water};

use super::answer::{Answer, LeftOut, add, extent};
use super::conform::conform;
use super::{Request, read};
use crate::AppError;

/// What names of layers of the water table have in them.
const WATER: [&str; 6] = ["water", "phreatic", "gwl", "gwt", "piezometric", "grundwasser"];
/// Most corners of areas: more points a problem has not.
const MOST_CORNERS: usize = 2000;
/// A section that is wider is drawn in another unit, most likely (m).
const WIDE_M: f64 = 2000.0;
/// One that is narrower too (m).
const NARROW_M: f64 = 0.5;

/// The problem that a drawing shows, and what is to be said about it.
pub(super) fn problem(request: &Request, drawing: Drawing) -> Result<(Description, Answer), AppError> {
    let mut sorted = Sorted::default();
    for (it, count) in drawing.left_out {
        let soilctl_drawing::LeftOut { layer, what, why, is_shape } = it;
        // What was asked for lacks nothing.
        let is_shape = is_shape && !request.leave_out.contains(&layer);
        sorted.left_out.push(LeftOut { layer, what, why, count, is_shape });
    }
    for shape in drawing.shapes {
        sorted.sort(request, shape);
    }
    let Sorted { mut polygons, layers, waters, mut left_out } = sorted;
    let refused = |words: String| AppError::Request(format!("{}: {words}", request.file.display()));
    if polygons.is_empty() {
        return Err(refused(
            "it has no area; draw each soil as closed polylines, or lines whose ends meet, on a layer of its own".into(),
        ));
    }
    let corners: usize = polygons.iter().map(Vec::len).sum();
    if corners > MOST_CORNERS {
        return Err(refused(format!(
            "its areas have {corners} corners, and a problem at most {MOST_CORNERS}; draw it with fewer, leave out layers, or take a larger --chord"
        )));
    }
    let joined = conform(&mut polygons, request.join_m);
    if let Some(i) = polygons.iter().position(|polygon| polygon.len() < 3) {
        return Err(refused(format!(
            "an area on layer {} is narrower than --join, {} m; draw it larger, or join less",
            layers[i], request.join_m
        )));
    }
    let known = request.soils.as_deref().map_or_else(|| Ok(Vec::new()), strengths)?;
    let mut soils = Vec::new();
    for (layer, polygon) in layers.iter().zip(&polygons) {
        add(&mut soils, layer, signed_area_m2(polygon).abs(), known.iter().any(|soil| soil.name == *layer));
    }
    let mut notes = drawing.notes;
    notes.extend(notes_on_units(drawing.unit, &polygons, drawing.has_chords, request));
    for unused in known.iter().filter(|soil| !layers.contains(&soil.name)) {
        notes.push(format!(
            "{} has strengths, and no area of the drawing is on a layer of that name",
            unused.name
        ));
    }
    let lacking: Vec<&str> =
        soils.iter().filter(|soil| !soil.has_strength).map(|soil| soil.name.as_str()).collect();
    if !lacking.is_empty() {
        notes.push(format!(
            "put strength and weight of {} into the problem file, where they are zero",
            lacking.join(", ")
        ));
    }
    notes.push("outline with soil below it is free, all other outline fixed; the factor of safety is asked for: change what is otherwise".into());
    let water = water(&waters).map_err(refused)?;
    for line in waters.iter().skip(1) {
        left_out.push(left(line, "there is another water table"));
    }
    let entry = |name: &str| {
        let known = known.iter().find(|soil| soil.name == name).cloned();
        known.unwrap_or_else(|| SoilEntry {
            name: name.to_owned(),
            phi_deg: Some(0.0),
            ..SoilEntry::default()
        })
    };
    let description = Description {
        title: request.file.file_stem().map(|name| name.to_string_lossy().into_owned()),
        default_boundary: Some(Kind::Fixed),
        objective: Aim::StrengthReduction {},
        water,
        soils: soils.iter().map(|soil| entry(&soil.name)).collect(),
        regions: (layers.iter().zip(&polygons))
            .map(|(layer, polygon)| RegionEntry { name: None, soil: layer.clone(), polygon: polygon.clone() })
            .collect(),
        boundaries: vec![BoundaryEntry::on_sides(Kind::Free, &[Side::Top])],
        ..Description::default()
    };
    let refused_as_it_is = if lacking.is_empty() { description.described().err() } else { None };
    notes.extend(refused_as_it_is.iter().map(|problem| format!("`solve` refuses it as it is: {problem}")));
    let answer = Answer {
        is_complete: lacking.is_empty() && refused_as_it_is.is_none(),
        soils,
        has_water: description.water.is_some(),
        extent_m: extent(polygons.into_iter().flatten()),
        unit: drawing.unit.unwrap_or(Unit::Metre).symbol().to_owned(),
        joined,
        left_out,
        notes,
    };
    Ok((description, answer))
}

/// Shapes by what they are.
#[derive(Default)]
struct Sorted {
    polygons: Vec<Vec<[f64; 2]>>,
    /// Layers of the polygons.
    layers: Vec<String>,
    waters: Vec<Shape>,
    left_out: Vec<LeftOut>,
}

impl Sorted {
    fn sort(&mut self, request: &Request, shape: Shape) {
        let lower = shape.layer.to_lowercase();
        let is_water = match &request.water {
            Some(layer) => shape.layer == *layer,
            None => WATER.iter().any(|word| lower.contains(word)),
        };
        if request.leave_out.contains(&shape.layer) {
            let asked = LeftOut { is_shape: false, ..left(&shape, "asked for by --leave-out") };
            return self.left_out.push(asked);
        }
        match shape.outline {
            Outline::Open | Outline::Unsaid if is_water => self.waters.push(shape),
            Outline::Closed if is_water => {
                self.left_out.push(left(&shape, "a water table is a line, and this is an area"));
            }
            Outline::Closed | Outline::Unsaid if shape.corners.len() > 2 => {
                self.layers.push(shape.layer);
                self.polygons.push(shape.corners);
            }
            Outline::Open | Outline::Closed | Outline::Unsaid => {
                self.left_out.push(left(&shape, "its ends meet no others, so that it bounds no area"));
            }
        }
    }
}

fn left(shape: &Shape, why: &str) -> LeftOut {
    let what = if shape.outline == Outline::Open { "line" } else { "area" };
    LeftOut { layer: shape.layer.clone(), what: what.into(), why: why.into(), count: 1, is_shape: true }
}

/// The first line as a water table from left to right.
fn water(lines: &[Shape]) -> Result<Option<Water>, String> {
    let Some(line) = lines.first() else { return Ok(None) };
    let mut table = line.corners.clone();
    if table.first().zip(table.last()).is_some_and(|(a, b)| a[0] > b[0]) {
        table.reverse();
    }
    if table.windows(2).any(|two| two[1][0] <= two[0][0]) {
        return Err(format!(
            "the water table on layer {} does not go from left to right; draw it so, or --leave-out that layer",
            line.layer
        ));
    }
    Ok(Some(Water::fresh(table)))
}

/// Strengths of a table.
fn strengths(path: &Path) -> Result<Vec<SoilEntry>, AppError> {
    let refused = |words: String| AppError::Request(format!("{}: {words}", path.display()));
    let bytes = read(path)?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(&bytes[..]);
    let rows: Result<Vec<SoilEntry>, _> = reader.deserialize().collect();
    let rows = rows.map_err(|error| refused(error.to_string()))?;
    let mut names = BTreeSet::new();
    match rows.iter().find(|soil| !names.insert(&soil.name)) {
        Some(twice) => Err(refused(format!("{} is there twice", twice.name))),
        None => Ok(rows),
    }
}

/// What to keep in mind about units and arcs.
fn notes_on_units(
    unit: Option<Unit>,
    polygons: &[Vec<[f64; 2]>],
    has_chords: bool,
    request: &Request,
) -> Vec<String> {
    let mut notes = Vec::new();
    if unit.is_none() {
        notes.push(
            "the drawing does not say its unit, and metres were taken; `soilctl convert --unit` takes others"
                .into(),
        );
    }
    let [[left, right], _] = extent(polygons.iter().flatten().copied());
    let width = right - left;
    if !(NARROW_M..=WIDE_M).contains(&width) {
        notes.push(format!(
            "the section is {width} m wide: is the unit right? `soilctl convert --unit` takes others"
        ));
    }
    if has_chords {
        notes.push(format!(
            "arcs became chords that are within {} m of them; `soilctl convert --chord` says how near",
            request.chord_m
        ));
    }
    notes
}
