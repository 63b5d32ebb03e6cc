use std::collections::BTreeMap;

use soilctl_controller::{ControllerConfig, Params, StrokePlan};
use soilctl_kinematics::Arm;
use soilctl_kinematics::config::ArmConfig;

use crate::SessionError;

/// Version of the format of our own records in a log.
pub const FORMAT_VERSION: u32 = 1;

/// Name of the metadata record that says what made a log.
pub const SESSION_RECORD: &str = "soilctl.session";
/// Name of the metadata record with the settings as TOML.
pub const CONFIGURATION_RECORD: &str = "soilctl.configuration";
/// Name of the metadata records with the boundaries of a stroke each.
pub const STROKE_RECORD: &str = "soilctl.stroke";
/// Name of the metadata record that a log ends with.
pub const END_RECORD: &str = "soilctl.end";

/// Which topics a log has.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Content {
    /// All of them, for every tool that reads logs.
    #[default]
    Whole,
    /// Inputs and outputs of every step, key frames and what does not move: all that strokes are read from and that a replay needs. Joints,
    /// motors, wrench, moving frames and the truth of a simulation are left out; all but the truth follow from the steps.
    Steps,
}

/// What a session is made from. It stands in the log as text, so that a replay starts from the same bits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SessionSetup {
    /// The arm file as TOML.
    pub arm: String,
    /// The controller's settings as TOML.
    pub controller: String,
    /// The stroke plan as TOML; empty for none.
    pub plan: String,
    /// Seed of the simulation.
    pub seed: u64,
    /// Name of the force model of the simulated soil, or of the hardware.
    pub model: String,
    /// Further texts for the record of the configuration, such as the campaign, by name.
    pub notes: BTreeMap<String, String>,
    /// Which topics the log has; not written down.
    pub content: Content,
}

impl SessionSetup {
    /// A session of this arm with these settings; `plan` is the TOML of a stroke plan or empty.
    ///
    /// # Errors
    /// [`SessionError::Toml`] if the settings cannot be put into TOML.
    pub fn new(
        arm: &ArmConfig,
        controller: &ControllerConfig,
        plan: &str,
        seed: u64,
        model: &str,
    ) -> Result<Self, SessionError> {
        Ok(Self {
            arm: toml::to_string(arm)?,
            controller: toml::to_string(controller)?,
            plan: plan.to_owned(),
            seed,
            model: model.to_owned(),
            notes: BTreeMap::new(),
            content: Content::Whole,
        })
    }

    /// The controller's parameters; running with these and not with those that the texts came from makes a replay
    /// start from the same bits.
    ///
    /// # Errors
    /// [`SessionError::Kinematics`] or [`SessionError::Controller`] naming the first key that is not allowed.
    pub fn params(&self) -> Result<Params, SessionError> {
        let arm = Arm::from_toml(&self.arm, "arm")?;
        let plan = if self.plan.is_empty() {
            StrokePlan::default()
        } else {
            StrokePlan::from_toml(&self.plan, "plan")?
        };
        Ok(Params::from_toml(arm, &self.controller, "controller settings", plan)?)
    }

    pub(crate) fn session_record(&self) -> BTreeMap<String, String> {
        [
            ("format_version", FORMAT_VERSION.to_string()),
            ("program_version", env!("CARGO_PKG_VERSION").to_owned()),
            ("seed", self.seed.to_string()),
            ("model", self.model.clone()),
            ("tick_rate_hz", soilctl_controller::TICK_RATE_HZ.to_string()),
        ]
        .map(|(key, value)| (key.to_owned(), value))
        .into()
    }

    pub(crate) fn configuration_record(&self) -> BTreeMap<String, String> {
        let mut record = self.notes.clone();
        for (key, text) in [("arm", &self.arm), ("controller", &self.controller), ("plan", &self.plan)] {
            record.insert(key.to_owned(), text.clone());
        }
        record
    }

    /// The setup in the metadata records of a log.
    ///
    /// # Errors
    /// [`SessionError::Missing`] or [`SessionError::Version`].
    pub(crate) fn from_records(
        file: &str,
        session: Option<&BTreeMap<String, String>>,
        configuration: Option<&BTreeMap<String, String>>,
    ) -> Result<Self, SessionError> {
        let missing = |what: &str| SessionError::Missing {
            file: file.to_owned(),
            what: what.to_owned(),
            advice: "only logs that soilctl wrote can be replayed",
        };
        let session = session.ok_or_else(|| missing(SESSION_RECORD))?;
        let mut notes = configuration.ok_or_else(|| missing(CONFIGURATION_RECORD))?.clone();
        let version = session.get("format_version").map_or("", String::as_str);
        if version != FORMAT_VERSION.to_string() {
            let found = version.to_owned();
            return Err(SessionError::Version { what: "the log", found, known: FORMAT_VERSION });
        }
        let mut take =
            |key: &str| notes.remove(key).ok_or_else(|| missing(&format!("{CONFIGURATION_RECORD}: {key}")));
        Ok(Self {
            arm: take("arm")?,
            controller: take("controller")?,
            plan: take("plan")?,
            seed: session.get("seed").and_then(|seed| seed.parse().ok()).ok_or_else(|| missing("seed"))?,
            model: session.get("model").cloned().ok_or_else(|| missing("model"))?,
            notes,
            content: Content::Whole,
        })
    }
}
