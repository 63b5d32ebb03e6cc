//! The same bits on every machine: only `libm` in the sources, and one number that stands for all bits.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use soilctl_kinematics::{Arm, JointAngles, TaskVelocity, urdf};

/// `f64::sin` and its like are those of the system and differ between systems.
#[test]
fn no_transcendental_function_of_the_system() {
    let forbidden = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".sin_cos()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".atan2(",
        ".hypot(",
        ".exp()",
        ".ln()",
        ".log10()",
        ".powf(",
        ".powi(",
        ".cbrt()",
        ".mul_add(",
        "f64::sin",
        "f64::cos",
        "f64::atan2",
    ];
    let mut files = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src")).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        for call in forbidden {
            assert!(!text.contains(call), "{}: {call}; use libm", path.display());
        }
        files += 1;
    }
    assert!(files > 15, "{files}");
}

/// If this fails after an update of `libm`, recorded runs no longer replay bit for bit: say so in the changelog.
#[test]
fn the_bits_stay() {
    let arm = Arm::thesis();
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    for n in 0..2000_u32 {
        let joints = JointAngles(std::array::from_fn(|i| {
            let step = f64::from(n * [7, 11, 13, 17, 19][i] % 1009) / 1009.0;
            let (lower, upper) = (arm.lower_limits().0[i], arm.upper_limits().0[i]);
            lower + step * (upper - lower)
        }));
        let pose = arm.forward(&joints).unwrap();
        hash.add(&[pose.x_m, pose.y_m, pose.z_m, pose.n1_rad, pose.n2_rad]);
        hash.add(&arm.gravity_torques(&joints).unwrap().0);
        if let Ok(jacobian) = arm.jacobian(&joints) {
            jacobian.0.iter().for_each(|row| hash.add(row));
        }
        if let Ok(found) = arm.inverse(&pose) {
            hash.add(&found.0);
        }
        if let Ok(solution) = arm.inverse_velocity(&joints, &TaskVelocity([0.01, -0.02, 0.03, 0.1, -0.2])) {
            hash.add(&solution.joints.0);
        }
    }
    urdf(&arm).bytes().for_each(|byte| hash.byte(byte));
    assert_eq!(hash.0, 0xb5f4_1d15_9adc_9442, "{:#x}", hash.0);
}

/// FNV-1a, 64 bits.
struct Hash(u64);

impl Hash {
    fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }

    fn add(&mut self, numbers: &[f64]) {
        numbers.iter().flat_map(|number| number.to_bits().to_le_bytes()).for_each(|byte| self.byte(byte));
    }
}
