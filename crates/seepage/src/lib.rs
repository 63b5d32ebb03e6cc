//! Steady flow of ground water through saturated and dry soil in a plane.
//!
//! Darcy's law, `q = -k grad h` with the total head `h = y + p`, where `p` is the pressure of the water over its unit weight, both in
//! metres, and the flow keeps its volume. Soil has one permeability along x and one along y. Its boundary has a given head, lies in air, or
//! lets nothing through; walls inside it let nothing through either. Ground in air is where water may come out, at no pressure, and
//! nothing goes in (a seepage face).
//!
//! Linear triangles. Above the free surface the permeability falls to a hundredth within a quarter of the height of one triangle, so the free
//! surface is found with an error of that order, while flow without one is that of ordinary finite elements. Which
//! of the nodes in air let water out is found along with the rest, by an active set.
//!
//! Harr, M. E. (1962), *Groundwater and Seepage*, has the exact solutions of the tests; Bathe, K.-J. and Khoshgoftaar, M. R. (1979),
//! *Finite element free surface seepage analysis without mesh iteration*, Int. J. Numer. Anal. Meth. Geomech. 3, 13-22, is where permeability
//! that falls with the pressure comes from.
//!
//! ```
//! use soilctl_seepage::{Boundary, Condition, Ground, Triangle};
//!
//! // A column, one metre wide and high, with a head of 3 m at its foot and of 1 m, the water's own level, on top.
//! let isotropic = [1e-5, 1e-5];
//! let ground = Ground {
//!     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
//!     triangles: vec![
//!         Triangle { corners: [0, 1, 2], permeability: isotropic },
//!         Triangle { corners: [0, 2, 3], permeability: isotropic },
//!     ],
//!     boundaries: vec![
//!         Boundary { triangle: 0, opposite: 2, condition: Condition::Head { head: 3.0, entry: 0 } },
//!         Boundary { triangle: 1, opposite: 0, condition: Condition::Air },
//!     ],
//!     walls: vec![],
//! };
//! let flow = ground.flow()?;
//! assert!((flow.inflow[0] - 2e-5).abs() < 1e-15);
//! # Ok::<(), soilctl_seepage::SeepageError>(())
//! ```

mod error;
mod flow;
mod ground;
mod linear;
mod nodes;

pub use error::SeepageError;
pub use flow::Flow;
pub use ground::{Boundary, Condition, Ground, Triangle};
