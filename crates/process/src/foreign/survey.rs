//! A whole log at a glance: means over some hundredths of a second, with the posture of the arm.

use std::ops::Range;

use soilctl_motion::{Columns, Joints, Series, usual_interval};

use crate::robot::{Robot, RobotSample};

/// Time that a block spans in s, or one sample where they come more slowly.
pub(crate) const BLOCK_S: f64 = 0.02;
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
