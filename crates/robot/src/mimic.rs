//! Which joint moves which. Joints may follow joints that follow others; each is resolved once.

use std::collections::BTreeMap;

use crate::RobotError;
use crate::model::Joint;
use crate::numbers::are_sound;
use crate::words::{cut, list};

/// What a joint's position follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Drive {
    /// It has none, or several: fixed, floating and planar joints.
    None,
    /// `multiplier * position + offset` of the joint `source`, which moves by itself.
    By { source: usize, multiplier: f64, offset: f64 },
    /// It follows something that has no position.
    Broken(Fault),
}

/// Why a joint cannot follow, with the joint at which it breaks off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fault {
    Missing(usize),
    Still(usize),
    Ring(usize),
    Size(usize),
}

/// What drives each joint, in time in proportion to their number.
pub(crate) fn drives(joints: &[Joint], by_name: &BTreeMap<String, usize>) -> Vec<Drive> {
    let mut known: Vec<Option<Drive>> = vec![None; joints.len()];
    let mut on_path = vec![false; joints.len()];
    let mut path = Vec::new();
    for first in 0..joints.len() {
        let mut end = follow(first, joints, by_name, &known, &mut on_path, &mut path);
        // Back to the first, each by the one that it follows.
        while let Some(number) = path.pop() {
            end = behind(number, joints, end);
            if let Some(place) = known.get_mut(number) {
                *place = Some(end);
            }
            if let Some(place) = on_path.get_mut(number) {
                *place = false;
            }
        }
    }
    known.into_iter().map(|drive| drive.unwrap_or(Drive::None)).collect()
}

/// Goes from a joint to what it follows, until that is known; `path` has the joints on the way that are not.
fn follow(
    first: usize,
    joints: &[Joint],
    by_name: &BTreeMap<String, usize>,
    known: &[Option<Drive>],
    on_path: &mut [bool],
    path: &mut Vec<usize>,
) -> Drive {
    let mut number = first;
    loop {
        if let Some(Some(drive)) = known.get(number) {
            return *drive;
        }
        let (Some(joint), Some(seen)) = (joints.get(number), on_path.get_mut(number)) else {
            return Drive::None;
        };
        if std::mem::replace(seen, true) {
            return Drive::Broken(Fault::Ring(number));
        }
        path.push(number);
        let Some(mimic) = &joint.mimic else {
            // What it follows is itself, if it has a position.
            return match joint.kind.has_position() {
                true => Drive::By { source: number, multiplier: 1.0, offset: 0.0 },
                false => Drive::None,
            };
        };
        match by_name.get(&mimic.joint) {
            Some(next) => number = *next,
            None => return Drive::Broken(Fault::Missing(number)),
        }
    }
}

/// What drives a joint whose leader is driven so.
fn behind(number: usize, joints: &[Joint], leader: Drive) -> Drive {
    let Some(mimic) = joints.get(number).and_then(|joint| joint.mimic.as_ref()) else { return leader };
    match leader {
        Drive::None => Drive::Broken(Fault::Still(number)),
        Drive::By { source, multiplier, offset } => {
            let (multiplier, offset) =
                (mimic.multiplier * multiplier, mimic.multiplier * offset + mimic.offset);
            match are_sound(&[multiplier, offset]) {
                true => Drive::By { source, multiplier, offset },
                false => Drive::Broken(Fault::Size(number)),
            }
        }
        Drive::Broken(_) => leader,
    }
}

/// In words, for the link that is asked for.
pub(crate) fn fault(
    fault: Fault,
    link: &str,
    joints: &[Joint],
    by_name: &BTreeMap<String, usize>,
) -> RobotError {
    let link = cut(link);
    let name = |number: usize| joints.get(number).map_or_else(String::new, |joint| cut(&joint.name));
    let follows = |number: &usize| joints.get(*number)?.mimic.as_ref().map(|mimic| mimic.joint.as_str());
    match fault {
        Fault::Missing(number) => {
            let follows = cut(follows(&number).unwrap_or_default());
            RobotError::MimicMissing { link, joint: name(number), follows }
        }
        Fault::Still(number) => {
            let follows = follows(&number).unwrap_or_default();
            let kind =
                by_name.get(follows).and_then(|place| joints.get(*place)).map_or("", |j| j.kind.word());
            RobotError::MimicStill { link, joint: name(number), follows: cut(follows), kind }
        }
        Fault::Ring(number) => {
            let next = |number: &usize| follows(number).and_then(|name| by_name.get(name).copied());
            let others = std::iter::successors(next(&number), next).take_while(|other| *other != number);
            let ring = std::iter::once(number).chain(others).filter_map(|number| joints.get(number));
            RobotError::MimicRing { link, joints: list(ring.map(|joint| joint.name.as_str())) }
        }
        Fault::Size(number) => RobotError::MimicSize { link, joint: name(number) },
    }
}
