//! Reads a problem file and says what it was understood to mean; solves nothing.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_certificate::Linear;
use soilctl_limit_analysis::describe::{Case, MemberEnd, MemberEntry, Profile};
use soilctl_limit_analysis::{Described, Description, LimitError};

use super::{Asked, BoundaryKind, SeepageAnswer};
use crate::{AppError, Watch, plausible};

/// Reads a problem file and says what it was understood to mean.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Problem file, .toml or .json
    pub file: PathBuf,
}

/// The answer, and the file in both forms.
#[derive(Debug)]
pub struct Checked {
    /// The answer.
    pub answer: Answer,
    /// The file.
    pub description: Description,
    /// The same cut into regions, in the units of the solver.
    pub described: Described,
}

/// Reads the file. What hardly anybody means is told as notes too.
///
/// # Errors
/// [`AppError`] if it cannot be read or makes no sense.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Checked, AppError> {
    of(Description::read(&request.file).map_err(LimitError::from)?, watch)
}

/// What a description was understood to mean.
///
/// # Errors
/// [`AppError`] if it makes no sense.
pub fn of(description: Description, watch: &dyn Watch) -> Result<Checked, AppError> {
    let described = description.described()?;
    let cases = description.cases().map_err(LimitError::from)?;
    for case in &cases {
        // Values may be out of their range in one case only.
        case.description.described()?;
    }
    let notes = plausible::of_file(&description, &cases);
    notes.iter().for_each(|note| watch.note(note));
    let mut answer = Answer::new(&description, &described, notes);
    answer.cases = cases.iter().map(CheckedCase::new).collect();
    Ok(Checked { answer, description, described })
}

/// A problem file as it was understood.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Title of the problem; null if it has none.
    pub title: Option<String>,
    /// What `solve` would bound.
    pub quantity: Asked,
    /// Unit of length of the solver in m.
    pub length_m: f64,
    /// Unit of stress of the solver in kPa.
    pub stress_kpa: f64,
    /// Regions of one soil after cutting; all of one soil as one where ground water flows.
    pub regions: Vec<CheckedRegion>,
    /// Total length of boundary with each condition.
    pub boundaries: Vec<CheckedBoundary>,
    /// Bars and sheets.
    pub members: Vec<CheckedMember>,
    /// How ground water flows between given heads; null if it does not.
    pub seepage: Option<SeepageAnswer>,
    /// Values that are possible but unusual, with what is usual and a likely cause.
    pub notes: Vec<String>,
    /// Cases, with the values of sweeps; empty if there are none.
    pub cases: Vec<CheckedCase>,
}

/// A case of the file.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckedCase {
    /// Its name, with the values of the sweeps.
    pub name: String,
    /// The values that it sets, by parameter.
    pub values: BTreeMap<String, f64>,
    /// Its partial factors other than one.
    pub factors: BTreeMap<String, f64>,
}

impl CheckedCase {
    fn new(case: &Case) -> Self {
        let factors = case.factors.named().into_iter().filter_map(|(key, value)| {
            let name = key.rsplit('.').next().unwrap_or(key);
            value.filter(|v| *v != 1.0).map(|value| (name.to_owned(), value))
        });
        Self { name: case.name.clone(), values: case.values.clone(), factors: factors.collect() }
    }
}

/// A region after cutting.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckedRegion {
    /// Name of the soil.
    pub soil: String,
    /// Area in m2.
    pub area_m2: f64,
    /// Friction angle.
    pub phi_deg: f64,
    /// Least and greatest cohesion at its corners.
    pub cohesion_kpa: [f64; 2],
    /// Unit weight.
    pub unit_weight_kn_m3: f64,
    /// Least and greatest pore pressure at its corners.
    pub pore_pressure_kpa: [f64; 2],
}

/// A bar, a sheet or a beam.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckedMember {
    /// Its name.
    pub name: String,
    /// Its length.
    pub length_m: f64,
    /// Greatest tension that it bears.
    pub tensile_kn_per_m: f64,
    /// Greatest compression that it bears.
    pub compressive_kn_per_m: f64,
    /// What each face bears of the shear strength of the soil beside it.
    pub bond_factor: f64,
    /// What the soil that goes on between a row of bars hands to each metre, at the start and the end; null for sheets and beams, which
    /// have faces.
    pub pullout_kn_per_m2: Option<[f64; 2]>,
    /// Length from the start along which it hands bars nothing.
    pub free_length_m: f64,
    /// Whether its start and its end are attached to what is there, and so may bear a force.
    pub attached: [bool; 2],
    /// Greatest bending moment that a beam bears; null for a bar or a sheet.
    pub moment_knm_per_m: Option<f64>,
    /// Greatest shear force of a beam.
    pub shear_kn_per_m: Option<f64>,
}

impl CheckedMember {
    fn new(member: &MemberEntry) -> Self {
        Self {
            name: member.name.clone(),
            length_m: member.length_m(),
            tensile_kn_per_m: member.tensile_kn_per_m,
            compressive_kn_per_m: member.compressive_kn_per_m,
            bond_factor: member.bond_factor,
            pullout_kn_per_m2: member.pullout_kn_per_m2.map(Profile::ends),
            free_length_m: member.free_length_m,
            attached: [MemberEnd::Start, MemberEnd::End].map(|end| member.attached.contains(&end)),
            moment_knm_per_m: member.moment_knm_per_m,
            shear_kn_per_m: member.shear_kn_per_m,
        }
    }
}

/// All boundary with one condition.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckedBoundary {
    /// The condition.
    pub kind: BoundaryKind,
    /// Its length, of both faces for plates.
    pub length_m: f64,
}

impl Answer {
    fn new(description: &Description, described: &Described, notes: Vec<String>) -> Self {
        let s = &described.statement;
        let (long, stress) = (described.length_m, described.stress_kpa);
        let regions = s.regions.iter().zip(&described.soils).map(|(r, soil)| {
            let (mut area, mut cohesion, mut pore) = (0.0, Span::default(), Span::default());
            for used in r.loops.iter().flatten() {
                let line = s.lines[used.line];
                let (from, to) = if used.forward { (line.from, line.to) } else { (line.to, line.from) };
                let [a, b] = [from, to].map(|p| s.points[p]);
                area += 0.5 * (a[0] * b[1] - a[1] * b[0]) * long * long;
                let at = |l: &Linear| stress * (l.at_origin + l.gradient[0] * a[0] + l.gradient[1] * a[1]);
                cohesion.add(at(&r.material.cohesion));
                // Of a plane through dry points only its rounding is left there.
                let water = at(&r.material.pore_pressure);
                pore.add(if water.abs() > 1e-9 * stress { water } else { 0.0 });
            }
            CheckedRegion {
                soil: soil.clone(),
                area_m2: area,
                phi_deg: r.material.phi_deg,
                cohesion_kpa: cohesion.ends(),
                unit_weight_kn_m3: r.material.unit_weight * stress / long,
                pore_pressure_kpa: pore.ends(),
            }
        });
        let length = |kind: BoundaryKind| {
            let sides = s.boundaries.iter().filter(|b| BoundaryKind::from(&b.condition) == kind);
            let length = sides.map(|b| {
                let [a, c] = [s.lines[b.line].from, s.lines[b.line].to].map(|p| s.points[p]);
                (c[0] - a[0]).hypot(c[1] - a[1])
            });
            length.sum::<f64>() * long
        };
        let boundaries = BoundaryKind::ALL.map(|kind| CheckedBoundary { kind, length_m: length(kind) });
        Self {
            title: described.title.clone(),
            quantity: Asked::of(description, described),
            length_m: long,
            stress_kpa: stress,
            regions: if described.flowed.is_some() { merged(regions) } else { regions.collect() },
            boundaries: boundaries.into_iter().filter(|b| b.length_m > 0.0).collect(),
            members: description.members.iter().map(CheckedMember::new).collect(),
            cases: Vec::new(),
            seepage: SeepageAnswer::of(described),
            notes,
        }
    }
}

/// Regions of like soil as one: where water flows there are many.
fn merged(regions: impl Iterator<Item = CheckedRegion>) -> Vec<CheckedRegion> {
    let mut all: Vec<CheckedRegion> = Vec::new();
    for region in regions {
        let is_like = |other: &CheckedRegion| {
            other.soil == region.soil && other.unit_weight_kn_m3 == region.unit_weight_kn_m3
        };
        let Some(one) = all.iter_mut().find(|other| is_like(other)) else {
            all.push(region);
            continue;
        };
        one.area_m2 += region.area_m2;
        for (span, other) in [
            (&mut one.cohesion_kpa, region.cohesion_kpa),
            (&mut one.pore_pressure_kpa, region.pore_pressure_kpa),
        ] {
            *span = [span[0].min(other[0]), span[1].max(other[1])];
        }
    }
    all
}

/// Least and greatest of some values.
#[derive(Default)]
struct Span(Option<[f64; 2]>);

impl Span {
    fn add(&mut self, value: f64) {
        let [low, high] = self.0.unwrap_or([value; 2]);
        self.0 = Some([low.min(value), high.max(value)]);
    }

    fn ends(&self) -> [f64; 2] {
        self.0.unwrap_or([0.0; 2])
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.solve-check/1";
}
