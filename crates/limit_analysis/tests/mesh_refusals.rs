//! What an outline must not be: each fault has its own error, which names what is wrong.

mod mesh_common;

use std::time::Instant;

use mesh_common::{holed, plate, polygon, region, statement, two_regions};
use soilctl_certificate::{Line, LineUse, Statement};
use soilctl_limit_analysis::mesh::{MeshError, check};

fn square() -> Statement {
    polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
}

/// The error of a square that was tampered with.
fn error(tamper: impl FnOnce(&mut Statement)) -> MeshError {
    let mut outline = square();
    tamper(&mut outline);
    let Err(error) = check(&outline) else { panic!("the outline passes") };
    assert!(!error.to_string().is_empty());
    error
}

/// Adds a line as a slit with a loop of its own.
fn add_slit(o: &mut Statement, from: usize, to: usize) {
    let line = o.lines.len();
    o.lines.push(Line { from, to });
    o.regions[0].loops.push(vec![LineUse { line, forward: true }, LineUse { line, forward: false }]);
}

#[test]
fn good_outlines_pass() {
    for outline in [square(), plate([0.5, -0.8]), holed(), two_regions()] {
        assert_eq!(check(&outline), Ok(()));
    }
    // A point that no line uses does not matter.
    let mut outline = square();
    outline.points.push([0.5, 0.0]);
    assert_eq!(check(&outline), Ok(()));
}

#[test]
fn empty() {
    assert_eq!(check(&statement(vec![], vec![], vec![])), Err(MeshError::Empty { what: "points" }));
    assert!(matches!(error(|o| o.regions.clear()), MeshError::Empty { what: "regions" }));
    assert!(matches!(error(|o| o.regions.push(region(vec![]))), MeshError::Empty { .. }));
}

#[test]
fn coordinates() {
    assert!(matches!(error(|o| o.points[2][0] = f64::NAN), MeshError::NotFinite { point: 2, .. }));
    assert!(matches!(error(|o| o.points[1][1] = f64::INFINITY), MeshError::NotFinite { point: 1, .. }));
    assert!(matches!(error(|o| o.points[1][1] = 1e200), MeshError::Magnitude { .. }));
    assert!(matches!(
        error(|o| o.points.iter_mut().flatten().for_each(|c| *c *= 1e-200)),
        MeshError::Magnitude { .. }
    ));
}

#[test]
fn indices() {
    assert_eq!(error(|o| o.lines[1].to = 9), MeshError::NoSuchPoint { line: 1, point: 9, count: 4 });
    let no_line = MeshError::NoSuchLine { region: 0, ring: 0, line: 7, count: 4 };
    assert_eq!(error(|o| o.regions[0].loops[0][2].line = 7), no_line);
}

#[test]
fn lengths() {
    assert!(matches!(error(|o| o.lines[1].to = 1), MeshError::ShortLine { line: 1, .. }));
    assert!(matches!(error(|o| o.points[1] = [1e-10, 0.0]), MeshError::ShortLine { line: 0, .. }));
    let twin = error(|o| {
        o.points.extend([[1.0, 1.0], [0.5, 0.5]]);
        add_slit(o, 4, 5);
    });
    assert!(matches!(twin, MeshError::CoincidentPoints { first: 2, second: 4, .. }));
}

#[test]
fn loops() {
    let open = error(|o| {
        o.regions[0].loops[0].pop();
    });
    assert_eq!(open, MeshError::OpenLoop { region: 0, ring: 0, line: 2, end: 3, next: 0, start: 0 });
    assert!(matches!(error(|o| o.regions[0].loops[0][1].forward = false), MeshError::OpenLoop { .. }));
    let turned = error(|o| {
        o.regions[0].loops[0].reverse();
        o.regions[0].loops[0].iter_mut().for_each(|u| u.forward = false);
    });
    assert_eq!(turned, MeshError::Orientation { region: 0, area: -1.0 });
    let twice = error(|o| {
        let again = o.regions[0].clone();
        o.regions.push(again);
    });
    assert_eq!(twice, MeshError::UsedTwice { line: 0, direction: "forwards", first: 0, second: 1 });
    assert_eq!(error(|o| o.lines.push(Line { from: 0, to: 2 })), MeshError::UnusedLine { line: 4 });
}

#[test]
fn crossings() {
    let bow = polygon(&[[0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [0.0, 1.5]]);
    let error_of_bow = check(&bow).unwrap_err();
    // Its area is negative or it crosses itself: the crossing is what is said if the area does not tell.
    assert!(
        matches!(error_of_bow, MeshError::Crossing { .. } | MeshError::Orientation { .. }),
        "{error_of_bow}"
    );
    let through = error(|o| {
        o.points.extend([[0.5, 0.5], [0.6, 1.5]]);
        add_slit(o, 4, 5);
    });
    assert!(matches!(through, MeshError::Crossing { first: 2, second: 4 }), "{through}");
    let slits = error(|o| {
        o.points.extend([[0.2, 0.2], [0.8, 0.8], [0.2, 0.8], [0.8, 0.2]]);
        add_slit(o, 4, 5);
        add_slit(o, 6, 7);
    });
    assert!(matches!(slits, MeshError::Crossing { first: 4, second: 5 }), "{slits}");
}

#[test]
fn touching_and_overlapping_lines() {
    for y in [0.0, 1e-10] {
        let touch = error(|o| {
            o.points.extend([[0.3, y], [0.3, 0.5]]);
            add_slit(o, 4, 5);
        });
        assert!(matches!(touch, MeshError::Touching { line: 0, point: 4, .. }), "{touch}");
    }
    let overlap = error(|o| {
        o.points.extend([[0.2, 0.5], [0.6, 0.5], [0.4, 0.5], [0.8, 0.5]]);
        add_slit(o, 4, 5);
        add_slit(o, 6, 7);
    });
    assert!(matches!(overlap, MeshError::Touching { .. }), "{overlap}");
    let longer = error(|o| {
        o.points.extend([[0.2, 0.5], [0.6, 0.5], [0.8, 0.5]]);
        add_slit(o, 4, 5);
        add_slit(o, 4, 6);
    });
    assert!(matches!(longer, MeshError::Touching { .. }), "{longer}");
    let double = error(|o| {
        o.points.extend([[0.2, 0.5], [0.6, 0.5]]);
        add_slit(o, 4, 5);
        add_slit(o, 5, 4);
    });
    assert_eq!(double, MeshError::DoubleLine { first: 4, second: 5 });
}

#[test]
fn overlapping_regions() {
    let mut outline = square();
    let inner = polygon(&[[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]);
    outline.points.extend(inner.points);
    outline.lines.extend(inner.lines.iter().map(|l| Line { from: l.from + 4, to: l.to + 4 }));
    let uses = (4..8).map(|line| LineUse { line, forward: true }).collect();
    outline.regions.push(region(vec![uses]));
    let error = check(&outline).unwrap_err();
    assert!(matches!(error, MeshError::Overlap { .. }), "{error}");
    // A hole that runs like an outer loop.
    let mut outline = holed();
    let hole = &mut outline.regions[0].loops[1];
    hole.reverse();
    hole.iter_mut().for_each(|u| u.forward = false);
    assert!(matches!(check(&outline), Err(MeshError::Overlap { .. })));
}

/// A regular polygon.
fn circle(n: usize) -> Statement {
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    polygon(&(0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect::<Vec<_>>())
}

#[test]
fn too_much_is_refused_at_once_and_much_is_checked_in_time() {
    let start = Instant::now();
    let error = check(&circle(100_001)).unwrap_err();
    assert_eq!(error, MeshError::TooMuch { what: "points", count: 100_001, limit: 100_000 });
    assert_eq!(check(&circle(100_000)), Ok(()));
    // A comb of long thin teeth: every line is long and close to many others.
    let mut comb = vec![[0.0, -1.0], [1.0, -1.0]];
    comb.extend((0..50_000).rev().flat_map(|i| {
        let x = i as f64 / 50_000.0;
        if i % 2 == 0 { [[x + 1e-5, 0.0], [x + 1e-6, 1.0]] } else { [[x + 1e-5, 1.0], [x + 1e-6, 0.0]] }
    }));
    comb.truncate(100_000);
    assert_eq!(check(&polygon(&comb)), Ok(()));
    // Every spoke crosses every other.
    let mut star = circle(2000);
    let jump = 999;
    for (i, line) in star.lines.iter_mut().enumerate() {
        *line = Line { from: i * jump % 2000, to: (i + 1) * jump % 2000 };
    }
    assert!(check(&star).is_err());
    // Very generous: it takes a second or so, and minutes if anything is quadratic.
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}
