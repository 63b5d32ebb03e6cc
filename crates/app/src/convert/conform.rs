//! Polygons that were drawn side by side, made to share their corners: in a drawing they are near, and for a problem they are one.

/// A point in metres.
type Point = [f64; 2];

/// Corners that are near to an earlier one become that one, and an edge gets the corners of others that lie on it. How many were moved or put in.
pub(super) fn conform(polygons: &mut [Vec<Point>], near_m: f64) -> usize {
    let mut kept: Vec<Point> = Vec::new();
    let mut count = 0;
    for corner in polygons.iter_mut().flatten() {
        match kept.iter().find(|other| distance(**other, *corner) <= near_m) {
            Some(other) => {
                count += usize::from(other != corner);
                *corner = *other;
            }
            None => kept.push(*corner),
        }
    }
    for polygon in polygons {
        let mut whole = Vec::new();
        for (a, b) in polygon.iter().copied().zip(polygon.iter().cycle().skip(1).copied()) {
            whole.push(a);
            let mut on: Vec<(f64, Point)> =
                kept.iter().filter_map(|p| Some((part(*p, a, b, near_m)?, *p))).collect();
            on.sort_by(|p, q| p.0.total_cmp(&q.0));
            count += on.len();
            whole.extend(on.into_iter().map(|(_, p)| p));
        }
        whole.dedup();
        while whole.len() > 1 && whole.first() == whole.last() {
            whole.pop();
        }
        *polygon = whole;
    }
    count
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The part of the way from `a` to `b` at which a point lies beside it, if it is near and neither of both.
fn part(p: Point, a: Point, b: Point, near_m: f64) -> Option<f64> {
    if p == a || p == b {
        return None;
    }
    let ([x, y], [dx, dy]) = ([p[0] - a[0], p[1] - a[1]], [b[0] - a[0], b[1] - a[1]]);
    let length = dx.hypot(dy);
    let along = (x * dx + y * dy) / length;
    let off = (x * dy - y * dx).abs() / length;
    (off <= near_m && along > near_m && along < length - near_m).then(|| along / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_shared_and_edges_are_cut_where_others_end() {
        let mut polygons = vec![
            vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]],
            vec![[0.0002, -0.0003], [2.0, 0.0004], [2.0, -3.0], [0.0, -3.0]],
            vec![[2.0, 0.0], [4.0, 0.0], [4.0, -3.0], [2.0, -3.0]],
        ];
        let count = conform(&mut polygons, 1e-3);
        assert_eq!(count, 3, "{polygons:?}");
        assert_eq!(polygons[0], [[0.0, 0.0], [2.0, 0.0004], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]]);
        assert_eq!(polygons[1][..2], [[0.0, 0.0], [2.0, 0.0004]]);
        assert_eq!(polygons[2][0], [2.0, 0.0004]);
    }

    #[test]
    fn what_is_apart_stays_as_it_is() {
        let drawn =
            vec![vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0]], vec![[0.0, -0.1], [4.0, -0.1], [4.0, -2.0]]];
        let mut polygons = drawn.clone();
        assert_eq!(conform(&mut polygons, 1e-3), 0);
        assert_eq!(polygons, drawn);
    }
}
