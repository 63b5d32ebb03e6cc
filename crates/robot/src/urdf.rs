use std::collections::BTreeMap;

use crate::RobotError;
use crate::mimic::{Drive, drives};
use crate::model::{Joint, JointKind, Link};
use crate::read::{Read, read};
use crate::tree::{Tree, grow, places};

/// A robot: links that joints hold together as a tree.
#[derive(Debug, Clone)]
pub struct Urdf {
    name: String,
    links: Vec<Link>,
    joints: Vec<Joint>,
    joints_by_name: BTreeMap<String, usize>,
    drives: Vec<Drive>,
    tree: Tree,
    notes: Vec<String>,
}

impl Urdf {
    /// Reads a URDF and checks it.
    ///
    /// Inertias, collision shapes, and what belongs to simulators and controllers are passed over. What only some links need, such
    /// as a mimic that can be followed, is checked when one of them is asked for.
    ///
    /// # Errors
    /// A [`RobotError`] if the text is no well-formed XML, no URDF, or not the URDF of one tree of links, if a name is there
    /// twice, or a number that poses depend on cannot be used.
    pub fn parse(text: &str) -> Result<Self, RobotError> {
        let Read { name, links, joints, notes } = read(text)?;
        // Before the tree: a joint that is there twice would be a link with two parents.
        let joints_by_name = places("joints", joints.iter().map(|read| read.joint.name.as_str()))?;
        let (joints, tree) = grow(&links, joints)?;
        let drives = drives(&joints, &joints_by_name);
        Ok(Self { name, links, joints, joints_by_name, drives, tree, notes })
    }

    /// The robot's name; empty if it has none.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All links in the order of the document.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// All joints in the order of the document.
    #[must_use]
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// What was odd but harmless, such as limits that are no range, in sentences for people.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Where a link is in [`Urdf::links`].
    #[must_use]
    pub fn link_index(&self, name: &str) -> Option<usize> {
        self.tree.by_name.get(name).copied()
    }

    /// Where the joint that a link hangs on is in [`Urdf::joints`]; `None` for the root.
    #[must_use]
    pub fn joint_above(&self, link: usize) -> Option<usize> {
        self.tree.above.get(link).copied().flatten()
    }

    /// Places of all links, each after the one it hangs on; the first is the root.
    #[must_use]
    pub fn outwards(&self) -> &[usize] {
        &self.tree.outwards
    }

    /// The link called `usual`, or else the one behind most joints that are not fixed; of those the one furthest out, and of
    /// several the first in the document.
    #[must_use]
    pub fn end_link(&self, usual: &str) -> &str {
        // How many joints move each link, and on how many it hangs.
        let mut ranks = vec![(0_usize, 0_usize); self.links.len()];
        for &link in self.outwards() {
            let Some(joint) = self.joint_above(link).and_then(|joint| self.joints.get(joint)) else {
                continue;
            };
            let (moving, depth) = ranks.get(joint.parent).copied().unwrap_or_default();
            if let Some(rank) = ranks.get_mut(link) {
                *rank = (moving + usize::from(joint.kind != JointKind::Fixed), depth + 1);
            }
        }
        // The last of several that are equal, so from the end.
        let best =
            self.links.iter().zip(&ranks).rev().max_by_key(|(link, rank)| (link.name == usual, **rank));
        best.map_or("", |(link, _)| &link.name)
    }

    pub(crate) fn drive(&self, joint: usize) -> Drive {
        self.drives.get(joint).copied().unwrap_or(Drive::None)
    }

    pub(crate) const fn joints_by_name(&self) -> &BTreeMap<String, usize> {
        &self.joints_by_name
    }
}
