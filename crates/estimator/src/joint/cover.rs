//! Cover of the consistent set by polytopes over simplices, cut finer level by level within a budget.

use super::factors::{Factors, units_below};
use super::shadow::{Piece, Shadows};
use super::simplex::{Box4, Known, Over, Simplex};
use super::unknowns::{Adhesion, Quantity, Unknowns};
use crate::{EstimatorError, Setup};

/// Edge of the first cells in lattice units: 2 deg.
const FIRST_CELL: i32 = 512;
/// Edge of the smallest cells: 1/8 deg.
const LAST_CELL: i32 = 32;

/// Simplices of the last level at most, by the number of unknowns: each costs as many linear programs as there are ends of intervals and slanting
/// sides of pairs.
const fn most_simplices(unknowns: usize) -> usize {
    match unknowns {
        0..=4 => 500,
        5 => 2000,
        _ => 8000,
    }
}

/// A cube of angles, and what is left of the linear quantities in it.
struct Cell {
    corner: [i32; 3],
    linear: Box4,
}

/// The cover of a setup.
pub(super) struct Cover<'s, 'm> {
    factors: Factors<'s, 'm>,
    known: Known,
    /// Angles that are not known.
    axes: Vec<usize>,
    unknown: Vec<Quantity>,
    cells: Vec<Cell>,
    size: i32,
}

impl<'s, 'm> Cover<'s, 'm> {
    /// The cover at the finest level that the budget allows.
    pub(super) fn new(setup: &'s Setup<'m>, unknowns: &Unknowns) -> Result<Self, EstimatorError> {
        let interval = |quantity| unknowns.interval(setup, quantity);
        let mut angles_deg = Quantity::ANGLES.map(interval);
        // No interface is rougher than the soil beside it.
        angles_deg[0].0 = angles_deg[0].0.max(angles_deg[1].0);
        let linear = Quantity::LINEAR.map(|quantity| <[f64; 2]>::from(interval(quantity)));
        let share = match unknowns.adhesion {
            Adhesion::ShareOfCohesion(share) if unknowns.cohesion_pa.0 < unknowns.cohesion_pa.1 => {
                Some(share)
            }
            Adhesion::ShareOfCohesion(_) | Adhesion::Pa(_) => None,
        };
        let axes: Vec<usize> =
            (0..3).filter(|&axis| axis == 0 || angles_deg[axis].0 < angles_deg[axis].1).collect();
        let mut corners = vec![[0; 3]];
        for &axis in &axes {
            let (low, high) = angles_deg[axis];
            let along = units_below(low, FIRST_CELL)..=units_below(high, FIRST_CELL);
            let places = along.step_by(FIRST_CELL as usize);
            corners = corners
                .iter()
                .flat_map(|corner: &[i32; 3]| {
                    places.clone().map(|place| {
                        let mut corner = *corner;
                        corner[axis] = place;
                        corner
                    })
                })
                .collect();
        }
        let mut cover = Self {
            factors: Factors::new(setup, unknowns),
            known: Known { angles_deg, share },
            axes,
            unknown: unknowns.unknown(setup),
            cells: corners.into_iter().map(|corner| Cell { corner, linear }).collect(),
            size: FIRST_CELL,
        };
        cover.contract()?;
        let most = most_simplices(cover.unknown.len());
        while cover.size > LAST_CELL && cover.simplices_of_next_level() <= most {
            cover.cut_angles();
            cover.contract()?;
        }
        Ok(cover)
    }

    /// Whether no soil is consistent.
    pub(super) const fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// An error if the model answered nowhere.
    pub(super) fn refusal(self) -> Result<(), EstimatorError> {
        self.factors.refusal()
    }

    fn simplices_of_next_level(&self) -> usize {
        let each: usize = (1..=self.axes.len()).product();
        (self.cells.len() << self.axes.len()) * each
    }

    /// Cuts all cells in halves along each angle.
    fn cut_angles(&mut self) {
        self.size /= 2;
        let (size, axes) = (self.size, &self.axes);
        let halves = |cell: &Cell| {
            (0..1_usize << axes.len())
                .map(|choice| {
                    let mut corner = cell.corner;
                    for (bit, &axis) in axes.iter().enumerate() {
                        corner[axis] += if choice >> bit & 1 == 1 { size } else { 0 };
                    }
                    Cell { corner, linear: cell.linear }
                })
                .collect::<Vec<_>>()
        };
        self.cells = self.cells.iter().flat_map(halves).collect();
    }

    /// Drops cells without consistent soils, and what the others do not need of density and loads.
    fn contract(&mut self) -> Result<(), EstimatorError> {
        let mut kept = Vec::with_capacity(self.cells.len());
        for Cell { corner, linear } in std::mem::take(&mut self.cells) {
            let mut hull: Option<Box4> = None;
            for simplex in simplices(corner, self.size, &self.axes) {
                let Some(over) = Over::new(&mut self.factors, &self.known, &simplex, linear)? else {
                    continue;
                };
                let Some(left) = left(&over, linear) else { continue };
                hull = Some(hull.map_or(left, |hull| union(hull, left)));
            }
            if let Some(linear) = hull {
                kept.push(Cell { corner, linear });
            }
        }
        self.cells = kept;
        Ok(())
    }

    /// What the cover leaves of each quantity and of each pair.
    pub(super) fn shadows(&mut self) -> Result<Shadows, EstimatorError> {
        let mut shadows = Shadows::new(self.unknown.clone());
        for cell in &self.cells {
            for simplex in simplices(cell.corner, self.size, &self.axes) {
                let over = Over::new(&mut self.factors, &self.known, &simplex, cell.linear)?;
                let piece = over.and_then(|over| Piece::new(&over, &self.unknown, cell.corner, self.size));
                shadows.extend(piece);
            }
        }
        Ok(shadows)
    }
}

/// What a polytope leaves of the linear quantities.
fn left(over: &Over<'_>, linear: Box4) -> Option<Box4> {
    let mut left = linear;
    for (quantity, interval) in Quantity::LINEAR.into_iter().zip(&mut left) {
        if interval[0] < interval[1] {
            let [low, high] = over.range(&over.quantity(quantity))?;
            *interval = [low.max(interval[0]), high.min(interval[1])];
            // Rounding may turn an interval of one value round.
            interval[1] = interval[1].max(interval[0]);
        }
    }
    // All may be known.
    over.range(&over.quantity(Quantity::Friction)).map(|_| left)
}

fn union(a: Box4, b: Box4) -> Box4 {
    [0, 1, 2, 3].map(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])])
}

/// The simplices of a cube: from its least corner along the axes, in each order (Kuhn 1960). Where delta would be above phi there is no soil.
fn simplices(corner: [i32; 3], size: i32, axes: &[usize]) -> Vec<Simplex> {
    orders(axes)
        .into_iter()
        .filter_map(|order| {
            let mut corners = vec![corner];
            let mut at = corner;
            for axis in order {
                at[axis] += size;
                corners.push(at);
            }
            let is_soil = !axes.contains(&1) || corners.iter().all(|at| at[1] <= at[0]);
            is_soil.then_some(Simplex { corners, size })
        })
        .collect()
}

fn orders(axes: &[usize]) -> Vec<Vec<usize>> {
    match axes {
        [] => vec![Vec::new()],
        _ => axes
            .iter()
            .flat_map(|&first| {
                let others: Vec<usize> = axes.iter().copied().filter(|&axis| axis != first).collect();
                orders(&others).into_iter().map(move |rest| [vec![first], rest].concat())
            })
            .collect(),
    }
}
