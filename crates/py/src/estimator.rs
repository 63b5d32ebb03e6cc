//! From measured failure forces to every soil that could have produced them.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use soilctl_app::request::Ends;
use soilctl_earth_pressure::{ChenLiu, EarthPressureError, ForceModel, Loads};
use soilctl_estimator::{
    Conflict, Estimate as ConsistentSoils, EstimatorError, Fit, Observation, Setup, StrokeMenu,
    agreement_factor, bands, best_fit, conflict, estimate as find, next_strokes, section,
};
use soilctl_soil::{Angle, Plate};

use crate::array::{Array, Column, common_shape, interval, interval_or_none};
use crate::copies::maker;
use crate::earth_pressure::asked;
use crate::error::{Answer, Fail, input, no_answer};
use crate::interruptible::stoppable;
use crate::region::{boundary_table, geojson, html, svg};
use crate::watched::Watched;

/// Everything that an estimate starts from.
struct Known {
    /// As given, a row a measurement: tool angle and slope of the ground in degrees, depth, width, force and its half width.
    given: Vec<[f64; 6]>,
    model: Arc<dyn ForceModel>,
    ends: Ends,
    end_tolerance: f64,
    observations: Vec<Observation>,
    delta_deg: (f64, f64),
    density_kg_m3: Option<(f64, f64)>,
    phi_search_deg: Option<(f64, f64)>,
    gravity_m_s2: f64,
    loads: Loads,
}

impl Known {
    fn setup<'a>(&self, model: &'a dyn ForceModel) -> Setup<'a> {
        Setup {
            density_kg_m3: self.density_kg_m3,
            phi_search_deg: self.phi_search_deg,
            gravity_m_s2: self.gravity_m_s2,
            loads: self.loads,
            end_tolerance: self.end_tolerance,
            ..Setup::new(model, self.observations.clone(), self.delta_deg)
        }
    }

    /// Computes something of the measurements, without the interpreter's lock, until Ctrl-C.
    fn compute<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&Setup<'_>) -> Result<T, EstimatorError> + Send,
    ) -> Answer<T> {
        stoppable(py, |stop| work(&self.setup(&Watched { model: self.model.as_ref(), stop })))
    }
}

/// Every soil that could have produced the measurements.
///
/// The region encloses the consistent soils: its boundary lies outside of the true one by at most 0.03 % in density.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Estimate {
    known: Known,
    found: ConsistentSoils,
    conflict: Conflict,
    fit: Option<Fit>,
}

#[pymethods]
impl Estimate {
    /// Whether any soil is consistent with all measurements.
    #[getter]
    fn consistent(&self) -> bool {
        self.found.is_consistent()
    }

    /// Least and greatest friction angle in degrees; None if no soil is consistent.
    #[getter]
    fn friction_angle_deg(&self) -> Option<(f64, f64)> {
        self.found.phi_deg.map(Into::into)
    }

    /// Least and greatest bulk density in kg/m3; None if no soil is consistent.
    #[getter]
    fn density_kg_m3(&self) -> Option<(f64, f64)> {
        self.found.density_kg_m3.map(Into::into)
    }

    /// Least and greatest end factor that strokes may share: the part of what ends add at most that they do add.
    /// None if they share none, or no soil is consistent.
    #[getter]
    fn end_factor(&self) -> Option<(f64, f64)> {
        self.found.end_factor.map(Into::into)
    }

    /// Area of the region in deg kg/m3.
    #[getter]
    fn area(&self) -> f64 {
        self.found.region.area()
    }

    /// Whether a limit of the search rather than a measurement cuts the region, so that it may be larger.
    #[getter]
    fn cut_by_search(&self) -> bool {
        self.found.limits.any()
    }

    /// The soil that fits best: a dict of friction angle, density, interface friction and misfit; None if there is none.
    #[getter]
    fn best_fit<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(fit) = &self.fit else { return Ok(None) };
        let dict = PyDict::new(py);
        dict.set_item("friction_angle_deg", fit.phi_deg)?;
        dict.set_item("density_kg_m3", fit.density_kg_m3)?;
        dict.set_item("interface_friction_deg", fit.delta_deg)?;
        dict.set_item("misfit", fit.misfit)?;
        Ok(Some(dict))
    }

    /// What breaks the consistency, by the places of measurements: ``culprits`` without which all others agree, ``pairs``
    /// that no soil explains together, and those that none explains ``alone``.
    #[getter]
    fn conflict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("culprits", &self.conflict.culprits)?;
        dict.set_item("pairs", &self.conflict.pairs)?;
        dict.set_item("alone", &self.conflict.alone)?;
        Ok(dict)
    }

    /// Factor by which all force intervals must grow (or, below 1, may shrink) until the measurements only just agree; None
    /// if ten times the uncertainty is not enough.
    fn agreement_factor(&self, py: Python<'_>) -> Answer<Option<f64>> {
        self.known.compute(py, agreement_factor)
    }

    /// Whether a soil, whatever its interface friction, is consistent.
    ///
    /// Raises:
    ///     InputError: If a number is not finite.
    fn contains(&self, friction_angle_deg: f64, density_kg_m3: f64) -> Answer<bool> {
        finite("friction_angle_deg", friction_angle_deg)?;
        finite("density_kg_m3", density_kg_m3)?;
        Ok(self.found.region.contains([friction_angle_deg, density_kg_m3]))
    }

    /// The region as a GeoJSON geometry (MultiPolygon) with x the friction angle in degrees and y the density in kg/m3.
    #[getter]
    fn __geo_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        geojson(py, &self.found.region)
    }

    /// The consistent soils at one interface friction, as a GeoJSON geometry like ``__geo_interface__``.
    ///
    /// Args:
    ///     interface_friction_deg: Within the interval that the estimate was made for, or any that the model covers.
    ///
    /// Raises:
    ///     InputError: If the angle is out of range.
    fn section<'py>(&self, py: Python<'py>, interface_friction_deg: f64) -> Answer<Bound<'py, PyDict>> {
        let region = self.known.compute(py, |setup| section(setup, interface_friction_deg))?;
        Ok(geojson(py, &region)?)
    }

    /// What each measurement alone would allow at one interface friction: GeoJSON geometries in the order of the
    /// measurements.
    ///
    /// Raises:
    ///     InputError: If the angle is out of range.
    fn bands<'py>(&self, py: Python<'py>, interface_friction_deg: f64) -> Answer<Vec<Bound<'py, PyDict>>> {
        let found = self.known.compute(py, |setup| bands(setup, interface_friction_deg))?;
        found.iter().map(|region| Ok(geojson(py, region)?)).collect()
    }

    /// Strokes that would shrink the region most, the best first: dicts of ``tool_angle_deg``, ``depth_m``,
    /// ``width_m``, ``area_left`` (relative to now), ``friction_angle_width_deg``, ``density_width_kg_m3``, ``force_n`` and ``model``.
    ///
    /// Args:
    ///     tool_angle_deg: Angles to consider, shape (n,).
    ///     depth_m: Depths to consider, shape (m,).
    ///     width_m: Widths of plates to consider, a number or shape (k,).
    ///     force_scatter: Relative scatter of the force from stroke to stroke, one half width.
    ///     depth_error_m: Uncertainty of the depth, one half width.
    ///     force_limit_n: Greatest force of the arm; strokes above it are left out. None for any.
    ///
    /// Raises:
    ///     NoAnswerError: If no soil is consistent, or there is nothing to choose from.
    ///     InputError: If a number is out of its range.
    #[pyo3(signature = (*, tool_angle_deg, depth_m, width_m, force_scatter = 0.05, depth_error_m = 0.0005, force_limit_n = None))]
    #[allow(clippy::too_many_arguments, reason = "keywords of a Python function")]
    fn next_strokes<'py>(
        &self,
        py: Python<'py>,
        tool_angle_deg: &Bound<'py, PyAny>,
        depth_m: &Bound<'py, PyAny>,
        width_m: &Bound<'py, PyAny>,
        force_scatter: f64,
        depth_error_m: f64,
        force_limit_n: Option<f64>,
    ) -> Answer<Vec<Bound<'py, PyDict>>> {
        let listed = |name, value| Array::new(name, value)?.values();
        let menu = StrokeMenu {
            tool_angles_deg: listed("tool_angle_deg", tool_angle_deg)?,
            depths_m: listed("depth_m", depth_m)?,
            widths_m: listed("width_m", width_m)?,
            force_scatter,
            depth_error_m,
            force_limit_n,
        };
        let found = stoppable(py, |stop| {
            let model = Watched { model: self.known.model.as_ref(), stop };
            let closed_form = Watched { model: &ChenLiu, stop };
            next_strokes(&self.known.setup(&model), &self.found, &menu, &closed_form)
        })?;
        let dicts = found.iter().map(|stroke| -> PyResult<_> {
            let dict = PyDict::new(py);
            dict.set_item("tool_angle_deg", stroke.alpha_deg)?;
            dict.set_item("depth_m", stroke.depth_m)?;
            dict.set_item("width_m", stroke.width_m)?;
            dict.set_item("area_left", stroke.area_left)?;
            dict.set_item("friction_angle_width_deg", stroke.phi_width_deg)?;
            dict.set_item("density_width_kg_m3", stroke.density_width_kg_m3)?;
            dict.set_item("force_n", stroke.force_n)?;
            dict.set_item("model", stroke.model)?;
            Ok(dict)
        });
        Ok(dicts.collect::<PyResult<_>>()?)
    }

    /// The numbers as a dict.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("consistent", self.consistent())?;
        dict.set_item("friction_angle_deg", self.friction_angle_deg())?;
        dict.set_item("density_kg_m3", self.density_kg_m3())?;
        dict.set_item("end_factor", self.end_factor())?;
        dict.set_item("area", self.area())?;
        dict.set_item("cut_by_search", self.cut_by_search())?;
        dict.set_item("best_fit", self.best_fit(py)?)?;
        dict.set_item("conflict", self.conflict(py)?)?;
        Ok(dict)
    }

    /// The boundary of the region as a pandas DataFrame: a row a corner, with the columns ``polygon``, ``ring`` (0 is the
    /// outline, the others are holes), ``friction_angle_deg`` and ``density_kg_m3``.
    ///
    /// Raises:
    ///     ImportError: If pandas is not installed.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        boundary_table(py, &self.found.region)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// Itself: nothing of it can be changed.
    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    /// What it was made from; it is made again from that, to the last bit.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, ())> {
        let (py, known) = (slf.py(), &slf.get().known);
        let dict = PyDict::new(py);
        let columns =
            ["tool_angle_deg", "surface_slope_deg", "depth_m", "width_m", "force_n", "force_error_n"];
        for (column, name) in columns.into_iter().enumerate() {
            dict.set_item(name, known.given.iter().map(|row| row[column]).collect::<Vec<_>>())?;
        }
        dict.set_item("interface_friction_deg", known.delta_deg)?;
        dict.set_item("density_kg_m3", known.density_kg_m3)?;
        dict.set_item("friction_search_deg", known.phi_search_deg)?;
        dict.set_item("model", known.model.id())?;
        dict.set_item("cohesion_pa", known.loads.cohesion_pa)?;
        dict.set_item("adhesion_pa", known.loads.adhesion_pa)?;
        dict.set_item("surcharge_pa", known.loads.surcharge_pa)?;
        dict.set_item("gravity_m_s2", known.gravity_m_s2)?;
        let ends = match known.ends {
            Ends::Finite => "finite",
            Ends::None => "none",
        };
        dict.set_item("ends", ends)?;
        dict.set_item("end_tolerance", known.end_tolerance)?;
        let again =
            py.import("functools")?.getattr("partial")?.call((maker(py, "estimate")?,), Some(&dict))?;
        Ok((again, ()))
    }

    fn __repr__(&self) -> String {
        match (self.found.phi_deg, self.found.density_kg_m3) {
            (Some([a, b]), Some([c, d])) => {
                format!("Estimate(friction_angle_deg=({a:.3}, {b:.3}), density_kg_m3=({c:.1}, {d:.1}))")
            }
            _ => "Estimate(no soil is consistent)".to_owned(),
        }
    }

    fn _repr_html_(&self) -> String {
        html(&self.found.region)
    }

    /// The region; x is the friction angle, y the density.
    fn _repr_svg_(&self) -> Option<String> {
        svg(&self.found.region)
    }
}

/// Every soil that could have produced measured failure forces.
///
/// Measurements are arrays of shape (n,), or numbers that hold for all of them.
///
/// Args:
///     tool_angle_deg: Plate from the horizontal.
///     depth_m: Vertical depth of the plate's lower edge.
///     width_m: Width of the plate.
///     force_n: Measured failure force.
///     force_error_n: Half width of its interval.
///     interface_friction_deg: Friction between soil and plate, known to lie between these two. Any sequence of two numbers,
///         here and below.
///     surface_slope_deg: Slope of the ground.
///     density_kg_m3: Bulk density, known to lie between these two; None if nothing is known.
///     friction_search_deg: Friction angles to search between; None for 5 to 60, as far as the model reaches.
///     model: Force model, one of ``soilctl.MODELS``.
///     cohesion_pa, adhesion_pa, surcharge_pa, gravity_m_s2: Known.
///     ends: ``finite`` for plates with ends, each of its own width, ``none`` for plane strain. By default plates have ends if the
///         model knows them.
///     end_tolerance: By how much the end factor of a measurement may differ from one that all share, 0 to 1; 1 if they share
///         nothing.
///
/// Raises:
///     InputError: If there is no measurement, a number is out of its range, or the model does not cover it.
#[pyfunction]
#[pyo3(signature = (
    *, tool_angle_deg, depth_m, width_m, force_n, force_error_n, interface_friction_deg, surface_slope_deg = None,
    density_kg_m3 = None, friction_search_deg = None, model = "table", cohesion_pa = 0.0, adhesion_pa = 0.0, surcharge_pa = 0.0,
    gravity_m_s2 = 9.80665, ends = None, end_tolerance = 0.1,
))]
#[allow(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn estimate<'py>(
    py: Python<'py>,
    tool_angle_deg: &Bound<'py, PyAny>,
    depth_m: &Bound<'py, PyAny>,
    width_m: &Bound<'py, PyAny>,
    force_n: &Bound<'py, PyAny>,
    force_error_n: &Bound<'py, PyAny>,
    interface_friction_deg: &Bound<'py, PyAny>,
    surface_slope_deg: Option<&Bound<'py, PyAny>>,
    density_kg_m3: Option<&Bound<'py, PyAny>>,
    friction_search_deg: Option<&Bound<'py, PyAny>>,
    model: &str,
    cohesion_pa: f64,
    adhesion_pa: f64,
    surcharge_pa: f64,
    gravity_m_s2: f64,
    ends: Option<&str>,
    end_tolerance: f64,
) -> Answer<Estimate> {
    let (model, ends) = asked(model, ends, true)?;
    let alpha = Array::new("tool_angle_deg", tool_angle_deg)?;
    let depth = Array::new("depth_m", depth_m)?;
    let width = Array::new("width_m", width_m)?;
    let force = Array::new("force_n", force_n)?;
    let error = Array::new("force_error_n", force_error_n)?;
    let beta = Array::or(py, "surface_slope_deg", surface_slope_deg, 0.0)?;
    let shape = common_shape(&[&alpha, &depth, &width, &force, &error, &beta])?;
    if shape.len() > 1 {
        return Err(input(format!(
            "measurements have shape {shape:?}; they must be numbers or have one axis"
        )));
    }
    let column = |array| Column::new(array, &shape);
    let (alpha, depth, width) = (column(&alpha)?, column(&depth)?, column(&width)?);
    let (force, error, beta) = (column(&force)?, column(&error)?, column(&beta)?);
    let columns = [alpha, beta, depth, width, force, error];
    let given: Vec<[f64; 6]> =
        (0..shape.iter().product()).map(|i| columns.each_ref().map(|column| column.at(i))).collect();
    let observations = given.iter().enumerate().map(|(i, row)| -> Answer<Observation> {
        let [alpha, beta, depth_m, width_m, force_n, error_n] = *row;
        let plate = Plate::new(Angle::from_degrees(alpha), Angle::from_degrees(beta), depth_m, width_m)?;
        Ok(Observation::new(i.to_string(), plate, force_n, error_n)?)
    });
    let observations = observations.collect::<Answer<Vec<_>>>()?;
    let known = Known {
        given,
        model,
        ends,
        end_tolerance,
        observations,
        delta_deg: interval("interface_friction_deg", interface_friction_deg)?,
        density_kg_m3: interval_or_none("density_kg_m3", density_kg_m3)?,
        phi_search_deg: interval_or_none("friction_search_deg", friction_search_deg)?,
        gravity_m_s2,
        loads: Loads { cohesion_pa, adhesion_pa, surcharge_pa },
    };
    let (found, conflict, fit) = known.compute(py, |setup| {
        let found = find(setup)?;
        let conflict = if found.is_consistent() { Conflict::default() } else { conflict(setup)? };
        let fit = best_fit(setup, &found)?;
        Ok((found, conflict, fit))
    })?;
    Ok(Estimate { known, found, conflict, fit })
}

fn finite(name: &str, value: f64) -> Answer<()> {
    match value.is_finite() {
        true => Ok(()),
        false => {
            Err(input(format!("{name} is {}; it must be a finite number", value.to_string().to_lowercase())))
        }
    }
}

impl From<EstimatorError> for Fail {
    fn from(problem: EstimatorError) -> Self {
        match problem {
            EstimatorError::TooLittle { .. }
            | EstimatorError::Model { source: EarthPressureError::Singular { .. }, .. } => no_answer(problem),
            _ => input(problem),
        }
    }
}
