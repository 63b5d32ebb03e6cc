//! Effects on the drives, from what they amount to at the tip.

use soilctl_effects::DriveSite;
use soilctl_plant::config::PlantConfig;

use crate::Plan;

/// Changes the drives by an effect's amplitude, in the unit of its parameter.
pub(super) fn change(site: DriveSite, amplitude: f64, plan: &Plan, config: &mut PlantConfig) {
    let links = &plan.plant().arm().config().links;
    // From the elbow's axis to the tip, and from the shoulder's: horizontal ways of the tip come from there in a stroke.
    let elbow_m = links.forearm_m + links.hand_m;
    let shoulder_m = links.upper_arm_m;
    let drives = &mut config.drives;
    match site {
        // The cables are those of the elbow; its two motors share the load.
        DriveSite::Stretch => {
            for motor in [2, 3] {
                let stiffness = &mut drives.stiffness_nm_per_rad[motor];
                *stiffness = 1.0 / (1.0 / *stiffness + 2.0 * amplitude / (elbow_m * elbow_m));
            }
        }
        // The shoulder's external encoder sits on the joint; under load from one side half of the play is seen.
        DriveSite::FreePlay => drives.free_play_deg[1] += (2.0 * amplitude / shoulder_m).to_degrees(),
        DriveSite::Friction => {
            for motor in [2, 3] {
                drives.friction_nm[motor] += 0.5 * amplitude * elbow_m;
            }
        }
    }
}
