use serde::{Deserialize, Serialize};
use soilctl_kinematics::TaskPose;

use super::{Active, Law, Setpoint, View};
use crate::config::StrokeLaw;
use crate::laws::{LeadAngle, LeadBounds};
use crate::{Finish, TICK_S};

/// What a stroke remembers. Inclinations in rad below the horizontal.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct StrokeRun {
    /// The integral of the orientation loop.
    pub angle: LeadAngle,
    /// Bounds of the lead's inclination.
    pub bounds: LeadBounds,
    /// Outward direction of the stroke's plane: cosine and sine of the base angle at the start.
    pub plane: [f64; 2],
    /// theta_plate, alpha - 90 deg.
    pub plate_rad: f64,
    /// Wanted angle of the force to the plate's normal.
    pub delta_rad: f64,
    /// Radius at the start in m.
    pub start_radius_m: f64,
    /// Height at the start in m, by the external encoders.
    pub start_z_m: f64,
    /// Smoothed radius and height from which the lead starts, by the external encoders, in m.
    pub smooth_m: [f64; 2],
    /// Tip by the motors minus tip by the external encoders at the start along x, y, z in m: free play and stretch, which the springs
    /// between wanted and motors' position must not take for a lead.
    pub offset_m: [f64; 3],
    /// Displacement along r and z in m beside the lead: what takes up the free play, and what friction keeps up.
    pub hold_m: [f64; 2],
    /// Whether the drives are through their free play and the plate presses on the soil. The lead waits for it.
    pub released: bool,
    /// Ticks for which it has pressed.
    pub taut_ticks: u32,
    /// Force on the sensor outwards and upwards, smoothed, in N: what the force was a moment ago.
    pub slow_force_n: [f64; 2],
    /// Lead in m.
    pub lead_m: f64,
    /// Inclination of the lead, theta_adj.
    pub lead_rad: f64,
    /// Inclination of the force, theta_env; the wanted one while there is too little force.
    pub force_rad: f64,
    /// Wanted inclination, theta_des.
    pub wanted_rad: f64,
    /// Largest force towards the base so far in N.
    pub peak_force_n: f64,
    /// Way of the plate towards the base in m.
    pub travel_m: f64,
    /// Height in m at which the soil failed, once it has.
    pub failure_z_m: Option<f64>,
    /// Largest rise of the plate since then in m.
    pub rise_m: f64,
    /// Largest force inclination over the wanted one since the soil failed, in rad.
    pub lift_rad: f64,
}

/// Time in s in which the force of the insertion is taken back, to 1/e, were there no friction.
const RELEASE_S: f64 = 0.15;
/// The same for a force across the lead that the lead alone is too small to turn.
const TRIM_S: f64 = 0.25;
/// Most force in N that the release reckons with, so that it is slow enough to stop in time.
const UNLOAD_N: f64 = 2.0;
/// Largest displacement in m that the force may ask for.
const MOST_TRIM_M: f64 = 0.03;
/// A force across the wanted direction, a part of it in N and a share of the whole, at which the lead waits.
const ACROSS_N: f64 = 0.3;
const ACROSS_SHARE: f64 = 0.15;
/// The lead never waits altogether: soil that slips on the plate has an angle of its own.
const LEAST_HASTE: f64 = 0.1;
/// How long ago "a moment ago" is, for the rate of the force, in s.
const RESPONSE_S: f64 = 0.05;
/// Share of the rate of force that the lead asks for above which the arm is taken to follow.
const FOLLOWS: f64 = 0.7;
/// What the integral of the orientation loop gets while the arm sticks.
const LEAST_PACE: f64 = 0.3;
/// Speed in m/s at which the drives go through their free play.
const TAKE_UP_M_S: f64 = 0.006;
/// Ticks for which the soil must press back before the lead begins.
const TAUT_TICKS: u32 = 15;
/// Longest time that is spent on it, in ticks.
const RELEASE_TICKS: u32 = 4000;

impl Active {
    pub(super) fn plan_stroke(&mut self, view: View<'_>, delta_rad: f64) -> Result<(), Finish> {
        let (est, settings) = (view.est, &view.params.config().stroke);
        let (sin, cos) = libm::sincos(est.joints.0[0]);
        let plate_rad = est.pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
        let (margin, upper) = (settings.lower_margin_deg.to_radians(), settings.upper_bound_deg.to_radians());
        let [fx, fy, fz] = est.force_xyz_n;
        let [k_r, _, k_z] = view.params.config().gains.stiffness_n_per_m;
        let displacement =
            |force: f64, stiffness: f64| if stiffness > 0.0 { -force / stiffness } else { 0.0 };
        let motor = view.params.arm().forward(&est.motor).map_err(|_| Finish::Unreachable)?;
        let seen_m = [along(&est.seen, [cos, sin]), est.seen.z_m];
        self.stroke = StrokeRun {
            offset_m: offset(&motor, &est.seen),
            // Else the torques that pressed the plate in would be gone at once, and the drives leap through their play.
            hold_m: [displacement(fx * cos + fy * sin, k_r), displacement(fz, k_z)],
            bounds: LeadBounds::new(plate_rad, delta_rad, margin, upper),
            plane: [cos, sin],
            plate_rad,
            delta_rad,
            start_radius_m: along(&est.pose, [cos, sin]),
            start_z_m: seen_m[1],
            smooth_m: seen_m,
            lead_m: settings.initial_lead_m,
            lead_rad: plate_rad + delta_rad,
            wanted_rad: plate_rad + delta_rad,
            force_rad: plate_rad + delta_rad,
            ..StrokeRun::default()
        };
        Ok(())
    }

    /// Orientation by feedback, magnitude by an open-loop lead (eqs 5.11 and 5.24 to 5.26).
    pub(super) fn do_stroke(&mut self, view: View<'_>, law: StrokeLaw) -> (Setpoint, Option<Finish>) {
        let (est, settings, run) = (view.est, &view.params.config().stroke, &mut self.stroke);
        let [cos, sin] = run.plane;
        let [fx, fy, fz] = est.force_xyz_n;
        let outward = fx * cos + fy * sin;
        let force = libm::hypot(outward, fz);
        let has_direction = force >= settings.least_force_n;
        // The hand turns with the arm, since the wrist is off.
        run.plate_rad = est.pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
        run.wanted_rad = run.plate_rad + run.delta_rad;
        // The soil presses back with the opposite of the plate's force: outwards and up.
        run.force_rad = if has_direction { libm::atan2(fz, outward) } else { run.wanted_rad };
        run.peak_force_n = run.peak_force_n.max(outward);
        run.travel_m = run.start_radius_m - along(&est.pose, run.plane);

        // After the failure a quick loop would hide a plate that lifts.
        let failed = run.travel_m >= settings.failure_travel_m;
        let short = run.wanted_rad - run.force_rad;
        let pace = run.pace(view, [outward, fz]);
        if !run.released {
            run.take_up(view, [outward, fz], self.ticks);
        } else if !failed {
            run.turn(view, law, [outward, fz], pace);
        }

        // Too flat for its size: let the orientation catch up before pressing harder (section 5.3.3).
        let largest = view.params.safe_force().largest_n(run.force_rad - run.plate_rad);
        let unsafe_force = has_direction && short > 0.0 && largest.is_some_and(|largest| force > largest);
        if run.released && !unsafe_force {
            let haste = match law {
                StrokeLaw::Force => haste(force, force * libm::sin(short)),
                StrokeLaw::Position => 1.0,
            };
            run.lead_m = (run.lead_m + haste * view.tuning.lead_rate_m_s * TICK_S).min(settings.max_lead_m);
        }
        if failed {
            let from = *run.failure_z_m.get_or_insert(run.smooth_m[1]);
            run.rise_m = run.rise_m.max(run.smooth_m[1] - from);
        }
        if failed && has_direction {
            run.lift_rad = run.lift_rad.max(-short);
        }

        let (sin_lead, cos_lead) = libm::sincos(run.lead_rad);
        let smoothing = view.params.stroke_smoothing;
        run.smooth_m[0] += smoothing * (along(&est.seen, run.plane) - run.smooth_m[0]);
        run.smooth_m[1] += smoothing * (est.seen.z_m - run.smooth_m[1]);
        let wanted_radius = run.smooth_m[0] - run.lead_m * cos_lead + run.hold_m[0];
        let wanted_z = run.smooth_m[1] - run.lead_m * sin_lead + run.hold_m[1];
        let place = [wanted_radius * cos, wanted_radius * sin, wanted_z];
        let position_m = std::array::from_fn(|i| place[i] + run.offset_m[i]);
        let finish = if run.travel_m >= settings.max_travel_m {
            Some(Finish::TravelLimit)
        } else if run.lead_m >= settings.max_lead_m {
            Some(Finish::LeadLimit)
        } else if view.saturated_ticks >= view.params.config().safety.saturated_ticks / 2 {
            // Some time before it is a fault.
            Some(Finish::TorqueLimit)
        } else if self.ticks >= settings.max_ticks {
            Some(Finish::TimeLimit)
        } else {
            None
        };
        let setpoint =
            Setpoint { law: Law::Stiffness, joints: self.from_joints, position_m, ..Setpoint::default() };
        (setpoint, finish)
    }
}

impl StrokeRun {
    /// Takes back the force of the insertion along the plate and leads the drives through their free play across it, until the
    /// soil presses back on the plate's face. The plate stays seated: a little force downwards does no harm (section 5.3.2.3).
    fn take_up(&mut self, view: View<'_>, [outward, fz]: [f64; 2], ticks: u32) {
        let seat_n = view.params.config().stroke.least_force_n;
        let (sin, cos) = libm::sincos(self.plate_rad);
        // Of the soil on the plate: against its face, and upwards along it.
        let (normal, tangent) = (outward * cos + fz * sin, fz * cos - outward * sin);
        let taut_n = 2.0 * seat_n;
        let excess = tangent - normal.max(0.0) * libm::tan(self.delta_rad) - seat_n;
        let upwards = excess.clamp(-UNLOAD_N, UNLOAD_N);
        // At the wanted angle it is short of the seat's force. To wait for more would press down motors that stick, until they come loose
        // all at once.
        let unloaded = excess < 0.5 * seat_n && excess > -1.5 * seat_n;
        let taut = normal >= taut_n;
        // While the plate is still pressed down it must not be pressed against the soil, which could fail.
        let back = if unloaded { 0.0 } else { (normal - taut_n).clamp(0.0, UNLOAD_N) };
        self.trim(view, [back * cos - upwards * sin, back * sin + upwards * cos], RELEASE_S);
        self.taut_ticks = if taut && unloaded { self.taut_ticks + 1 } else { 0 };
        if !taut && excess < 2.0 * seat_n {
            let way = TAKE_UP_M_S * TICK_S;
            self.hold_m[0] = (self.hold_m[0] - way * cos).max(-MOST_TRIM_M);
            self.hold_m[1] = (self.hold_m[1] - way * sin).clamp(-MOST_TRIM_M, MOST_TRIM_M);
        }
        if self.taut_ticks >= TAUT_TICKS || ticks >= RELEASE_TICKS {
            self.released = true;
            self.start_z_m = view.est.seen.z_m;
        }
    }

    /// Turns the lead.
    fn turn(&mut self, view: View<'_>, law: StrokeLaw, [outward, fz]: [f64; 2], pace: f64) {
        let settings = &view.params.config().stroke;
        let (sin, cos) = libm::sincos(self.wanted_rad);
        // Positive if the plate has to press more downwards.
        let across = outward * sin - fz * cos;
        let (error, gains, pace) = match law {
            // The correction is a force; as an angle it is the smaller the more force the lead asks for.
            StrokeLaw::Force => {
                let stiffness = view.params.config().gains.stiffness_n_per_m[2];
                let asked =
                    (stiffness * self.lead_m).max(libm::hypot(outward, fz)).max(settings.least_force_n);
                let gains = [settings.force_p, settings.force_p * settings.force_i_per_s];
                (across / asked, gains, pace)
            }
            StrokeLaw::Position => {
                let risen = view.est.seen.z_m - self.start_z_m;
                (risen, [settings.position_p_rad_per_m, settings.position_i_rad_per_m_s], 1.0)
            }
        };
        self.lead_rad = self.angle.update(self.wanted_rad, error, gains, pace, self.bounds);
        let at_bound = self.lead_rad <= self.bounds.lower_rad || self.lead_rad >= self.bounds.upper_rad;
        if law == StrokeLaw::Force && at_bound {
            self.trim(view, [across * sin, -across * cos], TRIM_S);
        }
    }

    /// How fast the integral goes: with the force, not with time. While dry friction holds the motors, the force does not answer to
    /// the lead, and an integral would wind up until they come loose all at once, far beyond the wanted angle.
    fn pace(&mut self, view: View<'_>, force_n: [f64; 2]) -> f64 {
        let ahead: [f64; 2] = std::array::from_fn(|i| force_n[i] - self.slow_force_n[i]);
        for (slow, ahead) in self.slow_force_n.iter_mut().zip(ahead) {
            *slow += ahead * TICK_S / RESPONSE_S;
        }
        let rate = libm::hypot(ahead[0], ahead[1]) / RESPONSE_S;
        let asked_n_per_s = view.params.config().gains.stiffness_n_per_m[2] * view.tuning.lead_rate_m_s;
        (rate / (FOLLOWS * asked_n_per_s).max(1e-9)).clamp(LEAST_PACE, 1.0)
    }

    /// Moves what is held by a force along r and z in N, over the stiffness and this time in s.
    fn trim(&mut self, view: View<'_>, force_n: [f64; 2], time_s: f64) {
        let [k_r, _, k_z] = view.params.config().gains.stiffness_n_per_m;
        for (hold, (force, stiffness)) in self.hold_m.iter_mut().zip(force_n.into_iter().zip([k_r, k_z])) {
            let trimmed = *hold + force / stiffness.max(1.0) * TICK_S / time_s;
            *hold = trimmed.clamp(-MOST_TRIM_M, MOST_TRIM_M);
        }
    }
}

/// Share of the lead's rate while a part of the force in N stands across the wanted direction: the orientation shall catch up
/// before the plate presses harder.
fn haste(force_n: f64, across_n: f64) -> f64 {
    (1.0 - across_n.abs() / (ACROSS_N + ACROSS_SHARE * force_n)).max(LEAST_HASTE)
}

/// Place of a pose along a horizontal direction in m.
fn along(pose: &TaskPose, [cos, sin]: [f64; 2]) -> f64 {
    pose.x_m * cos + pose.y_m * sin
}

/// Tip by the motors minus tip by the external encoders in m.
fn offset(motor: &TaskPose, external: &TaskPose) -> [f64; 3] {
    let (motor, external) = (motor.position_m(), external.position_m());
    std::array::from_fn(|i| motor[i] - external[i])
}
