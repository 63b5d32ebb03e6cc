use crate::SoilError;
use crate::error::check;

/// Width of a plate over its vertical depth, `w / H`; infinite in plane strain, where a plate has no ends.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct WidthRatio(f64);

impl WidthRatio {
    /// A plate without ends.
    pub const PLANE_STRAIN: Self = Self(f64::INFINITY);

    /// The ratio `w / H`, above 0; infinity is plane strain.
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if it is not above 0.
    pub fn new(ratio: f64) -> Result<Self, SoilError> {
        if ratio == f64::INFINITY {
            return Ok(Self::PLANE_STRAIN);
        }
        check("width over depth", ratio, "", "above 0", |r| r > 0.0)?;
        Ok(Self(ratio))
    }

    /// `w / H`; `None` in plane strain.
    #[must_use]
    pub fn finite(self) -> Option<f64> {
        self.0.is_finite().then_some(self.0)
    }

    /// `H / w`, to which what the ends add is proportional; 0 in plane strain.
    #[must_use]
    pub fn depth_over_width(self) -> f64 {
        1.0 / self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plane_strain_is_the_limit_of_wide_plates() {
        assert_eq!(WidthRatio::PLANE_STRAIN.depth_over_width(), 0.0);
        assert_eq!(WidthRatio::PLANE_STRAIN.finite(), None);
        assert_eq!(WidthRatio::new(f64::INFINITY).unwrap(), WidthRatio::PLANE_STRAIN);
        assert_eq!(WidthRatio::new(5.0).unwrap().depth_over_width(), 0.2);
        for ratio in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
            assert!(WidthRatio::new(ratio).is_err());
        }
    }
}
