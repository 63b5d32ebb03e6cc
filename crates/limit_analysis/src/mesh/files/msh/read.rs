//! From the text to nodes and elements, as the file has them.

use std::collections::BTreeMap;

use super::super::FileError;
use super::elements::Element;
use super::scan::Scan;

/// Most physical groups that an entity can be in.
const MOST_GROUPS: usize = 16;

/// What a file holds.
#[derive(Default)]
pub(super) struct Raw {
    /// Coordinates by number.
    pub(super) nodes: BTreeMap<u64, [f64; 3]>,
    /// Number of the point of the geometry at a node, by the node's number.
    pub(super) points: BTreeMap<u64, i64>,
    /// Names of physical groups by dimension and number.
    pub(super) names: BTreeMap<(u64, i64), String>,
    /// Physical groups of entities by dimension and number.
    pub(super) groups: BTreeMap<(u64, i64), Vec<i64>>,
    /// Points, lines and triangles.
    pub(super) elements: [Vec<Element>; 3],
}

/// Reads all sections that matter and skips others.
pub(super) fn read(bytes: &[u8]) -> Result<Raw, FileError> {
    let mut scan = Scan::new(bytes);
    scan.expect("$MeshFormat")?;
    let version = scan.word("the version of the format")?;
    let wrong = |found: &str, line| FileError::Version { line, found: found.chars().take(20).collect() };
    let new = version == "4.1";
    if !new && !["2", "2.0", "2.1", "2.2"].contains(&version) {
        return Err(wrong(version, scan.line));
    }
    if scan.word("0 for ASCII")? != "0" {
        return Err(wrong("binary", scan.line));
    }
    scan.skip(1, "the size of numbers")?;
    scan.expect("$EndMeshFormat")?;
    let mut raw = Raw::default();
    while let Some(text) = scan.text()? {
        match text {
            "$PhysicalNames" => raw.names(&mut scan)?,
            "$Entities" if new => raw.entities(&mut scan)?,
            "$Nodes" if new => raw.nodes_by_entity(&mut scan)?,
            "$Nodes" => raw.nodes(&mut scan)?,
            "$Elements" if new => raw.elements_by_entity(&mut scan)?,
            "$Elements" => raw.elements(&mut scan)?,
            "$ParametricNodes" => return Err(wrong(text, scan.line)),
            _ if text.starts_with('$') => skip_section(&mut scan, text)?,
            _ => return Err(scan.syntax("a section, a word that begins with $", text)),
        }
    }
    Ok(raw)
}

fn skip_section(scan: &mut Scan, begin: &str) -> Result<(), FileError> {
    let line = scan.line;
    while let Some(text) = scan.text()? {
        if text.strip_prefix("$End") == begin.get(1..) {
            return Ok(());
        }
    }
    Err(FileError::Ends { line, expected: "the end of the section that begins there" })
}

impl Raw {
    fn names(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let count: u64 = scan.number("the number of physical names")?;
        for _ in 0..count {
            let dimension = scan.number("a dimension, 0 to 3")?;
            let tag = scan.number("the number of a physical group")?;
            let expected = "a name in quotes";
            let text = scan.text()?.ok_or(FileError::Ends { line: scan.line, expected })?;
            let inner = text.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
            let name = inner.ok_or_else(|| scan.syntax(expected, text))?;
            self.names.insert((dimension, tag), name.to_owned());
        }
        scan.expect("$EndPhysicalNames")
    }

    fn entities(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let mut counts = [0u64; 4];
        for count in &mut counts {
            *count = scan.number("the number of entities")?;
        }
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let tag: i64 = scan.number("the number of an entity")?;
                scan.skip(if dimension == 0 { 3 } else { 6 }, "the box around an entity")?;
                let line = scan.line;
                let groups: u64 = scan.number("the number of physical groups")?;
                let mut list = Vec::new();
                for _ in 0..groups {
                    let group: i64 = scan.number("the number of a physical group")?;
                    list.push(group.saturating_abs());
                }
                if dimension > 0 {
                    let bounds = scan.number("the number of bounding entities")?;
                    scan.skip(bounds, "the number of an entity")?;
                }
                list.sort_unstable();
                list.dedup();
                // A region is one group.
                let limit = if dimension == 2 { 1 } else { MOST_GROUPS };
                if list.len() > limit {
                    return Err(FileError::Groups { line, count: list.len(), limit });
                }
                if !list.is_empty() {
                    self.groups.insert((dimension, tag), list);
                }
            }
        }
        scan.expect("$EndEntities")
    }

    fn nodes(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let count: u64 = scan.number("the number of nodes")?;
        for _ in 0..count {
            let tag = scan.number("the number of a node")?;
            let line = scan.line;
            let at = [scan.coordinate()?, scan.coordinate()?, scan.coordinate()?];
            self.node(tag, at, line)?;
        }
        scan.expect("$EndNodes")
    }

    fn nodes_by_entity(&mut self, scan: &mut Scan) -> Result<(), FileError> {
        let blocks: u64 = scan.number("the number of entities with nodes")?;
        scan.skip(3, "numbers of nodes")?;
        for _ in 0..blocks {
            let dimension: u64 = scan.number("a dimension, 0 to 3")?;
            let entity: i64 = scan.number("the number of an entity")?;
            let parameters = if scan.number::<u64>("0 or 1")? == 0 { 0 } else { dimension.min(3) };
            let count: u64 = scan.number("the number of nodes")?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push((scan.number("the number of a node")?, scan.line));
            }
            for (tag, line) in tags {
                let at = [scan.coordinate()?, scan.coordinate()?, scan.coordinate()?];
                scan.skip(parameters, "a parameter of a node")?;
                self.node(tag, at, line)?;
                if dimension == 0 {
                    self.points.insert(tag, entity);
                }
            }
        }
        scan.expect("$EndNodes")
    }

    fn node(&mut self, tag: u64, at: [f64; 3], line: usize) -> Result<(), FileError> {
        match self.nodes.insert(tag, at) {
            Some(_) => Err(FileError::Twice { line, what: "node", tag }),
            None => Ok(()),
        }
    }
}
