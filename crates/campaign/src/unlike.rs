//! Plants for tests of a twin: the one that it has, and others that it does not know.

use soilctl_plant::PlantParams;
use soilctl_plant::config::{LossLaw, MobilisationLaw, PlantConfig, TangentLaw};

use crate::CampaignError;

/// By which factor settings may be off, up or down, in a plant that is unlike the twin's: what nobody measures of sand (how its strength is
/// mobilised and lost, how stiff it is along the plate, how it heaps), friction of drives and sensors' noise, and the play and the
/// stretch of the drives by less than the effects `backlash` and `cable_flex` are at the least.
pub(crate) const SAND: f64 = 1.3;
pub(crate) const CONTACT: f64 = 1.6;
pub(crate) const FRICTION: f64 = 1.2;
const NOISE: f64 = 1.7;
const KNOWN: f64 = 1.03;
/// Ends of the part of a bracket where the true force lies, and greatest correlation of a sensor's readings 2 ms apart.
const FORCE_LAW: (f64, f64) = (0.3, 0.7);
const MOST_CORRELATED: f64 = 0.8;
/// Friction of a rotor at rest over that of one that turns, and the share of the soil that runs past the plate, in plants that have them.
const BREAKAWAY: f64 = 1.25;
const HEAP_PAST: f64 = 0.3;

/// The plant of the thesis's arm as the text of a plant file.
///
/// # Errors
/// [`CampaignError::Plan`] if it cannot be put into TOML.
pub fn default_plant() -> Result<String, CampaignError> {
    text(PlantParams::thesis().config())
}

/// The same with settings that are off in ways that a twin with the default plant does not know: other mobilisation, contact stiffness, loss of
/// strength, bearing, heaps, force law, friction of the drives, and noise with another size and spectrum; and every second time each of its
/// laws of mobilisation, of loss of strength, of friction along the plate, of heaps and of the drives' friction is of another form.
/// `draw` gives a number from 0 to 1.
///
/// # Errors
/// [`CampaignError::Plan`] if it cannot be put into TOML.
pub fn unlike_plant(draw: &mut dyn FnMut() -> f64) -> Result<String, CampaignError> {
    let mut plant = PlantParams::thesis().config().clone();
    let mut off = |value: &mut f64, most: f64| *value *= libm::pow(most, 2.0 * draw() - 1.0);
    let ground = &mut plant.ground;
    for value in [
        &mut ground.loose_mobilisation,
        &mut ground.dense_mobilisation,
        &mut ground.gradual_exponent,
        &mut ground.drastic_exponent,
        &mut ground.residual_drop,
        &mut ground.residual_way_m,
        &mut ground.bearing_shape,
        &mut ground.insertion_drift,
        &mut ground.misalignment_drift,
        &mut ground.heap_length,
        &mut plant.bodies.wall_friction,
    ] {
        off(value, SAND);
    }
    for value in [&mut ground.tangent_way_m, &mut ground.wedge_time_s, &mut ground.damping_ns_per_m] {
        off(value, CONTACT);
    }
    let drives = &mut plant.drives;
    for value in drives.friction_nm.iter_mut().chain(&mut drives.viscous_nms_per_rad) {
        off(value, FRICTION);
    }
    for value in drives.stiffness_nm_per_rad.iter_mut().chain(&mut drives.free_play_deg) {
        off(value, KNOWN);
    }
    let sensor = &mut plant.force_sensor;
    for value in [&mut sensor.noise_n, &mut sensor.noise_nm, &mut plant.amplifiers.current_noise_a] {
        off(value, NOISE);
    }
    plant.force_sensor.noise_correlation = MOST_CORRELATED * draw();
    let (low, high) = FORCE_LAW;
    plant.ground.bracket_fraction = low + (high - low) * draw();
    other_laws(&mut plant, draw);
    text(&plant)
}

/// Each of the plant's laws by another formula, or not, as it is drawn.
fn other_laws(plant: &mut PlantConfig, draw: &mut dyn FnMut() -> f64) {
    let mut other = || draw() > 0.5;
    if other() {
        plant.ground.mobilisation_law = MobilisationLaw::Hyperbola;
    }
    if other() {
        plant.ground.loss_law = LossLaw::Linear;
    }
    if other() {
        plant.ground.tangent_law = TangentLaw::Hyperbola;
    }
    if other() {
        plant.ground.heap_past = HEAP_PAST;
    }
    if other() {
        plant.drives.breakaway = BREAKAWAY;
    }
}

fn text(plant: &PlantConfig) -> Result<String, CampaignError> {
    let refused = |error: toml::ser::Error| CampaignError::Plan {
        file: "a plant for a test".to_owned(),
        problem: error.to_string(),
    };
    toml::to_string(plant).map_err(refused)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// Whatever is drawn, the plant is one, and the middle of all draws is the default but for force law and spectrum.
    #[test]
    fn every_draw_is_a_plant() {
        let arm = || PlantParams::thesis().arm().clone();
        let default = PlantParams::from_toml(arm(), &default_plant().unwrap(), "default").unwrap();
        assert_eq!(default.config(), PlantParams::thesis().config());
        for share in [0.0, 0.3, 1.0] {
            let other =
                PlantParams::from_toml(arm(), &unlike_plant(&mut || share).unwrap(), "other").unwrap();
            assert_ne!(other.config(), default.config());
        }
        let middle = PlantParams::from_toml(arm(), &unlike_plant(&mut || 0.5).unwrap(), "middle").unwrap();
        let mut expected = default.config().clone();
        expected.force_sensor.noise_correlation = 0.4;
        assert_eq!(*middle.config(), expected);
    }
}
