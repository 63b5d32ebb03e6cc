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
    /// Radius at the start in m.
    pub start_radius_m: f64,
    /// Height at the start in m.
    pub start_z_m: f64,
    /// Smoothed radius and height from which the lead starts, in m.
    pub smooth_m: [f64; 2],
    /// Tip by the motors minus tip by the external encoders at the start along x, y, z in m: free play and stretch, which the springs
    /// between wanted and motors' position must not take for a lead.
    pub offset_m: [f64; 3],
    /// Displacement along r and z in m that keeps the force with which the stroke began; along z it is turned until the
    /// force has the wanted inclination (position feedback: until the insertion's force is gone).
    pub hold_m: [f64; 2],
    /// Whether the force of the insertion is gone. The lead waits for it.
    pub released: bool,
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
/// The same for what friction keeps up during the stroke; slower than the loop that turns the lead.
const TRIM_S: f64 = 0.8;
/// Largest displacement along z in m that the force may ask for.
const MOST_TRIM_M: f64 = 0.01;
/// How many times faster the lead grows while the drives go through their free play and the plate feels nothing.
const HASTE: f64 = 5.0;
/// Longest time that is spent on it, in ticks.
const RELEASE_TICKS: u32 = 1500;

impl Active {
    pub(super) fn plan_stroke(&mut self, view: View<'_>, delta_rad: f64) -> Result<(), Finish> {
        let (est, settings) = (view.est, &view.params.config().stroke);
        let (sin, cos) = libm::sincos(est.external.0[0]);
        let plate_rad = est.pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
        let (margin, upper) = (settings.lower_margin_deg.to_radians(), settings.upper_bound_deg.to_radians());
        let [fx, fy, fz] = est.force_xyz_n;
        let [k_r, _, k_z] = view.params.config().gains.stiffness_n_per_m;
        let displacement =
            |force: f64, stiffness: f64| if stiffness > 0.0 { -force / stiffness } else { 0.0 };
        let motor = view.params.arm().forward(&est.motor).map_err(|_| Finish::Unreachable)?;
        self.stroke = StrokeRun {
            offset_m: offset(&motor, &est.pose),
            // Else the torques that pressed the plate in would be gone at once, and the drives leap through their play.
            hold_m: [displacement(fx * cos + fy * sin, k_r), displacement(fz, k_z)],
            bounds: LeadBounds::new(plate_rad, delta_rad, margin, upper),
            plane: [cos, sin],
            plate_rad,
            start_radius_m: est.pose.x_m * cos + est.pose.y_m * sin,
            start_z_m: est.pose.z_m,
            smooth_m: [est.pose.x_m * cos + est.pose.y_m * sin, est.pose.z_m],
            lead_m: settings.initial_lead_m,
            wanted_rad: plate_rad + delta_rad,
            force_rad: plate_rad + delta_rad,
            ..StrokeRun::default()
        };
        Ok(())
    }

    /// Orientation by feedback, magnitude by an open-loop lead (eqs 5.11 and 5.24 to 5.26).
    pub(super) fn do_stroke(
        &mut self,
        view: View<'_>,
        law: StrokeLaw,
        _delta_rad: f64,
    ) -> (Setpoint, Option<Finish>) {
        let (est, settings, run) = (view.est, &view.params.config().stroke, &mut self.stroke);
        let [cos, sin] = run.plane;
        let [fx, fy, fz] = est.force_xyz_n;
        let outward = fx * cos + fy * sin;
        let force = libm::hypot(outward, fz);
        let radius = est.pose.x_m * cos + est.pose.y_m * sin;
        let has_direction = force >= settings.least_force_n;
        // The soil presses back with the opposite of the plate's force: outwards and up.
        run.force_rad = if has_direction { libm::atan2(fz, outward) } else { run.wanted_rad };
        run.peak_force_n = run.peak_force_n.max(outward);
        run.travel_m = run.start_radius_m - radius;

        // After the failure a quick loop would hide a plate that lifts.
        let failed = run.travel_m >= settings.failure_travel_m;
        run.hold_m[0] *= 1.0 - TICK_S / RELEASE_S;
        // The insertion has left the plate pressed down, by more than the stroke will bear in the end; and dry friction keeps
        // up forces across the lead that the lead alone is too small to turn.
        if !failed && (!run.released || law == StrokeLaw::Force) {
            let excess = fz - outward * libm::tan(run.wanted_rad);
            let stiffness = view.params.config().gains.stiffness_n_per_m[2].max(1.0);
            let time_s = if run.released { TRIM_S } else { RELEASE_S };
            let trim = run.hold_m[1] + excess / stiffness * TICK_S / time_s;
            run.hold_m[1] = trim.clamp(-MOST_TRIM_M, MOST_TRIM_M);
            if !run.released && (excess <= settings.least_force_n || self.ticks >= RELEASE_TICKS) {
                // From here on, as if the stroke began now; the drives may have changed sides of their play.
                run.released = true;
                run.hold_m = [0.0; 2];
                run.smooth_m = [radius, est.pose.z_m];
                run.start_z_m = est.pose.z_m;
                if let Ok(motor) = view.params.arm().forward(&est.motor) {
                    run.offset_m = offset(&motor, &est.pose);
                }
            }
        }
        let short = if run.released { run.wanted_rad - run.force_rad } else { 0.0 };
        let (error, p, i) = match law {
            StrokeLaw::Force => (short, settings.force_p, settings.force_p * settings.force_i_per_s),
            StrokeLaw::Position => {
                (est.pose.z_m - run.start_z_m, settings.position_p_rad_per_m, settings.position_i_rad_per_m_s)
            }
        };
        if !failed {
            run.lead_rad = run.angle.update(run.wanted_rad, error, p, i, run.bounds);
        }

        // Too flat for its size: let the orientation catch up before pressing harder (section 5.3.3).
        let largest = view.params.safe_force().largest_n(run.force_rad - run.plate_rad);
        let unsafe_force = has_direction && short > 0.0 && largest.is_some_and(|largest| force > largest);
        if run.released && !unsafe_force {
            let haste = if has_direction { 1.0 } else { HASTE };
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
        run.smooth_m[0] += smoothing * (radius - run.smooth_m[0]);
        run.smooth_m[1] += smoothing * (est.pose.z_m - run.smooth_m[1]);
        let wanted_radius = run.smooth_m[0] - run.lead_m * cos_lead + run.hold_m[0];
        let wanted_z = run.smooth_m[1] - run.lead_m * sin_lead + run.hold_m[1];
        let place = [wanted_radius * cos, wanted_radius * sin, wanted_z];
        let position_m = std::array::from_fn(|i| place[i] + run.offset_m[i]);
        let finish = if run.travel_m >= settings.max_travel_m {
            Some(Finish::TravelLimit)
        } else if run.lead_m >= settings.max_lead_m {
            Some(Finish::LeadLimit)
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

/// Tip by the motors minus tip by the external encoders in m.
fn offset(motor: &TaskPose, external: &TaskPose) -> [f64; 3] {
    let (motor, external) = (motor.position_m(), external.position_m());
    std::array::from_fn(|i| motor[i] - external[i])
}
