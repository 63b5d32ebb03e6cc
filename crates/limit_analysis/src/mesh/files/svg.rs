//! A picture of a mesh.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::super::extract::Mesh;
use super::FileError;

/// Space round the mesh, pixels.
const MARGIN: f64 = 4.0;

/// What to draw: the edges, the lines of the outline thicker, and guide edges in red.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Svg<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Width of the picture in pixels, from 16 to 100 000. The height follows.
    pub width: f64,
    /// Red, green and blue of each triangle; without them triangles are not filled.
    pub colours: Option<&'a [[u8; 3]]>,
}

impl Svg<'_> {
    /// The file's text.
    ///
    /// # Errors
    ///
    /// [`FileError::BadField`] for a width out of range, colours that are not as many as triangles, and a mesh without
    /// vertices.
    pub fn write(&self) -> Result<String, FileError> {
        let bad = |name: &str, value, allowed: String| {
            Err(FileError::BadField { name: name.into(), what: "the number", value, allowed })
        };
        if !(16.0..=1e5).contains(&self.width) {
            return bad("width", self.width, "from 16 to 100000 pixels".into());
        }
        let triangles = &self.mesh.triangles;
        if let Some(colours) = self.colours.filter(|c| c.len() != triangles.len()) {
            return bad(
                "colours",
                colours.len() as f64,
                format!("{}, as there are triangles", triangles.len()),
            );
        }
        if self.mesh.vertices.is_empty() {
            return bad("vertices", 0.0, "at least 1".into());
        }
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for v in &self.mesh.vertices {
            for d in 0..2 {
                low[d] = low[d].min(v.position[d]);
                high[d] = high[d].max(v.position[d]);
            }
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let scale = (self.width - 2.0 * MARGIN) / if extent[0] > 0.0 { extent[0] } else { 1.0 };
        let height = scale * extent[1] + 2.0 * MARGIN;
        let at = |v: usize| {
            let [x, y] = self.mesh.vertices[v].position;
            format!("{:.2} {:.2}", MARGIN + scale * (x - low[0]), MARGIN + scale * (high[1] - y))
        };
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2} {height:.2}\" width=\"{0:.2}\" \
             height=\"{height:.2}\" stroke-linejoin=\"round\" stroke-linecap=\"round\" fill=\"none\">\n",
            self.width
        );
        for (t, [r, g, b]) in triangles.iter().zip(self.colours.unwrap_or(&[])) {
            let [p, q, s] = t.corners.map(at);
            // The stroke covers the gaps that renderers leave between neighbours.
            let colour = format!("#{r:02x}{g:02x}{b:02x}");
            let _ = writeln!(
                svg,
                "<path d=\"M{p}L{q}L{s}Z\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.3\"/>"
            );
        }
        let edges: BTreeSet<[usize; 2]> = triangles
            .iter()
            .flat_map(|t| [0, 1, 2].map(|i| [t.corners[i], t.corners[(i + 1) % 3]]))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let lines = self.mesh.lines.iter().flat_map(|l| l.windows(2)).map(|p| [p[0], p[1]]);
        for (class, colour, width, edges) in [
            ("edges", "#444", 0.4, edges.into_iter().collect::<Vec<_>>()),
            ("guides", "#d00", 1.0, self.mesh.guide_edges.clone()),
            ("lines", "#000", 1.4, lines.collect()),
        ] {
            let _ = write!(svg, "<path class=\"{class}\" stroke=\"{colour}\" stroke-width=\"{width}\" d=\"");
            edges.into_iter().for_each(|[a, b]| svg += &format!("M{}L{}", at(a), at(b)));
            svg += "\"/>\n";
        }
        svg += "</svg>\n";
        Ok(svg)
    }
}
