//! Trace-derived columns of hidden campaigns.

use soilctl_strokes::{Campaign, Instrument, StrokeRow};

use super::hidden::{Hidden, Span, World};
use super::random::Random;

/// Baselines that differ from campaign to campaign.
#[derive(Debug, Clone, Copy)]
pub(super) struct Habits {
    mobilisation: f64,
    post_slope: f64,
    residual: f64,
    stiffness_n_per_m: f64,
    soil_scatter: f64,
}

/// Draws an instrument.
pub(super) fn instrument(random: &mut Random) -> Instrument {
    Instrument {
        friction_angle_sd: random.between(1.0, 2.0),
        z_sd: random.between(2e-4, 5e-4),
        tare_sd: random.between(0.03, 0.08),
        heap_sd: random.between(5e-4, 1.5e-3),
        gap_sd: random.between(1e-4, 3e-4),
        cmd_sd: random.between(0.2, 0.5),
        joint_stiffness_n_per_m: random.between(6e3, 1.5e4),
        encoder_step_m: 2.5e-4,
        post_slope_sd: 0.0,
    }
}

impl Habits {
    pub(super) fn draw(campaign: &Campaign, dense: bool, random: &mut Random) -> Self {
        Self {
            mobilisation: if dense { random.between(0.04, 0.07) } else { random.between(0.14, 0.26) },
            post_slope: if dense { random.between(-1.0, -0.5) } else { random.between(-0.2, 0.05) },
            residual: if dense { random.between(0.65, 0.8) } else { random.between(0.92, 1.02) },
            stiffness_n_per_m: campaign.instrument.joint_stiffness_n_per_m * random.between(0.8, 1.25),
            soil_scatter: random.between(0.8, 1.2),
        }
    }
}

/// Fills the columns of a row that has a force.
pub(super) fn fill(
    row: &mut StrokeRow,
    hidden: &[Hidden],
    world: &World,
    span: &Span,
    campaign: &Campaign,
    habits: &Habits,
    random: &mut Random,
) {
    let i = &campaign.instrument;
    let size = |id: &str| hidden.iter().find(|h| h.id == id).map_or(0.0, |h| h.size);
    let time = row.time_s.map_or(0.0, |t| (t - span.time_s.0) / (span.time_s.1 - span.time_s.0));
    let zero = size("force_bias") + size("force_drift") * time;
    row.tare_before_n = Some(zero + random.normal(i.tare_sd));
    row.tare_after_n = Some(zero + random.normal(i.tare_sd));
    row.cmd_minus_force_n = Some(size("backdrive_friction") + random.normal(i.cmd_sd));
    let lifted = size("interface_friction_offset");
    let read = (world.delta_deg + lifted).to_radians().tan() + size("ft_crosstalk");
    row.friction_angle_deg = Some((read.atan().to_degrees() + random.normal(i.friction_angle_sd)).max(0.1));
    row.z_drift_m = Some(8e-5 * lifted + random.normal(i.z_sd));
    let gradual = size("progressive_failure") * ((row.alpha_deg - 72.0) / 18.0).clamp(0.0, 1.0);
    let loosened =
        hidden.iter().find(|h| h.id == "insertion_loosening").map_or(0.0, |h| (h.size / 6.0).min(1.0));
    let scatter = habits.soil_scatter;
    let displacement =
        row.depth_m * habits.mobilisation * (1.0 + 4.0 * gradual) * (1.0 + random.normal(0.12 * scatter))
            + size("cable_flex") * row.force_n;
    row.displacement_at_failure_m = Some(displacement.max(1e-5));
    let drop = habits.post_slope * (1.0 - (3.0 * gradual).min(0.9)) * (1.0 - loosened);
    row.post_slope_norm = Some(drop + 0.5 * gradual + random.normal(0.1 * scatter));
    let residual =
        habits.residual + (1.0 - habits.residual) * loosened + 0.4 * gradual * (1.0 - habits.residual);
    row.residual_ratio = Some((residual + random.normal(0.04 * scatter)).max(0.05));
    let heap = size("surcharge_heap") / (world.density_kg_m3 * 9.81);
    row.heap_height_m = Some(heap * (1.0 + random.normal(0.1)) + random.normal(i.heap_sd));
    row.motor_ext_gap_m =
        Some(row.force_n / habits.stiffness_n_per_m + size("backlash") + random.normal(i.gap_sd));
    let step = size("encoder_quantisation").max(i.encoder_step_m);
    row.x_step_m = Some((step * (1.0 + random.normal(0.03))).max(1e-6));
}
