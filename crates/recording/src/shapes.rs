//! The arm's shapes, from the URDF.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use soilctl_motion::{Mesh, Part};
use soilctl_robot::{Geometry, Link, Visual};

use crate::rows::single;
use crate::rrd::{Column, Component, Values};

/// Where the URDF names no colour.
const GREY: [f64; 4] = [0.7, 0.7, 0.72, 1.0];
/// Filled, not as wires.
const SOLID: u8 = 3;

/// What is drawn of a link: name below the link's entity, and columns. Meshes are in files of their own.
pub(crate) fn shapes(link: &Link, meshes: &BTreeMap<String, Mesh>) -> Vec<(String, Vec<Column>)> {
    let numbered = link.visuals.iter().enumerate();
    numbered
        .flat_map(|(number, visual)| {
            let parts = parts(visual, meshes).into_iter().enumerate();
            parts.map(move |(part, columns)| match part {
                0 => (format!("shape_{number}"), columns),
                more => (format!("shape_{number}_{more}"), columns),
            })
        })
        .collect()
}

/// Red, green, blue and opacity in a number.
fn packed(colour: [f64; 4]) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
    let bytes = colour.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
    u32::from_be_bytes(bytes)
}

fn parts(visual: &Visual, meshes: &BTreeMap<String, Mesh>) -> Vec<Vec<Column>> {
    let (origin, colour) = (&visual.origin, packed(visual.colour.unwrap_or(GREY)));
    match &visual.geometry {
        &Geometry::Box { size_m } => {
            let half = single(size_m.map(|length| 0.5 * length));
            let sizes = Component::new("Boxes3D", "half_sizes", "HalfSize3D");
            vec![placed("Boxes3D", vec![Column::row(sizes, Values::Vectors(vec![half]))], origin, colour)]
        }
        &Geometry::Cylinder { radius_m, length_m } => vec![cylinder(radius_m, length_m, origin, colour)],
        &Geometry::Sphere { radius_m } => vec![ball(radius_m, origin, colour)],
        &Geometry::Capsule { radius_m, length_m } => {
            let end = |side: f64| origin * Translation3::new(0.0, 0.0, side * 0.5 * length_m);
            vec![
                cylinder(radius_m, length_m, origin, colour),
                ball(radius_m, &end(-1.0), colour),
                ball(radius_m, &end(1.0), colour),
            ]
        }
        Geometry::Mesh { filename, scale } => {
            let parts = meshes.get(filename).into_iter().flat_map(|mesh| &mesh.parts);
            parts.map(|part| triangles(part, scale, origin, visual.colour, colour)).collect()
        }
        _ => Vec::new(),
    }
}

/// Triangles in the link's frame; the URDF's colour counts before that of the file.
fn triangles(
    part: &Part,
    scale: &[f64; 3],
    origin: &Isometry3<f64>,
    of_urdf: Option<[f64; 4]>,
    colour: u32,
) -> Vec<Column> {
    const POSITIONS: Component = Component::new("Mesh3D", "vertex_positions", "Position3D");
    const NORMALS: Component = Component::new("Mesh3D", "vertex_normals", "Vector3D");
    const TRIANGLES: Component = Component::new("Mesh3D", "triangle_indices", "TriangleIndices");
    const COLOUR: Component = Component::new("Mesh3D", "albedo_factor", "AlbedoFactor");
    let scaled = |point: &[f32; 3]| {
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(point[axis]) * scale[axis]);
        single((origin * Point3::new(x, y, z)).into())
    };
    let turned = |normal: &[f32; 3]| {
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(normal[axis]) / scale[axis]);
        let normal = Vector3::new(x, y, z).try_normalize(0.0).unwrap_or_else(Vector3::z);
        single((origin.rotation * normal).into())
    };
    // A mirror turns triangles over.
    let mirrored = scale.iter().product::<f64>() < 0.0;
    let around = |[a, b, c]: &[u32; 3]| if mirrored { [*a, *c, *b] } else { [*a, *b, *c] };
    let colour = match (of_urdf, part.colour) {
        (None, Some(of_file)) => packed(of_file.map(f64::from)),
        _ => colour,
    };
    vec![
        Column::row(COLOUR, Values::Colours(vec![colour])),
        Column::row(TRIANGLES, Values::Triangles(part.triangles.iter().map(around).collect())),
        Column::row(NORMALS, Values::Vectors(part.normals.iter().map(turned).collect())),
        Column::row(POSITIONS, Values::Vectors(part.points.iter().map(scaled).collect())),
    ]
}

/// Ground around the root, so wide.
pub(crate) fn ground(z_m: f64, size_m: f64) -> Vec<Column> {
    const SAND: u32 = 0xd8c0_90ff;
    let thick_m = 0.005 * size_m;
    let sizes = Component::new("Boxes3D", "half_sizes", "HalfSize3D");
    let half = single([size_m, size_m, 0.5 * thick_m]);
    let origin = Isometry3::translation(0.0, 0.0, z_m - 0.5 * thick_m);
    placed("Boxes3D", vec![Column::row(sizes, Values::Vectors(vec![half]))], &origin, SAND)
}

fn cylinder(radius_m: f64, length_m: f64, origin: &Isometry3<f64>, colour: u32) -> Vec<Column> {
    let [radius, length] = single([radius_m, length_m]);
    let lengths = Component::new("Cylinders3D", "lengths", "Length");
    let radii = Component::new("Cylinders3D", "radii", "Radius");
    let column = |component, value| Column::row(component, Values::Single(vec![value]));
    placed("Cylinders3D", vec![column(lengths, length), column(radii, radius)], origin, colour)
}

fn ball(radius_m: f64, origin: &Isometry3<f64>, colour: u32) -> Vec<Column> {
    let sizes = Component::new("Ellipsoids3D", "half_sizes", "HalfSize3D");
    let sizes = Column::row(sizes, Values::Vectors(vec![single([radius_m; 3])]));
    placed("Ellipsoids3D", vec![sizes], origin, colour)
}

/// The shape where it is on its link, in its colour.
fn placed(
    archetype: &'static str,
    mut columns: Vec<Column>,
    origin: &Isometry3<f64>,
    colour: u32,
) -> Vec<Column> {
    let part = |field, kind| Component::new(archetype, field, kind);
    columns.extend([
        Column::row(
            part("centers", "Translation3D"),
            Values::Vectors(vec![single(origin.translation.vector.into())]),
        ),
        Column::row(
            part("quaternions", "RotationQuat"),
            // Without the sign of a zero, which says nothing.
            Values::Quaternions(vec![single(origin.rotation.coords.map(|part| part + 0.0).into())]),
        ),
        Column::row(part("colors", "Color"), Values::Colours(vec![colour])),
        Column::row(part("fill_mode", "FillMode"), Values::Bytes(vec![SOLID])),
    ]);
    columns
}

#[cfg(test)]
mod tests {
    use soilctl_robot::Urdf;

    use super::*;

    #[test]
    fn every_shape_of_the_arm_is_drawn() {
        let text = soilctl_kinematics::urdf(&soilctl_kinematics::Arm::thesis());
        let urdf = Urdf::parse(&text).unwrap();
        let counts: Vec<usize> =
            urdf.links().iter().map(|link| shapes(link, &BTreeMap::new()).len()).collect();
        assert_eq!(counts.iter().sum::<usize>(), text.matches("<visual>").count());
        let of = |name| counts[urdf.link_index(name).unwrap()];
        assert_eq!((of("base_link"), of("hand_link")), (0, 2));
    }

    #[test]
    fn a_capsule_is_a_cylinder_with_two_balls() {
        let text = r#"<robot name="r"><link name="a"><visual><geometry><capsule radius="0.1" length="0.4"/></geometry></visual></link></robot>"#;
        let found = shapes(&Urdf::parse(text).unwrap().links()[0], &BTreeMap::new());
        let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["shape_0", "shape_0_1", "shape_0_2"]);
    }
}
