//! Soils of the Moon and Mars, and simulants of them, with strength and density as published.

mod published;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use crate::{AppError, Watch};

/// Where a soil lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema, ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum Body {
    /// The Earth, where simulants are tested.
    Earth,
    /// The Moon.
    Moon,
    /// Mars.
    Mars,
}

impl Body {
    /// Gravity at its surface (m/s2): standard gravity, and the means of the Moon and of Mars to three digits.
    #[must_use]
    pub const fn gravity_m_s2(self) -> f64 {
        match self {
            Self::Earth => STANDARD_GRAVITY_M_S2,
            Self::Moon => 1.62,
            Self::Mars => 3.71,
        }
    }
}

/// Soils with strength and density as published.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// One soil by its name; all of them if not given
    #[arg(value_name = "NAME")]
    pub name: Option<String>,

    /// Those of one body only
    #[arg(long, value_name = "BODY", value_enum)]
    pub body: Option<Body>,
}

/// Soils as published.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// In the order of the file: by body, then by name.
    pub soils: Vec<Soil>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.soils/1";
}

/// A soil, and who published what about it. Friction and cohesion are those of one straight line of strength, fitted together.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Soil {
    /// Its name here.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Where it lies.
    pub body: Body,
    /// Gravity there (m/s2).
    pub gravity_m_s2: f64,
    /// Least and greatest friction angle (deg).
    pub phi_deg: [f64; 2],
    /// Least and greatest cohesion (Pa).
    pub cohesion_pa: [f64; 2],
    /// Least and greatest bulk density (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// Normal stresses of the tests (Pa); null if they were not published.
    pub stress_pa: Option<[f64; 2]>,
    /// How it was tested, or what it was concluded from.
    pub method: String,
    /// Where it was published.
    pub source: String,
    /// What to keep in mind, such as what of it is not from this source.
    pub note: String,
}

/// Finds soils.
///
/// # Errors
/// [`AppError::Request`] if there is no soil of that name, or none on that body.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    let all = published::soils()?;
    let names: Vec<String> = all.iter().map(|soil| soil.name.clone()).collect();
    let is_wanted = |soil: &Soil| {
        request.body.is_none_or(|body| soil.body == body)
            && request.name.as_ref().is_none_or(|name| soil.name == *name)
    };
    let soils: Vec<Soil> = all.into_iter().filter(is_wanted).collect();
    if soils.is_empty() {
        return Err(AppError::Request(match &request.name {
            Some(name) if !names.contains(name) => {
                format!("no soil {name} is known; known are {}", names.join(", "))
            }
            Some(name) => format!("{name} is not on that body; leave --body out"),
            None => "no soil of that body is known".into(),
        }));
    }
    Ok(Answer { soils })
}
