use crate::space::MOST_RADIANS;
use crate::{Jacobian, JointTorques, KinematicsError, TaskForce, TaskVelocity, error::check_size};

/// Stiffness of the plate against displacements along r, t, z, n1, n2, where r and t turn with the base joint.
///
/// Row: force (N, or N m for n1 and n2); column: displacement (m, or rad). Since the arm is a planar one on a turning
/// base, a stiffness that keeps its meaning all around the base is written in these coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylindricalStiffness(pub [[f64; 5]; 5]);

/// Stiffness of the plate against displacements along x, y, z, n1, n2.
///
/// Row: force (N, or N m for n1 and n2); column: displacement (m, or rad).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CartesianStiffness(pub [[f64; 5]; 5]);

/// Whether the wrist's motor takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrist {
    /// All five joints are driven.
    Driven,
    /// The wrist is switched off and held by its worm gear, as during a stroke: n1 and n2 are not controlled.
    Locked,
}

impl CylindricalStiffness {
    /// Independent springs along r, t, z (N/m) and against n1, n2 (N m/rad).
    #[must_use]
    pub const fn diagonal([r, t, z, n1, n2]: [f64; 5]) -> Self {
        Self([
            [r, 0.0, 0.0, 0.0, 0.0],
            [0.0, t, 0.0, 0.0, 0.0],
            [0.0, 0.0, z, 0.0, 0.0],
            [0.0, 0.0, 0.0, n1, 0.0],
            [0.0, 0.0, 0.0, 0.0, n2],
        ])
    }

    /// The same springs in the fixed frame when the base joint is at `base_rad`: `R^-1 K R` of eq. 3.2.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if the angle is beyond 1000 rad, an element
    /// beyond 1e12, or one is not finite.
    pub fn to_cartesian(&self, base_rad: f64) -> Result<CartesianStiffness, KinematicsError> {
        rotated(&self.0, base_rad, 1.0).map(CartesianStiffness)
    }
}

impl CartesianStiffness {
    /// The same springs in the frame that turns with the base joint, when that is at `base_rad`.
    ///
    /// # Errors
    /// As [`CylindricalStiffness::to_cartesian`].
    pub fn to_cylindrical(&self, base_rad: f64) -> Result<CylindricalStiffness, KinematicsError> {
        rotated(&self.0, base_rad, -1.0).map(CylindricalStiffness)
    }

    /// Joint torques of these springs, stretched by `displacement` (wanted minus actual; m and rad): `J^T K dx`.
    ///
    /// In eq. 3.2 the first `J^-1` stands for `J^T`. With a locked wrist only the position rows and columns are
    /// used and the wrist's torque is zero; a pseudo-inverse over all rows, as in the thesis, would mix metres
    /// and radians.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if a displacement, an element or the
    /// force is not finite or too large (1e6, 1e12 and 1e6).
    pub fn joint_torques(
        &self,
        jacobian: &Jacobian,
        displacement: &TaskVelocity,
        wrist: Wrist,
    ) -> Result<JointTorques, KinematicsError> {
        check(&self.0)?;
        let displacement = displacement.checked()?;
        let rows = if wrist == Wrist::Locked { 3 } else { 5 };
        let force = TaskForce(std::array::from_fn(|i| {
            if i < rows { (0..rows).map(|j| self.0[i][j] * displacement[j]).sum() } else { 0.0 }
        }));
        let mut torques = jacobian.joint_torques(&force)?;
        if wrist == Wrist::Locked {
            torques.0[crate::Joint::Wrist.index()] = 0.0;
        }
        Ok(torques)
    }
}

fn check(matrix: &[[f64; 5]; 5]) -> Result<(), KinematicsError> {
    let (quantity, unit, allowed) = ("stiffness", "N/m or N m/rad", "between -1e12 and 1e12");
    matrix.iter().try_for_each(|row| check_size(quantity, row, 1e12, unit, allowed))
}

/// `R^T K R` with the rotation R by `sense * angle` in the first two coordinates.
fn rotated(matrix: &[[f64; 5]; 5], angle: f64, sense: f64) -> Result<[[f64; 5]; 5], KinematicsError> {
    check(matrix)?;
    check_size("base angle", &[angle], MOST_RADIANS, "rad", "between -1000 and 1000 rad")?;
    let (sin, c) = libm::sincos(angle);
    let s = sense * sin;
    let mut result = *matrix;
    for row in &mut result {
        (row[0], row[1]) = (row[0] * c - row[1] * s, row[0] * s + row[1] * c);
    }
    let (first, second) = (result[0], result[1]);
    for j in 0..5 {
        result[0][j] = first[j] * c - second[j] * s;
        result[1][j] = first[j] * s + second[j] * c;
    }
    Ok(result)
}
