//! Round tick positions and their labels.

use crate::model::Scale;

/// A labelled tick.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    pub(crate) label: String,
}

/// Labelled ticks and the positions of unlabelled ones.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Ticks {
    pub(crate) major: Vec<Tick>,
    pub(crate) minor: Vec<f64>,
}

/// About `target` ticks over `range`.
pub(crate) fn ticks(scale: Scale, range: (f64, f64), target: usize) -> Ticks {
    match scale {
        Scale::Linear => Ticks { major: linear(range, target), minor: Vec::new() },
        Scale::Log => log(range, target),
    }
}

fn linear((low, high): (f64, f64), target: usize) -> Vec<Tick> {
    let rough = (high - low) / target.max(1) as f64;
    let mut exponent = rough.log10().floor() as i32;
    let mantissa = rough / 10f64.powi(exponent);
    let mut step = [1.0, 2.0, 5.0].into_iter().find(|&s| s >= mantissa * 0.999);
    if step.is_none() {
        exponent += 1;
        step = Some(1.0);
    }
    let multiple = step.unwrap_or(1.0);
    let unit = multiple * 10f64.powi(exponent);
    let (first, last) = ((low / unit - 1e-6).ceil(), (high / unit + 1e-6).floor());
    let count = (last - first).clamp(0.0, 100.0) as usize;
    // Products of integers first, so that 3 * 0.1 is not 0.30000000000000004.
    let value = |k: f64| {
        if exponent < 0 { k * multiple / 10f64.powi(-exponent) } else { k * multiple * 10f64.powi(exponent) }
    };
    let values: Vec<f64> = (0..=count).map(|i| value(first + i as f64)).collect();
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let label = |value: f64| linear_label(value, exponent, largest);
    values.into_iter().map(|value| Tick { value, label: label(value) }).collect()
}

/// Plain decimals for everyday magnitudes, a common power of ten for others.
fn linear_label(value: f64, step_exponent: i32, largest: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if largest < 1e6 && step_exponent >= -5 {
        return minus(format!("{value:.*}", (-step_exponent).max(0) as usize));
    }
    let exponent = largest.log10().floor() as i32;
    let decimals = (exponent - step_exponent).clamp(0, 12) as usize;
    minus(format!("{:.decimals$}×10{}", value / 10f64.powi(exponent), superscript(exponent)))
}

fn log((low, high): (f64, f64), target: usize) -> Ticks {
    let (first, last) = ((low.log10() - 1e-9).ceil() as i32, (high.log10() + 1e-9).floor() as i32);
    let decades = last - first + 1;
    if decades < 2 && high / low < 20.0 {
        return Ticks { major: linear((low, high), target), minor: Vec::new() };
    }
    let stride = (decades as usize).div_ceil(target.max(2)).max(1) as i32;
    let multiples: &[i32] = if decades <= 2 { &[1, 2, 5] } else { &[1] };
    // One notation for the whole axis: plain decimals only where all labels are short.
    let plain = first > -5 && last <= 4;
    let mut ticks = Ticks::default();
    for exponent in first - 1..=last {
        for multiple in 1..10 {
            let value = f64::from(multiple) * 10f64.powi(exponent);
            let inside = value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
            if !inside {
                continue;
            }
            if multiples.contains(&multiple) && (exponent - first).rem_euclid(stride) == 0 {
                ticks.major.push(Tick { value, label: log_label(multiple, exponent, plain) });
            } else if stride == 1 || multiple == 1 {
                ticks.minor.push(value);
            }
        }
    }
    ticks
}

fn log_label(multiple: i32, exponent: i32, plain: bool) -> String {
    if plain {
        let value = f64::from(multiple) * 10f64.powi(exponent);
        format!("{value:.*}", (-exponent).max(0) as usize)
    } else if multiple == 1 {
        format!("10{}", superscript(exponent))
    } else {
        format!("{multiple}×10{}", superscript(exponent))
    }
}

fn superscript(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    exponent.to_string().chars().map(raised).collect()
}

/// A true minus sign instead of a hyphen.
fn minus(text: String) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, range: (f64, f64), target: usize) -> Vec<String> {
        ticks(scale, range, target).major.into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        assert_eq!(labels(Scale::Linear, (-0.6, 12.6), 6), ["0", "5", "10"]);
        assert_eq!(labels(Scale::Linear, (0.0, 0.3), 3), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(labels(Scale::Linear, (-1.0, 1.0), 4), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
    }

    #[test]
    fn large_values_share_a_power_of_ten() {
        assert_eq!(labels(Scale::Linear, (0.0, 2e7), 2), ["0", "1×10⁷", "2×10⁷"]);
        assert_eq!(labels(Scale::Linear, (1e-7, 3e-7), 2), ["1×10⁻⁷", "2×10⁻⁷", "3×10⁻⁷"]);
    }

    #[test]
    fn log_ticks_are_decades() {
        assert_eq!(labels(Scale::Log, (0.01, 1000.0), 8), ["0.01", "0.1", "1", "10", "100", "1000"]);
        assert_eq!(labels(Scale::Log, (1.0, 60.0), 8), ["1", "2", "5", "10", "20", "50"]);
        assert_eq!(labels(Scale::Log, (1e-12, 1e12), 5), ["10⁻¹²", "10⁻⁷", "10⁻²", "10³", "10⁸"]);
        assert_eq!(labels(Scale::Log, (2.1, 4.3), 4), ["3", "4"]);
    }

    #[test]
    fn extreme_ranges_do_not_explode() {
        for range in [(-1e100, 1e100), (1e15, 1e15 + 1e5), (0.0, 1e-199), (1e-100, 1e100)] {
            for scale in [Scale::Linear, Scale::Log] {
                if scale == Scale::Log && range.0 <= 0.0 {
                    continue;
                }
                let ticks = ticks(scale, range, 6);
                assert!((1..=102).contains(&ticks.major.len()), "{range:?} {ticks:?}");
            }
        }
    }
}
