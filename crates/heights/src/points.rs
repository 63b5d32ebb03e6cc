//! Clouds of points over a grid.

use soilctl_stats::median;

use crate::{Grid, HeightMap, HeightsError};

/// Points a cell that a grid is made for if nobody says its cell: enough for a median that a stray point does not move.
const POINTS_A_CELL: f64 = 5.0;

/// The most that a point may be off its node, in steps.
const OFF_NODE: f64 = 0.1;

/// A map of the medians of the points in each cell, and the median of how many there are in a cell that has some.
///
/// # Errors
/// Those of [`HeightMap::new`].
pub(crate) fn medians(grid: Grid, points: &[[f64; 3]]) -> Result<(HeightMap, usize), HeightsError> {
    let mut inside: Vec<(usize, f64)> =
        points.iter().filter_map(|&[x, y, z]| Some((grid.cell_of([x, y])?, z))).collect();
    inside.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut heights = vec![None; grid.cells()];
    let mut counts = Vec::new();
    for of_cell in inside.chunk_by(|a, b| a.0 == b.0) {
        let mut values: Vec<f64> = of_cell.iter().map(|(_, z)| *z).collect();
        counts.push(values.len() as f64);
        if let Some(height) = of_cell.first().and_then(|(cell, _)| heights.get_mut(*cell)) {
            *height = Some(median(&mut values));
        }
    }
    Ok((HeightMap::new(grid, heights)?, median(&mut counts) as usize))
}

/// A grid along the axes that holds all points, with cells of this side (m), or of one that has some points in each.
///
/// # Errors
/// Those of [`Grid::new`], among them too many cells; [`HeightsError::Format`] if there are no points, or all are on a line.
pub(crate) fn grid_over(file: &str, points: &[[f64; 3]], cell_m: Option<f64>) -> Result<Grid, HeightsError> {
    let [x, y] = [0, 1].map(|axis| {
        points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[axis]), high.max(point[axis])]
        })
    });
    let sides = [x[1] - x[0], y[1] - y[0]];
    if !(sides[0] > 0.0 && sides[1] > 0.0) {
        let reason = format!("it has {} points near the plate, and they span no area", points.len());
        return Err(HeightsError::format(file, reason));
    }
    let cell = cell_m
        .unwrap_or_else(|| round_up((POINTS_A_CELL * sides[0] * sides[1] / points.len() as f64).sqrt()));
    // Cells begin at multiples of their side, so that clouds of one ground come to the same cells.
    let first = [x[0], y[0]].map(|low| ((low / cell).floor() + 0.5) * cell);
    let count = |low: f64, high: f64| ((high - low) / cell).round() as usize + 1;
    Grid::new([count(first[0], x[1]), count(first[1], y[1])], first, [cell, 0.0], [0.0, cell])
}

/// The next number with two digits.
fn round_up(value: f64) -> f64 {
    let digit = libm::pow(10.0, libm::log10(value).floor() - 1.0);
    (value / digit).ceil() * digit
}

/// The map of points that stand on a grid along the axes, each on a node of its own; `None` if they do not.
///
/// # Errors
/// Those of [`HeightMap::new`].
pub(crate) fn on_nodes(points: &[[f64; 3]]) -> Result<Option<HeightMap>, HeightsError> {
    let axes = [0, 1].map(|axis| Axis::of(points, axis));
    let [Some(x), Some(y)] = axes else { return Ok(None) };
    // Few digits make gaps uneven, so that the least of them is wrong; then all nodes have points.
    for [x, y] in [[x.by_gap, y.by_gap], [x.by_number, y.by_number]] {
        let (columns, rows) = (x.count + 1, y.count + 1);
        // Points anywhere would need a far finer grid.
        if columns.saturating_mul(rows) > points.len().saturating_mul(4) {
            continue;
        }
        let grid = Grid::new([columns, rows], [x.first, y.first], [x.step, 0.0], [0.0, y.step])?;
        if let Some(heights) = taken(&grid, points) {
            return HeightMap::new(grid, heights).map(Some);
        }
    }
    Ok(None)
}

/// Heights of the nodes, if every point is at one, and no two are at the same.
fn taken(grid: &Grid, points: &[[f64; 3]]) -> Option<Vec<Option<f64>>> {
    let mut heights = vec![None; grid.cells()];
    for &[x, y, z] in points {
        let [i, j] = grid.at([x, y]);
        let off = (i - i.round()).abs().max((j - j.round()).abs());
        let height = grid.cell_of([x, y]).and_then(|cell| heights.get_mut(cell))?;
        if off > OFF_NODE || height.replace(z).is_some() {
            return None;
        }
    }
    Some(heights)
}

/// Nodes along an axis: the first, and how many steps follow.
#[derive(Debug, Clone, Copy)]
struct Nodes {
    first: f64,
    step: f64,
    count: usize,
}

/// What nodes may be by the coordinates that points have.
struct Axis {
    by_gap: Nodes,
    by_number: Nodes,
}

impl Axis {
    fn of(points: &[[f64; 3]], axis: usize) -> Option<Self> {
        let mut values: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (*values.first()?, *values.last()?);
        let span = last - first;
        // What is nearer than this is one coordinate.
        let same = 1e-6 * span;
        let gaps =
            values.windows(2).filter_map(|pair| Some(pair.last()? - pair.first()?)).filter(|gap| *gap > same);
        let (least, number) =
            gaps.fold((f64::INFINITY, 0_usize), |(least, number), gap| (f64::min(least, gap), number + 1));
        let count = (span / least).round();
        if number == 0 || count >= points.len() as f64 {
            return None;
        }
        let nodes = |count: usize| Nodes { first, step: span / count as f64, count };
        Some(Self { by_gap: nodes(count as usize), by_number: nodes(number) })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn points_on_nodes_are_a_grid_and_others_are_not() {
        let mut points = Vec::new();
        for j in 0..4 {
            for i in 0..6 {
                points.push([1.0 + 0.1 * f64::from(i), 2.0 + 0.05 * f64::from(j), f64::from(i * j)]);
            }
        }
        points.remove(7);
        points.reverse();
        let map = on_nodes(&points).unwrap().unwrap();
        assert_eq!(map.grid().size(), [6, 4]);
        assert_eq!(map.seen(), 23);
        assert_eq!(map.height_m([1.5, 2.15]), Some(15.0));
        assert_eq!(map.heights_m()[7], None);
        let twice = [points.clone(), vec![points[3]]].concat();
        assert!(on_nodes(&twice).unwrap().is_none());
        points[5][0] += 0.03;
        assert!(on_nodes(&points).unwrap().is_none());
        assert!(on_nodes(&points[..1]).unwrap().is_none() && on_nodes(&[]).unwrap().is_none());
    }

    /// Steps of a third of a cm, written to the tenth of a mm.
    #[test]
    fn coordinates_may_be_rounded() {
        let mut points = Vec::new();
        for j in 0..50 {
            for i in 0..60 {
                let [x, y] = [i, j].map(|k| (1e4 * f64::from(k) / 300.0).round() / 1e4);
                points.push([x, y, f64::from(i + j)]);
            }
        }
        let map = on_nodes(&points).unwrap().unwrap();
        assert_eq!((map.grid().size(), map.seen()), ([60, 50], 3000));
        assert_eq!(map.heights_m()[61], Some(2.0));
    }

    #[test]
    fn a_stray_point_does_not_move_a_cell() {
        let mut points: Vec<[f64; 3]> = (0..400)
            .map(|i| [0.05 * f64::from(i % 20) + 0.02, 0.05 * f64::from(i / 20) + 0.02, 0.25])
            .collect();
        points[17][2] = 5.0;
        let grid = grid_over("f", &points, Some(0.2)).unwrap();
        let (map, count) = medians(grid, &points).unwrap();
        assert!(map.heights_m().iter().flatten().all(|z| *z == 0.25));
        assert_eq!((grid.size(), count), ([5, 5], 16));
        // By itself: five points a cell, and two digits.
        assert!((grid_over("f", &points, None).unwrap().cell_m() - 0.11).abs() < 1e-12);
        assert!(grid_over("f", &points[..1], None).is_err());
        assert!(grid_over("f", &[], None).is_err());
    }
}
