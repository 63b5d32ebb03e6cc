//! Filling shapes on a pixel grid by the non-zero rule.

use super::scene::Px;

/// Calls `run(y, from, to)` for each run of pixels (`to` excluded) whose centres lie inside `rings`.
pub(crate) fn fill(rings: &[Vec<Px>], (width, height): (u32, u32), mut run: impl FnMut(i32, i32, i32)) {
    let vertical =
        |ring: &Vec<Px>| ring.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p.1), h.max(p.1)));
    let (low, high) =
        rings.iter().map(vertical).fold((f64::MAX, f64::MIN), |a, b| (a.0.min(b.0), a.1.max(b.1)));
    let first = (low - 0.5).ceil().max(0.0) as usize;
    let last = (high - 0.5).floor().min(f64::from(height) - 1.0);
    if last < first as f64 {
        return;
    }
    let mut crossings: Vec<Vec<(f64, i32)>> = vec![Vec::new(); last as usize - first + 1];
    for ring in rings {
        for (i, &to) in ring.iter().enumerate() {
            let from = ring[(i + ring.len() - 1) % ring.len()];
            add_edge(from, to, first, &mut crossings);
        }
    }
    for (row, mut edges) in crossings.into_iter().enumerate() {
        edges.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut winding = 0;
        for pair in edges.windows(2) {
            winding += pair[0].1;
            let from = (pair[0].0 - 0.5).ceil().clamp(0.0, f64::from(width)) as i32;
            let to = (pair[1].0 - 0.5).ceil().clamp(0.0, f64::from(width)) as i32;
            if winding != 0 && from < to {
                run((first + row) as i32, from, to);
            }
        }
    }
}

fn add_edge(from: Px, to: Px, first: usize, crossings: &mut [Vec<(f64, i32)>]) {
    let (upper, lower, direction) = if from.1 < to.1 { (from, to, 1) } else { (to, from, -1) };
    let begin = (upper.1 - 0.5).ceil().max(first as f64) as usize;
    let slope = (lower.0 - upper.0) / (lower.1 - upper.1);
    for (row, edges) in crossings.iter_mut().enumerate().skip(begin.saturating_sub(first)) {
        let center = (first + row) as f64 + 0.5;
        if center >= lower.1 {
            break;
        }
        edges.push((upper.0 + slope * (center - upper.1), direction));
    }
}

/// The outline of a thick polyline: a rectangle per segment and a disc per joint, all of the same
/// orientation, so that their union is filled once.
pub(crate) fn thick(points: &[Px], width: f64) -> Vec<Vec<Px>> {
    let half = width / 2.0;
    let mut path = points.to_vec();
    path.dedup();
    let mut rings = Vec::with_capacity(2 * path.len());
    for pair in path.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        let (nx, ny) = (-(b.1 - a.1) / length * half, (b.0 - a.0) / length * half);
        rings.push(vec![
            (a.0 - nx, a.1 - ny),
            (b.0 - nx, b.1 - ny),
            (b.0 + nx, b.1 + ny),
            (a.0 + nx, a.1 + ny),
        ]);
    }
    if let [_, joints @ .., _] = &path[..] {
        rings.extend(joints.iter().map(|&joint| disc(joint, half)));
    }
    rings
}

/// A polygon that is a circle to the eye.
pub(crate) fn disc(center: Px, radius: f64) -> Vec<Px> {
    let corners = ((radius * 3.0) as usize).clamp(8, 64);
    let corner = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * i as f64 / corners as f64).sin_cos();
        (center.0 + radius * cos, center.1 + radius * sin)
    };
    (0..corners).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(rings: &[Vec<Px>]) -> i32 {
        let mut area = 0;
        fill(rings, (100, 100), |_, from, to| area += to - from);
        area
    }

    #[test]
    fn fills_areas_and_leaves_holes() {
        let square = vec![(10.0, 10.0), (30.0, 10.0), (30.0, 30.0), (10.0, 30.0)];
        let hole: Vec<Px> = vec![(15.0, 15.0), (15.0, 25.0), (25.0, 25.0), (25.0, 15.0)];
        assert_eq!(area(std::slice::from_ref(&square)), 400);
        assert_eq!(area(&[square, hole]), 300);
    }

    #[test]
    fn overlaps_of_a_thick_line_count_once() {
        let bent = thick(&[(10.0, 10.0), (50.0, 10.0), (50.0, 50.0)], 8.0);
        let expected = 2.0 * 40.0 * 8.0 - 16.0 + std::f64::consts::PI * 4.0;
        assert!((f64::from(area(&bent)) - expected).abs() < 12.0, "{}", area(&bent));
    }

    #[test]
    fn shapes_beyond_the_page_are_cut() {
        assert_eq!(area(&[vec![(-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9)]]), 100 * 100);
        assert_eq!(area(&[vec![(5.0, 200.0), (9.0, 200.0), (9.0, 300.0)]]), 0);
    }
}
