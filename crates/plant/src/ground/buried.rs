//! Rigid blocks in the sand, and what a plate feels of them: soil that has to pass above, and contact.
//!
//! Ahead of a block the soil can only fail along a plane that passes above the edge of its top. The force is that of Coulomb's wedge (1776),
//! `P = W sin(theta + phi) / sin(alpha + delta + theta + phi)`, least over the planes of slope theta that do, over the same without the block. A
//! plane wedge overrates friction on the plate and locks too early, so a part of that friction is taken. The limit force of the plant, from whatever
//! model, is multiplied by the ratio.

use std::f64::consts::{FRAC_PI_2, PI};

use serde::{Deserialize, Serialize};

use crate::PlantError;
use crate::rules::Rules;

/// Part of the friction on the plate in the wedge [chosen: three quarters of a depth to one depth ahead ratios are of the size that bounds of limit
/// analysis have; they rise later and more steeply than these].
const PLATE_SHARE: f64 = 0.5;
/// Most of the ratio: soil that is locked between plate and block is crushed [assumed].
const MOST_RATIO: f64 = 20.0;
/// Stiffness of the contact of the whole plate with a block, in N/m [assumed]: 0.5 mm at 100 N.
const STIFFNESS_N_PER_M: f64 = 2e5;
/// Strips of the plate, each with the soil ahead of it.
const STRIPS: u32 = 9;
/// A block further ahead than so many depths is not felt: the flattest wedge is shorter.
const REACH: f64 = 12.0;

/// A rigid block that does not move, buried upright and aligned with a radius from the base axis; it reaches down as far as any plate goes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BuriedBlock {
    /// Distance from the base axis to the face that is turned away from it, which a pulled plate meets, in m; above 0, at most 10.
    pub face_radius_m: f64,
    /// Base angle of its middle in degrees; -180 to 180.
    pub base_deg: f64,
    /// Depth of its top below the level surface in m; 0 to 1.
    pub top_m: f64,
    /// Width across the radius in m; above 0, at most 10.
    pub width_m: f64,
    /// Length from that face towards the base in m; above 0, at most 10.
    pub length_m: f64,
}

impl BuriedBlock {
    /// Checks the numbers; `file` is named in messages.
    ///
    /// # Errors
    /// [`PlantError::Config`] naming the first key that is not allowed.
    pub fn check(&self, file: &str) -> Result<(), PlantError> {
        let rules = Rules { file };
        rules.positive("face_radius_m", self.face_radius_m, "m", 10.0)?;
        rules.range("base_deg", self.base_deg, "deg", -180.0, 180.0)?;
        rules.range("top_m", self.top_m, "m", 0.0, 1.0)?;
        rules.positive("width_m", self.width_m, "m", 10.0)?;
        rules.positive("length_m", self.length_m, "m", 10.0)
    }

    /// Way in m from a point (x, y) along a level unit vector to the block: 0 and below inside it, by how far it was entered; `None` if
    /// the way does not lead to it.
    #[must_use]
    pub fn way_m(&self, point_m: [f64; 2], ahead: [f64; 2]) -> Option<f64> {
        let (sin, cos) = libm::sincos(self.base_deg.to_radians());
        let middle = self.face_radius_m - 0.5 * self.length_m;
        let turned = |[x, y]: [f64; 2]| [x * cos + y * sin, y * cos - x * sin];
        let (at, along) = (turned(point_m), turned(ahead));
        let halves = [0.5 * self.length_m, 0.5 * self.width_m];
        let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
        for (axis, half) in halves.into_iter().enumerate() {
            let from = at[axis] - if axis == 0 { middle } else { 0.0 };
            if along[axis].abs() < 1e-12 {
                if from.abs() > half {
                    return None;
                }
                continue;
            }
            let ends = [(-half - from) / along[axis], (half - from) / along[axis]];
            enters = enters.max(ends[0].min(ends[1]));
            leaves = leaves.min(ends[0].max(ends[1]));
        }
        (enters <= leaves && leaves >= 0.0).then_some(enters)
    }
}

/// Least way ahead in m of a plate to a block that is not below it; below 0 by how far the block was entered. The plate has the middle of its
/// lower edge at `tip_m` (x, y), goes along a level unit vector, and is `depth_m` below the level surface.
#[must_use]
pub fn block_gap_m(
    blocks: &[BuriedBlock],
    tip_m: [f64; 2],
    ahead: [f64; 2],
    width_m: f64,
    depth_m: f64,
) -> Option<f64> {
    strips(tip_m, ahead, width_m)
        .flat_map(|from| blocks.iter().map(move |block| (block, from)))
        .filter(|(block, _)| depth_m > block.top_m)
        .filter_map(|(block, from)| block.way_m(from, ahead))
        .min_by(f64::total_cmp)
}

/// Middles of the strips of a plate.
fn strips([x, y]: [f64; 2], ahead: [f64; 2], width_m: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..STRIPS).map(move |strip| {
        let aside = width_m * ((f64::from(strip) + 0.5) / f64::from(STRIPS) - 0.5);
        [x - aside * ahead[1], y + aside * ahead[0]]
    })
}

/// What a plate feels of the blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nearby {
    /// Factor on the limit force.
    pub(super) ratio: f64,
    /// Force of the contact across the plate in N.
    pub(super) contact_n: f64,
    /// Least way ahead to a block in m that is not below the plate; below 0 by how far it was entered.
    pub(super) gap_m: Option<f64>,
}

impl Nearby {
    pub(super) const NOTHING: Self = Self { ratio: 1.0, contact_n: 0.0, gap_m: None };
}

/// A plate where it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plate {
    /// Middle of its lower edge in m (x, y).
    pub(super) tip_m: [f64; 2],
    /// Level unit vectors ahead and along its edge.
    pub(super) ahead: [f64; 2],
    pub(super) width_m: f64,
    /// Of its edge below the level surface in m.
    pub(super) depth_m: f64,
    pub(super) tool_angle_rad: f64,
}

/// What plate and soil are like to a wedge: friction angles in rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frictions {
    pub(super) soil_rad: f64,
    pub(super) plate_rad: f64,
}

/// Each strip of the plate has its own soil ahead: what a block narrower than the plate adds goes by the part of the width that it stands before.
pub(super) fn nearby(blocks: &[BuriedBlock], plate: &Plate, frictions: Frictions) -> Nearby {
    let mut found = Nearby::NOTHING;
    if plate.depth_m <= 0.0 {
        return found;
    }
    found.gap_m = block_gap_m(blocks, plate.tip_m, plate.ahead, plate.width_m, plate.depth_m);
    let share = 1.0 / f64::from(STRIPS);
    for from in strips(plate.tip_m, plate.ahead, plate.width_m) {
        let (mut most, mut entered_m) = (1.0_f64, 0.0_f64);
        for block in blocks {
            let above_tip_m = plate.depth_m - block.top_m;
            let Some(way_m) = block.way_m(from, plate.ahead) else { continue };
            if above_tip_m <= 0.0 || way_m > REACH * plate.depth_m {
                continue;
            }
            let least_slope = libm::atan2(above_tip_m, way_m.max(0.0));
            most = most.max(ratio(plate.tool_angle_rad, frictions, least_slope));
            entered_m = entered_m.max(-way_m);
        }
        found.ratio += share * (most - 1.0);
        found.contact_n += share * STIFFNESS_N_PER_M * entered_m;
    }
    found
}

/// Force of the weakest plane wedge that is at least so steep (rad) over that of the weakest of all.
fn ratio(alpha: f64, frictions: Frictions, least_slope: f64) -> f64 {
    let (phi, delta) = (frictions.soil_rad, PLATE_SHARE * frictions.plate_rad);
    // Steeper wedges are locked.
    let steepest = (PI - alpha - delta - phi).min(FRAC_PI_2);
    if least_slope >= steepest {
        return MOST_RATIO;
    }
    let force = |slope: f64| {
        let area = 1.0 / libm::tan(slope) + 1.0 / libm::tan(alpha);
        area * libm::sin(slope + phi) / libm::sin(alpha + delta + slope + phi)
    };
    let weakest = weakest(&force, steepest);
    if least_slope <= weakest { 1.0 } else { (force(least_slope) / force(weakest)).clamp(1.0, MOST_RATIO) }
}

/// The slope at which the force, which has one minimum, is least.
fn weakest(force: &impl Fn(f64) -> f64, steepest: f64) -> f64 {
    let (mut low, mut high) = (1e-3, steepest - 1e-6);
    // A hundredth of a degree.
    for _ in 0..24 {
        let third = (high - low) / 3.0;
        if force(low + third) < force(high - third) { high -= third } else { low += third }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    const BLOCK: BuriedBlock =
        BuriedBlock { face_radius_m: 0.3, base_deg: 90.0, top_m: 0.01, width_m: 0.2, length_m: 0.1 };

    fn at(y_m: f64, depth_m: f64) -> Nearby {
        let plate = Plate {
            tip_m: [0.0, y_m],
            ahead: [0.0, -1.0],
            width_m: 0.12,
            depth_m,
            tool_angle_rad: FRAC_PI_2,
        };
        let frictions = Frictions { soil_rad: 0.7, plate_rad: 0.0 };
        nearby(&[BLOCK], &plate, frictions)
    }

    #[test]
    fn ways_to_a_block() {
        let down = [0.0, -1.0];
        assert!((BLOCK.way_m([0.0, 0.35], down).unwrap() - 0.05).abs() < 1e-12);
        assert!((BLOCK.way_m([0.05, 0.29], down).unwrap() + 0.01).abs() < 1e-12);
        // Beside it, behind it, and off to the other side.
        assert_eq!(BLOCK.way_m([0.11, 0.35], down), None);
        assert_eq!(BLOCK.way_m([0.0, 0.15], down), None);
        assert_eq!(BLOCK.way_m([0.0, 0.35], [0.0, 1.0]), None);
        let s = 0.5f64.sqrt();
        // At 45 degrees it enters where it has gone down by 0.05.
        assert!((BLOCK.way_m([0.0, 0.35], [s, -s]).unwrap() - 0.05 / s).abs() < 1e-12);
    }

    /// Against a smooth upright wall, where the weakest plane rises at 45 deg - phi/2 and the force has a closed form.
    #[test]
    fn smooth_and_upright_it_is_rankine() {
        let phi = 0.7;
        let frictions = Frictions { soil_rad: phi, plate_rad: 0.0 };
        let critical = std::f64::consts::FRAC_PI_4 - 0.5 * phi;
        let k_p = libm::tan(std::f64::consts::FRAC_PI_4 + 0.5 * phi).powi(2);
        assert_eq!(ratio(FRAC_PI_2, frictions, critical - 0.01), 1.0);
        for slope in [critical + 0.05, critical + 0.2, critical + 0.35] {
            let expected = libm::tan(slope + phi) / libm::tan(slope) / k_p;
            assert!((ratio(FRAC_PI_2, frictions, slope) / expected - 1.0).abs() < 1e-6, "{slope}");
        }
        assert_eq!(ratio(FRAC_PI_2, frictions, 1.5), MOST_RATIO);
    }

    #[test]
    fn it_is_felt_more_and_more_and_then_touched() {
        let far: Vec<Nearby> = [0.45, 0.36, 0.34, 0.33, 0.32].map(|y| at(y, 0.03)).to_vec();
        assert_eq!((far[0].ratio, far[0].contact_n), (1.0, 0.0));
        assert!(far.windows(2).all(|pair| pair[1].ratio >= pair[0].ratio), "{far:?}");
        assert!(far[4].ratio > 1.2 && far[4].contact_n == 0.0, "{far:?}");
        assert!((far[4].gap_m.unwrap() - 0.02).abs() < 1e-12);
        let inside = at(0.2995, 0.03);
        assert!((inside.contact_n - 100.0).abs() < 1e-6, "{inside:?}");
        // A plate that goes above it does not feel it.
        assert_eq!(at(0.32, 0.01), Nearby::NOTHING);
    }

    #[test]
    fn half_a_plate_feels_half() {
        let plate = Plate {
            tip_m: [0.1, 0.32],
            ahead: [0.0, -1.0],
            width_m: 0.12,
            depth_m: 0.03,
            tool_angle_rad: FRAC_PI_2,
        };
        let frictions = Frictions { soil_rad: 0.7, plate_rad: 0.0 };
        let part = nearby(&[BLOCK], &plate, frictions).ratio - 1.0;
        let whole = at(0.32, 0.03).ratio - 1.0;
        assert!(part > 0.4 * whole && part < 0.6 * whole, "{part} {whole}");
    }
}
