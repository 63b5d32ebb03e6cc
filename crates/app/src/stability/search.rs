//! The bounds with the weakest and the strongest soil, at the stresses of the problem, and where between them it begins to stand.

use soilctl_limit_analysis::{Decision, Level, Options, decide};

use super::answer::{FrictionBasis, SlopeAnswer, Trial};
use super::factor::{Found, of_description, with_soil};
use super::region::Soils;
use super::site::{Site, Soil};
use super::{Request, words};
use crate::solve::Asked;
use crate::text::number;
use crate::{AppError, Watch};

/// Without a law, stresses of the problem may be so many times those of the strokes or less: friction of sand changes by some 1 to 2 deg over
/// that.
const SAME_STRESS: f64 = 2.0;
/// By how much friction of sand falls at most with each factor of ten of stress, in degrees (Hong 2001, table 6.13).
const STEEPEST_DEG: f64 = 6.0;
/// Part of a factor that must be left if friction falls so.
const NEARLY_ALL: f64 = 0.95;
/// Part of all work that coarse bounds may take, from which the stresses are known.
const SCOUT_SHARE: f64 = 0.05;
/// Gap with which they are known well enough.
const SCOUT_GAP: f64 = 0.15;
/// Gap of the bounds of layers with which their field is good enough.
const LAYERS_GAP: f64 = 0.06;
/// Where it begins to stand is sought to this, in degrees.
const NARROW_DEG: f64 = 0.25;

/// What was found.
pub(super) struct Outcome {
    pub(super) lower: Option<f64>,
    pub(super) upper: Option<f64>,
    pub(super) phi_deg: [f64; 2],
    pub(super) basis: FrictionBasis,
    pub(super) stress_pa: Option<[f64; 2]>,
    pub(super) decisive_pa: Option<f64>,
    pub(super) stands_from_deg: Option<f64>,
    pub(super) fails_to_deg: Option<f64>,
    pub(super) trials: Vec<Trial>,
    pub(super) by_slope: Vec<SlopeAnswer>,
}

impl Outcome {
    pub(super) fn new(
        phi_deg: [f64; 2],
        basis: FrictionBasis,
        stress_pa: Option<[f64; 2]>,
        [lower, upper]: [Option<f64>; 2],
        trials: Vec<Trial>,
    ) -> Self {
        Self {
            lower,
            upper,
            phi_deg,
            basis,
            stress_pa,
            decisive_pa: None,
            stands_from_deg: None,
            fails_to_deg: None,
            trials,
            by_slope: Vec::new(),
        }
    }

    fn is_decided(&self, required: f64) -> bool {
        self.lower.is_some_and(|l| l >= required) || self.upper.is_some_and(|u| u < required)
    }
}

pub(super) struct Search<'a> {
    pub(super) request: &'a Request,
    pub(super) site: &'a Site,
    pub(super) soils: &'a Soils,
    watch: &'a dyn Watch,
    options: Options,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        request: &'a Request,
        site: &'a Site,
        soils: &'a Soils,
        watch: &'a dyn Watch,
    ) -> Result<Self, AppError> {
        let options = request.budget.options(watch)?;
        Ok(Self { request, site, soils, watch, options })
    }

    /// Where the friction of soils without a law comes from, and the stresses at which they slip.
    pub(super) fn basis(&self) -> Result<(FrictionBasis, Option<[f64; 2]>), AppError> {
        let phi_deg = self.middle_deg();
        let scouted = self.scout(phi_deg)?;
        Ok((self.basis_without_law(phi_deg, &scouted)?, scouted.stress_pa))
    }

    fn middle_deg(&self) -> f64 {
        let [weakest, strongest] = self.soils.phi_deg();
        f64::midpoint(weakest, strongest).clamp(5.0, 60.0)
    }

    pub(super) fn run(&self) -> Result<Outcome, AppError> {
        let guess = self.soils.phi_deg();
        let phi_deg = self.middle_deg();
        let scouted = self.scout(phi_deg)?;
        let mut outcome = if self.soils.has_law() {
            self.by_law(scouted.stress_pa)?
        } else {
            let basis = self.basis_without_law(phi_deg, &scouted)?;
            self.by_angle(guess, scouted.stress_pa, basis)?
        };
        outcome.trials.sort_by(|a, b| a.phi_deg.total_cmp(&b.phi_deg));
        Ok(outcome)
    }

    /// With friction angles between two, at any stress.
    fn by_angle(
        &self,
        phi_deg: [f64; 2],
        stress_pa: Option<[f64; 2]>,
        basis: FrictionBasis,
    ) -> Result<Outcome, AppError> {
        let [weakest, strongest] = phi_deg;
        let [_, cohesion_kpa] = self.soils.more_cohesion_kpa();
        let (lower, upper) = (self.lower(weakest)?, self.upper(strongest, cohesion_kpa)?);
        let trials = vec![
            Trial { phi_deg: weakest, lower, upper: None },
            Trial { phi_deg: strongest, lower: None, upper },
        ];
        let mut outcome = Outcome::new(phi_deg, basis, stress_pa, self.cut(lower, upper), trials);
        let required = self.site.required();
        if outcome.is_decided(required) {
            outcome.stands_from_deg = outcome.lower.filter(|l| *l >= required).map(|_| weakest);
            outcome.fails_to_deg = outcome.upper.filter(|u| *u < required).map(|_| strongest);
        } else {
            self.bisect(&mut outcome)?;
        }
        Ok(outcome)
    }

    /// What the search of the estimate cut off may be weaker or stronger.
    pub(super) fn cut(&self, lower: Option<f64>, upper: Option<f64>) -> [Option<f64>; 2] {
        let [cut_weak, cut_strong] = self.soils.cut;
        [lower.filter(|_| !cut_weak), upper.filter(|_| !cut_strong)]
    }

    /// Whether friction angles of the strokes may be taken for those of the problem: if its stresses are theirs, or the user says so.
    fn basis_without_law(&self, phi_deg: f64, scouted: &Found) -> Result<FrictionBasis, AppError> {
        match (self.is_at_same_stress(phi_deg, scouted), self.request.constant_friction) {
            (true, _) => Ok(FrictionBasis::SameStress),
            (false, true) => Ok(FrictionBasis::Constant),
            (false, false) => Err(AppError::Request(words::other_stresses(self.soils, scouted.stress_pa))),
        }
    }

    /// Whether soil slips at the stresses at which it was tried, and a field has nearly all its strength left if friction falls beyond these as it may. Of
    /// soil with cohesion that is not known: what a field leaves is looked at for friction alone.
    fn is_at_same_stress(&self, phi_deg: f64, scouted: &Found) -> bool {
        let Some([low, high]) = self.soils.tried_pa else { return false };
        let slips_there =
            scouted.stress_pa.is_some_and(|[l, h]| l >= low / SAME_STRESS && h <= high * SAME_STRESS);
        let (Some(of_field), Some((described, stress))) = (scouted.lower, &scouted.field) else {
            return false;
        };
        let falling = |pa: f64| phi_deg - STEEPEST_DEG * libm::log10(pa / high).max(0.0);
        let reserve = self.site.reserve(described, stress, falling).map_or(f64::INFINITY, |(r, _)| r);
        let whole = if self.site.asked() == Asked::FactorOfSafety { of_field } else { 1.0 };
        slips_there && reserve >= NEARLY_ALL * whole
    }

    /// Stresses by coarse bounds.
    fn scout(&self, phi_deg: f64) -> Result<Found, AppError> {
        self.bounds("stresses", self.middle(phi_deg), &self.coarse())
    }

    fn coarse(&self) -> Options {
        Options {
            max_gap: SCOUT_GAP.max(self.options.max_gap),
            max_work: ((SCOUT_SHARE * self.options.max_work as f64) as u64).max(1),
            max_seconds: self.options.max_seconds.map(|all| SCOUT_SHARE * all),
            ..self.options.clone()
        }
    }

    /// A soil of the middle density and cohesion.
    pub(super) fn middle(&self, phi_deg: f64) -> Soil {
        let middle = |[low, high]: [f64; 2]| f64::midpoint(low, high);
        let cohesion_kpa = middle(self.soils.more_cohesion_kpa());
        Soil { phi_deg, density_kg_m3: middle(self.soils.density_kg_m3), cohesion_kpa }
    }

    pub(super) fn bounds(&self, what: &str, soil: Soil, options: &Options) -> Result<Found, AppError> {
        with_soil(self.site, soil, options, &mut |elements| {
            self.watch.say(&format!("{what}: phi {} deg, {elements} elements", number(soil.phi_deg)));
        })
    }

    /// Bounds with the weakest soil in layers; `None` if it cannot be had so.
    pub(super) fn in_layers(&self, density_kg_m3: f64) -> Option<Found> {
        let weakest = |pa: f64| self.soils.weakest_deg(pa);
        let description = self.site.with_layers(density_kg_m3, weakest)?;
        let say = &mut |elements| self.watch.say(&format!("weakest soil in layers: {elements} elements"));
        // The field is what counts, and is not much better for a sharper bound of the layers.
        let part = self.part();
        let options = Options { max_gap: part.max_gap.max(LAYERS_GAP), ..part };
        // What the layers cannot do is left to the whole soil.
        of_description(self.site, &description, &options, say).ok()
    }

    /// Densities that matter.
    pub(super) fn densities(&self) -> Vec<f64> {
        let [low, high] = self.soils.density_kg_m3;
        if self.site.takes_density() && low < high { vec![low, high] } else { vec![low] }
    }

    /// Work and time that one of the runs for an answer may take.
    pub(super) fn part(&self) -> Options {
        const PART: f64 = 0.25;
        let max_seconds = self.options.max_seconds.map(|all| PART * all);
        Options { max_seconds, ..self.options.clone() }
    }

    /// A lower bound with a friction angle and the least cohesion that holds for all densities.
    fn lower(&self, phi_deg: f64) -> Result<Option<f64>, AppError> {
        let mut least = Some(f64::INFINITY);
        let [cohesion_kpa, _] = self.soils.more_cohesion_kpa();
        for density_kg_m3 in self.densities() {
            let soil = Soil { phi_deg, density_kg_m3, cohesion_kpa };
            let found = self.bounds("weakest soil", soil, &self.part())?.lower;
            least = least.zip(found).map(|(a, b)| a.min(b));
        }
        Ok(least)
    }

    /// An upper bound with a friction angle, and cohesion (kPa), that holds for all densities: by the mechanism of one of them.
    pub(super) fn upper(&self, phi_deg: f64, cohesion_kpa: f64) -> Result<Option<f64>, AppError> {
        self.upper_by(phi_deg, cohesion_kpa, &self.part())
    }

    /// The same, coarse.
    pub(super) fn coarse_upper(&self, phi_deg: f64, cohesion_kpa: f64) -> Result<Option<f64>, AppError> {
        self.upper_by(phi_deg, cohesion_kpa, &self.coarse())
    }

    fn upper_by(&self, phi_deg: f64, cohesion_kpa: f64, options: &Options) -> Result<Option<f64>, AppError> {
        let middle = self.middle(phi_deg).density_kg_m3;
        for density_kg_m3 in std::iter::once(middle).chain(self.densities()) {
            let soil = Soil { phi_deg, density_kg_m3, cohesion_kpa };
            let found = self.bounds("strongest soil", soil, options)?;
            let upper = found.upper_between(self.site, soil, self.soils.density_kg_m3)?;
            if upper.is_some() || self.is_stopped() {
                return Ok(upper);
            }
        }
        Ok(None)
    }

    /// Whether a problem with one soil reaches what is required, with bounds no sharper than that takes, and coarse ones.
    pub(super) fn decide(&self, soil: Soil) -> Result<Decision, AppError> {
        let description = self.site.with_soil(soil)?;
        let mut say = |level: &Level, _| self.watch.say(&format!("{} elements", level.upper.elements));
        Ok(decide(&description, self.site.required(), &self.coarse(), &mut say)?)
    }

    /// Whether a lower bound is all that was asked for.
    pub(super) fn is_enough(&self, lower: Option<f64>) -> bool {
        lower.is_some_and(|lower| lower >= self.site.required())
    }

    pub(super) fn is_stopped(&self) -> bool {
        self.options.is_stopped()
    }

    /// Halves the friction angles until it is known where it begins to stand.
    fn bisect(&self, outcome: &mut Outcome) -> Result<(), AppError> {
        let required = self.site.required();
        let [mut fails, mut stands] = outcome.phi_deg;
        let [_, cohesion_kpa] = self.soils.more_cohesion_kpa();
        for _ in 0..self.request.trials {
            if stands - fails < NARROW_DEG || self.is_stopped() {
                break;
            }
            let phi_deg = f64::midpoint(fails, stands);
            let (lower, upper) = (self.lower(phi_deg)?, self.upper(phi_deg, cohesion_kpa)?);
            outcome.trials.push(Trial { phi_deg, lower, upper });
            if lower.is_some_and(|lower| lower >= required) {
                stands = phi_deg;
                outcome.stands_from_deg = Some(phi_deg);
            } else if upper.is_some_and(|upper| upper < required) {
                fails = phi_deg;
                outcome.fails_to_deg = Some(phi_deg);
            } else {
                break;
            }
        }
        Ok(())
    }
}
