//! Numbers and columns for people.

use soilctl_soil::units::pa_to_psi;

/// A number with six significant digits, without trailing zeros.
#[must_use]
pub fn number(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value);
    // Never "-0".
    let rounded = rounded + 0.0;
    let size = f64::abs(rounded);
    if size != 0.0 && !(1e-4..1e7).contains(&size) { format!("{rounded:e}") } else { rounded.to_string() }
}

/// A positive value rounded to its second digit.
#[must_use]
pub fn to_two_digits(value: f64) -> f64 {
    let step = libm::pow(10.0, libm::log10(value).floor() - 1.0);
    (value / step).round() * step
}

/// A value with its standard deviation: both to the second digit of this. The unit `1` is left out.
#[must_use]
pub fn measured(value: f64, sd: f64, unit: &str) -> String {
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    let places = 1.0 - sd.log10().floor();
    if !(-8.0..=8.0).contains(&places) {
        return format!("{} ± {}{unit}", number(value), number(sd));
    }
    let (step, decimals) = (10.0_f64.powf(-places), places.max(0.0) as usize);
    let rounded = |x: f64| format!("{:.decimals$}", (x / step).round() * step);
    format!("{} ± {}{unit}", rounded(value), rounded(sd))
}

/// Four significant digits that are not above the number: a lower bound still holds.
#[must_use]
pub fn rounded_down(value: f64) -> String {
    towards(value, -1.0)
}

/// Four significant digits that are not below the number: an upper bound still holds.
#[must_use]
pub fn rounded_up(value: f64) -> String {
    towards(value, 1.0)
}

fn towards(value: f64, sign: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if sign * (rounded - value) >= 0.0 || value == 0.0 {
        return number(rounded);
    }
    // The next number of four digits on that side.
    let step = 10.0_f64.powf(value.abs().log10().floor() - 3.0);
    let next: f64 = format!("{:.3e}", rounded + sign * step).parse().unwrap_or(value);
    number(next)
}

/// Name of the unit of a force for each unit of width, of those of stress and length.
#[must_use]
pub fn line_force_unit(stress: &str, length: &str) -> String {
    match (stress, length) {
        ("kPa", "m") => "kN/m".to_owned(),
        (stress, length) => format!("{stress}·{length}"),
    }
}

/// The unit of a bending moment per width, from those of stresses and lengths.
#[must_use]
pub fn moment_unit(stress: &str, length: &str) -> String {
    match (stress, length) {
        ("kPa", "m") => "kNm/m".to_owned(),
        (stress, length) => format!("{stress}·{length}²"),
    }
}

/// A number, or a dash where there is none.
#[must_use]
pub fn number_or_dash(value: Option<f64>) -> String {
    value.map_or_else(|| "-".into(), number)
}

/// A range, or a dash where there is none.
#[must_use]
pub fn range(value: Option<[f64; 2]>, digits: usize) -> String {
    value.map_or_else(|| "-".into(), |[low, high]| format!("{low:.digits$} to {high:.digits$}"))
}

/// Yes or no.
#[must_use]
pub const fn yes(value: bool) -> &'static str {
    if value { "yes" } else { "no" }
}

/// With a capital letter at the beginning.
#[must_use]
pub fn sentence_case(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Rows with their columns aligned to the right, two spaces apart.
#[must_use]
pub fn columns(rows: &[Vec<String>]) -> String {
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

/// A stress (Pa) in psi and in kPa.
#[must_use]
pub fn stress(pa: f64) -> String {
    format!("{} psi ({} kPa)", four_digits(pa_to_psi(pa)), four_digits(pa / 1000.0))
}

/// A number of four significant digits.
#[must_use]
pub fn four_digits(value: f64) -> String {
    number_or_dash(format!("{value:.3e}").parse().ok())
}

/// A time for people.
#[must_use]
pub fn duration(seconds: f64) -> String {
    let unit = |size: f64, name: &str| format!("about {:.1} {name}", seconds / size);
    match seconds {
        s if s < 90.0 => format!("about {seconds:.0} s"),
        s if s < 5400.0 => unit(60.0, "min"),
        s if s < 172_800.0 => unit(3600.0, "h"),
        _ => unit(86_400.0, "days"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_bounds_still_hold() {
        for value in
            [1.23456, 12.3456, 0.000_123_456, 99.999, 1e5 + 0.1, -3.21987, 8.0 / 3.0, -0.099_999, 4.0]
        {
            let (down, up): (f64, f64) =
                (rounded_down(value).parse().unwrap(), rounded_up(value).parse().unwrap());
            assert!(down <= value && value <= up, "{value}: {down} {up}");
            assert!(up - down <= 2e-3 * value.abs(), "{value}: {down} {up}");
        }
        assert_eq!((rounded_down(4.0), rounded_up(4.0)), ("4".into(), "4".into()));
    }

    #[test]
    fn numbers_keep_six_digits_at_any_size() {
        assert_eq!([number(-0.0), number(0.0)], ["0", "0"]);
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
    fn values_have_the_digits_that_their_deviation_allows() {
        for (value, sd, unit, text) in [
            (0.146_529, 0.033_081, "1", "0.147 ± 0.033"),
            (-4.2, 1.26, "deg", "-4.2 ± 1.3 deg"),
            (1603.7, 48.2, "Pa", "1604 ± 48 Pa"),
            (16_037.0, 4_820.0, "Pa", "16000 ± 4800 Pa"),
            (5.5e-4, 7.1e-5, "m/N", "0.000550 ± 0.000071 m/N"),
            (2.0, 0.0, "1", "2 ± 0"),
            (2.0, f64::NAN, "1", "2 ± NaN"),
        ] {
            assert_eq!(measured(value, sd, unit), text);
        }
    }

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let rows = [vec!["a".into(), "bb".into()], vec!["100".into(), "2".into()]];
        assert_eq!(columns(&rows), "  a  bb\n100   2\n");
    }

    #[test]
    fn times_read_well() {
        for (seconds, words) in [
            (0.0, "about 0 s"),
            (89.4, "about 89 s"),
            (600.0, "about 10.0 min"),
            (9000.0, "about 2.5 h"),
            (1e6, "about 11.6 days"),
        ] {
            assert_eq!(duration(seconds), words);
        }
    }
}
