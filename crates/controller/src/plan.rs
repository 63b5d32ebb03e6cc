use std::path::Path;

use serde::{Deserialize, Serialize};
use soilctl_kinematics::{Arm, TaskPose};

use crate::ControllerError;
use crate::config::Site;
use crate::validate::Rules;

/// Most strokes in a plan.
pub const MOST_STROKES: usize = 1024;

/// One stroke: where and how. SI units, radians.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct StrokeSpec {
    /// Number of the soil preparation.
    pub batch: u16,
    /// Radius of the insertion from the base axis in m.
    pub radius_m: f64,
    /// Base angle in rad.
    pub base_rad: f64,
    /// Tool angle alpha in rad.
    pub tool_angle_rad: f64,
    /// Vertical depth of the lower edge in m.
    pub depth_m: f64,
    /// Wanted angle between force and plate normal in rad.
    pub delta_rad: f64,
}

impl StrokeSpec {
    /// The pose of the plate with its lower edge at this height in m.
    #[must_use]
    pub fn pose(&self, height_m: f64) -> TaskPose {
        let (sin, cos) = libm::sincos(self.base_rad);
        TaskPose {
            x_m: self.radius_m * cos,
            y_m: self.radius_m * sin,
            z_m: height_m,
            n1_rad: 1.5 * std::f64::consts::PI - self.tool_angle_rad,
            n2_rad: 0.0,
        }
    }
}

/// The strokes of a campaign in order. Between batches the arm waits for the soil to be prepared.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StrokePlan {
    file: String,
    strokes: Vec<StrokeSpec>,
}

/// The strokes of a campaign plan as they stand in a TOML file. What else a campaign needs (soil, model, seed) stands in
/// keys beside them, which are not for the controller.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct PlanFile {
    version: u32,
    batches: Vec<BatchFile>,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct BatchFile {
    radius_m: Option<f64>,
    strokes: Vec<StrokeFile>,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct StrokeFile {
    radius_m: Option<f64>,
    base_deg: f64,
    alpha_deg: f64,
    depth_m: f64,
    delta_set_deg: f64,
}

impl StrokePlan {
    /// The strokes of a campaign plan from the text of its TOML file; `file` is named in messages. Tables 6.2 and 6.3 of
    /// the thesis are in `data/plans/`. Keys other than `version` and `batches` are left to others.
    ///
    /// # Errors
    /// [`ControllerError::Syntax`] if the text is not such a file, or [`ControllerError::Config`] if a value is not
    /// allowed. Whether the arm reaches the strokes is checked by [`Params`](crate::Params).
    pub fn from_toml(text: &str, file: &str) -> Result<Self, ControllerError> {
        let plan: PlanFile = toml::from_str(text).map_err(|error| ControllerError::Syntax {
            file: file.to_owned(),
            problem: error.to_string().trim_end().to_owned(),
        })?;
        let rules = Rules { file };
        rules.check("version", f64::from(plan.version), "", plan.version == 1, "1")?;
        let mut strokes = Vec::new();
        for (number, batch) in (0..).zip(&plan.batches) {
            for (i, stroke) in batch.strokes.iter().enumerate() {
                let key = |field: &str| format!("batches[{number}].strokes[{i}].{field}");
                let radius_m = stroke.radius_m.or(batch.radius_m).ok_or_else(|| ControllerError::Syntax {
                    file: file.to_owned(),
                    problem: format!(
                        "`{}` is missing; give it to the stroke or to its batch",
                        key("radius_m")
                    ),
                })?;
                rules.positive(&key("radius_m"), radius_m, "m", 10.0)?;
                rules.range(&key("base_deg"), stroke.base_deg, "deg", -180.0, 180.0)?;
                rules.range(&key("alpha_deg"), stroke.alpha_deg, "deg", 45.0, 135.0)?;
                rules.positive(&key("depth_m"), stroke.depth_m, "m", 1.0)?;
                rules.range(&key("delta_set_deg"), stroke.delta_set_deg, "deg", 0.0, 60.0)?;
                strokes.push(StrokeSpec {
                    batch: number,
                    radius_m,
                    base_rad: stroke.base_deg.to_radians(),
                    tool_angle_rad: stroke.alpha_deg.to_radians(),
                    depth_m: stroke.depth_m,
                    delta_rad: stroke.delta_set_deg.to_radians(),
                });
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "a list of more than 2^53 numbers does not exist")]
        let count = strokes.len() as f64;
        rules.check("batches", count, "strokes", strokes.len() <= MOST_STROKES, "at most 1024 strokes")?;
        Ok(Self { file: file.to_owned(), strokes })
    }

    /// A plan from a TOML file.
    ///
    /// # Errors
    /// [`ControllerError::Io`] if it cannot be read, otherwise as [`StrokePlan::from_toml`].
    pub fn read(path: &Path) -> Result<Self, ControllerError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|error| ControllerError::Io { file: file.clone(), reason: error.to_string() })?;
        Self::from_toml(&text, &file)
    }

    /// The strokes in order.
    #[must_use]
    pub fn strokes(&self) -> &[StrokeSpec] {
        &self.strokes
    }

    /// Every stroke must be reachable above the soil and in it.
    pub(crate) fn check_reach(&self, arm: &Arm, site: &Site) -> Result<(), ControllerError> {
        for (i, stroke) in self.strokes.iter().enumerate() {
            for (place, height_m) in [
                ("transit height", site.surface_z_m + site.transit_m),
                ("full depth", site.surface_z_m - stroke.depth_m),
            ] {
                arm.inverse(&stroke.pose(height_m)).map_err(|problem| ControllerError::Unreachable {
                    file: self.file.clone(),
                    number: i + 1,
                    place,
                    problem: Box::new(problem),
                })?;
            }
        }
        Ok(())
    }
}
