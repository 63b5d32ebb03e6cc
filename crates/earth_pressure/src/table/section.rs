//! A table at one tool angle, and look-ups in it.

use soilctl_soil::Rounded;

use super::cubic::{cell_error, hermite, node_slope};
use super::interpolate::Interpolator;
use super::place::{Node, Place};
use crate::EarthPressureError;

/// Result of a look-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lookup {
    /// Slant-normalised net coefficient.
    pub(super) k_net: f64,
    /// By how much, relatively, it may differ from what a solve would give; 0 at a solved node.
    pub(super) margin: f64,
}

/// `ln K` and the margin so far at the nodes of phi and delta, at one tool angle.
trait Grid {
    fn section(&self) -> &Section<'_>;

    fn node(&self, j: usize, k: usize) -> Option<Node>;

    /// Slope of `ln K` along delta at a node.
    fn slope(&self, j: usize, k: usize) -> f64;

    /// Bound on the error along phi in the cell above a node and along delta in the cell to its right, before the
    /// factor t (1 - t). Between nodes of the other axis it is interpolated, so that the margin is continuous.
    fn errors(&self, j: usize, k: usize) -> (f64, f64);
}

fn slope_at(grid: &impl Grid, j: usize, k: usize) -> f64 {
    node_slope(grid.section().delta(), k, |k| Some(grid.node(j, k)?.ln_k))
}

fn errors_at(grid: &impl Grid, j: usize, k: usize) -> (f64, f64) {
    let ln_k = |j: usize, k: usize| Some(grid.node(j, k)?.ln_k);
    let (phi, delta) = (grid.section().phi(), grid.section().delta());
    // Where delta > phi a node is made up.
    let seen_phi = phi.partition_point(|&phi| phi < delta[k])..phi.len();
    let seen_delta = 0..delta.partition_point(|&delta| delta <= phi[j]);
    (cell_error(phi, j, &seen_phi, |j| ln_k(j, k)), cell_error(delta, k, &seen_delta, |k| ln_k(j, k)))
}

impl Interpolator {
    /// The table at a tool angle in degrees, for one look-up.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the angle is outside the range of the table.
    pub(super) fn at(&self, alpha_deg: f64) -> Result<Section<'_>, EarthPressureError> {
        let alphas = &self.table().axes()[0];
        let place = Place::find(alphas, alpha_deg).ok_or_else(|| {
            self.table().bad(format!(
                "alpha is {} deg; the table covers {} to {} deg",
                Rounded(alpha_deg),
                Rounded(alphas[0]),
                Rounded(alphas[alphas.len() - 1])
            ))
        })?;
        Ok(Section { whole: self, alpha_deg, place })
    }

    /// The same for many look-ups.
    ///
    /// # Errors
    /// As [`Interpolator::at`].
    pub(super) fn slice(&self, alpha_deg: f64) -> Result<TableSlice<'_>, EarthPressureError> {
        Ok(TableSlice::new(self.at(alpha_deg)?))
    }
}

/// A table at one tool angle. Nodes are worked out when they are asked for, which for one look-up are few.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section<'a> {
    pub(super) whole: &'a Interpolator,
    pub(super) alpha_deg: f64,
    pub(super) place: Place,
}

impl<'a> Section<'a> {
    fn phi(&self) -> &'a [f64] {
        &self.whole.table().axes()[1]
    }

    fn delta(&self) -> &'a [f64] {
        &self.whole.table().axes()[2]
    }

    /// A node between those of the table along alpha.
    fn between(&self, j: usize, k: usize) -> Option<Node> {
        let Place { cell, t } = self.place;
        let at = |i: usize| self.whole.node(i, j, k);
        let left = at(cell)?;
        let mut node = left.node;
        if t != 0.0 {
            let right = at(cell + 1)?.node;
            let alphas = &self.whole.table().axes()[0];
            let h = alphas[cell + 1] - alphas[cell];
            let ends = ((node.ln_k, left.slopes.0), (right.ln_k, left.slopes.1));
            node.ln_k = hermite(h, ends.0, ends.1, t);
            node.margin += t * (right.margin - node.margin);
        }
        node.margin += t * (1.0 - t) * left.error;
        Some(node)
    }
}

impl Grid for Section<'_> {
    fn section(&self) -> &Section<'_> {
        self
    }

    /// The node just above delta = phi in each row comes from a parallelogram, so that the triangle of the grid
    /// below the diagonal is interpolated linearly. Such a node is never an answer itself: delta <= phi.
    fn node(&self, j: usize, k: usize) -> Option<Node> {
        let node = self.between(j, k);
        let (phi, delta) = (self.phi(), self.delta());
        let is_above = || k > 0 && j + 1 < phi.len() && delta[k] > phi[j] && delta[k - 1] <= phi[j];
        if node.is_some() || !is_above() {
            return node;
        }
        let (a, b, c) = (self.between(j, k - 1)?, self.between(j + 1, k)?, self.between(j + 1, k - 1)?);
        Some(Node { ln_k: a.ln_k + b.ln_k - c.ln_k, margin: a.margin.max(b.margin).max(c.margin) })
    }

    fn slope(&self, j: usize, k: usize) -> f64 {
        slope_at(self, j, k)
    }

    fn errors(&self, j: usize, k: usize) -> (f64, f64) {
        errors_at(self, j, k)
    }
}

/// A table at one tool angle with all that a look-up needs, worked out for many of them.
#[derive(Debug, Clone)]
pub(super) struct TableSlice<'a> {
    section: Section<'a>,
    /// Row by row in phi, as what follows.
    nodes: Vec<Option<Node>>,
    slopes: Vec<f64>,
    errors: Vec<(f64, f64)>,
}

impl<'a> TableSlice<'a> {
    pub(super) fn new(section: Section<'a>) -> Self {
        let columns = section.delta().len();
        let places = || (0..section.phi().len()).flat_map(|j| (0..columns).map(move |k| (j, k)));
        let nodes = places().map(|(j, k)| section.node(j, k)).collect();
        let mut slice = Self { section, nodes, slopes: Vec::new(), errors: Vec::new() };
        slice.slopes = places().map(|(j, k)| slope_at(&slice, j, k)).collect();
        slice.errors = places().map(|(j, k)| errors_at(&slice, j, k)).collect();
        slice
    }

    fn index(&self, j: usize, k: usize) -> usize {
        j * self.section.delta().len() + k
    }

    /// As [`Section::lookup`].
    pub(super) fn lookup(&self, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
        lookup(self, phi_deg, delta_deg)
    }
}

impl Grid for TableSlice<'_> {
    fn section(&self) -> &Section<'_> {
        &self.section
    }

    fn node(&self, j: usize, k: usize) -> Option<Node> {
        self.nodes[self.index(j, k)]
    }

    fn slope(&self, j: usize, k: usize) -> f64 {
        self.slopes[self.index(j, k)]
    }

    fn errors(&self, j: usize, k: usize) -> (f64, f64) {
        self.errors[self.index(j, k)]
    }
}

impl Section<'_> {
    /// Look-up at phi and delta in degrees.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the point is outside the table, [`EarthPressureError::EmptyCell`] if
    /// the cells around it are not filled.
    pub(super) fn lookup(&self, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
        lookup(self, phi_deg, delta_deg)
    }
}

fn lookup(grid: &impl Grid, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
    let section = grid.section();
    let (phi, delta) = (section.phi(), section.delta());
    let place = |axis: &[f64], x: f64, label: &str| {
        Place::find(axis, x).ok_or_else(|| {
            section.whole.table().bad(format!(
                "{label} is {} deg; the table covers {} to {} deg",
                Rounded(x),
                Rounded(axis[0]),
                Rounded(axis[axis.len() - 1])
            ))
        })
    };
    let in_phi = place(phi, phi_deg, "phi")?;
    let in_delta = place(delta, delta_deg, "delta")?;
    let node = in_phi.interpolate(phi, |j| along_delta(grid, j, in_delta));
    let node = node.ok_or_else(|| EarthPressureError::EmptyCell {
        table: section.whole.table().name().into(),
        alpha_deg: section.alpha_deg,
        phi_deg,
        delta_deg,
    })?;
    let error = |j: usize, k: usize| grid.errors(j.min(phi.len() - 1), k.min(delta.len() - 1));
    let (j, k) = (in_phi.cell, in_delta.cell);
    let here = error(j, k);
    let along_phi = here.0 + in_delta.t * (error(j, k + 1).0 - here.0);
    let along_delta = here.1 + in_phi.t * (error(j + 1, k).1 - here.1);
    let margin =
        node.margin + in_phi.t * (1.0 - in_phi.t) * along_phi + in_delta.t * (1.0 - in_delta.t) * along_delta;
    Ok(Lookup { k_net: libm::exp(node.ln_k), margin })
}

/// Row `j` at a place along delta.
fn along_delta(grid: &impl Grid, j: usize, place: Place) -> Option<Node> {
    let a = grid.node(j, place.cell)?;
    if place.t == 0.0 {
        return Some(a);
    }
    let b = grid.node(j, place.cell + 1)?;
    let delta = grid.section().delta();
    let h = delta[place.cell + 1] - delta[place.cell];
    let ends = ((a.ln_k, grid.slope(j, place.cell)), (b.ln_k, grid.slope(j, place.cell + 1)));
    Some(Node {
        ln_k: hermite(h, ends.0, ends.1, place.t),
        margin: a.margin + place.t * (b.margin - a.margin),
    })
}
