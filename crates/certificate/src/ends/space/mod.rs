//! A lower bound by a stress field in space about one end of a thin upright plate, in soil with friction and weight only.
//!
//! Coordinates: x ahead, s across (zero at the plate's end, negative towards its middle), z upwards (zero at the surface). The
//! plate is where `x = 0`, `-1 < z < 0` and `s < 0`; the unit weight is 1. `P` is the stress, pressure positive: `div P = -e_z`.
//! `K = (1 + sin(phi))/(1 - sin(phi))`, and the soil bears `P` if its principal pressures obey `p1 <= K p3`.
//!
//! # The whole field
//!
//! Let the plate have the width `w >= 2 b`. About each end the stress is that of the tetrahedra in the box `x0 < x < x1`, `-b < s < e`, `-D < z < 0`,
//! mirrored at the other end. Elsewhere it is, with `d = -z`,
//!
//! ```text
//! between the boxes, in the section of the box     P_xx, P_zz, P_xz of the triangles,  P_ss = f(x, z),  P_xs = P_sz = 0
//! x < x0 or x > x1, at s or between the boxes       diag(P_xx of the box or the section there, d, d)
//! s > e at the x of the box                         diag(d, P_ss of the box there, d)
//! below the box or the section                      diag(d, d, d + g(x, s)),  g = P_zz - D at z = -D
//! in all corners                                    diag(d, d, d)
//! ```
//!
//! Here "below" and "in all corners" are: at depths above `D` only the columns in x and s of the first lines, so beside the
//! columns below there is the ground at rest.
//!
//! *It is in equilibrium.* In the tetrahedra and triangles, by [what is proven of them](stress) once all [balances](balance) hold; a
//! pressure `f` across that does not vary with s needs nothing. Columns: the pressures along x (or s) do not vary along it, nor do others; `P_zz`
//! grows as the weight demands. Across the planes between these parts all shear stresses are zero on both sides: planes of the
//! box and the rim of the section bear normal pressures only. Across `x = x0` and `x = x1` the pressure `P_xx` is continuous by
//! construction within the section and the width of the box, and beyond the box in s it is `d` on both sides; across `s = e` the same holds
//! of `P_ss`; across `s = -b` it is `f` within the section, and `d` beyond x0 and x1 and below; across `z = -D` it is `P_zz` of the
//! box within, and `D` beyond. At the surface all stress is zero: in simplices that touch it only at vertices or edges as well, since all that
//! presses there is. Columns are so, too.
//!
//! *It is borne.* In the parts of a simplex the stress is linear, and what is borne is a convex cone: [the vertices and the
//! centroid](strength) decide. Between the boxes, `f` is linear on each triangle, and decided with it. Columns in x or s: if and only if `d/K <= P_xx <= K d`, of
//! which both sides are linear on each face, so that the vertices decide. Below the box, the same is proven of `P_zz` at `z = -D`; from
//! there on `K d - (d + g)` and `d + g - d/K` grow with the depth. The plate bears `|(P_xs, P_xz)| <= tan(delta) P_xx`, a convex cone of
//! what is linear on each face, on both sides; its edges are thin.
//!
//! *So the plate's force is a lower bound*, by the static theorem, of the force in the direction x that moves it: with `F`
//! that on the plate in the box and `h` that per unit width between,
//!
//! ```text
//! 2 F + (w - 2 b) h
//! ```
//!
//! # What is proven of a field
//!
//! - [`topology`]: the tetrahedra tile the box and the triangles its section; faces cover the plate; triangles lie in faces.
//! - [`system`]: what presses on faces need not balance in doubles. It is proven that close to it there is something that does.
//!   That is what the field is said to be; it is known in intervals.
//! - [`stress`]: what follows from it inside.
//! - [`borne`]: that all bear that.
//!
//! # Sources
//!
//! - Johnson & Mercier (1978), Some equilibrium finite element methods for two-dimensional elasticity problems. Numer. Math. 30, 103-116.
//! - Krizek (1982), An equilibrium finite element method in three-dimensional elasticity. Apl. Mat. 27, 46-75.
//! - Rump (2006), Verification of positive definiteness. BIT Numer. Math. 46, 433-452.

mod balance;
mod borne;
mod cholesky;
mod dissection;
mod field;
mod section;
mod simplex;
mod strength;
mod stress;
mod system;
#[cfg(test)]
mod tests;
mod topology;
mod tractions;

pub use field::{SpaceSection, SpaceStress};

use borne::Balanced;
use strength::Strengths;
use topology::{Complex, Words};

use super::plate::EndedPlate;
use crate::CertificateError;
use crate::interval::{Interval, angle};
use crate::problem::Problem;
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
    /// A lower bound on the force of a plate with two ends, per unit of its width; none if it is not as wide as both ends reach.
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

/// Proves a lower bound on the force that the soil can resist times the structure's velocity, per unit width of a thin
/// upright plate that has ends, with a stress field in space.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not such a plate, moved across its faces, in soil with friction and weight only, or the
/// field is not proven to be statically admissible.
pub fn prove_space(statement: &Statement, stress: &SpaceStress) -> Result<f64, CertificateError> {
    let not_covered = |place: &str, what| Err(CertificateError::NotCovered { place: place.into(), what });
    let problem = Problem::new(statement)?;
    let plate = EndedPlate::new(&problem)?;
    let material = plate.material;
    if !plate.down.x.is_zero() {
        return not_covered("the plate", "a stress field in space needs an upright one");
    }
    if !plate.gravity.x.is_zero() {
        return not_covered("gravity", "a stress field in space needs a level surface");
    }
    if !(plate.cohesion.is_zero() && plate.surcharge.is_zero()) {
        let what = "a stress field in space is for weight alone: no cohesion, no surcharge";
        return not_covered("the soil", what);
    }
    let Some(delta_deg) = alike(statement) else {
        return not_covered(
            "the plate",
            "a stress field in space needs faces of one friction, without adhesion",
        );
    };
    if !(plate.velocity.y.is_zero() && plate.velocity.x.is_not_zero()) {
        return not_covered(
            "the velocity",
            "a stress field in space is for plates that move across their faces",
        );
    }
    let force = prove_end(material.phi_deg, delta_deg, stress)?;
    let depth = -plate.down.y;
    // Behind is ahead for a plate that moves to the left.
    let unit =
        Interval::point(material.unit_weight) * -plate.gravity.y * depth.square() * plate.velocity.x.abs();
    let width = Interval::point(plate.half_width) * Interval::point(2.0) / depth;
    match force.at(width).map(|force| (force * unit).lo()) {
        Some(bound) if bound.is_finite() => Ok(bound),
        _ => not_covered("the width", "the plate must be as wide as the field reaches from both ends"),
    }
}

/// The friction of the plate's faces, if it is one and they have no adhesion.
fn alike(statement: &Statement) -> Option<f64> {
    let faces = statement.boundaries.iter().filter_map(|boundary| match boundary.condition {
        crate::statement::Condition::Face { delta_deg, adhesion } => Some([delta_deg, adhesion]),
        _ => None,
    });
    let all: Vec<[f64; 2]> = faces.collect();
    let first = *all.first()?;
    (first[1] == 0.0 && all.iter().all(|face| *face == first)).then_some(first[0])
}
