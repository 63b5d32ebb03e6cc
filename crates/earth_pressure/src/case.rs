use soilctl_soil::{
    Angle, Bracket, Interface, MAX_ANGLE_SUM_DEG, Plate, Provenance, SlantCoefficient, Soil, SoilError,
    WidthRatio,
};

use crate::EarthPressureError;

/// What a force coefficient depends on: four angles and the plate's width over its depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// Tool angle alpha.
    pub tool_angle: Angle,
    /// Surface slope beta, positive when the ground rises ahead of the plate.
    pub surface_slope: Angle,
    /// Width over vertical depth; only models that [have ends](crate::ForceModel::has_ends) take notice of it.
    pub width_ratio: WidthRatio,
    /// Soil friction phi.
    pub friction: Angle,
    /// Interface friction delta.
    pub interface: Angle,
}

/// What counts as equal to the friction angle.
const NEAR_DEG: f64 = 1e-9;

impl Case {
    /// A case in plane strain with a level surface, from degrees.
    #[must_use]
    pub fn level_deg(alpha: f64, phi: f64, delta: f64) -> Self {
        Self::from_deg(alpha, 0.0, phi, delta)
    }

    /// A case in plane strain from degrees.
    #[must_use]
    pub fn from_deg(alpha: f64, beta: f64, phi: f64, delta: f64) -> Self {
        Self {
            tool_angle: Angle::from_degrees(alpha),
            surface_slope: Angle::from_degrees(beta),
            width_ratio: WidthRatio::PLANE_STRAIN,
            friction: Angle::from_degrees(phi),
            interface: Angle::from_degrees(delta),
        }
    }

    /// The case of a plate in a soil, with its ends.
    #[must_use]
    pub fn of(plate: &Plate, soil: &Soil, interface: &Interface) -> Self {
        Self {
            tool_angle: plate.tool_angle(),
            surface_slope: plate.surface_slope(),
            width_ratio: plate.width_ratio(),
            friction: soil.friction(),
            interface: interface.friction(),
        }
    }

    /// The same for another width over depth.
    #[must_use]
    pub fn with_width_ratio(self, width_ratio: WidthRatio) -> Self {
        Self { width_ratio, ..self }
    }

    /// Refuses what no model can answer: delta above phi, a surface steeper than phi, alpha + delta of 175 deg
    /// or more.
    pub(crate) fn check(&self, model: &'static str) -> Result<(), EarthPressureError> {
        let (phi, delta, beta) =
            (self.friction.degrees(), self.interface.degrees(), self.surface_slope.degrees());
        if delta > phi + 1e-9 {
            return Err(SoilError::InterfaceRougherThanSoil { delta_deg: delta, phi_deg: phi }.into());
        }
        if self.tool_angle.degrees() + delta >= MAX_ANGLE_SUM_DEG {
            return Err(self.singular(
                model,
                "alpha + delta is 175 deg or more, so the plate's force is nearly vertical; lower either",
            ));
        }
        if beta.abs() > phi {
            return Err(self.singular(
                model,
                "the surface is steeper than the friction angle, so it slides by itself; use |beta| <= phi",
            ));
        }
        if beta <= -phi + NEAR_DEG {
            return Err(self.singular(
                model,
                "the surface falls at the friction angle, so the soil ahead gives way to any force; use beta > -phi",
            ));
        }
        Ok(())
    }

    /// The surface slope in radians, for formulas that divide nought by nought where it equals phi: there it is taken
    /// a billionth of a degree lower, which gives their limit.
    pub(crate) fn slope_below_phi(&self) -> f64 {
        let (beta, phi) = (self.surface_slope.radians(), self.friction.radians());
        let limit = phi - NEAR_DEG.to_radians();
        beta.clamp(-limit, limit)
    }

    pub(crate) fn singular(&self, model: &'static str, reason: &'static str) -> EarthPressureError {
        EarthPressureError::Singular {
            model,
            alpha_deg: self.tool_angle.degrees(),
            phi_deg: self.friction.degrees(),
            delta_deg: self.interface.degrees(),
            reason,
        }
    }

    /// The soil behind the plate, as the models see it: mirrored, so that it too lies ahead.
    pub(crate) fn mirrored(&self) -> Self {
        Self {
            tool_angle: Angle::from_radians(std::f64::consts::PI - self.tool_angle.radians()),
            surface_slope: -self.surface_slope,
            ..*self
        }
    }
}

/// What each kind of load adds to the force on the plate, slant-normalised, per unit width:
/// `F = 1/2 gamma L^2 weight + q L surcharge + c L cohesion + c_a L adhesion`.
///
/// The terms are superposed: all four are taken on the mechanism that is critical for the weight of the soil
/// (Reece 1965), which for an upper-bound mechanism stays an upper bound, a few per cent above the joint
/// optimum. `q` is a vertical pressure per unit of surface area on both sides of the plate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoadFactors {
    /// Soil weight.
    pub weight: f64,
    /// Surcharge.
    pub surcharge: f64,
    /// Cohesion.
    pub cohesion: f64,
    /// Adhesion.
    pub adhesion: f64,
}

impl LoadFactors {
    /// Passive minus active. Cohesion and adhesion resist on both sides, so theirs add up.
    pub(crate) fn net(passive: Self, active: Self) -> Self {
        Self {
            weight: passive.weight - active.weight,
            surcharge: passive.surcharge - active.surcharge,
            cohesion: passive.cohesion + active.cohesion,
            adhesion: passive.adhesion + active.adhesion,
        }
    }
}

/// Loads beside the weight of the soil.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Loads {
    /// Cohesion in Pa.
    pub cohesion_pa: f64,
    /// Adhesion in Pa.
    pub adhesion_pa: f64,
    /// Surcharge in Pa, on both sides of the plate.
    pub surcharge_pa: f64,
}

impl Loads {
    /// The first load that is not zero, by name.
    #[must_use]
    pub fn any(&self) -> Option<&'static str> {
        [("cohesion", self.cohesion_pa), ("adhesion", self.adhesion_pa), ("surcharge", self.surcharge_pa)]
            .into_iter()
            .find(|&(_, value)| value != 0.0)
            .map(|(name, _)| name)
    }
}

/// Answer of a model for one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// Passive side; `None` where a table has no split.
    pub passive: Option<LoadFactors>,
    /// Active side; its cohesion and adhesion factors are what these take away from the active thrust.
    pub active: Option<LoadFactors>,
    /// Passive minus active.
    pub net: LoadFactors,
    /// Ends of the bracket on `net.weight`; both equal to it for a point prediction.
    pub net_lower: SlantCoefficient,
    /// See `net_lower`.
    pub net_upper: SlantCoefficient,
    /// By how much, relatively, interpolation in a table may be wrong; 0 for a solved cell or a formula.
    pub interpolation_margin: f64,
    /// What the user should know about this number.
    pub notes: Vec<&'static str>,
}

/// Proven bounds in plane strain at (41, 47, 44): 7.61 to 8.90, where the models of sides find 4.05.
const FLATTER_THAN_FRICTION: &str = "the plate is flatter than its friction angle, and what the soil behind, which it drags along, adds is left out";

impl Prediction {
    /// # Errors
    /// [`EarthPressureError::Singular`] if no force is left: the soil behind pushes at least as hard as the model finds
    /// that ahead to resist, as where the surface falls nearly at the friction angle.
    pub(crate) fn from_sides(
        model: &'static str,
        case: &Case,
        passive: LoadFactors,
        active: LoadFactors,
    ) -> Result<Self, EarthPressureError> {
        let net = LoadFactors::net(passive, active);
        if net.weight.is_nan() || net.weight <= 0.0 {
            return Err(case.singular(
                model,
                "the soil behind the plate pushes at least as hard as that ahead resists; the surface falls too steeply",
            ));
        }
        Ok(Self {
            passive: Some(passive),
            active: Some(active),
            net,
            net_lower: SlantCoefficient(net.weight),
            net_upper: SlantCoefficient(net.weight),
            interpolation_margin: 0.0,
            notes: if case.tool_angle < case.interface { vec![FLATTER_THAN_FRICTION] } else { Vec::new() },
        })
    }

    /// Slant-normalised coefficient of the weight term.
    #[must_use]
    pub fn k_net(&self) -> SlantCoefficient {
        SlantCoefficient(self.net.weight)
    }

    /// The bracket on the slant-normalised coefficient of the weight term.
    ///
    /// # Errors
    /// [`SoilError::InvertedBracket`] if a table's lower bound lies above its upper one.
    pub fn bracket(&self, provenance: Provenance) -> Result<Bracket, SoilError> {
        Bracket::new(self.net_lower.0, self.net_upper.0, provenance)
    }

    /// Failure force in N on a plate in a soil, with all loads.
    #[must_use]
    pub fn force_n(&self, plate: &Plate, soil: &Soil, loads: &Loads) -> f64 {
        let per_length = plate.slant_length_m() * plate.width_m();
        plate.weight_scale_n(soil) * self.net.weight
            + per_length
                * (loads.surcharge_pa * self.net.surcharge
                    + loads.cohesion_pa * self.net.cohesion
                    + loads.adhesion_pa * self.net.adhesion)
    }
}
