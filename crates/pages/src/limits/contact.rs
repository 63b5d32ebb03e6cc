//! Stresses between structure and soil.

use soilctl_app::limits::{Fields, face_names};
use soilctl_figure::{Axis, Dash, Figure, Legend, Line};
use soilctl_limit_analysis::results::ContactPoint;

use crate::PageError;

/// Pressure and shear stress along all faces.
pub(super) fn figure(fields: &Fields) -> Result<Option<Figure>, PageError> {
    let Some(stress) = &fields.stress else { return Ok(None) };
    let contacts = stress.contacts();
    if contacts.is_empty() {
        return Ok(None);
    }
    let units = &fields.units;
    let what = "Lower bound, contact stresses";
    let title = if fields.title.is_empty() { what.to_owned() } else { format!("{what}: {}", fields.title) };
    let mut figure = Figure::new(
        title,
        Axis::linear(format!("distance along the face, from its upper end ({})", units.length_name)),
        Axis::linear(format!("stress ({})", units.stress_name)),
    )
    .with_legend(Legend::Below);
    let names = face_names(&contacts, fields.statement()?.objective.velocity());
    // Of each face, by turns; faces beyond have colours of their own.
    let dashes = [[Dash::Solid, Dash::Dash], [Dash::LongDash, Dash::Dot], [Dash::DashDot, Dash::DashDotDot]];
    for (color, ((contact, name), [solid, broken])) in
        contacts.iter().zip(names).zip(dashes.into_iter().cycle()).enumerate()
    {
        let line = |of: fn(&ContactPoint) -> f64| {
            let points = contact.points.iter().map(|p| (units.length * p.arc, units.stress * of(p)));
            points.collect::<Vec<_>>()
        };
        let pressure = Line::new(format!("{name}: pressure"), line(|p| p.pressure)).dash(solid);
        let shear = Line::new(format!("{name}: shear stress on the soil"), line(|p| p.shear)).dash(broken);
        figure.push(pressure.color(color).width(1.6))?.push(shear.color(color).width(1.6))?;
    }
    Ok(Some(figure))
}
