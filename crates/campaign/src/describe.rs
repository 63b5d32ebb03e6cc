//! What an experimenter would write about a campaign: `campaign.json`.

use soilctl_strokes::{Campaign, Instrument};

use crate::Plan;

/// The description of a simulated campaign: what plan, plant file and preparation say, nothing of what is true.
pub(crate) fn campaign(plan: &Plan) -> Campaign {
    let plant = plan.plant().config();
    let (soil, arm) = (plan.soil(), plan.plant().arm().config());
    let strokes = plan.strokes().strokes();
    #[allow(clippy::cast_precision_loss, reason = "at most 1024 strokes")]
    let radius_m = strokes.iter().map(|stroke| stroke.radius_m).sum::<f64>() / strokes.len().max(1) as f64;
    let elbow_m = arm.links.forearm_m + arm.links.hand_m;
    Campaign {
        density_sd_rel: soil.density_sd_rel,
        plate_thickness_m: arm.plate.thickness_m,
        dense_preparation: soil.relative_density(soil.density_kg_m3) > 0.5,
        design: plan.file().design.clone(),
        instrument: Instrument {
            joint_stiffness_n_per_m: arm.flexion.elbow_stiffness_nm_per_rad / (elbow_m * elbow_m),
            encoder_step_m: std::f64::consts::TAU * radius_m
                / plant.encoders.external_counts_per_turn[1].abs(),
            ..Instrument::default()
        },
        ..Campaign::default()
    }
}
