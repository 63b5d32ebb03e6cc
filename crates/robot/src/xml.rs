//! Elements of a document one after another, without a tree of them, without recursion, and without the entities of a
//! document type, which could expand without bound.

use std::borrow::Cow;

use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use crate::RobotError;
use crate::bounds::MOST_DEPTH;
use crate::notes::Notes;
use crate::words::{cut, cut_at};

/// Problems repeat names of the document, which may have any length.
const LONGEST_PROBLEM: usize = 300;

/// Walks through the elements of a document.
pub(crate) struct Elements<'a> {
    reader: Reader<&'a [u8]>,
    text: &'a str,
    depth: usize,
    /// The outermost element is there.
    rooted: bool,
    /// Inside an element that belongs to other programs, which may have attributes of any form.
    foreign: bool,
    pub(crate) notes: Notes,
}

/// An element's start.
pub(crate) struct Element<'a> {
    start: BytesStart<'a>,
    text: &'a str,
    at: usize,
}

/// What a walk comes to.
enum Step<'a> {
    Start(Element<'a>),
    End,
    Eof,
}

impl<'a> Elements<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        let mut reader = Reader::from_str(text);
        reader.config_mut().expand_empty_elements = true;
        Self { reader, text, depth: 0, rooted: false, foreign: false, notes: Notes::default() }
    }

    /// The next element inside the one that was last begun and is not over; `None` at its end.
    ///
    /// Each element that is returned must be read to its end, by this or by one of the two below.
    pub(crate) fn child(&mut self) -> Result<Option<Element<'a>>, RobotError> {
        match self.step()? {
            Step::Start(element) => Ok(Some(element)),
            Step::End | Step::Eof => Ok(None),
        }
    }

    /// Passes over what is inside the element that was last begun.
    pub(crate) fn skip(&mut self) -> Result<(), RobotError> {
        let around = self.depth.saturating_sub(1);
        while self.depth > around {
            self.step()?;
        }
        Ok(())
    }

    /// Passes over what belongs to other programs.
    pub(crate) fn skip_foreign(&mut self) -> Result<(), RobotError> {
        self.foreign = true;
        let skipped = self.skip();
        self.foreign = false;
        skipped
    }

    fn step(&mut self) -> Result<Step<'a>, RobotError> {
        loop {
            let at = usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX);
            let event = self.reader.read_event().map_err(|error| {
                let at = usize::try_from(self.reader.error_position()).unwrap_or(at);
                xml_error(self.text, at, &error.to_string())
            })?;
            let wrong = |problem: &str| Err(xml_error(self.text, at, problem));
            match event {
                Event::Start(start) | Event::Empty(start) => {
                    if self.depth == 0 && self.rooted {
                        return wrong("there is a second outermost element; a document has one");
                    }
                    self.rooted = true;
                    self.depth += 1;
                    if self.depth > MOST_DEPTH {
                        return Err(RobotError::TooDeep { line: line(self.text, at) });
                    }
                    let element = Element { start, text: self.text, at };
                    element.refuse_xacro(self.foreign)?;
                    return Ok(Step::Start(element));
                }
                Event::End(_) => {
                    self.depth = self.depth.saturating_sub(1);
                    return Ok(Step::End);
                }
                Event::Eof if self.depth > 0 => {
                    return wrong("it ends in the middle of an element; is the file complete?");
                }
                Event::Eof => return Ok(Step::Eof),
                Event::Text(text) if self.depth == 0 && !text.trim().is_empty() => {
                    return wrong("there is text outside of the outermost element");
                }
                Event::CData(_) if self.depth == 0 => {
                    return wrong("there is text outside of the outermost element");
                }
                Event::GeneralRef(reference) => {
                    if self.depth == 0 || !is_known(&reference) {
                        let name = cut(&reference);
                        return wrong(&format!(
                            "&{name}; stands for nothing that is known; document types are not read, so write it out"
                        ));
                    }
                }
                Event::DocType(_) => {
                    self.notes
                        .add(|| "the document type is not read; what it declares is left out".to_owned());
                }
                Event::Text(_) | Event::CData(_) | Event::Comment(_) | Event::Decl(_) | Event::PI(_) => {}
            }
        }
    }
}

impl Element<'_> {
    /// Its name with its prefix, as it is written.
    pub(crate) fn name(&self) -> &str {
        self.start.name().into_inner()
    }

    /// The line it begins on, from 1. It is counted from the beginning, so only for messages.
    pub(crate) fn line(&self) -> usize {
        line(self.text, self.at)
    }

    /// The values of some attributes.
    pub(crate) fn get<const N: usize>(
        &self,
        names: [&str; N],
    ) -> Result<[Option<Cow<'_, str>>; N], RobotError> {
        let wrong = |problem: &str| xml_error(self.text, self.at, problem);
        let mut values = [const { None }; N];
        // The reader's own check for repeated attributes takes memory for each of them.
        for attribute in self.start.attributes().with_checks(false) {
            let attribute = attribute.map_err(|error| wrong(&error.to_string()))?;
            let key = attribute.key.into_inner();
            let Some(value) =
                names.iter().zip(&mut values).find_map(|(name, value)| (*name == key).then_some(value))
            else {
                continue;
            };
            if value.is_some() {
                return Err(wrong(&format!("the attribute {key} is there twice in one element")));
            }
            let text = attribute
                .normalized_value(XmlVersion::Implicit1_0)
                .map_err(|error| wrong(&error.to_string()))?;
            *value = Some(text);
        }
        Ok(values)
    }

    fn refuse_xacro(&self, foreign: bool) -> Result<(), RobotError> {
        let refuse = |found: &str| Err(RobotError::Xacro { line: self.line(), found: cut(found) });
        if self.name().starts_with("xacro:") {
            return refuse(self.name());
        }
        let attributes = self.start.attributes_raw();
        match ["${", "$("].iter().find_map(|sign| attributes.find(sign)) {
            Some(from) if !foreign => refuse(attributes.get(from..).unwrap_or_default()),
            _ => Ok(()),
        }
    }
}

/// Whether a reference stands for a character that XML itself knows.
fn is_known(reference: &BytesRef<'_>) -> bool {
    match reference.resolve_char_ref() {
        Ok(Some(_)) => true,
        Ok(None) => quick_xml::escape::resolve_xml_entity(reference).is_some(),
        Err(_) => false,
    }
}

fn xml_error(text: &str, at: usize, problem: &str) -> RobotError {
    RobotError::Xml { line: line(text, at), problem: cut_at(problem, LONGEST_PROBLEM) }
}

fn line(text: &str, at: usize) -> usize {
    1 + text.bytes().take(at).filter(|byte| *byte == b'\n').count()
}
