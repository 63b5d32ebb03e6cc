//! Many lines at once.

use super::areas::stroke;
use super::clip;
use super::frame::Frame;
use super::scene::Scene;
use crate::model::Paths;
use crate::palette::{Dash, NEUTRAL, series};

pub(crate) fn draw_paths(paths: &Paths, frame: &Frame, scene: &mut Scene) {
    let color = paths.color.map_or(NEUTRAL, series);
    let mut heads = Vec::new();
    for part in &paths.parts {
        let mut points = frame.all(part);
        if let Some([left, tip, right]) = paths.head(part) {
            // The line ends inside of the head, whose tip stays sharp.
            let base = frame.at(((left.0 + right.0) / 2.0, (left.1 + right.1) / 2.0));
            points.pop();
            points.push(base);
            let ring = clip::ring(&frame.all(&[left, tip, right]), &frame.plot);
            if ring.len() > 2 {
                heads.push(ring);
            }
        }
        stroke(&points, Dash::Solid, paths.width, color, frame, scene);
    }
    if !heads.is_empty() {
        scene.fill(heads, color, 1.0);
    }
}
