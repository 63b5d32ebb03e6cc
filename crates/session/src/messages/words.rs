//! Names of enum variants, as they stand in messages: `TrajectoryEnded(Stroke, Contact)` is
//! `trajectory_ended/stroke/contact`.

use serde::Serialize;
use serde::de::value::{Error, StrDeserializer};
use serde::de::{Deserialize, IntoDeserializer};
use serde_json::Value;

/// The name of a variant, with the names of variants inside it: `TrajectoryEnded(Stroke, Contact)` is
/// `trajectory_ended/stroke/contact`.
#[must_use]
pub fn word<T: Serialize>(value: &T) -> String {
    serde_json::to_value(value).map_or_else(|_| String::new(), |value| path(&value))
}

fn path(value: &Value) -> String {
    match value {
        Value::String(name) => snake(name),
        Value::Object(parts) => {
            parts.iter().map(|(name, inner)| format!("{}/{}", snake(name), path(inner))).collect()
        }
        Value::Array(parts) => parts.iter().map(path).collect::<Vec<_>>().join("/"),
        other => other.to_string(),
    }
}

fn snake(name: &str) -> String {
    let mut text = String::with_capacity(name.len() + 4);
    for (i, letter) in name.chars().enumerate() {
        if letter.is_ascii_uppercase() && i > 0 {
            text.push('_');
        }
        text.push(letter.to_ascii_lowercase());
    }
    text
}

/// The variant without content of this name; the type may call its variants in either style.
#[must_use]
pub fn variant<'a, T: Deserialize<'a>>(name: &'a str) -> Option<T> {
    let read = |name: &str| {
        let text: StrDeserializer<'_, Error> = name.into_deserializer();
        T::deserialize(text).ok()
    };
    read(name).or_else(|| read(&camel(name)))
}

fn camel(name: &str) -> String {
    let mut upper = true;
    let mut text = String::with_capacity(name.len());
    for letter in name.chars() {
        if letter == '_' {
            upper = true;
        } else {
            text.push(if upper { letter.to_ascii_uppercase() } else { letter });
            upper = false;
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use soilctl_controller::{EventKind, Fault, Finish, SequenceId, TrajectoryKind};

    use super::*;

    #[test]
    fn variants_have_readable_names() {
        assert_eq!(word(&EventKind::Fault(Fault::TipForce)), "fault/tip_force");
        assert_eq!(
            word(&EventKind::TrajectoryEnded(TrajectoryKind::Stroke, Finish::Contact)),
            "trajectory_ended/stroke/contact"
        );
        assert_eq!(word(&EventKind::Homed), "homed");
        assert_eq!(word(&SequenceId::InsertStrokePullout), "insert_stroke_pullout");
    }

    #[test]
    fn names_lead_back_to_the_variant() {
        for sequence in SequenceId::ALL {
            assert_eq!(variant(&word(&sequence)), Some(sequence));
        }
        assert_eq!(variant("tip_force"), Some(Fault::TipForce));
        assert_eq!(variant::<Fault>("tip_farce"), None);
    }
}
