//! Results in answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::results::{Contact, MOVING};

use super::Shown;
use super::contact::names;
use super::frame::statement;
use crate::error::CliError;
use crate::text::{columns, number};

/// What the fields behind the bounds show.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ResultsAnswer {
    /// Unit of lengths: `m`, or `L` for slant lengths of the plate.
    length_unit: String,
    /// Unit of stresses: `kPa`, or `γL` for unit weight times slant length. Forces per width have this times the unit of
    /// length.
    stress_unit: String,
    /// Stretches of the ground that move in the upper bound's flow, by ascending x: at least at `moving` times the speed of
    /// the structure, or, if none moves, the greatest speed.
    moving_ground: Vec<StretchAnswer>,
    /// The fraction of the speed from which on soil is said to move.
    moving: f64,
    /// The faces of structures, with the resultants of the lower bound's contact stresses.
    contacts: Vec<ContactAnswer>,
    /// Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
    files: Vec<String>,
}

/// A stretch of ground, from its end at lesser x to that at greater x.
#[derive(Debug, Serialize, JsonSchema)]
struct StretchAnswer {
    /// First end, x and y.
    from: [f64; 2],
    /// Last end, x and y.
    to: [f64; 2],
}

/// Contact stresses along a face.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct ContactAnswer {
    /// `front`, `back` or `side` as seen along the structure's motion, `around` for a buried structure; numbered if there are
    /// several.
    pub(super) face: String,
    /// Length of the face.
    pub(super) length: f64,
    /// Resultant of the pressure, per unit width.
    pub(super) normal_force: f64,
    /// Resultant of the shear stress on the soil, per unit width; positive downwards along the face, from its upper end.
    pub(super) shear_force: f64,
    /// Distance of the pressure's resultant from the upper end, along the face; null if there is none.
    pub(super) centre: Option<f64>,
    /// Greatest pressure.
    pub(super) greatest_pressure: f64,
}

impl ResultsAnswer {
    pub(crate) fn new(shown: &Shown, files: Vec<String>) -> Result<Self, CliError> {
        let units = &shown.units;
        let stretches = shown.flow.as_ref().map_or_else(Vec::new, |f| f.moving_ground(MOVING));
        let stretch = |s: &soilctl_limit_analysis::results::Stretch| StretchAnswer {
            from: units.point(s.from),
            to: units.point(s.to),
        };
        let contacts = shown.stress.as_ref().map_or_else(Vec::new, |s| s.contacts());
        let names = names(&contacts, statement(shown)?.objective.velocity());
        let force = units.length * units.stress;
        let answer = |(c, face): (&Contact, String)| ContactAnswer {
            face,
            length: units.length * c.length(),
            normal_force: force * c.normal_force(),
            shear_force: force * c.shear_force(),
            centre: c.centre().map(|x| units.length * x),
            greatest_pressure: units.stress * c.points.iter().map(|p| p.pressure).fold(f64::MIN, f64::max),
        };
        Ok(Self {
            length_unit: units.length_name.clone(),
            stress_unit: units.stress_name.clone(),
            moving_ground: stretches.iter().map(stretch).collect(),
            moving: MOVING,
            contacts: contacts.iter().zip(names).map(answer).collect(),
            files,
        })
    }

    /// How far moving ground that starts at x = 0 reaches, to the right (1) or to the left (-1).
    pub(crate) fn reach(&self, sign: f64) -> f64 {
        self.moving_ground.iter().flat_map(|s| [s.from[0], s.to[0]]).fold(0.0, |most, x| most.max(sign * x))
    }

    /// Adds files that were written.
    pub(super) fn add_files(&mut self, files: Vec<String>) {
        self.files.extend(files);
    }

    /// Only the names of the files.
    pub(crate) fn into_files(self) -> Vec<String> {
        self.files
    }

    pub(super) fn length_unit(&self) -> &str {
        &self.length_unit
    }

    pub(super) fn stress_unit(&self) -> &str {
        &self.stress_unit
    }

    pub(super) fn contacts(&self) -> &[ContactAnswer] {
        &self.contacts
    }

    /// From and to of x along moving ground.
    pub(super) fn stretches(&self) -> impl Iterator<Item = [f64; 2]> {
        self.moving_ground.iter().map(|s| [s.from[0], s.to[0]])
    }

    /// The same in words.
    pub(crate) fn text(&self) -> String {
        let (unit, stress) = (&self.length_unit, &self.stress_unit);
        let mut text = String::new();
        for s in &self.moving_ground {
            let [a, b] = [s.from[0], s.to[0]].map(|x| number(rounded(x)));
            text += &format!("moving ground  x = {a} to {b} {unit}\n");
        }
        if !self.contacts.is_empty() {
            let header = [
                "face".to_owned(),
                format!("pressure, {stress} {unit}"),
                "shear".into(),
                format!("centre, {unit}"),
            ];
            let mut rows = vec![header.to_vec()];
            for c in &self.contacts {
                let forces = [c.normal_force, c.shear_force].map(|f| number(rounded(f)));
                let centre = c.centre.map_or_else(|| "-".into(), |x| number(rounded(x)));
                rows.push([&[c.face.clone()][..], &forces, &[centre]].concat());
            }
            text += &columns(&rows);
        }
        for file in &self.files {
            text += &format!("written: {file}\n");
        }
        text
    }
}

/// Four digits: these numbers are not proven.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
