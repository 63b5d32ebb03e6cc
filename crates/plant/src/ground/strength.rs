use soilctl_earth_pressure::{EarthPressureError, ForceModel};
use soilctl_soil::{Interface, Soil};

use super::SoilPreset;
use super::limit::LimitCoefficients;
use super::under_stress::UnderStress;
use crate::config::GroundConfig;

/// Coefficients of limit forces, by what friction depends on.
#[derive(Debug, Clone)]
enum Limits {
    /// The same at every stress.
    Everywhere(LimitCoefficients),
    /// Falling with stress.
    UnderStress(UnderStress),
}

/// What the soil can bear: limit force, edge resistance, friction, and how fast they are mobilised.
#[derive(Debug, Clone)]
pub(crate) struct Strength {
    limits: Limits,
    gravity_m_s2: f64,
    cohesion_pa: f64,
    pub(crate) density_kg_m3: f64,
    /// 0 loosest, 1 densest.
    pub(crate) relative_density: f64,
    /// Friction angle of the soil in rad; with a law of stress that at its reference, by which the edge and soil at rest go.
    pub(crate) phi_rad: f64,
    /// Friction angle on the plate in rad.
    pub(crate) delta_rad: f64,
    /// Earth pressure at rest over weight (Jaky 1944).
    at_rest: f64,
    /// Reissner's N_q, Vesic's N_gamma and Prandtl's N_c.
    bearing: [f64; 3],
}

impl Strength {
    pub(crate) fn new(
        config: &GroundConfig,
        preset: &SoilPreset,
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
    ) -> Result<Self, EarthPressureError> {
        let phi = soil.friction().radians();
        let (sin, tan) = (libm::sin(phi), libm::tan(phi));
        let root = libm::tan(std::f64::consts::FRAC_PI_4 + 0.5 * phi);
        let n_q = libm::exp(std::f64::consts::PI * tan) * root * root;
        Ok(Self {
            limits: match &preset.friction_law {
                None => Limits::Everywhere(LimitCoefficients::new(
                    model,
                    soil,
                    interface,
                    config.bracket_fraction,
                )?),
                Some(law) => Limits::UnderStress(UnderStress::new(
                    law,
                    model,
                    soil,
                    interface,
                    config.bracket_fraction,
                )?),
            },
            gravity_m_s2: soil.gravity_m_s2(),
            cohesion_pa: soil.cohesion_pa(),
            density_kg_m3: soil.density_kg_m3(),
            relative_density: preset.relative_density(soil.density_kg_m3()),
            phi_rad: phi,
            delta_rad: interface.friction().radians(),
            at_rest: 1.0 - sin,
            bearing: [n_q, 2.0 * (n_q + 1.0) * tan, (n_q - 1.0) / tan],
        })
    }

    /// The same for a plate with ends.
    pub(crate) fn with_ends(
        mut self,
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
        factor: f64,
    ) -> Result<Self, EarthPressureError> {
        self.limits = match self.limits {
            Limits::Everywhere(limits) => {
                Limits::Everywhere(limits.with_ends(model, soil, interface, factor)?)
            }
            Limits::UnderStress(limits) => {
                Limits::UnderStress(limits.with_ends(model, soil, interface, factor)?)
            }
        };
        Ok(self)
    }

    pub(crate) fn set_density(&mut self, preset: &SoilPreset, density_kg_m3: f64) {
        self.density_kg_m3 = density_kg_m3;
        self.relative_density = preset.relative_density(density_kg_m3);
    }

    fn unit_weight_n_m3(&self) -> f64 {
        self.density_kg_m3 * self.gravity_m_s2
    }

    /// Failure force in N on a plate with a heap ahead of it, with a share of the friction mobilised.
    pub(crate) fn limit_n(
        &self,
        tool_angle_rad: f64,
        depth_m: f64,
        heap_m: f64,
        width_m: f64,
        share: f64,
    ) -> f64 {
        let slant_m = depth_m / libm::sin(tool_angle_rad);
        let factors = match &self.limits {
            Limits::Everywhere(limits) => limits.at(tool_angle_rad, share, depth_m / width_m),
            Limits::UnderStress(limits) => limits.at(tool_angle_rad, share, depth_m, width_m),
        };
        let per_length = slant_m * width_m;
        let weight = self.unit_weight_n_m3() * (0.5 * slant_m * factors.weight + heap_m * factors.surcharge);
        per_length * (weight + self.cohesion_pa * factors.cohesion)
    }

    /// Force in N of both faces at rest, across the plate: one of them.
    pub(crate) fn at_rest_n(&self, depth_m: f64, width_m: f64) -> f64 {
        0.5 * self.at_rest * self.unit_weight_n_m3() * depth_m * depth_m * width_m
    }

    /// Resistance in N of the plate's edge to being pushed in: a strip footing as wide as the plate is thick.
    pub(crate) fn edge_n(&self, depth_m: f64, width_m: f64, thickness_m: f64, shape: f64) -> f64 {
        let [n_q, n_gamma, n_c] = self.bearing;
        let weight = self.unit_weight_n_m3();
        let pressure = weight * depth_m * n_q + 0.5 * weight * thickness_m * n_gamma + self.cohesion_pa * n_c;
        shape * width_m * thickness_m * pressure
    }
}
