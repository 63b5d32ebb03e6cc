//! What an experimenter would write about a campaign: `campaign.json`.

use soilctl_strokes::{Campaign, Instrument};

use crate::{Plan, step};

/// Of the slope after the break from one tool angle to the next: at 70 deg the plate rises and heaps, 0.5, at 90 deg it does not.
const POST_SLOPE_SD: f64 = 0.3;

/// The description of a simulated campaign: what plan, plant file and preparation say, nothing of what is true.
pub(crate) fn campaign(plan: &Plan) -> Campaign {
    let (soil, arm) = (plan.soil(), plan.plant().arm().config());
    let elbow_m = arm.links.forearm_m + arm.links.hand_m;
    let usual = Instrument::default();
    Campaign {
        density_sd_rel: soil.density_sd_rel,
        plate_thickness_m: arm.plate.thickness_m,
        dense_preparation: soil.relative_density(soil.density_kg_m3) > 0.5,
        design: plan.file().design.clone(),
        instrument: Instrument {
            joint_stiffness_n_per_m: arm.flexion.elbow_stiffness_nm_per_rad / (elbow_m * elbow_m),
            encoder_step_m: step::at_plate_m(plan).unwrap_or(usual.encoder_step_m),
            post_slope_sd: POST_SLOPE_SD,
            ..usual
        },
        ..Campaign::default()
    }
}
