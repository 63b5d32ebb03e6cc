//! A shape without a name as a term that a model file carries.

use nalgebra::{DMatrix, DVector};
use soilctl_effects::{Covariate, EmpiricalTerm};

use crate::data::Data;
use crate::search::ScoredShape;

/// Change of ln force that is not worth a point of a table: less than forces are known to.
const FLAT: f64 = 0.002;
/// Conditions that differ by less than this part of their range are one. As conditions are told apart where shapes are looked for.
const SAME: f64 = 0.02;

/// The regressors of a shape with their coefficients and covariances, over the conditions of the strokes.
pub(crate) fn term(
    data: &Data,
    shape: &ScoredShape,
    (coefficients, covariance): (&[f64], &[Vec<f64>]),
) -> Option<EmpiricalTerm> {
    let line = |i: usize| -> Option<Vec<f64>> {
        shape.columns.iter().map(|column| column.get(i).copied()).collect()
    };
    let lines: Vec<Vec<f64>> = (0..data.len()).map(line).collect::<Option<_>>()?;
    let points: Vec<Point> = lines
        .iter()
        .enumerate()
        .filter_map(|(i, line)| {
            let recorded = |condition: Covariate| condition.recorded(&data.rows[i], &data.reference);
            let x = recorded(shape.over.on)?;
            let y = shape.over.times.map_or(Some(0.0), recorded)?;
            let change = line.iter().zip(coefficients).map(|(a, b)| a * b).sum();
            let variance: f64 = line
                .iter()
                .zip(covariance)
                .map(|(a, row)| a * row.iter().zip(line).map(|(c, b)| c * b).sum::<f64>())
                .sum();
            Some(Point { x, y, change, sd: variance.max(0.0).sqrt() })
        })
        .collect();
    let (over, at, told) = match shape.over.times {
        None => {
            let told = along(points);
            (vec![shape.over.on], vec![told.iter().map(|point| point.x).collect()], told)
        }
        Some(times) => {
            let (at, told) = corners(&points)?;
            (vec![shape.over.on, times], at.map(Vec::from).to_vec(), told)
        }
    };
    Some(EmpiricalTerm {
        over,
        at,
        ln_force: told.iter().map(|point| point.change).collect(),
        sd: told.iter().map(|point| point.sd).collect(),
        log_bayes_factor: shape.log_bayes,
    })
}

/// What a shape says of a stroke.
#[derive(Debug, Clone, Copy)]
struct Point {
    x: f64,
    y: f64,
    change: f64,
    sd: f64,
}

/// The few points of one condition between which a line is near enough.
fn along(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    let span = points.last().map_or(0.0, |last| last.x) - points.first().map_or(0.0, |first| first.x);
    let alike =
        |a: &Point, b: &Point| (a.x - b.x).abs() <= SAME * span && (a.change - b.change).abs() <= FLAT;
    let mut levels: Vec<Point> = Vec::new();
    for group in points.chunk_by(alike) {
        let mean = |of: fn(&Point) -> f64| group.iter().map(of).sum::<f64>() / group.len() as f64;
        levels.push(Point { x: mean(|p| p.x), y: 0.0, change: mean(|p| p.change), sd: mean(|p| p.sd) });
    }
    // Two strokes of one condition have one change.
    levels.dedup_by(|a, b| a.x <= b.x);
    let mut kept = vec![false; levels.len()];
    needed(&levels, 0, levels.len().saturating_sub(1), &mut kept);
    levels.into_iter().zip(kept).filter_map(|(point, kept)| kept.then_some(point)).collect()
}

/// Marks the points from `first` to `last` without which the line through the others leaves one by more than [`FLAT`] (Douglas and Peucker 1973).
fn needed(points: &[Point], first: usize, last: usize, kept: &mut [bool]) {
    for end in [first, last] {
        if let Some(kept) = kept.get_mut(end) {
            *kept = true;
        }
    }
    let off = |i: usize| {
        let (a, b, p) = (points[first], points[last], points[i]);
        (a.change + (p.x - a.x) / (b.x - a.x) * (b.change - a.change) - p.change).abs()
    };
    let farthest = (first + 1..last).max_by(|a, b| off(*a).total_cmp(&off(*b)));
    if let Some(middle) = farthest.filter(|i| off(*i) > FLAT) {
        needed(points, first, middle, kept);
        needed(points, middle, last, kept);
    }
}

/// The four corners of two conditions' ranges, by which a product of them is known everywhere.
fn corners(points: &[Point]) -> Option<([[f64; 2]; 2], Vec<Point>)> {
    let ends = |of: fn(&Point) -> f64| {
        let low = points.iter().map(of).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        (low < high).then_some([low, high])
    };
    let (xs, ys) = (ends(|p| p.x)?, ends(|p| p.y)?);
    let share = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
    let weights = DMatrix::from_fn(points.len(), 4, |i, k| {
        let (u, v) = (share(points[i].x, xs), share(points[i].y, ys));
        [(1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v][k]
    });
    let solved = |of: fn(&Point) -> f64| {
        let values = DVector::from_iterator(points.len(), points.iter().map(of));
        weights.clone().svd(true, true).solve(&values, 1e-9).ok()
    };
    let changes = solved(|p| p.change)?;
    // One regressor: its error goes with it, and the sign of the change is that of both.
    let errors = solved(|p| p.sd * p.change.signum())?;
    let told = (0..4).map(|k| Point { x: xs[k / 2], y: ys[k % 2], change: changes[k], sd: errors[k].abs() });
    Some(([xs, ys], told.collect()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;
    use crate::explanation::Dependence;

    fn data(rows: impl Iterator<Item = (f64, f64)>) -> Data {
        let row = |(alpha_deg, depth_m)| StrokeRow {
            alpha_deg,
            depth_m,
            width_m: 0.1,
            force_n: 5.0,
            ..StrokeRow::default()
        };
        Data::new("t", rows.map(row).collect(), Campaign::default()).unwrap()
    }

    fn told(data: &Data, over: Dependence, columns: &[Vec<f64>], coefficients: &[f64]) -> EmpiricalTerm {
        let shape = ScoredShape { over, columns: columns.to_vec(), log_bayes: 9.0 };
        let n = coefficients.len();
        let covariance: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|j| if i == j { 1e-4 } else { 0.0 }).collect()).collect();
        let term = term(data, &shape, (coefficients, &covariance)).unwrap();
        term.check("t").unwrap();
        for (i, row) in data.rows.iter().enumerate() {
            let exact: f64 = columns.iter().zip(coefficients).map(|(column, c)| column[i] * c).sum();
            assert!((term.ln_factor(row, &data.reference) - exact).abs() < 1.5 * FLAT, "{i}");
        }
        term
    }

    /// A line needs two points, a parabola more, and a step four: two at its sides, close to each other.
    #[test]
    fn a_shape_over_one_condition_is_told_by_few_points() {
        let angles: Vec<f64> = (0..31).map(|i| 70.0 + f64::from(i)).collect();
        let data = data(angles.iter().map(|alpha| (*alpha, 0.025)));
        let over = Dependence::from(Covariate::ToolAngle);
        let line: Vec<f64> = angles.iter().map(|a| (a - 85.0) / 8.0).collect();
        let square: Vec<f64> = line.iter().map(|x| x * x - 1.0).collect();
        let step: Vec<f64> = angles.iter().map(|a| if *a < 82.0 { -1.0 } else { 1.0 }).collect();
        assert_eq!(told(&data, over, std::slice::from_ref(&line), &[0.1]).ln_force.len(), 2);
        assert!((4..20).contains(&told(&data, over, &[line, square], &[0.1, -0.05]).ln_force.len()));
        let step = told(&data, over, &[step], &[0.08]);
        assert_eq!((step.at[0].as_slice(), step.ln_force.len()), (&[70.0, 81.0, 82.0, 100.0][..], 4));
        assert!(step.sd.iter().all(|sd| (sd - 0.01).abs() < 1e-12));
    }

    #[test]
    fn a_product_of_two_is_told_by_its_corners_also_where_no_stroke_is() {
        let at = [(70.0, 0.02), (80.0, 0.03), (100.0, 0.02), (90.0, 0.04), (75.0, 0.04)];
        let product = |(a, d): (f64, f64)| (a - 85.0) / 10.0 * (d - 0.03) / 0.01;
        let data = data(at.into_iter());
        let over = Dependence { on: Covariate::ToolAngle, times: Some(Covariate::Depth) };
        let term = told(&data, over, &[at.iter().map(|p| product(*p)).collect()], &[0.1]);
        let corner = term.at_values(&|c| Some(if c == Covariate::Depth { 0.04 } else { 100.0 }));
        assert!((corner - 0.1 * product((100.0, 0.04))).abs() < 1e-9);
    }
}
