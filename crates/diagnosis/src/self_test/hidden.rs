//! What is hidden in a campaign. The formulas are not those of the catalogue: other functions of the same kind,
//! so that a diagnosis that only inverts its own formulas does not get through.

use std::f64::consts::{PI, TAU};

use soilctl_effects::{DirectMechanics, EffectId};
use soilctl_soil::STANDARD_GRAVITY_M_S2;
use soilctl_strokes::StrokeRow;

use super::cause::{Cause, Outside};
use super::random::Random;

/// A hidden cause with its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hidden {
    /// What it is.
    pub cause: Cause,
    /// Amplitude in the unit of the catalogue's parameter.
    pub size: f64,
    /// Decay length, azimuth or another detail.
    pub detail: f64,
}

/// Soil of a hidden campaign.
#[derive(Debug, Clone, Copy)]
pub(super) struct TrueSoil {
    pub(super) phi_deg: f64,
    pub(super) delta_deg: f64,
    pub(super) density_kg_m3: f64,
}

impl TrueSoil {
    pub(super) fn unit_weight_n_m3(&self) -> f64 {
        self.density_kg_m3 * STANDARD_GRAVITY_M_S2
    }
}

/// Means and ends of a campaign that effects refer to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub(super) depth_m: f64,
    pub(super) time_s: (f64, f64),
    pub(super) batches: f64,
}

/// A random size of an effect as hidden campaigns have it, in the unit of its parameter.
#[must_use]
pub fn hidden_size(id: EffectId, random: &mut Random) -> f64 {
    draw(Cause::Effect(id), random).size
}

/// A cause of a random size. Sizes are as in the catalogue's ranges, but for those that no campaign could show.
pub(super) fn draw(cause: Cause, random: &mut Random) -> Hidden {
    let r = random;
    let (size, detail) = match cause {
        Cause::Effect(id) => match id {
            EffectId::StressDependentFriction => (r.between(3.0, 6.0), 0.0),
            EffectId::ProgressiveFailure => (r.between(0.05, 0.18), 0.0),
            EffectId::InsertionLoosening => (r.log_between(2.0, 15.0), r.log_between(0.01, 0.1)),
            EffectId::Cohesion => (r.log_between(10.0, 200.0), 0.0),
            EffectId::SurchargeHeap => (r.log_between(5.0, 150.0), 0.0),
            EffectId::SurfaceSlope => (r.between(2.0, 5.0), r.between(-180.0, 180.0)),
            EffectId::SideEffects3d => (r.log_between(0.2, 3.0), 0.0),
            EffectId::RateEffect => (r.between(0.02, 0.12), 0.0),
            EffectId::TipBearing => (r.between(0.05, 0.25), 0.0),
            EffectId::InterfaceFrictionOffset => (r.sign() * r.between(3.0, 6.0), 0.0),
            EffectId::DepthOffset => (r.sign() * r.between(0.0005, 0.0025), 0.0),
            EffectId::ToolAngleOffset => (r.sign() * r.between(1.0, 5.0), 0.0),
            EffectId::ForceScale => (r.sign() * r.between(0.03, 0.15), 0.0),
            EffectId::ForceBias => (r.sign() * r.between(0.1, 0.5), 0.0),
            EffectId::ForceDrift => (r.sign() * r.between(0.2, 0.8), 0.0),
            EffectId::FtCrosstalk => (r.sign() * r.between(0.03, 0.12), 0.0),
            EffectId::DensityGradient => (r.log_between(0.05, 0.8) / 0.0254, 0.0),
            EffectId::PreparationDrift => (r.sign() * r.log_between(0.03, 0.4), 0.0),
            EffectId::RadiusDependence => (r.sign() * r.log_between(0.03, 0.35), 0.0),
            EffectId::BaseAngleDependence => (r.sign() * r.log_between(0.03, 0.35), r.choice(&[1.0, 2.0])),
            EffectId::AdjacentStroke => (-r.between(0.1, 0.4), r.log_between(0.02, 0.15)),
            EffectId::WallProximity => (r.between(0.1, 0.5), r.log_between(0.02, 0.15)),
            EffectId::MoistureDrying => (r.log_between(20.0, 200.0), r.between(0.15, 1.0)),
            EffectId::ModelForm => (1.0, 0.0),
            EffectId::CableFlex => (r.between(2e-4, 8e-4), 0.0),
            EffectId::Backlash => (r.between(4e-4, 1.2e-3), 0.0),
            EffectId::BackdriveFriction => (r.between(1.1, 2.7), 0.0),
            EffectId::EncoderQuantisation => (r.between(1e-3, 2e-3), 0.0),
        },
        Cause::Outside(outside) => match outside {
            Outside::OneOffBatches => (r.sign() * r.between(0.1, 0.3), r.between(0.2, 0.7)),
            Outside::AlphaByDepth => (r.sign() * r.between(0.06, 0.15), 0.0),
            Outside::BaseWaves | Outside::MiddleSpeed | Outside::WarmAfternoon | Outside::MiddleDepth => {
                (r.sign() * r.between(0.08, 0.25), r.between(0.0, 1.0))
            }
        },
    };
    Hidden { cause, size, detail }
}

/// The conditions under which a stroke fails the soil.
struct Failing {
    alpha_deg: f64,
    depth_m: f64,
    phi_deg: f64,
    delta_deg: f64,
    /// Slope of the surface, deg.
    slope_deg: f64,
}

/// What a cause changes: conditions, or the force itself.
enum Change {
    /// Adds to the tool angle, deg.
    ToolAngle(f64),
    /// Adds to the depth, m.
    Depth(f64),
    /// Adds to the friction angle, deg.
    Friction(f64),
    /// Adds to the interface friction angle, deg.
    Interface(f64),
    /// Adds to the slope of the surface, deg.
    Slope(f64),
    /// Multiplies the force.
    Times(f64),
    /// Adds to the force, N.
    Plus(f64),
    /// Nothing that forces show.
    Nothing,
}

/// Force in N without scatter; `None` where the force model has no answer.
pub(super) fn force_n(
    model: &DirectMechanics,
    soil: &TrueSoil,
    span: &Span,
    row: &StrokeRow,
    hidden: &[Hidden],
) -> Option<f64> {
    let mut at = Failing {
        alpha_deg: row.alpha_deg,
        depth_m: row.depth_m,
        phi_deg: soil.phi_deg,
        delta_deg: soil.delta_deg,
        slope_deg: 0.0,
    };
    for h in hidden {
        match change(h, &at, soil, span, row)? {
            Change::ToolAngle(by) => at.alpha_deg += by,
            Change::Depth(by) => at.depth_m += by,
            Change::Friction(by) => at.phi_deg += by,
            Change::Interface(by) => at.delta_deg = (at.delta_deg + by).max(0.0),
            Change::Slope(by) => at.slope_deg += by,
            Change::Times(_) | Change::Plus(_) | Change::Nothing => {}
        }
    }
    let (low, high) = model.model().valid_range().phi_deg;
    at.phi_deg = at.phi_deg.clamp(low.max(15.0), high.min(58.0));
    let slant = at.depth_m / at.alpha_deg.to_radians().sin();
    let (ln_weight, _) = model.ln_weight(at.alpha_deg, 0.0, at.phi_deg, at.delta_deg).ok()?;
    let level = 0.5 * soil.unit_weight_n_m3() * slant * slant * row.width_m * ln_weight.exp();
    // 5 % of force a degree of slope.
    let mut force = level * (1.0 + 0.05 * at.slope_deg);
    for h in hidden {
        match change(h, &at, soil, span, row)? {
            Change::Times(factor) => force *= factor,
            Change::Plus(newtons) => force += newtons,
            Change::ToolAngle(_)
            | Change::Depth(_)
            | Change::Friction(_)
            | Change::Interface(_)
            | Change::Slope(_)
            | Change::Nothing => {}
        }
    }
    // A force that the sensor reads the wrong way round is no stroke.
    (force > 0.15 && force.is_finite()).then_some(force)
}

/// What a cause changes under the conditions so far; `None` if the stroke lacks what it depends on.
fn change(h: &Hidden, at: &Failing, soil: &TrueSoil, span: &Span, row: &StrokeRow) -> Option<Change> {
    let &Hidden { cause, size, detail } = h;
    let time = (row.time_s? - span.time_s.0) / (span.time_s.1 - span.time_s.0);
    let batch: f64 = row.batch.as_ref()?.trim_start_matches('b').parse().ok()?;
    let batch = (batch - 1.0) / (span.batches - 1.0).max(1.0);
    let lean = row.alpha_deg.to_radians();
    // Passive wedge with a rough back, Rankine's cohesion term.
    let sticking = |pascal: f64| {
        let passive = (0.25 * PI + 0.5 * at.phi_deg.to_radians()).tan().powi(2);
        let rough = 1.0
            + 1.2 * at.delta_deg.to_radians().tan() * lean.sin()
            + 1.5 * (row.alpha_deg - 90.0).to_radians();
        pascal * row.depth_m * row.width_m * 2.0 * passive.sqrt() * rough
    };
    let only_if = |condition: bool| Change::Times(if condition { 1.0 + size } else { 1.0 });
    Some(match cause {
        Cause::Effect(id) => match id {
            EffectId::StressDependentFriction => {
                Change::Friction(-size * (at.depth_m / span.depth_m).log10())
            }
            EffectId::InsertionLoosening => {
                let fade = |z: f64| 1.0 / (1.0 + (z / detail).powi(2));
                Change::Friction(-(size * fade(at.depth_m) / fade(span.depth_m)).min(18.0))
            }
            EffectId::InterfaceFrictionOffset => Change::Interface(size),
            EffectId::DepthOffset => Change::Depth(size),
            EffectId::ToolAngleOffset => Change::ToolAngle(size),
            EffectId::SurfaceSlope => Change::Slope(size * (row.base_deg? - detail).to_radians().cos()),
            EffectId::ProgressiveFailure => {
                Change::Times(1.0 - size * ((row.alpha_deg - 72.0) / 18.0).clamp(0.0, 1.0).powi(2))
            }
            EffectId::Cohesion => Change::Plus(sticking(size)),
            EffectId::MoistureDrying => Change::Plus(sticking(size * (1.0 - time / (2.2 * detail)).max(0.0))),
            EffectId::SurchargeHeap => {
                Change::Times(1.0 + 2.0 * size / (soil.unit_weight_n_m3() * row.depth_m))
            }
            EffectId::SideEffects3d => Change::Times(1.0 + size * row.depth_m / row.width_m),
            EffectId::RateEffect => Change::Times(1.0 + size * (row.speed_mps? / 0.01).ln()),
            EffectId::TipBearing => {
                let wedge = (lean.cos() / 70f64.to_radians().cos()).max(0.0);
                Change::Times(1.0 + size * wedge.powf(1.2) * span.depth_m / row.depth_m)
            }
            EffectId::ForceScale => Change::Times(1.0 + size),
            EffectId::ForceBias => Change::Plus(size),
            EffectId::ForceDrift => Change::Plus(size * time),
            EffectId::FtCrosstalk => {
                let (sin, cos) = at.delta_deg.to_radians().sin_cos();
                Change::Times(cos.hypot(sin + size * cos))
            }
            EffectId::DensityGradient => Change::Times((size * (row.depth_m - span.depth_m)).exp()),
            EffectId::PreparationDrift => Change::Times((1.0 + size).powf(batch)),
            EffectId::RadiusDependence => Change::Times(1.0 + size * (row.radius_m? - 0.3048) / 0.127),
            EffectId::BaseAngleDependence => {
                let x = row.base_deg? / 35.0;
                Change::Times((if detail < 1.5 { size * 0.5 * x } else { size * x.abs() }).exp())
            }
            EffectId::AdjacentStroke => {
                Change::Times(1.0 + size * row.gap_prior_m.map_or(0.0, |d| fading(d, detail)))
            }
            EffectId::WallProximity => Change::Times(1.0 + size * fading(row.wall_m?, detail)),
            // The force model itself is another one.
            EffectId::ModelForm
            | EffectId::CableFlex
            | EffectId::Backlash
            | EffectId::BackdriveFriction
            | EffectId::EncoderQuantisation => Change::Nothing,
        },
        Cause::Outside(outside) => match outside {
            Outside::OneOffBatches => only_if(batch > detail && batch < detail + 0.35),
            Outside::BaseWaves => Change::Times(1.0 + size * (row.base_deg? / 9.0).sin()),
            Outside::AlphaByDepth => {
                let (a, d) = ((row.alpha_deg - 85.0) / 11.0, (row.depth_m / span.depth_m - 1.0) / 0.25);
                Change::Times((size * a * d).exp())
            }
            Outside::MiddleSpeed => only_if((row.speed_mps? - 0.01).abs() < 1e-3),
            Outside::WarmAfternoon => Change::Times(1.0 + size * (TAU * (1.5 * time + detail)).sin()),
            Outside::MiddleDepth => only_if((row.depth_m / span.depth_m - 0.98).abs() < 0.2),
        },
    })
}

/// 1 at no distance, faster down than an exponential near it and slower far away.
fn fading(distance: f64, decay: f64) -> f64 {
    1.0 / (1.0 + distance / decay).powf(1.6)
}
