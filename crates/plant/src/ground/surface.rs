use soilctl_soil::Soil;
use soilctl_terrain::{HeightField, Repose, Sweep, TerrainError};

use crate::config::BoxConfig;

/// Steepest slope in rad at which cohesive soil stands, for as low as furrows are.
const COHESIVE_RAD: f64 = 1.4;
/// Most steps in which the surface comes to rest after a stroke, and the slope that may be too much then.
const REST: (usize, f64) = (400, 0.02);

/// The soil's surface in the box, in the base frame: a plate pushes soil ahead of itself, and when it has left, slopes run
/// off. Volume is kept.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    origin_m: [f64; 2],
    level_z_m: f64,
    field: HeightField,
    level: HeightField,
    repose: Repose,
    restless: bool,
}

impl Surface {
    /// A level surface at `level_z_m`.
    pub(crate) fn new(
        sandbox: &BoxConfig,
        cell_m: f64,
        level_z_m: f64,
        soil: &Soil,
    ) -> Result<Self, TerrainError> {
        let cells = |[low, high]: [f64; 2]| {
            let count = ((high - low) / cell_m).ceil().clamp(1.0, 1e4);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1e4")]
            let count = count as usize;
            count
        };
        let field = HeightField::level(cells(sandbox.x_m), cells(sandbox.y_m), cell_m, level_z_m)?;
        let angle_rad = if soil.cohesion_pa() > 0.0 { COHESIVE_RAD } else { soil.friction().radians() };
        Ok(Self {
            origin_m: [sandbox.x_m[0], sandbox.y_m[0]],
            level_z_m,
            level: field.clone(),
            field,
            repose: Repose::from_radians(angle_rad)?,
            restless: false,
        })
    }

    /// Level again.
    pub(crate) fn rake(&mut self) {
        self.field.clone_from(&self.level);
        self.restless = false;
    }

    /// Volume of soil above the table's height in m3; differences are what matters.
    pub(crate) fn volume_m3(&self) -> f64 {
        self.field.volume_m3()
    }

    /// Mean height in m ahead of the plate at `tip_m` over a length in m; beyond the walls it is level.
    pub(crate) fn ahead_m(&self, tip_m: [f64; 3], ahead: [f64; 2], length_m: f64, width_m: f64) -> f64 {
        let cell_m = self.field.cell_m();
        let place = self.place(tip_m);
        // From the next cell on: the plate's own is in part furrow.
        let from_m = [place[0] + cell_m * ahead[0], place[1] + cell_m * ahead[1]];
        self.field.mean_height_m(from_m, ahead, length_m, width_m).unwrap_or(self.level_z_m)
    }

    /// The plate has come by `way_m` to `tip_m` and has moved what was above its edge to within `heap_m` ahead, but for a share that runs past.
    pub(crate) fn push(
        &mut self,
        tip_m: [f64; 3],
        ahead: [f64; 2],
        way_m: f64,
        width_m: f64,
        [heap_m, share_past]: [f64; 2],
    ) {
        let to_m = self.place(tip_m);
        let from_m = [to_m[0] - way_m * ahead[0], to_m[1] - way_m * ahead[1]];
        let sweep = Sweep { from_m, to_m, width_m, bottom_m: tip_m[2], ahead_m: heap_m };
        // A place that is no number is reported as a lost arm in the same tick.
        self.restless |= self.field.push_past(&sweep, share_past).is_ok_and(|moved_m3| moved_m3 > 0.0);
    }

    /// Slopes run off, once after each stroke: while the plate is in it, it holds its heap back.
    pub(crate) fn come_to_rest(&mut self) {
        if std::mem::take(&mut self.restless) {
            self.field.lift();
            let (steps, excess) = REST;
            self.field.settle(&self.repose, steps, excess);
        }
    }

    fn place(&self, tip_m: [f64; 3]) -> [f64; 2] {
        [tip_m[0] - self.origin_m[0], tip_m[1] - self.origin_m[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use soilctl_soil::Angle;

    fn surface() -> Surface {
        let sandbox = BoxConfig { x_m: [0.1, 0.7], y_m: [-0.3, 0.3], floor_z_m: -0.5, top_z_m: 0.0 };
        let soil = Soil::new(Angle::from_degrees(35.0), 1500.0).unwrap();
        Surface::new(&sandbox, 0.005, -0.33, &soil).unwrap()
    }

    /// A stroke towards the base leaves a furrow and a heap; slopes run off to repose; not a grain is lost.
    #[test]
    fn a_stroke() {
        let mut surface = surface();
        let before = surface.volume_m3();
        for step in 1..=5 {
            let x = 0.4 - 0.005 * f64::from(step);
            surface.push([x, 0.0, -0.355], [-1.0, 0.0], 0.005, 0.12, [0.05, 0.0]);
        }
        let heap = |surface: &Surface| surface.ahead_m([0.375, 0.0, -0.355], [-1.0, 0.0], 0.05, 0.12) + 0.33;
        let steep = surface.field.steepest_slope();
        // At most 25 mm x 25 mm over 50 mm.
        assert!(heap(&surface) > 0.004 && heap(&surface) < 0.0125 + 1e-9, "{}", heap(&surface));
        surface.come_to_rest();
        let limit = libm::tan(35f64.to_radians());
        assert!(steep > limit && surface.field.steepest_slope() < limit + 0.1, "{steep}");
        assert!((surface.volume_m3() - before).abs() < 1e-12);
        let settled = surface.clone();
        surface.come_to_rest();
        assert!(surface == settled);
        surface.rake();
        assert!(heap(&surface).abs() < 1e-12);
    }
}
