//! The options of a plate's stroke.

use soilctl_direct_shear::{PointDepth, StrokeLoad};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2, Soil, Stroke};

use super::equivalent::Inputs;
use crate::args::finite;
use crate::error::CliError;

/// What a stroke needs beside its force; each of them needs the force in turn.
const WITH_FORCE: [&str; 5] = ["alpha", "depth", "width", "density", "delta"];

#[derive(Debug, clap::Args)]
pub(super) struct StrokeArgs {
    /// Tool angle from the horizontal (deg); --alpha, --depth, --width, --density, --delta and --force go together
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    alpha: Option<f64>,

    /// Vertical depth of the plate's lower edge below the surface (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    depth: Option<f64>,

    /// Width of the plate (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    width: Option<f64>,

    /// Bulk density (kg/m3)
    #[arg(long, value_name = "KG/M3", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    density: Option<f64>,

    /// Gravity at the stroke (m/s2)
    #[arg(long, value_name = "M/S2", value_parser = finite, allow_negative_numbers = true, requires = "force",
          default_value_t = STANDARD_GRAVITY_M_S2)]
    gravity: f64,

    /// Friction angle between soil and plate (deg)
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    delta: Option<f64>,

    /// Failure force of the stroke (N)
    #[arg(long, value_name = "N", value_parser = finite, allow_negative_numbers = true, requires_all = WITH_FORCE)]
    force: Option<f64>,

    /// Friction angle to compute the stresses with (deg); if not given, angle and stress are made consistent
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    phi: Option<f64>,

    /// Depth of the point considered as a fraction of the plate's depth (may be repeated, or a list with commas)
    #[arg(long, value_name = "FRACTION", value_parser = finite, allow_negative_numbers = true, requires = "force",
          value_delimiter = ',', default_values = ["0.5", "0.6667"])]
    point_fraction: Vec<f64>,

    /// Warns of the shift when the friction angle of the stroke is used at this normal stress (Pa)
    #[arg(long, value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "force")]
    carry_to: Option<f64>,
}

/// A stroke, checked.
pub(super) struct Given {
    pub(super) inputs: Inputs,
    /// Each point with its fraction of the plate's depth.
    pub(super) loads: Vec<(f64, StrokeLoad)>,
    pub(super) carry_to_pa: Option<f64>,
}

impl StrokeArgs {
    /// The stroke of the options; `None` without them.
    pub(super) fn given(&self) -> Result<Option<Given>, CliError> {
        let (Some(alpha_deg), Some(depth_m), Some(width_m)) = (self.alpha, self.depth, self.width) else {
            return Ok(None);
        };
        let (Some(density_kg_m3), Some(delta_deg), Some(force_n)) = (self.density, self.delta, self.force)
        else {
            return Ok(None);
        };
        let plate = Plate::new(Angle::from_degrees(alpha_deg), Angle::ZERO, depth_m, width_m)?;
        let stroke = Stroke::new(plate, force_n)?;
        let soil = Soil::new(Angle::ZERO, density_kg_m3)?.with_gravity(self.gravity)?;
        let delta = Angle::from_degrees(delta_deg);
        let mut loads = Vec::new();
        for &fraction in &self.point_fraction {
            let point = PointDepth::FractionOfPlate(fraction);
            let load = StrokeLoad::new(&stroke, soil.unit_weight_n_m3(), delta, point)?;
            if let Some(phi_deg) = self.phi {
                load.equivalent_stress(Angle::from_degrees(phi_deg))?;
            }
            loads.push((fraction, load));
        }
        let inputs = Inputs {
            alpha_deg,
            depth_m,
            width_m,
            density_kg_m3,
            gravity_m_s2: self.gravity,
            delta_deg,
            force_n,
            phi_deg: self.phi,
        };
        Ok(Some(Given { inputs, loads, carry_to_pa: self.carry_to }))
    }
}
