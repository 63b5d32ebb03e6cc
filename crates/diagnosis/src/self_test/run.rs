//! Cases of the self-test and how one of them ends.

use soilctl_earth_pressure::model;
use soilctl_effects::catalogue;
use soilctl_strokes::StrokeRow;

use super::campaign::{HiddenCampaign, generate};
use super::design::Design;
use super::hidden::{OUTSIDE, draw};
use super::random::Random;
use crate::data::Data;
use crate::setup::Setup;
use crate::surface::Surface;
use crate::testability::{lambda, stroke_sd};
use crate::{Diagnosis, DiagnosisError, Status, diagnose};

/// What a case is a test of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Nothing is hidden.
    Null,
    /// One effect, all columns.
    Single,
    /// One effect, forces alone.
    SingleForces,
    /// Two effects.
    Pair,
    /// An effect outside the catalogue.
    Outside,
    /// One effect in a design that cannot tell it from others: one width, one speed, forces alone.
    Confounded,
}

/// One hidden campaign to be drawn.
#[derive(Debug, Clone)]
pub struct Case {
    /// What it tests.
    pub kind: Kind,
    /// Its number, which with the seed says everything random about it.
    pub number: u64,
    /// Ids of what is hidden.
    pub ids: Vec<&'static str>,
    /// Its design.
    pub design: Design,
}

/// How a case ended.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The campaign.
    pub campaign: HiddenCampaign,
    /// Squared signal-to-noise ratio of what is hidden, one by one.
    pub lambdas: Vec<f64>,
    /// What the diagnosis said.
    pub diagnosis: Diagnosis,
    /// What it said of a confounded design once its follow-up was made; `None` if it was not asked for.
    pub followed: Option<Diagnosis>,
}

/// Effects that one width, one speed and forces alone do not tell from each other.
const CONFOUNDED: [&str; 8] = [
    "side_effects_3d",
    "density_gradient",
    "cohesion",
    "stress_dependent_friction",
    "surface_slope",
    "base_angle_dependence",
    "force_bias",
    "preparation_drift",
];

/// Draws of a soil and an amplitude until there is a force for every stroke.
const ATTEMPTS: u64 = 20;

/// The force model and its surface, shared by all cases.
pub struct SelfTest {
    model: String,
    surface: Surface,
    seed: u64,
}

/// Cases in a fixed order; `rounds` times as many as there are kinds of hidden effects.
#[must_use]
pub fn cases(rounds: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    let ids: Vec<&'static str> = catalogue().iter().map(|effect| effect.id()).collect();
    let mut number = 0;
    let mut push = |kind, ids: Vec<&'static str>, design: Design| {
        number += 1;
        cases.push(Case { kind, number, ids, design });
    };
    for round in 0..rounds {
        for k in 0..12 {
            let design = Design {
                scatter: if k % 3 == 2 { 0.1 } else { 0.06 },
                true_model: [None, Some("chen"), None, Some("log-spiral"), None, Some("caquot")][k % 6],
                traces: k % 4 != 3,
                ..Design::default()
            };
            push(Kind::Null, Vec::new(), design);
        }
        for &id in &ids {
            push(Kind::Single, vec![id], Design::default());
        }
        for &effect in catalogue().iter().filter(|effect| effect.acts_on_force()) {
            push(Kind::SingleForces, vec![effect.id()], Design { traces: false, ..Design::default() });
        }
        for k in 0..12_usize {
            let step = 1 + (round as usize * 7 + k * 5) % (ids.len() - 1);
            let first = (round as usize * 11 + k * 3) % ids.len();
            push(Kind::Pair, vec![ids[first], ids[(first + step) % ids.len()]], Design::default());
        }
        for (k, id) in OUTSIDE.into_iter().enumerate() {
            push(
                Kind::Outside,
                vec![id],
                Design { traces: (round as usize + k).is_multiple_of(2), ..Design::default() },
            );
        }
        for id in CONFOUNDED {
            let design = Design {
                widths_m: vec![0.127],
                speeds_mps: vec![0.01],
                depths_m: vec![0.0169, 0.0212, 0.0254],
                traces: false,
                ..Design::default()
            };
            push(Kind::Confounded, vec![id], design);
        }
    }
    cases
}

impl SelfTest {
    /// Prepares a self-test against a force model.
    ///
    /// # Errors
    /// [`DiagnosisError::Model`] if there is no such model.
    pub fn new(model_id: &str, seed: u64) -> Result<Self, DiagnosisError> {
        let surface = Surface::new(model(model_id)?, (70.0, 100.0))?;
        Ok(Self { model: model_id.into(), surface, seed })
    }

    /// The hidden campaign of a case; `None` if the drawn soil has no finite force.
    ///
    /// # Errors
    /// [`DiagnosisError`] if the force model fails.
    pub fn campaign(&self, case: &Case) -> Result<Option<HiddenCampaign>, DiagnosisError> {
        for attempt in 0..ATTEMPTS {
            let mut random = self.stream(case, attempt);
            let hidden = case.ids.iter().map(|&id| draw(id, &mut random)).collect();
            if let Some(mut found) = generate(&case.design, &self.model, hidden, &mut random)? {
                found.attempt = attempt;
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    fn stream(&self, case: &Case, attempt: u64) -> Random {
        Random::new(self.seed, case.number + (attempt << 32))
    }
}

/// Draws and diagnoses one case.
///
/// # Errors
/// [`DiagnosisError`] if the diagnosis fails.
pub fn run_case(test: &SelfTest, case: &Case) -> Result<Option<Outcome>, DiagnosisError> {
    let Some(campaign) = test.campaign(case)? else { return Ok(None) };
    let data = Data::new("hidden campaign", campaign.rows.clone(), campaign.campaign.clone())?;
    let diagnosis = diagnose(&data, &test.surface)?;
    let lambdas = case.ids.iter().map(|id| signal(test, &data, &campaign, case, id)).collect();
    let mut followed = None;
    if let (Kind::Confounded, Status::Ambiguous, Some(next)) = (case.kind, diagnosis.status, &diagnosis.next)
        && let Some(rows) = campaign.followed_by(&next.rows, case.number)?
    {
        let data = Data::new("hidden campaign with its follow-up", rows, campaign.campaign.clone())?;
        followed = Some(diagnose(&data, &test.surface)?);
    }
    Ok(Some(Outcome { campaign, lambdas, diagnosis, followed }))
}

/// Squared signal-to-noise ratio of one hidden effect: in its own channel if no force shows it.
fn signal(test: &SelfTest, data: &Data, campaign: &HiddenCampaign, case: &Case, id: &str) -> f64 {
    let instrument = &campaign.campaign.instrument;
    let size = campaign.hidden.iter().find(|h| h.id == id).map_or(0.0, |h| h.size);
    let n = data.len() as f64;
    let seen = |shift: f64, sd: f64| if case.design.traces { n * (shift / sd).powi(2) } else { 0.0 };
    match id {
        "cable_flex" => {
            let mean = |f: &dyn Fn(&StrokeRow) -> f64| data.rows.iter().map(f).sum::<f64>() / n;
            let (force, depth) = (mean(&|r| r.force_n), mean(&|r| r.depth_m));
            let spread = mean(&|r| (r.force_n - force).powi(2)).sqrt();
            return seen(size * spread, 0.12 * 0.15 * depth);
        }
        "backlash" => return seen(size, instrument.gap_sd),
        "backdrive_friction" => return seen(size, instrument.cmd_sd),
        "encoder_quantisation" => return seen(size - instrument.encoder_step_m, 0.03 * size),
        _ => {}
    }
    let setup = Setup::new(data, &test.surface, data.phi.mean);
    let mut sd = stroke_sd(&setup, Some(case.design.scatter));
    sd.iter_mut().for_each(|s| *s = s.max(1e-3));
    let change: Vec<f64> = if campaign.hidden.len() == 1 {
        campaign.ln_true.iter().zip(&campaign.ln_plain).map(|(a, b)| a - b).collect()
    } else {
        let alone =
            Case { ids: vec![*case.ids.iter().find(|known| **known == id).unwrap_or(&"")], ..case.clone() };
        match test.alone(&alone, campaign, id) {
            Ok(Some(change)) => change,
            _ => return 0.0,
        }
    };
    // The soil that is really there, about which the priors are put.
    lambda(&setup, data.phi.mean.clamp(33.0, 42.0), &change, &sd).unwrap_or(0.0)
}

impl SelfTest {
    /// Change of ln force by one of several hidden effects alone, in the same soil.
    fn alone(
        &self,
        case: &Case,
        campaign: &HiddenCampaign,
        id: &str,
    ) -> Result<Option<Vec<f64>>, DiagnosisError> {
        let hidden: Vec<_> = campaign.hidden.iter().copied().filter(|h| h.id == id).collect();
        let mut random = self.stream(case, campaign.attempt);
        // The same draws as in the campaign come first, so that soil and geometry are the same.
        for h in &campaign.hidden {
            draw(h.id, &mut random);
        }
        let found = generate(&case.design, &self.model, hidden, &mut random)?;
        Ok(found.map(|one| one.ln_true.iter().zip(&one.ln_plain).map(|(a, b)| a - b).collect()))
    }
}

impl Outcome {
    /// Ids that the diagnosis gave, best first.
    #[must_use]
    pub fn given(&self) -> Vec<&'static str> {
        self.diagnosis.effects.iter().map(|effect| effect.id).collect()
    }

    /// Whether the diagnosis is firm.
    #[must_use]
    pub fn firm(&self) -> bool {
        self.diagnosis.status == Status::Named
    }
}
