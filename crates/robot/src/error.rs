use thiserror::Error;

use crate::bounds::{MOST_BYTES, MOST_DEPTH, MOST_LINKS, MOST_SIZE};

/// What can be wrong with a URDF, or with what is asked of it.
///
/// Names and values are as the document has them, cut where they are too long to be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RobotError {
    /// The document is longer than what is read.
    #[error(
        "the URDF has {bytes} bytes, at most {MOST_BYTES} are read; give shapes as mesh files, not as text"
    )]
    TooLong {
        /// Its length.
        bytes: usize,
    },
    /// Elements lie deeper inside each other than any URDF needs.
    #[error(
        "line {line}: elements lie more than {MOST_DEPTH} deep inside each other; a URDF needs six levels"
    )]
    TooDeep {
        /// The line, from 1.
        line: usize,
    },
    /// There are more links, joints, visuals or materials than are read.
    #[error(
        "the URDF has more than {MOST_LINKS} {what}, which is the most that is read; leave out what does not move"
    )]
    TooMany {
        /// What is counted.
        what: &'static str,
    },
    /// The text is not well-formed XML, or not all of it.
    #[error("line {line}: this is not well-formed XML: {problem}")]
    Xml {
        /// The line, from 1.
        line: usize,
        /// What is wrong, and what to do.
        problem: String,
    },
    /// The document is a source of a URDF and not one yet.
    #[error(
        "line {line}: {found:?} is xacro, from which a URDF is made; run xacro first: `xacro robot.urdf.xacro > robot.urdf`"
    )]
    Xacro {
        /// The line, from 1.
        line: usize,
        /// What shows it.
        found: String,
    },
    /// The outermost element is another one.
    #[error("the outermost element is {found:?}; it must be \"robot\" in a URDF")]
    NotRobot {
        /// Its name; empty if there is no element at all.
        found: String,
    },
    /// An element lacks what it cannot do without.
    #[error("line {line}: {element} has no {missing}; a URDF must give it")]
    Missing {
        /// The line, from 1.
        line: usize,
        /// The element, with its name if it has one.
        element: String,
        /// What it lacks.
        missing: &'static str,
    },
    /// A number that cannot be used.
    #[error("{what} is {found:?}; it must be {allowed}, each finite and at most {MOST_SIZE} in size")]
    Number {
        /// Which number, with the name of its joint or link.
        what: String,
        /// What is written there.
        found: String,
        /// The allowed form, with its unit.
        allowed: &'static str,
    },
    /// A joint that moves, and an axis without a direction.
    #[error(
        "the axis of joint {joint:?} is {found:?}; it must be three finite numbers, not all zero, such as \"0 0 1\""
    )]
    Axis {
        /// The joint.
        joint: String,
        /// What is written there.
        found: String,
    },
    /// A type of joint that URDF does not have.
    #[error(
        "joint {joint:?} is of type {found:?}; it must be revolute, continuous, prismatic, fixed, floating or planar"
    )]
    JointType {
        /// The joint.
        joint: String,
        /// What is written there.
        found: String,
    },
    /// Two links or two joints have the same name.
    #[error("there are two {what} called {name:?}; give each its own name")]
    Twice {
        /// Links or joints.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A joint names a link that is not there.
    #[error(
        "joint {joint:?} has the {end} link {link:?}, which is not in the URDF; correct the name or add the link"
    )]
    UnknownLink {
        /// The joint.
        joint: String,
        /// Parent or child.
        end: &'static str,
        /// What it names.
        link: String,
    },
    /// A link is the child of two joints.
    #[error(
        "link {link:?} is the child of the joints {first:?} and {second:?}; in a tree it hangs on one of them"
    )]
    TwoParents {
        /// The link.
        link: String,
        /// The joint that comes first in the document.
        first: String,
        /// The other.
        second: String,
    },
    /// Links hang on each other in a circle.
    #[error(
        "the links {links} hang on each other in a ring; a URDF is a tree, so take one of their joints out"
    )]
    Ring {
        /// Their names, from parent to child.
        links: String,
    },
    /// There are several links that hang on nothing.
    #[error(
        "{count} links hang on no joint: {links}; a tree has one root, so join the others to it by fixed joints"
    )]
    Roots {
        /// How many.
        count: usize,
        /// Their names.
        links: String,
    },
    /// There is nothing in it.
    #[error("the URDF has no links; it must have at least one")]
    NoLinks,
    /// A link that is asked for and is not there.
    #[error("the URDF has no link {link:?}; it has {known}")]
    NoLink {
        /// What was asked for.
        link: String,
        /// The links there are.
        known: String,
    },
    /// A joint with several positions lies between the root and a link that is asked for.
    #[error(
        "link {link:?} hangs on the {kind} joint {joint:?}, whose position is not one number; make it a fixed joint, \
         or take the part of the URDF below it"
    )]
    Free {
        /// What was asked for.
        link: String,
        /// Floating or planar.
        kind: &'static str,
        /// The joint.
        joint: String,
    },
    /// A joint repeats the motion of one that is not there.
    #[error(
        "joint {joint:?}, on which link {link:?} hangs, mimics {follows:?}, which is not in the URDF; correct the name or take its mimic out"
    )]
    MimicMissing {
        /// What was asked for.
        link: String,
        /// The joint that mimics.
        joint: String,
        /// What it names.
        follows: String,
    },
    /// Joints repeat the motion of each other.
    #[error(
        "link {link:?} hangs on joints that mimic each other in a ring: {joints}; one of them must move by itself"
    )]
    MimicRing {
        /// What was asked for.
        link: String,
        /// The ring.
        joints: String,
    },
    /// A joint repeats the motion of one that has none, or has several.
    #[error(
        "joint {joint:?}, on which link {link:?} hangs, mimics the {kind} joint {follows:?}, which has no position to follow; take its mimic out"
    )]
    MimicStill {
        /// What was asked for.
        link: String,
        /// The joint that mimics.
        joint: String,
        /// The joint it follows.
        follows: String,
        /// Type of that joint.
        kind: &'static str,
    },
    /// Joints that follow each other have factors whose product is out of range.
    #[error(
        "joint {joint:?}, on which link {link:?} hangs, mimics through factors or offsets that are more than {MOST_SIZE} together; correct them"
    )]
    MimicSize {
        /// What was asked for.
        link: String,
        /// The joint that mimics.
        joint: String,
    },
}
