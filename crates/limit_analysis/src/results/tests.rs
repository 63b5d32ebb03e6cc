use soilctl_certificate::{
    Boundary, Condition, Flow, Line, LineUse, Linear, LowerField, Material, Mesh, Objective, Place, Region,
    Statement, Triangle, UpperField, Velocity, Vertex, prove_lower, prove_upper,
};

use super::*;
use crate::describe::Description;
use crate::lower::Lower;
use crate::mesh::{Request, generate};
use crate::topology::Topology;
use crate::{Bounds, EmbeddedPlate, Options, Problem, bound};

const SOIL: Material = Material {
    phi_deg: 30.0,
    cohesion: Linear::uniform(0.0),
    unit_weight: 1.0,
    pore_pressure: Linear::uniform(0.0),
    tension: None,
    envelope: None,
    anisotropy: None,
};

/// A smooth wall, two high, pushed against level sand of 30 degrees: Rankine's force is `Kp h^2/2` = 6.
fn wall(objective: Objective) -> Statement {
    let face = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    let conditions = [face, Condition::Fixed, Condition::Fixed, Condition::Free];
    let forward = |line| LineUse { line, forward: true };
    Statement {
        points: vec![[0.0, 0.0], [0.0, -2.0], [4.0, -2.0], [4.0, 0.0]],
        lines: [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(from, to)| Line { from, to }).to_vec(),
        regions: vec![Region { loops: vec![(0..4).map(forward).collect()], material: SOIL }],
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective,
        width: None,
        members: Vec::new(),
        boundaries: (0..4)
            .map(|line| Boundary { line, forward: true, condition: conditions[line] })
            .collect(),
    }
}

const PUSHED: Objective = Objective::Structure { velocity: [1.0, 0.0] };

/// Coulomb's wedge for the wall, which moves at `sqrt(3)` upwards.
fn wedge() -> UpperField {
    let corner = |point| Place::Corner { point };
    let top = 12.0_f64.sqrt();
    let vertices = [
        ([0.0, 0.0], corner(0)),
        ([0.0, -2.0], corner(1)),
        ([4.0, -2.0], corner(2)),
        ([4.0, 0.0], corner(3)),
        ([top, 0.0], Place::OnLine { line: 3, s: 1.0 - top / 4.0 }),
    ];
    let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4]].map(|corners| Triangle { corners, region: 0 });
    UpperField {
        mesh: Mesh {
            vertices: vertices.map(|(position, place)| Vertex { position, place }).to_vec(),
            triangles: triangles.to_vec(),
        },
        flows: [[0, 1, 2, 3, 4, 5], [6; 6], [6; 6]].map(Flow::Quadratic).to_vec(),
        velocities: [vec![Velocity::Free { x: 1.0, y: 3.0_f64.sqrt() }; 6], vec![Velocity::Zero]].concat(),
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    }
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b} within {tolerance}");
}

#[test]
fn a_wedge_moves_as_a_block_and_its_weight_is_the_force() {
    let flow = FlowResults::new(&wall(PUSHED), &wedge()).unwrap();
    let root = 3.0_f64.sqrt();
    for (p, [x, y]) in [([0.5, -0.5], [1.0, root]), ([1.0, -1.3], [1.0, root]), ([3.0, -1.5], [0.0; 2])] {
        let v = flow.velocity(p).unwrap();
        close(v[0], x, 1e-12);
        close(v[1], y, 1e-12);
    }
    assert_eq!(flow.velocity([-0.1, -1.0]), None);
    let power = flow.power();
    // Sand without cohesion dissipates nothing; the wedge of area 2 sqrt(3) rises at sqrt(3).
    assert_eq!((power.in_soil, power.along_jumps, power.by_loads, power.live), (0.0, 0.0, 0.0, 0.0));
    close(power.by_weight, -6.0, 1e-12);
    close(power.bound(&PUSHED).unwrap(), 6.0, 1e-12);
    let jumps = flow.jumps();
    let [line] = jumps.iter().filter(|j| !j.at_structure).collect::<Vec<_>>()[..] else {
        panic!("{jumps:?}")
    };
    close(line.length(), 4.0, 1e-12);
    // A slip of two against the slope of the line, at the friction angle to it.
    close(line.speed(), 2.0, 1e-12);
    close(line.opening[1], 1.0, 1e-12);
    assert!(
        flow.dissipation()
            .iter()
            .flatten()
            .chain(flow.shear_rate().iter().flatten())
            .all(|x| x.abs() < 1e-12)
    );
}

#[test]
fn the_failure_surface_of_a_wedge_is_its_slip_line_and_it_reaches_as_far_as_rankine_says() {
    let flow = FlowResults::new(&wall(PUSHED), &wedge()).unwrap();
    let [line] = &flow.failure_surface(MOVING)[..] else { panic!("more than one line") };
    let mut ends = [line[0], line[line.len() - 1]];
    ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let reach = 2.0 * (60.0_f64.to_radians()).tan();
    for (end, exact) in ends.iter().zip([[0.0, -2.0], [reach, 0.0]]) {
        close(end[0], exact[0], 1e-12);
        close(end[1], exact[1], 1e-12);
    }
    let [ground] = flow.moving_ground(MOVING)[..] else { panic!("more than one stretch") };
    close(ground.from[0], 0.0, 1e-12);
    close(ground.to[0], reach, 1e-12);
}

/// The stress field of unknowns that are all zero: ground at rest, `xx = yy = -depth`.
fn at_rest(statement: &Statement) -> LowerField {
    let problem = Problem::new(statement.clone()).unwrap();
    let size = |_: [f64; 2]| 0.4;
    let request = Request {
        statement: problem.statement(),
        guides: &[],
        fans: &[],
        size: &size,
        max_triangles: 10_000,
    };
    let mesh = generate(&request).unwrap();
    let topology = Topology::new(&mesh);
    let lower = Lower::new(&problem, &mesh, &topology, 0.0);
    lower.function.saved(&mesh, &topology, &problem, &vec![0.0; lower.program.unknowns])
}

#[test]
fn ground_at_rest_presses_like_a_fluid() {
    let statement = wall(PUSHED);
    let field = at_rest(&statement);
    let stress = StressResults::new(&statement, &field).unwrap();
    for p in [[0.3, -0.2], [2.0, -1.9], [3.9, -1.0], [0.01, -1.99]] {
        let s = stress.stress(p).unwrap();
        for (found, exact) in s.into_iter().zip([p[1], p[1], 0.0]) {
            close(found, exact, 1e-12);
        }
        close(Principal::of(s).major, -p[1], 1e-12);
    }
    assert_eq!(stress.stress([2.0, 0.1]), None);
    let contacts = stress.contacts();
    let [contact] = &contacts[..] else { panic!("one face") };
    for point in &contact.points {
        close(point.arc, -point.at[1], 1e-12);
        close(point.pressure, point.arc, 1e-12);
        close(point.shear, 0.0, 1e-12);
        assert_eq!(point.inward, [1.0, 0.0]);
    }
    close(contact.length(), 2.0, 1e-12);
    close(contact.normal_force(), 2.0, 1e-12);
    close(contact.centre().unwrap(), 4.0 / 3.0, 1e-12);
    close(contact.force()[0], prove_lower(&statement, &field).unwrap(), 1e-9);
}

#[test]
fn principal_stresses_turn_with_the_stress() {
    for degrees in [0.0, 20.0, 45.0, 90.0, 110.0, 179.0_f64] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        // A compression of 3 along the angle and one of 1 across it.
        let p = Principal::of([-3.0 * cos * cos - sin * sin, -3.0 * sin * sin - cos * cos, -2.0 * sin * cos]);
        close(p.major, 3.0, 1e-12);
        close(p.minor, 1.0, 1e-12);
        close((p.direction[0] * cos + p.direction[1] * sin).abs(), 1.0, 1e-12);
        assert!(p.direction[0] >= -1e-12, "{:?}", p.direction);
    }
}

/// A few levels, however slow the machine.
fn solve(problem: &Problem, max_elements: usize) -> (Bounds, FlowResults, StressResults) {
    let options = Options { max_gap: 1e-6, max_work: u64::MAX, max_elements, ..Options::default() };
    let bounds = bound(problem, &options, &mut |_, _| {}).unwrap();
    let flow = FlowResults::new(problem.statement(), &bounds.upper.field).unwrap();
    let stress = StressResults::new(problem.statement(), &bounds.lower.field).unwrap();
    (bounds, flow, stress)
}

/// Contact stresses add up to the lower bound, powers to the upper one.
fn add_up(problem: &Problem, bounds: &Bounds, flow: &FlowResults, stress: &StressResults) {
    let statement = problem.statement();
    let upper = flow.power().bound(&statement.objective).unwrap();
    close(upper, prove_upper(statement, &bounds.upper.field).unwrap(), 1e-7 * upper.abs());
    if let Objective::Structure { velocity: [x, y] } = statement.objective {
        let force = stress.contacts().iter().fold([0.0; 2], |sum, c| [0, 1].map(|i| sum[i] + c.force()[i]));
        close(force[0] * x + force[1] * y, bounds.lower.value, 1e-7 * bounds.lower.value.abs());
    }
}

#[test]
fn a_smooth_plate_bears_rankines_stresses_and_moves_rankines_wedges() {
    let problem = EmbeddedPlate::default().problem().unwrap();
    let (bounds, flow, stress) = solve(&problem, 2500);
    add_up(&problem, &bounds, &flow, &stress);
    let contacts = stress.contacts();
    assert_eq!(contacts.len(), 2);
    for contact in &contacts {
        let k = if contact.turned_towards([1.0, 0.0]) > 0.0 { 3.0 } else { 1.0 / 3.0 };
        close(contact.length(), 1.0, 1e-12);
        // The bounds are within half a per cent of each other; a local value may be off by more.
        close(contact.normal_force(), 0.5 * k, 0.01 * k);
        close(contact.centre().unwrap(), 2.0 / 3.0, 0.01);
        close(contact.shear_force(), 0.0, 1e-9);
        let squares = contact.points.iter().map(|p| (p.pressure - k * p.arc).powi(2));
        let rms = (squares.sum::<f64>() / contact.points.len() as f64).sqrt();
        assert!(rms < 0.05 * k, "{rms}");
    }
    let root = 3.0_f64.sqrt();
    let [behind, ahead] = flow.moving_ground(MOVING)[..] else { panic!("two stretches") };
    assert_eq!((behind.to, ahead.from), ([0.0; 2], [0.0; 2]));
    close(ahead.to[0], root, 0.05 * root);
    close(-behind.from[0], 1.0 / root, 0.05);
    let work = shear_work(&flow, &stress);
    assert!(work.iter().flatten().all(|w| *w >= 0.0));
}

fn example(name: &str) -> Problem {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/problems").join(name);
    Description::read(&path).unwrap().described().unwrap().problem().unwrap()
}

#[test]
fn powers_and_contact_stresses_of_described_problems_add_up() {
    // Clay around an anchor, layers and water around a plate, clay under a footing.
    for name in ["anchor.toml", "plate_layers.toml", "footing_clay.toml"] {
        let problem = example(name);
        let (bounds, flow, stress) = solve(&problem, 700);
        add_up(&problem, &bounds, &flow, &stress);
        if name == "anchor.toml" {
            // A buried block has one face, all around.
            let contacts = stress.contacts();
            assert!(contacts.len() == 1 && contacts[0].closed && contacts[0].points[0].arc == 0.0);
            assert!(flow.power().in_soil > 0.0);
        }
    }
}

fn units() -> Units {
    Units { origin: [0.0; 2], length: 0.1, length_name: "m".into(), stress: 2.0, stress_name: "kPa".into() }
}

#[test]
fn files_hold_each_triangle_once_and_are_the_same_each_time() {
    let statement = wall(PUSHED);
    let flow = FlowResults::new(&statement, &wedge()).unwrap();
    let stress = StressResults::new(&statement, &at_rest(&statement)).unwrap();
    let both = write_vtu(Some(&flow), Some(&stress), &units()).unwrap();
    assert!(both.contains("NumberOfPoints=\"18\" NumberOfCells=\"3\""));
    for name in ["velocity", "stress", "principal_major", "dissipation", "shear_work", "phi_deg", "region"] {
        assert!(both.contains(&format!("Name=\"{name}\"")), "{name}");
    }
    assert_eq!(both, write_vtu(Some(&flow), Some(&stress), &units()).unwrap());
    let cells = 3 * stress.triangles().len();
    let alone = write_vtu(None, Some(&stress), &units()).unwrap();
    assert!(alone.contains(&format!("NumberOfCells=\"{cells}\"")) && !alone.contains("velocity"));
    assert!(write_vtu(None, None, &units()).is_err());
    // Four lines and the guide; a region; three triangles.
    let msh = flow.msh();
    assert!(msh.contains("\n1 5 \"guides\"\n2 1 \"region 0\"\n$EndPhysicalNames"), "{msh}");
    assert!(msh.contains("\n2 1 2 3\n") && msh.ends_with("$EndElements\n"), "{msh}");
}
