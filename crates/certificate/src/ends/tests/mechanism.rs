//! One block whose force is known by hand, and whatever is changed in it.

use proptest::prelude::*;

use crate::examples::Plate;
use crate::tests::altered::{alter, changes};
use crate::{BeyondFacet, CertificateError, Facet, Mechanism, Position, Statement, prove_mechanism};

const PHI: f64 = 35.0;
const DELTA: f64 = 20.0;

/// An upright plate, two deep.
fn statement(width: f64, cohesion: f64, surcharge: f64) -> Statement {
    let plate = Plate { lean: 0.0, delta_deg: DELTA, surcharge, gravity: [0.0, -1.0] };
    let mut statement = plate.statement().with_width(width);
    statement.regions[0].material.cohesion.at_origin = cohesion;
    statement
}

/// A block that slides up a plane which rises at `rise` from the plate's lower edge. Its ends open just as much as the
/// friction demands. With angles a little too large it does so provably. And what the block holds per width: work of
/// the weight and of the surcharge, and `c cot(phi)` times the volume by which the ends and the plane open.
fn block(statement: &Statement, rise: f64, more_deg: f64) -> (Mechanism, f64) {
    let half = 0.5 * statement.width.unwrap();
    let [phi, delta] = [PHI, DELTA].map(|angle| (angle + more_deg).to_radians());
    let heading = rise + phi;
    let speed = delta.cos() / (heading + delta).cos();
    let velocity = [speed * heading.cos(), 0.0, speed * heading.sin()];
    let (depth, reach) = (2.0, 2.0 / rise.tan());
    let sine = phi.sin() / heading.cos();
    let spread = sine / (1.0 - sine * sine).sqrt();
    let vertices = vec![
        Position::Plate([0.0, 0.0]),
        Position::Plate([0.0, half]),
        Position::Plate([1.0, half]),
        Position::Plate([1.0, 0.0]),
        Position::Surface([reach, 0.0]),
        Position::Surface([reach, half + spread * reach]),
    ];
    let facet = |corners, beyond| Facet { block: 0, corners, beyond };
    let facets = vec![
        facet([0, 1, 2], BeyondFacet::Plate),
        facet([0, 2, 3], BeyondFacet::Plate),
        facet([0, 4, 5], BeyondFacet::Surface),
        facet([0, 5, 1], BeyondFacet::Surface),
        facet([3, 2, 5], BeyondFacet::Rest),
        facet([3, 5, 4], BeyondFacet::Rest),
        facet([1, 5, 2], BeyondFacet::Rest),
        facet([0, 3, 4], BeyondFacet::Symmetry),
    ];
    let volume = half * reach * depth / 2.0 + spread * reach * reach * depth / 6.0;
    let surface = half * reach + spread * reach * reach / 2.0;
    let opened = velocity[2] * surface - velocity[0] * half * depth;
    let cohesion = statement.regions[0].material.cohesion.at_origin;
    let power = velocity[2] * (volume + statement.surcharge * surface) + cohesion / phi.tan() * opened;
    (Mechanism { vertices, velocities: vec![velocity], facets }, power / half)
}

#[test]
fn one_block_by_hand() {
    for (width, rise, cohesion, surcharge) in
        [(10.0, 0.32, 0.0, 0.0), (2.0, 0.3, 0.0, 0.7), (0.5, 0.3, 0.2, 0.0), (4.0, 0.25, 0.3, 1.0)]
    {
        let statement = statement(width, cohesion, surcharge);
        let (mechanism, expected) = block(&statement, rise, 1e-9);
        let proven = prove_mechanism(&statement, &mechanism).unwrap();
        assert!(
            proven >= expected * (1.0 - 1e-9) && proven <= expected * (1.0 + 1e-7),
            "{proven} {expected}"
        );
        let (mechanism, _) = block(&statement, rise, -1e-9);
        let refused = prove_mechanism(&statement, &mechanism).unwrap_err();
        assert!(matches!(refused, CertificateError::NotProven { .. }), "{refused}");
    }
}

/// What stands still behind the plate adds nothing; a block that slides down after it takes its own weight's power.
#[test]
fn a_block_behind_helps() {
    let statement = statement(4.0, 0.0, 0.0);
    let (mut mechanism, ahead) = block(&statement, 0.3, 1e-9);
    let (phi, delta) = ((PHI + 1e-9).to_radians(), (DELTA + 1e-9).to_radians());
    // A plane at 60 degrees; the plate moves away at 1, the soil down along it.
    let (rise, half, depth) = (60.0_f64.to_radians(), 2.0, 2.0);
    let sinking = rise - phi;
    // Seen from the plate, the soil slides down: the opening is `1 - V cos`, the slip `V sin`.
    let speed = delta.cos() / (delta - sinking).cos();
    let velocity = [speed * sinking.cos(), 0.0, -speed * sinking.sin()];
    let reach = depth / rise.tan();
    let sine = phi.sin() / sinking.cos();
    let narrows = sine / (1.0 - sine * sine).sqrt();
    let first = mechanism.vertices.len();
    mechanism
        .vertices
        .extend([Position::Surface([-reach, 0.0]), Position::Surface([-reach, half - narrows * reach])]);
    mechanism.velocities.push(velocity);
    let (s, n) = (first, first + 1);
    mechanism.facets.extend(
        [
            ([0, 2, 1], BeyondFacet::Plate),
            ([0, 3, 2], BeyondFacet::Plate),
            ([0, n, s], BeyondFacet::Surface),
            ([0, 1, n], BeyondFacet::Surface),
            ([3, n, 2], BeyondFacet::Rest),
            ([3, s, n], BeyondFacet::Rest),
            ([1, 2, n], BeyondFacet::Rest),
            ([0, s, 3], BeyondFacet::Symmetry),
        ]
        .map(|(corners, beyond)| Facet { block: 1, corners, beyond }),
    );
    let volume = half * reach * depth / 2.0 - narrows * reach * reach * depth / 6.0;
    let expected = ahead - speed * sinking.sin() * volume / half;
    let proven = prove_mechanism(&statement, &mechanism).unwrap();
    assert!((proven / expected - 1.0).abs() < 1e-7, "{proven} {expected}");
}

#[test]
fn what_is_no_mechanism_is_refused() {
    let statement = statement(4.0, 0.0, 0.0);
    let (good, _) = block(&statement, 0.3, 1e-9);
    let refused = |change: &dyn Fn(&mut Mechanism)| {
        let mut bad = good.clone();
        change(&mut bad);
        let error = prove_mechanism(&statement, &bad).unwrap_err();
        assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
        error.to_string()
    };
    assert!(refused(&|m| m.facets.truncate(7)).contains("close up"));
    assert!(refused(&|m| m.vertices[5] = Position::Surface([-1.0, 3.0])).contains("both sides"));
    assert!(refused(&|m| m.vertices[5] = Position::Inside([5.0, 3.0, 0.1])).contains("must be in the soil"));
    assert!(refused(&|m| m.vertices[5] = Position::Surface([5.0, -3.0])).contains("must be in the soil"));
    assert!(refused(&|m| m.facets[2].beyond = BeyondFacet::Rest).contains("named so"));
    assert!(refused(&|m| m.facets[0].beyond = BeyondFacet::Rest).contains("named so"));
    // Narrower than the plate.
    assert!(refused(&|m| m.vertices[2] = Position::Plate([1.0, 1.9])).contains("cover it once"));
    // The same block twice, half as fast: it would cover the plate twice.
    assert!(
        refused(&|m| {
            let mut twice: Vec<Facet> = m.facets.iter().map(|f| Facet { block: 1, ..*f }).collect();
            m.facets.append(&mut twice);
            m.velocities = vec![m.velocities[0].map(|v| 0.5 * v); 2];
        })
        .contains("cover it once")
    );
    // Twice, and once inside out: in sum it covers the plate once.
    assert!(
        refused(&|m| {
            let own = m.facets.clone();
            m.facets.extend(own.iter().map(|f| Facet { block: 1, ..*f }));
            let inside_out =
                |f: &Facet| Facet { block: 2, corners: [f.corners[0], f.corners[2], f.corners[1]], ..*f };
            m.facets.extend(own.iter().map(inside_out));
            m.velocities = vec![m.velocities[0]; 3];
        })
        .contains("turn its back")
    );
    let plane = Statement { width: None, ..statement.clone() };
    let error = prove_mechanism(&plane, &good).unwrap_err();
    assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(4000), ..ProptestConfig::default() })]

    /// A smooth plate of any width would hold more than nine tenths of Rankine's pressures ahead of it and behind it; the
    /// true force with a rough face is about half as much again.
    #[test]
    fn an_altered_mechanism_proves_nothing_false(changes in changes(), width in 0.5..20.0_f64) {
        let statement = statement(width, 0.0, 0.0);
        let (mechanism, _) = block(&statement, 0.3, 1e-9);
        let kp = (45.0 + 0.5 * PHI).to_radians().tan().powi(2);
        let held = 0.9 * (kp - 1.0 / kp) * 2.0;
        let altered: Option<Mechanism> = alter(&mechanism, &changes);
        if let Some(bound) = altered.and_then(|m| prove_mechanism(&statement, &m).ok()) {
            prop_assert!(bound >= held, "{bound} {held}");
        }
    }
}
