//! What is hidden in a campaign. The formulas are not those of the catalogue: other functions of the same kind,
//! so that a diagnosis that only inverts its own formulas does not get through.

use soilctl_effects::DirectMechanics;
use soilctl_strokes::StrokeRow;

use super::random::Random;

/// A hidden effect: an id of the catalogue, or one that is not in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hidden {
    /// Id.
    pub id: &'static str,
    /// Amplitude in the unit of the catalogue's parameter.
    pub size: f64,
    /// Decay length, azimuth or another detail.
    pub detail: f64,
}

/// Ids of hidden effects that no effect of the catalogue describes.
pub const OUTSIDE: [&str; 6] =
    ["one_off_batches", "base_waves", "alpha_by_depth", "middle_speed", "warm_afternoon", "middle_depth"];

/// Soil of a hidden campaign.
#[derive(Debug, Clone, Copy)]
pub(super) struct World {
    pub(super) phi_deg: f64,
    pub(super) delta_deg: f64,
    pub(super) density_kg_m3: f64,
}

/// Ends of a campaign that effects refer to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub(super) depth_m: f64,
    pub(super) time_s: (f64, f64),
    pub(super) batches: f64,
}

const GRAVITY: f64 = 9.806_65;

/// A random effect of a kind.
pub(super) fn draw(id: &'static str, random: &mut Random) -> Hidden {
    let r = random;
    let (size, detail) = match id {
        "stress_dependent_friction" => (r.between(3.0, 6.0), 0.0),
        "progressive_failure" => (r.between(0.05, 0.18), 0.0),
        "insertion_loosening" => (r.log_between(2.0, 15.0), r.log_between(0.01, 0.1)),
        "cohesion" => (r.log_between(10.0, 200.0), 0.0),
        "surcharge_heap" => (r.log_between(5.0, 150.0), 0.0),
        "surface_slope" => (r.between(2.0, 5.0), r.between(-180.0, 180.0)),
        "side_effects_3d" => (r.log_between(0.2, 3.0), 0.0),
        "rate_effect" => (r.between(0.02, 0.12), 0.0),
        "tip_bearing" => (r.between(0.05, 0.25), 0.0),
        "interface_friction_offset" => (r.sign() * r.between(3.0, 6.0), 0.0),
        "depth_offset" => (r.sign() * r.between(0.0005, 0.0025), 0.0),
        "tool_angle_offset" => (r.sign() * r.between(1.0, 5.0), 0.0),
        "force_scale" => (r.sign() * r.between(0.03, 0.15), 0.0),
        "force_bias" => (r.sign() * r.between(0.1, 0.5), 0.0),
        "force_drift" => (r.sign() * r.between(0.2, 0.8), 0.0),
        "ft_crosstalk" => (r.sign() * r.between(0.03, 0.12), 0.0),
        "density_gradient" => (r.log_between(0.05, 0.8) / 0.0254, 0.0),
        "preparation_drift" => (r.sign() * r.log_between(0.03, 0.4), 0.0),
        "radius_dependence" => (r.sign() * r.log_between(0.03, 0.35), 0.0),
        "base_angle_dependence" => (r.sign() * r.log_between(0.03, 0.35), r.choice(&[1.0, 2.0])),
        "adjacent_stroke" => (-r.between(0.1, 0.4), r.log_between(0.02, 0.15)),
        "wall_proximity" => (r.between(0.1, 0.5), r.log_between(0.02, 0.15)),
        "moisture_drying" => (r.log_between(20.0, 200.0), r.between(0.15, 1.0)),
        "model_form" => (1.0, 0.0),
        "cable_flex" => (r.between(2e-4, 8e-4), 0.0),
        "backlash" => (r.between(4e-4, 1.2e-3), 0.0),
        "backdrive_friction" => (r.between(1.1, 2.7), 0.0),
        "encoder_quantisation" => (r.between(1e-3, 2e-3), 0.0),
        "one_off_batches" => (r.sign() * r.between(0.1, 0.3), r.between(0.2, 0.7)),
        "alpha_by_depth" => (r.sign() * r.between(0.06, 0.15), 0.0),
        _ => (r.sign() * r.between(0.08, 0.25), r.between(0.0, 1.0)),
    };
    Hidden { id, size, detail }
}

/// Force in N without scatter; `None` where the force model has no answer.
pub(super) fn force_n(
    model: &DirectMechanics,
    world: &World,
    span: &Span,
    row: &StrokeRow,
    hidden: &[Hidden],
) -> Option<f64> {
    let (mut alpha, mut depth, mut phi, mut delta) =
        (row.alpha_deg, row.depth_m, world.phi_deg, world.delta_deg);
    let mut slope = 0.0;
    let unit_weight = world.density_kg_m3 * GRAVITY;
    for h in hidden {
        match h.id {
            "stress_dependent_friction" => phi -= h.size * (depth / span.depth_m).log10(),
            "insertion_loosening" => {
                let fade = |z: f64| 1.0 / (1.0 + (z / h.detail).powi(2));
                phi -= (h.size * fade(depth) / fade(span.depth_m)).min(18.0);
            }
            "interface_friction_offset" => delta = (delta + h.size).max(0.0),
            "depth_offset" => depth += h.size,
            "tool_angle_offset" => alpha += h.size,
            "surface_slope" => slope += h.size * (row.base_deg? - h.detail).to_radians().cos(),
            _ => {}
        }
    }
    let (low, high) = model.model().valid_range().phi_deg;
    let phi = phi.clamp(low.max(15.0), high.min(58.0));
    let slant = depth / alpha.to_radians().sin();
    let (ln_weight, _) = model.ln_weight(alpha, 0.0, phi, delta).ok()?;
    let mut force = 0.5 * unit_weight * slant * slant * row.width_m * ln_weight.exp() * (1.0 + 0.05 * slope);
    for h in hidden {
        force = alter(h, force, world, span, row, phi, delta)?;
    }
    // A force that the sensor reads the wrong way round is no stroke.
    (force > 0.15 && force.is_finite()).then_some(force)
}

/// The force after one more effect that acts on the force itself.
fn alter(
    h: &Hidden,
    force: f64,
    world: &World,
    span: &Span,
    row: &StrokeRow,
    phi: f64,
    delta: f64,
) -> Option<f64> {
    let unit_weight = world.density_kg_m3 * GRAVITY;
    let time = (row.time_s? - span.time_s.0) / (span.time_s.1 - span.time_s.0);
    let batch: f64 = row.batch.as_ref()?.trim_start_matches('b').parse().ok()?;
    let batch = (batch - 1.0) / (span.batches - 1.0).max(1.0);
    let lean = row.alpha_deg.to_radians();
    // Passive wedge with a rough back, Rankine's cohesion term.
    let sticking = |pascal: f64| {
        let passive = (0.25 * std::f64::consts::PI + 0.5 * phi.to_radians()).tan().powi(2);
        let rough =
            1.0 + 1.2 * delta.to_radians().tan() * lean.sin() + 1.5 * (row.alpha_deg - 90.0).to_radians();
        pascal * row.depth_m * row.width_m * 2.0 * passive.sqrt() * rough
    };
    Some(match h.id {
        "progressive_failure" => {
            force * (1.0 - h.size * ((row.alpha_deg - 72.0) / 18.0).clamp(0.0, 1.0).powi(2))
        }
        "cohesion" => force + sticking(h.size),
        "moisture_drying" => force + sticking(h.size * (1.0 - time / (2.2 * h.detail)).max(0.0)),
        "surcharge_heap" => force * (1.0 + 2.0 * h.size / (unit_weight * row.depth_m)),
        "side_effects_3d" => force * (1.0 + h.size * row.depth_m / row.width_m),
        "rate_effect" => force * (1.0 + h.size * (row.speed_mps? / 0.01).ln()),
        "tip_bearing" => {
            let wedge = (lean.cos() / 70f64.to_radians().cos()).max(0.0);
            force * (1.0 + h.size * wedge.powf(1.2) * span.depth_m / row.depth_m)
        }
        "force_scale" => force * (1.0 + h.size),
        "force_bias" => force + h.size,
        "force_drift" => force + h.size * time,
        "ft_crosstalk" => {
            let (sin, cos) = delta.to_radians().sin_cos();
            force * cos.hypot(sin + h.size * cos)
        }
        "density_gradient" => force * (h.size * (row.depth_m - span.depth_m)).exp(),
        "preparation_drift" => force * (1.0 + h.size).powf(batch),
        "radius_dependence" => force * (1.0 + h.size * (row.radius_m? - 0.3048) / 0.127),
        "base_angle_dependence" => {
            let x = row.base_deg? / 35.0;
            force * (if h.detail < 1.5 { h.size * 0.5 * x } else { h.size * x.abs() }).exp()
        }
        "adjacent_stroke" => force * (1.0 + h.size * row.gap_prior_m.map_or(0.0, |d| fading(d, h.detail))),
        "wall_proximity" => force * (1.0 + h.size * fading(row.wall_m?, h.detail)),
        "one_off_batches" => {
            force * if batch > h.detail && batch < h.detail + 0.35 { 1.0 + h.size } else { 1.0 }
        }
        "base_waves" => force * (1.0 + h.size * (row.base_deg? / 9.0).sin()),
        "alpha_by_depth" => {
            let (a, d) = ((row.alpha_deg - 85.0) / 11.0, (row.depth_m / span.depth_m - 1.0) / 0.25);
            force * (h.size * a * d).exp()
        }
        "middle_speed" => force * if (row.speed_mps? - 0.01).abs() < 1e-3 { 1.0 + h.size } else { 1.0 },
        "warm_afternoon" => force * (1.0 + h.size * (std::f64::consts::TAU * (1.5 * time + h.detail)).sin()),
        "middle_depth" => {
            force * if (row.depth_m / span.depth_m - 0.98).abs() < 0.2 { 1.0 + h.size } else { 1.0 }
        }
        _ => force,
    })
}

/// 1 at no distance, faster down than an exponential near it and slower far away.
fn fading(distance: f64, decay: f64) -> f64 {
    1.0 / (1.0 + distance / decay).powf(1.6)
}
