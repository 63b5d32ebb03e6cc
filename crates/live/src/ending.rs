/// Why a session ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// Somebody asked for it.
    Asked,
    /// Its time is up.
    TimeIsUp,
    /// The log of a simulated run could not be written.
    LogFailed,
    /// The driver went away.
    DriverGone,
    /// The simulated arm left all bounds.
    HardwareFailed,
}

impl Ending {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Asked => "asked to end",
            Self::TimeIsUp => "the time is up",
            Self::LogFailed => "the log could not be written",
            Self::DriverGone => "the driver went away",
            Self::HardwareFailed => "the simulated arm left all bounds",
        }
    }
}
