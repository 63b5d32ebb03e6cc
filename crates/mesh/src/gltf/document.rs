use nalgebra::{Matrix4, Quaternion, Translation3, UnitQuaternion, Vector3};
use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// A list that is not much longer than those of real robots: two letters of JSON may take hundreds of bytes here.
#[derive(Debug)]
pub(super) struct Few<T>(Vec<T>);

impl<T> Few<T> {
    const MOST: usize = 20_000;
}

impl<T> Default for Few<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> std::ops::Deref for Few<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Few<T> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        struct List<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for List<T> {
            type Value = Few<T>;

            fn expecting(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                out.write_str("a list")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut source: A) -> Result<Few<T>, A::Error> {
                let mut all = Vec::new();
                while let Some(next) = source.next_element()? {
                    if all.len() >= Few::<T>::MOST {
                        return Err(A::Error::custom(format_args!(
                            "a list has more than {} parts",
                            Few::<T>::MOST
                        )));
                    }
                    all.push(next);
                }
                Ok(Few(all))
            }
        }
        source.deserialize_seq(List(std::marker::PhantomData))
    }
}

/// What is looked at of the JSON.
#[derive(Debug, Deserialize)]
pub(super) struct Document {
    pub(super) asset: Asset,
    pub(super) scene: Option<usize>,
    #[serde(default)]
    pub(super) scenes: Few<Scene>,
    #[serde(default)]
    pub(super) nodes: Few<Node>,
    #[serde(default)]
    pub(super) meshes: Few<Meshes>,
    #[serde(default)]
    pub(super) materials: Few<Material>,
    #[serde(default)]
    pub(super) accessors: Few<Accessor>,
    #[serde(default, rename = "bufferViews")]
    pub(super) views: Few<View>,
    #[serde(default)]
    pub(super) buffers: Few<Buffer>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Debug, Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Node {
    #[serde(default)]
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

impl Node {
    /// From its frame to the one above.
    pub(super) fn place(&self) -> Matrix4<f64> {
        if let Some(columns) = &self.matrix {
            return Matrix4::from_column_slice(columns);
        }
        let [x, y, z, w] = self.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let turn = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-12).unwrap_or_default();
        let shift = Translation3::from(Vector3::from(self.translation.unwrap_or_default()));
        let scale = Matrix4::new_nonuniform_scaling(&Vector3::from(self.scale.unwrap_or([1.0; 3])));
        shift.to_homogeneous() * turn.to_homogeneous() * scale
    }
}

#[derive(Debug, Deserialize)]
pub(super) struct Meshes {
    pub(super) primitives: Few<Primitive>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) mode: Option<u64>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub(super) normal: Option<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Material {
    #[serde(rename = "pbrMetallicRoughness")]
    pub(super) roughness: Option<Roughness>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Roughness {
    #[serde(rename = "baseColorFactor")]
    pub(super) colour: Option<[f32; 4]>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Accessor {
    #[serde(rename = "bufferView")]
    pub(super) view: Option<usize>,
    #[serde(default, rename = "byteOffset")]
    pub(super) offset: usize,
    #[serde(rename = "componentType")]
    pub(super) component: u64,
    pub(super) count: usize,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<serde::de::IgnoredAny>,
}

#[derive(Debug, Deserialize)]
pub(super) struct View {
    pub(super) buffer: usize,
    #[serde(default, rename = "byteOffset")]
    pub(super) offset: usize,
    #[serde(rename = "byteLength")]
    pub(super) length: usize,
    #[serde(rename = "byteStride")]
    pub(super) stride: Option<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
}
