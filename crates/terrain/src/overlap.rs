use crate::field::HeightField;

/// A rectangle on the table: it begins at the middle of one side and goes `length_m` ahead.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rectangle {
    /// Middle of the side that it begins with, in m.
    pub(crate) from_m: [f64; 2],
    /// Unit vector from there to the opposite side.
    pub(crate) ahead: [f64; 2],
    /// Length along it in m.
    pub(crate) length_m: f64,
    /// Width across it in m.
    pub(crate) width_m: f64,
}

impl Rectangle {
    fn corners(&self) -> [[f64; 2]; 4] {
        let [x, y] = self.from_m;
        let [c, s] = self.ahead;
        let half = 0.5 * self.width_m;
        let at = |u: f64, v: f64| [x + u * c - v * s, y + u * s + v * c];
        [at(0.0, -half), at(self.length_m, -half), at(self.length_m, half), at(0.0, half)]
    }
}

/// A quadrilateral that is cut by four lines has at most eight corners.
const MOST_CORNERS: usize = 8;

/// A convex polygon with its corners in order.
struct Polygon {
    corners: [[f64; 2]; MOST_CORNERS],
    count: usize,
}

impl Polygon {
    fn corners(&self) -> &[[f64; 2]] {
        self.corners.get(..self.count).unwrap_or_default()
    }

    fn add(&mut self, corner: [f64; 2]) {
        if let Some(place) = self.corners.get_mut(self.count) {
            *place = corner;
            self.count += 1;
        }
    }

    /// What of it lies where `sign * coordinate <= sign * limit` (Sutherland and Hodgman 1974).
    fn clipped(&self, axis: usize, limit: f64, sign: f64) -> Self {
        let mut inside = Self { corners: [[0.0; 2]; MOST_CORNERS], count: 0 };
        let corners = self.corners();
        for (i, &here) in corners.iter().enumerate() {
            let last = corners[(i + corners.len() - 1) % corners.len()];
            let (a, b) = (sign * (limit - last[axis]), sign * (limit - here[axis]));
            if (a < 0.0) != (b < 0.0) {
                let share = a / (a - b);
                inside.add([last[0] + share * (here[0] - last[0]), last[1] + share * (here[1] - last[1])]);
            }
            if b >= 0.0 {
                inside.add(here);
            }
        }
        inside
    }

    /// By the shoelace formula, about the first corner so that far corners cost no digits.
    fn area(&self) -> f64 {
        let corners = self.corners();
        let Some(&[x, y]) = corners.first() else { return 0.0 };
        let twice: f64 = corners
            .windows(2)
            .map(|pair| (pair[0][0] - x) * (pair[1][1] - y) - (pair[1][0] - x) * (pair[0][1] - y))
            .sum();
        0.5 * twice.abs()
    }
}

impl HeightField {
    /// The cells that a rectangle covers, row by row, each with the share of it that is covered, above 0 and at most 1.
    pub(crate) fn covered(&self, rectangle: &Rectangle) -> Vec<(usize, f64)> {
        let cell_m = self.cell_m();
        let corners = rectangle.corners().map(|corner| corner.map(|value| value / cell_m));
        let span = |axis: usize, count: usize| {
            let least = corners.iter().map(|corner| corner[axis]).fold(f64::INFINITY, f64::min);
            let most = corners.iter().map(|corner| corner[axis]).fold(f64::NEG_INFINITY, f64::max);
            #[allow(clippy::cast_precision_loss, reason = "at most 2^24 cells")]
            let limit = count as f64;
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 2^24")]
            let cell = |value: f64| value.max(0.0).min(limit) as usize;
            cell(least.floor())..cell(most.ceil())
        };
        let (columns, rows) = (span(0, self.columns()), span(1, self.rows()));
        let mut covered = Vec::new();
        for row in rows {
            for column in columns.clone() {
                #[allow(clippy::cast_precision_loss, reason = "at most 2^24 cells")]
                let (x, y) = (column as f64, row as f64);
                // About the cell's corner, so that its own coordinates are small.
                let mut polygon = Polygon { corners: [[0.0; 2]; MOST_CORNERS], count: 0 };
                for corner in corners {
                    polygon.add([corner[0] - x, corner[1] - y]);
                }
                for (axis, limit, sign) in [(0, 0.0, -1.0), (0, 1.0, 1.0), (1, 0.0, -1.0), (1, 1.0, 1.0)] {
                    polygon = polygon.clipped(axis, limit, sign);
                }
                let share = polygon.area().min(1.0);
                if share > 0.0 {
                    covered.push((row * self.columns() + column, share));
                }
            }
        }
        covered
    }
}
