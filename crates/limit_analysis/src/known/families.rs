//! Kinds of problems, with what is known about each.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement};

use super::common::{soil, statement};
use super::grounds::{footing, heavy, slope, strip, wall};
use super::infinite::infinite_slope;
use super::prandtl::{nc, nq, size};
use crate::EmbeddedPlate;

/// A problem whose answer is known to lie between two numbers.
#[derive(Clone)]
pub(super) struct Known {
    pub(super) name: String,
    pub(super) statement: Statement,
    pub(super) value: [f64; 2],
}

impl Known {
    /// Whether some of its soil has no cohesion.
    pub(super) fn has_sand(&self) -> bool {
        let is_sand = |material: &Material| material.cohesion == Linear::uniform(0.0);
        self.statement.regions.iter().any(|region| is_sand(&region.material))
    }
}

/// Pseudo-random numbers (xorshift, Marsaglia 2003).
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn yes(&mut self) -> bool {
        self.between(0.0, 1.0) < 0.5
    }
}

fn passive(phi_deg: f64) -> f64 {
    (45.0 + phi_deg / 2.0).to_radians().tan()
}

/// A smooth wall before one soil: Rankine.
fn rankine(r: &mut Random) -> Known {
    let direction = if r.yes() { 1.0 } else { -1.0 };
    let phi_deg = if r.between(0.0, 1.0) < 0.2 && direction > 0.0 { 0.0 } else { r.between(5.0, 45.0) };
    let surcharge = if r.yes() { r.between(0.1, 2.0) } else { 0.0 };
    let root = passive(direction * phi_deg);
    // A wall bears no tension: the soil that gives way must press on all of it.
    let most = if direction > 0.0 { 1.0 } else { 0.4 * surcharge * root };
    let cohesion = if r.yes() || phi_deg == 0.0 { r.between(0.2, 1.0) * most } else { 0.0 };
    let exact = direction * (root * root * (0.5 + surcharge) + direction * 2.0 * cohesion * root);
    Known {
        name: format!("wall {direction} {phi_deg:.1} {cohesion:.2} {surcharge:.2}"),
        statement: wall(&[(1.0, heavy(soil(phi_deg, cohesion)))], [0.0, -1.0], surcharge, direction),
        value: [exact; 2],
    }
}

/// A smooth wall before layers of clay, through which wedges go straight.
fn layered(r: &mut Random) -> Known {
    let [at, upper, lower] = [r.between(0.3, 0.7), r.between(0.3, 2.0), r.between(0.3, 2.0)];
    let layers = [(at, heavy(soil(0.0, upper))), (1.0 - at, heavy(soil(0.0, lower)))];
    let exact = 0.5 + 2.0 * (at * upper + (1.0 - at) * lower);
    Known {
        name: format!("layers {at:.2} {upper:.2} {lower:.2}"),
        statement: wall(&layers, [0.0, -1.0], 0.0, 1.0),
        value: [exact; 2],
    }
}

fn endless(r: &mut Random) -> Known {
    let phi_deg = r.between(5.0, 30.0);
    let beta_deg = r.between(phi_deg + 4.0, phi_deg + 20.0);
    let water = if r.yes() { r.between(0.1, 0.5) * beta_deg.to_radians().cos() } else { 0.0 };
    Known {
        name: format!("endless slope {beta_deg:.1} {phi_deg:.1} {water:.2}"),
        statement: infinite_slope(beta_deg, phi_deg, water),
        value: [1.0; 2],
    }
}

/// Strip loads on weightless soil: Prandtl and Reissner; surcharge and cohesion add up (Caquot).
fn prandtl(r: &mut Random) -> Known {
    let phi_deg = if r.between(0.0, 1.0) < 0.3 { 0.0 } else { r.between(5.0, 32.0) };
    let cohesion = r.between(0.2, 1.0);
    let beside = if r.yes() { r.between(0.1, 1.0) } else { 0.0 };
    let exact = cohesion * nc(phi_deg) + beside * if phi_deg == 0.0 { 1.0 } else { nq(phi_deg) };
    Known {
        name: format!("strip {phi_deg:.1} {cohesion:.2} {beside:.2}"),
        statement: strip(soil(phi_deg, cohesion), beside, size(phi_deg)),
        value: [exact; 2],
    }
}

/// Heights of slopes. In clay a vertical cut's is known to four digits; with friction it lies between Rankine's and
/// Culmann's plane wedge, and that of other slopes below the wedge.
fn height(r: &mut Random) -> Known {
    let cohesion = r.between(0.5, 2.0);
    let (phi_deg, angle_deg) = match r.between(0.0, 3.0) as usize {
        0 => (0.0, 90.0),
        1 => (r.between(5.0, 30.0), 90.0),
        _ => (r.between(0.0, 25.0), r.between(50.0, 85.0)),
    };
    let (phi, angle) = (phi_deg.to_radians(), angle_deg.to_radians());
    let wedge = 4.0 * angle.sin() * phi.cos() / (1.0 - (angle - phi).cos());
    let value = match (phi_deg == 0.0, angle_deg == 90.0) {
        (true, true) => [3.7764, 3.7776],
        (false, true) => [2.0 * passive(phi_deg), wedge],
        _ => [0.0, wedge],
    };
    Known {
        name: format!("slope {angle_deg:.1} {phi_deg:.1} {cohesion:.2}"),
        statement: slope(soil(phi_deg, cohesion), angle_deg),
        value: value.map(|v| v * cohesion),
    }
}

/// Rigid footings on sand: Martin (2005), to six digits.
fn martin(r: &mut Random) -> Known {
    let table = [(10.0, 0.280_894, 0.433_187), (20.0, 1.578_62, 2.838_94), (30.0, 7.653_00, 14.754_3)];
    let (phi_deg, smooth, rough) = table[r.between(0.0, 3.0) as usize];
    let (weight, is_rough) = (r.between(0.5, 2.0), r.yes());
    let (delta_deg, value) = if is_rough { (phi_deg, rough) } else { (0.0, smooth) };
    let material = Material { unit_weight: weight, ..soil(phi_deg, 0.0) };
    Known {
        name: format!("footing {phi_deg} {delta_deg} {weight:.2}"),
        statement: footing(material, delta_deg, 0.0, [8.0, 4.0]),
        value: [1.0 - 1e-5, 1.0 + 1e-5].map(|x| x * weight * value),
    }
}

/// A strip load on weightless soil without cohesion, with a pressure beside it: Reissner.
fn reissner(r: &mut Random) -> Known {
    let (phi_deg, beside) = (r.between(5.0, 32.0), r.between(0.1, 1.0));
    Known {
        name: format!("strip on sand {phi_deg:.1} {beside:.2}"),
        statement: strip(soil(phi_deg, 0.0), beside, size(phi_deg)),
        value: [beside * nq(phi_deg); 2],
    }
}

/// A slope of sand that is pushed out of the hill, as by an earthquake: it slides along itself. With gravity turned by the angle whose tangent is that part of the
/// weight, it is a slope that is steeper by this angle, and stands as long as it is no steeper than its friction.
fn shaken(r: &mut Random) -> Known {
    let phi_deg = r.between(20.0, 42.0);
    let beta_deg = phi_deg - r.between(4.0, 15.0);
    let objective = Objective::Body { gravity: [1.0, 0.0] };
    let it = slope(soil(phi_deg, 0.0), beta_deg);
    let exact = (phi_deg - beta_deg).to_radians().tan();
    Known {
        name: format!("shaken sand {beta_deg:.1} {phi_deg:.1}"),
        statement: Statement { gravity: [0.0, -1.0], objective, ..it },
        value: [exact; 2],
    }
}

/// A rigid slab that is pulled along clay: its adhesion is all that holds it.
fn slab(r: &mut Random) -> Known {
    let [cohesion, grip] = [r.between(0.5, 1.0), r.between(0.2, 0.95)];
    let adhesion = grip * cohesion;
    let points = [[-4.0, 0.0], [-4.0, -2.0], [4.0, -2.0], [4.0, 0.0], [1.0, 0.0], [-1.0, 0.0]];
    let material = Material { cohesion: Linear::uniform(cohesion), ..heavy(soil(0.0, 0.0)) };
    let objective = Objective::Structure { velocity: [1.0, 0.0] };
    let it = statement(&[(&[0, 1, 2, 3, 4, 5], material)], &points, objective, |[x, y]| match () {
        () if y == 0.0 && x.abs() < 1.0 => Condition::Face { delta_deg: 0.0, adhesion },
        () if y == 0.0 => Condition::Free,
        () => Condition::Fixed,
    });
    Known {
        name: format!("slab {cohesion:.2} {grip:.2}"),
        statement: Statement { gravity: [0.0, -1.0], ..it },
        value: [0.0, 2.0 * adhesion],
    }
}

/// A random problem of one of the kinds, in turn; the same for the same number and seed.
pub(super) fn random(number: usize, seed: u64) -> Known {
    let kinds = [rankine, layered, endless, prandtl, height, martin, slab, reissner, shaken];
    kinds[number % kinds.len()](&mut Random::new(seed ^ (number as u64) << 8))
}

/// The plates of Hong (2001), Appendix C, between the bounds printed there. Those at 5 degrees of interface friction were
/// interpolated, so the lower ones prove nothing.
pub(super) fn plates() -> Vec<Known> {
    let rows = include_str!("../../../../data/appendix_c.csv").lines().skip(1);
    let plate = |row: &str| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        let [alpha_deg, phi_deg, delta_deg, high, low] = [cells[0], cells[1], cells[2], cells[7], cells[8]];
        let plate = EmbeddedPlate { alpha_deg, phi_deg, delta_deg, ..EmbeddedPlate::default() };
        // From a coefficient to a horizontal force; three digits are printed.
        let force = |coefficient: f64| 0.5 * coefficient * (alpha_deg + delta_deg).to_radians().sin();
        let low = if delta_deg == 5.0 { 0.0 } else { low - 5e-4 };
        Known {
            name: format!("plate {alpha_deg} {phi_deg} {delta_deg}"),
            statement: plate.problem().unwrap().statement().clone(),
            value: [low, high + 5e-4].map(force),
        }
    };
    rows.map(plate).collect()
}
