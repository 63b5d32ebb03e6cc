//! Several figures on one page.

use super::svg::Svg;
use super::words::Words;
use super::{draw_figure, png};
use crate::error::FigureError;
use crate::model::{Figure, Size};

/// Small multiples: figures of equal size on one page, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureGrid {
    figures: Vec<Figure>,
    columns: usize,
}

impl FigureGrid {
    /// A grid of `figures` with the given number of columns.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadGrid`] without figures, or unless there are 1 to 12 columns.
    pub fn new(figures: impl Into<Vec<Figure>>, columns: usize) -> Result<Self, FigureError> {
        let figures = figures.into();
        if figures.is_empty() || !(1..=12).contains(&columns) {
            return Err(FigureError::BadGrid { figures: figures.len(), columns });
        }
        Ok(Self { figures, columns })
    }

    /// Renders the page as an SVG document.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadSize`] if the cells come out below 160 px; otherwise as [`Figure::to_svg`].
    pub fn to_svg(&self, page: Size) -> Result<String, FigureError> {
        self.document(page, Words::Text)
    }

    /// Renders the page as a PNG file of twice `page`.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadSize`] if the cells come out below 160 px; otherwise as [`Figure::to_png`].
    pub fn to_png(&self, page: Size) -> Result<Vec<u8>, FigureError> {
        png::render(&self.document(page, Words::Outlines)?, page)
    }

    fn document(&self, page: Size, words: Words) -> Result<String, FigureError> {
        let columns = self.columns.min(self.figures.len()) as u32;
        let rows = (self.figures.len() as u32).div_ceil(columns);
        let cell = Size::new(page.width() / columns, page.height() / rows)?;
        let titles: Vec<&str> = self.figures.iter().map(Figure::title).collect();
        let mut svg = Svg::new(page, &titles.join("; "), words, "");
        for (i, figure) in (0_u32..).zip(&self.figures) {
            let corner = (f64::from(i % columns * cell.width()), f64::from(i / columns * cell.height()));
            svg.moved(corner, |svg| draw_figure(figure, cell, svg))?;
        }
        Ok(svg.finish())
    }
}
