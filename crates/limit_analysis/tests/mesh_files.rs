//! Files: what is written is read again as it was, and what is damaged is refused.
#![allow(clippy::unwrap_used)]

mod mesh_common;

use mesh_common::{check, holed, mesh_with_fans, plate, polygon, two_regions};
use soilctl_limit_analysis::mesh::files::{
    Encoding, Field, FileError, Imported, Layout, Svg, Vtu, read_msh, write_msh,
};
use soilctl_limit_analysis::mesh::structured::{block, rectangle};
use soilctl_limit_analysis::mesh::{Fan, Guide, LineUse, Mesh, MeshError, Outline};

/// Meshes of several shapes.
fn examples() -> Vec<(Outline, Mesh)> {
    let guide = |points: &[[f64; 2]]| Guide { points: points.to_vec() };
    let fans = [Fan { point: 5, radius: 0.1, angle: 0.27 }];
    let cases: [(Outline, Vec<Guide>, &[Fan]); 4] = [
        (
            plate([0.5, -0.8]),
            vec![guide(&[[0.5, -0.8], [2.1, 0.0]]), guide(&[[-2.0, 0.0], [1.0, -2.0]])],
            &fans,
        ),
        (plate([1.0 / 3.0, -0.7]), vec![], &[]),
        (two_regions(), vec![], &[]),
        (holed(), vec![guide(&[[0.0, 0.0], [4.0, 3.7]])], &[]),
    ];
    let size = |p: [f64; 2]| 0.1 + 0.2 * (p[0] - 0.5).hypot(p[1] + 0.8);
    let made = cases.map(|(outline, guides, fans)| {
        let mesh = mesh_with_fans(&outline, &guides, fans, &size).unwrap();
        (outline, mesh)
    });
    let corners = [[0.0, 3.0], [-1.0, 0.0], [4.0, -1.0], [3.0, 2.5]];
    made.into_iter().chain([block(corners, &[0.0, 0.3, 1.0], &[0.0, 0.5, 0.9, 1.0]).unwrap()]).collect()
}

/// What each region's loops use, in any order.
fn uses(outline: &Outline) -> Vec<Vec<LineUse>> {
    let all = outline.regions.iter().map(|r| {
        let mut all: Vec<LineUse> = r.loops.iter().flatten().copied().collect();
        all.sort_by_key(|u| (u.line, u.forward));
        all
    });
    all.collect()
}

#[test]
fn msh_comes_back_as_it_went() {
    for (outline, mesh) in examples() {
        let text = write_msh(&outline, &mesh);
        assert_eq!(text, write_msh(&outline, &mesh));
        let Imported { outline: read, mesh: again, regions, lines } = read_msh(text.as_bytes()).unwrap();
        check(&read, &again);
        assert_eq!((&read.points, &read.lines), (&outline.points, &outline.lines));
        assert_eq!(uses(&read), uses(&outline));
        assert_eq!(again.triangles, mesh.triangles);
        assert_eq!((&again.lines, &again.guide_edges), (&mesh.lines, &mesh.guide_edges));
        for (a, b) in again.vertices.iter().zip(&mesh.vertices) {
            // On lines, the place along the line is found anew.
            assert!((0..2).all(|d| (a.position[d] - b.position[d]).abs() < 1e-14));
            assert_eq!(std::mem::discriminant(&a.place), std::mem::discriminant(&b.place));
        }
        for (i, region) in regions.iter().enumerate() {
            assert_eq!(region.as_ref().unwrap().name, Some(format!("region {i}")));
        }
        for (i, groups) in lines.iter().enumerate() {
            assert_eq!((groups.len(), groups[0].tag), (1, i as i64 + 1));
        }
    }
}

/// A square of four triangles in version 2.2, with whatever lines and groups.
fn square(elements: &[&str]) -> String {
    let nodes = "1 0 0 0\n2 1 0 0\n30 1 1 0\n4 0 1 0\n5 0.5 0.5 0\n6 9 9 9";
    let elements: Vec<String> = elements.iter().enumerate().map(|(i, e)| format!("{} {e}", i + 1)).collect();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 7 \"the base\"\n2 3 \"sand\"\n$EndPhysicalNames\n\
         $Comments\nwhat ever\n$EndComments\n$Nodes\n6\n{nodes}\n$EndNodes\n$Elements\n{}\n{}\n$EndElements\n",
        elements.len(),
        elements.join("\n")
    )
}

const FOUR: [&str; 4] = ["2 2 3 1 1 2 5", "2 2 3 1 2 30 5", "2 2 3 1 30 5 4", "2 2 3 1 4 1 5"];

#[test]
fn version_2_and_groups() {
    let read =
        read_msh(square(&[&FOUR[..], &["1 2 7 1 1 2", "1 2 0 9 1 5", "15 2 0 1 30"]].concat()).as_bytes());
    let Imported { outline, mesh, regions, lines } = read.unwrap();
    check(&outline, &mesh);
    assert_eq!((mesh.triangles.len(), outline.points.len(), outline.lines.len()), (4, 4, 4));
    assert_eq!(regions[0].as_ref().unwrap().name.as_deref(), Some("sand"));
    assert_eq!(lines[0][0].name.as_deref(), Some("the base"));
    assert_eq!(lines.iter().map(Vec::len).sum::<usize>(), 1);
    // Node 30 is a point of the geometry, so it comes first.
    assert_eq!(outline.points[0], [1.0, 1.0]);
    // Without groups of lines, a line inside is a slit; with two regions there is an interface.
    let read = read_msh(square(&[&FOUR[..], &["1 2 0 9 1 5"]].concat()).as_bytes()).unwrap();
    check(&read.outline, &read.mesh);
    assert_eq!((read.outline.lines.len(), read.outline.regions[0].loops[0].len()), (5, 6));
    let two = [FOUR[0], "2 2 0 5 2 30 5", FOUR[2], FOUR[3]];
    let read = read_msh(square(&two).as_bytes()).unwrap();
    check(&read.outline, &read.mesh);
    assert_eq!((read.outline.lines.len(), read.outline.regions.len()), (6, 2));
    assert_eq!(read.regions[1], None);
    assert_eq!(read.mesh.triangles.iter().filter(|t| t.region == 1).count(), 1);
}

#[test]
fn curves_are_one_line_where_they_are_straight() {
    let (outline, mesh) = rectangle(&[0.0, 0.1, 0.3, 1.0], &[0.0, -0.2, -1.0]).unwrap();
    let text = write_msh(&outline, &mesh);
    // One curve all round the rectangle.
    let mut one = text.clone();
    for line in 2..=4 {
        one = one.replace(&format!("\n1 {line} 1 "), "\n1 1 1 ");
    }
    let read = read_msh(one.as_bytes()).unwrap();
    check(&read.outline, &read.mesh);
    assert_eq!((read.outline.lines.len(), &read.outline.points), (4, &outline.points));
    // A corner of a cell that is off the base by a little: one line for each edge beside it.
    let bent = text.replace("\n0.1 -1.0 0\n", "\n0.1 -1.00001 0\n");
    assert_ne!(bent, text);
    let read = read_msh(bent.as_bytes()).unwrap();
    check(&read.outline, &read.mesh);
    assert_eq!(read.outline.lines.len(), 6);
    assert_eq!(read.lines.iter().filter(|g| g[0].name.as_deref() == Some("line 1")).count(), 3);
}

fn error(text: &str) -> FileError {
    let error = read_msh(text.as_bytes()).unwrap_err();
    assert!(!error.to_string().is_empty());
    error
}

#[test]
fn faults_are_named_with_their_line() {
    let good = square(&FOUR);
    assert!(read_msh(good.as_bytes()).is_ok());
    let with = |from: &str, to: &str| {
        assert!(good.contains(from));
        error(&good.replacen(from, to, 1))
    };
    assert_eq!(error(""), FileError::Ends { line: 1, expected: "$MeshFormat" });
    assert!(matches!(with("2.2 0 8", "4.0 0 8"), FileError::Version { line: 2, .. }));
    assert!(matches!(with("2.2 0 8", "2.2 1 8"), FileError::Version { line: 2, .. }));
    assert!(matches!(with("30 1 1 0", "30 1 1"), FileError::Syntax { .. }));
    assert!(matches!(with("30 1 1 0", "30 1 nan 0"), FileError::Syntax { line: 16, .. }));
    assert!(matches!(with("30 1 1 0", "4 1 1 0"), FileError::Twice { line: 17, what: "node", tag: 4 }));
    assert!(matches!(with("30 1 1 0", "30 1 1 0.1"), FileError::NotFlat { tag: 30, .. }));
    assert!(matches!(with("30 1 1 0", "30 0.5 0.5 0"), FileError::Flat { line: 24, tag: 2, .. }));
    assert!(matches!(
        with("1 2 2 3 1 1 2 5", "1 2 2 3 1 1 2 8"),
        FileError::Missing { line: 23, tag: 8, .. }
    ));
    assert!(matches!(with("1 2 2 3 1 1 2 5", "1 3 2 3 1 1 2 5 4"), FileError::Element { line: 23, kind: 3 }));
    assert!(matches!(with("1 2 2 3 1 1 2 5", "2 2 2 3 1 1 2 5"), FileError::Twice { line: 24, .. }));
    assert!(matches!(with("$Elements\n4", "$Elements\n5"), FileError::Syntax { line: 27, .. }));
    assert!(matches!(
        with("$Elements\n4", "$Elements\n99999999999999999999999"),
        FileError::Syntax { line: 22, .. }
    ));
    assert!(matches!(with("\n$EndElements\n", "\n"), FileError::Ends { .. }));
    assert!(matches!(with("$EndComments", "$EndComment"), FileError::Ends { line: 9, .. }));
    let lines = |more: &str| error(&square(&[&FOUR[..], &[more]].concat()));
    assert!(matches!(lines("2 2 3 1 1 2 4"), FileError::Overlap { line: 27, tag: 5, .. }));
    assert!(matches!(lines("1 2 0 1 1 30"), FileError::LooseLine { line: 27, tag: 5 }));
    assert!(matches!(lines("1 2 0 1 1 6"), FileError::LooseLine { line: 27, tag: 5 }));
    assert!(matches!(error(&square(&["15 2 0 1 30"])), FileError::NoTriangles));
    // Two triangles that overlap without a common edge.
    let apart = error(&square(&["2 2 0 1 1 2 30", "2 2 0 1 5 30 4"]));
    assert!(
        matches!(apart, FileError::Outline(MeshError::Touching { .. } | MeshError::Crossing { .. })),
        "{apart}"
    );
}

#[test]
fn damaged_files_are_refused_or_read_but_never_break_anything() {
    let (outline, mesh) = examples().remove(2);
    let text = write_msh(&outline, &mesh);
    let mut state = 7u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below
    };
    let mut good = 0;
    for _ in 0..1500 {
        let mut bytes = text.clone().into_bytes();
        match random(4) {
            0 => bytes.truncate(random(bytes.len())),
            1 => {
                let at = random(bytes.len());
                bytes.drain(at..(at + random(40)).min(text.len()));
            }
            2 => {
                let at = random(bytes.len());
                let digits: Vec<u8> = (0..random(22)).map(|_| b"0123456789-.e$ \n\xff"[random(17)]).collect();
                bytes.splice(at..at, digits);
            }
            _ => {
                for _ in 0..=random(3) {
                    let at = random(bytes.len());
                    bytes[at] = b"0123456789-.e$ \n\"\xff"[random(18)];
                }
            }
        }
        if let Ok(read) = read_msh(&bytes) {
            check(&read.outline, &read.mesh);
            good += 1;
        }
    }
    // Digits of coordinates, and what is not looked at, may change.
    assert!((100..1400).contains(&good), "{good}");
}

#[test]
fn vtu_has_what_was_asked_for() {
    let (_, mesh) = examples().remove(3);
    let (vertices, triangles) = (mesh.vertices.len(), mesh.triangles.len());
    let values: Vec<f64> = (0..12 * triangles).map(|i| 0.1 * i as f64).collect();
    for (layout, points, kind) in [
        (Layout::Vertices, vertices, 5),
        (Layout::Corners, 3 * triangles, 5),
        (Layout::Quadratic, 6 * triangles, 22),
    ] {
        let point_data = [
            Field { name: "velocity <m/s>", components: 2, values: &values[..2 * points] },
            Field { name: "pressure", components: 1, values: &values[..points] },
        ];
        let cell_data = [Field { name: "gap", components: 1, values: &values[..triangles] }];
        let vtu = Vtu {
            mesh: &mesh,
            layout,
            point_data: &point_data,
            cell_data: &cell_data,
            encoding: Encoding::Ascii,
        };
        let text = vtu.write().unwrap();
        assert!(text.contains(&format!("NumberOfPoints=\"{points}\" NumberOfCells=\"{triangles}\"")));
        assert!(text.contains("Name=\"velocity &lt;m/s&gt;\" NumberOfComponents=\"3\""));
        let array = |name: &str| -> Vec<f64> {
            let after = text.split_once(&format!("Name=\"{name}\"")).unwrap().1.split_once('>').unwrap().1;
            let words = after.split_once("</").unwrap().0.split_ascii_whitespace();
            words.map(|w| w.parse().unwrap()).collect()
        };
        assert_eq!(array("gap"), values[..triangles]);
        assert_eq!(array("pressure"), values[..points]);
        assert_eq!(array("velocity &lt;m/s&gt;")[3..6], [values[2], values[3], 0.0]);
        assert_eq!(array("types"), vec![f64::from(kind); triangles]);
        let (coordinates, connectivity) = (array("points"), array("connectivity"));
        for (i, t) in mesh.triangles.iter().enumerate() {
            let per_cell = connectivity.len() / triangles;
            for k in 0..3 {
                let point = connectivity[per_cell * i + k] as usize;
                let [x, y] = mesh.vertices[t.corners[k]].position;
                assert_eq!(coordinates[3 * point..3 * point + 3], [x, y, 0.0]);
            }
        }
        let packed = Vtu { encoding: Encoding::Base64, ..vtu }.write().unwrap();
        assert!(packed.contains("<AppendedData encoding=\"base64\">"));
    }
}

#[test]
fn bad_fields_are_refused() {
    let (_, mesh) = rectangle(&[0.0, 1.0], &[0.0, -1.0]).unwrap();
    let values = [0.0; 20];
    let refused = |fields: &[Field]| {
        let vtu = Vtu {
            mesh: &mesh,
            layout: Layout::Vertices,
            point_data: &[],
            cell_data: fields,
            encoding: Encoding::Ascii,
        };
        let error = vtu.write().unwrap_err();
        assert!(matches!(error, FileError::BadField { .. }), "{error}");
    };
    let good = Field { name: "a", components: 1, values: &values[..4] };
    refused(&[Field { values: &values[..5], ..good }]);
    refused(&[Field { components: 2, ..good }]);
    refused(&[Field { components: 4, values: &values[..16], ..good }]);
    refused(&[Field { name: "", ..good }]);
    refused(&[Field { name: "region", ..good }]);
    refused(&[good, good]);
    refused(&[Field { values: &[0.0, 0.0, f64::NAN, 0.0], ..good }]);
}

#[test]
fn svg_draws_every_edge_once() {
    let (_, mesh) = rectangle(&[0.0, 1.0, 2.0], &[0.0, -1.0]).unwrap();
    let text = Svg { mesh: &mesh, width: 208.0, colours: None }.write().unwrap();
    assert!(text.contains("viewBox=\"0 0 208.00 108.00\"") && !text.contains("fill=\"#"));
    let edges = text.lines().find(|l| l.contains("class=\"edges\"")).unwrap();
    assert_eq!(edges.matches('M').count(), 7 + 8);
    let colours = vec![[255, 128, 0]; 8];
    let text = Svg { mesh: &mesh, width: 208.0, colours: Some(&colours) }.write().unwrap();
    assert_eq!(text.matches("fill=\"#ff8000\"").count(), 8);
    let outline = polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let mesh = mesh_with_fans(&outline, &[], &[], &|_| 0.3).unwrap();
    for (width, colours) in [(f64::NAN, None), (1.0, None), (1e9, None), (100.0, Some(&[[0u8; 3]][..]))] {
        assert!(matches!(Svg { mesh: &mesh, width, colours }.write(), Err(FileError::BadField { .. })));
    }
}
