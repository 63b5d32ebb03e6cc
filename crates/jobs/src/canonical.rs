//! One text for one value, and what stands for a text.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use sha2::{Digest, Sha256};

/// The JSON of a value whose bytes depend on nothing but the value: keys sorted, no spaces, numbers as Python writes them.
/// It is the form of the Python package's stores, so that both find each other's results.
///
/// # Errors
/// If the value has no JSON: keys that are no text, numbers beyond those of JSON.
pub fn canonical(value: &impl Serialize) -> serde_json::Result<String> {
    let mut value = serde_json::to_value(value)?;
    // Whether the map sorts its keys depends on which features of `serde_json` a program has.
    value.sort_all_objects();
    let mut bytes = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut bytes, LikePython))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Compact JSON with `repr` of Python's floats.
struct LikePython;

impl Formatter for LikePython {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        let scientific = format!("{value:e}");
        let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        match exponent.parse::<i32>() {
            Ok(exponent) if !(-4..16).contains(&exponent) => write!(writer, "{digits}e{exponent:+03}"),
            _ if value.fract() == 0.0 => write!(writer, "{value}.0"),
            _ => write!(writer, "{value}"),
        }
    }
}

/// SHA-256 in 64 hexadecimal digits: the address of what is stored.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// FNV-1a in 16 hexadecimal digits: short, and says whether two texts are the same as long as nobody wants to deceive.
#[must_use]
pub fn fnv1a(bytes: &[u8]) -> String {
    let hash = bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use std::collections::HashMap;

    use super::*;

    /// What `json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)` writes.
    #[test]
    fn numbers_and_texts_are_those_of_python() {
        for (value, text) in [
            (0.0, "0.0"),
            (-0.0, "-0.0"),
            (85.0, "85.0"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1e-4, "0.0001"),
            (9.999e-5, "9.999e-05"),
            (1e15, "1000000000000000.0"),
            (1e16, "1e+16"),
            (1.5e16, "1.5e+16"),
            (123_456_789_012_345_680.0, "1.2345678901234568e+17"),
            (-5e-324, "-5e-324"),
            (f64::MAX, "1.7976931348623157e+308"),
        ] {
            assert_eq!(canonical(&value).unwrap(), text);
        }
        assert_eq!(canonical(&"\u{1}\u{7f}é\"\\/\n\t\u{8}").unwrap(), "\"\\u0001\u{7f}é\\\"\\\\/\\n\\t\\b\"");
        assert_eq!(canonical(&(1, true, None::<u8>)).unwrap(), "[1,true,null]");
    }

    #[test]
    fn the_order_of_keys_does_not_matter() {
        let map: HashMap<_, _> = (0..20).map(|i| (format!("k{i}"), i)).collect();
        let reverse: HashMap<_, _> = (0..20).rev().map(|i| (format!("k{i}"), i)).collect();
        let text = canonical(&map).unwrap();
        assert_eq!(text, canonical(&reverse).unwrap());
        assert!(text.starts_with(r#"{"k0":0,"k1":1,"k10":10,"#), "{text}");
    }

    #[test]
    fn hashes_are_the_published_ones() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert_eq!(fnv1a(b"a"), "af63dc4c8601ec8c");
    }
}
