//! ParaView's XML format for unstructured grids: quadratic triangles that share no points, numbers as base64.

use std::fmt::Write;

use base64::prelude::{BASE64_STANDARD, Engine};

use super::Point;
use crate::error::LimitError;
use crate::mesh::Mesh;
use crate::vector::along;

/// VTK's number of the triangle with six nodes.
const QUADRATIC_TRIANGLE: u8 = 22;

/// Numbers at points, or in triangles.
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

/// The text of a file. For each triangle, data at points are those at its three corners, then at the middles of its edges
/// from corner 0 to 1, from 1 to 2, and from 2 to 0. The region of each triangle is written too.
///
/// # Errors
///
/// [`LimitError::NotFinite`] for a number that is too large to be written.
pub(super) fn write(mesh: &Mesh, point_data: &[Field], cell_data: &[Field]) -> Result<String, LimitError> {
    for field in point_data.iter().chain(cell_data) {
        if let Some(value) = field.values.iter().find(|v| !v.is_finite()) {
            return Err(LimitError::NotFinite { field: field.name, value: *value });
        }
    }
    let cells = mesh.triangles.len();
    let six = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        [a, b, c, along(a, b, 0.5), along(b, c, 0.5), along(c, a, 0.5)]
    };
    let points = (0..cells).flat_map(six).flat_map(|[x, y]: Point| [x, y, 0.0]).collect();
    let mut a = Arrays::default();
    a.xml += "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
              byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    let _ = writeln!(a.xml, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">", 6 * cells);
    a.xml += "<PointData>\n";
    point_data.iter().for_each(|f| a.field(f));
    a.xml += "</PointData>\n<CellData>\n";
    a.integers("region", mesh.triangles.iter().map(|t| t.region));
    cell_data.iter().for_each(|f| a.field(f));
    a.xml += "</CellData>\n<Points>\n";
    a.field(&Field { name: "points", components: 3, values: points });
    a.xml += "</Points>\n<Cells>\n";
    a.integers("connectivity", 0..6 * cells);
    a.integers("offsets", (1..=cells).map(|i| 6 * i));
    a.array("UInt8", "types", 1, &vec![QUADRATIC_TRIANGLE; cells]);
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
