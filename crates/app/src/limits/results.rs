//! What the fields behind bounds show, in numbers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{Bending, Member};
use soilctl_limit_analysis::results::{
    BeamForces, Contact, FlowResults, MOVING, MemberForces, MemberStretch, StressResults, Stretch, farthest,
    greatest, least,
};

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
    /// Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the upper bound's flow.
    pub members: Vec<MemberAnswer>,
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

/// A bar, a sheet or a beam. Forces are per unit width, tension positive; for a factor of safety those of soil whose strength is divided by its
/// lower bound.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MemberAnswer {
    /// Its name.
    pub name: String,
    /// Greatest tension that it bears.
    pub tensile_strength: f64,
    /// Greatest compression that it bears.
    pub compressive_strength: f64,
    /// Greatest tension in the field of the lower bound; zero if there is none, null if there is no field.
    pub greatest_tension: Option<f64>,
    /// Distance of that from its start.
    pub greatest_tension_at: Option<f64>,
    /// Greatest compression likewise, as a positive number.
    pub greatest_compression: Option<f64>,
    /// The greatest of these over the strength for it: how far it is used; of a beam with its moment and shear force.
    pub utilisation: Option<f64>,
    /// The axial force along it: distances from its start, and the force there.
    pub axial_force: Vec<[f64; 2]>,
    /// What it gets longer in the flow of the upper bound, over the speed that others are compared with; null if there is no flow. Not
    /// zero where it yields.
    pub gets_longer: Option<f64>,
    /// What it gets shorter, likewise.
    pub gets_shorter: Option<f64>,
    /// The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they are pulled out. Null for sheets and beams.
    pub slip: Option<f64>,
    /// How a beam bends; null for a bar or a sheet.
    pub bending: Option<BendingAnswer>,
}

/// How a beam bends.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BendingAnswer {
    /// Greatest bending moment that it bears, per unit width (force).
    pub moment_strength: f64,
    /// The moment that is farthest from zero in the field of the lower bound, positive where it stretches the beam's right side.
    pub greatest_moment: Option<f64>,
    /// Distance of that from its start.
    pub greatest_moment_at: Option<f64>,
    /// Greatest shear force that it bears, per unit width.
    pub shear_strength: f64,
    /// The shear force that is farthest from zero, per unit width.
    pub greatest_shear: Option<f64>,
    /// The moment along it: distances from its start, and the moment there.
    pub moment: Vec<[f64; 2]>,
    /// The shear force along it, likewise.
    pub shear: Vec<[f64; 2]>,
    /// Where it yields in the flow of the upper bound: distances from its start, and how fast it turns there, over the speed that others are
    /// compared with (1/length).
    pub hinges: Vec<[f64; 2]>,
}

impl BendingAnswer {
    fn new(
        fields: &Fields,
        most: Bending,
        forces: Option<&BeamForces>,
        stretch: Option<&MemberStretch>,
    ) -> Self {
        let (length, force) = (fields.units.length, fields.units.length * fields.units.stress);
        let speed = fields.flow.as_ref().map_or(1.0, FlowResults::speed);
        let course = |course: &[[f64; 2]], unit: f64| -> Vec<[f64; 2]> {
            course.iter().map(|[at, value]| [length * at, unit * value]).collect()
        };
        let moment = forces.map(|forces| farthest(&forces.moment));
        Self {
            moment_strength: force * length * most.moment,
            greatest_moment: moment.map(|[_, value]| force * length * value),
            greatest_moment_at: moment.map(|[at, _]| length * at),
            shear_strength: force * most.shear,
            greatest_shear: forces.map(|forces| force * farthest(&forces.shear)[1]),
            moment: forces.map_or_else(Vec::new, |forces| course(&forces.moment, force * length)),
            shear: forces.map_or_else(Vec::new, |forces| course(&forces.shear, force)),
            hinges: stretch.map_or_else(Vec::new, |stretch| course(&stretch.hinges, 1.0 / (speed * length))),
        }
    }

    /// How far the beam is used.
    fn used(&self) -> f64 {
        let part = |value: Option<f64>, most: f64| value.map_or(0.0, |value| value.abs() / most);
        part(self.greatest_moment, self.moment_strength).max(part(self.greatest_shear, self.shear_strength))
    }
}

/// Bars that slip in the soil by less than this part of the speed that others are compared with move along with it.
const SLIPS: f64 = 0.05;

impl MemberAnswer {
    /// How it yields in the flow of the upper bound, in words.
    #[must_use]
    pub fn yields(&self) -> &'static str {
        let Some((longer, shorter)) = self.gets_longer.zip(self.gets_shorter) else { return "-" };
        match (longer + shorter > 0.0, self.slip.is_some_and(|slip| slip > SLIPS)) {
            (false, false) => "no",
            (true, false) => "stretches",
            (false, true) => "slips",
            (true, true) => "stretches, slips",
        }
    }

    /// All members of what fields show.
    fn all(fields: &Fields) -> Result<Vec<Self>, AppError> {
        let units = &fields.units;
        let unit = units.length * units.stress;
        let forces = fields.stress.as_ref().map(StressResults::member_forces);
        let stretches = fields.flow.as_ref().map(FlowResults::member_stretches);
        let speed = fields.flow.as_ref().map_or(1.0, FlowResults::speed);
        let of = |(i, member): (usize, &Member)| {
            let force = forces.as_ref().and_then(|all| all.iter().find(|force| force.member == i));
            let stretch = stretches.as_ref().and_then(|all| all.get(i));
            let axial = force.map(|force: &MemberForces| &force.axial);
            let [most, least] = [axial.map(|course| greatest(course)), axial.map(|course| least(course))];
            let tension = most.map(|[_, force]| force.max(0.0));
            let compression = least.map(|[_, force]| (-force).max(0.0));
            let part = |force: f64, strength: f64| if force > 0.0 { force / strength } else { 0.0 };
            let used = tension
                .zip(compression)
                .map(|(t, c)| part(t, member.tension).max(part(c, member.compression)));
            let bending = member.bending.map(|most| {
                BendingAnswer::new(fields, most, force.and_then(|force| force.bending.as_ref()), stretch)
            });
            Self {
                name: if member.name.is_empty() { format!("{}", i + 1) } else { member.name.clone() },
                tensile_strength: unit * member.tension,
                compressive_strength: unit * member.compression,
                greatest_tension: tension.map(|force| unit * force),
                greatest_tension_at: most.map(|[at, _]| units.length * at),
                greatest_compression: compression.map(|force| unit * force),
                utilisation: used
                    .map(|used| bending.as_ref().map_or(used, |bending| bending.used().max(used))),
                axial_force: force.map_or_else(Vec::new, |force| {
                    force.axial.iter().map(|[at, force]| [units.length * at, unit * force]).collect()
                }),
                gets_longer: stretch.map(|s| s.longer / speed),
                gets_shorter: stretch.map(|s| s.shorter / speed),
                slip: stretch.and_then(|s| s.slip).map(|slip| slip / speed),
                bending,
            }
        };
        Ok(fields.statement()?.members.iter().enumerate().map(of).collect())
    }
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
            members: MemberAnswer::all(fields)?,
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
