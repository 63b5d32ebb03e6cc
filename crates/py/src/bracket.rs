//! What a bounding run found, and what it tells on its way.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use soilctl_certificate::Solution as Saved;
use soilctl_limit_analysis::Ended;

use crate::certificate::{Solution, or_none};
use crate::copies::{hash_of, maker};
use crate::error::{Answer, input, no_answer};

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
    pub(crate) quantity: String,
    /// Its unit; empty for pure numbers.
    #[pyo3(get)]
    pub(crate) unit: String,
    pub(crate) ended: Ended,
    /// Work spent: elements of meshes times steps of the solver on them.
    #[pyo3(get)]
    pub(crate) work: u64,
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
#[derive(PartialEq)]
pub(crate) enum Proofs {
    /// Both bounds are of one problem.
    Both(Arc<Saved>),
    /// Bounds are of soils of different strength.
    Several(Vec<(String, Arc<Saved>)>),
}

#[pymethods]
impl Bracket {
    /// ``|(U - L) / ((U + L) / 2)|``; None if the bounds are on both sides of zero.
    #[getter]
    fn gap(&self) -> Option<f64> {
        let (low, high) = (self.lower, self.upper);
        (low * high > 0.0).then(|| (2.0 * (high - low) / (high + low)).abs())
    }

    /// Why the run ended: gap, elements, work, memory, time or stopped.
    #[getter]
    fn ended(&self) -> &'static str {
        self.ended.name()
    }

    /// What kind of limit that is: goal, work, memory, seconds or user. Only after the last two the same call may end
    /// elsewhere another time.
    #[getter]
    fn stopped_by(&self) -> &'static str {
        self.ended.stopped_by().name()
    }

    /// What factorised the solver's systems behind the lower and the upper bound.
    #[getter]
    fn factorisation(&self) -> (Option<String>, Option<String>) {
        let saved: Vec<&Saved> = match &self.proofs {
            Proofs::Both(saved) => vec![saved],
            Proofs::Several(proofs) => proofs.iter().map(|(_, saved)| &**saved).collect(),
        };
        let lower = saved.iter().find_map(|s| s.lower.as_ref()?.computed.clone());
        let upper = saved.iter().find_map(|s| s.upper.as_ref()?.computed.clone());
        (lower.map(|c| c.factorisation), upper.map(|c| c.factorisation))
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
        dict.set_item("quantity", &self.quantity)?;
        dict.set_item("unit", &self.unit)?;
        dict.set_item("lower", self.lower)?;
        dict.set_item("upper", self.upper)?;
        dict.set_item("gap", self.gap())?;
        dict.set_item("ended", self.ended())?;
        dict.set_item("stopped_by", self.stopped_by())?;
        dict.set_item("work", self.work)?;
        if let Some(force_n) = self.force_n {
            dict.set_item("force_n", force_n)?;
        }
        Ok(dict)
    }

    /// Equal are brackets with the same numbers and proofs, however long they took.
    fn __eq__(&self, other: &Self) -> bool {
        let ends = |of: &Self| (of.lower, of.upper, of.force_n, of.origin_m);
        ends(self) == ends(other)
            && (&self.quantity, &self.unit, self.ended) == (&other.quantity, &other.unit, other.ended)
            && self.elements == other.elements
            && self.proofs == other.proofs
    }

    fn __hash__(&self) -> u64 {
        hash_of(&[Some(self.lower), Some(self.upper)])
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// Itself: nothing of it can be changed.
    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, own) = (slf.py(), slf.get());
        let summary = (own.lower, own.upper, &own.quantity, &own.unit, own.ended(), own.seconds, own.work);
        let solutions: Vec<_> = own.solutions(py)?.items().iter().collect();
        let args = (summary, own.force_n, own.elements, solutions).into_pyobject(py)?;
        Ok((maker(py, "_restore_bracket")?, args))
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

/// A bracket as `__reduce__` has taken it apart: lower, upper, quantity, unit, why it ended, seconds, work; and what else there is.
#[pyfunction]
#[pyo3(name = "_restore_bracket")]
pub(crate) fn restore_bracket(
    summary: (f64, f64, String, String, String, f64, u64),
    force_n: Option<(f64, f64)>,
    elements: (usize, usize),
    solutions: Vec<(String, Py<Solution>)>,
) -> Answer<Bracket> {
    let (lower, upper, quantity, unit, ended, seconds, work) = summary;
    let ended = Ended::ALL
        .into_iter()
        .find(|one| one.name() == ended)
        .ok_or_else(|| input(format!("a bracket cannot have ended by {ended:?}")))?;
    let Some(first) = solutions.first() else {
        return Err(input("a bracket needs a solution that proves it"));
    };
    let origin_m = first.1.get().origin();
    let proofs = match solutions.as_slice() {
        [(name, only)] if name == "both" => Proofs::Both(only.get().saved()),
        several => {
            Proofs::Several(several.iter().map(|(name, one)| (name.clone(), one.get().saved())).collect())
        }
    };
    Ok(Bracket { lower, upper, quantity, unit, ended, work, seconds, force_n, elements, proofs, origin_m })
}

/// One level of meshes, as ``progress`` gets it.
#[pyclass(module = "soilctl", frozen, get_all)]
pub(crate) struct Progress {
    /// Triangles of the level's mesh.
    pub(crate) elements: usize,
    /// Gap of the best bounds so far; None before the first pair.
    pub(crate) gap: Option<f64>,
    /// What strength was divided by, in the search of a factor of safety; else None.
    pub(crate) factor: Option<f64>,
}

#[pymethods]
impl Progress {
    fn __repr__(&self) -> String {
        let Self { elements, .. } = self;
        let [gap, factor] = [self.gap, self.factor].map(or_none);
        format!("Progress(elements={elements}, gap={gap}, factor={factor})")
    }
}
