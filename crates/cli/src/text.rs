//! Numbers and columns for people.

/// A number with six significant digits, without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value);
    let size = f64::abs(rounded);
    if size != 0.0 && !(1e-4..1e7).contains(&size) { format!("{rounded:e}") } else { rounded.to_string() }
}

/// A number, or a dash where there is none.
pub(crate) fn number_or_dash(value: Option<f64>) -> String {
    value.map_or_else(|| "-".into(), number)
}

/// Rows with their columns aligned to the right, two spaces apart.
pub(crate) fn columns(rows: &[Vec<String>]) -> String {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows {
        for (i, cell) in row.iter().enumerate() {
            let width = cell.chars().count();
            match widths.get_mut(i) {
                Some(widest) => *widest = width.max(*widest),
                None => widths.push(width),
            }
        }
    }
    let mut text = String::new();
    for row in rows {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect();
        text += cells.join("  ").trim_end();
        text += "\n";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_six_digits_at_any_size() {
        for (value, text) in [
            (0.0, "0"),
            (7.835_949, "7.83595"),
            (1600.0, "1600"),
            (-4.0, "-4"),
            (1.234_567_8e-7, "1.23457e-7"),
            (9.999_999, "10"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let rows = [vec!["a".into(), "bb".into()], vec!["100".into(), "2".into()]];
        assert_eq!(columns(&rows), "  a  bb\n100   2\n");
    }
}
