use nalgebra::Isometry3;

use super::{Reading, shape};
use crate::RobotError;
use crate::bounds::MOST_LINKS;
use crate::model::{Link, Visual};
use crate::numbers::origin;
use crate::words::cut;
use crate::xml::Element;

impl<'a> Reading<'a> {
    pub(super) fn link(&mut self, element: &Element<'a>) -> Result<(), RobotError> {
        if self.links.len() >= MOST_LINKS {
            return Err(RobotError::TooMany { what: "links" });
        }
        let name = Self::named(element)?;
        let mut visuals = Vec::new();
        while let Some(part) = self.xml.child()? {
            if part.name() == "visual" {
                let place = visuals.len();
                visuals.extend(self.visual(&name, place)?);
            } else {
                self.xml.skip()?;
            }
        }
        self.links.push(Link { name, visuals });
        Ok(())
    }

    /// One shape, which will be at `place` among those of its link; `None` if nothing can be drawn of it.
    fn visual(&mut self, link: &str, place: usize) -> Result<Option<Visual>, RobotError> {
        if self.visuals >= MOST_LINKS {
            return Err(RobotError::TooMany { what: "visuals" });
        }
        self.visuals += 1;
        let (mut pose, mut geometry, mut material) = (None, None, None);
        while let Some(part) = self.xml.child()? {
            match part.name() {
                "origin" if pose.is_none() => {
                    pose = Some(origin(&part, "a visual of link", link)?);
                    self.xml.skip()?;
                }
                "geometry" if geometry.is_none() => geometry = shape::geometry(&mut self.xml, link)?,
                "material" if material.is_none() => {
                    let [name] = part.get(["name"])?;
                    let name = name.unwrap_or_default().into_owned();
                    material = Some((shape::colour(&mut self.xml, &name)?, name));
                }
                _ => self.xml.skip()?,
            }
        }
        let Some(geometry) = geometry else {
            self.xml.notes.add(|| format!("a visual of link {:?} has no shape to draw", cut(link)));
            return Ok(None);
        };
        let colour =
            material.and_then(|(colour, name)| self.material_of((self.links.len(), place), colour, name));
        Ok(Some(Visual { origin: pose.unwrap_or_else(Isometry3::identity), geometry, colour }))
    }

    /// The colour of a visual, if it is known yet; otherwise it is asked for by its name.
    fn material_of(
        &mut self,
        (link, visual): (usize, usize),
        colour: Option<[f64; 4]>,
        name: String,
    ) -> Option<[f64; 4]> {
        match colour {
            Some(colour) if !name.is_empty() => {
                self.colours.inline.entry(name).or_insert(colour);
            }
            None if !name.is_empty() => self.colours.wanted.push((link, visual, name)),
            _ => {}
        }
        colour
    }
}
