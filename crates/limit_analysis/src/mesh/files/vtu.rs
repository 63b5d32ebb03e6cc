//! ParaView's XML format for unstructured grids.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::super::extract::Mesh;
use super::super::vector::along;
use super::FileError;
use super::arrays::Arrays;

/// Which points the file has, and with that how data at points are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// One point for each vertex: fields are continuous, with a value for each vertex.
    Vertices,
    /// Three points for each triangle: fields may jump. The values of a triangle's corners, triangle by triangle.
    Corners,
    /// Six points for each triangle: fields are quadratic in it and may jump. For each triangle the values at its three
    /// corners, then at the middles of its edges from corner 0 to 1, from 1 to 2, and from 2 to 0.
    Quadratic,
}

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// Decimal, with as many digits as tell the number exactly.
    Ascii,
    /// Base64 in the appended part: 64 bits a number, exact, quick to read.
    Base64,
}

/// Numbers at points, or in triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field<'a> {
    /// Name, not empty, different from that of the file's other fields of the same kind; with the unit at its end.
    pub name: &'a str,
    /// Numbers a point: 1 for scalars, 2 for vectors (written with a third that is zero), 3 for other things, 9 for
    /// tensors.
    pub components: usize,
    /// The numbers, finite, point by point.
    pub values: &'a [f64],
}

/// What to write.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vtu<'a> {
    /// The mesh. The region of each triangle is written as the cell data "region".
    pub mesh: &'a Mesh,
    /// Which points there are.
    pub layout: Layout,
    /// Data at points.
    pub point_data: &'a [Field<'a>],
    /// Data in triangles.
    pub cell_data: &'a [Field<'a>],
    /// How numbers are written.
    pub encoding: Encoding,
}

impl Vtu<'_> {
    /// The file's text.
    ///
    /// # Errors
    ///
    /// [`FileError::BadField`] for fields with the wrong number of values, with values that are not finite, with a name
    /// that is empty, is used twice, or is that of "region", and with other numbers of components than 1, 2, 3 and 9.
    pub fn write(&self) -> Result<String, FileError> {
        let mesh = self.mesh;
        let (points, per_cell) = self.points();
        let cells = mesh.triangles.len();
        check(self.point_data, points.len() / 3, &[])?;
        check(self.cell_data, cells, &["region"])?;
        let mut a = Arrays { encoding: self.encoding, xml: String::new(), appended: String::new() };
        a.xml += "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
                  byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
        let _ = writeln!(a.xml, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">", points.len() / 3);
        a.xml += "<PointData>\n";
        self.point_data.iter().for_each(|f| a.field(f));
        a.xml += "</PointData>\n<CellData>\n";
        a.integers("Int64", "region", mesh.triangles.iter().map(|t| t.region));
        self.cell_data.iter().for_each(|f| a.field(f));
        a.xml += "</CellData>\n<Points>\n";
        a.field(&Field { name: "points", components: 3, values: &points });
        a.xml += "</Points>\n<Cells>\n";
        if self.layout == Layout::Vertices {
            a.integers("Int64", "connectivity", mesh.triangles.iter().flat_map(|t| t.corners));
        } else {
            a.integers("Int64", "connectivity", 0..points.len() / 3);
        }
        a.integers("Int64", "offsets", (1..=cells).map(|i| i * per_cell));
        a.integers("UInt8", "types", std::iter::repeat_n(if per_cell == 6 { 22 } else { 5 }, cells));
        a.xml += "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
        if self.encoding == Encoding::Base64 {
            a.xml += "<AppendedData encoding=\"base64\">\n_";
            a.xml += &a.appended;
            a.xml += "\n</AppendedData>\n";
        }
        a.xml += "</VTKFile>\n";
        Ok(a.xml)
    }

    /// Three coordinates of each point, and how many points a triangle has.
    fn points(&self) -> (Vec<f64>, usize) {
        let at = |v: usize| self.mesh.vertices[v].position;
        let corners = || self.mesh.triangles.iter().map(|t| t.corners.map(at));
        let (points, per_cell): (Vec<[f64; 2]>, usize) = match self.layout {
            Layout::Vertices => (self.mesh.vertices.iter().map(|v| v.position).collect(), 3),
            Layout::Corners => (corners().flatten().collect(), 3),
            Layout::Quadratic => {
                let middle = |a, b| along(a, b, 0.5);
                let six = |[a, b, c]: [[f64; 2]; 3]| [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
                (corners().flat_map(six).collect(), 6)
            }
        };
        (points.into_iter().flat_map(|[x, y]| [x, y, 0.0]).collect(), per_cell)
    }
}

fn check(fields: &[Field], count: usize, reserved: &[&str]) -> Result<(), FileError> {
    let mut names: BTreeSet<&str> = reserved.iter().copied().collect();
    for field in fields {
        let bad = |what, value, allowed: &str| {
            Err(FileError::BadField { name: field.name.into(), what, value, allowed: allowed.into() })
        };
        if field.name.is_empty() || !names.insert(field.name) {
            return bad("how often the name is there", 2.0, "1, and the name not empty and not \"region\"");
        }
        if ![1, 2, 3, 9].contains(&field.components) {
            return bad("the number of components", field.components as f64, "1, 2, 3 or 9");
        }
        let wanted = count * field.components;
        if field.values.len() != wanted {
            let allowed = format!("{wanted}: {count} points or triangles, {} each", field.components);
            return bad("the number of values", field.values.len() as f64, &allowed);
        }
        if let Some(&value) = field.values.iter().find(|v| !v.is_finite()) {
            return bad("a value", value, "finite");
        }
    }
    Ok(())
}
