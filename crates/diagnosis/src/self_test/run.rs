//! Cases of the self-test and how one of them ends.

use soilctl_earth_pressure::model;
use soilctl_effects::{DriveSite, EffectId, SensorSite, Site, SoilSite, SurfaceSite};
use soilctl_strokes::StrokeRow;

use super::campaign::{HiddenCampaign, generate};
use super::cause::{Cause, Outside};
use super::design::Design;
use super::hidden::{Hidden, draw};
use super::random::Random;
use crate::data::Data;
use crate::setup::FitSetup;
use crate::surface::Surface;
use crate::testability::{lambda, stroke_sd};
use crate::{Diagnosis, DiagnosisError, Status, diagnose};

/// What a case is a test of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
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
    /// What is hidden.
    pub causes: Vec<Cause>,
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
const CONFOUNDED: [EffectId; 8] = [
    EffectId::SideEffects3d,
    EffectId::DensityGradient,
    EffectId::Cohesion,
    EffectId::StressDependentFriction,
    EffectId::SurfaceSlope,
    EffectId::BaseAngleDependence,
    EffectId::ForceBias,
    EffectId::PreparationDrift,
];

/// Most draws of a soil and an amplitude until there is a force for every stroke.
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
    let mut number = 0;
    let ids = EffectId::ALL;
    let mut push = |kind, causes: Vec<Cause>, design: Design| {
        number += 1;
        cases.push(Case { kind, number, causes, design });
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
        for id in ids {
            push(Kind::Single, vec![id.into()], Design::default());
        }
        for id in ids.into_iter().filter(|id| id.effect().acts_on_force()) {
            push(Kind::SingleForces, vec![id.into()], Design { traces: false, ..Design::default() });
        }
        for k in 0..12_usize {
            let step = 1 + (round as usize * 7 + k * 5) % (ids.len() - 1);
            let first = (round as usize * 11 + k * 3) % ids.len();
            let pair = [first, first + step].map(|i| ids[i % ids.len()].into());
            push(Kind::Pair, pair.to_vec(), Design::default());
        }
        for (k, outside) in Outside::ALL.into_iter().enumerate() {
            push(
                Kind::Outside,
                vec![Cause::Outside(outside)],
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
            push(Kind::Confounded, vec![id.into()], design);
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
            let hidden = case.causes.iter().map(|&cause| draw(cause, &mut random)).collect();
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
    let lambdas = campaign.hidden.iter().map(|of| signal(test, &data, &campaign, case, of)).collect();
    let mut followed = None;
    if let (Kind::Confounded, Status::Ambiguous, Some(next)) = (case.kind, diagnosis.status, &diagnosis.next)
        && let Some(rows) = campaign.followed_by(&next.rows, case.number)?
    {
        let data = Data::new("hidden campaign with its follow-up", rows, campaign.campaign.clone())?;
        followed = Some(diagnose(&data, &test.surface)?);
    }
    Ok(Some(Outcome { campaign, lambdas, diagnosis, followed }))
}

/// Squared signal-to-noise ratio of one hidden cause: in its own channel if no force shows it.
fn signal(test: &SelfTest, data: &Data, campaign: &HiddenCampaign, case: &Case, of: &Hidden) -> f64 {
    if let Some((shift, sd)) = in_channel(data, campaign, of) {
        return if case.design.traces { data.len() as f64 * (shift / sd).powi(2) } else { 0.0 };
    }
    let setup = FitSetup::new(data, &test.surface, data.phi.mean);
    let mut sd = stroke_sd(&setup, Some(case.design.scatter));
    sd.iter_mut().for_each(|s| *s = s.max(1e-3));
    let change: Vec<f64> = if campaign.hidden.len() == 1 {
        campaign.ln_true.iter().zip(&campaign.ln_plain).map(|(a, b)| a - b).collect()
    } else {
        match test.alone(case, campaign, of) {
            Ok(Some(change)) => change,
            _ => return 0.0,
        }
    };
    // The soil that is really there, about which the priors are put.
    lambda(&setup, data.phi.mean.clamp(33.0, 42.0), &change, &sd).unwrap_or(0.0)
}

/// Shift and scatter of the channel that shows a cause which no force shows; `None` for all others.
fn in_channel(data: &Data, campaign: &HiddenCampaign, of: &Hidden) -> Option<(f64, f64)> {
    let instrument = &campaign.campaign.instrument;
    let id = match of.cause {
        Cause::Effect(id) => id,
        Cause::Outside(_) => return None,
    };
    match id.effect().site {
        Site::Drive(DriveSite::Stretch) => {
            let n = data.len() as f64;
            let mean = |f: &dyn Fn(&StrokeRow) -> f64| data.rows.iter().map(f).sum::<f64>() / n;
            let (force, depth) = (mean(&|r| r.force_n), mean(&|r| r.depth_m));
            let spread = mean(&|r| (r.force_n - force).powi(2)).sqrt();
            Some((of.size * spread, 0.12 * 0.15 * depth))
        }
        Site::Drive(DriveSite::FreePlay) => Some((of.size, instrument.gap_sd)),
        Site::Drive(DriveSite::Friction) => Some((of.size, instrument.cmd_sd)),
        Site::Sensor(SensorSite::EncoderStep) => Some((of.size - instrument.encoder_step_m, 0.03 * of.size)),
        Site::Soil(SoilSite::Strength | SoilSite::Mobilisation | SoilSite::Loosening)
        | Site::Interface
        | Site::Surface(SurfaceSite::Height | SurfaceSite::Slope | SurfaceSite::Load)
        | Site::Sensor(
            SensorSite::ForceZero
            | SensorSite::ForceZeroDrift
            | SensorSite::ForceGain
            | SensorSite::Crosstalk
            | SensorSite::ToolAngle,
        )
        | Site::Model => None,
    }
}

impl SelfTest {
    /// Change of ln force by one of several hidden effects alone, in the same soil.
    fn alone(
        &self,
        case: &Case,
        campaign: &HiddenCampaign,
        of: &Hidden,
    ) -> Result<Option<Vec<f64>>, DiagnosisError> {
        let mut random = self.stream(case, campaign.attempt);
        // The same draws as in the campaign come first, so that soil and geometry are the same.
        for h in &campaign.hidden {
            draw(h.cause, &mut random);
        }
        let found = generate(&case.design, &self.model, vec![*of], &mut random)?;
        Ok(found.map(|one| one.ln_true.iter().zip(&one.ln_plain).map(|(a, b)| a - b).collect()))
    }
}

impl Outcome {
    /// Effects that the diagnosis gave, best first.
    #[must_use]
    pub fn given(&self) -> Vec<EffectId> {
        self.diagnosis.effects.iter().map(|effect| effect.id).collect()
    }

    /// Whether the diagnosis is firm.
    #[must_use]
    pub fn firm(&self) -> bool {
        self.diagnosis.status == Status::Named
    }
}
