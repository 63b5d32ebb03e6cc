//! What `solve --check` answers: the file as it was understood.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::Condition;
use soilctl_limit_analysis::describe::Aim;
use soilctl_limit_analysis::{Described, Description};

use super::answer::{SAFETY, names};
use crate::output::Words;
use crate::text::{columns, number};

/// A problem file as it was understood.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CheckAnswer {
    /// Title of the problem; null if it has none.
    title: Option<String>,
    /// What `solve` would bound.
    quantity: &'static str,
    /// Unit of length of the solver in m.
    length_m: f64,
    /// Unit of stress of the solver in kPa.
    stress_kpa: f64,
    /// Regions of one soil after cutting.
    regions: Vec<CheckedRegion>,
    /// Total length of boundary with each condition.
    boundaries: Vec<CheckedBoundary>,
    #[serde(skip)]
    words: &'static str,
}

/// A region after cutting.
#[derive(Debug, Serialize, JsonSchema)]
struct CheckedRegion {
    /// Area in m2.
    area_m2: f64,
    /// Friction angle.
    phi_deg: f64,
    /// Least and greatest cohesion at its corners.
    cohesion_kpa: [f64; 2],
    /// Unit weight.
    unit_weight_kn_m3: f64,
    /// Least and greatest pore pressure at its corners.
    pore_pressure_kpa: [f64; 2],
}

/// All boundary with one condition.
#[derive(Debug, Serialize, JsonSchema)]
struct CheckedBoundary {
    /// The condition.
    kind: &'static str,
    /// Its length, of both faces for plates.
    length_m: f64,
}

pub(super) const KINDS: [&str; 6] = ["free", "load", "fixed", "smooth", "far", "face"];

pub(super) fn kind(condition: &Condition) -> &'static str {
    KINDS[match condition {
        Condition::Free => 0,
        Condition::Loaded { .. } => 1,
        Condition::Fixed => 2,
        Condition::Smooth => 3,
        Condition::Far => 4,
        Condition::Face { .. } => 5,
    }]
}

impl CheckAnswer {
    pub(super) fn new(description: &Description, described: &Described) -> Self {
        let s = &described.statement;
        let (long, stress) = (described.length_m, described.stress_kpa);
        let [quantity, words] = match description.objective {
            Aim::StrengthReduction {} => SAFETY,
            _ => names(described.quantity),
        };
        let regions = s.regions.iter().map(|r| {
            let (mut area, mut cohesion, mut pore) = (0.0, Span::default(), Span::default());
            for used in r.loops.iter().flatten() {
                let line = s.lines[used.line];
                let (from, to) = if used.forward { (line.from, line.to) } else { (line.to, line.from) };
                let [a, b] = [from, to].map(|p| s.points[p]);
                area += 0.5 * (a[0] * b[1] - a[1] * b[0]) * long * long;
                let at = |l: &soilctl_certificate::Linear| {
                    stress * (l.at_origin + l.gradient[0] * a[0] + l.gradient[1] * a[1])
                };
                cohesion.add(at(&r.material.cohesion));
                pore.add(at(&r.material.pore_pressure));
            }
            CheckedRegion {
                area_m2: area,
                phi_deg: r.material.phi_deg,
                cohesion_kpa: cohesion.ends(),
                unit_weight_kn_m3: r.material.unit_weight * stress / long,
                pore_pressure_kpa: pore.ends(),
            }
        });
        let length = |name: &str| {
            let sides = s.boundaries.iter().filter(|b| kind(&b.condition) == name);
            let length = sides.map(|b| {
                let [a, c] = [s.lines[b.line].from, s.lines[b.line].to].map(|p| s.points[p]);
                (c[0] - a[0]).hypot(c[1] - a[1])
            });
            length.sum::<f64>() * long
        };
        let boundaries = KINDS.map(|kind| CheckedBoundary { kind, length_m: length(kind) });
        Self {
            title: described.title.clone(),
            quantity,
            length_m: long,
            stress_kpa: stress,
            regions: regions.collect(),
            boundaries: boundaries.into_iter().filter(|b| b.length_m > 0.0).collect(),
            words,
        }
    }
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

impl soilctl_app::Answer for CheckAnswer {
    const SCHEMA: &'static str = "soilctl.solve-check/1";
}

impl Words for CheckAnswer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        let [long, stress] = [number(self.length_m), number(self.stress_kpa)];
        text += &format!("asked for: {}\nunits: {long} m, {stress} kPa\n\n", self.words);
        let header = ["area m2", "phi deg", "cohesion kPa", "weight kN/m3", "pore pressure kPa"];
        let mut rows = vec![header.map(str::to_owned).to_vec()];
        let span = |[low, high]: [f64; 2]| {
            if low == high { number(low) } else { format!("{} to {}", number(low), number(high)) }
        };
        for r in &self.regions {
            let [c, u] = [r.cohesion_kpa, r.pore_pressure_kpa].map(span);
            rows.push(vec![number(r.area_m2), number(r.phi_deg), c, number(r.unit_weight_kn_m3), u]);
        }
        text += &columns(&rows);
        text += "\n";
        let mut rows = vec![["boundary", "length m"].map(str::to_owned).to_vec()];
        rows.extend(self.boundaries.iter().map(|b| vec![b.kind.to_owned(), number(b.length_m)]));
        text + &columns(&rows)
    }
}
