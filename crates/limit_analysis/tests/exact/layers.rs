//! Layers of clay: where both conjugate planes are at 45 degrees, wedges go straight through.

use crate::common::soil;
use crate::grounds::{heavy, wall};
use crate::{brackets, solve};

#[test]
fn a_smooth_wall_in_layered_clay_carries_what_its_layers_do() {
    for (upper, lower) in [(1.0, 2.0), (2.0, 0.5)] {
        let layers = [(0.4, heavy(soil(0.0, upper))), (0.6, heavy(soil(0.0, lower)))];
        let exact = 0.5 + 2.0 * (0.4 * upper + 0.6 * lower);
        brackets(
            &format!("smooth wall, layers of clay of strength {upper} and {lower}"),
            &solve(wall(&layers, [0.0, -1.0], 0.0, 1.0), 900),
            [exact; 2],
            0.01,
        );
    }
}
