//! How far a gradual failure has mobilised the soil: force against displacement as a limit force, which the heap
//! makes grow, times a mobilised fraction that tends to 1.
//!
//! `F(u) = F_0 m(u / lambda) + F_1 max(0, u - u_95)`: soil is heaped once it fails, from where 95 % are mobilised. At a given
//! `lambda` it is linear in the limit force `F_0` of the undisturbed ground and its growth `F_1`, so one search over `lambda` does. Which law `m` follows is not known; several are
//! fitted, from a sharp bend to a hyperbola (Kondner 1963; Duncan & Chang 1970), and count by how well they fit. Their
//! spread is part of the uncertainty.

use std::f64::consts::FRAC_PI_2;

use soilctl_stats::{Solved, least_squares};

/// The limit force by mobilisation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturation {
    /// Limit force of the undisturbed ground in N.
    pub force_n: f64,
    /// Its standard deviation in N: residuals, and the spread of the laws that fit.
    pub sd_n: f64,
    /// Growth of the limit force with displacement in N/m.
    pub growth_n_per_m: f64,
    /// Fraction of the limit force that was mobilised at the end, 0 to 1.
    pub mobilised: f64,
    /// Displacement in m at which 95 % were mobilised, if the stroke went so far.
    pub displacement_95_m: Option<f64>,
}

/// Mobilised fraction at `x = u / lambda`, all with limit 1.
type Law = fn(f64) -> f64;
const LAWS: [Law; 11] = [
    |x| x.min(1.0),
    |x| if x < 2.0 { x - x * x / 4.0 } else { 1.0 },
    f64::tanh,
    |x| 1.0 - (-x).exp(),
    |x| 1.0 - (-x.powf(0.75)).exp(),
    |x| 1.0 - (1.0 + x / 3.0).powi(-3),
    |x| x / (1.0 + x),
    |x| x / (1.0 + x.powf(1.5)).powf(2.0 / 3.0),
    |x| x / (1.0 + x * x).sqrt(),
    |x| x / (1.0 + x.powi(4)).powf(0.25),
    |x| (x * FRAC_PI_2).atan() / FRAC_PI_2,
];

/// Mobilised fraction at which the soil counts as failing.
const FAILING: f64 = 0.95;

/// As many independent pieces of evidence does a curve give on its shape: what a law misses, it misses over long parts.
const INDEPENDENT: f64 = 8.0;

/// Laws whose misfit stays under this fraction of the force can't be told apart: no soil follows any of them closer.
const INDISTINCT: f64 = 0.009;

/// The laws are the corners of what a soil may do, from a sharp bend to a hyperbola, and a soil lies between: over 190 simulated
/// strokes in four soils the error was so much of their spread (`docs/process.md`).
const SHARE_OF_SPREAD: f64 = 0.55;

/// Growth of the limit force over a depth, by the limit force: one standard deviation of what is expected before it is
/// measured. A law that is slow to saturate needs none.
const USUAL_GROWTH: f64 = 0.2;

/// Growth of the limit force over the stroke, by the limit force: soil in heaps makes it grow, dense soil loses some.
const LEAST_GROWTH: f64 = -0.5;
const MOST_GROWTH: f64 = 2.0;

/// One law with its best length.
struct Fitted {
    lambda: f64,
    law: Law,
    solved: Solved<2>,
    square: f64,
}

/// Fits all laws to nodes (displacement, force) that start where the plate began to push at a depth. `noise_n` is the standard
/// deviation of a node. `None` if no law fits with a limit force above 0.
pub(super) fn fit(nodes: &[[f64; 2]], noise_n: f64, depth_m: f64) -> Option<Saturation> {
    let last = nodes.iter().map(|node| node[0]).fold(0.0, f64::max);
    if !(last.is_finite() && last > 0.0) {
        return None;
    }
    let stroke = Stroke { nodes, last, growth_sd: USUAL_GROWTH * last / depth_m };
    let fits: Vec<Fitted> = LAWS.iter().filter_map(|law| stroke.best_length(*law)).collect();
    let highest = nodes.iter().map(|node| node[1]).fold(0.0, f64::max);
    let floor = (noise_n * noise_n + (INDISTINCT * highest).powi(2)).max(f64::MIN_POSITIVE);
    let least = fits.iter().map(|fit| fit.square.max(floor)).min_by(f64::total_cmp)?;
    let weights: Vec<f64> =
        fits.iter().map(|fit| (fit.square.max(floor) / least).powf(-INDEPENDENT / 2.0)).collect();
    let total: f64 = weights.iter().sum();
    let mean = |value: &dyn Fn(&Fitted) -> f64| -> f64 {
        fits.iter().zip(&weights).map(|(fit, w)| w * value(fit)).sum::<f64>() / total
    };
    let force_n = mean(&|fit| fit.solved.x[0]);
    let spread = mean(&|fit| (fit.solved.x[0] - force_n).powi(2));
    let within =
        mean(&|fit| fit.square.max(floor) * fit.solved.inverse[0][0] * nodes.len() as f64 / INDEPENDENT);
    let length_95 = mean(&|fit| fit.lambda * reach(fit.law, FAILING));
    Some(Saturation {
        force_n,
        sd_n: SHARE_OF_SPREAD * (spread + within).sqrt(),
        growth_n_per_m: mean(&|fit| fit.solved.x[1]) / last,
        mobilised: mean(&|fit| (fit.law)(last / fit.lambda)),
        displacement_95_m: (length_95 <= last).then_some(length_95),
    })
}

/// Smallest `x` at which a law reaches `fraction`, by bisection.
fn reach(law: Law, fraction: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1e3);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if law(middle) < fraction { low = middle } else { high = middle }
    }
    high
}

/// What the laws are fitted to.
struct Stroke<'a> {
    nodes: &'a [[f64; 2]],
    /// Displacement of the last node in m.
    last: f64,
    /// Standard deviation of the growth over the stroke that is expected, by the limit force.
    growth_sd: f64,
}

impl Stroke<'_> {
    /// Least squares over the length on a logarithmic grid, refined twice around the best.
    fn best_length(&self, law: Law) -> Option<Fitted> {
        let failing = reach(law, FAILING);
        let mut best: Option<Fitted> = None;
        // From a hundredth of the stroke to three times the stroke: longer ones can't be told from a straight line.
        let (mut low, mut high) = ((0.003 * self.last).ln(), (3.0 * self.last).ln());
        for _ in 0..3 {
            let steps = 40;
            for k in 0..=steps {
                let lambda = (low + (high - low) * f64::from(k) / f64::from(steps)).exp();
                if let Some(found) = self.at_length(law, lambda, failing * lambda)
                    && best.as_ref().is_none_or(|known| found.square < known.square)
                {
                    best = Some(found);
                }
            }
            let around = best.as_ref()?.lambda.ln();
            let half = (high - low) / f64::from(steps);
            (low, high) = (around - half, around + half);
        }
        best
    }

    /// Limit force above 0, growth within its bounds and not without need.
    fn at_length(&self, law: Law, lambda: f64, failing_m: f64) -> Option<Fitted> {
        let Self { nodes, last, growth_sd } = *self;
        let row = |u: f64| [law((u / lambda).max(0.0)), (u - failing_m).max(0.0) / last];
        let rows = nodes.iter().map(|[u, f]| (row(*u), *f, 1.0));
        // One standard deviation of growth weighs as much as the misfit of one independent piece of evidence.
        let expected = ([0.0, 1.0], 0.0, nodes.len() as f64 / INDEPENDENT * (INDISTINCT / growth_sd).powi(2));
        let both = least_squares(rows.chain([expected]))?;
        let growth = both.x[1] / both.x[0];
        let solved = if (LEAST_GROWTH..=MOST_GROWTH).contains(&growth) {
            both
        } else {
            // On the edge of what is allowed one unknown is left.
            let share = growth.clamp(LEAST_GROWTH, MOST_GROWTH);
            let single = least_squares(nodes.iter().map(|[u, f]| {
                let [m, grown] = row(*u);
                ([m + share * grown], *f, 1.0)
            }))?;
            Solved {
                x: [single.x[0], share * single.x[0]],
                inverse: [[single.inverse[0][0], 0.0], [0.0, 0.0]],
            }
        };
        if solved.x[0].is_nan() || solved.x[0] <= 0.0 {
            return None;
        }
        let misfit = |[u, f]: &[f64; 2]| {
            let [m, grown] = row(*u);
            (f - solved.x[0] * m - solved.x[1] * grown).powi(2)
        };
        let unexpected = (INDISTINCT * solved.x[1] / growth_sd).powi(2) / INDEPENDENT;
        let square = nodes.iter().map(misfit).sum::<f64>() / nodes.len() as f64 + unexpected;
        Some(Fitted { lambda, law, solved, square })
    }
}
