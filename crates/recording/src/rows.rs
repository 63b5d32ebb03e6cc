//! Rows of the recording in the terms of Rerun's archetypes.

use crate::rrd::{Column, Component, Values};

/// Curves: one value each.
pub(crate) fn curves(values: &[f64]) -> Vec<Column> {
    const SCALARS: Component = Component::new("Scalars", "scalars", "Scalar");
    vec![Column::row(SCALARS, Values::Double(values.to_vec()))]
}

/// How curves are drawn, in the order of their values.
pub(crate) fn curve_style(names: &[(&str, u32)]) -> Vec<Column> {
    const NAMES: Component = Component::new("SeriesLines", "names", "Name");
    const COLOURS: Component = Component::new("SeriesLines", "colors", "Color");
    vec![
        Column::row(COLOURS, Values::Colours(names.iter().map(|(_, colour)| *colour).collect())),
        Column::row(NAMES, texts(names.iter().map(|(name, _)| *name))),
    ]
}

/// An arrow from a point; none if a number is not finite.
pub(crate) fn arrow(from: [f64; 3], vector: [f64; 3]) -> Vec<Column> {
    const ORIGINS: Component = Component::new("Arrows3D", "origins", "Position3D");
    const VECTORS: Component = Component::new("Arrows3D", "vectors", "Vector3D");
    let drawn = from.iter().chain(&vector).all(|number| number.is_finite());
    let vectors = |vector| Values::Vectors(if drawn { vec![single(vector)] } else { Vec::new() });
    vec![Column::row(ORIGINS, vectors(from)), Column::row(VECTORS, vectors(vector))]
}

/// Bones from points along vectors.
pub(crate) fn bones(bones: &[([f64; 3], [f64; 3])]) -> Vec<Column> {
    const ORIGINS: Component = Component::new("Arrows3D", "origins", "Position3D");
    const VECTORS: Component = Component::new("Arrows3D", "vectors", "Vector3D");
    let origins = bones.iter().map(|(origin, _)| single(*origin)).collect();
    let vectors = bones.iter().map(|(_, vector)| single(*vector)).collect();
    vec![Column::row(ORIGINS, Values::Vectors(origins)), Column::row(VECTORS, Values::Vectors(vectors))]
}

/// How bones are drawn.
pub(crate) fn bone_style(radius_m: f32) -> Vec<Column> {
    const COLOURS: Component = Component::new("Arrows3D", "colors", "Color");
    const RADII: Component = Component::new("Arrows3D", "radii", "Radius");
    const GREY: u32 = 0x9ea8_b3ff;
    vec![
        Column::row(COLOURS, Values::Colours(vec![GREY])),
        Column::row(RADII, Values::Single(vec![radius_m])),
    ]
}

/// How an arrow is drawn.
pub(crate) fn arrow_style(label: &str, colour: u32, radius_m: f32) -> Vec<Column> {
    const COLOURS: Component = Component::new("Arrows3D", "colors", "Color");
    const LABELS: Component = Component::new("Arrows3D", "labels", "Text");
    const SHOWN: Component = Component::new("Arrows3D", "show_labels", "ShowLabels");
    const RADII: Component = Component::new("Arrows3D", "radii", "Radius");
    vec![
        Column::row(COLOURS, Values::Colours(vec![colour])),
        Column::row(LABELS, texts([label])),
        Column::row(RADII, Values::Single(vec![radius_m])),
        // In the way of the plate; shown when the pointer is on the arrow.
        Column::row(SHOWN, Values::Flags(vec![false])),
    ]
}

/// Triangles from the first corner to each edge between the others, translucent.
pub(crate) fn fan(corners: &[[f64; 3]]) -> Vec<Column> {
    const POSITIONS: Component = Component::new("Mesh3D", "vertex_positions", "Position3D");
    const TRIANGLES: Component = Component::new("Mesh3D", "triangle_indices", "TriangleIndices");
    const COLOUR: Component = Component::new("Mesh3D", "albedo_factor", "AlbedoFactor");
    const GREEN: u32 = 0x2eb5_8073;
    let count = u32::try_from(corners.len()).unwrap_or(0);
    // From both sides.
    let triangles = (1..count.saturating_sub(1)).flat_map(|k| [[0, k, k + 1], [0, k + 1, k]]).collect();
    let colour = if corners.is_empty() { Vec::new() } else { vec![GREEN] };
    vec![
        Column::row(COLOUR, Values::Colours(colour)),
        Column::row(TRIANGLES, Values::Triangles(triangles)),
        Column::row(POSITIONS, Values::Vectors(corners.iter().map(|corner| single(*corner)).collect())),
    ]
}

/// A frame in its parent.
pub(crate) fn transform(origin_m: [f64; 3], quaternion_xyzw: [f64; 4]) -> Vec<Column> {
    const QUATERNION: Component = Component::new("Transform3D", "quaternion", "RotationQuat");
    const TRANSLATION: Component = Component::new("Transform3D", "translation", "Translation3D");
    vec![
        Column::row(QUATERNION, Values::Quaternions(vec![single(quaternion_xyzw)])),
        Column::row(TRANSLATION, Values::Vectors(vec![single(origin_m)])),
    ]
}

/// The scene's axes: x right, y forwards, z up.
pub(crate) fn axes() -> Vec<Column> {
    const AXES: Component = Component::new("ViewCoordinates", "xyz", "ViewCoordinates");
    const RIGHT_FORWARD_UP: [u8; 3] = [3, 5, 1];
    vec![Column::row(AXES, Values::Axes(vec![RIGHT_FORWARD_UP]))]
}

/// A state begins; without a name there is none from now on.
pub(crate) fn state(name: Option<&str>) -> Vec<Column> {
    const STATE: Component = Component::new("StateChange", "state", "Text");
    vec![Column::row(STATE, texts(name))]
}

/// A line of the log of events.
pub(crate) fn line(level: &str, text: &str) -> Vec<Column> {
    const LEVEL: Component = Component::new("TextLog", "level", "TextLogLevel");
    const TEXT: Component = Component::new("TextLog", "text", "Text");
    vec![Column::row(LEVEL, texts([level])), Column::row(TEXT, texts([text]))]
}

/// A page of Markdown.
pub(crate) fn page(markdown: &str) -> Vec<Column> {
    const MEDIA: Component = Component::new("TextDocument", "media_type", "MediaType");
    const TEXT: Component = Component::new("TextDocument", "text", "Text");
    vec![Column::row(MEDIA, texts(["text/markdown"])), Column::row(TEXT, texts([markdown]))]
}

/// The name of the recording in the viewer.
pub(crate) fn name(name: &str) -> Vec<Column> {
    const NAME: Component = Component::new("RecordingInfo", "name", "Name");
    vec![Column::row(NAME, texts([name]))]
}

pub(crate) fn texts<'a>(all: impl IntoIterator<Item = &'a str>) -> Values {
    Values::Texts(all.into_iter().map(str::to_owned).collect())
}

/// Places in the scene have single precision in Rerun.
#[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
pub(crate) fn single<const N: usize>(numbers: [f64; N]) -> [f32; N] {
    numbers.map(|number| number as f32)
}
