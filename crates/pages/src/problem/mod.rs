//! A problem as a drawing: soils, water, supports, structures, and what acts.
//!
//! `of_statement.rs` and `of_file.rs` say what there is to draw, the other files draw one kind of thing each. Symbols are as large
//! on the page whatever the size of the problem.

mod acting;
mod heads;
mod of_file;
mod of_statement;
mod place;
mod regions;
mod supports;
mod understood;
mod water;

use soilctl_app::solve::BoundaryKind;
use soilctl_figure::{Axis, Figure, Paths, Polygon, Polygons, Size, Text, TextPlace};
use soilctl_limit_analysis::results::Point;

use crate::PageError;
use place::{Scale, data, middle, ring};
pub use understood::{Understood, UnderstoodLoad, UnderstoodSide};

/// Palette indices that mean the same in every drawing: water, what acts, ink.
const WATER: usize = 0;
const ACTING: usize = 1;
const INK: usize = 6;
/// Those of soils, in order: not that whose hatch is level, which would look like strata.
const SOILS: [usize; 5] = [7, 2, 3, 5, 1];

/// Those of members: not that of loads.
const MEMBERS: [usize; 3] = [2, 3, 4];

/// What there is to draw, in the coordinates of the axes. Sides are walked with the soil on the left.
pub(crate) struct Scene {
    title: String,
    length_name: String,
    stress_name: String,
    /// Names of soils with their strength, and where they are.
    soils: Vec<(String, Vec<Polygon>)>,
    /// Where soils meet.
    interfaces: Vec<Vec<Point>>,
    /// Rigid bodies: names, and their corners.
    bodies: Vec<(String, Vec<Point>)>,
    /// Plates and faces without a body: names, empty if unknown, and their points.
    faces: Vec<(String, Vec<Point>)>,
    /// Bars and sheets: names with what they bear, and their ends.
    members: Vec<(String, [Point; 2])>,
    sides: Vec<([Point; 2], BoundaryKind)>,
    /// Pieces of the water table, and what stands above the ground.
    table: Vec<Vec<Point>>,
    ponds: Vec<Vec<Point>>,
    /// Of water that flows: its free surface and lines of equal head in pieces, and where which head is given.
    free_surface: Vec<Vec<Point>>,
    equipotentials: Vec<Vec<Point>>,
    heads: Vec<(String, Point)>,
    loads: Vec<Load>,
    /// Pressure on all free sides.
    surcharge: f64,
    /// What moves, from where and in which direction.
    motion: Option<(String, Point, Point)>,
    /// Accelerations: words, and the direction in which they push the soil.
    shaking: Vec<(String, Point)>,
}

/// A load along a straight side: pressure, and shear stress on the soil along it, at both ends.
#[derive(Debug, Clone)]
struct Load {
    ends: [Point; 2],
    pressure: [f64; 2],
    shear: [f64; 2],
    /// Whether its factor is what is bounded.
    live: bool,
}

impl Scene {
    /// The drawing, and the size at which it is legible.
    ///
    /// # Errors
    /// [`PageError`] if it cannot be drawn.
    pub(crate) fn figure(&self) -> Result<(Figure, Size), PageError> {
        let axis = |name: &str| Axis::linear(format!("{name} ({})", self.length_name));
        let mut figure = Figure::new(self.title.clone(), axis("x"), axis("y")).with_equal_aspect()?;
        let scale = Scale::new(self.sides.iter().flat_map(|(ends, _)| ends));
        for (i, (name, parts)) in self.soils.iter().enumerate() {
            figure.push(Polygons::new(name, parts.clone()).color(SOILS[i % SOILS.len()]))?;
        }
        if !self.ponds.is_empty() {
            let ponds: Vec<Polygon> = self.ponds.iter().map(|corners| Polygon::new(ring(corners))).collect();
            figure.push(Polygons::new("open water", ponds).color(WATER))?;
        }
        if !self.interfaces.is_empty() {
            let lines: Vec<_> = self.interfaces.iter().map(|line| ring(line)).collect();
            figure.push(Paths::new("", lines).width(1.0).color(INK))?;
        }
        self.add_members(&mut figure)?;
        self.add_structures(&mut figure)?;
        supports::add(&mut figure, &self.sides, &scale)?;
        water::add(&mut figure, &self.table, &scale)?;
        heads::add(&mut figure, self)?;
        acting::add(&mut figure, self, &scale)?;
        let entries = figure.layers().iter().filter(|layer| !layer.name().is_empty()).count();
        Ok((figure, scale.size(entries)?))
    }

    /// Thick lines, alike where they bear alike.
    fn add_members(&self, figure: &mut Figure) -> Result<(), PageError> {
        let mut kinds: Vec<(&str, Vec<&[Point; 2]>)> = Vec::new();
        for (words, ends) in &self.members {
            match kinds.iter_mut().find(|(known, _)| known == words) {
                Some((_, all)) => all.push(ends),
                None => kinds.push((words, vec![ends])),
            }
        }
        for (i, (words, all)) in kinds.into_iter().enumerate() {
            let parts: Vec<_> = all.into_iter().map(|ends| ring(ends)).collect();
            figure.push(Paths::new(words, parts).width(3.0).color(MEMBERS[i % MEMBERS.len()]))?;
        }
        Ok(())
    }

    /// Bodies filled, faces as thick lines, and their names beside them.
    fn add_structures(&self, figure: &mut Figure) -> Result<(), PageError> {
        if !self.bodies.is_empty() {
            let parts: Vec<Polygon> =
                self.bodies.iter().map(|(_, corners)| Polygon::new(ring(corners))).collect();
            figure.push(Polygons::new("rigid structure", parts).color(INK))?;
        }
        if !self.faces.is_empty() {
            let name = if self.bodies.is_empty() { "rigid structure" } else { "" };
            let parts: Vec<_> = self.faces.iter().map(|(_, points)| ring(points)).collect();
            figure.push(Paths::new(name, parts).width(5.0).color(INK))?;
        }
        let bodies = self.bodies.iter().map(|body| (body, TextPlace::Above));
        // A plate ends where its name begins, one that lies has it above.
        let faces = self.faces.iter().map(|face| {
            let lies = face.1.iter().all(|p| p[1] == face.1[0][1]);
            (face, if lies { TextPlace::Above } else { TextPlace::Right })
        });
        for ((name, points), place) in bodies.chain(faces).filter(|((name, _), _)| !name.is_empty()) {
            let top = points.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default();
            let x = if place == TextPlace::Right { top[0] } else { middle(points)[0] };
            figure.push(Text::new(name.clone(), data([x, top[1]])).place(place))?;
        }
        Ok(())
    }
}
