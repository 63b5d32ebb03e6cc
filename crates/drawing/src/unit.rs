//! Units of length.

use std::str::FromStr;

/// The unit of a drawing's coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Decimetres.
    Decimetre,
    /// Metres.
    Metre,
    /// Kilometres.
    Kilometre,
    /// Inches of 25.4 mm.
    Inch,
    /// Feet of 304.8 mm.
    Foot,
}

impl Unit {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Millimetre,
        Self::Centimetre,
        Self::Decimetre,
        Self::Metre,
        Self::Kilometre,
        Self::Inch,
        Self::Foot,
    ];

    /// Its length in metres.
    #[must_use]
    pub const fn metres(self) -> f64 {
        match self {
            Self::Millimetre => 1e-3,
            Self::Centimetre => 1e-2,
            Self::Decimetre => 0.1,
            Self::Metre => 1.0,
            Self::Kilometre => 1e3,
            Self::Inch => 0.0254,
            Self::Foot => 0.3048,
        }
    }

    /// Its symbol.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Decimetre => "dm",
            Self::Metre => "m",
            Self::Kilometre => "km",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// The number of `$INSUNITS` in DXF.
    pub(crate) const fn of_dxf(self) -> u16 {
        match self {
            Self::Inch => 1,
            Self::Foot => 2,
            Self::Millimetre => 4,
            Self::Centimetre => 5,
            Self::Metre => 6,
            Self::Kilometre => 7,
            Self::Decimetre => 14,
        }
    }
}

impl FromStr for Unit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let symbols = Self::ALL.map(Self::symbol).join(", ");
        let found = Self::ALL.into_iter().find(|unit| unit.symbol() == text);
        found.ok_or_else(|| format!("{text} is no unit; it must be one of {symbols}"))
    }
}
