//! The strokes of a hidden campaign: a design of one of three sizes, the same for all campaigns in a sand.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_diagnosis::self_test::Random;

use super::hidden::{DENSITY_SD_REL, Sand};

/// Tool angles and depths of the larger designs.
pub(super) const ALPHAS_DEG: [f64; 3] = [80.0, 90.0, 100.0];
pub(super) const DEPTHS_M: [f64; 3] = [0.020, 0.0254, 0.029];
/// Radii, m: 17 and 12 in.
const RADII_M: [f64; 2] = [0.4318, 0.3048];
/// Between strokes beside each other at each radius, deg: no plate goes where another one went. By how much all are turned from one preparation to the
/// next.
const BESIDE_DEG: [f64; 2] = [25.0, 35.0];
const TURNS_DEG: [f64; 3] = [0.0, -4.0, 4.0];
/// Tool angles and depths are balanced over so many strokes, in an order of this seed.
const BLOCK: usize = 24;
const ORDER: u64 = 48;

/// How many strokes a campaign has.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
pub enum Design {
    /// 12: four preparations of three, two tool angles at two radii and one depth.
    #[default]
    #[serde(rename = "12")]
    #[value(name = "12")]
    Strokes12,
    /// 24: four preparations of six, three tool angles and depths at two radii.
    #[serde(rename = "24")]
    #[value(name = "24")]
    Strokes24,
    /// 48: eight preparations of six like those.
    #[serde(rename = "48")]
    #[value(name = "48")]
    Strokes48,
}

impl Design {
    /// Preparations.
    pub(super) const fn batches(self) -> usize {
        match self {
            Self::Strokes12 | Self::Strokes24 => 4,
            Self::Strokes48 => 8,
        }
    }

    /// Strokes of a preparation.
    pub(super) const fn strokes(self) -> usize {
        match self {
            Self::Strokes12 => 3,
            Self::Strokes24 | Self::Strokes48 => 6,
        }
    }

    /// Strokes of a campaign.
    pub(super) const fn all(self) -> usize {
        self.batches() * self.strokes()
    }

    /// Tool angles times radii: strokes that the twin makes alone.
    pub(super) const fn kinds(self) -> usize {
        match self {
            Self::Strokes12 => 4,
            Self::Strokes24 | Self::Strokes48 => ALPHAS_DEG.len() * RADII_M.len(),
        }
    }

    /// The plan of a campaign in a sand.
    pub(super) fn plan(self, sand: &Sand, model: &str) -> String {
        let mut text = format!(
            "version = 1\ndesign = \"hidden campaign\"\nsoil = \"{}\"\nmodel = \"{model}\"\nplant = \"plant.toml\"\n\
             preparation = {{ density_sd_rel = {DENSITY_SD_REL} }}\n",
            sand.preset
        );
        let cells = match self {
            Self::Strokes12 => one_depth(),
            Self::Strokes24 | Self::Strokes48 => self.three_depths(),
        };
        for batch in cells.chunks(self.strokes()) {
            text += "[[batches]]\nstrokes = [\n";
            for Cell { radius_m, base_deg, alpha_deg, depth_m } in batch {
                // Writing to a text cannot fail.
                let _ = writeln!(
                    text,
                    "    {{ radius_m = {radius_m}, base_deg = {base_deg:.1}, alpha_deg = {alpha_deg:.1}, depth_m = {depth_m}, \
                     delta_set_deg = {:.1} }},",
                    sand.set_deg
                );
            }
            text += "]\n";
        }
        text
    }

    /// Three strokes beside each other at the larger radius and three at the smaller one. Tool angles and depths are balanced one by one and
    /// paired at random.
    fn three_depths(self) -> Vec<Cell> {
        let mut random = Random::new(ORDER, 1);
        let spread = |levels: [f64; 3], random: &mut Random| -> Vec<f64> {
            random.order(BLOCK).into_iter().map(|i| levels[i % levels.len()]).collect()
        };
        let mut block = || {
            let (alphas, depths) = (spread(ALPHAS_DEG, &mut random), spread(DEPTHS_M, &mut random));
            alphas.into_iter().zip(depths)
        };
        let levels: Vec<(f64, f64)> = (0..self.all() / BLOCK).flat_map(|_| block()).collect();
        let cell = |(i, (alpha_deg, depth_m)): (usize, (f64, f64))| {
            let (batch, place) = (i / self.strokes(), i % self.strokes());
            let (ring, beside) = (place / 3, (place % 3) as f64 - 1.0);
            let base_deg = beside * BESIDE_DEG[ring] + TURNS_DEG[batch % 3];
            Cell { radius_m: RADII_M[ring], base_deg, alpha_deg, depth_m }
        };
        levels.into_iter().enumerate().map(cell).collect()
    }
}

struct Cell {
    radius_m: f64,
    base_deg: f64,
    alpha_deg: f64,
    depth_m: f64,
}

/// Two tool angles at two radii: one of these goes with the preparation, both with the place in it.
fn one_depth() -> Vec<Cell> {
    let (batches, strokes) = (Design::Strokes12.batches(), Design::Strokes12.strokes());
    let cell = |i: usize| {
        let (batch, stroke) = (i / strokes, i % strokes);
        let (alpha_deg, depth_m) = if (batch + stroke) % 2 == 0 { (90.0, 0.0254) } else { (80.0, 0.02501) };
        let radius_m = RADII_M[usize::from(batch >= batches / 2)];
        Cell { radius_m, base_deg: 25.0 * (stroke as f64 - 1.0), alpha_deg, depth_m }
    };
    (0..batches * strokes).map(cell).collect()
}
