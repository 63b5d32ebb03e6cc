//! From text to links and joints as the document has them, before it is known if they make a tree.

mod joint;
mod link;
mod shape;

use std::collections::BTreeMap;

use crate::RobotError;
use crate::bounds::{MOST_BYTES, MOST_LINKS};
use crate::model::Link;
use crate::words::cut;
use crate::xml::{Element, Elements};

pub(crate) use joint::Unplaced;

/// What a document says.
pub(crate) struct Read {
    pub(crate) name: String,
    pub(crate) links: Vec<Link>,
    pub(crate) joints: Vec<Unplaced>,
    pub(crate) notes: Vec<String>,
}

/// What is known while reading.
struct Reading<'a> {
    xml: Elements<'a>,
    links: Vec<Link>,
    joints: Vec<Unplaced>,
    visuals: usize,
    colours: Colours,
}

/// Colours by name. A visual may use one that is defined further down.
#[derive(Default)]
struct Colours {
    /// Those of the robot.
    defined: BTreeMap<String, [f64; 4]>,
    /// Those that a visual defines for itself, and other visuals may then use.
    inline: BTreeMap<String, [f64; 4]>,
    /// Link and visual that wait for a colour of that name.
    wanted: Vec<(usize, usize, String)>,
}

pub(crate) fn read(text: &str) -> Result<Read, RobotError> {
    if text.len() > MOST_BYTES {
        return Err(RobotError::TooLong { bytes: text.len() });
    }
    let mut xml = Elements::new(text);
    let robot = xml.child()?;
    let Some(robot) = robot.as_ref().filter(|element| element.name() == "robot") else {
        return Err(RobotError::NotRobot {
            found: robot.map_or_else(String::new, |other| cut(other.name())),
        });
    };
    let [name] = robot.get(["name"])?;
    if name.is_none() {
        xml.notes.add(|| "the robot has no name".to_owned());
    }
    let mut reading =
        Reading { xml, links: Vec::new(), joints: Vec::new(), visuals: 0, colours: Colours::default() };
    reading.robot()?;
    reading.paint();
    let Reading { xml, links, joints, .. } = reading;
    Ok(Read { name: name.unwrap_or_default().into_owned(), links, joints, notes: xml.notes.finish() })
}

impl<'a> Reading<'a> {
    fn robot(&mut self) -> Result<(), RobotError> {
        while let Some(element) = self.xml.child()? {
            match element.name() {
                "link" => self.link(&element)?,
                "joint" => self.joint(&element)?,
                "material" => self.material(&element)?,
                // Transmissions, simulators, controllers: they have joints of their own in them.
                _ => self.xml.skip_foreign()?,
            }
        }
        // Nothing may follow.
        self.xml.child().map(|_| ())
    }

    /// A colour that is defined for the whole robot.
    fn material(&mut self, element: &Element<'a>) -> Result<(), RobotError> {
        let [name] = element.get(["name"])?;
        let colour = shape::colour(&mut self.xml, name.as_deref().unwrap_or_default())?;
        let (Some(name), Some(colour)) = (name, colour) else { return Ok(()) };
        if self.colours.defined.contains_key(&*name) {
            self.xml.notes.add(|| format!("material {:?} is there twice, the first counts", cut(&name)));
        } else if self.colours.defined.len() >= MOST_LINKS {
            return Err(RobotError::TooMany { what: "materials" });
        } else {
            self.colours.defined.insert(name.into_owned(), colour);
        }
        Ok(())
    }

    /// Gives visuals the colours that they name.
    fn paint(&mut self) {
        for (link, visual, name) in &self.colours.wanted {
            let found = self.colours.defined.get(name).or_else(|| self.colours.inline.get(name));
            if found.is_none() {
                self.xml.notes.add(|| format!("material {:?} has no colour", cut(name)));
            }
            if let Some(visual) = self.links.get_mut(*link).and_then(|link| link.visuals.get_mut(*visual)) {
                visual.colour = found.copied();
            }
        }
    }

    /// The name of a link or joint.
    fn named(element: &Element<'a>) -> Result<String, RobotError> {
        let [name] = element.get(["name"])?;
        match name {
            Some(name) if !name.is_empty() => Ok(name.into_owned()),
            _ => Err(RobotError::Missing {
                line: element.line(),
                element: format!("a {}", element.name()),
                missing: "name",
            }),
        }
    }
}
