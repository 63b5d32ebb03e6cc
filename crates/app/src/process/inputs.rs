//! What the options ask for: which logs under which names, and how they are read.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use soilctl_jobs::Shard;
use soilctl_process::log::{LogSettings, Sense};
use soilctl_process::table::Form;

use super::request::{Bag, Request, WrenchSense};
use super::windows::windows;
use crate::AppError;
use crate::files::failed;
use crate::machine::cores;

/// Most logs of one run.
const MOST_LOGS: usize = 1_000_000;

/// A log and what its strokes are named after.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Log {
    pub(crate) path: PathBuf,
    pub(crate) name: String,
}

#[derive(Debug)]
pub(crate) struct Inputs {
    pub(crate) logs: Vec<Log>,
    pub(crate) settings: LogSettings,
    /// Topic of clouds of points, if it was named.
    pub(crate) scan_topic: Option<String>,
    pub(crate) trace_rate_hz: f64,
    pub(crate) threads: usize,
    pub(crate) out: Option<(PathBuf, Form)>,
    pub(crate) shard: Option<Shard>,
}

impl Inputs {
    /// Places of the logs that this run is about.
    pub(crate) fn own(&self) -> impl Iterator<Item = usize> {
        (0..self.logs.len()).filter(|place| self.shard.is_none_or(|shard| shard.has(*place)))
    }

    pub(crate) fn of(request: &Request) -> Result<Self, AppError> {
        let mut paths = BTreeSet::new();
        for given in &request.logs {
            if given.is_dir() && !soilctl_bag::is_recording(given) {
                collect(given, &mut paths)?;
            } else {
                paths.insert(given.clone());
            }
        }
        if paths.is_empty() {
            let folders: Vec<String> = request.logs.iter().map(|path| path.display().to_string()).collect();
            return Err(AppError::Request(format!(
                "there is no recording (.mcap, .db3, .bag, or the folder of a split bag) in {}",
                folders.join(", ")
            )));
        }
        Ok(Self {
            logs: named(paths),
            settings: settings(&request.bag)?,
            scan_topic: request.bag.scan_topic.clone(),
            trace_rate_hz: request.trace_rate_hz,
            threads: request.threads.map_or_else(cores, |threads| threads as usize),
            shard: request.shard,
            out: request
                .out
                .as_deref()
                .map(|path| Ok::<_, AppError>((path.to_owned(), form(path)?)))
                .transpose()?,
        })
    }
}

/// Every recording below a folder; that of a split bag is one.
fn collect(folder: &Path, paths: &mut BTreeSet<PathBuf>) -> Result<(), AppError> {
    for entry in std::fs::read_dir(folder).map_err(failed(folder))? {
        let entry = entry.map_err(failed(folder))?;
        let path = entry.path();
        // Links to folders are not followed, so that a ring of them cannot catch us.
        if soilctl_bag::is_recording(&path) {
            paths.insert(path);
        } else if entry.file_type().map_err(failed(folder))?.is_dir() {
            collect(&path, paths)?;
        }
        if paths.len() > MOST_LOGS {
            return Err(AppError::Request(format!(
                "{} holds more than {MOST_LOGS} logs; give parts of it",
                folder.display()
            )));
        }
    }
    Ok(())
}

/// Logs are named after their files, with as much of the folders as tells them apart.
fn named(paths: BTreeSet<PathBuf>) -> Vec<Log> {
    let name = |path: &Path, parts: usize| {
        let stem = path.with_extension("");
        let all: Vec<_> = stem.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        all[all.len().saturating_sub(parts)..].join("/")
    };
    let mut depth: BTreeMap<&PathBuf, usize> = paths.iter().map(|path| (path, 1)).collect();
    // A few rounds do: folders deeper than that have nothing left to add.
    for _ in 0..32 {
        let mut users: BTreeMap<String, Vec<&PathBuf>> = BTreeMap::new();
        for (path, parts) in &depth {
            users.entry(name(path, *parts)).or_default().push(path);
        }
        let same: Vec<&PathBuf> = users.into_values().filter(|all| all.len() > 1).flatten().collect();
        if same.is_empty() {
            break;
        }
        for path in same {
            *depth.entry(path).or_insert(1) += 1;
        }
    }
    let names: Vec<String> = depth.iter().map(|(path, parts)| name(path, *parts)).collect();
    paths.iter().cloned().zip(names).map(|(path, name)| Log { path, name }).collect()
}

fn form(path: &Path) -> Result<Form, AppError> {
    let refused = || format!("--out is {}; the name must end in .csv or .parquet", path.display());
    Form::of(path).ok_or_else(|| AppError::Request(refused()))
}

fn settings(bag: &Bag) -> Result<LogSettings, AppError> {
    let tare = match bag.tare.as_deref() {
        None => None,
        Some(&[x, y, z]) => Some([x, y, z, 0.0, 0.0, 0.0]),
        Some(&[x, y, z, a, b, c]) => Some([x, y, z, a, b, c]),
        Some(other) => {
            return Err(AppError::Request(format!(
                "--tare has {} numbers; give three forces, or three forces and three moments",
                other.len()
            )));
        }
    };
    Ok(LogSettings {
        joint_topic: bag.topics.joint_topic.clone(),
        wrench_topic: bag.topics.wrench_topic.clone(),
        urdf: bag.topics.urdf_text()?,
        plate_frame: bag.plate_frame.clone(),
        sensor_frame: bag.topics.sensor_frame.clone(),
        surface_z_m: bag.topics.surface_z_m,
        alpha_deg: bag.alpha_deg,
        width_m: bag.width_m,
        delta_set_deg: bag.delta_set_deg,
        tare,
        tool_weight_n: bag.tool_weight_n,
        sense: match bag.wrench_sense {
            WrenchSense::SoilOnPlate => Sense::SoilOnPlate,
            WrenchSense::PlateOnSoil => Sense::PlateOnSoil,
        },
        windows: bag.strokes.as_ref().map(windows).transpose()?,
    })
}
