//! Many lines at once.

use super::frame::Frame;
use super::svg::{Pen, Svg};
use crate::model::Paths;
use crate::palette::{NEUTRAL, series};

pub(crate) fn draw_paths(paths: &Paths, frame: &Frame, svg: &mut Svg) {
    let color = paths.color.map_or(NEUTRAL, series);
    let mut heads = Vec::new();
    let mut lines = Vec::new();
    for part in &paths.parts {
        let mut points = frame.all(part);
        if let Some([left, tip, right]) = paths.head(part) {
            let head = frame.all(&[left, tip, right]);
            let neck = frame.at(((left.0 + right.0) / 2.0, (left.1 + right.1) / 2.0));
            // On a logarithmic axis a head may reach below zero, where there is no place for it.
            if head.iter().chain([&neck]).all(|place| place.0.is_finite() && place.1.is_finite()) {
                // The line ends inside of the head, whose tip stays sharp.
                points.pop();
                points.push(neck);
                heads.push(head);
            }
        }
        lines.push(points);
    }
    svg.stroke(&frame.cut_lines(lines), Pen::solid(paths.width, color));
    svg.fill(&frame.cut_rings(heads), color, 1.0);
}
