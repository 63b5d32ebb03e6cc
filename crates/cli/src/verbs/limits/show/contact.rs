//! Stresses between structure and soil.

use soilctl_figure::{Axis, Dash, Figure, Legend, Line};
use soilctl_limit_analysis::results::Contact;

use super::Shown;
use super::frame::statement;
use crate::error::CliError;

/// Names of faces: by where they look, seen along the structure's motion, numbered if there are several.
pub(super) fn names(contacts: &[Contact], direction: [f64; 2]) -> Vec<String> {
    let length = direction[0].hypot(direction[1]);
    let kind = |c: &Contact| {
        let towards = c.turned_towards(direction);
        // A closed face looks everywhere.
        if towards > 0.05 * c.length() * length {
            "front"
        } else if towards < -0.05 * c.length() * length {
            "back"
        } else {
            "side"
        }
    };
    let kinds: Vec<&str> = contacts.iter().map(|c| if c.closed { "around" } else { kind(c) }).collect();
    let name = |(i, kind): (usize, &&str)| {
        let same = |kinds: &[&str]| kinds.iter().filter(|k| k == &kind).count();
        match same(&kinds) {
            1 => (*kind).to_owned(),
            _ => format!("{kind} {}", same(&kinds[..=i])),
        }
    };
    kinds.iter().enumerate().map(name).collect()
}

/// Pressure and shear stress along all faces.
pub(super) fn figure(shown: &Shown) -> Result<Option<Figure>, CliError> {
    let Some(stress) = &shown.stress else { return Ok(None) };
    let contacts = stress.contacts();
    if contacts.is_empty() {
        return Ok(None);
    }
    let units = &shown.units;
    let what = "Lower bound, contact stresses";
    let title = if shown.title.is_empty() { what.to_owned() } else { format!("{what}: {}", shown.title) };
    let mut figure = Figure::new(
        title,
        Axis::linear(format!("distance along the face, from its upper end ({})", units.length_name)),
        Axis::linear(format!("stress ({})", units.stress_name)),
    )
    .with_legend(Legend::Below);
    let names = names(&contacts, statement(shown)?.objective.velocity());
    // Of each face, by turns; faces beyond have colours of their own.
    let dashes = [[Dash::Solid, Dash::Dash], [Dash::LongDash, Dash::Dot], [Dash::DashDot, Dash::DashDotDot]];
    for (color, ((contact, name), [solid, broken])) in
        contacts.iter().zip(names).zip(dashes.into_iter().cycle()).enumerate()
    {
        let line = |of: fn(&soilctl_limit_analysis::results::ContactPoint) -> f64| {
            let points = contact.points.iter().map(|p| (units.length * p.arc, units.stress * of(p)));
            points.collect::<Vec<_>>()
        };
        let pressure = Line::new(format!("{name}: pressure"), line(|p| p.pressure)).dash(solid);
        let shear = Line::new(format!("{name}: shear stress on the soil"), line(|p| p.shear)).dash(broken);
        figure.push(pressure.color(color).width(1.6))?.push(shear.color(color).width(1.6))?;
    }
    Ok(Some(figure))
}
