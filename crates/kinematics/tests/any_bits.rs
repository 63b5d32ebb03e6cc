//! Whatever the 64 bits of a number say: no panic, no NaN as an answer, and errors that can be shown.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use proptest::prelude::*;
use soilctl_kinematics::{
    Arm, CartesianStiffness, Compliance, CylindricalStiffness, Jacobian, JointAngles, JointTorques,
    JointVelocities, KinematicsError, MotorAngles, MotorTorques, MotorVelocities, Push, TaskForce, TaskPose,
    TaskVelocity, Wrist, thesis_elbow_offset_rad,
};

/// Any bits, and now and then a number of ordinary size, so that the later checks are reached as well.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => any::<u64>().prop_map(f64::from_bits),
        4 => -4.0..4.0_f64,
        1 => prop::sample::select(vec![
            0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, 5e-324, 1000.0, 1e6,
            std::f64::consts::PI, std::f64::consts::FRAC_PI_2, -std::f64::consts::FRAC_PI_2, 0.9144, 0.3302,
        ]),
    ]
}

fn five() -> impl Strategy<Value = [f64; 5]> {
    prop_oneof![prop::array::uniform5(number()), prop::array::uniform5(-4.0..4.0_f64)]
}

fn matrix() -> impl Strategy<Value = [[f64; 5]; 5]> {
    prop::array::uniform5(five())
}

/// Finite numbers, or an error with a message.
fn sound<T>(
    answer: Result<T, KinematicsError>,
    numbers: impl Fn(&T) -> Vec<f64>,
) -> Result<(), TestCaseError> {
    match answer {
        Ok(value) => prop_assert!(numbers(&value).iter().all(|n| n.is_finite()), "{:?}", numbers(&value)),
        Err(error) => prop_assert!(error.to_string().len() > 20),
    }
    Ok(())
}

fn flat<const N: usize>(matrix: [[f64; N]; N]) -> Vec<f64> {
    matrix.into_iter().flatten().collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn kinematics(q in five(), v in five()) {
        let arm = Arm::thesis();
        let (joints, velocity) = (JointAngles(q), TaskVelocity(v));
        sound(arm.forward(&joints), |p| vec![p.x_m, p.y_m, p.z_m, p.n1_rad, p.n2_rad])?;
        sound(arm.jacobian(&joints), |j| flat(j.0))?;
        sound(arm.frames(&joints), |frames| {
            let named = frames.named();
            let parts = named.iter().map(|(_, f)| [flat(f.rotation), f.quaternion_xyzw().to_vec(), f.origin_m.to_vec()]);
            parts.flatten().flatten().collect()
        })?;
        sound(arm.gravity_torques(&joints), |t| t.0.to_vec())?;
        sound(arm.potential_energy_j(&joints), |e| vec![*e])?;
        sound(arm.inverse_velocity(&joints, &velocity), |s| [&s.joints.0[..], &s.shortfall_rad_s[..]].concat())?;
        sound(arm.tip_force(&joints, &JointTorques(v)), |f| f.to_vec())?;
        sound(arm.check_limits(&joints), |()| vec![])?;
        let pose = TaskPose { x_m: v[0], y_m: v[1], z_m: v[2], n1_rad: v[3], n2_rad: v[4] };
        if let Ok(found) = arm.inverse(&pose) {
            arm.check_limits(&found).unwrap();
            prop_assert!(arm.forward(&found).unwrap().z_m.is_finite());
        }
        sound(arm.inverse(&pose), |q| q.0.to_vec())?;
        sound(TaskPose::digging(v[0], v[1], v[2], v[3]), |p| vec![p.x_m, p.y_m, p.z_m, p.n1_rad, p.n2_rad])?;
    }

    #[test]
    fn motors(a in five()) {
        let transmission = *Arm::thesis().transmission();
        sound(transmission.motor_angles(&JointAngles(a)), |v| v.0.to_vec())?;
        sound(transmission.joint_angles(&MotorAngles(a)), |v| v.0.to_vec())?;
        sound(transmission.motor_velocities(&JointVelocities(a)), |v| v.0.to_vec())?;
        sound(transmission.joint_velocities(&MotorVelocities(a)), |v| v.0.to_vec())?;
        sound(transmission.motor_torques(&JointTorques(a)), |v| v.0.to_vec())?;
        sound(transmission.joint_torques(&MotorTorques(a)), |v| v.0.to_vec())?;
    }

    #[test]
    fn stiffness(k in matrix(), j in matrix(), dx in five(), angle in number()) {
        sound(CylindricalStiffness(k).to_cartesian(angle), |k| flat(k.0))?;
        sound(CartesianStiffness(k).to_cylindrical(angle), |k| flat(k.0))?;
        let jacobian = Jacobian(j);
        sound(jacobian.task_velocity(&JointVelocities(dx)), |v| v.0.to_vec())?;
        sound(jacobian.joint_torques(&TaskForce(dx)), |v| v.0.to_vec())?;
        for wrist in [Wrist::Driven, Wrist::Locked] {
            sound(CartesianStiffness(k).joint_torques(&jacobian, &TaskVelocity(dx), wrist), |t| t.0.to_vec())?;
        }
    }

    #[test]
    fn flexion(q in five(), p in five(), c in five(), force in prop::array::uniform3(number())) {
        let arm = Arm::thesis();
        let compliance = Compliance { rad_per_nm: [[c[0], c[1]], [c[2], c[3]]] };
        sound(arm.compensate_flexion(&JointAngles(q), force, &compliance), |q| q.0.to_vec())?;
        let push = Push { contact: JointAngles(q), pressed: JointAngles(p), plate_on_stop_n: force };
        let other = Push { contact: JointAngles(p), pressed: JointAngles(q), ..push };
        let numbers = |fit: &soilctl_kinematics::ComplianceFit| {
            [flat(fit.compliance.rad_per_nm), fit.rms_rad.to_vec()].concat()
        };
        sound(Compliance::fit(&arm, &[push, other]), numbers)?;
        sound(Compliance::fit_elbow(&arm, &[push, other]), numbers)?;
        sound(Compliance::of_elbow(c[4]), |c| flat(c.rad_per_nm))?;
        sound(thesis_elbow_offset_rad(c[0], c[1], c[2], c[3], c[4]), |offset| vec![*offset])?;
    }
}
