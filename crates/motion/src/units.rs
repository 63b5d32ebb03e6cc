//! Numbers that cannot be in the units that ROS has.

use soilctl_robot::{JointKind, Urdf};

use crate::Columns;

/// Joints that turn further than this, or slide further, are not given in rad or m.
pub const MOST_RAD: f64 = 30.0;
/// See [`MOST_RAD`].
pub const MOST_M: f64 = 50.0;
/// A torque by its force is a lever in m; none at an arm's hand is so long.
const MOST_LEVER_M: f64 = 20.0;
/// No arm's sensor reads such a force in N.
const MOST_N: f64 = 1e6;

/// Says which columns have such numbers. Without a URDF nobody knows whether a joint turns without end, so nothing is said of joints.
pub(crate) fn implausible(columns: &Columns, joints: &[String], urdf: Option<&str>) -> Vec<String> {
    let mut found = Vec::new();
    let urdf = urdf.and_then(|text| Urdf::parse(text).ok());
    for (name, series) in joints.iter().zip(&columns.joints) {
        let kind = urdf.as_ref().and_then(|urdf| urdf.joints().iter().find(|joint| joint.name == *name));
        let (most, unit, instead) = match kind.map(|joint| joint.kind) {
            Some(JointKind::Revolute) => (MOST_RAD, "rad", "degrees"),
            Some(JointKind::Prismatic) => (MOST_M, "m", "mm"),
            Some(JointKind::Continuous | JointKind::Fixed | JointKind::Floating | JointKind::Planar)
            | None => {
                continue;
            }
        };
        let furthest = largest(series.values.iter().copied());
        if furthest > most {
            found.push(format!(
                "joint {name} goes to {furthest:.1} {unit}: its positions seem to be in {instead}; ROS has them in {unit}"
            ));
        }
    }
    let wrenches = &columns.wrenches.values;
    let size = |from: usize| largest(wrenches.iter().flat_map(|w| w.iter().skip(from).take(3).copied()));
    let (force, torque) = (size(0), size(3));
    if force > MOST_N {
        found.push(format!("a force reads {force:.3e} N; ROS has forces in N"));
    }
    if torque > MOST_LEVER_M * force && torque > 1.0 {
        found.push(format!(
            "torques go to {torque:.1} N m beside forces of no more than {force:.2} N: they seem to be in N mm; ROS has them in N m"
        ));
    }
    if let Some(first) = wrenches.first()
        && wrenches.len() > 10
        && wrenches.iter().all(|wrench| wrench == first)
    {
        found.push(format!("all {} wrenches are the same: the sensor was not read", wrenches.len()));
    }
    found
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, f64::max)
}
