use soilctl_kinematics::Frame;

use super::buried::Nearby;
use super::strength::Strength;
use crate::config::{GroundConfig, LossLaw, MobilisationLaw, TangentLaw};
use crate::effects::SoilChange;
use crate::truth::SoilTruth;

/// Share of the limit from which on the soil counts as failing.
const FAILING: f64 = 0.995;
/// Failure ratio of the hyperbola along the plate (Clough and Duncan 1971 found 0.7 to 0.95 for sand on concrete).
const SLIP_RATIO: f64 = 0.8;
/// Depth below which nothing is divided by it, in m.
const LEAST_DEPTH_M: f64 = 0.001;
/// Share of the edge's resistance that counts as load even if the plate hardly stands on it.
const STANDING: f64 = 0.1;
/// Depth at which the damping is the one of the settings, in m.
const DAMPED_AT_M: f64 = 0.0254;

/// The contact of plate and soil, and what it remembers.
///
/// Across the plate the mobilised share of the limit force grows with the way of the plate against the soil, slower the
/// more is mobilised; along it and sideways there are springs that slip at the friction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PlateContact {
    /// What is mobilised, -1 to 1.
    mobilised: f64,
    /// Factor of buried blocks on the limit force so far; 0 before the plate has met soil.
    ratio: f64,
    /// Stretch of the springs along the plate (soil pressing upwards) and along its edge in m.
    stretch_m: [f64; 2],
    deepest_m: f64,
    /// Way of the failing soil, a mean over the wedge, in m.
    slip_m: f64,
    /// Share of the friction on the plate by which the limit force goes, 0 to 1.
    share: f64,
    /// Forces across and along the plate and along its edge in N, damping included.
    forces_n: [f64; 3],
    pub(crate) slant_m: f64,
    pub(crate) speed_m_s: f64,
    /// Way of the failing soil that the surface does not know yet, in m.
    pub(crate) moved_m: f64,
    pub(crate) truth: SoilTruth,
}

impl PlateContact {
    #[allow(clippy::too_many_arguments, reason = "called from one place")]
    pub(crate) fn press(
        &mut self,
        config: &GroundConfig,
        strength: &Strength,
        change: &SoilChange,
        near: &Nearby,
        [width_m, thickness_m]: [f64; 2],
        hand: &Frame,
        [depth_m, heap_m]: [f64; 2],
        velocity_m_s: [f64; 3],
        dt_s: f64,
    ) {
        let axis = |column: usize| [0, 1, 2].map(|row: usize| hand.rotation[row][column]);
        let along = |column: usize| dot(axis(column), velocity_m_s);
        // Towards the base, sideways, and into the soil.
        let (push, side, down) = (along(0), along(1), along(2));
        let alpha = tool_angle_rad(hand);
        if depth_m <= 0.0 || alpha <= 0.2 || alpha >= std::f64::consts::PI - 0.2 {
            *self = Self {
                truth: SoilTruth {
                    depth_m,
                    tool_angle_rad: alpha,
                    heap_m,
                    block_gap_m: near.gap_m,
                    ..SoilTruth::default()
                },
                ..Self::default()
            };
            return;
        }
        self.slant_m = depth_m / libm::sin(alpha);
        self.speed_m_s = libm::sqrt(dot(velocity_m_s, velocity_m_s));
        let delta = (strength.delta_rad + change.interface_rad).max(0.0);
        let friction = libm::tan(delta);

        // Soil that the edge pushes aside moves against the plate.
        let deeper = (depth_m - self.deepest_m).max(0.0);
        if deeper > 0.0 {
            // A deeper wedge holds soil that has not slipped yet; their volumes go by the square of the depth.
            let slipped = self.deepest_m / depth_m;
            self.slip_m *= slipped * slipped;
            self.deepest_m = depth_m;
        }
        let lean = libm::cos(alpha) / std::f64::consts::FRAC_1_SQRT_2;
        let drift = config.misalignment_drift + config.insertion_drift * lean;
        let way = push * dt_s + drift * deeper;

        let [normal, tangent] = [self.forces_n[0], self.forces_n[1]];
        let share = if delta > 0.0 { libm::atan2(tangent, normal.abs().max(1e-6)) / delta } else { 1.0 };
        // The wedge that will fail follows the force's inclination, but not a vibration of the arm: a force across the plate
        // that goes at once by the force along it feeds energy into both, and an arm on cables starts to hum.
        let follows = if self.mobilised == 0.0 { 1.0 } else { dt_s / (config.wedge_time_s + dt_s) };
        self.share += follows * (share.clamp(0.0, 1.0) - self.share);
        let share = self.share;
        let facing = if self.mobilised < 0.0 { std::f64::consts::PI - alpha } else { alpha };
        let limit = change.limit_force * strength.limit_n(facing, depth_m, heap_m, width_m, share);
        let residual = self.residual(config, strength);
        let most_normal = limit * libm::cos(share * delta) * residual * near.ratio;
        // Soil that bears more since it is confined has to be pressed together first: the force does not leap.
        if near.ratio > self.ratio && self.ratio > 0.0 {
            self.mobilised *= self.ratio / near.ratio;
        }
        self.ratio = near.ratio;
        let failing = self.mobilise(config, strength, change, alpha, depth_m, way);

        // Both faces hold the plate in soil at rest; at the limit the net force of both is inclined by the friction alone.
        let rests = 1.0 - libm::pow(self.mobilised.abs(), bend(config, strength, alpha));
        let at_rest = 2.0 * strength.at_rest_n(depth_m, width_m) * friction * rests;
        let edge = change.bearing * strength.edge_n(depth_m, width_m, thickness_m, config.bearing_shape);
        let normal = self.mobilised * most_normal;
        let grip = normal.abs() * friction + at_rest;
        // An inclined load bears less, by Meyerhof's (1963) factor: what presses the plate ahead, against what it stands on.
        let stands = tangent.max(0.0) + STANDING * edge;
        let upright = (1.0 - libm::atan2(normal.max(0.0), stands) / strength.phi_rad).max(0.0);
        let bearing = edge * upright * upright;
        let spring = (most_normal * friction + at_rest + edge) / config.tangent_way_m;
        // The failing wedge rises along the plate.
        let rising = if failing { push.max(0.0) } else { 0.0 };
        let law = config.tangent_law;
        let tangent =
            slip(law, &mut self.stretch_m[0], (down + rising) * dt_s, spring, -grip, grip + bearing);
        let most_side = grip + edge * thickness_m / width_m;
        let lateral = slip(law, &mut self.stretch_m[1], side * dt_s, spring, -most_side, most_side);

        let damping = config.damping_ns_per_m * depth_m / DAMPED_AT_M;
        let free = |force: f64, most: f64| if most > 0.0 { (1.0 - force.abs() / most).max(0.0) } else { 0.0 };
        self.forces_n = [
            normal + near.contact_n + damping * push * free(self.mobilised, 1.0),
            tangent + damping * down * free(tangent, grip + bearing),
            lateral + damping * side * free(lateral, most_side),
        ];
        self.truth = SoilTruth {
            depth_m,
            heap_m,
            tool_angle_rad: alpha,
            limit_force_n: change.limit_force * strength.limit_n(alpha, depth_m, heap_m, width_m, 1.0),
            limit_force_now_n: libm::hypot(most_normal, tangent),
            force_n: self.force_n(hand),
            normal_n: self.forces_n[0],
            tangent_n: self.forces_n[1],
            lateral_n: self.forces_n[2],
            mobilisation: self.mobilised,
            failing,
            slip_m: self.slip_m,
            block_gap_m: near.gap_m,
        };
    }

    /// Moves the plate by `way` against the soil; says whether the soil fails.
    fn mobilise(
        &mut self,
        config: &GroundConfig,
        strength: &Strength,
        change: &SoilChange,
        alpha: f64,
        depth_m: f64,
        way: f64,
    ) -> bool {
        let dense = strength.relative_density;
        let ratio =
            config.loose_mobilisation + dense * (config.dense_mobilisation - config.loose_mobilisation);
        let failure_m = (change.mobilisation_way * ratio * depth_m.max(LEAST_DEPTH_M)).max(1e-6);
        let bend = bend(config, strength, alpha);
        let slope = (1.0 + 2.0 / bend) / failure_m;
        let left = if way * self.mobilised > 0.0 {
            match config.mobilisation_law {
                MobilisationLaw::Power => 1.0 - libm::pow(self.mobilised.abs(), bend),
                MobilisationLaw::Hyperbola => {
                    let left = 1.0 - 2.0 / (bend + 2.0) * self.mobilised.abs();
                    left * left
                }
            }
        } else {
            1.0
        };
        self.mobilised = (self.mobilised + slope * way * left).clamp(-1.0, 1.0);
        let failing = self.mobilised >= FAILING && way > 0.0;
        if failing {
            self.slip_m += way;
            self.moved_m += way;
        }
        failing
    }

    /// Dense soil loses strength after its peak.
    fn residual(&self, config: &GroundConfig, strength: &Strength) -> f64 {
        if self.slip_m == 0.0 {
            return 1.0;
        }
        let way = self.slip_m / config.residual_way_m;
        let lost = match config.loss_law {
            LossLaw::Exponential => 1.0 - libm::exp(-way),
            LossLaw::Linear => (0.5 * way).min(1.0),
        };
        1.0 - config.residual_drop * strength.relative_density * lost
    }

    /// Force on the plate in base coordinates.
    pub(crate) fn force_n(&self, hand: &Frame) -> [f64; 3] {
        let [normal, tangent, lateral] = self.forces_n;
        hand.rotation.map(|[x, y, z]| -normal * x - lateral * y - tangent * z)
    }
}

/// Tool angle in rad.
pub(super) fn tool_angle_rad(hand: &Frame) -> f64 {
    libm::atan2(-hand.rotation[2][2], hand.rotation[2][0])
}

/// How late the soil yields on the way to its limit: gradually at steep angles and in loose soil, drastically else.
fn bend(config: &GroundConfig, strength: &Strength, alpha: f64) -> f64 {
    let flat = ((config.gradual_above_deg - alpha.to_degrees()) / 10.0).clamp(0.0, 1.0);
    let bend = config.gradual_exponent + flat * (config.drastic_exponent - config.gradual_exponent);
    bend * (1.0 + strength.relative_density)
}

/// What slips at its limits, by a law of friction: its force in N after a further way in m.
fn slip(law: TangentLaw, stretch_m: &mut f64, way_m: f64, stiffness: f64, least: f64, most: f64) -> f64 {
    let free = stiffness * (*stretch_m + way_m);
    // The force, and what the spring would bear at that stretch.
    let (force, linear) = match law {
        TangentLaw::Spring => {
            let force = free.max(least).min(most);
            (force, force)
        }
        TangentLaw::Hyperbola => {
            let limit = if free < 0.0 { least } else { most };
            let way = if limit == 0.0 { 0.0 } else { (free / limit).min(1.0 / (1.0 - SLIP_RATIO)) };
            (limit * way / (1.0 + SLIP_RATIO * way), limit * way)
        }
    };
    *stretch_m = if stiffness > 0.0 { linear / stiffness } else { 0.0 };
    force
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::{PlantParams, SoilPreset};

    /// The hyperbola of Kondner, m = k x / (1 + R k x), with the first stiffness and the way to failure of the settings.
    #[test]
    fn a_hyperbola_ends_at_failure() {
        let preset = SoilPreset::named("ticino_loose").unwrap();
        let (soil, interface) = preset.soil().unwrap();
        let model = soilctl_earth_pressure::model("chen").unwrap();
        let mut config = PlantParams::thesis().config().ground;
        config.mobilisation_law = MobilisationLaw::Hyperbola;
        let strength = Strength::new(&config, &preset, model.as_ref(), &soil, &interface).unwrap();
        let (alpha, depth_m, step_m) = (std::f64::consts::FRAC_PI_2, 0.025, 1e-7);
        let dense = strength.relative_density;
        let failure_m = depth_m
            * (config.loose_mobilisation + dense * (config.dense_mobilisation - config.loose_mobilisation));
        let bend = bend(&config, &strength, alpha);
        let (stiffness, ratio) = ((1.0 + 2.0 / bend) / failure_m, 2.0 / (bend + 2.0));
        let (mut plate, mut way_m) = (PlateContact::default(), 0.0);
        while !plate.mobilise(&config, &strength, &SoilChange::default(), alpha, depth_m, step_m) {
            way_m += step_m;
            let exact = stiffness * way_m / (1.0 + ratio * stiffness * way_m);
            assert!((plate.mobilised - exact).abs() < 1e-4, "{} for {exact}", plate.mobilised);
        }
        assert!(way_m < failure_m && way_m > 0.98 * failure_m, "{way_m} of {failure_m} m");
    }

    /// Both laws along the plate start with the same stiffness and end at the same limits, whichever way it goes.
    #[test]
    fn slip_ends_at_its_limits() {
        for law in [TangentLaw::Spring, TangentLaw::Hyperbola] {
            let mut stretch_m = 0.0;
            let first = slip(law, &mut stretch_m, 1e-9, 1e3, -1.0, 2.0);
            assert!((first / 1e-6 - 1.0).abs() < 1e-5, "{law:?}: {first}");
            assert!((slip(law, &mut stretch_m, 1.0, 1e3, -1.0, 2.0) - 2.0).abs() < 1e-12, "{law:?}");
            assert!((slip(law, &mut stretch_m, -1.0, 1e3, -1.0, 2.0) + 1.0).abs() < 1e-12, "{law:?}");
            assert_eq!(slip(law, &mut stretch_m, -1.0, 0.0, 0.0, 0.0), 0.0);
        }
    }
}
