//! Links and joints as a tree. Every check takes time in proportion to their number.

use std::collections::BTreeMap;

use crate::RobotError;
use crate::model::{Joint, Link};
use crate::read::Unplaced;
use crate::words::{cut, list};

/// How links hang together.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    /// Places of links by their names.
    pub(crate) by_name: BTreeMap<String, usize>,
    /// The joint that each link hangs on; `None` for the root.
    pub(crate) above: Vec<Option<usize>>,
    /// All links, each after the one it hangs on.
    pub(crate) outwards: Vec<usize>,
}

/// Finds the links that joints name, and checks that they make one tree.
pub(crate) fn grow(links: &[Link], unplaced: Vec<Unplaced>) -> Result<(Vec<Joint>, Tree), RobotError> {
    if links.is_empty() {
        return Err(RobotError::NoLinks);
    }
    let by_name = places("links", links.iter().map(|link| link.name.as_str()))?;
    let joints = place(&by_name, unplaced)?;
    let above = hang(links, &joints)?;
    let outwards = walk(links, &joints, &above)?;
    Ok((joints, Tree { by_name, above, outwards }))
}

/// Where each name is; no name may be there twice.
pub(crate) fn places<'a>(
    what: &'static str,
    names: impl Iterator<Item = &'a str>,
) -> Result<BTreeMap<String, usize>, RobotError> {
    let mut places = BTreeMap::new();
    for (place, name) in names.enumerate() {
        if places.insert(name.to_owned(), place).is_some() {
            return Err(RobotError::Twice { what, name: cut(name) });
        }
    }
    Ok(places)
}

fn place(links: &BTreeMap<String, usize>, unplaced: Vec<Unplaced>) -> Result<Vec<Joint>, RobotError> {
    let found = |joint: &Joint, end, name: &String| {
        links.get(name).copied().ok_or_else(|| RobotError::UnknownLink {
            joint: cut(&joint.name),
            end,
            link: cut(name),
        })
    };
    unplaced
        .into_iter()
        .map(|Unplaced { joint, parent, child }| {
            let (parent, child) = (found(&joint, "parent", &parent)?, found(&joint, "child", &child)?);
            Ok(Joint { parent, child, ..joint })
        })
        .collect()
}

/// The joint above each link.
fn hang(links: &[Link], joints: &[Joint]) -> Result<Vec<Option<usize>>, RobotError> {
    let mut above: Vec<Option<usize>> = vec![None; links.len()];
    for (number, joint) in joints.iter().enumerate() {
        let Some(place) = above.get_mut(joint.child) else { continue };
        if let Some(first) = place.and_then(|first| joints.get(first)) {
            return Err(RobotError::TwoParents {
                link: links.get(joint.child).map_or_else(String::new, |link| cut(&link.name)),
                first: cut(&first.name),
                second: cut(&joint.name),
            });
        }
        *place = Some(number);
    }
    Ok(above)
}

/// All links from the root outwards.
fn walk(links: &[Link], joints: &[Joint], above: &[Option<usize>]) -> Result<Vec<usize>, RobotError> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); links.len()];
    for joint in joints {
        if let Some(children) = children.get_mut(joint.parent) {
            children.push(joint.child);
        }
    }
    let mut outwards: Vec<usize> = (0..links.len()).filter(|link| above.get(*link) == Some(&None)).collect();
    let roots = outwards.len();
    let mut reached = vec![false; links.len()];
    let mut next = 0;
    while let Some(&link) = outwards.get(next) {
        if let Some(reached) = reached.get_mut(link) {
            *reached = true;
        }
        outwards.extend(children.get(link).into_iter().flatten());
        next += 1;
    }
    let names = |places: &[usize]| {
        list(places.iter().filter_map(|place| links.get(*place)).map(|link| link.name.as_str()))
    };
    if let Some(lost) = reached.iter().position(|reached| !reached) {
        return Err(RobotError::Ring { links: names(&ring(lost, joints, above)) });
    }
    if roots > 1 {
        let links = names(outwards.get(..roots).unwrap_or_default());
        return Err(RobotError::Roots { count: roots, links });
    }
    Ok(outwards)
}

/// The ring that is above a link which no root reaches, from parent to child.
fn ring(lost: usize, joints: &[Joint], above: &[Option<usize>]) -> Vec<usize> {
    let parent =
        |link: &usize| above.get(*link).copied().flatten().and_then(|j| joints.get(j)).map(|j| j.parent);
    let mut seen = vec![false; above.len()];
    let entered = std::iter::successors(Some(lost), parent)
        .find(|link| seen.get_mut(*link).is_none_or(|seen| std::mem::replace(seen, true)));
    let Some(entered) = entered else { return Vec::new() };
    let mut ring = vec![entered];
    ring.extend(std::iter::successors(parent(&entered), parent).take_while(|link| *link != entered));
    ring.reverse();
    ring
}
