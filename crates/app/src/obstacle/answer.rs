//! What is said of a buried body.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_columns::{Cell, Kind};

use super::BodyKind;
use crate::files::save_table;
use crate::tool::ToolAnswer;
use crate::{AppError, Outcome};

/// The force at one distance.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DistanceAnswer {
    /// Distance from the tool's tip to the body along the surface (m).
    pub ahead_m: f64,
    /// Lower bound on the force along the motion, per metre of width (N/m); null if there is none.
    pub lower_n_per_m: Option<f64>,
    /// Upper bound on it; null likewise.
    pub upper_n_per_m: Option<f64>,
    /// Lower bound on the force over that without the body; null likewise.
    pub ratio_lower: Option<f64>,
    /// Upper bound on that ratio; null likewise.
    pub ratio_upper: Option<f64>,
    /// `(U - L) / ((U + L) / 2)` of the forces; null without both.
    pub gap: Option<f64>,
    /// Whether the lower bound is that without the body, which holds here too, as no field found here proves more.
    pub lower_is_without: bool,
    /// Why bounds are missing; null if they are not.
    pub problem: Option<String>,
}

/// Whether the force says that something is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// At some of the distances it is proven to be more than the scatter above the force without the body.
    Shows,
    /// At none of them.
    Hidden,
    /// The bounds are too wide to tell.
    Open,
}

/// Proven bounds on the force of a tool near a buried body, over the distance.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Whether the force says that something is there.
    pub answer: Verdict,
    /// Lower bound on the force without the body, along the motion, per metre of width (N/m).
    pub without_lower_n_per_m: f64,
    /// Upper bound on it (N/m).
    pub without_upper_n_per_m: f64,
    /// The same at each distance, near to far.
    pub distances: Vec<DistanceAnswer>,
    /// Greatest distance looked at up to which the force is proven to be more than the scatter above that without the body; null if there is none.
    pub shows_to_m: Option<f64>,
    /// Least distance looked at from which on it is proven to be no more than that; null likewise.
    pub hidden_from_m: Option<f64>,
    /// Relative scatter of measured forces.
    pub scatter: f64,
    /// What the body does.
    pub body: BodyKind,
    /// Depth of its top below the surface.
    pub body_top_m: f64,
    /// Its height.
    pub body_height_m: f64,
    /// Its length along the motion.
    pub body_length_m: f64,
    /// Cohesion of a stone, whose friction angle is that of the soil: the bounds are those of a stone of this strength, which is far above
    /// that of the soil; null for bodies that do not move.
    pub stone_cohesion_pa: Option<f64>,
    /// The tool.
    pub tool: ToolAnswer,
    /// Direction of the motion, from the horizontal.
    pub direction_deg: f64,
    /// Whether all bounds that are told are proven with interval arithmetic.
    pub certified: bool,
    /// The answer in words.
    pub verdict: String,
    /// Values that are possible but unusual, and what else is to be kept in mind.
    pub notes: Vec<String>,
    /// Work spent in element steps.
    pub work: u64,
    /// Time spent in s.
    pub seconds: f64,
    /// The gap asked for.
    #[serde(skip)]
    pub max_gap: f64,
    /// The gap of the force without the body.
    #[serde(skip)]
    pub without_gap: Option<f64>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.obstacle/1";

    fn outcome(&self) -> Outcome {
        let is_close = |gap: Option<f64>| gap.is_some_and(|gap| gap <= self.max_gap);
        let all = self.distances.iter().all(|one| is_close(one.gap));
        if all && is_close(self.without_gap) { Outcome::Done } else { Outcome::Partial }
    }
}

impl Answer {
    /// What the distances say together.
    pub(super) fn conclude(&mut self) {
        let most = 1.0 + self.scatter;
        let shows = |one: &&DistanceAnswer| one.ratio_lower.is_some_and(|ratio| ratio > most);
        let hides = |one: &&DistanceAnswer| one.ratio_upper.is_some_and(|ratio| ratio <= most);
        let ahead = |one: &DistanceAnswer| one.ahead_m;
        self.shows_to_m = self.distances.iter().take_while(shows).last().map(ahead);
        self.hidden_from_m = self.distances.iter().rev().take_while(hides).last().map(ahead);
        let any = self.distances.iter().any(|one| shows(&one));
        self.answer = match (any, self.distances.iter().all(|one| hides(&one))) {
            (true, _) => Verdict::Shows,
            (false, true) => Verdict::Hidden,
            (false, false) => Verdict::Open,
        };
        self.verdict = self.words();
    }

    fn words(&self) -> String {
        let percent = crate::text::number(100.0 * self.scatter);
        let m = crate::text::number;
        let ends = self.distances.first().zip(self.distances.last());
        let looked =
            ends.map_or_else(String::new, |(a, b)| format!("{} to {} m", m(a.ahead_m), m(b.ahead_m)));
        match (self.shows_to_m, self.hidden_from_m) {
            (Some(near), Some(far)) => format!(
                "The force is proven to be more than {percent} % above that without the body at distances up to {} m, and not from {} m on, of \
                 those looked at ({looked}).",
                m(near),
                m(far)
            ),
            (Some(near), None) => format!(
                "The force is proven to be more than {percent} % above that without the body at distances up to {} m, of those looked at \
                 ({looked}); from where on it is not, the bounds leave open.",
                m(near)
            ),
            (None, Some(far)) if self.answer == Verdict::Hidden => format!(
                "The force says nothing: at no distance looked at ({looked}) is it more than {percent} % above that without the body; that it is not \
                 from {} m on is proven.",
                m(far)
            ),
            (None, Some(far)) => format!(
                "From {} m on, of the distances looked at ({looked}), the force is proven to be no more than {percent} % above that without the \
                 body; nearer by the bounds leave open up to which distance it is more.",
                m(far)
            ),
            (None, None) => format!(
                "At the distances looked at ({looked}) the bounds leave open up to where the force is more than {percent} % above that without the body."
            ),
        }
    }

    /// Writes the table over the distance.
    pub(super) fn write_table(&self, path: &Path) -> Result<(), AppError> {
        let known = |x: Option<f64>| x.map_or(Cell::Missing, Cell::Float);
        let row = |one: &DistanceAnswer| {
            [
                Cell::Float(one.ahead_m),
                known(one.lower_n_per_m),
                known(one.upper_n_per_m),
                known(one.ratio_lower),
                known(one.ratio_upper),
                known(one.gap),
            ]
        };
        save_table(path, "obstacle", COLUMNS, self.distances.iter().map(row))
    }
}

const COLUMNS: [(&str, Kind); 6] = [
    ("ahead_m", Kind::Decimal),
    ("lower_n_per_m", Kind::OptionalFloat),
    ("upper_n_per_m", Kind::OptionalFloat),
    ("ratio_lower", Kind::OptionalFloat),
    ("ratio_upper", Kind::OptionalFloat),
    ("gap", Kind::OptionalFloat),
];
