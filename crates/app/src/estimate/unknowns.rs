//! Cohesion, adhesion, surcharge and slope as unknowns: what a request knows of them, and what an estimate says of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_estimator::{Adhesion, Estimate, Joint, Quantity, Ring, Setup, Unknowns, estimate};

use crate::AppError;
use crate::request::{Loads, finite};

/// What is known of the ground within intervals. All strokes share the same values.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Intervals {
    /// Cohesion of the soil (Pa) as an unknown between LOW and HIGH, instead of `--cohesion`
    #[arg(long = "cohesion-range", value_name = "LOW:HIGH", value_parser = interval, allow_hyphen_values = true,
          conflicts_with = "cohesion_pa")]
    pub cohesion_range_pa: Option<(f64, f64)>,

    /// Adhesion between soil and plate (Pa) as an unknown between LOW and HIGH, instead of `--adhesion`
    #[arg(long = "adhesion-range", value_name = "LOW:HIGH", value_parser = interval, allow_hyphen_values = true,
          conflicts_with = "adhesion_pa")]
    pub adhesion_range_pa: Option<(f64, f64)>,

    /// Adhesion as an unknown part of the cohesion between LOW and HIGH, 0 to 1, instead of `--adhesion`
    #[arg(long = "adhesion-share", value_name = "LOW:HIGH", value_parser = interval, allow_hyphen_values = true,
          conflicts_with_all = ["adhesion_pa", "adhesion_range_pa"])]
    pub adhesion_share: Option<(f64, f64)>,

    /// Vertical pressure on the surface (Pa) as an unknown between LOW and HIGH, instead of `--surcharge`
    #[arg(long = "surcharge-range", value_name = "LOW:HIGH", value_parser = interval, allow_hyphen_values = true,
          conflicts_with = "surcharge_pa")]
    pub surcharge_range_pa: Option<(f64, f64)>,

    /// Slope of the surface (deg) as an unknown between LOW and HIGH, such as an inclinometer tells it, instead of `--beta`
    #[arg(long = "beta-range", value_name = "LOW:HIGH", value_parser = interval, allow_hyphen_values = true,
          conflicts_with = "beta_deg")]
    pub beta_range_deg: Option<(f64, f64)>,

    /// Also tell what each unknown costs: the widths of friction angle and density, were it known. Needs one of the intervals above
    #[arg(long)]
    pub costs: bool,
}

fn interval(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once(':').ok_or("it must be LOW:HIGH, such as 0:500")?;
    let (low, high) = (finite(low)?, finite(high)?);
    if low <= high { Ok((low, high)) } else { Err("LOW must be at most HIGH".into()) }
}

impl Intervals {
    /// Whether anything is an unknown.
    #[must_use]
    pub const fn any(&self) -> bool {
        self.cohesion_range_pa.is_some()
            || self.adhesion_range_pa.is_some()
            || self.adhesion_share.is_some()
            || self.surcharge_range_pa.is_some()
            || self.beta_range_deg.is_some()
    }

    /// The unknowns of a setup, with what is known of the others; `None` if all is known.
    pub(super) fn unknowns(&self, loads: &Loads) -> Option<Unknowns> {
        let known = Unknowns::known(&(*loads).into(), loads.beta_deg);
        let adhesion = self.adhesion_share.map(Adhesion::ShareOfCohesion);
        self.any().then(|| Unknowns {
            cohesion_pa: self.cohesion_range_pa.unwrap_or(known.cohesion_pa),
            adhesion: adhesion.or(self.adhesion_range_pa.map(Adhesion::Pa)).unwrap_or(known.adhesion),
            surcharge_pa: self.surcharge_range_pa.unwrap_or(known.surcharge_pa),
            slope_deg: self.beta_range_deg.unwrap_or(known.slope_deg),
        })
    }

    /// Refuses what takes all loads as known.
    pub(super) fn refuse(&self, tasks: &[(&str, bool)]) -> Result<(), AppError> {
        if !self.any() {
            return if self.costs {
                Err(AppError::Request(
                    "--costs tells what unknowns beside friction and density cost; give one of --cohesion-range, --adhesion-range, \
                     --adhesion-share, --surcharge-range and --beta-range"
                        .into(),
                ))
            } else {
                Ok(())
            };
        }
        match tasks.iter().find(|(_, asked)| *asked) {
            Some((option, _)) => Err(AppError::Request(format!(
                "{option} takes cohesion, adhesion, surcharge and slope as known; leave it out, or give each of them as one number"
            ))),
            None => Ok(()),
        }
    }
}

/// What is left of all unknowns together.
#[derive(Debug, Serialize, JsonSchema)]
pub struct UnknownsAnswer {
    /// The quantities that are not known.
    pub quantities: Vec<Unknown>,
    /// What is left of each pair of them; empty if no soil is consistent.
    pub pairs: Vec<Pair>,
    /// What each unknown costs; null unless asked for.
    pub costs: Option<Vec<Cost>>,
}

/// A quantity that is not known.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Unknown {
    /// Its name, which ends with its unit.
    pub name: Name,
    /// What was known of it.
    pub known: [f64; 2],
    /// What the measurements leave of it; null if no soil is consistent.
    pub range: Option<[f64; 2]>,
}

/// Names of quantities, as keys of answers have them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Name {
    /// Friction angle.
    PhiDeg,
    /// Interface friction.
    DeltaDeg,
    /// Slope of the surface.
    BetaDeg,
    /// Bulk density.
    #[serde(rename = "density_kg_m3")]
    DensityKgM3,
    /// Cohesion.
    CohesionPa,
    /// Adhesion.
    AdhesionPa,
    /// Surcharge.
    SurchargePa,
}

impl From<Quantity> for Name {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Friction => Self::PhiDeg,
            Quantity::InterfaceFriction => Self::DeltaDeg,
            Quantity::Slope => Self::BetaDeg,
            Quantity::Density => Self::DensityKgM3,
            Quantity::Cohesion => Self::CohesionPa,
            Quantity::Adhesion => Self::AdhesionPa,
            Quantity::Surcharge => Self::SurchargePa,
        }
    }
}

impl Name {
    /// Name, unit, and digits after the point.
    #[must_use]
    pub const fn in_words(self) -> (&'static str, &'static str, usize) {
        match self {
            Self::PhiDeg => ("phi", "deg", 2),
            Self::DeltaDeg => ("delta", "deg", 2),
            Self::BetaDeg => ("slope", "deg", 2),
            Self::DensityKgM3 => ("density", "kg/m3", 0),
            Self::CohesionPa => ("cohesion", "Pa", 0),
            Self::AdhesionPa => ("adhesion", "Pa", 0),
            Self::SurchargePa => ("surcharge", "Pa", 0),
        }
    }
}

/// What is left of two quantities together.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pair {
    /// The first coordinate of its points.
    pub x: Name,
    /// The second one.
    pub y: Name,
    /// Consistent [x, y]: polygons, each an outer ring and its holes. Of two quantities that are no angles it is the convex hull.
    pub polygons: Vec<Vec<Ring>>,
}

/// What an unknown costs.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Cost {
    /// The unknown.
    pub name: Name,
    /// The value at which it is taken as known: the middle of what the measurements leave of it.
    pub value: f64,
    /// Width of the range of the friction angle if it is known (deg); null if no soil is consistent then.
    pub phi_width_deg: Option<f64>,
    /// Width of the range of the density if it is known (kg/m3); null if no soil is consistent then.
    pub density_width_kg_m3: Option<f64>,
}

impl UnknownsAnswer {
    /// What an estimate says; `None` if all loads are known.
    pub(super) fn of(setup: &Setup<'_>, found: &Estimate, costs: bool) -> Result<Option<Self>, AppError> {
        let (Some(unknowns), Some(joint)) = (&setup.unknowns, &found.joint) else { return Ok(None) };
        let quantity = |quantity: Quantity| Unknown {
            name: quantity.into(),
            known: unknowns.interval(setup, quantity).into(),
            range: joint.range(quantity),
        };
        let pair = |(x, y, region): &(Quantity, Quantity, soilctl_estimator::Region)| Pair {
            x: (*x).into(),
            y: (*y).into(),
            polygons: region.polygons().to_vec(),
        };
        Ok(Some(Self {
            quantities: unknowns.unknown(setup).into_iter().map(quantity).collect(),
            pairs: joint.pairs.iter().map(pair).collect(),
            costs: if costs { Some(costs_of(setup, unknowns, joint)?) } else { None },
        }))
    }
}

/// Estimates with one unknown less each.
fn costs_of(setup: &Setup<'_>, unknowns: &Unknowns, joint: &Joint) -> Result<Vec<Cost>, AppError> {
    let mut costs = Vec::new();
    for (quantity, [low, high]) in &joint.ranges {
        let value = f64::midpoint(*low, *high);
        let mut known = Setup { unknowns: Some(unknowns.with_known(*quantity, value)), ..setup.clone() };
        match quantity {
            // What it costs is told in its own width.
            Quantity::Friction => continue,
            Quantity::InterfaceFriction => known.delta_deg = (value, value),
            Quantity::Density => known.density_kg_m3 = Some((value, value)),
            Quantity::Slope | Quantity::Cohesion | Quantity::Adhesion | Quantity::Surcharge => {}
        }
        let found = estimate(&known)?;
        let width = |range: Option<[f64; 2]>| range.map(|[low, high]| high - low);
        costs.push(Cost {
            name: (*quantity).into(),
            value,
            phi_width_deg: width(found.phi_deg),
            density_width_kg_m3: width(found.density_kg_m3),
        });
    }
    Ok(costs)
}
