//! Statements to mesh, and what must be true of every mesh.
#![allow(dead_code)] // each test file uses part of it

use std::collections::BTreeMap;

use soilctl_certificate::{Line, LineUse, Linear, Material, Objective, Place, Region, Statement};
use soilctl_limit_analysis::mesh::{Fan, Guide, Mesh, MeshError, Request, generate};

/// A region of any soil: meshes depend on loops only.
pub(crate) fn region(loops: Vec<Vec<LineUse>>) -> Region {
    let material = Material {
        phi_deg: 30.0,
        cohesion: Linear::default(),
        unit_weight: 1.0,
        pore_pressure: Linear::default(),
        tension: None,
        envelope: None,
        anisotropy: None,
    };
    Region { loops, material }
}

/// A statement of which only the geometry matters.
pub(crate) fn statement(points: Vec<[f64; 2]>, lines: Vec<Line>, regions: Vec<Region>) -> Statement {
    Statement {
        points,
        lines,
        regions,
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective: Objective::Loads,
        width: None,
        members: Vec::new(),
        boundaries: Vec::new(),
    }
}

/// Lines through the given points, which close.
fn ring(points: &[usize], lines: &mut Vec<Line>) -> Vec<LineUse> {
    let mut uses = Vec::new();
    for (i, &from) in points.iter().enumerate() {
        uses.push(LineUse { line: lines.len(), forward: true });
        lines.push(Line { from, to: points[(i + 1) % points.len()] });
    }
    uses
}

/// One region, a polygon, counter-clockwise.
pub(crate) fn polygon(points: &[[f64; 2]]) -> Statement {
    let mut lines = Vec::new();
    let uses = ring(&(0..points.len()).collect::<Vec<_>>(), &mut lines);
    statement(points.to_vec(), lines, vec![region(vec![uses])])
}

/// The box [-3, 12] x [-3, 0] with a plate from the origin to its tip, a slit.
pub(crate) fn plate(tip: [f64; 2]) -> Statement {
    let mut outline = polygon(&[[-3.0, -3.0], [12.0, -3.0], [12.0, 0.0], [0.0, 0.0], [-3.0, 0.0]]);
    outline.points.push(tip);
    outline.lines.push(Line { from: 3, to: 5 });
    let uses = &mut outline.regions[0].loops[0];
    uses.splice(3..3, [LineUse { line: 5, forward: true }, LineUse { line: 5, forward: false }]);
    outline
}

/// A square with a square hole.
pub(crate) fn holed() -> Statement {
    let mut outline = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
    outline.points.extend([[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0]]);
    let hole = ring(&[4, 5, 6, 7], &mut outline.lines);
    outline.regions[0].loops.push(hole);
    outline
}

/// Two regions side by side; the interface is line 3.
pub(crate) fn two_regions() -> Statement {
    let mut outline = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.3, 1.0], [0.0, 1.0]]);
    outline.lines.swap(1, 3); // the interface becomes line 3, from point 1 to point 2
    let forward = |line| LineUse { line, forward: true };
    outline.regions[0].loops[0] = vec![forward(0), forward(3), forward(2), forward(1)];
    outline.points.extend([[3.0, 0.0], [3.0, 1.0]]);
    outline.lines.extend([Line { from: 1, to: 4 }, Line { from: 4, to: 5 }, Line { from: 5, to: 2 }]);
    let right = vec![forward(4), forward(5), forward(6), LineUse { line: 3, forward: false }];
    outline.regions.push(region(vec![right]));
    outline
}

pub(crate) fn mesh(
    outline: &Statement,
    guides: &[Guide],
    size: &dyn Fn([f64; 2]) -> f64,
) -> Result<Mesh, MeshError> {
    mesh_with_fans(outline, guides, &[], size)
}

pub(crate) fn mesh_with_fans(
    outline: &Statement,
    guides: &[Guide],
    fans: &[Fan],
    size: &dyn Fn([f64; 2]) -> f64,
) -> Result<Mesh, MeshError> {
    generate(&Request { statement: outline, guides, fans, size, max_triangles: 200_000 })
}

fn twice_area(p: [[f64; 2]; 3]) -> f64 {
    (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])
}

/// Checks everything that is promised of a mesh but its sizes and angles.
pub(crate) fn check(outline: &Statement, mesh: &Mesh) {
    check_areas(outline, mesh);
    check_places(outline, mesh);
    check_edges(outline, mesh);
}

fn check_areas(outline: &Statement, mesh: &Mesh) {
    let mut areas = vec![0.0; outline.regions.len()];
    for t in &mesh.triangles {
        let area = twice_area(t.corners.map(|v| mesh.vertices[v].position));
        assert!(area > 0.0, "{t:?} has the area {area}");
        areas[t.region] += 0.5 * area;
    }
    for (region, r) in outline.regions.iter().enumerate() {
        let mut area = 0.0;
        for used in r.loops.iter().flatten() {
            let line = outline.lines[used.line];
            let (a, b) = (outline.points[line.from], outline.points[line.to]);
            let origin = outline.points[0];
            let part = 0.5 * twice_area([origin, a, b]);
            area += if used.forward { part } else { -part };
        }
        // The sum of many rounded areas, and vertices beside their line by a rounding error.
        assert!(
            (areas[region] - area).abs() <= 1e-12 * area,
            "region {region}: {} for {area}",
            areas[region]
        );
    }
}

fn check_places(outline: &Statement, mesh: &Mesh) {
    let mut used = vec![false; mesh.vertices.len()];
    mesh.triangles.iter().flat_map(|t| t.corners).for_each(|v| used[v] = true);
    assert!(used.iter().all(|u| *u), "a vertex is in no triangle");
    let mut on_lines = vec![0; outline.lines.len()];
    for v in &mesh.vertices {
        match v.place {
            Place::Corner { point } => assert_eq!(v.position, outline.points[point]),
            Place::OnLine { line, s } => {
                let ends = outline.lines[line];
                let (a, b) = (outline.points[ends.from], outline.points[ends.to]);
                assert!(0.0 < s && s < 1.0);
                assert_eq!(v.position, [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]);
                on_lines[line] += 1;
            }
            Place::Inside => {}
        }
    }
    for (line, chain) in mesh.lines.iter().enumerate() {
        let place = |i: usize| mesh.vertices[chain[i]].place;
        let last = chain.len() - 1;
        assert_eq!(place(0), Place::Corner { point: outline.lines[line].from });
        assert_eq!(place(last), Place::Corner { point: outline.lines[line].to });
        assert_eq!(on_lines[line], last - 1, "vertices of line {line}");
        let mut before = 0.0;
        for i in 1..last {
            let Place::OnLine { line: l, s } = place(i) else { panic!("line {line} has {:?}", place(i)) };
            assert!(l == line && s > before);
            before = s;
        }
    }
}

/// Every directed edge has one triangle, and its opposite another one of the same region, or it is on a line: then what
/// is on either side is what the loops say.
fn check_edges(outline: &Statement, mesh: &Mesh) {
    let mut left = BTreeMap::new();
    for t in &mesh.triangles {
        for i in 0..3 {
            let edge = [t.corners[i], t.corners[(i + 1) % 3]];
            assert!(left.insert(edge, t.region).is_none(), "edge {edge:?} has two triangles on one side");
        }
    }
    let region_of = |line, forward| {
        let has = |r: &Region| r.loops.iter().flatten().any(|u| *u == LineUse { line, forward });
        outline.regions.iter().position(has)
    };
    for edge in &mesh.guide_edges {
        assert!(edge[0] < edge[1] && left.contains_key(edge), "guide edge {edge:?} is no edge of the mesh");
    }
    assert!(mesh.guide_edges.is_sorted());
    let mut inner = left.clone();
    for (line, chain) in mesh.lines.iter().enumerate() {
        for pair in chain.windows(2) {
            assert_eq!(inner.remove(&[pair[0], pair[1]]), region_of(line, true), "left of line {line}");
            assert_eq!(inner.remove(&[pair[1], pair[0]]), region_of(line, false), "right of line {line}");
        }
    }
    for (&[a, b], region) in &inner {
        assert_eq!(inner.get(&[b, a]), Some(region), "edge {a} {b} is on no line");
    }
}

/// Fraction of edges whose length is within 40 % of the wanted size at their middle.
pub(crate) fn fraction_of_size(mesh: &Mesh, size: &dyn Fn([f64; 2]) -> f64) -> f64 {
    let (mut good, mut all) = (0, 0);
    for t in &mesh.triangles {
        for i in 0..3 {
            let [a, b] = [t.corners[i], t.corners[(i + 1) % 3]].map(|v| mesh.vertices[v].position);
            let ratio = (a[0] - b[0]).hypot(a[1] - b[1]) / size([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
            good += usize::from((0.6..=1.4).contains(&ratio));
            all += 1;
        }
    }
    good as f64 / all as f64
}
