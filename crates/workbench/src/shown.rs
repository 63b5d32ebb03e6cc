//! The flow behind an upper bound as pages take it: short numbers, in metres.

use serde::Serialize;
use soilctl_app::limits::Fields;

/// Places are rounded to this part of the ground's size, velocities to this part of the greatest one: what a screen can show.
const PLACES: f64 = 1e5;
const VELOCITIES: f64 = 2000.0;

/// The mesh, its velocities, and where these jump.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Shown {
    /// Corners of all triangles: x and y of the first, second and third, in m.
    triangles: Vec<[f64; 6]>,
    /// Velocities there, over the greatest.
    velocities: Vec<[f64; 6]>,
    /// The velocity of the structure likewise; zero if none moves.
    structure: [f64; 2],
    /// Edges along which soil slides: x and y of both ends, and how much is dissipated per length, over the greatest.
    slips: Vec<[f64; 5]>,
}

impl Shown {
    /// Of the fields of a solution; none if there is no flow.
    pub(crate) fn new(fields: &Fields) -> Option<Self> {
        let flow = fields.flow.as_ref()?;
        let at = |p: &[f64; 2]| fields.units.point(*p);
        let places: Vec<[[f64; 2]; 3]> =
            flow.triangles().iter().map(|corners| [0, 1, 2].map(|k| at(&corners[k]))).collect();
        let reach = places.iter().flatten().flatten().map(|x| x.abs()).fold(f64::MIN_POSITIVE, f64::max);
        let place = |x: f64| round(x, reach / PLACES);
        let velocities = flow.corner_velocities();
        let top = velocities.iter().flatten().map(|[x, y]| x.hypot(*y)).fold(flow.speed(), f64::max);
        let top = top.max(f64::MIN_POSITIVE);
        let flat = |[a, b, c]: [[f64; 2]; 3]| [a[0], a[1], b[0], b[1], c[0], c[1]];
        let jumps = flow.jumps();
        let most = jumps.iter().map(|jump| jump.dissipation).fold(f64::MIN_POSITIVE, f64::max);
        let slip = |jump: &soilctl_limit_analysis::results::Jump| {
            let [a, b] = jump.ends.map(|p| at(&p).map(place));
            [a[0], a[1], b[0], b[1], round(jump.dissipation / most, 1e-3)]
        };
        Some(Self {
            triangles: places.iter().map(|corners| flat(*corners).map(place)).collect(),
            velocities: velocities
                .iter()
                .map(|v| flat(*v).map(|x| round(x / top, 1.0 / VELOCITIES)))
                .collect(),
            structure: flow.statement().objective.velocity().map(|x| round(x / top, 1.0 / VELOCITIES)),
            slips: jumps.iter().map(slip).filter(|slip| slip[4] > 0.0).collect(),
        })
    }
}

/// To a multiple of a step, in few digits.
fn round(value: f64, step: f64) -> f64 {
    let digits = (-step.log10()).ceil().clamp(0.0, 12.0) as i32;
    let scale = 10_f64.powi(digits);
    (value * scale).round() / scale
}
