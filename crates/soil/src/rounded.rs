use std::fmt;

/// A number as messages show it: six decimals at most, trailing zeros dropped, so that 30 degrees that went through
/// radians read `30` and not `29.999999999999996`. Errors keep the exact value.
///
/// Numbers too small for six decimals, and those too long to be read, are written with six digits and an exponent.
///
/// ```
/// use soilctl_soil::Rounded;
///
/// assert_eq!(format!("{} deg", Rounded(29.999_999_999_999_996)), "30 deg");
/// assert_eq!(Rounded(0.025).to_string(), "0.025");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounded(pub f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let text = if !size.is_finite() || size == 0.0 {
            self.0.to_string()
        } else if (1e-4..1e15).contains(&size) {
            trimmed(&format!("{:.6}", self.0)).to_owned()
        } else {
            let text = format!("{:.5e}", self.0);
            match text.split_once('e') {
                Some((digits, power)) => format!("{}e{power}", trimmed(digits)),
                None => text,
            }
        };
        f.pad(&text)
    }
}

/// Drops the zeros that end a decimal fraction, and the point with the last digit.
fn trimmed(text: &str) -> &str {
    text.trim_end_matches('0').trim_end_matches('.')
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn noise_goes_and_digits_stay() {
        let shown = [
            (29.999_999_999_999_996, "30"),
            (-90.000_000_000_000_01, "-90"),
            (0.0, "0"),
            (100.0, "100"),
            (1_234.567_89, "1234.56789"),
            (0.000_5, "0.0005"),
            (1.5e-7, "1.5e-7"),
            (-2e300, "-2e300"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ];
        for (value, text) in shown {
            assert_eq!(Rounded(value).to_string(), text);
        }
        assert_eq!(format!("[{:>5}]", Rounded(2.5)), "[  2.5]");
    }

    proptest! {
        #[test]
        fn what_is_shown_is_the_value(value in prop_oneof![-1e20..1e20_f64, -1e3..1e3_f64, -1e-3..1e-3_f64]) {
            let back: f64 = Rounded(value).to_string().parse().unwrap();
            prop_assert!((back - value).abs() <= 0.5e-6f64.max(5.1e-6 * value.abs()));
        }
    }
}
