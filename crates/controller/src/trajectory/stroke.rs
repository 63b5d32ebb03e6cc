use serde::{Deserialize, Serialize};

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

impl Active {
    pub(super) fn plan_stroke(&mut self, view: View<'_>, delta_rad: f64) {
        let (est, settings) = (view.est, &view.params.config().stroke);
        let (sin, cos) = libm::sincos(est.external.0[0]);
        let plate_rad = est.pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
        let (margin, upper) = (settings.lower_margin_deg.to_radians(), settings.upper_bound_deg.to_radians());
        self.stroke = StrokeRun {
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

        let short = run.wanted_rad - run.force_rad;
        let (error, p, i) = match law {
            StrokeLaw::Force => (short, settings.force_p, settings.force_p * settings.force_i_per_s),
            StrokeLaw::Position => {
                (est.pose.z_m - run.start_z_m, settings.position_p_rad_per_m, settings.position_i_rad_per_m_s)
            }
        };
        // After the failure a quick loop would hide a plate that lifts.
        let failed = run.travel_m >= settings.failure_travel_m;
        if !failed {
            run.lead_rad = run.angle.update(run.wanted_rad, error, p, i, run.bounds);
        }

        // Too flat for its size: let the orientation catch up before pressing harder (section 5.3.3).
        let largest = view.params.safe_force().largest_n(run.force_rad - run.plate_rad);
        let unsafe_force = has_direction && short > 0.0 && largest.is_some_and(|largest| force > largest);
        if !unsafe_force {
            run.lead_m = (run.lead_m + view.tuning.lead_rate_m_s * TICK_S).min(settings.max_lead_m);
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
        let wanted_radius = run.smooth_m[0] - run.lead_m * cos_lead;
        let position_m = [wanted_radius * cos, wanted_radius * sin, run.smooth_m[1] - run.lead_m * sin_lead];
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
