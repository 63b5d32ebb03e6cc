//! The step of the external encoders, seen at the plate.

use std::f64::consts::TAU;

use soilctl_kinematics::Joint;

use crate::Plan;

/// How far the plate of the first stroke seems to move along the stroke, in m, when the shoulder's external encoder counts one on:
/// the coarsest of all. Where the elbow's encoders are on the motors' outputs, its angle is read across the cable's way over the
/// shoulder, and moves along.
pub(crate) fn at_plate_m(plan: &Plan) -> Option<f64> {
    let (plant, stroke) = (plan.plant(), plan.strokes().strokes().first()?);
    let arm = plant.arm();
    let joints = arm.inverse(&stroke.pose(plan.controller().site.surface_z_m - stroke.depth_m)).ok()?;
    let jacobian = arm.jacobian(&joints).ok()?.0;
    let (shoulder, elbow) = (Joint::Shoulder.index(), Joint::Elbow.index());
    let encoders = &plant.config().encoders;
    let to_joint = arm.transmission().motor_to_joint();
    let turns = |joint: usize| {
        if encoders.external_on_joint[elbow] {
            f64::from(u8::from(joint == shoulder))
        } else {
            to_joint[joint][shoulder]
        }
    };
    let (sin, cos) = libm::sincos(joints.0[Joint::Base.index()]);
    let outwards: f64 = (0..5).map(|j| (jacobian[0][j] * cos + jacobian[1][j] * sin) * turns(j)).sum();
    Some(outwards.abs() * TAU / encoders.external_counts_per_turn[shoulder].abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The thesis's arm: a tenth of a degree at the shoulder, which is 0.34 m above the soil, and 0.058 degrees at the elbow, which
    /// is another 0.7 m above.
    #[test]
    fn a_count_of_the_shoulder_moves_the_plate_by_nearly_two_millimetres() {
        let text = "version = 1\nsoil = \"ticino_loose\"\nmodel = \"table\"\nseed = 1\n[[batches]]\nstrokes = [\n{ radius_m = 0.4, \
                    base_deg = 30.0, alpha_deg = 90.0, depth_m = 0.0254, delta_set_deg = 20.0 },\n]\n";
        let plan = Plan::from_toml(text, "plan", std::path::Path::new(".")).unwrap();
        let arm = plan.plant().arm();
        let stroke = plan.strokes().strokes()[0];
        let joints = arm.inverse(&stroke.pose(plan.controller().site.surface_z_m - stroke.depth_m)).unwrap();
        let mut counted = joints;
        let count = TAU / 3600.0;
        counted.0[1] += count;
        counted.0[2] += 0.58 * count;
        let radius = |joints| {
            let pose = arm.forward(joints).unwrap();
            libm::hypot(pose.x_m, pose.y_m)
        };
        let step = at_plate_m(&plan).unwrap();
        assert!((step - (radius(&counted) - radius(&joints)).abs()).abs() < 2e-6, "{step}");
        assert!((0.0015..0.002).contains(&step), "{step}");
    }
}
