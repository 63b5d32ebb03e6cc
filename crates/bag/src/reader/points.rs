//! Points of a cloud, out of rows of bytes that the message itself describes (`sensor_msgs/PointCloud2`).

use super::cursor::Cursor;
use super::plan::Part;
use crate::definition::{Base, Definition, Field, Shape, Structure};

/// Numbers of `sensor_msgs/PointField` for what a coordinate may be.
const FLOAT32: u8 = 7;
const FLOAT64: u8 = 8;
/// Channels of a point; the richest sensors have some twenty.
const MOST_CHANNELS: usize = 1000;
/// Plain numbers of a cloud, in the order of `Layout::sizes`.
const SIZES: [&str; 4] = ["height", "width", "point_step", "row_step"];

/// How the bytes of a cloud are laid out, and the bytes.
#[derive(Debug, Default)]
pub(super) struct Layout<'a> {
    /// Name, offset within a point, and number of the type of each channel.
    channels: Vec<(&'a str, usize, u8)>,
    /// Rows, points in a row, bytes of a point and bytes of a row.
    sizes: [usize; 4],
    big: bool,
    data: &'a [u8],
}

/// The fields of a type that is a cloud. `is_dense` is passed over: points that are no numbers are looked for anyway.
pub(super) fn parts(definition: &Definition, structure: &Structure) -> Option<Vec<(usize, Part)>> {
    let (channels, field) = structure.field("fields")?;
    let Base::Structure(number) = field.base else { return None };
    let inner: Vec<_> = definition
        .structure(number)
        .fields
        .iter()
        .map(|field| (field.name.as_str(), field.base, field.shape))
        .collect();
    let channel = [
        ("name", Base::Text, Shape::One),
        ("offset", Base::Uint32, Shape::One),
        ("datatype", Base::Uint8, Shape::One),
        ("count", Base::Uint32, Shape::One),
    ];
    let (data, bytes) = structure.field("data")?;
    let (big, flag) = structure.field("is_bigendian")?;
    let is_list = |field: &Field| matches!(field.shape, Shape::List | Shape::Bounded(_));
    if inner != channel
        || !is_list(field)
        || !is_list(bytes)
        || bytes.base != Base::Uint8
        || flag.shape != Shape::One
        || !matches!(flag.base, Base::Bool | Base::Uint8)
    {
        return None;
    }
    let mut parts = vec![(channels, Part::Channels), (data, Part::Bytes), (big, Part::BigEndian)];
    for (i, name) in SIZES.into_iter().enumerate() {
        let (place, field) = structure.field(name)?;
        if (field.base, field.shape) != (Base::Uint32, Shape::One) {
            return None;
        }
        parts.push((place, Part::Size(i)));
    }
    Some(parts)
}

impl<'a> Layout<'a> {
    pub(super) fn read_channels(&mut self, cursor: &mut Cursor<'a>, most: usize) -> Result<(), String> {
        for _ in 0..cursor.length(most.min(MOST_CHANNELS))? {
            let name = std::str::from_utf8(cursor.text()?).map_err(|_| "a text is not UTF-8".to_owned())?;
            let offset = cursor.u32()? as usize;
            let datatype = cursor.u8()?;
            cursor.u32()?;
            self.channels.push((name, offset, datatype));
        }
        Ok(())
    }

    pub(super) fn read_size(&mut self, cursor: &mut Cursor<'a>, which: usize) -> Result<(), String> {
        let size = cursor.u32()? as usize;
        if let Some(place) = self.sizes.get_mut(which) {
            *place = size;
        }
        Ok(())
    }

    pub(super) fn read_big(&mut self, cursor: &mut Cursor<'a>) -> Result<(), String> {
        self.big = cursor.u8()? != 0;
        Ok(())
    }

    pub(super) fn read_bytes(&mut self, cursor: &mut Cursor<'a>, most: usize) -> Result<(), String> {
        self.data = cursor.bytes(most)?;
        Ok(())
    }

    /// The points with three finite coordinates, and how many have none.
    ///
    /// # Errors
    /// In words: no `x`, `y` or `z`, coordinates that are no floating-point numbers, or sizes that contradict each other.
    pub(super) fn points(&self) -> Result<(Vec<[f64; 3]>, usize), String> {
        let [rows, columns, point_step, row_step] = self.sizes;
        let mut axes = [(0, 0); 3];
        for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
            let found = self.channels.iter().find(|(channel, _, _)| *channel == name);
            let &(_, offset, datatype) =
                found.ok_or_else(|| format!("its points have no channel `{name}`"))?;
            let size = match datatype {
                FLOAT32 => 4,
                FLOAT64 => 8,
                other => {
                    return Err(format!(
                        "channel `{name}` of its points has the type {other}; only 7 (FLOAT32) and 8 (FLOAT64) are read"
                    ));
                }
            };
            if offset.saturating_add(size) > point_step {
                return Err(format!(
                    "channel `{name}` ends at byte {} of a point, which has {point_step}",
                    offset.saturating_add(size)
                ));
            }
            *axis = (offset, size);
        }
        // Of a single row some writers leave the length out.
        let row_bytes = columns.saturating_mul(point_step);
        let need = rows.saturating_sub(1).saturating_mul(row_step).saturating_add(row_bytes);
        if rows > 0 && need > self.data.len() || rows > 1 && row_step < row_bytes {
            return Err(format!(
                "it has {} bytes of points, which do not hold {rows} rows of {columns} points with {point_step} bytes each",
                self.data.len()
            ));
        }
        let (mut points, mut missing) = (Vec::new(), 0);
        // Without columns there is nothing to walk over, however many rows are claimed.
        for row in 0..if columns > 0 { rows } else { 0 } {
            for column in 0..columns {
                let start = row * row_step + column * point_step;
                let point = axes.map(|(offset, size)| self.number(start + offset, size));
                if point.iter().all(|x| x.is_finite()) {
                    points.push(point);
                } else {
                    missing += 1;
                }
            }
        }
        Ok((points, missing))
    }

    fn number(&self, start: usize, size: usize) -> f64 {
        let bytes = self.data.get(start..).unwrap_or_default();
        match (size, bytes.first_chunk::<4>(), bytes.first_chunk::<8>()) {
            (4, Some(&four), _) if self.big => f32::from_be_bytes(four).into(),
            (4, Some(&four), _) => f32::from_le_bytes(four).into(),
            (_, _, Some(&eight)) if self.big => f64::from_be_bytes(eight),
            (_, _, Some(&eight)) => f64::from_le_bytes(eight),
            _ => f64::NAN,
        }
    }
}
