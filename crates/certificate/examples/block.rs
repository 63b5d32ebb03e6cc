//! A block of soil on a smooth base, pushed to the right: the force that proves to be enough, and a flow that is refused.
//!
//! `cargo run -p soilctl-certificate --example block`

use soilctl_certificate::{
    Boundary, Condition, Flow, Line, LineUse, Linear, Material, Mesh, Objective, Place, Region, Statement,
    Triangle, UpperField, Velocity, Vertex, prove_upper,
};

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), soilctl_certificate::CertificateError> {
    let points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let around: Vec<LineUse> = (0..4).map(|line| LineUse { line, forward: true }).collect();
    let wall = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    let conditions = [Condition::Smooth, Condition::Free, Condition::Free, wall];
    let statement = Statement {
        points: points.clone(),
        lines: (0..4).map(|i| Line { from: i, to: (i + 1) % 4 }).collect(),
        regions: vec![Region {
            loops: vec![around],
            material: Material {
                phi_deg: 30.0,
                cohesion: Linear::default(),
                unit_weight: 1.0,
                pore_pressure: Linear::default(),
                tension: None,
                envelope: None,
                anisotropy: None,
            },
        }],
        gravity: [0.0, -1.0],
        datum: 1.0,
        // On the top and on the right.
        surcharge: 2.0,
        objective: Objective::Structure { velocity: [1.0, 0.0] },
        width: None,
        members: Vec::new(),
        boundaries: (0..4).map(|i| Boundary { line: i, forward: true, condition: conditions[i] }).collect(),
    };
    let vertex = |point: usize| Vertex { position: points[point], place: Place::Corner { point } };
    let triangle = |corners| Triangle { corners, region: 0 };
    // The whole block moves with the wall: all control points are one.
    let mut flow = UpperField {
        mesh: Mesh {
            vertices: (0..4).map(vertex).collect(),
            triangles: vec![triangle([0, 1, 2]), triangle([0, 2, 3])],
        },
        flows: vec![Flow::Quadratic([0; 6]); 2],
        velocities: vec![Velocity::Free { x: 1.0, y: 0.0 }],
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    };
    println!("the force is at most {}", prove_upper(&statement, &flow)?);
    flow.velocities[0] = Velocity::Free { x: 1.0, y: -0.1 };
    if let Err(reason) = prove_upper(&statement, &flow) {
        println!("into the base it cannot flow: {reason}");
    }
    Ok(())
}
