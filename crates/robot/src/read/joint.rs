use nalgebra::{Isometry3, Unit, Vector3};

use super::Reading;
use crate::RobotError;
use crate::bounds::MOST_LINKS;
use crate::model::{Joint, JointKind, Limits, Mimic};
use crate::notes::Notes;
use crate::numbers::{numbers, origin, sound};
use crate::turn::direction;
use crate::words::cut;
use crate::xml::Element;

/// A joint, and the names of links that are yet to be found.
pub(crate) struct Unplaced {
    pub(crate) joint: Joint,
    pub(crate) parent: String,
    pub(crate) child: String,
}

/// The parts of a joint; of several the first counts.
#[derive(Default)]
struct Parts {
    parent: Option<String>,
    child: Option<String>,
    origin: Option<Isometry3<f64>>,
    axis: Option<Unit<Vector3<f64>>>,
    mimic: Option<Mimic>,
    limits: Option<Limits>,
}

impl<'a> Reading<'a> {
    pub(super) fn joint(&mut self, element: &Element<'a>) -> Result<(), RobotError> {
        if self.joints.len() >= MOST_LINKS {
            return Err(RobotError::TooMany { what: "joints" });
        }
        let name = Self::named(element)?;
        let missing = |missing: &'static str| RobotError::Missing {
            line: element.line(),
            element: format!("joint {:?}", cut(&name)),
            missing,
        };
        let [word] = element.get(["type"])?;
        let word = word.ok_or_else(|| missing("type"))?;
        let kind = JointKind::from_word(&word)
            .ok_or_else(|| RobotError::JointType { joint: cut(&name), found: cut(&word) })?;

        let mut parts = Parts::default();
        while let Some(part) = self.xml.child()? {
            let first = parts.take(&part, kind, &name, &mut self.xml.notes)?;
            if !first {
                let part = cut(part.name());
                self.xml
                    .notes
                    .add(|| format!("joint {:?} has a second {part}, the first counts", cut(&name)));
            }
            self.xml.skip()?;
        }
        let parent = parts.parent.ok_or_else(|| missing("parent link"))?;
        let child = parts.child.ok_or_else(|| missing("child link"))?;
        let origin = parts.origin.unwrap_or_else(Isometry3::identity);
        let axis = parts.axis.unwrap_or_else(Vector3::x_axis);
        let (mimic, limits) = (parts.mimic, parts.limits);
        let joint = Joint { name, kind, parent: 0, child: 0, origin, axis, mimic, limits };
        self.joints.push(Unplaced { joint, parent, child });
        Ok(())
    }
}

impl Parts {
    /// Keeps a part; false if there is one of its kind already.
    fn take(
        &mut self,
        part: &Element<'_>,
        kind: JointKind,
        joint: &str,
        notes: &mut Notes,
    ) -> Result<bool, RobotError> {
        let link = || -> Result<Option<String>, RobotError> {
            let [link] = part.get(["link"])?;
            Ok(link.map(std::borrow::Cow::into_owned))
        };
        match part.name() {
            "parent" if self.parent.is_none() => self.parent = link()?,
            "child" if self.child.is_none() => self.child = link()?,
            "origin" if self.origin.is_none() => self.origin = Some(origin(part, "joint", joint)?),
            "axis" if self.axis.is_none() => self.axis = axis(part, kind, joint, notes)?,
            "mimic" if self.mimic.is_none() => self.mimic = mimic(part, kind, joint, notes)?,
            "limit" if self.limits.is_none() => self.limits = limits(part, joint, notes)?,
            "parent" | "child" | "origin" | "axis" | "mimic" | "limit" => return Ok(false),
            _ => {}
        }
        Ok(true)
    }
}

/// The direction of a joint that moves; those of others mean nothing, and some programs write zeros there.
fn axis(
    part: &Element<'_>,
    kind: JointKind,
    joint: &str,
    notes: &mut Notes,
) -> Result<Option<Unit<Vector3<f64>>>, RobotError> {
    let [xyz] = part.get(["xyz"])?;
    let Some(text) = xyz else { return Ok(None) };
    let found = numbers(&text).and_then(direction);
    match found {
        None if kind.has_position() => Err(RobotError::Axis { joint: cut(joint), found: cut(&text) }),
        None => {
            notes.add(|| {
                format!("the {} joint {:?} has an axis without a direction", kind.word(), cut(joint))
            });
            Ok(None)
        }
        Some(axis) => Ok(Some(axis)),
    }
}

fn mimic(
    part: &Element<'_>,
    kind: JointKind,
    joint: &str,
    notes: &mut Notes,
) -> Result<Option<Mimic>, RobotError> {
    if !kind.has_position() {
        notes
            .add(|| format!("the {} joint {:?} mimics another, which does nothing", kind.word(), cut(joint)));
        return Ok(None);
    }
    let [follows, multiplier, offset] = part.get(["joint", "multiplier", "offset"])?;
    let follows = follows.ok_or_else(|| RobotError::Missing {
        line: part.line(),
        element: format!("the mimic of joint {:?}", cut(joint)),
        missing: "joint to follow",
    })?;
    let number = |text: Option<&str>, what: &str, usual: f64| match text {
        Some(text) => sound(text, || format!("{what} of the mimic of joint {:?}", cut(joint)), "one number")
            .map(|[value]| value),
        None => Ok(usual),
    };
    let multiplier = number(multiplier.as_deref(), "multiplier", 1.0)?;
    let offset = number(offset.as_deref(), "offset", 0.0)?;
    Ok(Some(Mimic { joint: follows.into_owned(), multiplier, offset }))
}

/// The range of a joint; nothing depends on it, so one that makes no sense is left out.
fn limits(part: &Element<'_>, joint: &str, notes: &mut Notes) -> Result<Option<Limits>, RobotError> {
    let [lower, upper] = part.get(["lower", "upper"])?;
    if lower.is_none() && upper.is_none() {
        return Ok(None);
    }
    // Zero is what URDF takes where nothing is said.
    let number = |text: Option<&str>| text.map_or(Some([0.0]), numbers::<1>);
    let range = number(lower.as_deref()).zip(number(upper.as_deref()));
    let sound = range
        .map(|([lower], [upper])| Limits { lower, upper })
        .filter(|range| range.lower.is_finite() && range.upper.is_finite() && range.lower <= range.upper);
    if sound.is_none() {
        let [lower, upper] = [lower, upper].map(|text| cut(&text.unwrap_or_default()));
        notes.add(|| {
            format!(
                "the limits of joint {:?} are no range, from {lower:?} to {upper:?}, and are left out",
                cut(joint)
            )
        });
    }
    Ok(sound)
}
