//! Columns of a chunk: one component of Rerun's data model each, a list of values a row.

use std::sync::Arc;

use arrow_array::{
    ArrayRef, BooleanArray, FixedSizeListArray, Float32Array, Float64Array, StringArray, UInt8Array,
    UInt32Array,
};
use arrow_schema::{ArrowError, Field};

/// A field of one of Rerun's archetypes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Component {
    archetype: &'static str,
    field: &'static str,
    kind: &'static str,
    is_layout: bool,
    kind_is_layout: bool,
}

impl Component {
    /// Of the archetype `rerun.archetypes.ARCHETYPE`, with values of the type `rerun.components.KIND`.
    pub(crate) const fn new(archetype: &'static str, field: &'static str, kind: &'static str) -> Self {
        Self { archetype, field, kind, is_layout: false, kind_is_layout: false }
    }

    /// The same of a layout, with values of a type that only layouts have.
    pub(crate) const fn layout(archetype: &'static str, field: &'static str, kind: &'static str) -> Self {
        Self { archetype, field, kind, is_layout: true, kind_is_layout: true }
    }

    /// A name in a layout, which has the type of all names.
    pub(crate) const fn layout_name(archetype: &'static str, field: &'static str) -> Self {
        Self { archetype, field, kind: "Name", is_layout: true, kind_is_layout: false }
    }

    pub(super) fn archetype(self) -> String {
        let group = if self.is_layout { "rerun.blueprint.archetypes" } else { "rerun.archetypes" };
        format!("{group}.{}", self.archetype)
    }

    pub(super) fn name(self) -> String {
        format!("{}:{}", self.archetype, self.field)
    }

    pub(super) fn kind(self) -> String {
        let group = if self.kind_is_layout { "rerun.blueprint.components" } else { "rerun.components" };
        format!("{group}.{}", self.kind)
    }
}

/// Values of all rows, one after the other.
#[derive(Debug, Clone)]
pub(crate) enum Values {
    Flags(Vec<bool>),
    Bytes(Vec<u8>),
    Colours(Vec<u32>),
    Single(Vec<f32>),
    Double(Vec<f64>),
    Texts(Vec<String>),
    /// Vectors of three.
    Vectors(Vec<[f32; 3]>),
    /// Quaternions x, y, z, w.
    Quaternions(Vec<[f32; 4]>),
    /// Numbers of the corners of triangles.
    Triangles(Vec<[u32; 3]>),
    /// Directions of the axes of a scene.
    Axes(Vec<[u8; 3]>),
    /// Ids in layouts.
    Ids(Vec<[u8; 16]>),
}

/// A component, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    pub(super) component: Component,
    pub(super) values: Values,
    /// Where each row ends among the values, from 0.
    pub(super) ends: Vec<i32>,
}

impl Column {
    /// A column of one row.
    pub(crate) fn row(component: Component, values: Values) -> Self {
        let mut column = Self { component, ends: vec![0], values };
        column.end_row();
        column
    }

    /// Appends the rows of another column of the same component.
    pub(super) fn append(&mut self, other: Self) {
        let before = self.ends.last().copied().unwrap_or(0);
        self.ends.extend(other.ends.into_iter().skip(1).map(|end| before + end));
        match (&mut self.values, other.values) {
            (Values::Flags(all), Values::Flags(more)) => all.extend(more),
            (Values::Bytes(all), Values::Bytes(more)) => all.extend(more),
            (Values::Colours(all), Values::Colours(more)) => all.extend(more),
            (Values::Single(all), Values::Single(more)) => all.extend(more),
            (Values::Double(all), Values::Double(more)) => all.extend(more),
            (Values::Texts(all), Values::Texts(more)) => all.extend(more),
            (Values::Vectors(all), Values::Vectors(more)) => all.extend(more),
            (Values::Quaternions(all), Values::Quaternions(more)) => all.extend(more),
            (Values::Triangles(all), Values::Triangles(more)) => all.extend(more),
            (Values::Axes(all), Values::Axes(more)) => all.extend(more),
            (Values::Ids(all), Values::Ids(more)) => all.extend(more),
            // A component has one type of values, so this is never reached; the row would be an empty one.
            _ => {
                self.ends.pop();
                self.end_row();
            }
        }
    }

    fn end_row(&mut self) {
        self.ends.push(i32::try_from(self.values.len()).unwrap_or(i32::MAX));
    }

    pub(super) fn array(&self) -> Result<ArrayRef, ArrowError> {
        Ok(match &self.values {
            Values::Flags(all) => Arc::new(BooleanArray::from(all.clone())),
            Values::Bytes(all) => Arc::new(UInt8Array::from(all.clone())),
            Values::Colours(all) => Arc::new(UInt32Array::from(all.clone())),
            Values::Single(all) => Arc::new(Float32Array::from(all.clone())),
            Values::Double(all) => Arc::new(Float64Array::from(all.clone())),
            Values::Texts(all) => Arc::new(StringArray::from(all.clone())),
            Values::Vectors(all) => fixed(3, Arc::new(Float32Array::from(all.as_flattened().to_vec())))?,
            Values::Quaternions(all) => fixed(4, Arc::new(Float32Array::from(all.as_flattened().to_vec())))?,
            Values::Triangles(all) => fixed(3, Arc::new(UInt32Array::from(all.as_flattened().to_vec())))?,
            Values::Axes(all) => fixed(3, Arc::new(UInt8Array::from(all.as_flattened().to_vec())))?,
            Values::Ids(all) => fixed(16, Arc::new(UInt8Array::from(all.as_flattened().to_vec())))?,
        })
    }
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Flags(all) => all.len(),
            Self::Bytes(all) => all.len(),
            Self::Colours(all) => all.len(),
            Self::Single(all) => all.len(),
            Self::Double(all) => all.len(),
            Self::Texts(all) => all.len(),
            Self::Vectors(all) => all.len(),
            Self::Quaternions(all) => all.len(),
            Self::Triangles(all) => all.len(),
            Self::Axes(all) => all.len(),
            Self::Ids(all) => all.len(),
        }
    }
}

fn fixed(width: i32, parts: ArrayRef) -> Result<ArrayRef, ArrowError> {
    let item = Arc::new(Field::new("item", parts.data_type().clone(), false));
    Ok(Arc::new(FixedSizeListArray::try_new(item, width, parts, None)?))
}
