//! Settings and plans: the files that ship are valid, and a wrong number is named.
#![allow(clippy::unwrap_used)]

use soilctl_controller::{ControllerConfig, ControllerError, DEFAULT, Params, StrokePlan};
use soilctl_kinematics::Arm;

fn with(change: impl Fn(&mut ControllerConfig)) -> Result<Params, ControllerError> {
    let mut config: ControllerConfig = toml::from_str(DEFAULT).unwrap();
    change(&mut config);
    Params::new(Arm::thesis(), config, StrokePlan::default())
}

fn key(change: impl Fn(&mut ControllerConfig)) -> String {
    match with(change) {
        Err(ControllerError::Config { key, .. }) => key,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_ships_is_valid() {
    let params = Params::thesis();
    assert!((params.config().safety.joint_margin_deg - 2.0).abs() < 1e-12);
    for (text, strokes, batches) in [
        (include_str!("../../../data/plans/table_6_2.toml"), 48, 8),
        (include_str!("../../../data/plans/table_6_3.toml"), 48, 12),
    ] {
        let plan = StrokePlan::from_toml(text, "plan").unwrap();
        assert_eq!(plan.strokes().len(), strokes);
        assert_eq!(plan.strokes().last().unwrap().batch + 1, batches);
        // All within reach.
        Params::from_toml(Arm::thesis(), DEFAULT, "default", plan).unwrap();
    }
}

#[test]
fn wrong_numbers_are_named() {
    assert_eq!(key(|c| c.version = 2), "version");
    assert_eq!(key(|c| c.encoders.motor_counts_per_turn[3] = 0.0), "encoders.motor_counts_per_turn[3]");
    assert_eq!(key(|c| c.gains.motor_p_nm_per_rad[2] = f64::NAN), "gains.motor_p_nm_per_rad[2]");
    assert_eq!(key(|c| c.touch.joint_error_deg[0] = 7.0), "touch.joint_error_deg[0]");
    assert_eq!(key(|c| c.stroke.max_lead_m = 0.0001), "stroke.max_lead_m");
    assert_eq!(key(|c| c.safety.stiffness_error_m = 0.001), "safety.stiffness_error_m");
    assert_eq!(key(|c| c.safety.max_current_a[0] = 1.0), "safety.max_current_a[0]");
    assert_eq!(key(|c| c.safety.height_m = [1.0, 0.5]), "safety.height_m[1]");
    assert_eq!(key(|c| c.hand.force_n = 40.0), "hand.force_n");
    assert_eq!(key(|c| c.hand.torque_share = 1.0), "hand.torque_share");
    assert_eq!(key(|c| c.hand.lease_ticks = 0), "hand.lease_ticks");
    assert_eq!(key(|c| c.safety.radius_m = [0.12, 0.13]), "hand.margin_m with safety.radius_m");
    assert_eq!(key(|c| c.site.park_deg[2] = 1.0), "site.park_deg[2]");
    assert_eq!(key(|c| c.sweep.tool_angle_deg = 70.0), "sweep.tool_angle_deg");
    assert_eq!(key(|c| c.stroke.safe_force.angle_deg = vec![1.0, 2.0]), "stroke.safe_force.angle_deg");
}

#[test]
fn messages_say_what_to_do() {
    let error = with(|c| c.insert.gain_m_s_per_n = -1.0).unwrap_err().to_string();
    assert_eq!(
        error,
        "controller settings: `insert.gain_m_s_per_n` is -1 m/s per N; it must be from 0 to 1 m/s per N"
    );
    let error = Params::from_toml(Arm::thesis(), "version = ", "my.toml", StrokePlan::default()).unwrap_err();
    assert!(error.to_string().starts_with("my.toml: "), "{error}");
    let far = "version = 1\n[[batches]]\nstrokes = [{ radius_m = 0.4318, base_deg = 0.0, alpha_deg = 80.0, \
               depth_m = 0.9, delta_set_deg = 23.0 }]";
    let plan = StrokePlan::from_toml(far, "far.toml").unwrap();
    let error = Params::from_toml(Arm::thesis(), DEFAULT, "default", plan).unwrap_err().to_string();
    assert!(error.starts_with("far.toml: stroke 1 cannot be reached at full depth: "), "{error}");
    let error = Params::read(Arm::thesis(), std::path::Path::new("/no/such/file"), StrokePlan::default());
    assert!(matches!(error, Err(ControllerError::Io { .. })));
}
