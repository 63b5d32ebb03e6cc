//! Any arm by its URDF: where plate and sensor are, given the joints.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Vector3};
use soilctl_robot::{Chain, Urdf};

use crate::error::ProcessError;

/// An arm that carries a plate and a force sensor.
#[derive(Debug)]
pub struct Robot {
    plate: Placed,
    sensor: Placed,
    names: Vec<String>,
}

/// A chain, and where each of its joints is found among the robot's.
#[derive(Debug)]
struct Placed {
    chain: Chain,
    joints: Vec<usize>,
}

/// One moment of the recorded motion, in the URDF's root frame, z up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotSample {
    /// Time in s.
    pub t_s: f64,
    /// Origin of the plate frame in m: the middle of the plate's lower edge.
    pub tip_m: [f64; 3],
    /// Direction of the plate frame's z axis: from the upper to the lower edge.
    pub down_plate: [f64; 3],
    /// Force (N) and torque (N m) of the soil on the plate in the sensor frame.
    pub wrench: [f64; 6],
    /// Turns vectors of the sensor frame into the root frame.
    pub to_root: [[f64; 3]; 3],
}

/// Forces across the plate under this one in N have no centre.
const LEAST_CENTRE_N: f64 = 0.2;

impl RobotSample {
    /// Force of the soil on the plate in the root frame in N.
    #[must_use]
    pub fn force_n(&self) -> [f64; 3] {
        self.turned([self.wrench[0], self.wrench[1], self.wrench[2]])
    }

    /// A vector of the sensor frame in the root frame.
    pub(crate) fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        self.to_root.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// How far below the sensor along the plate's z axis the force acts, in m, by least squares over the torque; `None` if
    /// the force is too small to say.
    #[must_use]
    pub fn centre_m(&self) -> Option<f64> {
        let down = Vector3::from(self.down_plate);
        let force = Vector3::from(self.force_n());
        let torque = Vector3::from(self.turned([self.wrench[3], self.wrench[4], self.wrench[5]]));
        let arm = down.cross(&force);
        (arm.norm() > LEAST_CENTRE_N).then(|| arm.dot(&torque) / arm.norm_squared()).filter(|c| c.is_finite())
    }
}

impl Robot {
    /// Reads a URDF. `plate_frame` is the link at the plate's lower edge with z down along the plate, `sensor_frame` the
    /// one that the wrench is given in.
    ///
    /// # Errors
    /// [`ProcessError::Urdf`] if the text is not a URDF of a tree of links, or if one of the two hangs on joints that cannot be
    /// followed; [`ProcessError::NoFrame`] if a frame is not in it.
    pub fn from_urdf(text: &str, plate_frame: &str, sensor_frame: &str) -> Result<Self, ProcessError> {
        let urdf = parse(text)?;
        let mut names: Vec<String> = Vec::new();
        let mut places: BTreeMap<String, usize> = BTreeMap::new();
        let mut to = |frame: &str| -> Result<Placed, ProcessError> {
            let chain = urdf.chain(frame)?;
            let place = |name: &String| {
                *places.entry(name.clone()).or_insert_with(|| {
                    names.push(name.clone());
                    names.len() - 1
                })
            };
            let joints = chain.joint_names().iter().map(place).collect();
            Ok(Placed { chain, joints })
        };
        let (plate, sensor) = (to(plate_frame)?, to(sensor_frame)?);
        Ok(Self { plate, sensor, names })
    }

    /// The link called `usual`, or else the one behind most moving joints, the first of them in the file.
    ///
    /// # Errors
    /// [`ProcessError::Urdf`] if the text is not a URDF of a tree of links.
    pub fn end_link(text: &str, usual: &str) -> Result<String, ProcessError> {
        Ok(parse(text)?.end_link(usual).to_owned())
    }

    /// Whether each of [`Robot::joint_names`] slides, in m, and does not turn, in rad.
    pub(crate) fn sliding(&self) -> Vec<bool> {
        let mut sliding = vec![false; self.names.len()];
        for placed in [&self.plate, &self.sensor] {
            for (place, slides) in placed.joints.iter().zip(placed.chain.sliding()) {
                sliding[*place] = *slides;
            }
        }
        sliding
    }

    /// How the sensor stands in the root frame if no joint turns it.
    pub(crate) fn fixed_turn(&self) -> Option<[[f64; 3]; 3]> {
        if self.sensor.chain.turns() {
            return None;
        }
        let zero = vec![0.0; self.names.len()];
        self.sample(0.0, &zero, [0.0; 6]).ok().map(|sample| sample.to_root)
    }

    /// The joints that move plate or sensor, in the order that [`Robot::sample`] takes their positions.
    #[must_use]
    pub fn joint_names(&self) -> &[String] {
        &self.names
    }

    /// Where the plate is and what acts on it.
    ///
    /// `positions` in rad (or m for a sliding joint), one for each of [`Robot::joint_names`]; `wrench` is force (N) and
    /// torque (N m) of the soil on the plate in the sensor frame.
    ///
    /// # Errors
    /// [`ProcessError::Lengths`] if there are not as many positions as joints; [`ProcessError::NotFinite`] if one is no finite
    /// number, or so large that there is no pose.
    pub fn sample(&self, t_s: f64, positions: &[f64], wrench: [f64; 6]) -> Result<RobotSample, ProcessError> {
        const COLUMN: &str = "joint positions";
        let (found, expected) = (positions.len(), self.names.len());
        if found != expected {
            return Err(ProcessError::Lengths { column: COLUMN, found, expected });
        }
        let largest = || {
            let size = |value: f64| if value.is_nan() { f64::INFINITY } else { value.abs() };
            let all = positions.iter().copied().enumerate();
            let (index, value) =
                all.max_by(|(_, a), (_, b)| size(*a).total_cmp(&size(*b))).unwrap_or_default();
            ProcessError::NotFinite { column: COLUMN, index, value }
        };
        let plate = self.plate.pose(positions).ok_or_else(largest)?;
        let sensor = self.sensor.pose(positions).ok_or_else(largest)?;
        let down = plate.rotation * Vector3::z();
        let tip = plate.translation.vector;
        let turn = sensor.rotation.to_rotation_matrix();
        Ok(RobotSample {
            t_s,
            tip_m: [tip.x, tip.y, tip.z],
            down_plate: [down.x, down.y, down.z],
            wrench,
            to_root: [0, 1, 2].map(|i| [0, 1, 2].map(|j| turn[(i, j)])),
        })
    }
}

impl Placed {
    /// Logs of real arms stray a little over their limits, so there are none here.
    fn pose(&self, positions: &[f64]) -> Option<Isometry3<f64>> {
        let own: Option<Vec<f64>> = self.joints.iter().map(|place| positions.get(*place).copied()).collect();
        self.chain.pose(&own?)
    }
}

fn parse(text: &str) -> Result<Urdf, ProcessError> {
    let urdf = Urdf::parse(text)?;
    if urdf.joints().is_empty() {
        return Err(ProcessError::Urdf("it has no joints".into()));
    }
    Ok(urdf)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HAND: &str = r#"<robot name="hand"><link name="a"/><link name="b"/><link name="c"/><link name="flange"/><link name="camera"/>
        <joint name="ab" type="revolute"><parent link="a"/><child link="b"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
        <joint name="bc" type="continuous"><parent link="b"/><child link="c"/></joint>
        <joint name="cf" type="fixed"><parent link="c"/><child link="flange"/></joint>
        <joint name="acam" type="fixed"><parent link="a"/><child link="camera"/></joint></robot>"#;

    #[test]
    fn the_end_is_behind_most_joints_unless_the_usual_link_is_there() {
        assert_eq!(Robot::end_link(HAND, "plate_tip").unwrap(), "flange");
        assert_eq!(Robot::end_link(HAND, "camera").unwrap(), "camera");
        assert!(matches!(Robot::end_link("<robot", "camera"), Err(ProcessError::Urdf(_))));
    }

    /// What other readers of URDFs fall over.
    #[test]
    fn odd_documents_end_in_poses_or_in_words() {
        let sample =
            |text: &str| Robot::from_urdf(text, "flange", "camera")?.sample(0.0, &[0.5, 0.2], [0.0; 6]);
        let usual = sample(HAND).unwrap();
        for limits in ["lower=\"nan\" upper=\"1\"", "lower=\"1\" upper=\"0\""] {
            assert_eq!(sample(&HAND.replace("lower=\"0\" upper=\"1\"", limits)).unwrap(), usual);
        }
        let follows = |other: &str| {
            HAND.replace("<child link=\"c\"/>", &format!("<child link=\"c\"/><mimic joint=\"{other}\"/>"))
        };
        let error = sample(&follows("ghost")).unwrap_err();
        assert!(matches!(&error, ProcessError::Urdf(why) if why.contains("ghost")), "{error}");
        let followed = Robot::from_urdf(&follows("ab"), "flange", "camera").unwrap();
        assert_eq!(followed.joint_names(), ["ab"]);
        let robot = Robot::from_urdf(HAND, "flange", "camera").unwrap();
        assert!(matches!(robot.sample(0.0, &[0.5], [0.0; 6]), Err(ProcessError::Lengths { .. })));
        let error = robot.sample(0.0, &[0.5, f64::NAN], [0.0; 6]).unwrap_err();
        assert!(matches!(error, ProcessError::NotFinite { index: 1, .. }), "{error}");
    }
}
