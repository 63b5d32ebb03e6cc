use soilctl_earth_pressure::{
    Case, ChenLiu, EarthPressureError, ForceModel, LoadFactors, Loads, ModelSlice, check_loads,
};
use soilctl_soil::{Angle, Interface, Soil, WidthRatio};

/// Tool angles of the nodes: from this one, in steps of half a degree.
const FIRST_DEG: usize = 50;
pub(super) const ANGLES: usize = 121;
/// Friction on the plate at the nodes, in sixteenths of the full one.
pub(super) const SHARES: usize = 17;

/// Coefficients of a force model for one soil, at every tool angle and with the friction on the plate in part mobilised.
///
/// Taken from the model once, since a step has no time for it, and rounded to 1e-9, so that the last bits of a system's
/// sine do not matter. Between nodes they are interpolated linearly: within 0.4 % of the model. Beyond the tool angles
/// of a table it follows the shape of Chen and Liu's model, scaled to the table's last value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LimitCoefficients {
    /// Net factors of weight and cohesion and the passive one of surcharge, by angle and share.
    nodes: Vec<[LoadFactors; SHARES]>,
    /// What the plate's ends add to the factor of weight, by angle and share: of wide plates, and with depth over width. Empty in
    /// plane strain.
    ends: Vec<[[f64; 2]; SHARES]>,
}

impl LimitCoefficients {
    /// Errors are those of the model at the tool angles that it covers.
    pub(crate) fn new(
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
        fraction: f64,
    ) -> Result<Self, EarthPressureError> {
        let range = model.valid_range().alpha_deg;
        let loads = Loads { cohesion_pa: soil.cohesion_pa(), adhesion_pa: 0.0, surcharge_pa: 0.0 };
        let mut nodes = Vec::with_capacity(ANGLES);
        for i in 0..ANGLES {
            let alpha_deg = angle_deg(i);
            let mut row = [LoadFactors::default(); SHARES];
            for (k, factors) in row.iter_mut().enumerate() {
                let case = |alpha_deg: f64| Case {
                    tool_angle: Angle::from_degrees(alpha_deg),
                    surface_slope: Angle::ZERO,
                    width_ratio: WidthRatio::PLANE_STRAIN,
                    friction: soil.friction(),
                    interface: Angle::from_radians(share(k) * interface.friction().radians()),
                };
                let inside = alpha_deg.max(range.0).min(range.1);
                check_loads(model, &case(inside), &loads)?;
                let prediction = model.predict(&case(inside))?;
                let weight =
                    prediction.net_lower.0 + fraction * (prediction.net_upper.0 - prediction.net_lower.0);
                let mut found = LoadFactors { weight, ..prediction.net };
                let (here, nearest) = (ChenLiu.predict(&case(alpha_deg))?, ChenLiu.predict(&case(inside))?);
                if inside != alpha_deg {
                    found.weight *= here.net.weight / nearest.net.weight;
                }
                // A heap loads the soil ahead only.
                let passive = here.passive.map_or(0.0, |side| side.surcharge);
                found.surcharge = found.weight * passive / here.net.weight;
                *factors = rounded(found);
            }
            nodes.push(row);
        }
        Ok(Self { nodes, ends: Vec::new() })
    }

    /// The same for a plate with ends, which add a part (0 to 1) of what they add at most by the model's bracket.
    pub(crate) fn with_ends(
        mut self,
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
        factor: f64,
    ) -> Result<Self, EarthPressureError> {
        let range = model.valid_range().alpha_deg;
        let mut ends = Vec::with_capacity(ANGLES);
        for (i, nodes) in self.nodes.iter().enumerate() {
            let alpha_deg = angle_deg(i);
            let inside = Angle::from_degrees(alpha_deg.max(range.0).min(range.1));
            let of = |ratio| model.at(inside, Angle::ZERO, WidthRatio::new(ratio)?);
            let (square, twice) = (of(1.0)?, of(2.0)?);
            let mut row = [[0.0; 2]; SHARES];
            for (k, (ends, plane)) in row.iter_mut().zip(nodes).enumerate() {
                let delta_deg = share(k) * interface.friction().degrees();
                let net = |slice: &dyn ModelSlice| slice.net(soil.friction().degrees(), delta_deg);
                let (one, half) = (net(&*square)?, net(&*twice)?);
                // Linear in depth over width; beyond the angles of the model as plane strain goes on there.
                let term = 2.0 * (one.ends_at_most - half.ends_at_most);
                let near = self.at(inside.radians(), share(k), 0.0);
                let scale = factor * plane.weight / near.weight;
                *ends = [one.ends_at_most - term, term].map(|x| round(scale * x));
            }
            ends.push(row);
        }
        self.ends = ends;
        Ok(self)
    }

    /// Factors at a tool angle in rad with a share (0 to 1) of the friction on the plate, for a depth over width.
    pub(crate) fn at(&self, tool_angle_rad: f64, share: f64, depth_over_width: f64) -> LoadFactors {
        let nodes = surrounding(tool_angle_rad, share);
        let along = |row: usize| {
            between(&self.nodes[row][nodes.column], &self.nodes[row][nodes.column + 1], nodes.in_column)
        };
        let mut factors = between(&along(nodes.row), &along(nodes.row + 1), nodes.in_row);
        if !self.ends.is_empty() {
            factors.weight += nodes.mix(|row, column| {
                let [wide, term] = self.ends[row][column];
                wide + depth_over_width * term
            });
        }
        factors
    }

    /// Factors at a node, in plane strain.
    pub(super) fn node(&self, angle: usize, share: usize) -> &LoadFactors {
        &self.nodes[angle][share]
    }
}

/// Four nodes around a tool angle and a share of the friction on the plate: the first, and how far from it to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surrounding {
    row: usize,
    in_row: f64,
    column: usize,
    in_column: f64,
}

/// The nodes around a tool angle in rad and a share (0 to 1).
pub(super) fn surrounding(tool_angle_rad: f64, share: f64) -> Surrounding {
    #[allow(clippy::cast_precision_loss, reason = "small integers")]
    let (first, last) = (FIRST_DEG as f64, (ANGLES - 2) as f64);
    let (row, in_row) = place(2.0 * (tool_angle_rad.to_degrees() - first), last);
    #[allow(clippy::cast_precision_loss, reason = "small integers")]
    let (column, in_column) = place(share * (SHARES - 1) as f64, (SHARES - 2) as f64);
    Surrounding { row, in_row, column, in_column }
}

impl Surrounding {
    /// Linear between what the four nodes have.
    pub(super) fn mix(&self, of: impl Fn(usize, usize) -> f64) -> f64 {
        let mix = |a: f64, b: f64, share: f64| a + share * (b - a);
        let along = |row: usize| mix(of(row, self.column), of(row, self.column + 1), self.in_column);
        mix(along(self.row), along(self.row + 1), self.in_row)
    }
}

/// Tool angle of a node in deg.
#[allow(clippy::cast_precision_loss, reason = "small integers")]
pub(super) fn angle_deg(i: usize) -> f64 {
    FIRST_DEG as f64 + 0.5 * i as f64
}

/// Share of the friction on the plate at a node.
#[allow(clippy::cast_precision_loss, reason = "small integers")]
pub(super) fn share(k: usize) -> f64 {
    k as f64 / (SHARES - 1) as f64
}

/// Cell and place in it; beyond the ends the last cell is taken, at its edge.
fn place(at: f64, last: f64) -> (usize, f64) {
    let cell = at.floor().max(0.0).min(last);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to last")]
    let index = cell as usize;
    (index, (at - cell).clamp(0.0, 1.0))
}

pub(super) fn between(a: &LoadFactors, b: &LoadFactors, share: f64) -> LoadFactors {
    let mix = |a: f64, b: f64| a + share * (b - a);
    LoadFactors {
        weight: mix(a.weight, b.weight),
        surcharge: mix(a.surcharge, b.surcharge),
        cohesion: mix(a.cohesion, b.cohesion),
        adhesion: mix(a.adhesion, b.adhesion),
    }
}

pub(super) fn round(value: f64) -> f64 {
    (value * 1e9).round() * 1e-9
}

fn rounded(factors: LoadFactors) -> LoadFactors {
    LoadFactors {
        weight: round(factors.weight),
        surcharge: round(factors.surcharge),
        cohesion: round(factors.cohesion),
        adhesion: round(factors.adhesion),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use soilctl_earth_pressure::model;

    /// Against the model itself, also between the nodes.
    #[test]
    fn nodes_and_interpolation() {
        let soil = Soil::new(Angle::from_degrees(40.0), 1500.0).unwrap();
        let interface = Interface::new(Angle::from_degrees(25.0), 0.0).unwrap();
        for id in ["chen", "coulomb", "table"] {
            let model = model(id).unwrap();
            let limits = LimitCoefficients::new(model.as_ref(), &soil, &interface, 0.5).unwrap();
            for alpha in [70.0, 77.3, 90.0, 99.5] {
                for delta in [0.0, 10.0, 25.0] {
                    let p = model.predict(&Case::level_deg(alpha, 40.0, delta)).unwrap();
                    let expected = 0.5 * (p.net_lower.0 + p.net_upper.0);
                    let found = limits.at(alpha.to_radians(), delta / 25.0, 0.2).weight;
                    assert!(
                        (found / expected - 1.0).abs() < 4e-3,
                        "{id} {alpha} {delta}: {found} {expected}"
                    );
                }
            }
        }
    }

    /// A part of what ends add at most, at any depth over width, between the nodes too; nothing at a factor of 0.
    #[test]
    fn ends_add_their_part_of_what_the_table_allows() {
        let soil = Soil::new(Angle::from_degrees(40.0), 1500.0).unwrap();
        let interface = Interface::new(Angle::from_degrees(25.0), 0.0).unwrap();
        let (chen, table) = (model("chen").unwrap(), model("table").unwrap());
        let plane = LimitCoefficients::new(chen.as_ref(), &soil, &interface, 0.5).unwrap();
        let of = |factor| plane.clone().with_ends(table.as_ref(), &soil, &interface, factor).unwrap();
        let (none, some) = (of(0.0), of(0.7));
        for (alpha, delta, ratio) in
            [(70.0, 25.0, 5.0), (82.3, 10.0, 0.8), (90.0, 0.0, 50.0), (99.5, 20.0, 2.0)]
        {
            let at = |limits: &LimitCoefficients| {
                limits.at(f64::to_radians(alpha), delta / 25.0, 1.0 / ratio).weight
            };
            assert_eq!(at(&none), at(&plane));
            let slice = table.at(Angle::from_degrees(alpha), Angle::ZERO, WidthRatio::new(ratio).unwrap());
            let most = slice.unwrap().net(40.0, delta).unwrap().ends_at_most;
            let found = (at(&some) - at(&plane)) / most;
            assert!((found - 0.7).abs() < 1e-2, "{alpha} {delta} {ratio}: {found}");
        }
    }

    /// Beyond the table's 70 degrees the coefficient goes on without a jump.
    #[test]
    fn beyond_a_table() {
        let soil = Soil::new(Angle::from_degrees(40.0), 1500.0).unwrap();
        let interface = Interface::new(Angle::from_degrees(25.0), 0.0).unwrap();
        let limits =
            LimitCoefficients::new(model("table").unwrap().as_ref(), &soil, &interface, 0.5).unwrap();
        let at = |deg: f64| limits.at(deg.to_radians(), 1.0, 0.2).weight;
        assert!(at(69.0) < at(70.0) && at(68.0) > 0.9 * at(70.0));
        assert!(at(101.0) > at(100.0) && at(101.0) < 1.1 * at(100.0));
    }
}
