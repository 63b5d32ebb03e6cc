//! The surface that strokes leave, as far as it can be told beforehand: heaps ahead of the plate, furrows that run off.

use soilctl_controller::StrokeSpec;
use soilctl_plant::PlantParams;
use soilctl_soil::Angle;
use soilctl_terrain::{HeightField, Repose, Sweep};

use crate::DiggingError;
use crate::stance::sinks;

/// Depths ahead over which the surface loads the failing wedge.
const WEDGE_LENGTH: f64 = 2.5;
/// Most steps in which the surface comes to rest after a stroke, and the slope that may be too much then.
const REST: (usize, f64) = (400, 0.02);
/// What lies higher above the deepest place of a furrow is not its floor, in m.
const FLOOR_M: f64 = 0.003;
/// Places of a stroke at which the heap is told: those of [`crate::Way`].
const STEPS: usize = 8;
/// Sweeps between two of them.
const SWEEPS: usize = 4;

/// The surface of the soil in its box, in the arm's base frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    field: HeightField,
    origin_m: [f64; 2],
    repose: Repose,
    /// Depths ahead of the plate over which it heaps what it moves.
    heap_length: f64,
    width_m: f64,
}

impl Surface {
    /// Level soil at a height (m) in the box of a plant, whose slopes stand up to an angle.
    ///
    /// # Errors
    /// [`DiggingError::Terrain`] for a box or an angle that makes no surface.
    pub fn level(plant: &PlantParams, height_m: f64, repose: Angle) -> Result<Self, DiggingError> {
        let (sandbox, ground) = (&plant.config().sandbox, &plant.config().ground);
        let cells = |[low, high]: [f64; 2]| {
            let count = ((high - low) / ground.cell_m).ceil().clamp(1.0, 1e4);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1e4")]
            let count = count as usize;
            count
        };
        Ok(Self {
            field: HeightField::level(cells(sandbox.x_m), cells(sandbox.y_m), ground.cell_m, height_m)?,
            origin_m: [sandbox.x_m[0], sandbox.y_m[0]],
            repose: Repose::from_radians(repose.radians())?,
            heap_length: ground.heap_length,
            width_m: plant.arm().config().plate.width_m,
        })
    }

    /// Mean height in m under the plate's lower edge where a stroke is inserted; `None` outside the box.
    #[must_use]
    pub fn under_m(&self, stroke: &StrokeSpec) -> Option<f64> {
        let (place, ahead) = self.place(stroke, 0.0);
        let back = self.field.cell_m();
        let from = [place[0] - back * ahead[0], place[1] - back * ahead[1]];
        self.field.mean_height_m(from, ahead, 2.0 * back, self.width_m)
    }

    /// How far into a stroke's way (m) the floor of a furrow begins: up to there soil has run off the wall behind. 0 on level soil.
    #[must_use]
    pub fn floor_begins_m(&self, stroke: &StrokeSpec, length_m: f64) -> f64 {
        let cell_m = self.field.cell_m();
        let steps = (0.7 * length_m / cell_m).floor().clamp(0.0, 1e4);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 1e4")]
        let heights: Vec<(f64, f64)> = (0..=steps as u32)
            .filter_map(|i| {
                let travel_m = cell_m * f64::from(i);
                let there = StrokeSpec { radius_m: stroke.radius_m - travel_m, ..*stroke };
                Some((travel_m, self.under_m(&there)?))
            })
            .collect();
        let floor = heights.iter().map(|(_, height)| *height).fold(f64::INFINITY, f64::min);
        heights.iter().find(|(_, height)| *height <= floor + FLOOR_M).map_or(0.0, |(travel_m, _)| *travel_m)
    }

    /// Heaps in m above the surface at the insertion, at the places of a stroke's way; the surface stays as it is.
    ///
    /// # Errors
    /// [`DiggingError::Terrain`] for a stroke outside all bounds.
    pub fn heaps_m(&self, stroke: &StrokeSpec, length_m: f64) -> Result<Vec<f64>, DiggingError> {
        let mut copy = self.clone();
        let level_m = self.under_m(stroke).unwrap_or_default();
        copy.sweep(stroke, level_m, length_m)
    }

    /// Makes a stroke: furrow and heap, which run off after it.
    ///
    /// # Errors
    /// As [`Surface::heaps_m`].
    pub fn stroke(&mut self, stroke: &StrokeSpec, length_m: f64) -> Result<(), DiggingError> {
        let level_m = self.under_m(stroke).unwrap_or_default();
        self.sweep(stroke, level_m, length_m)?;
        self.field.lift();
        self.field.settle(&self.repose, REST.0, REST.1);
        Ok(())
    }

    fn sweep(&mut self, stroke: &StrokeSpec, level_m: f64, length_m: f64) -> Result<Vec<f64>, DiggingError> {
        let wedge_m = WEDGE_LENGTH * stroke.depth_m;
        let heap = |surface: &Self, travel_m: f64| {
            let (place, ahead) = surface.place(stroke, travel_m);
            let from = [0, 1].map(|i: usize| place[i] + surface.field.cell_m() * ahead[i]);
            let height = surface.field.mean_height_m(from, ahead, wedge_m, surface.width_m);
            height.map_or(0.0, |height_m| (height_m - level_m).max(0.0))
        };
        let mut heaps = vec![heap(self, 0.0)];
        for step in 0..STEPS {
            for sweep in 0..SWEEPS {
                #[allow(clippy::cast_precision_loss, reason = "small integers")]
                let at = |k: usize| length_m * k as f64 / (STEPS * SWEEPS) as f64;
                let k = step * SWEEPS + sweep;
                self.field.push(&Sweep {
                    from_m: self.place(stroke, at(k)).0,
                    to_m: self.place(stroke, at(k + 1)).0,
                    width_m: self.width_m,
                    bottom_m: level_m - stroke.depth_m - sinks(stroke.tool_angle_rad.to_degrees()) * at(k),
                    ahead_m: self.heap_length * stroke.depth_m,
                })?;
            }
            #[allow(clippy::cast_precision_loss, reason = "small integers")]
            heaps.push(heap(self, length_m * (step + 1) as f64 / STEPS as f64));
        }
        Ok(heaps)
    }

    /// Place of the lower edge in the field, and the direction of the stroke.
    fn place(&self, stroke: &StrokeSpec, travel_m: f64) -> ([f64; 2], [f64; 2]) {
        let (sin, cos) = libm::sincos(stroke.base_rad);
        let radius_m = stroke.radius_m - travel_m;
        ([radius_m * cos - self.origin_m[0], radius_m * sin - self.origin_m[1]], [-cos, -sin])
    }
}
