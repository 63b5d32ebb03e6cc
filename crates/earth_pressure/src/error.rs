use soilctl_soil::{Rounded, SoilError};
use thiserror::Error;

/// What can go wrong in a force model or a prediction table. Numbers are rounded in messages only ([`Rounded`]).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum EarthPressureError {
    /// An input is outside the range in which the model holds.
    #[error(
        "model {model} covers {quantity} from {} to {} deg, but {quantity} is {} deg; {advice}",
        Rounded(*.low), Rounded(*.high), Rounded(*.value)
    )]
    OutsideModel {
        /// Model id.
        model: &'static str,
        /// Name of the input.
        quantity: &'static str,
        /// Value given in degrees.
        value: f64,
        /// Least value covered.
        low: f64,
        /// Greatest value covered.
        high: f64,
        /// What the user can do.
        advice: &'static str,
    },
    /// The inputs are in range one by one, but the model has no finite answer for them together.
    #[error(
        "model {model} has no finite answer at alpha {} deg, phi {} deg, delta {} deg: {reason}",
        Rounded(*.alpha_deg), Rounded(*.phi_deg), Rounded(*.delta_deg)
    )]
    Singular {
        /// Model id.
        model: &'static str,
        /// Tool angle in degrees.
        alpha_deg: f64,
        /// Friction angle in degrees.
        phi_deg: f64,
        /// Interface friction in degrees.
        delta_deg: f64,
        /// Why, in physical words.
        reason: &'static str,
    },
    /// The model knows soil weight only.
    #[error("model {model} has no term for {term}; use coulomb, chen or (with a level surface) log-spiral")]
    NoLoadTerm {
        /// Model id.
        model: &'static str,
        /// Cohesion, adhesion or surcharge.
        term: &'static str,
    },
    /// A model of plates with ends, where plates are in plane strain.
    #[error(
        "model {model} is one of plates with ends, which are not known here: plates are in plane strain; use chen, \
         table, log-spiral or coulomb"
    )]
    HasEnds {
        /// Model id.
        model: &'static str,
    },
    /// What a model found does not prove what it says.
    #[error(
        "what model {model} found is not proven ({why}); leave the plate's width out for bounds in plane strain"
    )]
    NotProven {
        /// Model id.
        model: &'static str,
        /// What the checker says.
        why: String,
    },
    /// A model of plates with ends, and nothing said about them.
    #[error("model {model} is one of plates with ends: {advice}")]
    NeedsEnds {
        /// Model id.
        model: &'static str,
        /// What the user can do.
        advice: &'static str,
    },
    /// Ends asked of a model that has none.
    #[error(
        "model {model} is for plane strain, in which a plate has no ends; use blocks-3d, mckyes, perumpral or \
         godwin-spoor, ovesen, or leave the ends out (--ends none)"
    )]
    NoEnds {
        /// Model id.
        model: &'static str,
    },
    /// No such model.
    #[error("there is no force model called {name:?}; the models are {known}")]
    UnknownModel {
        /// What was asked for.
        name: String,
        /// All ids, separated by commas.
        known: String,
    },
    /// The point lies in a part of the table that was never filled.
    #[error(
        "table {table} has no filled cells around alpha {} deg, phi {} deg, delta {} deg; \
         fill them or use another model",
        Rounded(*.alpha_deg), Rounded(*.phi_deg), Rounded(*.delta_deg)
    )]
    EmptyCell {
        /// Table name.
        table: String,
        /// Tool angle in degrees.
        alpha_deg: f64,
        /// Friction angle in degrees.
        phi_deg: f64,
        /// Interface friction in degrees.
        delta_deg: f64,
    },
    /// A table's content is wrong.
    #[error("{table}: {problem}")]
    BadTable {
        /// Table or file name, with the line where it is known.
        table: String,
        /// What is wrong, with the value and what is allowed.
        problem: String,
    },
    /// A table or its file is larger than any that is taken; found out before memory is asked for.
    #[error(
        "{table} has {size}; a table may have at most {limit} nodes: take larger steps or a smaller range"
    )]
    TooLarge {
        /// Table or file name.
        table: String,
        /// Its size, in words.
        size: String,
        /// Most nodes taken.
        limit: usize,
    },
    /// A file could not be read or written.
    #[error("{path}: {problem}")]
    File {
        /// The path.
        path: String,
        /// What the system says.
        problem: String,
    },
    /// The soil, interface or plate itself is not valid.
    #[error(transparent)]
    Soil(#[from] SoilError),
}
