//! What `solve --check --plot` draws: the file as it was understood.

use std::collections::BTreeMap;

use soilctl_figure::{Axis, Figure, Paths, Polygon, Polygons};
use soilctl_limit_analysis::{Described, Description};

use super::check::{KINDS, kind};
use super::scale::units;
use crate::error::CliError;

/// The regions of each soil, and what holds along the boundary.
pub(super) fn drawing(description: &Description, described: &Described) -> Result<Figure, CliError> {
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
    let (statement, units) = (&described.statement, units(description, described));
    for (place, name) in KINDS.into_iter().enumerate() {
        let sides = statement.boundaries.iter().filter(|side| kind(&side.condition) == name);
        let lines: Vec<Vec<(f64, f64)>> = sides
            .map(|side| {
                let line = &statement.lines[side.line];
                [line.from, line.to].map(|end| units.point(statement.points[end]).into()).into()
            })
            .collect();
        if !lines.is_empty() {
            figure.push(Paths::new(name, lines).width(3.0).color(count + place))?;
        }
    }
    Ok(figure)
}
