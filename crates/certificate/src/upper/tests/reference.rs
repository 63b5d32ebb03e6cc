//! The piecewise cubic element, built from its definition.

/// Coefficients of `sum c_ij x^i y^j` for the three parts of a triangle's element.
type Parts = [[f64; 10]; 3];

const POWERS: [[i32; 2]; 10] =
    [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2], [3, 0], [2, 1], [1, 2], [0, 3]];

/// The derivative `d^i/dx^i d^j/dy^j` of each of the ten powers.
fn powers([x, y]: [f64; 2], [i, j]: [i32; 2]) -> [f64; 10] {
    let one = |x: f64, power: i32, order: i32| {
        let factor: i32 = (0..order).map(|k| power - k).product();
        if power < order { 0.0 } else { f64::from(factor) * x.powi(power - order) }
    };
    POWERS.map(|[p, q]| one(x, p, i) * one(y, q, j))
}

pub(super) fn derivative(part: &[f64; 10], at: [f64; 2], order: [i32; 2]) -> f64 {
    powers(at, order).iter().zip(part).map(|(a, b)| a * b).sum()
}

/// The piecewise cubic with these values and slopes at the corners `p` and these slopes across the middles of edges, with
/// continuous slopes: 30 equations for 30 coefficients.
pub(super) fn solve(p: [[f64; 2]; 3], jets: [[f64; 3]; 3], across: [f64; 3]) -> Parts {
    let mut rows: Vec<[f64; 31]> = Vec::new();
    let g = [0, 1].map(|i| (p[0][i] + p[1][i] + p[2][i]) / 3.0);
    let mut add = |terms: &[(usize, [f64; 10], f64)], value: f64| {
        let mut row = [0.0; 31];
        for (part, basis, factor) in terms {
            for (k, b) in basis.iter().enumerate() {
                row[10 * part + k] += factor * b;
            }
        }
        row[30] = value;
        rows.push(row);
    };
    let orders = [[0, 0], [1, 0], [0, 1]];
    for k in 0..3 {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        for corner in [a, b] {
            for (order, value) in orders.iter().zip(jets[corner]) {
                add(&[(k, powers(p[corner], *order), 1.0)], value);
            }
        }
        let middle = [0, 1].map(|i| (p[a][i] + p[b][i]) / 2.0);
        let [dx, dy] = [0, 1].map(|i| p[b][i] - p[a][i]);
        add(&[(k, powers(middle, [1, 0]), -dy), (k, powers(middle, [0, 1]), dx)], across[k]);
        // Across the line from corner `k` to the centroid.
        let half = [0, 1].map(|i| (p[k][i] + g[i]) / 2.0);
        let [dx, dy] = [0, 1].map(|i| g[i] - p[k][i]);
        let slope = |part, sign: f64| {
            [(part, powers(half, [1, 0]), -dy * sign), (part, powers(half, [0, 1]), dx * sign)]
        };
        add(&[slope(a, 1.0), slope(b, -1.0)].concat(), 0.0);
        if k < 2 {
            for order in orders {
                add(&[(k, powers(g, order), 1.0), (k + 1, powers(g, order), -1.0)], 0.0);
            }
        }
    }
    eliminate(&mut rows);
    [0, 1, 2].map(|part| std::array::from_fn(|k| rows[10 * part + k][30]))
}

/// Gauss and Jordan; leaves the solution in the last column.
fn eliminate(rows: &mut [[f64; 31]]) {
    let count = rows.len();
    assert_eq!(count, 30);
    for column in 0..count {
        let best = (column..count).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        rows.swap(column, best.unwrap());
        let pivot = rows[column].map(|x| x / rows[column][column]);
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[column];
            if i == column {
                *row = pivot;
            } else {
                row.iter_mut().zip(pivot).for_each(|(x, p)| *x -= factor * p);
            }
        }
    }
}

/// The sum of `of(part, point, weights of its nodes) * area` over a triangle, with `n^2` points in each part.
pub(super) fn integral(p: [[f64; 2]; 3], n: usize, of: impl Fn(usize, [f64; 2], [f64; 3]) -> f64) -> f64 {
    let g = [0, 1].map(|i| (p[0][i] + p[1][i] + p[2][i]) / 3.0);
    let mut sum = 0.0;
    for k in 0..3 {
        let (a, b) = (p[(k + 1) % 3], p[(k + 2) % 3]);
        let area = ((b[0] - a[0]) * (g[1] - a[1]) - (b[1] - a[1]) * (g[0] - a[0])) / 2.0;
        for i in 0..n * n {
            let [s, t] = [i % n, i / n].map(|i| (i as f64 + 0.5) / n as f64);
            let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
            let at = [0, 1].map(|i| a[i] + s * (b[i] - a[i]) + t * (g[i] - a[i]));
            sum += of(k, at, [1.0 - s - t, s, t]) * area / (n * n) as f64;
        }
    }
    sum
}
