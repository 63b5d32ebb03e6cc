//! The page around the parts of a report.

use super::HtmlReport;
use crate::escape;

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("figures.js");

/// Allows what is inside of the page and forbids every load from elsewhere.
const POLICY: &str =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

pub(crate) fn render(report: &HtmlReport) -> String {
    let title = escape::html(&report.title);
    let subtitle = paragraph("subtitle", report.subtitle.as_deref());
    let footer = report
        .footer
        .as_deref()
        .map_or_else(String::new, |text| format!("<footer><p>{}</p></footer>\n", escape::html(text)));
    let body: String = report.blocks.iter().map(super::Block::to_html).collect();
    let has_figures = report.blocks.iter().any(|block| matches!(block, super::Block::Figure(_)));
    let library = if has_figures { library() } else { String::new() };
    let script = if has_figures { format!("<script>\n{SCRIPT}</script>\n") } else { String::new() };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n{library}</head>\n<body>\n<main>\n\
         <header><h1>{title}</h1>\n{subtitle}</header>\n{body}</main>\n{footer}{script}</body>\n</html>\n"
    )
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
