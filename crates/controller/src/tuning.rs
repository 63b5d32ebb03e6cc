use serde::{Deserialize, Serialize};

use crate::config::StrokeLaw;

/// Values that may be changed during a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tuning {
    /// Speed of moves as a fraction of the settings'.
    pub speed_scale: f64,
    /// `l_rate` in m/s.
    pub lead_rate_m_s: f64,
    /// Whether insertion accommodates.
    pub accommodate: bool,
    /// Law of strokes in sequences.
    pub law: StrokeLaw,
}
