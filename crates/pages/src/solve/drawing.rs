//! A problem file as it was understood.

use std::collections::BTreeMap;

use soilctl_app::solve::BoundaryKind;
use soilctl_app::solve::check::Checked;
use soilctl_figure::{Axis, Figure, Paths, Polygon, Polygons};
use soilctl_limit_analysis::results::problem_units;

use crate::PageError;

/// The regions of each soil, and what holds along the boundary.
///
/// # Errors
/// [`PageError`] if a region cannot be drawn.
pub fn drawing(Checked { description, described, .. }: &Checked) -> Result<Figure, PageError> {
    let title = described.title.clone().unwrap_or_else(|| "the problem".into());
    let mut figure = Figure::new(title, Axis::linear("x (m)"), Axis::linear("y (m)")).with_equal_aspect()?;
    let mut soils: BTreeMap<&str, Vec<Polygon>> = BTreeMap::new();
    for region in &description.regions {
        let corners: Vec<(f64, f64)> = region.polygon.iter().map(|corner| (*corner).into()).collect();
        soils.entry(&region.soil).or_default().push(Polygon::new(corners));
    }
    let count = soils.len();
    for (soil, regions) in soils {
        figure.push(Polygons::new(soil, regions))?;
    }
    let (statement, units) = (&described.statement, problem_units(description, described));
    for (place, kind) in BoundaryKind::ALL.into_iter().enumerate() {
        let sides = statement.boundaries.iter().filter(|side| BoundaryKind::from(&side.condition) == kind);
        let lines: Vec<Vec<(f64, f64)>> = sides
            .map(|side| {
                let line = &statement.lines[side.line];
                [line.from, line.to].map(|end| units.point(statement.points[end]).into()).into()
            })
            .collect();
        if !lines.is_empty() {
            figure.push(Paths::new(kind.name(), lines).width(3.0).color(count + place))?;
        }
    }
    Ok(figure)
}
