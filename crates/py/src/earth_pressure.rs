//! Force models: coefficients and forces of plates, vectorised.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyTuple};
use soilctl_app::request::Ends;
use soilctl_earth_pressure::{
    Case, EarthPressureError, ForceModel, InPlaneStrain, Loads, MODEL_IDS, check_loads, model,
};
use soilctl_soil::{Angle, Interface, Plate, STANDARD_GRAVITY_M_S2, Soil, WidthRatio};

use crate::array::{Array, Column, common_shape, place, shaped};
use crate::copies::maker;
use crate::error::{Answer, Fail, file_at, input, no_answer};
use crate::work::in_blocks;

/// Models by id and by whether they are asked about plane strain.
type Models = BTreeMap<(String, bool), Arc<dyn ForceModel>>;

/// A model of these, made once: tables take a while to read.
fn made_once(id: &str, in_plane_strain: bool) -> Result<Arc<dyn ForceModel>, EarthPressureError> {
    static MODELS: OnceLock<Mutex<Models>> = OnceLock::new();
    let models = MODELS.get_or_init(Mutex::default);
    let mut models = models.lock().unwrap_or_else(PoisonError::into_inner);
    let key = (id.to_owned(), in_plane_strain);
    if let Some(found) = models.get(&key) {
        return Ok(Arc::clone(found));
    }
    let made = model(id)?;
    let made: Arc<dyn ForceModel> = Arc::from(if in_plane_strain { InPlaneStrain::of(made) } else { made });
    models.insert(key, Arc::clone(&made));
    Ok(made)
}

/// A model by its id; plates have ends if it knows them and they have a width.
pub(crate) fn known(id: &str) -> Result<Arc<dyn ForceModel>, EarthPressureError> {
    made_once(id, false)
}

/// A model of plane strain by its id.
pub(crate) fn plane(id: &str) -> Result<Arc<dyn ForceModel>, EarthPressureError> {
    let model = made_once(id, true)?;
    let own = made_once(id, false)?;
    if own.is_for_plane_strain() { Ok(model) } else { Err(EarthPressureError::HasEnds { model: own.id() }) }
}

/// A model as it is asked about plates, and whether they have ends.
pub(crate) fn asked(id: &str, ends: Option<&str>, sized: bool) -> Answer<(Arc<dyn ForceModel>, Ends)> {
    let own = made_once(id, false)?;
    let ends = Ends::of(ends.map(ends_named).transpose()?, own.as_ref(), sized)?;
    Ok((if ends == Ends::None { made_once(id, true)? } else { own }, ends))
}

pub(crate) fn ends_named(name: &str) -> Answer<Ends> {
    match name {
        "finite" => Ok(Ends::Finite),
        "none" => Ok(Ends::None),
        other => Err(input(format!("ends is {other:?}; it must be finite or none"))),
    }
}

/// Coefficients of a plate, and its failure force if all that it needs was given.
///
/// Attributes are floats if all arguments were numbers, and otherwise arrays of their common shape. Coefficients are
/// normalised by the slant length L: ``F = 1/2 gamma L^2 w K``.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Prediction {
    /// Id of the model.
    #[pyo3(get)]
    model: String,
    /// Where the model comes from.
    #[pyo3(get)]
    reference: String,
    /// Net coefficient (passive minus active); the geometric mean of the ends of a bracket.
    #[pyo3(get)]
    coefficient: Py<PyAny>,
    /// Ends of the bracket on the net coefficient and on the force; None for a point model.
    ends: Option<Bounds>,
    /// By how much, relatively, interpolation in a table may be wrong; None for a formula.
    #[pyo3(get)]
    interpolation_margin: Option<Py<PyAny>>,
    /// Failure force in N with all loads; None without density, depth and width.
    #[pyo3(get)]
    force_n: Option<Py<PyAny>>,
}

/// Lower and upper ends.
struct Bounds {
    coefficient: [Py<PyAny>; 2],
    force_n: Option<[Py<PyAny>; 2]>,
}

impl Prediction {
    /// One end of the bracket on the coefficient. That of a point model is a copy: who changes one array means one.
    fn end(&self, py: Python<'_>, which: usize) -> PyResult<Py<PyAny>> {
        match &self.ends {
            Some(ends) => Ok(ends.coefficient[which].clone_ref(py)),
            None => copied(py, &self.coefficient),
        }
    }

    fn force_end(&self, py: Python<'_>, which: usize) -> PyResult<Option<Py<PyAny>>> {
        match (&self.ends, &self.force_n) {
            (Some(ends), _) => Ok(ends.force_n.as_ref().map(|ends| ends[which].clone_ref(py))),
            (None, Some(force)) => copied(py, force).map(Some),
            (None, None) => Ok(None),
        }
    }
}

/// Another array of the same numbers; a float as it is.
fn copied(py: Python<'_>, value: &Py<PyAny>) -> PyResult<Py<PyAny>> {
    let value = value.bind(py);
    let copied =
        if value.is_instance_of::<PyFloat>() { value.clone() } else { value.call_method0("copy")? };
    Ok(copied.unbind())
}

#[pymethods]
impl Prediction {
    /// Lower end of the bracket on the net coefficient; that itself for a point model.
    #[getter]
    fn lower(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.end(py, 0)
    }

    /// Upper end of it.
    #[getter]
    fn upper(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.end(py, 1)
    }

    /// Lower end of the bracket on the force in N.
    #[getter]
    fn force_lower_n(&self, py: Python<'_>) -> PyResult<Option<Py<PyAny>>> {
        self.force_end(py, 0)
    }

    /// Upper end of it.
    #[getter]
    fn force_upper_n(&self, py: Python<'_>) -> PyResult<Option<Py<PyAny>>> {
        self.force_end(py, 1)
    }

    /// Everything as a dict of numbers and arrays.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("model", &self.model)?;
        dict.set_item("coefficient", &self.coefficient)?;
        dict.set_item("lower", self.lower(py)?)?;
        dict.set_item("upper", self.upper(py)?)?;
        let (lower_n, upper_n) = (self.force_lower_n(py)?, self.force_upper_n(py)?);
        for (key, value) in [
            ("interpolation_margin", &self.interpolation_margin),
            ("force_n", &self.force_n),
            ("force_lower_n", &lower_n),
            ("force_upper_n", &upper_n),
        ] {
            if let Some(value) = value {
                dict.set_item(key, value)?;
            }
        }
        Ok(dict)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, own) = (slf.py(), slf.get());
        let ends = own.ends.as_ref().map(|ends| {
            let [low, high] = &ends.coefficient;
            let force_n = ends.force_n.as_ref().map(|[low, high]| (low, high));
            ((low, high), force_n)
        });
        let named = (&own.model, &own.reference);
        let args = (named, &own.coefficient, ends, &own.interpolation_margin, &own.force_n);
        Ok((maker(py, "_restore_prediction")?, args.into_pyobject(py)?))
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        let mut rows = String::new();
        for (key, value) in self.to_dict(py)? {
            let value = value.str()?.to_string().replace('&', "&amp;").replace('<', "&lt;");
            rows += &format!("<tr><th>{key}</th><td>{value}</td></tr>");
        }
        Ok(format!("<table>{rows}</table>"))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let coefficient = self.coefficient.bind(py).repr()?;
        let force = match &self.force_n {
            Some(force) => format!(", force_n={}", force.bind(py).repr()?),
            None => String::new(),
        };
        Ok(format!("Prediction(model={:?}, coefficient={coefficient}{force})", self.model))
    }
}

type Pair = (Py<PyAny>, Py<PyAny>);

/// A prediction as `__reduce__` has taken it apart.
#[pyfunction]
#[pyo3(name = "_restore_prediction")]
pub(crate) fn restore_prediction(
    named: (String, String),
    coefficient: Py<PyAny>,
    ends: Option<(Pair, Option<Pair>)>,
    interpolation_margin: Option<Py<PyAny>>,
    force_n: Option<Py<PyAny>>,
) -> Prediction {
    let (model, reference) = named;
    let ends =
        ends.map(|(both, force_n)| Bounds { coefficient: both.into(), force_n: force_n.map(Into::into) });
    Prediction { model, reference, coefficient, ends, interpolation_margin, force_n }
}

/// What is kept of each element.
#[derive(Clone, Copy)]
struct Point {
    net: f64,
    ends: [f64; 2],
    margin: f64,
    /// Force per coefficient, and the force of the other loads, in N.
    newtons: Option<[f64; 2]>,
}

/// Arguments of `predict` with their names.
struct Given<'a> {
    alpha: Column<'a>,
    phi: Column<'a>,
    delta: Column<'a>,
    beta: Column<'a>,
    gravity: Column<'a>,
    loads: [Column<'a>; 3],
    /// Density, depth and width.
    sizes: Option<[Column<'a>; 3]>,
}

impl Given<'_> {
    fn point(&self, model: &dyn ForceModel, i: usize) -> Result<Point, EarthPressureError> {
        let mut case = Case::from_deg(self.alpha.at(i), self.beta.at(i), self.phi.at(i), self.delta.at(i));
        if model.has_ends() {
            let Some([_, depth, width]) = &self.sizes else {
                return Err(EarthPressureError::NeedsEnds {
                    model: model.id(),
                    advice: "give density_kg_m3, depth_m and width_m, or ends=\"none\" for plane strain",
                });
            };
            let plate = Plate::new(case.tool_angle, case.surface_slope, depth.at(i), width.at(i))?;
            case = case.with_width_ratio(plate.width_ratio());
        }
        let [cohesion_pa, adhesion_pa, surcharge_pa] = [0, 1, 2].map(|k| self.loads[k].at(i));
        let loads = Loads { cohesion_pa, adhesion_pa, surcharge_pa };
        check_loads(model, &case, &loads)?;
        let found = model.predict(&case)?;
        let newtons = match &self.sizes {
            None => None,
            Some([density, depth, width]) => {
                let plate = Plate::new(case.tool_angle, case.surface_slope, depth.at(i), width.at(i))?;
                let soil = Soil::new(case.friction, density.at(i))?
                    .with_cohesion(cohesion_pa)?
                    .with_gravity(self.gravity.at(i))?;
                Interface::new(case.interface, adhesion_pa)?;
                let scale = plate.weight_scale_n(&soil);
                Some([scale, found.force_n(&plate, &soil, &loads) - scale * found.net.weight])
            }
        };
        let ends = [found.net_lower.0, found.net_upper.0];
        Ok(Point { net: found.net.weight, ends, margin: found.interpolation_margin, newtons })
    }
}

/// Coefficients and forces of a flat plate that fails soil, by a named model.
///
/// All numbers may be arrays; they are broadcast against each other. The work is done without the interpreter's lock, on all
/// cores, and Ctrl-C ends it.
///
/// Args:
///     model: One of ``soilctl.MODELS``.
///     tool_angle_deg: Plate from the horizontal.
///     friction_angle_deg: Internal friction of the soil.
///     interface_friction_deg: Friction between soil and plate, at most that of the soil.
///     surface_slope_deg: Slope of the ground, positive when it rises ahead of the plate.
///     density_kg_m3: Bulk density; for forces, with depth and width.
///     depth_m: Vertical depth of the plate's lower edge.
///     width_m: Width of the plate.
///     cohesion_pa: Cohesion of the soil.
///     adhesion_pa: Adhesion between soil and plate.
///     surcharge_pa: Vertical pressure on the surface.
///     gravity_m_s2: Gravity.
///     ends: ``finite`` for a plate with ends, whose force is above that of plane strain, ``none`` for plane strain. By default a
///         plate has ends if the model knows them and the plate has a width.
///
/// Raises:
///     InputError: If a number is out of the model's range, not finite, or a shape does not go with the others.
///     NoAnswerError: If there is no finite answer. The message names the first element that has none.
#[pyfunction]
#[pyo3(signature = (
    model = "chen", *, tool_angle_deg, friction_angle_deg, interface_friction_deg, surface_slope_deg = None,
    density_kg_m3 = None, depth_m = None, width_m = None, cohesion_pa = None, adhesion_pa = None, surcharge_pa = None,
    gravity_m_s2 = None, ends = None,
))]
#[allow(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn predict<'py>(
    py: Python<'py>,
    model: &str,
    tool_angle_deg: &Bound<'py, PyAny>,
    friction_angle_deg: &Bound<'py, PyAny>,
    interface_friction_deg: &Bound<'py, PyAny>,
    surface_slope_deg: Option<&Bound<'py, PyAny>>,
    density_kg_m3: Option<&Bound<'py, PyAny>>,
    depth_m: Option<&Bound<'py, PyAny>>,
    width_m: Option<&Bound<'py, PyAny>>,
    cohesion_pa: Option<&Bound<'py, PyAny>>,
    adhesion_pa: Option<&Bound<'py, PyAny>>,
    surcharge_pa: Option<&Bound<'py, PyAny>>,
    gravity_m_s2: Option<&Bound<'py, PyAny>>,
    ends: Option<&str>,
) -> Answer<Prediction> {
    let alpha = Array::new("tool_angle_deg", tool_angle_deg)?;
    let phi = Array::new("friction_angle_deg", friction_angle_deg)?;
    let delta = Array::new("interface_friction_deg", interface_friction_deg)?;
    let beta = Array::or(py, "surface_slope_deg", surface_slope_deg, 0.0)?;
    let gravity = Array::or(py, "gravity_m_s2", gravity_m_s2, STANDARD_GRAVITY_M_S2)?;
    let cohesion = Array::or(py, "cohesion_pa", cohesion_pa, 0.0)?;
    let adhesion = Array::or(py, "adhesion_pa", adhesion_pa, 0.0)?;
    let surcharge = Array::or(py, "surcharge_pa", surcharge_pa, 0.0)?;
    let sizes = match (density_kg_m3, depth_m, width_m) {
        (None, None, None) => {
            let loads = [
                ("cohesion_pa", cohesion_pa),
                ("adhesion_pa", adhesion_pa),
                ("surcharge_pa", surcharge_pa),
                ("gravity_m_s2", gravity_m_s2),
            ];
            if let Some((name, _)) = loads.into_iter().find(|(_, given)| given.is_some()) {
                return Err(input(format!(
                    "{name} changes forces only, not coefficients; give density_kg_m3, depth_m and width_m too"
                )));
            }
            None
        }
        (Some(density), Some(depth), Some(width)) => Some([
            Array::new("density_kg_m3", density)?,
            Array::new("depth_m", depth)?,
            Array::new("width_m", width)?,
        ]),
        _ => return Err(input("a force needs density_kg_m3, depth_m and width_m; give all or none")),
    };
    let mut arrays = vec![&alpha, &phi, &delta, &beta, &gravity, &cohesion, &adhesion, &surcharge];
    arrays.extend(sizes.iter().flatten());
    let shape = common_shape(&arrays)?;
    let column = |array| Column::new(array, &shape);
    let given = Given {
        alpha: column(&alpha)?,
        phi: column(&phi)?,
        delta: column(&delta)?,
        beta: column(&beta)?,
        gravity: column(&gravity)?,
        loads: [column(&cohesion)?, column(&adhesion)?, column(&surcharge)?],
        sizes: match &sizes {
            Some([density, depth, width]) => Some([column(density)?, column(depth)?, column(width)?]),
            None => None,
        },
    };
    let (model, _) = asked(model, ends, sizes.is_some())?;
    let mut columns = Columns::default();
    in_blocks(py, &shape, |i| given.point(model.as_ref(), i), |points| columns.take(&points))?;
    columns.answer(py, model.as_ref(), &shape)
}

/// What is kept of all elements.
#[derive(Default)]
struct Columns {
    net: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
    margin: Vec<f64>,
    /// Force per coefficient, and of the other loads; empty if no force was asked for.
    newtons: Vec<[f64; 2]>,
}

impl Columns {
    fn take(&mut self, points: &[Point]) {
        self.net.extend(points.iter().map(|point| point.net));
        self.lower.extend(points.iter().map(|point| point.ends[0]));
        self.upper.extend(points.iter().map(|point| point.ends[1]));
        self.margin.extend(points.iter().map(|point| point.margin));
        self.newtons.extend(points.iter().filter_map(|point| point.newtons));
    }

    fn answer(self, py: Python<'_>, model: &dyn ForceModel, shape: &[usize]) -> Answer<Prediction> {
        let array = |values: Vec<f64>| -> Answer<Py<PyAny>> {
            if let Some(at) = values.iter().position(|value| !value.is_finite()) {
                return Err(beyond(&place(at, shape), values[at]));
            }
            Ok(shaped(py, values, shape)?.unbind())
        };
        let force = |of: &[f64]| -> Answer<Option<Py<PyAny>>> {
            let all = || of.iter().zip(&self.newtons).map(|(k, [scale, rest])| scale * k + rest).collect();
            (!self.newtons.is_empty()).then(|| array(all())).transpose()
        };
        let force_n = force(&self.net)?;
        let ends = if self.lower != self.net || self.upper != self.net {
            let force_n = force(&self.lower)?.zip(force(&self.upper)?).map(Into::into);
            Some(Bounds { coefficient: [array(self.lower)?, array(self.upper)?], force_n })
        } else {
            None
        };
        let interpolation_margin = if model.interpolates() { Some(array(self.margin)?) } else { None };
        let coefficient = array(self.net)?;
        Ok(Prediction {
            model: model.id().to_owned(),
            reference: model.reference().to_owned(),
            ends,
            interpolation_margin,
            coefficient,
            force_n,
        })
    }
}

/// Numbers so large or small that a result is none.
pub(crate) fn beyond(place: &str, value: f64) -> Fail {
    let value = value.to_string().to_lowercase();
    no_answer(format!(
        "{place}a result came out as {value}, which is no answer; the inputs are beyond what double precision can hold, \
         so bring them closer to the size of a real plate and soil"
    ))
}

/// Angles in degrees for which a model answers, ends included, by the name of the argument of ``predict``.
///
/// Raises:
///     InputError: If there is no such model.
#[pyfunction]
pub(crate) fn valid_range<'py>(py: Python<'py>, model: &str) -> Answer<Bound<'py, PyDict>> {
    let range = known(model)?.valid_range();
    let dict = PyDict::new(py);
    dict.set_item("tool_angle_deg", range.alpha_deg)?;
    dict.set_item("surface_slope_deg", range.beta_deg)?;
    dict.set_item("friction_angle_deg", range.phi_deg)?;
    dict.set_item("interface_friction_deg", range.delta_deg)?;
    Ok(dict)
}

/// Failure surface ahead of a plate of unit slant length: points of shape (n, 2) from the tip to the ground.
///
/// The tip is the origin, x points ahead and y up; the plate has no ends. None for tables, which know no surface.
///
/// Raises:
///     InputError, NoAnswerError: As ``predict``.
#[pyfunction]
#[pyo3(signature = (
    model = "chen", *, tool_angle_deg, friction_angle_deg, interface_friction_deg, surface_slope_deg = 0.0
))]
pub(crate) fn failure_surface<'py>(
    py: Python<'py>,
    model: &str,
    tool_angle_deg: f64,
    friction_angle_deg: f64,
    interface_friction_deg: f64,
    surface_slope_deg: f64,
) -> Answer<Option<Bound<'py, PyAny>>> {
    let case = Case {
        tool_angle: Angle::from_degrees(tool_angle_deg),
        surface_slope: Angle::from_degrees(surface_slope_deg),
        width_ratio: WidthRatio::PLANE_STRAIN,
        friction: Angle::from_degrees(friction_angle_deg),
        interface: Angle::from_degrees(interface_friction_deg),
    };
    let Some(found) = known(model)?.failure_surface(&case)? else { return Ok(None) };
    let shape = [found.points.len(), 2];
    Ok(Some(shaped(py, found.points.into_iter().flat_map(|(x, y)| [x, y]).collect(), &shape)?))
}

pub(crate) const MODELS: [&str; MODEL_IDS.len()] = MODEL_IDS;

impl From<EarthPressureError> for Fail {
    fn from(problem: EarthPressureError) -> Self {
        match problem {
            EarthPressureError::Singular { .. } | EarthPressureError::EmptyCell { .. } => no_answer(problem),
            EarthPressureError::File { ref path, .. } => file_at(&problem, path),
            _ => input(problem),
        }
    }
}
