//! Exact data: contour lines and the locus of their intersections.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_estimator::{Ellipse, ExactSection, Setup, exact_estimate, exact_section};

use crate::AppError;

/// Two contours that cross.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Crossing {
    /// Friction angle (deg).
    pub phi_deg: f64,
    /// Density (kg/m3).
    pub density_kg_m3: f64,
    /// The two measurements.
    pub of: [String; 2],
}

/// Contours at one delta.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ContourSection {
    /// Interface friction (deg).
    pub delta_deg: f64,
    /// One polyline of [phi (deg), density (kg/m3)] a measurement.
    pub contours: Vec<Vec<[f64; 2]>>,
    /// Where pairs of contours cross.
    pub intersections: Vec<Crossing>,
    /// Centre [phi, density] of the smallest ellipse around the crossings.
    pub ellipse_centre: Option<[f64; 2]>,
    /// Its semi-axes as vectors, the longer first.
    pub ellipse_semi_axes: Option<[[f64; 2]; 2]>,
    /// Its area (deg kg/m3).
    pub ellipse_area: Option<f64>,
}

impl ContourSection {
    fn of(setup: &Setup<'_>, found: &ExactSection) -> Self {
        let label = |i: usize| setup.observations[i].label().to_owned();
        Self {
            delta_deg: found.delta_deg,
            contours: found.contours.clone(),
            intersections: found
                .intersections
                .iter()
                .map(|(at, [i, j])| Crossing {
                    phi_deg: at[0],
                    density_kg_m3: at[1],
                    of: [label(*i), label(*j)],
                })
                .collect(),
            ellipse_centre: found.ellipse.as_ref().map(|e| e.centre),
            ellipse_semi_axes: found.ellipse.as_ref().map(|e| e.semi_axes),
            ellipse_area: found.ellipse.as_ref().map(Ellipse::area),
        }
    }
}

/// Answer for exact data.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ExactAnswer {
    /// The delta with the smallest ellipse, within what is known of it; null if no contours cross.
    pub best: Option<ContourSection>,
    /// Sections at chosen deltas.
    pub sections: Vec<ContourSection>,
}

pub(super) fn answer(setup: &Setup<'_>, deltas: &[f64]) -> Result<ExactAnswer, AppError> {
    let best = exact_estimate(setup)?.map(|found| ContourSection::of(setup, &found));
    let sections = deltas
        .iter()
        .map(|&delta| Ok(ContourSection::of(setup, &exact_section(setup, delta)?)))
        .collect::<Result<Vec<_>, AppError>>()?;
    Ok(ExactAnswer { best, sections })
}

impl ContourSection {
    /// The crossings as points.
    #[must_use]
    pub fn crossings(&self) -> Vec<(f64, f64)> {
        self.intersections.iter().map(|c| (c.phi_deg, c.density_kg_m3)).collect()
    }

    /// The ellipse as a polygon; `None` if it has no area.
    #[must_use]
    pub fn outline(&self) -> Option<Vec<(f64, f64)>> {
        let ellipse = Ellipse { centre: self.ellipse_centre?, semi_axes: self.ellipse_semi_axes? };
        (ellipse.area() > 1e-9).then(|| ellipse.outline(72).iter().map(|p| (p[0], p[1])).collect())
    }
}
