//! The force at which the soil fails, from force against displacement.

mod after;
mod drastic;
mod evidence;
mod saturation;
mod settings;
mod start;
mod two_lines;

use std::fmt;

pub use evidence::{Change, Evidence};
pub use saturation::Saturation;
pub use settings::{FailureSettings, ForceNoise};
pub use two_lines::TwoLines;

use crate::blocks::Blocks;
use crate::trace::Trace;

/// What a stroke's trace says of its failure.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// The failure, or why none can be told.
    pub outcome: Outcome,
    /// Two lines through the curve up to a drastic failure or to the end; the thesis's rule, for comparison.
    pub two_lines: Option<TwoLines>,
    /// The curve as a limit force times its mobilised fraction.
    pub saturation: Option<Saturation>,
    /// Standard deviation of one sample of the force in N, if samples are independent.
    pub noise_n: f64,
}

/// Whether there is a failure.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// There is one.
    Found(FailurePoint),
    /// None can be told, and why.
    Indiscernible(Indiscernible),
}

/// The failure of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FailurePoint {
    /// Force at which the soil failed, in N.
    pub force_n: f64,
    /// Its standard deviation in N.
    pub sd_n: f64,
    /// How it was found.
    pub method: Method,
    /// Displacement at failure in m, from the start of the trace.
    pub displacement_m: f64,
    /// Time of failure in s, on the trace's clock.
    pub time_s: f64,
    /// `(dF/du) H/F` over half a depth after failure, if the stroke went on.
    pub post_slope_norm: Option<f64>,
    /// Force half a depth after failure over the force at failure, if the stroke went so far.
    pub residual_ratio: Option<f64>,
    /// What the other channels did.
    pub evidence: Evidence,
}

/// How a failure was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The force dropped.
    Drop,
    /// The plate ran away.
    RunAway,
    /// The limit force that the curve tends to.
    Saturation,
}

/// Two sorts of failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// All at once.
    Drastic,
    /// By and by.
    Gradual,
}

impl Method {
    /// Sort of failure that this method finds.
    #[must_use]
    pub fn kind(self) -> Kind {
        match self {
            Self::Drop | Self::RunAway => Kind::Drastic,
            Self::Saturation => Kind::Gradual,
        }
    }

    /// As it stands in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Drop => "drop",
            Self::RunAway => "run_away",
            Self::Saturation => "saturation",
        }
    }
}

/// Why no failure can be told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Indiscernible {
    /// The force never rose to the least that counts.
    NoForce {
        /// Highest force in N.
        highest_n: f64,
        /// What was needed in N.
        least_n: f64,
    },
    /// The plate did not move.
    NoTravel {
        /// Greatest displacement in m.
        travel_m: f64,
    },
    /// Force grows as steeply at the end as at the beginning.
    NoBreak {
        /// Late slope over early slope.
        slope_ratio: f64,
    },
    /// The stroke ended before most of the limit force was mobilised.
    Incomplete {
        /// Mobilised fraction at the end, 0 to 1.
        mobilised: f64,
    },
    /// There is a break, but its force is too uncertain.
    Uncertain {
        /// Standard deviation over force.
        sd_rel: f64,
    },
    /// The force lies too far from the plate's normal to fail the soil ahead.
    Inclined {
        /// Angle between the force and the plate's normal in deg.
        angle_deg: f64,
    },
    /// The plate sank or rose too far for the square of its depth to hold.
    LeftDepth {
        /// Depth over that at the beginning.
        ratio: f64,
    },
    /// The plate slid down along itself, and the soil ahead did not fail.
    Slid {
        /// Way down in m.
        down_m: f64,
        /// Way ahead in the same time in m.
        ahead_m: f64,
    },
}

impl Indiscernible {
    /// As it stands in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NoForce { .. } => "no_force",
            Self::NoTravel { .. } => "no_travel",
            Self::NoBreak { .. } => "no_break",
            Self::Incomplete { .. } => "incomplete",
            Self::Uncertain { .. } => "uncertain",
            Self::Inclined { .. } => "inclined",
            Self::LeftDepth { .. } => "left_depth",
            Self::Slid { .. } => "slid",
        }
    }
}

impl fmt::Display for Indiscernible {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoForce { highest_n, least_n } => {
                write!(out, "the force never exceeds {highest_n:.3} N, a stroke needs {least_n:.3} N")
            }
            Self::NoTravel { travel_m } => write!(out, "the plate moved by only {:.3} mm", travel_m * 1e3),
            Self::NoBreak { slope_ratio } if *slope_ratio <= 0.0 => {
                write!(out, "the force does not rise when the plate begins to move, or falls throughout")
            }
            Self::NoBreak { slope_ratio } => write!(
                out,
                "force rises nearly as fast at the end as at the beginning (slopes 1 : {slope_ratio:.2}), so there is no break"
            ),
            Self::Incomplete { mobilised } => write!(
                out,
                "the stroke ended with only {:.0} % of the limit force mobilised; let it go further or push harder",
                mobilised * 100.0
            ),
            Self::Uncertain { sd_rel } => {
                write!(
                    out,
                    "the failure force is uncertain by {:.0} % (one standard deviation)",
                    sd_rel * 100.0
                )
            }
            Self::Inclined { angle_deg } => write!(
                out,
                "the force is inclined by {angle_deg:.0} deg to the plate's normal, so it does not push the soil ahead"
            ),
            Self::LeftDepth { ratio } => {
                write!(out, "the plate went to {ratio:.2} times its depth, too far to scale the force")
            }
            Self::Slid { down_m, ahead_m } => write!(
                out,
                "the plate slid {:.1} mm down while it went {:.1} mm ahead; choose a lower set-point for the interface friction",
                down_m * 1e3,
                ahead_m * 1e3
            ),
        }
    }
}

/// Nodes that a curve is fitted at.
const NODES: usize = 120;
/// So much of a curve after failure is looked at: a share of the way to failure, and at least so many depths.
const AFTER_FAILURE: f64 = 1.5;
const AFTER_DEPTHS: f64 = 0.3;
/// A plate that went back by more depths than this was let go.
const LET_GO: f64 = 0.02;

/// The highest of some hundred blocks of mere noise is three to four of its standard deviations; a force is more.
const LEAST_NOISES: f64 = 5.0;

/// Least travel in depths: below, there is no curve.
const LEAST_TRAVEL: f64 = 2e-3;

/// Finds the failure of one stroke.
///
/// A drop of the force or a run-away of the plate is a drastic failure, and its force the one just before. Otherwise the
/// failure is gradual: the limit force is found by how the curve saturates. The thesis's rule, the break of
/// two lines (section 5.5), is biased low by as much as is still to be mobilised at the break; it is reported beside.
#[must_use]
pub fn failure_force(trace: &Trace, settings: &FailureSettings) -> Analysis {
    let mut blocks = Blocks::of(trace);
    if let Some(noise) = settings.noise {
        // What is slower than a few blocks the curve itself does not show.
        blocks.noise_n = blocks.noise_n.max(noise.of_mean(blocks.interval_s()));
    }
    let noise_n = blocks.noise_n * (blocks.samples as f64).sqrt();
    let highest_n = blocks.f_n.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least_n = settings.least_force_n.max(LEAST_NOISES * blocks.noise_n);
    let none = |reason| Analysis {
        outcome: Outcome::Indiscernible(reason),
        two_lines: None,
        saturation: None,
        noise_n,
    };
    if highest_n < least_n {
        return none(Indiscernible::NoForce { highest_n, least_n });
    }
    let (low, high) =
        blocks.u_m.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), u| (l.min(*u), h.max(*u)));
    if high - low < LEAST_TRAVEL * settings.depth_m {
        return none(Indiscernible::NoTravel { travel_m: high - low });
    }
    let blocks = blocks.part(start::of_rise(&blocks)..blocks.t_s.len());
    let broken = drastic::find(&blocks, settings);
    let loading = broken.map_or_else(|| blocks.clone(), |broken| blocks.part(0..broken.block + 1));
    let (nodes, saturation) = curve(&loading, settings);
    let two_lines = two_lines::fit(&nodes);
    let outcome = match broken {
        Some(broken) => at_break(trace, &blocks, broken, settings),
        None => gradual(trace, &blocks, two_lines, saturation, settings),
    };
    Analysis { outcome, two_lines, saturation, noise_n }
}

/// Nodes of the curve and how it saturates. What the plate does long after the failure, when it has left its depth or has a
/// heap ahead, is left out as soon as it is known where that begins.
fn curve(loading: &Blocks, settings: &FailureSettings) -> (Vec<[f64; 2]>, Option<Saturation>) {
    let mut part = loading.virgin(LET_GO * settings.depth_m);
    loop {
        let nodes = part.nodes(NODES);
        let found = saturation::fit(&from_rest(&nodes), part.noise_n, settings.depth_m);
        let Some(at) = found.as_ref().and_then(|found| found.displacement_95_m) else {
            return (nodes, found);
        };
        let first = part.u_m.first().copied().unwrap_or(0.0);
        let enough = (AFTER_FAILURE * at).max(AFTER_DEPTHS * settings.depth_m);
        let Some(end) = part.u_m.iter().position(|u| u - first > at + enough) else { return (nodes, found) };
        part = part.part(0..end);
    }
}

/// Nodes measured from where the force would be zero: the plate may carry some when a stroke begins.
fn from_rest(nodes: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (Some([u_0, f_0]), Some([u_1, f_1])) = (nodes.first(), nodes.get(nodes.len() / 8)) else {
        return Vec::new();
    };
    let slope = (f_1 - f_0) / (u_1 - u_0);
    let back = if slope.is_finite() && slope > 0.0 { (f_0 / slope).max(0.0) } else { 0.0 };
    nodes.iter().map(|[u, f]| [u - u_0 + back, *f]).collect()
}

fn at_break(trace: &Trace, blocks: &Blocks, broken: drastic::Break, settings: &FailureSettings) -> Outcome {
    let Some((force_n, sd_n)) = drastic::force_at(blocks, broken.block, settings) else {
        return Outcome::Indiscernible(Indiscernible::Uncertain { sd_rel: 1.0 });
    };
    let method = match broken.sign {
        drastic::Sign::Drop => Method::Drop,
        drastic::Sign::RunAway => Method::RunAway,
    };
    point(trace, blocks, settings, FailureForce { force_n, sd_n, method, block: broken.block })
}

fn gradual(
    trace: &Trace,
    blocks: &Blocks,
    two_lines: Option<TwoLines>,
    saturation: Option<Saturation>,
    settings: &FailureSettings,
) -> Outcome {
    let (Some(lines), Some(curve)) = (two_lines, saturation) else {
        return Outcome::Indiscernible(Indiscernible::NoBreak { slope_ratio: 1.0 });
    };
    let slope_ratio = lines.late_n_per_m / lines.early_n_per_m;
    if !(slope_ratio.is_finite() && slope_ratio < settings.most_slope_ratio) || lines.early_n_per_m <= 0.0 {
        return Outcome::Indiscernible(Indiscernible::NoBreak { slope_ratio });
    }
    if curve.mobilised < settings.least_mobilised {
        return Outcome::Indiscernible(Indiscernible::Incomplete { mobilised: curve.mobilised });
    }
    let first = blocks.u_m.first().copied().unwrap_or(0.0);
    let at = curve.displacement_95_m.unwrap_or(lines.displacement_m - first);
    let block = blocks.u_m.iter().position(|u| u - first >= at).unwrap_or(blocks.u_m.len().saturating_sub(1));
    // What is not mobilised is extrapolated, and so less certain.
    let extrapolated = 0.25 * (1.0 - curve.mobilised) * curve.force_n;
    let sd_n = curve.sd_n.hypot(extrapolated);
    point(
        trace,
        blocks,
        settings,
        FailureForce { force_n: curve.force_n, sd_n, method: Method::Saturation, block },
    )
}

struct FailureForce {
    force_n: f64,
    sd_n: f64,
    method: Method,
    block: usize,
}

fn point(trace: &Trace, blocks: &Blocks, settings: &FailureSettings, found: FailureForce) -> Outcome {
    let floor_sd_rel = match found.method.kind() {
        Kind::Drastic => settings.drastic_floor_sd_rel,
        Kind::Gradual => settings.floor_sd_rel,
    };
    let sd_n = found.sd_n.hypot(floor_sd_rel * found.force_n);
    let sd_rel = sd_n / found.force_n;
    if !(sd_rel.is_finite() && sd_rel <= settings.most_sd_rel) {
        return Outcome::Indiscernible(Indiscernible::Uncertain { sd_rel: sd_rel.min(1e3) });
    }
    let (Some(&time_s), Some(&u), Some(&first)) =
        (blocks.t_s.get(found.block), blocks.u_m.get(found.block), blocks.u_m.first())
    else {
        return Outcome::Indiscernible(Indiscernible::Uncertain { sd_rel });
    };
    let after = after::After::of(blocks, found.block, found.force_n, settings.depth_m);
    Outcome::Found(FailurePoint {
        force_n: found.force_n,
        sd_n,
        method: found.method,
        displacement_m: u - first,
        time_s,
        post_slope_norm: after.slope_norm,
        residual_ratio: after.residual_ratio,
        evidence: Evidence::at(trace, time_s),
    })
}
