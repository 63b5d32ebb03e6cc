//! The mechanism in the plane: blocks between rays from the plate's top, each moving as one.
//!
//! Coordinates: the plate's top edge at the origin, x ahead, z up, slant length 1, the plate moving ahead with unit
//! speed. Angles of rays are dips below the horizontal, angles of velocities ("headings") rise above it.

use std::f64::consts::PI;

use crate::Case;

/// Blocks between plate and surface.
const BLOCKS: usize = 12;

/// Least angle between rays: the facets of thinner blocks would be rounding.
const THINNEST: f64 = 5e-5;

/// Least angle between the first ray and the directions that leave it: a cone that touches the ray would have facets that
/// are rounding next to the plate's top.
pub(super) const FLATTEST: f64 = 1e-4;

/// What is free in the mechanism: rays and headings run evenly from the first to the last.
///
/// Four blocks whose rays and headings are each on their own are lower than four even ones by less than 0.01 % at
/// (phi 30, delta 15) and (40, 25); twelve blocks are lower than eight by 0.05 %.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape {
    pub(super) first_ray: f64,
    pub(super) last_ray: f64,
    pub(super) first_heading: f64,
    pub(super) last_heading: f64,
}

/// A rigid block between two rays.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    /// Dips of the ray towards the plate and of the one towards the surface.
    pub(super) rays: [f64; 2],
    /// Distances from the origin to the slip line along these rays.
    pub(super) radii: [f64; 2],
    pub(super) heading: f64,
    pub(super) speed: f64,
}

impl Block {
    /// Area per unit of width.
    pub(super) fn area(&self) -> f64 {
        0.5 * self.radii[0] * self.radii[1] * libm::sin(self.rays[0] - self.rays[1])
    }

    /// Upward part of the velocity.
    pub(super) fn rise(&self) -> f64 {
        self.speed * libm::sin(self.heading)
    }
}

/// The blocks of a shape; `None` where they do not flow as the rule of flow demands.
///
/// The soil slides along the plate at the angle delta to it (separating), along each ray and along the slip line below
/// at the angle phi. With `p` the direction of the plate's force, no work is done on what slides along the plate:
/// `V_1 sin(alpha + delta + heading) = sin(alpha + delta)`. At a ray of dip a, the jump has the direction
/// `180 deg - a - phi`, so speeds are as `sin(a + phi + heading)` of the other block.
pub(super) fn blocks(case: &Case, shape: &Shape) -> Option<Vec<Block>> {
    let (alpha, phi) = (case.tool_angle.radians(), case.friction.radians());
    let plate = alpha + case.interface.radians();
    let between = |first: f64, last: f64, part: usize, parts: usize| {
        first + (last - first) * part as f64 / parts as f64
    };
    let ray = |i: usize| match i {
        0 => alpha,
        BLOCKS => -case.surface_slope.radians(),
        _ => between(shape.first_ray, shape.last_ray, i - 1, BLOCKS - 2),
    };
    let mut blocks: Vec<Block> = Vec::with_capacity(BLOCKS);
    for i in 0..BLOCKS {
        let rays = [ray(i), ray(i + 1)];
        let heading = between(shape.first_heading, shape.last_heading, i, BLOCKS - 1);
        let (before, after, radius) = match blocks.last() {
            None => (libm::sin(plate), libm::sin(plate + heading), 1.0),
            Some(last) => {
                let turned = rays[0] + phi;
                (last.speed * libm::sin(turned + last.heading), libm::sin(turned + heading), last.radii[1])
            }
        };
        // All directions within phi of the velocity come from the first ray and cross the second.
        let enters = heading + rays[0] <= PI - phi - FLATTEST;
        let leaves = libm::sin(heading + rays[1]) > libm::sin(phi) && heading + rays[1] < PI - phi;
        let turns = heading >= blocks.last().map_or(0.0, |last| last.heading);
        if rays[0] - rays[1] < THINNEST || !enters || !leaves || !turns || before <= 0.0 || after <= 1e-6 {
            return None;
        }
        let base = heading - phi;
        let next = radius * libm::sin(rays[0] + base) / libm::sin(rays[1] + base);
        if next.is_nan() || next <= 0.0 {
            return None;
        }
        blocks.push(Block { rays, radii: [radius, next], heading, speed: before / after });
    }
    Some(blocks)
}
