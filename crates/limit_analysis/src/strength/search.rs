//! The search for the factor of safety: which factor to try next, and how sharply.
//!
//! At each factor `F` that divides the strength, the factor on all that acts that the soil can bear has bounds `[l, u]`, both
//! falling with `F`. Where `l` is at least one the soil stands, where `u` is below one it does not. Roots of both are
//! approached by secants in logarithms; for soil without friction the first step is exact.

/// Bounds on the weight multiplier at one factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// What strength was divided by.
    pub factor: f64,
    /// Lower bound on the multiplier; zero if none is proven.
    pub lower: f64,
    /// Upper bound; infinite if none is proven or any weight can be borne.
    pub upper: f64,
}

/// No step is larger than this factor: one bad multiplier shall not lead far astray.
const STEP: f64 = 4.0;

/// Steps are a little longer than they need be, in units of the gap asked for, so that they end on the right side.
const SPARE: f64 = 0.05;

/// Gap of the multiplier, in units of the gap asked for, at which a factor is left open; and how much sharper each stage is.
const SHARP: f64 = 0.7;
const SHARPER: f64 = 0.4;

/// How far beside a guess it is tried, and how much is worth a further trial, in units of the gap asked for.
const BESIDE: f64 = 0.45;
const LEAST_PART: f64 = 0.4;
const REACH: f64 = 1.15;

/// Bounds farther apart than this, in units of the gap asked for, are brought together from both sides at once.
const FAR: f64 = 4.0;

/// Bounds this close to one (in logarithms) tell well where they are one.
const NEAR: f64 = 0.1;

/// A trial whose bounds are both this close to one (in logarithms) tells where the limit is: secants from it lead there, which halving
/// and steps away from a guess only do in the end.
const TOLD: f64 = 0.15;

/// Factors on both sides of the limit that are this close (in logarithms) fail in much the same way.
const ALIKE: f64 = 0.1;

impl Trial {
    /// Distance of the bounds over their mean; infinite without an upper bound.
    pub(super) fn gap(&self) -> f64 {
        if self.upper.is_infinite() {
            return f64::INFINITY;
        }
        2.0 * (self.upper - self.lower) / (self.upper + self.lower)
    }

    /// Whether it is not proven on which side of one the multiplier is.
    pub(super) fn is_open(&self) -> bool {
        self.lower < 1.0 && self.upper >= 1.0
    }

    /// Logarithmic distance of the bounds.
    fn width(&self) -> f64 {
        (self.upper / self.lower).ln()
    }
}

/// What the factor of safety may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Guess {
    /// Within a few parts in ten.
    Rough(f64),
    /// Exactly, unless the soil fails in another way.
    Good(f64),
}

impl Guess {
    pub(super) fn factor(self) -> f64 {
        match self {
            Self::Rough(factor) | Self::Good(factor) => factor,
        }
    }
}

/// What is known so far.
#[derive(Debug, Clone)]
pub(super) struct Search {
    pub(super) trials: Vec<Trial>,
    /// Greatest factor at which the soil stands, least at which it does not.
    pub(super) stands: Option<f64>,
    pub(super) fails: Option<f64>,
    /// Relative gap between the two that is asked for.
    max_gap: f64,
    /// Relative gap of the multiplier for the next trial.
    pub(super) trial_gap: f64,
    /// Whether trials cannot get sharper.
    pub(super) is_finest: bool,
    /// A guess of the factor of safety.
    guess: Option<Guess>,
}

impl Search {
    pub(super) fn new(max_gap: f64, guess: Option<Guess>) -> Self {
        let trial_gap = SHARP * max_gap;
        Self { trials: Vec::new(), stands: None, fails: None, max_gap, trial_gap, is_finest: false, guess }
    }

    /// Next to the guess, on the side that is not proven; no more once a trial has told where the limit is.
    fn guessed(&self) -> Option<f64> {
        let guess = self.guess.filter(|_| !self.is_told())?;
        let next = match (guess, self.trials.len()) {
            (Guess::Rough(factor), 0) => Some(factor),
            (Guess::Rough(factor), tried) => self.reached(factor, tried - 1),
            (Guess::Good(factor), 0) => Some(factor * (1.0 - BESIDE * self.max_gap)),
            (Guess::Good(factor), 1) => Some(factor * (1.0 + BESIDE * self.max_gap)),
            (Guess::Good(factor), tried) => self.reached(factor, tried - 2),
        };
        // The same again would be left as open as it was.
        next.filter(|factor| self.trials.iter().all(|trial| trial.factor != *factor))
    }

    /// Away from the guess, until there is a factor on either side: the farther the more were tried.
    fn reached(&self, guess: f64, tried: usize) -> Option<f64> {
        let steps = REACH.powi(1 << tried.min(4));
        match (self.stands, self.fails) {
            (None, fails) => Some(fails.map_or(guess, |f| f.min(guess)) / steps),
            (Some(stands), None) => Some(stands.max(guess) * steps),
            (Some(_), Some(_)) => None,
        }
    }

    /// Factors that are not known to be on one side.
    fn open(&self) -> impl Iterator<Item = f64> {
        self.trials.iter().filter(|t| t.is_open()).map(|t| t.factor)
    }

    /// The middle of the larger part that is left between what is proven and the factors left open; nothing if that is too small to
    /// matter.
    fn halved(&self, low: f64, high: f64) -> Option<f64> {
        let between = |f: &f64| *f > low && *f < high;
        let first = self.open().filter(between).fold(f64::INFINITY, f64::min);
        let last = self.open().filter(between).fold(0.0, f64::max);
        if first > last {
            return Some((low * high).sqrt());
        }
        let (below, above) = (first / low, high / last);
        let middle = if below > above { (low * first).sqrt() } else { (last * high).sqrt() };
        (below.max(above) > 1.0 + LEAST_PART * self.max_gap).then_some(middle)
    }

    /// Takes note of a trial.
    pub(super) fn add(&mut self, trial: Trial) {
        if trial.lower >= 1.0 {
            self.stands_at(trial.factor);
        }
        if trial.upper < 1.0 {
            self.fails = Some(self.fails.map_or(trial.factor, |f| f.min(trial.factor)));
        }
        self.trials.push(trial);
    }

    /// Takes note of a factor at which the soil stands by the stresses of a trial at a greater one.
    pub(super) fn stands_at(&mut self, factor: f64) {
        self.stands = Some(self.stands.map_or(factor, |f| f.max(factor)));
    }

    /// Whether both bounds of a trial are close to one.
    fn is_told(&self) -> bool {
        let is_close = |bound: f64| bound > 0.0 && bound.ln().abs() <= TOLD;
        self.trials.iter().any(|trial| is_close(trial.lower) && is_close(trial.upper))
    }

    /// Whether a factor was left open, or the proven ones on both sides of the limit are next to each other.
    pub(super) fn is_near(&self) -> bool {
        self.open().next().is_some()
            || self.stands.zip(self.fails).is_some_and(|(stands, fails)| (fails / stands).ln() < ALIKE)
    }

    /// Relative distance of what is proven.
    pub(super) fn gap(&self) -> Option<f64> {
        self.gap_with(f64::NAN, None, None)
    }

    /// The same with the bounds of a trial that is not over.
    pub(super) fn gap_with(&self, factor: f64, lower: Option<f64>, upper: Option<f64>) -> Option<f64> {
        let stands = lower.filter(|lower| *lower >= 1.0).map(|_| factor);
        let fails = upper.filter(|upper| *upper < 1.0).map(|_| factor);
        let low = self.stands.into_iter().chain(stands).reduce(f64::max)?;
        let high = self.fails.into_iter().chain(fails).reduce(f64::min)?;
        Some(2.0 * (high - low) / (high + low))
    }

    pub(super) fn is_done(&self) -> bool {
        self.gap().is_some_and(|gap| gap <= self.max_gap)
    }

    /// The factor to try next. Sharpens the trials when they have shown all they can at their gap; none is left if that
    /// cannot be.
    pub(super) fn next(&mut self) -> Option<f64> {
        if let Some(guess) = self.guessed() {
            return Some(guess);
        }
        let Some(last) = self.trials.last().copied() else { return Some(1.0) };
        let slope = self.slope();
        let spare = SPARE * self.max_gap;
        // Towards the root of a bound: from the trial where it is next to one; at the end, of those that are about as sharp
        // as any near one.
        let root = |of: fn(&Trial) -> f64, beyond: f64| {
            let far = |t: &Trial| of(t).ln().abs();
            let known = || self.trials.iter().filter(|t| of(t).is_finite() && of(t) > 0.0);
            let nearest = known().map(far).fold(f64::INFINITY, f64::min);
            let near =
                || known().filter(|t| far(t) <= if self.is_finest { nearest.max(NEAR) } else { nearest });
            let sharpest = near().map(Trial::width).fold(f64::INFINITY, f64::min);
            let best =
                near().filter(|t| t.width() <= 2.0 * sharpest).min_by(|a, b| far(a).total_cmp(&far(b)));
            best.map(|t| t.factor * of(t).powf(1.0 / slope).clamp(1.0 / STEP, STEP) * beyond)
        };
        let stands = root(|t| t.lower, 1.0 - spare).unwrap_or(last.factor / STEP);
        let fails = root(|t| t.upper, 1.0 + spare).unwrap_or(last.factor * STEP);
        // Where any weight is borne, the soil is too strong, though that proves nothing.
        let strong =
            self.trials.iter().filter(|t| t.upper.is_infinite()).map(|t| t.factor).fold(0.0, f64::max);
        let low = self.stands.unwrap_or(0.0).max(strong);
        let high = self.fails.unwrap_or(f64::INFINITY);
        // One bound alone tells the side of the root, not how far it is.
        let is_one_sided = !(last.upper.is_finite() && last.lower > 0.0);
        let stands_at = self.stands.unwrap_or(0.0);
        if is_one_sided && stands_at > 0.0 && high.is_finite() && high / stands_at > 1.0 + self.max_gap {
            return self.halved(stands_at, high);
        }
        if low > 0.0 && high.is_finite() && high / low > 1.0 + FAR * self.max_gap && !self.is_told() {
            return self.halved(low, high);
        }
        // What each of the two would gain.
        let gains = [
            if self.stands.is_none() { f64::INFINITY } else { stands.min(high) / low - 1.0 },
            if self.fails.is_none() { f64::INFINITY } else { 1.0 - fails.max(low) / high },
        ];
        if gains[0].max(gains[1]) < 0.1 * self.max_gap {
            if self.is_finest {
                return None;
            }
            self.trial_gap *= SHARPER;
            // The middle, sharply, tells where both roots are.
            return Some((low * high).sqrt());
        }
        let next = if gains[0] >= gains[1] { stands } else { fails };
        let is_new = self.open().all(|f| (next / f - 1.0).abs() > SPARE * self.max_gap);
        if !is_new && low > 0.0 && high.is_finite() {
            return self.halved(low, high);
        }
        let inside = next > low && next < high;
        Some(match (inside, low > 0.0, high.is_finite()) {
            (true, _, _) => next,
            (false, true, true) => (low * high).sqrt(),
            (false, true, false) => low * 2.0,
            (false, false, _) => high / 2.0,
        })
    }

    /// How fast the multiplier falls: the power of the factor, from the two trials nearest to the root.
    fn slope(&self) -> f64 {
        let middle = |t: &Trial| (t.lower * t.upper).sqrt();
        let mut known: Vec<&Trial> =
            self.trials.iter().filter(|t| middle(t).is_finite() && middle(t) > 0.0).collect();
        known.sort_by(|a, b| middle(a).ln().abs().total_cmp(&middle(b).ln().abs()));
        let slope = |a: &Trial, b: &Trial| -(middle(b) / middle(a)).ln() / (b.factor / a.factor).ln();
        let far_apart = |a: &Trial, b: &Trial| (b.factor / a.factor).ln().abs() > 1e-3;
        let pair =
            known.first().and_then(|a| known[1..].iter().find(|b| far_apart(a, b)).map(|b| slope(a, b)));
        pair.filter(|s| s.is_finite()).map_or(1.0, |s| s.clamp(0.5, 20.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs a search on a multiplier that is known, with bounds as wide as asked for.
    fn run(max_gap: f64, multiplier: impl Fn(f64) -> f64) -> (Search, usize) {
        let mut search = Search::new(max_gap, None);
        for trials in 0..60 {
            if search.is_done() {
                return (search, trials);
            }
            let factor = search.next().unwrap();
            let (m, half) = (multiplier(factor), 0.5 * search.trial_gap);
            search.add(Trial { factor, lower: m * (1.0 - half), upper: m * (1.0 + half) });
        }
        panic!("no end: {search:?}");
    }

    #[test]
    fn the_root_is_enclosed_in_few_trials() {
        for power in [1.0, 2.0, 6.0] {
            for root in [0.05, 0.7, 1.0, 1.3, 40.0] {
                for max_gap in [0.1, 0.01] {
                    let (search, trials) = run(max_gap, |f: f64| (root / f).powf(power));
                    assert!(search.stands.unwrap() <= root && root <= search.fails.unwrap());
                    assert!(trials <= 16, "{power} {root} {max_gap}: {trials}");
                }
            }
        }
    }

    #[test]
    fn the_limit_is_near_once_a_factor_is_open_or_both_sides_are_alike() {
        let trial = |factor, lower, upper| Trial { factor, lower, upper };
        let near = |trials: &[Trial]| {
            let mut search = Search::new(0.01, None);
            trials.iter().for_each(|trial| search.add(*trial));
            search.is_near()
        };
        let (stands, falls) = (trial(1.0, 1.3, 1.4), trial(2.0, 0.6, 0.7));
        assert!(!near(&[]) && !near(&[stands]) && !near(&[stands, falls]));
        assert!(near(&[stands, falls, trial(1.3, 0.99, 1.01)]));
        assert!(near(&[stands, trial(1.08, 0.9, 0.95)]));
    }

    #[test]
    fn soil_that_bears_any_weight_is_weakened_until_it_does_not() {
        // Cohesion and friction: flatter than the friction angle, any weight is borne.
        let multiplier = |f: f64| if f < 1.5 { f64::INFINITY } else { 0.5 / (f - 1.5) };
        let (search, trials) = run(0.02, multiplier);
        assert!(search.stands.unwrap() <= 2.0 && 2.0 <= search.fails.unwrap());
        assert!(trials <= 25, "{trials}");
    }

    #[test]
    fn a_multiplier_without_end_leads_to_weaker_soil_though_it_proves_nothing() {
        let mut search = Search::new(0.1, None);
        search.add(Trial { factor: 1.0, lower: 0.0, upper: f64::INFINITY });
        assert!(search.next().unwrap() > 1.0);
    }

    #[test]
    fn bounds_that_get_no_sharper_are_used_up() {
        let mut search = Search::new(0.01, None);
        let mut trials = 0;
        while let Some(factor) = search.next() {
            // As close as 3 % and no closer, from the first trial that asks for more on.
            search.is_finest |= search.trial_gap < 0.03;
            let (m, half) = (1.7 / factor, 0.5 * search.trial_gap.max(0.03));
            search.add(Trial { factor, lower: m * (1.0 - half), upper: m * (1.0 + half) });
            trials += 1;
        }
        assert!(trials < 20 && search.gap().unwrap() < 0.035, "{trials}: {search:?}");
    }
}
