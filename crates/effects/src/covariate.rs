use std::fmt;

use serde::{Deserialize, Serialize};
use soilctl_strokes::StrokeRow;

use crate::Reference;

/// A condition of a stroke that is recorded: what an effect, a residual or a follow-up may vary with.
///
/// In files it has the name of its column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(into = "&'static str", try_from = "String")]
pub enum Covariate {
    /// Tool angle, deg.
    ToolAngle,
    /// Vertical depth, m.
    Depth,
    /// Width of the plate, m.
    Width,
    /// Speed, m/s.
    Speed,
    /// Radius of the stroke about the base, m.
    Radius,
    /// Base angle, deg.
    BaseAngle,
    /// Distance to the nearest earlier stroke, m.
    PriorGap,
    /// Distance to the nearest wall, m.
    Wall,
    /// Set-point of the interface friction angle, deg.
    InterfaceSetPoint,
    /// Number of the stroke in its preparation.
    Order,
    /// Campaign clock, s.
    Time,
    /// Preparation, in the order in which they were made.
    Batch,
}

impl Covariate {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::ToolAngle,
        Self::Depth,
        Self::Width,
        Self::Speed,
        Self::Radius,
        Self::BaseAngle,
        Self::PriorGap,
        Self::Wall,
        Self::InterfaceSetPoint,
        Self::Order,
        Self::Time,
        Self::Batch,
    ];

    /// Name of the column in the stroke table.
    #[must_use]
    pub const fn column(self) -> &'static str {
        match self {
            Self::ToolAngle => "alpha_deg",
            Self::Depth => "depth_m",
            Self::Width => "width_m",
            Self::Speed => "speed_mps",
            Self::Radius => "radius_m",
            Self::BaseAngle => "base_deg",
            Self::PriorGap => "gap_prior_m",
            Self::Wall => "wall_m",
            Self::InterfaceSetPoint => "delta_set_deg",
            Self::Order => "order",
            Self::Time => "time_s",
            Self::Batch => "batch",
        }
    }

    /// The cell of a stroke; `None` if it is empty, and for a batch, which has a name and no number.
    #[must_use]
    pub fn of(self, row: &StrokeRow) -> Option<f64> {
        match self {
            Self::ToolAngle => Some(row.alpha_deg),
            Self::Depth => Some(row.depth_m),
            Self::Width => Some(row.width_m),
            Self::Speed => row.speed_mps,
            Self::Radius => row.radius_m,
            Self::BaseAngle => row.base_deg,
            Self::PriorGap => row.gap_prior_m,
            Self::Wall => row.wall_m,
            Self::InterfaceSetPoint => row.delta_set_deg,
            Self::Order => row.order.map(f64::from),
            Self::Time => row.time_s,
            Self::Batch => None,
        }
    }
}

impl Covariate {
    /// As [`Covariate::of`], but a batch has its place in the order of the reference, from 0; `None` if it is not there.
    #[must_use]
    pub fn recorded(self, row: &StrokeRow, reference: &Reference) -> Option<f64> {
        match self {
            Self::Batch => reference.place_of(row.batch.as_deref()?),
            of_row => of_row.of(row),
        }
    }
}

impl From<Covariate> for &'static str {
    fn from(covariate: Covariate) -> Self {
        covariate.column()
    }
}

impl TryFrom<String> for Covariate {
    type Error = String;

    fn try_from(name: String) -> Result<Self, Self::Error> {
        let columns = || Self::ALL.map(Self::column).join(", ");
        Self::ALL
            .into_iter()
            .find(|covariate| covariate.column() == name)
            .ok_or_else(|| format!("{name:?} is no condition of a stroke; they are {}", columns()))
    }
}

impl fmt::Display for Covariate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.column())
    }
}
