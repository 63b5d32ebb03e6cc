//! A piece of an infinite slope, in axes along and across it. Its ends carry the tractions of the infinite slope at its
//! limit, as dead loads, so the piece is at its limit too.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement};

use super::common::{soil, statement};
use super::grounds::heavy;

const LENGTH: f64 = 3.0;

/// A layer of thickness one on a stronger one; on its base act a pressure and a shear stress at the limit.
pub(crate) fn layer(
    material: Material,
    pressure: f64,
    shear: f64,
    objective: Objective,
    gravity: [f64; 2],
) -> Statement {
    let points = [[0.0, 0.0], [0.0, -1.0], [LENGTH, -1.0], [LENGTH, 0.0], [0.0, -1.5], [LENGTH, -1.5]];
    let strong = Material { cohesion: Linear::uniform(20.0), ..material.clone() };
    // The pressure along the layer at its base, where the circle of stresses touches the limit; water adds to both.
    let along = pressure + 2.0 * shear * material.phi_deg.to_radians().tan();
    let regions: [(&[usize], Material); 2] = [(&[0, 1, 2, 3], material), (&[1, 4, 5, 2], strong)];
    let it = statement(&regions, &points, objective, |[x, y]| match () {
        () if y == 0.0 => Condition::Free,
        // Lines lead down on the left, up on the right.
        () if y > -1.0 && x == 0.0 => {
            Condition::Loaded { pressure: [0.0, along], shear: [0.0, shear], live: false }
        }
        () if y > -1.0 => Condition::Loaded { pressure: [along, 0.0], shear: [shear, 0.0], live: false },
        () => Condition::Fixed,
    });
    Statement { gravity, ..it }
}

/// An infinite slope of height one at its limit; the factor on its weight is one. Pore pressure grows with the depth.
pub(crate) fn infinite_slope(beta_deg: f64, phi_deg: f64, water: f64) -> Statement {
    let (sin, cos) = beta_deg.to_radians().sin_cos();
    let cohesion = sin - (cos - water) * phi_deg.to_radians().tan();
    assert!(cohesion > 0.0);
    let pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -water] };
    let material = Material { pore_pressure, ..heavy(soil(phi_deg, cohesion)) };
    layer(material, cos, sin, Objective::Body { gravity: [sin, -cos] }, [0.0, 0.0])
}
