//! From the crates' errors to the exceptions of `soilctl.errors`, with the same messages as on the command line.

use std::fmt::Display;
use std::path::Path;

use pyo3::PyErr;
use soilctl_soil::SoilError;

/// The exceptions themselves are written in Python, since some have two bases.
pub(crate) mod kinds {
    pyo3::import_exception!(soilctl.errors, InputError);
    pyo3::import_exception!(soilctl.errors, InputTypeError);
    pyo3::import_exception!(soilctl.errors, FileError);
    pyo3::import_exception!(soilctl.errors, NoAnswerError);
    pyo3::import_exception!(soilctl.errors, ProofError);
    pyo3::import_exception!(soilctl.errors, SimulationError);
    pyo3::import_exception!(soilctl.errors, Interrupted);
}

/// An exception about to be raised; the conversions below choose its kind.
pub(crate) struct Fail(pub(crate) PyErr);

pub(crate) type Answer<T> = Result<T, Fail>;

/// A value that makes no sense.
pub(crate) fn input(message: impl Display) -> Fail {
    Fail(kinds::InputError::new_err(message.to_string()))
}

/// Sound input that has no answer.
pub(crate) fn no_answer(message: impl Display) -> Fail {
    Fail(kinds::NoAnswerError::new_err(message.to_string()))
}

/// A file that cannot be read or written.
pub(crate) fn file(message: impl Display) -> Fail {
    Fail(kinds::FileError::new_err(message.to_string()))
}

/// The same, of which it is known which file it is.
pub(crate) fn file_at(message: impl Display, path: impl AsRef<Path>) -> Fail {
    Fail(kinds::FileError::new_err((message.to_string(), path.as_ref().to_owned())))
}

impl From<PyErr> for Fail {
    fn from(raised: PyErr) -> Self {
        Self(raised)
    }
}

impl From<Fail> for PyErr {
    fn from(fail: Fail) -> Self {
        fail.0
    }
}

impl From<SoilError> for Fail {
    fn from(problem: SoilError) -> Self {
        input(problem)
    }
}
