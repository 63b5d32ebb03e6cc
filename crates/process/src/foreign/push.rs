//! The phases of a contact by where the edge goes: insertion, seating, push, hold and pull-out.

use std::fmt;
use std::ops::Range;

use soilctl_stats::{median, noise, quantile};

use super::survey::Block;

/// A push is looked for where the edge is at least this share of its depth below the surface.
const DEEP: f64 = 0.6;
/// Depth of a contact: this quantile of the depths, since encoders jump.
const LOWEST: f64 = 0.95;
/// A plate that goes along the ground so many times further than down is pushed, otherwise it is being inserted.
const LEVEL: f64 = 2.0;
/// Way up or down within `SETTLE_S` that is no insertion or pull-out any more, as a share of the depth; at least `SETTLE_M`.
const SETTLE: f64 = 0.02;
const SETTLE_M: f64 = 3e-4;
const SETTLE_S: f64 = 0.3;
/// Of the rest before a push so much is kept, in s: the force that an insertion left.
const REST_S: f64 = 2.0;
/// Least distance along the ground that is motion, in m; and in standard deviations of the position's noise.
const MOTION_M: f64 = 2e-5;
const MOTION_SD: f64 = 4.0;

/// A push of the plate along the ground.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Push {
    /// Blocks from the seated plate to the end of its way.
    pub(crate) blocks: Range<usize>,
    /// When it begins to move, in s.
    pub(crate) moves_s: f64,
    /// Unit vector along the ground.
    pub(crate) direction: [f64; 2],
    /// Way along the ground in m.
    pub(crate) travel_m: f64,
    /// Depth where it begins in m.
    pub(crate) depth_m: f64,
}

/// What is known of where the edge went in a contact without a push.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NoPush {
    pub(crate) why: Why,
    /// Greatest depth in m; negative above the surface.
    pub(crate) depth_m: f64,
    /// Greatest way along the ground in m, where it was looked for.
    pub(crate) travel_m: f64,
}

/// Why there is no push.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Why {
    /// No joint states.
    NoPosture,
    /// The edge stays above the surface.
    Above,
    /// It goes down and up, but hardly along the ground.
    NoTravel,
}

impl fmt::Display for NoPush {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { why, depth_m, travel_m } = *self;
        match why {
            Why::NoPosture => {
                write!(out, "there are no joint states while it lasts, so nobody knows where the plate was")
            }
            Why::Above => write!(
                out,
                "the edge stays {:.1} mm above the surface as given; check --surface-z and the plate's frame, or it touched something else",
                -depth_m * 1e3
            ),
            Why::NoTravel => write!(
                out,
                "nothing travelled: the plate goes {:.1} mm deep and {:.1} mm along the ground, a press and no stroke",
                depth_m * 1e3,
                travel_m * 1e3
            ),
        }
    }
}

/// Where the edge was in a block.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    block: usize,
    t_s: f64,
    edge_m: [f64; 3],
}

/// The push in some blocks; `surface_z_m` is the height of the soil, `least_m` the way from which on it is one.
pub(crate) fn push(
    blocks: &[Block],
    range: Range<usize>,
    surface_z_m: f64,
    least_m: f64,
) -> Result<Push, NoPush> {
    let place = |block: usize| {
        let at = blocks.get(block)?;
        Some(Place { block, t_s: at.t_s, edge_m: at.posture?.tip_m })
    };
    let places: Vec<Place> = range.filter_map(place).collect();
    let none = |why, depth_m, travel_m| NoPush { why, depth_m, travel_m };
    if places.len() < 3 {
        return Err(none(Why::NoPosture, 0.0, 0.0));
    }
    let depth = |place: &Place| surface_z_m - place.edge_m[2];
    let mut depths: Vec<f64> = places.iter().map(depth).filter(|depth| *depth > 0.0).collect();
    depths.sort_by(f64::total_cmp);
    let Some(lowest) = quantile(&depths, LOWEST) else {
        let closest = places.iter().map(depth).fold(f64::NEG_INFINITY, f64::max);
        return Err(none(Why::Above, closest, 0.0));
    };
    let deep = |place: &Place| depth(place) >= DEEP * lowest;
    let first = places.iter().position(deep).unwrap_or(0);
    let last = places.iter().rposition(deep).map_or(places.len(), |last| last + 1);
    let places = settled(&places[first..last], lowest);
    let jitter = |axis: usize| noise(&places.iter().map(|place| place.edge_m[axis]).collect::<Vec<_>>());
    let motion_m = MOTION_M.max(MOTION_SD * jitter(0).max(jitter(1)));
    let early = &places[..(places.len() / 50).clamp(1, 10).min(places.len())];
    let start = [0, 1].map(|i| median(&mut early.iter().map(|place| place.edge_m[i]).collect::<Vec<_>>()));
    let way = |place: &Place| (place.edge_m[0] - start[0]).hypot(place.edge_m[1] - start[1]);
    let Some(far) = (0..places.len()).max_by(|a, b| way(&places[*a]).total_cmp(&way(&places[*b]))) else {
        return Err(none(Why::NoTravel, lowest, 0.0));
    };
    let travel_m = way(&places[far]);
    if travel_m.is_nan() || travel_m < least_m.max(2.0 * motion_m) {
        return Err(none(Why::NoTravel, lowest, travel_m));
    }
    let moves = places[..far].iter().rposition(|place| way(place) < motion_m).unwrap_or(0);
    // Afterwards it rests.
    let end = places[..far].iter().position(|place| way(place) > travel_m - motion_m).unwrap_or(far);
    let moves_s = places[moves].t_s;
    let from = places[..=moves].partition_point(|place| place.t_s < moves_s - REST_S);
    let direction = [0, 1].map(|i| (places[far].edge_m[i] - start[i]) / travel_m);
    Ok(Push {
        blocks: places[from].block..places[end].block + 1,
        moves_s,
        direction,
        travel_m,
        depth_m: depth(&places[from]),
    })
}

/// Without the insertion at the beginning and the pull-out at the end: times at which the edge goes down or up, and not mostly
/// along the ground.
fn settled(places: &[Place], lowest_m: f64) -> &[Place] {
    let tolerance_m = SETTLE_M.max(SETTLE * lowest_m);
    let rests = |a: &Place, b: &Place| {
        let across = (b.edge_m[2] - a.edge_m[2]).abs();
        let along = (b.edge_m[0] - a.edge_m[0]).hypot(b.edge_m[1] - a.edge_m[1]);
        across < tolerance_m || along > LEVEL * across
    };
    let first = (0..places.len()).find(|k| {
        let ahead = places[*k..].iter().find(|place| place.t_s >= places[*k].t_s + SETTLE_S);
        ahead.or(places.last()).is_some_and(|ahead| rests(&places[*k], ahead))
    });
    let first = first.unwrap_or(0);
    let last = (first..places.len()).rev().find(|k| {
        let before = places[first..*k].iter().rev().find(|place| place.t_s <= places[*k].t_s - SETTLE_S);
        before.or(places.get(first)).is_some_and(|before| rests(before, &places[*k]))
    });
    &places[first..last.map_or(places.len(), |last| last + 1)]
}
