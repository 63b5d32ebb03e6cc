//! How far strokes lie from each other and from the walls of the box, seen from above.

/// The plate's lower edge, end to end, in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    ends: [[f64; 2]; 2],
}

impl Edge {
    /// An edge of this width about `tip_m`, across the line to the base axis.
    pub(super) fn new(tip_m: [f64; 2], width_m: f64) -> Option<Self> {
        let radius = tip_m[0].hypot(tip_m[1]);
        (radius > 0.0).then(|| {
            let across = [-tip_m[1] / radius, tip_m[0] / radius];
            Self { ends: [-0.5, 0.5].map(|side| [0, 1].map(|i| tip_m[i] + side * width_m * across[i])) }
        })
    }

    /// Least distance to another edge in m; 0 if they cross.
    pub(super) fn distance_m(&self, other: &Self) -> f64 {
        if self.crosses(other) {
            return 0.0;
        }
        let to = |edge: &Self, points: &Self| {
            points.ends.iter().map(|p| edge.distance_to_m(*p)).fold(f64::INFINITY, f64::min)
        };
        to(self, other).min(to(other, self))
    }

    fn crosses(&self, other: &Self) -> bool {
        let side = |edge: &Self, p: [f64; 2]| {
            let [[ax, ay], [bx, by]] = edge.ends;
            (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        };
        side(self, other.ends[0]) * side(self, other.ends[1]) < 0.0
            && side(other, self.ends[0]) * side(other, self.ends[1]) < 0.0
    }

    fn distance_to_m(&self, p: [f64; 2]) -> f64 {
        let [a, b] = self.ends;
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let share = (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        (p[0] - a[0] - share * dx).hypot(p[1] - a[1] - share * dy)
    }

    /// Coordinate of the end that a wall at +x, -x, +y or -y (0 to 3) touches, in m.
    pub(super) fn furthest(&self, wall: usize) -> f64 {
        let ends = self.ends.map(|end| end[usize::from(wall >= 2)]);
        if wall.is_multiple_of(2) { ends[0].max(ends[1]) } else { ends[0].min(ends[1]) }
    }

    /// Least distance to walls at +x, -x, +y, -y in m, those that are known; `None` if none is.
    pub(super) fn walls_distance_m(&self, walls_m: &[Option<f64>; 4]) -> Option<f64> {
        let gap = |(number, wall): (usize, &Option<f64>)| {
            let axis = number / 2;
            wall.map(|wall| {
                self.ends.iter().map(|end| (wall - end[axis]).abs()).fold(f64::INFINITY, f64::min)
            })
        };
        walls_m.iter().enumerate().filter_map(gap).min_by(f64::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_side_by_side_crossing_and_at_a_wall() {
        let at = |x, y| Edge::new([x, y], 0.2).unwrap();
        // Both across the x axis, one behind the other.
        assert!((at(0.4, 0.0).distance_m(&at(0.3, 0.0)) - 0.1).abs() < 1e-12);
        let turned = Edge { ends: [[0.3, 0.0], [0.5, 0.0]] };
        assert_eq!(at(0.4, 0.0).distance_m(&turned), 0.0);
        let walls = [Some(0.65), None, None, Some(-0.3)];
        assert!((at(0.4, 0.0).walls_distance_m(&walls).unwrap() - 0.2).abs() < 1e-12);
        assert_eq!(at(0.4, 0.0).walls_distance_m(&[None; 4]), None);
    }
}
