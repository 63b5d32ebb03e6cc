//! Caquot & Kerisel's earth-pressure tables (1948) as Hong (2001) used them.
//!
//! The net coefficient is the printed column of Appendix C, interpolated like any table. Its split into a passive
//! and an active part is inferred: the active part was recovered from the column by assuming the classical form
//! `K = Kp(rough) R(phi, delta/phi) - Ka` with the published reduction factors R.

use soilctl_soil::{Angle, WidthRatio};

use super::thesis::{Column, appendix_c};
use crate::model::{ForceModel, ModelSlice, ValidRange};
use crate::table::TableModel;
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ACTIVE_CSV: &str = include_str!("../../../../data/caquot_active_inferred.csv");
const RATIOS: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
const ALPHA: (f64, f64, usize) = (70.0, 5.0, 7);
const PHI: (f64, f64, usize) = (25.0, 5.0, 6);

/// Caquot & Kerisel's tables.
#[derive(Debug, Clone)]
pub struct Caquot {
    net: TableModel,
}

impl Caquot {
    /// The model on its built-in tables.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if a built-in file is damaged, which a test rules out.
    pub fn new() -> Result<Self, EarthPressureError> {
        let reference = "Caquot & Kerisel 1948, as tabulated in Hong 2001, Appendix C; neither bound; the \
                         passive/active split is inferred";
        Ok(Self { net: TableModel::new("caquot", reference, appendix_c(Column::Caquot)?) })
    }

    /// Inferred active coefficient, linear in alpha, phi and delta/phi; `None` outside alpha 70-100, phi 25-50 deg,
    /// or where the ratio delta/phi was not recovered.
    pub(crate) fn active(case: &Case) -> Option<f64> {
        let (phi, delta) = (case.friction.degrees(), case.interface.degrees());
        let (i, s) = cell(case.tool_angle.degrees(), ALPHA)?;
        let (j, t) = cell(phi, PHI)?;
        if case.surface_slope.radians() != 0.0 {
            return None;
        }
        let rows: Vec<Vec<Option<f64>>> = ACTIVE_CSV
            .lines()
            .skip(1)
            .map(|line| line.split(',').skip(2).map(|field| field.parse().ok()).collect())
            .collect();
        let at = |i: usize, j: usize| along_ratio(rows.get(i * PHI.2 + j)?, delta / phi);
        // A corner with weight 0 need not exist.
        let corner = |i: usize, j: usize, w: f64| if w == 0.0 { Some(0.0) } else { at(i, j).map(|k| w * k) };
        Some(
            corner(i, j, (1.0 - s) * (1.0 - t))?
                + corner(i + 1, j, s * (1.0 - t))?
                + corner(i, j + 1, (1.0 - s) * t)?
                + corner(i + 1, j + 1, s * t)?,
        )
    }
}

/// Index of the cell and fraction in it.
fn cell(x: f64, (start, step, count): (f64, f64, usize)) -> Option<(usize, f64)> {
    let u = (x - start) / step;
    if !(-1e-9..=(count - 1) as f64 + 1e-9).contains(&u) {
        return None;
    }
    let nearest = u.round();
    if (u - nearest).abs() < 1e-9 {
        return Some((nearest as usize, 0.0));
    }
    Some((u.floor() as usize, u.fract()))
}

fn along_ratio(row: &[Option<f64>], ratio: f64) -> Option<f64> {
    let i = RATIOS.windows(2).position(|w| ratio <= w[1] + 1e-12)?;
    let t = (ratio - RATIOS[i]) / (RATIOS[i + 1] - RATIOS[i]);
    Some(row[i]? + t * ((*row.get(i + 1)?)? - row[i]?))
}

impl ForceModel for Caquot {
    fn id(&self) -> &'static str {
        self.net.id()
    }

    fn reference(&self) -> &'static str {
        self.net.reference()
    }

    fn valid_range(&self) -> ValidRange {
        self.net.valid_range()
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        let mut prediction = self.net.predict(case)?;
        if let Some(active) = Self::active(case) {
            let weight = |weight| Some(LoadFactors { weight, ..LoadFactors::default() });
            prediction.passive = weight(prediction.net.weight + active);
            prediction.active = weight(active);
            prediction.notes.push("the split into passive and active is inferred");
        }
        Ok(prediction)
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.net.at(tool_angle, surface_slope, width_ratio)
    }
}
