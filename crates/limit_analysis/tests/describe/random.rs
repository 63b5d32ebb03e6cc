//! Random layered ground with plates, water and different unit weights, against a plain look at each point.

use proptest::prelude::*;
use soilctl_certificate::Statement;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Hold, Kind, PlateEntry, RegionEntry, Side, SoilEntry, Water,
};
use soilctl_limit_analysis::{Description, DescriptionError, LimitError};

use crate::common::{area, refusals};

const LOW: f64 = -10.0;
const WIDTH: f64 = 20.0;

/// Heights of the boundaries between layers at common stations, from the top downwards.
#[derive(Debug, Clone)]
struct Ground {
    stations: Vec<f64>,
    heights: Vec<Vec<f64>>,
    /// Fractions at which layers have more points on their edges, each layer its own.
    more: Vec<Vec<f64>>,
    weights: Vec<f64>,
    water: Vec<f64>,
    plate: Option<[f64; 4]>,
}

fn grounds() -> impl Strategy<Value = Ground> {
    (2_usize..5, 1_usize..4).prop_flat_map(|(stations, layers)| {
        let gaps = prop::collection::vec(0.3..1.0_f64, stations);
        let thickness = prop::collection::vec(prop::collection::vec(0.5..2.0_f64, stations + 1), layers);
        let top = prop::collection::vec(prop_oneof![Just(0.0), -1.0..1.0_f64], stations + 1);
        let more = prop::collection::vec(prop::collection::vec(0.1..0.9_f64, 0..3), layers);
        let weights = prop::collection::vec(prop_oneof![Just(18.0), Just(20.0), Just(16.0)], layers);
        let water = prop::collection::vec(-4.0..2.0_f64, 0..4);
        let plate = prop::option::of([-8.0..8.0_f64, -3.0..-0.5_f64, -8.0..8.0_f64, -3.0..-0.5_f64]);
        (gaps, thickness, top, more, weights, water, plate).prop_map(
            |(gaps, thickness, top, more, weights, water, plate)| {
                let total: f64 = gaps.iter().sum();
                let mut stations = vec![LOW];
                for gap in gaps {
                    stations.push(stations[stations.len() - 1] + WIDTH * gap / total);
                }
                let last = stations.len() - 1;
                stations[last] = LOW + WIDTH;
                let mut heights = vec![top];
                for t in thickness {
                    let above = &heights[heights.len() - 1];
                    heights.push(above.iter().zip(t).map(|(y, t)| y - t).collect());
                }
                Ground { stations, heights, more, weights, water, plate }
            },
        )
    })
}

impl Ground {
    fn height(&self, boundary: usize, x: f64) -> f64 {
        let last = self.stations.len() - 2;
        let i = self.stations.windows(2).position(|w| x <= w[1]).unwrap_or(last).min(last);
        let s = (x - self.stations[i]) / (self.stations[i + 1] - self.stations[i]);
        let h = &self.heights[boundary];
        h[i] + s * (h[i + 1] - h[i])
    }

    /// The boundary of a layer, with points of its own.
    fn line(&self, boundary: usize, layer: usize) -> Vec<[f64; 2]> {
        let mut x = self.stations.clone();
        // A station is a bend that the other layer has too: no point may take its place.
        for more in self.more[layer].iter().map(|s| LOW + s * WIDTH) {
            if x.iter().all(|other| (other - more).abs() > 1e-3) {
                x.push(more);
            }
        }
        x.sort_by(f64::total_cmp);
        x.iter().map(|x| [*x, self.height(boundary, *x)]).collect()
    }

    fn table(&self) -> Vec<[f64; 2]> {
        let x = |i: usize| LOW + WIDTH * (i as f64 + 0.37) / self.water.len() as f64;
        self.water.iter().enumerate().map(|(i, y)| [x(i), *y]).collect()
    }

    fn description(&self) -> Description {
        let soil = |(i, weight): (usize, &f64)| SoilEntry {
            name: format!("soil {i}"),
            phi_deg: Some(20.0 + i as f64),
            cohesion_kpa: 5.0,
            unit_weight_kn_m3: *weight,
            ..SoilEntry::default()
        };
        let region = |layer: usize| {
            let mut polygon = self.line(layer, layer);
            polygon.extend(self.line(layer + 1, layer).into_iter().rev());
            RegionEntry { name: None, soil: format!("soil {layer}"), polygon }
        };
        let plate = |[a, b, c, d]: [f64; 4]| PlateEntry {
            name: "plate".into(),
            line: vec![[a, b], [c, d]],
            held: Some(Hold::Smooth),
            ..PlateEntry::default()
        };
        Description {
            default_boundary: Some(Kind::Free),
            objective: Aim::UnitWeight {},
            water: (!self.water.is_empty()).then(|| Water {
                table: self.table(),
                rise_m: 0.0,
                unit_weight_kn_m3: 10.0,
            }),
            soils: self.weights.iter().enumerate().map(soil).collect(),
            regions: (0..self.weights.len()).map(region).collect(),
            boundaries: vec![
                BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left, Side::Right]),
                BoundaryEntry::on_line(Kind::Fixed, &self.line(self.weights.len(), self.weights.len() - 1)),
            ],
            plates: self.plate.map(plate).into_iter().collect(),
            ..Description::default()
        }
    }

    fn water_at(&self, x: f64) -> Option<f64> {
        let table = self.table();
        let (first, last) = (*table.first()?, *table.last()?);
        let piece = table.windows(2).find(|w| w[0][0] <= x && x <= w[1][0]);
        Some(match piece {
            Some(w) => w[0][1] + (w[1][1] - w[0][1]) * (x - w[0][0]) / (w[1][0] - w[0][0]),
            None if x < first[0] => first[1],
            None => last[1],
        })
    }
}

/// How often the loops of a region run around a point.
fn around(statement: &Statement, region: usize, p: [f64; 2]) -> i32 {
    let mut count = 0;
    for used in statement.regions[region].loops.iter().flatten() {
        let line = statement.lines[used.line];
        let (from, to) = if used.forward { (line.from, line.to) } else { (line.to, line.from) };
        let [a, b] = [from, to].map(|i| statement.points[i]);
        if (a[1] > p[1]) != (b[1] > p[1]) {
            let x = a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
            if x > p[0] {
                count += if b[1] > a[1] { 1 } else { -1 };
            }
        }
    }
    count
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn each_point_has_its_soil_and_its_water(ground in grounds()) {
        let described = match ground.description().described() {
            // Random plates and tables may come close to corners.
            Err(LimitError::Description(DescriptionError::NearlyTouch { .. })) => return Ok(()),
            Err(LimitError::Description(DescriptionError::Entry { problem, .. }))
                if problem.contains("it is not in the soil") => return Ok(()),
            other => other.unwrap(),
        };
        let s = &described.statement;
        let refusals = refusals(s);
        prop_assert!(refusals.is_empty(), "{refusals:?}");
        let square = described.length_m * described.length_m;
        let total: f64 = (0..s.regions.len()).map(|r| area(s, r)).sum::<f64>() * square;
        let mut expected = 0.0;
        for w in 0..ground.stations.len() - 1 {
            let thick = |i: usize| ground.heights[0][i] - ground.heights[ground.weights.len()][i];
            expected += 0.5 * (thick(w) + thick(w + 1)) * (ground.stations[w + 1] - ground.stations[w]);
        }
        prop_assert!((total - expected).abs() < 1e-6 * expected, "{total} {expected}");
        // The origin of the statement, from its extreme points.
        let low = s.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        let high = s.points.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
        let top = ground.heights[0].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for i in 0..60 {
            for j in 0..30 {
                let p = [LOW + WIDTH * (f64::from(i) + 0.513) / 60.0, top - 8.0 * (f64::from(j) + 0.417) / 30.0];
                let margin = (0..=ground.weights.len()).map(|b| (ground.height(b, p[0]) - p[1]).abs()).fold(1.0, f64::min);
                let table = ground.water_at(p[0]);
                if margin < 1e-6 || table.is_some_and(|y| (y - p[1]).abs() < 1e-6) {
                    continue;
                }
                let at = [low + (p[0] - LOW) / described.length_m, high + (p[1] - top) / described.length_m];
                let found: Vec<usize> = (0..s.regions.len()).filter(|r| around(s, *r, at) != 0).collect();
                let layer = (0..ground.weights.len())
                    .find(|l| p[1] < ground.height(*l, p[0]) && p[1] > ground.height(l + 1, p[0]));
                let Some(layer) = layer else {
                    prop_assert!(found.is_empty(), "{p:?}");
                    continue;
                };
                prop_assert_eq!(found.len(), 1);
                prop_assert_eq!(around(s, found[0], at), 1);
                let m = s.regions[found[0]].material.clone();
                prop_assert_eq!(m.phi_deg, 20.0 + layer as f64);
                let pore = m.pore_pressure.at(at) * described.stress_kpa;
                let wanted = table.map_or(0.0, |y| 10.0 * (y - p[1]).max(0.0));
                prop_assert!((pore - wanted).abs() < 1e-7, "{pore} for {wanted} at {p:?}");
            }
        }
    }
}

#[test]
fn soil_under_a_plate_in_two_pieces_is_cut_below_their_joint() {
    let ground = Ground {
        stations: vec![-10.0, -0.44403992751625054, 10.0],
        heights: vec![
            vec![-0.9989370289726277, 0.0, 0.0],
            vec![-2.679215303339283, -1.4357283849785831, -0.5],
            vec![-3.723720196919057, -3.0616753959235097, -1.0],
        ],
        more: vec![vec![], vec![0.3377557889082863]],
        weights: vec![16.0, 18.0],
        water: vec![-2.6068813649094937],
        plate: Some([0.0, -1.7864910531826161, -4.108394799107894, -2.6681629028667717]),
    };
    let refusals = refusals(&ground.description().described().unwrap().statement);
    assert!(refusals.is_empty(), "{refusals:?}");
}
