use std::collections::VecDeque;

use super::{Robot, RobotSample};
use crate::error::ProcessError;

/// What could not be used, by count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Lost {
    /// Messages that came later than the wait allows, by their stamps.
    pub late: u64,
    /// Wrenches without joints close before and after.
    pub gaps: u64,
    /// Messages with a number that is not finite, or of the wrong length.
    pub unusable: u64,
    /// Messages with the stamp of one before.
    pub repeated: u64,
}

/// Joins joint states and wrenches, which come at rates of their own and not always in order, into samples at the
/// wrenches' times. Memory is bounded by the wait.
#[derive(Debug)]
pub struct Aligner {
    robot: Robot,
    wait_s: f64,
    joints: VecDeque<(f64, Vec<f64>)>,
    wrenches: VecDeque<(f64, [f64; 6])>,
    /// Position of each joint as last heard.
    known: Vec<Option<f64>>,
    newest_s: f64,
    given_s: f64,
    lost: Lost,
}

/// Joints further apart than this are not interpolated, in s.
const MOST_GAP_S: f64 = 0.25;

impl Aligner {
    /// Waits `wait_s` (s, by the stamps) for messages that come late; 0.5 is plenty.
    #[must_use]
    pub fn new(robot: Robot, wait_s: f64) -> Self {
        let known = vec![None; robot.joint_names().len()];
        Self {
            robot,
            wait_s: wait_s.max(0.0),
            joints: VecDeque::new(),
            wrenches: VecDeque::new(),
            known,
            newest_s: f64::NEG_INFINITY,
            given_s: f64::NEG_INFINITY,
            lost: Lost::default(),
        }
    }

    /// What could not be used so far.
    #[must_use]
    pub fn lost(&self) -> Lost {
        self.lost
    }

    /// Joints that no message has named so far.
    #[must_use]
    pub fn missing_joints(&self) -> Vec<&str> {
        let names = self.robot.joint_names().iter().zip(&self.known);
        names.filter(|(_, known)| known.is_none()).map(|(name, _)| name.as_str()).collect()
    }

    /// A joint state: positions (rad or m) of the joints it names; those it doesn't name keep their last.
    pub fn joints<'a>(&mut self, t_s: f64, positions: impl Iterator<Item = (&'a str, f64)>) {
        if !self.in_time(t_s) {
            return;
        }
        let mut usable = true;
        for (name, value) in positions {
            let Some(place) = self.robot.joint_names().iter().position(|known| known == name) else {
                continue;
            };
            if value.is_finite() {
                self.known[place] = Some(value);
            } else {
                usable = false;
            }
        }
        let all: Option<Vec<f64>> = self.known.iter().copied().collect();
        match all {
            Some(all) if usable => self.lost.repeated += insert(&mut self.joints, t_s, all),
            Some(_) => self.lost.unusable += 1,
            None => {}
        }
    }

    /// A wrench: force (N) and torque (N m) of the soil on the plate in the sensor frame.
    pub fn wrench(&mut self, t_s: f64, wrench: [f64; 6]) {
        if !self.in_time(t_s) {
            return;
        }
        if wrench.iter().all(|part| part.is_finite()) {
            self.lost.repeated += insert(&mut self.wrenches, t_s, wrench);
        } else {
            self.lost.unusable += 1;
        }
    }

    fn in_time(&mut self, t_s: f64) -> bool {
        if !t_s.is_finite() {
            self.lost.unusable += 1;
            return false;
        }
        self.newest_s = self.newest_s.max(t_s);
        let in_time = t_s > self.given_s;
        self.lost.late += u64::from(!in_time);
        in_time
    }

    /// The next sample that nothing can precede any more; with `end`, without waiting.
    ///
    /// # Errors
    /// None that input can cause; those of [`Robot::sample`].
    pub fn next(&mut self, end: bool) -> Result<Option<RobotSample>, ProcessError> {
        while let Some(&(t_s, wrench)) = self.wrenches.front() {
            if !end && t_s > self.newest_s - self.wait_s {
                return Ok(None);
            }
            self.wrenches.pop_front();
            self.given_s = t_s;
            // The last joints at or before it, and the first after.
            while self.joints.get(1).is_some_and(|(next, _)| *next <= t_s) {
                self.joints.pop_front();
            }
            match between(&self.joints, t_s) {
                Some(positions) => match self.robot.sample(t_s, &positions, wrench) {
                    // So far out that there is no pose.
                    Err(ProcessError::NotFinite { .. }) => self.lost.unusable += 1,
                    sample => return sample.map(Some),
                },
                None => self.lost.gaps += 1,
            }
        }
        Ok(None)
    }
}

/// Keeps a queue sorted by time; 1 if there is an entry of that time already.
fn insert<T>(queue: &mut VecDeque<(f64, T)>, t_s: f64, value: T) -> u64 {
    let place = queue.iter().rposition(|(t, _)| *t <= t_s).map_or(0, |last| last + 1);
    if place > 0 && queue.get(place - 1).is_some_and(|(t, _)| *t == t_s) {
        return 1;
    }
    queue.insert(place, (t_s, value));
    0
}

fn between(joints: &VecDeque<(f64, Vec<f64>)>, t_s: f64) -> Option<Vec<f64>> {
    let (before, first) = joints.front().filter(|(t, _)| *t <= t_s)?;
    if *before == t_s {
        return Some(first.clone());
    }
    let (after, second) = joints.get(1)?;
    let step = after - before;
    let share = (t_s - before) / step;
    (step <= MOST_GAP_S).then(|| first.iter().zip(second).map(|(a, b)| a + share * (b - a)).collect())
}
