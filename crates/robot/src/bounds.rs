//! How much is read: bounds on what a document may cost, far above what robots have.

/// The longest document in bytes.
pub const MOST_BYTES: usize = 64 << 20;
/// How deep elements may lie inside each other; URDF itself needs six levels.
pub const MOST_DEPTH: usize = 64;
/// The most links, joints, visuals or materials, each counted by itself.
pub const MOST_LINKS: usize = 100_000;
/// The largest size of a length in m, of an angle in rad and of a factor. It leaves room for map coordinates, and
/// products along the longest chain stay finite.
pub const MOST_SIZE: f64 = 1e9;
/// More notes than this are only counted.
pub(crate) const MOST_NOTES: usize = 100;
