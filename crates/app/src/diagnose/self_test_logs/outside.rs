//! What a campaign of logs may hide that no effect of the catalogue is: terms of the conditions of its strokes.

use soilctl_diagnosis::self_test::Random;
use soilctl_effects::{Covariate, EmpiricalTerm};

use super::design::{ALPHAS_DEG, DEPTHS_M, Design};

/// Change of ln force where such a term is largest: the sizes of effects that a campaign can show.
const SIZES: [f64; 2] = [0.12, 0.3];
/// Length of a wave over the base angle, deg.
const WAVE_DEG: f64 = 40.0;
/// How near to a step its points lie, relative.
const STEEP: f64 = 1e-3;

/// A kind of term.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outside {
    /// The middle tool angle differs.
    AngleBump,
    /// Strokes deeper than the shallowest ones differ.
    DepthStep,
    /// The force waves over the base angle.
    BaseWave,
    /// Every other stroke of a preparation differs.
    EveryOther,
    /// The deepest strokes at the largest tool angle differ.
    Corner,
    /// One preparation differs.
    OddPreparation,
}

impl Outside {
    /// All of them, in the order in which they are hidden.
    pub(super) const ALL: [Self; 6] = [
        Self::AngleBump,
        Self::EveryOther,
        Self::DepthStep,
        Self::OddPreparation,
        Self::BaseWave,
        Self::Corner,
    ];

    /// Name in answers.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::AngleBump => "outside_angle_bump",
            Self::DepthStep => "outside_depth_step",
            Self::BaseWave => "outside_base_wave",
            Self::EveryOther => "outside_every_other",
            Self::Corner => "outside_corner",
            Self::OddPreparation => "outside_odd_preparation",
        }
    }

    /// The conditions that it is over.
    pub(super) const fn over(self) -> &'static [Covariate] {
        match self {
            Self::AngleBump => &[Covariate::ToolAngle],
            Self::DepthStep => &[Covariate::Depth],
            Self::BaseWave => &[Covariate::BaseAngle],
            Self::EveryOther => &[Covariate::Order],
            Self::Corner => &[Covariate::ToolAngle, Covariate::Depth],
            Self::OddPreparation => &[Covariate::Batch],
        }
    }

    /// Change of ln force, of either sign.
    pub(super) fn size(random: &mut Random) -> f64 {
        random.sign() * random.between(SIZES[0], SIZES[1])
    }

    /// The term of a size in the strokes of a design.
    pub(super) fn term(self, size: f64, design: Design, random: &mut Random) -> EmpiricalTerm {
        let count = |n: usize| (0..n).map(|i| i as f64).collect::<Vec<f64>>();
        let steps = |of: &[f64]| of.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect::<Vec<f64>>();
        let around = |edge: f64| [(1.0 - STEEP) * edge, (1.0 + STEEP) * edge];
        let (at, ln_force) = match self {
            Self::AngleBump => (vec![ALPHAS_DEG.to_vec()], vec![0.0, size, 0.0]),
            Self::DepthStep => {
                let [below, above] = around(steps(&DEPTHS_M)[0]);
                (vec![vec![below, above]], vec![0.0, size])
            }
            Self::BaseWave => {
                let at: Vec<f64> = (-40..=40).map(f64::from).collect();
                let wave = |deg: &f64| size * (std::f64::consts::TAU * deg / WAVE_DEG).sin();
                let ln_force = at.iter().map(wave).collect();
                (vec![at], ln_force)
            }
            Self::EveryOther => {
                let at = count(design.strokes() + 1);
                let ln_force = at.iter().map(|order| if order % 2.0 == 0.0 { size } else { 0.0 }).collect();
                (vec![at], ln_force)
            }
            Self::Corner => {
                let [low, high] = around(steps(&ALPHAS_DEG)[1]);
                let [shallow, deep] = around(steps(&DEPTHS_M)[1]);
                (vec![vec![low, high], vec![shallow, deep]], vec![0.0, 0.0, 0.0, size])
            }
            Self::OddPreparation => {
                let odd = random.choice(&(1..design.batches()).collect::<Vec<usize>>());
                let at = count(design.batches());
                let ln_force = (0..at.len()).map(|batch| if batch == odd { size } else { 0.0 }).collect();
                (vec![at], ln_force)
            }
        };
        let sd = vec![0.0; ln_force.len()];
        EmpiricalTerm { over: self.over().to_vec(), at, ln_force, sd, log_bayes_factor: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// Terms by hand: where each of them is at its largest, and where it is nothing.
    #[test]
    fn terms_are_where_their_names_say() {
        let design = Design::Strokes48;
        let term = |of: Outside| {
            let term = of.term(0.2, design, &mut Random::new(1, 1));
            term.check("a term").unwrap();
            term
        };
        let near = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        let one = |of: Outside, value: f64| term(of).at_values(&|_| Some(value));
        for (of, value, wanted) in [
            (Outside::AngleBump, 90.0, 0.2),
            (Outside::AngleBump, 100.0, 0.0),
            (Outside::DepthStep, 0.020, 0.0),
            (Outside::DepthStep, 0.029, 0.2),
            (Outside::EveryOther, 3.0, 0.0),
            (Outside::EveryOther, 6.0, 0.2),
            (Outside::BaseWave, 0.0, 0.0),
        ] {
            near(one(of, value), wanted);
        }
        near(one(Outside::BaseWave, 10.0), 0.2);
        near(one(Outside::BaseWave, -10.0), -0.2);
        let corner = |alpha: f64, depth: f64| {
            term(Outside::Corner)
                .at_values(&|of| Some(if of == Covariate::ToolAngle { alpha } else { depth }))
        };
        near(corner(100.0, 0.029), 0.2);
        near(corner(100.0, 0.0254), 0.0);
        near(corner(90.0, 0.029), 0.0);
        let odd = term(Outside::OddPreparation);
        near(odd.ln_force.iter().sum(), 0.2);
        near(odd.ln_force[0], 0.0);
    }
}
