//! The soil beyond far lines.

use crate::CertificateError;
use crate::statement::{Boundary, Condition, Objective, Statement};

/// Which sides of the mesh are far. They frame it: all else lies within the rectangle that they are part of, and the
/// soil beyond fills what is left of the strips and quadrants around it, up to where the far side on its hand starts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FarFrame {
    /// At the least x of all points, from anywhere down to the least y.
    pub(crate) left: bool,
    /// At the greatest x, likewise.
    pub(crate) right: bool,
    /// At the least y, from the least x to the greatest.
    pub(crate) below: bool,
    /// Least x, greatest x, least y.
    pub(crate) limits: [f64; 3],
}

/// A far or other boundary side, walked with the soil on the left.
struct Walked {
    from: [f64; 2],
    to: [f64; 2],
    condition: Condition,
}

impl FarFrame {
    /// Finds the frame and checks that far lines make one.
    pub(super) fn new(statement: &Statement) -> Result<Self, CertificateError> {
        let walked = |b: &Boundary| {
            let [from, to] = statement.lines[b.line].walked(b.forward).map(|i| statement.points[i]);
            Walked { from, to, condition: b.condition }
        };
        let sides: Vec<Walked> = statement.boundaries.iter().map(walked).collect();
        let (x, y) = (|p: &[f64; 2]| p[0], |p: &[f64; 2]| p[1]);
        let least = |of: fn(&[f64; 2]) -> f64| statement.points.iter().map(of).fold(f64::INFINITY, f64::min);
        let limits = [least(x), -least(|p| -p[0]), least(y)];
        let [x_min, x_max, y_min] = limits;
        // Each part of the frame: the coordinate that is constant along it, its value, where it starts and ends, if that
        // is not up to it.
        let parts = [
            ("the left far side", 0, x_min, [None, Some(y_min)]),
            ("the right far side", 0, x_max, [Some(y_min), None]),
            ("the far side below", 1, y_min, [Some(x_min), Some(x_max)]),
        ];
        let mut frame = Self { limits, ..Self::default() };
        let mut found = 0;
        for (part, (name, axis, at, ends)) in parts.into_iter().enumerate() {
            // Only the left one is walked towards lesser values.
            let rises = part > 0;
            let on = |s: &&Walked| {
                let level = s.from[axis] == at && s.to[axis] == at;
                level && (s.to[1 - axis] > s.from[1 - axis]) == rises
            };
            let far = |s: &&Walked| s.condition == Condition::Far;
            let mut run: Vec<[f64; 2]> =
                sides.iter().filter(on).filter(far).map(|s| [s.from[1 - axis], s.to[1 - axis]]).collect();
            found += run.len();
            if run.is_empty() {
                continue;
            }
            run.sort_by(|a, b| a[0].total_cmp(&b[0]));
            if !rises {
                run.reverse();
            }
            let joined = run.windows(2).all(|w| w[0][1] == w[1][0]);
            let found_ends = [run[0][0], run[run.len() - 1][1]];
            let whole = ends.into_iter().zip(found_ends).all(|(end, found)| end.is_none_or(|e| e == found));
            if !(joined && whole) {
                let what = "must run without a gap: left and right down to the lowest point, below from the leftmost \
                            point to the rightmost";
                return Err(CertificateError::NotCovered { place: name.into(), what });
            }
            *[&mut frame.left, &mut frame.right, &mut frame.below][part] = true;
        }
        if sides.iter().filter(|s| s.condition == Condition::Far).count() != found {
            let what = "far lines must be vertical at the least or greatest x, or level at the least y";
            return Err(CertificateError::NotCovered { place: "far lines".into(), what });
        }
        frame.check_corners(statement, &sides)?;
        Ok(frame)
    }

    /// Where only one of the two sides at a lower corner is far, the other one must be a wall or base that goes on
    /// beyond the corner: fixed, or smooth without shear stress in the reference.
    fn check_corners(&self, statement: &Statement, sides: &[Walked]) -> Result<(), CertificateError> {
        let [x_min, x_max, y_min] = self.limits;
        let level_force = matches!(statement.objective, Objective::Body { gravity: [x, _] } if x != 0.0);
        let no_shear = statement.gravity[0] == 0.0 && !level_force;
        let corners = [("lower left", x_min, self.left), ("lower right", x_max, self.right)];
        for (name, x, side_is_far) in corners {
            if side_is_far == self.below {
                continue;
            }
            let corner = [x, y_min];
            // The axis that does not change along the side that is not far.
            let axis = usize::from(side_is_far);
            let goes_on = sides.iter().any(|s| {
                let there = (s.from == corner || s.to == corner) && s.from[axis] == s.to[axis];
                let holds = match s.condition {
                    Condition::Fixed => true,
                    Condition::Smooth => no_shear,
                    _ => false,
                };
                there && holds
            });
            if !goes_on {
                let what = "where one side is far, the other must be far, fixed or (with vertical gravity) smooth, and \
                            vertical or level";
                return Err(CertificateError::NotCovered { place: format!("the {name} corner"), what });
            }
        }
        Ok(())
    }
}
