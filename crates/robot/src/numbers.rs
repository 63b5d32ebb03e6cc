//! Numbers in attributes.

use nalgebra::{Isometry3, Translation3};

use crate::RobotError;
use crate::bounds::MOST_SIZE;
use crate::turn::from_rpy;
use crate::words::cut;
use crate::xml::Element;

/// As many numbers as asked for, with any white space around and between them; `None` if there are more, fewer, or
/// anything else. They need not be finite.
pub(crate) fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let mut words = text.split_whitespace();
    let mut values = [0.0; N];
    for value in &mut values {
        *value = words.next()?.parse().ok()?;
    }
    words.next().is_none().then_some(values)
}

/// Whether all are finite and of a size that lengths, angles and factors of robots have.
pub(crate) fn are_sound(values: &[f64]) -> bool {
    values.iter().all(|value| value.abs() <= MOST_SIZE)
}

/// As [`numbers`], and an error that says where it was if they are no sound numbers.
pub(crate) fn sound<const N: usize>(
    text: &str,
    what: impl FnOnce() -> String,
    allowed: &'static str,
) -> Result<[f64; N], RobotError> {
    numbers(text).filter(|values| are_sound(values)).ok_or_else(|| RobotError::Number {
        what: what(),
        found: cut(text),
        allowed,
    })
}

/// The pose in an element `origin` of the named joint or link.
pub(crate) fn origin(element: &Element<'_>, kind: &str, name: &str) -> Result<Isometry3<f64>, RobotError> {
    let [xyz, rpy] = element.get(["xyz", "rpy"])?;
    let three = |text: Option<&str>, part: &str, allowed| match text {
        Some(text) => sound(text, || format!("{part} of the origin of {kind} {:?}", cut(name)), allowed),
        None => Ok([0.0; 3]),
    };
    let [x, y, z] = three(xyz.as_deref(), "xyz", "three numbers in m such as \"0 0 0.1\"")?;
    let rpy = three(rpy.as_deref(), "rpy", "three numbers in rad such as \"0 0 1.57\"")?;
    Ok(Isometry3::from_parts(Translation3::new(x, y, z), from_rpy(rpy)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_many_as_asked_for() {
        assert_eq!(numbers("1 -2.5e-3 .5"), Some([1.0, -2.5e-3, 0.5]));
        assert_eq!(numbers(" \t+1.\u{a0}\n2\u{2003}3\r"), Some([1.0, 2.0, 3.0]));
        for text in ["", "1 2", "1 2 3 4", "1,2,3", "1 2 x", "0x10 0 0"] {
            assert_eq!(numbers::<3>(text), None, "{text}");
        }
    }

    #[test]
    fn only_finite_numbers_of_some_size_are_sound() {
        assert!(are_sound(&[0.0, -1e9, 5e-324]));
        for bad in [f64::NAN, f64::INFINITY, -1.1e9] {
            assert!(!are_sound(&[0.0, bad]));
        }
    }
}
