//! Rigid blocks in the soil of a plan.

use soilctl_plant::{BuriedBlock, PlantError};

use super::file::{Block, PlanFile};
use crate::{CampaignError, Plan};

impl Block {
    fn buried(&self) -> BuriedBlock {
        BuriedBlock {
            face_radius_m: self.face_radius_m,
            base_deg: self.base_deg,
            top_m: self.top_m,
            width_m: self.width_m,
            length_m: self.length_m,
        }
    }
}

impl Plan {
    /// The blocks in the soil of a batch.
    #[must_use]
    pub fn blocks_of(&self, batch: usize) -> Vec<BuriedBlock> {
        let there = self.file.blocks.iter().filter(|block| block.batch.is_none_or(|of| of == batch));
        there.map(Block::buried).collect()
    }
}

/// Refuses blocks whose numbers are out of their range, that lie in no batch, or onto which a plate of the plan would be pressed.
pub(super) fn check(file: &PlanFile, name: &str, plate_width_m: f64) -> Result<(), CampaignError> {
    let refused = |problem: String| CampaignError::Plan { file: name.to_owned(), problem };
    for (place, block) in file.blocks.iter().enumerate() {
        block.buried().check(name).map_err(|error| match error {
            PlantError::Config { file, key, value, unit, allowed } => {
                PlantError::Config { file, key: format!("blocks[{place}].{key}"), value, unit, allowed }
            }
            other => other,
        })?;
        if let Some(batch) = block.batch.filter(|batch| *batch >= file.batches.len()) {
            return Err(refused(format!(
                "`blocks[{place}].batch` is {batch}; batches are numbered from 0 to {}",
                file.batches.len() - 1
            )));
        }
        for (number, batch) in file.batches.iter().enumerate() {
            if block.batch.is_some_and(|of| of != number) {
                continue;
            }
            for (i, stroke) in batch.strokes.iter().enumerate() {
                let (sin, cos) = libm::sincos(stroke.base_deg.to_radians());
                let radius_m = stroke.radius_m.or(batch.radius_m).unwrap_or_default();
                // Across the plate from end to end.
                let ends = [-0.5, 0.0, 0.5].map(|part| part * plate_width_m);
                let is_above = |aside: f64| {
                    let at = [radius_m * cos - aside * sin, radius_m * sin + aside * cos];
                    block.buried().way_m(at, [-cos, -sin]).is_some_and(|way| way <= 0.0)
                };
                if stroke.depth_m > block.top_m && ends.into_iter().any(is_above) {
                    return Err(refused(format!(
                        "the plate of `batches[{number}].strokes[{i}]` goes in at {radius_m} m, above `blocks[{place}]`, whose top is {} m below the \
                         surface; begin the stroke further out, or bury the block elsewhere or deeper",
                        block.top_m
                    )));
                }
            }
        }
    }
    Ok(())
}
