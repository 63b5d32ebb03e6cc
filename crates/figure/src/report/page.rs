//! The page around the parts of a report.

use super::{Block, HtmlReport};
use crate::{escape, interactive};

const STYLE: &str = include_str!("style.css");
/// Light and dark, and files of figures.
const PAGE_SCRIPT: &str = include_str!("page.js");
const PLOT_SCRIPT: &str = include_str!("figures.js");
const MOTION_SCRIPT: &str = include_str!("motion.js");

/// Allows what is inside of the page and forbids every load from elsewhere.
const POLICY: &str =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

/// From so many sections on a page has contents.
const SECTIONS: usize = 3;

pub(crate) fn render(report: &HtmlReport) -> String {
    let title = escape::html(&report.title);
    let tab = report.kind.as_ref().map_or_else(String::new, |kind| format!("{}: ", escape::html(kind)));
    let kind = paragraph("kind", report.kind.as_deref());
    let subtitle = paragraph("subtitle", report.subtitle.as_deref());
    let verdict = report.verdict.as_ref().map_or_else(String::new, |v| v.to_html("callout verdict"));
    // The library of interactive plots is larger than all that a browser's module should be.
    let still = report.still || cfg!(target_family = "wasm");
    let body: String = report.blocks.iter().map(|block| block.to_html(still)).collect();
    let drawn = |plot: bool| {
        !still && report.blocks.iter().any(|b| matches!(b, Block::Figure(d) if d.is_plot() == plot))
    };
    let library = if drawn(true) { library() } else { String::new() };
    let scripts = [(true, PAGE_SCRIPT), (drawn(true), PLOT_SCRIPT), (drawn(false), MOTION_SCRIPT)];
    let script: String = scripts.iter().filter(|(wanted, _)| *wanted).map(|(_, script)| *script).collect();
    let script = script.replacen("[SHADES]", &interactive::shades().to_string(), 1);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{tab}{title}</title>\n<style>\n{STYLE}</style>\n{library}</head>\n<body>\n<main>\n\
         <header>{kind}<h1>{title}</h1>\n{subtitle}{verdict}</header>\n{contents}{body}</main>\n{foot}\
         <script>\n{script}</script>\n</body>\n</html>\n",
        contents = contents(report),
        foot = foot(report),
    )
}

/// Links to all sections.
fn contents(report: &HtmlReport) -> String {
    let link = |block: &Block| match block {
        Block::Section { number, text } => {
            Some(format!("<li><a href=\"#section-{number}\">{}</a></li>\n", escape::html(text)))
        }
        _ => None,
    };
    let links: Vec<String> = report.blocks.iter().filter_map(link).collect();
    if links.len() < SECTIONS {
        return String::new();
    }
    format!("<nav class=\"contents\" aria-label=\"Contents\">\n<ol>\n{}</ol>\n</nav>\n", links.concat())
}

/// What made the report.
fn foot(report: &HtmlReport) -> String {
    let command =
        report.command.as_ref().map(|line| format!("<p>Made by <code>{}</code></p>\n", escape::html(line)));
    match (paragraph("made", report.footer.as_deref()), command.unwrap_or_default()) {
        (made, command) if made.is_empty() && command.is_empty() => String::new(),
        (made, command) => format!("<footer>\n{made}{command}</footer>\n"),
    }
}

fn paragraph(class: &str, text: Option<&str>) -> String {
    text.map_or_else(String::new, |text| format!("<p class=\"{class}\">{}</p>\n", escape::html(text)))
}

/// The script element of plotly.js alone. The source also holds a formula renderer, which would
/// fetch fonts; it follows after the first script element.
fn library() -> String {
    const END: &str = "</script>";
    let sources = plotly::Plot::offline_js_sources();
    sources.find(END).map_or_else(String::new, |end| format!("{}\n", &sources[..end + END.len()]))
}
