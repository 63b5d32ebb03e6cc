//! The soil's surface, from the plate's motion, with the terrain of the simulated plant.

use soilctl_kinematics::{Arm, JointAngles};
use soilctl_terrain::{HeightField, Repose, Sweep, TerrainError};

use crate::MonitorError;
use crate::messages::{Patch, Sandbox};
use crate::scene::Scene;

/// Steps of run-off after the plate has left, in all and for each state: it is seen sliding for half a second.
const REST_STEPS: u32 = 400;
const STATE_STEPS: u32 = 25;
/// Heights are told in units of so many metres.
const UNIT_M: f64 = 1e-5;

/// The surface, following states.
#[derive(Debug, Clone)]
pub(crate) struct Surface {
    arm: Arm,
    sandbox: Sandbox,
    heap_length: f64,
    width_m: f64,
    repose: Repose,
    field: HeightField,
    /// Where the plate was when it last moved soil; none outside the soil.
    last_m: Option<[f64; 3]>,
    restless: u32,
    waiting: bool,
}

/// What a [`Surface`] needs to go on from.
#[derive(Debug, Clone)]
pub(crate) struct Snapshot {
    heights_m: Vec<f64>,
    last_m: Option<[f64; 3]>,
    restless: u32,
    waiting: bool,
}

impl Surface {
    /// Level sand.
    pub(crate) fn new(scene: &Scene) -> Result<Self, MonitorError> {
        let refused = |error: TerrainError| MonitorError::Scene(error.to_string());
        let sandbox = scene.sandbox;
        Ok(Self {
            arm: scene.arm.clone(),
            sandbox,
            heap_length: scene.heap_length,
            width_m: scene.arm.config().plate.width_m,
            repose: Repose::from_radians(scene.repose_deg.to_radians()).map_err(refused)?,
            field: level(&sandbox).map_err(refused)?,
            last_m: None,
            restless: 0,
            waiting: false,
        })
    }

    /// Takes in where the joints are, and the plate's edge, where somebody knows it better than they do. `waiting`: the sequence waits for the soil to be prepared.
    pub(crate) fn follow(
        &mut self,
        joints_deg: [f64; 5],
        tip_m: Option<[f64; 3]>,
        homed: bool,
        waiting: bool,
    ) {
        if std::mem::replace(&mut self.waiting, waiting) && !waiting {
            self.rake();
        }
        if homed {
            // An arm that is lost moves no soil.
            if let Ok(frames) = self.arm.frames(&JointAngles::from_degrees(joints_deg)) {
                let rotation = frames.plate_tip.rotation;
                self.plate(tip_m.unwrap_or(frames.plate_tip.origin_m), [rotation[0][0], rotation[1][0]]);
            }
        }
        if self.last_m.is_none() && self.restless > 0 {
            let steps = self.restless.min(STATE_STEPS);
            self.restless -= steps;
            if self.field.settle(&self.repose, steps as usize, 0.02).excess_slope <= 0.02 {
                self.restless = 0;
            }
        }
    }

    fn plate(&mut self, tip_m: [f64; 3], ahead: [f64; 2]) {
        let [x, y, z] = tip_m;
        let Sandbox { x_m, y_m, surface_z_m, cell_m, .. } = self.sandbox;
        let inside = x > x_m[0] && x < x_m[1] && y > y_m[0] && y < y_m[1] && z < surface_z_m;
        if !inside {
            if self.last_m.take().is_some() {
                // Where this stroke swept, the next one may sweep again.
                self.field.lift();
            }
            return;
        }
        let Some(last_m) = self.last_m else {
            self.last_m = Some(tip_m);
            return;
        };
        let size = ahead[0].hypot(ahead[1]);
        let way_m = ((x - last_m[0]) * ahead[0] + (y - last_m[1]) * ahead[1]) / size;
        // A plate that lies flat, or is drawn back, pushes nothing ahead.
        if !(size > 0.1 && way_m.abs() >= cell_m) {
            return;
        }
        let heap_m = self.heap_length * (surface_z_m - z).max(cell_m);
        let place = |point: [f64; 3]| [point[0] - x_m[0], point[1] - y_m[0]];
        let (from_m, to_m) = (place(last_m), place(tip_m));
        let sweep = Sweep { from_m, to_m, width_m: self.width_m, bottom_m: z, ahead_m: heap_m };
        if way_m > 0.0 && self.field.push(&sweep).is_ok_and(|moved_m3| moved_m3 > 0.0) {
            self.restless = REST_STEPS;
        }
        self.last_m = Some(tip_m);
    }

    fn rake(&mut self) {
        if let Ok(field) = level(&self.sandbox) {
            self.field = field;
        }
        (self.last_m, self.restless) = (None, 0);
    }

    /// The heights above the raked level, in units of 0.01 mm.
    pub(crate) fn heights(&self) -> Vec<i32> {
        let level_m = self.sandbox.surface_z_m;
        #[allow(clippy::cast_possible_truncation, reason = "saturates")]
        self.field.heights_m().iter().map(|height| ((height - level_m) / UNIT_M).round() as i32).collect()
    }

    /// Columns and rows.
    pub(crate) const fn grid(&self) -> [usize; 2] {
        [self.field.columns(), self.field.rows()]
    }

    pub(crate) fn snapshot(&self) -> Snapshot {
        let Self { last_m, restless, waiting, .. } = *self;
        Snapshot { heights_m: self.field.heights_m().to_vec(), last_m, restless, waiting }
    }

    pub(crate) fn restore(&mut self, snapshot: &Snapshot) {
        let (columns, cell_m) = (self.field.columns(), self.field.cell_m());
        if let Ok(field) = HeightField::from_heights(columns, cell_m, snapshot.heights_m.clone()) {
            self.field = field;
            (self.last_m, self.restless, self.waiting) =
                (snapshot.last_m, snapshot.restless, snapshot.waiting);
        }
    }

    /// Whether a [`Snapshot`] is all there is to it: no slope runs off and no stroke is under way.
    pub(crate) const fn is_at_rest(&self) -> bool {
        self.restless == 0 && self.last_m.is_none()
    }
}

fn level(sandbox: &Sandbox) -> Result<HeightField, TerrainError> {
    let cells = |[low, high]: [f64; 2]| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 2000")]
        let count = ((high - low) / sandbox.cell_m).ceil().clamp(1.0, 2000.0) as usize;
        count
    };
    HeightField::level(cells(sandbox.x_m), cells(sandbox.y_m), sandbox.cell_m, sandbox.surface_z_m)
}

/// What a page knows of the surface, to tell it no more than what has changed.
#[derive(Debug, Default)]
pub(crate) struct Known {
    heights: Vec<i32>,
}

impl Known {
    /// The smallest rectangle that holds all changes; none without changes.
    pub(crate) fn update(&mut self, [columns, rows]: [usize; 2], now: &[i32]) -> Option<Patch> {
        let grid = [columns, rows];
        if self.heights.len() != now.len() {
            self.heights = now.to_vec();
            return Some(Patch { grid, column: 0, row: 0, columns, heights: now.to_vec() });
        }
        let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
        for (k, (old, new)) in self.heights.iter().zip(now).enumerate() {
            if old != new {
                let place = [k % columns, k / columns];
                for i in 0..2 {
                    low[i] = low[i].min(place[i]);
                    high[i] = high[i].max(place[i]);
                }
            }
        }
        if low[0] > high[0] {
            return None;
        }
        self.heights.copy_from_slice(now);
        let heights = (low[1]..=high[1])
            .flat_map(|row| now.get(row * columns + low[0]..=row * columns + high[0]).unwrap_or_default())
            .copied()
            .collect();
        Some(Patch { grid, column: low[0], row: low[1], columns: high[0] - low[0] + 1, heights })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_is_the_smallest_rectangle_of_changes() {
        let mut known = Known::default();
        let mut heights = vec![0; 20];
        let all = known.update([5, 4], &heights).unwrap();
        assert_eq!((all.columns, all.heights.len()), (5, 20));
        assert_eq!(known.update([5, 4], &heights), None);
        (heights[5 + 2], heights[10 + 1]) = (7, 8);
        let patch = known.update([5, 4], &heights).unwrap();
        assert_eq!((patch.column, patch.row, patch.columns), (1, 1, 2));
        assert_eq!(patch.heights, [0, 7, 8, 0]);
    }
}
