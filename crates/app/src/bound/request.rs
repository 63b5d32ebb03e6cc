//! What bounds on a plate's force are asked.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits::Budget;
use crate::request::{Ends, Loads, finite};

/// Proven lower and upper bounds on a plate's force, by limit analysis.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Tool angle from the horizontal (deg), 10 to 170
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub alpha_deg: f64,

    /// Internal friction angle of the soil (deg), above 0 and below 70
    #[arg(long = "phi", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub phi_deg: f64,

    /// Friction falls with stress: by so many degrees a decade of normal stress, 0.1 to 8. --phi is then the friction angle at --reference-stress
    #[arg(long = "friction-law", value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "reference_stress_pa")]
    #[schemars(range(min = 0.1, max = 8.0))]
    pub friction_law: Option<f64>,

    /// Normal stress (Pa) at which --phi is the friction angle, with --friction-law
    #[arg(long = "reference-stress", value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "friction_law")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub reference_stress_pa: Option<f64>,

    /// Friction angle between soil and plate (deg), at most phi
    #[arg(long = "delta", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub delta_deg: f64,

    /// Bulk density (kg/m3); needed for forces, and with cohesion, adhesion or surcharge
    #[arg(long = "density", value_name = "KG/M3", value_parser = finite, allow_negative_numbers = true)]
    pub density_kg_m3: Option<f64>,

    /// Vertical depth of the plate's lower edge below the surface (m); likewise
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    pub depth_m: Option<f64>,

    /// Width of the plate (m); needed for forces, and with it the plate has ends
    #[arg(long = "width", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    pub width_m: Option<f64>,

    /// Width over vertical depth, where neither is given in metres
    #[arg(long = "width-ratio", value_name = "RATIO", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub width_ratio: Option<f64>,

    /// Whether the plate has ends: `finite` for one with a width unless it is said otherwise, `none` for plane strain
    #[arg(long, value_name = "WHICH", value_enum)]
    pub ends: Option<Ends>,

    /// About how many tetrahedra the stress field about an end of a plate has, which bounds from below what ends add: more take longer
    /// and narrow the bracket; 0 for none
    #[arg(long, value_name = "N", default_value_t = Request::default().tetrahedra)]
    #[schemars(range(min = 0, max = 10_000))]
    pub tetrahedra: u32,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,

    /// Saves the fields that prove the bounds, for `soilctl certify`
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            alpha_deg: 0.0,
            phi_deg: 0.0,
            friction_law: None,
            reference_stress_pa: None,
            delta_deg: 0.0,
            density_kg_m3: None,
            depth_m: None,
            width_m: None,
            width_ratio: None,
            ends: None,
            tetrahedra: 400,
            loads: Loads::default(),
            budget: Budget::default(),
            save: None,
        }
    }
}
