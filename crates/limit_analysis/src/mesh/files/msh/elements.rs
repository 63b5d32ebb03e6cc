//! The elements of a file.

use super::super::FileError;
use super::read::Raw;
use super::scan::Scan;

/// A point, a line or a triangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    pub(super) tag: u64,
    /// Line of the file.
    pub(super) line: usize,
    /// The point, curve or surface that it is part of.
    pub(super) entity: i64,
    /// Its physical group if the element itself has one, else 0: then the entity's groups count.
    pub(super) group: i64,
    /// Its nodes, as many as it has; the others are 0.
    pub(super) nodes: [u64; 3],
}

/// Dimension and number of nodes of gmsh's element types.
fn dimension(kind: u64, line: usize) -> Result<usize, FileError> {
    match kind {
        15 => Ok(0),
        1 => Ok(1),
        2 => Ok(2),
        _ => Err(FileError::Element { line, kind }),
    }
}

fn nodes(scan: &mut Scan, dimension: usize) -> Result<[u64; 3], FileError> {
    let mut nodes = [0; 3];
    for node in &mut nodes[..=dimension] {
        *node = scan.number("the number of a node")?;
    }
    Ok(nodes)
}

impl Raw {
    /// Elements of version 2.
    pub(super) fn elements(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let count: u64 = scan.number("the number of elements")?;
        for _ in 0..count {
            let tag = scan.number("the number of an element")?;
            let line = scan.line;
            let dimension = dimension(scan.number("the type of an element")?, line)?;
            let tags: u64 = scan.number("how many tags the element has")?;
            let group = if tags > 0 { scan.number::<i64>("the number of a physical group")? } else { 0 };
            let entity = if tags > 1 { scan.number("the number of an entity")? } else { 0 };
            scan.skip(tags.saturating_sub(2), "the number of a partition")?;
            let nodes = nodes(scan, dimension)?;
            if dimension == 0 {
                self.points.insert(nodes[0], entity);
            }
            let group = group.saturating_abs();
            self.elements[dimension].push(Element { tag, line, entity, group, nodes });
        }
        scan.expect("$EndElements")
    }

    /// Elements of version 4.
    pub(super) fn elements_by_entity(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let blocks: u64 = scan.number("the number of entities with elements")?;
        scan.skip(3, "numbers of elements")?;
        for _ in 0..blocks {
            scan.skip(1, "a dimension, 0 to 3")?;
            let entity = scan.number("the number of an entity")?;
            let line = scan.line;
            let dimension = dimension(scan.number("the type of elements")?, line)?;
            let count: u64 = scan.number("the number of elements")?;
            for _ in 0..count {
                let tag = scan.number("the number of an element")?;
                let line = scan.line;
                let nodes = nodes(scan, dimension)?;
                self.elements[dimension].push(Element { tag, line, entity, group: 0, nodes });
            }
        }
        scan.expect("$EndElements")
    }

    /// The physical groups of an element, ascending.
    pub(super) fn groups(&self, element: &Element, dimension: u64) -> Vec<i64> {
        if element.group != 0 {
            return vec![element.group];
        }
        self.groups.get(&(dimension, element.entity)).cloned().unwrap_or_default()
    }
}
