use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use csv::ByteRecord;

use crate::cell::shortened;
use crate::read::Records;
use crate::{MAX_ROWS, Place, StrokesError};

/// One sample of a recorded stroke. `None` means not recorded.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TraceSample {
    /// Time in s, on any clock; grows within a stroke.
    pub t_s: f64,
    /// Displacement along the stroke by the external encoders, without compensation, in m.
    pub x_ext_m: f64,
    /// The same by the motors' encoders, in m.
    pub x_mtr_m: Option<f64>,
    /// Magnitude of the force in the plane of travel, tare removed, in N.
    pub force_n: f64,
    /// Inclination of the force to the plate's normal, in deg.
    pub friction_angle_deg: Option<f64>,
    /// Height of the plate's lower edge, up positive, from any datum, in m.
    pub z_m: Option<f64>,
}

/// Traces of strokes, `traces.csv`, by the name of the stroke.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TraceTable {
    strokes: BTreeMap<String, Vec<TraceSample>>,
}

const COLUMNS: [&str; 7] = ["stroke_id", "t_s", "x_ext_m", "x_mtr_m", "force_n", "friction_angle_deg", "z_m"];
/// Columns that may be left out, and whose cells may be empty.
const OPTIONAL: [&str; 3] = ["x_mtr_m", "friction_angle_deg", "z_m"];
/// Greatest magnitude of a number; a clock may count seconds from 1970.
const MOST: f64 = 1e12;

impl TraceTable {
    /// Reads `traces.csv`: a header, then one row a sample, those of a stroke in the order of time. The order of columns is
    /// free, and columns that are not known are left out.
    ///
    /// # Errors
    /// [`StrokesError`] with the line, the column, the offending text and what is allowed.
    pub fn read(path: &Path) -> Result<Self, StrokesError> {
        let name = path.display().to_string();
        let file = File::open(path)
            .map_err(|problem| StrokesError::File { file: name.clone(), problem: problem.to_string() })?;
        Self::from_reader(file, &name)
    }

    /// As [`TraceTable::read`], from any reader; `name` stands for the file in messages.
    ///
    /// # Errors
    /// As [`TraceTable::read`].
    pub fn from_reader(input: impl Read, name: &str) -> Result<Self, StrokesError> {
        let mut records = Records::new(input, name);
        let Some(line) = records.next()? else {
            return Err(StrokesError::EmptyTraces { file: name.into() });
        };
        let header = Header::parse(&records.record, name, line)?;
        let mut strokes: BTreeMap<String, Vec<TraceSample>> = BTreeMap::new();
        let mut rows = 0;
        while let Some(line) = records.next()? {
            rows += 1;
            if rows > MAX_ROWS {
                return Err(StrokesError::TooLarge { file: name.into(), limit: format!("{MAX_ROWS} rows") });
            }
            let row = Row { record: &records.record, header: &header, file: name, line };
            let (id, sample) = row.sample()?;
            match strokes.get_mut(id) {
                Some(samples) => {
                    row.follows(samples.last(), &sample)?;
                    samples.push(sample);
                }
                None => {
                    strokes.insert(id.to_owned(), vec![sample]);
                }
            }
        }
        Ok(Self { strokes })
    }

    /// Traces made by a program, by name of the stroke, each in the order of time.
    #[must_use]
    pub const fn new(strokes: BTreeMap<String, Vec<TraceSample>>) -> Self {
        Self { strokes }
    }

    /// The samples of a stroke in the order of time; `None` if it has none.
    #[must_use]
    pub fn get(&self, stroke_id: &str) -> Option<&[TraceSample]> {
        self.strokes.get(stroke_id).map(Vec::as_slice)
    }

    /// Number of strokes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.strokes.len()
    }

    /// Whether there is no stroke.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.strokes.is_empty()
    }
}

/// Where the known columns are.
struct Header {
    places: [Option<usize>; COLUMNS.len()],
    width: usize,
}

impl Header {
    fn parse(record: &ByteRecord, file: &str, line: usize) -> Result<Self, StrokesError> {
        let names: Vec<String> =
            record.iter().map(|name| String::from_utf8_lossy(name).trim().to_owned()).collect();
        let mut places = [None; COLUMNS.len()];
        for (place, column) in places.iter_mut().zip(COLUMNS) {
            let mut found = (0..names.len()).filter(|&i| names[i] == column);
            *place = found.next();
            if let (Some(first), Some(second)) = (*place, found.next()) {
                return Err(StrokesError::DuplicateColumn {
                    file: file.into(),
                    line,
                    column: column.into(),
                    first: first + 1,
                    second: second + 1,
                });
            }
            if place.is_none() && !OPTIONAL.contains(&column) {
                let found = names.iter().take(40).map(|name| shortened(name)).collect::<Vec<_>>().join(", ");
                let hint = "; the columns of traces are stroke_id, t_s, x_ext_m, force_n and, if recorded, x_mtr_m, \
                            friction_angle_deg, z_m";
                return Err(StrokesError::MissingColumn { file: file.into(), column, found, hint });
            }
        }
        Ok(Self { places, width: names.len() })
    }
}

/// One line.
struct Row<'a> {
    record: &'a ByteRecord,
    header: &'a Header,
    file: &'a str,
    line: usize,
}

impl<'a> Row<'a> {
    fn sample(&self) -> Result<(&'a str, TraceSample), StrokesError> {
        if self.record.len() != self.header.width {
            return Err(StrokesError::Ragged {
                file: self.file.into(),
                line: self.line,
                found: self.record.len(),
                expected: self.header.width,
            });
        }
        let id = self.text(0)?;
        if id.is_empty() {
            return Err(StrokesError::EmptyCell {
                place: self.place(0),
                allowed: "the stroke_id of the stroke table".into(),
            });
        }
        let needed = |column: usize| -> Result<f64, StrokesError> {
            self.number(column)?.ok_or_else(|| StrokesError::EmptyCell {
                place: self.place(column),
                allowed: "a finite number".into(),
            })
        };
        let sample = TraceSample {
            t_s: needed(1)?,
            x_ext_m: needed(2)?,
            x_mtr_m: self.number(3)?,
            force_n: needed(4)?,
            friction_angle_deg: self.number(5)?,
            z_m: self.number(6)?,
        };
        Ok((id, sample))
    }

    fn follows(&self, before: Option<&TraceSample>, sample: &TraceSample) -> Result<(), StrokesError> {
        match before {
            Some(before) if sample.t_s <= before.t_s => Err(StrokesError::OutOfRange {
                place: self.place(1),
                text: sample.t_s.to_string(),
                allowed: format!("above the {} s of the sample before it in this stroke", before.t_s),
            }),
            _ => Ok(()),
        }
    }

    fn place(&self, column: usize) -> Place {
        Place { file: self.file.into(), line: self.line, column: COLUMNS[column].into() }
    }

    fn text(&self, column: usize) -> Result<&'a str, StrokesError> {
        let bytes = self.header.places[column].and_then(|i| self.record.get(i)).unwrap_or_default();
        std::str::from_utf8(bytes).map(str::trim).map_err(|problem| {
            let at = problem.valid_up_to();
            StrokesError::NotUtf8 {
                file: self.file.into(),
                line: self.line,
                cell: format!("column {}", COLUMNS[column]),
                at: at + 1,
                byte: bytes.get(at).copied().unwrap_or_default(),
            }
        })
    }

    fn number(&self, column: usize) -> Result<Option<f64>, StrokesError> {
        let text = self.text(column)?;
        if text.is_empty() {
            return Ok(None);
        }
        let allowed = || format!("a finite number (magnitude up to {MOST:e})");
        let Ok(value) = text.parse::<f64>() else {
            let (place, text) = (self.place(column), shortened(text));
            return Err(StrokesError::NotANumber { place, text, allowed: allowed() });
        };
        if value.is_finite() && value.abs() <= MOST {
            return Ok(Some(value));
        }
        Err(StrokesError::OutOfRange { place: self.place(column), text: shortened(text), allowed: allowed() })
    }
}
