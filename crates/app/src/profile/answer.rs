//! What a profile says, as plain data.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Outcome;
use crate::request::Ends;

/// How ground may go with depth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// One soil.
    OneSoil,
    /// Friction angle and density go straight from those at the surface to those at the deepest stroke.
    Gradient,
    /// One soil above a level surface, another below.
    Step,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::OneSoil, Self::Gradient, Self::Step];

    /// Its name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OneSoil => "one soil",
            Self::Gradient => "gradient",
            Self::Step => "step",
        }
    }
}

/// What a measurement says of its force.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Stroke {
    /// Tool angle and depth.
    pub label: String,
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Depth (m).
    pub depth_m: f64,
    /// Strokes taken together in it.
    pub count: usize,
    /// Force (N).
    pub force_n: f64,
    /// Its band (N).
    pub band_n: [f64; 2],
    /// Density times coefficient (kg/m3), 2F/(g w L2) with the slant length L: in one soil without ends it is the same at all depths for one tool angle.
    pub normalised_kg_m3: f64,
    /// Its band (kg/m3).
    pub normalised_band_kg_m3: [f64; 2],
}

/// Ranges at a depth.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Level {
    /// Depth below the surface (m).
    pub depth_m: f64,
    /// Friction angle (deg).
    pub phi_deg: [f64; 2],
    /// Density (kg/m3).
    pub density_kg_m3: [f64; 2],
}

/// What is left of the ground.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Ranges {
    /// Friction angle (deg) at the surface, or above the step.
    pub phi_top_deg: [f64; 2],
    /// Friction angle (deg) at the deepest stroke, or below the step.
    pub phi_bottom_deg: [f64; 2],
    /// By how much the friction angle is greater at the bottom (deg).
    pub phi_growth_deg: [f64; 2],
    /// Density (kg/m3) at the top.
    pub density_top_kg_m3: [f64; 2],
    /// Density (kg/m3) at the bottom.
    pub density_bottom_kg_m3: [f64; 2],
    /// By how much the density is greater at the bottom (kg/m3).
    pub density_growth_kg_m3: [f64; 2],
}

/// Grounds with a step within an interval of depths.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct StepSlice {
    /// Depths of the step (m).
    pub step_m: [f64; 2],
    /// What is left of such ground.
    pub ranges: Ranges,
}

/// A way in which ground may go with depth, and what the strokes leave of it.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Hypothesis {
    /// The way.
    pub kind: Kind,
    /// Whether some such ground explains all strokes.
    pub consistent: bool,
    /// Whether that is for sure: false if the search ended before it found one, and before all were excluded.
    pub is_certain: bool,
    /// By which factor bands must be widened until some such ground explains them; 1 if it does, null if not even ten is enough.
    pub widening: Option<f64>,
    /// Probability that strokes in such ground are so far off by chance, at most; null if it is consistent, and for bounds.
    pub p: Option<f64>,
    /// What is left; null if inconsistent.
    pub ranges: Option<Ranges>,
    /// Depth of the step (m); null if inconsistent, and of other kinds.
    pub step_m: Option<[f64; 2]>,
    /// What is left for steps at depths of an interval, growing; empty for other kinds.
    pub slices: Vec<StepSlice>,
    /// Ranges over depth, from the surface to the deepest stroke; empty if inconsistent.
    pub profile: Vec<Level>,
    /// Whether ranges are as narrow as the data allow, to 0.25 deg and 20 kg/m3; otherwise the search ended before, and they are wider.
    pub is_sharp: bool,
}

/// One soil of another kind, which looks like ground that changes.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Alias {
    /// Whether it explains all strokes; null if it was not asked, for the model has no such term.
    pub consistent: Option<bool>,
    /// What was allowed, in the unit of the alias: degrees a decade of stress, or Pa.
    pub allowed: [f64; 2],
    /// What the strokes leave of that; null if it explains nothing, or one soil without it explains them, so that it was not asked.
    pub left: Option<[f64; 2]>,
    /// Range of the friction angle (deg) then, under a law of stress at its reference; null as before.
    pub phi_deg: Option<[f64; 2]>,
}

/// A force at a depth by a hypothesis.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Predicted {
    /// The hypothesis.
    pub kind: Kind,
    /// Forces (N) that it allows; the upper one is null where there is no end to them.
    pub force_n: [Option<f64>; 2],
}

impl Predicted {
    /// Its range in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        match self.force_n {
            [Some(low), Some(high)] => crate::text::range(Some([low, high]), 1),
            [Some(low), None] => format!("at least {low:.1}"),
            [None, _] => "-".into(),
        }
    }
}

/// What a next stroke at a depth would tell.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct NextDepth {
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Depth (m).
    pub depth_m: f64,
    /// Width of the plate (m).
    pub width_m: f64,
    /// Forces by each consistent hypothesis.
    pub forces: Vec<Predicted>,
    /// Forces that some hypothesis allows and another does not, over what a band spans: the mean over pairs, or with one hypothesis all that it allows. Above 1 such a
    /// stroke may tell them apart.
    pub tells: f64,
}

/// The answer.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// Force model.
    pub model: String,
    /// Whether plates have ends.
    pub ends: Ends,
    /// Probability with which all bands together hold their true forces; null for bounds, which hold them for sure. A way in which the ground does go
    /// is excluded with a probability of at most one minus this.
    pub confidence: Option<f64>,
    /// What is known of the friction on the plate (deg).
    pub delta_deg: [f64; 2],
    /// Least and greatest depth of a stroke (m).
    pub depths_m: [f64; 2],
    /// Depths at which a step was looked for (m).
    pub step_searched_m: [f64; 2],
    /// Friction angles that were looked at (deg): those that the model covers. A range that ends there may be wider in truth.
    pub phi_searched_deg: [f64; 2],
    /// Densities that were looked at (kg/m3), at all depths.
    pub density_searched_kg_m3: [f64; 2],
    /// The measurements.
    pub strokes: Vec<Stroke>,
    /// The ways in which ground may go with depth.
    pub hypotheses: Vec<Hypothesis>,
    /// One soil whose friction angle falls with stress.
    pub friction_law: Alias,
    /// One soil with some cohesion.
    pub cohesion: Alias,
    /// What a next stroke would tell, by depth; empty if no hypothesis is consistent.
    pub next_depths: Vec<NextDepth>,
    /// Place in `next_depths` of the one that tells most; null if none tells anything.
    pub next: Option<usize>,
    /// The result in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl Answer {
    /// What was found of a kind.
    #[must_use]
    pub fn of(&self, kind: Kind) -> Option<&Hypothesis> {
        self.hypotheses.iter().find(|hypothesis| hypothesis.kind == kind)
    }

    /// Whether ground of a kind explains the strokes.
    #[must_use]
    pub fn allows(&self, kind: Kind) -> bool {
        self.of(kind).is_some_and(|hypothesis| hypothesis.consistent)
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.profile/1";

    /// Negative if no ground of any kind explains the strokes.
    fn outcome(&self) -> Outcome {
        if self.hypotheses.iter().any(|one| one.consistent) { Outcome::Done } else { Outcome::Negative }
    }
}
