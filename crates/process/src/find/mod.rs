//! Strokes in a stream of samples: contact by force, with hysteresis, and travel along the ground.

mod carve;
mod settings;

use std::collections::VecDeque;

pub use settings::FindSettings;

use crate::robot::RobotSample;

/// One contact of the plate with the soil in which it travelled: a stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct Recorded {
    /// Samples of the stroke: after insertion, before the plate is pulled out.
    pub samples: Vec<RobotSample>,
    /// Unit vector of the travel along the ground (x, y).
    pub direction: [f64; 2],
    /// Mean wrench in free air before, in the sensor frame: the tare that has been taken off the samples.
    pub tare_before: Option<[f64; 6]>,
    /// Mean wrench in free air after, as read.
    pub tare_after: Option<[f64; 6]>,
}

/// Why a contact was no stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotAStroke {
    /// Begin of the contact in s.
    pub from_s: f64,
    /// Its end in s.
    pub to_s: f64,
    /// Greatest travel along the ground at the lowest depth, in m.
    pub travel_m: f64,
}

/// What came of a contact.
#[derive(Debug, Clone, PartialEq)]
pub enum Contact {
    /// A stroke.
    Stroke(Recorded),
    /// Something else: a touch, an insertion, a bump.
    Other(NotAStroke),
}

/// Finds strokes, one sample at a time. Memory is bounded by the longest contact.
#[derive(Debug)]
pub struct Finder {
    settings: FindSettings,
    /// Free air before a contact.
    air: VecDeque<RobotSample>,
    state: State,
}

#[derive(Debug)]
enum State {
    Air,
    Contact { samples: Vec<RobotSample>, tare: Option<[f64; 6]>, quiet_since_s: Option<f64> },
}

impl Finder {
    /// A finder that begins in free air.
    #[must_use]
    pub fn new(settings: FindSettings) -> Self {
        Self { settings, air: VecDeque::new(), state: State::Air }
    }

    /// Takes the next sample, in order of time; gives a contact when it is over.
    pub fn push(&mut self, sample: RobotSample) -> Option<Contact> {
        let settings = self.settings;
        match &mut self.state {
            State::Air => {
                let tare = settings.tare.or_else(|| mean_wrench(&self.air, settings.margin_s));
                // Without a tare nothing can be said yet.
                if tare.is_some() && size(&sample, tare) > settings.on_n {
                    let samples: Vec<RobotSample> = self.air.drain(..).chain([sample]).collect();
                    self.state = State::Contact { samples, tare, quiet_since_s: None };
                    return None;
                }
                self.air.push_back(sample);
                while self.air.front().is_some_and(|first| first.t_s < sample.t_s - settings.air_s) {
                    self.air.pop_front();
                }
                None
            }
            State::Contact { samples, tare, quiet_since_s } => {
                let gap = samples.last().is_some_and(|last| sample.t_s - last.t_s > settings.most_gap_s);
                let long = samples.first().is_some_and(|first| sample.t_s - first.t_s > settings.longest_s);
                if gap || long {
                    let contact = self.end();
                    self.air.push_back(sample);
                    return contact;
                }
                samples.push(sample);
                if size(&sample, *tare) > settings.off_n {
                    *quiet_since_s = None;
                    return None;
                }
                let since = *quiet_since_s.get_or_insert(sample.t_s);
                // Free air afterwards shows the tare once more.
                (sample.t_s - since > settings.quiet_s).then(|| self.end()).flatten()
            }
        }
    }

    /// Ends the contact at hand, as at the end of a log.
    pub fn end(&mut self) -> Option<Contact> {
        match std::mem::replace(&mut self.state, State::Air) {
            State::Air => None,
            State::Contact { samples, tare, quiet_since_s } => {
                self.air.clear();
                let (from, to) = (samples.first()?.t_s, samples.last()?.t_s);
                let after = quiet_since_s.and_then(|since| {
                    let quiet = samples.iter().filter(|s| s.t_s >= since + self.settings.margin_s);
                    mean(quiet.map(|s| s.wrench))
                });
                let end = quiet_since_s.unwrap_or(f64::INFINITY);
                let busy = samples.into_iter().filter(|s| s.t_s < end).collect();
                Some(carve::stroke(busy, tare, after, &self.settings).unwrap_or_else(|travel_m| {
                    Contact::Other(NotAStroke { from_s: from, to_s: to, travel_m })
                }))
            }
        }
    }
}

/// Mean wrench of free air, leaving out the last `margin_s`, in which contact may have begun; `None` without air.
fn mean_wrench(air: &VecDeque<RobotSample>, margin_s: f64) -> Option<[f64; 6]> {
    let last = air.back()?.t_s;
    mean(air.iter().filter(|s| s.t_s <= last - margin_s).map(|s| s.wrench))
}

fn mean(wrenches: impl Iterator<Item = [f64; 6]>) -> Option<[f64; 6]> {
    let (mut sum, mut count) = ([0.0; 6], 0.0);
    for wrench in wrenches {
        for (total, part) in sum.iter_mut().zip(wrench) {
            *total += part;
        }
        count += 1.0;
    }
    (count >= 5.0).then(|| sum.map(|total| total / count))
}

/// Size of the force without tare, in N.
fn size(sample: &RobotSample, tare: Option<[f64; 6]>) -> f64 {
    let tare = tare.unwrap_or_default();
    sample.wrench.iter().zip(tare).take(3).map(|(f, t)| (f - t).powi(2)).sum::<f64>().sqrt()
}
