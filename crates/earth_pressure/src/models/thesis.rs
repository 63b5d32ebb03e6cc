//! The tables of Hong (2001), Appendix C: 287 sets of tool angle 70-100 deg, friction 25-50 deg and interface
//! friction 0-30 deg.
//!
//! The lower bound at delta = 5 deg was never solved: in all 42 rows it is the mean of delta = 0 and 10, and in two
//! of them it exceeds a rigorous upper bound. Those cells are marked interpolated.

use crate::EarthPressureError;
use crate::table::{Cell, CellStatus, PredictionTable, Quantity, TableModel};

const CSV: &str = include_str!("../../../../data/appendix_c.csv");

/// A column of Appendix C.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Coulomb.
    Coulomb,
    /// Log-spiral, with the quirks described at [`crate::LogSpiral`].
    LogSpiral,
    /// Chen & Liu.
    Chen,
    /// Caquot & Kerisel.
    Caquot,
    /// Numerical upper bound.
    UpperBound,
    /// Numerical lower bound.
    LowerBound,
}

impl Column {
    const fn header(self) -> &'static str {
        match self {
            Self::Coulomb => "coulomb",
            Self::LogSpiral => "log_spiral",
            Self::Chen => "chen",
            Self::Caquot => "caquot",
            Self::UpperBound => "num_ub",
            Self::LowerBound => "num_lb",
        }
    }

    const fn quantity(self) -> Quantity {
        match self {
            Self::UpperBound => Quantity::UpperBound,
            Self::LowerBound => Quantity::LowerBound,
            _ => Quantity::Estimate,
        }
    }
}

/// One column as a table. Rows that are blank in print (two at alpha 100, phi 50, delta 30) stay empty.
///
/// # Errors
/// [`EarthPressureError::BadTable`] if the built-in file is damaged, which a test rules out.
pub fn appendix_c(column: Column) -> Result<PredictionTable, EarthPressureError> {
    let name = format!("Appendix C, {}", column.header());
    let bad = |problem: String| EarthPressureError::BadTable { table: name.clone(), problem };
    let mut reader = csv::Reader::from_reader(CSV.as_bytes());
    let headers = reader.headers().map_err(|e| bad(e.to_string()))?.clone();
    let place = |header: &str| {
        headers.iter().position(|h| h == header).ok_or_else(|| bad(format!("column {header} is missing")))
    };
    let places = [place("alpha_deg")?, place("phi_deg")?, place("delta_deg")?, place(column.header())?];
    let mut cells = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| bad(e.to_string()))?;
        let field = |i: usize| record.get(places[i]).unwrap_or_default();
        let number = |i: usize| field(i).parse::<f64>().map_err(|e| bad(format!("{:?}: {e}", field(i))));
        if field(3).is_empty() {
            continue;
        }
        let node = [number(0)?, number(1)?, number(2)?];
        let filled_in = column == Column::LowerBound && node[2] == 5.0;
        let status = if filled_in { CellStatus::Interpolated } else { CellStatus::Solved };
        cells.push((node, Cell { k_net: number(3)?, status }));
    }
    PredictionTable::from_cells(&name, column.quantity(), &cells, |_| name.clone())
}

/// Model `thesis-ub`: the numerical upper bound.
///
/// # Errors
/// As [`appendix_c`].
pub fn upper_bound() -> Result<TableModel, EarthPressureError> {
    let reference = "Hong 2001, Appendix C: numerical upper bound (after Ukritchon, Whittle & Sloan)";
    Ok(TableModel::new("thesis-ub", reference, appendix_c(Column::UpperBound)?))
}

/// Model `thesis-lb`: the numerical lower bound as printed.
///
/// # Errors
/// As [`appendix_c`].
pub fn lower_bound() -> Result<TableModel, EarthPressureError> {
    let reference =
        "Hong 2001, Appendix C: numerical lower bound; its cells at delta = 5 deg are interpolated";
    Ok(TableModel::new("thesis-lb", reference, appendix_c(Column::LowerBound)?))
}
