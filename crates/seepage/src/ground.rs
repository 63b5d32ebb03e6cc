use std::collections::BTreeMap;

use crate::error::SeepageError;

/// Least and greatest permeability in m/s: tight clay and rock to boulders have 1e-13 to 1.
const PERMEABILITY: [f64; 2] = [1e-15, 1e3];

/// A triangle of soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    /// Indices of its corners, counter-clockwise.
    pub corners: [usize; 3],
    /// Permeability along x and along y in m/s, 1e-15 to 1e3.
    pub permeability: [f64; 2],
}

/// What holds along an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Condition {
    /// A given total head in m.
    Head {
        /// The head.
        head: f64,
        /// Of which entry it is, from 0: what flows in is told for each.
        entry: usize,
    },
    /// Water comes out at no pressure, or nothing passes.
    Air,
}

/// An edge of a triangle that lets water through. All other edges of one triangle only let nothing through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary {
    /// Index of the triangle.
    pub triangle: usize,
    /// The corner opposite to the edge, 0 to 2.
    pub opposite: usize,
    /// What holds.
    pub condition: Condition,
}

/// Soil with its boundary.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ground {
    /// Points in m, y upwards.
    pub points: Vec<[f64; 2]>,
    /// Triangles that share edges.
    pub triangles: Vec<Triangle>,
    /// Where water passes.
    pub boundaries: Vec<Boundary>,
    /// Edges inside the soil that let nothing through, by their points.
    pub walls: Vec<[usize; 2]>,
}

pub(crate) fn pair(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

impl Ground {
    /// The same ground with each triangle cut into four at the middles of its edges. Those of triangle `t` are `4 t` to `4 t + 3`; the
    /// corner `i` of `4 t + i` is corner `i` of `t`.
    ///
    /// # Errors
    ///
    /// [`SeepageError::Index`] for a point, triangle or corner that is not there.
    pub fn refined(&self) -> Result<Self, SeepageError> {
        self.check_indices()?;
        let mut points = self.points.clone();
        let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut middle = |a: usize, b: usize| {
            *middles.entry(pair(a, b)).or_insert_with(|| {
                let [p, q] = [points[a], points[b]];
                points.push([0, 1].map(|i| 0.5 * (p[i] + q[i])));
                points.len() - 1
            })
        };
        let mut triangles = Vec::with_capacity(4 * self.triangles.len());
        for Triangle { corners: [a, b, c], permeability } in &self.triangles {
            let [opposite_a, opposite_b, opposite_c] = [middle(*b, *c), middle(*c, *a), middle(*a, *b)];
            let four = [
                [*a, opposite_c, opposite_b],
                [opposite_c, *b, opposite_a],
                [opposite_b, opposite_a, *c],
                [opposite_a, opposite_b, opposite_c],
            ];
            triangles.extend(four.map(|corners| Triangle { corners, permeability: *permeability }));
        }
        // Both halves of an edge are opposite to the corner that the whole is opposite to.
        let halves =
            |b: &Boundary| [1, 2].map(|i| Boundary { triangle: 4 * b.triangle + (b.opposite + i) % 3, ..*b });
        let boundaries = self.boundaries.iter().flat_map(halves).collect();
        let split = |[a, b]: &[usize; 2]| {
            middles.get(&pair(*a, *b)).map_or_else(Vec::new, |m| vec![[*a, *m], [*m, *b]])
        };
        let walls = self.walls.iter().flat_map(split).collect();
        Ok(Self { points, triangles, boundaries, walls })
    }

    pub(crate) fn check(&self) -> Result<(), SeepageError> {
        self.check_indices()?;
        let finite = |what, value: f64| {
            let number = SeepageError::Number { what, value, allowed: "a finite number of metres" };
            if value.is_finite() { Ok(()) } else { Err(number) }
        };
        for p in &self.points {
            finite("x", p[0])?;
            finite("y", p[1])?;
        }
        for t in &self.triangles {
            for value in t.permeability {
                let allowed = "1e-15 to 1e3 m/s";
                if !(PERMEABILITY[0]..=PERMEABILITY[1]).contains(&value) {
                    return Err(SeepageError::Number { what: "a permeability", value, allowed });
                }
            }
        }
        for b in &self.boundaries {
            if let Condition::Head { head, .. } = b.condition {
                finite("a head", head)?;
            }
        }
        Ok(())
    }

    fn check_indices(&self) -> Result<(), SeepageError> {
        let within = |what, index: usize, count: usize| {
            if index < count { Ok(()) } else { Err(SeepageError::Index { what, index, count }) }
        };
        let points = self.triangles.iter().flat_map(|t| &t.corners).chain(self.walls.iter().flatten());
        for point in points {
            within("point", *point, self.points.len())?;
        }
        for b in &self.boundaries {
            within("triangle", b.triangle, self.triangles.len())?;
            within("corner", b.opposite, 3)?;
        }
        Ok(())
    }
}
