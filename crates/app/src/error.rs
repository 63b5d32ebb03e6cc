//! Why a use case gave no answer.

use soilctl_certificate::CertificateError;
use soilctl_controller::ControllerError;
use soilctl_diagnosis::DiagnosisError;
use soilctl_direct_shear::DirectShearError;
use soilctl_drawing::DrawingError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_effects::EffectsError;
use soilctl_estimator::EstimatorError;
use soilctl_jobs::JobsError;
use soilctl_kinematics::KinematicsError;
use soilctl_limit_analysis::{DescriptionError, LimitError};
use soilctl_soil::SoilError;
use soilctl_strokes::StrokesError;
use thiserror::Error;

#[cfg(not(target_family = "wasm"))]
use {
    soilctl_bag::BagError, soilctl_campaign::CampaignError, soilctl_digging::DiggingError,
    soilctl_ground::GroundError, soilctl_heights::HeightsError, soilctl_motion::MotionError,
    soilctl_process::ProcessError, soilctl_session::SessionError,
};

/// Why a use case gave no answer.
#[derive(Debug, Error)]
pub enum AppError {
    /// Values of a request that do not go together, or one that is missing.
    #[error("{0}")]
    Request(String),
    /// A value of a request outside its range.
    #[error("{key} is {value}; it must be {allowed}")]
    OutOfRange {
        /// Name of the value, as the request's field is called.
        key: String,
        /// What was given.
        value: String,
        /// What is allowed, with its unit.
        allowed: String,
    },
    /// A force model or a table.
    #[error(transparent)]
    EarthPressure(#[from] EarthPressureError),
    /// One row of a stroke table.
    #[error("{file}, line {line}: {problem}")]
    Row {
        /// Name of the file.
        file: String,
        /// Line in the file.
        line: usize,
        /// What is wrong there.
        problem: EarthPressureError,
    },
    /// A soil, an interface or a plate.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// A stroke table.
    #[error(transparent)]
    Strokes(#[from] StrokesError),
    /// Direct shear.
    #[error(transparent)]
    DirectShear(#[from] DirectShearError),
    /// A drawing.
    #[error("{file}: {problem}")]
    Drawing {
        /// Name of the file.
        file: String,
        /// What is wrong with it.
        problem: DrawingError,
    },
    /// An estimate.
    #[error(transparent)]
    Estimator(#[from] EstimatorError),
    /// Limit analysis.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// A saved solution.
    #[error(transparent)]
    Certificate(#[from] CertificateError),
    /// A log.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Session(#[from] SessionError),
    /// A recording of another program.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// None of several logs can be used; a note has told of each.
    #[error("none of {logs} logs can be used; the first: {first}")]
    NoLog {
        /// How many there are.
        logs: usize,
        /// What is wrong with the first.
        first: String,
    },
    /// Recorded strokes.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Process(#[from] ProcessError),
    /// An arm.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// Settings of the controller.
    #[error(transparent)]
    Controller(#[from] ControllerError),
    /// Work of another run, a store or a journal.
    #[error(transparent)]
    Jobs(#[from] JobsError),
    /// Places.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Ground(#[from] GroundError),
    /// Height maps.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Heights(#[from] HeightsError),
    /// A simulated campaign.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// Digging.
    #[cfg(not(target_family = "wasm"))]
    #[error(transparent)]
    Digging(#[from] DiggingError),
    /// A diagnosis.
    #[error(transparent)]
    Diagnosis(#[from] DiagnosisError),
    /// Effects and model files.
    #[error(transparent)]
    Effects(#[from] EffectsError),
    /// An answer that is no number.
    #[error(
        "{key} came out as {value}, which is no answer; the inputs are beyond what double precision can hold, so \
         bring them closer to the size of a real plate and soil"
    )]
    NotFinite {
        /// Key of the answer.
        key: String,
        /// NaN or an infinity.
        value: f64,
    },
    /// A file that cannot be written or read.
    #[error("{path}: {problem}")]
    File {
        /// The path.
        path: String,
        /// What the system says.
        problem: std::io::Error,
    },
    /// A request or an answer that is no JSON document.
    #[error("{0}")]
    Json(#[from] serde_json::Error),
}

impl AppError {
    /// Whether a file could not be read or written, rather than made no sense.
    #[must_use]
    pub const fn is_of_a_file(&self) -> bool {
        #[cfg(not(target_family = "wasm"))]
        if matches!(
            self,
            Self::Session(
                SessionError::File { .. } | SessionError::Write { .. } | SessionError::NotALog { .. }
            ) | Self::Motion(
                MotionError::Write { .. }
                    | MotionError::Bag(BagError::File { .. } | BagError::NotARecording { .. })
            ) | Self::Campaign(CampaignError::File { .. })
                | Self::Heights(HeightsError::File { .. } | HeightsError::Format { .. })
        ) {
            return true;
        }
        matches!(
            self,
            Self::File { .. }
                | Self::EarthPressure(EarthPressureError::File { .. })
                | Self::Strokes(StrokesError::File { .. })
                | Self::DirectShear(DirectShearError::Io { .. })
                | Self::Effects(EffectsError::File { .. })
                | Self::Limit(
                    LimitError::Description(DescriptionError::File { .. })
                        | LimitError::Certificate(CertificateError::File { .. })
                )
                | Self::Certificate(CertificateError::File { .. })
                | Self::Jobs(JobsError::File { .. } | JobsError::NoResult { .. } | JobsError::Damaged { .. })
        )
    }
}
