//! Joins the lines around each region in loops.

use std::collections::BTreeMap;

use super::super::super::outline::{LineUse, Outline, RegionOutline};
use super::super::super::vector::between;
use super::runs::Run;

/// The regions of an outline that has points and lines.
pub(super) fn regions(outline: &Outline, runs: &[Run], count: usize) -> Vec<RegionOutline> {
    // Around each point, the lines that leave it, counter-clockwise.
    let mut star: Vec<Vec<(f64, LineUse)>> = vec![Vec::new(); outline.points.len()];
    let mut open: Vec<BTreeMap<(usize, bool), LineUse>> = vec![BTreeMap::new(); count];
    for (line, run) in runs.iter().enumerate() {
        for (forward, region) in [(true, run.regions[0]), (false, run.regions[1])] {
            let used = LineUse { line, forward };
            let [from, to] = outline.ends(used);
            let way = between(outline.points[from], outline.points[to]);
            star[from].push((way[1].atan2(way[0]), used));
            if let Some(region) = region {
                open[region].insert((line, !forward), used);
            }
        }
    }
    star.iter_mut().for_each(|s| s.sort_by(|a, b| a.0.total_cmp(&b.0)));
    let mut place = BTreeMap::new();
    for leaving in &star {
        for (i, (_, used)) in leaving.iter().enumerate() {
            place.insert((used.line, used.forward), i);
        }
    }
    // With the region on the left, the next line is the first clockwise from the way back.
    let next = |used: LineUse| {
        let leaving = &star[outline.ends(used)[1]];
        let back = place.get(&(used.line, !used.forward)).copied().unwrap_or_default();
        leaving[(back + leaving.len() - 1) % leaving.len()].1
    };
    let mut regions = Vec::with_capacity(count);
    for mut open in open {
        let mut loops = Vec::new();
        while let Some((_, start)) = open.pop_first() {
            let mut ring = vec![start];
            let mut used = next(start);
            while open.remove(&(used.line, !used.forward)).is_some() {
                ring.push(used);
                used = next(used);
            }
            loops.push(ring);
        }
        regions.push(RegionOutline { loops });
    }
    regions
}
