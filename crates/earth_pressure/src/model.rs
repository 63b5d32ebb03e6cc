use soilctl_soil::{Angle, Interface, Plate, Provenance, Soil, WidthRatio};

use crate::{Case, EarthPressureError, LoadFactors, Loads, Prediction};

/// A model of the force at which a plate fails the soil.
pub trait ForceModel: Send + Sync {
    /// Id on the command line and in files.
    fn id(&self) -> &'static str;

    /// Where the model comes from and what it is: exact, upper bound, table, ...
    fn reference(&self) -> &'static str;

    /// What the lower and the upper end of its brackets come from; the same for a point model.
    fn provenance(&self) -> Provenance {
        Provenance { lower: self.reference().into(), upper: self.reference().into() }
    }

    /// Angles for which the model answers.
    fn valid_range(&self) -> ValidRange;

    /// Whether the plate's width over its depth changes the answer; a model without ends is for plane strain and takes
    /// no notice of it.
    fn has_ends(&self) -> bool {
        false
    }

    /// Whether its bracket says what ends add at most: [`NetFactors::ends_at_most`] is above 0 for plates that have ends.
    fn bounds_ends(&self) -> bool {
        false
    }

    /// Whether it is asked about plane strain where nothing is said of a plate's width; see [`crate::InPlaneStrain`].
    fn is_for_plane_strain(&self) -> bool {
        !self.has_ends()
    }

    /// Whether each answer takes a search of a tenth of a second and more, too long for what asks for thousands.
    fn is_slow(&self) -> bool {
        false
    }

    /// Whether cohesion, adhesion and surcharge are covered in this case.
    fn has_load_terms(&self, case: &Case) -> bool {
        let _ = case;
        false
    }

    /// Whether answers are interpolated in a table, with a margin for that.
    fn interpolates(&self) -> bool {
        false
    }

    /// Coefficients for one case.
    ///
    /// # Errors
    /// [`EarthPressureError`] if an angle is outside the valid range, delta exceeds phi, or no finite answer
    /// exists.
    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError>;

    /// Passive failure surface from the tip of a plate of unit slant length; `None` for tables.
    ///
    /// # Errors
    /// As [`ForceModel::predict`].
    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        let _ = case;
        Ok(None)
    }

    /// The model at one geometry, prepared for many soils.
    ///
    /// # Errors
    /// [`EarthPressureError::OutsideModel`] if the geometry is outside the valid range.
    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError>;
}

/// A model at fixed tool angle, surface slope and width over depth: net load factors as a function of phi and delta.
pub trait ModelSlice: Send + Sync {
    /// Net factors for friction phi and interface friction delta, in degrees.
    ///
    /// # Errors
    /// As [`ForceModel::predict`].
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError>;
}

/// Net factors of a slice; the weight factor as a bracket (zero width for a point model).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NetFactors {
    /// Lower end of the weight factor.
    pub weight_lower: f64,
    /// Upper end of the weight factor.
    pub weight_upper: f64,
    /// How much of the bracket the ends of the plate are behind: what they add to the weight factor lies between nothing and this.
    /// 0 in plane strain, and of a model whose bracket says nothing of it.
    pub ends_at_most: f64,
    /// The other factors; `weight` is the geometric mean of the ends.
    pub factors: LoadFactors,
}

/// Slice of a closed-form model: calls `predict`.
pub(crate) struct DirectSlice<'a, M: ForceModel> {
    model: &'a M,
    tool_angle: Angle,
    surface_slope: Angle,
    width_ratio: WidthRatio,
}

impl<'a, M: ForceModel> DirectSlice<'a, M> {
    /// The slice at a geometry that the model covers.
    pub(crate) fn boxed(
        model: &'a M,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + 'a>, EarthPressureError> {
        model.valid_range().check_geometry(model.id(), tool_angle, surface_slope)?;
        Ok(Box::new(Self { model, tool_angle, surface_slope, width_ratio }))
    }
}

impl<M: ForceModel> ModelSlice for DirectSlice<'_, M> {
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError> {
        let case = Case {
            tool_angle: self.tool_angle,
            surface_slope: self.surface_slope,
            width_ratio: self.width_ratio,
            friction: Angle::from_degrees(phi_deg),
            interface: Angle::from_degrees(delta_deg),
        };
        let p = self.model.predict(&case)?;
        let [weight_lower, weight_upper] = [p.net_lower.0, p.net_upper.0];
        Ok(NetFactors { weight_lower, weight_upper, ends_at_most: 0.0, factors: p.net })
    }
}

/// Angles for which a model answers, in degrees, ends included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValidRange {
    /// Tool angle.
    pub alpha_deg: (f64, f64),
    /// Surface slope.
    pub beta_deg: (f64, f64),
    /// Soil friction.
    pub phi_deg: (f64, f64),
    /// Interface friction (and never above phi).
    pub delta_deg: (f64, f64),
}

impl ValidRange {
    /// Range of the closed-form models.
    pub(crate) const fn closed_form() -> Self {
        Self {
            alpha_deg: (20.0, 140.0),
            beta_deg: (-40.0, 40.0),
            phi_deg: (1.0, 60.0),
            delta_deg: (0.0, 60.0),
        }
    }

    /// Refuses a case outside the range.
    pub(crate) fn check(&self, model: &'static str, case: &Case) -> Result<(), EarthPressureError> {
        self.check_geometry(model, case.tool_angle, case.surface_slope)?;
        self.check_soil(model, case.friction.degrees(), case.interface.degrees())?;
        case.check(model)
    }

    pub(crate) fn check_geometry(
        &self,
        model: &'static str,
        tool_angle: Angle,
        surface_slope: Angle,
    ) -> Result<(), EarthPressureError> {
        in_range(model, "alpha", tool_angle.degrees(), self.alpha_deg)?;
        in_range(model, "beta", surface_slope.degrees(), self.beta_deg)
    }

    pub(crate) fn check_soil(
        &self,
        model: &'static str,
        phi_deg: f64,
        delta_deg: f64,
    ) -> Result<(), EarthPressureError> {
        in_range(model, "phi", phi_deg, self.phi_deg)?;
        in_range(model, "delta", delta_deg, self.delta_deg)
    }
}

/// A billionth of a degree is forgiven, so that a table's edge survives a unit conversion.
fn in_range(
    model: &'static str,
    quantity: &'static str,
    value: f64,
    (low, high): (f64, f64),
) -> Result<(), EarthPressureError> {
    if value >= low - 1e-9 && value <= high + 1e-9 {
        return Ok(());
    }
    let advice = match (low == high, quantity) {
        (true, "alpha") => "it is for an upright plate; use mckyes, perumpral or blocks-3d",
        (true, _) => {
            "it is for a level surface; use coulomb, chen or log-spiral, or blocks-3d for a plate with ends"
        }
        (false, _) => "use a model that covers it (coulomb, chen and log-spiral cover most)",
    };
    Err(EarthPressureError::OutsideModel { model, quantity, value, low, high, advice })
}

/// Passive failure surface of a plate of unit slant length, tip at the origin, x ahead, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct FailureSurface {
    /// Upper end of the plate at the surface.
    pub plate_top: (f64, f64),
    /// Polyline from the tip to the ground surface.
    pub points: Vec<(f64, f64)>,
}

impl FailureSurface {
    pub(crate) fn from_tip(case: &Case, points: Vec<(f64, f64)>) -> Self {
        let alpha = case.tool_angle;
        Self { plate_top: (-alpha.cos(), alpha.sin()), points }
    }

    /// Distance along the ground from the plate to where the surface daylights, in slant lengths.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.points.last().map_or(0.0, |&(x, y)| libm::hypot(x - self.plate_top.0, y - self.plate_top.1))
    }
}

/// Failure force in N of a model for a plate in a soil, with all loads, and the prediction behind it.
///
/// # Errors
/// As [`ForceModel::predict`]; [`EarthPressureError::NoLoadTerm`] if the model lacks a load that is not zero.
pub fn failure_force_n(
    model: &dyn ForceModel,
    plate: &Plate,
    soil: &Soil,
    interface: &Interface,
    surcharge_pa: f64,
) -> Result<(f64, Prediction), EarthPressureError> {
    let loads = Loads { cohesion_pa: soil.cohesion_pa(), adhesion_pa: interface.adhesion_pa(), surcharge_pa };
    let case = Case::of(plate, soil, interface);
    check_loads(model, &case, &loads)?;
    let prediction = model.predict(&case)?;
    Ok((prediction.force_n(plate, soil, &loads), prediction))
}

/// Refuses loads that the model has no term for.
///
/// # Errors
/// [`EarthPressureError::NoLoadTerm`].
pub fn check_loads(model: &dyn ForceModel, case: &Case, loads: &Loads) -> Result<(), EarthPressureError> {
    match loads.any() {
        Some(term) if !model.has_load_terms(case) => {
            Err(EarthPressureError::NoLoadTerm { model: model.id(), term })
        }
        _ => Ok(()),
    }
}
