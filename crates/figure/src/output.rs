//! The forms a figure is rendered to.

use crate::error::FigureError;
use crate::model::{Figure, Size};
use crate::{csv, draw, interactive};

impl Figure {
    /// Renders the figure as an SVG document.
    ///
    /// # Errors
    ///
    /// [`FigureError::EmptyFigure`] without layers, [`FigureError::Backend`] if drawing fails.
    pub fn to_svg(&self, size: Size) -> Result<String, FigureError> {
        draw::to_svg(self, size, "")
    }

    /// Renders the figure as a PNG file of twice `size` (for sharp text on dense screens).
    ///
    /// # Errors
    ///
    /// [`FigureError::EmptyFigure`] without layers, [`FigureError::Backend`] if drawing fails.
    pub fn to_png(&self, size: Size) -> Result<Vec<u8>, FigureError> {
        draw::to_png(self, size)
    }

    /// The figure as plotly.js input: an object with `data` and `layout`.
    pub fn to_plotly_json(&self) -> serde_json::Value {
        interactive::to_json(self)
    }

    /// All data of the figure in long form, as a CSV file with the columns
    /// `layer,kind,name,part,ring,x,y,y_low,y_high,text`.
    ///
    /// | column | meaning |
    /// |---|---|
    /// | `layer` | number of the layer, from 1 in draw order |
    /// | `kind` | `line`, `band`, `polygons`, `points`, `paths`, `shades`, `hspan`, `vspan`, `hline`, `vline` or `text` |
    /// | `name` | name of the layer |
    /// | `part`, `ring` | number of the polygon or the path from 1; 0 for its exterior, from 1 for its holes |
    /// | `x`, `y` | coordinates in the units of the axes; a `vspan` has one row per end |
    /// | `y_low`, `y_high` | ends of a band, of a horizontal span or of an error bar |
    /// | `text` | hover label of a point, the text of a text layer or the value of a shaded polygon |
    ///
    /// Fields that do not apply are empty. Numbers are written with as many digits as are needed
    /// to read back the same value; quoting follows RFC 4180 with LF line ends.
    pub fn to_csv(&self) -> String {
        csv::to_csv(self)
    }
}
