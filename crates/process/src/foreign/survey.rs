//! A whole log at a glance: means over some hundredths of a second, with the posture of the arm.

use std::ops::Range;

use soilctl_stats::median;

use super::columns::{Columns, Series};
use crate::robot::{Robot, RobotSample};

/// Time that a block spans in s, or one sample where they come more slowly.
pub(crate) const BLOCK_S: f64 = 0.02;
/// Joint states further apart than this, and than three usual intervals, are not interpolated, in s.
const MOST_GAP_S: f64 = 0.25;
/// A joint that moved by less than this across a gap stood still, in rad or m.
const STILL: f64 = 1e-5;
/// Wrenches further apart than so many usual intervals have a gap between them.
const GAP_INTERVALS: f64 = 5.0;

/// Neighbouring wrenches, averaged.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Block {
    /// Middle of its times in s.
    pub(crate) t_s: f64,
    /// Mean force in N and torque in N m.
    pub(crate) wrench: [f64; 6],
    /// Wrenches in it.
    pub(crate) samples: Range<usize>,
    /// Where the arm was, with the mean wrench; `None` without joint states around it.
    pub(crate) posture: Option<RobotSample>,
    /// Where gravity points to in the sensor's frame; known without joint states where no joint turns the sensor.
    pub(crate) gravity: Option<[f64; 3]>,
}

/// The blocks of a log.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Survey {
    pub(crate) blocks: Vec<Block>,
    /// Usual time between two wrenches in s.
    pub(crate) interval_s: f64,
    /// Wrenches a block.
    pub(crate) per_block: usize,
    /// Times from and to which no wrench came, in s.
    pub(crate) gaps: Vec<[f64; 2]>,
}

impl Survey {
    pub(crate) fn of(columns: &Columns, robot: &Robot) -> Self {
        let Series { t_s, values } = &columns.wrenches;
        let interval_s = usual_interval(t_s);
        let most_s = GAP_INTERVALS * interval_s;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 1 to some thousands"
        )]
        let per_block = (BLOCK_S / interval_s.max(1e-6)).round().clamp(1.0, 1e5) as usize;
        let mut joints = Joints::new(&columns.joints);
        let still = robot.fixed_turn();
        let mut survey = Self { interval_s, per_block, ..Self::default() };
        let mut from = 0;
        while from < t_s.len() {
            let most = (from + per_block).min(t_s.len());
            let cut = (from + 1..most).find(|k| t_s[*k] - t_s[*k - 1] > most_s);
            let to = cut.unwrap_or(most);
            if let Some(next) = t_s.get(to)
                && next - t_s[to - 1] > most_s
            {
                survey.gaps.push([t_s[to - 1], *next]);
            }
            let count = (to - from) as f64;
            let middle_s = t_s[from..to].iter().sum::<f64>() / count;
            let wrench = std::array::from_fn(|i| values[from..to].iter().map(|w| w[i]).sum::<f64>() / count);
            let posture =
                joints.at(middle_s).and_then(|positions| robot.sample(middle_s, positions, wrench).ok());
            let turn = posture.map(|sample| sample.to_root).or(still);
            let gravity = turn.map(|turn| turn[2].map(|part| -part));
            survey.blocks.push(Block { t_s: middle_s, wrench, samples: from..to, posture, gravity });
            from = to;
        }
        survey
    }

    /// Blocks whose times lie in a span.
    pub(crate) fn within(&self, from_s: f64, to_s: f64) -> Range<usize> {
        let first = self.blocks.partition_point(|block| block.t_s < from_s);
        let last = self.blocks.partition_point(|block| block.t_s <= to_s);
        first..last.max(first)
    }
}

/// Median of the steps between times; 0 of fewer than two.
pub(crate) fn usual_interval(t_s: &[f64]) -> f64 {
    let mut steps: Vec<f64> = t_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    median(&mut steps)
}

/// Positions of all joints at rising times.
#[derive(Debug, Clone)]
pub(crate) struct Joints<'a> {
    series: &'a [Series<f64>],
    most_gap_s: Vec<f64>,
    /// The last value of each at or before the present time.
    places: Vec<usize>,
    positions: Vec<f64>,
}

impl<'a> Joints<'a> {
    pub(crate) fn new(series: &'a [Series<f64>]) -> Self {
        let most_gap_s = series.iter().map(|s| MOST_GAP_S.max(3.0 * usual_interval(&s.t_s))).collect();
        let (places, positions) = (vec![0; series.len()], vec![0.0; series.len()]);
        Self { series, most_gap_s, places, positions }
    }

    /// The same from a time on.
    pub(crate) fn starting(&self, t_s: f64) -> Self {
        let mut started = self.clone();
        for (place, series) in started.places.iter_mut().zip(self.series) {
            *place = series.t_s.partition_point(|known| *known <= t_s).saturating_sub(1);
        }
        started
    }

    /// Linear between neighbours; `None` before the first of any joint, after the last, or in a gap in which it moved. Times must
    /// not fall from call to call.
    pub(crate) fn at(&mut self, t_s: f64) -> Option<&[f64]> {
        for (number, series) in self.series.iter().enumerate() {
            let place = &mut self.places[number];
            while series.t_s.get(*place + 1).is_some_and(|next| *next <= t_s) {
                *place += 1;
            }
            let (before_s, before) = (*series.t_s.get(*place)?, series.values[*place]);
            if before_s > t_s {
                return None;
            }
            self.positions[number] = match series.t_s.get(*place + 1) {
                _ if before_s == t_s => before,
                // A few intervals beyond the last it will still be there.
                None if t_s - before_s < self.most_gap_s[number] / 3.0 => before,
                None => return None,
                Some(after_s) => {
                    let (step_s, after) = (after_s - before_s, series.values[*place + 1]);
                    if step_s > self.most_gap_s[number] && (after - before).abs() > STILL {
                        return None;
                    }
                    before + (t_s - before_s) / step_s * (after - before)
                }
            };
        }
        Some(&self.positions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_are_interpolated_but_not_across_gaps_in_which_they_move() {
        let first = Series {
            t_s: vec![0.0, 0.05, 0.1, 0.15, 0.2, 1.2, 2.2],
            values: vec![0.0, 0.5, 1.0, 1.5, 2.0, 2.0, 3.0],
        };
        let second = Series { t_s: vec![0.05, 0.1, 0.15, 0.2, 0.3, 1.0, 2.0, 2.2], values: vec![1.0; 8] };
        let series = [first, second];
        let mut joints = Joints::new(&series);
        assert_eq!(joints.at(0.01), None);
        assert_eq!(joints.at(0.05), Some(&[0.5, 1.0][..]));
        assert_eq!(joints.at(0.1), Some(&[1.0, 1.0][..]));
        assert_eq!(joints.at(0.7), Some(&[2.0, 1.0][..]));
        assert_eq!(joints.at(1.7), None);
        assert_eq!(joints.at(2.2), Some(&[3.0, 1.0][..]));
        assert_eq!(joints.at(9.0), None);
        assert_eq!(joints.starting(0.1).at(0.12), Joints::new(&series).at(0.12));
        assert_eq!(joints.starting(-1.0).at(0.05), Some(&[0.5, 1.0][..]));
        assert_eq!(Joints::new(&[Series::default()]).at(0.0), None);
    }
}
