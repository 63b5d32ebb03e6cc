//! A lower bound by a stress field in space about one end of a thin upright plate, in soil with friction and weight
//! only.
//!
//! Coordinates: x ahead, s across (zero at the plate's end, negative towards its middle), z upwards (zero at the
//! surface). The plate is where `x = 0`, `-1 < z < 0` and `s < 0`; the unit weight is 1. `P` is the stress, pressure
//! positive: `div P = -e_z`. `K = (1 + sin(phi))/(1 - sin(phi))`, and the soil bears `P` if its principal pressures
//! obey `p1 <= K p3`.
//!
//! # The whole field
//!
//! Let the plate have the width `w >= 2 b`, and let `d = -z` be the depth. About each end, in the *box* `x0 < x <
//! x1`, `-b < s < e`, `-D < z < 0`, the stress is that of the tetrahedra, mirrored at the other end. Between both
//! boxes, in the *section* `x0 < x < x1`, `-D < z < 0`, it is that of the triangles, the same across, with `P_ss =
//! f(x, z)` and no shear stress across. Elsewhere the soil stands in columns:
//!
//! ```text
//! ahead of and behind box and section, d < D     P_xx as in their planes x = x1 and x = x0,     P_ss = P_zz = d
//! beside the box, s > e, x0 < x < x1, d < D      P_ss as in its plane s = e,                    P_xx = P_zz = d
//! below box and section, d > D                   P_zz = d + g,  g = P_zz - D at z = -D,         P_xx = P_ss = d
//! everywhere else                                the ground at rest,                            P_xx = P_ss = P_zz = d
//! ```
//!
//! *It is in equilibrium.* In tetrahedra and triangles this is [proven](stress) once all [balances](balance) hold;
//! that `f` and the rest of the section do not vary across means that nothing else is needed there. In columns no
//! stress varies along its own direction but `P_zz`, which grows as the weight demands. In the planes between these
//! parts there are no shear stresses on either side: in those of the box and on the rim of the section by what is
//! given, elsewhere since there are none at all. The pressure across them is the same on both sides: by construction
//! where the box or the section adjoins, and `d` where columns adjoin columns or the ground at rest. In the plane
//! between box and section it is `f`. At the surface nothing presses.
//!
//! *It is borne.* In each part of a tetrahedron or a triangle the stress is linear, with `f` in the latter, and what
//! the soil bears is a convex cone: [vertices and centroids](strength) decide. It bears a column ahead, behind or
//! beside if and only if its own pressure `p` obeys `d/K <= p <= K d`. Both are linear on each face, so its vertices
//! decide. The same is proven of `P_zz` at `z = -D`; below, `K d - (d + g)` and `d + g - d/K` grow with the depth.
//! The faces of the plate bear `|(P_xs, P_xz)| <= tan(delta) P_xx`, a convex cone too. Its edges are thin.
//!
//! *So the plate's force is a lower bound* by the static theorem, for a plate that moves along x: with `F` the force
//! along x on the part of the plate in the box, and `h` that per unit width between,
//!
//! ```text
//! 2 F + (w - 2 b) h
//! ```
//!
//! The cone has nothing to spare where the best field lies on its boundary, so that fields must keep a margin for the
//! rounding of their numbers: a share of 1e-7 of the ground at rest, which all bear with strength to spare, is enough
//! and costs nothing.
//!
//! # What is proven of a field
//!
//! - [`topology`]: the tetrahedra tile the box and the triangles its section; faces cover the plate; triangles lie in
//!   faces.
//! - [`system`]: what presses on faces need not balance in doubles. It is proven that close to it there is something
//!   that does. That is what the field is said to be; it is known in intervals.
//! - [`stress`]: what follows from it inside.
//! - [`borne`]: that all bear that.
//!
//! # Sources
//!
//! - Johnson & Mercier (1978), Some equilibrium finite element methods for two-dimensional elasticity problems.
//!   Numer. Math. 30, 103-116.
//! - Krizek (1982), An equilibrium finite element method in three-dimensional elasticity. Apl. Mat. 27, 46-75.
//! - Rump (2006), Verification of positive definiteness. BIT Numer. Math. 46, 433-452.

mod balance;
mod borne;
mod cholesky;
mod dissection;
mod field;
mod section;
mod shown;
mod simplex;
mod strength;
mod stress;
mod system;
#[cfg(test)]
mod tests;
mod topology;
mod tractions;
mod upright;

pub use field::{SpaceSection, SpaceStress};
pub use shown::{ShownFace, ShownPart, ShownSpace, show_space};

use borne::Balanced;
use strength::Strengths;
use topology::{Complex, Words};
use upright::{UprightPlate, not_covered};

use crate::CertificateError;
use crate::interval::{Interval, angle};
use crate::statement::Statement;

const SPACE: Words = Words { vertex: "vertex", cell: "tetrahedron", cells: "tetrahedra", face: "face" };
const PLANE: Words = Words {
    vertex: "vertex of the section",
    cell: "triangle of the section",
    cells: "triangles of the section",
    face: "edge of the section",
};

/// What a stress field about one end of a plate proves, in units of the plate's depth and the soil's weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndForce {
    /// How far the field about the end reaches towards the middle.
    pub reach: f64,
    /// The plate's force on that part of its width is not below this.
    pub end: f64,
    /// Between, that per unit width is not below this.
    pub between: f64,
}

impl EndForce {
    /// A lower bound on the force of a plate with two ends, per unit of its width; none if it is not as wide as both
    /// ends reach.
    #[must_use]
    pub fn per_width(&self, width: f64) -> Option<f64> {
        self.at(Interval::point(width)).map(Interval::lo).filter(|force| force.is_finite())
    }

    fn at(&self, width: Interval) -> Option<Interval> {
        let ends = Interval::point(2.0 * self.reach);
        let rest = width - ends;
        let force = Interval::point(2.0 * self.end) + rest * Interval::point(self.between);
        (rest.is_at_least_zero() && width.is_positive()).then(|| force / width)
    }
}

/// Proves a lower bound on the force of a thin upright plate, moved ahead, in soil with weight and friction only.
///
/// # Errors
///
/// [`CertificateError`] if an angle is out of range, or the field is not proven to be statically admissible.
pub fn prove_end(phi_deg: f64, delta_deg: f64, stress: &SpaceStress) -> Result<EndForce, CertificateError> {
    in_range("friction angle of the soil", phi_deg, "above 0 and below 90", phi_deg > 0.0)?;
    in_range("friction angle of the plate", delta_deg, "at least 0 and below 90", delta_deg >= 0.0)?;
    let strengths = Strengths::new(angle(phi_deg), delta_deg);
    let complex = Complex::new(&stress.vertices, &stress.tetrahedra, &SPACE)?;
    let plane = Complex::new(&stress.section.vertices, &stress.section.triangles, &PLANE)?;
    let ([x0, s0, z0], [x1, _, z1]) = (complex.low, complex.high);
    if (plane.low, plane.high) != ([x0, z0], [x1, z1]) {
        let problem = "must fill the side of the box where s is least";
        return Err(CertificateError::BadMesh { place: "the section".into(), problem });
    }
    let end = Balanced::new(complex, &stress.tractions, &stress.behind, &strengths)?;
    let across = section::across(&plane, &stress.section.parents, &end)?;
    let middle = Balanced::new(plane, &stress.section.tractions, &stress.section.behind, &strengths)?;
    end.check_faces(&strengths, |axis, high| axis == 1 && !high)?;
    middle.check_faces(&strengths, |_, _| false)?;
    end.check_soil(&strengths, |_, _, stress| *stress)?;
    middle.check_soil(&strengths, |cell, corner, stress| {
        let values = across[cell];
        let corners = &middle.complex.cells[cell].corners;
        let at = corner.and_then(|corner| corners.iter().position(|&c| c == corner));
        let across = at.map_or_else(|| (values[0] + values[1] + values[2]).third(), |at| values[at]);
        section::with_across(stress, across)
    })?;
    let [end, between] = [end.force(), middle.force()].map(Interval::lo);
    if end.is_finite() && between.is_finite() {
        return Ok(EndForce { reach: -s0, end, between });
    }
    Err(CertificateError::NotProven {
        quantity: "difference of the largest number and the force",
        place: "the plate".into(),
        low: f64::NEG_INFINITY,
        unit: "force",
    })
}

fn in_range(
    quantity: &'static str,
    value: f64,
    allowed: &'static str,
    low: bool,
) -> Result<(), CertificateError> {
    if low && value < 90.0 {
        return Ok(());
    }
    Err(CertificateError::OutOfRange { quantity, place: "the field".into(), value, unit: "degrees", allowed })
}

/// Proves a lower bound on the force that the soil can resist times the structure's velocity, per unit width of a
/// thin upright plate that has ends, with a stress field in space.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not such a plate, moved across its faces, in soil with friction and
/// weight only, or the field is not proven to be statically admissible.
pub fn prove_space(statement: &Statement, stress: &SpaceStress) -> Result<f64, CertificateError> {
    let plate = UprightPlate::new(statement)?;
    let force = prove_end(plate.phi_deg, plate.delta_deg, stress)?;
    let unit = plate.unit_weight * plate.depth.square() * plate.speed;
    let width = Interval::point(plate.half_width) * Interval::point(2.0) / plate.depth;
    match force.at(width).map(|force| (force * unit).lo()).filter(|bound| bound.is_finite()) {
        Some(bound) => Ok(bound),
        None => not_covered("the width", "the plate must be as wide as the field reaches from both ends"),
    }
}
