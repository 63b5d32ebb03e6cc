//! A problem as a drawing.

use soilctl_drawing::{Drawing, Outline, Shape, Unit};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::Kind;

/// The drawing of a problem: areas on the layers of their soils, then all lines on layers of their own.
#[must_use]
pub fn drawing(description: &Description) -> Drawing {
    let Description { regions, water, boundaries, plates, structures, members, .. } = description;
    let area = |layer: &str, corners: &[[f64; 2]]| shape(layer.to_owned(), corners, Outline::Closed);
    let line = |layer: String, corners: &[[f64; 2]]| shape(layer, corners, Outline::Open);
    let mut shapes: Vec<Shape> = regions.iter().map(|region| area(&region.soil, &region.polygon)).collect();
    shapes.extend(water.iter().map(|water| line("water table".into(), &water.levels())));
    for boundary in boundaries.iter().filter(|boundary| !boundary.line.is_empty()) {
        shapes.push(line(format!("boundary {}", word(boundary.kind)), &boundary.line));
    }
    shapes.extend(plates.iter().map(|plate| line(format!("plate {}", plate.name), &plate.line)));
    for structure in structures {
        let layer = format!("structure {}", structure.name);
        if structure.polygon.is_empty() {
            shapes.push(line(layer, &structure.edge));
        } else {
            shapes.push(area(&layer, &structure.polygon));
        }
    }
    shapes.extend(members.iter().map(|member| line(format!("member {}", member.name), &member.line)));
    Drawing { shapes, unit: Some(Unit::Metre), ..Drawing::default() }
}

fn shape(layer: String, corners: &[[f64; 2]], outline: Outline) -> Shape {
    Shape { layer, corners: corners.to_vec(), outline }
}

const fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Fixed => "fixed",
        Kind::Smooth => "smooth",
        Kind::Symmetric => "symmetric",
        Kind::Free => "free",
        Kind::Far => "far",
        Kind::Load => "load",
    }
}
