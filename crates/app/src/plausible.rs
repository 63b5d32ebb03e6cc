//! Inputs that are possible but that hardly anybody means: a note says the value, what is usual, and the likely cause. Nothing is
//! refused for it.

mod edges;
mod file;
mod plate;
mod tool;

pub(crate) use file::notes as of_file;
pub(crate) use plate::notes as of_plate;
pub(crate) use tool::notes as of_tool;

use crate::text::number;

/// Unit weights of soil with its water, kN/m3.
const WEIGHT: [f64; 2] = [5.0, 30.0];
/// Friction angles of soil that has any, degrees. Rockfill at low stress reaches the upper end.
const FRICTION: [f64; 2] = [5.0, 60.0];
/// Angles up to this may be radians: 1.3 are 74 degrees.
const RADIANS: f64 = 1.3;
/// Stresses above this are strength of rock, not of soil, kPa: 10 MPa.
const STRESS_KPA: f64 = 1e4;

/// A unit weight; none is that of the weightless soil of textbooks.
fn weight(entry: &str, key: &str, kn_m3: f64) -> Option<String> {
    let [low, high] = WEIGHT;
    if kn_m3 == 0.0 || (low..=high).contains(&kn_m3) {
        return None;
    }
    let cause = match kn_m3 {
        x if (1e3 * low..=1e3 * high).contains(&x) => "is it in N/m3?",
        x if (500.0..=3000.0).contains(&x) => "is it a density in kg/m3?",
        x if (0.5..=3.0).contains(&x) => "is it a density in t/m3?",
        _ => "is it in kN/m3?",
    };
    Some(format!(
        "{entry}: {key} is {}; soils have {} to {} kN/m3: {cause}",
        number(kn_m3),
        number(low),
        number(high)
    ))
}

/// A friction angle, of soil or of a face, that is not zero.
fn friction(entry: &str, key: &str, deg: f64) -> Option<String> {
    let [low, high] = FRICTION;
    if deg == 0.0 || (low..=high).contains(&deg) {
        return None;
    }
    let cause = if deg <= RADIANS {
        format!("is it in radians? {} rad are {:.1} deg", number(deg), deg.to_degrees())
    } else if deg > high {
        "is it an angle of another kind, or that of rockfill at a low stress?".to_owned()
    } else {
        "is it in degrees?".to_owned()
    };
    Some(format!(
        "{entry}: {key} is {}; soils with friction have {} to {} deg: {cause}",
        number(deg),
        number(low),
        number(high)
    ))
}

/// Cohesion, adhesion, or a pressure, in kPa; the note tells it as `value` in the unit of its key.
fn stress(entry: &str, key: &str, kpa: f64, value: f64) -> Option<String> {
    let cause = if value == kpa { "is it in Pa?" } else { "is there a factor of 1000 too many?" };
    (kpa.abs() > STRESS_KPA).then(|| {
        format!(
            "{entry}: {key} is {}; soils have up to 10 MPa at most, and most below 100 kPa: {cause}",
            number(value)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_say_value_range_and_cause() {
        for (note, words) in [
            (weight("soil 1", "unit_weight_kn_m3", 19_000.0), ["19000", "5 to 30 kN/m3", "N/m3?"]),
            (weight("soil 1", "unit_weight_kn_m3", 1_900.0), ["1900", "5 to 30 kN/m3", "kg/m3?"]),
            (weight("soil 1", "unit_weight_kn_m3", 1.9), ["1.9", "5 to 30 kN/m3", "t/m3?"]),
            (weight("soil 1", "unit_weight_kn_m3", 40.0), ["40", "5 to 30 kN/m3", "is it in kN/m3?"]),
            (friction("soil 1", "phi_deg", 0.4), ["0.4", "5 to 60 deg", "0.4 rad are 22.9 deg"]),
            (friction("soil 1", "phi_deg", 65.0), ["65", "5 to 60 deg", "rockfill"]),
            (friction("soil 1", "phi_deg", 3.0), ["3", "5 to 60 deg", "in degrees?"]),
            (stress("soil 1", "cohesion_kpa", 12_000.0, 12_000.0), ["12000", "10 MPa", "in Pa?"]),
        ] {
            let note = note.unwrap_or_default();
            assert!(words.iter().all(|word| note.contains(word)), "{note}");
        }
        for usual in [
            weight("", "", 0.0),
            weight("", "", 18.0),
            friction("", "", 0.0),
            friction("", "", 35.0),
            stress("", "", 500.0, 500.0),
        ] {
            assert_eq!(usual, None);
        }
    }
}
