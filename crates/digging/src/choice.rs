//! Which tool angle fails the soil at least cost.

use soilctl_controller::{Params, StrokeSpec};
use soilctl_earth_pressure::ForceModel;

use crate::forces::{Bite, sliding_n};
use crate::insertion::insertion_n;
use crate::load::{Load, Push, load};
use crate::stance::{Way, sinks, way};
use crate::{DiggingError, Soils};

/// What is to be least.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// The greatest share of a torque limit.
    Torque,
    /// Squared currents: heat.
    Heat,
    /// Work on the soil for each volume that is moved.
    Work,
}

/// Step in deg in which tool angles are tried first, and the width to which the best place is narrowed down.
const STEP_DEG: f64 = 2.5;
const WIDTH_DEG: f64 = 0.05;
/// Part of an interval that golden section keeps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Where and how deep to stroke, for how far; the tool angle is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Task {
    /// Radius of the insertion from the base axis in m.
    pub radius_m: f64,
    /// Base angle in rad.
    pub base_rad: f64,
    /// Height of the surface in m.
    pub surface_z_m: f64,
    /// Depth of the lower edge in m.
    pub depth_m: f64,
    /// Length of the stroke in m.
    pub length_m: f64,
    /// Dry friction of the drives in N m, by motor.
    pub friction_nm: [f64; 5],
}

/// What a stroke at a tool angle takes at most, in the strongest of all soils.
#[derive(Debug, Clone, PartialEq)]
pub struct Cost {
    /// Tool angle at the insertion in deg.
    pub tool_angle_deg: f64,
    /// Tool angles, from the begin of the stroke to its end, in deg.
    pub turns_deg: [f64; 2],
    /// Failure force in N at the begin: what every soil bears, if it is proven, and what fails every soil.
    pub force_n: (Option<f64>, f64),
    /// Greatest share of a torque limit, while the plate is pushed in or anywhere on the way.
    pub share: f64,
    /// Force in N along the plate that pushes it in, and the share of a torque limit that it takes.
    pub insertion: (f64, f64),
    /// Greatest heat rate of insertion and way in A2.
    pub heat_a2: f64,
    /// Work on the soil for a volume that is moved in J/m3: mean force ahead over the area that is cut.
    pub work_j_m3: f64,
    /// The load at the begin.
    pub load: Load,
}

impl Cost {
    /// What an aim makes least.
    #[must_use]
    pub const fn of(&self, aim: Aim) -> f64 {
        match aim {
            Aim::Torque => self.share,
            Aim::Heat => self.heat_a2,
            Aim::Work => self.work_j_m3,
        }
    }
}

impl Task {
    /// The stroke at a tool angle (deg) and wanted inclination of the force (deg).
    #[must_use]
    pub fn stroke(&self, tool_angle_deg: f64, delta_deg: f64) -> StrokeSpec {
        StrokeSpec {
            batch: 0,
            radius_m: self.radius_m,
            base_rad: self.base_rad,
            tool_angle_rad: tool_angle_deg.to_radians(),
            depth_m: self.depth_m,
            delta_rad: delta_deg.to_radians(),
        }
    }

    /// What a stroke at a tool angle takes at most, with `heap_m` (m) of soil ahead of the plate at each of the places of its way, or level soil
    /// if there are none.
    ///
    /// # Errors
    /// [`DiggingError::Kinematics`] if the arm does not reach it, others as of [`crate::borne`].
    pub fn cost(
        &self,
        params: &Params,
        model: &dyn ForceModel,
        soils: &Soils,
        tool_angle_deg: f64,
        heap_m: &[f64],
    ) -> Result<Cost, DiggingError> {
        let delta_deg = soils.delta_deg()[1];
        let stroke = self.stroke(tool_angle_deg, delta_deg);
        let way: Way = way(params, &stroke, self.surface_z_m, self.length_m)?;
        let width_m = params.arm().config().plate.width_m;
        let level = Bite { tool_angle_deg, depth_m: self.depth_m, heap_m: 0.0, width_m };
        let inserts_n = insertion_n(soils, &level, params.arm().config().plate.thickness_m);
        let Some(start) = way.joints.first() else { return Err(DiggingError::NoWay) };
        let along = Push { force_n: inserts_n, inclination_rad: std::f64::consts::FRAC_PI_2, up_m: 0.0 };
        let inserting = load(params, start, &along, &self.friction_nm)?;
        let (mut share, mut heat_a2, mut ahead_n) = (inserting.share, inserting.heat_a2, 0.0);
        let mut first = None;
        let mut cut_m = 0.0;
        for (i, (joints, tool_angle_deg)) in way.joints.iter().zip(&way.tool_angle_deg).enumerate() {
            let heap_m = heap_m.get(i).copied().unwrap_or(0.0);
            let depth_m = self.depth_m + sinks(stroke.tool_angle_rad.to_degrees()) * way.travel_m[i];
            let bite = Bite { tool_angle_deg: *tool_angle_deg, depth_m, heap_m, width_m };
            let force_n = sliding_n(model, soils, &bite)?;
            let up_m = depth_m / libm::sin(tool_angle_deg.to_radians()) / 3.0;
            cut_m += depth_m;
            let push = Push { force_n: force_n.1, inclination_rad: delta_deg.to_radians(), up_m };
            let here = load(params, joints, &push, &self.friction_nm)?;
            share = share.max(here.share);
            heat_a2 = heat_a2.max(here.heat_a2);
            ahead_n += here.ahead_n;
            first.get_or_insert((force_n, here));
        }
        let Some((force_n, load)) = first else { return Err(DiggingError::NoWay) };
        let ends = [way.tool_angle_deg.first(), way.tool_angle_deg.last()];
        Ok(Cost {
            tool_angle_deg,
            turns_deg: ends.map(|end| end.copied().unwrap_or(tool_angle_deg)),
            force_n,
            share,
            insertion: (inserts_n, inserting.share),
            heat_a2,
            work_j_m3: ahead_n / (width_m * cut_m),
            load,
        })
    }

    /// The tool angle of least cost within an interval (deg): a scan, then golden section about its best place; `None` if the arm reaches no
    /// angle of the scan.
    ///
    /// # Errors
    /// As [`Task::cost`], but for angles that the arm does not reach.
    pub fn best(
        &self,
        params: &Params,
        model: &dyn ForceModel,
        soils: &Soils,
        angles_deg: [f64; 2],
        aim: Aim,
        heap_m: &[f64],
    ) -> Result<Option<Cost>, DiggingError> {
        let [low, high] = angles_deg;
        let at = |deg: f64| match self.cost(params, model, soils, deg, heap_m) {
            Ok(cost) => Ok(Some(cost)),
            Err(DiggingError::Kinematics(_) | DiggingError::WayEnds { .. }) => Ok(None),
            Err(other) => Err(other),
        };
        let value = |cost: &Option<Cost>| cost.as_ref().map_or(f64::INFINITY, |cost| cost.of(aim));
        let steps = ((high - low) / STEP_DEG).ceil().clamp(1.0, 100.0);
        let mut best: Option<Cost> = None;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 100")]
        for i in 0..=steps as u32 {
            let found = at(low + (high - low) * f64::from(i) / steps)?;
            if value(&found) < value(&best) {
                best = found;
            }
        }
        let Some(middle) = best.as_ref().map(|cost| cost.tool_angle_deg) else { return Ok(None) };
        let step = (high - low) / steps;
        let (mut a, mut b) = ((middle - step).max(low), (middle + step).min(high));
        while b - a > WIDTH_DEG {
            let [left, right] = [b - GOLDEN * (b - a), a + GOLDEN * (b - a)];
            let [l, r] = [at(left)?, at(right)?];
            // Out of reach on one side of the best place only: away from there.
            let goes_left = if value(&l).is_infinite() && value(&r).is_infinite() {
                middle < left
            } else {
                value(&l) <= value(&r)
            };
            if goes_left {
                b = right
            } else {
                a = left
            }
            for found in [l, r] {
                if value(&found) < value(&best) {
                    best = found;
                }
            }
        }
        Ok(best)
    }
}
