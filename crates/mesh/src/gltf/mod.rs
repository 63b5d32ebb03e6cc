//! glTF 2.0, as JSON with its buffers or as one binary file (GLB): triangles, their colours, and where nodes put them.

mod accessor;
mod document;

use nalgebra::{Matrix4, Point3};

use self::accessor::{Buffers, indices, vectors};
use self::document::{Document, Node, Primitive};
use crate::error::Fault;
use crate::shape::{Mesh, Part, is_near};

/// Nodes that are gone through, with those that are there several times.
const MOST_NODES: usize = 20_000;
/// Nodes below one another.
const MOST_DEPTH: usize = 64;
/// Corners and their numbers that are read in all, with those that are read several times.
const MOST_ELEMENTS: u64 = 20_000_000;
/// Triangles: strips and fans are others, lines and points are not drawn.
const TRIANGLES: u64 = 4;

const MAGIC: &[u8; 4] = b"glTF";
const JSON: u32 = 0x4e4f_534a;
const BINARY: u32 = 0x004e_4942;

/// Gives the bytes of another file, by its name beside this one.
pub(crate) type Beside<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// Whether these bytes look like glTF.
pub(crate) fn is_gltf(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || bytes.trim_ascii_start().starts_with(b"{")
}

/// At most so many triangles.
pub(crate) fn read(bytes: &[u8], most: u64, beside: &mut Beside<'_>) -> Result<Mesh, Fault> {
    let (json, binary) = if bytes.starts_with(MAGIC) { split(bytes)? } else { (bytes, None) };
    let document: Document = serde_json::from_slice(json).map_err(|error| Fault::of(error.to_string()))?;
    if !document.asset.version.starts_with("2.") {
        return Err(Fault::of("its version is not 2"));
    }
    let buffers = Buffers::of(&document, binary, beside)?;
    let mut reading =
        Reading { document: &document, buffers, mesh: Mesh::default(), nodes: 0, elements: 0, most };
    for root in roots(&document) {
        // What is up in glTF is y, and z in a URDF.
        reading.node(root, &y_up_to_z_up(), 0)?;
    }
    if reading.mesh.triangles() == 0 {
        return Err(Fault::of("it has no triangle"));
    }
    Ok(reading.mesh)
}

/// JSON and buffer of a binary file.
fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    let word = |at: usize| -> Option<u32> {
        bytes.get(at..at + 4).and_then(|four| <[u8; 4]>::try_from(four).ok()).map(u32::from_le_bytes)
    };
    let (mut at, mut json, mut binary) = (12_usize, None, None);
    while let (Some(length), Some(kind)) = (word(at), word(at.saturating_add(4))) {
        let from = at + 8;
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let chunk =
            bytes.get(from..from.saturating_add(length)).ok_or_else(|| Fault::of("a chunk is cut"))?;
        match kind {
            JSON if json.is_none() => json = Some(chunk),
            BINARY if binary.is_none() => binary = Some(chunk),
            _ => {}
        }
        at = from + length;
    }
    json.map(|json| (json, binary)).ok_or_else(|| Fault::of("it has no JSON"))
}

/// The nodes of the scene that is shown; without scenes all that hang on nothing.
fn roots(document: &Document) -> Vec<usize> {
    if let Some(scene) = document.scenes.get(document.scene.unwrap_or(0)) {
        return scene.nodes.clone();
    }
    let mut hangs = vec![false; document.nodes.len()];
    for child in document.nodes.iter().flat_map(|node| &node.children) {
        if let Some(hangs) = hangs.get_mut(*child) {
            *hangs = true;
        }
    }
    hangs.iter().enumerate().filter(|(_, hangs)| !**hangs).map(|(node, _)| node).collect()
}

fn y_up_to_z_up() -> Matrix4<f64> {
    Matrix4::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
}

struct Reading<'a> {
    document: &'a Document,
    buffers: Buffers,
    mesh: Mesh,
    nodes: usize,
    elements: u64,
    most: u64,
}

impl Reading<'_> {
    fn node(&mut self, number: usize, above: &Matrix4<f64>, depth: usize) -> Result<(), Fault> {
        let document = self.document;
        let node = document.nodes.get(number).ok_or_else(|| Fault::of("a node is not there"))?;
        self.nodes += 1;
        if self.nodes > MOST_NODES || depth > MOST_DEPTH {
            return Err(Fault::of("its nodes are too many, too deep, or a ring"));
        }
        let place = above * Node::place(node);
        let primitives =
            node.mesh.map(|mesh| document.meshes.get(mesh).ok_or_else(|| Fault::of("a mesh is not there")));
        for primitive in primitives.transpose()?.iter().flat_map(|mesh| mesh.primitives.iter()) {
            if primitive.mode.unwrap_or(TRIANGLES) == TRIANGLES {
                self.primitive(primitive, &place)?;
            }
        }
        node.children.iter().try_for_each(|child| self.node(*child, &place, depth + 1))
    }

    fn primitive(&mut self, primitive: &Primitive, place: &Matrix4<f64>) -> Result<(), Fault> {
        let Some(positions) = primitive.attributes.position else { return Ok(()) };
        let accessors = [Some(positions), primitive.indices, primitive.attributes.normal];
        for accessor in accessors.into_iter().flatten() {
            let count = self.document.accessors.get(accessor).map_or(0, |accessor| accessor.count as u64);
            self.elements = self.elements.saturating_add(count);
        }
        if self.elements > MOST_ELEMENTS {
            return Err(Fault::TooMany);
        }
        let points = vectors(self.document, &self.buffers, positions)?;
        let corners: Vec<u32> = match primitive.indices {
            Some(accessor) => indices(self.document, &self.buffers, accessor)?,
            None => (0..u32::try_from(points.len()).unwrap_or(u32::MAX)).collect(),
        };
        if self.mesh.triangles() + corners.len() as u64 / 3 > self.most {
            return Err(Fault::TooMany);
        }
        let given = primitive.attributes.normal;
        let given = given.map(|normal| vectors(self.document, &self.buffers, normal)).transpose()?;
        let mut part = Part { colour: self.colour(primitive), ..Part::default() };
        #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
        let placed = |point: &[f32; 3]| -> [f32; 3] {
            let point = place.transform_point(&Point3::from(*point).cast::<f64>());
            [point.x as f32, point.y as f32, point.z as f32]
        };
        let points: Vec<[f32; 3]> = points.iter().map(placed).collect();
        let normals =
            given.filter(|given| given.len() == points.len()).and_then(|given| turned(&given, place));
        let triangles = corners.chunks_exact(3).filter_map(|three| <[u32; 3]>::try_from(three).ok());
        let at = |corner: u32| points.get(corner as usize).copied();
        match normals {
            Some(normals) if points.iter().all(is_near) => {
                let known = |corner: &u32| (*corner as usize) < points.len();
                let triangles: Vec<[u32; 3]> = triangles.collect();
                if !triangles.iter().flatten().all(known) {
                    return Err(Fault::of("a triangle has a corner that is not there"));
                }
                (part.triangles, part.points, part.normals) = (triangles, points, normals);
            }
            _ => {
                for triangle in triangles {
                    let [a, b, c] = triangle.map(at);
                    let (Some(a), Some(b), Some(c)) = (a, b, c) else {
                        return Err(Fault::of("a triangle has a corner that is not there"));
                    };
                    part.flat([a, b, c]);
                }
            }
        }
        if !part.triangles.is_empty() {
            self.mesh.parts.push(part);
        }
        Ok(())
    }

    fn colour(&self, primitive: &Primitive) -> Option<[f32; 4]> {
        let material = self.document.materials.get(primitive.material?)?;
        let colour = material.roughness.as_ref()?.colour?;
        // It is linear there, and as screens have it everywhere else.
        let [red, green, blue] = [0, 1, 2].map(|k| colour[k].max(0.0).powf(1.0 / 2.2).min(1.0));
        let all = [red, green, blue, colour[3].clamp(0.0, 1.0)];
        all.iter().all(|part| part.is_finite()).then_some(all)
    }
}

/// Normals where a node puts them; nothing if one has no direction.
fn turned(normals: &[[f32; 3]], place: &Matrix4<f64>) -> Option<Vec<[f32; 3]>> {
    let turn = place.fixed_view::<3, 3>(0, 0).into_owned().try_inverse()?.transpose();
    #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
    let turned = |normal: &[f32; 3]| {
        let normal = (turn * nalgebra::Vector3::from(*normal).cast::<f64>()).try_normalize(1e-12)?;
        let normal = [normal.x as f32, normal.y as f32, normal.z as f32];
        normal.iter().all(|part| part.is_finite()).then_some(normal)
    };
    normals.iter().map(turned).collect()
}
