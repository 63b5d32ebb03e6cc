//! The page about the log.

use std::collections::BTreeMap;

type Record = BTreeMap<String, String>;

/// Columns of the table of strokes: key and heading.
const COLUMNS: [(&str, &str); 8] = [
    ("number", "stroke"),
    ("start_s", "from (s)"),
    ("end_s", "to (s)"),
    ("finish", "finish"),
    ("alpha_deg", "tool angle (deg)"),
    ("depth_m", "depth (m)"),
    ("radius_m", "radius (m)"),
    ("base_deg", "base (deg)"),
];

/// Markdown: what made the log, its strokes, and what is wrong with it.
pub(crate) fn about(name: &str, session: &Record, strokes: &[Record], damage: &[String]) -> String {
    let mut text = format!("# {name}\n\n");
    for (key, value) in session {
        text += &format!("- {}: {value}\n", key.replace('_', " "));
    }
    text += "\nArrows: 5 mm a newton, the lead five times its size. The force sensor's arrow has its bias in it; \
             the controller's and the truth's have not.\n";
    for line in damage {
        text += &format!("\n**Damaged:** {line}\n");
    }
    if !strokes.is_empty() {
        let headings: Vec<&str> = COLUMNS.iter().map(|(_, heading)| *heading).collect();
        text += &format!("\n| {} |\n|{}\n", headings.join(" | "), "---|".repeat(COLUMNS.len()));
    }
    for stroke in strokes {
        let cells = COLUMNS.map(|(key, _)| stroke.get(key).map_or("", String::as_str));
        text += &format!("| {} |\n", cells.join(" | "));
    }
    text
}
