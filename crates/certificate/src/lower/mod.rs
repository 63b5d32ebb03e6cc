//! The lower bound: a stress field is proven statically admissible, and the force or factor that goes with it is the bound.

mod bending;
mod body_force;
mod covered;
pub(crate) mod element;
mod faces;
mod far;
mod force;
mod gauges;
mod given;
mod glue;
mod jets;
mod joined;
mod loads;
mod local;
mod members;
mod overburden;
mod references;
mod strength;
mod surfaces;
#[cfg(test)]
mod tests;

use crate::CertificateError;
use crate::ends::Splice;
use crate::fields::LowerField;
use crate::mesh::Side;
use crate::problem::Problem;
use crate::statement::{Condition, Objective, Statement};
use crate::tiling::{Beyond, Tiling, after};

use body_force::BodyForce;
use gauges::{Gauges, LocalJet};
use given::GivenLines;
use jets::Maker;
use loads::{Loads, Station};
pub(crate) use members::SectionForces;
use overburden::Overburden;
use references::ReferenceStresses;
use strength::Divisor;
use surfaces::Surfaces;

/// Proves a lower bound: on the force that the soil can resist times the structure's velocity, or on the factor of the
/// [objective](Objective).
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem or not covered, if the field is not built as it must be, or
/// if the soil or a face is not proven to bear the stresses.
pub fn prove_lower(statement: &Statement, field: &LowerField) -> Result<f64, CertificateError> {
    let problem = Problem::new(statement)?;
    let setting = Setting::new(&problem, field)?;
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let function = StressFunction::new(&problem, &setting, &tiling, field)?;
    function.check_recession()?;
    for triangle in 0..field.mesh.triangles.len() {
        let stresses = function.stresses(triangle);
        function.check_strength(triangle, &stresses)?;
        for (corner, part) in stresses.iter().enumerate() {
            let side = Side { triangle, corner };
            match tiling.beyond(side) {
                Beyond::Boundary(_, Condition::Face { delta_deg, adhesion }) => {
                    function.check_face(side, part, delta_deg, adhesion)?;
                }
                Beyond::Boundary(on, Condition::Far) => function.check_far(side, on, part)?,
                _ => {}
            }
        }
    }
    let attached = function.check_members(|triangle| function.stresses(triangle))?;
    let bound = match statement.objective {
        Objective::Structure { .. } => (function.power() + attached).lo(),
        Objective::Loads | Objective::Body { .. } | Objective::Everything => field.multiplier,
    };
    if bound > f64::NEG_INFINITY {
        Ok(bound)
    } else {
        Err(CertificateError::NotProven {
            quantity: "difference of the bound and the least number",
            place: "the whole field".into(),
            low: bound,
            unit: "force*velocity",
        })
    }
}

/// What members bear along their edges, in the order of [`Tiling::along_members`].
pub(crate) type MemberForces = Result<Vec<SectionForces>, CertificateError>;

/// Stresses at the nodes of the three parts of each triangle, and what members bear, on a checked mesh. No strength is checked.
pub(crate) fn node_stresses<T>(
    statement: &Statement,
    field: &LowerField,
    with: impl FnOnce(&Tiling, Vec<element::NodeStresses>, MemberForces) -> T,
) -> Result<T, CertificateError> {
    let problem = Problem::new(statement)?;
    let setting = Setting::new(&problem, field)?;
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let function = StressFunction::new(&problem, &setting, &tiling, field)?;
    let stresses = (0..field.mesh.triangles.len()).map(|t| function.stresses(t)).collect();
    Ok(with(&tiling, stresses, function.member_forces()))
}

/// What follows from the statement and the factor that is to be proven, whatever the mesh.
struct Setting {
    references: ReferenceStresses,
    loads: Loads,
    overburden: Overburden,
    divisor: Divisor,
    splice: Option<Splice>,
}

impl Setting {
    fn new(problem: &Problem, field: &LowerField) -> Result<Self, CertificateError> {
        let body_force = BodyForce::new(problem.statement, field);
        let references = ReferenceStresses::new(problem, &body_force)?;
        let loads = Loads::new(problem, &references, field)?;
        covered::check(problem)?;
        let overburden = Overburden::new(problem, &references, &body_force)?;
        let divisor = Divisor::new(problem.statement, field)?;
        let splice = Splice::new(problem)?;
        Ok(Self { references, loads, overburden, divisor, splice })
    }
}

/// A stress function on a checked mesh.
struct StressFunction<'a> {
    problem: &'a Problem<'a>,
    references: &'a ReferenceStresses,
    loads: &'a Loads,
    overburden: &'a Overburden,
    divisor: Divisor,
    splice: Option<Splice>,
    tiling: &'a Tiling<'a>,
    field: &'a LowerField,
    gauges: Gauges<'a>,
    given: GivenLines<'a>,
    surfaces: Surfaces<'a>,
    /// Where vertex copies are on free or loaded boundary.
    stations: Vec<Option<Station>>,
    /// Values and slopes of the vertex copies.
    jets: Vec<LocalJet>,
    /// For each vertex copy, whether the stress vanishes there, to the first order of its distance.
    apexes: Vec<bool>,
}

impl<'a> StressFunction<'a> {
    fn new(
        problem: &'a Problem<'a>,
        setting: &'a Setting,
        tiling: &'a Tiling<'a>,
        field: &'a LowerField,
    ) -> Result<Self, CertificateError> {
        let Setting { references, loads, overburden, divisor, splice } = setting;
        jets::check_numbers(problem, field, loads.count())?;
        let gauges = Gauges::new(problem, field)?;
        let (stations, apexes) = glue::check(problem, tiling, field, loads)?;
        let given =
            GivenLines::new(problem, references, tiling, field, &stations, |station| loads.jet(station).1)?;
        let surfaces = Surfaces::new(problem, references, loads, tiling, field, &stations, &apexes)?;
        let maker = Maker {
            problem,
            tiling,
            field,
            loads,
            stations: &stations,
            gauges: &gauges,
            given: &given,
            surfaces: &surfaces,
        };
        let jets = maker.jets()?;
        let surface = |copy: usize| surfaces.of_copy(copy);
        glue::check_branches(tiling, field, |copy| !given.at(copy).is_empty(), surface)?;
        let level =
            |surface: usize, station: Option<Station>| surfaces.is_level_from(surface, station, loads);
        given.check(field, &gauges, &stations, &apexes, &jets, level)?;
        let (divisor, splice) = (*divisor, *splice);
        Ok(Self {
            problem,
            references,
            loads,
            overburden,
            divisor,
            splice,
            tiling,
            field,
            gauges,
            given,
            surfaces,
            stations,
            jets,
            apexes,
        })
    }

    /// Vertex copies at the start and end of an edge.
    fn ends(&self, side: Side) -> [usize; 2] {
        ends(self.field, side)
    }
}

fn ends(field: &LowerField, side: Side) -> [usize; 2] {
    [1, 2].map(|i| field.corners[side.triangle][after(side.corner, i)])
}
