use std::fmt::Write;

use crate::inertia::{COLUMN_RADIUS_M, HAND_RADIUS_M, LINK_RADIUS_M, LinkBody, counterweight_radius_m};
use crate::{Arm, Joint};

/// One drawn and colliding shape, centred at `z_m` on the link's axis.
struct Shape {
    geometry: String,
    z_m: f64,
    colour: &'static str,
}

impl Shape {
    /// From `from_m` to `to_m` along the link; none if nothing is left between.
    fn cylinder(from_m: f64, to_m: f64, radius_m: f64, colour: &'static str) -> Option<Self> {
        let length = to_m - from_m;
        (length > 0.0).then(|| Self {
            geometry: format!("<cylinder radius=\"{radius_m}\" length=\"{length}\"/>"),
            z_m: from_m + 0.5 * length,
            colour,
        })
    }

    fn ball(z_m: f64, radius_m: f64, colour: &'static str) -> Option<Self> {
        (radius_m > 0.0).then(|| Self { geometry: format!("<sphere radius=\"{radius_m}\"/>"), z_m, colour })
    }
}

/// The arm as a URDF document, for viewers, simulators and ROS tools.
///
/// Links: `base_link`, `column_link`, `upper_arm_link`, `forearm_link`, `twist_link`, `hand_link` and the frames
/// `ft_sensor` and `plate_tip`, the same as in [`LinkFrames`](crate::LinkFrames). Joints: `base`, `shoulder`,
/// `elbow`, `twist`, `wrist`. Lengths in m, angles in rad, masses in kg. Kinematics, limits, masses and centres
/// of mass are those of the arm file; the shapes, and so the inertias, are plain rods, balls and the plate. The
/// counterweights belong to the links they sit on. Numbers are written so that they read back to the same bits.
#[must_use]
pub fn urdf(arm: &Arm) -> String {
    let config = arm.config();
    let (lengths, weights) = (&config.links, &config.counterweights);
    let upper_edge = lengths.hand_m - config.plate.height_m;
    let grey = |from, to, radius| Shape::cylinder(from, to, radius, "grey");
    let ball = |weight: crate::config::Counterweight| {
        Shape::ball(-weight.behind_m, counterweight_radius_m(weight), "dark")
    };
    let box_size = [config.plate.thickness_m, config.plate.width_m, config.plate.height_m];
    let plate = Shape {
        geometry: format!("<box size=\"{} {} {}\"/>", box_size[0], box_size[1], box_size[2]),
        z_m: lengths.hand_m - 0.5 * config.plate.height_m,
        colour: "steel",
    };

    let mut text = format!("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", config.name);
    for (name, rgba) in
        [("grey", "0.7 0.7 0.72 1"), ("dark", "0.25 0.25 0.28 1"), ("steel", "0.45 0.55 0.65 1")]
    {
        let _ = writeln!(text, "  <material name=\"{name}\"><color rgba=\"{rgba}\"/></material>");
    }
    link(&mut text, "base_link", None, &[]);
    let [column, upper_arm, forearm, twist, hand] = arm.link_bodies();
    link(&mut text, "column_link", Some(column), &[grey(0.0, lengths.base_height_m, COLUMN_RADIUS_M)]);
    let shapes = [grey(0.0, lengths.upper_arm_m, LINK_RADIUS_M), ball(weights.shoulder)];
    link(&mut text, "upper_arm_link", Some(upper_arm), &shapes);
    let shapes = [grey(0.0, lengths.forearm_m, LINK_RADIUS_M), ball(weights.elbow)];
    link(&mut text, "forearm_link", Some(forearm), &shapes);
    let shapes =
        [grey(0.0, lengths.twist_m, LINK_RADIUS_M), Shape::ball(lengths.twist_m, LINK_RADIUS_M, "dark")];
    link(&mut text, "twist_link", Some(twist), &shapes);
    link(&mut text, "hand_link", Some(hand), &[grey(0.0, upper_edge, HAND_RADIUS_M), Some(plate)]);
    link(&mut text, "ft_sensor", None, &[]);
    link(&mut text, "plate_tip", None, &[]);

    revolute(&mut text, arm, Joint::Base, ["base_link", "column_link"], 0.0, "0 0 1");
    revolute(
        &mut text,
        arm,
        Joint::Shoulder,
        ["column_link", "upper_arm_link"],
        lengths.base_height_m,
        "0 1 0",
    );
    revolute(&mut text, arm, Joint::Elbow, ["upper_arm_link", "forearm_link"], lengths.upper_arm_m, "0 1 0");
    revolute(&mut text, arm, Joint::Twist, ["forearm_link", "twist_link"], lengths.forearm_m, "0 0 1");
    revolute(&mut text, arm, Joint::Wrist, ["twist_link", "hand_link"], lengths.twist_m, "0 1 0");
    let sensor = lengths.hand_m - config.sensor.before_tip_m;
    fixed(&mut text, "ft_sensor", sensor, &format!("0 {} 0", -std::f64::consts::FRAC_PI_2));
    fixed(&mut text, "plate_tip", lengths.hand_m, "0 0 0");
    text.push_str("</robot>\n");
    text
}

// Writing to a String cannot fail, hence the ignored results.
fn link(text: &mut String, name: &str, body: Option<LinkBody>, shapes: &[Option<Shape>]) {
    if body.is_none() {
        let _ = writeln!(text, "  <link name=\"{name}\"/>");
        return;
    }
    let _ = writeln!(text, "  <link name=\"{name}\">");
    if let Some(LinkBody { mass_kg, centre_m, across_kg_m2: across, along_kg_m2: along }) = body {
        let _ = writeln!(text, "    <inertial>");
        let _ = writeln!(text, "      <origin xyz=\"0 0 {centre_m}\" rpy=\"0 0 0\"/>");
        let _ = writeln!(text, "      <mass value=\"{mass_kg}\"/>");
        let _ = write!(text, "      <inertia ixx=\"{across}\" ixy=\"0\" ixz=\"0\" ");
        let _ = writeln!(text, "iyy=\"{across}\" iyz=\"0\" izz=\"{along}\"/>");
        let _ = writeln!(text, "    </inertial>");
    }
    for Shape { geometry, z_m, colour } in shapes.iter().flatten() {
        let place = format!("<origin xyz=\"0 0 {z_m}\" rpy=\"0 0 0\"/><geometry>{geometry}</geometry>");
        let _ = writeln!(text, "    <visual>{place}<material name=\"{colour}\"/></visual>");
        let _ = writeln!(text, "    <collision>{place}</collision>");
    }
    let _ = writeln!(text, "  </link>");
}

fn revolute(text: &mut String, arm: &Arm, joint: Joint, [parent, child]: [&str; 2], z_m: f64, axis: &str) {
    let i = joint.index();
    let config = arm.config().joints.all()[i];
    let (lower, upper) = (arm.lower_limits().0[i], arm.upper_limits().0[i]);
    let (effort, velocity) = (config.max_torque_nm, config.max_speed_deg_s.to_radians());
    let _ = writeln!(text, "  <joint name=\"{joint}\" type=\"revolute\">");
    let _ = writeln!(text, "    <parent link=\"{parent}\"/><child link=\"{child}\"/>");
    let _ = writeln!(text, "    <origin xyz=\"0 0 {z_m}\" rpy=\"0 0 0\"/><axis xyz=\"{axis}\"/>");
    let _ = write!(text, "    <limit lower=\"{lower}\" upper=\"{upper}\" ");
    let _ = writeln!(text, "effort=\"{effort}\" velocity=\"{velocity}\"/>");
    let _ = writeln!(text, "  </joint>");
}

fn fixed(text: &mut String, child: &str, z_m: f64, rpy: &str) {
    let _ = writeln!(text, "  <joint name=\"{child}_joint\" type=\"fixed\">");
    let _ = writeln!(text, "    <parent link=\"hand_link\"/><child link=\"{child}\"/>");
    let _ = writeln!(text, "    <origin xyz=\"0 0 {z_m}\" rpy=\"{rpy}\"/>");
    let _ = writeln!(text, "  </joint>");
}
