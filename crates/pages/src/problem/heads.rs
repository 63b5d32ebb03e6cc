//! Ground water that flows: its free surface, lines of equal head, and open water where a head is above the ground.

use soilctl_app::solve::BoundaryKind;
use soilctl_app::text::number;
use soilctl_figure::{Figure, Paths, Text, TextPlace};
use soilctl_limit_analysis::describe::{Flowed, HeadEntry};
use soilctl_limit_analysis::results::Point;

use super::place::{between, data, middle, ring};
use super::{Load, Scene, WATER};
use crate::PageError;

/// Points this close to a line, as a part of its length, are on it.
const ON: f64 = 1e-6;

impl Scene {
    /// Open water above the ground instead of the arrows for its pressure, and the flow.
    pub(super) fn flow(&mut self, heads: &[HeadEntry], weight: f64, flowed: &Flowed) {
        let head_at = |p: Point| heads.iter().find(|head| is_on(&head.line, p)).map(|head| head.head_m);
        let depth = |head: f64, p: Point| (head - p[1]).max(0.0);
        let is_water = |load: &Load| {
            let Some(head) = head_at(between(load.ends, 0.5)) else { return false };
            let expected = load.ends.map(|p| self.surcharge + weight * depth(head, p));
            let near = |i: usize| (load.pressure[i] - expected[i]).abs() <= 1e-6 * expected[i].abs();
            load.shear == [0.0; 2] && !load.live && near(0) && near(1)
        };
        let (under, others): (Vec<_>, Vec<_>) = self.loads.drain(..).partition(is_water);
        self.loads = others;
        self.sides.extend(under.iter().map(|load| (load.ends, BoundaryKind::Free)));
        for HeadEntry { line, head_m, .. } in heads {
            let is_wet = |(ends, kind): &&([Point; 2], BoundaryKind)| {
                let p = between(*ends, 0.5);
                *kind == BoundaryKind::Free && p[1] < *head_m && is_on(line, p)
            };
            let wet: Vec<[Point; 2]> = self.sides.iter().filter(is_wet).map(|(ends, _)| *ends).collect();
            let xs = || wet.iter().flatten().map(|p| p[0]);
            let [low, high] = [xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max)];
            if low < high {
                self.table.push(vec![[low, *head_m], [high, *head_m]]);
            }
            let pond = |[a, b]: &[Point; 2]| vec![*a, *b, [b[0], *head_m], [a[0], *head_m]];
            self.ponds.extend(wet.iter().map(pond));
        }
        self.free_surface = flowed.free_surface.iter().map(|piece| piece.to_vec()).collect();
        self.equipotentials = flowed.equipotentials.iter().map(|piece| piece.to_vec()).collect();
        let word = |head: &HeadEntry| {
            let name = head.name.as_ref().map_or_else(String::new, |name| format!("{name}: "));
            (format!("{name}head {} m", number(head.head_m)), middle(&head.line))
        };
        self.heads = heads.iter().map(word).collect();
    }
}

/// Whether a point is on a line.
fn is_on(line: &[Point], p: Point) -> bool {
    line.windows(2).any(|w| {
        let ab = [w[1][0] - w[0][0], w[1][1] - w[0][1]];
        let ap = [p[0] - w[0][0], p[1] - w[0][1]];
        let square = ab[0] * ab[0] + ab[1] * ab[1];
        let part = (ap[0] * ab[0] + ap[1] * ab[1]) / square;
        (-ON..=1.0 + ON).contains(&part) && (ab[0] * ap[1] - ab[1] * ap[0]).abs() <= ON * square
    })
}

pub(super) fn add(figure: &mut Figure, scene: &Scene) -> Result<(), PageError> {
    let paths = |lines: &[Vec<Point>]| lines.iter().map(|line| ring(line)).collect::<Vec<_>>();
    if !scene.equipotentials.is_empty() {
        let lines = Paths::new("equal head, in tenths of the loss", paths(&scene.equipotentials));
        figure.push(lines.width(0.8).color(WATER))?;
    }
    if !scene.free_surface.is_empty() {
        figure.push(Paths::new("phreatic surface", paths(&scene.free_surface)).width(2.5).color(WATER))?;
    }
    for (words, at) in &scene.heads {
        figure.push(Text::new(words.clone(), data(*at)).place(TextPlace::Above))?;
    }
    Ok(())
}
