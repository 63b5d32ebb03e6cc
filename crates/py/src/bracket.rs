//! What a bounding run found, and what it tells on its way.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use soilctl_certificate::Solution as Saved;

use crate::certificate::Solution;
use crate::error::{Answer, no_answer};

/// Proven bounds: the true value for rigid-plastic soil with associated flow lies between them.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Bracket {
    /// The lower bound, in ``unit``.
    #[pyo3(get)]
    pub(crate) lower: f64,
    /// The upper bound, in ``unit``.
    #[pyo3(get)]
    pub(crate) upper: f64,
    /// What is bounded.
    #[pyo3(get)]
    pub(crate) quantity: &'static str,
    /// Its unit; empty for pure numbers.
    #[pyo3(get)]
    pub(crate) unit: &'static str,
    /// Why the run ended: gap, time, elements, memory or stopped.
    #[pyo3(get)]
    pub(crate) ended: &'static str,
    /// Time spent in s.
    #[pyo3(get)]
    pub(crate) seconds: f64,
    /// Bounds on the force in N; None without depth, width and density.
    #[pyo3(get)]
    pub(crate) force_n: Option<(f64, f64)>,
    /// Triangles of the meshes of lower and upper bound.
    #[pyo3(get)]
    pub(crate) elements: (usize, usize),
    /// What proves the bounds: one solution, or several by name for a factor of safety.
    pub(crate) proofs: Proofs,
    /// Where the origin of the solutions is in the coordinates of the problem, in m.
    pub(crate) origin_m: [f64; 2],
}

/// Saved solutions that prove a bracket.
pub(crate) enum Proofs {
    /// Both bounds are of one problem.
    Both(Arc<Saved>),
    /// Bounds are of soils of different strength.
    Several(Vec<(&'static str, Arc<Saved>)>),
}

#[pymethods]
impl Bracket {
    /// ``|(U - L) / ((U + L) / 2)|``; None if the bounds are on both sides of zero.
    #[getter]
    fn gap(&self) -> Option<f64> {
        let (low, high) = (self.lower, self.upper);
        (low * high > 0.0).then(|| (2.0 * (high - low) / (high + low)).abs())
    }

    /// The fields that prove the bounds: to look at, to save, and to prove anew.
    ///
    /// Raises:
    ///     NoAnswerError: For a factor of safety, whose bounds are of soils of different strength: see ``solutions``.
    #[getter]
    fn solution(&self) -> Answer<Solution> {
        match &self.proofs {
            Proofs::Both(saved) => Ok(Solution::of(Arc::clone(saved), self.origin_m)),
            Proofs::Several(_) => Err(no_answer(
                "the bounds of a factor of safety are of soils of different strength; take one of .solutions",
            )),
        }
    }

    /// All solutions by name: ``both``, or ``lower`` and ``upper`` for a factor of safety.
    #[getter]
    fn solutions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        match &self.proofs {
            Proofs::Both(saved) => dict.set_item("both", Solution::of(Arc::clone(saved), self.origin_m))?,
            Proofs::Several(proofs) => {
                for (name, saved) in proofs {
                    dict.set_item(name, Solution::of(Arc::clone(saved), self.origin_m))?;
                }
            }
        }
        Ok(dict)
    }

    /// Whether a value lies inside, ends included.
    fn __contains__(&self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// The numbers as a dict.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("quantity", self.quantity)?;
        dict.set_item("unit", self.unit)?;
        dict.set_item("lower", self.lower)?;
        dict.set_item("upper", self.upper)?;
        dict.set_item("gap", self.gap())?;
        dict.set_item("ended", self.ended)?;
        if let Some(force_n) = self.force_n {
            dict.set_item("force_n", force_n)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let Self { quantity, lower, upper, .. } = self;
        format!("Bracket({quantity:?}, {lower} to {upper}{}{})", self.behind(), self.percent())
    }

    fn _repr_html_(&self) -> String {
        let row = |name: &str, value: String| format!("<tr><th>{name}</th><td>{value}</td></tr>");
        let mut rows = row("lower", format!("{:.6}{}", self.lower, self.behind()));
        rows += &row("upper", format!("{:.6}{}", self.upper, self.behind()));
        if let Some(gap) = self.gap() {
            rows += &row("gap", format!("{:.2} %", 100.0 * gap));
        }
        if let Some((low, high)) = self.force_n {
            rows += &row("force", format!("{low:.4} to {high:.4} N"));
        }
        format!("<table><caption>{}, proven</caption>{rows}</table>", self.quantity)
    }
}

impl Bracket {
    /// The unit as it stands behind a number.
    fn behind(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) }
    }

    fn percent(&self) -> String {
        self.gap().map_or_else(String::new, |gap| format!(", gap {:.2} %", 100.0 * gap))
    }
}

/// One level of meshes, as ``progress`` is told about it.
#[pyclass(module = "soilctl", frozen, get_all)]
pub(crate) struct Progress {
    /// Triangles of the level's mesh.
    pub(crate) elements: usize,
    /// Gap of the best bounds so far; None before the first pair.
    pub(crate) gap: Option<f64>,
    /// What strength was divided by, in the search of a factor of safety; else None.
    pub(crate) factor: Option<f64>,
}
