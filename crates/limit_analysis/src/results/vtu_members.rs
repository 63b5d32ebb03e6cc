//! What members bear, for ParaView.

use soilctl_certificate::ShownAcross;

use super::members::{BETWEEN, polynomial};
use super::stress::StressResults;
use super::units::Units;
use super::vtu_file::{Cells, Field, Shape, write};
use crate::error::LimitError;
use crate::vector::along;

/// The members of a solution in ParaView's format, as lines from point to point; nothing if it has none. Points are not shared, so a shear
/// force may jump.
///
/// At points: `axial_force`, tension positive, and `shear_force` (stress times length), and `moment` (times length again), positive
/// where it stretches the right side; these two are zero where no beam is. Each line is a piece of a `member`, counted from 0.
///
/// # Errors
///
/// [`LimitError::NotFinite`] if a number is too large to be written.
pub fn write_members_vtu(stress: &StressResults, units: &Units) -> Result<Option<String>, LimitError> {
    let (mut places, mut members) = (Vec::new(), Vec::new());
    let [mut axial, mut shear, mut moment] = [const { Vec::new() }; 3];
    let force = units.stress * units.length;
    for edge in &stress.shown.members {
        for step in 0..BETWEEN {
            members.push(edge.member);
            for s in [step, step + 1].map(|i| i as f64 / BETWEEN as f64) {
                let [x, y] = units.point(along(edge.ends[0], edge.ends[1], s));
                places.push([x, y, 0.0]);
                let [across, turning] = match edge.across {
                    Some(ShownAcross::Forces { moment, shear }) => {
                        [polynomial(shear, s), polynomial(moment, s)]
                    }
                    Some(ShownAcross::Velocity(_) | ShownAcross::Slip(_)) | None => [0.0; 2],
                };
                axial.push(force * polynomial(edge.along, s));
                shear.push(force * across);
                moment.push(force * units.length * turning);
            }
        }
    }
    if members.is_empty() {
        return Ok(None);
    }
    let lines = Cells { shape: Shape::Line, points: places, number: ("member", members) };
    let points = [("axial_force", axial), ("shear_force", shear), ("moment", moment)]
        .map(|(name, values)| Field::scalar(name, values));
    write(&lines, &points, &[]).map(Some)
}
