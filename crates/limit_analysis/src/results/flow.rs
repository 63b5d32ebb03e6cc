use soilctl_certificate::{FlowPiece, Material, Mesh, ShownFlow, Statement, UpperField, show_flow};

use super::Point;
use super::finder::{Finder, barycentric};
use crate::error::LimitError;
use crate::vector::twice_area;

/// The flow behind an upper bound.
#[derive(Debug, Clone)]
pub struct FlowResults {
    pub(super) statement: Statement,
    pub(super) shown: ShownFlow,
    pub(super) saved: Mesh,
    pub(super) finder: Finder,
    top_speed: f64,
}

impl FlowResults {
    /// Takes a flow from a certificate.
    ///
    /// # Errors
    ///
    /// [`LimitError::Certificate`] if the field is not built as it must be. Nothing is proven here.
    pub fn new(statement: &Statement, field: &UpperField) -> Result<Self, LimitError> {
        let shown = show_flow(statement, field)?;
        let speeds = shown.pieces.iter().flatten().flat_map(|p| p.control).map(|[x, y]| x.hypot(y));
        let top_speed = speeds.fold(0.0, f64::max);
        let finder = Finder::new(&shown.corners, &shown.adjoins);
        Ok(Self { statement: statement.clone(), shown, saved: field.mesh.clone(), finder, top_speed })
    }

    /// The problem.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Corners of all triangles, counter-clockwise (length).
    #[must_use]
    pub fn triangles(&self) -> &[[Point; 3]] {
        &self.shown.corners
    }

    /// The polynomial pieces of the flow on each triangle: velocities in units of the structure's.
    #[must_use]
    pub fn pieces(&self) -> &[Vec<FlowPiece>] {
        &self.shown.pieces
    }

    /// The speed that others are compared with: that of the structure, or, if none moves, the greatest of all control
    /// points.
    #[must_use]
    pub fn speed(&self) -> f64 {
        let [x, y] = self.statement.objective.velocity();
        if x == 0.0 && y == 0.0 { self.top_speed } else { x.hypot(y) }
    }

    /// Velocity at a point; none outside of the soil. On a line where it jumps, that on one side.
    #[must_use]
    pub fn velocity(&self, p: Point) -> Option<Point> {
        let triangle = self.finder.triangle(p, 0)?;
        let of = |piece: &FlowPiece| barycentric(&piece.corners, p);
        let least = |piece: &FlowPiece| of(piece).into_iter().fold(f64::INFINITY, f64::min);
        let pieces = self.shown.pieces[triangle].iter();
        let piece = pieces.max_by(|a, b| least(a).total_cmp(&least(b)))?;
        Some(value(&piece.control, of(piece)))
    }

    /// Velocities at the corners of all triangles, in units of the structure's.
    #[must_use]
    pub fn corner_velocities(&self) -> Vec<[Point; 3]> {
        let of = |pieces: &Vec<FlowPiece>| match &pieces[..] {
            // Three parts: the first corner of each is the one after that which it lies opposite to.
            [a, b, c] => [c.control[0], a.control[0], b.control[0]],
            parts => parts.first().map_or([[0.0; 2]; 3], |whole| [0, 1, 2].map(|k| whole.control[k])),
        };
        self.pieces().iter().map(of).collect()
    }

    pub(super) fn material(&self, triangle: usize) -> &Material {
        &self.statement.regions[self.saved.triangles[triangle].region].material
    }

    /// Control points on an edge, walked with the triangle on the left.
    pub(super) fn on_edge(&self, triangle: usize, corner: usize) -> [Point; 3] {
        match &self.shown.pieces[triangle][..] {
            [whole] => [(corner + 1) % 3, 3 + corner, (corner + 2) % 3].map(|i| whole.control[i]),
            parts => [0, 5, 1].map(|i| parts[corner].control[i]),
        }
    }

    /// Ends of an edge, walked likewise.
    pub(super) fn ends(&self, triangle: usize, corner: usize) -> [Point; 2] {
        let v = &self.shown.corners[triangle];
        [v[(corner + 1) % 3], v[(corner + 2) % 3]]
    }
}

/// A quadratic polynomial in Bernstein form.
pub(super) fn value(control: &[Point; 6], l: [f64; 3]) -> Point {
    let [l0, l1, l2] = l;
    let weights = [l0 * l0, l1 * l1, l2 * l2, 2.0 * l1 * l2, 2.0 * l2 * l0, 2.0 * l0 * l1];
    [0, 1].map(|axis| weights.iter().zip(control).map(|(w, b)| w * b[axis]).sum())
}

/// Strain rates `[exx, eyy, 2 exy]` at the corners of a piece; between them they are linear. Extension is positive.
#[must_use]
pub(super) fn strain_rates(piece: &FlowPiece) -> [[f64; 3]; 3] {
    let v = &piece.corners;
    let whole = twice_area([v[0], v[1], v[2]]);
    // Of the barycentric coordinates.
    let gradients = [0, 1, 2].map(|k| {
        let (a, b) = (v[(k + 1) % 3], v[(k + 2) % 3]);
        [(a[1] - b[1]) / whole, (b[0] - a[0]) / whole]
    });
    [0, 1, 2].map(|k| {
        let mut rate = [0.0; 3];
        for i in [(k + 1) % 3, (k + 2) % 3] {
            // The control point on the edge between corners k and i.
            let (b, own) = (piece.control[6 - k - i], piece.control[k]);
            let [x, y] = [2.0 * (b[0] - own[0]), 2.0 * (b[1] - own[1])];
            let [gx, gy] = gradients[i];
            rate[0] += x * gx;
            rate[1] += y * gy;
            rate[2] += x * gy + y * gx;
        }
        rate
    })
}

/// Dilation and shear rate, the diameter of Mohr's circle.
pub(super) fn invariants([exx, eyy, shear]: [f64; 3]) -> [f64; 2] {
    [exx + eyy, (exx - eyy).hypot(shear)]
}

pub(super) fn area(piece: &FlowPiece) -> f64 {
    0.5 * twice_area([piece.corners[0], piece.corners[1], piece.corners[2]])
}
