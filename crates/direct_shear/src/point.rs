use std::path::Path;

use serde::Serialize;
use soilctl_soil::{Angle, units};

use crate::degrees;
use crate::error::{DirectShearError, check};
use crate::table::Table;

/// Normal stresses below this one are taken for a slip of the unit.
const MIN_NORMAL_STRESS_PA: f64 = 1e-6;
/// Normal stresses above this one crush any sand.
const MAX_NORMAL_STRESS_PA: f64 = 1e9;
const STRESS_ALLOWED: &str = "above 1e-6 and below 1e9 Pa";
const ANGLE_ALLOWED: &str = "a number above 0 and below 90 deg";

/// A peak friction angle measured under one normal stress.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShearPoint {
    normal_stress_pa: f64,
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    friction: Angle,
}

impl ShearPoint {
    /// A point from normal stress (above 1e-6 and below 1e9 Pa) and friction angle (above 0, below 90 deg).
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] if a value is outside its range or not finite.
    pub fn new(normal_stress_pa: f64, friction: Angle) -> Result<Self, DirectShearError> {
        check_stress("normal_stress_pa", normal_stress_pa)?;
        check("friction_angle_deg", friction.degrees(), "deg", "above 0 and below 90 deg", |angle| {
            angle > 0.0 && angle < 90.0
        })?;
        Ok(Self { normal_stress_pa, friction })
    }

    /// Normal stress on the shear plane in Pa.
    #[must_use]
    pub const fn normal_stress_pa(&self) -> f64 {
        self.normal_stress_pa
    }

    /// Peak friction angle.
    #[must_use]
    pub const fn friction(&self) -> Angle {
        self.friction
    }
}

/// The tests of one soil, in the order of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShearSeries {
    /// Name of the soil; `None` if the table has no such column.
    pub soil: Option<String>,
    /// The points, at least one.
    pub points: Vec<ShearPoint>,
}

/// Reads a table of shear-box results from a CSV file.
///
/// Columns: `soil` (optional), `normal_stress_psi` or `normal_stress_pa`, and `friction_angle_deg`; others are
/// ignored, and so are lines that begin with `#`. Soils come back in the order of their first line.
///
/// # Errors
/// A [`DirectShearError`] with file, line and column if the file cannot be read, is not UTF-8, lacks a
/// column, has no rows, or if a stress is not above 1e-6 and below 1e9 Pa or an angle not above 0 and
/// below 90 degrees.
pub fn read_shear_points(path: impl AsRef<Path>) -> Result<Vec<ShearSeries>, DirectShearError> {
    from_table(&Table::read(path.as_ref())?)
}

/// The same as [`read_shear_points`] for the bytes of a table; `name` stands in for the file in messages.
///
/// # Errors
/// As [`read_shear_points`].
pub fn parse_shear_points(bytes: &[u8], name: &str) -> Result<Vec<ShearSeries>, DirectShearError> {
    from_table(&Table::parse(bytes, name)?)
}

fn from_table(table: &Table) -> Result<Vec<ShearSeries>, DirectShearError> {
    table.refuse_misspelt(&["soil", "normal_stress_psi", "normal_stress_pa", "friction_angle_deg"])?;
    let soil_column = table.column("soil");
    let (stress_column, in_psi) = match (table.column("normal_stress_psi"), table.column("normal_stress_pa"))
    {
        (Some(column), None) => (column, true),
        (None, Some(column)) => (column, false),
        (Some(_), Some(_)) => {
            let problem = "both `normal_stress_psi` and `normal_stress_pa` are given; keep one";
            return Err(table.columns_error(problem.to_owned()));
        }
        (None, None) => {
            let problem = "column `normal_stress_psi` or `normal_stress_pa` is missing; add one";
            return Err(table.columns_error(problem.to_owned()));
        }
    };
    let angle_column = table.require("friction_angle_deg")?;
    let (to_pa, stress_allowed): (fn(f64) -> f64, _) = if in_psi {
        (units::psi_to_pa, "a number above 1.5e-10 and below 145037 psi")
    } else {
        (std::convert::identity, "a number above 1e-6 and below 1e9 Pa")
    };

    let mut series: Vec<ShearSeries> = Vec::new();
    for row in &table.rows {
        let soil = soil_column.map(|column| table.text(row, column)).transpose()?.map(str::to_owned);
        let stress = table.number(row, stress_column, stress_allowed, |value| stress_ok(to_pa(value)))?;
        let angle = table.number(row, angle_column, ANGLE_ALLOWED, |value| value > 0.0 && value < 90.0)?;
        let point = ShearPoint::new(to_pa(stress), Angle::from_degrees(angle))?;
        match series.iter_mut().find(|entry| entry.soil == soil) {
            Some(entry) => entry.points.push(point),
            None => series.push(ShearSeries { soil, points: vec![point] }),
        }
    }
    Ok(series)
}

fn stress_ok(stress_pa: f64) -> bool {
    stress_pa > MIN_NORMAL_STRESS_PA && stress_pa < MAX_NORMAL_STRESS_PA
}

pub(crate) fn check_stress(quantity: &'static str, stress_pa: f64) -> Result<f64, DirectShearError> {
    check(quantity, stress_pa, "Pa", STRESS_ALLOWED, stress_ok)
}
