use std::collections::BTreeMap;

use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};

use crate::mimic::{Drive, fault};
use crate::model::{Joint, JointKind};
use crate::turn::about_axis;
use crate::words::{cut, list};
use crate::{RobotError, Urdf};

/// The way from the root to a link, ready for forward kinematics.
#[derive(Debug, Clone)]
pub struct Chain {
    link: String,
    names: Vec<String>,
    sliding: Vec<bool>,
    steps: Vec<Step>,
    /// What does not move behind the last joint that does.
    end: Isometry3<f64>,
    turns: bool,
}

/// One joint that moves.
#[derive(Debug, Clone)]
struct Step {
    /// All that does not move between the joint before and this one.
    before: Isometry3<f64>,
    motion: Motion,
    /// Whose position it follows, among the names.
    place: usize,
    multiplier: f64,
    offset: f64,
}

/// What a joint with a position does.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Motion {
    Turn(Unit<Vector3<f64>>),
    Slide(Unit<Vector3<f64>>),
}

impl Motion {
    /// `None` for joints without a position.
    pub(crate) fn of(joint: &Joint) -> Option<Self> {
        match joint.kind {
            JointKind::Revolute | JointKind::Continuous => Some(Self::Turn(joint.axis)),
            JointKind::Prismatic => Some(Self::Slide(joint.axis)),
            JointKind::Fixed | JointKind::Floating | JointKind::Planar => None,
        }
    }

    /// At a position in rad or m.
    pub(crate) fn at(&self, position: f64) -> Isometry3<f64> {
        match self {
            Self::Turn(axis) => Isometry3::from_parts(Translation3::identity(), about_axis(axis, position)),
            Self::Slide(axis) => {
                Isometry3::from_parts(axis.scale(position).into(), UnitQuaternion::identity())
            }
        }
    }
}

impl Chain {
    /// The link at its end.
    #[must_use]
    pub fn link(&self) -> &str {
        &self.link
    }

    /// The joints that move it, in order from the root. A joint that mimics another is not there; the one that it follows
    /// is, at the first place where it is needed, also if that one lies on another branch of the tree.
    #[must_use]
    pub fn joint_names(&self) -> &[String] {
        &self.names
    }

    /// For each of [`Chain::joint_names`] whether it slides, so that its position is in m and not in rad.
    #[must_use]
    pub fn sliding(&self) -> &[bool] {
        &self.sliding
    }

    /// Whether the link's orientation depends on any joint; it does not if all of them slide.
    #[must_use]
    pub const fn turns(&self) -> bool {
        self.turns
    }

    /// From the link's frame to the root's, at positions (rad, or m of a joint that slides), one for each of
    /// [`Chain::joint_names`]. It does not allocate.
    ///
    /// `None` if there are not as many positions as joints, or if one is so large, or no number, that the pose would not be
    /// finite.
    #[must_use]
    pub fn pose(&self, positions: &[f64]) -> Option<Isometry3<f64>> {
        if positions.len() != self.names.len() {
            return None;
        }
        let mut pose = Isometry3::identity();
        for step in &self.steps {
            let position = step.multiplier * positions.get(step.place)? + step.offset;
            pose = pose * step.before * step.motion.at(position);
        }
        finite(pose * self.end)
    }
}

/// A pose whose numbers are all finite.
pub(crate) fn finite(pose: Isometry3<f64>) -> Option<Isometry3<f64>> {
    let mut numbers = pose.translation.vector.iter().chain(pose.rotation.coords.iter());
    numbers.all(|number| number.is_finite()).then_some(pose)
}

impl Urdf {
    /// The way from the root to a link.
    ///
    /// # Errors
    /// [`RobotError::NoLink`] if the link is not there; [`RobotError::Free`] if it hangs on a floating or planar joint;
    /// [`RobotError::MimicMissing`], [`RobotError::MimicRing`], [`RobotError::MimicStill`] or [`RobotError::MimicSize`]
    /// if a joint that it hangs on mimics what has no position.
    pub fn chain(&self, link: &str) -> Result<Chain, RobotError> {
        let end = self.link_index(link).ok_or_else(|| RobotError::NoLink {
            link: cut(link),
            known: list(self.links().iter().map(|link| link.name.as_str())),
        })?;
        let mut joints: Vec<usize> = Vec::new();
        let mut above = self.joint_above(end);
        while let Some(number) = above {
            joints.push(number);
            above = self.joints().get(number).and_then(|joint| self.joint_above(joint.parent));
        }

        let mut chain = Chain {
            link: link.to_owned(),
            names: Vec::new(),
            sliding: Vec::new(),
            steps: Vec::new(),
            end: Isometry3::identity(),
            turns: false,
        };
        let mut places: BTreeMap<usize, usize> = BTreeMap::new();
        for (number, joint) in
            joints.iter().rev().filter_map(|n| self.joints().get(*n).map(|joint| (*n, joint)))
        {
            let before = chain.end * joint.origin;
            match (self.drive(number), Motion::of(joint)) {
                (Drive::By { source, multiplier, offset }, Some(motion)) => {
                    let place = *places.entry(source).or_insert_with(|| chain.add(self.joints().get(source)));
                    chain.turns |= matches!(motion, Motion::Turn(_));
                    chain.steps.push(Step { before, motion, place, multiplier, offset });
                    chain.end = Isometry3::identity();
                }
                (Drive::Broken(why), _) => {
                    return Err(fault(why, link, self.joints(), self.joints_by_name()));
                }
                _ if joint.kind == JointKind::Fixed => chain.end = before,
                _ => {
                    return Err(RobotError::Free {
                        link: cut(link),
                        kind: joint.kind.word(),
                        joint: cut(&joint.name),
                    });
                }
            }
        }
        Ok(chain)
    }
}

impl Chain {
    /// Adds a joint that moves by itself, and says where its position will be.
    fn add(&mut self, joint: Option<&Joint>) -> usize {
        self.names.push(joint.map(|joint| joint.name.clone()).unwrap_or_default());
        self.sliding.push(joint.is_some_and(|joint| joint.kind == JointKind::Prismatic));
        self.names.len() - 1
    }
}
