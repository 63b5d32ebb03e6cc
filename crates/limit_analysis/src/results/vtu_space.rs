//! Blocks and stresses in space for ParaView: x ahead, y across from the middle of the plate, z up.

use soilctl_certificate::{BeyondFacet, Mechanism, ShownSpace};

use super::units::Units;
use super::vtu_file::{Cells, Field, Shape, write};
use crate::error::LimitError;

/// A place in space in units that people know.
fn shown(units: &Units, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [x, z] = units.point([x, z]);
    [x, units.length * y, z]
}

/// The rigid blocks behind an upper bound in ParaView's format, on one side of the middle of the plate: the triangles of their faces.
///
/// At points: `velocity`, in units of the structure's. For each triangle its `block`, and what is `beyond` it: 0 soil at rest, 1
/// another block, 2 the surface, 3 the plate, 4 the other half.
///
/// # Errors
///
/// [`LimitError::NotFinite`] if a number is too large to be written.
pub fn write_blocks_vtu(
    mechanism: &Mechanism,
    places: &[[f64; 3]],
    units: &Units,
) -> Result<String, LimitError> {
    let beyond = |beyond: BeyondFacet| match beyond {
        BeyondFacet::Rest => 0.0,
        BeyondFacet::Block(_) => 1.0,
        BeyondFacet::Surface => 2.0,
        BeyondFacet::Plate => 3.0,
        BeyondFacet::Symmetry => 4.0,
    };
    let facets = &mechanism.facets;
    let triangles = Cells {
        shape: Shape::Triangle,
        points: facets.iter().flat_map(|f| f.corners).map(|corner| shown(units, places[corner])).collect(),
        number: ("block", facets.iter().map(|f| f.block).collect()),
    };
    let velocity = facets.iter().flat_map(|f| [mechanism.velocities[f.block]; 3]).flatten();
    let points = [Field { name: "velocity", components: 3, values: velocity.collect() }];
    let cells = [Field::scalar("beyond", facets.iter().map(|f| beyond(f.beyond)).collect())];
    write(&triangles, &points, &cells)
}

/// A stress field about one end of a plate in ParaView's format: the tetrahedra in each of which it is linear.
///
/// At points: the total `stress` (a tensor of 9, tension positive) and the greatest and least principal pressure, `principal_major` and
/// `principal_minor` (compression positive), in units of stress. Each four tetrahedra are an `element`.
///
/// # Errors
///
/// [`LimitError::NotFinite`] if a number is too large to be written.
pub fn write_space_vtu(stress: &ShownSpace, units: &Units) -> Result<String, LimitError> {
    let parts = &stress.parts;
    let tetrahedra = Cells {
        shape: Shape::Tetrahedron,
        points: parts.iter().flat_map(|part| part.corners).map(|place| shown(units, place)).collect(),
        number: ("element", (0..parts.len()).map(|part| part / 4).collect()),
    };
    let tensors = parts.iter().flat_map(|part| part.stress.as_flattened().as_flattened().to_vec());
    let principal = |which: usize| {
        parts
            .iter()
            .flat_map(|part| part.principal)
            .map(|pressures| units.stress * pressures[which])
            .collect()
    };
    let points = [
        Field { name: "stress", components: 9, values: tensors.map(|p| -units.stress * p).collect() },
        Field::scalar("principal_major", principal(1)),
        Field::scalar("principal_minor", principal(0)),
    ];
    write(&tetrahedra, &points, &[])
}
