//! Axial forces and bending moments of members.

use soilctl_app::limits::Fields;
use soilctl_app::text::{line_force_unit, moment_unit};
use soilctl_certificate::Member;
use soilctl_figure::{Axis, Dash, Figure, Legend, Line};
use soilctl_limit_analysis::results::{Course, MemberForces};

use crate::PageError;

/// Axial forces along all members.
pub(super) fn figure(fields: &Fields) -> Result<Option<Figure>, PageError> {
    let units = &fields.units;
    let name = format!("axial force ({})", line_force_unit(&units.stress_name, &units.length_name));
    let course = |forces: &MemberForces| Some(forces.axial.clone());
    drawn(fields, ["axial forces", &name], units.length * units.stress, course, |m| vec![m.tension])
}

/// Bending moments along all beams.
pub(super) fn moments(fields: &Fields) -> Result<Option<Figure>, PageError> {
    let units = &fields.units;
    let name = format!("bending moment ({})", moment_unit(&units.stress_name, &units.length_name));
    let unit = units.length * units.length * units.stress;
    let course = |forces: &MemberForces| Some(forces.bending.as_ref()?.moment.clone());
    let most = |m: &Member| m.bending.map_or_else(Vec::new, |bending| vec![bending.moment, -bending.moment]);
    drawn(fields, ["bending moments", &name], unit, course, most)
}

/// Something along members, with what each bears.
fn drawn(
    fields: &Fields,
    [what, axis]: [&str; 2],
    unit: f64,
    course: impl Fn(&MemberForces) -> Option<Course>,
    bears: impl Fn(&Member) -> Vec<f64>,
) -> Result<Option<Figure>, PageError> {
    let Some(stress) = &fields.stress else { return Ok(None) };
    let forces = stress.member_forces();
    let courses: Vec<_> = forces.iter().filter_map(|forces| Some((forces.member, course(forces)?))).collect();
    if courses.is_empty() {
        return Ok(None);
    }
    let (units, statement) = (&fields.units, fields.statement()?);
    let what = format!("Lower bound, {what}");
    let title = if fields.title.is_empty() { what } else { format!("{what}: {}", fields.title) };
    let along = Axis::linear(format!("distance from the start ({})", units.length_name));
    let mut figure = Figure::new(title, along, Axis::linear(axis)).with_legend(Legend::Below);
    for (color, (member, course)) in courses.into_iter().enumerate() {
        let (number, member) = (member + 1, &statement.members[member]);
        let name = if member.name.is_empty() { format!("member {number}") } else { member.name.clone() };
        let points: Vec<_> = course.iter().map(|[at, value]| (units.length * at, unit * value)).collect();
        let end = points.last().map_or(0.0, |p| p.0);
        figure.push(Line::new(name.clone(), points).color(color).width(1.6))?;
        for (i, most) in bears(member).into_iter().enumerate() {
            let name = if i == 0 { format!("{name}: bears") } else { String::new() };
            let strength = vec![(0.0, unit * most), (end, unit * most)];
            figure.push(Line::new(name, strength).dash(Dash::Dot).color(color).width(1.2))?;
        }
    }
    Ok(Some(figure))
}
