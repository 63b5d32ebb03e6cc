use soilctl_certificate::{
    CertificateError, Condition, LowerField, Mesh, Objective, Statement, UpperField, prove_lower, prove_upper,
};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Described, RegionEntry, SoilEntry};

pub(crate) fn soil(name: &str, phi_deg: f64, cohesion_kpa: f64) -> SoilEntry {
    SoilEntry {
        name: name.into(),
        phi_deg: Some(phi_deg),
        cohesion_kpa,
        unit_weight_kn_m3: 18.0,
        ..SoilEntry::default()
    }
}

pub(crate) fn region(soil: &str, polygon: &[[f64; 2]]) -> RegionEntry {
    RegionEntry { name: None, soil: soil.into(), polygon: polygon.to_vec() }
}

/// What the checker says about a statement before it looks at a mesh: nothing, if it is sound and covered.
pub(crate) fn refusals(statement: &Statement) -> Vec<CertificateError> {
    let mesh = Mesh { vertices: Vec::new(), triangles: Vec::new() };
    let upper = UpperField {
        mesh: mesh.clone(),
        flows: Vec::new(),
        velocities: Vec::new(),
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    };
    let lower = LowerField {
        mesh,
        corners: Vec::new(),
        copies: Vec::new(),
        gauges: Vec::new(),
        lines: Vec::new(),
        slopes: Vec::new(),
        far_stress: 0.0,
        multiplier: 1.0,
    };
    let found = [prove_upper(statement, &upper).unwrap_err(), prove_lower(statement, &lower).unwrap_err()];
    let sound = |e: &CertificateError| {
        matches!(e, CertificateError::BadMesh { .. } | CertificateError::BadField { .. })
    };
    found.into_iter().filter(|e| !sound(e)).collect()
}

/// The statement of a description, which the checker takes for both bounds.
pub(crate) fn described(description: &Description) -> Described {
    let described = description.described().unwrap();
    let refusals = refusals(&described.statement);
    assert!(refusals.is_empty(), "{refusals:?}");
    // The mesh generator has its own rules; gravity of zero is for later.
    let mut meshed = described.clone();
    if meshed.statement.gravity == [0.0; 2] {
        meshed.statement.gravity = [0.0, -1.0];
        meshed.statement.objective = Objective::Loads;
    }
    meshed.problem().unwrap();
    described
}

/// Total length of the sides with a condition, in the units of the statement.
pub(crate) fn length(statement: &Statement, wanted: impl Fn(&Condition) -> bool) -> f64 {
    let sides = statement.boundaries.iter().filter(|b| wanted(&b.condition));
    let long = |line: usize| {
        let [a, b] = [statement.lines[line].from, statement.lines[line].to].map(|p| statement.points[p]);
        (b[0] - a[0]).hypot(b[1] - a[1])
    };
    sides.map(|b| long(b.line)).sum()
}

/// Corners of the first loop of a region.
pub(crate) fn corners(statement: &Statement, region: usize) -> Vec<[f64; 2]> {
    let start = |u: &soilctl_certificate::LineUse| {
        let line = statement.lines[u.line];
        statement.points[if u.forward { line.from } else { line.to }]
    };
    statement.regions[region].loops[0].iter().map(start).collect()
}

/// Area of all loops of a region.
pub(crate) fn area(statement: &Statement, region: usize) -> f64 {
    let ring = |uses: &Vec<soilctl_certificate::LineUse>| -> f64 {
        let double = uses.iter().map(|u| {
            let line = statement.lines[u.line];
            let [a, b] = [line.from, line.to].map(|p| statement.points[p]);
            let cross = a[0] * b[1] - a[1] * b[0];
            if u.forward { cross } else { -cross }
        });
        0.5 * double.sum::<f64>()
    };
    statement.regions[region].loops.iter().map(ring).sum()
}
