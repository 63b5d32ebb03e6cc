//! Designs of hidden campaigns.

use soilctl_strokes::StrokeRow;

use super::random::Random;

/// What a hidden campaign looks like from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Strokes; a multiple of 6.
    pub strokes: usize,
    /// Vertical depths, m.
    pub depths_m: Vec<f64>,
    /// Widths, m.
    pub widths_m: Vec<f64>,
    /// Speeds, m/s.
    pub speeds_mps: Vec<f64>,
    /// Relative scatter of a force.
    pub scatter: f64,
    /// Whether columns from the trace are filled.
    pub traces: bool,
    /// Force model that is true; `None` for the one that the diagnosis uses.
    pub true_model: Option<&'static str>,
}

impl Default for Design {
    fn default() -> Self {
        Self {
            strokes: 48,
            depths_m: vec![0.0127, 0.0169, 0.0212, 0.0254],
            widths_m: vec![0.127, 0.0762],
            speeds_mps: vec![0.005, 0.01, 0.02],
            scatter: 0.06,
            traces: true,
            true_model: None,
        }
    }
}

const ANGLES_DEG: [f64; 4] = [70.0, 80.0, 90.0, 100.0];
const STROKE_S: f64 = 240.0;
const PREPARATION_S: f64 = 3600.0;

/// Rows with geometry and order, without forces.
pub(super) fn rows(design: &Design, random: &mut Random) -> Vec<StrokeRow> {
    // Depth, width, speed and angle are balanced one by one and paired at random.
    let n = design.strokes;
    let spread = |levels: &[f64], random: &mut Random| -> Vec<f64> {
        random.order(n).into_iter().map(|i| levels[i % levels.len()]).collect()
    };
    let depths = spread(&design.depths_m, random);
    let widths = spread(&design.widths_m, random);
    let speeds = spread(&design.speeds_mps, random);
    let angles = spread(&ANGLES_DEG, random);
    let mut time_s = 0.0;
    (0..n)
        .map(|i| {
            let (batch, order) = (i / 6, i % 6);
            if order == 0 && i > 0 {
                time_s += PREPARATION_S;
            }
            time_s += STROKE_S * random.between(0.8, 1.2);
            // 70 deg is out of reach of the wrist at 17 in.
            let far = order % 2 == 0 && angles[i] > 75.0;
            let side = (order % 3) as f64 - 1.0;
            StrokeRow {
                line: i + 2,
                stroke_id: Some(format!("s{:02}", i + 1)),
                batch: Some(format!("b{:02}", batch + 1)),
                order: Some(order as u32 + 1),
                time_s: Some(time_s),
                alpha_deg: angles[i],
                depth_m: depths[i],
                width_m: widths[i],
                speed_mps: Some(speeds[i]),
                radius_m: Some(if far { 0.4318 } else { 0.3048 }),
                base_deg: Some(side * if far { 25.0 } else { 35.0 }),
                gap_prior_m: (order > 0).then(|| random.between(0.01, 0.16)),
                wall_m: Some(
                    random.between(0.02, 0.07) + 0.06 * (1.0 - side.abs()) + if far { 0.0 } else { 0.03 },
                ),
                ..StrokeRow::default()
            }
        })
        .collect()
}
