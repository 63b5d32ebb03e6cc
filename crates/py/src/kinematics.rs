//! The arm as a library: forward and inverse kinematics, Jacobian, stiffness, gravity.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use soilctl_kinematics::{
    CartesianStiffness, CylindricalStiffness, Jacobian, JointAngles, JointTorques, JointVelocities,
    KinematicsError, MotorAngles, TaskForce, TaskPose, TaskVelocity, Wrist, urdf,
};

use crate::array::{Array, rows_together, shaped};
use crate::copies::maker;
use crate::error::{Answer, Fail, file_at, input, no_answer};
use crate::work::each;

const JOINTS: &str = "base, shoulder, elbow, twist, wrist";
const POSE: &str = "x, y, z, n1, n2";

/// A digging arm of five joints: base, shoulder, elbow, twist, wrist.
///
/// Joint angles are in rad in arrays whose last axis has length 5. A pose is ``x, y, z`` of the middle of the plate's lower
/// edge in m, the pitch ``n1`` and the angle out of the arm's plane ``n2`` in rad. All methods take arrays of any shape
/// before the last axis.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Arm {
    pub(crate) arm: Arc<soilctl_kinematics::Arm>,
    /// The file that it was made from; None for the arm of Hong (2001).
    text: Option<String>,
}

#[pymethods]
impl Arm {
    /// The arm of Hong (2001), or the one of a TOML file.
    ///
    /// Raises:
    ///     FileError: If the file cannot be read.
    ///     InputError: If it is no arm file; the message names the key.
    #[new]
    #[pyo3(signature = (file = None))]
    fn new(file: Option<PathBuf>) -> Answer<Self> {
        let (arm, text) = match file {
            // Read once only: a copy is the arm that this one is. What cannot be read has its message from the crate.
            Some(file) => match std::fs::read_to_string(&file) {
                Ok(text) => {
                    (soilctl_kinematics::Arm::from_toml(&text, &file.display().to_string())?, Some(text))
                }
                Err(_) => (soilctl_kinematics::Arm::read(&file)?, None),
            },
            None => (soilctl_kinematics::Arm::thesis(), None),
        };
        Ok(Self { arm: Arc::new(arm), text })
    }

    /// An arm from the text of a TOML file.
    ///
    /// Raises:
    ///     InputError: If the text describes no arm; the message names the key.
    #[staticmethod]
    fn from_toml(text: &str) -> Answer<Self> {
        let arm = soilctl_kinematics::Arm::from_toml(text, "the text")?;
        Ok(Self { arm: Arc::new(arm), text: Some(text.to_owned()) })
    }

    /// Least and greatest joint angles in rad, shape (2, 5).
    #[getter]
    fn limits_rad<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        let both = [self.arm.lower_limits().0, self.arm.upper_limits().0];
        shaped(py, both.concat(), &[2, 5])
    }

    /// Poses of the plate, shape (..., 5), for joint angles of shape (..., 5). Limits are not checked.
    ///
    /// Raises:
    ///     InputError: If an angle is not finite or beyond 1000 rad.
    fn forward<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let (joints, rest) = Array::new("joint_angles_rad", joint_angles_rad)?.rows::<5>(JOINTS)?;
        rows(py, &rest, |i| self.arm.forward(&JointAngles(joints[i])).map(plain))
    }

    /// Joint angles in rad, shape (..., 5), that bring the plate to poses of shape (..., 5), in closed form.
    ///
    /// Raises:
    ///     NoAnswerError: If a pose is out of reach, singular, or needs a joint beyond its limits. The message names the
    ///         first such pose.
    ///     InputError: If a number is out of range.
    fn inverse<'py>(&self, py: Python<'py>, pose: &Bound<'py, PyAny>) -> Answer<Bound<'py, PyAny>> {
        let (poses, rest) = Array::new("pose", pose)?.rows::<5>(POSE)?;
        rows(py, &rest, |i| self.arm.inverse(&to_pose(poses[i])).map(|joints| joints.0))
    }

    /// Derivatives of the pose with respect to the joints, shape (..., 5, 5): rows x, y, z, n1, n2, columns joints.
    ///
    /// Raises:
    ///     NoAnswerError: Where the hand is at right angles to the arm's plane, and the pitch has no derivative.
    ///     InputError: If an angle is not finite or beyond 1000 rad.
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let (joints, mut rest) = Array::new("joint_angles_rad", joint_angles_rad)?.rows::<5>(JOINTS)?;
        let all = each(py, &rest, |i| self.arm.jacobian(&JointAngles(joints[i])))?;
        rest.extend([5, 5]);
        shaped(py, all.into_iter().flat_map(|j| j.0.concat()).collect(), &rest)
    }

    /// Velocities of the pose, shape (..., 5), for joint angles and velocities (rad/s), each of shape (..., 5); one for all
    /// of the other will do.
    ///
    /// Raises:
    ///     InputError, NoAnswerError: As ``jacobian``.
    fn velocity<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
        joint_velocities_rad_s: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let joints = Array::new("joint_angles_rad", joint_angles_rad)?;
        let rates = Array::new("joint_velocities_rad_s", joint_velocities_rad_s)?;
        let ([joints, rates], rest) = rows_together::<5>((&joints, JOINTS), (&rates, JOINTS))?;
        rows(py, &rest, |i| {
            let velocity =
                self.arm.jacobian(&JointAngles(joints[i]))?.task_velocity(&JointVelocities(rates[i]))?;
            Ok::<_, KinematicsError>(velocity.0)
        })
    }

    /// Joint torques in N m, shape (..., 5), that press with a force at the tip (N, and N m for n1 and n2); one posture or one
    /// force for all of the other will do.
    ///
    /// Raises:
    ///     InputError, NoAnswerError: As ``jacobian``.
    fn joint_torques<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
        force: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let joints = Array::new("joint_angles_rad", joint_angles_rad)?;
        let forces = Array::new("force", force)?;
        let ([joints, forces], rest) = rows_together::<5>((&joints, JOINTS), (&forces, POSE))?;
        rows(py, &rest, |i| {
            let torques = self.arm.jacobian(&JointAngles(joints[i]))?.joint_torques(&TaskForce(forces[i]))?;
            Ok::<_, KinematicsError>(torques.0)
        })
    }

    /// Joint torques in N m of springs at the plate, shape (5,): ``J^T K dx`` at one posture.
    ///
    /// Args:
    ///     joint_angles_rad: The posture, shape (5,).
    ///     displacement: Wanted minus actual pose, shape (5,), m and rad.
    ///     stiffness: Along r, t, z (N/m) and against n1, n2 (N m/rad), where r and t turn with the base: shape (5,), or
    ///         (5, 5) for coupled ones.
    ///     wrist_locked: The wrist is switched off and held by its worm gear; n1 and n2 do not count.
    ///
    /// Raises:
    ///     InputError, NoAnswerError: As ``jacobian``.
    #[pyo3(signature = (joint_angles_rad, displacement, *, stiffness, wrist_locked = false))]
    fn stiffness_torques<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
        displacement: &Bound<'py, PyAny>,
        stiffness: &Bound<'py, PyAny>,
        wrist_locked: bool,
    ) -> Answer<Bound<'py, PyAny>> {
        let joints = JointAngles(Array::new("joint_angles_rad", joint_angles_rad)?.row::<5>(JOINTS)?);
        let displacement = TaskVelocity(Array::new("displacement", displacement)?.row::<5>(POSE)?);
        let stiffness = cartesian(&Array::new("stiffness", stiffness)?, joints.0[0])?;
        let jacobian: Jacobian = self.arm.jacobian(&joints)?;
        let wrist = if wrist_locked { Wrist::Locked } else { Wrist::Driven };
        let torques: JointTorques = stiffness.joint_torques(&jacobian, &displacement, wrist)?;
        shaped(py, torques.0.to_vec(), &[5])
    }

    /// Joint torques in N m that hold the arm against gravity, shape (..., 5).
    ///
    /// Raises:
    ///     InputError: If an angle is not finite or beyond 1000 rad.
    fn gravity_torques<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let (joints, rest) = Array::new("joint_angles_rad", joint_angles_rad)?.rows::<5>(JOINTS)?;
        rows(py, &rest, |i| self.arm.gravity_torques(&JointAngles(joints[i])).map(|torques| torques.0))
    }

    /// Motor angles in rad for joint angles, shape (..., 5); elbow and twist share a differential.
    ///
    /// Raises:
    ///     InputError: If an angle is not finite or beyond 1000 rad.
    fn motor_angles<'py>(
        &self,
        py: Python<'py>,
        joint_angles_rad: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let (joints, rest) = Array::new("joint_angles_rad", joint_angles_rad)?.rows::<5>(JOINTS)?;
        rows(py, &rest, |i| self.arm.transmission().motor_angles(&JointAngles(joints[i])).map(|m| m.0))
    }

    /// Joint angles in rad for motor angles, shape (..., 5): the inverse of ``motor_angles``.
    ///
    /// Raises:
    ///     InputError: If an angle is not finite or beyond 1000 rad.
    fn joint_angles<'py>(
        &self,
        py: Python<'py>,
        motor_angles_rad: &Bound<'py, PyAny>,
    ) -> Answer<Bound<'py, PyAny>> {
        let (motors, rest) = Array::new("motor_angles_rad", motor_angles_rad)?.rows::<5>("one a motor")?;
        rows(py, &rest, |i| self.arm.transmission().joint_angles(&MotorAngles(motors[i])).map(|j| j.0))
    }

    /// Pose, shape (5,), of a plate with a level lower edge, ready for a stroke towards the base.
    ///
    /// Args:
    ///     radius_m: From the base's axis to the middle of the lower edge.
    ///     height_m: Of the lower edge, in the base frame.
    ///     tool_angle_deg: Plate from the horizontal; below 90 the lower edge is nearer to the base.
    ///     base_angle_deg: Where the arm points.
    ///
    /// Raises:
    ///     InputError: If a number is not finite or out of range.
    #[staticmethod]
    #[pyo3(signature = (*, radius_m, height_m, tool_angle_deg, base_angle_deg = 0.0))]
    fn digging_pose(
        py: Python<'_>,
        radius_m: f64,
        height_m: f64,
        tool_angle_deg: f64,
        base_angle_deg: f64,
    ) -> Answer<Bound<'_, PyAny>> {
        let (base_rad, tool_rad) = (base_angle_deg.to_radians(), tool_angle_deg.to_radians());
        shaped(py, plain(TaskPose::digging(radius_m, base_rad, height_m, tool_rad)?).to_vec(), &[5])
    }

    /// Refuses joint angles, shape (..., 5), outside the limits.
    ///
    /// Raises:
    ///     NoAnswerError: Names the first element and the joint that is outside.
    fn check_limits(&self, py: Python<'_>, joint_angles_rad: &Bound<'_, PyAny>) -> Answer<()> {
        let (joints, rest) = Array::new("joint_angles_rad", joint_angles_rad)?.rows::<5>(JOINTS)?;
        each(py, &rest, |i| self.arm.check_limits(&JointAngles(joints[i]))).map(|_| ())
    }

    /// The arm as URDF.
    fn urdf(&self) -> String {
        urdf(&self.arm)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Option<String>,))> {
        Ok((maker(slf.py(), "_restore_arm")?, (slf.get().text.clone(),)))
    }

    fn __repr__(&self) -> String {
        let links = &self.arm.config().links;
        format!(
            "Arm(upper_arm_m={}, forearm_m={}, hand_m={})",
            links.upper_arm_m, links.forearm_m, links.hand_m
        )
    }
}

/// An arm as `__reduce__` has taken it apart: from the text of a file.
#[pyfunction]
#[pyo3(name = "_restore_arm")]
pub(crate) fn restore_arm(text: Option<&str>) -> Answer<Arm> {
    match text {
        Some(text) => Arm::from_toml(text),
        None => Arm::new(None),
    }
}

fn plain(pose: TaskPose) -> [f64; 5] {
    [pose.x_m, pose.y_m, pose.z_m, pose.n1_rad, pose.n2_rad]
}

fn to_pose([x_m, y_m, z_m, n1_rad, n2_rad]: [f64; 5]) -> TaskPose {
    TaskPose { x_m, y_m, z_m, n1_rad, n2_rad }
}

/// Springs in the fixed frame.
fn cartesian(stiffness: &Array<'_>, base_rad: f64) -> Answer<CartesianStiffness> {
    let springs = if stiffness.shape().len() == 2 {
        let (rows, rest) = stiffness.rows::<5>(POSE)?;
        match <[[f64; 5]; 5]>::try_from(rows) {
            Ok(matrix) => CylindricalStiffness(matrix),
            Err(_) => return Err(input(format!("stiffness has {rest:?} rows; it must have 5"))),
        }
    } else {
        CylindricalStiffness::diagonal(stiffness.row::<5>("r, t, z, n1, n2")?)
    };
    Ok(springs.to_cartesian(base_rad)?)
}

fn rows<'py>(
    py: Python<'py>,
    rest: &[usize],
    answer: impl Fn(usize) -> Result<[f64; 5], KinematicsError> + Sync,
) -> Answer<Bound<'py, PyAny>> {
    let all = each(py, rest, answer)?;
    let shape: Vec<usize> = rest.iter().copied().chain([5]).collect();
    shaped(py, all.concat(), &shape)
}

impl From<KinematicsError> for Fail {
    fn from(problem: KinematicsError) -> Self {
        match problem {
            KinematicsError::Unreachable { .. }
            | KinematicsError::Singular { .. }
            | KinematicsError::OutOfLimits { .. } => no_answer(problem),
            KinematicsError::Io { file: ref path, .. } => file_at(&problem, path),
            _ => input(problem),
        }
    }
}
