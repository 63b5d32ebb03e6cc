//! MSH 4.1 out.

use std::fmt::Write;

use soilctl_certificate::{Place, Statement};

use crate::mesh::Mesh;

/// Name of the physical group of curves that holds guide edges.
const GUIDES: &str = "guides";

/// A mesh in gmsh's format MSH 4.1, ASCII.
///
/// Vertices and triangles have their index plus 1 as number. The points, lines and regions of the statement are points,
/// curves and surfaces with their index plus 1 as number; each line and region is a physical group of the same number,
/// named "line 0" and so on and "region 0" and so on. Guide edges are on one more curve, in a group named "guides".
/// The statement must be the one that the mesh was made of.
pub(super) fn write_msh(statement: &Statement, mesh: &Mesh) -> String {
    let mut text = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    let curves = statement.lines.len() + usize::from(!mesh.guide_edges.is_empty());
    let _ = writeln!(text, "$PhysicalNames\n{}", curves + statement.regions.len());
    for line in 0..statement.lines.len() {
        let _ = writeln!(text, "1 {} \"line {line}\"", line + 1);
    }
    if curves > statement.lines.len() {
        let _ = writeln!(text, "1 {curves} \"{GUIDES}\"");
    }
    for region in 0..statement.regions.len() {
        let _ = writeln!(text, "2 {} \"region {region}\"", region + 1);
    }
    text += "$EndPhysicalNames\n";
    entities(statement, mesh, curves, &mut text);
    nodes(statement, mesh, &mut text);
    elements(statement, mesh, curves, &mut text);
    text
}

/// The box around some points, as the format has it.
fn bounds(points: impl Iterator<Item = [f64; 2]>) -> String {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        for d in 0..2 {
            low[d] = low[d].min(p[d]);
            high[d] = high[d].max(p[d]);
        }
    }
    format!("{:?} {:?} 0 {:?} {:?} 0", low[0], low[1], high[0], high[1])
}

fn entities(statement: &Statement, mesh: &Mesh, curves: usize, text: &mut String) {
    let (points, regions) = (&statement.points, &statement.regions);
    let _ = writeln!(text, "$Entities\n{} {curves} {} 0", points.len(), regions.len());
    for (point, [x, y]) in points.iter().enumerate() {
        let _ = writeln!(text, "{} {x:?} {y:?} 0 0", point + 1);
    }
    for (line, ends) in statement.lines.iter().enumerate() {
        let (line, box_of) = (line + 1, bounds([ends.from, ends.to].into_iter().map(|p| points[p])));
        let _ = writeln!(text, "{line} {box_of} 1 {line} 2 {} -{}", ends.from + 1, ends.to + 1);
    }
    if curves > statement.lines.len() {
        let at = |&v: &usize| mesh.vertices[v].position;
        let _ = writeln!(text, "{curves} {} 1 {curves} 0", bounds(mesh.guide_edges.iter().flatten().map(at)));
    }
    for (region, r) in regions.iter().enumerate() {
        let uses: Vec<_> = r.loops.iter().flatten().collect();
        let ends = uses.iter().map(|u| points[statement.lines[u.line].from]);
        let _ = write!(text, "{0} {1} 1 {0}", region + 1, bounds(ends));
        // A slit does not bound the surface, it is inside.
        let is_slit = |line: usize| uses.iter().filter(|u| u.line == line).count() == 2;
        let bounding: Vec<_> = uses.iter().filter(|u| !is_slit(u.line)).collect();
        let _ = write!(text, " {}", bounding.len());
        for used in bounding {
            let _ = write!(text, " {}{}", if used.forward { "" } else { "-" }, used.line + 1);
        }
        text.push('\n');
    }
    text.push_str("$EndEntities\n");
}

/// Vertices of each entity, by dimension and index.
fn nodes(statement: &Statement, mesh: &Mesh, text: &mut String) {
    let mut region = vec![0; mesh.vertices.len()];
    for t in &mesh.triangles {
        t.corners.iter().for_each(|&v| region[v] = t.region);
    }
    let counts = [statement.points.len(), statement.lines.len(), statement.regions.len()];
    let mut blocks = counts.map(|count| vec![Vec::new(); count]);
    for (v, vertex) in mesh.vertices.iter().enumerate() {
        match vertex.place {
            Place::Corner { point } => blocks[0][point].push(v),
            Place::OnLine { line, .. } => blocks[1][line].push(v),
            Place::Inside => blocks[2][region[v]].push(v),
        }
    }
    let (count, all) = (blocks.iter().flatten().filter(|b| !b.is_empty()).count(), mesh.vertices.len());
    let _ = writeln!(text, "$Nodes\n{count} {all} {} {all}", all.min(1));
    for (dimension, blocks) in blocks.iter().enumerate() {
        for (entity, block) in blocks.iter().enumerate().filter(|b| !b.1.is_empty()) {
            let _ = writeln!(text, "{dimension} {} 0 {}", entity + 1, block.len());
            for v in block {
                let _ = writeln!(text, "{}", v + 1);
            }
            for &v in block {
                let [x, y] = mesh.vertices[v].position;
                let _ = writeln!(text, "{x:?} {y:?} 0");
            }
        }
    }
    text.push_str("$EndNodes\n");
}

fn elements(statement: &Statement, mesh: &Mesh, curves: usize, text: &mut String) {
    let mut chains: Vec<Vec<[usize; 2]>> =
        mesh.lines.iter().map(|l| l.windows(2).map(|p| [p[0], p[1]]).collect()).collect();
    if curves > statement.lines.len() {
        chains.push(mesh.guide_edges.clone());
    }
    let mut regions = vec![Vec::new(); statement.regions.len()];
    for (i, t) in mesh.triangles.iter().enumerate() {
        regions[t.region].push(i);
    }
    let filled = regions.iter().filter(|r| !r.is_empty()).count();
    let all = mesh.triangles.len() + chains.iter().map(Vec::len).sum::<usize>();
    let _ = writeln!(text, "$Elements\n{} {all} {} {all}", chains.len() + filled, all.min(1));
    let mut tag = mesh.triangles.len();
    for (line, chain) in chains.iter().enumerate() {
        let _ = writeln!(text, "1 {} 1 {}", line + 1, chain.len());
        for [a, b] in chain {
            tag += 1;
            let _ = writeln!(text, "{tag} {} {}", a + 1, b + 1);
        }
    }
    for (region, triangles) in regions.iter().enumerate().filter(|r| !r.1.is_empty()) {
        let _ = writeln!(text, "2 {} 2 {}", region + 1, triangles.len());
        for &i in triangles {
            let [a, b, c] = mesh.triangles[i].corners.map(|v| v + 1);
            let _ = writeln!(text, "{} {a} {b} {c}", i + 1);
        }
    }
    text.push_str("$EndElements\n");
}
