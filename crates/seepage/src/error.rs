use thiserror::Error;

/// Why a flow cannot be found.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SeepageError {
    /// An index that nothing has.
    #[error("{what} {index} is named, but there are {count}")]
    Index {
        /// Of what.
        what: &'static str,
        /// The index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A number that makes no sense.
    #[error("{what} is {value}, allowed is {allowed}")]
    Number {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        allowed: &'static str,
    },
    /// A triangle without area, or with its corners clockwise.
    #[error("triangle {triangle} has no area, or its corners run clockwise; list them counter-clockwise")]
    Flat {
        /// Its index.
        triangle: usize,
    },
    /// An edge at which more than two triangles meet.
    #[error("more than two triangles meet at the edge of points {} and {}; a mesh has two there", edge[0], edge[1])]
    Crowded {
        /// The indices of its points.
        edge: [usize; 2],
    },
    /// Soil that no given head reaches.
    #[error(
        "no head is given that reaches the soil around ({:.4}, {:.4}); give one on its boundary", at[0], at[1]
    )]
    NoHead {
        /// A place in it.
        at: [f64; 2],
    },
    /// The equations could not be solved.
    #[error(
        "the equations of the flow are singular to working precision; permeabilities may differ too much"
    )]
    Singular,
    /// The free surface was not found.
    #[error("the free surface was not found in {steps} steps; the heads still change by {change:.2e} m")]
    NotFound {
        /// Steps that were made.
        steps: usize,
        /// The last change.
        change: f64,
    },
    /// A build for 32 bits.
    #[error("flow of water is not computed in browsers or where addresses have 32 bits; use the program")]
    NotHere,
}
