//! Page sizes.

use crate::error::FigureError;

/// Smallest side of a page on which a figure stays legible.
const MIN_SIDE: u32 = 160;
/// Largest side; bounds the memory of the bitmap renderer.
const MAX_SIDE: u32 = 2000;

/// Size of a rendered figure in px. PNG files have twice as many pixels along each side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// A page of `width` times `height` px.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadSize`] unless both sides are between 160 and 2000 px.
    pub fn new(width: u32, height: u32) -> Result<Self, FigureError> {
        let allowed = MIN_SIDE..=MAX_SIDE;
        if allowed.contains(&width) && allowed.contains(&height) {
            Ok(Self { width, height })
        } else {
            Err(FigureError::BadSize { width, height, min: MIN_SIDE })
        }
    }

    /// Width in px.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Height in px.
    pub fn height(self) -> u32 {
        self.height
    }
}

impl Default for Size {
    /// 760 x 480 px, about the width of a text column.
    fn default() -> Self {
        Self { width: 760, height: 480 }
    }
}
