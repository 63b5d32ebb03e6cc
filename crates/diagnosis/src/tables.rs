//! Tables of a diagnosis: predictions, gap and next experiment, each as the bytes of a CSV file.

use soilctl_columns::{Cell, Column, Columns, ColumnsError, Form, Kind, TableWriter};
use soilctl_effects::{Covariate, Loaded};
use soilctl_strokes::StrokeRow;

use crate::{Comparison, Data, DiagnosisError, NextExperiment, Part};

type Table = TableWriter<Vec<u8>>;

fn table<const N: usize>(columns: [(&str, Kind); N]) -> Result<Table, ColumnsError> {
    TableWriter::new(Form::Csv, Vec::new(), "table", columns)
}

fn optional(value: Option<f64>) -> Cell<'static> {
    value.map_or(Cell::Missing, Cell::Float)
}

impl Comparison {
    /// The force of each stroke by the model files without and with the effects, and as predicted from the other batches.
    ///
    /// # Errors
    /// [`DiagnosisError::Effects`] if a model file has no answer for a stroke.
    pub fn predictions_csv(
        &self,
        data: &Data,
        before: &Loaded,
        after: &Loaded,
    ) -> Result<Vec<u8>, DiagnosisError> {
        let mut table = table([
            ("stroke_id", Kind::Text),
            ("force_before_n", Kind::Float),
            ("force_after_n", Kind::Float),
            ("heldout_before_n", Kind::OptionalFloat),
            ("heldout_after_n", Kind::OptionalFloat),
        ])?;
        for (i, row) in data.rows.iter().enumerate() {
            let held_out = |ln_force: &Option<Vec<f64>>| optional(ln_force.as_ref().map(|all| all[i].exp()));
            table.row([
                Cell::Text(row.stroke_id.clone().unwrap_or_else(|| (i + 1).to_string()).into()),
                Cell::Float(before.force_n(row)?),
                Cell::Float(after.force_n(row)?),
                held_out(&self.heldout_before),
                held_out(&self.heldout_after),
            ])?;
        }
        Ok(table.finish()?)
    }

    /// The held-out gap by column and condition.
    ///
    /// # Errors
    /// None in practice: a table in memory can be written.
    pub fn gap_csv(&self) -> Result<Vec<u8>, DiagnosisError> {
        let mut table = table([
            ("channel", Kind::Text),
            ("covariate", Kind::Text),
            ("from", Kind::OptionalFloat),
            ("to", Kind::OptionalFloat),
            ("readings", Kind::Integer),
            ("normalised_rmse_before", Kind::Float),
            ("normalised_rmse_after", Kind::Float),
            ("delta_elpd", Kind::Float),
            ("delta_elpd_se", Kind::Float),
        ])?;
        for part in &self.parts {
            let Part { channel, covariate, range, readings, before, after, delta_elpd, delta_elpd_se } = part;
            let [from, to] = range.map_or([None; 2], |ends| ends.map(Some)).map(optional);
            let covariate =
                covariate.map_or(Cell::Missing, |known| Cell::Text(Covariate::column(known).into()));
            let numbers = [before, after, delta_elpd, delta_elpd_se].map(|value| Cell::Float(*value));
            let first =
                [Cell::Text((*channel).into()), covariate, from, to, Cell::Integer(*readings as i128)];
            table.row(first.into_iter().chain(numbers))?;
        }
        Ok(table.finish()?)
    }
}

impl NextExperiment {
    /// The strokes to make, without forces, and with empty cells for what is to be read: both are still to be measured.
    ///
    /// # Errors
    /// None in practice: a table in memory can be written.
    pub fn design_csv(&self) -> Result<Vec<u8>, DiagnosisError> {
        let filled = |column: &&Column<StrokeRow>| {
            self.rows.iter().any(|row| (column.get)(row) != Cell::Missing) && column.about.name != "force_n"
        };
        let columns: Vec<_> = StrokeRow::COLUMNS.iter().filter(filled).collect();
        let heads = columns.iter().map(|column| (column.about.name, column.about.kind));
        let mut table = TableWriter::new(Form::Csv, Vec::new(), "table", heads)?;
        let to_read = |name: &str| self.readings.iter().any(|channel| channel.column() == name);
        for row in &self.rows {
            table.row(columns.iter().map(|column| match to_read(column.about.name) {
                true => Cell::Missing,
                false => (column.get)(row),
            }))?;
        }
        Ok(table.finish()?)
    }
}

#[cfg(test)]
mod tests {
    use soilctl_effects::Channel;

    use super::*;

    #[test]
    fn a_design_leaves_what_is_to_be_measured_empty() {
        let row = StrokeRow {
            alpha_deg: 80.0,
            depth_m: 0.02,
            width_m: 0.1,
            force_n: 1.0,
            radius_m: Some(0.3),
            heap_height_m: Some(0.0),
            ..StrokeRow::default()
        };
        let readings = vec![Channel::HeapHeight];
        let next = NextExperiment {
            text: String::new(),
            rows: vec![row.clone(), row],
            readings,
            power: 1.0,
            by_plan: false,
        };
        let table = String::from_utf8(next.design_csv().unwrap()).unwrap();
        assert_eq!(
            table,
            "alpha_deg,depth_m,width_m,radius_m,heap_height_m\n80,0.02,0.1,0.3,\n80,0.02,0.1,0.3,\n"
        );
    }
}
