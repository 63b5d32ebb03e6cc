//! The HTML report.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{HOSTILE, everything};
use soilctl_figure::{Align, CalloutKind, HtmlReport, RichText, Size, Table};

fn report() -> HtmlReport {
    let mut report = HtmlReport::new(HOSTILE);
    let mut table = Table::new(HOSTILE, [(HOSTILE, Align::Left), ("n", Align::Right)]);
    table.row([HOSTILE, "1"]).unwrap();
    report
        .subtitle(HOSTILE)
        .heading(HOSTILE)
        .subheading(HOSTILE)
        .paragraph(RichText::new(HOSTILE).strong(HOSTILE).emphasis(HOSTILE).code(HOSTILE))
        .table(table)
        .callout(CalloutKind::Bad, HOSTILE, HOSTILE)
        .definitions([(HOSTILE, HOSTILE)])
        .footer(HOSTILE);
    report.figure(&everything().unwrap(), Size::default(), HOSTILE).unwrap();
    report.figure(&everything().unwrap(), Size::default(), "second").unwrap();
    report
}

/// The page without the text of the library.
fn own_part(html: &str) -> String {
    let start = html.find("<script type=\"text/javascript\">").unwrap();
    let end = start + html[start..].find("</script>").unwrap();
    format!("{}{}", &html[..start], &html[end..])
}

#[test]
fn the_library_is_embedded_once_and_alone() {
    let html = report().to_html();
    assert_eq!(html.matches("* plotly.js v").count(), 1);
    assert_eq!(html.matches("<script type=\"text/javascript\">").count(), 1);
    assert!(!own_part(&html).contains("mathjax") && own_part(&html).len() < 400_000);
    let plain = HtmlReport::new("no figures").to_html();
    assert!(plain.len() < 20_000);
}

#[test]
fn nothing_is_loaded_from_elsewhere() {
    let own = own_part(&report().to_html());
    assert!(own.contains("default-src 'none'"));
    for attribute in ["src=", "href=", "url(", "@import", "srcset="] {
        for (at, _) in own.match_indices(attribute) {
            let value = own[at + attribute.len()..].trim_start_matches(['"', '\'']);
            assert!(value.starts_with("data:") || value.starts_with('#'), "{attribute}{}", &value[..40]);
        }
    }
    assert_eq!(own.matches("http").count(), own.matches("http://www.w3.org/2000/svg").count() + 1);
}

#[test]
fn hostile_text_stays_text() {
    let own = own_part(&report().to_html());
    assert!(!own.contains("<script>alert") && !own.contains("\u{0}"));
    // The library's own element is cut out at its start; the data of two figures and the page
    // script remain.
    assert_eq!(own.matches("<script").count(), 3);
    assert_eq!(own.matches("<figure id=\"figure-").count(), 2);
}

#[test]
fn figures_are_complete() {
    let html = report().to_html();
    for part in ["id=\"plot-1\"", "id=\"plot-2\"", "download=\"figure-1.csv\"", "download=\"figure-2.csv\""] {
        assert_eq!(html.matches(part).count(), 1, "{part}");
    }
    assert_eq!(html.matches("<svg ").count() - own_svg_strings(&html), 2);
    let start = html.find("class=\"figure-data\">").unwrap() + "class=\"figure-data\">".len();
    let json = &html[start..start + html[start..].find("</script>").unwrap()];
    let parsed: serde_json::Value = serde_json::from_str(json).unwrap();
    let data = parsed["data"].as_array().unwrap();
    // One trace a layer, but for the map: one for each of its seven levels and one for the colour bar.
    assert_eq!(data.len(), 6 + 8);
    assert_eq!(parsed["layout"]["shapes"].as_array().unwrap().len(), 4);
    assert!(data.iter().all(|trace| trace["name"].as_str().is_some_and(|name| !name.contains('<'))));
    assert!(data[0]["hovertemplate"].as_str().unwrap().contains("x (mm): %{x"));
}

/// Occurrences inside of the library.
fn own_svg_strings(html: &str) -> usize {
    html.matches("<svg ").count() - own_part(html).matches("<svg ").count()
}

#[test]
fn equal_reports_are_equal_files() {
    assert!(report().to_html() == report().to_html());
}
