//! Surfaces of soil without cohesion: there the effective stress vanishes, so that the second derivatives of the stress function are known.
//!
//! The stress function is looked for beyond the cubic polynomial that has them; `soilctl_certificate` says which, and why.

use soilctl_certificate::{Boundary, Condition, LineUse, Linear};
use soilctl_conic::Form;

use super::loads::Loads;
use super::reference::ReferenceStress;
use crate::problem::Problem;
use crate::vector::{Point, between, distance, dot, turned};

/// Number of the polynomial that is zero.
pub(super) const AT_REST: usize = 0;

/// Cohesion over the weight of as much soil as the side is long, up to which it is next to none.
const WEAK: f64 = 0.05;

fn bare(problem: &Problem, side: LineUse, condition: Condition) -> bool {
    let region = problem.owner(side);
    condition.leaves_bare(problem.statement().surcharge)
        && region.is_some_and(|r| problem.soils[r].cohesion.is_zero())
}

/// Whether the effective stress must vanish on a side.
pub(crate) fn is_bare(problem: &Problem, side: LineUse) -> bool {
    problem.condition(side).is_some_and(|condition| bare(problem, side, condition))
}

/// Whether a free side is of soil with friction that has next to no cohesion, if any.
pub(crate) fn is_weak(problem: &Problem, side: LineUse) -> bool {
    let statement = problem.statement();
    let Some(soil) = problem.owner(side).map(|region| &problem.soils[region]) else { return false };
    let [p, q] = problem.ends(side.line);
    let weight = soil.unit_weight * statement.gravity[0].hypot(statement.gravity[1]) * distance(p, q);
    let cohesion = soil.cohesion.at(p).max(soil.cohesion.at(q));
    let is_free = problem.condition(side).is_some_and(|condition| condition.leaves_bare(statement.surcharge));
    is_free && soil.tan > 0.0 && cohesion <= WEAK * weight
}

/// The numbers of the surfaces that bare sides belong to, as the certificate counts them: those on the datum before which
/// nothing acts are at rest.
pub(super) fn numbers(problem: &Problem, loads: &Loads) -> Vec<(LineUse, usize)> {
    let statement = problem.statement();
    let mut count = AT_REST;
    let in_water = |b: &&Boundary| b.condition == Condition::Submerged;
    let sides = || statement.boundaries.iter().filter(|b| bare(problem, b.side(), b.condition));
    let (dry, wet) = (sides().filter(|b| !in_water(b)), sides().filter(in_water));
    dry.chain(wet)
        .map(|b| {
            let on_datum = !in_water(&b) && problem.ends(b.line).iter().all(|p| p[1] == statement.datum);
            if on_datum && loads.is_at_rest_up_to(b.side()) {
                return (b.side(), AT_REST);
            }
            count += 1;
            (b.side(), count)
        })
        .collect()
}

/// The polynomial of a side.
#[derive(Debug, Clone)]
struct Surface {
    side: LineUse,
    start: Point,
    along: Point,
    /// Second derivatives along the side's vector turned left, at the side's ends.
    bend: [Form; 2],
    /// Stress per distance from the side, in units of its length.
    gradient: [Form; 3],
    region: usize,
    /// Pore pressure of the soil, if the side is under water.
    water: Option<Linear>,
}

fn difference(a: &[Form; 3], b: &[Form; 3]) -> [Form; 3] {
    std::array::from_fn(|i| a[i].clone().plus(-1.0, &b[i]))
}

/// `a . stress b`.
fn on(stress: &[Form; 3], a: Point, b: Point) -> Form {
    let [xx, yy, xy] = stress;
    Form::default().plus(a[0] * b[0], xx).plus(a[1] * b[1], yy).plus(a[0] * b[1] + a[1] * b[0], xy)
}

impl Surface {
    fn new(problem: &Problem, reference: &ReferenceStress, side: LineUse) -> Self {
        let mut ends = problem.ends(side.line);
        if !side.forward {
            ends.reverse();
        }
        let region = problem.owner(side).unwrap_or(0);
        let (start, t) = (ends[0], between(ends[0], ends[1]));
        let n = turned(t);
        let water = (problem.condition(side) == Some(Condition::Submerged))
            .then(|| problem.soils[region].pore_pressure);
        let effective = |p: Point| {
            let [xx, yy, xy] = reference.at(region, p);
            let pressure = Form::constant(water.map_or(0.0, |water| water.at(p)));
            [xx.plus(1.0, &pressure), yy.plus(1.0, &pressure), xy]
        };
        let at = ends.map(effective);
        let inside = effective([start[0] + n[0], start[1] + n[1]]);
        let (along, inwards) = (difference(&at[1], &at[0]), difference(&inside, &at[0]));
        let tt = on(&inwards, t, t);
        let tn = on(&inwards, t, n).plus(1.0, &on(&along, t, t));
        let nn = on(&inwards, n, n).plus(1.0, &on(&along, t, n));
        let fourth = dot(t, t) * dot(t, t);
        let part = |i: usize, j: usize| {
            Form::default()
                .plus(t[i] * t[j] / fourth, &tt)
                .plus((t[i] * n[j] + n[i] * t[j]) / fourth, &tn)
                .plus(n[i] * n[j] / fourth, &nn)
        };
        let zero = Form::default;
        let surcharge = reference.surcharge();
        let bend = at.map(|[xx, yy, xy]| {
            let excess = [xx, yy].map(|f| f.plus(surcharge, &Form::constant(1.0)));
            let [xx, yy] = excess;
            zero().plus(-1.0, &on(&[xx, yy, xy], t, t))
        });
        Self { side, start, along: t, bend, gradient: [part(0, 0), part(1, 1), part(0, 1)], region, water }
    }

    fn place(&self, p: Point) -> [f64; 2] {
        let (t, from) = (self.along, between(self.start, p));
        [dot(from, t) / dot(t, t), dot(from, turned(t)) / dot(t, t)]
    }

    /// Value and slopes.
    fn jet(&self, loads: &Loads, p: Point) -> [Form; 3] {
        let [s, e] = self.place(p);
        let (t, n) = (self.along, turned(self.along));
        let (value, slopes, traction) = loads.beyond(self.side, s);
        let along = |a: Point, forms: &[Form; 2]| Form::default().plus(a[0], &forms[0]).plus(a[1], &forms[1]);
        let change = self.bend[1].clone().plus(-1.0, &self.bend[0]);
        let h = self.bend[0].clone().plus(s, &change);
        let w = along(n, &slopes);
        let over_s = along(t, &slopes).plus(e, &along(t, &traction)).plus(e * e / 2.0, &change);
        let over_e = w.clone().plus(e, &h);
        let tt = dot(t, t);
        let slope = |i: usize| Form::default().plus(t[i] / tt, &over_s).plus(n[i] / tt, &over_e);
        [value.plus(e, &w).plus(e * e / 2.0, &h), slope(0), slope(1)]
    }
}

/// All surfaces, and which of them vertex copies and triangles go by.
#[derive(Debug, Clone, Default)]
pub(crate) struct Surfaces {
    loads: Loads,
    surfaces: Vec<Surface>,
    pub(super) of_copy: Vec<usize>,
    of_triangle: Vec<usize>,
}

fn common(list: Option<Vec<usize>>, other: &[usize]) -> Option<Vec<usize>> {
    Some(list.map_or_else(|| other.to_vec(), |l| l.into_iter().filter(|x| other.contains(x)).collect()))
}

fn least(list: Option<Vec<usize>>) -> usize {
    list.and_then(|list| list.into_iter().min()).unwrap_or(AT_REST)
}

impl Surfaces {
    /// `at` has the surfaces at each vertex copy, none where the stress need not vanish; `twins` the copies that have the same unknowns.
    pub(super) fn new(
        problem: &Problem,
        reference: &ReferenceStress,
        loads: &Loads,
        numbers: &[(LineUse, usize)],
        corners: &[[usize; 3]],
        at: &[Vec<usize>],
        twins: &[Option<usize>],
    ) -> Self {
        let moving = numbers.iter().filter(|(_, number)| *number != AT_REST);
        let surfaces = moving.map(|(side, _)| Surface::new(problem, reference, *side)).collect();
        let mut next_to: Vec<Option<Vec<usize>>> = vec![None; at.len()];
        let mut of_triangle = Vec::with_capacity(corners.len());
        for copies in corners {
            let mut here = None;
            for apex in copies.iter().copied().filter(|copy| !at[*copy].is_empty()) {
                here = common(here, &at[apex]);
                for copy in copies.iter().copied().filter(|copy| at[*copy].is_empty()) {
                    next_to[copy] = common(next_to[copy].take(), &at[apex]);
                }
            }
            of_triangle.push(least(here));
        }
        let mut of_copy: Vec<usize> = next_to.into_iter().map(least).collect();
        for (copy, twin) in twins.iter().enumerate() {
            if let Some(twin) = *twin {
                let both = of_copy[copy].max(of_copy[twin]);
                (of_copy[copy], of_copy[twin]) = (both, both);
            }
        }
        Self { loads: loads.clone(), surfaces, of_copy, of_triangle }
    }

    fn surface(&self, number: usize) -> Option<&Surface> {
        self.surfaces.get(number.checked_sub(1)?)
    }

    /// Value and slopes of a polynomial; nothing if it is zero.
    pub(super) fn jet(&self, number: usize, p: Point) -> Option<[Form; 3]> {
        Some(self.surface(number)?.jet(&self.loads, p))
    }

    /// Those of the polynomial of a vertex copy beyond that of a triangle.
    pub(super) fn beyond(&self, copy: usize, triangle: usize, p: Point) -> Option<[Form; 3]> {
        let (a, b) = (self.of_copy[copy], self.of_triangle[triangle]);
        if a == b {
            return None;
        }
        let zero = || [Form::default(), Form::default(), Form::default()];
        let [a, b] = [a, b].map(|number| self.jet(number, p).unwrap_or_else(zero));
        Some(difference(&a, &b))
    }

    pub(super) fn of_triangle(&self, triangle: usize, p: Point) -> Option<[Form; 3]> {
        self.jet(self.of_triangle[triangle], p)
    }

    /// The normal of the side of a copy, into the soil, and its product with the way from the side to a point; none for those at rest.
    pub(super) fn away(&self, copy: usize, p: Point) -> Option<(Point, f64)> {
        let surface = self.surface(self.of_copy[copy])?;
        let n = turned(surface.along);
        Some((n, dot(n, between(surface.start, p))))
    }

    /// What the stress of the function beyond the polynomial of a triangle is added to.
    pub(super) fn stress(
        &self,
        reference: &ReferenceStress,
        triangle: usize,
        region: usize,
        p: Point,
    ) -> [Form; 3] {
        let Some(surface) = self.surface(self.of_triangle[triangle]) else { return reference.at(region, p) };
        let [_, e] = surface.place(p);
        let [xx, yy, xy] = surface.gradient.each_ref().map(|f| Form::default().plus(e, f));
        let water = Form::constant(surface.water.map_or(0.0, |water| water.at(p)));
        let (xx, yy) = (xx.plus(-1.0, &water), yy.plus(-1.0, &water));
        if region == surface.region {
            return [xx, yy, xy];
        }
        let more = difference(&reference.at(region, p), &reference.at(surface.region, p));
        [xx, yy.plus(1.0, &more[1]), xy]
    }
}
