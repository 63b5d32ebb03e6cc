use super::envelope;
use crate::CertificateError;
use crate::interval::Vector;
use crate::statement::{Anisotropy, Condition, Grip, Linear, Material, Member, Objective, Statement};

/// Most lines of a statement: some checks compare all pairs.
const MAX_LINES: usize = 1024;

/// Checks that every number of a statement is in its range and every index points at something.
pub(super) fn check(statement: &Statement) -> Result<(), CertificateError> {
    let Statement { points, lines, regions, gravity, datum, surcharge, objective, .. } = statement;
    for (i, p) in points.iter().enumerate() {
        for x in p {
            finite("coordinate", || format!("point {i}"), *x, "length")?;
        }
    }
    if lines.len() > MAX_LINES {
        let count = lines.len();
        return Err(CertificateError::NotCovered {
            place: format!("{count} lines"),
            what: "a statement has at most 1024 lines",
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
        let (m, place) = (&region.material, || format!("region {i}"));
        check_angle("friction angle", place, m.phi_deg)?;
        check_linear("cohesion", place, &m.cohesion)?;
        check_linear("pore pressure", place, &m.pore_pressure)?;
        // A linear function is least at a corner; at a surface it may be zero but for rounding.
        for used in region.loops.iter().flatten() {
            let line = lines[used.line];
            for corner in [line.from, line.to] {
                let least = m.cohesion.enclosed(Vector::point(points[corner])).hi();
                at_least_zero("cohesion at a corner", place, least, "stress")?;
            }
        }
        at_least_zero("unit weight", place, m.unit_weight, "force/volume")?;
        at_least_zero("tension", place, m.tension.unwrap_or(0.0), "stress")?;
        for line in m.envelope.iter().flat_map(|e| e.inside.iter().chain(&e.outside)) {
            check_angle("friction angle of a line of the envelope", place, line.phi_deg)?;
            at_least_zero("cohesion of a line of the envelope", place, line.cohesion, "stress")?;
        }
        envelope::check(m, place)?;
        check_anisotropy(m, place)?;
        if statement.width.is_some() && (m.envelope.is_some() || m.anisotropy.is_some()) {
            let what = "strength that is curved or depends on the direction beside a structure with ends";
            return Err(CertificateError::NotCovered { place: place(), what });
        }
    }
    let whole = || "the statement".to_owned();
    finite("gravity along x", whole, gravity[0], "")?;
    let down = gravity[1] < 0.0 || *gravity == [0.0; 2];
    within("gravity along y", whole, gravity[1], "", "finite and below 0, or 0 like the one along x", down)?;
    finite("datum", whole, *datum, "length")?;
    at_least_zero("surcharge", whole, *surcharge, "stress")?;
    if let Some(width) = statement.width {
        within("width", whole, width, "length", "finite and above 0", width > 0.0)?;
    }
    check_members(statement)?;
    let (Objective::Structure { velocity: numbers } | Objective::Body { gravity: numbers }) = *objective
    else {
        return check_boundaries(statement);
    };
    for x in numbers {
        finite("the objective's velocity or gravity", whole, x, "")?;
    }
    check_boundaries(statement)
}

fn check_anisotropy(m: &Material, place: impl Fn() -> String) -> Result<(), CertificateError> {
    let Some(Anisotropy { passive, shear }) = m.anisotropy else { return Ok(()) };
    for (quantity, value) in [("passive strength", passive), ("greatest shear stress", shear)] {
        within(quantity, &place, value, "of the cohesion", "finite and above 0", value > 0.0)?;
    }
    if m.phi_deg == 0.0 && m.tension.is_none() && m.envelope.is_none() {
        return Ok(());
    }
    let what = "strength that depends on the direction beside friction, a limit to tension or an envelope";
    Err(CertificateError::NotCovered { place: place(), what })
}

fn check_boundaries(statement: &Statement) -> Result<(), CertificateError> {
    let Statement { lines, boundaries, .. } = statement;
    for (i, boundary) in boundaries.iter().enumerate() {
        let place = || format!("boundary {i}");
        exists(place, "line", boundary.line, lines.len())?;
        if let Condition::Face { delta_deg, adhesion } = boundary.condition {
            check_angle("interface friction", place, delta_deg)?;
            at_least_zero("adhesion", place, adhesion, "stress")?;
        }
        if let Condition::Loaded { pressure, shear, .. } | Condition::Lined { pressure, shear, .. } =
            boundary.condition
        {
            for x in pressure.into_iter().chain(shear) {
                finite("load", place, x, "stress")?;
            }
        }
    }
    Ok(())
}

fn check_members(statement: &Statement) -> Result<(), CertificateError> {
    for (i, member) in statement.members.iter().enumerate() {
        let place = || format!("member {i}");
        for side in &member.path {
            exists(place, "line", side.line, statement.lines.len())?;
        }
        at_least_zero("tension", place, member.tension, "force")?;
        at_least_zero("compression", place, member.compression, "force")?;
        let holds = member.bond > 0.0 && member.bond <= 1.0;
        within("bond", place, member.bond, "", "above 0 and at most 1", holds)?;
        check_grips(member, place)?;
        for (quantity, most) in member
            .bending
            .iter()
            .flat_map(|b| [("greatest moment", b.moment), ("greatest shear force", b.shear)])
        {
            within(quantity, place, most, "force", "finite and above 0", most > 0.0)?;
        }
    }
    if statement.width.is_some() && !statement.members.is_empty() {
        let (place, what) = ("the statement".into(), "members beside a structure with ends");
        return Err(CertificateError::NotCovered { place, what });
    }
    Ok(())
}

/// Checks what a row of bars takes from the soil.
fn check_grips(member: &Member, place: impl Fn() -> String) -> Result<(), CertificateError> {
    let Some(grips) = &member.pullout else { return Ok(()) };
    let bad = |problem| Err(CertificateError::BadStatement { place: place(), problem });
    if grips.len() != member.path.len() {
        return bad("its pullout must have an entry for each line of its path");
    }
    if member.bond != 1.0 || member.bending.is_some() {
        return bad("a row of bars has no faces and does not bend: its bond is 1, and it has no bending");
    }
    for Grip { resistance, part: [from, to] } in grips {
        for value in resistance {
            at_least_zero("pullout resistance", &place, *value, "stress")?;
        }
        let allowed = "at least 0, in order, and at most 1";
        let holds = *from >= 0.0 && from <= to && *to <= 1.0;
        within("fraction of the line with pullout resistance", &place, *to, "", allowed, holds)?;
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

fn check_linear(
    quantity: &'static str,
    place: impl Fn() -> String,
    linear: &Linear,
) -> Result<(), CertificateError> {
    let [x, y] = linear.gradient;
    [linear.at_origin, x, y].into_iter().try_for_each(|value| finite(quantity, &place, value, "stress"))
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
