//! ParaView's XML format for unstructured grids: cells of one shape that share no points, numbers as base64.

use std::fmt::Write;

use base64::prelude::{BASE64_STANDARD, Engine};

use crate::error::LimitError;

/// The shape of all cells of a file.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Line,
    Triangle,
    Tetrahedron,
    /// Three corners, then the middles of the edges from corner 0 to 1, from 1 to 2, and from 2 to 0.
    QuadraticTriangle,
}

impl Shape {
    /// Points of a cell.
    const fn points(self) -> usize {
        match self {
            Self::Line => 2,
            Self::Triangle => 3,
            Self::Tetrahedron => 4,
            Self::QuadraticTriangle => 6,
        }
    }

    /// VTK's number of it.
    const fn number(self) -> u8 {
        match self {
            Self::Line => 3,
            Self::Triangle => 5,
            Self::Tetrahedron => 10,
            Self::QuadraticTriangle => 22,
        }
    }
}

/// Cells, cell by cell their points, and for each a whole number that has a name.
pub(super) struct Cells {
    pub(super) shape: Shape,
    pub(super) points: Vec<[f64; 3]>,
    pub(super) number: (&'static str, Vec<usize>),
}

/// Numbers at points, or in cells.
pub(super) struct Field {
    pub(super) name: &'static str,
    /// Numbers a point: 1 for scalars, 2 for vectors (written with a third that is zero), 9 for tensors.
    pub(super) components: usize,
    /// The numbers, point by point.
    pub(super) values: Vec<f64>,
}

impl Field {
    pub(super) fn scalar(name: &'static str, values: Vec<f64>) -> Self {
        Self { name, components: 1, values }
    }
}

/// The text of a file.
///
/// # Errors
///
/// [`LimitError::NotFinite`] for a number that is too large to be written.
pub(super) fn write(cells: &Cells, point_data: &[Field], cell_data: &[Field]) -> Result<String, LimitError> {
    let points =
        Field { name: "points", components: 3, values: cells.points.iter().flatten().copied().collect() };
    for field in point_data.iter().chain(cell_data).chain([&points]) {
        if let Some(value) = field.values.iter().find(|v| !v.is_finite()) {
            return Err(LimitError::NotFinite { field: field.name, value: *value });
        }
    }
    let (shape, (name, numbers)) = (cells.shape, &cells.number);
    let (count, nodes) = (numbers.len(), cells.points.len());
    let mut a = Arrays::default();
    a.xml += "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
              byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    let _ = writeln!(a.xml, "<Piece NumberOfPoints=\"{nodes}\" NumberOfCells=\"{count}\">");
    a.xml += "<PointData>\n";
    point_data.iter().for_each(|f| a.field(f));
    a.xml += "</PointData>\n<CellData>\n";
    a.integers(name, numbers.iter().copied());
    cell_data.iter().for_each(|f| a.field(f));
    a.xml += "</CellData>\n<Points>\n";
    a.field(&points);
    a.xml += "</Points>\n<Cells>\n";
    a.integers("connectivity", 0..nodes);
    a.integers("offsets", (1..=count).map(|i| shape.points() * i));
    a.array("UInt8", "types", 1, &vec![shape.number(); count]);
    a.xml += "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"base64\">\n_";
    a.xml += &a.appended;
    a.xml += "\n</AppendedData>\n</VTKFile>\n";
    Ok(a.xml)
}

/// A file in the making.
#[derive(Default)]
struct Arrays {
    /// The file up to here.
    xml: String,
    /// The appended part, encoded.
    appended: String,
}

impl Arrays {
    fn field(&mut self, field: &Field) {
        let bytes = |values: &[f64]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
        if field.components == 2 {
            let padded: Vec<f64> = field.values.chunks(2).flat_map(|v| [v[0], v[1], 0.0]).collect();
            self.array("Float64", field.name, 3, &bytes(&padded));
        } else {
            self.array("Float64", field.name, field.components, &bytes(&field.values));
        }
    }

    fn integers(&mut self, name: &str, values: impl Iterator<Item = usize>) {
        let bytes: Vec<u8> = values.flat_map(|v| (v as u64).to_le_bytes()).collect();
        self.array("Int64", name, 1, &bytes);
    }

    fn array(&mut self, kind: &str, name: &str, components: usize, bytes: &[u8]) {
        let _ = write!(self.xml, "<DataArray type=\"{kind}\" Name=\"{name}\"");
        // One goes without saying; some readers take a stated one for a column of a matrix.
        if components > 1 {
            let _ = write!(self.xml, " NumberOfComponents=\"{components}\"");
        }
        let _ = writeln!(self.xml, " format=\"appended\" offset=\"{}\"/>", self.appended.len());
        let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
        block.extend(bytes);
        BASE64_STANDARD.encode_string(&block, &mut self.appended);
    }
}
