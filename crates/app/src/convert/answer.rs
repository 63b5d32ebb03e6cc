//! What a conversion is answered with.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_drawing::{Drawing, Outline, Unit, signed_area_m2};
use soilctl_limit_analysis::Description;

use crate::Outcome;

/// What was converted.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Whether nothing is to be put in before it can be solved.
    pub is_complete: bool,
    /// The soils, in the order in which they were found.
    pub soils: Vec<SoilAnswer>,
    /// Whether there is a water table.
    pub has_water: bool,
    /// Least and greatest x and y (m).
    pub extent_m: [[f64; 2]; 2],
    /// Unit of the drawing's coordinates.
    pub unit: String,
    /// How many corners were moved onto others, or put into an edge that others are on.
    pub joined: usize,
    /// What of the drawing is not in the problem.
    pub left_out: Vec<LeftOut>,
    /// What to do, or to keep in mind.
    pub notes: Vec<String>,
}

/// A soil and its areas.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SoilAnswer {
    /// Its name, that of its layer.
    pub name: String,
    /// How many areas it has.
    pub areas: usize,
    /// Their sizes together (m2).
    pub area_m2: f64,
    /// Whether its strength and weight are known; otherwise they are zero in the problem file.
    pub has_strength: bool,
}

/// What is not in the problem.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LeftOut {
    /// Its layer.
    pub layer: String,
    /// What it is, as the file calls it.
    pub what: String,
    /// Why.
    pub why: String,
    /// How often it is there.
    pub count: usize,
    /// Whether it could have been ground: an area or a line.
    pub is_shape: bool,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.convert/1";

    fn outcome(&self) -> Outcome {
        let is_whole = self.left_out.iter().all(|it| !it.is_shape);
        if self.is_complete && is_whole { Outcome::Done } else { Outcome::Partial }
    }
}

impl Answer {
    /// Of a problem that was drawn.
    pub(super) fn of_problem(description: &Description, drawing: &Drawing) -> Self {
        let mut soils: Vec<SoilAnswer> = Vec::new();
        let names = description.regions.iter().map(|region| region.soil.as_str());
        let areas = drawing.shapes.iter().filter(|shape| shape.outline == Outline::Closed);
        for (name, shape) in names.zip(areas) {
            add(&mut soils, name, signed_area_m2(&shape.corners).abs(), true);
        }
        Self {
            is_complete: true,
            soils,
            has_water: description.water.is_some(),
            extent_m: extent(drawing.shapes.iter().flat_map(|shape| shape.corners.iter().copied())),
            unit: Unit::Metre.symbol().to_owned(),
            joined: 0,
            left_out: Vec::new(),
            notes: Vec::new(),
        }
    }
}

/// Counts an area of a soil.
pub(super) fn add(soils: &mut Vec<SoilAnswer>, name: &str, area_m2: f64, has_strength: bool) {
    match soils.iter_mut().find(|soil| soil.name == name) {
        Some(soil) => {
            soil.areas += 1;
            soil.area_m2 += area_m2;
        }
        None => soils.push(SoilAnswer { name: name.to_owned(), areas: 1, area_m2, has_strength }),
    }
}

/// Least and greatest x and y; zero without points.
pub(super) fn extent(points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    points
        .fold(None, |found: Option<[[f64; 2]; 2]>, [x, y]| {
            let [[a, b], [c, d]] = found.unwrap_or([[x, x], [y, y]]);
            Some([[a.min(x), b.max(x)], [c.min(y), d.max(y)]])
        })
        .unwrap_or_default()
}
