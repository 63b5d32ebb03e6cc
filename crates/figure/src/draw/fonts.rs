//! The embedded font: measuring, outlining, shortening and wrapping texts.

use std::sync::LazyLock;

use ttf_parser::{Face, FaceParsingError, OutlineBuilder};

use crate::error::FigureError;

/// What SVG files ask for; the alternatives have nearly the same widths.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, Geneva, sans-serif";

static FACES: LazyLock<Result<[Face<'_>; 2], FaceParsingError>> =
    LazyLock::new(|| Ok([Face::parse(dejavu::sans::regular(), 0)?, Face::parse(dejavu::sans::bold(), 0)?]));

fn face(bold: bool) -> Option<&'static Face<'static>> {
    FACES.as_ref().ok().map(|faces| &faces[usize::from(bold)])
}

/// Fails if the embedded font cannot be read; after this, all functions here know the widths of letters.
pub(crate) fn check() -> Result<(), FigureError> {
    let unreadable = |error| FigureError::Backend(format!("the embedded font: {error}"));
    FACES.as_ref().map(drop).map_err(unreadable)
}

/// Width of a text in px.
pub(crate) fn width(text: &str, em: f64, bold: bool) -> f64 {
    let Some(face) = face(bold) else { return 0.0 };
    let advance = |c| f64::from(face.glyph_hor_advance(glyph(face, c)).unwrap_or_default());
    text.chars().map(advance).sum::<f64>() * em / f64::from(face.units_per_em())
}

/// The outline of a text as SVG path data, in units of the font with y upwards, and how many of these an em has.
pub(crate) fn outline(text: &str, bold: bool) -> (String, f64) {
    let Some(face) = face(bold) else { return (String::new(), 1.0) };
    let mut pen = Outline { steps: String::new(), left: 0.0 };
    for c in text.chars() {
        let glyph = glyph(face, c);
        face.outline_glyph(glyph, &mut pen);
        pen.left += f32::from(face.glyph_hor_advance(glyph).unwrap_or_default());
    }
    (pen.steps, f64::from(face.units_per_em()))
}

/// The first glyph of a font stands for all letters that it does not have.
fn glyph(face: &Face<'_>, c: char) -> ttf_parser::GlyphId {
    face.glyph_index(c).unwrap_or_default()
}

/// Writes path data, moved to the right by `left`.
struct Outline {
    steps: String,
    left: f32,
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.steps += &format!("M{} {y}", x + self.left);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.steps += &format!("L{} {y}", x + self.left);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.steps += &format!("Q{} {y1} {} {y}", x1 + self.left, x + self.left);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.steps += &format!("C{} {y1} {} {y2} {} {y}", x1 + self.left, x2 + self.left, x + self.left);
    }

    fn close(&mut self) {
        self.steps.push('Z');
    }
}

/// The text, shortened with an ellipsis to fit into `limit` px.
pub(crate) fn fit(text: &str, em: f64, bold: bool, limit: f64) -> String {
    // A limit that was summed up from this very width may have lost its last digits.
    let limit = limit + 1e-6;
    if width(text, em, bold) <= limit {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while kept.pop().is_some() {
        let shortened = format!("{}…", kept.trim_end());
        if width(&shortened, em, bold) <= limit {
            return shortened;
        }
    }
    "…".to_owned()
}

/// The text on at most `max_lines` lines of `limit` px, broken at spaces; the rest is cut off with
/// an ellipsis.
pub(crate) fn wrap(text: &str, em: f64, bold: bool, limit: f64, max_lines: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let may_break = lines.len() < max_lines;
        match lines.last_mut() {
            Some(line) => {
                let longer = format!("{line} {word}");
                if may_break && width(&longer, em, bold) > limit {
                    lines.push(word.to_owned());
                } else {
                    *line = longer;
                }
            }
            None => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| fit(line, em, bold, limit)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_and_shortens() {
        let full = width("Shear stress (kPa)", 13.0, false);
        assert!((90.0..150.0).contains(&full), "{full}");
        assert!(width("Shear", 13.0, true) > width("Shear", 13.0, false));
        let short = fit("Shear stress (kPa)", 13.0, false, 60.0);
        assert!(short.ends_with('…') && width(&short, 13.0, false) < 60.1, "{short}");
    }

    #[test]
    fn wraps_at_spaces_and_cuts_the_rest() {
        let lines = wrap("one two three four five six seven eight", 13.0, false, 70.0, 2);
        assert_eq!(lines.len(), 2);
        assert!(lines[1].ends_with('…'));
        assert!(wrap("   ", 13.0, false, 70.0, 2).is_empty());
    }
}
