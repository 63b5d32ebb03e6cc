//! Trace-derived columns of hidden campaigns.

use soilctl_effects::{DriveSite, SensorSite, Site, SoilSite, SurfaceSite};
use soilctl_strokes::{Campaign, Instrument, StrokeRow};

use super::cause::Cause;
use super::hidden::{Hidden, Span, TrueSoil};
use super::random::Random;

/// What columns read without effects, which differs from campaign to campaign. Ranges: empirical, as loose and dense sand read in
/// strokes of this size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Baselines {
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
        ..Instrument::default()
    }
}

impl Baselines {
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

/// What columns show of the causes that are hidden.
#[derive(Default)]
struct Shown {
    zero_n: f64,
    crosstalk: f64,
    step_m: f64,
    interface_deg: f64,
    drive_friction_n: f64,
    free_play_m: f64,
    compliance_m_per_n: f64,
    load_pa: f64,
    deficit: f64,
    loosened_deg: f64,
}

impl Shown {
    /// `time` goes from 0 (first stroke) to 1 (last).
    fn of(hidden: &[Hidden], time: f64) -> Self {
        let mut shown = Self::default();
        for h in hidden {
            let id = match h.cause {
                Cause::Effect(id) => id,
                Cause::Outside(_) => continue,
            };
            match id.effect().site {
                Site::Sensor(SensorSite::ForceZero) => shown.zero_n += h.size,
                Site::Sensor(SensorSite::ForceZeroDrift) => shown.zero_n += h.size * time,
                Site::Sensor(SensorSite::Crosstalk) => shown.crosstalk += h.size,
                Site::Sensor(SensorSite::EncoderStep) => shown.step_m = h.size,
                Site::Interface => shown.interface_deg += h.size,
                Site::Drive(DriveSite::Friction) => shown.drive_friction_n += h.size,
                Site::Drive(DriveSite::FreePlay) => shown.free_play_m += h.size,
                Site::Drive(DriveSite::Stretch) => shown.compliance_m_per_n += h.size,
                Site::Surface(SurfaceSite::Load) => shown.load_pa += h.size,
                Site::Soil(SoilSite::Mobilisation) => shown.deficit += h.size,
                Site::Soil(SoilSite::Loosening) => shown.loosened_deg += h.size,
                Site::Soil(SoilSite::Strength)
                | Site::Surface(SurfaceSite::Height | SurfaceSite::Slope)
                | Site::Sensor(SensorSite::ForceGain | SensorSite::ToolAngle)
                | Site::Model => {}
            }
        }
        shown
    }
}

/// Fills the columns of a row that has a force.
pub(super) fn fill(
    row: &mut StrokeRow,
    hidden: &[Hidden],
    soil: &TrueSoil,
    span: &Span,
    campaign: &Campaign,
    baselines: &Baselines,
    random: &mut Random,
) {
    let i = &campaign.instrument;
    let time = row.time_s.map_or(0.0, |t| (t - span.time_s.0) / (span.time_s.1 - span.time_s.0));
    let shown = Shown::of(hidden, time);
    row.tare_before_n = Some(shown.zero_n + random.normal(i.tare_sd));
    row.tare_after_n = Some(shown.zero_n + random.normal(i.tare_sd));
    row.cmd_minus_force_n = Some(shown.drive_friction_n + random.normal(i.cmd_sd));
    let read = (soil.delta_deg + shown.interface_deg).to_radians().tan() + shown.crosstalk;
    row.friction_angle_deg = Some((read.atan().to_degrees() + random.normal(i.friction_angle_sd)).max(0.1));
    row.z_drift_m = Some(8e-5 * shown.interface_deg + random.normal(i.z_sd));
    let gradual = shown.deficit * ((row.alpha_deg - 72.0) / 18.0).clamp(0.0, 1.0);
    let loosened = (shown.loosened_deg / 6.0).min(1.0);
    let scatter = baselines.soil_scatter;
    let displacement =
        row.depth_m * baselines.mobilisation * (1.0 + 4.0 * gradual) * (1.0 + random.normal(0.12 * scatter))
            + shown.compliance_m_per_n * row.force_n;
    row.displacement_at_failure_m = Some(displacement.max(1e-5));
    let drop = baselines.post_slope * (1.0 - (3.0 * gradual).min(0.9)) * (1.0 - loosened);
    row.post_slope_norm = Some(drop + 0.5 * gradual + random.normal(0.1 * scatter));
    let residual = baselines.residual
        + (1.0 - baselines.residual) * loosened
        + 0.4 * gradual * (1.0 - baselines.residual);
    row.residual_ratio = Some((residual + random.normal(0.04 * scatter)).max(0.05));
    let heap = shown.load_pa / (soil.density_kg_m3 * 9.81);
    row.heap_height_m = Some(heap * (1.0 + random.normal(0.1)) + random.normal(i.heap_sd));
    row.motor_ext_gap_m =
        Some(row.force_n / baselines.stiffness_n_per_m + shown.free_play_m + random.normal(i.gap_sd));
    let step = shown.step_m.max(i.encoder_step_m);
    row.x_step_m = Some((step * (1.0 + random.normal(0.03))).max(1e-6));
}
