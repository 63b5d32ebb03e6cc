//! Laws of strength as lines.

use soilctl_certificate::{Envelope, Material, StrengthLine};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, SoilEntry, StrengthLaw};

use crate::common::refusals;

fn slope(soil: SoilEntry) -> Description {
    let mut it = Description::strip_load(soil, 2.0);
    it.objective = Aim::StrengthReduction {};
    it
}

fn of_law(strength: StrengthLaw) -> SoilEntry {
    SoilEntry {
        name: "fill".into(),
        strength: Some(strength),
        unit_weight_kn_m3: 19.0,
        ..SoilEntry::default()
    }
}

/// The material of the only region, with its unit of stress in kPa.
fn material(it: &Description) -> (Material, f64) {
    let described = it.described().unwrap();
    (described.statement.regions[0].material.clone(), described.stress_kpa)
}

/// Inner and outer lines, in kPa.
fn lines((material, unit): &(Material, f64)) -> [Vec<StrengthLine>; 2] {
    let Some(Envelope { inside, outside }) = &material.envelope else { panic!("it is curved") };
    let own = StrengthLine { phi_deg: material.phi_deg, cohesion: material.cohesion.at_origin };
    let in_kpa = |line: &StrengthLine| StrengthLine { cohesion: line.cohesion * unit, ..*line };
    [std::iter::once(&own).chain(inside).map(in_kpa).collect(), outside.iter().map(in_kpa).collect()]
}

/// The radius of the greatest circle of Mohr below lines.
fn radius(lines: &[StrengthLine], mean: f64) -> f64 {
    let of = |l: &StrengthLine| {
        let (sin, cos) = l.phi_deg.to_radians().sin_cos();
        l.cohesion * cos + mean * sin
    };
    lines.iter().map(of).fold(f64::INFINITY, f64::min)
}

fn shear(lines: &[StrengthLine], normal: f64) -> f64 {
    lines.iter().map(|l| l.cohesion + normal * l.phi_deg.to_radians().tan()).fold(f64::INFINITY, f64::min)
}

/// The greatest principal stress that lines bear beside a least one.
fn greatest(lines: &[StrengthLine], least: f64) -> f64 {
    let of = |l: &StrengthLine| {
        let n = (45.0 + 0.5 * l.phi_deg).to_radians().tan();
        least * n * n + 2.0 * l.cohesion * n
    };
    lines.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Friction that falls with stress is between its lines, whose slopes fall, from where it is greatest to where a third is left; and near to
/// both.
#[test]
fn friction_that_falls_with_stress_is_between_its_lines() {
    for (phi_deg, slope_deg_per_decade, reference_kpa, greatest_phi_deg) in [
        (38.0, 5.0, 10.0, 55.0),
        (42.0, 0.5, 1.0, 44.0),
        (30.0, 8.0, 100.0, 50.0),
        (15.0, 8.0, 0.1, 60.0),
        (40.0, 4.0, 1e4, 41.0),
    ] {
        let law = StrengthLaw::FrictionLaw {
            phi_deg,
            slope_deg_per_decade,
            reference_kpa,
            greatest_phi_deg,
            up_to_kpa: Some(500.0),
        };
        let it = material(&slope(of_law(law)));
        let [inside, outside] = lines(&it);
        for side in [&inside, &outside] {
            assert!(side.windows(2).all(|two| two[1].phi_deg < two[0].phi_deg), "{side:?}");
        }
        let mut between = 0.0;
        for i in 1..=300 {
            let sigma = 500.0 * (f64::from(i) / 300.0).powi(3);
            let fallen = phi_deg - slope_deg_per_decade * (sigma / reference_kpa).log10();
            if fallen < phi_deg / 3.0 {
                break;
            }
            let strength = sigma * fallen.min(greatest_phi_deg).to_radians().tan();
            let (less, more) = (shear(&inside, sigma), shear(&outside, sigma));
            assert!(
                less <= strength * (1.0 + 1e-9) && more >= strength * (1.0 - 1e-9),
                "{sigma}: {less} {strength} {more}"
            );
            if sigma > 2.0 {
                between = f64::max(between, (more - less) / strength);
            }
        }
        assert!(between < 0.03, "{phi_deg}: {between}");
    }
}

#[test]
fn a_power_is_between_its_chords_and_tangents() {
    for (factor, exponent, tension_kpa) in
        [(1.1, 0.86, 0.0), (2.0, 0.8, 5.0), (5.0, 0.5, 20.0), (0.6, 0.99, 1.0)]
    {
        let law = StrengthLaw::Power { factor, exponent, tension_kpa, up_to_kpa: Some(400.0) };
        let [inside, outside] = lines(&material(&slope(of_law(law))));
        for i in 1..100 {
            let mean = -tension_kpa + 300.0 * (0.01 * f64::from(i)).powi(3);
            // The greatest circle below the curve, by trying where it touches.
            let near = |k: i32| -tension_kpa + (mean + tension_kpa) * 1e-4 * f64::from(k);
            let to = |sigma: f64| (sigma - mean).hypot(factor * (sigma + tension_kpa).powf(exponent));
            let curve = (0..=10_000).map(|k| to(near(k))).fold(f64::INFINITY, f64::min);
            let [low, high] = [&inside, &outside].map(|lines| shear(lines, mean));
            let strength = factor * (mean + tension_kpa).powf(exponent);
            assert!(low <= strength && strength <= high, "{exponent} at {mean}: {low} {strength} {high}");
            let [low, high] = [&inside, &outside].map(|lines| radius(lines, mean));
            assert!(
                low <= curve && curve <= high * (1.0 + 1e-6),
                "{exponent} at {mean}: {low} {curve} {high}"
            );
            if mean > 60.0 {
                assert!(high - low < 0.02 * curve, "{exponent} at {mean}: {low} {curve} {high}");
            }
        }
    }
}

/// The criterion as its authors write it, with the principal stresses.
#[test]
fn hoek_and_brown_s_strength_is_between_its_lines() {
    for (ucs_mpa, gsi, mi, disturbance) in
        [(0.5, 30.0, 8.0, 0.7), (5.0, 50.0, 10.0, 0.0), (100.0, 80.0, 25.0, 1.0)]
    {
        let up_to_kpa = Some(1e3 * ucs_mpa);
        let law = StrengthLaw::HoekBrown { ucs_mpa, gsi, mi, disturbance, up_to_kpa };
        let [inside, outside] = lines(&material(&slope(of_law(law))));
        let mb = mi * f64::exp((gsi - 100.0) / (28.0 - 14.0 * disturbance));
        let s = f64::exp((gsi - 100.0) / (9.0 - 3.0 * disturbance));
        let a = 0.5 + (f64::exp(-gsi / 15.0) - f64::exp(-20.0 / 3.0)) / 6.0;
        let ucs = 1e3 * ucs_mpa;
        for i in 0..300 {
            let least = -s * ucs / mb + ucs * (0.01 * f64::from(i)).powi(3);
            let curve = least + ucs * (mb * least / ucs + s).max(0.0).powf(a);
            let [low, high] = [&inside, &outside].map(|lines| greatest(lines, least));
            assert!(
                low <= curve + 1e-9 * ucs && curve <= high + 1e-9 * ucs,
                "at {least}: {low} {curve} {high}"
            );
            if (0.005 * ucs..0.5 * ucs).contains(&least) {
                assert!(high - low < 0.02 * (curve - least), "at {least}: {low} {curve} {high}");
            }
        }
    }
}

/// The checker takes each law, however strength is divided: its lines stay in order, and the outer ones outside.
#[test]
fn divided_laws_are_laws() {
    let power =
        |factor, exponent, tension_kpa| StrengthLaw::Power { factor, exponent, tension_kpa, up_to_kpa: None };
    let rock = |ucs_mpa, gsi, mi, disturbance| StrengthLaw::HoekBrown {
        ucs_mpa,
        gsi,
        mi,
        disturbance,
        up_to_kpa: None,
    };
    let friction =
        |phi_deg, slope_deg_per_decade, reference_kpa, greatest_phi_deg| StrengthLaw::FrictionLaw {
            phi_deg,
            slope_deg_per_decade,
            reference_kpa,
            greatest_phi_deg,
            up_to_kpa: None,
        };
    let laws = [
        friction(38.0, 5.0, 10.0, 55.0),
        friction(15.0, 8.0, 1e-3, 15.0),
        friction(69.0, 0.1, 1e6, 69.9),
        power(1.1, 0.86, 0.0),
        power(3.0, 0.6, 5.0),
        power(5.0, 0.3, 40.0),
        power(0.6, 0.999, 1.0),
        rock(0.5, 30.0, 8.0, 0.7),
        rock(100.0, 100.0, 50.0, 0.0),
        rock(0.01, 5.0, 1.0, 1.0),
        StrengthLaw::Points { points_kpa: vec![[0.0, 20.0], [5.0, 40.0], [10.0, 45.0], [200.0, 50.0]] },
    ];
    for law in laws {
        for factor in [0.3, 1.0, 1.14, 4.0] {
            let found = slope(of_law(law.clone())).reduced(factor).described().unwrap();
            let refused = refusals(&found.statement);
            assert!(refused.is_empty(), "{law} over {factor}: {refused:?}");
        }
    }
}

#[test]
fn points_are_met_exactly() {
    let points = vec![[0.0, 6.0], [40.0, 33.0], [80.0, 60.0], [120.0, 75.0], [400.0, 165.0]];
    let found = material(&slope(of_law(StrengthLaw::Points { points_kpa: points.clone() })));
    let [inside, outside] = lines(&found);
    assert!(outside.is_empty());
    assert_eq!(inside.len(), 3, "the first three points are in one line: {inside:?}");
    for [normal, strength] in points {
        assert!((shear(&inside, normal) - strength).abs() < 1e-10, "{normal}");
    }
    let line = material(&slope(of_law(StrengthLaw::Points { points_kpa: vec![[0.0, 5.0], [100.0, 70.0]] })));
    assert_eq!(line.0.envelope, None);
    assert!((line.0.phi_deg.to_radians().tan() - 0.65).abs() < 1e-15);
    assert!((line.0.cohesion.at_origin * line.1 - 5.0).abs() < 1e-12);
}

#[test]
fn strength_is_divided() {
    let law = StrengthLaw::Power { factor: 1.4, exponent: 0.8, tension_kpa: 2.0, up_to_kpa: Some(300.0) };
    let whole = lines(&material(&slope(of_law(law.clone()))));
    let part = lines(&material(&slope(of_law(law)).reduced(1.25)));
    for (whole, part) in whole.iter().zip(&part) {
        for sigma in [-1.0, 0.0, 5.0, 80.0, 900.0] {
            assert!((shear(whole, sigma) / shear(part, sigma) - 1.25).abs() < 1e-12, "at {sigma}");
        }
    }
}

/// Davis (1968): `tan(phi*) = cos(psi) sin(phi)/(1 - sin(psi) sin(phi))`.
#[test]
fn soil_that_dilates_less_has_davis_s_strength() {
    let soil = |dilation_deg| SoilEntry {
        name: "sand".into(),
        phi_deg: Some(35.0),
        cohesion_kpa: 4.0,
        unit_weight_kn_m3: 18.0,
        dilation_deg,
        ..SoilEntry::default()
    };
    let of = |dilation_deg| {
        let (material, unit) = material(&slope(soil(dilation_deg)));
        (material.phi_deg.to_radians().tan(), material.cohesion.at_origin * unit)
    };
    let (sin, tan) = (35.0_f64.to_radians().sin(), 35.0_f64.to_radians().tan());
    assert!((of(Some(0.0)).0 - sin).abs() < 1e-14, "without dilation the tangent is the sine");
    assert!((of(Some(0.0)).1 - 4.0 * sin / tan).abs() < 1e-12);
    let whole = of(None);
    let with_all = of(Some(35.0));
    assert!((whole.0 - with_all.0).abs() < 1e-15 && (whole.1 - 4.0).abs() < 1e-12);
    // Weaker than the dilation angle says, soil dilates as much as the flow rule says.
    let weak = slope(soil(Some(20.0))).reduced(3.0);
    assert!((material(&weak).0.phi_deg.to_radians().tan() - tan / 3.0).abs() < 1e-14);
}

#[test]
fn laws_that_are_none_are_refused() {
    let refused = |words: &str, change: &dyn Fn(&mut SoilEntry)| {
        let mut soil =
            of_law(StrengthLaw::Power { factor: 1.0, exponent: 0.8, tension_kpa: 0.0, up_to_kpa: None });
        change(&mut soil);
        let error = slope(soil).described().unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    refused("leave out one of them", &|s| s.phi_deg = Some(30.0));
    refused("neither phi_deg", &|s| s.strength = None);
    refused("no cohesion_kpa", &|s| s.cohesion_kpa = 1.0);
    refused("no cohesion_kpa, cohesion_gradient_kpa_per_m or dilation_deg", &|s| s.dilation_deg = Some(1.0));
    refused("strength_factor is 0", &|s| s.strength_factor = Some(0.0));
    refused("strength_factor goes with strength", &|s| {
        (s.phi_deg, s.strength, s.strength_factor) = (Some(30.0), None, Some(2.0));
    });
    refused("dilation_deg is 31, allowed is 0 to phi_deg", &|s| {
        (s.phi_deg, s.strength, s.dilation_deg) = (Some(30.0), None, Some(31.0));
    });
    let power = |factor, exponent, tension_kpa| {
        Some(StrengthLaw::Power { factor, exponent, tension_kpa, up_to_kpa: None })
    };
    refused("a straight line has phi_deg", &|s| s.strength = power(1.0, 1.0, 0.0));
    refused("strength.factor is NaN", &|s| s.strength = power(f64::NAN, 0.8, 0.0));
    refused("strength.tension_kpa is -1", &|s| s.strength = power(1.0, 0.8, -1.0));
    let friction = |phi_deg, slope_deg_per_decade, greatest_phi_deg| {
        let (reference_kpa, up_to_kpa) = (1.0, None);
        Some(StrengthLaw::FrictionLaw {
            phi_deg,
            slope_deg_per_decade,
            reference_kpa,
            greatest_phi_deg,
            up_to_kpa,
        })
    };
    refused("strength.phi_deg is 14", &|s| s.strength = friction(14.0, 5.0, 55.0));
    refused("strength.slope_deg_per_decade is 0", &|s| s.strength = friction(38.0, 0.0, 55.0));
    refused("from strength.phi_deg to 69.9 deg", &|s| s.strength = friction(38.0, 5.0, 37.0));
    let points = |points: &[[f64; 2]]| Some(StrengthLaw::Points { points_kpa: points.to_vec() });
    refused("fewer than two points", &|s| s.strength = points(&[[0.0, 1.0]]));
    refused("must grow from one", &|s| s.strength = points(&[[0.0, 1.0], [0.0, 2.0]]));
    refused("slope between strength.points_kpa must not grow", &|s| {
        s.strength = points(&[[0.0, 1.0], [10.0, 2.0], [20.0, 9.0]]);
    });
    refused("strength below zero at no stress", &|s| s.strength = points(&[[10.0, 1.0], [20.0, 20.0]]));
    refused("strength.gsi is 101", &|s| {
        s.strength = Some(StrengthLaw::HoekBrown {
            ucs_mpa: 1.0,
            gsi: 101.0,
            mi: 10.0,
            disturbance: 0.0,
            up_to_kpa: None,
        });
    });
}
