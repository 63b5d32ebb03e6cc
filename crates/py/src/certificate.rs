//! Saved solutions: their proofs, and what their fields show.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use soilctl_certificate::{CertificateError, Checked, Solution as Saved, check};
use soilctl_limit_analysis::results::{FlowResults, MOVING, StressResults, Units, write_vtu};

use crate::array::{Array, shaped};
use crate::copies::{hash_of, maker};
use crate::error::{Answer, Fail, file_at, input, kinds, no_answer};
use crate::work::each;

/// A lower and an upper bound with the fields that prove them.
///
/// Lengths are in units of ``length_m``, stresses of ``stress_pa``, velocities of the structure's.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Solution {
    saved: Arc<Saved>,
    /// Where the origin of the statement is in the coordinates of its problem, in m; a file does not say.
    origin_m: [f64; 2],
}

impl Solution {
    pub(crate) const fn of(saved: Arc<Saved>, origin_m: [f64; 2]) -> Self {
        Self { saved, origin_m }
    }

    pub(crate) fn saved(&self) -> Arc<Saved> {
        Arc::clone(&self.saved)
    }

    pub(crate) const fn origin(&self) -> [f64; 2] {
        self.origin_m
    }

    fn flow(&self) -> Answer<FlowResults> {
        match &self.saved.upper {
            Some(claim) => Ok(FlowResults::new(&self.saved.statement, &claim.field)?),
            None => Err(no_answer("the solution has no upper bound, so it shows no flow")),
        }
    }

    fn claims(&self) -> [Option<f64>; 2] {
        let upper = self.saved.upper.as_ref().map(|c| c.claimed);
        let upper = upper.or(self.saved.mechanism.as_ref().map(|c| c.claimed));
        [self.saved.lower.as_ref().map(|c| c.claimed), upper]
    }

    fn stress_field(&self) -> Answer<StressResults> {
        match &self.saved.lower {
            Some(claim) => Ok(StressResults::new(&self.saved.statement, &claim.field)?),
            None => Err(no_answer("the solution has no lower bound, so it shows no stresses")),
        }
    }
}

#[pymethods]
impl Solution {
    /// A solution from a file that ``write`` or ``soilctl bound --save`` has written.
    ///
    /// Raises:
    ///     FileError: If the file cannot be read.
    ///     InputError: If it is no solution.
    #[staticmethod]
    fn read(path: PathBuf) -> Answer<Self> {
        Ok(Self::of(Arc::new(Saved::read(&path)?), [0.0; 2]))
    }

    /// Writes a file for ``read`` and ``soilctl certify``.
    ///
    /// Raises:
    ///     FileError: If it cannot be written.
    fn write(&self, path: PathBuf) -> Answer<()> {
        Ok(self.saved.write(&path)?)
    }

    /// Proves both bounds anew, with interval arithmetic and without the solver.
    ///
    /// Raises:
    ///     ProofError: If the checker proves bounds that exclude each other, which is a fault of its own.
    fn certify(&self, py: Python<'_>) -> Answer<Certificate> {
        Ok(py.detach(|| Certificate::of(&self.saved))?)
    }

    /// What the problem is, in words; None if the file does not say.
    #[getter]
    fn description(&self) -> Option<&str> {
        self.saved.scale.description.as_deref()
    }

    /// One unit of length in m; None if the file does not say.
    #[getter]
    fn length_m(&self) -> Option<f64> {
        self.saved.scale.length_m
    }

    /// Width of the structure in units of length; None in plane strain. A structure with ends has no flow in the plane: its upper
    /// bound is proven by blocks in space.
    #[getter]
    fn width(&self) -> Option<f64> {
        self.saved.statement.width
    }

    /// Where the fields' origin is in the coordinates of the problem, in m: a point of the fields is at
    /// ``origin_m + length_m * point`` there. (0, 0) for plates, whose origin is the plate's top, and for solutions that were read.
    #[getter]
    const fn origin_m(&self) -> (f64, f64) {
        (self.origin_m[0], self.origin_m[1])
    }

    /// One unit of stress in Pa; None if the file does not say.
    #[getter]
    fn stress_pa(&self) -> Option<f64> {
        Some(self.saved.scale.length_m? * self.saved.scale.unit_weight_n_per_m3?)
    }

    /// Corners of the triangles of a bound's mesh, counter-clockwise, shape (n, 3, 2).
    ///
    /// Args:
    ///     bound: ``"upper"`` or ``"lower"``: each has a mesh of its own.
    ///
    /// Raises:
    ///     NoAnswerError: If the solution has no such bound.
    #[pyo3(signature = (bound = "upper"))]
    fn triangles<'py>(&self, py: Python<'py>, bound: &str) -> Answer<Bound<'py, PyAny>> {
        let triangles = match bound {
            "upper" => self.flow()?.triangles().to_vec(),
            "lower" => self.stress_field()?.triangles().to_vec(),
            _ => return Err(input(format!("bound is {bound:?}; it must be \"upper\" or \"lower\""))),
        };
        shaped(py, triangles.iter().flatten().flatten().copied().collect(), &[triangles.len(), 3, 2])
    }

    /// Velocities of the upper bound at points of shape (..., 2), in units of the structure's, same shape.
    ///
    /// Raises:
    ///     NoAnswerError: If a point is outside the soil, or there is no upper bound.
    fn velocity<'py>(&self, py: Python<'py>, points: &Bound<'py, PyAny>) -> Answer<Bound<'py, PyAny>> {
        let (points, mut shape) = Array::new("points", points)?.rows::<2>("x, y")?;
        let flow = self.flow()?;
        let all = each(py, &shape, |i| flow.velocity(points[i]).ok_or(Outside(points[i])))?;
        shape.push(2);
        shaped(py, all.concat(), &shape)
    }

    /// Total stresses ``xx, yy, xy`` of the lower bound at points of shape (..., 2), tension positive, shape (..., 3).
    ///
    /// Raises:
    ///     NoAnswerError: If a point is outside the soil, or there is no lower bound.
    fn stress<'py>(&self, py: Python<'py>, points: &Bound<'py, PyAny>) -> Answer<Bound<'py, PyAny>> {
        let (points, mut shape) = Array::new("points", points)?.rows::<2>("x, y")?;
        let stress = self.stress_field()?;
        let all = each(py, &shape, |i| stress.stress(points[i]).ok_or(Outside(points[i])))?;
        shape.push(3);
        shaped(py, all.concat(), &shape)
    }

    /// Greatest shear strain rate of each triangle of the upper bound (velocity over length), shape (n,).
    ///
    /// Raises:
    ///     NoAnswerError: If there is no upper bound.
    fn shear_rate<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        let rates = self.flow()?.shear_rate();
        let mean = rates.iter().map(|pieces| pieces.iter().sum::<f64>() / pieces.len().max(1) as f64);
        shaped(py, mean.collect(), &[rates.len()])
    }

    /// The boundary of the soil that moves: a list of lines, each of shape (n, 2).
    ///
    /// Raises:
    ///     NoAnswerError: If there is no upper bound.
    fn failure_surface<'py>(&self, py: Python<'py>) -> Answer<Vec<Bound<'py, PyAny>>> {
        let lines = self.flow()?.failure_surface(MOVING);
        lines.into_iter().map(|line| shaped(py, line.concat(), &[line.len(), 2])).collect()
    }

    /// Stresses between structure and soil, of the lower bound: one dict a face, with the arrays ``arc``, ``points``,
    /// ``pressure`` and ``shear``, two entries an edge of the mesh.
    ///
    /// Raises:
    ///     NoAnswerError: If there is no lower bound.
    fn contacts<'py>(&self, py: Python<'py>) -> Answer<Vec<Bound<'py, PyDict>>> {
        let contacts = self.stress_field()?.contacts();
        let faces = contacts.iter().map(|contact| -> Answer<_> {
            let count = contact.points.len();
            let dict = PyDict::new(py);
            let column = |of: fn(&soilctl_limit_analysis::results::ContactPoint) -> f64| {
                shaped(py, contact.points.iter().map(of).collect(), &[count])
            };
            dict.set_item("arc", column(|p| p.arc)?)?;
            dict.set_item("pressure", column(|p| p.pressure)?)?;
            dict.set_item("shear", column(|p| p.shear)?)?;
            let at = contact.points.iter().flat_map(|p| p.at).collect();
            dict.set_item("points", shaped(py, at, &[count, 2])?)?;
            Ok(dict)
        });
        faces.collect()
    }

    /// The solution in ParaView's format, in the coordinates of the problem: velocities, stresses, dissipation, soil.
    ///
    /// Raises:
    ///     NoAnswerError: If there is neither an upper nor a lower bound.
    fn vtu(&self) -> Answer<String> {
        let flow = self.saved.upper.is_some().then(|| self.flow()).transpose()?;
        let stress = self.saved.lower.is_some().then(|| self.stress_field()).transpose()?;
        let (length, pressure) = (self.saved.scale.length_m, self.stress_pa());
        let units = Units {
            origin: self.origin_m,
            length: length.unwrap_or(1.0),
            length_name: length.map_or("L", |_| "m").to_owned(),
            stress: pressure.map_or(1.0, |p| 1e-3 * p),
            stress_name: pressure.map_or("γL", |_| "kPa").to_owned(),
        };
        Ok(write_vtu(flow.as_ref(), stress.as_ref(), &units)?)
    }

    /// Equal are solutions with the same problem, fields, claims and origin.
    fn __eq__(&self, other: &Self) -> bool {
        self.origin_m == other.origin_m && self.saved == other.saved
    }

    fn __hash__(&self) -> u64 {
        hash_of(&self.claims())
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// Itself: nothing of it can be changed.
    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    /// By way of a file: solutions are read and written as nothing else.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("soilctl._copies")?.call_method1("reduced", (slf,))
    }

    fn __repr__(&self) -> String {
        let [lower, upper] = self.claims().map(or_none);
        format!("Solution(lower={lower}, upper={upper})")
    }

    /// The mesh of the upper bound; the faster the soil moves, the darker. Without one, that of the lower bound; None without
    /// either.
    fn _repr_svg_(&self) -> Answer<Option<String>> {
        let flow = self.saved.upper.is_some().then(|| self.flow()).transpose()?;
        let stress = self.saved.lower.is_some().then(|| self.stress_field()).transpose()?;
        let triangles = match (&flow, &stress) {
            (Some(flow), _) => flow.triangles(),
            (None, Some(stress)) => stress.triangles(),
            (None, None) => return Ok(None),
        };
        let corners = || triangles.iter().flatten();
        let end =
            |axis: usize, start: f64, pick: fn(f64, f64) -> f64| corners().map(|p| p[axis]).fold(start, pick);
        let (left, right) = (end(0, f64::INFINITY, f64::min), end(0, f64::NEG_INFINITY, f64::max));
        let (low, high) = (end(1, f64::INFINITY, f64::min), end(1, f64::NEG_INFINITY, f64::max));
        let scale = 640.0 / (right - left).max(f64::MIN_POSITIVE);
        let speed = |at: [f64; 2]| -> Option<f64> {
            let flow = flow.as_ref()?;
            let [x, y] = flow.velocity(at)?;
            Some(x.hypot(y) / flow.speed().max(f64::MIN_POSITIVE))
        };
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 {:.1}\" width=\"640\" stroke=\"#555\" \
             stroke-width=\"0.3\">",
            scale * (high - low)
        );
        for triangle in triangles {
            let middle = [0, 1].map(|axis| triangle.iter().map(|p| p[axis]).sum::<f64>() / 3.0);
            let moves = speed(middle).unwrap_or(0.0).clamp(0.0, 1.0);
            let [red, green] = [255.0 - 185.0 * moves, 255.0 - 125.0 * moves];
            let points =
                triangle.map(|[x, y]| format!("{:.1},{:.1}", scale * (x - left), scale * (high - y)));
            // Writing into a string cannot fail.
            let _ = write!(svg, "<path d=\"M{}Z\" fill=\"rgb({red:.0},{green:.0},255)\"/>", points.join("L"));
        }
        Ok(Some(svg + "</svg>"))
    }
}

/// A saved solution with the origin that its file does not say.
#[pyfunction]
#[pyo3(name = "_restore_solution")]
pub(crate) fn restore_solution(path: PathBuf, origin_m: [f64; 2]) -> Answer<Solution> {
    Ok(Solution::of(Arc::new(Saved::read(&path)?), origin_m))
}

/// A number as Python shows it.
pub(crate) fn or_none(value: Option<f64>) -> String {
    value.map_or_else(|| "None".to_owned(), |value| value.to_string())
}

/// A point without soil.
struct Outside([f64; 2]);

impl std::fmt::Display for Outside {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the point {:?} is outside the soil", self.0)
    }
}

impl From<Outside> for Fail {
    fn from(problem: Outside) -> Self {
        no_answer(problem)
    }
}

/// What a solution proves, whatever it claims.
#[derive(PartialEq)]
#[pyclass(module = "soilctl", frozen, get_all)]
pub(crate) struct Certificate {
    /// Whether every claim is proven.
    certified: bool,
    /// Claimed lower bound, in the units of the solution; None if there is none.
    lower_claimed: Option<f64>,
    /// Proven lower bound; None if the field proves nothing.
    lower_proven: Option<f64>,
    /// Why the field proves no lower bound.
    lower_refusal: Option<String>,
    /// Claimed upper bound; None if there is none.
    upper_claimed: Option<f64>,
    /// Proven upper bound; None if the field proves nothing.
    upper_proven: Option<f64>,
    /// Why the field proves no upper bound.
    upper_refusal: Option<String>,
}

impl Certificate {
    fn of(saved: &Saved) -> Result<Self, CertificateError> {
        let (lower, upper) = check(saved)?;
        let split = |checked: Option<Checked>| match checked {
            Some(Checked { claimed, proven: Ok(proven) }) => (Some(claimed), Some(proven), None),
            Some(Checked { claimed, proven: Err(why) }) => (Some(claimed), None, Some(why.to_string())),
            None => (None, None, None),
        };
        let (lower_claimed, lower_proven, lower_refusal) = split(lower);
        let (upper_claimed, upper_proven, upper_refusal) = split(upper);
        let lower = lower_claimed.is_none_or(|claimed| lower_proven.is_some_and(|proven| claimed <= proven));
        let upper = upper_claimed.is_none_or(|claimed| upper_proven.is_some_and(|proven| claimed >= proven));
        let any = lower_claimed.is_some() || upper_claimed.is_some();
        Ok(Self {
            certified: any && lower && upper,
            lower_claimed,
            lower_proven,
            lower_refusal,
            upper_claimed,
            upper_proven,
            upper_refusal,
        })
    }
}

#[pymethods]
impl Certificate {
    fn __bool__(&self) -> bool {
        self.certified
    }

    fn __eq__(&self, other: &Self) -> bool {
        self == other
    }

    fn __hash__(&self) -> u64 {
        hash_of(&[self.lower_claimed, self.lower_proven, self.upper_claimed, self.upper_proven])
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, own) = (slf.py(), slf.get());
        let lower = (own.lower_claimed, own.lower_proven, &own.lower_refusal);
        let upper = (own.upper_claimed, own.upper_proven, &own.upper_refusal);
        Ok((maker(py, "_restore_certificate")?, (own.certified, lower, upper).into_pyobject(py)?))
    }

    fn __repr__(&self) -> String {
        let certified = if self.certified { "True" } else { "False" };
        let [lower, upper] = [self.lower_proven, self.upper_proven].map(or_none);
        format!("Certificate(certified={certified}, lower_proven={lower}, upper_proven={upper})")
    }

    fn _repr_html_(&self) -> String {
        let row = |name: &str, claimed: Option<f64>, proven: Option<f64>, why: &Option<String>| {
            let proven =
                why.clone().unwrap_or_else(|| or_none(proven)).replace('&', "&amp;").replace('<', "&lt;");
            format!("<tr><th>{name}</th><td>{}</td><td>{proven}</td></tr>", or_none(claimed))
        };
        let verdict = if self.certified { "certified" } else { "not certified" };
        format!(
            "<table><caption>{verdict}</caption><tr><th></th><th>claimed</th><th>proven</th></tr>{}{}</table>",
            row("lower", self.lower_claimed, self.lower_proven, &self.lower_refusal),
            row("upper", self.upper_claimed, self.upper_proven, &self.upper_refusal),
        )
    }
}

/// A certificate as `__reduce__` has taken it apart: what is claimed of each bound, what is proven, and why it is not.
#[pyfunction]
#[pyo3(name = "_restore_certificate")]
pub(crate) fn restore_certificate(
    certified: bool,
    lower: (Option<f64>, Option<f64>, Option<String>),
    upper: (Option<f64>, Option<f64>, Option<String>),
) -> Certificate {
    let (lower_claimed, lower_proven, lower_refusal) = lower;
    let (upper_claimed, upper_proven, upper_refusal) = upper;
    Certificate {
        certified,
        lower_claimed,
        lower_proven,
        lower_refusal,
        upper_claimed,
        upper_proven,
        upper_refusal,
    }
}

impl From<CertificateError> for Fail {
    fn from(problem: CertificateError) -> Self {
        match problem {
            CertificateError::File { ref path, .. } => file_at(&problem, path),
            CertificateError::Format { .. } | CertificateError::Schema { .. } => input(problem),
            _ => Self(kinds::ProofError::new_err(problem.to_string())),
        }
    }
}
