//! Trees of links, drawn at random and written as URDFs.
#![allow(dead_code, clippy::unwrap_used, clippy::indexing_slicing)]

use std::fmt::Write;

use proptest::prelude::*;

/// A joint to draw, and the link that hangs on it.
#[derive(Debug, Clone)]
pub(crate) struct Drawn {
    /// The link before it: the root, or the link of an earlier joint.
    pub(crate) parent: usize,
    pub(crate) kind: &'static str,
    pub(crate) xyz: [f64; 3],
    pub(crate) rpy: [f64; 3],
    pub(crate) axis: [f64; 3],
    /// Where it stands in the document.
    pub(crate) rank: u32,
}

const MOVING: [&str; 3] = ["revolute", "continuous", "prismatic"];

fn drawn(earlier: usize, kinds: &'static [&'static str]) -> impl Strategy<Value = Drawn> {
    let axis = prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("a direction", |axis| axis.iter().map(|part| part * part).sum::<f64>() > 1e-4);
    let parts = (prop::array::uniform3(-1.0..1.0_f64), prop::array::uniform3(-4.0..4.0_f64), axis);
    // Rather long branches than broad ones.
    let parent = prop_oneof![3 => Just(earlier), 1 => 0..=earlier];
    (parent, prop::sample::select(kinds), parts, any::<u32>())
        .prop_map(|(parent, kind, (xyz, rpy, axis), rank)| Drawn { parent, kind, xyz, rpy, axis, rank })
}

/// Trees with up to 24 joints that a chain can be made of.
pub(crate) fn tree() -> impl Strategy<Value = Vec<Drawn>> {
    tree_of(&["revolute", "continuous", "prismatic", "fixed"])
}

/// Trees of joints of some types.
pub(crate) fn tree_of(kinds: &'static [&'static str]) -> impl Strategy<Value = Vec<Drawn>> {
    (1..25_usize).prop_flat_map(move |count| (0..count).map(|joint| drawn(joint, kinds)).collect::<Vec<_>>())
}

/// A tree as a URDF: links `l0` to `ln`, `l0` the root, and joints `j1` to `jn`, each with the number of its child; in any
/// order.
pub(crate) fn urdf(tree: &[Drawn]) -> String {
    let mut order: Vec<usize> = (0..tree.len()).collect();
    order.sort_by_key(|joint| tree[*joint].rank);
    let mut text = String::from("<?xml version=\"1.0\"?>\n<robot name=\"drawn\">\n");
    for link in order.iter().map(|joint| joint + 1).chain([0]) {
        writeln!(text, "  <link name=\"l{link}\"/>").unwrap();
    }
    for joint in order {
        text.push_str(&written(joint + 1, &tree[joint], ""));
    }
    text + "</robot>\n"
}

/// One joint, with something more in it.
pub(crate) fn written(child: usize, drawn: &Drawn, more: &str) -> String {
    let three = |values: [f64; 3]| values.map(|value| value.to_string()).join(" ");
    let Drawn { parent, kind, .. } = drawn;
    format!(
        "  <joint name=\"j{child}\" type=\"{kind}\">\n    <origin xyz=\"{}\" rpy=\"{}\"/>\n    \
         <parent link=\"l{parent}\"/><child link=\"l{child}\"/>\n    <axis xyz=\"{}\"/>\n    \
         <limit lower=\"-9\" upper=\"9\" effort=\"1\" velocity=\"1\"/>{more}\n  </joint>\n",
        three(drawn.xyz),
        three(drawn.rpy),
        three(drawn.axis)
    )
}

/// The moving joints on the way to a link, from the root.
pub(crate) fn moving_above(tree: &[Drawn], link: usize) -> Vec<usize> {
    let above = |link: &usize| tree.get(link.wrapping_sub(1)).map(|joint| joint.parent);
    let way = std::iter::successors(Some(link), above).filter(|link| *link > 0);
    let mut joints: Vec<usize> = way.filter(|joint| MOVING.contains(&tree[joint - 1].kind)).collect();
    joints.reverse();
    joints
}

/// `count` links in a row, each on a joint of this type, 1 m along x.
pub(crate) fn row(count: usize, kind: &str) -> String {
    let mut text = String::from("<robot name=\"row\"><link name=\"l0\"/>");
    for link in 1..count {
        let before = link - 1;
        write!(
            text,
            "<link name=\"l{link}\"/><joint name=\"j{link}\" type=\"{kind}\"><parent link=\"l{before}\"/>\
             <child link=\"l{link}\"/><origin xyz=\"1 0 0\"/><axis xyz=\"0 0 1\"/></joint>"
        )
        .unwrap();
    }
    text + "</robot>"
}
