use super::cursor::Cursor;
use crate::definition::{Base, Definition, Field, Shape, Structure};

/// How many values a field has in this message.
pub(super) fn count(cursor: &mut Cursor<'_>, shape: Shape) -> Result<usize, String> {
    match shape {
        Shape::One => Ok(1),
        Shape::Fixed(count) => Ok(count),
        Shape::Bounded(most) => cursor.length(most),
        Shape::List => cursor.length(usize::MAX),
    }
}

/// Passes over a field.
pub(super) fn field(definition: &Definition, cursor: &mut Cursor<'_>, field: &Field) -> Result<(), String> {
    let count = count(cursor, field.shape)?;
    if let Some(size) = field.base.size() {
        return cursor.pass(size, count);
    }
    match field.base {
        Base::Structure(number) => {
            let inner = definition.structure(number);
            for _ in 0..count {
                structure(definition, cursor, inner)?;
            }
        }
        Base::Text => {
            for _ in 0..count {
                cursor.text()?;
            }
        }
        // Seconds and nanoseconds.
        _ => cursor.pass(4, count.saturating_mul(2))?,
    }
    Ok(())
}

fn structure(definition: &Definition, cursor: &mut Cursor<'_>, inner: &Structure) -> Result<(), String> {
    inner.fields.iter().try_for_each(|inner| field(definition, cursor, inner))
}
