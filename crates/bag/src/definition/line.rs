use super::sections::shown;
use super::{Base, Ros, Shape, short_name};

/// What a line tells: a field of a type of ROS itself, or of another type.
#[derive(Debug, PartialEq)]
pub(super) struct Line {
    pub(super) name: String,
    pub(super) what: What,
    pub(super) shape: Shape,
}

/// What a field holds, before other types are looked up.
#[derive(Debug, PartialEq)]
pub(super) enum What {
    Plain(Base),
    /// A type by its short name.
    Named(String),
}

/// Reads a line of a definition in this package; nothing for a comment, a constant or an empty line.
///
/// # Errors
/// In words.
pub(super) fn line(ros: Ros, package: &str, line: &str) -> Result<Option<Line>, String> {
    let line = line.trim();
    if line.is_empty() || line.starts_with('#') {
        return Ok(None);
    }
    let odd = || format!("the line {:?} of its definition is no field", shown(line));
    let (kind, rest) = line.split_once(char::is_whitespace).ok_or_else(odd)?;
    let rest = rest.trim_start();
    let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
    let (name, rest) = rest.split_at_checked(end).ok_or_else(odd)?;
    if name.is_empty() {
        return Err(odd());
    }
    // Values of constants may hold anything, also `#`; default values and comments say nothing about the bytes.
    if rest.trim_start().starts_with('=') {
        return Ok(None);
    }
    let (base, shape) = match kind.split_once('[') {
        None => (kind, Shape::One),
        Some((base, length)) => {
            let length = length.strip_suffix(']').ok_or_else(odd)?;
            (base, shape(length).ok_or_else(odd)?)
        }
    };
    // The longest text that a bounded one may have says nothing about the bytes either.
    let base = base.split_once("<=").map_or(base, |(base, _)| base);
    let what = what(ros, package, base).ok_or_else(|| match base {
        "wstring" => format!("its field {name} is a `wstring`, text in 16 bits, which is not read"),
        _ => odd(),
    })?;
    Ok(Some(Line { name: name.to_owned(), what, shape }))
}

fn shape(length: &str) -> Option<Shape> {
    if length.is_empty() {
        return Some(Shape::List);
    }
    match length.strip_prefix("<=") {
        Some(most) => most.parse().ok().map(Shape::Bounded),
        None => length.parse().ok().map(Shape::Fixed),
    }
}

fn what(ros: Ros, package: &str, base: &str) -> Option<What> {
    Some(What::Plain(match base {
        "bool" => Base::Bool,
        "int8" => Base::Int8,
        "byte" if ros == Ros::One => Base::Int8,
        "uint8" | "byte" | "char" => Base::Uint8,
        "int16" => Base::Int16,
        "uint16" => Base::Uint16,
        "int32" => Base::Int32,
        "uint32" => Base::Uint32,
        "int64" => Base::Int64,
        "uint64" => Base::Uint64,
        "float32" => Base::Float32,
        "float64" => Base::Float64,
        "string" => Base::Text,
        "time" => Base::Time,
        "duration" => Base::Duration,
        "wstring" => return None,
        // ROS 1 knows this one without its package.
        "Header" if ros == Ros::One => return Some(What::Named("std_msgs/Header".to_owned())),
        other => {
            let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '/';
            if other.is_empty() || !other.chars().all(plain) {
                return None;
            }
            let name = if other.contains('/') { short_name(other) } else { format!("{package}/{other}") };
            return Some(match name.as_str() {
                "builtin_interfaces/Time" => What::Plain(Base::Time),
                "builtin_interfaces/Duration" => What::Plain(Base::Duration),
                _ => What::Named(name),
            });
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(ros: Ros, text: &str) -> Option<(String, What, Shape)> {
        line(ros, "here", text).unwrap().map(|line| (line.name, line.what, line.shape))
    }

    #[test]
    fn fields_of_every_form() {
        let plain = |name: &str, base, shape| Some((name.to_owned(), What::Plain(base), shape));
        let named = |name: &str, of: &str, shape| Some((name.to_owned(), What::Named(of.to_owned()), shape));
        for (text, expected) in [
            ("", None),
            ("  # int32 x", None),
            ("int32 X=5", None),
            ("string NAME = a # b", None),
            ("wstring W=a", None),
            ("int32 x", plain("x", Base::Int32, Shape::One)),
            ("\tfloat64   x 0.5 # metres", plain("x", Base::Float64, Shape::One)),
            ("int32[] y [1, 2]", plain("y", Base::Int32, Shape::List)),
            ("uint8[16] id", plain("id", Base::Uint8, Shape::Fixed(16))),
            ("float32[<=3] few#", plain("few", Base::Float32, Shape::Bounded(3))),
            ("string<=10[<=5] words \"a=b\"", plain("words", Base::Text, Shape::Bounded(5))),
            ("byte b", plain("b", Base::Uint8, Shape::One)),
            ("builtin_interfaces/msg/Time stamp", plain("stamp", Base::Time, Shape::One)),
            ("std_msgs/Header header", named("header", "std_msgs/Header", Shape::One)),
            ("Thing[] things", named("things", "here/Thing", Shape::List)),
            ("Header header", named("header", "here/Header", Shape::One)),
        ] {
            assert_eq!(read(Ros::Two, text), expected, "{text}");
        }
        assert_eq!(read(Ros::One, "Header header"), named("header", "std_msgs/Header", Shape::One));
        assert_eq!(read(Ros::One, "byte b"), plain("b", Base::Int8, Shape::One));
        for text in
            ["int32", "int32 9.5 [", "int32[ x", "int32[-1] x", "int32[x] x", "a-b x", "wstring w", "---"]
        {
            let read = line(Ros::Two, "here", text);
            assert!(read.is_err() || text == "int32 9.5 [", "{text}: {read:?}");
        }
    }
}
