//! From a push to a stroke: its samples beside the tare, evaluated, with what the tare adds to its uncertainty.

use nalgebra::Vector3;

use super::air::{AirModel, Tare};
use super::push::Push;
use super::survey::Survey;
use super::trust::{Doubt, Stops, gap};
use crate::log::{LogStroke, NoStroke};
use crate::robot::{Robot, RobotSample};
use crate::{Outcome, Recorded, Setting, evaluate};
use soilctl_motion::{Columns, Joints};

/// A tare more uncertain than this share of the force is doubtful; one more uncertain than the second refuses the stroke.
const DOUBTFUL_TARE: f64 = 0.03;
const HOPELESS_TARE: f64 = 0.15;
/// The tare is worked out at so many times of a stroke, and is linear between them.
const TARES: usize = 20;
/// Fewest samples from the begin of the push to the failure.
const FEWEST_SAMPLES: usize = 20;

/// What strokes of a log share.
pub(crate) struct Weigher<'a> {
    pub(crate) columns: &'a Columns,
    pub(crate) joints: Joints<'a>,
    pub(crate) robot: &'a Robot,
    pub(crate) survey: &'a Survey,
    pub(crate) air: &'a AirModel,
    pub(crate) stops: Stops,
    pub(crate) setting: &'a Setting,
    /// Times at which a clock was set, in s.
    pub(crate) clock_set_s: Vec<f64>,
}

impl Weigher<'_> {
    /// Weighs a push.
    pub(crate) fn stroke(&self, push: &Push) -> Result<LogStroke, NoStroke> {
        let blocks = &self.survey.blocks[push.blocks.clone()];
        let (Some(first), Some(last)) = (blocks.first(), blocks.last()) else {
            return Err(NoStroke {
                from_s: 0.0,
                to_s: 0.0,
                reason: "it has no samples".into(),
                refused: true,
            });
        };
        let (from_s, to_s) = (first.t_s, last.t_s);
        let refused = |reason: String| NoStroke { from_s, to_s, reason, refused: true };
        // The last block may reach into the rest or the pull-out.
        let samples = self.samples(first.samples.start, last.samples.start);
        let recorded = Recorded { samples, direction: push.direction, tare_before: None, tare_after: None };
        let mut evaluated =
            evaluate(&recorded, self.setting).map_err(|problem| refused(problem.to_string()))?;
        let mut doubts = Vec::new();
        let fail_s = match &evaluated.analysis.outcome {
            Outcome::Found(point) => point.time_s,
            Outcome::Indiscernible(_) => to_s,
        };
        let raw = &self.columns.wrenches;
        let within = |t_s: f64| raw.t_s.partition_point(|t| *t < t_s);
        let (moves, fails) = (within(push.moves_s), within(fail_s + 0.05).min(raw.values.len()));
        let risen = raw.values.get(moves.min(fails)..fails).unwrap_or_default();
        if self.stops.hit(risen) {
            doubts.push(Doubt::Clipped);
        }
        if gap(self.survey, push.moves_s, fail_s).is_some() || self.posture_missing(push, fail_s) {
            doubts.push(Doubt::Gap);
        }
        if self.clock_set_s.iter().any(|t_s| (from_s..=to_s).contains(t_s)) {
            doubts.push(Doubt::Clock);
        }
        let found = matches!(evaluated.analysis.outcome, Outcome::Found(_));
        if doubts.contains(&Doubt::Clipped) {
            return Err(refused(
                "the sensor's readings stand still at the end of their range while the force rises, so the force was higher than \
                 it could tell; use a sensor of a larger range or a smaller plate"
                    .into(),
            ));
        }
        if found && risen.len() < FEWEST_SAMPLES {
            return Err(refused(format!(
                "only {} wrenches lie between the begin of the push and the failure, at least {FEWEST_SAMPLES} are needed; record \
                 faster or pull more slowly",
                risen.len()
            )));
        }
        if let Some(reason) = self.pushes_ahead(&recorded, push) {
            return Err(refused(reason));
        }
        if found {
            self.add_tare(&mut evaluated, &recorded, fail_s, &mut doubts).map_err(refused)?;
        }
        let flags = doubts.into_iter().map(Doubt::name).collect();
        Ok(LogStroke { evaluated, course: None, finish: None, flags, start_s: from_s, end_s: to_s })
    }

    /// Samples of wrenches `from..to`, beside the tare.
    fn samples(&self, from: usize, to: usize) -> Vec<RobotSample> {
        let raw = &self.columns.wrenches;
        let mut joints = self.joints.starting(raw.t_s.get(from).copied().unwrap_or_default());
        let mut samples: Vec<RobotSample> = Vec::with_capacity(to - from);
        for k in from..to {
            let (t_s, wrench) = (raw.t_s[k], raw.values[k]);
            if let Some(positions) = joints.at(t_s)
                && let Ok(sample) = self.robot.sample(t_s, positions, wrench)
            {
                samples.push(sample);
            }
        }
        let Some(begin) = samples.first().map(gravity) else { return samples };
        let step = samples.len().div_ceil(TARES).max(1);
        let at = |sample: &RobotSample| self.air.tare(sample.t_s, gravity(sample), begin).wrench;
        let knots: Vec<[f64; 6]> = samples.iter().step_by(step).chain(samples.last()).map(at).collect();
        let last = samples.len() - 1;
        for (k, sample) in samples.iter_mut().enumerate() {
            let (low, high) = (k / step, (k / step + 1).min(knots.len() - 1));
            let (from, to) = (low * step, (low * step + step).min(last));
            let share = if to > from { (k - from) as f64 / (to - from) as f64 } else { 0.0 };
            for (i, part) in sample.wrench.iter_mut().enumerate() {
                *part -= knots[low][i] + share * (knots[high][i] - knots[low][i]);
            }
        }
        samples
    }

    /// Whether joint states are missing while the force rises.
    fn posture_missing(&self, push: &Push, fail_s: f64) -> bool {
        let rising = self.survey.within(push.moves_s, fail_s);
        self.survey.blocks[rising].iter().any(|block| block.posture.is_none())
    }

    /// Soil can only push back.
    fn pushes_ahead(&self, recorded: &Recorded, push: &Push) -> Option<String> {
        let [dx, dy] = push.direction;
        let moving = recorded.samples.iter().filter(|sample| sample.t_s >= push.moves_s);
        let along: Vec<f64> =
            moving.map(|sample| sample.force_n()).map(|force| force[0] * dx + force[1] * dy).collect();
        let half = &along[along.len() / 2..];
        let mean = half.iter().sum::<f64>() / half.len().max(1) as f64;
        let sd = self.air.told.noise.map_or(0.0, |noise| noise.force_n());
        (mean > sd.max(1e-9)).then(|| {
            format!(
                "the force pushes the plate ahead, by {mean:.2} N in the mean of the second half of its way, which soil cannot do: the \
                 wrench is that of the plate on the soil (--wrench-sense plate-on-soil), or the sensor's frame is not that of its wrenches \
                 (--sensor-frame)"
            )
        })
    }

    /// Adds what the tare is uncertain by to the force's standard deviation.
    fn add_tare(
        &self,
        evaluated: &mut crate::Evaluated,
        recorded: &Recorded,
        fail_s: f64,
        doubts: &mut Vec<Doubt>,
    ) -> Result<(), String> {
        let (Some(at), Some(first)) =
            (recorded.samples.iter().rev().find(|s| s.t_s <= fail_s), recorded.samples.first())
        else {
            return Ok(());
        };
        let tare = self.air.tare(at.t_s, gravity(at), gravity(first));
        let force = Vector3::new(at.wrench[0], at.wrench[1], at.wrench[2]);
        let unit = force / force.norm().max(f64::MIN_POSITIVE);
        let sd = |of: nalgebra::Matrix3<f64>| (unit.transpose() * of * unit)[(0, 0)].max(0.0).sqrt();
        let (sd_n, weight_sd_n) = (sd(tare.covariance), sd(tare.of_weight));
        let row = &mut evaluated.row;
        if sd_n > HOPELESS_TARE * row.force_n {
            return Err(format!(
                "the tare at its time and posture is known to {sd_n:.2} N only, for a force of {:.2} N{}; record free air before and \
                 after each stroke, in its posture",
                row.force_n,
                if self.air.is_given() && weight_sd_n <= 0.7 * sd_n {
                    ": --tare lies that far from what free air in the log tells"
                } else if weight_sd_n > 0.7 * sd_n {
                    ": the weight that the sensor carries cannot be told from its bias, since all free air has one posture \
                     (give --tool-weight)"
                } else {
                    ""
                }
            ));
        }
        if sd_n > DOUBTFUL_TARE * row.force_n {
            doubts.push(if weight_sd_n > 0.7 * sd_n { Doubt::Posture } else { Doubt::Tare });
        }
        row.force_sd_n = row.force_sd_n.map(|own| own.hypot(sd_n));
        self.tares(row, at, recorded);
        Ok(())
    }

    /// What the tare amounts to along the force, before and after: the columns of the stroke table.
    fn tares(&self, row: &mut soilctl_strokes::StrokeRow, at: &RobotSample, recorded: &Recorded) {
        let (Some(first), Some(last)) = (recorded.samples.first(), recorded.samples.last()) else { return };
        let [dx, dy] = recorded.direction;
        let force = at.force_n();
        let along = force[0] * dx + force[1] * dy;
        let size = along.hypot(force[2]);
        let share = |sample: &RobotSample| {
            let Tare { wrench, .. } = self.air.tare(sample.t_s, gravity(sample), gravity(first));
            let tare = at.turned([wrench[0], wrench[1], wrench[2]]);
            ((tare[0] * dx + tare[1] * dy) * along + tare[2] * force[2]) / size
        };
        if size > 0.0 {
            row.tare_before_n = Some(share(first));
            row.tare_after_n = Some(share(last));
        }
    }
}

/// Where gravity points to in the sensor's frame.
fn gravity(sample: &RobotSample) -> [f64; 3] {
    sample.to_root[2].map(|part| -part)
}
