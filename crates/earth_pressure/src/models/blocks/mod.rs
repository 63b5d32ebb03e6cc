//! A kinematic upper bound for a plate with ends: translating blocks that a cone of directions sweeps sideways.
//!
//! It generalises the multi-block mechanisms of Soubra & Regenass (2000, Journal of Geotechnical and Geoenvironmental
//! Engineering 126, 969-978). Ahead of the plate, [`fan`] has the blocks in the plane and [`ends`] what they sweep at
//! the two ends; [`behind`] has the soil that slides down after the plate. With volumes `Vol_i` and velocities `V_i` the
//! work of the plate equals that against the weight,
//!
//! ```text
//! P sin(alpha + delta) = gamma (sum over blocks ahead of Vol_i V_iz  -  the same of the wedge behind)
//! ```
//!
//! With cohesion c, a surface of slip dissipates `c cot(phi)` times the volume by which it opens, whatever the direction
//! of slip, so all of them together dissipate `c cot(phi)` times what the heaved surface rises by less what the plate
//! sweeps. Adhesion holds back what moves up along the plate. A plate without ends has the plane mechanism.

mod ahead;
mod behind;
mod ends;
mod fan;
mod polyhedra;

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;
use soilctl_certificate::{CertificateError, Claim, Mechanism, Statement, prove_mechanism};
use soilctl_soil::{Angle, WidthRatio};
use std::f64::consts::{FRAC_PI_2, PI};

use self::behind::Wedge;
use self::ends::Ends;
use self::fan::{Block, Shape};
use super::chen_liu;
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "blocks-3d";

/// Facets of a cone while the shape is sought, and in the answer. The end term at (phi 40, delta 25) is 3 % above that
/// of the circular cone with 16 facets.
const FACETS_SOUGHT: usize = 16;
const FACETS: usize = 64;

/// Restarts of the downhill simplex, and most steps of each.
const RUNS: usize = 3;
const STEPS: u64 = 300;

/// What headings and rays turn at least, from the first to the last: the direction of a jump between blocks that hardly
/// move against each other would be rounding, and so would the facets of one that is too thin.
const LEAST_TURN: f64 = 1e-5;
const LEAST_SPREAD: f64 = 1e-3;

/// How much larger both friction angles are for polyhedra that are to be proven, in radians, so that rounding does no harm;
/// more if the proof fails.
const MARGINS: [f64; 4] = [1e-8, 1e-7, 1e-6, 1e-5];

/// The value of a shape that is no mechanism.
const NONE: f64 = 1e12;

/// Translating blocks with cone-swept ends.
#[derive(Debug, Clone, Copy, Default)]
pub struct Blocks;

impl Blocks {
    /// Width over depth at which the mechanism of [`Blocks::proven_law`] is best.
    pub const LAW_AT: f64 = 5.0;

    /// The mechanism of least force under some loads as polyhedra, with the force per width times the plate's velocity
    /// that they are proven to hold back at most.
    ///
    /// The statement is that of the plate of this case, in units of the slant length and of the unit weight, x along the
    /// surface and z across it, the plate's top at the origin. Its width counts, whatever the case says. `loads` says what each
    /// factor is worth: `1/2` for the weight and a pressure for the others. The plate moves horizontally with unit speed.
    ///
    /// # Errors
    ///
    /// As [`ForceModel::predict`]; [`EarthPressureError::Soil`] for a statement without a width;
    /// [`EarthPressureError::NotProven`].
    pub fn proven(
        &self,
        case: &Case,
        statement: &Statement,
        loads: LoadFactors,
    ) -> Result<Claim<Mechanism>, EarthPressureError> {
        let width = statement.width.unwrap_or(f64::NAN);
        let case = case.with_width_ratio(WidthRatio::new(width / case.tool_angle.sin())?);
        proven(&case, loads, |harder, blocks, wedge| {
            let field = polyhedra::polyhedra(harder, 0.5 * width, blocks, wedge, FACETS);
            let claimed = prove_mechanism(statement, &field)?;
            Ok(Claim { field, claimed, computed: None })
        })
    }

    /// A bound for every width at once, by the mechanism that is best at five times the depth: what the ends of a given one
    /// sweep does not depend on how far apart they are, so the force per width grows linearly with depth over width, and
    /// not more than that where the ends behind the plate meet. The statement is as for [`Blocks::proven`], in plane strain.
    ///
    /// # Errors
    ///
    /// As [`Blocks::proven`].
    pub fn proven_law(
        &self,
        case: &Case,
        statement: &Statement,
        loads: LoadFactors,
    ) -> Result<EndLaw, EarthPressureError> {
        let sine = case.tool_angle.sin();
        proven(&case.with_width_ratio(WidthRatio::new(Self::LAW_AT)?), loads, |harder, blocks, wedge| {
            let held = |ratio: f64| {
                let width = ratio * sine;
                let field = polyhedra::polyhedra(
                    &harder.with_width_ratio(WidthRatio::new(ratio).unwrap_or(WidthRatio::PLANE_STRAIN)),
                    0.5 * width,
                    blocks,
                    wedge.map(|w| w.at_width(ratio / Self::LAW_AT)).as_ref(),
                    FACETS,
                );
                prove_mechanism(&statement.clone().with_width(width), &field)
            };
            let [far, near] = [held(LAW_FROM[0])?, held(LAW_FROM[1])?];
            let depth_over_width = LAW_FROM.map(f64::recip);
            let term = (near - far) / (depth_over_width[1] - depth_over_width[0]);
            // Both are bounds that are a few roundings above what the blocks hold.
            let term = term + LAW_SLACK * far.abs();
            Ok(EndLaw { without_ends: far - depth_over_width[0] * term + LAW_SLACK * far.abs(), term })
        })
    }
}

/// Widths over depth between which the law is taken: the ends behind the plate are far apart there.
const LAW_FROM: [f64; 2] = [400.0, 100.0];

/// What proven bounds may be above the true power of their blocks, relative, and more.
const LAW_SLACK: f64 = 1e-8;

/// An upper bound on the force per width for every width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndLaw {
    /// The bound on a plate that is wide beyond all measure.
    pub without_ends: f64,
    /// What a depth over width of one adds to it.
    pub term: f64,
}

/// Makes and proves something of the best mechanism, with friction angles that are larger by as little as suffices.
fn proven<T>(
    case: &Case,
    loads: LoadFactors,
    prove: impl Fn(&Case, &[Block], Option<&Wedge>) -> Result<T, CertificateError>,
) -> Result<T, EarthPressureError> {
    check(case)?;
    let mut refusal = String::new();
    for margin in MARGINS {
        let more = |angle: Angle| Angle::from_radians(angle.radians() + margin);
        let harder = Case { friction: more(case.friction), interface: more(case.interface), ..*case };
        let (blocks, wedge) = (best(&harder, loads)?, behind::hardest(&harder));
        match prove(&harder, &blocks, wedge.as_ref()) {
            Ok(proven) => return Ok(proven),
            Err(why) => refusal = why.to_string(),
        }
    }
    Err(EarthPressureError::NotProven { model: ID, why: refusal })
}

impl ForceModel for Blocks {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "translating blocks with cone-swept ends, after Soubra & Regenass 2000; kinematic upper bound on each side"
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange {
            alpha_deg: (30.0, 120.0),
            beta_deg: (-30.0, 30.0),
            phi_deg: (5.0, 50.0),
            delta_deg: (0.0, 50.0),
        }
    }

    fn has_ends(&self) -> bool {
        true
    }

    fn is_slow(&self) -> bool {
        true
    }

    fn has_load_terms(&self, _case: &Case) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        check(case)?;
        let blocks = best(case, WEIGHT)?;
        Prediction::from_sides(ID, case, passive(case, &blocks, FACETS), behind::active(case))
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        check(case)?;
        let top = (-case.tool_angle.cos(), case.tool_angle.sin());
        let corner = |block: &Block| {
            let (sin, cos) = libm::sincos(block.rays[1]);
            (top.0 + block.radii[1] * cos, top.1 - block.radii[1] * sin)
        };
        let points = std::iter::once((0.0, 0.0)).chain(best(case, WEIGHT)?.iter().map(corner)).collect();
        Ok(Some(FailureSurface::from_tip(case, points)))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        DirectSlice::boxed(self, tool_angle, surface_slope, width_ratio)
    }
}

/// Whether there is a mechanism. A plate that is flatter than its friction angle cannot leave soil behind it at rest, since a face separates
/// from it at the friction angle or more; and with ends, no wedge follows a plate that is as flat as that.
fn check(case: &Case) -> Result<(), EarthPressureError> {
    Blocks.valid_range().check(ID, case)?;
    if case.tool_angle < case.interface && behind::hardest(case).is_none() {
        return Err(case.singular(
            ID,
            "the plate is flatter than its friction angle, and drags the soil behind it along",
        ));
    }
    Ok(())
}

/// Passive factors of a mechanism.
fn passive(case: &Case, blocks: &[Block], facets: usize) -> LoadFactors {
    let (phi, plate) = (case.friction.radians(), case.tool_angle.radians() + case.interface.radians());
    let per_width = case.width_ratio.depth_over_width() / case.tool_angle.sin();
    let Ends { lifted, heaved_area } =
        if per_width > 0.0 { ends::ends(blocks, phi, facets) } else { Ends::default() };
    let lifted = blocks.iter().map(|b| b.area() * b.rise()).sum::<f64>() + lifted * per_width;
    let (Some(first), Some(last)) = (blocks.first(), blocks.last()) else { return LoadFactors::default() };
    let heaved = last.radii[1] + heaved_area * per_width;
    let opened = last.speed * libm::sin(last.heading + last.rays[1]) * heaved
        - first.speed * libm::sin(first.heading + first.rays[0]);
    let power = libm::sin(plate);
    LoadFactors {
        weight: 2.0 * lifted / power,
        surcharge: last.rise() * heaved / power,
        cohesion: opened / (libm::tan(phi) * power),
        adhesion: -first.speed * libm::cos(case.tool_angle.radians() + first.heading) / power,
    }
}

/// What factors are worth where only that of the weight counts.
const WEIGHT: LoadFactors = LoadFactors { weight: 1.0, surcharge: 0.0, cohesion: 0.0, adhesion: 0.0 };

/// The mechanism of least force on the passive side under loads of this worth.
fn best(case: &Case, worth: LoadFactors) -> Result<Vec<Block>, EarthPressureError> {
    let none = || case.singular(ID, "no mechanism of blocks fits between plate and surface");
    let mut shape = start(case, worth).ok_or_else(none)?;
    for _ in 0..RUNS {
        shape = downhill(case, shape, worth);
    }
    fan::blocks(case, &free(shape)).ok_or_else(none)
}

/// The free shape, so that rays and headings keep their order: first ray, how much the last is less, first heading,
/// how much the last is more.
fn free([ray, less, heading, more]: [f64; 4]) -> Shape {
    Shape {
        first_ray: ray,
        last_ray: ray - less.abs() - LEAST_SPREAD,
        first_heading: heading.abs(),
        last_heading: heading.abs() + more.abs() + LEAST_TURN,
    }
}

fn value(case: &Case, shape: [f64; 4], worth: LoadFactors) -> f64 {
    match fan::blocks(case, &free(shape)) {
        Some(blocks) => {
            let factors = passive(case, &blocks, FACETS_SOUGHT);
            worth.weight * factors.weight
                + worth.surcharge * factors.surcharge
                + worth.cohesion * factors.cohesion
                + worth.adhesion * factors.adhesion
        }
        None => NONE,
    }
}

/// The best of some shapes about Chen & Liu's fan, in which soil moves square to the rays.
fn start(case: &Case, worth: LoadFactors) -> Option<[f64; 4]> {
    let (first, last) = chen_liu::fan(case)?;
    let highest = 0.98 * case.tool_angle.radians();
    let steepest = PI - case.friction.radians() - case.tool_angle.radians() - 2.0 * fan::FLATTEST;
    let mut found: Option<([f64; 4], f64)> = None;
    for inside in [0.02, 0.1, 0.2, 0.3, 0.4] {
        for turned in [0.0, 0.05, 0.1, 0.2] {
            let spread = first - last;
            let ray = (first - inside * spread).min(highest);
            let heading = (FRAC_PI_2 - first + turned).min(steepest).max(0.0);
            let more = (FRAC_PI_2 - last - heading + turned).max(0.0);
            let shape = [ray, (ray - last - inside * spread).max(0.0), heading, more];
            let value = value(case, shape, worth);
            if value < found.map_or(NONE, |(_, least)| least) {
                found = Some((shape, value));
            }
        }
    }
    found.map(|(shape, _)| shape)
}

struct Problem<'a>(&'a Case, LoadFactors);

impl CostFunction for Problem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, at: &Self::Param) -> Result<f64, argmin::core::Error> {
        Ok(value(self.0, std::array::from_fn(|k| at[k]), self.1))
    }
}

/// Nelder & Mead's downhill simplex; the start where it breaks down.
fn downhill(case: &Case, start: [f64; 4], worth: LoadFactors) -> [f64; 4] {
    let mut simplex = vec![start.to_vec()];
    for k in 0..start.len() {
        let mut corner = start.to_vec();
        corner[k] += 0.05;
        simplex.push(corner);
    }
    let found = NelderMead::new(simplex)
        .with_sd_tolerance(1e-9)
        .and_then(|solver| {
            Executor::new(Problem(case, worth), solver).configure(|s| s.max_iters(STEPS)).run()
        })
        .ok()
        .and_then(|result| result.state().get_best_param().cloned());
    let shape = found.map_or(start, |at| std::array::from_fn(|k| at[k]));
    if value(case, shape, worth) <= value(case, start, worth) { shape } else { start }
}
