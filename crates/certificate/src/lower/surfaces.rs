//! Surfaces of soil without cohesion, level or sloping: there the effective stress must vanish.
//!
//! With tractions zero and the stress zero along a straight side, all second derivatives of the stress function are known
//! there. With `p = start + s t + e n`, where `t` leads along the side and `n` is `t` turned left, into the soil, the cubic
//! polynomial
//!
//! ```text
//! q = v(s) + e w(s) + e^2/2 h(s),      h = -(t . reference t)
//! ```
//!
//! has them, if `v` is the value that the run demands and `w` its slope along `n`. Its stress and the reference's add up to `e S`,
//! with one tensor `S`: it vanishes on the side and balances the weight. A stress function that vanishes to second order
//! beyond `q` at a point of the side has no stress there.
//!
//! Under water the same holds for effective stresses, with `reference + u I` for the reference, where `u` is the pore pressure of the
//! soil: `q` and the reference add up to `e S - u I`.

use super::loads::{Loads, Station, Stretch, is_bare};
use super::references::ReferenceStresses;
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::{Interval, Vector};
use crate::mesh::Place;
use crate::problem::{Problem, Stress};
use crate::statement::{Boundary, Condition, LineUse, Linear};
use crate::tiling::Tiling;

/// Number of the polynomial that is zero: of sides at the datum before which nothing acts, and of all that is next to none.
pub(super) const AT_REST: usize = 0;

/// The polynomial of one side.
#[derive(Debug, Clone, Copy)]
struct Surface {
    stretch: Stretch,
    start: Vector,
    /// `h` at the side's ends.
    bend: [Interval; 2],
    /// `S`.
    gradient: Stress,
    region: usize,
    /// `u`, if the side is under water.
    water: Option<Linear>,
}

impl Surface {
    fn new(
        problem: &Problem,
        references: &ReferenceStresses,
        stretch: Stretch,
        water: Option<Linear>,
    ) -> Self {
        let ends = problem.walked(stretch.side).map(Vector::point);
        let region = problem.owner(stretch.side).unwrap_or(0);
        let reference = references.of(region);
        let (t, n) = (stretch.along, stretch.along.turned());
        let effective = |step: Vector| match water {
            Some(water) => reference.change(step).with_mean(Vector::point(water.gradient).dot(step)),
            None => reference.change(step),
        };
        let (along, inwards) = (effective(t), effective(n));
        let [tt, tn, nn] = [
            inwards.between(t, t),
            inwards.between(t, n) + along.between(t, t),
            inwards.between(n, n) + along.between(t, n),
        ];
        let fourth = t.square().square();
        let part = |a: Interval, b: Interval, c: Interval, d: Interval| {
            // `t t`, `t n` both ways, `n n`.
            (tt * (a * b) + tn * (a * d + c * b) + nn * (c * d)) / fourth
        };
        let gradient = Stress {
            xx: part(t.x, t.x, n.x, n.x),
            yy: part(t.y, t.y, n.y, n.y),
            xy: part(t.x, t.y, n.x, n.y),
        };
        let bend = ends.map(|p| {
            let excess = reference.excess(p);
            -water.map_or(excess, |water| reference.at(p).with_mean(water.enclosed(p))).between(t, t)
        });
        Self { stretch, start: ends[0], bend, gradient, region, water }
    }

    /// `s` and `e` of a point.
    fn place(&self, p: Vector) -> [Interval; 2] {
        let (t, from) = (self.stretch.along, p - self.start);
        [from.dot(t) / t.square(), from.dot(t.turned()) / t.square()]
    }

    fn jet(&self, p: Vector) -> (Interval, Vector) {
        let [s, e] = self.place(p);
        let (t, n) = (self.stretch.along, self.stretch.along.turned());
        let slopes = self.stretch.slopes_at(s);
        let change = self.bend[1] - self.bend[0];
        let h = self.bend[0] + s * change;
        let w = slopes.dot(n);
        let half = e.square().half();
        let value = self.stretch.value_at(s) + e * w + half * h;
        // Slopes change by the traction turned left.
        let along = slopes.dot(t) + e * self.stretch.traction(s).dot(t) + half * change;
        (value, t * (along / t.square()) + n * ((w + e * h) / t.square()))
    }

    fn stress(&self, p: Vector) -> Stress {
        let [_, e] = self.place(p);
        let Stress { xx, yy, xy } = self.gradient;
        let effective = Stress { xx: xx * e, yy: yy * e, xy: xy * e };
        self.water.map_or(effective, |water| effective.with_mean(-water.enclosed(p)))
    }
}

/// All such sides, and which of them vertex copies and triangles go by.
pub(super) struct Surfaces<'a> {
    references: &'a ReferenceStresses,
    /// Those with a number above [`AT_REST`].
    surfaces: Vec<Surface>,
    /// For each vertex copy, the one that its jet is relative to.
    of_copy: Vec<usize>,
    of_triangle: Vec<usize>,
}

/// What two lists have in common.
fn common(a: Option<Vec<usize>>, b: &[usize]) -> Option<Vec<usize>> {
    Some(a.map_or_else(|| b.to_vec(), |a| a.into_iter().filter(|x| b.contains(x)).collect()))
}

fn least(list: Option<Vec<usize>>, place: impl Fn() -> String) -> Result<usize, CertificateError> {
    let problem = "it is next to surfaces in different directions, of soil without cohesion";
    let found = list.map_or(Some(AT_REST), |list| list.into_iter().min());
    found.ok_or_else(|| CertificateError::BadField { place: place(), problem })
}

impl<'a> Surfaces<'a> {
    pub(super) fn new(
        problem: &Problem,
        references: &'a ReferenceStresses,
        loads: &Loads,
        tiling: &Tiling,
        field: &LowerField,
        stations: &[Option<Station>],
        apexes: &[bool],
    ) -> Result<Self, CertificateError> {
        let mut surfaces = Vec::new();
        let mut number = std::collections::BTreeMap::new();
        let mut owners: Vec<Vec<usize>> = vec![Vec::new()];
        // Dry ones first: where both meet, what goes by the dry one has no stress, exactly.
        let in_water = |boundary: &Boundary| boundary.condition == Condition::Submerged;
        let (wet, dry): (Vec<&Boundary>, Vec<&Boundary>) =
            problem.statement.boundaries.iter().partition(|b| in_water(b));
        for boundary in dry.into_iter().chain(wet) {
            let side = boundary.side();
            let Some(stretch) = loads.stretch(side).filter(|_| is_bare(problem, boundary)) else { continue };
            let is_level = problem.walked(side).iter().all(|p| p[1] == problem.statement.datum);
            if is_level && !in_water(boundary) && loads.is_at_rest_up_to(side) {
                number.insert(side, AT_REST);
                owners[AT_REST].extend(problem.owner(side));
            } else {
                let region = problem.owner(side).filter(|_| in_water(boundary));
                let water = region.map(|region| problem.strengths[region].pore_pressure);
                let surface = Surface::new(problem, references, stretch, water);
                owners.push(vec![surface.region]);
                surfaces.push(surface);
                number.insert(side, surfaces.len());
            }
        }
        let at = |copy: usize| -> Vec<usize> {
            let sides = stations[copy].filter(|_| apexes[copy]).map(|station| loads.sides_at(station));
            sides.into_iter().flatten().filter_map(|side| number.get(&side).copied()).collect()
        };
        let at: Vec<Vec<usize>> = (0..field.copies.len()).map(at).collect();
        let mut next_to: Vec<Option<Vec<usize>>> = vec![None; field.copies.len()];
        let mut of_triangle = Vec::with_capacity(field.corners.len());
        for (triangle, copies) in field.corners.iter().enumerate() {
            let mut here = None;
            for apex in copies.iter().copied().filter(|copy| apexes[*copy]) {
                here = common(here, &at[apex]);
                for copy in copies.iter().copied().filter(|copy| !apexes[*copy]) {
                    next_to[copy] = common(next_to[copy].take(), &at[apex]);
                }
                if at[apex] == [AT_REST] {
                    continue;
                }
                let regions = at[apex].iter().flat_map(|surface| owners[*surface].iter().copied());
                let place = field.mesh.vertices[field.copies[apex].vertex].place;
                check_references(problem, references, tiling.region(triangle), regions, place)?;
            }
            of_triangle.push(least(here, || format!("triangle {triangle}"))?);
        }
        let of_copy = next_to.into_iter().enumerate().map(|(copy, list)| match field.copies[copy].jet {
            Jet::OneApex { apex, .. } => Ok(at[apex].iter().copied().min().unwrap_or(AT_REST)),
            Jet::ManyApexes { .. } | Jet::Zero { .. } => least(list, || format!("vertex copy {copy}")),
            Jet::Gauge { .. }
            | Jet::Free { .. }
            | Jet::OneLine { .. }
            | Jet::TwoLines { .. }
            | Jet::Kinked { .. } => Ok(AT_REST),
        });
        let of_copy = of_copy.collect::<Result<_, _>>()?;
        Ok(Self { references, surfaces, of_copy, of_triangle })
    }

    /// The number of the polynomial that a vertex copy's jet is relative to.
    pub(super) fn of_copy(&self, copy: usize) -> usize {
        self.of_copy[copy]
    }

    pub(super) fn of_triangle(&self, triangle: usize) -> usize {
        self.of_triangle[triangle]
    }

    /// Value and slopes of a polynomial; exactly zero for [`AT_REST`].
    pub(super) fn jet(&self, surface: usize, p: Vector) -> (Interval, Vector) {
        let surface = surface.checked_sub(1).and_then(|i| self.surfaces.get(i));
        surface.map_or((Interval::ZERO, Vector::ZERO), |surface| surface.jet(p))
    }

    /// Value and slopes of the polynomial `a` beyond `b`.
    pub(super) fn beyond(&self, a: usize, b: usize, p: Vector) -> (Interval, Vector) {
        if a == b {
            return (Interval::ZERO, Vector::ZERO);
        }
        let ((f, slopes), (g, less)) = (self.jet(a, p), self.jet(b, p));
        (f - g, slopes - less)
    }

    /// The vector of the side, and from its line to a point along that turned left, in units of its length.
    pub(super) fn away_from_side(&self, surface: usize, p: Vector) -> Option<(Vector, Interval)> {
        let surface = self.surfaces.get(surface.checked_sub(1)?)?;
        Some((surface.stretch.along, surface.place(p)[1]))
    }

    /// What the stress of the function beyond a polynomial is added to, in a region.
    pub(super) fn stress(&self, surface: usize, region: usize, p: Vector) -> Stress {
        let Some(surface) = surface.checked_sub(1).and_then(|i| self.surfaces.get(i)) else {
            return self.references.of(region).at(p);
        };
        let stress = surface.stress(p);
        if self.references.same(region, surface.region) {
            return stress;
        }
        let [column, own] = [region, surface.region].map(|r| self.references.of(r).column_at(p));
        Stress { yy: stress.yy + (column - own), ..stress }
    }

    /// The pore pressure that the stress at the side of a polynomial is; none beside what is dry.
    pub(super) fn water(&self, surface: usize) -> Option<Linear> {
        self.surfaces.get(surface.checked_sub(1)?)?.water
    }

    /// Whether the polynomial's slope along x is the same all along a vertical line down from a vertex copy at this station: the side is
    /// level, and the reference has no shear stress.
    pub(super) fn is_level_from(&self, surface: usize, station: Option<Station>, loads: &Loads) -> bool {
        let Some(surface) = surface.checked_sub(1).and_then(|i| self.surfaces.get(i)) else { return false };
        let reference = self.references.of(surface.region);
        let sides = station.map(|station| loads.sides_at(station));
        surface.stretch.along.y.is_zero()
            && reference.gradient.xy.is_zero()
            && sides.into_iter().flatten().any(|side| side == surface.stretch.side)
    }
}

/// Checks that at a surface the references of all regions there are one.
fn check_references(
    problem: &Problem,
    references: &ReferenceStresses,
    region: usize,
    owners: impl Iterator<Item = usize>,
    place: Place,
) -> Result<(), CertificateError> {
    let statement = problem.statement;
    let ends = match place {
        Place::Corner { point } => [statement.points[point]; 2],
        Place::OnLine { line, .. } => {
            [statement.lines[line].from, statement.lines[line].to].map(|i| statement.points[i])
        }
        Place::Inside => return Ok(()),
    };
    let is_base = |region: usize| references.is_base_at(region, ends);
    let agrees = |owner: usize| references.same(region, owner) || (is_base(region) && is_base(owner));
    if owners.into_iter().all(agrees) {
        return Ok(());
    }
    let what = "a surface of soil without cohesion where soil of other unit weight meets it from the side";
    Err(CertificateError::NotCovered { place: format!("region {region}"), what })
}

/// Whether an edge from an apex to another copy runs along a side without loads but water.
pub(super) fn along_free_side(problem: &Problem, loads: &Loads, apex: Station, other: Station) -> bool {
    let others = loads.sides_at(other);
    let is_free =
        |side: &LineUse| matches!(problem.condition(*side), Some(Condition::Free | Condition::Submerged));
    loads.sides_at(apex).iter().any(|side| is_free(side) && others.contains(side))
}
