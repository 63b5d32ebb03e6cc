//! Joints, forces, state and events as a block of text.

use std::collections::VecDeque;
use std::fmt::Write;

use soilctl_live::protocol::{Event, StateMessage};

const JOINTS: [&str; 5] = ["base", "shoulder", "elbow", "twist", "wrist"];
/// Events that are shown.
pub(super) const EVENTS: usize = 6;

/// The panels, some twenty lines.
pub(super) fn panel(state: &StateMessage, events: &VecDeque<Event>) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "{}", summary(state));
    let _ = writeln!(text, "{:10}{:>10}{:>10}{:>12}{:>12}", "joint", "deg", "wanted", "deg/s", "N m");
    for (i, name) in JOINTS.iter().enumerate() {
        let _ = writeln!(
            text,
            "{name:10}{:>10.3}{:>10.3}{:>12.2}{:>12.3}",
            state.joints_deg[i],
            state.desired_joints_deg[i],
            state.joint_rates_deg_s[i],
            state.joint_torques_nm[i]
        );
    }
    match &state.plate {
        Some(plate) => {
            let _ = writeln!(
                text,
                "plate     x {:.4} m, y {:.4} m, z {:.4} m, tool angle {:.2} deg",
                plate.x_m, plate.y_m, plate.z_m, plate.tool_angle_deg
            );
        }
        None => text.push_str("plate     not known before homing\n"),
    }
    let [r, t, z] = state.force_rtz_n;
    let _ = writeln!(text, "force     r {r:.2} N, t {t:.2} N, z {z:.2} N");
    let shown = |value: Option<f64>, scale: f64| {
        value.map_or("-".to_owned(), |value| format!("{:.2}", value * scale))
    };
    let _ = writeln!(
        text,
        "stroke    {} mm, friction angle {} of {} deg, lead {} mm at {} deg, safe force {} N",
        shown(state.displacement_m, 1e3),
        shown(state.friction_angle_deg, 1.0),
        shown(state.friction_setpoint_deg, 1.0),
        shown(state.lead_m, 1e3),
        shown(state.lead_inclination_deg, 1.0),
        shown(state.safe_force_n, 1.0)
    );
    let fault = state.fault.as_ref().map_or("none".to_owned(), |fault| {
        format!(
            "{} {} at {:.3} s: {:.4}, limit {:.4}",
            fault.kind,
            fault.index,
            fault.tick as f64 * 0.002,
            fault.value,
            fault.limit
        )
    });
    let _ = writeln!(text, "fault     {fault}");
    let dropped = &state.dropped;
    let _ = writeln!(
        text,
        "dropped   {} steps of the log, {} states, {} events, {} messages",
        dropped.log_steps, dropped.states, dropped.events, dropped.messages
    );
    for event in events.iter().rev().take(EVENTS).rev() {
        let _ = writeln!(text, "event     {}", event_words(event));
    }
    text
}

/// The state in one line.
pub(super) fn summary(state: &StateMessage) -> String {
    let mut text = format!("{:9.3} s  {}", state.time_s, state.mode);
    text += if state.homed { ", homed" } else { ", not homed" };
    if let Some(sequence) = &state.sequence {
        let _ = write!(text, ", {sequence} step {}", state.sequence_step);
    }
    if let Some(trajectory) = &state.trajectory {
        let _ = write!(text, ", {trajectory}");
    }
    for (is, word) in [
        (state.waiting, ", waiting for the soil"),
        (state.paused, ", time stands still"),
        (state.storing, ", storing"),
    ] {
        if is {
            text += word;
        }
    }
    text
}

/// An event in one line.
pub(super) fn event_words(event: &Event) -> String {
    let mut text = format!("{:9.3} s  {}", event.time_s, event.kind);
    if event.index != 0 {
        let _ = write!(text, " {}", event.index);
    }
    if event.value != 0.0 || event.limit != 0.0 {
        let _ = write!(text, ": {:.5}", event.value);
    }
    if event.limit != 0.0 {
        let _ = write!(text, " (limit {:.5})", event.limit);
    }
    text
}

/// Draws blocks of text over each other on a terminal, one below the other elsewhere.
#[derive(Debug, Default)]
pub(super) struct Screen {
    terminal: bool,
    lines: usize,
}

impl Screen {
    pub(super) fn new() -> Self {
        Self { terminal: std::io::IsTerminal::is_terminal(&std::io::stdout()), lines: 0 }
    }

    /// What is to be written so that `block` is shown.
    pub(super) fn draw(&mut self, block: &str) -> String {
        let back = match (self.terminal, self.lines) {
            (true, 1..) => format!("\x1b[{}A\x1b[J", self.lines),
            _ => String::new(),
        };
        self.lines = block.lines().count();
        back + block
    }
}
