use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::Beside;
use super::document::{Accessor, Document};
use crate::error::Fault;

const BYTE: u64 = 5121;
const SHORT: u64 = 5123;
const WORD: u64 = 5125;
const FLOAT: u64 = 5126;

/// The bytes of all buffers.
pub(super) struct Buffers(Vec<Vec<u8>>);

impl Buffers {
    pub(super) fn of(
        document: &Document,
        binary: Option<&[u8]>,
        beside: &mut Beside<'_>,
    ) -> Result<Self, Fault> {
        const MOST_BUFFERS: usize = 64;
        if document.buffers.len() > MOST_BUFFERS {
            return Err(Fault::of(format!("it has more than {MOST_BUFFERS} buffers")));
        }
        let mut all = Vec::new();
        for (number, buffer) in document.buffers.iter().enumerate() {
            all.push(match (&buffer.uri, binary) {
                (Some(uri), _) if uri.starts_with("data:") => {
                    let packed = uri.split_once(";base64,").map(|(_, packed)| packed);
                    let packed = packed.ok_or_else(|| Fault::of("a buffer is not in base64"))?;
                    STANDARD.decode(packed).map_err(|error| Fault::of(format!("a buffer: {error}")))?
                }
                (Some(uri), _) => beside(uri).map_err(Fault::of)?,
                (None, Some(binary)) if number == 0 => binary.to_vec(),
                (None, _) => return Err(Fault::of("a buffer is not there")),
            });
        }
        Ok(Self(all))
    }
}

/// Vectors of three; at most as many as there are bytes for.
pub(super) fn vectors(document: &Document, buffers: &Buffers, number: usize) -> Result<Vec<[f32; 3]>, Fault> {
    let accessor = accessor(document, number)?;
    if (accessor.kind.as_str(), accessor.component) != ("VEC3", FLOAT) {
        return Err(Fault::of("positions or normals are not three 32-bit numbers each"));
    }
    let elements = elements(document, buffers, accessor, 12)?;
    let value = |bytes: &[u8], axis: usize| {
        let four = bytes.get(4 * axis..4 * axis + 4).and_then(|four| <[u8; 4]>::try_from(four).ok());
        four.map_or(0.0, f32::from_le_bytes)
    };
    Ok(elements.map(|bytes| [0, 1, 2].map(|axis| value(bytes, axis))).collect())
}

/// Whole numbers.
pub(super) fn indices(document: &Document, buffers: &Buffers, number: usize) -> Result<Vec<u32>, Fault> {
    let accessor = accessor(document, number)?;
    let size = match (accessor.kind.as_str(), accessor.component) {
        ("SCALAR", BYTE) => 1,
        ("SCALAR", SHORT) => 2,
        ("SCALAR", WORD) => 4,
        _ => return Err(Fault::of("corners of triangles are no whole numbers")),
    };
    let elements = elements(document, buffers, accessor, size)?;
    Ok(elements.map(|bytes| bytes.iter().rev().fold(0, |sum, byte| (sum << 8) | u32::from(*byte))).collect())
}

fn accessor(document: &Document, number: usize) -> Result<&Accessor, Fault> {
    let found = document.accessors.get(number).ok_or_else(|| Fault::of("an accessor is not there"))?;
    if found.sparse.is_some() {
        return Err(Fault::of("sparse accessors are not read"));
    }
    Ok(found)
}

/// The bytes of each element.
fn elements<'a>(
    document: &Document,
    buffers: &'a Buffers,
    accessor: &Accessor,
    size: usize,
) -> Result<impl Iterator<Item = &'a [u8]> + use<'a>, Fault> {
    let cut = || Fault::of("an accessor reaches beyond its buffer");
    let view = accessor.view.ok_or_else(|| Fault::of("an accessor without bytes is not read"))?;
    let view = document.views.get(view).ok_or_else(|| Fault::of("a view of a buffer is not there"))?;
    let buffer = buffers.0.get(view.buffer).ok_or_else(|| Fault::of("a buffer is not there"))?;
    let end = view.offset.checked_add(view.length).ok_or_else(cut)?;
    let bytes =
        buffer.get(view.offset..end).and_then(|bytes| bytes.get(accessor.offset..)).ok_or_else(cut)?;
    let (stride, count) = (view.stride.unwrap_or(size), accessor.count);
    if stride < size {
        return Err(Fault::of("elements of a view lie over each other"));
    }
    let needed = count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
    if needed.is_none_or(|needed| needed > bytes.len()) {
        return Err(cut());
    }
    Ok(bytes.chunks(stride).take(count).filter_map(move |chunk| chunk.get(..size)))
}
