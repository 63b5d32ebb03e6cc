//! The mechanism as polyhedra that can be proven.
//!
//! Axes are along and across the surface, with the plate's top at the origin; the slant length is 1.

use soilctl_certificate::{BeyondFacet, Facet, Mechanism, Position};

use super::behind::Wedge;
use super::ends::{self, Corner, FIRST_FACE, Rim, Swept};
use super::fan::Block;
use crate::Case;

/// A mechanism that grows.
struct Builder {
    made: Mechanism,
    half_width: f64,
}

/// Vertices that all faces share: the plate's upper edge in the middle and at its end.
const TOP: [usize; 2] = [0, 1];

impl Builder {
    fn vertex(&mut self, position: Position) -> usize {
        self.made.vertices.push(position);
        self.made.vertices.len() - 1
    }

    /// Vertices of half a face in the plane of a ray, around it: the upper edge, the rim of its end, the lower edge's middle.
    fn face(&mut self, rim: &[Corner], place: impl Fn(Corner) -> Position) -> Vec<usize> {
        let end = rim.iter().skip(1).map(|&[r, y]| [r, y + self.half_width]);
        let lowest = rim.last().map(|&[r, _]| [r, 0.0]);
        let corners: Vec<Corner> = end.chain(lowest).collect();
        TOP.into_iter().chain(corners.into_iter().map(|corner| self.vertex(place(corner)))).collect()
    }

    /// Adds facets of a block, turned outwards from a point inside it.
    fn facets(
        &mut self,
        block: usize,
        inside: [f64; 3],
        facets: impl IntoIterator<Item = ([usize; 3], BeyondFacet)>,
        at: impl Fn(Position) -> [f64; 3],
    ) {
        for ([a, b, c], beyond) in facets {
            let [p, q, r] = [a, b, c].map(|k| at(self.made.vertices[k]));
            let (u, v, w) = (less(q, p), less(r, p), less(p, inside));
            let volume = w[0] * (u[1] * v[2] - u[2] * v[1])
                + w[1] * (u[2] * v[0] - u[0] * v[2])
                + w[2] * (u[0] * v[1] - u[1] * v[0]);
            let corners = if volume > 0.0 { [a, b, c] } else { [a, c, b] };
            self.made.facets.push(Facet { block, corners, beyond });
        }
    }
}

fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Triangles of a convex polygon, all from its first corner.
fn triangles(polygon: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    polygon.windows(2).skip(1).map(|pair| [polygon[0], pair[0], pair[1]])
}

/// The blocks ahead of the plate and the wedge behind it, of a plate of this half width, as the case says.
pub(super) fn polyhedra(
    case: &Case,
    half_width: f64,
    blocks: &[Block],
    wedge: Option<&Wedge>,
    facets: usize,
) -> Mechanism {
    let slope = case.surface_slope.radians();
    let plate = libm::sincos(case.tool_angle.radians() + slope);
    let at = |position: Position| match position {
        Position::Inside(at) => at,
        Position::Surface([x, y]) => [x, y, 0.0],
        Position::Plate([s, y]) => [s * plate.1, y, -s * plate.0],
    };
    let velocity = |speed: f64, heading: f64| {
        let (rise, ahead) = libm::sincos(heading - slope);
        [speed * ahead, 0.0, speed * rise]
    };
    let vertices = vec![Position::Plate([0.0, 0.0]), Position::Plate([0.0, half_width])];
    let made = Mechanism { vertices, velocities: Vec::new(), facets: Vec::new() };
    let mut builder = Builder { made, half_width };
    let mut rim = FIRST_FACE.to_vec();
    let mut face = builder.face(&rim, Position::Plate);
    let plate_face = face.clone();
    for (i, block) in blocks.iter().enumerate() {
        let is_last = i + 1 == blocks.len();
        let swept = Swept::new(&rim, block, &ends::edges(block.heading, case.friction.radians(), facets));
        rim = swept.face(block);
        let (dip_sin, dip_cos) = libm::sincos(block.rays[1] + slope);
        let next = builder.face(&rim, |[r, y]| {
            if is_last { Position::Surface([r, y]) } else { Position::Inside([r * dip_cos, y, -r * dip_sin]) }
        });
        let corner = |rim: Rim| match rim {
            Rim::Before(k) => face[k + 1],
            Rim::After(k) => next[k + 1],
        };
        let (Some(&[tip, lowest]), Some(&[next_tip, next_lowest])) = (face.last_chunk(), next.last_chunk())
        else {
            break;
        };
        let mut all: Vec<([usize; 3], BeyondFacet)> =
            swept.facets().into_iter().map(|f| (f.map(corner), BeyondFacet::Rest)).collect();
        all.push(([lowest, tip, next_tip], BeyondFacet::Rest));
        all.push(([lowest, next_tip, next_lowest], BeyondFacet::Rest));
        all.push(([TOP[0], lowest, next_lowest], BeyondFacet::Symmetry));
        if i == 0 {
            all.extend(triangles(&face).map(|t| (t, BeyondFacet::Plate)));
        }
        let beyond = if is_last { BeyondFacet::Surface } else { BeyondFacet::Block(i + 1) };
        all.extend(triangles(&next).map(|t| (t, beyond)));
        // The middle between points of the upper edge and of both lower ones.
        let points = [TOP[0], tip, next_tip, next_lowest].map(|k| at(builder.made.vertices[k]));
        let inside = std::array::from_fn(|k| points.iter().map(|p| 0.25 * p[k]).sum());
        builder.made.velocities.push(velocity(block.speed, block.heading));
        builder.facets(i, inside, all, at);
        face = next;
    }
    if let Some(wedge) = wedge {
        behind(&mut builder, wedge, &plate_face, at);
        builder.made.velocities.push(velocity(wedge.speed, -wedge.sinking));
    }
    builder.made
}

/// The wedge behind: the plate, the surface, the slip plane, an end that narrows it, and the plane of symmetry.
fn behind(builder: &mut Builder, wedge: &Wedge, plate: &[usize], at: impl Fn(Position) -> [f64; 3]) {
    let block = builder.made.velocities.len();
    let &[top, top_end, tip_end, tip] = plate else { return };
    let part = wedge.end / wedge.height;
    let half_width = builder.half_width;
    let far = [-wedge.surface * part, 0.0];
    let from = at(builder.made.vertices[tip]);
    let mut all =
        vec![([top, top_end, tip_end], BeyondFacet::Plate), ([top, tip_end, tip], BeyondFacet::Plate)];
    if part < 1.0 {
        // The ends meet before the slip plane comes to the surface.
        let reach = builder.vertex(Position::Surface(far));
        let low = builder.vertex(Position::Inside([
            from[0] + (-wedge.surface - from[0]) * part,
            0.0,
            from[2] * (1.0 - part),
        ]));
        all.extend([
            ([top, top_end, reach], BeyondFacet::Surface),
            ([tip, tip_end, low], BeyondFacet::Rest),
            ([top_end, tip_end, low], BeyondFacet::Rest),
            ([top_end, low, reach], BeyondFacet::Rest),
            ([top, tip, low], BeyondFacet::Symmetry),
            ([top, low, reach], BeyondFacet::Symmetry),
        ]);
    } else {
        let reach = builder.vertex(Position::Surface(far));
        let reach_end =
            builder.vertex(Position::Surface([far[0], half_width * (1.0 - wedge.narrowing * wedge.end)]));
        all.extend([
            ([top, top_end, reach_end], BeyondFacet::Surface),
            ([top, reach_end, reach], BeyondFacet::Surface),
            ([tip, tip_end, reach_end], BeyondFacet::Rest),
            ([tip, reach_end, reach], BeyondFacet::Rest),
            ([top_end, tip_end, reach_end], BeyondFacet::Rest),
            ([top, tip, reach], BeyondFacet::Symmetry),
        ]);
    }
    let points = [top, top_end, tip, builder.made.vertices.len() - 1].map(|k| at(builder.made.vertices[k]));
    let inside = std::array::from_fn(|k| points.iter().map(|p| 0.25 * p[k]).sum());
    builder.facets(block, inside, all, at);
}
