//! What the force of a plate is in ground that changes with depth, for a box of such grounds.
//!
//! ```text
//! F = g w L^2 \int_0^1 \left[ \int_0^\zeta \varrho(s H)\, ds \right] K(\varphi(\zeta H), \delta)\, d\zeta ,
//! ```
//!
//! the sum of local pressures: the weight of all that lies above a point of the plate, times the coefficient of the friction there, as earth pressure
//! in layers is taken since Terzaghi. In one soil it is the model itself. It is linear in the densities at top and bottom.

use std::sync::Arc;

use super::coefficients::Coefficients;

/// How friction angle and density go with depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// One soil.
    Uniform,
    /// From those at the surface straight to those at a depth in m.
    Gradient {
        /// The depth in m to which it goes; beyond, it goes on.
        to_m: f64,
    },
    /// One soil above a level surface, another below.
    Step,
}

/// A stroke and what is known of its force.
#[derive(Debug, Clone)]
pub struct Stroke {
    /// Depth of the plate's lower edge in m.
    pub depth_m: f64,
    /// Gravity, width and the square of the slant length: N for each kg/m3 of `c rho`.
    pub unit_n: f64,
    /// Interval of the force in N.
    pub force_n: [f64; 2],
    /// By how much its part of what ends add may differ from that of the ground, 0 to 1.
    pub end_tolerance: f64,
    /// How soil elsewhere than at the plate acts on it.
    pub layering: Layering,
    /// The model at its geometry.
    pub coefficients: Arc<Coefficients>,
}

/// A box of grounds: intervals of all that is unknown but the densities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground {
    /// Friction angle at top and bottom in deg.
    pub phi_deg: [[f64; 2]; 2],
    /// Friction on the plate in deg.
    pub delta_deg: [f64; 2],
    /// Part of what the ends of plates add at most, by the model.
    pub ends: [f64; 2],
    /// Depth of the step in m; without meaning for other shapes.
    pub step_m: [f64; 2],
}

/// How far what lies elsewhere than at the plate acts on its force, by proven bounds of layered ground (README).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layering {
    /// By how much the force may be off what local pressures come to, towards the soil at the bottom: this share of the logarithm of the ratio of coefficients
    /// at bottom and top.
    pub towards_bottom: f64,
    /// To which part of its depth below the edge of the plate soil acts on it.
    pub reach: f64,
}

/// The same towards the soil at the top, for all plates.
pub const TOWARDS_TOP: f64 = 0.06;
/// And this share of the force, wherever anything may change.
pub const WHERE_IT_CHANGES: f64 = 0.005;
/// The greatest tool angle in deg for which it is known: beyond, soil fails far below the plate's edge.
pub const STEEPEST_DEG: f64 = 90.0;

impl Layering {
    /// At a tool angle in deg. `None` beyond the steepest.
    #[must_use]
    pub fn at(alpha_deg: f64) -> Option<Self> {
        // A degree of what is asked for and what is set.
        if alpha_deg <= 81.0 {
            Some(Self { towards_bottom: 0.2, reach: 0.05 })
        } else if alpha_deg <= STEEPEST_DEG + 1.0 {
            Some(Self { towards_bottom: 0.35, reach: 0.12 })
        } else {
            None
        }
    }
}

/// A stroke's force over its unit, `c . density`, with the least and the greatest `c`, what the model of layers may be off included.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weights {
    pub(super) least: [f64; 2],
    pub(super) greatest: [f64; 2],
}

/// Nodes and weights of Gauss and Legendre on 0 to 1: exact to 1e-6 for coefficients that change by a factor of ten.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_9),
    (0.330_009_478_207_571_9, 0.326_072_577_431_273_1),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_1),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_9),
];

impl Stroke {
    /// The weights of the two densities, for all grounds of a box.
    pub(super) fn weights(&self, shape: Shape, ground: &Ground) -> Weights {
        let own = self.end_tolerance;
        let ends = [(ground.ends[0] - own).max(0.0), (ground.ends[1] + own).min(1.0)];
        let k = |phi_deg: [f64; 2]| self.coefficients.range(phi_deg, ground.delta_deg, ends);
        let [top, bottom] = ground.phi_deg;
        match shape {
            Shape::Uniform => {
                let [low, high] = k(top);
                Weights { least: [0.5 * low, 0.0], greatest: [0.5 * high, 0.0] }
            }
            Shape::Gradient { to_m } => {
                let part = self.depth_m / to_m;
                let between = |zeta: f64, end: usize| {
                    let t = part * zeta;
                    // Beyond the depth to which it goes ends change places.
                    let (a, b) = if t <= 1.0 { (top[end], bottom[end]) } else { (top[1 - end], bottom[end]) };
                    a + t * (b - a)
                };
                let mut found = Weights { least: [0.0; 2], greatest: [0.0; 2] };
                for (zeta, weight) in GAUSS {
                    let [low, high] = k([between(zeta, 0), between(zeta, 1)]);
                    let below = 0.5 * part * zeta * zeta;
                    for (density, share) in [zeta - below, below].into_iter().enumerate() {
                        found.least[density] += weight * share * low;
                        found.greatest[density] += weight * share * high;
                    }
                }
                found.widened(self.off(ground, [between(1.0, 0), between(1.0, 1)]))
            }
            Shape::Step => {
                let zeta = ground.step_m.map(|step| (step / self.depth_m).min(1.0));
                if ground.step_m[0] >= (1.0 + self.layering.reach) * self.depth_m {
                    let [low, high] = k(top);
                    return Weights { least: [0.5 * low, 0.0], greatest: [0.5 * high, 0.0] };
                }
                let (above, below) = (k(top), k(bottom));
                let across = zeta.map(|z| z * (1.0 - z));
                let most = if zeta[0] <= 0.5 && zeta[1] >= 0.5 { 0.25 } else { across[0].max(across[1]) };
                let square = |z: f64| 0.5 * z * z;
                Weights {
                    least: [
                        square(zeta[0]) * above[0] + across[0].min(across[1]) * below[0],
                        square(1.0 - zeta[1]) * below[0],
                    ],
                    greatest: [
                        square(zeta[1]) * above[1] + most * below[1],
                        square(1.0 - zeta[0]) * below[1],
                    ],
                }
                .widened(self.off(ground, bottom))
            }
        }
    }

    /// Factors by which a force may be below and above local pressures, for a friction angle in deg at the top in that of the ground and at the
    /// bottom of the plate in an interval. Where in its bracket the model's coefficient is, it is at top and bottom.
    fn off(&self, ground: &Ground, bottom_deg: [f64; 2]) -> [f64; 2] {
        let delta = f64::midpoint(ground.delta_deg[0], ground.delta_deg[1]);
        let ln_k = |phi: f64| self.coefficients.ln_middle(phi, delta);
        let [top, bottom] = [ground.phi_deg[0].map(ln_k), bottom_deg.map(ln_k)];
        let ratios = [bottom[0] - top[1], bottom[1] - top[0]];
        let towards_bottom = self.layering.towards_bottom;
        let up = |ratio: f64| if ratio > 0.0 { towards_bottom * ratio } else { -TOWARDS_TOP * ratio };
        let down = |ratio: f64| if ratio > 0.0 { -TOWARDS_TOP * ratio } else { towards_bottom * ratio };
        let of = |one: f64, other: f64, pick: fn(f64, f64) -> f64| {
            // Where soils may be the same, nothing is off: 0 is between the ratios.
            let between = if ratios[0] <= 0.0 && ratios[1] >= 0.0 { 0.0 } else { one };
            libm::exp(pick(pick(one, other), between))
        };
        [of(down(ratios[0]), down(ratios[1]), f64::min), of(up(ratios[0]), up(ratios[1]), f64::max)]
    }
}

impl Weights {
    fn widened(self, [down, up]: [f64; 2]) -> Self {
        let (down, up) = (down * (1.0 - WHERE_IT_CHANGES), up * (1.0 + WHERE_IT_CHANGES));
        Self { least: self.least.map(|c| c * down), greatest: self.greatest.map(|c| c * up) }
    }
}
