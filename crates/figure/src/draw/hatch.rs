//! Lines across areas, so that areas are told apart without colours.

use super::dash::dashes;
use super::scene::{Px, Scene};
use crate::palette::{Hatch, Rgb, faint};

/// Between two lines, in px.
const SPACING: f64 = 9.0;
const WIDTH: f64 = 0.9;

/// Hatches rings that are filled by the non-zero rule.
pub(crate) fn draw_hatch(rings: &[Vec<Px>], hatch: Hatch, color: Rgb, scene: &mut Scene) {
    for &(x, y) in hatch.directions() {
        let size = f64::hypot(x, y);
        let (x, y) = (x / size, y / size);
        // In coordinates along and across the lines, which are those of the page: neighbours' lines meet.
        let turned: Vec<Vec<Px>> = rings
            .iter()
            .map(|ring| ring.iter().map(|p| (p.0 * x + p.1 * y, p.1 * x - p.0 * y)).collect())
            .collect();
        for [from, to] in across(&turned) {
            let back = |p: Px| (p.0 * x - p.1 * y, p.0 * y + p.1 * x);
            for piece in dashes(&[back(from), back(to)], hatch.pattern(), WIDTH) {
                scene.stroke(piece, WIDTH, faint(color));
            }
        }
    }
}

/// The parts of lines of constant `y` that are inside of rings.
fn across(rings: &[Vec<Px>]) -> Vec<[Px; 2]> {
    let edges = || rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let (low, high) =
        edges().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (p, _)| (low.min(p.1), high.max(p.1)));
    if low > high {
        return Vec::new();
    }
    let mut parts = Vec::new();
    // Both are finite, and a page has at most some thousand lines.
    #[allow(clippy::cast_possible_truncation, reason = "places on a page")]
    let (first, last) = ((low / SPACING).ceil() as i64, (high / SPACING).floor() as i64);
    for number in first..=last {
        #[allow(clippy::cast_precision_loss, reason = "small")]
        let y = number as f64 * SPACING;
        let mut crossings: Vec<(f64, i32)> = edges()
            .filter(|(p, q)| (p.1 <= y) != (q.1 <= y))
            .map(|(p, q)| (p.0 + (y - p.1) / (q.1 - p.1) * (q.0 - p.0), if q.1 > p.1 { 1 } else { -1 }))
            .collect();
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].1;
            if winding != 0 {
                parts.push([(pair[0].0, y), (pair[1].0, y)]);
            }
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_inside_only() {
        let square = |low: f64, high: f64| vec![(low, low), (high, low), (high, high), (low, high)];
        // A hole runs the other way.
        let mut hole = square(20.0, 50.0);
        hole.reverse();
        let parts = across(&[square(1.0, 80.0), hole]);
        let at = |y: f64| parts.iter().filter(|[p, _]| p.1 == y).map(|[p, q]| (p.0, q.0)).collect::<Vec<_>>();
        assert_eq!(at(9.0), [(1.0, 80.0)]);
        assert_eq!(at(36.0), [(1.0, 20.0), (50.0, 80.0)]);
        // 9, 18, 27 ... 72; three of them through the hole.
        assert_eq!(parts.len(), 8 + 3);
        assert!(across(&[]).is_empty());
    }
}
