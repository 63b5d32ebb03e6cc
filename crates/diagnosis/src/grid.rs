//! Cubic interpolation on a regular grid of three angles.

/// Equally spaced values.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Axis {
    pub(crate) start: f64,
    pub(crate) step: f64,
    pub(crate) count: usize,
}

/// Values on a grid, NaN where there is none.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    axes: [Axis; 3],
    values: Vec<f64>,
}

impl Grid {
    pub(crate) fn new(axes: [Axis; 3], f: impl Fn(f64, f64, f64) -> f64) -> Self {
        let mut values = Vec::with_capacity(axes.iter().map(|axis| axis.count).product());
        let node = |axis: &Axis, i: usize| axis.start + axis.step * i as f64;
        for i in 0..axes[0].count {
            for j in 0..axes[1].count {
                for k in 0..axes[2].count {
                    values.push(f(node(&axes[0], i), node(&axes[1], j), node(&axes[2], k)));
                }
            }
        }
        Self { axes, values }
    }

    /// The value at a point; NaN outside the grid or beside a missing value.
    pub(crate) fn at(&self, x: f64, y: f64, z: f64) -> f64 {
        let (Some(a), Some(b), Some(c)) =
            (stencil(&self.axes[0], x), stencil(&self.axes[1], y), stencil(&self.axes[2], z))
        else {
            return f64::NAN;
        };
        let (rows, columns) = (self.axes[1].count, self.axes[2].count);
        let mut sum = 0.0;
        for &(i, wi) in &a {
            if wi == 0.0 {
                continue;
            }
            for &(j, wj) in &b {
                if wj == 0.0 {
                    continue;
                }
                let row = (i * rows + j) * columns;
                for &(k, wk) in &c {
                    if wk != 0.0 {
                        sum += wi * wj * wk * self.values[row + k];
                    }
                }
            }
        }
        sum
    }
}

/// Four nodes around a value and their weights (Catmull-Rom inside, a parabola in the outermost cells).
fn stencil(axis: &Axis, x: f64) -> Option<[(usize, f64); 4]> {
    let position = (x - axis.start) / axis.step;
    let last = axis.count - 1;
    if !(-1e-9..=last as f64 + 1e-9).contains(&position) {
        return None;
    }
    let position = position.clamp(0.0, last as f64);
    // In range by the check above.
    let cell = (position as usize).min(last.saturating_sub(1));
    let t = position - cell as f64;
    if t == 0.0 {
        return Some([(cell, 1.0), (cell, 0.0), (cell, 0.0), (cell, 0.0)]);
    }
    if t == 1.0 {
        return Some([(cell + 1, 1.0), (cell, 0.0), (cell, 0.0), (cell, 0.0)]);
    }
    let parabola = |first: usize, s: f64| {
        [
            (first, 0.5 * (s - 1.0) * (s - 2.0)),
            (first + 1, s * (2.0 - s)),
            (first + 2, 0.5 * s * (s - 1.0)),
            (first, 0.0),
        ]
    };
    Some(if cell == 0 {
        parabola(0, t)
    } else if cell + 1 == last {
        parabola(cell - 1, 1.0 + t)
    } else {
        let (t2, t3) = (t * t, t * t * t);
        [
            (cell - 1, 0.5 * (-t3 + 2.0 * t2 - t)),
            (cell, 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0)),
            (cell + 1, 0.5 * (-3.0 * t3 + 4.0 * t2 + t)),
            (cell + 2, 0.5 * (t3 - t2)),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_are_exact_everywhere() {
        let axis = |count| Axis { start: -1.0, step: 0.5, count };
        let f = |x: f64, y: f64, z: f64| 1.0 + x * x - 2.0 * y * y + x * y + 0.5 * z * z - z;
        let grid = Grid::new([axis(5), axis(6), axis(7)], f);
        for (x, y, z) in [(-1.0, -0.9, 1.9), (0.99, 1.3, 0.1), (0.2, 0.0, -0.6), (1.0, 1.5, 2.0)] {
            assert!((grid.at(x, y, z) - f(x, y, z)).abs() < 1e-12);
        }
        assert!(grid.at(1.01, 0.0, 0.0).is_nan());
    }
}
