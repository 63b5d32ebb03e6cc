//! A plate in a soil: the force by each model, where the soil fails, and which forces it bears.

use std::sync::OnceLock;

use serde::{Deserialize, Serialize};
use soilctl_app::request::Ends;
use soilctl_earth_pressure::{
    Case, EarthPressureError, ForceModel, Loads, MODEL_IDS, Prediction, check_loads, model,
};
use soilctl_soil::{Angle, Interface, Plate, Soil, SoilError, WidthRatio};

/// The proven bracket, and the mechanism that has an answer up to interfaces as rough as the soil (Hong 2001, figure 5-13).
const BRACKET: &str = "table";
const MECHANISM: &str = "chen";

/// A plate and the soil that it is in, as a page gives them.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Given {
    alpha_deg: f64,
    beta_deg: f64,
    depth_m: f64,
    width_m: f64,
    phi_deg: f64,
    delta_deg: f64,
    density_kg_m3: f64,
    cohesion_pa: f64,
    adhesion_pa: f64,
    surcharge_pa: f64,
    gravity_m_s2: f64,
    /// Also models whose answer takes a search of a tenth of a second and more.
    slow: bool,
}

/// What is shown of it. Places are in m, the plate's lower edge at the origin, x ahead and y up.
#[derive(Debug, PartialEq, Serialize)]
pub(crate) struct Shown {
    /// Where the plate meets the surface.
    top_m: [f64; 2],
    models: Vec<OfModel>,
    /// Forces that the soil bears by the proven bracket, and by the upper bound of Chen & Liu.
    borne: [Borne; 2],
}

/// The answer of a model, with or without ends.
#[derive(Debug, PartialEq, Serialize)]
struct OfModel {
    id: &'static str,
    reference: &'static str,
    ends: Ends,
    /// It takes a search, and was not asked.
    is_left_out: bool,
    /// Least and greatest force in N; the same for a model that names one.
    force_n: Option<[f64; 2]>,
    /// Net coefficient per slant length.
    k_net: Option<[f64; 2]>,
    interpolation_margin: f64,
    notes: Vec<&'static str>,
    /// From the plate's lower edge to the surface.
    surface_m: Option<Vec<[f64; 2]>>,
    error: Option<String>,
}

/// Forces that the soil bears, by their angle to the plate's normal (section 5.3.3): what a plate needs whose interface has just that
/// friction.
#[derive(Debug, PartialEq, Serialize)]
struct Borne {
    id: &'static str,
    ends: Ends,
    /// Angle in degrees, positive downwards; least and greatest force in N.
    points: Vec<[f64; 3]>,
    /// Why there are none, or not up to the friction angle of the soil.
    error: Option<String>,
}

/// A model by its id, or why it could not be made.
type Made = (&'static str, Result<Box<dyn ForceModel>, EarthPressureError>);

/// All models, made once.
fn models() -> &'static [Made] {
    static MODELS: OnceLock<Vec<Made>> = OnceLock::new();
    MODELS.get_or_init(|| MODEL_IDS.iter().map(|id| (*id, model(id))).collect())
}

/// The plate, the soil and its loads, checked.
struct Bench {
    plate: Plate,
    soil: Soil,
    interface: Interface,
    loads: Loads,
    is_slow_asked: bool,
}

/// What is shown of a plate in a soil.
///
/// # Errors
/// [`SoilError::OutOfRange`] for values that no plate or soil has. That a model does not cover a case is said beside the others.
pub(crate) fn shown(given: &Given) -> Result<Shown, SoilError> {
    let bench = Bench::new(given)?;
    let slant_m = bench.plate.slant_length_m();
    let alpha = bench.plate.tool_angle();
    let mut found = Vec::new();
    for (id, made) in models() {
        match made {
            Ok(model) => {
                let with = model.has_ends().then_some(Ends::Finite);
                let without = model.is_for_plane_strain().then_some(Ends::None);
                found.extend([without, with].into_iter().flatten().map(|ends| bench.of(&**model, ends)));
            }
            Err(problem) => found.push(OfModel { error: Some(problem.to_string()), ..OfModel::none(id) }),
        }
    }
    Ok(Shown {
        top_m: [-slant_m * alpha.cos(), slant_m * alpha.sin()],
        models: found,
        borne: [bench.borne(BRACKET, Ends::Finite), bench.borne(MECHANISM, Ends::None)],
    })
}

impl Bench {
    fn new(given: &Given) -> Result<Self, SoilError> {
        let angle = Angle::from_degrees;
        let plate = Plate::new(angle(given.alpha_deg), angle(given.beta_deg), given.depth_m, given.width_m)?;
        let soil = Soil::new(angle(given.phi_deg), given.density_kg_m3)?
            .with_cohesion(given.cohesion_pa)?
            .with_gravity(given.gravity_m_s2)?;
        let interface = Interface::new(angle(given.delta_deg), given.adhesion_pa)?;
        if given.surcharge_pa < 0.0 {
            return Err(SoilError::OutOfRange {
                quantity: "surcharge",
                value: given.surcharge_pa,
                unit: "Pa",
                allowed: "at least 0 Pa",
            });
        }
        let (cohesion_pa, adhesion_pa) = (given.cohesion_pa, given.adhesion_pa);
        let loads = Loads { cohesion_pa, adhesion_pa, surcharge_pa: given.surcharge_pa };
        Ok(Self { plate, soil, interface, loads, is_slow_asked: given.slow })
    }

    fn case(&self, ends: Ends) -> Case {
        let case = Case::of(&self.plate, &self.soil, &self.interface);
        match ends {
            Ends::Finite => case,
            Ends::None => case.with_width_ratio(WidthRatio::PLANE_STRAIN),
        }
    }

    fn predict(&self, model: &dyn ForceModel, case: &Case) -> Result<Prediction, EarthPressureError> {
        check_loads(model, case, &self.loads)?;
        model.predict(case)
    }

    /// Least and greatest force in N.
    fn forces_n(&self, found: &Prediction) -> [f64; 2] {
        let (force_n, scale_n) =
            (found.force_n(&self.plate, &self.soil, &self.loads), self.plate.weight_scale_n(&self.soil));
        [found.net_lower, found.net_upper].map(|end| scale_n.mul_add(end.0 - found.net.weight, force_n))
    }

    fn of(&self, model: &dyn ForceModel, ends: Ends) -> OfModel {
        let blank = OfModel { reference: model.reference(), ends, ..OfModel::none(model.id()) };
        if model.is_slow() && !self.is_slow_asked {
            return OfModel { is_left_out: true, ..blank };
        }
        let case = self.case(ends);
        match self.predict(model, &case) {
            Ok(found) => OfModel {
                force_n: Some(self.forces_n(&found)),
                k_net: Some([found.net_lower.0, found.net_upper.0]),
                interpolation_margin: found.interpolation_margin,
                surface_m: self.surface_m(model, &case),
                notes: found.notes,
                ..blank
            },
            Err(problem) => OfModel { error: Some(problem.to_string()), ..blank },
        }
    }

    /// None for a table, and where a model that has a force has no surface.
    fn surface_m(&self, model: &dyn ForceModel, case: &Case) -> Option<Vec<[f64; 2]>> {
        let slant_m = self.plate.slant_length_m();
        let surface = model.failure_surface(case).ok()??;
        Some(surface.points.iter().map(|&(x, y)| [slant_m * x, slant_m * y]).collect())
    }

    fn borne(&self, id: &'static str, ends: Ends) -> Borne {
        let mut borne = Borne { id, ends, points: Vec::new(), error: None };
        let made = models().iter().find(|(known, _)| *known == id).map(|(_, made)| made);
        let Some(Ok(model)) = made else {
            borne.error = made.and_then(|made| made.as_ref().err()).map(ToString::to_string);
            return borne;
        };
        let phi_deg = self.soil.friction().degrees();
        let whole = (0..=90).map(f64::from).take_while(|angle| *angle < phi_deg);
        for angle_deg in whole.chain([phi_deg]) {
            let case = Case { interface: Angle::from_degrees(angle_deg), ..self.case(ends) };
            match self.predict(&**model, &case) {
                Ok(found) => {
                    let [low, high] = self.forces_n(&found);
                    borne.points.push([angle_deg, low, high]);
                }
                Err(problem) => {
                    borne.error = Some(problem.to_string());
                    break;
                }
            }
        }
        borne
    }
}

impl OfModel {
    const fn none(id: &'static str) -> Self {
        Self {
            id,
            reference: "",
            ends: Ends::None,
            is_left_out: false,
            force_n: None,
            k_net: None,
            interpolation_margin: 0.0,
            notes: Vec::new(),
            surface_m: None,
            error: None,
        }
    }
}
