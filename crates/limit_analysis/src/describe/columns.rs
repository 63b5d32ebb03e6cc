//! Vertical cuts that let stresses of soils of different unit weight, and pore pressures in units of them, be linear.
//!
//! The proof adds to each region of other unit weight a stress that starts from zero, or from that of the region above, along
//! the region's top, which must then be one straight line, or level. What follows repeats the checker's rule and asks for
//! cuts where it fails; cutting a region may bend the top of the one below, so it is asked again until it holds.

use soilctl_certificate::LineUse;

use std::collections::BTreeMap;

use super::faces::Face;
use super::ground::{Map, inside};
use super::holds::Holds;
use super::input::Description;
use super::segments::{Cut, Drawing, Owner, Segment};
use crate::vector::{Point, between};

/// A region of other unit weight, and its top: one line, or one height.
type Layer = (u64, [Point; 2]);

/// A side of a face that lies above it, and the face beyond if it is an interface.
type Top = ([Point; 2], Option<usize>);

/// Index of the face that each walk has on its left.
fn owners(faces: &[Face]) -> BTreeMap<LineUse, usize> {
    let walks = faces.iter().enumerate().flat_map(|(i, f)| f.loops.iter().flatten().map(move |w| (*w, i)));
    walks.collect()
}

/// Cuts that are needed because unit weights differ. `base` is the unit weight of the first region.
pub(super) fn weight_cuts(
    description: &Description,
    map: &Map,
    faces: &[Face],
    holds: &BTreeMap<LineUse, Holds>,
    base: f64,
) -> Vec<Segment> {
    let owner = owners(faces);
    let weight = |face: &Face| description.soils[description.soil_of(face.region)].unit_weight_kn_m3;
    // Interfaces above a face; what is held or free above it, if there are none.
    let tops = |index: usize| -> Vec<Top> {
        let (mut interfaces, mut boundaries) = (Vec::new(), Vec::new());
        for walk in faces[index].loops.iter().flatten() {
            let ends = map.walked_points(*walk);
            if ends[1][0] >= ends[0][0] {
                continue;
            }
            match owner.get(&walk.reversed()).filter(|_| !holds.contains_key(walk)) {
                Some(above) if *above == index => {}
                Some(above) => interfaces.push((ends, Some(*above))),
                None => boundaries.push((ends, None)),
            }
        }
        if interfaces.is_empty() { boundaries } else { interfaces }
    };
    let tops: Vec<Vec<Top>> = (0..faces.len()).map(tops).collect();
    let mut layers: Vec<Option<Vec<Layer>>> = vec![None; faces.len()];
    let mut cuts = Vec::new();
    for _ in 0..faces.len() {
        for (index, face) in faces.iter().enumerate() {
            let tops = &tops[index];
            let waits = |(_, above): &Top| above.is_some_and(|above| layers[above].is_none());
            if layers[index].is_some() || tops.iter().any(waits) {
                continue;
            }
            let above = |top: &Top| top.1.and_then(|above| layers[above].clone()).unwrap_or_default();
            if weight(face) == base && tops.iter().all(|top| above(top).is_empty()) {
                layers[index] = Some(Vec::new());
                continue;
            }
            // The layers that follow from one top: those above it go on, if they are as heavy, or a new one starts there.
            let followed = |top: &Top| {
                let (own, ends) = (weight(face), top.0);
                let mut layers = above(top);
                if layers.last().map_or(base.to_bits(), |last| last.0) != own.to_bits() {
                    layers.push((
                        own.to_bits(),
                        if ends[0][1] == ends[1][1] { [[0.0, ends[0][1]]; 2] } else { ends },
                    ));
                }
                layers
            };
            let first = tops.first().filter(|f| tops.iter().all(|top| followed(top) == followed(f)));
            if first.is_none() && tops.iter().any(|top| top.1.is_some()) {
                let corners = tops.iter().flat_map(|(ends, _)| *ends);
                cuts.extend(corners.filter_map(|p| downwards(map, face, p)));
            }
            layers[index] = Some(match first {
                Some(top) => followed(top),
                // From zero at the datum.
                None => vec![(weight(face).to_bits(), [[f64::INFINITY; 2]; 2])],
            });
        }
    }
    cuts
}

/// The vertical from a point of a face down to the next edge, if that is inside the face.
fn downwards(map: &Map, face: &Face, from: Point) -> Option<Segment> {
    let walks = || face.loops.iter().flatten();
    let polygon =
        |ring: &Vec<LineUse>| -> Vec<Point> { ring.iter().map(|w| map.walked_points(*w)[0]).collect() };
    let hit = |walk: &LineUse| {
        let [a, b] = map.walked_points(*walk);
        let along = between(a, b);
        let covers = a[0].min(b[0]) <= from[0] && from[0] <= a[0].max(b[0]) && along[0] != 0.0;
        let y = a[1] + along[1] * (from[0] - a[0]) / along[0];
        (covers && a != from && b != from && y < from[1]).then_some(y)
    };
    // A plate inside the face does not part it: the cut goes on below.
    let slit = |walk: &&LineUse| walks().any(|w| *w == walk.reversed());
    let y = walks().filter(|w| !slit(w)).filter_map(hit).fold(f64::NEG_INFINITY, f64::max);
    let middle = [from[0], 0.5 * (from[1] + y)];
    let within = face.loops.iter().filter(|ring| inside(&polygon(ring), middle)).count() % 2 == 1;
    // Where the vertical is there already, its middle is on an edge.
    let there = walks().any(|w| {
        let [a, b] = map.walked_points(*w);
        a[0] == from[0] && b[0] == from[0] && (a[1] < middle[1]) != (b[1] < middle[1])
    });
    (y.is_finite() && within && !there).then(|| Segment {
        ends: [from, [from[0], y]],
        owner: Owner::Cut(Cut::Weight),
        number: 0,
    })
}

/// Verticals through all corners, for soils whose pore pressure is in units of the weight above.
pub(super) fn ratio_cuts(description: &Description, drawing: &Drawing, map: &Map) -> Vec<Segment> {
    if !description.soils.iter().any(|s| s.pore_pressure_ratio > 0.0) {
        return Vec::new();
    }
    let mut x: Vec<f64> =
        map.arrangement.edges.iter().flat_map(|e| e.ends).map(|p| map.arrangement.points[p][0]).collect();
    x.sort_by(f64::total_cmp);
    x.dedup();
    let inside = x.into_iter().filter(|x| *x > drawing.low[0] && *x < drawing.high[0]);
    inside.map(|x| drawing.cut([x, drawing.high[1]], drawing.low[1], Cut::Ratio)).collect()
}

/// Weight of the soil vertically above a point over its area, in kPa.
pub(super) fn overburden(description: &Description, drawing: &Drawing, p: Point) -> f64 {
    let mut total = 0.0;
    for (region, polygon) in drawing.regions.iter().enumerate() {
        let weight = description.soils[description.soil_of(region)].unit_weight_kn_m3;
        let last = polygon.last().into_iter();
        for (a, b) in last.chain(polygon).zip(polygon) {
            if (a[0] > p[0]) != (b[0] > p[0]) {
                let y =
                    if a[1] == b[1] { a[1] } else { a[1] + (b[1] - a[1]) * (p[0] - a[0]) / (b[0] - a[0]) };
                // The surface counts, the base counts back; what is below the point does not.
                let orientation = if super::faces::area(polygon) > 0.0 { 1.0 } else { -1.0 };
                let top = if b[0] < a[0] { orientation } else { -orientation };
                total += top * weight * (y - p[1]).max(0.0);
            }
        }
    }
    total
}
