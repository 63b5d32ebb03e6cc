//! Rows of bars: what the soil that goes on between them hands to each piece.

use soilctl_certificate::{Grip, LineUse};

use super::check::{Range, number};
use super::error::DescriptionError;
use super::ground::Map;
use super::parts::MemberEntry;
use crate::vector::{between, distance, dot};

/// Nobody's bars bear more.
const PULLOUT: Range = Range { low: 0.0, high: 1e6, words: "0 to 1e6 kN/m2" };

/// Least grip at one end over that at the other: where it vanished, rounding would ask for more than there is.
const LEAST: f64 = 0.01;

/// Where the grip begins nearer than this fraction of a line to one of its ends, it begins there.
const NEAR: f64 = 1e-6;

/// Checks the pullout resistance of a member, if it has any.
pub(super) fn check(entry: &str, member: &MemberEntry) -> Result<(), DescriptionError> {
    let wrong = |problem: &str| Err(DescriptionError::entry(entry, problem));
    let Some(pullout) = member.pullout_kn_per_m2 else {
        return if member.free_length_m == 0.0 {
            Ok(())
        } else {
            wrong("free_length_m goes with pullout_kn_per_m2, which the rest of its length has")
        };
    };
    for value in pullout.ends() {
        number(entry, "pullout_kn_per_m2", value, PULLOUT)?;
    }
    let [from, to] = pullout.ends();
    if from.min(to) < LEAST * from.max(to) {
        return wrong(
            "pullout_kn_per_m2 at one end is less than a hundredth of that at the other, which no proof covers; give it that much, or a free_length_m",
        );
    }
    let free = Range { low: 0.0, high: member.length_m(), words: "0 to the length of the member in m" };
    number(entry, "free_length_m", member.free_length_m, free)?;
    if member.bends() {
        return wrong("a beam parts the soil and has faces: give bond_factor, and no pullout_kn_per_m2");
    }
    if member.bond_factor != 1.0 {
        return wrong(
            "it has both bond_factor, of a sheet that parts the soil, and pullout_kn_per_m2, of bars between which it goes on; keep one",
        );
    }
    Ok(())
}

/// What the soil hands to a row of bars along the lines of its path.
pub(super) fn grips(
    member: &MemberEntry,
    path: &[LineUse],
    map: &Map,
    stress: impl Fn(f64) -> f64,
) -> Option<Vec<Grip>> {
    let [from, to] = member.pullout_kn_per_m2?.ends();
    let (length, start) = (member.length_m(), *member.line.first()?);
    let way = between(start, *member.line.get(1)?);
    let grip = |walk: &LineUse| {
        let [p, q] = map.walked_points(*walk);
        let at = [p, q].map(|p| dot(between(start, p), way) / length);
        let mut resistance = at.map(|at| stress(from + (to - from) * (at / length).clamp(0.0, 1.0)));
        let first = ((member.free_length_m - at[0]) / distance(p, q)).clamp(0.0, 1.0);
        let first = if first < NEAR { 0.0 } else { first };
        if first > 1.0 - NEAR {
            return Grip { resistance: [0.0; 2], part: [0.0, 1.0] };
        }
        if walk.forward {
            return Grip { resistance, part: [first, 1.0] };
        }
        resistance.reverse();
        Grip { resistance, part: [0.0, 1.0 - first] }
    };
    Some(path.iter().map(grip).collect())
}
