//! Finds numbers that are no numbers before they are written; JSON itself would turn them into `null`.

use std::fmt::{self, Display};

use serde::ser::{self, Serialize, Serializer};

use crate::AppError;

/// Refuses an answer with NaN or an infinity anywhere inside.
///
/// # Errors
/// [`AppError::NotFinite`] with the key of the number.
pub fn check(answer: &impl Serialize) -> Result<(), AppError> {
    answer.serialize(Walk).map_err(|found| match found {
        Refused::Number { key, value } => AppError::NotFinite { key, value },
        Refused::Other(problem) => AppError::Request(problem),
    })
}

/// Why a walk ended.
#[derive(Debug)]
enum Refused {
    /// A number that is not finite, below this key.
    Number { key: String, value: f64 },
    /// A type that refuses to be serialised.
    Other(String),
}

impl Refused {
    /// The same with one more key in front.
    fn below(self, outer: &str) -> Self {
        match self {
            Self::Number { key, value } if key.is_empty() => Self::Number { key: outer.into(), value },
            Self::Number { key, value } => Self::Number { key: format!("{outer}.{key}"), value },
            other => other,
        }
    }
}

impl Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Refused {}

impl ser::Error for Refused {
    fn custom<T: Display>(message: T) -> Self {
        Self::Other(message.to_string())
    }
}

/// Walks through a value without writing it.
struct Walk;

macro_rules! passes {
    ($($method:ident: $kind:ty),*) => {$(
        fn $method(self, _: $kind) -> Result<(), Refused> {
            Ok(())
        }
    )*};
}

impl Serializer for Walk {
    type Ok = ();
    type Error = Refused;
    type SerializeSeq = Self;
    type SerializeTuple = Self;
    type SerializeTupleStruct = Self;
    type SerializeTupleVariant = Self;
    type SerializeMap = Self;
    type SerializeStruct = Self;
    type SerializeStructVariant = Self;

    passes!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64, serialize_char: char,
        serialize_str: &str, serialize_bytes: &[u8], serialize_unit_struct: &'static str
    );

    fn serialize_f32(self, value: f32) -> Result<(), Refused> {
        self.serialize_f64(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Refused> {
        if value.is_finite() { Ok(()) } else { Err(Refused::Number { key: String::new(), value }) }
    }

    fn serialize_none(self) -> Result<(), Refused> {
        Ok(())
    }

    fn serialize_some<T: ?Sized + Serialize>(self, value: &T) -> Result<(), Refused> {
        value.serialize(Self)
    }

    fn serialize_unit(self) -> Result<(), Refused> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Refused> {
        Ok(())
    }

    fn serialize_newtype_struct<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Refused> {
        value.serialize(Self)
    }

    fn serialize_newtype_variant<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Refused> {
        value.serialize(Self).map_err(|found| found.below(variant))
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_tuple(self, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Refused> {
        Ok(self)
    }
}

macro_rules! walks_items {
    ($($kind:ident: $method:ident),*) => {$(
        impl ser::$kind for Walk {
            type Ok = ();
            type Error = Refused;

            fn $method<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Refused> {
                value.serialize(Walk)
            }

            fn end(self) -> Result<(), Refused> {
                Ok(())
            }
        }
    )*};
}
walks_items!(
    SerializeSeq: serialize_element, SerializeTuple: serialize_element, SerializeTupleStruct: serialize_field,
    SerializeTupleVariant: serialize_field
);

macro_rules! walks_fields {
    ($($kind:ident),*) => {$(
        impl ser::$kind for Walk {
            type Ok = ();
            type Error = Refused;

            fn serialize_field<T: ?Sized + Serialize>(&mut self, key: &'static str, value: &T) -> Result<(), Refused> {
                value.serialize(Walk).map_err(|found| found.below(key))
            }

            fn end(self) -> Result<(), Refused> {
                Ok(())
            }
        }
    )*};
}
walks_fields!(SerializeStruct, SerializeStructVariant);

impl ser::SerializeMap for Walk {
    type Ok = ();
    type Error = Refused;

    fn serialize_key<T: ?Sized + Serialize>(&mut self, _: &T) -> Result<(), Refused> {
        Ok(())
    }

    fn serialize_value<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Refused> {
        value.serialize(Self)
    }

    fn end(self) -> Result<(), Refused> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(serde::Serialize)]
    struct Inner {
        ends: [Option<f64>; 2],
    }

    #[derive(serde::Serialize)]
    #[serde(tag = "kind")]
    enum Outer {
        One { rows: Vec<Inner> },
    }

    #[test]
    fn what_is_not_finite_is_found_by_its_key() {
        let rows = |last| vec![Inner { ends: [None, Some(1.0)] }, Inner { ends: [Some(0.0), Some(last)] }];
        assert!(check(&Outer::One { rows: rows(2.0) }).is_ok());
        let message = check(&Outer::One { rows: rows(f64::NAN) }).unwrap_err().to_string();
        assert!(message.starts_with("rows.ends came out as NaN"), "{message}");
    }
}
