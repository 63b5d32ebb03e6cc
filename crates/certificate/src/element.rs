//! The piecewise cubic element of both kinds of proof.

pub(crate) use crate::lower::element::Local;
