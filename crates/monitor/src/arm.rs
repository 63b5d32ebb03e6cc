//! The arm as pages draw it: bodies on links, and joints between them.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Point3};
use serde::Serialize;
use soilctl_motion::Mesh;
use soilctl_robot::{Geometry, JointKind, Urdf};

/// Bodies that a page draws at most.
const MOST_BODIES: usize = 2000;
/// A pose as a matrix of 4 x 4, column by column.
type Matrix = [f64; 16];
/// Nothing lies further out than this, in m; pages have single precision.
const FURTHEST_M: f64 = 1e6;

/// The arm.
#[derive(Debug, Clone, Default, Serialize)]
pub(crate) struct ArmMessage {
    pub(crate) bodies: Vec<Body>,
    joints: Vec<Joint>,
    /// Place of each body's link in the URDF.
    #[serde(skip)]
    places: Vec<usize>,
}

/// A body on a link.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Body {
    link: String,
    place: Matrix,
    pub(crate) shape: Shape,
    /// Red, green, blue and opacity from 0 to 1; none if the URDF gives none.
    colour: Option<[f64; 4]>,
}

/// What it is like, in m.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(crate) enum Shape {
    Box {
        size: [f64; 3],
    },
    Cylinder {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    Capsule {
        radius: f64,
        length: f64,
    },
    /// The number of a mesh, the factors of its axes, and two corners of the box around it before.
    Mesh {
        number: usize,
        scale: [f64; 3],
        bounds: [[f32; 3]; 2],
    },
}

#[derive(Debug, Clone, Serialize)]
struct Joint {
    name: String,
    parent: String,
    child: String,
    place: Matrix,
    axis: [f64; 3],
    turns: bool,
    slides: bool,
    mimic: Option<Mimic>,
}

#[derive(Debug, Clone, Serialize)]
struct Mimic {
    joint: String,
    factor: f64,
    offset: f64,
}

impl ArmMessage {
    /// Of a URDF, with the meshes by their names that are there.
    pub(crate) fn of(urdf: &Urdf, meshes: &BTreeMap<String, Mesh>) -> Self {
        let mut arm = Self::default();
        for (place, link) in urdf.links().iter().enumerate() {
            for visual in &link.visuals {
                let Some(shape) = shape(&visual.geometry, meshes) else { continue };
                if arm.bodies.len() >= MOST_BODIES {
                    break;
                }
                arm.bodies.push(Body {
                    link: link.name.clone(),
                    place: matrix(&visual.origin),
                    shape,
                    colour: visual.colour,
                });
                arm.places.push(place);
            }
        }
        let name = |link: usize| urdf.links().get(link).map(|link| link.name.clone()).unwrap_or_default();
        let joint = |joint: &soilctl_robot::Joint| Joint {
            name: joint.name.clone(),
            parent: name(joint.parent),
            child: name(joint.child),
            place: matrix(&joint.origin),
            axis: joint.axis.into_inner().into(),
            turns: matches!(joint.kind, JointKind::Revolute | JointKind::Continuous),
            slides: joint.kind == JointKind::Prismatic,
            mimic: joint.mimic.as_ref().map(|mimic| Mimic {
                joint: mimic.joint.clone(),
                factor: mimic.multiplier,
                offset: mimic.offset,
            }),
        };
        // Each after the one that it hangs on.
        let above = urdf.outwards().iter().filter_map(|link| urdf.joints().get(urdf.joint_above(*link)?));
        arm.joints = above.map(joint).collect();
        arm
    }

    /// Extends a space, by its two corners, so that all links at these poses are in it.
    pub(crate) fn extend(&self, poses: &[Option<Isometry3<f64>>], space: &mut [[f64; 3]; 2]) {
        let mut add = |point: Point3<f64>| {
            for (axis, value) in point.iter().enumerate() {
                let value = value.clamp(-FURTHEST_M, FURTHEST_M);
                space[0][axis] = space[0][axis].min(value);
                space[1][axis] = space[1][axis].max(value);
            }
        };
        for pose in poses.iter().flatten() {
            add(pose.translation.vector.into());
        }
        for (body, place) in self.bodies.iter().zip(&self.places) {
            let Some(pose) = poses.get(*place).copied().flatten() else { continue };
            let own = nalgebra::Matrix4::from_column_slice(&body.place);
            let [low, high] = body.shape.bounds();
            for corner in 0..8_u8 {
                let side = |axis: usize| if corner & (1 << axis) == 0 { low[axis] } else { high[axis] };
                let corner = Point3::new(side(0), side(1), side(2));
                add(pose * own.transform_point(&corner));
            }
        }
    }
}

impl Shape {
    /// Two corners of the box around it.
    fn bounds(&self) -> [[f64; 3]; 2] {
        let half = match *self {
            Self::Box { size } => size.map(|edge| 0.5 * edge),
            Self::Cylinder { radius, length } => [radius, radius, 0.5 * length],
            Self::Sphere { radius } => [radius; 3],
            Self::Capsule { radius, length } => [radius, radius, 0.5 * length + radius],
            Self::Mesh { scale, bounds, .. } => {
                return bounds.map(|corner| [0, 1, 2].map(|axis| f64::from(corner[axis]) * scale[axis]));
            }
        };
        [half.map(|part| -part), half]
    }
}

/// None of a mesh that is not there.
fn shape(geometry: &Geometry, meshes: &BTreeMap<String, Mesh>) -> Option<Shape> {
    match *geometry {
        Geometry::Mesh { ref filename, scale } => {
            let bounds = meshes.get(filename)?.bounds_m()?;
            let number = meshes.keys().position(|name| name == filename)?;
            Some(Shape::Mesh { number, scale, bounds })
        }
        Geometry::Box { size_m: size } => Some(Shape::Box { size }),
        Geometry::Cylinder { radius_m: radius, length_m: length } => Some(Shape::Cylinder { radius, length }),
        Geometry::Sphere { radius_m: radius } => Some(Shape::Sphere { radius }),
        Geometry::Capsule { radius_m: radius, length_m: length } => Some(Shape::Capsule { radius, length }),
        _ => None,
    }
}

fn matrix(pose: &Isometry3<f64>) -> Matrix {
    let mut columns = [0.0; 16];
    columns.copy_from_slice(pose.to_homogeneous().as_slice());
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_space_holds_links_and_corners_of_shapes() {
        let text = r#"<robot name="r"><link name="a"/><link name="b"><visual><origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>
            <geometry><box size="4 2 1"/></geometry></visual></link>
            <joint name="j" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/>
            <limit lower="0" upper="9" effort="1" velocity="1"/></joint></robot>"#;
        let urdf = Urdf::parse(text).unwrap();
        let arm = ArmMessage::of(&urdf, &BTreeMap::new());
        let mut space = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        arm.extend(&urdf.link_poses(&|_| Some(5.0)), &mut space);
        // Turned by a quarter, the box is 2 m along x and 4 m along y, at 5 m.
        let expected = [[0.0, -2.0, 0.0], [6.0, 2.0, 1.5]];
        for (found, expected) in space.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-12, "{space:?}");
        }
    }
}
