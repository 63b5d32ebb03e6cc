//! What the checks of files have in common.

use crate::PlantError;

/// Stops at the first broken rule, naming the key.
pub(crate) struct Rules<'a> {
    pub(crate) file: &'a str,
}

pub(crate) type Checked = Result<(), PlantError>;

impl Rules<'_> {
    pub(crate) fn check(
        &self,
        key: &str,
        value: f64,
        unit: &'static str,
        ok: bool,
        allowed: String,
    ) -> Checked {
        if value.is_finite() && ok {
            return Ok(());
        }
        Err(PlantError::Config { file: self.file.to_owned(), key: key.to_owned(), value, unit, allowed })
    }

    /// `least <= value <= most`.
    pub(crate) fn range(&self, key: &str, value: f64, unit: &'static str, least: f64, most: f64) -> Checked {
        let allowed = format!("from {least} to {most} {unit}").trim_end().to_owned();
        self.check(key, value, unit, value >= least && value <= most, allowed)
    }

    /// `0 < value <= most`.
    pub(crate) fn positive(&self, key: &str, value: f64, unit: &'static str, most: f64) -> Checked {
        let allowed = format!("above 0 and at most {most} {unit}").trim_end().to_owned();
        self.check(key, value, unit, value > 0.0 && value <= most, allowed)
    }

    /// All of a list between `least` and `most`.
    pub(crate) fn each(
        &self,
        key: &str,
        values: &[f64],
        unit: &'static str,
        least: f64,
        most: f64,
    ) -> Checked {
        values
            .iter()
            .enumerate()
            .try_for_each(|(i, &value)| self.range(&format!("{key}[{i}]"), value, unit, least, most))
    }

    /// All of a list above 0 and at most `most`.
    pub(crate) fn each_positive(&self, key: &str, values: &[f64], unit: &'static str, most: f64) -> Checked {
        values
            .iter()
            .enumerate()
            .try_for_each(|(i, &value)| self.positive(&format!("{key}[{i}]"), value, unit, most))
    }
}
