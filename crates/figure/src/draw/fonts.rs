//! The font of the static renderers: registration, measuring, shortening and wrapping.

use std::sync::OnceLock;

use plotters::style::{FontStyle, FontTransform, IntoFont, RGBColor, TextStyle, register_font};

use crate::error::FigureError;
use crate::palette::Rgb;

/// Name under which the embedded font is registered. It doubles as the `font-family` of SVG files,
/// where the alternatives have nearly the same widths.
const FAMILY: &str = "DejaVu Sans, Verdana, Geneva, sans-serif";

/// Ascent plus descent of the font in em; the bitmap backend scales fonts by this height.
pub(crate) const LINE_HEIGHT: f64 = 1.1640625;

/// Registers the embedded fonts once per process.
pub(crate) fn register() -> Result<(), FigureError> {
    static DONE: OnceLock<bool> = OnceLock::new();
    let registered = *DONE.get_or_init(|| {
        register_font(FAMILY, FontStyle::Normal, dejavu::sans::regular()).is_ok()
            && register_font(FAMILY, FontStyle::Bold, dejavu::sans::bold()).is_ok()
    });
    if registered { Ok(()) } else { Err(FigureError::Backend("the embedded font is unreadable".into())) }
}

/// The text style of a font height as the backend counts it.
pub(crate) fn style(height: f64, bold: bool, upwards: bool, color: Rgb) -> TextStyle<'static> {
    let face = if bold { FontStyle::Bold } else { FontStyle::Normal };
    let turn = if upwards { FontTransform::Rotate270 } else { FontTransform::None };
    let color = RGBColor(color.0, color.1, color.2);
    (FAMILY, height, face).into_font().transform(turn).color(&color)
}

/// Width of a text in px.
pub(crate) fn width(text: &str, em: f64, bold: bool) -> f64 {
    // Measured large, because the backend rounds widths to whole pixels.
    const LARGE: f64 = 100.0;
    let face = if bold { FontStyle::Bold } else { FontStyle::Normal };
    let font = (FAMILY, LARGE * LINE_HEIGHT, face).into_font();
    match font.layout_box(text) {
        Ok(((left, _), (right, _))) => f64::from(right - left) * em / LARGE,
        // Only an unregistered font fails; an estimate keeps the layout usable.
        Err(_) => text.chars().count() as f64 * em * 0.65,
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
        register().unwrap();
        let full = width("Shear stress (kPa)", 13.0, false);
        assert!((90.0..150.0).contains(&full), "{full}");
        assert!(width("Shear", 13.0, true) > width("Shear", 13.0, false));
        let short = fit("Shear stress (kPa)", 13.0, false, 60.0);
        assert!(short.ends_with('…') && width(&short, 13.0, false) < 60.1, "{short}");
    }

    #[test]
    fn wraps_at_spaces_and_cuts_the_rest() {
        register().unwrap();
        let lines = wrap("one two three four five six seven eight", 13.0, false, 70.0, 2);
        assert_eq!(lines.len(), 2);
        assert!(lines[1].ends_with('…'));
        assert!(wrap("   ", 13.0, false, 70.0, 2).is_empty());
    }
}
