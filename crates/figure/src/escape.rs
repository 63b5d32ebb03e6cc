//! Making text from anywhere safe inside documents.

/// Text without control characters, which neither SVG nor HTML may contain.
pub(crate) fn printable(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\n' | '\r' | '\t' => ' ',
            // Besides the control characters, XML excludes these two code points.
            '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
            c if c.is_control() => '\u{fffd}',
            c => c,
        })
        .collect()
}

/// Text for element content and quoted attributes of HTML and XML.
pub(crate) fn html(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in printable(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// Text for plotly.js, which reads a subset of HTML in its labels and `%{...}` in its templates.
pub(crate) fn plotly(text: &str) -> String {
    let text = printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace("%{", "%&#123;")
}

/// JSON for a `<script>` element; the escapes keep the parser from seeing tags inside of strings.
pub(crate) fn script_json(value: &serde_json::Value) -> String {
    value.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

/// A `data:` address that holds `content`.
pub(crate) fn data_uri(media_type: &str, content: &str) -> String {
    let mut out = format!("data:{media_type};charset=utf-8,");
    for byte in content.bytes() {
        if byte.is_ascii_alphanumeric() || b"-_.~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_text_is_defused() {
        assert_eq!(html("<b a='1'>&\"\u{0}"), "&lt;b a=&#39;1&#39;&gt;&amp;&quot;\u{fffd}");
        assert_eq!(plotly("<a>%{x}"), "&lt;a&gt;%&#123;x}");
        let json = script_json(&serde_json::json!("</script><!--"));
        assert!(!json.contains('<'));
        assert_eq!(serde_json::from_str::<String>(&json).unwrap(), "</script><!--");
    }

    #[test]
    fn data_addresses_hold_any_text() {
        assert_eq!(data_uri("text/csv", "a,τ\n"), "data:text/csv;charset=utf-8,a%2C%CF%84%0A");
    }
}
