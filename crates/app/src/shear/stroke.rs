//! A plate's stroke, as it is asked about.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_direct_shear::{PointDepth, StrokeLoad};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2, Soil, Stroke};

use super::answer::Inputs;
use crate::AppError;
use crate::request::finite;

/// What a stroke needs beside its force; each of them needs the force in turn.
const WITH_FORCE: [&str; 5] = ["alpha_deg", "depth_m", "width_m", "density_kg_m3", "delta_deg"];

/// A plate's stroke, at whose stresses friction angles are asked for.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct StrokeRequest {
    /// Tool angle from the horizontal (deg); --alpha, --depth, --width, --density, --delta and --force go together
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub alpha_deg: Option<f64>,

    /// Vertical depth of the plate's lower edge below the surface (m)
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub depth_m: Option<f64>,

    /// Width of the plate (m)
    #[arg(long = "width", value_name = "M", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub width_m: Option<f64>,

    /// Bulk density (kg/m3)
    #[arg(long = "density", value_name = "KG/M3", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub density_kg_m3: Option<f64>,

    /// Gravity at the stroke (m/s2)
    #[arg(long = "gravity", value_name = "M/S2", value_parser = finite, allow_negative_numbers = true, requires = "force_n",
          default_value_t = StrokeRequest::default().gravity_m_s2)]
    pub gravity_m_s2: f64,

    /// Friction angle between soil and plate (deg)
    #[arg(long = "delta", value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub delta_deg: Option<f64>,

    /// Failure force of the stroke (N)
    #[arg(long = "force", value_name = "N", value_parser = finite, allow_negative_numbers = true, requires_all = WITH_FORCE)]
    pub force_n: Option<f64>,

    /// Friction angle to compute the stresses with (deg); if not given, angle and stress are made consistent
    #[arg(long = "phi", value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub phi_deg: Option<f64>,

    /// Depth of the point considered as a fraction of the plate's depth (may be repeated, or a list with commas)
    #[arg(long, value_name = "FRACTION", value_parser = finite, allow_negative_numbers = true, requires = "force_n",
          value_delimiter = ',', default_values_t = StrokeRequest::default().point_fraction)]
    pub point_fraction: Vec<f64>,

    /// Warns of the shift when the friction angle of the stroke is used at this normal stress (Pa)
    #[arg(long = "carry-to", value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "force_n")]
    pub carry_to_pa: Option<f64>,
}

impl Default for StrokeRequest {
    fn default() -> Self {
        Self {
            alpha_deg: None,
            depth_m: None,
            width_m: None,
            density_kg_m3: None,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
            delta_deg: None,
            force_n: None,
            phi_deg: None,
            point_fraction: vec![0.5, 0.6667],
            carry_to_pa: None,
        }
    }
}

/// A stroke, checked.
pub(super) struct Given {
    pub(super) inputs: Inputs,
    /// Each point with its fraction of the plate's depth.
    pub(super) loads: Vec<(f64, StrokeLoad)>,
    pub(super) carry_to_pa: Option<f64>,
}

impl StrokeRequest {
    /// The stroke of the options; `None` without them.
    pub(super) fn given(&self) -> Result<Option<Given>, AppError> {
        let (Some(alpha_deg), Some(depth_m), Some(width_m)) = (self.alpha_deg, self.depth_m, self.width_m)
        else {
            return Ok(None);
        };
        let (Some(density_kg_m3), Some(delta_deg), Some(force_n)) =
            (self.density_kg_m3, self.delta_deg, self.force_n)
        else {
            return Ok(None);
        };
        let plate = Plate::new(Angle::from_degrees(alpha_deg), Angle::ZERO, depth_m, width_m)?;
        let stroke = Stroke::new(plate, force_n)?;
        let soil = Soil::new(Angle::ZERO, density_kg_m3)?.with_gravity(self.gravity_m_s2)?;
        let delta = Angle::from_degrees(delta_deg);
        let mut loads = Vec::new();
        for &fraction in &self.point_fraction {
            let point = PointDepth::FractionOfPlate(fraction);
            let load = StrokeLoad::new(&stroke, soil.unit_weight_n_m3(), delta, point)?;
            if let Some(phi_deg) = self.phi_deg {
                load.equivalent_stress(Angle::from_degrees(phi_deg))?;
            }
            loads.push((fraction, load));
        }
        let inputs = Inputs {
            alpha_deg,
            depth_m,
            width_m,
            density_kg_m3,
            gravity_m_s2: self.gravity_m_s2,
            delta_deg,
            force_n,
            phi_deg: self.phi_deg,
        };
        Ok(Some(Given { inputs, loads, carry_to_pa: self.carry_to_pa }))
    }
}
