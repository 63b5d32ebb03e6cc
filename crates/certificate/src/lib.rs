//! Saved limit-analysis solutions, and proofs of the bounds they claim.
//!
//! A rigid structure is pushed through soil (plane strain, Mohr-Coulomb, associated flow). How much force the soil can
//! resist is bounded from below by any stress field in equilibrium that the soil can bear, and from above by any flow
//! that dilates as its friction demands. [`prove_lower`] and [`prove_upper`] check such fields with interval arithmetic
//! whose ends are rounded outwards, and return the bound that is then *proven* for exactly the numbers of the
//! [`Statement`]. They share no code with the solver that made the fields and trust nothing in them: a field from
//! elsewhere, altered or wrong, either proves a true bound or is refused with a reason.
//!
//! ```no_run
//! use soilctl_certificate::{Solution, prove};
//!
//! let proof = prove(&Solution::read("solution.json".as_ref())?)?;
//! for (name, bound) in [("lower", proof.lower), ("upper", proof.upper)] {
//!     if let Some(bound) = bound {
//!         println!("{name} bound: {} proven, {} claimed", bound.proven, bound.claimed);
//!     }
//! }
//! # Ok::<(), soilctl_certificate::CertificateError>(())
//! ```
//!
//! # What is bounded
//!
//! `F`, the force of the structure on the soil (per unit width) times the structure's velocity `V`: the largest that a
//! stress field in equilibrium with weight and surcharge can have, of all that soil and faces can bear. A soil bears
//! `c cos(phi) - sin(phi) (xx + yy)/2 >= sqrt(((xx - yy)/2)^2 + xy^2)`, a [face](Condition::Face) `|shear| <= adhesion -
//! normal tan(delta)`, a frictionless one pressure only. Soil beyond [far](Condition::Far) lines is part of it: to the
//! left and right of the mesh, below it, or all around. Where such soil adjoins a [fixed](Condition::Fixed) or
//! [smooth](Condition::Smooth) wall or base at a corner of the mesh, that goes on for ever too.
//!
//! # Every interval holds the true number
//!
//! Each operation returns an interval that holds the true result if the arguments hold theirs, so the checks hold for
//! real numbers. Vertices on lines and on points of the statement are exactly there. Zeros that follow from the
//! construction, such as `x - x` for one `x`, are not computed at all, so inequalities that hold with equality there
//! can be proven.
//!
//! # The mesh covers the soil once
//!
//! Lines of the statement are proven not to cross, and beyond each side that has soil on one hand only there is proven
//! to be none, so regions do not overlap. All triangles are proven to be counter-clockwise. Each edge is either paired
//! with one of the same region or lies on a loop of its region, in the loop's sense, and the latter cover the loops once.
//! So the boundaries of all triangles of a region add up to its loops, and the number of triangles over a point is the
//! loops' winding number around it: one in the region, zero outside.
//!
//! # Upper bound
//!
//! For a stress field as above and a flow `v` that is zero far away, virtual work gives `F` = power of the stresses on the
//! strain rate and on the jumps of `v`, less that of the weight and of the surcharge, less that of the tractions on the
//! slip `v - V` at the faces. Where strain rate and jumps are in the cone that is dual to what the soil or face bears
//! (`exx + eyy >= sin(phi) sqrt((exx - eyy)^2 + 4 exy^2)`; opening at least slip times `tan`), the power is at most
//! `c cot(phi)` times the dilation. The cones are convex: strain rates, linear on a triangle, obey at the corners and
//! hence everywhere; jumps, quadratic along an edge, obey at Bernstein control points and hence everywhere. A jump between
//! two soils may use either, since the traction is within the strength of both. What remains is linear in the control
//! points and is summed.
//!
//! # Lower bound
//!
//! The stress is the reference plus `xx = f_yy, yy = f_xx, xy = -f_xy` of a function `f` with continuous slopes, cubic on
//! each third of a triangle. The reference is in equilibrium with the weight; with depth `d` below the datum, gravity
//! `g`, unit weight `w`, surcharge `q` and `t = g_x/g_y` it is `yy = w g_y d - q, xy = w g_x d, xx = (1 + 2 t^2) w g_y d - q`.
//! The rest needs no force: it is in equilibrium with itself in each part, and tractions on an edge are derivatives along
//! the edge of the slopes, which both sides share. *So equilibrium holds by construction*: both sides of an edge take value
//! and slopes at its ends from the same vertex copies and the slope across its middle from the same number; a cubic and
//! its quadratic slope across are determined by these. Affine functions carry no stress; chains name some, so that values
//! near them can be stored without loss.
//!
//! - *Free edges.* `f` equals the affine function of one chain there, with its slopes, so there is no traction beyond the
//!   reference's, which is the surcharge since free sides lie at the datum.
//! - *Lines of given shear.* With `n = to - from` turned left, the slope across `g = grad f . n` has `g' = t . ref n` (no
//!   shear stress) or `g' = 0` (far lines: that of the reference). This makes it a known quadratic polynomial but for a
//!   constant, which comes from the first chain that the line touches or from [`LowerField::lines`]. The slope across an
//!   edge equals `g` if it does at both ends and in the middle.
//! - *Apexes.* Without surcharge and cohesion there is no strength at the free surface, so the stress must vanish at all
//!   copies that belong to chains: all Bernstein coefficients up to two steps from them are zero (beyond the chain). The one
//!   next to a neighbour `C` of an apex `T` is `f + grad f . (T - C)/3` = 0, which restricts the [`Jet`] of `C`. The
//!   conditions for continuous slopes across and within triangles then hold as for the general element.
//! - *Strength.* Stresses are linear on each part, so its three nodes decide; so do both ends of a face edge.
//! - *Force.* Tractions of `f` on a piece of boundary, soil on the left, add up to the change of `(f_y, -f_x)`.
//!
//! # Beyond far lines
//!
//! Beside a vertical far line the stress is, at each height, (`xx` of the mesh at the line, reference `yy`, reference
//! `xy`). Below a level one it is (reference `xx` + `far_stress`, `yy` of the mesh at the line + what the weight adds with
//! depth, reference `xy`). In the quadrants beyond both it is (reference `xx` + `far_stress`, reference `yy` and `xy`).
//! Each balances: the components that vary only along x or y in the way that matters are those of the reference, for
//! `xx` in the strips beside does not depend on x and `yy` below the mesh changes with y as in the reference. On each
//! line between two of these the components that act across it are the same: `xy` is the reference's everywhere (in the
//! mesh because `g' = 0`); `xx` continues across vertical lines, `yy` across level ones. The surface at the datum carries
//! the surcharge. Strength is proven at both ends of each edge and in the corners; downwards a stress state moves along
//! the reference's gradient, which is proven to be within the cone of the strength without cohesion, so it stays within.
//!
//! # What is not covered yet
//!
//! Upper bounds for soil without friction; lower bounds with different unit weights or with free sides off the datum;
//! adhesion without friction; far lines other than a frame of the mesh; more than two lines of given shear, or parallel
//! ones, that meet.

mod error;
#[cfg(test)]
mod examples;
mod fields;
mod interval;
mod lower;
mod mesh;
mod problem;
mod proof;
mod solution;
mod statement;
#[cfg(test)]
mod tests;
mod tiling;
mod upper;

pub use error::CertificateError;
pub use fields::{Chain, Gradient, Jet, LowerField, UpperField, Velocity, VertexCopy};
pub use lower::prove_lower;
pub use mesh::{Mesh, Place, Triangle, Vertex};
pub use proof::{Bound, Proof, prove};
pub use solution::{Claim, MAX_FILE_BYTES, SCHEMA, Scale, Solution};
pub use statement::{Boundary, Condition, Line, LineUse, Material, Region, Statement};
pub use upper::prove_upper;
