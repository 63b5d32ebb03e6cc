use soilctl_certificate::{LowerField, Mesh, ShownStress, Statement, show_stress};

use super::Point;
use super::finder::{Finder, barycentric, centroid};
use crate::error::LimitError;

/// The stress field behind a lower bound.
#[derive(Debug, Clone)]
pub struct StressResults {
    pub(super) statement: Statement,
    pub(super) shown: ShownStress,
    pub(super) saved: Mesh,
    finder: Finder,
}

impl StressResults {
    /// Takes a stress field from a certificate.
    ///
    /// # Errors
    ///
    /// [`LimitError::Certificate`] if the field is not built as it must be. Nothing is proven here.
    pub fn new(statement: &Statement, field: &LowerField) -> Result<Self, LimitError> {
        let shown = show_stress(statement, field)?;
        let finder = Finder::new(&shown.corners, &shown.adjoins);
        Ok(Self { statement: statement.clone(), shown, saved: field.mesh.clone(), finder })
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

    /// Total stress `[xx, yy, xy]` at a point, tension positive; none outside of the soil. On a line where it jumps, that
    /// on one side.
    #[must_use]
    pub fn stress(&self, p: Point) -> Option<[f64; 3]> {
        self.stress_from(p, 0).map(|(_, stress)| stress)
    }

    /// The same, looked for from a triangle on; also the triangle.
    pub(super) fn stress_from(&self, p: Point, start: usize) -> Option<(usize, [f64; 3])> {
        let triangle = self.finder.triangle(p, start)?;
        let v = &self.shown.corners[triangle];
        let l = barycentric(v, p);
        // A part is nearer to its edge than the others are.
        let k = (0..3).min_by(|a, b| l[*a].total_cmp(&l[*b]))?;
        let part = [v[(k + 1) % 3], v[(k + 2) % 3], centroid(v)];
        let weights = barycentric(&part, p);
        let nodes = &self.shown.parts[triangle][k];
        Some((triangle, [0, 1, 2].map(|c| (0..3).map(|i| weights[i] * nodes[i][c]).sum())))
    }
}

/// Principal stresses in the plane, compression positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// The greater compression (stress).
    pub major: f64,
    /// The lesser one (stress); negative if it is a tension.
    pub minor: f64,
    /// Unit vector along the greater one; to the right, or straight up.
    pub direction: Point,
}

impl Principal {
    /// From `[xx, yy, xy]`, tension positive.
    #[must_use]
    pub fn of([xx, yy, xy]: [f64; 3]) -> Self {
        let mean = 0.5 * (xx + yy);
        let radius = (0.5 * (xx - yy)).hypot(xy);
        // The greater tension lies at half of this angle, the greater compression across it.
        let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
        let direction = if sin > 0.0 { [sin, -cos] } else { [-sin, cos] };
        Self { major: radius - mean, minor: -radius - mean, direction }
    }

    /// Radius of Mohr's circle: the greatest shear stress.
    #[must_use]
    pub fn radius(&self) -> f64 {
        0.5 * (self.major - self.minor)
    }
}
