//! A soil cut into layers along its surface, with less friction the deeper they are.
//!
//! A stress field for such layers loads deep soil less than one for a single friction angle, so that more is left of a strength that falls with stress.
//! Nothing is proven by the layers themselves: the field is held against the law afterwards.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{RegionEntry, SoilEntry};

type Point = [f64; 2];

/// Depths of the cuts below the surface, over the greatest depth of the soil.
const CUTS: [f64; 4] = [0.05, 0.12, 0.25, 0.5];
/// Stress over the weight of the soil vertically above: that of slip planes in slopes.
const STRESS: f64 = 0.8;
/// Points nearer than this part of the soil's extent are one.
const SAME: f64 = 1e-9;

/// The problem with one of its soils in layers, whose friction angles (deg) are a function of stress (Pa). `None` if its regions cannot be cut so.
pub(super) fn layered(
    description: &Description,
    soil: usize,
    friction_deg: impl Fn(f64) -> f64,
) -> Option<Description> {
    let whole = &description.soils[soil];
    let is_ours = |region: &&RegionEntry| region.soil == whole.name;
    let areas: Vec<Vec<Point>> =
        description.regions.iter().filter(is_ours).map(|region| region.polygon.clone()).collect();
    let surface = surface(&areas);
    let lowest = areas.iter().flatten().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let deepest = surface.iter().map(|p| p[1] - lowest).fold(0.0, f64::max);
    let known: Vec<Point> = areas.iter().flatten().copied().collect();
    let mut found = description.clone();
    found.soils.remove(soil);
    found.regions.retain(|region| region.soil != whole.name);
    let depths = CUTS.map(|cut| cut * deepest);
    for layer in 0..=CUTS.len() {
        let top = if layer == 0 { None } else { Some(depths[layer - 1]) };
        let bottom = depths.get(layer).copied();
        let name = format!("{} {}", whole.name, layer + 1);
        let stress_pa = 1e3 * STRESS * whole.unit_weight_kn_m3 * bottom.unwrap_or(deepest);
        found.soils.push(SoilEntry {
            name: name.clone(),
            phi_deg: Some(friction_deg(stress_pa)),
            ..whole.clone()
        });
        for area in &areas {
            let mut parts = vec![vec![area.clone()]];
            if let Some(depth) = top {
                let under = under(&surface, depth, lowest);
                parts = parts.overlay_as::<i64>(&under, OverlayRule::Intersect, FillRule::NonZero);
            }
            if let Some(depth) = bottom {
                let under = under(&surface, depth, lowest);
                parts = parts.overlay_as::<i64>(&under, OverlayRule::Difference, FillRule::NonZero);
            }
            for part in parts {
                let [ring] = &part[..] else { return None };
                let polygon: Vec<Point> = ring.iter().map(|p| snapped(*p, &known, deepest)).collect();
                found.regions.push(RegionEntry { name: None, soil: name.clone(), polygon });
            }
        }
    }
    Some(found)
}

/// The highest points of areas, from left to right.
fn surface(areas: &[Vec<Point>]) -> Vec<Point> {
    let mut places: Vec<f64> = areas.iter().flatten().map(|p| p[0]).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let edges =
        || areas.iter().flat_map(|area| (0..area.len()).map(|i| (area[i], area[(i + 1) % area.len()])));
    let mut points = Vec::new();
    for span in places.windows(2) {
        let (left, right) = (span[0], span[1]);
        let middle = f64::midpoint(left, right);
        let over =
            |(a, b): &(Point, Point)| a[0].min(b[0]) <= left && a[0].max(b[0]) >= right && a[0] != b[0];
        let at = |(a, b): (Point, Point), x: f64| a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
        let highest = edges().filter(over).max_by(|e, f| at(*e, middle).total_cmp(&at(*f, middle)));
        if let Some(edge) = highest {
            points.extend([[left, at(edge, left)], [right, at(edge, right)]]);
        }
    }
    points.dedup();
    points
}

/// What lies deeper below a surface than a depth.
fn under(surface: &[Point], depth: f64, lowest: f64) -> Vec<Vec<Vec<Point>>> {
    let (Some(first), Some(last)) = (surface.first(), surface.last()) else { return Vec::new() };
    let base = lowest - 2.0 * depth;
    // To the sides farther than any area.
    let wide = 1.0 + last[0] - first[0];
    let mut ring = vec![[first[0] - wide, base], [last[0] + wide, base], [last[0] + wide, last[1] - depth]];
    ring.extend(surface.iter().rev().map(|[x, y]| [*x, y - depth]));
    ring.push([first[0] - wide, first[1] - depth]);
    vec![vec![ring]]
}

/// A point, or the corner of the file that it is but for rounding.
fn snapped(p: Point, known: &[Point], extent: f64) -> Point {
    let is_near = |k: &&Point| (k[0] - p[0]).abs().max((k[1] - p[1]).abs()) <= SAME * extent;
    known.iter().find(is_near).copied().unwrap_or(p)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// Twice the area, by the shoelace formula.
    fn doubled(polygon: &[Point]) -> f64 {
        let n = polygon.len();
        (0..n)
            .map(|i| polygon[i][0] * polygon[(i + 1) % n][1] - polygon[i][1] * polygon[(i + 1) % n][0])
            .sum()
    }

    #[test]
    fn layers_fill_the_soil_and_follow_its_surface() {
        let sand = SoilEntry {
            name: "sand".into(),
            phi_deg: Some(30.0),
            unit_weight_kn_m3: 16.0,
            ..SoilEntry::default()
        };
        let slope = Description::slope(sand, 5.0, 30.0);
        let found = layered(&slope, 0, |pa| 40.0 - 1e-4 * pa).unwrap();
        assert_eq!(found.soils.len(), CUTS.len() + 1);
        assert!(found.soils.windows(2).all(|two| two[0].phi_deg > two[1].phi_deg));
        let area = |d: &Description| d.regions.iter().map(|r| doubled(&r.polygon).abs()).sum::<f64>();
        assert!((area(&found) / area(&slope) - 1.0).abs() < 1e-9);
        found.described().unwrap();
    }
}
