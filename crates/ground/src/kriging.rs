//! Ordinary kriging of intervals, under every covariance that is plausible.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use crate::GroundError;

/// Fewest places that tell anything of what lies between: three distances for two unknowns of the covariance and a mean.
pub const LEAST_SITES: usize = 4;
/// Most places: their work grows with the third power.
pub const MOST_SITES: usize = 200;
/// Half of the 95 % point of chi-square with two degrees of freedom.
const PLAUSIBLE: f64 = 2.996;
/// Lengths that are tried, from half of the least distance to four times the greatest.
const LENGTHS: usize = 12;
/// Standard deviations that are tried, from a tenth to fifteen times that of the middles.
const SILLS: usize = 36;

/// A place with an interval of what was found there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Site {
    /// Along x in m.
    pub x_m: f64,
    /// Along y in m.
    pub y_m: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end, above it.
    pub high: f64,
}

/// An exponential covariance, `sd^2 exp(-distance / length)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variogram {
    /// Its length in m.
    pub length_m: f64,
    /// The standard deviation of the quantity over the ground, in its unit.
    pub sd: f64,
}

/// What is known at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Between {
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Greatest standard deviation of what kriging errs by there; 0 at a place.
    pub sd: f64,
}

/// A quantity over the ground.
#[derive(Debug, Clone)]
pub struct Field {
    sites: Vec<Site>,
    deviations: f64,
    /// For each plausible length the greatest plausible deviation.
    systems: Vec<System>,
    unbounded: bool,
}

/// The kriging system of one length.
#[derive(Debug, Clone)]
struct System {
    variogram: Variogram,
    factor: Cholesky<f64, Dyn>,
    /// What the inverse of the correlations makes of ones, and its sum.
    ones: DVector<f64>,
    total: f64,
}

impl Field {
    /// A field through places. An interval holds its true value, and `deviations`, above 0, is how many standard deviations of what lies
    /// between places an answer reaches.
    ///
    /// # Errors
    /// [`GroundError`] for fewer than [`LEAST_SITES`] or more than [`MOST_SITES`] places, two at one point, or a place that has no interval.
    pub fn new(sites: &[Site], deviations: f64) -> Result<Self, GroundError> {
        check(sites)?;
        let (least, most) = distances(sites)?;
        let lengths = steps(0.5 * least, 4.0 * most, LENGTHS);
        let plausible = plausible(sites, deviations, &lengths);
        let best = plausible.iter().map(|tried| tried.1).fold(f64::NEG_INFINITY, f64::max);
        let mut systems = Vec::new();
        let mut unbounded = false;
        for &length_m in &lengths {
            let of_length =
                plausible.iter().filter(|(v, l)| v.length_m == length_m && *l >= best - PLAUSIBLE);
            let Some(sd) = of_length.map(|(v, _)| v.sd).reduce(f64::max) else { continue };
            let greatest = plausible.iter().map(|(v, _)| v.sd).fold(0.0, f64::max);
            unbounded |= sd >= greatest;
            systems.push(System::new(sites, Variogram { length_m, sd }).ok_or(GroundError::Unsolvable)?);
        }
        if systems.is_empty() {
            return Err(GroundError::Unsolvable);
        }
        Ok(Self { sites: sites.to_vec(), deviations, systems, unbounded })
    }

    /// The covariances that are plausible: for each length the greatest deviation.
    pub fn variograms(&self) -> impl Iterator<Item = Variogram> + '_ {
        self.systems.iter().map(|system| system.variogram)
    }

    /// Whether the greatest deviation that is tried is still plausible, so that the truth may vary more.
    #[must_use]
    pub const fn is_unbounded(&self) -> bool {
        self.unbounded
    }

    /// What is known at a point: the hull over all plausible covariances.
    #[must_use]
    pub fn at(&self, x_m: f64, y_m: f64) -> Between {
        let mut hull = Between { low: f64::INFINITY, high: f64::NEG_INFINITY, sd: 0.0 };
        for system in &self.systems {
            let (weights, variance) = system.weights(&self.sites, x_m, y_m);
            let (mut low, mut high) = (0.0, 0.0);
            for (weight, site) in weights.iter().zip(&self.sites) {
                let ends = [weight * site.low, weight * site.high];
                low += ends[0].min(ends[1]);
                high += ends[0].max(ends[1]);
            }
            let sd = system.variogram.sd * variance.sqrt();
            hull.low = hull.low.min(low - self.deviations * sd);
            hull.high = hull.high.max(high + self.deviations * sd);
            hull.sd = hull.sd.max(sd);
        }
        hull
    }

    /// Greatest standard deviation of what kriging errs by at a point.
    pub(crate) fn sd_at(&self, x_m: f64, y_m: f64) -> f64 {
        let of = |system: &System| system.variogram.sd * system.weights(&self.sites, x_m, y_m).1.sqrt();
        self.systems.iter().map(of).fold(0.0, f64::max)
    }

    /// Mean half width of the intervals.
    pub(crate) fn mean_half_width(&self) -> f64 {
        let halves = self.sites.iter().map(|site| 0.5 * (site.high - site.low));
        halves.sum::<f64>() / self.sites.len() as f64
    }

    /// The same covariances with a further place; `None` if it is at one that there is.
    pub(crate) fn with_place(&self, x_m: f64, y_m: f64) -> Option<Self> {
        let mut sites = self.sites.clone();
        sites.push(Site { x_m, y_m, low: 0.0, high: 1.0 });
        let systems = self.systems.iter().map(|system| System::new(&sites, system.variogram));
        Some(Self { systems: systems.collect::<Option<_>>()?, sites, ..*self })
    }
}

impl System {
    /// `None` if two places are the same to double precision.
    fn new(sites: &[Site], variogram: Variogram) -> Option<Self> {
        let factor = Cholesky::new(correlations(sites, variogram.length_m))?;
        let ones = factor.solve(&DVector::from_element(sites.len(), 1.0));
        let total = ones.sum();
        (total.is_finite() && total > 0.0).then_some(Self { variogram, factor, ones, total })
    }

    /// Weights of the places, which sum to 1, and the variance of the error over that of the field.
    fn weights(&self, sites: &[Site], x_m: f64, y_m: f64) -> (DVector<f64>, f64) {
        let to =
            |site: &Site| correlation(libm::hypot(site.x_m - x_m, site.y_m - y_m), self.variogram.length_m);
        let right = DVector::from_iterator(sites.len(), sites.iter().map(to));
        let simple = self.factor.solve(&right);
        let left = 1.0 - simple.sum();
        let variance = 1.0 - right.dot(&simple) + left * left / self.total;
        (simple + &self.ones * (left / self.total), variance.max(0.0))
    }
}

fn correlation(distance_m: f64, length_m: f64) -> f64 {
    libm::exp(-distance_m / length_m)
}

fn correlations(sites: &[Site], length_m: f64) -> DMatrix<f64> {
    let n = sites.len();
    DMatrix::from_fn(n, n, |i, j| {
        let (a, b) = (&sites[i], &sites[j]);
        correlation(libm::hypot(a.x_m - b.x_m, a.y_m - b.y_m), length_m)
    })
}

/// Covariances that are tried, each with the logarithm of its restricted likelihood.
fn plausible(sites: &[Site], deviations: f64, lengths: &[f64]) -> Vec<(Variogram, f64)> {
    let n = sites.len() as f64;
    let middles = DVector::from_iterator(sites.len(), sites.iter().map(|site| 0.5 * (site.low + site.high)));
    let noise: Vec<f64> = sites.iter().map(|site| 0.5 * (site.high - site.low) / deviations).collect();
    let mean = middles.sum() / n;
    let spread = (middles.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let typical = (noise.iter().map(|x| x * x).sum::<f64>() / n).sqrt();
    let base = spread.max(typical);
    let mut tried = Vec::new();
    for &length_m in lengths {
        let correlations = correlations(sites, length_m);
        for sd in steps(0.1 * base, 15.0 * base, SILLS) {
            let mut covariance = &correlations * (sd * sd);
            for (i, tau) in noise.iter().enumerate() {
                covariance[(i, i)] += tau * tau;
            }
            if let Some(log) = restricted_likelihood(covariance, &middles) {
                tried.push((Variogram { length_m, sd }, log));
            }
        }
    }
    tried
}

/// Logarithm of the likelihood of what values say beside their unknown mean; `None` if the covariance is none.
fn restricted_likelihood(covariance: DMatrix<f64>, values: &DVector<f64>) -> Option<f64> {
    let factor = Cholesky::new(covariance)?;
    let ones = DVector::from_element(values.len(), 1.0);
    let solved = factor.solve(&ones);
    let total = solved.sum();
    let mean = solved.dot(values) / total;
    let off = values.add_scalar(-mean);
    let square = off.dot(&factor.solve(&off));
    let determinant: f64 = factor.l_dirty().diagonal().iter().map(|x| libm::log(*x)).sum();
    let log = -determinant - 0.5 * libm::log(total) - 0.5 * square;
    log.is_finite().then_some(log)
}

/// Numbers from one to another in equal ratios.
fn steps(low: f64, high: f64, count: usize) -> Vec<f64> {
    let ratio = libm::log(high / low) / (count - 1) as f64;
    (0..count).map(|i| low * libm::exp(ratio * i as f64)).collect()
}

fn check(sites: &[Site]) -> Result<(), GroundError> {
    if !(LEAST_SITES..=MOST_SITES).contains(&sites.len()) {
        return Err(GroundError::Count { count: sites.len(), least: LEAST_SITES, most: MOST_SITES });
    }
    for &Site { x_m, y_m, low, high } in sites {
        if !([x_m, y_m, low, high].iter().all(|value| value.is_finite()) && low < high) {
            return Err(GroundError::BadSite { x_m, y_m, low, high });
        }
    }
    Ok(())
}

/// Least and greatest distance of two places.
fn distances(sites: &[Site]) -> Result<(f64, f64), GroundError> {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    let mut closest = (0.0, 0.0);
    for (i, a) in sites.iter().enumerate() {
        for b in &sites[..i] {
            let distance = libm::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
            if distance < least {
                (least, closest) = (distance, (a.x_m, a.y_m));
            }
            most = most.max(distance);
        }
    }
    // Nearer ones would leave too few digits.
    if least <= 1e-6 * most || most == 0.0 {
        return Err(GroundError::SamePoint { x_m: closest.0, y_m: closest.1 });
    }
    Ok((least, most))
}

#[cfg(test)]
mod tests;
