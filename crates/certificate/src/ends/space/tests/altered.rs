//! Fields that are altered are refused, each for its own reason; whatever the numbers are, nothing panics.

use proptest::prelude::*;

use super::Small;
use super::small::ground;
use crate::{CertificateError, SpaceStress, prove_end};

fn good() -> SpaceStress {
    Small::new(true).field(&ground(1.5, 1.0), &ground(1.5, 1.0))
}

fn refused(alter: impl Fn(&mut SpaceStress)) -> String {
    let mut field = good();
    alter(&mut field);
    prove_end(30.0, 15.0, &field).unwrap_err().to_string()
}

#[track_caller]
fn says(found: &str, part: &str) {
    assert!(found.contains(part), "{found}");
}

#[test]
fn meshes_that_do_not_fit_are_refused() {
    says(&refused(|f| _ = f.tetrahedra.pop()), "belongs to one simplex only");
    says(&refused(|f| f.tetrahedra.push(f.tetrahedra[0])), "lies on the same side of a face");
    says(&refused(|f| f.tetrahedra[3][1] = f.tetrahedra[3][2]), "names a vertex twice");
    says(&refused(|f| f.tetrahedra[3][1] = 4000), "names vertex 4000");
    says(&refused(|f| f.vertices[27] = [1.7, 0.9, -1.9]), "lies on the same side of a face");
    // Vertex 13 is that where the plate's lower edge ends.
    says(&refused(|f| f.vertices[13][2] = -1.01), "the plate: must be covered once");
    says(&refused(|f| f.vertices[13][0] = 0.01), "the plate: must be covered once");
    // A vertex of the plane ahead.
    says(&refused(|f| f.vertices[22][0] = 1.9), "is not in a plane of the box");
    says(&refused(|f| f.vertices[22][0] = 2.1), "is not in a plane of the box");
    says(&refused(|f| f.vertices[0] = [f64::NAN; 3]), "coordinate of vertex 0");
    says(
        &refused(|f| f.vertices.iter_mut().for_each(|v| v[2] -= 0.5)),
        "the box: must have the surface on top",
    );
    says(&refused(|f| f.tetrahedra.clear()), "must cover the box once");
    says(&refused(|f| f.vertices.clear()), "the box");
    // Twice the box, one beside the other in the list.
    says(
        &refused(|f| {
            let count = f.vertices.len();
            f.vertices.extend(f.vertices.clone());
            f.tetrahedra.extend(f.tetrahedra.clone().iter().map(|t| t.map(|v| v + count)));
        }),
        "must cover the box once",
    );
}

#[test]
fn sections_that_do_not_fit_are_refused() {
    says(&refused(|f| _ = f.section.triangles.pop()), "edge of the section");
    says(&refused(|f| _ = f.section.parents.pop()), "parents has");
    says(&refused(|f| f.section.parents[0] = 0), "its parent must be on the side of the box");
    says(&refused(|f| f.section.parents[0] = 100_000), "names face 100000");
    says(&refused(|f| f.section.parents.swap(0, 4)), "is not proven to lie in its parent");
    says(
        &refused(|f| f.section.vertices.iter_mut().for_each(|v| v[0] *= 2.0)),
        "the section: must fill the side of the box",
    );
}

#[test]
fn tractions_that_are_not_borne_are_refused() {
    says(&refused(|f| _ = f.tractions.pop()), "tractions has");
    says(&refused(|f| _ = f.behind.pop()), "behind has");
    says(&refused(|f| f.tractions[7][1][2] = f64::INFINITY), "traction of face 7");
    says(&refused(|f| f.section.tractions[3][1][0] = f64::NAN), "traction of edge of the section 3");
    // Too much shear on the plate, behind.
    says(
        &refused(|f| f.behind.iter_mut().for_each(|t| t.iter_mut().for_each(|t| t[1] = 1.5 * t[0]))),
        "strength to spare of the plate's face",
    );
    let too_much = |k: f64| {
        let field = Small::new(true).field(&ground(k, 1.0), &ground(k, 1.0));
        prove_end(30.0, 15.0, &field).unwrap_err().to_string()
    };
    says(&too_much(3.2), "strength to spare of the ground beyond the box");
    // Within the limits on all sides, but not in between.
    let small = Small::new(true);
    let field = small.field(&ground(2.0, 0.66), &ground(2.0, 0.66));
    says(&prove_end(30.0, 15.0, &field).unwrap_err().to_string(), "strength to spare of the soil at vertex");
    // In the section: what presses across is not enough there.
    let mut section = good();
    section.section = small.field(&ground(2.9, 1.0), &ground(2.9, 1.0)).section;
    let thin = Small::new(true).field(&ground(1.5, 0.6), &ground(1.5, 0.6));
    section.tractions = thin.tractions;
    section.behind = thin.behind;
    says(&prove_end(30.0, 15.0, &section).unwrap_err().to_string(), "of triangle of the section");
}

#[test]
fn balances_that_depend_on_each_other_are_refused() {
    let field = Small::new(false).field(&ground(1.5, 1.0), &ground(1.5, 1.0));
    says(&prove_end(30.0, 15.0, &field).unwrap_err().to_string(), "rank of the balances");
}

#[test]
fn angles_are_in_range() {
    for (phi, delta) in
        [(0.0, 0.0), (90.0, 15.0), (f64::NAN, 15.0), (30.0, 90.0), (30.0, -1.0), (30.0, f64::NAN)]
    {
        assert!(matches!(prove_end(phi, delta, &good()), Err(CertificateError::OutOfRange { .. })));
    }
}

#[test]
fn files_with_other_keys_are_refused() {
    let text = serde_json::to_string(&good()).unwrap();
    assert_eq!(serde_json::from_str::<SpaceStress>(&text).unwrap(), good());
    assert!(serde_json::from_str::<SpaceStress>(&text.replace("\"behind\"", "\"beyond\"")).is_err());
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -1e3..1e3_f64, Just(0.0), Just(-1.0), Just(f64::MAX), Just(5e-324)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn nothing_panics(
        numbers in prop::collection::vec((0..4_usize, any::<prop::sample::Index>(), 0..3_usize, any_number()), 1..4),
        index in any::<prop::sample::Index>(), to in prop_oneof![0..200_usize, Just(usize::MAX)], swap in any::<bool>(),
    ) {
        let mut field = good();
        for (list, at, axis, x) in numbers {
            match list {
                0 => at.get_mut(&mut field.vertices)[axis] = x,
                1 => at.get_mut(&mut field.tractions)[axis][axis] = x,
                2 => at.get_mut(&mut field.behind)[0][axis] = x,
                _ => at.get_mut(&mut field.section.vertices)[axis % 2] = x,
            }
        }
        if swap {
            index.get_mut(&mut field.tetrahedra)[0] = to;
            index.get_mut(&mut field.section.triangles)[0] = to;
        }
        if let Ok(force) = prove_end(30.0, 15.0, &field) {
            prop_assert!(force.end.is_finite() && force.between.is_finite());
        }
    }
}
