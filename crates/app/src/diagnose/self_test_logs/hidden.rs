//! What is hidden in a campaign of logs: its soil, its arm, and an effect or none. All of it follows from the seed and the number.

use std::fmt::Write as _;

use soilctl_diagnosis::self_test::{Random, hidden_size};
use soilctl_effects::{EffectId, ModelFile, ParameterValue, Reference, SoilEntry};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use super::super::learn::with;

/// Preparations of a campaign and strokes in each.
pub(super) const BATCHES: usize = 4;
pub(super) const STROKES: usize = 3;
/// Standard deviation of the friction angle that a direct shear test tells, deg, and of the densities of preparations, relative: small, so that
/// what the twin learns of a soil, for densities in steps of 50 kg/m3, serves all campaigns in it.
pub(super) const PHI_SD_DEG: f64 = 1.0;
const DENSITY_SD_REL: f64 = 0.005;

/// What a campaign may hide, in turn: nothing every third time.
const HIDDEN: [Option<EffectId>; 12] = [
    None,
    Some(EffectId::ForceDrift),
    Some(EffectId::InterfaceFrictionOffset),
    None,
    Some(EffectId::ForceBias),
    Some(EffectId::Backlash),
    None,
    Some(EffectId::FtCrosstalk),
    Some(EffectId::ProgressiveFailure),
    None,
    Some(EffectId::ForceScale),
    Some(EffectId::CableFlex),
];

/// A preset with what is known of it beforehand: friction angle (deg) and density (kg/m3), and the set-point of its strokes (deg).
struct Sand {
    preset: &'static str,
    phi_deg: f64,
    density_kg_m3: f64,
    set_deg: f64,
}

const SANDS: [Sand; 4] = [
    Sand { preset: "ticino_loose", phi_deg: 42.0, density_kg_m3: 1450.0, set_deg: 23.0 },
    Sand { preset: "ticino_rained", phi_deg: 44.0, density_kg_m3: 1600.0, set_deg: 23.0 },
    Sand { preset: "nevada_fine", phi_deg: 42.0, density_kg_m3: 1450.0, set_deg: 27.0 },
    Sand { preset: "glass_beads", phi_deg: 30.0, density_kg_m3: 1450.0, set_deg: 19.0 },
];

/// A campaign that hides something.
pub(super) struct Case {
    /// Its number, from 0.
    pub(super) number: u64,
    /// Seed of its noise.
    pub(super) seed: u64,
    /// The effect, with its amplitude in the unit of its parameter.
    pub(super) hidden: Option<(EffectId, f64)>,
    /// Name of its soil's preset.
    pub(super) soil: &'static str,
    /// Its plan.
    pub(super) plan: String,
    /// The arm, as the text of a plant file.
    pub(super) plant: String,
    /// Friction angle that a shear test told, deg.
    pub(super) told_phi_deg: f64,
    /// The true soil, with the effect.
    pub(super) truth: ModelFile,
}

impl Case {
    /// The campaign of a number; `only` is what it is to hide, if it is not its turn that says so.
    pub(super) fn new(
        seed: u64,
        number: u64,
        only: Option<Option<EffectId>>,
        model: &str,
    ) -> Result<Self, crate::AppError> {
        let mut random = Random::new(seed, number + 1);
        let turn = (number % HIDDEN.len() as u64) as usize;
        let id = only.unwrap_or_else(|| HIDDEN.get(turn).copied().flatten());
        // The soils in turn, one further in each round of what is hidden, so that each effect meets each of them.
        let place = (number + number / HIDDEN.len() as u64) as usize % SANDS.len();
        let sand = SANDS.get(place).unwrap_or(&SANDS[0]);
        let hidden = id.map(|id| (id, hidden_size(id, &mut random)));
        let phi_deg = sand.phi_deg + random.normal(PHI_SD_DEG);
        let density_kg_m3 = sand.density_kg_m3 * (1.0 + random.normal(DENSITY_SD_REL));
        let plant = soilctl_campaign::unlike_plant(&mut || random.unit())?;
        let plain = truth(model, phi_deg, density_kg_m3, sand.set_deg);
        let truth = match hidden {
            Some((id, size)) => with(&plain, id.effect(), size),
            None => plain,
        };
        Ok(Self {
            number,
            seed: seed.wrapping_mul(1_000).wrapping_add(number),
            hidden,
            soil: sand.preset,
            plan: plan(sand, model),
            plant,
            told_phi_deg: sand.phi_deg,
            truth,
        })
    }

    /// What it hides, in words.
    pub(super) fn named(&self) -> &'static str {
        self.hidden.map_or("none", |(id, _)| id.name())
    }
}

/// Two tool angles at two radii: one of these goes with the preparation, both with the place in it.
fn plan(sand: &Sand, model: &str) -> String {
    let mut text = format!(
        "version = 1\ndesign = \"hidden campaign\"\nsoil = \"{}\"\nmodel = \"{model}\"\nplant = \"plant.toml\"\n\
         preparation = {{ density_sd_rel = {DENSITY_SD_REL} }}\n",
        sand.preset
    );
    for batch in 0..BATCHES {
        text += "[[batches]]\nstrokes = [\n";
        let radius_m = if batch < BATCHES / 2 { 0.4318 } else { 0.3048 };
        for stroke in 0..STROKES {
            let base_deg = 25.0 * (stroke as f64 - 1.0);
            let (alpha_deg, depth_m) =
                if (batch + stroke) % 2 == 0 { (90.0, 0.0254) } else { (80.0, 0.02501) };
            // Writing to a text cannot fail.
            let _ = writeln!(
                text,
                "    {{ radius_m = {radius_m}, base_deg = {base_deg:.1}, alpha_deg = {alpha_deg:.1}, depth_m = {depth_m}, \
                 delta_set_deg = {:.1} }},",
                sand.set_deg
            );
        }
        text += "]\n";
    }
    text
}

/// A model file of a soil whose interface friction is the set-point.
fn truth(model: &str, phi_deg: f64, density_kg_m3: f64, set_deg: f64) -> ModelFile {
    let value = |value: f64, unit: &str| ParameterValue { value, sd: 0.0, unit: unit.to_owned() };
    ModelFile {
        schema: soilctl_effects::FILE_SCHEMA.to_owned(),
        model: model.to_owned(),
        status: "hand".to_owned(),
        soil: SoilEntry {
            phi_deg: value(phi_deg, "deg"),
            delta_deg: value(set_deg, "deg"),
            delta_offset_deg: value(0.0, "deg"),
            density_kg_m3: value(density_kg_m3, "kg/m3"),
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
        },
        effects: Vec::new(),
        empirical: Vec::new(),
        equivalence_set: Vec::new(),
        reference: Reference {
            depth_m: 0.025,
            alpha_deg: 85.0,
            delta_set_deg: Some(set_deg),
            speed_mps: None,
            time_s: None,
            base_deg: Some((-25.0, 25.0)),
            batches: Vec::new(),
        },
        data_hash: String::new(),
        held_out: None,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::path::Path;

    use soilctl_campaign::Plan;

    use super::*;

    /// Every soil has a plan that the arm can make; the same seed and number give the same campaign, another number another one.
    #[test]
    fn campaigns_can_be_made_and_made_again() {
        let folder = tempfile::tempdir().unwrap();
        for number in 0..4 {
            let case = Case::new(7, number, Some(Some(EffectId::ForceDrift)), "table").unwrap();
            std::fs::write(folder.path().join("plant.toml"), &case.plant).unwrap();
            let plan = Plan::from_toml(&case.plan, "plan", folder.path()).unwrap();
            assert_eq!((plan.batches(), plan.strokes().strokes().len()), (BATCHES, BATCHES * STROKES));
            assert_ne!(
                plan.plant().config(),
                Plan::from_toml(&case.plan.replace("plant.toml", "default"), "p", Path::new(""))
                    .unwrap()
                    .plant()
                    .config()
            );
            let again = Case::new(7, number, Some(Some(EffectId::ForceDrift)), "table").unwrap();
            assert_eq!((&again.plant, &again.truth), (&case.plant, &case.truth));
            assert_ne!(Case::new(7, number + 1, None, "table").unwrap().plant, case.plant);
        }
        // In four rounds each effect meets each soil once, and nothing each of them four times.
        let mut met: Vec<(&str, &str)> = (0..48)
            .map(|number| Case::new(1, number, None, "table").unwrap())
            .map(|case| (case.named(), case.soil))
            .collect();
        met.sort_unstable();
        assert_eq!(met.chunk_by(|a, b| a == b).map(<[_]>::len).filter(|count| *count == 1).count(), 32);
        assert_eq!(met.chunk_by(|a, b| a == b).map(<[_]>::len).filter(|count| *count == 4).count(), 4);
        // A third hides nothing, and that comes first.
        let turns: Vec<bool> =
            (0..12).map(|n| Case::new(1, n, None, "table").unwrap().hidden.is_none()).collect();
        assert!(turns[0] && turns.iter().filter(|none| **none).count() == 4);
    }
}
