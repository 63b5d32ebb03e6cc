//! Flows whose exact solution is known.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::f64::consts::PI;

use soilctl_seepage::{Boundary, Condition, Flow, Ground, SeepageError, Triangle};

/// A rectangle from `low` to `high` in `count` steps, diagonals in turn, with one permeability.
fn grid(
    low: [f64; 2],
    high: [f64; 2],
    count: [usize; 2],
    permeability: impl Fn([f64; 2]) -> [f64; 2],
) -> Ground {
    let [nx, ny] = count;
    let at = |i: usize, n: usize, axis: usize| low[axis] + (high[axis] - low[axis]) * i as f64 / n as f64;
    let mut ground = Ground::default();
    for i in 0..=nx {
        for j in 0..=ny {
            ground.points.push([at(i, nx, 0), at(j, ny, 1)]);
        }
    }
    let index = |i: usize, j: usize| i * (ny + 1) + j;
    for i in 0..nx {
        for j in 0..ny {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            let two = if (i + j) % 2 == 0 { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] };
            let middle = [0, 1].map(|k| 0.5 * (ground.points[a][k] + ground.points[c][k]));
            ground
                .triangles
                .extend(two.map(|corners| Triangle { corners, permeability: permeability(middle) }));
        }
    }
    ground
}

/// Adds what holds along the outline of a rectangle: for each edge, by its middle.
fn hold(ground: &mut Ground, condition: impl Fn([f64; 2]) -> Option<Condition>) {
    let mut count = std::collections::BTreeMap::new();
    for (t, triangle) in ground.triangles.iter().enumerate() {
        for k in 0..3 {
            let [a, b] = [1, 2].map(|i| triangle.corners[(k + i) % 3]);
            count.entry([a.min(b), a.max(b)]).or_insert_with(Vec::new).push((t, k));
        }
    }
    for ([a, b], sides) in count {
        let [p, q] = [a, b].map(|i| ground.points[i]);
        let middle = [0, 1].map(|i| 0.5 * (p[i] + q[i]));
        if let ([(triangle, opposite)], Some(condition)) = (sides.as_slice(), condition(middle)) {
            ground.boundaries.push(Boundary { triangle: *triangle, opposite: *opposite, condition });
        }
    }
}

fn head(entry: usize, head: f64) -> Option<Condition> {
    Some(Condition::Head { head, entry })
}

/// Nothing is lost.
fn assert_kept(flow: &Flow) {
    let in_all: f64 = flow.inflow.iter().sum::<f64>() + flow.air;
    let most = flow.inflow.iter().fold(0.0_f64, |m, q| m.max(q.abs()));
    assert!(in_all.abs() <= 1e-8 * most, "{flow:?}");
}

/// Complete elliptic integral of the first kind, by the arithmetic-geometric mean.
fn elliptic(modulus: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - modulus * modulus).sqrt());
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

/// Flow below a sheet pile that goes `depth` into a layer of thickness one, over permeability and loss of head.
fn below_sheet_pile(depth: f64, steps: usize) -> Flow {
    let mut ground = grid([-4.0, -1.0], [4.0, 0.0], [8 * steps, steps], |_| [1e-5, 1e-5]);
    hold(&mut ground, |[x, y]| {
        if y == 0.0 { head(usize::from(x > 0.0), if x < 0.0 { 3.0 } else { 1.0 }) } else { None }
    });
    let on = |p: [f64; 2]| p[0] == 0.0 && p[1] >= -depth - 1e-9;
    let index = |i: usize| i;
    let column: Vec<usize> = (0..ground.points.len()).map(index).filter(|i| on(ground.points[*i])).collect();
    ground.walls = column.windows(2).map(|w| [w[0], w[1]]).collect();
    ground.flow().unwrap()
}

#[test]
fn a_sheet_pile_in_a_layer() {
    // Harr (1962), section 5-3: q / (k h) = K' / (2 K) with the modulus sin(pi s / 2 T).
    for depth in [0.25, 0.5, 0.75] {
        let modulus = (0.5 * PI * depth).sin();
        let exact = elliptic((1.0 - modulus * modulus).sqrt()) / (2.0 * elliptic(modulus));
        let error = |steps: usize| {
            let flow = below_sheet_pile(depth, steps);
            assert_kept(&flow);
            (flow.inflow[0] / (1e-5 * 2.0) / exact - 1.0).abs()
        };
        let (coarse, fine) = (error(16), error(32));
        assert!(fine < 0.025, "{depth}: {fine}");
        // The square root at the tip halves the error with the size.
        assert!(coarse / fine > 1.8, "{depth}: {coarse} {fine}");
    }
}

/// A dam with upright faces on rock.
fn dam(steps: usize, levels: [f64; 2], long: f64) -> Flow {
    let high = 1.2 * levels[0];
    let count = [steps, (high / long * steps as f64).round() as usize];
    let mut ground = grid([0.0, 0.0], [long, high], count, |_| [1e-4, 1e-4]);
    hold(&mut ground, |[x, y]| match () {
        () if x == 0.0 && y < levels[0] => head(0, levels[0]),
        () if x == long && y < levels[1] => head(1, levels[1]),
        () if y > 0.0 => Some(Condition::Air),
        () => None,
    });
    ground.flow().unwrap()
}

#[test]
fn a_dam_with_upright_faces() {
    // Charny (1951): Dupuit's formula for what flows through is exact, seepage face and all.
    for (levels, long) in [([10.0, 2.0], 5.0), ([10.0, 0.0], 20.0), ([6.0, 5.0], 10.0)] {
        let exact = 1e-4 * (levels[0] * levels[0] - levels[1] * levels[1]) / (2.0 * long);
        let error = |steps: usize| {
            let flow = dam(steps, levels, long);
            assert_kept(&flow);
            (flow.inflow[0] / exact - 1.0).abs()
        };
        let (coarse, fine) = (error(10), error(40));
        assert!(fine < 0.015 && fine < 0.5 * coarse, "{levels:?} {long}: {coarse} {fine}");
    }
}

#[test]
fn water_comes_out_above_the_tailwater_only() {
    let flow = dam(20, [10.0, 2.0], 5.0);
    assert!(flow.air < 0.0 && flow.inflow[1] < 0.0, "{flow:?}");
}

#[test]
fn flow_is_linear_along_a_column_and_through_layers() {
    for head_below in [5.0, 2.2, 2.0] {
        let layers = |p: [f64; 2]| if p[1] < 1.0 { [1e-6, 2e-6] } else { [1e-3, 4e-6] };
        let mut ground = grid([0.0, 0.0], [1.0, 2.0], [3, 8], layers);
        hold(&mut ground, |[_, y]| match () {
            () if y == 0.0 => head(0, head_below),
            () if y == 2.0 => Some(Condition::Air),
            () => None,
        });
        let flow = ground.flow().unwrap();
        let exact = (head_below - 2.0) / (1.0 / 2e-6 + 1.0 / 4e-6);
        assert!((flow.inflow[0] - exact).abs() < 1e-14, "{head_below}: {flow:?}");
    }
}

#[test]
fn permeability_along_one_axis_stretches_the_ground() {
    // With x over the square root of kx / ky the flow is that of isotropic soil of permeability sqrt(kx ky).
    let flow = |stretch: f64, permeability: [f64; 2]| {
        let mut ground = grid([0.0, 0.0], [5.0 * stretch, 12.0], [10, 24], |_| permeability);
        hold(&mut ground, |[x, y]| match () {
            () if x == 0.0 && y < 10.0 => head(0, 10.0),
            () if x == 5.0 * stretch && y < 2.0 => head(1, 2.0),
            () if y > 0.0 => Some(Condition::Air),
            () => None,
        });
        ground.flow().unwrap()
    };
    let (plain, wide) = (flow(1.0, [6e-6, 6e-6]), flow(3.0, [18e-6, 2e-6]));
    for (a, b) in plain.heads.iter().flatten().zip(wide.heads.iter().flatten()) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
    assert!((plain.inflow[0] / wide.inflow[0] - 1.0).abs() < 1e-7);
}

#[test]
fn water_at_rest_stays_so() {
    let flow = dam(8, [4.0, 4.0], 6.0);
    assert!(flow.heads.iter().flatten().all(|h| (h - 4.0).abs() < 1e-9), "{flow:?}");
    assert!(flow.inflow.iter().all(|q| q.abs() < 1e-15) && flow.air.abs() < 1e-15);
}

#[test]
fn finer_triangles_are_the_same_ground() {
    let mut ground = grid([-2.0, -1.0], [2.0, 0.0], [4, 2], |_| [1e-5, 1e-5]);
    hold(&mut ground, |[x, y]| {
        if y == 0.0 { head(usize::from(x > 0.0), if x < 0.0 { 1.0 } else { 0.0 }) } else { None }
    });
    let on = |i: &usize| ground.points[*i][0] == 0.0 && ground.points[*i][1] >= -0.5;
    let column: Vec<usize> = (0..ground.points.len()).filter(on).collect();
    ground.walls = column.windows(2).map(|w| [w[0], w[1]]).collect();
    let finer = ground.refined().unwrap().refined().unwrap();
    assert_eq!(finer.triangles.len(), 16 * ground.triangles.len());
    assert_eq!(
        (finer.walls.len(), finer.boundaries.len()),
        (4 * ground.walls.len(), 4 * ground.boundaries.len())
    );
    let exact = 0.5;
    let [coarse, fine] = [&ground, &finer].map(|g| g.flow().unwrap().inflow[0] / 1e-5);
    // Finite elements let too much through, and a wall lets nothing through.
    assert!(coarse > fine && fine > exact && fine < 1.15 * exact, "{coarse} {fine}");
    for (t, triangle) in ground.triangles.iter().enumerate() {
        assert_eq!(finer.triangles[16 * t].corners[0], triangle.corners[0]);
        let area = |g: &Ground, t: usize| {
            let [a, b, c] = g.triangles[t].corners.map(|i| g.points[i]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        };
        let parts: f64 = (16 * t..16 * (t + 1)).map(|part| area(&finer, part)).sum();
        assert!((parts - area(&ground, t)).abs() < 1e-12);
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let good = || {
        let mut ground = grid([0.0, 0.0], [1.0, 1.0], [2, 2], |_| [1e-5, 1e-5]);
        hold(&mut ground, |[_, y]| if y == 0.0 { head(0, 2.0) } else { None });
        ground
    };
    assert!(good().flow().is_ok());
    let with = |change: fn(&mut Ground)| {
        let mut ground = good();
        change(&mut ground);
        ground.flow().unwrap_err()
    };
    assert!(matches!(with(|g| g.boundaries.clear()), SeepageError::NoHead { .. }));
    assert!(matches!(with(|g| g.triangles[0].corners[1] = 99), SeepageError::Index { what: "point", .. }));
    assert!(matches!(with(|g| g.boundaries[0].opposite = 3), SeepageError::Index { what: "corner", .. }));
    assert!(matches!(with(|g| g.triangles[0].corners.swap(0, 1)), SeepageError::Flat { triangle: 0 }));
    assert!(matches!(with(|g| g.triangles.push(g.triangles[0])), SeepageError::Crowded { .. }));
    assert!(matches!(with(|g| g.triangles[0].permeability[0] = 0.0), SeepageError::Number { .. }));
    assert!(matches!(with(|g| g.points[0][0] = f64::NAN), SeepageError::Number { .. }));
    let parted = with(|g| {
        let apart = g.points.len();
        g.points.extend([[5.0, 0.0], [6.0, 0.0], [5.0, 1.0]]);
        g.triangles.push(Triangle { corners: [apart, apart + 1, apart + 2], permeability: [1e-5; 2] });
    });
    assert_eq!(parted, SeepageError::NoHead { at: [5.0, 0.0] });
}
