use nalgebra::Vector3;

/// The largest file that is read, in bytes.
pub const MOST_BYTES: u64 = 256 << 20;
/// Most triangles of all meshes of a robot.
pub const MOST_TRIANGLES: u64 = 2_000_000;
/// Nothing lies further out than this, in m.
const FURTHEST_M: f32 = 1e6;

/// Triangles in m, z up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Parts of one colour each.
    pub parts: Vec<Part>,
}

/// Triangles of one colour.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Part {
    /// Corners in m, all of them finite.
    pub points: Vec<[f32; 3]>,
    /// Of each corner the direction outwards, of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Numbers of corners, three a triangle, all of them there.
    pub triangles: Vec<[u32; 3]>,
    /// Red, green, blue and opacity from 0 to 1, if the file says so.
    pub colour: Option<[f32; 4]>,
}

impl Mesh {
    /// How many triangles there are.
    #[must_use]
    pub fn triangles(&self) -> u64 {
        self.parts.iter().map(|part| part.triangles.len() as u64).sum()
    }

    /// The two corners of the box around it; none if it is empty.
    #[must_use]
    pub fn bounds_m(&self) -> Option<[[f32; 3]; 2]> {
        let mut points = self.parts.iter().flat_map(|part| &part.points);
        let first = *points.next()?;
        let mut bounds = [first, first];
        for point in points {
            for (axis, value) in point.iter().enumerate() {
                bounds[0][axis] = bounds[0][axis].min(*value);
                bounds[1][axis] = bounds[1][axis].max(*value);
            }
        }
        Some(bounds)
    }
}

impl Part {
    /// Adds a triangle with corners of its own, seen as flat; one that is no triangle, or too far out, is left out.
    pub(crate) fn flat(&mut self, corners: [[f32; 3]; 3]) {
        let [a, b, c] = corners.map(|corner| Vector3::from(corner).cast::<f64>());
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0);
        let (true, Some(normal)) = (corners.iter().all(is_near), normal) else { return };
        let Ok(first) = u32::try_from(self.points.len()) else { return };
        #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
        let normal = [normal.x as f32, normal.y as f32, normal.z as f32];
        self.points.extend(corners);
        self.normals.extend([normal; 3]);
        self.triangles.push([first, first + 1, first + 2]);
    }
}

/// Whether a point is one that can be drawn.
pub(crate) fn is_near(point: &[f32; 3]) -> bool {
    point.iter().all(|value| value.abs() <= FURTHEST_M)
}
