//! The soils that are asked about: those that explain strokes, as the answer of `estimate` has them, or those of a publication, as the answer of `soils`
//! has them.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use soilctl_estimator::FrictionLaw;
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use crate::{Answer, AppError, estimate, soils};

/// What an answer says of itself.
#[derive(Debug, Deserialize)]
struct Head {
    schema: String,
}

/// What is read of an answer of `estimate`.
#[derive(Debug, Deserialize)]
struct Estimated {
    consistent: bool,
    phi_deg: Option<[f64; 2]>,
    density_kg_m3: Option<[f64; 2]>,
    #[serde(default)]
    cut_by: Vec<String>,
    #[serde(default)]
    slip_stress_pa: Option<[f64; 2]>,
    #[serde(default)]
    reference_stress_pa: Option<f64>,
    #[serde(default)]
    friction_law: Option<Law>,
    #[serde(default)]
    unknowns: Option<serde::de::IgnoredAny>,
}

/// What is read of an answer of `soils`.
#[derive(Debug, Deserialize)]
struct Published {
    soils: Vec<PublishedSoil>,
}

#[derive(Debug, Deserialize)]
struct PublishedSoil {
    gravity_m_s2: f64,
    phi_deg: [f64; 2],
    cohesion_pa: [f64; 2],
    density_kg_m3: [f64; 2],
    stress_pa: Option<[f64; 2]>,
}

#[derive(Debug, Deserialize)]
struct Law {
    slices: Vec<Slice>,
    shear_tests: Vec<Test>,
}

#[derive(Debug, Clone, Deserialize)]
struct Slice {
    slope_deg_per_decade: [f64; 2],
    phi_deg: [f64; 2],
}

#[derive(Debug, Deserialize)]
struct Test {
    stress_pa: f64,
}

/// Friction as a law of stress.
#[derive(Debug, Clone)]
struct Falling {
    reference_stress_pa: f64,
    /// Normal stresses at which it was tried (Pa).
    tried_pa: [f64; 2],
    slices: Vec<Slice>,
}

/// Where the soils come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Origin {
    /// They explain strokes.
    Strokes,
    /// Their ranges are published.
    Published,
}

impl Origin {
    /// All of them, in words.
    pub(super) const fn every_soil(self) -> &'static str {
        match self {
            Self::Strokes => "every soil that explains the strokes",
            Self::Published => "every soil within the published ranges",
        }
    }

    /// Who tried them.
    pub(super) const fn trials(self) -> &'static str {
        match self {
            Self::Strokes => "the strokes",
            Self::Published => "the published tests",
        }
    }
}

/// The soils that are asked about.
#[derive(Debug, Clone)]
pub(super) struct Soils {
    pub(super) origin: Origin,
    /// Friction angles, or those at the reference stress of a law (deg).
    phi_deg: [f64; 2],
    /// Cohesion (Pa); `None` where strokes say nothing of it.
    pub(super) cohesion_pa: Option<[f64; 2]>,
    /// Densities (kg/m3).
    pub(super) density_kg_m3: [f64; 2],
    /// Gravity where they are (m/s2).
    pub(super) gravity_m_s2: f64,
    /// Normal stresses on slip surfaces at which the soil was tried (Pa); `None` if that was not published.
    pub(super) tried_pa: Option<[f64; 2]>,
    law: Option<Falling>,
    /// What is said of soils that are weaker or stronger than the search went; the search cut them off.
    pub(super) cut: [bool; 2],
}

impl Soils {
    /// Reads an answer of `estimate`, or one of `soils` with one soil.
    ///
    /// # Errors
    /// [`AppError`] if it is no such answer, no soil is consistent, there are several, or its numbers make no sense.
    pub(super) fn read(path: &Path) -> Result<Self, AppError> {
        let refused = |words: String| AppError::Request(format!("{}: {words}", path.display()));
        let text = fs::read_to_string(path).map_err(|error| refused(error.to_string()))?;
        Self::of_text(&text).map_err(refused)
    }

    fn of_text(text: &str) -> Result<Self, String> {
        const WANTED: &str = "it must be what `soilctl estimate FILE --format json` or `soilctl soils NAME --format json` prints";
        let of_json = |error: serde_json::Error| format!("{error}; {WANTED}");
        let Head { schema } = serde_json::from_str(text).map_err(of_json)?;
        let soils = if schema == estimate::Answer::SCHEMA {
            Self::estimated(serde_json::from_str(text).map_err(of_json)?)?
        } else if schema == soils::Answer::SCHEMA {
            Self::published(serde_json::from_str(text).map_err(of_json)?)?
        } else {
            return Err(format!("its schema is {schema}; {WANTED}"));
        };
        soils.check()?;
        Ok(soils)
    }

    fn published(found: Published) -> Result<Self, String> {
        let [soil] = &found.soils[..] else {
            return Err(format!("it has {} soils; name one: `soilctl soils NAME`", found.soils.len()));
        };
        Ok(Self {
            origin: Origin::Published,
            phi_deg: soil.phi_deg,
            cohesion_pa: Some(soil.cohesion_pa),
            density_kg_m3: soil.density_kg_m3,
            gravity_m_s2: soil.gravity_m_s2,
            tried_pa: soil.stress_pa,
            law: None,
            cut: [false; 2],
        })
    }

    fn estimated(found: Estimated) -> Result<Self, String> {
        if !found.consistent {
            return Err("no soil explains all strokes, so nothing can be said of what stands on it".into());
        }
        if found.unknowns.is_some() {
            return Err("its soils have cohesion, adhesion, surcharge or slope as unknowns, of which stability knows nothing yet; estimate with each of them \
                        as one number"
                .into());
        }
        let missing = |what: &str| format!("{what} is missing; estimate anew with this version");
        let tried_pa = found.slip_stress_pa.ok_or_else(|| missing("slip_stress_pa"))?;
        let soils = Self {
            origin: Origin::Strokes,
            phi_deg: found.phi_deg.ok_or_else(|| missing("phi_deg"))?,
            cohesion_pa: None,
            density_kg_m3: found.density_kg_m3.ok_or_else(|| missing("density_kg_m3"))?,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
            tried_pa: Some(tried_pa),
            law: None,
            cut: ["least", "greatest"]
                .map(|end| found.cut_by.iter().any(|cut| cut.starts_with(&format!("{end} friction")))),
        };
        let Some(law) = found.friction_law else { return Ok(soils) };
        let reference_stress_pa = found.reference_stress_pa.ok_or_else(|| missing("reference_stress_pa"))?;
        let boxes = law.shear_tests.iter().map(|test| test.stress_pa);
        let tried_pa = boxes.fold(tried_pa, |[a, b], stress| [a.min(stress), b.max(stress)]);
        let law = Falling { reference_stress_pa, tried_pa, slices: law.slices };
        Ok(Self { law: Some(law), tried_pa: Some(tried_pa), ..soils })
    }

    fn check(&self) -> Result<(), String> {
        let within = |what: &str, [low, high]: [f64; 2], least: f64, most: f64, unit: &str| {
            if least <= low && low <= high && high <= most {
                return Ok(());
            }
            Err(format!(
                "{what} is {low} to {high} {unit}; it must be an interval within {least} to {most} {unit}"
            ))
        };
        within("phi_deg", self.phi_deg, 0.0, 89.0, "deg")?;
        within("density_kg_m3", self.density_kg_m3, 1.0, 3e4, "kg/m3")?;
        within("gravity_m_s2", [self.gravity_m_s2; 2], 1e-3, 1e3, "m/s2")?;
        if let Some(cohesion) = self.cohesion_pa {
            within("cohesion_pa", cohesion, 0.0, 1e9, "Pa")?;
        }
        if let Some(tried) = self.tried_pa {
            within("the stress at which it was tried", tried, 1e-6, 1e9, "Pa")?;
        }
        let Some(law) = &self.law else { return Ok(()) };
        within("reference_stress_pa", [law.reference_stress_pa; 2], 1e-6, 1e9, "Pa")?;
        if law.slices.is_empty() {
            return Err("friction_law has no slices".into());
        }
        for slice in &law.slices {
            within("slope_deg_per_decade", slice.slope_deg_per_decade, 0.0, 90.0, "deg/decade")?;
            within("phi_deg of a slice", slice.phi_deg, 0.0, 120.0, "deg")?;
        }
        Ok(())
    }

    /// Whether friction is known as a law of stress.
    pub(super) const fn has_law(&self) -> bool {
        self.law.is_some()
    }

    /// Friction angles at all stresses that were tried (deg).
    pub(super) fn phi_deg(&self) -> [f64; 2] {
        match &self.law {
            None => self.phi_deg,
            Some(Falling { tried_pa: [low, high], .. }) => {
                [self.weakest_deg(*high), self.strongest_deg(*low)]
            }
        }
    }

    /// Cohesion (kPa) beside that of the problem: least and greatest.
    pub(super) fn more_cohesion_kpa(&self) -> [f64; 2] {
        self.cohesion_pa.map_or([0.0; 2], |range| range.map(|pa| 1e-3 * pa))
    }

    /// How many slices the law has.
    pub(super) fn slices(&self) -> usize {
        self.law.as_ref().map_or(0, |law| law.slices.len())
    }

    /// Slopes of a slice (deg/decade).
    pub(super) fn slopes(&self, slice: usize) -> Option<[f64; 2]> {
        Some(self.law.as_ref()?.slices.get(slice)?.slope_deg_per_decade)
    }

    /// Least friction angle (deg) at a normal stress (Pa) of all these soils. Below the stresses that were tried it is that at the least of them, since
    /// nobody has seen it to be more.
    pub(super) fn weakest_deg(&self, stress_pa: f64) -> f64 {
        (0..self.slices()).map(|slice| self.weakest_of_deg(slice, stress_pa)).fold(f64::INFINITY, f64::min)
    }

    /// The same of the soils of a slice.
    pub(super) fn weakest_of_deg(&self, slice: usize, stress_pa: f64) -> f64 {
        self.of_slice(slice, |tried| stress_pa.max(tried[0]), 0)
    }

    /// Greatest friction angle (deg) at a normal stress (Pa) of all these soils. Above the stresses that were tried it is that at the greatest of them,
    /// since friction may stop to fall.
    pub(super) fn strongest_deg(&self, stress_pa: f64) -> f64 {
        let strongest = |slice| self.of_slice(slice, |tried| stress_pa.min(tried[1]), 1);
        (0..self.slices()).map(strongest).fold(f64::NEG_INFINITY, f64::max)
    }

    /// At a stress that may depend on those that were tried.
    fn of_slice(&self, slice: usize, stress_pa: impl Fn([f64; 2]) -> f64, end: usize) -> f64 {
        let Some(Falling { reference_stress_pa, tried_pa, slices }) = &self.law else {
            return self.phi_deg[end];
        };
        let Slice { slope_deg_per_decade: [low, high], phi_deg } = slices[slice];
        let law =
            FrictionLaw { slope_deg_per_decade: (low, high), reference_stress_pa: *reference_stress_pa };
        law.friction_range_deg(phi_deg[end], [stress_pa(*tried_pa); 2])[end].clamp(0.0, MOST_DEG)
    }
}

/// No soil has more friction than this, in degrees; a law in the logarithm of stress says so near no stress.
const MOST_DEG: f64 = 80.0;
