//! What an estimate is asked.

use std::path::PathBuf;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::MODEL_IDS;

use super::unknowns::Intervals;
use crate::request::{Ends, Loads, NumberOrColumn, finite, model_help, slopes};
use crate::{AppError, TableSource};

/// What a force's uncertainty means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Uncertainty {
    /// Bands of `--sigma` standard deviations
    Sigma,
    /// Hard bounds: `force_sd_n` is the half width, a group spans its least to its greatest force
    Bounds,
}

/// Every soil that could have produced the measured forces.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Stroke table (CSV)
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub file: TableSource,

    /// Force model; `table` is the bracket of proven bounds
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model, help = model_help())]
    #[schemars(extend("enum" = MODEL_IDS))]
    pub model: String,

    /// Whether plates have ends, each its own width: the force is then above that of plane strain. By default they have them
    /// for the models that know ends (table, mckyes, perumpral, godwin-spoor, ovesen); the other models are of plane strain
    #[arg(long, value_name = "ENDS")]
    pub ends: Option<Ends>,

    /// By how much the end factor of a stroke may differ from one that all strokes share. It is the part of what ends add at most, by
    /// the proven bracket of `table`, that the ends of a plate do add. At 1 strokes share nothing
    #[arg(long = "end-tol", value_name = "PART", default_value_t = Request::default().end_tolerance, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub end_tolerance: f64,

    /// A model file, such as the patch of `diagnose`: its effects are taken out of the measured forces first, at the
    /// soil of the file
    #[arg(long, value_name = "PATCH")]
    pub model_file: Option<PathBuf>,

    /// Friction angle between soil and plate (deg), or `column` for what the table says: the measured friction_angle_deg where strokes
    /// of one kind are taken together, otherwise delta_set_deg
    #[arg(long = "delta", value_name = "DEG|column", default_value_t = Request::default().delta_deg, allow_negative_numbers = true)]
    #[schemars(extend("positional" = true))]
    pub delta_deg: NumberOrColumn,

    /// Half width of what is known of delta (deg)
    #[arg(long = "delta-tol", value_name = "DEG", default_value_t = Request::default().delta_tol_deg, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0))]
    pub delta_tol_deg: f64,

    /// Bulk density (kg/m3), or `column` for density_kg_m3 of the table; left out: unknown
    #[arg(long = "density", value_name = "KG/M3|column", allow_negative_numbers = true)]
    pub density_kg_m3: Option<NumberOrColumn>,

    /// Relative half width of what is known of the density
    #[arg(long, value_name = "FRACTION", default_value_t = Request::default().density_tol, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0), extend("exclusiveMaximum" = 1.0))]
    pub density_tol: f64,

    /// Probability with which all bands together hold their true forces, where strokes of one kind are taken together [default: 0.95].
    /// Left out, they are if the table says how forces scatter: if strokes are repeated, or it has depth_sd_m
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 1.0))]
    pub confidence: Option<f64>,

    /// Standard deviations that a band reaches on either side of the force; each stroke with force_sd_n has a band of its own then
    /// [default: 1 where strokes are not taken together]
    #[arg(long, value_name = "K", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub sigma: Option<f64>,

    /// What the uncertainty of a force means
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Request::default().uncertainty)]
    pub uncertainty: Uncertainty,

    /// Allow that forces at tool angles of 90 deg and more were read low by up to this fraction, because friction was
    /// not fully mobilised when failure was read (0.1 in Hong 2001, section 7.5.1)
    #[arg(long, value_name = "FRACTION", default_value_t = Request::default().adjust_high_angles, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0))]
    pub adjust_high_angles: f64,

    /// Take friction as a law of stress: it falls by so many degrees a decade of normal stress, known to lie between LOW and HIGH
    /// (`--friction-law` alone: 0:8). phi is then the friction angle at the reference stress
    #[arg(long, value_name = "LOW:HIGH", value_parser = slopes, num_args = 0..=1, require_equals = true,
          default_missing_value = "0:8")]
    pub friction_law: Option<(f64, f64)>,

    /// Normal stress at which phi is told (Pa), with a law of stress; default: the middle of the stresses in the strokes
    #[arg(long = "reference-stress", value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "friction_law")]
    pub reference_stress_pa: Option<f64>,

    /// Tests of the same soil in direct shear (a table of friction angles against normal stress), with a law of stress
    #[arg(long, value_name = "FILE", requires = "friction_law", value_hint = clap::ValueHint::AnyPath)]
    pub shear_box: Option<TableSource>,

    /// The soil in the table of direct shear; needed if it has several
    #[arg(long, value_name = "NAME", requires = "shear_box")]
    pub shear_soil: Option<String>,

    /// Half width of what a test in direct shear says of the friction angle (deg): its scatter, and what the box itself may be off by
    #[arg(long = "shear-tol", value_name = "DEG", default_value_t = Request::default().shear_tol_deg, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub shear_tol_deg: f64,

    /// Friction angles to search (deg), LOW:HIGH
    #[arg(long = "phi-range", value_name = "LOW:HIGH", value_parser = range)]
    pub phi_range_deg: Option<(f64, f64)>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub intervals: Intervals,

    /// Values of delta at which sections are shown (deg); default: the ends and the middle
    #[arg(long = "sections", value_name = "DEG,...", value_delimiter = ',', value_parser = finite)]
    pub sections_deg: Vec<f64>,

    /// Rank the next strokes by how much they would shrink the region
    #[arg(long)]
    pub next_strokes: bool,

    /// Tool angles to consider for the next stroke (deg)
    #[arg(long = "next-alpha", value_name = "DEG,...", value_delimiter = ',', value_parser = finite,
          default_values_t = Request::default().next_alpha_deg, requires = "next_strokes")]
    pub next_alpha_deg: Vec<f64>,

    /// Depths to consider for the next stroke (m); default: the depths of the table
    #[arg(long = "next-depth", value_name = "M,...", value_delimiter = ',', value_parser = finite, requires = "next_strokes")]
    pub next_depth_m: Vec<f64>,

    /// Plate widths to consider for the next stroke (m); default: the widths of the table
    #[arg(long = "next-width", value_name = "M,...", value_delimiter = ',', value_parser = finite, requires = "next_strokes")]
    pub next_width_m: Vec<f64>,

    /// Greatest force the arm can exert (N); dearer strokes are left out
    #[arg(long = "force-limit", value_name = "N", value_parser = finite, requires = "next_strokes")]
    pub force_limit_n: Option<f64>,

    /// Take the forces as exact: contour lines instead of bands
    #[arg(long)]
    pub exact: bool,

    /// Also run what one would otherwise use, downhill simplex and Levenberg-Marquardt from many starts
    #[arg(long)]
    pub compare: bool,

    /// Whether strokes at different depths are kept apart, for what asks whether ground changes with depth; no option
    #[arg(skip)]
    #[serde(skip)]
    pub tells_depths_apart: bool,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            file: TableSource::default(),
            model: "table".into(),
            ends: None,
            end_tolerance: 0.1,
            model_file: None,
            delta_deg: NumberOrColumn::Column,
            delta_tol_deg: 1.0,
            density_kg_m3: None,
            density_tol: 0.04,
            confidence: None,
            sigma: None,
            uncertainty: Uncertainty::Sigma,
            adjust_high_angles: 0.0,
            friction_law: None,
            reference_stress_pa: None,
            shear_box: None,
            shear_soil: None,
            shear_tol_deg: 2.0,
            phi_range_deg: None,
            loads: Loads::default(),
            intervals: Intervals::default(),
            sections_deg: Vec::new(),
            next_strokes: false,
            next_alpha_deg: vec![40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 110.0],
            next_depth_m: Vec::new(),
            next_width_m: Vec::new(),
            force_limit_n: None,
            exact: false,
            compare: false,
            tells_depths_apart: false,
        }
    }
}

/// How bands are made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum BandKind {
    /// Strokes of one kind together, all bands with this probability.
    Joint(f64),
    /// The same if the table says how forces scatter, otherwise by own deviations.
    AsTold(f64),
    /// Each measurement by its own deviation.
    Own,
}

/// Probability of all bands together, if nothing else is asked for.
const CONFIDENCE: f64 = 0.95;

impl Request {
    /// Standard deviations on either side of a measurement with a band of its own.
    pub(super) fn deviations(&self) -> f64 {
        self.sigma.unwrap_or(1.0)
    }

    /// How bands are made.
    pub(super) fn band_kind(&self) -> Result<BandKind, AppError> {
        let refused = |words: &str| Err(AppError::Request(words.to_owned()));
        match (self.confidence, self.sigma, self.uncertainty) {
            (_, Some(_), Uncertainty::Bounds) => {
                refused("--sigma has no meaning with --uncertainty bounds; leave one out")
            }
            (Some(_), _, Uncertainty::Bounds) => {
                refused("--confidence has no meaning with --uncertainty bounds; leave one out")
            }
            (Some(_), Some(_), Uncertainty::Sigma) => refused(
                "--confidence is for strokes of one kind together, --sigma for each by itself; leave one out",
            ),
            (Some(_), None, Uncertainty::Sigma) if self.exact => {
                refused("--confidence has no meaning with --exact; leave one out")
            }
            (Some(confidence), None, Uncertainty::Sigma) => Ok(BandKind::Joint(confidence)),
            (None, None, Uncertainty::Sigma) if !self.exact => Ok(BandKind::AsTold(CONFIDENCE)),
            (None, _, _) => Ok(BandKind::Own),
        }
    }
}

fn range(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once(':').ok_or("it must be LOW:HIGH, such as 30:45")?;
    let (low, high) = (finite(low)?, finite(high)?);
    if low < high { Ok((low, high)) } else { Err("LOW must be below HIGH".into()) }
}
