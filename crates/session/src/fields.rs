//! A message as named cells: for tables, and to say which field of two messages differs.

use serde::Serialize;
use serde::ser::{self, Serializer};
use soilctl_columns::Cell;

/// The cells of a message in order. Arrays of fixed length become one cell an element, `name_0` and so on; lists of
/// variable length one cell.
pub(crate) fn cells<T: Serialize>(message: &T) -> Vec<(String, Cell<'static>)> {
    let mut walk = Walk { name: String::new(), cells: Vec::new() };
    // Nothing in a walk fails: messages hold none of the types that are refused.
    let _ = message.serialize(&mut walk);
    walk.cells
}

struct Walk {
    name: String,
    cells: Vec<(String, Cell<'static>)>,
}

impl Walk {
    fn put(&mut self, cell: Cell<'static>) -> Result<(), std::fmt::Error> {
        self.cells.push((self.name.clone(), cell));
        Ok(())
    }

    fn below<T: Serialize + ?Sized>(&mut self, name: &str, value: &T) -> Result<(), std::fmt::Error> {
        let length = self.name.len();
        if length > 0 {
            self.name.push('_');
        }
        self.name.push_str(name);
        let done = value.serialize(&mut *self);
        self.name.truncate(length);
        done
    }
}

/// The elements of a list or array.
struct Elements<'a> {
    walk: &'a mut Walk,
    count: usize,
    /// Where the cells of a list of variable length begin.
    list_from: Option<usize>,
}

impl Elements<'_> {
    fn element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), std::fmt::Error> {
        let name = self.count.to_string();
        self.count += 1;
        self.walk.below(&name, value)
    }

    /// Elements of a list are parted by semicolons, the fields of an element by spaces.
    fn end(self) -> Result<(), std::fmt::Error> {
        let Some(from) = self.list_from else { return Ok(()) };
        let prefix = if self.walk.name.is_empty() { 0 } else { self.walk.name.len() + 1 };
        let mut text = String::new();
        let mut element = String::new();
        for (name, cell) in self.walk.cells.split_off(from) {
            let number =
                name.get(prefix..).unwrap_or_default().split('_').next().unwrap_or_default().to_owned();
            if !text.is_empty() {
                text.push_str(if number == element { " " } else { "; " });
            }
            text += &cell.to_string();
            element = number;
        }
        self.walk.put(Cell::Text(text.into()))
    }
}

macro_rules! scalar {
    ($($method:ident: $kind:ty => $cell:expr),* $(,)?) => {$(
        fn $method(self, value: $kind) -> Result<(), Self::Error> {
            #[allow(clippy::redundant_closure_call, reason = "one line a type")]
            self.put($cell(value))
        }
    )*};
}

macro_rules! refused {
    ($($method:ident($($kind:ty),*) -> $done:ty),* $(,)?) => {$(
        fn $method(self, $(_: $kind),*) -> Result<$done, Self::Error> {
            Err(std::fmt::Error)
        }
    )*};
}

impl<'a> Serializer for &'a mut Walk {
    type Ok = ();
    type Error = std::fmt::Error;
    type SerializeSeq = Elements<'a>;
    type SerializeTuple = Elements<'a>;
    type SerializeTupleStruct = ser::Impossible<(), Self::Error>;
    type SerializeTupleVariant = ser::Impossible<(), Self::Error>;
    type SerializeMap = ser::Impossible<(), Self::Error>;
    type SerializeStruct = &'a mut Walk;
    type SerializeStructVariant = ser::Impossible<(), Self::Error>;

    scalar! {
        serialize_bool: bool => Cell::Flag,
        serialize_i8: i8 => |v| Cell::Integer(i128::from(v)),
        serialize_i16: i16 => |v| Cell::Integer(i128::from(v)),
        serialize_i32: i32 => |v| Cell::Integer(i128::from(v)),
        serialize_i64: i64 => |v| Cell::Integer(i128::from(v)),
        serialize_u8: u8 => |v| Cell::Integer(i128::from(v)),
        serialize_u16: u16 => |v| Cell::Integer(i128::from(v)),
        serialize_u32: u32 => |v| Cell::Integer(i128::from(v)),
        serialize_u64: u64 => |v| Cell::Integer(i128::from(v)),
        serialize_f32: f32 => |v| Cell::Float(f64::from(v)),
        serialize_f64: f64 => Cell::Float,
        serialize_str: &str => |v: &str| Cell::Text(v.to_owned().into()),
    }

    refused! {
        serialize_char(char) -> (),
        serialize_bytes(&[u8]) -> (),
        serialize_none() -> (),
        serialize_unit() -> (),
        serialize_unit_struct(&'static str) -> (),
        serialize_unit_variant(&'static str, u32, &'static str) -> (),
        serialize_tuple_struct(&'static str, usize) -> Self::SerializeTupleStruct,
        serialize_tuple_variant(&'static str, u32, &'static str, usize) -> Self::SerializeTupleVariant,
        serialize_map(Option<usize>) -> Self::SerializeMap,
        serialize_struct_variant(&'static str, u32, &'static str, usize) -> Self::SerializeStructVariant,
    }

    fn serialize_some<T: Serialize + ?Sized>(self, _: &T) -> Result<(), Self::Error> {
        Err(std::fmt::Error)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Self::Error> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: &T,
    ) -> Result<(), Self::Error> {
        Err(std::fmt::Error)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Elements<'a>, Self::Error> {
        let list_from = Some(self.cells.len());
        Ok(Elements { walk: self, count: 0, list_from })
    }

    fn serialize_tuple(self, _: usize) -> Result<Elements<'a>, Self::Error> {
        Ok(Elements { walk: self, count: 0, list_from: None })
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, Self::Error> {
        Ok(self)
    }
}

impl ser::SerializeSeq for Elements<'_> {
    type Ok = ();
    type Error = std::fmt::Error;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Self::Error> {
        self.element(value)
    }

    fn end(self) -> Result<(), Self::Error> {
        Elements::end(self)
    }
}

impl ser::SerializeTuple for Elements<'_> {
    type Ok = ();
    type Error = std::fmt::Error;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Self::Error> {
        self.element(value)
    }

    fn end(self) -> Result<(), Self::Error> {
        Elements::end(self)
    }
}

impl ser::SerializeStruct for &mut Walk {
    type Ok = ();
    type Error = std::fmt::Error;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), Self::Error> {
        self.below(name, value)
    }

    fn end(self) -> Result<(), Self::Error> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::{ControllerStep, EventMessage};

    #[test]
    fn arrays_are_cells_and_lists_are_one() {
        let event = |kind: &str| EventMessage { kind: kind.to_owned(), index: 2, value: 0.5, limit: 0.0 };
        let message = ControllerStep {
            events: vec![event("homed"), event("fault/tip_force")],
            request_numbers: vec![1.0, f64::NAN],
            ..ControllerStep::default()
        };
        let cells = cells(&message);
        let find = |name: &str| cells.iter().find(|(key, _)| key == name).map(|(_, cell)| cell.clone());
        assert_eq!(find("events"), Some(Cell::Text("homed 2 0.5 0; fault/tip_force 2 0.5 0".into())));
        assert_eq!(find("request_numbers"), Some(Cell::Text("1; NaN".into())));
        assert_eq!(find("motor_counts_4"), Some(Cell::Integer(0)));
        assert_eq!(find("motor_counts_5"), None);
    }
}
