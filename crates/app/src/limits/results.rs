//! What the fields behind bounds show, in numbers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::results::{Contact, MOVING, Stretch};

use super::Fields;
use crate::AppError;

/// What the fields behind the bounds show.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ResultsAnswer {
    /// Unit of lengths: `m`, or `L` for slant lengths of the plate.
    pub length_unit: String,
    /// Unit of stresses: `kPa`, or `γL` for unit weight times slant length. Forces per width have this times the unit of
    /// length.
    pub stress_unit: String,
    /// Stretches of the ground that move in the upper bound's flow, by ascending x: at least at `moving` times the speed of
    /// the structure, or, if none moves, the greatest speed.
    pub moving_ground: Vec<StretchAnswer>,
    /// The fraction of the speed from which on soil is said to move.
    pub moving: f64,
    /// The faces of structures, with the resultants of the lower bound's contact stresses.
    pub contacts: Vec<ContactAnswer>,
    /// Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
    pub files: Vec<String>,
}

/// A stretch of ground, from its end at lesser x to that at greater x.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StretchAnswer {
    /// First end, x and y.
    pub from: [f64; 2],
    /// Last end, x and y.
    pub to: [f64; 2],
}

/// Contact stresses along a face.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ContactAnswer {
    /// `front`, `back` or `side` as seen along the structure's motion, `around` for a buried structure; numbered if there are
    /// several.
    pub face: String,
    /// Length of the face.
    pub length: f64,
    /// Resultant of the pressure, per unit width.
    pub normal_force: f64,
    /// Resultant of the shear stress on the soil, per unit width; positive downwards along the face, from its upper end.
    pub shear_force: f64,
    /// Distance of the pressure's resultant from the upper end, along the face; null if there is none.
    pub centre: Option<f64>,
    /// Greatest pressure.
    pub greatest_pressure: f64,
}

impl ResultsAnswer {
    /// What fields show.
    ///
    /// # Errors
    /// [`AppError::Request`] if there is no field.
    pub fn new(fields: &Fields) -> Result<Self, AppError> {
        let units = &fields.units;
        let stretches = fields.flow.as_ref().map_or_else(Vec::new, |f| f.moving_ground(MOVING));
        let stretch = |s: &Stretch| StretchAnswer { from: units.point(s.from), to: units.point(s.to) };
        let contacts = fields.stress.as_ref().map_or_else(Vec::new, |s| s.contacts());
        let names = face_names(&contacts, fields.statement()?.objective.velocity());
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
            files: Vec::new(),
        })
    }

    /// How far moving ground that starts at x = 0 reaches, to the right (1) or to the left (-1).
    pub(crate) fn reach(&self, sign: f64) -> f64 {
        self.moving_ground.iter().flat_map(|s| [s.from[0], s.to[0]]).fold(0.0, |most, x| most.max(sign * x))
    }
}

/// Names of faces: by where they look, seen along the structure's motion, numbered if there are several.
#[must_use]
pub fn face_names(contacts: &[Contact], direction: [f64; 2]) -> Vec<String> {
    let length = direction[0].hypot(direction[1]);
    let kind = |c: &Contact| {
        let towards = c.turned_towards(direction);
        // A closed face looks everywhere.
        if towards > 0.05 * c.length() * length {
            "front"
        } else if towards < -0.05 * c.length() * length {
            "back"
        } else {
            "side"
        }
    };
    let kinds: Vec<&str> = contacts.iter().map(|c| if c.closed { "around" } else { kind(c) }).collect();
    let name = |(i, kind): (usize, &&str)| {
        let same = |kinds: &[&str]| kinds.iter().filter(|k| k == &kind).count();
        match same(&kinds) {
            1 => (*kind).to_owned(),
            _ => format!("{kind} {}", same(&kinds[..=i])),
        }
    };
    kinds.iter().enumerate().map(name).collect()
}
