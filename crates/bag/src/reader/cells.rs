//! A message of any type as named cells.

use std::collections::BTreeSet;
use std::fmt::Write;

use soilctl_columns::Cell;

use super::cursor::Cursor;
use super::{parts, pass};
use crate::definition::{Base, Definition, Field, Shape, Structure};

/// Most cells of a message.
const MOST_CELLS: usize = 10_000;
/// Lists of a joint state that have a value a joint.
const JOINT_PARTS: [&str; 3] = ["position", "velocity", "effort"];

/// The cells of a message in order.
///
/// # Errors
/// In words.
pub(super) fn cells(
    definition: &Definition,
    cursor: Cursor<'_>,
    signed: bool,
) -> Result<Vec<(String, Cell<'static>)>, String> {
    let root = definition.root();
    let mut walk = Walk { definition, cursor, signed, name: String::new(), cells: Vec::new() };
    let is_list = |name: &str, base: &[Base]| {
        root.field(name).is_some_and(|(_, field)| base.contains(&field.base) && field.shape != Shape::One)
    };
    let floats = [Base::Float32, Base::Float64];
    if is_list("name", &[Base::Text]) && is_list("position", &floats) {
        walk.joints(root)?;
    } else {
        for field in &root.fields {
            walk.top(field)?;
        }
    }
    walk.cursor.end()?;
    let mut cells = walk.cells;
    part_names(&mut cells);
    Ok(cells)
}

struct Walk<'a> {
    definition: &'a Definition,
    cursor: Cursor<'a>,
    /// Whether seconds of a time have a sign.
    signed: bool,
    name: String,
    cells: Vec<(String, Cell<'static>)>,
}

impl Walk<'_> {
    /// A field of the message itself.
    fn top(&mut self, field: &Field) -> Result<(), String> {
        let (Base::Structure(number), Some(_)) = (field.base, parts::header(self.definition, field)) else {
            return self.field(field);
        };
        for inner in &self.definition.structure(number).fields {
            // The stamp of the header is that of the message.
            if inner.name == "stamp" && self.name.is_empty() {
                self.field(inner)?;
            } else {
                self.below(&field.name, |walk| walk.field(inner))?;
            }
        }
        Ok(())
    }

    /// A joint state: what its lists say of a joint stands under its name; what a message leaves out is not a number.
    fn joints(&mut self, root: &Structure) -> Result<(), String> {
        let mut names = Vec::new();
        let mut lists: Vec<(&str, Vec<f64>)> = Vec::new();
        for field in &root.fields {
            let float = matches!(field.base, Base::Float32 | Base::Float64) && field.shape != Shape::One;
            match JOINT_PARTS.iter().find(|part| **part == field.name) {
                Some(part) if float => {
                    let count = pass::count(&mut self.cursor, field.shape)?;
                    let values = (0..count).map(|_| match field.base {
                        Base::Float32 => self.cursor.f32().map(f64::from),
                        _ => self.cursor.f64(),
                    });
                    lists.push((part, values.collect::<Result<_, _>>()?));
                }
                _ if field.name == "name" => {
                    for _ in 0..pass::count(&mut self.cursor, field.shape)? {
                        names.push(String::from_utf8_lossy(self.cursor.text()?).into_owned());
                    }
                }
                _ => self.top(field)?,
            }
        }
        for (i, name) in names.iter().enumerate() {
            for (part, values) in &lists {
                let value = values.get(i).copied().unwrap_or(f64::NAN);
                self.name.clear();
                self.put(&format!("{name}_{part}"), Cell::Float(value))?;
            }
        }
        Ok(())
    }

    fn below(
        &mut self,
        name: &str,
        inner: impl FnOnce(&mut Self) -> Result<(), String>,
    ) -> Result<(), String> {
        let length = self.name.len();
        if length > 0 {
            self.name.push('_');
        }
        self.name.push_str(name);
        let done = inner(self);
        self.name.truncate(length);
        done
    }

    fn put(&mut self, name: &str, cell: Cell<'static>) -> Result<(), String> {
        if self.cells.len() >= MOST_CELLS {
            return Err(format!("it has more than {MOST_CELLS} values, too many for the columns of a table"));
        }
        self.below(name, |walk| {
            walk.cells.push((walk.name.clone(), cell));
            Ok(())
        })
    }

    fn field(&mut self, field: &Field) -> Result<(), String> {
        match field.shape {
            Shape::One => self.one(&field.name, field.base),
            Shape::Fixed(count) => self
                .below(&field.name, |walk| (0..count).try_for_each(|i| walk.one(&i.to_string(), field.base))),
            Shape::Bounded(_) | Shape::List => {
                let mut text = String::new();
                self.list(field, &mut text)?;
                self.put(&field.name, Cell::Text(text.into()))
            }
        }
    }

    fn one(&mut self, name: &str, base: Base) -> Result<(), String> {
        if let Base::Structure(number) = base {
            let structure = self.definition.structure(number);
            return self.below(name, |walk| structure.fields.iter().try_for_each(|field| walk.field(field)));
        }
        let cell = self.plain(base)?;
        match base {
            Base::Time | Base::Duration => self.put(&format!("{name}_s"), cell),
            _ => self.put(name, cell),
        }
    }

    fn plain(&mut self, base: Base) -> Result<Cell<'static>, String> {
        let cursor = &mut self.cursor;
        Ok(match base {
            Base::Bool => Cell::Flag(cursor.u8()? != 0),
            Base::Int8 => Cell::Integer(cursor.i8()?.into()),
            Base::Uint8 => Cell::Integer(cursor.u8()?.into()),
            Base::Int16 => Cell::Integer(cursor.i16()?.into()),
            Base::Uint16 => Cell::Integer(cursor.u16()?.into()),
            Base::Int32 => Cell::Integer(cursor.i32()?.into()),
            Base::Uint32 => Cell::Integer(cursor.u32()?.into()),
            Base::Int64 => Cell::Integer(cursor.i64()?.into()),
            Base::Uint64 => Cell::Integer(cursor.u64()?.into()),
            Base::Float32 => Cell::Float(cursor.f32()?.into()),
            Base::Float64 => Cell::Float(cursor.f64()?),
            Base::Time => seconds(cursor.ns(self.signed)?),
            Base::Duration => seconds(cursor.ns(true)?),
            // Other programs write text in other encodings, and a table should still show the rest.
            Base::Text | Base::Structure(_) => {
                Cell::Text(String::from_utf8_lossy(cursor.text()?).into_owned().into())
            }
        })
    }

    /// Elements are parted by semicolons, the fields of an element by spaces.
    fn list(&mut self, field: &Field, text: &mut String) -> Result<(), String> {
        for i in 0..pass::count(&mut self.cursor, field.shape)? {
            if i > 0 {
                text.push_str("; ");
            }
            self.element(field.base, text)?;
        }
        Ok(())
    }

    fn element(&mut self, base: Base, text: &mut String) -> Result<(), String> {
        let Base::Structure(number) = base else {
            let cell = self.plain(base)?;
            // Writing to a text cannot fail.
            let _ = write!(text, "{cell}");
            return Ok(());
        };
        for (i, field) in self.definition.structure(number).fields.iter().enumerate() {
            if i > 0 {
                text.push(' ');
            }
            match field.shape {
                Shape::Fixed(count) => {
                    for i in 0..count {
                        if i > 0 {
                            text.push(' ');
                        }
                        self.element(field.base, text)?;
                    }
                }
                _ => self.list(field, text)?,
            }
        }
        Ok(())
    }
}

#[allow(clippy::cast_precision_loss, reason = "a hundredth of a tick after 285 years")]
fn seconds(ns: i64) -> Cell<'static> {
    Cell::Float(ns as f64 / 1e9)
}

/// Tables need different names: `a_b` may be a field and also the field `b` of the field `a`, and joints may share a name.
fn part_names(cells: &mut [(String, Cell<'static>)]) {
    let mut taken = BTreeSet::new();
    for (name, _) in cells {
        let mut number = 2;
        let plain = name.clone();
        while !taken.insert(name.clone()) {
            *name = format!("{plain}_{number}");
            number += 1;
        }
    }
}
