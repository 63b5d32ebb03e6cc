//! Slopes that a wheel or a track climbs on every soil that explains the strokes, or that was published.

mod answer;
mod request;
mod section;

use std::time::Instant;

pub use answer::{Answer, Trial};
pub use request::Request;
use section::section;
use soilctl_limit_analysis::Reach;

use super::FrictionBasis;
use super::region::{Origin, Soils};
use super::search::Search;
use super::site::{Site, Soil};
use super::{Verdict, words};
use crate::text::number;
use crate::{AppError, Watch};

/// Steepest slope that is tried, in degrees.
const STEEPEST_DEG: f64 = 60.0;
/// Slopes end so far below the friction angle of the weakest soil without cohesion, which falls by itself there, in degrees.
const BELOW_FRICTION_DEG: f64 = 0.25;

/// Answers which slopes a wheel climbs.
///
/// # Errors
/// [`AppError`] if a request or file makes no sense, the friction of the strokes says nothing at the stresses under the wheel, or nothing is proven.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let begun = Instant::now();
    let soils = Soils::read(&request.region)?;
    if soils.has_law() {
        return Err(AppError::Request(format!(
            "{}: a law of stress is not covered under a wheel, where nothing holds the soil beside it; estimate without --friction-law, from strokes or tests at \
             the stresses under the wheel",
            request.region.display()
        )));
    }
    let steepest_deg = steepest_deg(&soils);
    if let Some(slope) = request.slope_deg.filter(|slope| *slope > steepest_deg) {
        return Err(AppError::Request(format!(
            "--slope is {} deg; the weakest of these soils falls by itself from {} deg on",
            number(slope),
            number(steepest_deg)
        )));
    }
    let mut climb = Climb {
        request,
        soils: &soils,
        watch,
        trials: Vec::new(),
        basis: None,
        stress_pa: None,
        is_stopped: false,
    };
    watch.begin(0, "slopes");
    let searched = climb.search(steepest_deg);
    watch.end();
    searched?;
    climb.trials.sort_by(|a, b| a.slope_deg.total_cmp(&b.slope_deg));
    climb.answer(steepest_deg, begun)
}

/// Where the weakest soil falls by itself, or where nobody drives.
fn steepest_deg(soils: &Soils) -> f64 {
    let [weakest, _] = soils.phi_deg();
    let has_cohesion = soils.more_cohesion_kpa()[0] > 0.0;
    if has_cohesion { STEEPEST_DEG } else { (weakest - BELOW_FRICTION_DEG).clamp(0.0, STEEPEST_DEG) }
}

struct Climb<'a> {
    request: &'a Request,
    soils: &'a Soils,
    watch: &'a dyn Watch,
    trials: Vec<Trial>,
    basis: Option<FrictionBasis>,
    stress_pa: Option<[f64; 2]>,
    /// Whether the user broke it off; what was found until then is told.
    is_stopped: bool,
}

impl Climb<'_> {
    /// Tries the slope that is asked about, or halves slopes until it is known up to which the wheel climbs and from which it does not.
    fn search(&mut self, steepest_deg: f64) -> Result<(), AppError> {
        if let Some(slope) = self.request.slope_deg {
            return self.trial(slope).map(|_| ());
        }
        let level = self.trial(0.0)?;
        let end = self.trial(steepest_deg)?;
        if !end.climbs() && level.climbs() {
            self.halve(0.0, steepest_deg, |trial| !trial.climbs())?;
        }
        if end.slips() && !level.slips() {
            // What is known already narrows it.
            let (slips, holds): (Vec<&Trial>, Vec<&Trial>) =
                self.trials.iter().partition(|trial| trial.slips());
            let from = holds.iter().map(|trial| trial.slope_deg).fold(0.0, f64::max);
            let to = slips.iter().map(|trial| trial.slope_deg).fold(steepest_deg, f64::min);
            if from < to {
                self.halve(from, to, Trial::slips)?;
            }
        }
        Ok(())
    }

    /// Halves slopes between one of which something does not hold, and a steeper one of which it does.
    fn halve(&mut self, mut from: f64, mut to: f64, holds: impl Fn(&Trial) -> bool) -> Result<(), AppError> {
        while to - from > self.request.within_deg && !self.is_stopped {
            let middle = f64::midpoint(from, to);
            if holds(&self.trial(middle)?) { to = middle } else { from = middle }
        }
        Ok(())
    }

    /// Bounds the factor on the wheel's load on one slope.
    fn trial(&mut self, slope_deg: f64) -> Result<Trial, AppError> {
        self.watch.say(&format!("a slope of {} deg", number(slope_deg)));
        let request = self.request.of_stability();
        let gravity = self.request.gravity_m_s2.unwrap_or(self.soils.gravity_m_s2);
        let site =
            Site::new(section(self.request, slope_deg), "the section under the wheel", &request, self.soils)?
                .under_gravity(gravity * slope_deg.to_radians().cos());
        let search = Search::new(&request, &site, self.soils, self.watch)?;
        if self.basis.is_none() {
            let (basis, stress_pa) = search.basis()?;
            (self.basis, self.stress_pa) = (Some(basis), stress_pa);
        }
        let (lower, upper) = (self.weakest(&search)?, self.strongest(&search)?);
        self.is_stopped |= search.is_stopped();
        let trial = Trial { slope_deg, lower, upper };
        self.trials.push(trial);
        Ok(trial)
    }

    /// A lower bound with the weakest soil, for all densities: the least of theirs.
    fn weakest(&self, search: &Search<'_>) -> Result<Option<f64>, AppError> {
        let ([phi_deg, _], [cohesion_kpa, _]) = (self.soils.phi_deg(), self.soils.more_cohesion_kpa());
        let mut least = f64::INFINITY;
        for density_kg_m3 in search.densities() {
            match search.decide(Soil { phi_deg, density_kg_m3, cohesion_kpa })?.lower {
                Some(lower) => least = least.min(lower),
                None => return Ok(None),
            }
        }
        Ok(search.cut(Some(least), None)[0])
    }

    /// A coarse upper bound with the strongest soil, for all densities; none where soil of the middle density bears it.
    fn strongest(&self, search: &Search<'_>) -> Result<Option<f64>, AppError> {
        let ([_, phi_deg], [_, cohesion_kpa]) = (self.soils.phi_deg(), self.soils.more_cohesion_kpa());
        let middle = Soil { cohesion_kpa, ..search.middle(phi_deg) };
        match search.decide(middle)?.reach {
            Reach::Reached | Reach::Open => Ok(None),
            Reach::Missed => Ok(search.cut(None, search.coarse_upper(phi_deg, cohesion_kpa)?)[1]),
        }
    }

    fn answer(self, steepest_deg: f64, begun: Instant) -> Result<Answer, AppError> {
        let Self { request, soils, trials, basis, stress_pa, .. } = self;
        let Some(friction_basis) = basis else {
            return Err(AppError::Request("no slope was tried".into()));
        };
        let climbed = trials.iter().filter(|t| t.climbs()).map(|t| t.slope_deg).reduce(f64::max);
        let slipped = trials.iter().filter(|t| t.slips()).map(|t| t.slope_deg).reduce(f64::min);
        let verdict = request.slope_deg.map(|_| match (climbed, slipped) {
            (Some(_), _) => Verdict::Stands,
            (None, Some(_)) => Verdict::Fails,
            (None, None) => Verdict::Depends,
        });
        let mut answer = Answer {
            answer: verdict,
            climbs_to_deg: climbed,
            gives_way_from_deg: slipped,
            steepest_deg,
            trials,
            phi_deg: soils.phi_deg(),
            friction_basis,
            cohesion_pa: soils.cohesion_pa,
            density_kg_m3: soils.density_kg_m3,
            gravity_m_s2: request.gravity_m_s2.unwrap_or(soils.gravity_m_s2),
            pressure_pa: request.pressure_pa(),
            slip_stress_pa: stress_pa,
            tried_stress_pa: soils.tried_pa,
            verdict: String::new(),
            warnings: warnings(soils, friction_basis),
            seconds: begun.elapsed().as_secs_f64(),
        };
        answer.verdict = sentence(&answer, request, soils.origin);
        Ok(answer)
    }
}

/// The answer in a sentence.
fn sentence(answer: &Answer, request: &Request, origin: Origin) -> String {
    let wheel = format!(
        "A wheel with {} N on {} by {} mm, {} kPa,",
        number(request.wheel_load_n),
        number(1e3 * request.contact_length_m),
        number(1e3 * request.wheel_width_m),
        number(1e-3 * request.pressure_pa())
    );
    let every = origin.every_soil();
    match (answer.answer, answer.climbs_to_deg, answer.gives_way_from_deg) {
        (Some(Verdict::Stands), ..) => format!("{wheel} climbs this slope on {every}."),
        (Some(Verdict::Fails), ..) => {
            format!("{wheel} does not: the ground under it gives way with {every}.")
        }
        (Some(Verdict::Depends), ..) => {
            format!("{wheel} may climb this slope: it depends on the soil, or the bounds are too far apart.")
        }
        (None, None, Some(0.0)) => format!("{wheel} sinks on level ground, with {every}."),
        (None, climbs, gives_way) => {
            let climbs = climbs.map_or_else(
                || "is not proven to be borne on level ground".to_owned(),
                |to| format!("climbs slopes up to {to:.1} deg on {every}"),
            );
            let gives_way = gives_way.map_or_else(String::new, |from| {
                format!("; from {from:.1} deg on the ground under it gives way with each of them")
            });
            format!("{wheel} {climbs}{gives_way}.")
        }
    }
}

/// What to keep in mind.
fn warnings(soils: &Soils, basis: FrictionBasis) -> Vec<String> {
    let mut warnings = vec![
        "a strip as wide as the wheel is long in contact, in plane strain: what the wheel's ends add, its sinkage, slip and lugs, and load that moves to the \
         lower wheels on a slope, are not in it"
            .to_owned(),
    ];
    if basis == FrictionBasis::Constant {
        warnings.push(format!(
            "{} taken as {} found {}, at whatever stress is under the wheel, because --constant-friction says so",
            if soils.cohesion_pa.is_some() { "friction and cohesion are" } else { "friction is" },
            soils.origin.trials(),
            if soils.cohesion_pa.is_some() { "them" } else { "it" },
        ));
    }
    warnings.extend(words::cut(soils));
    warnings
}
