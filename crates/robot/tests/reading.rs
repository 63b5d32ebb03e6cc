//! What is kept of a document, and what is noted.
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use nalgebra::Vector3;
use soilctl_robot::{Geometry, JointKind, Limits, Urdf};

fn with(inside: &str) -> Urdf {
    Urdf::parse(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>{inside}\
         <joint name=\"ab\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>"
    ))
    .unwrap()
}

/// A link with these visuals, hung on `b` by a joint.
fn drawn(visuals: &str) -> Urdf {
    with(&format!(
        "<link name=\"c\">{visuals}</link><joint name=\"bc\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>"
    ))
}

/// One joint to `c`, with these parts.
fn jointed(kind: &str, parts: &str) -> Urdf {
    with(&format!(
        "<link name=\"c\"/><joint name=\"bc\" type=\"{kind}\"><parent link=\"b\"/><child link=\"c\"/>{parts}</joint>"
    ))
}

#[test]
fn shapes_are_kept_with_their_places_and_colours() {
    let urdf = drawn(
        "<inertial><mass value=\"1\"/></inertial>\
         <visual name=\"v\"><origin xyz=\"1 2 3\"/><geometry><box size=\"0.1 0.2 0.3\"/></geometry><material name=\"late\"/></visual>\
         <visual><geometry><cylinder radius=\"0.1\" length=\"2\"/></geometry>\
           <material name=\"own\"><color rgba=\"1 0 0 0.5\"/></material></visual>\
         <visual><geometry><sphere radius=\".5\"/></geometry><material name=\"own\"/></visual>\
         <visual><geometry><capsule radius=\"0.1\" length=\"0.4\"/></geometry><material><color rgba=\"0 0 1 1\"/></material></visual>\
         <visual><geometry><mesh filename=\"package://r/a &amp; b.stl\" scale=\"0.001 0.001 -0.001\"/></geometry></visual>\
         <visual><geometry><mesh filename=\"c.dae\"/></geometry></visual>\
         <collision><geometry><sphere radius=\"9\"/></geometry></collision>",
    );
    let visuals = &urdf.links()[2].visuals;
    let shapes: Vec<&Geometry> = visuals.iter().map(|visual| &visual.geometry).collect();
    assert_eq!(shapes.len(), 6);
    assert_eq!(*shapes[0], Geometry::Box { size_m: [0.1, 0.2, 0.3] });
    assert_eq!(visuals[0].origin.translation.vector, Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(*shapes[1], Geometry::Cylinder { radius_m: 0.1, length_m: 2.0 });
    assert_eq!(*shapes[2], Geometry::Sphere { radius_m: 0.5 });
    assert_eq!(*shapes[3], Geometry::Capsule { radius_m: 0.1, length_m: 0.4 });
    let mesh = |filename: &str, scale| Geometry::Mesh { filename: filename.to_owned(), scale };
    assert_eq!(*shapes[4], mesh("package://r/a & b.stl", [0.001, 0.001, -0.001]));
    assert_eq!(*shapes[5], mesh("c.dae", [1.0; 3]));
    let colours: Vec<_> = visuals.iter().map(|visual| visual.colour).collect();
    let red = Some([1.0, 0.0, 0.0, 0.5]);
    assert_eq!(colours, [None, red, red, Some([0.0, 0.0, 1.0, 1.0]), None, None]);
    assert_eq!(urdf.notes(), ["material \"late\" has no colour"]);
}

#[test]
fn colours_of_the_robot_count_wherever_they_stand() {
    let painted = |name: &str| {
        format!("<visual><geometry><sphere radius=\"1\"/></geometry><material name=\"{name}\"/></visual>")
    };
    let urdf = Urdf::parse(&format!(
        "<robot name=\"r\"><material name=\"early\"><color rgba=\"0 0 0 1\"/></material>\
         <link name=\"a\">{}{}{}</link>\
         <material name=\"late\"><color rgba=\"1 1 1 1\"/></material>\
         <material name=\"late\"><color rgba=\"0 1 1 1\"/></material>\
         <material name=\"loud\"><color rgba=\"255 0 0 1\"/></material></robot>",
        painted("early"),
        painted("late"),
        painted("loud")
    ))
    .unwrap();
    let colours: Vec<_> = urdf.links()[0].visuals.iter().map(|visual| visual.colour).collect();
    assert_eq!(colours, [Some([0.0, 0.0, 0.0, 1.0]), Some([1.0; 4]), None]);
    let notes = urdf.notes().join("; ");
    assert!(
        notes.contains("\"late\" is there twice") && notes.contains("\"loud\" is not four numbers"),
        "{notes}"
    );
}

#[test]
fn shapes_that_cannot_be_drawn_are_noted() {
    let bad = [
        "<box size=\"1 2\"/>",
        "<box size=\"1 -2 3\"/>",
        "<cylinder radius=\"0.1\"/>",
        "<sphere radius=\"nan\"/>",
        "<sphere radius=\"0\"/>",
        "<mesh filename=\"\"/>",
        "<mesh filename=\"a.stl\" scale=\"1 0 1\"/>",
        "<mesh scale=\"1 1 1\"/>",
        "<cone radius=\"1\"/>",
        "",
    ];
    for shape in bad {
        let urdf = drawn(&format!("<visual><geometry>{shape}</geometry></visual>"));
        assert!(urdf.links()[2].visuals.is_empty(), "{shape}");
        assert!(
            urdf.notes().iter().all(|note| note.contains("link \"c\"")) && !urdf.notes().is_empty(),
            "{shape}"
        );
    }
}

#[test]
fn joints_are_kept_with_their_usual_values() {
    let urdf = jointed("continuous", "");
    let joint = urdf.joints().iter().find(|joint| joint.name == "bc").unwrap();
    assert_eq!((joint.kind, joint.axis), (JointKind::Continuous, Vector3::x_axis()));
    assert_eq!((joint.parent, joint.child), (1, 2));
    assert!(joint.mimic.is_none() && joint.limits.is_none());
    assert_eq!(urdf.outwards(), [0, 1, 2]);
    assert_eq!((urdf.joint_above(0), urdf.joint_above(2)), (None, Some(0)));
    assert!(urdf.notes().is_empty());

    let urdf = jointed("prismatic", "<limit effort=\"1\" velocity=\"1\"/><axis/><dynamics damping=\"1\"/>");
    assert_eq!(urdf.joints()[0].limits, None);
    let urdf = jointed("prismatic", "<limit lower=\"-1\"/><axis xyz=\"0 0 -4\"/>");
    assert_eq!(urdf.joints()[0].limits, Some(Limits { lower: -1.0, upper: 0.0 }));
    assert_eq!(urdf.joints()[0].axis, -Vector3::z_axis());
    assert!(urdf.notes().is_empty());
}

#[test]
fn limits_that_are_no_range_do_no_harm() {
    for limits in [
        "lower=\"nan\" upper=\"1\"",
        "lower=\"1\" upper=\"-1\"",
        "lower=\"-inf\" upper=\"inf\"",
        "upper=\"x\"",
    ] {
        let urdf = jointed("revolute", &format!("<limit {limits} effort=\"nan\" velocity=\"-1\"/>"));
        assert_eq!(urdf.joints()[0].limits, None);
        assert!(urdf.notes().len() == 1 && urdf.notes()[0].contains("\"bc\""), "{:?}", urdf.notes());
        assert!(urdf.chain("c").unwrap().pose(&[0.5]).is_some());
    }
}

#[test]
fn axes_and_mimics_of_fixed_joints_do_nothing() {
    let urdf = jointed("fixed", "<axis xyz=\"0 0 0\"/><mimic joint=\"nobody\"/>");
    assert_eq!(urdf.notes().len(), 2);
    assert!(urdf.chain("c").unwrap().pose(&[]).is_some());
}

#[test]
fn of_repeated_parts_the_first_counts() {
    let urdf =
        jointed("revolute", "<origin xyz=\"1 0 0\"/><origin xyz=\"nan 0 0\"/><parent link=\"nowhere\"/>");
    assert_eq!(urdf.joints()[0].origin.translation.vector, Vector3::x());
    assert_eq!(urdf.notes().len(), 2);
}

/// Parts of other programs have links and joints in them that mean something else.
#[test]
fn what_belongs_to_other_programs_is_passed_over() {
    let urdf = with(
        "<transmission name=\"t\"><joint name=\"ab\"/></transmission><!-- -- <joint> -->\
         <gazebo reference=\"a\"><link name=\"a\"/><plugin file=\"$(find it) ${x}\"/>text</gazebo>\
         <ros2_control><joint name=\"x\"><param>$(arg y) &lt;&#65;</param></joint></ros2_control><![CDATA[<link>]]>",
    );
    assert_eq!((urdf.links().len(), urdf.joints().len()), (2, 1));
    assert!(urdf.notes().is_empty());
}

#[test]
fn numbers_and_names_may_be_written_in_odd_ways() {
    let urdf = jointed("fixed", "<origin xyz=\" \t+1.&#10;2e0\u{a0}\n 3 \" rpy='0   0 -0.'/>");
    assert_eq!(urdf.joints()[0].origin.translation.vector, Vector3::new(1.0, 2.0, 3.0));
    let urdf = Urdf::parse(
        "\u{feff}<?xml version='1.0' encoding='utf-8'?>\n<!-- a --><robot><link name='ä &amp; ö'/></robot>\n",
    );
    let urdf = urdf.unwrap();
    assert_eq!((urdf.name(), urdf.end_link("x"), urdf.notes().len()), ("", "ä & ö", 1));
}

#[test]
fn notes_are_bounded() {
    let many = "<material name=\"m\"><color rgba=\"9 9 9 9\"/></material>".repeat(1000);
    let notes = with(&many).notes().to_vec();
    assert!(notes.len() == 101 && notes[100].contains("900 more"), "{}", notes[100]);
}
