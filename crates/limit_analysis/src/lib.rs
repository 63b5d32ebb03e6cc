//! Lower and upper bounds on plane-strain collapse loads, by finite-element limit analysis.
//!
//! A rigid structure is pushed through Mohr-Coulomb soil with associated flow, or loads on the soil are multiplied. The
//! collapse load is bounded by two cone programs on triangular meshes; what is reported is never the solver's objective but
//! what [`soilctl_certificate`] proves about the field that the solver found. That crate states the two theorems and the
//! symbols that are used here.
//!
//! ```no_run
//! use soilctl_limit_analysis::{EmbeddedPlate, Options, bound};
//!
//! let plate = EmbeddedPlate { alpha_deg: 90.0, phi_deg: 30.0, delta_deg: 15.0, ..EmbeddedPlate::default() };
//! let bounds = bound(&plate.problem()?, &Options::default(), &mut |_, _| {})?;
//! println!("{} to {}", bounds.lower.value, bounds.upper.value);
//! # Ok::<(), soilctl_limit_analysis::LimitError>(())
//! ```
//!
//! # The static program (lower bound)
//!
//! The stress is a reference stress `s0`, in equilibrium with the weight, plus the second derivatives of an Airy stress
//! function `f` on Clough-Tocher macro-elements: cubic on each third of a triangle, with continuous slopes. So equilibrium
//! and the continuity of tractions hold identically, and only yield is left, at the nodes `i` of each third, where stress
//! is linear:
//!
//! ```text
//! maximise    F(s)  or  m                        s = s0(m) + (f_yy, f_xx, -f_xy)
//! subject to  ( c cos(phi) - p sin(phi),  (xx - yy)/2,  xy )_i  in Q3     strength of the soil
//!             ( t - p,  (xx - yy)/2,  xy )_i  in Q3                       where its tension is limited to t
//!             adhesion - (normal + u) tan(delta) +- shear  >= 0           at both ends of each edge on a face
//! ```
//!
//! with `Q3 = { (a, b, c) : a >= sqrt(b^2 + c^2) }`. Given tractions fix `f` and its slopes along the boundary up to an
//! affine function, given shear fixes the slope across a line up to a constant: both are built into the unknowns.
//!
//! # The kinematic program (upper bound)
//!
//! Velocities are quadratic in Bernstein form. They may jump along slip lines, faces and interfaces. Strain rates are
//! linear on a triangle, so the flow rule holds everywhere if it does at the corners `i`; jumps are quadratic along an
//! edge, so theirs does if it holds for the Bernstein coefficients `j`:
//!
//! ```text
//! minimise    sum over triangles  int (c cot(phi) - u) e  +  sum over edges  int (c cot(phi) - u) opening  -  W(v)
//! subject to  ( e/sin(phi),  exx - eyy,  2 exy )_i  in Q3
//!             opening_j +- slip_j tan(phi)  >= 0
//!             P(v) = 1                                                    if a factor is bounded
//! ```
//!
//! Soil without friction keeps its volume: its velocity is that of a stream function on the macro-element of the static
//! program, and it dissipates `c g`, with one cone `(z, exx - eyy, 2 exy) in Q3` for each shear rate `g <= z`. Where tension
//! is limited, a cone more bounds `max(g - e, 0)`.
//!
//! # Members
//!
//! Bars and sheets bear an axial force `N` along a line. In the static program the slope of `f` across the line jumps by `N`, which is bounded by two rows for
//! each Bernstein coefficient; in the kinematic one the member has a velocity along itself, soil may slide on both sides, and each rise of
//! the velocity costs the tension that is borne, each fall the compression. Where the soil goes on between the bars of a row, what `N` grows by along
//! the line is bounded by two rows at each end of an edge, and in the kinematic program bars slip in the soil at them, at the cost of their
//! pullout resistance. [`soilctl_certificate`] states all of it.
//!
//! # Duality, and the gap
//!
//! On one mesh and with exact spaces the two programs are dual to each other: velocities are the multipliers of
//! equilibrium, the plastic multipliers those of yield. Here each is solved on its own spaces, so that both bounds are
//! strict. For any admissible pair, whatever the meshes,
//!
//! ```text
//! upper - lower  =  int ( D(v) - s : e(v) )  +  int ( D([v]) - (s n) . [v] )  >=  0
//! ```
//!
//! and neither integrand is anywhere negative. So the share of a triangle says where elements are missing: meshes are
//! refined until all shares are alike, and slip lines of the velocity become edges along which the next one may jump.
//!
//! # Plates with ends
//!
//! [`end_lower`] finds a stress field in space about the ends of an upright plate, by semidefinite cones on tetrahedra, for
//! [`soilctl_certificate::prove_end`] to prove.
//!
//! # Proofs
//!
//! Programs are tightened a little, so that the solver's rounding leaves fields strictly inside the cones. The certificate
//! then encloses each quantity in an interval whose ends are rounded outwards: what is returned holds for real numbers.
//!
//! # Sources
//!
//! - Lysmer (1970), Limit analysis of plane problems in soil mechanics. J. Soil Mech. Found. Div. ASCE 96, 1311-1334.
//! - Sloan (1988, 1989), Lower and upper bound limit analysis using finite elements and linear programming. Int. J. Numer.
//!   Anal. Methods Geomech. 12, 61-77; 13, 263-282.
//! - Lyamin & Sloan (2002), Lower bound limit analysis using non-linear programming. Int. J. Numer. Methods Eng. 55, 573-611.
//! - Makrodimopoulos & Martin (2006, 2007): both bounds by second-order cone programming, the upper one with straight
//!   six-node triangles. Int. J. Numer. Methods Eng. 66, 604-634; Int. J. Numer. Anal. Methods Geomech. 31, 835-865. In 2008
//!   with velocity jumps: Commun. Numer. Methods Eng. 24, 911-927.
//! - Krabbenhoft, Lyamin & Sloan (2007), Formulation and solution of some plasticity problems as conic programs. Int. J.
//!   Solids Struct. 44, 1533-1549.
//! - Clough & Tocher (1965): the macro-element; see [`soilctl_certificate`].

mod accuracy;
mod adapt;
mod anisotropy;
mod bound;
mod decide;
pub mod describe;
mod envelope;
mod error;
mod fields;
mod gap;
#[cfg(test)]
mod known;
mod lower;
mod members;
pub mod mesh;
mod mobile;
mod plate;
mod problem;
pub mod results;
mod singular;
mod slide;
mod slip;
mod space;
mod start;
mod strength;
mod topology;
mod upper;
mod vector;

pub use bound::{
    Bound, Bounds, Ended, IDENTITY, Level, Options, SHARES, Solve, StoppedBy, WORK_TO_FALL, bound,
    bound_section, falls, seems_to_fall,
};
pub use decide::{Decision, Reach, decide};
pub use describe::{Described, Description, DescriptionError};
pub use error::{LimitError, OneSide};
pub use plate::{EmbeddedPlate, MAX_ANGLE_SUM_DEG, StressLaw};
pub use problem::Problem;
pub use soilctl_conic::{Factorisation, Status};
pub use space::{EndLevel, EndLower, EndOptions, end_lower};
pub use strength::{SafetyBounds, SafetyProof, Trial, factor_of_safety};
