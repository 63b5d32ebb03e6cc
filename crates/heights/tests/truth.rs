//! Ground that is made: where it broke, how much was moved and how the scanner was moved are known.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_heights::{Change, Grid, HeightMap, NoBreak, Plate, Stroke, change, stroke};
use soilctl_terrain::{HeightField, Repose, Sweep};

/// Normal deviates: sums of twelve uniform ones of a linear congruence.
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn next(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    /// A block that slides up: the edge is a step.
    Block,
    /// A heap with straight sides.
    Wedge,
    /// A heap whose foot is flatter than its top.
    Hollow,
}

#[derive(Debug, Clone, Copy)]
struct Case {
    shape: Shape,
    cell_m: f64,
    noise_m: f64,
    edge_m: f64,
    heading_deg: f64,
    tilt: [f64; 2],
    /// Sideways, and how rough the ground is.
    moved: [f64; 2],
    rough_m: f64,
    seed: u64,
}

const WIDTH: f64 = 0.12;
const TOP: f64 = 0.015;

impl Case {
    fn plate(&self) -> Plate {
        Plate { at_m: [0.02, -0.01], sd_m: 0.0, heading_deg: self.heading_deg, width_m: WIDTH }
    }

    /// Change of height at a place: a heap ahead of the plate and a furrow of 0.1 m behind it.
    fn change_m(&self, place: [f64; 2]) -> f64 {
        let [ahead, left] = self.plate().seen_from(place);
        if left.abs() > 0.5 * WIDTH {
            return 0.0;
        }
        let part = ahead / self.edge_m;
        match self.shape {
            _ if (-0.1..0.0).contains(&ahead) => -0.012,
            _ if !(0.0..1.0).contains(&part) => 0.0,
            Shape::Block => 0.4 * TOP,
            Shape::Wedge => TOP * (1.0 - part),
            Shape::Hollow => TOP * (1.0 - part).powf(1.4),
        }
    }

    /// What rose and what sank, summed over the centres of the cells.
    fn sums_m3(&self) -> [f64; 2] {
        let grid = *self.maps().0.grid();
        let of = |sign: f64| {
            let changes = (0..grid.cells()).map(|cell| (sign * self.change_m(grid.place(cell))).max(0.0));
            changes.sum::<f64>() * grid.area_m2()
        };
        [of(1.0), of(-1.0)]
    }

    fn ground_m(&self, [x, y]: [f64; 2]) -> f64 {
        self.rough_m * (libm::sin(40.0 * x + 3.0 * y) + libm::sin(31.0 * y - 7.0 * x))
    }

    fn maps(&self) -> (HeightMap, HeightMap) {
        let count = (0.6 / self.cell_m) as usize;
        let low = -0.3;
        let grid = Grid::new([count, count], [low, low], [self.cell_m, 0.0], [0.0, self.cell_m]).unwrap();
        let mut random = Normal(self.seed);
        let mut noise = || self.noise_m * random.next();
        let before = (0..grid.cells()).map(|cell| Some(self.ground_m(grid.place(cell)) + noise())).collect();
        let before = HeightMap::new(grid, before).unwrap();
        let after = (0..grid.cells()).map(|cell| {
            let place = grid.place(cell);
            let [x, y] = [0, 1].map(|axis| place[axis] - self.moved[axis]);
            let tilt = 0.004 + self.tilt[0] * place[0] + self.tilt[1] * place[1];
            Some(self.ground_m([x, y]) + self.change_m([x, y]) + tilt + noise())
        });
        (before, HeightMap::new(grid, after.collect()).unwrap())
    }

    fn ask(&self) -> (Change, Stroke) {
        let (before, after) = self.maps();
        let change = change(&before, &after, &self.plate(), 3.0, None).unwrap();
        let stroke = stroke(&before, &change, &self.plate(), 3.0).unwrap();
        (change, stroke)
    }
}

const CASE: Case = Case {
    shape: Shape::Wedge,
    cell_m: 0.004,
    noise_m: 0.0005,
    edge_m: 0.1,
    heading_deg: 0.0,
    tilt: [0.0; 2],
    moved: [0.0; 2],
    rough_m: 0.0,
    seed: 1,
};

/// Edges of three shapes, at any place between cells and in any direction, are within two standard deviations and the resolution.
#[test]
fn the_edge_is_where_it_was_made() {
    for shape in [Shape::Block, Shape::Wedge, Shape::Hollow] {
        let (mut held, mut sum, mut widths) = (0, 0.0, 0.0);
        let count = 24;
        for seed in 0..count {
            let mut random = Normal(seed + 100);
            let case = Case {
                shape,
                seed,
                noise_m: 0.0002 + 0.0008 * random.uniform(),
                edge_m: 0.06 + 0.09 * random.uniform(),
                heading_deg: 360.0 * random.uniform() - 180.0,
                cell_m: 0.003 + 0.003 * random.uniform(),
                ..CASE
            };
            let (_, found) = case.ask();
            let broke = found.broke.unwrap();
            let off = broke.distance_m - case.edge_m;
            held += usize::from(off.abs() <= 2.0 * broke.sd_m + broke.resolution_m);
            sum += off;
            widths += broke.sd_m;
        }
        let (mean, sd) = (sum / count as f64, widths / count as f64);
        println!("{shape:?}: {held} of {count}, mean {:.2} mm, sd {:.2} mm", 1e3 * mean, 1e3 * sd);
        assert!(held >= 22, "{shape:?}");
    }
}

/// A scanner that was tilted, lifted and moved sideways between the maps: all of it is found on rough ground, and the edge and volumes are as
/// without.
#[test]
fn how_the_scanner_was_moved_is_taken_away() {
    let level = Case { rough_m: 0.004, heading_deg: 25.0, ..CASE };
    let moved = Case { tilt: [0.02, -0.01], moved: [0.006, -0.003], seed: 2, ..level };
    let (change, found) = moved.ask();
    let shift = change.shift;
    for axis in 0..2 {
        assert!((shift.sideways_m[axis] - moved.moved[axis]).abs() < 5e-4, "{shift:?}");
        assert!((shift.tilt[axis] - moved.tilt[axis]).abs() < 1e-3, "{shift:?}");
    }
    // 4 mm and the tilt, at the plate.
    let up = 0.004 + moved.tilt[0] * 0.02 + moved.tilt[1] * -0.01;
    assert!((shift.up_m - up).abs() < 5.0 * shift.up_sd_m + 2e-4, "{shift:?} {up}");
    let (_, expected) = level.ask();
    let (a, b) = (found.broke.unwrap(), expected.broke.unwrap());
    assert!((a.distance_m - b.distance_m).abs() < 2.0 * a.sd_m.hypot(b.sd_m) + a.resolution_m);
    // The upright face of the heap, read between cells, is smeared over one of them.
    let (off, sd) = (found.heap.m3 - expected.heap.m3, found.heap.sd_m3.hypot(expected.heap.sd_m3));
    assert!(off.abs() < 3.0 * sd + 0.03 * expected.heap.m3, "{off} {sd}");
}

/// Volumes are the sums of what was made at the centres of cells, and near the formulas of the shapes: half of length, height and width of a
/// wedge; a box of the furrow. Cells along an edge are in or out as their centres are, so formulas are met to a cell or so.
#[test]
fn volumes_of_shapes_hold_the_truth() {
    let (mut held, mut square, count) = (0, 0.0, 30_u32);
    for seed in 0..count {
        let seed = u64::from(seed);
        let mut random = Normal(seed + 7);
        let case = Case {
            heading_deg: [0.0, 90.0, 180.0][(seed % 3) as usize],
            noise_m: 0.0005,
            edge_m: 0.08 + 0.04 * random.uniform(),
            seed,
            ..CASE
        };
        let (_, found) = case.ask();
        let truth = [0.5 * TOP * case.edge_m * WIDTH, 0.012 * 0.1 * WIDTH];
        for (volume, truth) in [found.heap, found.furrow].iter().zip(truth) {
            assert!((volume.m3 - truth).abs() < 0.1 * truth, "{volume:?} {truth}");
            assert!(!volume.off_map && volume.hidden == 0, "{volume:?}");
        }
        let sums = case.sums_m3();
        for (volume, sum) in [found.heap, found.furrow].iter().zip(sums) {
            let off = (volume.m3 - sum) / volume.sd_m3;
            held += usize::from(off.abs() <= 2.0);
            square += off * off / f64::from(2 * count);
        }
        let [swelling, sd] = found.swelling.unwrap();
        assert!((swelling - sums[0] / sums[1]).abs() < 4.0 * sd);
    }
    println!("{held} of {}, {square:.2}", 2 * count);
    assert!(held >= 54 && square < 1.5);
}

/// The simulated sand keeps its volume: heap and furrow are alike, and what the simulation itself says by its heights.
#[test]
fn heap_and_furrow_of_simulated_sand() {
    let cell = 0.004;
    let mut sand = HeightField::level(150, 100, cell, 0.1).unwrap();
    let before = sand.heights_m().to_vec();
    let repose = Repose::from_radians(0.6).unwrap();
    for step in 0..40 {
        let x = 0.2 + 0.0025 * f64::from(step);
        let [from_m, to_m] = [x, x + 0.0025].map(|x| [x, 0.2]);
        sand.push(&Sweep { from_m, to_m, width_m: 0.12, bottom_m: 0.075, ahead_m: 0.03 }).unwrap();
        sand.settle(&repose, 2000, 1e-4);
    }
    let after = sand.heights_m().to_vec();
    let truth: f64 = before.iter().zip(&after).map(|(a, b)| (b - a).max(0.0) * cell * cell).sum();
    let plate = Plate { at_m: [0.3, 0.2], sd_m: 0.0, heading_deg: 0.0, width_m: 0.12 };
    let grid = Grid::new([150, 100], [0.5 * cell; 2], [cell, 0.0], [0.0, cell]).unwrap();
    let mut random = Normal(3);
    let mut map = |heights: &[f64]| {
        let noisy = heights.iter().map(|z| Some(z + 3e-4 * random.next())).collect();
        HeightMap::new(grid, noisy).unwrap()
    };
    let (before, after) = (map(&before), map(&after));
    let change = change(&before, &after, &plate, 3.0, None).unwrap();
    let found = stroke(&before, &change, &plate, 3.0).unwrap();
    for volume in [found.heap, found.furrow] {
        assert!((volume.m3 - truth).abs() < 3.0 * volume.sd_m3 + 0.01 * truth, "{volume:?} {truth}");
    }
    let [swelling, sd] = found.swelling.unwrap();
    assert!((swelling - 1.0).abs() < 3.0 * sd + 0.02, "{swelling} {sd}");
    // The heap ends at the last cell along the middle that is higher than before.
    let row = sand.heights_m().chunks(150).nth(50).unwrap().to_vec();
    let last = row.iter().rposition(|z| *z > 0.1 + 1e-6).unwrap();
    let (edge, broke) = ((last as f64 + 1.0) * cell - 0.3, found.broke.unwrap());
    assert!(
        (broke.distance_m - edge).abs() < 2.0 * broke.sd_m + 3.0 * broke.resolution_m,
        "{broke:?} {edge}"
    );
}

/// Noise that neighbours share tells less: the scanner's own smoothing makes heights look exact, and volumes and edges must not believe it.
#[test]
fn noise_that_clumps_is_not_taken_for_many_readings() {
    let case = Case { noise_m: 0.001, ..CASE };
    let (before, after) = case.maps();
    let smooth = |map: &HeightMap| {
        let [columns, rows] = map.grid().size();
        let at =
            |i: usize, j: usize| map.heights_m()[j.min(rows - 1) * columns + i.min(columns - 1)].unwrap();
        let mean = |cell: usize| {
            let (i, j) = (cell % columns, cell / columns);
            let near = (0..4).flat_map(|b| (0..4).map(move |a| (a, b)));
            Some(near.map(|(a, b)| at(i + a, j + b)).sum::<f64>() / 16.0)
        };
        HeightMap::new(*map.grid(), (0..columns * rows).map(mean).collect()).unwrap()
    };
    let plain = change(&before, &after, &case.plate(), 3.0, None).unwrap();
    let smoothed = change(&smooth(&before), &smooth(&after), &case.plate(), 3.0, None).unwrap();
    assert!(plain.clumping < 1.5, "{}", plain.clumping);
    // Means over sixteen have a quarter of the deviation; sums over many cells have what they had.
    assert!((4.0 * smoothed.noise_m / plain.noise_m - 1.0).abs() < 0.15);
    let of_sums = smoothed.noise_m * smoothed.clumping.sqrt();
    assert!((0.6..1.4).contains(&(of_sums / plain.noise_m)), "{of_sums} {}", plain.noise_m);
}

#[test]
fn what_cannot_be_said_is_not() {
    // Nothing happened, or less than the noise.
    let quiet = Case { noise_m: 0.02, ..CASE };
    assert!(matches!(quiet.ask().1.broke, Err(NoBreak::NoRise { .. })));
    // The heap leaves the map.
    let long = Case { edge_m: 0.5, ..CASE };
    let (_, found) = long.ask();
    assert_eq!(found.broke, Err(NoBreak::OffMap));
    assert!(found.heap.off_map && !found.furrow.off_map);
    // Where the edge is, nothing was seen.
    let (before, after) = CASE.maps();
    let hide = |from: f64, to: f64| {
        let grid = *after.grid();
        let heights = after.heights_m().iter().enumerate().map(|(cell, z)| {
            let [ahead, _] = CASE.plate().seen_from(grid.place(cell));
            z.filter(|_| !(from..to).contains(&ahead))
        });
        HeightMap::new(grid, heights.collect()).unwrap()
    };
    let plate = CASE.plate();
    let ask = |after: &HeightMap| {
        let change = change(&before, after, &plate, 3.0, None).unwrap();
        stroke(&before, &change, &plate, 3.0).unwrap()
    };
    let hidden = ask(&hide(0.05, 0.15));
    assert_eq!(hidden.broke, Err(NoBreak::Hidden));
    assert!(hidden.heap.hidden > 0);
    // The plate itself hides what is next to it, which does not matter.
    let broke = ask(&hide(-0.02, 0.02)).broke.unwrap();
    assert!((broke.distance_m - CASE.edge_m).abs() < 2.0 * broke.sd_m + broke.resolution_m);
    // Elsewhere, and in another frame.
    let elsewhere = Plate { at_m: [5.0, 0.0], ..plate };
    let problem = change(&before, &after, &elsewhere, 3.0, None).unwrap_err().to_string();
    assert!(problem.contains("is not on the ground seen"), "{problem}");
    let away = Grid::new([50, 50], [5.0, 5.0], [0.004, 0.0], [0.0, 0.004]).unwrap();
    let away = HeightMap::new(away, vec![Some(0.0); 2500]).unwrap();
    let problem = change(&before, &away, &plate, 3.0, None).unwrap_err().to_string();
    assert!(problem.contains("0 cells"), "{problem}");
    // Maps that are the same say nothing of their noise.
    let same = change(&before, &before, &plate, 3.0, None).unwrap();
    assert!(same.notes.iter().any(|note| note.contains("to the micrometre")), "{:?}", same.notes);
    assert!(stroke(&before, &same, &plate, 3.0).unwrap().broke.is_err());
}
