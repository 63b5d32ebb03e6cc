//! The soils that explain the strokes, as the answer of `estimate` has them.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use soilctl_estimator::FrictionLaw;

use crate::AppError;

/// What is read of an answer.
#[derive(Debug, Deserialize)]
struct Document {
    schema: String,
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
    slices: Vec<Slice>,
}

/// Soils that explain the strokes.
#[derive(Debug, Clone)]
pub(super) struct Soils {
    /// Friction angles of the strokes, or at the reference stress of a law (deg).
    phi_deg: [f64; 2],
    /// Densities (kg/m3).
    pub(super) density_kg_m3: [f64; 2],
    /// Normal stresses on slip surfaces at which the soil was tried (Pa).
    pub(super) tried_pa: [f64; 2],
    law: Option<Falling>,
    /// What is said of soils that are weaker or stronger than the search went; the search cut them off.
    pub(super) cut: [bool; 2],
}

impl Soils {
    /// Reads an answer of `estimate`.
    ///
    /// # Errors
    /// [`AppError`] if it is no such answer, no soil is consistent, or its numbers make no sense.
    pub(super) fn read(path: &Path) -> Result<Self, AppError> {
        let name = path.display();
        let refused = |words: String| AppError::Request(format!("{name}: {words}"));
        let text = fs::read_to_string(path).map_err(|error| refused(error.to_string()))?;
        let of_json = |error: serde_json::Error| {
            refused(format!("{error}; it must be what `soilctl estimate FILE --format json` prints"))
        };
        let found: Document = serde_json::from_str(&text).map_err(of_json)?;
        if found.schema != "soilctl.estimate/1" {
            return Err(refused(format!("its schema is {}; it must be soilctl.estimate/1", found.schema)));
        }
        if !found.consistent {
            return Err(refused(
                "no soil explains all strokes, so nothing can be said of what stands on it".into(),
            ));
        }
        let missing = |what: &str| refused(format!("{what} is missing; estimate anew with this version"));
        let soils = Self {
            phi_deg: found.phi_deg.ok_or_else(|| missing("phi_deg"))?,
            density_kg_m3: found.density_kg_m3.ok_or_else(|| missing("density_kg_m3"))?,
            tried_pa: found.slip_stress_pa.ok_or_else(|| missing("slip_stress_pa"))?,
            law: None,
            cut: ["least", "greatest"]
                .map(|end| found.cut_by.iter().any(|cut| cut.starts_with(&format!("{end} friction")))),
        };
        let soils = match found.friction_law {
            None => soils,
            Some(law) => {
                let reference_stress_pa =
                    found.reference_stress_pa.ok_or_else(|| missing("reference_stress_pa"))?;
                let boxes = law.shear_tests.iter().map(|test| test.stress_pa);
                let [low, high] = soils.tried_pa;
                let tried = boxes.fold([low, high], |[a, b], stress| [a.min(stress), b.max(stress)]);
                Self {
                    law: Some(Falling { reference_stress_pa, slices: law.slices }),
                    tried_pa: tried,
                    ..soils
                }
            }
        };
        soils.check().map_err(refused)?;
        Ok(soils)
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
        within("slip_stress_pa", self.tried_pa, 1e-6, 1e9, "Pa")?;
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

    /// Friction angles of the strokes (deg), or at the reference stress of a law.
    pub(super) const fn of_strokes_deg(&self) -> [f64; 2] {
        self.phi_deg
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
        self.of_slice(slice, stress_pa.max(self.tried_pa[0]), 0)
    }

    /// Greatest friction angle (deg) at a normal stress (Pa) of all these soils. Above the stresses that were tried it is that at the greatest of them,
    /// since friction may stop to fall.
    pub(super) fn strongest_deg(&self, stress_pa: f64) -> f64 {
        let stress = stress_pa.min(self.tried_pa[1]);
        (0..self.slices()).map(|slice| self.of_slice(slice, stress, 1)).fold(f64::NEG_INFINITY, f64::max)
    }

    fn of_slice(&self, slice: usize, stress_pa: f64, end: usize) -> f64 {
        let Some(law) = &self.law else { return self.phi_deg[end] };
        let Slice { slope_deg_per_decade: [low, high], phi_deg } = law.slices[slice];
        let law =
            FrictionLaw { slope_deg_per_decade: (low, high), reference_stress_pa: law.reference_stress_pa };
        law.friction_range_deg(phi_deg[end], [stress_pa; 2])[end].clamp(0.0, MOST_DEG)
    }
}

/// No soil has more friction than this, in degrees; a law in the logarithm of stress says so near no stress.
const MOST_DEG: f64 = 80.0;
