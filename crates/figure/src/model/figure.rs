//! The figure itself.

use serde::Serialize;

use super::check::check;
use super::{Axis, Layer, Scale};
use crate::error::FigureError;

/// Where the legend goes. It never covers data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Legend {
    /// Below the plot; suits long names and narrow screens.
    #[default]
    Below,
    /// To the right of the plot; suits many short names.
    Right,
    /// No legend.
    Hidden,
}

/// A figure: two axes and layers in draw order.
///
/// Layers are checked when they are pushed, so a figure is valid at any time. Spans are drawn
/// beneath and reference lines and texts above the other layers, whatever the order of pushing;
/// all backends agree on this.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figure {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) equal_aspect: bool,
    pub(crate) legend: Legend,
    pub(crate) layers: Vec<Layer>,
}

impl Figure {
    /// An empty figure.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, equal_aspect: false, legend: Legend::default(), layers: Vec::new() }
    }

    /// Sets the place of the legend.
    #[must_use]
    pub fn with_legend(mut self, legend: Legend) -> Self {
        self.legend = legend;
        self
    }

    /// Makes one unit of x as long as one unit of y; ranges are widened as needed, fixed ones too.
    ///
    /// # Errors
    ///
    /// [`FigureError::EqualAspectOnLog`] if an axis is logarithmic.
    pub fn with_equal_aspect(mut self) -> Result<Self, FigureError> {
        for axis in [&self.x, &self.y] {
            if axis.scale == Scale::Log {
                return Err(FigureError::EqualAspectOnLog { axis: axis.label.clone() });
            }
        }
        self.equal_aspect = true;
        Ok(self)
    }

    /// Adds a layer on top of the present ones.
    ///
    /// # Errors
    ///
    /// A [`FigureError`] that names the first value, length or width the layer is refused for.
    pub fn push(&mut self, layer: impl Into<Layer>) -> Result<&mut Self, FigureError> {
        let mut layer = layer.into();
        check(&layer, &self.x, &self.y)?;
        let taken = self.layers.iter_mut().filter_map(Layer::series_color).count();
        if let Some(color) = layer.series_color() {
            color.get_or_insert(taken);
        }
        self.layers.push(layer);
        Ok(self)
    }

    /// The title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The horizontal axis.
    pub fn x_axis(&self) -> &Axis {
        &self.x
    }

    /// The vertical axis.
    pub fn y_axis(&self) -> &Axis {
        &self.y
    }

    /// The layers in the order they were pushed.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }
}
