//! Strokes in the samples of a bag: by given times, or found by contact and travel.

use std::collections::VecDeque;

use super::{Candidate, LogSettings, LogStroke, NoStroke};
use crate::{Contact, FindSettings, Finder, Recorded, RobotSample, Setting, evaluate};

/// Free air before a given stroke, in s, and what is left out of it next to the stroke.
const AIR_S: f64 = 1.0;
const MARGIN_S: f64 = 0.1;

/// Cuts the stream of samples into strokes.
pub(super) struct Cutter {
    setting: Setting,
    tool_weight_n: f64,
    by: By,
}

enum By {
    Finder(Box<Finder>),
    /// Windows still to come, the earliest first; the air before; the samples of the present one.
    Windows {
        left: VecDeque<[f64; 2]>,
        tare: Option<[f64; 6]>,
        air: VecDeque<RobotSample>,
        now: Vec<RobotSample>,
    },
}

impl Cutter {
    pub(super) fn new(settings: &LogSettings) -> Self {
        let by = match &settings.windows {
            None => By::Finder(Box::new(Finder::new(FindSettings {
                tare: settings.tare,
                ..FindSettings::default()
            }))),
            Some(windows) => {
                let mut sorted = windows.clone();
                sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
                let (air, now) = (VecDeque::new(), Vec::new());
                By::Windows { left: sorted.into(), tare: settings.tare, air, now }
            }
        };
        let setting = Setting {
            surface_z_m: settings.surface_z_m.unwrap_or_default(),
            width_m: settings.width_m.unwrap_or_default(),
            alpha_deg: settings.alpha_deg,
            delta_set_deg: settings.delta_set_deg,
            ..Setting::default()
        };
        Self { setting, tool_weight_n: settings.tool_weight_n, by }
    }

    pub(super) fn push(&mut self, sample: RobotSample, found: &mut dyn FnMut(Candidate)) {
        match &mut self.by {
            By::Finder(finder) => {
                if let Some(contact) = finder.push(sample) {
                    self.contact(contact, found);
                }
            }
            By::Windows { left, air, now, .. } => {
                let Some(&[from, to]) = left.front() else { return };
                if sample.t_s < from {
                    air.push_back(sample);
                    while air.front().is_some_and(|first| first.t_s < sample.t_s - AIR_S) {
                        air.pop_front();
                    }
                } else if sample.t_s <= to {
                    now.push(sample);
                } else {
                    self.window(found);
                    self.push(sample, found);
                }
            }
        }
    }

    pub(super) fn end(&mut self, found: &mut dyn FnMut(Candidate)) {
        match &mut self.by {
            By::Finder(finder) => {
                if let Some(contact) = finder.end() {
                    self.contact(contact, found);
                }
            }
            By::Windows { left, .. } => {
                for _ in 0..left.len() {
                    self.window(found);
                }
            }
        }
    }

    /// Ends the present window.
    fn window(&mut self, found: &mut dyn FnMut(Candidate)) {
        let By::Windows { left, tare, air, now } = &mut self.by else { return };
        let Some([from_s, to_s]) = left.pop_front() else { return };
        let samples = std::mem::take(now);
        let rest: Vec<RobotSample> = air.drain(..).filter(|s| s.t_s < from_s - MARGIN_S).collect();
        let mean = (rest.len() >= 5).then(|| {
            std::array::from_fn(|i| rest.iter().map(|s| s.wrench[i]).sum::<f64>() / rest.len() as f64)
        });
        let nothing = |reason: &str| Candidate::Rejected(NoStroke { from_s, to_s, reason: reason.into() });
        let Some(tare) = tare.or(mean) else {
            found(nothing(
                "nothing was recorded in the second before it, so the tare is unknown; give --tare",
            ));
            return;
        };
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            found(nothing("no samples lie between these times"));
            return;
        };
        let way = [last.tip_m[0] - first.tip_m[0], last.tip_m[1] - first.tip_m[1]];
        let length = way[0].hypot(way[1]);
        if length <= 0.0 {
            found(nothing("the plate does not move along the ground between these times"));
            return;
        }
        let direction = [way[0] / length, way[1] / length];
        let taken =
            |s: &RobotSample| RobotSample { wrench: std::array::from_fn(|i| s.wrench[i] - tare[i]), ..*s };
        let samples = samples.iter().map(taken).collect();
        let recorded = Recorded { samples, direction, tare_before: Some(tare), tare_after: None };
        self.contact(Contact::Stroke(recorded), found);
    }

    fn contact(&self, contact: Contact, found: &mut dyn FnMut(Candidate)) {
        match contact {
            Contact::Other(other) => found(Candidate::Rejected(NoStroke {
                from_s: other.from_s,
                to_s: other.to_s,
                reason: format!(
                    "the plate touches something but travels only {:.1} mm",
                    other.travel_m * 1e3
                ),
            })),
            Contact::Stroke(mut recorded) => {
                let span = |s: Option<&RobotSample>| s.map_or(0.0, |s| s.t_s);
                let (from_s, to_s) = (span(recorded.samples.first()), span(recorded.samples.last()));
                turn_weight(&mut recorded.samples, self.tool_weight_n);
                match evaluate(&recorded, &self.setting) {
                    Ok(evaluated) => found(Candidate::Stroke(Box::new(LogStroke {
                        evaluated,
                        course: None,
                        finish: None,
                        flags: Vec::new(),
                        start_s: from_s,
                        end_s: to_s,
                    }))),
                    Err(error) => {
                        found(Candidate::Rejected(NoStroke { from_s, to_s, reason: error.to_string() }));
                    }
                }
            }
        }
    }
}

/// Takes off what the tool's weight does to the readings when the sensor turns after its tare: the tare has it as in the
/// first sample.
fn turn_weight(samples: &mut [RobotSample], weight_n: f64) {
    let Some(up) = samples.first().map(|s| s.to_root[2]) else { return };
    for sample in samples {
        for (force, (now, then)) in sample.wrench.iter_mut().zip(sample.to_root[2].iter().zip(up)) {
            *force += weight_n * (now - then);
        }
    }
}
