//! A stress field in space about the ends of a plate: a lower bound that knows what these add.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{Claim, EndForce, SpaceStress, prove_end};
use soilctl_limit_analysis::{EmbeddedPlate, EndLevel, EndOptions, end_lower};

use super::ScaledPlate;

/// What may be spent on the field.
#[derive(Debug, Clone)]
pub struct EndBudget {
    /// About how many tetrahedra; with none there is no field.
    pub tetrahedra: usize,
    /// Time that may be spent in s, if it is limited.
    pub seconds: Option<f64>,
    /// Memory that may be used, in bytes.
    pub memory: u64,
    /// Set to end the search.
    pub stop: Arc<AtomicBool>,
}

/// A stress field in space about one end of a plate, and what it proves, in slant lengths and unit weights.
#[derive(Debug, Clone)]
pub struct EndField {
    /// The field, and the proven force per unit width of the plate that it was found for.
    pub claim: Claim<SpaceStress>,
    /// What it proves of plates of any width.
    pub force: EndForce,
}

/// Memory in bytes that a search may need, and for each tetrahedron of it: more than the most measured (0.5 GB with 800, 1.5 GB with
/// 3,000).
const MEMORY: u64 = 150_000_000;
const MEMORY_EACH: u64 = 600_000;

/// What became of the stress field in space about the ends of a plate.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct EndAnswer {
    /// Tetrahedra of the field about one end; 0 if there is none.
    pub tetrahedra: usize,
    /// Lower bound on the net coefficient that it proves for the width asked for; null if there is none.
    pub lower: Option<f64>,
    /// Time spent on it in s, also if there is none.
    pub seconds: f64,
    /// Why there is none, in words; null if there is one.
    pub why_none: Option<String>,
}

impl EndAnswer {
    pub(super) fn new(found: &Result<EndField, String>, seconds: f64, scaled: &ScaledPlate) -> Self {
        match found {
            Ok(end) => Self {
                tetrahedra: end.claim.field.tetrahedra.len(),
                lower: Some(scaled.of_forces([end.claim.claimed; 2])[0]),
                seconds,
                why_none: None,
            },
            Err(why) => Self { tetrahedra: 0, lower: None, seconds, why_none: Some(why.clone()) },
        }
    }
}

/// Finds a field for a plate of a width in slant lengths, and proves it.
///
/// # Errors
/// Why there is none, in words: the splice then is all that is known of the force from below.
pub fn find_end(
    plate: &EmbeddedPlate,
    width: f64,
    budget: &EndBudget,
    progress: &mut dyn FnMut(&EndLevel),
) -> Result<EndField, String> {
    covered(plate)?;
    if budget.tetrahedra == 0 {
        return Err("none was asked for".into());
    }
    if budget.seconds.is_some_and(|left| left <= 0.0) {
        return Err("the time was up before".into());
    }
    let needed = MEMORY + MEMORY_EACH * budget.tetrahedra as u64;
    if needed > budget.memory {
        return Err(format!(
            "{} tetrahedra may need {} MB, more than allowed",
            budget.tetrahedra,
            needed / 1_000_000
        ));
    }
    let options = EndOptions {
        tetrahedra: budget.tetrahedra,
        max_seconds: budget.seconds,
        stops: [Arc::clone(&budget.stop), Arc::default()],
        ..EndOptions::default()
    };
    let found = end_lower(plate.phi_deg, plate.delta_deg, width, &options, progress)
        .map_err(|why| why.to_string())?;
    let force = prove_end(plate.phi_deg, plate.delta_deg, &found.field)
        .map_err(|why| format!("what was found is not proven: {why}"))?;
    let claimed =
        force.per_width(width).ok_or("the plate is not as wide as the field reaches from both ends")?;
    Ok(EndField { claim: found.claim(claimed), force })
}

/// Refuses plates that such fields are not for.
fn covered(plate: &EmbeddedPlate) -> Result<(), String> {
    let EmbeddedPlate { alpha_deg, beta_deg, cohesion, adhesion, surcharge, .. } = *plate;
    let loads = [("cohesion", cohesion), ("adhesion", adhesion), ("a surcharge", surcharge)];
    let loaded = loads.into_iter().find(|(_, load)| *load != 0.0);
    if alpha_deg != 90.0 {
        return Err("a stress field in space is for upright plates".into());
    }
    if beta_deg != 0.0 {
        return Err("a stress field in space is for level ground".into());
    }
    match loaded {
        Some((name, _)) => Err(format!("a stress field in space is for weight alone, without {name}")),
        None => Ok(()),
    }
}
