//! What was odd about the messages of a log: said with topic, number, and the times of the first and last.

use std::fmt;

/// One kind of trouble on one topic.
#[derive(Debug, Clone, PartialEq)]
pub struct Trouble {
    /// The topic.
    pub topic: String,
    /// What is odd.
    pub what: Oddity,
    /// How many messages are concerned.
    pub count: u64,
    /// Time of the first in s, on the log's clock.
    pub first_s: f64,
    /// Time of the last in s.
    pub last_s: f64,
}

/// What may be odd about messages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Oddity {
    /// They could not be decoded.
    Malformed,
    /// They have numbers that are not finite, and were left out.
    NotFinite,
    /// They were recorded twice, and the second was left out.
    Duplicate,
    /// They have no stamp; the log's time was taken.
    Unstamped,
    /// Their stamps cannot be, or are too coarse to tell them apart; the log's time was taken.
    WrongStamps,
    /// They stand in the log behind later ones, and were put in order.
    Disordered,
    /// The sender's clock was set by so many s; the log's time tells how much time passed.
    ClockSet {
        /// Ahead in s, negative if back.
        by_s: f64,
    },
    /// None came for a time much longer than usual; the longest such time in s.
    Gap {
        /// Longest in s.
        longest_s: f64,
    },
    /// No joint states came shortly before and after these wrenches, so their posture is unknown.
    NoPosture,
}

impl fmt::Display for Trouble {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { topic, count, first_s, last_s, .. } = self;
        let messages = if *count == 1 { "1 message".to_owned() } else { format!("{count} messages") };
        match self.what {
            Oddity::Malformed => write!(out, "{topic}: {messages} cannot be decoded")?,
            Oddity::NotFinite => {
                write!(out, "{topic}: {messages} with a number that is not finite, left out")?;
            }
            Oddity::Duplicate => write!(out, "{topic}: {messages} recorded twice, the second left out")?,
            Oddity::Unstamped => write!(out, "{topic}: {messages} without a stamp; the log's time is taken")?,
            Oddity::WrongStamps => write!(
                out,
                "{topic}: {messages} with stamps that cannot be or do not tell them apart; the log's time is taken"
            )?,
            Oddity::Disordered => write!(out, "{topic}: {messages} out of order, put in order")?,
            Oddity::ClockSet { by_s } => write!(
                out,
                "{topic}: the sender's clock was set {} by {:.3} s; the log's time is taken for how much time passed",
                if by_s < 0.0 { "back" } else { "ahead" },
                by_s.abs()
            )?,
            Oddity::Gap { longest_s } => {
                let gaps = if *count == 1 { "a gap".to_owned() } else { format!("{count} gaps") };
                write!(out, "{topic}: {gaps}, the longest of {longest_s:.3} s")?;
            }
            Oddity::NoPosture => {
                write!(out, "{topic}: {messages} without joint states close before and after")?;
            }
        }
        if *count > 1 {
            write!(out, " (from {first_s:.3} to {last_s:.3} s)")
        } else {
            write!(out, " (at {first_s:.3} s)")
        }
    }
}
