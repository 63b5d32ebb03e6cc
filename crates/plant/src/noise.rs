use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Normal deviates from a seed: the same bits on every machine.
#[derive(Debug, Clone)]
pub(crate) struct Noise {
    generator: Pcg64Mcg,
    spare: Option<f64>,
}

impl Noise {
    pub(crate) fn new(seed: u64) -> Self {
        Self { generator: Pcg64Mcg::seed_from_u64(seed), spare: None }
    }

    /// A deviate of mean 0 and standard deviation 1 (Box and Muller 1958).
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        let radius = (-2.0 * libm::log(1.0 - self.uniform())).sqrt();
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * self.uniform());
        self.spare = Some(radius * sin);
        radius * cos
    }

    /// Evenly between 0 and 1, 1 excluded.
    fn uniform(&mut self) -> f64 {
        #[allow(clippy::cast_precision_loss, reason = "53 bits fit")]
        let bits = (self.generator.next_u64() >> 11) as f64;
        bits / 9_007_199_254_740_992.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moments of 200 000 deviates, within five of their own standard deviations.
    #[test]
    fn deviates_are_normal() {
        let mut noise = Noise::new(1);
        let deviates: Vec<f64> = (0..200_000).map(|_| noise.normal()).collect();
        let count = 200_000.0_f64;
        let moment = |n: i32| deviates.iter().map(|x| x.powi(n)).sum::<f64>() / count;
        for (n, expected, variance) in [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
            let error = (moment(n) - expected).abs();
            assert!(error < 5.0 * (variance / count).sqrt(), "moment {n} is off by {error}");
        }
        let within = deviates.iter().filter(|x| x.abs() < 1.0).count();
        assert!((within as f64 / count - 0.682_689).abs() < 5.0 * (0.2166 / count).sqrt());
    }

    #[test]
    fn a_seed_repeats_and_another_differs() {
        let first = |seed| Noise::new(seed).normal().to_bits();
        assert_eq!(first(7), first(7));
        assert_ne!(first(7), first(8));
    }
}
