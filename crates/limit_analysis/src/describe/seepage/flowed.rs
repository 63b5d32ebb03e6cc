/// What a flow is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowUnit {
    /// m3/s for a metre of width.
    M2PerS,
    /// The same over the permeability, which is not given: m.
    OverPermeability,
}

/// What flows in where a head is given.
#[derive(Debug, Clone, PartialEq)]
pub struct HeadFlow {
    /// Name of the entry.
    pub name: Option<String>,
    /// The total head in m.
    pub head_m: f64,
    /// What flows into the soil; negative where it flows out.
    pub inflow: f64,
}

/// A steady flow of ground water.
#[derive(Debug, Clone, PartialEq)]
pub struct Flowed {
    /// For each given head.
    pub heads: Vec<HeadFlow>,
    /// What comes out of ground in air.
    pub seepage: f64,
    /// Unit of flows.
    pub unit: FlowUnit,
    /// Greatest loss of head over the way where water comes out, and where; it grows without limit on finer triangles at a sharp
    /// corner.
    pub exit_gradient: Option<(f64, [f64; 2])>,
    /// The free surface, in pieces: below it the pores are under pressure.
    pub free_surface: Vec<[[f64; 2]; 2]>,
    /// Where the head is nine values in equal steps between the least and the greatest one, below the free surface, in pieces.
    pub equipotentials: Vec<[[f64; 2]; 2]>,
    /// Triangles in which pore pressures are linear and not zero.
    pub triangles: usize,
    /// Greatest pore pressure in kPa.
    pub greatest_kpa: f64,
    /// Greatest difference between pore pressures as proven and those of triangles a sixty-fourth as large, in kPa.
    pub kept_within_kpa: f64,
    /// Greatest difference, at the corners of triangles, between those and the ones of triangles four times as large, in kPa.
    pub found_within_kpa: f64,
}
