//! Stress fields in space, to look at.

use super::borne::Balanced;
use super::field::SpaceStress;
use super::simplex::Matrix;
use super::strength::{Strengths, extremes};
use super::topology::Complex;
use super::upright::UprightPlate;
use super::{PLANE, SPACE, section};
use crate::CertificateError;
use crate::interval::{Interval, angle};
use crate::statement::Statement;

/// A stress field about one end of a plate as it lies in the soil of a statement: x and z as x and y of the
/// statement, y across from the middle of the plate, towards the end where it is positive. Pressures are positive.
/// Rounded: nothing is proven.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownSpace {
    /// Tetrahedra in each of which the stress is linear.
    pub parts: Vec<ShownPart>,
    /// Faces on the plate.
    pub plate: Vec<ShownFace>,
}

/// A tetrahedron.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPart {
    /// Its corners: x, y, z.
    pub corners: [[f64; 3]; 4],
    /// The stress at each of these.
    pub stress: [[[f64; 3]; 3]; 4],
    /// The least and the greatest principal pressure at each of these.
    pub principal: [[f64; 2]; 4],
}

/// A triangle on the plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownFace {
    /// Its corners: y, z.
    pub corners: [[f64; 2]; 3],
    /// At each of these, the pressure on the plate's face ahead less that on the one behind.
    pub net_pressure: [f64; 3],
}

/// What a stress field in space looks like.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a plate that such a field is for, or the field cannot be balanced.
pub fn show_space(statement: &Statement, stress: &SpaceStress) -> Result<ShownSpace, CertificateError> {
    let plate = UprightPlate::new(statement)?;
    let strengths = Strengths::new(angle(plate.phi_deg), plate.delta_deg);
    let complex = Complex::new(&stress.vertices, &stress.tetrahedra, &SPACE)?;
    let plane = Complex::new(&stress.section.vertices, &stress.section.triangles, &PLANE)?;
    let end = Balanced::new(complex, &stress.tractions, &stress.behind, &strengths)?;
    section::across(&plane, &stress.section.parents, &end)?;
    let depth = plate.depth.middle();
    let unit = plate.unit_weight.middle() * depth;
    let forward = if plate.moves_back { -1.0 } else { 1.0 };
    let top = [plate.top.x, plate.top.y].map(Interval::middle);
    let place = |[x, s, z]: [f64; 3]| {
        [top[0] + forward * depth * x, plate.half_width + depth * s, top[1] + depth * z]
    };
    let seen = |stress: &Matrix<3>| {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                // Shear stresses with x change their sign in a mirror.
                let mirrored = if (i == 0) == (j == 0) { 1.0 } else { forward };
                unit * mirrored * stress[i][j].middle()
            })
        })
    };
    let mut parts = Vec::new();
    for (number, cell) in end.complex.cells.iter().enumerate() {
        let points = end.stresses(number);
        let at = |corner: usize| end.complex.places[corner];
        let mean = |axis: usize| cell.corners.iter().map(|&c| at(c)[axis]).sum::<f64>() / 4.0;
        let middle = std::array::from_fn(mean);
        for left_out in 0..4 {
            // The centroid comes last.
            let centre = points.last().map_or([[0.0; 3]; 3], |point| seen(&point.stress));
            let mut part = ShownPart {
                corners: [place(middle); 4],
                stress: [centre; 4],
                principal: [extremes(centre); 4],
            };
            // Points are listed corner by corner, at each the parts that have it.
            for (slot, k) in (0..4).filter(|&k| k != left_out).enumerate() {
                let corner = cell.corners[k];
                part.corners[slot] = place(at(corner));
                part.stress[slot] = seen(&points[3 * k + left_out - usize::from(left_out > k)].stress);
                part.principal[slot] = extremes(part.stress[slot]);
            }
            parts.push(part);
        }
    }
    let faces = end.complex.plates().map(|(number, face)| {
        let corner = |k: usize| {
            let [_, y, z] = place(end.complex.places[face.corners[k]]);
            [y, z]
        };
        ShownFace {
            corners: std::array::from_fn(corner),
            net_pressure: std::array::from_fn(|k| unit * end.net_pressure(number, k).middle()),
        }
    });
    let faces = faces.collect();
    Ok(ShownSpace { parts, plate: faces })
}
