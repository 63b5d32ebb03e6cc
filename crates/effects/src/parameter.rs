/// Which signs an amplitude may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Physics allows one sign only.
    Positive,
    /// Either sign.
    Either,
}

/// Magnitudes that literature and experience make plausible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least plausible magnitude, above 0.
    pub low: f64,
    /// Greatest plausible magnitude.
    pub high: f64,
    /// Allowed signs.
    pub sign: Sign,
}

impl Range {
    /// Magnitudes from `low` to `high` of one sign.
    #[must_use]
    pub const fn positive(low: f64, high: f64) -> Self {
        Self { low, high, sign: Sign::Positive }
    }

    /// Magnitudes from `low` to `high` of either sign.
    #[must_use]
    pub const fn either(low: f64, high: f64) -> Self {
        Self { low, high, sign: Sign::Either }
    }

    /// The signs to try.
    #[must_use]
    pub fn signs(&self) -> &'static [f64] {
        match self.sign {
            Sign::Positive => &[1.0],
            Sign::Either => &[1.0, -1.0],
        }
    }

    /// Middle of the range in the logarithm.
    #[must_use]
    pub fn typical(&self) -> f64 {
        (self.low * self.high).sqrt()
    }

    /// Standard deviation of ln magnitude in the prior: a normal distribution in the logarithm that has nine tenths
    /// of its mass in the range, and never less than a factor of 1.3.
    #[must_use]
    pub fn ln_sd(&self) -> f64 {
        (libm::log(self.high / self.low) / (2.0 * 1.645)).max(0.26)
    }
}

/// A parameter as it is written into a model file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Its name, with the unit where there is one.
    pub name: &'static str,
    /// Its unit; `1` for a number without.
    pub unit: &'static str,
}

/// What the amplitude leaves open: a decay length, an azimuth, a choice of pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    /// The parameter in files; `None` if it is a detail that is averaged over and not reported.
    pub parameter: Option<Parameter>,
    /// The values that are tried, equally likely beforehand.
    pub values: &'static [f64],
}
