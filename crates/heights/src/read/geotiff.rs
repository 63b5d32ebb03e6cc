//! GeoTIFF (OGC 19-008r4): a raster whose tags say where it is.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use tiff::ColorType;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

use crate::{Grid, HeightMap, HeightsError, MOST_CELLS};

type Input = Decoder<BufReader<File>>;

/// Keys of the directory of keys.
const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;
const LINEAR_UNITS: u16 = 3076;
const VERTICAL_UNITS: u16 = 4099;
/// Their values.
const GEOGRAPHIC: u16 = 2;
const POINTS: u16 = 2;
const METRE: u16 = 9001;
/// GDAL's scale and offset of values, among other things.
const GDAL_METADATA: Tag = Tag::Unknown(42112);

pub(super) fn read(path: &Path, file: &str) -> Result<HeightMap, HeightsError> {
    let input = File::open(path).map_err(|error| HeightsError::file(file, &error))?;
    let wrong = |error: tiff::TiffError| HeightsError::format(file, format!("as a TIFF, {error}"));
    let mut limits = Limits::default();
    limits.decoding_buffer_size = 8 * MOST_CELLS;
    limits.intermediate_buffer_size = 8 * MOST_CELLS;
    let mut input = Decoder::new(BufReader::new(input)).map_err(wrong)?.with_limits(limits);
    let (columns, rows) = input.dimensions().map_err(wrong)?;
    let cells = u64::from(columns) * u64::from(rows);
    if cells > MOST_CELLS as u64 {
        return Err(HeightsError::TooLarge {
            file: file.to_owned(),
            what: "cells",
            count: cells,
            most: MOST_CELLS as u64,
        });
    }
    let color = input.colortype().map_err(wrong)?;
    if !matches!(color, ColorType::Gray(8 | 16 | 32 | 64)) {
        let reason =
            format!("its cells are {color:?}, not one height each; save one band with the heights in m");
        return Err(HeightsError::format(file, reason));
    }
    let grid = place(&mut input, [columns as usize, rows as usize], file)?;
    let said = input.find_tag(GDAL_METADATA).map_err(wrong)?.and_then(|value| value.into_string().ok());
    if said.is_some_and(|text| text.contains("role=\"scale\"") || text.contains("role=\"offset\"")) {
        return Err(HeightsError::format(
            file,
            "its heights have a scale or an offset; save them as they are, in m",
        ));
    }
    let no_data = input.find_tag(Tag::GdalNodata).map_err(wrong)?.and_then(|value| value.into_string().ok());
    let no_data = no_data.map(|text| {
        let number = text.trim().trim_end_matches('\0').trim().parse::<f64>();
        number.map_err(|_| {
            HeightsError::format(file, format!("its value for no data is `{text}`, which is no number"))
        })
    });
    let no_data = no_data.transpose()?;
    let values = values(input.read_image().map_err(wrong)?, no_data);
    if values.len() as u64 != cells {
        return Err(HeightsError::format(file, format!("it has {} of {cells} cells", values.len())));
    }
    HeightMap::new(grid, values)
}

/// Heights without those that stand for no data, which is written with all digits of the type of the cells.
fn values(cells: DecodingResult, no_data: Option<f64>) -> Vec<Option<f64>> {
    fn of<T: Copy>(cells: &[T], number: impl Fn(T) -> f64, no_data: Option<f64>) -> Vec<Option<f64>> {
        let is_data = |z: &f64| !z.is_nan() && no_data.is_none_or(|code| *z != code);
        cells.iter().map(|cell| Some(number(*cell)).filter(is_data)).collect()
    }
    #[allow(clippy::cast_possible_truncation, reason = "the code as a cell of four bytes holds it")]
    let short = no_data.map(|code| f64::from(code as f32));
    match cells {
        DecodingResult::U8(cells) => of(&cells, f64::from, no_data),
        DecodingResult::U16(cells) => of(&cells, f64::from, no_data),
        DecodingResult::U32(cells) => of(&cells, f64::from, no_data),
        DecodingResult::U64(cells) => of(&cells, |x| x as f64, no_data),
        DecodingResult::I8(cells) => of(&cells, f64::from, no_data),
        DecodingResult::I16(cells) => of(&cells, f64::from, no_data),
        DecodingResult::I32(cells) => of(&cells, f64::from, no_data),
        DecodingResult::I64(cells) => of(&cells, |x| x as f64, no_data),
        DecodingResult::F16(cells) => of(&cells, f64::from, no_data),
        DecodingResult::F32(cells) => of(&cells, f64::from, short),
        DecodingResult::F64(cells) => of(&cells, |x| x, no_data),
    }
}

/// Where the cells are, by a tie point and a scale or by a transformation.
fn place(input: &mut Input, size: [usize; 2], file: &str) -> Result<Grid, HeightsError> {
    let wrong = |error: tiff::TiffError| HeightsError::format(file, format!("as a TIFF, {error}"));
    let mut numbers = |tag| -> Result<Option<Vec<f64>>, HeightsError> {
        let value = input.find_tag(tag).map_err(wrong)?;
        value.map(tiff::decoder::ifd::Value::into_f64_vec).transpose().map_err(wrong)
    };
    let (scale, ties) = (numbers(Tag::ModelPixelScaleTag)?, numbers(Tag::ModelTiepointTag)?);
    let matrix = numbers(Tag::ModelTransformationTag)?;
    let keys = input.find_tag(Tag::GeoKeyDirectoryTag).map_err(wrong)?;
    let keys =
        keys.map(tiff::decoder::ifd::Value::into_u16_vec).transpose().map_err(wrong)?.unwrap_or_default();
    // Four numbers a key after a header of four: the key, where its value stands (0: here), how many, and the value.
    let key = |id: u16| {
        keys.chunks_exact(4)
            .skip(1)
            .find(|entry| entry.starts_with(&[id, 0]))
            .and_then(|entry| entry.get(3).copied())
    };
    if key(MODEL_TYPE) == Some(GEOGRAPHIC) {
        return Err(HeightsError::format(
            file,
            "its places are in degrees; project it to metres (gdalwarp -t_srs EPSG:...)",
        ));
    }
    for (id, what) in [(LINEAR_UNITS, "places"), (VERTICAL_UNITS, "heights")] {
        if let Some(unit) = key(id).filter(|unit| *unit != METRE) {
            return Err(HeightsError::format(
                file,
                format!("its {what} are in the unit EPSG {unit}; save it in metres (EPSG {METRE})"),
            ));
        }
    }
    // The corner of the first cell, and steps from column to column and from row to row.
    let (corner, column, row) = match (matrix.as_deref(), scale.as_deref(), ties.as_deref()) {
        (Some(&[a, b, _, d, e, f, _, h, ..]), _, _) => ([d, h], [a, e], [b, f]),
        (None, Some(&[sx, sy, sz]), Some(&[i, j, _, x, y, _])) => {
            if sx.min(sy).is_nan() || sx <= 0.0 || sy <= 0.0 {
                let reason = format!("its ModelPixelScale is {sx} and {sy} m; both must be above 0");
                return Err(HeightsError::format(file, reason));
            }
            if sz != 0.0 && sz != 1.0 {
                return Err(HeightsError::format(
                    file,
                    format!("its heights are scaled by {sz}; save them in m"),
                ));
            }
            ([x - i * sx, y + j * sy], [sx, 0.0], [0.0, -sy])
        }
        _ => {
            return Err(HeightsError::format(
                file,
                "it does not say where it is, by ModelTransformation or by ModelPixelScale and one ModelTiepoint (gdal_translate -a_ullr writes them)",
            ));
        }
    };
    let half = if key(RASTER_TYPE) == Some(POINTS) { 0.0 } else { 0.5 };
    let origin = [0, 1].map(|axis| corner[axis] + half * (column[axis] + row[axis]));
    Grid::new(size, origin, column, row)
}
