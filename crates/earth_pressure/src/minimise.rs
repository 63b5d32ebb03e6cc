//! One-dimensional minimisation, fast enough to sit inside a grid of ten thousand predictions.

/// Least value of `f` on `[low, high]` and where it is.
///
/// A scan of `samples` points brackets the lowest valley, Brent's method (1973, chapter 5) closes in on it; an
/// end of the interval is returned when the function still falls towards it. Points where `f` is not finite are
/// outside its domain. The abscissa is good to 1e-7, the value to its square. `None` if there is no finite value at all.
pub(crate) fn minimise(low: f64, high: f64, samples: usize, f: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let step = (high - low) / samples as f64;
    let at = |i: usize| low + step * i as f64;
    let (best, value) = (0..=samples)
        .map(|i| (i, f(at(i))))
        .filter(|(_, y)| y.is_finite())
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    let found = brent(at(best.saturating_sub(1)), at((best + 1).min(samples)), at(best), value, &f);
    Some(if found.1 < value { found } else { (at(best), value) })
}

/// Brent's parabolic interpolation with golden-section safeguard, started from an inner point.
fn brent(mut a: f64, mut b: f64, start: f64, start_value: f64, f: &impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.381_966_011_250_105;
    const TOLERANCE: f64 = 1e-7;
    let guarded = |x: f64| {
        let y = f(x);
        if y.is_finite() { y } else { f64::MAX }
    };
    let (mut x, mut w, mut v) = (start, start, start);
    let (mut fx, mut fw, mut fv) = (start_value, start_value, start_value);
    let (mut d, mut e) = (0.0_f64, 0.0_f64);
    for _ in 0..60 {
        let middle = f64::midpoint(a, b);
        let tolerance = TOLERANCE * x.abs() + 1e-12;
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            break;
        }
        let mut golden = true;
        if e.abs() > tolerance {
            let r = (x - w) * (fx - fv);
            let mut q = (x - v) * (fx - fw);
            let mut p = (x - v) * q - (x - w) * r;
            q = 2.0 * (q - r);
            if q > 0.0 {
                p = -p;
            }
            q = q.abs();
            let before = e;
            e = d;
            if p.abs() < (0.5 * q * before).abs() && p > q * (a - x) && p < q * (b - x) {
                d = p / q;
                let u = x + d;
                if u - a < 2.0 * tolerance || b - u < 2.0 * tolerance {
                    d = tolerance.copysign(middle - x);
                }
                golden = false;
            }
        }
        if golden {
            e = if x >= middle { a - x } else { b - x };
            d = GOLDEN * e;
        }
        let u = if d.abs() >= tolerance { x + d } else { x + tolerance.copysign(d) };
        let fu = guarded(u);
        if fu <= fx {
            if u >= x {
                a = x
            } else {
                b = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_lower_of_two_valleys_and_the_ends() {
        let (x, y) = minimise(-2.0, 3.0, 20, |x| (x * x - 1.0).powi(2) + 0.1 * x).unwrap();
        assert!((x + 1.0122).abs() < 1e-3 && y < -0.1);
        let (x, _) = minimise(0.0, 1.0, 8, |x| x).unwrap();
        assert_eq!(x, 0.0);
        assert!(minimise(0.0, 1.0, 8, |_| f64::NAN).is_none());
    }

    #[test]
    fn is_accurate_to_the_tolerance() {
        let (x, _) = minimise(0.0, 2.0, 10, |x| libm::cosh(x) - x).unwrap();
        assert!((x - 1f64.asinh()).abs() < 1e-6);
    }
}
