//! The same as others find: `urdf-rs` and `k` on trees of all kinds, and our arm's own kinematics.
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

mod common;

use common::{Drawn, moving_above, tree, tree_of, urdf, written};
use k::nalgebra as theirs;
use nalgebra::Isometry3;
use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles};
use soilctl_robot::Urdf;

/// Rounding of some 50 products of numbers up to 1, with lengths up to 50 m.
const TOLERANCE: f64 = 1e-12;

fn assert_same(ours: &Isometry3<f64>, theirs: &theirs::Isometry3<f64>) -> Result<(), TestCaseError> {
    for (our, their) in ours.translation.vector.iter().zip(theirs.translation.vector.iter()) {
        prop_assert!((our - their).abs() < TOLERANCE, "{ours} {theirs}");
    }
    let (our, their) = (ours.rotation.to_rotation_matrix(), theirs.rotation.to_rotation_matrix());
    for (our, their) in our.matrix().iter().zip(their.matrix().iter()) {
        prop_assert!((our - their).abs() < TOLERANCE, "{ours} {theirs}");
    }
    Ok(())
}

fn k_chain(text: &str) -> k::Chain<f64> {
    k::Chain::from(urdf_rs::read_from_string(text).unwrap())
}

/// Positions of all joints by the number of their child.
fn positions() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-3.0..3.0_f64, 25)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn every_link_of_a_tree_is_where_k_has_it(tree in tree(), positions in positions()) {
        let text = urdf(&tree);
        let ours = Urdf::parse(&text).unwrap();
        let theirs = k_chain(&text);
        let drawn = ours.link_poses(&|name| Some(positions[name[1..].parse::<usize>().unwrap()]));
        for link in 1..=tree.len() {
            let name = format!("l{link}");
            let chain = ours.chain(&name).unwrap();
            let joints = moving_above(&tree, link);
            prop_assert_eq!(chain.joint_names(), joints.iter().map(|j| format!("j{j}")).collect::<Vec<_>>());
            prop_assert_eq!(chain.sliding(), joints.iter().map(|j| tree[j - 1].kind == "prismatic").collect::<Vec<_>>());
            prop_assert_eq!(chain.turns(), joints.iter().any(|j| tree[j - 1].kind != "prismatic"));
            let values: Vec<f64> = joints.iter().map(|joint| positions[*joint]).collect();
            let pose = chain.pose(&values).unwrap();

            let serial = k::SerialChain::from_end(theirs.find_link(&name).unwrap());
            prop_assert_eq!(serial.dof(), values.len());
            serial.set_joint_positions_unchecked(&values);
            assert_same(&pose, &serial.end_transform())?;
            assert_same(&drawn[ours.link_index(&name).unwrap()].unwrap(), &serial.end_transform())?;
        }
        prop_assert_eq!(drawn[ours.link_index("l0").unwrap()], Some(Isometry3::identity()));
    }

    /// Joints that follow others are where `k` has them when their positions are given to it.
    #[test]
    fn followers_are_where_joints_of_those_positions_are(
        tree in tree_of(&["revolute", "continuous", "prismatic"]),
        leaders in prop::collection::vec((any::<u32>(), -2.0..2.0_f64, -1.0..1.0_f64), 25),
        positions in positions(),
    ) {
        // Joint j follows an earlier one, or nothing.
        let leader = |joint: usize| Some(leaders[joint].0 as usize % joint).filter(|leader| *leader > 0);
        let mut values = positions.clone();
        let mut text = String::from("<robot name=\"followers\"><link name=\"l0\"/>");
        for (joint, drawn) in (1..).zip(&tree) {
            let (_, multiplier, offset) = leaders[joint];
            let more = leader(joint).map_or_else(String::new, |leader| {
                values[joint] = multiplier * values[leader] + offset;
                format!("<mimic joint=\"j{leader}\" multiplier=\"{multiplier}\" offset=\"{offset}\"/>")
            });
            text += &format!("<link name=\"l{joint}\"/>{}", written(joint, drawn, &more));
        }
        let ours = Urdf::parse(&(text + "</robot>")).unwrap();
        let theirs = k_chain(&urdf(&tree));
        let drawn = ours.link_poses(&|name| Some(positions[name[1..].parse::<usize>().unwrap()]));
        for (link, pose) in drawn.iter().enumerate().skip(1) {
            let chain = ours.chain(&format!("l{link}")).unwrap();
            let independent: Vec<f64> = chain.joint_names().iter().map(|name| {
                let joint: usize = name[1..].parse().unwrap();
                assert!(leader(joint).is_none());
                positions[joint]
            }).collect();
            let all: Vec<f64> = moving_above(&tree, link).iter().map(|joint| values[*joint]).collect();
            let serial = k::SerialChain::from_end(theirs.find_link(&format!("l{link}")).unwrap());
            serial.set_joint_positions_unchecked(&all);
            assert_same(&chain.pose(&independent).unwrap(), &serial.end_transform())?;
            assert_same(&pose.unwrap(), &serial.end_transform())?;
        }
    }

    #[test]
    fn the_end_is_the_link_that_a_search_over_all_finds(
        tree in tree_of(&["revolute", "prismatic", "fixed", "fixed", "floating", "planar"]), usual in 0..40_usize,
    ) {
        let text = urdf(&tree);
        let usual = format!("l{usual}");
        let ours = Urdf::parse(&text).unwrap();
        prop_assert_eq!(ours.end_link(&usual), end_by_search(&text, &usual));
    }

    /// What is read is what another reader reads.
    #[test]
    fn documents_say_the_same_to_another_reader(tree in tree()) {
        let text = urdf(&tree);
        let (ours, theirs) = (Urdf::parse(&text).unwrap(), urdf_rs::read_from_string(&text).unwrap());
        prop_assert_eq!(ours.name(), theirs.name);
        prop_assert_eq!(ours.links().len(), theirs.links.len());
        for (our, their) in ours.links().iter().zip(&theirs.links) {
            prop_assert_eq!(&our.name, &their.name);
        }
        for (our, their) in ours.joints().iter().zip(&theirs.joints) {
            prop_assert_eq!(&our.name, &their.name);
            prop_assert_eq!(&ours.links()[our.parent].name, &their.parent.link);
            prop_assert_eq!(&ours.links()[our.child].name, &their.child.link);
            prop_assert_eq!(<[f64; 3]>::from(our.origin.translation.vector), *their.origin.xyz);
            prop_assert_eq!(our.limits.map(|limits| [limits.lower, limits.upper]), Some([their.limit.lower, their.limit.upper]));
        }
        prop_assert!(ours.notes().is_empty());
    }
}

/// By the definition, with no thought of time.
fn end_by_search(text: &str, usual: &str) -> String {
    let parsed = urdf_rs::read_from_string(text).unwrap();
    let above = |link: &str| parsed.joints.iter().find(|joint| joint.child.link == link);
    let rank = |link: &str| {
        let joints = || std::iter::successors(above(link), |joint| above(&joint.parent.link));
        let moving = joints().filter(|joint| joint.joint_type != urdf_rs::JointType::Fixed).count();
        (link == usual, moving, joints().count())
    };
    let links = parsed.links.iter().map(|link| link.name.as_str());
    let best = links.clone().map(rank).max().unwrap();
    links.clone().find(|link| rank(link) == best).unwrap().to_owned()
}

#[test]
fn our_own_arm_is_where_its_closed_forms_have_it() {
    let arm = Arm::thesis();
    let urdf = Urdf::parse(&soilctl_kinematics::urdf(&arm)).unwrap();
    assert!(urdf.notes().is_empty() && urdf.name() == "thesis" && urdf.end_link("plate_tip") == "plate_tip");
    for degrees in [[0.0; 5], [20.0, 120.0, 80.0, -40.0, 60.0], [-50.0, -20.0, 140.0, 70.0, -80.0]] {
        let joints = JointAngles::from_degrees(degrees);
        for (name, frame) in arm.frames(&joints).unwrap().named() {
            let chain = urdf.chain(name).unwrap();
            let pose = chain.pose(&joints.0[..chain.joint_names().len()]).unwrap();
            let rotation = pose.rotation.to_rotation_matrix();
            for row in 0..3 {
                assert!((pose.translation.vector[row] - frame.origin_m[row]).abs() < TOLERANCE, "{name}");
                for column in 0..3 {
                    assert!(
                        (rotation[(row, column)] - frame.rotation[row][column]).abs() < TOLERANCE,
                        "{name}"
                    );
                }
            }
        }
    }
}

/// The types of the drawn tree are what its name says.
#[test]
fn a_drawn_tree_is_as_it_was_drawn() {
    let joint =
        |parent, kind| Drawn { parent, kind, xyz: [0.0; 3], rpy: [0.0; 3], axis: [1.0, 0.0, 0.0], rank: 0 };
    let tree = [joint(0, "fixed"), joint(1, "revolute"), joint(1, "prismatic"), joint(3, "revolute")];
    assert_eq!(moving_above(&tree, 4), [3, 4]);
    assert_eq!(Urdf::parse(&urdf(&tree)).unwrap().chain("l4").unwrap().joint_names(), ["j3", "j4"]);
}
