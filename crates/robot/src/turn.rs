//! Rotations. Sines and cosines are those of `libm`, so that a pose has the same bits on every machine.

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3};

/// Turned by roll about x, then pitch about y, then yaw about z, all of them fixed axes: `R = Rz(yaw) Ry(pitch) Rx(roll)`.
pub(crate) fn from_rpy([roll, pitch, yaw]: [f64; 3]) -> UnitQuaternion<f64> {
    let about = |axis: Unit<Vector3<f64>>, angle| about_axis(&axis, angle);
    about(Vector3::z_axis(), yaw) * about(Vector3::y_axis(), pitch) * about(Vector3::x_axis(), roll)
}

/// Turned by `angle` in rad about `axis`.
pub(crate) fn about_axis(axis: &Unit<Vector3<f64>>, angle: f64) -> UnitQuaternion<f64> {
    let (sin, cos) = libm::sincos(0.5 * angle);
    // Its length is 1 to rounding, as that of the axis.
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, axis.scale(sin)))
}

/// The direction of a vector; `None` if it has none. Its parts may be so small or large that their squares are not numbers.
pub(crate) fn direction(vector: [f64; 3]) -> Option<Unit<Vector3<f64>>> {
    let vector = Vector3::from(vector);
    let most = vector.amax();
    if !(vector.iter().all(|part| part.is_finite()) && most > 0.0) {
        return None;
    }
    Some(Unit::new_normalize(vector / most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_turn_about_fixed_axes_one_after_another() {
        let (roll, pitch, yaw) = (0.3_f64, -0.7_f64, 1.1_f64);
        let (sr, cr, sp, cp, sy, cy) =
            (roll.sin(), roll.cos(), pitch.sin(), pitch.cos(), yaw.sin(), yaw.cos());
        // Rz(yaw) Ry(pitch) Rx(roll), multiplied out.
        let expected = [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ];
        let found = from_rpy([roll, pitch, yaw]).to_rotation_matrix();
        for (row, expected) in expected.iter().enumerate() {
            for (column, expected) in expected.iter().enumerate() {
                assert!((found[(row, column)] - expected).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn directions_of_the_smallest_and_largest_vectors_are_found() {
        for size in [5e-324, 1e-300, 1.0, 1e300, f64::MAX] {
            let found = direction([0.0, -size, 0.0]).unwrap();
            assert_eq!(found.into_inner(), Vector3::new(0.0, -1.0, 0.0));
        }
        for none in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 0.0]] {
            assert!(direction(none).is_none());
        }
    }
}
