use super::cursor::Cursor;
use super::points::Layout;
use super::{Encoding, Kind, Reading, pass};
use crate::definition::{Base, Definition, Field, Shape};

/// What to do with each field of a type.
#[derive(Debug, Clone, Default)]
pub(super) struct Plan {
    /// Number of the type in its definition.
    pub(super) structure: usize,
    pub(super) fields: Vec<Part>,
}

/// What a field is to a reading.
#[derive(Debug, Clone, Default)]
pub(super) enum Part {
    /// Nothing.
    #[default]
    Other,
    /// It holds some of what is wanted.
    Inside(Plan),
    Stamp,
    Frame,
    Names,
    Positions,
    /// A number of the wrench.
    Number(usize),
    Text,
    /// Channels of a cloud of points.
    Channels,
    /// A size of a cloud.
    Size(usize),
    /// Whether its numbers have their highest byte first.
    BigEndian,
    /// Its points.
    Bytes,
}

/// What was met so far.
#[derive(Default)]
struct Met<'a> {
    /// How deep in the message the stamp stood, and the stamp. The inner one is of the measurement, the outer of who wrapped it.
    stamp: Option<(usize, i64)>,
    frame: Option<(usize, &'a str)>,
    names: Vec<String>,
    positions: Vec<f64>,
    wrench: [f64; 6],
    text: &'a str,
    cloud: Layout<'a>,
}

impl Plan {
    /// What a message says.
    ///
    /// # Errors
    /// In words.
    pub(super) fn read(
        &self,
        kind: Kind,
        definition: &Definition,
        encoding: Encoding,
        data: &[u8],
    ) -> Result<Reading, String> {
        let mut cursor = Cursor::of(encoding, data)?;
        let mut met = Met::default();
        self.walk(definition, encoding, &mut cursor, &mut met, 0)?;
        cursor.end()?;
        let Met { stamp, frame, names, positions, wrench, text, cloud } = met;
        let stamp_ns = stamp.map(|(_, ns)| ns);
        let frame = frame.map(|(_, frame)| frame.to_owned()).unwrap_or_default();
        match kind {
            Kind::Wrench => Ok(Reading::Wrench { stamp_ns, frame, wrench }),
            Kind::Points => {
                let (points, missing) = cloud.points()?;
                Ok(Reading::Points { stamp_ns, frame, points, missing })
            }
            Kind::Text => Ok(Reading::Text(text.to_owned())),
            // ROS allows a joint state to leave positions out.
            Kind::Joints if positions.is_empty() => Err("it has no positions".to_owned()),
            Kind::Joints if positions.len() != names.len() => {
                Err(format!("it has {} names of joints, but {} positions", names.len(), positions.len()))
            }
            Kind::Joints => Ok(Reading::Joints { stamp_ns, names, positions }),
        }
    }

    /// Only the stamp of a message.
    ///
    /// # Errors
    /// In words.
    pub(super) fn stamp_ns(
        &self,
        definition: &Definition,
        encoding: Encoding,
        data: &[u8],
    ) -> Result<Option<i64>, String> {
        let mut met = Met::default();
        self.walk(definition, encoding, &mut Cursor::of(encoding, data)?, &mut met, 0)?;
        Ok(met.stamp.map(|(_, ns)| ns))
    }

    fn walk<'a>(
        &self,
        definition: &Definition,
        encoding: Encoding,
        cursor: &mut Cursor<'a>,
        met: &mut Met<'a>,
        depth: usize,
    ) -> Result<(), String> {
        for (field, part) in definition.structure(self.structure).fields.iter().zip(&self.fields) {
            match part {
                Part::Other => pass::field(definition, cursor, field)?,
                Part::Inside(plan) => plan.walk(definition, encoding, cursor, met, depth + 1)?,
                Part::Stamp => {
                    let ns = cursor.ns(encoding == Encoding::Cdr)?;
                    if ns != 0 && met.stamp.is_none_or(|(known, _)| depth >= known) {
                        met.stamp = Some((depth, ns));
                    }
                }
                Part::Frame => {
                    let frame = text(cursor)?;
                    if !frame.is_empty() && met.frame.is_none_or(|(known, _)| depth >= known) {
                        met.frame = Some((depth, frame));
                    }
                }
                Part::Names => {
                    let count = pass::count(cursor, field.shape)?;
                    met.names =
                        (0..count).map(|_| text(cursor).map(str::to_owned)).collect::<Result<_, _>>()?;
                }
                Part::Positions => {
                    let count = pass::count(cursor, field.shape)?;
                    met.positions = (0..count).map(|_| float(cursor, field)).collect::<Result<_, _>>()?;
                }
                Part::Number(number) => {
                    let value = float(cursor, field)?;
                    if let Some(place) = met.wrench.get_mut(*number) {
                        *place = value;
                    }
                }
                Part::Text => met.text = text(cursor)?,
                Part::Channels => met.cloud.read_channels(cursor, most(field))?,
                Part::Size(which) => met.cloud.read_size(cursor, *which)?,
                Part::BigEndian => met.cloud.read_big(cursor)?,
                Part::Bytes => met.cloud.read_bytes(cursor, most(field))?,
            }
        }
        Ok(())
    }
}

/// The longest that a list may be by its definition.
const fn most(field: &Field) -> usize {
    if let Shape::Bounded(most) = field.shape { most } else { usize::MAX }
}

fn float(cursor: &mut Cursor<'_>, field: &Field) -> Result<f64, String> {
    if field.base == Base::Float32 { cursor.f32().map(f64::from) } else { cursor.f64() }
}

fn text<'a>(cursor: &mut Cursor<'a>) -> Result<&'a str, String> {
    std::str::from_utf8(cursor.text()?).map_err(|_| "a text is not UTF-8".to_owned())
}
