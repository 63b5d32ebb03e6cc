//! The page: one document, put together from its parts.

use soilctl_live::protocol::{FORCE_M_PER_N, LEAD_SCALE};

/// Where the style goes, where the scripts go, and the number that allows them.
const STYLE_MARK: &str = "/*STYLE*/";
const SCRIPT_MARK: &str = "/*SCRIPT*/";
const NONCE_MARK: &str = "NONCE";

/// Where the scales of arrows go, which are those of all programs.
const SCALE_MARKS: [(&str, f64); 2] = [("/*FORCE_M_PER_N*/", FORCE_M_PER_N), ("/*LEAD_SCALE*/", LEAD_SCALE)];

const DOCUMENT: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/style.css");
/// What paints an arm, a box and soil, in the order in which they build on each other; the page for digging has it too.
const PAINTER: [&str; 7] = [
    include_str!("../page/matrix.js"),
    include_str!("../page/fit.js"),
    include_str!("../page/shapes.js"),
    include_str!("../page/arm.js"),
    include_str!("../page/soil.js"),
    include_str!("../page/shaders.js"),
    include_str!("../page/painter.js"),
];
/// What other modules take from it.
const PAINTER_EXPORTS: &str = "export {Matrix, Vector, Shapes, Painter, KIND, LOOKS, across};\n";
/// What the page has beside it, in the order in which they build on each other.
const SCRIPTS: [&str; 6] = [
    include_str!("../page/pace.js"),
    include_str!("../page/scene.js"),
    include_str!("../page/charts.js"),
    include_str!("../page/player.js"),
    include_str!("../page/panel.js"),
    include_str!("../page/main.js"),
];

/// The page with a number used once.
pub(crate) fn page(nonce: &str) -> String {
    // First the number, which must not get into what stands in scripts.
    let script = painter() + &SCRIPTS.concat();
    DOCUMENT.replace(NONCE_MARK, nonce).replace(STYLE_MARK, STYLE).replace(SCRIPT_MARK, &script)
}

/// What paints, with the scales of arrows.
fn painter() -> String {
    SCALE_MARKS
        .iter()
        .fold(PAINTER.concat(), |script, (mark, scale)| script.replace(mark, &scale.to_string()))
}

/// What paints, as a module.
pub(crate) fn painter_module() -> String {
    painter() + PAINTER_EXPORTS
}

/// The policy that allows the page its own style and script, its own server, and nothing else.
pub(crate) fn policy(nonce: &str) -> String {
    format!(
        "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'nonce-{nonce}'; connect-src 'self'; img-src data:; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_one_document_that_asks_for_nothing() {
        let page = page("abc");
        assert!(page.contains("FORCE_SCALE = 0.005, LEAD_SCALE = 5,"));
        assert!(!page.contains(STYLE_MARK) && !page.contains(SCRIPT_MARK) && !page.contains(NONCE_MARK));
        for sign in ["http://", "https://", "src=", "@import", "url("] {
            let found = page.match_indices(sign).map(|(place, _)| &page[place..(place + 60).min(page.len())]);
            let foreign: Vec<_> = found.filter(|text| !text.starts_with("http://www.w3.org/")).collect();
            assert!(foreign.is_empty(), "{foreign:?}");
        }
        assert_eq!(page.matches("nonce=\"abc\"").count(), 2);
    }
}
