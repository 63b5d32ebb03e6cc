use clap::Command;
use soilctl_app::AppError;
use soilctl_campaign::CampaignError;
use soilctl_controller::ControllerError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_figure::FigureError;
use soilctl_jobs::JobsError;
use soilctl_live::LiveError;
use soilctl_monitor::MonitorError;
use soilctl_pages::PageError;
use soilctl_recording::RecordingError;
use soilctl_session::SessionError;
use soilctl_soil::SoilError;
use soilctl_workbench::WorkbenchError;
use thiserror::Error;

/// Why a verb gave no answer.
#[derive(Debug, Error)]
pub(crate) enum CliError {
    /// Options that do not go together, or one that is missing.
    #[error("{0}")]
    Usage(String),
    /// A use case.
    #[error(transparent)]
    App(#[from] AppError),
    /// A figure or a page.
    #[error(transparent)]
    Page(#[from] PageError),
    /// A force model or a table.
    #[error(transparent)]
    EarthPressure(#[from] EarthPressureError),
    /// A soil, an interface or a plate.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// A log.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// A live session, or the operator's end of one.
    #[error(transparent)]
    Live(#[from] LiveError),
    /// The workbench.
    #[error(transparent)]
    Workbench(#[from] WorkbenchError),
    /// The monitor.
    #[error(transparent)]
    Monitor(#[from] MonitorError),
    /// A recording for a viewer.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// Settings of the controller.
    #[error(transparent)]
    Controller(#[from] ControllerError),
    /// A simulated campaign.
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// Work of another run, a store or a journal.
    #[error(transparent)]
    Jobs(#[from] JobsError),
    /// A figure.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// A file that cannot be written or read.
    #[error("{path}: {problem}")]
    File {
        /// The path.
        path: String,
        /// What the system says.
        problem: std::io::Error,
    },
    /// Stdout.
    #[error("the answer could not be written: {0}")]
    Stdout(#[from] std::io::Error),
    /// An answer that could not be put into JSON.
    #[error("the answer could not be put into JSON: {0}")]
    Json(#[from] serde_json::Error),
}

impl CliError {
    /// The same with values called as the command line `whole` calls them.
    pub(crate) fn in_options(self, whole: &Command) -> Self {
        match self {
            Self::App(AppError::OutOfRange { key, value, allowed }) => {
                let option = option_of(whole, &key);
                Self::App(AppError::OutOfRange { key: option.unwrap_or(key), value, allowed })
            }
            other => other,
        }
    }

    /// Whether a file could not be read or written, rather than made no sense.
    pub(crate) const fn is_of_a_file(&self) -> bool {
        if let Self::App(problem) | Self::Page(PageError::App(problem)) = self {
            return problem.is_of_a_file();
        }
        matches!(
            self,
            Self::File { .. }
                | Self::EarthPressure(EarthPressureError::File { .. })
                | Self::Session(
                    SessionError::File { .. } | SessionError::Write { .. } | SessionError::NotALog { .. }
                )
                | Self::Recording(
                    RecordingError::Write { .. }
                        | RecordingError::Session(SessionError::File { .. } | SessionError::NotALog { .. })
                )
                | Self::Campaign(CampaignError::File { .. })
                | Self::Jobs(JobsError::File { .. } | JobsError::NoResult { .. } | JobsError::Damaged { .. })
        )
    }

    /// Whether the reader of stdout went away, which is its right.
    pub(crate) fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Stdout(problem) if problem.kind() == std::io::ErrorKind::BrokenPipe)
    }
}

/// The option that fills a field of a request.
fn option_of(command: &Command, field: &str) -> Option<String> {
    let own = command.get_arguments().find(|argument| argument.get_id() == field);
    let option = own.and_then(|argument| argument.get_long()).map(|long| format!("--{long}"));
    option.or_else(|| command.get_subcommands().find_map(|verb| option_of(verb, field)))
}
