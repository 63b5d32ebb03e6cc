//! What `pickle` and `copy` make of results: a function of the compiled part, and what it takes.

use std::hash::{DefaultHasher, Hash, Hasher};

use pyo3::prelude::*;

/// A function that makes something again, as `__reduce__` names it.
pub(crate) fn maker<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("soilctl._native")?.getattr(name)
}

/// The same for equal numbers, 0 and -0 among them.
pub(crate) fn hash_of(numbers: &[Option<f64>]) -> u64 {
    let mut state = DefaultHasher::new();
    for number in numbers {
        number.map(|number| (number + 0.0).to_bits()).hash(&mut state);
    }
    state.finish()
}
