use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::StrokesError;
use crate::campaign_json::Keys;

/// What is known about a campaign beside its strokes: `campaign.json`.
///
/// Every key is optional. The defaults are those of a small arm in a prepared box of dry sand.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Campaign {
    /// Friction angle known from elsewhere, in deg; default none.
    pub phi_independent_deg: Option<f64>,
    /// Its standard deviation in deg; default 1 deg if the angle is given, otherwise none.
    pub phi_independent_sd: Option<f64>,
    /// Standard deviation of the interface friction angle about its set-point, in deg; default 1.
    pub delta_sd_deg: f64,
    /// Relative standard deviation of the density between preparations; default 0.04.
    pub density_sd_rel: f64,
    /// Standard deviation of the depth of a stroke in m, where the stroke table does not say it; default 0.0005.
    pub depth_sd_m: f64,
    /// Standard deviation in m of what all depths are off together, by a datum or a surface that is always found too low; default
    /// 0.0002, as touches of simulated soil are off in the mean (`docs/process.md`).
    pub depth_common_sd_m: f64,
    /// Relative standard deviation of a true force from that of a force model on level ground, for strokes of one kind together: the
    /// heap ahead, a surface that is lower at the foot of an earlier heap, the law of the friction on the plate. Default 0.025,
    /// empirical: what the soil bore in 49 simulated strokes was so far from its model (`docs/estimate.md`).
    pub soil_sd_rel: f64,
    /// Thickness of the plate in m; default 0.002.
    pub plate_thickness_m: f64,
    /// Whether the soil was prepared densely, so that it softens after failure; default false.
    pub dense_preparation: bool,
    /// The design of the campaign in free text; default empty.
    pub design: String,
    /// The instrument.
    pub instrument: Instrument,
}

/// Accuracy of the instrument: standard deviations of its readings, stiffness and resolution.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Instrument {
    /// Of the force sensor's gain, relative; default 0.01, which is what makers say of six-axis sensors.
    pub force_gain_sd: f64,
    /// Of the measured friction angle, in deg; default 1.
    pub friction_angle_sd: f64,
    /// Of the height of the tip, in m; default 0.0005.
    pub z_sd: f64,
    /// Of a free-air reading, in N; default 0.05.
    pub tare_sd: f64,
    /// Of the height of a heap, in m; default 0.001.
    pub heap_sd: f64,
    /// Of the difference between motor-side and external position, in m; default 0.001.
    pub gap_sd: f64,
    /// Of the difference between commanded and measured force, in N; default 0.5.
    pub cmd_sd: f64,
    /// Stiffness at the tip with the motors held, in N/m; default 10000.
    pub joint_stiffness_n_per_m: f64,
    /// Step of the tip for one step of the external encoders, in m; default 0.00127.
    pub encoder_step_m: f64,
    /// Of `post_slope_norm` from one tool angle to the next, and over a tenth of the depth, as an arm gives it whose plate rises or
    /// dives while it heaps the soil; default 0.
    pub post_slope_sd: f64,
}

impl Default for Campaign {
    fn default() -> Self {
        Self {
            phi_independent_deg: None,
            phi_independent_sd: None,
            delta_sd_deg: 1.0,
            density_sd_rel: 0.04,
            depth_sd_m: 0.0005,
            depth_common_sd_m: 0.0002,
            soil_sd_rel: 0.025,
            plate_thickness_m: 0.002,
            dense_preparation: false,
            design: String::new(),
            instrument: Instrument::default(),
        }
    }
}

impl Default for Instrument {
    fn default() -> Self {
        Self {
            force_gain_sd: 0.01,
            friction_angle_sd: 1.0,
            z_sd: 0.0005,
            tare_sd: 0.05,
            heap_sd: 0.001,
            gap_sd: 0.001,
            cmd_sd: 0.5,
            joint_stiffness_n_per_m: 10_000.0,
            encoder_step_m: 0.00127,
            post_slope_sd: 0.0,
        }
    }
}

impl Campaign {
    /// Reads `campaign.json` in the folder of a stroke table; `None` if there is none.
    ///
    /// # Errors
    /// As [`Campaign::from_json`], and [`StrokesError::File`] if the file is there but cannot be read.
    pub fn read_beside(strokes_path: &Path) -> Result<Option<Self>, StrokesError> {
        let path = path_beside(strokes_path);
        let file = path.display().to_string();
        match std::fs::read_to_string(&path) {
            Ok(text) => Self::from_json(&text, &file).map(Some),
            Err(problem) if problem.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(problem) => Err(StrokesError::file(&file, &problem)),
        }
    }

    /// A campaign from JSON text; `file` stands for it in messages. `null` is as if the key were left out.
    ///
    /// # Errors
    /// [`StrokesError::NotAnObject`] if the text is not a JSON object, [`StrokesError::BadKey`] if a value is of the
    /// wrong type or outside its range, [`StrokesError::UnknownKey`] if a key is none of those above.
    pub fn from_json(text: &str, file: &str) -> Result<Self, StrokesError> {
        let whole = Keys::parse(text, file)?;
        let inner = whole.object("instrument")?;
        let (usual, usual_inner) = (Self::default(), Instrument::default());
        let phi_independent_deg = whole.optional_angle("phi_independent_deg")?;
        let usual_sd = phi_independent_deg.map(|_| 1.0);
        let campaign = Self {
            phi_independent_deg,
            phi_independent_sd: whole.optional_positive("phi_independent_sd")?.or(usual_sd),
            delta_sd_deg: whole.at_least_zero("delta_sd_deg", usual.delta_sd_deg)?,
            density_sd_rel: whole.at_least_zero("density_sd_rel", usual.density_sd_rel)?,
            depth_sd_m: whole.at_least_zero("depth_sd_m", usual.depth_sd_m)?,
            depth_common_sd_m: whole.at_least_zero("depth_common_sd_m", usual.depth_common_sd_m)?,
            soil_sd_rel: whole.at_least_zero("soil_sd_rel", usual.soil_sd_rel)?,
            plate_thickness_m: whole.at_least_zero("plate_thickness_m", usual.plate_thickness_m)?,
            dense_preparation: whole.bool("dense_preparation", usual.dense_preparation)?,
            design: whole.text("design")?,
            instrument: Instrument {
                force_gain_sd: inner.at_least_zero("force_gain_sd", usual_inner.force_gain_sd)?,
                friction_angle_sd: inner.at_least_zero("friction_angle_sd", usual_inner.friction_angle_sd)?,
                z_sd: inner.at_least_zero("z_sd", usual_inner.z_sd)?,
                tare_sd: inner.at_least_zero("tare_sd", usual_inner.tare_sd)?,
                heap_sd: inner.at_least_zero("heap_sd", usual_inner.heap_sd)?,
                gap_sd: inner.at_least_zero("gap_sd", usual_inner.gap_sd)?,
                cmd_sd: inner.at_least_zero("cmd_sd", usual_inner.cmd_sd)?,
                joint_stiffness_n_per_m: inner
                    .positive("joint_stiffness_n_per_m", usual_inner.joint_stiffness_n_per_m)?,
                encoder_step_m: inner.at_least_zero("encoder_step_m", usual_inner.encoder_step_m)?,
                post_slope_sd: inner.at_least_zero("post_slope_sd", usual_inner.post_slope_sd)?,
            },
        };
        whole.refuse_unknown()?;
        inner.refuse_unknown()?;
        Ok(campaign)
    }

    /// Writes `campaign.json` in the folder of a stroke table.
    ///
    /// # Errors
    /// [`StrokesError::File`] if the file cannot be written.
    pub fn write_beside(&self, strokes_path: &Path) -> Result<(), StrokesError> {
        let path = path_beside(strokes_path);
        let file = path.display().to_string();
        let text =
            serde_json::to_string_pretty(self).map_err(|problem| StrokesError::file(&file, &problem))?;
        soilctl_jobs::write_atomically(&path, (text + "\n").as_bytes())
            .map_err(|problem| StrokesError::file(&file, &problem))
    }
}

fn path_beside(strokes_path: &Path) -> PathBuf {
    strokes_path.with_file_name("campaign.json")
}
