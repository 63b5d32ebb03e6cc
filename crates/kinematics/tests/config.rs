//! Arm files: what is refused, and that the message names the key, the value and what is allowed.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use std::path::Path;

use soilctl_kinematics::{Arm, ArmConfig, KinematicsError};

fn text() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/arm/thesis.toml")).unwrap()
}

#[test]
fn the_built_in_arm_is_the_file() {
    let arm = Arm::from_toml(&text(), "thesis.toml").unwrap();
    assert_eq!(arm, Arm::thesis());
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/arm/thesis.toml"));
    assert_eq!(Arm::read(path).unwrap(), arm);
    let written: String = toml::to_string(arm.config()).unwrap();
    assert_eq!(Arm::from_toml(&written, "written").unwrap(), arm);
}

/// Every number of the file is a guarded one: NaN and a huge value are refused with the full name of the key.
#[test]
fn each_number_is_checked_under_its_name() {
    let value: toml::Table = toml::from_str(&text()).unwrap();
    let mut numbers = Vec::new();
    collect(&toml::Value::Table(value.clone()), &mut Vec::new(), &mut numbers);
    assert_eq!(numbers.len(), 63, "{numbers:?}");
    for path in numbers {
        let key = path.join(".");
        for bad in [f64::NAN, f64::NEG_INFINITY, 1e300, -1e300] {
            let mut changed = toml::Value::Table(value.clone());
            let slot = path.iter().fold(&mut changed, |at, part| &mut at[part.as_str()]);
            if !slot.is_float() {
                continue;
            }
            *slot = toml::Value::Float(bad);
            match Arm::from_toml(&toml::to_string(&changed).unwrap(), "arm.toml").unwrap_err() {
                KinematicsError::Config { file, key: named, value, .. } => {
                    assert_eq!((file.as_str(), named.as_str()), ("arm.toml", key.as_str()));
                    assert!(value.to_bits() == bad.to_bits() || value.is_nan(), "{key} {value}");
                }
                other => panic!("{key} = {bad}: {other}"),
            }
        }
    }
}

fn collect(value: &toml::Value, path: &mut Vec<String>, numbers: &mut Vec<Vec<String>>) {
    match value {
        toml::Value::Table(table) => {
            for (key, value) in table {
                path.push(key.clone());
                collect(value, path, numbers);
                path.pop();
            }
        }
        toml::Value::Float(_) | toml::Value::Integer(_) => numbers.push(path.clone()),
        _ => {}
    }
}

#[test]
fn bad_values_are_named_with_what_is_allowed() {
    let cases = [
        (
            "upper_arm_m = 0.4064",
            "upper_arm_m = 0.0",
            "`links.upper_arm_m` is 0 m; it must be from 0.001 to 10 m",
        ),
        (
            "lower_deg = 5.0",
            "lower_deg = -5.0",
            "`joints.elbow.lower_deg` is -5 deg; it must be above 0 and below 180",
        ),
        (
            "upper_deg = 90.0",
            "upper_deg = 91.0",
            "`joints.twist.upper_deg` is 91 deg; it must be from -90 to 90 deg",
        ),
        (
            "upper_deg = 170.0",
            "upper_deg = -40.0",
            "`joints.shoulder.upper_deg` is -40 deg; it must be above the lower",
        ),
        (
            "home_deg = 150.0",
            "home_deg = 151.0",
            "`joints.elbow.home_deg` is 151 deg; it must be from 5 to 150 deg",
        ),
        ("motor_sign = 1", "motor_sign = 2", "`joints.base.motor_sign` is 2 ; it must be 1 or -1"),
        ("differential_ratio = 2.0", "differential_ratio = 0.0", "`transmission.differential_ratio` is 0"),
        (
            "encoder_counts_per_turn = 3600",
            "encoder_counts_per_turn = 0",
            "`transmission.encoder_counts_per_turn` is 0",
        ),
        ("mass_kg = 0.169", "mass_kg = -1.0", "`masses.hand.mass_kg` is -1 kg"),
        (
            "height_m = 0.0635",
            "height_m = 0.2",
            "`plate.height_m` is 0.2 m; it must be above 0 and at most 0.127 m",
        ),
        ("damping = 0.05", "damping = 0.0", "`wrist_singularity.damping` is 0"),
        ("version = 1", "version = 2", "`version` is 2 ; it must be 1"),
        (
            "gravity_m_s2 = 9.80665",
            "gravity_m_s2 = -9.81",
            "`gravity_m_s2` is -9.81 m/s2; it must be from 0 to 30 m/s2",
        ),
        ("name = \"thesis\"", "name = \"a<b\"", "`name` is \"a<b\"; use letters"),
    ];
    for (from, to, message) in cases {
        assert!(text().contains(from), "{from}");
        let error = Arm::from_toml(&text().replacen(from, to, 1), "arm.toml").unwrap_err().to_string();
        // Numbers without a unit leave no double space behind.
        assert!(
            error.contains(&message.replace(" ;", ";")) && error.starts_with("arm.toml: "),
            "{error}\n{message}"
        );
    }
}

#[test]
fn syntax_errors_have_a_line() {
    let misspelt = text().replacen("hand_m", "hand_mm", 1);
    let error = Arm::from_toml(&misspelt, "arm.toml").unwrap_err().to_string();
    assert!(error.starts_with("arm.toml: TOML parse error at line") && error.contains("hand_mm"), "{error}");
    let missing = text().replacen("hand_m = 0.127", "", 1);
    let error = Arm::from_toml(&missing, "arm.toml").unwrap_err().to_string();
    assert!(error.contains("missing field `hand_m`"), "{error}");
    let error = Arm::read(Path::new("/nowhere/arm.toml")).unwrap_err();
    assert!(matches!(&error, KinematicsError::Io { file, .. } if file == "/nowhere/arm.toml"), "{error}");
}

#[test]
fn a_config_made_in_code_is_checked_too() {
    let mut config: ArmConfig = Arm::thesis().config().clone();
    config.links.hand_m = f64::INFINITY;
    let error = Arm::new(config).unwrap_err().to_string();
    assert!(error.starts_with("arm: `links.hand_m` is inf m"), "{error}");
}
