#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::Float;
use proptest::prelude::*;

use super::*;

pub(crate) type BigRational = Ratio<BigInt>;

/// A number of the machine is a whole number times a power of two.
pub(crate) fn exact(x: f64) -> BigRational {
    assert!(x.is_finite());
    let (significand, exponent, sign) = Float::integer_decode(x);
    let whole = BigInt::from(significand) * sign;
    let power = BigInt::from(1) << exponent.unsigned_abs();
    if exponent < 0 { Ratio::new(whole, power) } else { Ratio::from_integer(whole * power) }
}

pub(crate) fn holds(interval: Interval, x: &BigRational) -> bool {
    let above = interval.lo == f64::NEG_INFINITY || exact(interval.lo) <= *x;
    let below = interval.hi == f64::INFINITY || *x <= exact(interval.hi);
    above && below
}

/// Numbers with few bits, with many, tiny ones and huge ones.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-8_i32..8).prop_map(f64::from),
        -2.0..2.0_f64,
        (-1000_i32..1000).prop_map(|i| f64::from(i) / 64.0),
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        (-1.0..1.0_f64, -1070_i32..1020).prop_map(|(m, e)| m * 2.0_f64.powi(e)),
    ]
}

/// An interval and a number in it.
fn enclosed() -> impl Strategy<Value = (Interval, f64)> {
    (number(), number(), number(), any::<bool>()).prop_map(|(a, b, c, thin)| {
        let mut ends = [a, b, c];
        ends.sort_by(f64::total_cmp);
        if thin { (Interval::point(a), a) } else { (Interval::new(ends[0], ends[2]), ends[1]) }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(4000), ..ProptestConfig::default() })]

    #[test]
    fn results_are_enclosed((x, a) in enclosed(), (y, b) in enclosed()) {
        let (a, b) = (exact(a), exact(b));
        prop_assert!(holds(x + y, &(&a + &b)));
        prop_assert!(holds(x - y, &(&a - &b)));
        prop_assert!(holds(x * y, &(&a * &b)));
        prop_assert!(holds(x.square(), &(&a * &a)));
        prop_assert!(holds(-x, &-&a));
        if b != exact(0.0) {
            prop_assert!(holds(x / y, &(&a / &b)));
        }
        let zero = exact(0.0);
        let (magnitude, or_zero) = if a < zero { (-&a, zero.clone()) } else { (a.clone(), a.clone()) };
        prop_assert!(holds(x.abs(), &magnitude) && holds(x.or_zero(), &or_zero));
        if a >= zero {
            let root = x.sqrt();
            let square = |r: f64| exact(r) * exact(r);
            prop_assert!(root.lo >= 0.0 && square(root.lo) <= a);
            prop_assert!(root.hi == f64::INFINITY || a <= square(root.hi));
        }
        for r in [x + y, x - y, x * y, x.square(), x / y, x.abs(), x.or_zero(), x.sqrt()] {
            prop_assert!(r.lo <= r.hi && r.lo < f64::INFINITY && r.hi > f64::NEG_INFINITY);
        }
        prop_assert!(x.square().lo >= 0.0);
    }

    #[test]
    fn thin_intervals_stay_thin(a in -2.0..2.0_f64, b in 0.5..2.0_f64) {
        let (x, y) = (Interval::point(a), Interval::point(b));
        for r in [x + y, x - y, x * y, x / y] {
            prop_assert!(r.hi - r.lo <= 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn small_integers_are_exact(a in -1_000_000_i32..1_000_000, b in -1_000_000_i32..1_000_000, e in -40_i32..40) {
        let scale = 2.0_f64.powi(e);
        let (x, y) = (Interval::point(f64::from(a) * scale), Interval::point(f64::from(b)));
        for r in [x + y * scale.into(), x - y * scale.into(), x * y, x * y - y * x] {
            prop_assert_eq!(r.lo, r.hi);
        }
        if b != 0 {
            let quotient = (x * y) / y;
            prop_assert_eq!(quotient, x);
        }
    }
}

#[test]
fn roots_of_small_squares_are_exact() {
    for i in 0..1000 {
        let x = Interval::point(f64::from(i));
        assert_eq!(x.square().sqrt(), x);
    }
    assert!(Interval::ZERO.sqrt().is_zero());
    let (a, b) = (Interval::new(-1.0, 2.0), Interval::new(0.0, 1.0));
    assert_eq!(a.or_lesser(b), b.or_lesser(a));
}

#[test]
fn zero_takes_no_noise() {
    let any = Interval::point(f64::NAN);
    assert!((Interval::ZERO * any).is_zero() && (any * Interval::ZERO).is_zero());
    let x = Interval::point(0.1) * Interval::point(0.3);
    assert_eq!(x + Interval::ZERO, x);
    assert!(!(x - x).is_zero(), "two numbers may differ although they are known to the same ends");
    let p = Interval::point(0.1);
    assert!((p - p).is_zero());
}

#[test]
fn what_is_not_finite_proves_nothing() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let x = Interval::point(x);
        assert!(!x.is_at_least_zero() && !(-x).is_at_least_zero() && !x.is_not_zero());
        assert!(!(x + Interval::ONE).is_at_least_zero() && !(Interval::ONE / x).is_positive());
    }
    let huge = Interval::point(f64::MAX);
    assert_eq!((huge + huge).hi, f64::INFINITY);
    assert!((huge * huge).is_positive());
}

/// `0.123` as a fraction.
fn decimal(digits: &str) -> BigRational {
    let (whole, part) = digits.split_once('.').unwrap();
    format!("{whole}{part}/1{}", "0".repeat(part.len())).parse().unwrap()
}

#[test]
fn sines_are_enclosed() {
    // To 30 digits, from Machin's formula for pi and the Taylor series in decimal arithmetic.
    let known = [
        (0.0009765625, "0.000017044230975681883421572794", "0.999999999854747095213253892977"),
        (10.0, "0.173648177666930348851716626769", "0.984807753012208059366743024590"),
        (20.5, "0.350207381259467461025877873899", "0.936672189248397616249600602811"),
        (33.0, "0.544639035015027082224083692082", "0.838670567945424029637590941805"),
        (44.875, "0.705562431934713141439116005773", "0.708647764860916840952788557121"),
        (45.0, "0.707106781186547524400844362105", "0.707106781186547524400844362105"),
        (45.125, "0.708647764860916840952788557121", "0.705562431934713141439116005773"),
        (60.0, "0.866025403784438646763723170753", "0.500000000000000000000000000000"),
        (89.875, "0.999997620177351842910882007379", "0.002181659834336769732739976444"),
    ];
    for (degrees, sin, cos) in known {
        let found = angle(degrees);
        for (interval, digits) in [(found.sin, sin), (found.cos, cos)] {
            let last = decimal("0.000000000000000000000000000001");
            let near = decimal(digits);
            assert!(
                holds(interval, &(&near - &last)) && holds(interval, &(&near + &last)),
                "{degrees}: {interval:?}"
            );
            assert!(interval.hi - interval.lo < 2e-15);
        }
        assert!(holds(found.tan() * found.cot(), &exact(1.0)));
    }
    assert!(angle(0.0).sin.is_zero());
    assert!(holds(angle(0.0).cos, &exact(1.0)) && holds(angle(30.0).sin, &exact(0.5)));
}

proptest! {
    #[test]
    fn sine_and_cosine_make_one(degrees in 0.0..90.0_f64) {
        let Angle { sin, cos } = angle(degrees);
        let one = sin.square() + cos.square();
        prop_assert!(one.lo <= 1.0 && one.hi >= 1.0 && one.hi - one.lo < 1e-14);
        prop_assert!(sin.is_at_least_zero() && cos.is_positive());
        prop_assert!((sin.lo - degrees.to_radians().sin()).abs() < 1e-15);
    }
}
