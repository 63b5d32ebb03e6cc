//! The rules that a settings file has to keep.

use soilctl_kinematics::{Arm, Joint, JointAngles};

use crate::ControllerError;
use crate::config::{ControllerConfig, Hand, Insert, Safety, Site, Stroke, Sweep, Touch};

/// Stops at the first broken rule, naming the key.
pub(crate) struct Rules<'a> {
    pub(crate) file: &'a str,
}

type Checked = Result<(), ControllerError>;

impl Rules<'_> {
    pub(crate) fn check(
        &self,
        key: &str,
        value: f64,
        unit: &'static str,
        ok: bool,
        allowed: &str,
    ) -> Checked {
        if value.is_finite() && ok {
            return Ok(());
        }
        Err(ControllerError::Config {
            file: self.file.to_owned(),
            key: key.to_owned(),
            value,
            unit,
            allowed: allowed.to_owned(),
        })
    }

    /// `least <= value <= most`.
    pub(crate) fn range(&self, key: &str, value: f64, unit: &'static str, least: f64, most: f64) -> Checked {
        let allowed = format!("from {least} to {most} {unit}");
        self.check(key, value, unit, value >= least && value <= most, allowed.trim_end())
    }

    /// `0 < value <= most`.
    pub(crate) fn positive(&self, key: &str, value: f64, unit: &'static str, most: f64) -> Checked {
        let allowed = format!("above 0 and at most {most} {unit}");
        self.check(key, value, unit, value > 0.0 && value <= most, allowed.trim_end())
    }

    fn five(&self, key: &str, values: &[f64], unit: &'static str, least: f64, most: f64) -> Checked {
        values
            .iter()
            .enumerate()
            .try_for_each(|(i, &value)| self.range(&format!("{key}[{i}]"), value, unit, least, most))
    }

    fn five_positive(&self, key: &str, values: &[f64; 5], unit: &'static str, most: f64) -> Checked {
        values
            .iter()
            .enumerate()
            .try_for_each(|(i, &value)| self.positive(&format!("{key}[{i}]"), value, unit, most))
    }

    fn interval(
        &self,
        key: &str,
        [low, high]: [f64; 2],
        unit: &'static str,
        least: f64,
        most: f64,
    ) -> Checked {
        self.range(&format!("{key}[0]"), low, unit, least, most)?;
        self.range(&format!("{key}[1]"), high, unit, least, most)?;
        self.check(&format!("{key}[1]"), high, unit, high > low, "above the first of the two")
    }

    fn ticks(&self, key: &str, value: u32, least: u32, most: u32) -> Checked {
        self.range(key, f64::from(value), "ticks", f64::from(least), f64::from(most))
    }

    fn touch(&self, touch: &Touch, safety: &Safety) -> Checked {
        self.five_positive("touch.joint_speed_deg_s", &touch.joint_speed_deg_s, "deg/s", 90.0)?;
        for (i, &error) in touch.joint_error_deg.iter().enumerate() {
            let allowed = "above 0 and below safety.tracking_error_deg, which would stop the arm first";
            let key = format!("touch.joint_error_deg[{i}]");
            self.check(&key, error, "deg", error > 0.0 && error < safety.tracking_error_deg[i], allowed)?;
        }
        self.positive("touch.tip_speed_m_s", touch.tip_speed_m_s, "m/s", 0.2)?;
        let allowed = "above 0 and below safety.tip_force_n, which would stop the arm first";
        let force = touch.tip_force_n;
        self.check("touch.tip_force_n", force, "N", force > 0.0 && force < safety.tip_force_n, allowed)?;
        self.ticks("touch.confirm_ticks", touch.confirm_ticks, 1, 1000)?;
        self.positive("touch.soil_travel_m", touch.soil_travel_m, "m", 1.0)?;
        self.positive("touch.wall_travel_m", touch.wall_travel_m, "m", 1.0)
    }

    fn insert(&self, insert: &Insert) -> Checked {
        self.positive("insert.speed_m_s", insert.speed_m_s, "m/s", 0.1)?;
        self.range("insert.gain_m_s_per_n", insert.gain_m_s_per_n, "m/s per N", 0.0, 1.0)?;
        self.range("insert.dead_zone_n", insert.dead_zone_n, "N", 0.0, 100.0)?;
        self.positive("insert.max_lateral_speed_m_s", insert.max_lateral_speed_m_s, "m/s", 0.1)?;
        self.range("insert.max_lateral_offset_m", insert.max_lateral_offset_m, "m", 0.0, 0.2)?;
        self.ticks("insert.settle_ticks", insert.settle_ticks, 0, 100_000)?;
        self.positive("insert.depth_tolerance_m", insert.depth_tolerance_m, "m", 0.1)
    }

    fn stroke(&self, stroke: &Stroke) -> Checked {
        self.range("stroke.initial_lead_m", stroke.initial_lead_m, "m", 0.0, 0.1)?;
        self.positive("stroke.lead_rate_m_s", stroke.lead_rate_m_s, "m/s", 0.1)?;
        let lead = stroke.max_lead_m;
        let allowed = "above stroke.initial_lead_m and at most 0.2 m";
        self.check("stroke.max_lead_m", lead, "m", lead > stroke.initial_lead_m && lead <= 0.2, allowed)?;
        self.positive("stroke.max_travel_m", stroke.max_travel_m, "m", 0.5)?;
        self.ticks("stroke.max_ticks", stroke.max_ticks, 1, 1_000_000)?;
        self.range("stroke.force_p", stroke.force_p, "", 0.0, 100.0)?;
        self.range("stroke.force_i_per_s", stroke.force_i_per_s, "1/s", 0.0, 100.0)?;
        self.range("stroke.position_p_rad_per_m", stroke.position_p_rad_per_m, "rad/m", 0.0, 1e5)?;
        self.range("stroke.position_i_rad_per_m_s", stroke.position_i_rad_per_m_s, "rad/(m s)", 0.0, 1e5)?;
        self.range("stroke.position_filter_hz", stroke.position_filter_hz, "Hz", 0.1, 240.0)?;
        self.positive("stroke.least_force_n", stroke.least_force_n, "N", 100.0)?;
        self.range("stroke.upper_bound_deg", stroke.upper_bound_deg, "deg", 0.0, 90.0)?;
        self.range("stroke.lower_margin_deg", stroke.lower_margin_deg, "deg", 0.0, 90.0)?;
        self.positive("stroke.failure_travel_m", stroke.failure_travel_m, "m", 0.5)?;
        self.positive("stroke.lift_deg", stroke.lift_deg, "deg", 90.0)?;
        self.positive("stroke.lift_rise_m", stroke.lift_rise_m, "m", 0.1)?;
        self.safe_force(stroke)
    }

    fn safe_force(&self, stroke: &Stroke) -> Checked {
        let (angles, forces) = (&stroke.safe_force.angle_deg, &stroke.safe_force.force_n);
        #[allow(clippy::cast_precision_loss, reason = "a list of more than 2^53 numbers does not exist")]
        let length = angles.len() as f64;
        let ok = angles.len() == forces.len() && angles.len() != 1 && angles.len() <= 32;
        let allowed = "0 or 2 to 32 numbers, as many as in stroke.safe_force.force_n";
        self.check("stroke.safe_force.angle_deg", length, "numbers", ok, allowed)?;
        self.five("stroke.safe_force.angle_deg", angles, "deg", -90.0, 90.0)?;
        self.five("stroke.safe_force.force_n", forces, "N", 1e-3, 1e6)?;
        for (i, pair) in angles.windows(2).enumerate() {
            let key = format!("stroke.safe_force.angle_deg[{}]", i + 1);
            self.check(&key, pair[1], "deg", pair[1] > pair[0], "above the one before")?;
        }
        Ok(())
    }

    fn site(&self, site: &Site, arm: &Arm) -> Checked {
        self.range("site.surface_z_m", site.surface_z_m, "m", -10.0, 10.0)?;
        self.positive("site.clearance_m", site.clearance_m, "m", 1.0)?;
        let allowed = "at least site.clearance_m and at most 1 m";
        let transit = site.transit_m;
        self.check("site.transit_m", transit, "m", transit >= site.clearance_m && transit <= 1.0, allowed)?;
        let (lower, upper) = (arm.lower_limits().degrees(), arm.upper_limits().degrees());
        for joint in Joint::ALL {
            let i = joint.index();
            self.range(&format!("site.park_deg[{i}]"), site.park_deg[i], "deg", lower[i], upper[i])?;
        }
        let park = JointAngles::from_degrees(site.park_deg);
        let allowed = "inside the arm's limits";
        self.check("site.park_deg", site.park_deg[0], "deg", arm.check_limits(&park).is_ok(), allowed)
    }

    fn sweep(&self, sweep: &Sweep) -> Checked {
        self.range("sweep.first_delta_deg", sweep.first_delta_deg, "deg", 0.0, 60.0)?;
        self.range("sweep.last_delta_deg", sweep.last_delta_deg, "deg", sweep.first_delta_deg, 60.0)?;
        self.positive("sweep.step_deg", sweep.step_deg, "deg", 60.0)?;
        self.positive("sweep.radius_m", sweep.radius_m, "m", 10.0)?;
        #[allow(clippy::cast_precision_loss, reason = "a list of more than 2^53 numbers does not exist")]
        self.range("sweep.base_deg", sweep.base_deg.len() as f64, "angles", 1.0, 16.0)?;
        self.five("sweep.base_deg", &sweep.base_deg, "deg", -180.0, 180.0)?;
        self.range("sweep.tool_angle_deg", sweep.tool_angle_deg, "deg", 80.0, 90.0)?;
        self.positive("sweep.depth_m", sweep.depth_m, "m", 1.0)
    }

    fn hand(&self, hand: &Hand, safety: &Safety) -> Checked {
        self.positive("hand.speed_m_s", hand.speed_m_s, "m/s", 0.5)?;
        self.positive("hand.acceleration_m_s2", hand.acceleration_m_s2, "m/s2", 20.0)?;
        self.positive("hand.pitch_speed_deg_s", hand.pitch_speed_deg_s, "deg/s", 90.0)?;
        self.positive("hand.pitch_acceleration_deg_s2", hand.pitch_acceleration_deg_s2, "deg/s2", 3600.0)?;
        let allowed = "above 0 and below safety.tip_force_n, which would stop the arm first";
        let force = hand.force_n;
        self.check("hand.force_n", force, "N", force > 0.0 && force < safety.tip_force_n, allowed)?;
        let share = hand.torque_share;
        self.check("hand.torque_share", share, "", share > 0.0 && share < 1.0, "above 0 and below 1")?;
        self.range("hand.margin_m", hand.margin_m, "m", 0.0, 0.1)?;
        for (key, [low, high]) in [("safety.radius_m", safety.radius_m), ("safety.height_m", safety.height_m)]
        {
            let allowed = "less than half of what safety allows, so that something is left";
            let ok = 2.0 * hand.margin_m < high - low;
            self.check(&format!("hand.margin_m with {key}"), hand.margin_m, "m", ok, allowed)?;
        }
        self.ticks("hand.lease_ticks", hand.lease_ticks, 1, 5000)
    }

    fn safety(&self, safety: &Safety, max_lead_m: f64) -> Checked {
        self.range("safety.joint_margin_deg", safety.joint_margin_deg, "deg", 0.0, 10.0)?;
        self.positive("safety.joint_speed_factor", safety.joint_speed_factor, "", 10.0)?;
        self.five_positive("safety.tracking_error_deg", &safety.tracking_error_deg, "deg", 90.0)?;
        let error = safety.stiffness_error_m;
        let allowed = "above stroke.max_lead_m and at most 1 m";
        self.check("safety.stiffness_error_m", error, "m", error > max_lead_m && error <= 1.0, allowed)?;
        self.positive("safety.setpoint_step_deg", safety.setpoint_step_deg, "deg", 10.0)?;
        self.five_positive("safety.disagreement_deg", &safety.disagreement_deg, "deg", 90.0)?;
        self.positive("safety.tip_force_n", safety.tip_force_n, "N", 1e4)?;
        self.ticks("safety.saturated_ticks", safety.saturated_ticks, 1, 1_000_000)?;
        self.interval("safety.radius_m", safety.radius_m, "m", 0.001, 10.0)?;
        self.interval("safety.height_m", safety.height_m, "m", -10.0, 10.0)?;
        self.interval("safety.base_deg", safety.base_deg, "deg", -180.0, 180.0)?;
        for (key, ticks) in [
            ("safety.motor_encoder_stale_ticks", safety.motor_encoder_stale_ticks),
            ("safety.external_encoder_stale_ticks", safety.external_encoder_stale_ticks),
            ("safety.force_stale_ticks", safety.force_stale_ticks),
            ("safety.amplifier_stale_ticks", safety.amplifier_stale_ticks),
            ("safety.heartbeat_ticks", safety.heartbeat_ticks),
            ("safety.amplifier_ticks", safety.amplifier_ticks),
        ] {
            self.ticks(key, ticks, 1, 1_000_000)?;
        }
        self.ticks("safety.force_frozen_ticks", safety.force_frozen_ticks, 0, 1_000_000)?;
        self.ticks("safety.dropped_ticks", safety.dropped_ticks, 0, 1000)?;
        self.five_positive("safety.max_current_a", &safety.max_current_a, "A", 1e3)?;
        self.positive("safety.current_error_a", safety.current_error_a, "A", 1e3)?;
        self.interval("safety.supply_voltage_v", safety.supply_voltage_v, "V", 0.0, 1e3)
    }
}

/// Checks every number of `config` for `arm`; `file` is named in the error.
pub(crate) fn validate(config: &ControllerConfig, arm: &Arm, file: &str) -> Checked {
    let rules = Rules { file };
    rules.check("version", f64::from(config.version), "", config.version == 1, "1")?;

    let encoders = &config.encoders;
    for (key, counts) in [
        ("encoders.motor_counts_per_turn", encoders.motor_counts_per_turn),
        ("encoders.external_counts_per_turn", encoders.external_counts_per_turn),
    ] {
        rules.five_positive(key, &counts.map(f64::abs), "counts", 1e9)?;
    }
    for (key, corner) in [
        ("encoders.motor_filter_hz", encoders.motor_filter_hz),
        ("encoders.external_filter_hz", encoders.external_filter_hz),
        ("encoders.velocity_filter_hz", encoders.velocity_filter_hz),
        ("force_sensor.filter_hz", config.force_sensor.filter_hz),
    ] {
        rules.range(key, corner, "Hz", 0.1, 240.0)?;
    }
    rules.ticks("force_sensor.bias_ticks", config.force_sensor.bias_ticks, 1, 5000)?;
    rules.positive("force_sensor.shear_range_n", config.force_sensor.shear_range_n, "N", 1e6)?;
    rules.positive("force_sensor.normal_range_n", config.force_sensor.normal_range_n, "N", 1e6)?;
    rules.positive("force_sensor.moment_range_nm", config.force_sensor.moment_range_nm, "N m", 1e6)?;

    let gains = &config.gains;
    for (key, unit, values) in [
        ("gains.motor_p_nm_per_rad", "N m/rad", gains.motor_p_nm_per_rad),
        ("gains.motor_d_nms_per_rad", "N m s/rad", gains.motor_d_nms_per_rad),
        ("gains.external_p_nm_per_rad", "N m/rad", gains.external_p_nm_per_rad),
        ("gains.external_i_nm_per_rad_s", "N m/(rad s)", gains.external_i_nm_per_rad_s),
        ("gains.integral_limit_nm", "N m", gains.integral_limit_nm),
        ("gains.velocity_p_nms_per_rad", "N m s/rad", gains.velocity_p_nms_per_rad),
        ("gains.velocity_i_nm_per_rad", "N m/rad", gains.velocity_i_nm_per_rad),
    ] {
        rules.five(key, &values, unit, 0.0, 1e5)?;
    }
    rules.five("gains.stiffness_n_per_m", &gains.stiffness_n_per_m, "N/m", 0.0, 1e5)?;

    rules.five_positive("motors.current_a_per_nm", &config.motors.current_a_per_nm, "A/(N m)", 100.0)?;
    rules.five_positive("motors.max_torque_nm", &config.motors.max_torque_nm, "N m", 1e4)?;
    rules.five_positive("motors.max_torque_rate_nm_s", &config.motors.max_torque_rate_nm_s, "N m/s", 1e6)?;
    for i in 0..5 {
        let (key, most) = (format!("safety.max_current_a[{i}]"), config.safety.max_current_a[i]);
        let needed = config.motors.max_torque_nm[i] * config.motors.current_a_per_nm[i];
        let allowed = format!("at least the {needed} A of motors.max_torque_nm, or lower that torque");
        rules.check(&key, most, "A", most >= needed, &allowed)?;
    }
    rules.positive("moves.joint_speed_deg_s", config.moves.joint_speed_deg_s, "deg/s", 360.0)?;
    rules.positive("moves.tip_speed_m_s", config.moves.tip_speed_m_s, "m/s", 1.0)?;
    rules.positive("moves.pitch_speed_deg_s", config.moves.pitch_speed_deg_s, "deg/s", 360.0)?;
    rules.touch(&config.touch, &config.safety)?;
    rules.insert(&config.insert)?;
    rules.stroke(&config.stroke)?;
    rules.site(&config.site, arm)?;
    rules.sweep(&config.sweep)?;
    rules.safety(&config.safety, config.stroke.max_lead_m)?;
    rules.hand(&config.hand, &config.safety)
}
