//! What presses on a plate near its end, in the stress field in space behind the lower bound.

use soilctl_app::limits::Fields;
use soilctl_figure::{Axis, Figure, Paths, Shade, Shades, Size};

use super::frame::INK;
use crate::PageError;

const WIDTH: u32 = 900;
/// Room that axes and legend take, across and up.
const AROUND: [f64; 2] = [190.0, 150.0];
/// Each face on the plate is drawn in 4 to this power parts, each of one shade.
const HALVINGS: usize = 3;

/// The corners of a triangle on the plate, and what presses there.
type Corners = [([f64; 2], f64); 3];

/// The pressure ahead less that behind, as a map of the plate; none if there is no such field.
pub(super) fn figure(fields: &Fields) -> Result<Option<(Figure, Size)>, PageError> {
    let Some(stress) = &fields.end else { return Ok(None) };
    let units = &fields.units;
    let place = |[y, z]: [f64; 2]| [units.length * y, units.point([0.0, z])[1]];
    let mut parts = Vec::new();
    for face in &stress.plate {
        let corners: Corners =
            std::array::from_fn(|k| (place(face.corners[k]), units.stress * face.net_pressure[k]));
        halved(corners, HALVINGS, &mut parts);
    }
    let all = || parts.iter().flat_map(|part| &part.ring);
    let span = |of: fn(&(f64, f64)) -> f64| {
        all().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let ([left, right], [low, high]) = (span(|p| p.0), span(|p| p.1));
    let most = parts.iter().map(|part| part.value).fold(0.0, f64::max);
    // A field has faces on the plate, and a plate has an area.
    if most <= 0.0 || left >= right || low >= high {
        return Ok(None);
    }
    let what = "Lower bound, pressure on the plate near its end";
    let title = if fields.title.is_empty() { what.to_owned() } else { format!("{what}: {}", fields.title) };
    let unit = &units.length_name;
    let margin = 0.02 * (right - left);
    let x =
        Axis::linear(format!("y, across from the middle ({unit})")).range(left - margin, right + margin)?;
    let z = Axis::linear(format!("z ({unit})")).range(low - margin, high + margin)?;
    let mut figure = Figure::new(title, x, z).with_equal_aspect()?;
    figure.push(Shades::new(
        format!("pressure ahead less that behind ({})", units.stress_name),
        parts,
        0.0,
        most,
    ))?;
    let rim = vec![vec![(left, low), (right, low), (right, high), (left, high)]];
    figure.push(Paths::new("", rim).width(1.5).color(INK))?;
    let wide = (high - low) / (right - left);
    let height = (f64::from(WIDTH) - AROUND[0]) * wide + AROUND[1];
    Ok(Some((figure, Size::new(WIDTH, height.clamp(360.0, 1100.0) as u32)?)))
}

/// The parts of a triangle whose sides are halved so many times.
fn halved(corners: Corners, times: usize, parts: &mut Vec<Shade>) {
    let [a, b, c] = corners;
    if times == 0 {
        let ring = corners.map(|(place, _)| place.into()).to_vec();
        parts.push(Shade { ring, value: (a.1 + b.1 + c.1) / 3.0 });
        return;
    }
    let middle = |(p, v): ([f64; 2], f64), (q, w): ([f64; 2], f64)| {
        ([0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])], 0.5 * (v + w))
    };
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        halved(part, times - 1, parts);
    }
}
