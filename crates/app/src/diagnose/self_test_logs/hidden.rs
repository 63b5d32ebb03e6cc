//! What is hidden in a campaign of logs: its soil, its arm, and an effect or none. All of it follows from the seed and the number.

use soilctl_diagnosis::self_test::{Random, hidden_size};
use soilctl_effects::{EffectId, ModelFile, ParameterValue, Reference, SoilEntry};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use super::super::learn::with;
use super::design::Design;
use super::outside::Outside;

/// Standard deviation of the friction angle that a direct shear test tells, deg, and of the densities of preparations, relative: small, so that
/// what the twin learns of a soil, for densities in steps of 50 kg/m3, serves all campaigns in it.
pub(super) const PHI_SD_DEG: f64 = 1.0;
pub(super) const DENSITY_SD_REL: f64 = 0.005;

/// What a campaign hides.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Hidden {
    /// Effects, each with its amplitude in the unit of its parameter; none hides nothing.
    Effects(Vec<(EffectId, f64)>),
    /// What no effect of the catalogue is, with its largest change of ln force.
    Outside(Outside, f64),
}

impl Hidden {
    /// Its parts by name, with their sizes.
    pub(super) fn parts(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Effects(all) => all.iter().map(|(id, size)| (id.name(), *size)).collect(),
            Self::Outside(of, size) => vec![(of.name(), *size)],
        }
    }

    /// Its name in answers and of its folder.
    pub(super) fn name(&self) -> String {
        joined(&self.parts().into_iter().map(|(name, _)| name).collect::<Vec<_>>())
    }
}

/// Names of what a campaign hides as one.
pub(super) fn joined(names: &[&str]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join("+") }
}

/// What all campaigns hide, or in which turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Nothing every third time, otherwise an effect in turn.
    InTurn,
    /// Nothing.
    Nothing,
    /// One effect.
    Effect(EffectId),
    /// Two effects at once, pairs in turn.
    Two,
    /// What no effect is, in turn.
    Outside,
}

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

/// Pairs of effects that are hidden at once, in turn: each of six effects that are found alone, with two others.
const PAIRS: [[EffectId; 2]; 6] = [
    [EffectId::ForceBias, EffectId::Backlash],
    [EffectId::ForceDrift, EffectId::InterfaceFrictionOffset],
    [EffectId::CableFlex, EffectId::ForceBias],
    [EffectId::FtCrosstalk, EffectId::Backlash],
    [EffectId::InterfaceFrictionOffset, EffectId::CableFlex],
    [EffectId::ForceDrift, EffectId::FtCrosstalk],
];

/// A preset with what is known of it beforehand: friction angle (deg) and density (kg/m3), and the set-point of its strokes (deg).
pub(super) struct Sand {
    pub(super) preset: &'static str,
    phi_deg: f64,
    density_kg_m3: f64,
    pub(super) set_deg: f64,
}

const SANDS: [Sand; 4] = [
    Sand { preset: "ticino_loose", phi_deg: 42.0, density_kg_m3: 1450.0, set_deg: 23.0 },
    Sand { preset: "ticino_rained", phi_deg: 44.0, density_kg_m3: 1600.0, set_deg: 23.0 },
    Sand { preset: "nevada_fine", phi_deg: 42.0, density_kg_m3: 1450.0, set_deg: 27.0 },
    Sand { preset: "glass_beads", phi_deg: 30.0, density_kg_m3: 1450.0, set_deg: 19.0 },
];

impl Sand {
    /// The one with the name of a preset.
    pub(super) fn named(preset: &str) -> Result<&'static Self, crate::AppError> {
        SANDS.iter().find(|sand| sand.preset == preset).ok_or_else(|| {
            let names = SANDS.each_ref().map(|sand| sand.preset).join(", ");
            crate::AppError::Request(format!("hidden campaigns are made in {names}, and not in {preset:?}"))
        })
    }
}

/// A campaign that hides something.
pub(super) struct Case {
    /// Its number, from 0.
    pub(super) number: u64,
    /// Seed of its noise.
    pub(super) seed: u64,
    /// What it hides.
    pub(super) hidden: Hidden,
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
    /// The campaign of a number.
    pub(super) fn new(
        seed: u64,
        number: u64,
        wanted: Wanted,
        (design, soil): (Design, Option<&Sand>),
        model: &str,
    ) -> Result<Self, crate::AppError> {
        let mut random = Random::new(seed, number + 1);
        let turn = (number % HIDDEN.len() as u64) as usize;
        let of_effects = |ids: &[EffectId], random: &mut Random| {
            Hidden::Effects(ids.iter().map(|id| (*id, hidden_size(*id, random))).collect())
        };
        // The soils in turn, one further in each round of what is hidden, so that each effect meets each of them.
        let place = (number + number / HIDDEN.len() as u64) as usize % SANDS.len();
        let sand = soil.unwrap_or(&SANDS[place]);
        let hidden = match wanted {
            Wanted::InTurn => of_effects(HIDDEN[turn].as_slice(), &mut random),
            Wanted::Nothing => Hidden::Effects(Vec::new()),
            Wanted::Effect(id) => of_effects(&[id], &mut random),
            Wanted::Two => of_effects(&PAIRS[number as usize % PAIRS.len()], &mut random),
            Wanted::Outside => {
                let of = Outside::ALL[number as usize % Outside::ALL.len()];
                Hidden::Outside(of, Outside::size(&mut random))
            }
        };
        let phi_deg = sand.phi_deg + random.normal(PHI_SD_DEG);
        let density_kg_m3 = sand.density_kg_m3 * (1.0 + random.normal(DENSITY_SD_REL));
        let plant = soilctl_campaign::unlike_plant(&mut || random.unit())?;
        let plain = truth(model, phi_deg, density_kg_m3, sand.set_deg, design);
        let truth = match &hidden {
            Hidden::Effects(all) => {
                all.iter().fold(plain, |file, (id, size)| with(&file, id.effect(), *size))
            }
            Hidden::Outside(of, size) => {
                ModelFile { empirical: vec![of.term(*size, design, &mut random)], ..plain }
            }
        };
        Ok(Self {
            number,
            seed: seed.wrapping_mul(1_000).wrapping_add(number),
            hidden,
            soil: sand.preset,
            plan: design.plan(sand, model),
            plant,
            told_phi_deg: sand.phi_deg,
            truth,
        })
    }
}

/// A model file of a soil whose interface friction is the set-point.
fn truth(model: &str, phi_deg: f64, density_kg_m3: f64, set_deg: f64, design: Design) -> ModelFile {
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
            batches: (0..design.batches()).map(|batch| batch.to_string()).collect(),
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
        let designs = [Design::Strokes12, Design::Strokes24, Design::Strokes48];
        for (number, design) in (0..4).flat_map(|number| designs.map(|design| (number, design))) {
            let drift = Wanted::Effect(EffectId::ForceDrift);
            let case = |number| Case::new(7, number, drift, (design, None), "table").unwrap();
            let (case, again, next) = (case(number), case(number), case(number + 1));
            std::fs::write(folder.path().join("plant.toml"), &case.plant).unwrap();
            let plan = Plan::from_toml(&case.plan, "plan", folder.path()).unwrap();
            assert_eq!((plan.batches(), plan.strokes().strokes().len()), (design.batches(), design.all()));
            assert_eq!(plan.apart().unwrap().strokes().strokes().len(), design.kinds());
            assert_ne!(
                plan.plant().config(),
                Plan::from_toml(&case.plan.replace("plant.toml", "default"), "p", Path::new(""))
                    .unwrap()
                    .plant()
                    .config()
            );
            assert_eq!((&again.plant, &again.truth), (&case.plant, &case.truth));
            assert_ne!(next.plant, case.plant);
        }
        let in_turn =
            |number| Case::new(1, number, Wanted::InTurn, (Design::default(), None), "table").unwrap();
        // In four rounds each effect meets each soil once, and nothing each of them four times.
        let mut met: Vec<(String, &str)> =
            (0..48).map(in_turn).map(|case| (case.hidden.name(), case.soil)).collect();
        met.sort_unstable();
        assert_eq!(met.chunk_by(|a, b| a == b).map(<[_]>::len).filter(|count| *count == 1).count(), 32);
        assert_eq!(met.chunk_by(|a, b| a == b).map(<[_]>::len).filter(|count| *count == 4).count(), 4);
        // A third hides nothing, and that comes first.
        let turns: Vec<bool> = (0..12).map(|number| in_turn(number).hidden.parts().is_empty()).collect();
        assert!(turns[0] && turns.iter().filter(|none| **none).count() == 4);
    }
}
