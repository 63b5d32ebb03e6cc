//! What a model says of each measurement at points of a lattice of angles.

use rustc_hash::FxHashMap;
use soilctl_earth_pressure::{EarthPressureError, ModelSlice};
use soilctl_soil::Angle;

use super::unknowns::{Quantity, Unknowns};
use crate::{EstimatorError, Setup};

/// Lattice units per degree.
const UNITS_PER_DEG: f64 = 256.0;

/// A point of the lattice: friction, interface friction and slope in units; 0 in place of an angle that is known.
pub(super) type Node = [i32; 3];

/// An angle in degrees.
pub(super) fn deg(units: i32) -> f64 {
    f64::from(units) / UNITS_PER_DEG
}

/// Units of an angle in degrees, rounded down to a multiple.
pub(super) fn units_below(deg: f64, multiple: i32) -> i32 {
    (deg * UNITS_PER_DEG / f64::from(multiple)).floor() as i32 * multiple
}

/// Loads beside weight: cohesion, adhesion, surcharge.
pub(super) const LOADS: usize = 3;

/// What a measurement says of the density at some angles. The sides are its lower end and its upper end,
/// `density + sum of loads times shares >= force` and `<= force`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// Force over what a density of 1 makes of it, in kg/m3.
    pub(super) force: [f64; 2],
    /// What a load of 1 Pa makes of the force, over what a density of 1 does, in kg/m3 per Pa.
    pub(super) loads: [[f64; LOADS]; 2],
}

/// The bounds of a measurement at a point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Told {
    Bounds(Bounds),
    /// The soil carries any force there.
    Singular,
    /// The model has no answer.
    Nothing,
}

struct Stroke {
    /// `g L^2 w / 2`, and `L w`.
    scale: [f64; 2],
    force_n: [f64; 2],
}

/// Bounds of all measurements at points, found once each.
pub(super) struct Factors<'s, 'm> {
    setup: &'s Setup<'m>,
    strokes: Vec<Stroke>,
    /// Angles that are known, in degrees.
    known_deg: [Option<f64>; 3],
    slices: FxHashMap<i32, Vec<Box<dyn ModelSlice + 'm>>>,
    places: FxHashMap<Node, usize>,
    told: Vec<Told>,
    /// Whether the model answered anywhere, and why it did not where it first did not.
    answered: bool,
    refusal: Option<EarthPressureError>,
}

impl<'s, 'm> Factors<'s, 'm> {
    pub(super) fn new(setup: &'s Setup<'m>, unknowns: &Unknowns) -> Self {
        let stroke = |observation: &crate::Observation| {
            let plate = observation.plate();
            let area = plate.slant_length_m() * plate.width_m();
            Stroke {
                scale: [0.5 * setup.gravity_m_s2 * plate.slant_length_m() * area, area],
                force_n: [observation.low_n(), observation.high_n()],
            }
        };
        let known = |quantity| {
            let (low, high) = unknowns.interval(setup, quantity);
            (low == high && quantity != Quantity::Friction).then_some(low)
        };
        Self {
            setup,
            strokes: setup.observations.iter().map(stroke).collect(),
            known_deg: Quantity::ANGLES.map(known),
            slices: FxHashMap::default(),
            places: FxHashMap::default(),
            told: Vec::new(),
            answered: false,
            refusal: None,
        }
    }

    /// How many measurements there are.
    pub(super) fn count(&self) -> usize {
        self.strokes.len()
    }

    /// Where the bounds of a point begin.
    pub(super) fn place(&mut self, node: Node) -> Result<usize, EstimatorError> {
        if let Some(&place) = self.places.get(&node) {
            return Ok(place);
        }
        let place = self.told.len();
        let range = self.setup.model.valid_range();
        let angle = |axis: usize| self.known_deg[axis].unwrap_or_else(|| deg(node[axis]));
        // Points that stick out of the model's range take its value at the edge; no soil is sought there.
        let delta = angle(1).clamp(range.delta_deg.0, range.delta_deg.1);
        let phi = angle(0).clamp(range.phi_deg.0, range.phi_deg.1).max(delta);
        let slope = angle(2).clamp(range.beta_deg.0, range.beta_deg.1);
        let slices = match self.slices.entry(node[2]) {
            std::collections::hash_map::Entry::Occupied(known) => known.into_mut(),
            std::collections::hash_map::Entry::Vacant(free) => free.insert(slices(self.setup, slope)?),
        };
        for (stroke, slice) in self.strokes.iter().zip(slices.iter()) {
            let told = stroke.told(&**slice, phi, delta);
            self.answered |= matches!(told, Ok(Told::Bounds(_)));
            self.told.push(told.unwrap_or_else(|refusal| {
                self.refusal.get_or_insert(refusal);
                Told::Nothing
            }));
        }
        self.places.insert(node, place);
        Ok(place)
    }

    /// What is told of a measurement at a point.
    pub(super) fn told(&self, place: usize, measurement: usize) -> Told {
        self.told.get(place + measurement).copied().unwrap_or(Told::Nothing)
    }

    /// An error if the model answered nowhere.
    pub(super) fn refusal(self) -> Result<(), EstimatorError> {
        match self.refusal {
            Some(refusal) if !self.answered => Err(refusal.into()),
            _ => Ok(()),
        }
    }
}

fn slices<'m>(setup: &Setup<'m>, slope_deg: f64) -> Result<Vec<Box<dyn ModelSlice + 'm>>, EstimatorError> {
    let of = |observation: &crate::Observation| {
        let plate = observation.plate();
        let slope = Angle::from_degrees(slope_deg);
        setup.model.at(plate.tool_angle(), slope, setup.width_ratio(plate)).map_err(|source| {
            EstimatorError::Model { context: format!("measurement {}: ", observation.label()), source }
        })
    };
    setup.observations.iter().map(of).collect()
}

impl Stroke {
    fn told(&self, slice: &dyn ModelSlice, phi_deg: f64, delta_deg: f64) -> Result<Told, EarthPressureError> {
        let net = match slice.net(phi_deg, delta_deg) {
            Ok(net) if net.weight_lower > 0.0 => net,
            Ok(_) | Err(EarthPressureError::Singular { .. }) => return Ok(Told::Singular),
            Err(refusal) => return Err(refusal),
        };
        // The lower end of the force is reached with the upper end of the bracket, and the other way round.
        let weight = [net.weight_upper, net.weight_lower].map(|k| self.scale[0] * k);
        let loads = [net.factors.cohesion, net.factors.adhesion, net.factors.surcharge];
        Ok(Told::Bounds(Bounds {
            force: [self.force_n[0] / weight[0], self.force_n[1] / weight[1]],
            loads: weight.map(|weight| loads.map(|k| self.scale[1] * k / weight)),
        }))
    }
}
