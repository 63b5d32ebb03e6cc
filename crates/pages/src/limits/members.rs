//! Axial forces of bars and sheets.

use soilctl_app::limits::Fields;
use soilctl_app::text::line_force_unit;
use soilctl_figure::{Axis, Dash, Figure, Legend, Line};

use crate::PageError;

/// Axial forces along all members.
pub(super) fn figure(fields: &Fields) -> Result<Option<Figure>, PageError> {
    let Some(stress) = &fields.stress else { return Ok(None) };
    let forces = stress.axial_forces();
    if forces.is_empty() {
        return Ok(None);
    }
    let (units, statement) = (&fields.units, fields.statement()?);
    let force_name = line_force_unit(&units.stress_name, &units.length_name);
    let what = "Lower bound, axial forces";
    let title = if fields.title.is_empty() { what.to_owned() } else { format!("{what}: {}", fields.title) };
    let mut figure = Figure::new(
        title,
        Axis::linear(format!("distance from the start ({})", units.length_name)),
        Axis::linear(format!("axial force ({force_name})")),
    )
    .with_legend(Legend::Below);
    let unit = units.length * units.stress;
    for (color, force) in forces.iter().enumerate() {
        let member = &statement.members[force.member];
        let name =
            if member.name.is_empty() { format!("member {}", force.member + 1) } else { member.name.clone() };
        let points: Vec<_> =
            force.points.iter().map(|[at, value]| (units.length * at, unit * value)).collect();
        let end = points.last().map_or(0.0, |p| p.0);
        let most = unit * member.tension;
        let strength = Line::new(format!("{name}: bears"), vec![(0.0, most), (end, most)]).dash(Dash::Dot);
        figure
            .push(Line::new(name, points).color(color).width(1.6))?
            .push(strength.color(color).width(1.2))?;
    }
    Ok(Some(figure))
}
