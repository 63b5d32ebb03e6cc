//! Strokes made from a mobilisation law: the arm pulls through a spring whose far end advances evenly.
#![allow(dead_code, clippy::unwrap_used, reason = "each test file uses a part")]

use soilctl_process::{Channels, Trace};

/// A small generator: uniform numbers by a linear congruence, normal ones as sums of twelve.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

pub(crate) const DEPTH_M: f64 = 0.025;
pub(crate) const LIMIT_N: f64 = 10.0;

/// A stroke through soil whose force over displacement is `force`, sampled at 500 Hz for `seconds`, with noise.
pub(crate) fn stroke(
    force: impl Fn(f64) -> f64,
    lead_end_m: f64,
    seconds: f64,
    noise_n: f64,
    seed: u64,
) -> Trace {
    let mut random = Random(seed);
    let stiffness = 1500.0;
    let n = (seconds * 500.0) as usize;
    let (mut t, mut u, mut f) = (Vec::new(), Vec::new(), Vec::new());
    let mut at = 0.0;
    for i in 0..n {
        let lead = lead_end_m * i as f64 / n as f64;
        // The plate goes on while the spring pushes more than the soil resists.
        for _ in 0..4000 {
            if stiffness * (lead - at) <= force(at) || at > lead {
                break;
            }
            at += 1e-6;
        }
        t.push(i as f64 / 500.0);
        u.push(at);
        f.push(
            stiffness * (lead - at).max(0.0).min(force(at + 1e-6).max(0.0) / stiffness + 1.0)
                + noise_n * random.normal(),
        );
    }
    Trace::new(t, u, f, Channels::default()).unwrap()
}

/// A name and a law.
pub(crate) type Law = (&'static str, fn(f64) -> f64);

/// Mobilisation laws with limit 1 at `x = u / lambda`; not all of them are among the fitted ones.
pub(crate) fn laws() -> Vec<Law> {
    vec![
        ("sharp", |x| x.min(1.0)),
        ("parabola", |x| if x < 2.0 { x - x * x / 4.0 } else { 1.0 }),
        ("tanh", f64::tanh),
        ("exponential", |x| 1.0 - (-x).exp()),
        ("hyperbola", |x| x / (1.0 + x)),
        ("root", |x| x / (1.0 + x * x).sqrt()),
        ("arctangent", |x| (x * std::f64::consts::FRAC_PI_2).atan() / std::f64::consts::FRAC_PI_2),
        // Not among the fitted ones.
        ("Gudermann", |x| (x * std::f64::consts::FRAC_PI_2).sinh().atan() / std::f64::consts::FRAC_PI_2),
        ("Weibull 0.85", |x| 1.0 - (-x.powf(0.85)).exp()),
        ("Weibull 1.3", |x| 1.0 - (-x.powf(1.3)).exp()),
        ("two scales", |x| 1.0 - 0.7 * (-1.2 * x).exp() - 0.3 * (-0.4 * x).exp()),
    ]
}

/// Way over which soil was heaped up to a displacement: where it has all but failed, it goes with the plate.
pub(crate) fn heaped(mobilised: impl Fn(f64) -> f64) -> impl Fn(f64) -> f64 {
    const STEP_M: f64 = 1e-6;
    let mut way = 0.0;
    let ways: Vec<f64> = (0..30_000)
        .map(|k| {
            way += STEP_M * mobilised(f64::from(k) * STEP_M).powi(8);
            way
        })
        .collect();
    move |u| ways[((u / STEP_M) as usize).min(ways.len() - 1)]
}
