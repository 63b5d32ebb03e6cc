//! Shapes without a name, over covariates and pairs of them, so that what is not in the catalogue has a voice.

use soilctl_effects::{Covariate, Effect};

use crate::data::Data;
use crate::explanation::Dependence;

/// A recorded condition of the strokes.
#[derive(Debug, Clone)]
pub(crate) struct Condition {
    pub(crate) covariate: Covariate,
    /// Value by stroke; strokes without one take the mean.
    pub(crate) values: Vec<f64>,
    /// Level by stroke, if there are few different values.
    pub(crate) levels: Option<Vec<usize>>,
}

/// A shape over one covariate or two.
#[derive(Debug, Clone)]
pub(crate) struct Generic {
    pub(crate) over: Dependence,
    /// Regressors of unit root mean square.
    pub(crate) columns: Vec<Vec<f64>>,
}

/// Different values of a condition up to which each has a level of its own. Empirical: designs have two to six.
const MOST_LEVELS: usize = 6;

/// The conditions that vary in a campaign.
pub(crate) fn conditions(data: &Data) -> Vec<Condition> {
    let cells = |covariate: Covariate| match covariate {
        Covariate::Batch => data.batch.iter().map(|&b| Some(b as f64)).collect(),
        of_row => data.rows.iter().map(|row| of_row.of(row)).collect(),
    };
    Covariate::ALL.into_iter().filter_map(|covariate| condition(covariate, cells(covariate))).collect()
}

/// Whether a recorded condition is not always the same.
pub(crate) fn varies(data: &Data, covariate: Covariate) -> bool {
    conditions(data).iter().any(|condition| condition.covariate == covariate)
}

fn condition(covariate: Covariate, cells: Vec<Option<f64>>) -> Option<Condition> {
    let known: Vec<f64> = cells.iter().flatten().copied().collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let mut distinct = known;
    distinct.sort_by(f64::total_cmp);
    let span = distinct.last()? - distinct.first()?;
    if span <= 1e-9 * mean.abs().max(1e-9) {
        return None;
    }
    distinct.dedup_by(|a, b| (*a - *b).abs() <= 0.02 * span);
    let values: Vec<f64> = cells.iter().map(|cell| cell.unwrap_or(mean)).collect();
    let levels = (distinct.len() <= MOST_LEVELS).then(|| {
        values
            .iter()
            .map(|value| {
                let nearest = distinct
                    .iter()
                    .enumerate()
                    .min_by(|a, b| (a.1 - value).abs().total_cmp(&(b.1 - value).abs()));
                nearest.map_or(0, |(i, _)| i)
            })
            .collect()
    });
    Some(Condition { covariate, values, levels })
}

/// 1 where a stroke has a level, 0 elsewhere.
pub(crate) fn indicator(levels: &[usize], level: usize) -> Vec<f64> {
    levels.iter().map(|&of| f64::from(u8::from(of == level))).collect()
}

/// Shifted to mean 0 and scaled to root mean square 1; `None` if nothing is left.
pub(crate) fn standard(values: &[f64]) -> Option<Vec<f64>> {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let rms = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    let least = 1e-9 * values.iter().fold(1e-9_f64, |most, x| most.max(x.abs()));
    (rms > least).then(|| values.iter().map(|x| (x - mean) / rms).collect())
}

/// All shapes of a campaign.
pub(crate) fn shapes(data: &Data) -> Vec<Generic> {
    let found = conditions(data);
    let mut shapes = Vec::new();
    for c in &found {
        let Some(linear) = standard(&c.values) else { continue };
        let square: Vec<f64> = linear.iter().map(|x| x * x).collect();
        let over = c.covariate.into();
        shapes.push(Generic { over, columns: vec![linear.clone()] });
        if c.covariate == Covariate::Order {
            shapes.extend(of_order(c).map(|column| Generic { over, columns: vec![column] }));
        }
        let few =
            c.levels.as_ref().map_or(usize::MAX, |levels| levels.iter().max().map_or(1, |last| last + 1));
        if few > 2 {
            if let Some(square) = without(&square, &linear) {
                shapes.push(Generic { over, columns: vec![square.clone()] });
                shapes.push(Generic { over, columns: vec![linear.clone(), square] });
            }
            let steps = quantiles(c, 4).into_iter().filter_map(|at| step(c, at));
            shapes.extend(steps.map(|column| Generic { over, columns: vec![column] }));
        }
        if let Some(levels) = c.levels.as_ref().filter(|_| few > 2) {
            let columns = (0..few).filter_map(|level| standard(&indicator(levels, level)));
            shapes.push(Generic { over, columns: columns.collect() });
        } else if few == usize::MAX {
            shapes.extend(waves(c).map(|columns| Generic { over, columns }));
        }
    }
    if data.batches > MOST_LEVELS {
        // Batches that scatter more than preparations do.
        let columns = (0..data.batches).filter_map(|batch| standard(&indicator(&data.batch, batch)));
        shapes.push(Generic { over: Covariate::Batch.into(), columns: columns.collect() });
    }
    for (i, a) in found.iter().enumerate() {
        for b in &found[i + 1..] {
            let (Some(x), Some(y)) = (standard(&a.values), standard(&b.values)) else { continue };
            let product: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x * y).collect();
            let Some(left) = without(&product, &x).and_then(|p| without(&p, &y)) else { continue };
            let over = Dependence { on: a.covariate, times: Some(b.covariate) };
            shapes.push(Generic { over, columns: vec![left] });
        }
    }
    shapes
}

/// What is left of a regressor after another (standardised) is taken out.
fn without(values: &[f64], other: &[f64]) -> Option<Vec<f64>> {
    let values = standard(values)?;
    let share = values.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() / values.len() as f64;
    if share.abs() > 0.95 {
        return None;
    }
    standard(&values.iter().zip(other).map(|(a, b)| a - share * b).collect::<Vec<_>>())
}

/// Values of a condition that divide the strokes into equal parts.
fn quantiles(c: &Condition, parts: usize) -> Vec<f64> {
    let mut sorted = c.values.clone();
    sorted.sort_by(f64::total_cmp);
    (1..parts).map(|k| sorted[k * sorted.len() / parts]).collect()
}

/// A step at a value of a condition.
fn step(c: &Condition, at: f64) -> Option<Vec<f64>> {
    standard(&c.values.iter().map(|x| f64::from(u8::from(*x >= at))).collect::<Vec<_>>())
}

/// The first strokes of a preparation unlike the later ones, and every other stroke unlike the ones between.
fn of_order(c: &Condition) -> impl Iterator<Item = Vec<f64>> {
    let first = c.values.iter().copied().fold(f64::INFINITY, f64::min);
    let fading = move |x: &f64| (-(x - first) / 1.5).exp();
    let alternating = |x: &f64| (std::f64::consts::PI * x).cos();
    let over = |shape: &dyn Fn(&f64) -> f64| standard(&c.values.iter().map(shape).collect::<Vec<_>>());
    [over(&fading), over(&alternating)].into_iter().flatten()
}

/// What an effect that goes steadily with a condition may be mistaken for: other shapes over that condition and those next to it.
/// None for other effects.
pub(crate) fn rivals(data: &Data, effect: &Effect) -> Vec<Generic> {
    let over: &[Covariate] = match effect.varies_with {
        Some(Covariate::Time | Covariate::Batch) => &[Covariate::Time, Covariate::Batch],
        Some(Covariate::PriorGap) => &[Covariate::PriorGap, Covariate::Order],
        // Conditions of a stroke on its own, in which no neighbour hides.
        Some(
            Covariate::ToolAngle
            | Covariate::Depth
            | Covariate::Width
            | Covariate::Speed
            | Covariate::Radius
            | Covariate::BaseAngle
            | Covariate::Wall
            | Covariate::InterfaceSetPoint
            | Covariate::Order,
        )
        | None => return Vec::new(),
    };
    let mut found = Vec::new();
    for c in conditions(data).iter().filter(|c| over.contains(&c.covariate)) {
        let columns = if c.covariate == Covariate::Order { of_order(c).collect() } else { fine_steps(c) };
        let over = c.covariate.into();
        found.extend(columns.into_iter().map(|column| Generic { over, columns: vec![column] }));
    }
    found
}

/// Steps at up to fifteen places.
fn fine_steps(c: &Condition) -> Vec<Vec<f64>> {
    let mut at = quantiles(c, 16);
    at.dedup();
    at.into_iter().filter_map(|at| step(c, at)).collect()
}

/// One and two waves over the range.
fn waves(c: &Condition) -> impl Iterator<Item = Vec<Vec<f64>>> {
    let low = c.values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = c.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let values = c.values.clone();
    [1.0, 2.0].into_iter().filter_map(move |waves| {
        let turn = |x: &f64| waves * std::f64::consts::TAU * (x - low) / (high - low);
        let sine: Vec<f64> = values.iter().map(|x| turn(x).sin()).collect();
        let cosine: Vec<f64> = values.iter().map(|x| turn(x).cos()).collect();
        Some(vec![standard(&sine)?, standard(&cosine)?])
    })
}
