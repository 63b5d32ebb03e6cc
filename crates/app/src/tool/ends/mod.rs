//! A tool of finite width: its own stress field in plane strain from below, which holds for every width with side plates and without, and from above
//! blocks in space, ahead of the tool if it is a plate, or else ahead of a [`front`] that it lies behind.

mod answer;
mod front;

pub use answer::{EndsAnswer, FrontAnswer};
use front::Front;
use soilctl_certificate::{Claim, Mechanism, SCHEMA, Scale, Solution, Statement};
use soilctl_earth_pressure::{Blocks, Case, LoadFactors};
use soilctl_limit_analysis::EmbeddedPlate;
use soilctl_soil::WidthRatio;

use super::ground::Placed;
use super::request::Setting;
use super::shape::Point;
use crate::solve::Kept;
use crate::text::number;
use crate::{AppError, Watch};

/// Tool angles at which fronts are tried before the best is looked for nearby.
const FRONTS: u32 = 8;
/// How often the distance of two fronts on either side of the best is halved.
const HALVINGS: u32 = 4;
/// Where mechanisms of blocks are known to be found (deg), and how far a front is from being as flat as its friction angle at least.
const ALPHAS: [f64; 2] = [30.0, 120.0];
const ABOVE_PHI: f64 = 1.0;
/// Greatest sum of tool angle and friction of the front (deg).
const GREATEST_SUM: f64 = 174.0;

/// What bounds the force of a tool with ends from above.
#[derive(Debug)]
pub(super) struct Above {
    /// Newtons, rounded upwards.
    pub(super) upper_n: f64,
    /// The plate that the blocks are of; none where it is the tool itself.
    front: Option<Front>,
    solution: Solution,
}

/// Refuses what the argument for ends does not cover.
pub(super) fn check(setting: &Setting, placed: &Placed) -> Result<(), AppError> {
    let loads = &setting.loads;
    let sticky = placed.shape.pieces().iter().map(|piece| piece.adhesion_pa).fold(0.0, f64::max);
    for (option, value, unit) in [
        ("--cohesion", loads.cohesion_pa, "Pa"),
        ("--surcharge", loads.surcharge_pa, "Pa"),
        ("adhesion", sticky, "Pa"),
        ("--beta", loads.beta_deg, "deg"),
        ("--direction", setting.direction_deg, "deg"),
    ] {
        if value != 0.0 {
            return Err(AppError::Request(format!(
                "{option} is {} {unit}, and bounds with ends (--width) are of tools that move along level sand without cohesion and loads: it must be 0; \
                 leave --width out for bounds per metre of a tool without ends",
                number(value)
            )));
        }
    }
    Ok(())
}

impl Above {
    /// The best mechanism found and proven.
    pub(super) fn new(
        setting: &Setting,
        placed: &Placed,
        width_m: f64,
        watch: &dyn Watch,
    ) -> Result<Self, AppError> {
        watch.begin(0, "mechanisms in space");
        // A plate needs no plug, is smoother than soil, and soil follows it.
        let own = Self::of_plate(setting, placed, width_m).and_then(Result::ok);
        let found = own.map_or_else(|| Self::of_front(setting, placed, width_m), Ok);
        watch.end();
        found
    }

    /// Of a flat tool without side plates, by itself.
    fn of_plate(setting: &Setting, placed: &Placed, width_m: f64) -> Option<Result<Self, AppError>> {
        let shape = &placed.shape;
        let piece = shape.pieces().first()?;
        let is_plate = shape.is_flat() && shape.top()[1] == 0.0 && shape.side_plates.is_empty();
        is_plate.then(|| {
            let alpha_deg = shape.chord_alpha_deg();
            let sides = Sides { alpha_deg, phi_deg: setting.phi_deg, delta_deg: piece.delta_deg };
            Self::proven(&sides, placed, shape.chord_m(), width_m, None)
        })
    }

    /// Of the front that bounds the force best.
    fn of_front(setting: &Setting, placed: &Placed, width_m: f64) -> Result<Self, AppError> {
        let phi_deg = setting.phi_deg;
        let points: Vec<Point> =
            placed.shape.points().chain(placed.shape.side_plates.iter().copied()).collect();
        let force = |alpha_deg: f64| {
            let front = Front::new(&points, phi_deg, alpha_deg, width_m)?;
            let ratio = WidthRatio::new(front.width_m / front.depth_m).ok()?;
            let case = Case::from_deg(alpha_deg, 0.0, phi_deg, phi_deg).with_width_ratio(ratio);
            let coefficient = Blocks.ahead(&case).ok()?;
            let along = (alpha_deg + phi_deg).to_radians().sin();
            Some((coefficient * along * front.length_m().powi(2) * front.width_m, front))
        };
        let [low, high] = [ALPHAS[0].max(phi_deg + ABOVE_PHI), ALPHAS[1].min(GREATEST_SUM - phi_deg)];
        let step = (high - low) / f64::from(FRONTS - 1);
        let tried: Vec<(f64, Front)> = (0..FRONTS).filter_map(|k| force(low + step * f64::from(k))).collect();
        let Some(mut best) = tried.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return Err(AppError::Request(format!(
                "no mechanism of blocks in space is found for the tool at --phi {} deg; with --width friction angles are 5 to 50 deg",
                number(phi_deg)
            )));
        };
        let mut nearby = step;
        for _ in 0..HALVINGS {
            nearby *= 0.5;
            let around = [best.1.alpha_deg - nearby, best.1.alpha_deg + nearby];
            let found = around.into_iter().filter(|alpha| (low..=high).contains(alpha)).filter_map(&force);
            best = found.fold(best, |best, one| if one.0 < best.0 { one } else { best });
        }
        let front = best.1;
        let sides = Sides { alpha_deg: front.alpha_deg, phi_deg, delta_deg: phi_deg };
        Self::proven(&sides, placed, front.length_m(), front.width_m, Some(front))
    }

    /// Proves blocks of a plate: those ahead of a front alone, or of a plate with the soil that follows it.
    fn proven(
        sides: &Sides,
        placed: &Placed,
        length_m: f64,
        width_m: f64,
        front: Option<Front>,
    ) -> Result<Self, AppError> {
        let Sides { alpha_deg, phi_deg, delta_deg } = *sides;
        let plate = EmbeddedPlate { alpha_deg, phi_deg, delta_deg, ..EmbeddedPlate::default() };
        let problem = plate.problem_with_ends(width_m / length_m)?;
        let statement = problem.statement();
        let case = Case::from_deg(alpha_deg, 0.0, phi_deg, delta_deg);
        let claim = if front.is_some() {
            Blocks.proven_ahead(&case, statement)?
        } else {
            let loads = LoadFactors { weight: 0.5, surcharge: 0.0, cohesion: 0.0, adhesion: 0.0 };
            Blocks.proven(&case, statement, loads)?
        };
        let newtons = 1e3 * placed.unit_weight_kn_m3 * length_m * length_m * width_m;
        let upper = claim.claimed * newtons;
        // The lengths and each product are good to a few roundings.
        let upper_n = upper + 16.0 * f64::EPSILON * upper.abs();
        let solution = solution(statement, claim, placed, length_m, front);
        Ok(Self { upper_n, front, solution })
    }

    /// What proves the bound, beside what proves the lower one: it is of another statement.
    pub(super) fn kept(&self) -> Kept {
        let part = if self.front.is_some() { "front" } else { "blocks" };
        Kept { part: Some(part), solution: self.solution.clone() }
    }
}

/// The angles of a plate that blocks are of.
struct Sides {
    alpha_deg: f64,
    phi_deg: f64,
    delta_deg: f64,
}

fn solution(
    statement: &Statement,
    claim: Claim<Mechanism>,
    placed: &Placed,
    length_m: f64,
    front: Option<Front>,
) -> Solution {
    let what = match front {
        Some(front) => format!(
            "front at {} deg, {} m deep and {} m wide, as rough as the soil: an equivalent plate, whose bound by blocks ahead of it alone is one of a tool that lies \
             behind it; that the tool does is not part of this file",
            number(front.alpha_deg),
            number(front.depth_m),
            number(front.width_m)
        ),
        None => "a plate with ends".to_owned(),
    };
    Solution {
        schema: SCHEMA.to_owned(),
        program: format!("soilctl {}", env!("CARGO_PKG_VERSION")),
        statement: statement.clone(),
        scale: Scale {
            length_m: Some(length_m),
            unit_weight_n_per_m3: Some(1e3 * placed.unit_weight_kn_m3),
            description: Some(what),
        },
        lower: None,
        upper: None,
        mechanism: Some(claim),
        space: None,
    }
}
