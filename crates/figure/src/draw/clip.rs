//! Cutting lines and rings at the edges of a rectangle.

use super::px::Px;

/// A rectangle on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub(crate) fn contains(&self, p: Px) -> bool {
        // Points on the edge stay in despite rounding.
        let slack = 1e-6;
        (self.left - slack..=self.right + slack).contains(&p.0)
            && (self.top - slack..=self.bottom + slack).contains(&p.1)
    }

    pub(crate) fn ring(&self) -> Vec<Px> {
        vec![
            (self.left, self.top),
            (self.right, self.top),
            (self.right, self.bottom),
            (self.left, self.bottom),
        ]
    }

    /// The ring with its first corner once more at the end.
    pub(crate) fn outline(&self) -> Vec<Px> {
        let mut line = self.ring();
        line.push((self.left, self.top));
        line
    }

    /// The four half planes as (axis, limit, sign): inside where `sign * (p[axis] - limit) >= 0`.
    fn edges(&self) -> [(usize, f64, f64); 4] {
        [(0, self.left, 1.0), (0, self.right, -1.0), (1, self.top, 1.0), (1, self.bottom, -1.0)]
    }
}

/// The parts of a polyline inside a rectangle.
pub(crate) fn polyline(points: &[Px], rect: &Rect) -> Vec<Vec<Px>> {
    let mut parts: Vec<Vec<Px>> = Vec::new();
    let mut joined = false;
    for pair in points.windows(2) {
        let Some((from, to, leaves)) = segment(pair[0], pair[1], rect) else {
            joined = false;
            continue;
        };
        match parts.last_mut() {
            Some(part) if joined => part.push(to),
            _ => parts.push(vec![from, to]),
        }
        joined = !leaves;
    }
    parts
}

/// The part of a segment inside a rectangle (Liang and Barsky), and whether its end was cut off.
fn segment(a: Px, b: Px, rect: &Rect) -> Option<(Px, Px, bool)> {
    let delta = [b.0 - a.0, b.1 - a.1];
    let start = [a.0, a.1];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (axis, limit, sign) in rect.edges() {
        let (speed, room) = (sign * delta[axis], sign * (start[axis] - limit));
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed > 0.0 {
            enter = enter.max(-room / speed);
        } else {
            leave = leave.min(room / -speed);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |t: f64| (start[0] + t * delta[0], start[1] + t * delta[1]);
    let from = if enter > 0.0 { at(enter) } else { a };
    let to = if leave < 1.0 { at(leave) } else { b };
    Some((from, to, leave < 1.0))
}

/// The part of a ring inside a rectangle (Sutherland and Hodgman); empty if nothing is left.
pub(crate) fn ring(points: &[Px], rect: &Rect) -> Vec<Px> {
    let mut current = points.to_vec();
    for (axis, limit, sign) in rect.edges() {
        let coordinate = |p: Px| if axis == 0 { p.0 } else { p.1 };
        let room = |p: Px| sign * (coordinate(p) - limit);
        let mut kept = Vec::with_capacity(current.len() + 4);
        for (i, &to) in current.iter().enumerate() {
            let from = current[(i + current.len() - 1) % current.len()];
            let (before, after) = (room(from), room(to));
            if (before < 0.0) != (after < 0.0) {
                let t = before / (before - after);
                kept.push((from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1)));
            }
            if after >= 0.0 {
                kept.push(to);
            }
        }
        current = kept;
    }
    current
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECT: Rect = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };

    #[test]
    fn lines_are_cut_where_they_leave() {
        let parts = polyline(&[(-5.0, 5.0), (5.0, 5.0), (15.0, 5.0), (15.0, 8.0), (5.0, 8.0)], &RECT);
        assert_eq!(parts, [vec![(0.0, 5.0), (5.0, 5.0), (10.0, 5.0)], vec![(10.0, 8.0), (5.0, 8.0)]]);
        assert!(polyline(&[(-5.0, -5.0), (15.0, -5.0)], &RECT).is_empty());
    }

    #[test]
    fn rings_are_cut_at_the_edges() {
        let cut = ring(&[(5.0, 5.0), (15.0, 5.0), (15.0, 7.0), (5.0, 7.0)], &RECT);
        assert_eq!(cut, [(5.0, 5.0), (10.0, 5.0), (10.0, 7.0), (5.0, 7.0)]);
        assert!(ring(&[(20.0, 0.0), (30.0, 0.0), (30.0, 5.0)], &RECT).is_empty());
    }
}
