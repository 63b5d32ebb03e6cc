//! The rules that a plant file has to keep.

use crate::config::{
    AmplifiersConfig, BodiesConfig, BoxConfig, DrivesConfig, EncodersConfig, ForceSensorConfig, GroundConfig,
    PlantConfig,
};
use crate::rules::{Checked, Rules};

/// Checks everything; the first broken rule is named.
pub(crate) fn validate(config: &PlantConfig, file: &str) -> Checked {
    let rules = Rules { file };
    let one = "1, the only version there is".to_owned();
    rules.check("version", f64::from(config.version), "", config.version == 1, one)?;
    bodies(&rules, &config.bodies)?;
    sandbox(&rules, &config.sandbox)?;
    drives(&rules, &config.drives)?;
    encoders(&rules, &config.encoders)?;
    force_sensor(&rules, &config.force_sensor)?;
    amplifiers(&rules, &config.amplifiers)?;
    ground(&rules, &config.ground)
}

fn bodies(rules: &Rules<'_>, bodies: &BodiesConfig) -> Checked {
    rules.range("bodies.substeps", f64::from(bodies.substeps), "", 1.0, 1000.0)?;
    let iterations = u32::try_from(bodies.solver_iterations).map_or(f64::MAX, f64::from);
    rules.range("bodies.solver_iterations", iterations, "", 1.0, 100.0)?;
    let (damping, armature) = (&bodies.joint_damping_nms_per_rad, &bodies.joint_armature_kg_m2);
    rules.each("bodies.joint_damping_nms_per_rad", damping, "N m s/rad", 0.0, 100.0)?;
    rules.each("bodies.joint_armature_kg_m2", armature, "kg m2", 0.0, 10.0)?;
    rules.range("bodies.wall_friction", bodies.wall_friction, "", 0.0, 10.0)
}

fn sandbox(rules: &Rules<'_>, sandbox: &BoxConfig) -> Checked {
    for (key, [low, high]) in [
        ("box.x_m", sandbox.x_m),
        ("box.y_m", sandbox.y_m),
        ("box.floor_z_m, box.top_z_m", [sandbox.floor_z_m, sandbox.top_z_m]),
    ] {
        rules.each(key, &[low, high], "m", -10.0, 10.0)?;
        let allowed = "at least 0.05 m above the other end".to_owned();
        rules.check(key, high, "m", high - low >= 0.05, allowed)?;
    }
    Ok(())
}

fn drives(rules: &Rules<'_>, drives: &DrivesConfig) -> Checked {
    rules.each_positive("drives.rotor_inertia_kg_m2", &drives.rotor_inertia_kg_m2, "kg m2", 100.0)?;
    rules.each("drives.free_play_deg", &drives.free_play_deg, "deg", 0.0, 20.0)?;
    rules.each_positive("drives.stiffness_nm_per_rad", &drives.stiffness_nm_per_rad, "N m/rad", 1e5)?;
    rules.each("drives.damping_nms_per_rad", &drives.damping_nms_per_rad, "N m s/rad", 0.0, 1000.0)?;
    rules.each("drives.friction_nm", &drives.friction_nm, "N m", 0.0, 100.0)?;
    rules.each("drives.load_friction", &drives.load_friction, "", 0.0, 10.0)?;
    rules.each("drives.viscous_nms_per_rad", &drives.viscous_nms_per_rad, "N m s/rad", 0.0, 100.0)?;
    rules.range("drives.breakaway", drives.breakaway, "", 1.0, 3.0)?;
    rules.range("drives.stribeck_rad_s", drives.stribeck_rad_s, "rad/s", 1e-4, 10.0)
}

fn encoders(rules: &Rules<'_>, encoders: &EncodersConfig) -> Checked {
    for (name, counts) in [
        ("motor_counts_per_turn", encoders.motor_counts_per_turn),
        ("external_counts_per_turn", encoders.external_counts_per_turn),
    ] {
        for (i, value) in counts.into_iter().enumerate() {
            let size = value.abs();
            let allowed = "from 1 to 1e9, or negative".to_owned();
            let ok = (1.0..=1e9).contains(&size);
            rules.check(&format!("encoders.{name}[{i}]"), value, "counts", ok, allowed)?;
        }
    }
    Ok(())
}

fn force_sensor(rules: &Rules<'_>, sensor: &ForceSensorConfig) -> Checked {
    let key = |name: &str| format!("force_sensor.{name}");
    rules.positive(&key("shear_range_n"), sensor.shear_range_n, "N", 1e5)?;
    rules.positive(&key("normal_range_n"), sensor.normal_range_n, "N", 1e5)?;
    rules.positive(&key("moment_range_nm"), sensor.moment_range_nm, "N m", 1e4)?;
    rules.range(&key("bits"), f64::from(sensor.bits), "", 4.0, 32.0)?;
    rules.range(&key("noise_n"), sensor.noise_n, "N", 0.0, 100.0)?;
    rules.range(&key("noise_nm"), sensor.noise_nm, "N m", 0.0, 10.0)?;
    rules.range(&key("noise_correlation"), sensor.noise_correlation, "", 0.0, 0.999)?;
    for (i, range) in sensor.ranges().into_iter().enumerate() {
        let unit = if i < 3 { "N" } else { "N m" };
        rules.range(&format!("force_sensor.bias[{i}]"), sensor.bias[i], unit, -range, range)?;
    }
    rules.each(&key("scale"), &sensor.scale, "", 0.5, 2.0)?;
    rules.range(&key("overload_shear_n"), sensor.overload_shear_n, "N", sensor.shear_range_n, 1e6)?;
    rules.range(&key("overload_normal_n"), sensor.overload_normal_n, "N", sensor.normal_range_n, 1e6)?;
    rules.range(&key("overload_moment_nm"), sensor.overload_moment_nm, "N m", sensor.moment_range_nm, 1e6)?;
    rules.range(&key("mass_behind_kg"), sensor.mass_behind_kg, "kg", 0.0, 100.0)
}

fn amplifiers(rules: &Rules<'_>, amplifiers: &AmplifiersConfig) -> Checked {
    rules.each_positive("amplifiers.current_a_per_nm", &amplifiers.current_a_per_nm, "A/(N m)", 100.0)?;
    rules.range("amplifiers.current_noise_a", amplifiers.current_noise_a, "A", 0.0, 10.0)?;
    rules.range("amplifiers.supply_v", amplifiers.supply_v, "V", 0.0, 1000.0)?;
    rules.range("amplifiers.supply_noise_v", amplifiers.supply_noise_v, "V", 0.0, 100.0)
}

fn ground(rules: &Rules<'_>, ground: &GroundConfig) -> Checked {
    for (name, value, unit, least, most) in [
        ("bracket_fraction", ground.bracket_fraction, "", 0.0, 1.0),
        ("cell_m", ground.cell_m, "m", 0.002, 0.1),
        ("loose_mobilisation", ground.loose_mobilisation, "", 0.001, 1.0),
        ("dense_mobilisation", ground.dense_mobilisation, "", 0.001, 1.0),
        ("gradual_above_deg", ground.gradual_above_deg, "deg", 0.0, 180.0),
        ("gradual_exponent", ground.gradual_exponent, "", 1.0, 100.0),
        ("drastic_exponent", ground.drastic_exponent, "", 1.0, 100.0),
        ("residual_drop", ground.residual_drop, "", 0.0, 0.9),
        ("residual_way_m", ground.residual_way_m, "m", 1e-4, 1.0),
        ("tangent_way_m", ground.tangent_way_m, "m", 1e-5, 0.1),
        ("wedge_time_s", ground.wedge_time_s, "s", 0.0, 10.0),
        ("bearing_shape", ground.bearing_shape, "", 0.0, 10.0),
        ("insertion_drift", ground.insertion_drift, "", -10.0, 10.0),
        ("misalignment_drift", ground.misalignment_drift, "", -10.0, 10.0),
        ("damping_ns_per_m", ground.damping_ns_per_m, "N s/m", 0.0, 1000.0),
        ("heap_length", ground.heap_length, "", 0.5, 10.0),
        ("heap_past", ground.heap_past, "", 0.0, 0.9),
    ] {
        rules.range(&format!("ground.{name}"), value, unit, least, most)?;
    }
    Ok(())
}
