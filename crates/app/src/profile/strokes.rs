//! From an estimate's setup to strokes of a profile.

use std::sync::Arc;

use soilctl_estimator::Setup;
use soilctl_ground::profile::{Coefficients, Ground, Layering, STEEPEST_DEG, Stroke};
use soilctl_soil::{Angle, Plate};
use soilctl_strokes::{ReadOptions, StrokeRow, StrokeTable};

use super::request::Request;
use crate::AppError;
use crate::text::number;

/// Depths of strokes must differ by this factor at least.
const LEAST_DEPTH_RATIO: f64 = 1.2;

/// Steps are looked for from this part of the least depth, since of a thin skin strokes say nothing,
const SHALLOWEST_STEP: f64 = 0.7;
/// to this part of the greatest, since only the tip of one plate reaches deeper.
const DEEPEST_STEP: f64 = 0.95;

/// The strokes of a request at tool angles for which layers are known, and how many are not.
pub(super) fn table(request: &Request) -> Result<(StrokeTable, usize), AppError> {
    let table = request.file.strokes(ReadOptions::default())?;
    let kept: Vec<StrokeRow> = table.rows().filter(|row| Layering::at(row.alpha_deg).is_some()).collect();
    if kept.is_empty() {
        return Err(AppError::Request(format!(
            "{} has no stroke at a tool angle of at most {STEEPEST_DEG} deg; at greater ones soil fails far below the plate's edge, where no stroke tells what it is",
            table.name()
        )));
    }
    let left_out = table.len() - kept.len();
    Ok((StrokeTable::new(table.name(), &kept)?, left_out))
}

/// Strokes, and all that the ground may be.
pub(super) struct Strokes<'s> {
    pub(super) setup: Setup<'s>,
    pub(super) strokes: Vec<Stroke>,
    pub(super) start: Ground,
    pub(super) density_kg_m3: [f64; 2],
    /// Least and greatest depth in m.
    pub(super) depths_m: [f64; 2],
    /// Depths in m at which a step is looked for.
    pub(super) step_m: [f64; 2],
    /// Whether a model bounds what ends add; then that is an unknown.
    knows_ends: bool,
}

impl<'s> Strokes<'s> {
    pub(super) fn of(setup: Setup<'s>, file: &str) -> Result<Self, AppError> {
        let depths = setup.observations.iter().map(|o| o.plate().depth_m());
        let depths_m = depths.fold([f64::INFINITY, 0.0_f64], |[low, high], d| [low.min(d), high.max(d)]);
        if depths_m[1] < LEAST_DEPTH_RATIO * depths_m[0] {
            return Err(AppError::Request(format!(
                "{file} has strokes from {} to {} mm deep; a profile takes depths that differ by a factor of {LEAST_DEPTH_RATIO} at least: make the same \
                 strokes at another depth, or ask estimate",
                number((1e4 * depths_m[0]).round() / 10.0),
                number((1e4 * depths_m[1]).round() / 10.0)
            )));
        }
        let knows_ends = setup.model.bounds_ends();
        let phi = setup.phi_range_deg();
        // Where strokes share nothing of their ends, each has its own part of them, and the ground none.
        let ends = if knows_ends && setup.end_tolerance < 1.0 { [0.0, 1.0] } else { [0.0; 2] };
        let density = setup.density_range_kg_m3();
        let step_m = [SHALLOWEST_STEP * depths_m[0], DEEPEST_STEP * depths_m[1]];
        let mut found = Self {
            start: Ground {
                phi_deg: [[phi.0, phi.1]; 2],
                delta_deg: [setup.delta_deg.0, setup.delta_deg.1],
                ends,
                step_m,
            },
            density_kg_m3: [density.0, density.1],
            setup,
            strokes: Vec::new(),
            depths_m,
            step_m,
            knows_ends,
        };
        let observed: Vec<(Plate, [f64; 2])> =
            found.setup.observations.iter().map(|o| (*o.plate(), [o.low_n(), o.high_n()])).collect();
        for (plate, force_n) in observed {
            let stroke = found.stroke(&plate, force_n)?;
            found.strokes.push(stroke);
        }
        Ok(found)
    }

    /// A stroke of a plate; its geometry is tabulated unless another of the strokes has the same.
    pub(super) fn stroke(&self, plate: &Plate, force_n: [f64; 2]) -> Result<Stroke, AppError> {
        let setup = &self.setup;
        let alpha_deg = plate.tool_angle().degrees();
        let layering = Layering::at(alpha_deg).ok_or_else(|| {
            AppError::Request(format!(
                "a stroke is at a tool angle of {} deg; in ground that may change it must be at most {STEEPEST_DEG} deg: at greater ones soil fails far below the plate's \
                 edge, where no stroke tells what it is",
                number(alpha_deg)
            ))
        })?;
        let ratio = |plate: &Plate| setup.width_ratio(plate).depth_over_width().to_bits();
        let alike =
            self.setup.observations.iter().zip(&self.strokes).find(|(o, _)| {
                o.plate().tool_angle() == plate.tool_angle() && ratio(o.plate()) == ratio(plate)
            });
        let coefficients = match alike {
            Some((_, stroke)) => Arc::clone(&stroke.coefficients),
            None => {
                let slice = setup.model.at(plate.tool_angle(), Angle::ZERO, setup.width_ratio(plate))?;
                Arc::new(Coefficients::of(&*slice, setup.phi_range_deg(), setup.delta_deg)?)
            }
        };
        Ok(Stroke {
            depth_m: plate.depth_m(),
            unit_n: setup.gravity_m_s2 * plate.width_m() * plate.slant_length_m().powi(2),
            force_n,
            layering,
            end_tolerance: if self.knows_ends { setup.end_tolerance } else { 0.0 },
            coefficients,
        })
    }
}
