use super::course::CELL_DEPTHS;
use super::expected::{Judged, Look};
use super::ratios::Ratios;
use crate::ProcessError;

/// Size of a part of the region, in depths of the plate.
const STEP: f64 = 0.1;
/// Furthest distance looked at, in depths: further away even a block up to the surface shows by little.
const FURTHEST: f64 = 4.0;

/// Where a block may be: its face ahead of the plate's lower edge and its top below the surface, in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// From and to.
    pub ahead_m: [f64; 2],
    /// From and to.
    pub top_m: [f64; 2],
}

/// All places that go with a stroke so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// The parts, near to far; empty if no block goes with the stroke.
    pub places: Vec<Place>,
    /// Whether it goes on beyond the furthest distance looked at.
    pub is_open: bool,
}

impl Region {
    /// Ends of the distances in m; `None` if it is empty.
    #[must_use]
    pub fn ahead_m(&self) -> Option<[f64; 2]> {
        ends(self.places.iter().map(|place| place.ahead_m))
    }

    /// Ends of the depths of the top in m; `None` likewise.
    #[must_use]
    pub fn top_m(&self) -> Option<[f64; 2]> {
        ends(self.places.iter().map(|place| place.top_m))
    }
}

fn ends(ranges: impl Iterator<Item = [f64; 2]>) -> Option<[f64; 2]> {
    ranges.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
}

/// All blocks that go with the looks of a stroke up to one of them, in soil with a friction angle between two in deg.
///
/// At the first look the ratio is that of the block then; at later ones it is over that at the first. Each is widened by its scatter, and a place is kept
/// if at each look there are a ratio within the bounds and one within the scatter that meet.
///
/// # Errors
/// [`ProcessError::OutOfRange`] of a friction angle without bounds, or of a look that is not there.
pub fn region(
    judged: &Judged,
    up_to: usize,
    ratios: &Ratios,
    phi_deg: [f64; 2],
) -> Result<Region, ProcessError> {
    let phi_deg = ratios.friction_angles_deg(phi_deg)?;
    let looks = judged.looks.get(..=up_to).filter(|looks| !looks.is_empty());
    let (first, last, looks) = looks.and_then(|looks| Some((looks.first()?, looks.last()?, looks))).ok_or(
        ProcessError::OutOfRange {
            what: "look",
            value: up_to as f64,
            unit: "",
            allowed: "below the number of looks",
        },
    )?;
    let step_m = STEP * last.depth_m;
    let count = |depths: f64| (0..).take_while(move |i| f64::from(*i) * STEP < depths - 1e-9);
    let part = |i: i32| [f64::from(i) * step_m, f64::from(i + 1) * step_m];
    let mut places = Vec::new();
    for ahead in count(FURTHEST) {
        for top in count(1.0) {
            let place = Place { ahead_m: part(ahead), top_m: part(top) };
            // Nobody needs a force to see what is covered by less.
            if f64::from(top + 1) * STEP <= ratios.least_top_depths() + 1e-9 {
                continue;
            }
            let at = |look: &Look| within(ratios, &phi_deg, &place, look, last);
            let before = at(first);
            if looks.iter().enumerate().all(|(i, look)| {
                let now = at(look);
                if i == 0 { meets(look, now) } else { meets(look, [now[0] / before[1], now[1] / before[0]]) }
            }) {
                places.push(place);
            }
        }
    }
    let furthest_m = FURTHEST * last.depth_m;
    let is_open = places.iter().any(|place| place.ahead_m[1] > furthest_m - 0.5 * step_m);
    Ok(Region { places, is_open })
}

/// Bounds on the ratio at an earlier look, of a block that is at a place at the last one.
fn within(ratios: &Ratios, phi_deg: &[f64], place: &Place, look: &Look, last: &Look) -> [f64; 2] {
    let further_m = last.way_m - look.way_m;
    // The look is a mean over a cell that ends there.
    let ahead_m = [place.ahead_m[0] + further_m, place.ahead_m[1] + further_m + CELL_DEPTHS * look.depth_m];
    let depths = |range_m: [f64; 2]| range_m.map(|value| value / look.depth_m);
    ratios.between(phi_deg, depths(ahead_m), depths(place.top_m))
}

/// Whether a look, with its scatter, goes with a range of ratios.
fn meets(look: &Look, [low, high]: [f64; 2]) -> bool {
    look.ratio / look.factor <= high && look.ratio * look.factor >= low
}
