use crate::CertificateError;
use crate::statement::{Condition, Statement};

/// Most lines of a statement: some checks compare all pairs.
const MAX_LINES: usize = 256;

/// Checks that every number of a statement is in its range and every index points at something.
pub(super) fn check(statement: &Statement) -> Result<(), CertificateError> {
    let Statement { points, lines, regions, gravity, datum, surcharge, velocity, boundaries } = statement;
    for (i, p) in points.iter().enumerate() {
        for x in p {
            finite("coordinate", || format!("point {i}"), *x, "length")?;
        }
    }
    if lines.len() > MAX_LINES {
        let count = lines.len();
        return Err(CertificateError::NotCovered {
            place: format!("{count} lines"),
            what: "a statement has at most 256 lines",
        });
    }
    for (i, line) in lines.iter().enumerate() {
        for index in [line.from, line.to] {
            exists(|| format!("line {i}"), "point", index, points.len())?;
        }
    }
    for (i, region) in regions.iter().enumerate() {
        for used in region.loops.iter().flatten() {
            exists(|| format!("region {i}"), "line", used.line, lines.len())?;
        }
        let (m, place) = (region.material, || format!("region {i}"));
        check_angle("friction angle", place, m.phi_deg)?;
        at_least_zero("cohesion", place, m.cohesion, "stress")?;
        at_least_zero("unit weight", place, m.unit_weight, "force/volume")?;
    }
    let whole = || "the statement".to_owned();
    finite("gravity along x", whole, gravity[0], "")?;
    within("gravity along y", whole, gravity[1], "", "finite and below 0", gravity[1] < 0.0)?;
    finite("datum", whole, *datum, "length")?;
    at_least_zero("surcharge", whole, *surcharge, "stress")?;
    for v in velocity {
        finite("velocity", whole, *v, "")?;
    }
    for (i, boundary) in boundaries.iter().enumerate() {
        let place = || format!("boundary {i}");
        exists(place, "line", boundary.line, lines.len())?;
        if let Condition::Face { delta_deg, adhesion } = boundary.condition {
            check_angle("interface friction", place, delta_deg)?;
            at_least_zero("adhesion", place, adhesion, "stress")?;
            if delta_deg == 0.0 && adhesion > 0.0 {
                let what = "adhesion without interface friction; give a friction angle above 0 deg";
                return Err(CertificateError::NotCovered { place: place(), what });
            }
        }
    }
    Ok(())
}

/// Checks that an index is below a count.
pub(crate) fn exists(
    place: impl Fn() -> String,
    what: &'static str,
    index: usize,
    count: usize,
) -> Result<(), CertificateError> {
    if index < count { Ok(()) } else { Err(CertificateError::NoSuch { place: place(), what, index, count }) }
}

/// Checks that a number is finite.
pub(crate) fn finite(
    quantity: &'static str,
    place: impl Fn() -> String,
    value: f64,
    unit: &'static str,
) -> Result<(), CertificateError> {
    within(quantity, place, value, unit, "finite", true)
}

fn at_least_zero(
    quantity: &'static str,
    place: impl Fn() -> String,
    value: f64,
    unit: &'static str,
) -> Result<(), CertificateError> {
    within(quantity, place, value, unit, "finite and at least 0", value >= 0.0)
}

fn check_angle(
    quantity: &'static str,
    place: impl Fn() -> String,
    value: f64,
) -> Result<(), CertificateError> {
    within(quantity, place, value, "deg", "at least 0 and below 90", (0.0..90.0).contains(&value))
}

fn within(
    quantity: &'static str,
    place: impl Fn() -> String,
    value: f64,
    unit: &'static str,
    allowed: &'static str,
    holds: bool,
) -> Result<(), CertificateError> {
    if holds && value.is_finite() {
        Ok(())
    } else {
        Err(CertificateError::OutOfRange { quantity, place: place(), value, unit, allowed })
    }
}
