/// Soil and interface without any effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Base {
    /// Friction angle of the soil, deg.
    pub phi_deg: f64,
    /// Interface friction angle of this stroke, deg.
    pub delta_deg: f64,
    /// Bulk density, kg/m3.
    pub density_kg_m3: f64,
    /// Gravity, m/s2.
    pub gravity_m_s2: f64,
}

/// Under which conditions a stroke really fails the soil, and how it is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// Tool angle, deg.
    pub alpha_deg: f64,
    /// Surface slope ahead of the plate, deg.
    pub beta_deg: f64,
    /// Vertical depth of the lower edge, m.
    pub depth_m: f64,
    /// Friction angle of the soil, deg.
    pub phi_deg: f64,
    /// Interface friction angle, deg.
    pub delta_deg: f64,
    /// Cohesion, Pa.
    pub cohesion_pa: f64,
    /// Vertical pressure on the surface, Pa.
    pub surcharge_pa: f64,
    /// ln of a factor on the force.
    pub ln_factor: f64,
    /// What the reading adds to the force, N.
    pub bias_n: f64,
}

impl Conditions {
    /// The conditions without any effect.
    #[must_use]
    pub const fn plain(alpha_deg: f64, depth_m: f64, base: &Base) -> Self {
        Self {
            alpha_deg,
            beta_deg: 0.0,
            depth_m,
            phi_deg: base.phi_deg,
            delta_deg: base.delta_deg,
            cohesion_pa: 0.0,
            surcharge_pa: 0.0,
            ln_factor: 0.0,
            bias_n: 0.0,
        }
    }

    /// Changes the force by a share of it, which cannot take more than 99 % away.
    pub(crate) fn scale(&mut self, share: f64) {
        self.ln_factor += libm::log1p(share.max(-0.99));
    }
}
