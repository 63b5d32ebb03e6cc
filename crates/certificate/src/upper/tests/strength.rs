//! What soil dissipates, against all stress states that it bears.

use super::super::resistance::Resistance;
use super::reference::integral;
use crate::examples::{Random, soil};
use crate::interval::{Interval, Vector, angle};
use crate::problem::Strength;
use crate::{Envelope, Linear, Material, StrengthLine};

/// The greatest `p e + R g` of all stress states that a soil bears, by trying them.
fn tried(phi: f64, c: f64, t: f64, e: f64, g: f64) -> f64 {
    let (sin, cos) = phi.to_radians().sin_cos();
    let mut best = f64::NEG_INFINITY;
    for i in 0..=200_000 {
        let p = 5.0 - 20.0 * f64::from(i) / 200_000.0;
        let radius = (c * cos - p * sin).min(t - p);
        if radius >= 0.0 {
            best = best.max(p * e + radius * g);
        }
    }
    best
}

#[test]
fn strength_with_a_limit_to_tension_is_its_support_function() {
    let point = Interval::point;
    let mut random = Random::new(7);
    let mut near = 0;
    for _ in 0..60 {
        let mut next = |top: f64| top * 0.5 * (1.0 + random.next());
        let (phi, c, t, g) = (next(50.0), next(1.0), next(2.0), next(2.0));
        let e = g * phi.to_radians().sin() + next(1.5);
        let strength = Strength {
            friction: angle(phi),
            cohesion: Linear::uniform(c),
            pore_pressure: Linear::default(),
            tension: Some(point(t)),
            envelope: None,
            anisotropy: None,
        };
        let at = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Vector::point);
        let bound = Resistance::new(&strength, at).of_triangle([point(e); 3], [point(g); 3]).all();
        let slip = (g * g - e * e).max(0.0).sqrt();
        if e <= g {
            let layer = Resistance::new(&strength, [at[0], at[1]]);
            let layer = layer.of_layer([point(e); 3], [point(slip); 3]).all();
            assert!((layer.hi() - bound.hi()).abs() < 1e-6, "{layer:?} {bound:?}");
        }
        let best = tried(phi, c, t, e, g);
        assert!(
            bound.hi() >= best - 1e-9 && bound.hi() <= best + 1e-3,
            "{phi} {c} {t} {e} {g}: {bound:?} {best}"
        );
        near += usize::from(t < c / phi.to_radians().tan());
    }
    assert!((20..60).contains(&near));
}

/// The greatest `(xx - yy)/2 g + xy h` of all stresses that clay bears whose strength depends on the direction, by trying them, also in a layer
/// along any edge; and no stress that is borne lies outside the circle that counts in their place.
#[test]
fn strength_that_depends_on_the_direction_is_its_support_function() {
    let point = Interval::point;
    let mut random = Random::new(23);
    for _ in 0..40 {
        let mut next = |top: f64| top * 0.5 * (1.001 + random.next());
        let (passive, shear, c) = (next(2.0), next(2.0), next(3.0));
        let of = crate::Anisotropy { passive, shear };
        let material = Material { anisotropy: Some(of), ..crate::examples::material(0.0, c, 0.0) };
        let strength = Strength::new(&material);
        let borne: Vec<[f64; 2]> = (0..20_000)
            .map(|i| (f64::from(i) * 1e-4 * std::f64::consts::PI).sin_cos())
            .map(|(sin, cos)| [c * (0.5 * (1.0 - passive) + 0.5 * (1.0 + passive) * cos), c * shear * sin])
            .collect();
        let greatest =
            |g: f64, h: f64| borne.iter().map(|[x, y]| x * g + y * h).fold(f64::NEG_INFINITY, f64::max);
        let (g, h) = (next(2.0) - 1.0, next(2.0) - 1.0);
        let rate = strength.shear_rate(point(g), point(h));
        let at = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Vector::point);
        let bound = Resistance::new(&strength, at).of_triangle([Interval::ZERO; 3], [rate; 3]).all().hi();
        let tried = greatest(g, h);
        assert!(bound >= tried - 1e-12 && bound <= tried + 1e-6, "{bound} {tried}");

        let (edge, slip) = ([next(2.0) - 1.0, next(2.0) - 1.0], next(2.0) - 1.0);
        let square = edge[0] * edge[0] + edge[1] * edge[1];
        let ends = [[0.0, 0.0], edge].map(Vector::point);
        let layer =
            Resistance::new(&strength, ends).of_layer([Interval::ZERO; 3], [point(slip); 3]).all().hi();
        // Half of n t' + t n', with n that is t turned left.
        let (t, n) = ([edge[0], edge[1]], [-edge[1], edge[0]]);
        let strain = |i: usize, j: usize| 0.5 * (n[i] * t[j] + t[i] * n[j]) / square * slip;
        let tried = greatest(strain(0, 0) - strain(1, 1), 2.0 * strain(0, 1));
        assert!(layer >= tried - 1e-12 && layer <= tried + 1e-6, "{layer} {tried}");

        if let Some(ellipse) = strength.anisotropy {
            let [x, y] = borne[(next(1.0) * 19_999.0) as usize];
            let [round_x, round_y] = ellipse.round(point(c), point(x), point(y));
            let radius = (round_x.square() + round_y.square()).sqrt();
            assert!(radius.lo() <= c + 1e-12 && radius.hi() >= c - 1e-12, "{radius:?} {c}");
        }
    }
}

/// A parabola of Mohr, `tau^2 = 1 + 2 s` at the pressure `s`, between chords and tangents: with the normal to the envelope at the angle
/// `a`, its circles are known in closed form. What is dissipated is above that of the parabola for the tangents and below for the chords,
/// and near both.
#[test]
fn strength_of_many_lines_is_that_of_the_curve_they_are_near() {
    let at = |s: f64| (1.0 + 2.0 * s).sqrt();
    let slope = |s: f64| 1.0 / at(s);
    let line = |slope: f64, cohesion: f64| StrengthLine { phi_deg: slope.atan().to_degrees(), cohesion };
    let tangent = |s: f64| line(slope(s), at(s) - slope(s) * s);
    let chord = |a: f64, b: f64| {
        let slope = (at(b) - at(a)) / (b - a);
        line(slope, at(a) - slope * a)
    };
    let knots: Vec<f64> = (0..=400).map(|i| -0.5 + 4e-5 * f64::from(i).powi(2)).collect();
    let chords: Vec<StrengthLine> = knots.windows(2).map(|two| chord(two[0], two[1])).collect();
    let tangents = knots.windows(2).map(|two| tangent(0.5 * (two[0] + two[1]))).collect();
    let material = Material {
        phi_deg: chords[0].phi_deg,
        cohesion: Linear::uniform(chords[0].cohesion),
        envelope: Some(Envelope { inside: chords[1..].to_vec(), outside: tangents }),
        ..soil(30.0)
    };
    let outer = Strength::new(&material);
    let inner = Envelope { outside: Vec::new(), ..material.envelope.clone().unwrap() };
    let inner = Strength::new(&Material { envelope: Some(inner), ..material });
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Vector::point);
    let point = Interval::point;
    for (opening, slip) in [(0.3, 1.0), (0.5, 1.0), (1.0, 1.0), (2.0, 1.0), (0.4, -1.0)] {
        // The greatest `tau |slip| - s opening` on the parabola, at `tau = |slip|/opening`, above its tip.
        let tau = f64::abs(slip) / opening;
        let curve = tau * f64::abs(slip) - 0.5 * (tau * tau - 1.0) * opening;
        let of = |strength: &Strength| {
            let layer = Resistance::new(strength, [corners[0], corners[1]]);
            layer.of_layer([point(opening); 3], [point(slip); 3]).all().hi()
        };
        let (low, high) = (of(&inner), of(&outer));
        assert!(low <= curve + 1e-12 && curve <= high + 1e-12, "{opening}: {low} {curve} {high}");
        assert!(high - low < 1e-3 * curve, "{opening}: {low} {curve} {high}");
        let dilation = [point(opening); 3];
        let shearing = [point(f64::hypot(opening, slip)); 3];
        let triangle = Resistance::new(&outer, corners).of_triangle(dilation, shearing).all().hi();
        assert!((triangle - high).abs() < 1e-12);
        let bond = Resistance::new(&outer, [corners[0], corners[1]]);
        let bond = bond.of_bond(Interval::ONE, [point(opening); 3], [point(slip); 3]).all().hi();
        assert!((bond - curve).abs() < 1e-3 * curve && bond >= curve, "{bond} {curve}");
    }
}

/// The greatest power by formula, for sums.
fn power(phi: f64, c: f64, t: Option<f64>, e: f64, g: f64) -> f64 {
    let (sin, cos) = phi.to_radians().sin_cos();
    let apex = c * cos / sin * e;
    let radius = |t: f64| ((c * cos - t * sin) / (1.0 - sin)).max(0.0);
    t.map_or(apex, |t| apex.min(t * e + radius(t) * (g - e).max(0.0)))
}

#[test]
fn what_is_bounded_is_above_sums_and_not_by_much() {
    let point = Interval::point;
    let (phi, n) = (25.0_f64, 60);
    let (sin, tan) = (phi.to_radians().sin(), phi.to_radians().tan());
    let p = [[0.1, 0.0], [1.2, 0.3], [0.4, 0.9]];
    let area = (1.1 * 0.9 - 0.3 * 0.3) / 2.0;
    let mut random = Random::new(3);
    for case in 0..40 {
        let mut next = || random.next();
        let tension = [None, Some(0.0), Some(0.3), Some(0.7)][case % 4];
        let strength = Strength {
            friction: angle(phi),
            cohesion: Linear { at_origin: 0.6, gradient: [0.3 * next(), 0.4 * next()] },
            pore_pressure: Linear { at_origin: next(), gradient: [next(), next()] },
            tension: tension.map(point),
            envelope: None,
            anisotropy: None,
        };
        let at = |l: &Linear, q: [f64; 2]| l.at_origin + l.gradient[0] * q[0] + l.gradient[1] * q[1];
        // Components of the shear rate at the corners, and dilation with some to spare.
        let rates = p.map(|_| [next(), next()]);
        let dilation = rates.map(|r| r[0].hypot(r[1]) * sin + 0.3 * next().abs());
        let shearing = rates.map(|r| point(r[0].hypot(r[1])));
        let bound =
            Resistance::new(&strength, p.map(Vector::point)).of_triangle(dilation.map(point), shearing).all();
        let weights = |q: [f64; 2]| {
            let cross = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]) / (2.0 * area);
            let to = |i: usize| [p[i][0] - q[0], p[i][1] - q[1]];
            [cross(to(1), to(2)), cross(to(2), to(0)), cross(to(0), to(1))]
        };
        let sum = integral(p, n, |_, q, _| {
            let w = weights(q);
            let mean = |x: [f64; 3]| w[0] * x[0] + w[1] * x[1] + w[2] * x[2];
            let e = mean(dilation);
            let g = mean(rates.map(|r| r[0])).hypot(mean(rates.map(|r| r[1])));
            power(phi, at(&strength.cohesion, q), tension, e, g) - at(&strength.pore_pressure, q) * e
        }) / area;
        assert!(bound.hi() > sum - 1e-4 && bound.hi() < sum + 0.8, "{case}: {bound:?} {sum}");
        let slip = [next(), next(), next()];
        let opening = slip.map(|s| s.abs() * tan + 0.3 * next().abs());
        let layer = Resistance::new(&strength, [p[0], p[1]].map(Vector::point));
        let bound = layer.of_layer(opening.map(point), slip.map(point)).all();
        let count = 3000;
        let sum: f64 = (0..count)
            .map(|i| {
                let s = (f64::from(i) + 0.5) / f64::from(count);
                let r = 1.0 - s;
                let of = |b: [f64; 3]| b[0] * r * r + 2.0 * b[1] * r * s + b[2] * s * s;
                let q = [0, 1].map(|i| p[0][i] * r + p[1][i] * s);
                let (o, g) = (of(opening), of(opening).hypot(of(slip)));
                power(phi, at(&strength.cohesion, q), tension, o, g) - at(&strength.pore_pressure, q) * o
            })
            .sum::<f64>()
            / f64::from(count);
        assert!(bound.hi() > sum - 1e-6 && bound.hi() < sum + 0.8, "{case}: {bound:?} {sum}");
        if tension.is_none() {
            // Exactly, since all is linear in what is not.
            assert!((bound.hi() - sum).abs() < 1e-6, "{case}: {bound:?} {sum}");
        }
    }
}
