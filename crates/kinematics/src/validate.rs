//! The rules that an arm file has to keep.

use crate::config::{ArmConfig, Counterweight, JointConfig, Mass};
use crate::{Joint, KinematicsError};

/// Collects nothing and stops at the first broken rule, naming the key.
struct Rules<'a> {
    file: &'a str,
}

impl Rules<'_> {
    fn check(
        &self,
        key: &str,
        value: f64,
        unit: &'static str,
        allowed: &str,
        ok: bool,
    ) -> Result<(), KinematicsError> {
        if value.is_finite() && ok {
            return Ok(());
        }
        Err(KinematicsError::Config {
            file: self.file.to_owned(),
            key: key.to_owned(),
            value,
            unit,
            allowed: allowed.to_owned(),
        })
    }

    /// `least <= value <= most`, or `least < value <= most` if `open`.
    fn range(
        &self,
        key: &str,
        value: f64,
        unit: &'static str,
        least: f64,
        most: f64,
        open: bool,
    ) -> Result<(), KinematicsError> {
        let ok = if open { value > least } else { value >= least } && value <= most;
        let unit_after = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let allowed = if open {
            format!("above {least} and at most {most}{unit_after}")
        } else {
            format!("from {least} to {most}{unit_after}")
        };
        self.check(key, value, unit, &allowed, ok)
    }

    fn joint(&self, joint: Joint, config: &JointConfig) -> Result<(), KinematicsError> {
        let key = |field: &str| format!("joints.{joint}.{field}");
        let (lower, upper) = (config.lower_deg, config.upper_deg);
        match joint {
            Joint::Elbow => {
                let allowed = "above 0 and below 180 deg: the inverse takes the branch with a bent elbow";
                self.check(&key("lower_deg"), lower, "deg", allowed, lower > 0.0 && lower < 180.0)?;
                self.check(&key("upper_deg"), upper, "deg", allowed, upper > 0.0 && upper < 180.0)?;
            }
            Joint::Twist => {
                self.range(&key("lower_deg"), lower, "deg", -90.0, 90.0, false)?;
                self.range(&key("upper_deg"), upper, "deg", -90.0, 90.0, false)?;
            }
            Joint::Base | Joint::Shoulder | Joint::Wrist => {
                self.range(&key("lower_deg"), lower, "deg", -360.0, 360.0, false)?;
                self.range(&key("upper_deg"), upper, "deg", -360.0, 360.0, false)?;
            }
        }
        let allowed = format!("above the lower limit of {lower} deg, by less than a turn");
        self.check(&key("upper_deg"), upper, "deg", &allowed, upper > lower && upper - lower < 360.0)?;
        self.range(&key("home_deg"), config.home_deg, "deg", lower, upper, false)?;
        self.range(&key("max_speed_deg_s"), config.max_speed_deg_s, "deg/s", 0.0, 1e4, true)?;
        self.range(&key("max_torque_nm"), config.max_torque_nm, "N m", 0.0, 1e6, true)?;
        let sign = config.motor_sign;
        self.check(&key("motor_sign"), f64::from(sign), "", "1 or -1", sign.abs() == 1)
    }

    fn mass(&self, name: &str, mass: Mass) -> Result<(), KinematicsError> {
        self.range(&format!("masses.{name}.mass_kg"), mass.mass_kg, "kg", 0.0, 1000.0, true)?;
        self.range(&format!("masses.{name}.com_m"), mass.com_m, "m", -10.0, 10.0, false)
    }

    fn counterweight(&self, name: &str, weight: Counterweight) -> Result<(), KinematicsError> {
        self.range(&format!("counterweights.{name}.mass_kg"), weight.mass_kg, "kg", 0.0, 1000.0, false)?;
        self.range(&format!("counterweights.{name}.behind_m"), weight.behind_m, "m", 0.0, 10.0, false)
    }
}

/// Checks every number of `config`; `file` is named in the error.
pub(crate) fn validate(config: &ArmConfig, file: &str) -> Result<(), KinematicsError> {
    let rules = Rules { file };
    rules.check("version", f64::from(config.version), "", "1", config.version == 1)?;
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if config.name.is_empty() || !config.name.chars().all(plain) {
        return Err(KinematicsError::Syntax {
            file: file.to_owned(),
            problem: format!("`name` is \"{}\"; use letters, digits, _ and - only", config.name),
        });
    }
    rules.range("gravity_m_s2", config.gravity_m_s2, "m/s2", 0.0, 30.0, false)?;

    let links = &config.links;
    rules.range("links.base_height_m", links.base_height_m, "m", 0.0, 10.0, false)?;
    rules.range("links.upper_arm_m", links.upper_arm_m, "m", 0.001, 10.0, false)?;
    rules.range("links.forearm_m", links.forearm_m, "m", 0.001, 10.0, false)?;
    rules.range("links.twist_m", links.twist_m, "m", 0.0, 10.0, false)?;
    rules.range("links.hand_m", links.hand_m, "m", 0.001, 10.0, false)?;

    for (joint, entry) in Joint::ALL.into_iter().zip(config.joints.all()) {
        rules.joint(joint, &entry)?;
    }

    let transmission = &config.transmission;
    rules.range("transmission.coupling_ratio", transmission.coupling_ratio, "", -10.0, 10.0, false)?;
    rules.range(
        "transmission.differential_ratio",
        transmission.differential_ratio,
        "",
        0.01,
        100.0,
        false,
    )?;
    rules.range("transmission.gearhead_ratio", transmission.gearhead_ratio, "", 1.0, 1e4, false)?;
    let backlash = transmission.gearhead_backlash_deg;
    rules.range("transmission.gearhead_backlash_deg", backlash, "deg", 0.0, 90.0, false)?;
    let counts = transmission.encoder_counts_per_turn;
    let allowed = "at least 1";
    rules.check("transmission.encoder_counts_per_turn", f64::from(counts), "", allowed, counts > 0)?;

    let masses = &config.masses;
    rules.mass("base", masses.base)?;
    rules.mass("upper_arm", masses.upper_arm)?;
    rules.mass("forearm", masses.forearm)?;
    rules.mass("twist", masses.twist)?;
    rules.mass("hand", masses.hand)?;
    rules.counterweight("shoulder", config.counterweights.shoulder)?;
    rules.counterweight("elbow", config.counterweights.elbow)?;

    rules.range("plate.width_m", config.plate.width_m, "m", 0.0, 10.0, true)?;
    rules.range("plate.thickness_m", config.plate.thickness_m, "m", 0.0, 1.0, true)?;
    rules.range("plate.height_m", config.plate.height_m, "m", 0.0, links.hand_m, true)?;
    rules.range("sensor.before_tip_m", config.sensor.before_tip_m, "m", 0.0, links.hand_m, false)?;
    let stiffness = config.flexion.elbow_stiffness_nm_per_rad;
    rules.range("flexion.elbow_stiffness_nm_per_rad", stiffness, "N m/rad", 1e-6, 1e9, false)?;
    let wrist = &config.wrist_singularity;
    rules.range("wrist_singularity.sin_region", wrist.sin_region, "", 0.001, 0.5, false)?;
    rules.range("wrist_singularity.damping", wrist.damping, "", 0.0001, 1.0, false)
}
