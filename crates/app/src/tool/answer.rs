//! What bounds on a tool's force are.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::{Ended, Factorisation, StoppedBy};

use super::ends::{Above, EndsAnswer};
use super::forces::{DirectionAnswer, ForcesAnswer};
use super::ground::Placed;
use super::request::Setting;
use super::shape::Piece;
use super::table::TableAnswer;
use crate::limits::{LevelAnswer, ResultsAnswer};
use crate::solve::Solved;
use crate::text::number;
use crate::{AppError, Outcome, plausible};

/// A straight piece of the tool, in the ground.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct PieceAnswer {
    /// Its end towards the tip: along the surface, ahead of where the tool goes through it, and across, upwards (m).
    pub from_m: [f64; 2],
    /// Its other end.
    pub to_m: [f64; 2],
    /// Its tool angle from the horizontal.
    pub alpha_deg: f64,
    /// Friction angle between soil and piece.
    pub delta_deg: f64,
    /// Adhesion between them.
    pub adhesion_pa: f64,
}

/// The tool in its place.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ToolAnswer {
    /// What it is; null if the file does not say.
    pub title: Option<String>,
    /// What of it is in the ground, from the tip.
    pub pieces: Vec<PieceAnswer>,
    /// Tool angle of the straight line from the tip to where the tool goes through the surface, or to the top of a buried tool.
    pub chord_alpha_deg: f64,
    /// Length of that line.
    pub chord_m: f64,
    /// Depth of the lowest point below the surface, at right angles to it.
    pub depth_m: f64,
    /// Depth of the highest point likewise; zero unless the tool is buried.
    pub cover_m: f64,
    /// How far the straight pieces are from the arc that they stand for at most.
    pub off_arc_m: f64,
}

/// Proven bounds on the net force of a tool, in plane strain or, with a width, with ends.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Lower bound on the force of the tool on the soil along its motion, per metre of width (N/m): of a tool without ends, or of one with the width of `ends`.
    pub lower_n_per_m: f64,
    /// Upper bound on it (N/m).
    pub upper_n_per_m: f64,
    /// `|(U - L) / ((U + L) / 2)|`; null if the bounds are on both sides of zero.
    pub gap: Option<f64>,
    /// Lower bound on the coefficient of that force, `2 F / (gamma L^2)`, with the length of the chord for L.
    pub coefficient_lower: f64,
    /// Upper bound on it.
    pub coefficient_upper: f64,
    /// Of a flat tool with one interface that moves horizontally: lower bound on the coefficient that `bound` answers, of the force inclined at delta
    /// to the normal; null for others, whose direction of force is not known.
    pub slant_lower: Option<f64>,
    /// Upper bound on it; null likewise.
    pub slant_upper: Option<f64>,
    /// What is proven of the whole tool with its ends; null without --width.
    pub ends: Option<EndsAnswer>,
    /// Forces that the soil bears, in all directions; null without --forces.
    pub forces: Option<ForcesAnswer>,
    /// Bounds over friction angles; null without --table.
    pub table: Option<TableAnswer>,
    /// Direction of the motion, from the horizontal.
    pub direction_deg: f64,
    /// The tool.
    pub tool: ToolAnswer,
    /// Whether both bounds are proven with interval arithmetic.
    pub certified: bool,
    /// Triangles of the mesh of the lower bound; each has three parts.
    pub lower_elements: usize,
    /// Triangles of the mesh of the upper bound.
    pub upper_elements: usize,
    /// What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does not.
    pub lower_factorisation: Factorisation,
    /// The same of the upper bound.
    pub upper_factorisation: Factorisation,
    /// Work spent in element steps: elements of meshes times steps of the solver on them.
    pub work: u64,
    /// Time spent in s.
    pub seconds: f64,
    /// Why the run ended.
    pub ended: Ended,
    /// What kind of limit that is. Only after `seconds` and `user` the same command may end elsewhere another time.
    pub stopped_by: StoppedBy,
    /// All levels, coarse to fine, in kN/m.
    pub levels: Vec<LevelAnswer>,
    /// What the fields behind the bounds show, along and across the surface.
    pub results: ResultsAnswer,
    /// Values that are possible but unusual, and what else is to be kept in mind.
    pub notes: Vec<String>,
    /// The gap asked for.
    #[serde(skip)]
    pub max_gap: f64,
}

/// Outwards by a few roundings.
pub(super) fn times([lower, upper]: [f64; 2], factor: f64) -> [f64; 2] {
    let slack = 8.0 * f64::EPSILON;
    let [l, u] = [lower * factor, upper * factor];
    [l - slack * l.abs(), u + slack * u.abs()]
}

impl Answer {
    pub(super) fn new(
        setting: &Setting,
        placed: &Placed,
        solved: &Solved,
        ends: Option<(Above, f64)>,
        notes: Vec<String>,
    ) -> Result<Self, AppError> {
        let answer = &solved.answer;
        let tool = ToolAnswer::new(placed, setting);
        let plane = times([answer.lower, answer.upper], 1e3);
        let ends = ends.map(|(above, width_m)| {
            EndsAnswer::new(&above, width_m, placed.file.has_side_plates(), plane, answer.gap)
        });
        let [lower, upper] = ends.map_or(plane, |ends| ends.per_metre());
        let unit = 0.5 * 1e3 * placed.unit_weight_kn_m3 * tool.chord_m.powi(2);
        let coefficient = times([lower, upper], 1.0 / unit);
        let shape = &placed.shape;
        let sum = (tool.chord_alpha_deg + shape.pieces().first().map_or(0.0, |piece| piece.delta_deg))
            .to_radians()
            .sin();
        let is_plate = shape.is_flat() && setting.direction_deg == 0.0 && tool.cover_m == 0.0 && sum > 0.0;
        let slant = is_plate.then(|| times(coefficient, 1.0 / sum));
        Ok(Self {
            lower_n_per_m: lower,
            upper_n_per_m: upper,
            gap: ends.map_or(answer.gap, |ends| ends.gap()),
            coefficient_lower: coefficient[0],
            coefficient_upper: coefficient[1],
            slant_lower: slant.map(|s| s[0]),
            slant_upper: slant.map(|s| s[1]),
            ends,
            forces: None,
            table: None,
            direction_deg: setting.direction_deg,
            tool,
            certified: answer.certified,
            lower_elements: answer.lower_elements,
            upper_elements: answer.upper_elements,
            lower_factorisation: answer.lower_factorisation,
            upper_factorisation: answer.upper_factorisation,
            work: answer.work,
            seconds: answer.seconds,
            ended: answer.ended,
            stopped_by: answer.stopped_by,
            levels: answer.levels.clone(),
            results: ResultsAnswer::new(&solved.fields)?,
            notes,
            max_gap: answer.max_gap,
        })
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.tool/1";

    fn outcome(&self) -> Outcome {
        // No budget makes ends tighter.
        let gap = self.ends.map_or(self.gap, |ends| ends.plane_gap);
        let misses = |one: &DirectionAnswer| one.force_n_per_m.is_none() || one.upper_n_per_m.is_none();
        if self.forces.as_ref().is_some_and(|forces| forces.directions.iter().any(misses)) {
            return Outcome::Partial;
        }
        if self.table.as_ref().is_some_and(|table| table.rows.iter().any(|row| row.problem.is_some())) {
            return Outcome::Partial;
        }
        if gap.is_some_and(|gap| gap <= self.max_gap) { Outcome::Done } else { Outcome::Partial }
    }
}

impl ToolAnswer {
    /// The tool of a setting in its place.
    pub(crate) fn new(placed: &Placed, setting: &Setting) -> Self {
        let shape = &placed.shape;
        let beta = setting.loads.beta_deg;
        let piece = |piece: &Piece| PieceAnswer {
            from_m: piece.ends[0],
            to_m: piece.ends[1],
            // Against the surface it is more by the slope.
            alpha_deg: piece.alpha_deg() - beta,
            delta_deg: piece.delta_deg,
            adhesion_pa: piece.adhesion_pa,
        };
        let heights = || shape.points().map(|p| p[1]);
        Self {
            title: placed.file.title.clone(),
            pieces: shape.pieces().iter().map(piece).collect(),
            chord_alpha_deg: shape.chord_alpha_deg() - beta,
            chord_m: shape.chord_m(),
            depth_m: -heights().fold(0.0, f64::min),
            cover_m: (-heights().fold(f64::NEG_INFINITY, f64::max)).max(0.0),
            off_arc_m: shape.off_arc_m,
        }
    }
}

/// What hardly anybody means, and what bounds are not about.
pub(crate) fn notes(setting: &Setting, placed: &Placed, has_ends: bool) -> Vec<String> {
    let mut notes = plausible::of_tool(setting);
    if placed.file.has_side_plates() && !has_ends {
        notes.push(
            "side plates are left out: bounds are per metre of a tool so wide that its ends do not count; `soilctl tool` with --width has them".into(),
        );
    }
    let off = placed.shape.off_arc_m;
    if off > 1e-3 * placed.shape.chord_m() {
        notes.push(format!(
            "the arc is {} straight pieces, up to {} mm away from it; bounds hold for these, and more `pieces` in the tool file are closer",
            placed.file.arc.as_ref().map_or(0, |arc| arc.pieces),
            number(1e3 * off)
        ));
    }
    notes
}
