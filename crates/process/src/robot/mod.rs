//! Any arm by its URDF: where plate and sensor are, given the joints.

use std::sync::Arc;

use k::nalgebra::{Isometry3, Vector3};

use crate::error::ProcessError;

/// An arm that carries a plate and a force sensor.
#[derive(Debug)]
pub struct Robot {
    plate: k::SerialChain<f64>,
    sensor: k::SerialChain<f64>,
    names: Vec<String>,
    /// Where each joint of the two chains is found among `names`.
    plate_joints: Vec<usize>,
    sensor_joints: Vec<usize>,
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
    /// [`ProcessError::Urdf`] if the text is not a URDF of a tree of links; [`ProcessError::NoFrame`] if a frame is
    /// not in it.
    pub fn from_urdf(text: &str, plate_frame: &str, sensor_frame: &str) -> Result<Self, ProcessError> {
        let parsed = parse(text)?;
        let chain = Arc::new(k::Chain::<f64>::from(&parsed));
        let to = |frame: &str| -> Result<k::SerialChain<f64>, ProcessError> {
            let node = chain.find_link(frame).ok_or_else(|| ProcessError::NoFrame {
                frame: frame.to_owned(),
                known: parsed.links.iter().map(|link| link.name.as_str()).collect::<Vec<_>>().join(", "),
            })?;
            Ok(k::SerialChain::from_end(node))
        };
        let (plate, sensor) = (to(plate_frame)?, to(sensor_frame)?);
        let mut names: Vec<String> = Vec::new();
        let mut index = |chain: &k::SerialChain<f64>| -> Vec<usize> {
            let joints: Vec<String> = chain.iter_joints().map(|joint| joint.name.clone()).collect();
            joints
                .into_iter()
                .map(|name| {
                    names.iter().position(|known| *known == name).unwrap_or_else(|| {
                        names.push(name);
                        names.len() - 1
                    })
                })
                .collect()
        };
        let (plate_joints, sensor_joints) = (index(&plate), index(&sensor));
        Ok(Self { plate, sensor, names, plate_joints, sensor_joints })
    }

    /// The link called `usual`, or else the one behind most moving joints, the first of them in the file.
    ///
    /// # Errors
    /// [`ProcessError::Urdf`] if the text is not a URDF of a tree of links.
    pub fn end_link(text: &str, usual: &str) -> Result<String, ProcessError> {
        let parsed = parse(text)?;
        let above = |link: &str| parsed.joints.iter().find(|joint| joint.child.link == link);
        let moving = |link: &str| {
            let joints = std::iter::successors(above(link), |joint| above(&joint.parent.link));
            joints.filter(|joint| joint.joint_type != urdf_rs::JointType::Fixed).count()
        };
        // Of links that move alike the ones furthest out.
        let depth =
            |link: &str| std::iter::successors(above(link), |joint| above(&joint.parent.link)).count();
        let rank = |link: &str| (link == usual, moving(link), depth(link));
        let links = parsed.links.iter().map(|link| link.name.as_str());
        // The last of several that are equal, so from the end.
        let best = links.rev().max_by_key(|link| rank(link));
        Ok(best.unwrap_or_default().to_owned())
    }

    /// How the sensor stands in the root frame if no joint turns it.
    pub(crate) fn fixed_turn(&self) -> Option<[[f64; 3]; 3]> {
        let turns =
            self.sensor.iter_joints().any(|j| matches!(j.joint_type, k::JointType::Rotational { .. }));
        if turns {
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
    /// [`ProcessError::Lengths`] if there are not as many positions as joints.
    pub fn sample(&self, t_s: f64, positions: &[f64], wrench: [f64; 6]) -> Result<RobotSample, ProcessError> {
        let lengths = ProcessError::Lengths {
            column: "joint positions",
            found: positions.len(),
            expected: self.names.len(),
        };
        if positions.len() != self.names.len() {
            return Err(lengths);
        }
        let plate = pose(&self.plate, &self.plate_joints, positions).ok_or(lengths.clone())?;
        let sensor = pose(&self.sensor, &self.sensor_joints, positions).ok_or(lengths)?;
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

fn pose(chain: &k::SerialChain<f64>, joints: &[usize], positions: &[f64]) -> Option<Isometry3<f64>> {
    let of: Vec<f64> = joints.iter().filter_map(|index| positions.get(*index).copied()).collect();
    // Logs of real arms stray a little over their limits.
    if of.len() != chain.dof() {
        return None;
    }
    chain.set_joint_positions_unchecked(&of);
    Some(chain.end_transform())
}

fn parse(text: &str) -> Result<urdf_rs::Robot, ProcessError> {
    let robot = urdf_rs::read_from_string(text).map_err(|error| ProcessError::Urdf(error.to_string()))?;
    check_tree(&robot)?;
    Ok(robot)
}

/// `k` assumes one root and links that exist.
fn check_tree(robot: &urdf_rs::Robot) -> Result<(), ProcessError> {
    let wrong = |text: String| Err(ProcessError::Urdf(text));
    if robot.joints.is_empty() {
        return wrong("it has no joints".into());
    }
    for joint in &robot.joints {
        for link in [&joint.parent.link, &joint.child.link] {
            if !robot.links.iter().any(|known| known.name == *link) {
                return wrong(format!("joint {} names the link {link}, which is not there", joint.name));
            }
        }
        let parents = robot.joints.iter().filter(|other| other.child.link == joint.child.link).count();
        if parents > 1 {
            return wrong(format!("link {} hangs on {parents} joints, a tree has one", joint.child.link));
        }
        // Climbing from here must end at the root.
        let mut link = &joint.parent.link;
        let mut steps = 0;
        while let Some(above) = robot.joints.iter().find(|other| other.child.link == *link) {
            link = &above.parent.link;
            steps += 1;
            if steps > robot.joints.len() {
                return wrong(format!("the joints above {} form a ring", joint.name));
            }
        }
    }
    let roots = robot
        .links
        .iter()
        .filter(|link| !robot.joints.iter().any(|joint| joint.child.link == link.name))
        .count();
    if roots != 1 {
        return wrong(format!("it has {roots} root links, a tree has one"));
    }
    Ok(())
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
}
