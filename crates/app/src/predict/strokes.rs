//! One prediction for every row of a stroke table.

use std::collections::BTreeMap;

use soilctl_earth_pressure::{Case, Loads, Prediction as ModelPrediction, check_loads};
use soilctl_soil::{Angle, Interface, Plate, Soil};
use soilctl_strokes::{ReadOptions, StrokeRow};

use super::Request;
use super::answer::{Answer, StrokePrediction};
use super::chosen::Chosen;
use super::single::inputs;
use crate::request::{Ends, NumberOrColumn};
use crate::{AppError, TableSource};

pub(super) fn predict(request: &Request, table: &TableSource) -> Result<Answer, AppError> {
    // Measured forces are only shown beside the predicted ones, so their uncertainty does not matter.
    let table = table.strokes(ReadOptions { allow_zero_sd: true })?;
    let loads = request.checked_loads()?;
    let chosen = Chosen::of(request)?;
    let mut predictor =
        Predictor { request, chosen: &chosen, loads, file: table.name(), known: BTreeMap::new() };
    let strokes = table.rows().map(|row| predictor.stroke(row)).collect::<Result<Vec<_>, _>>()?;
    let margins = predictor.known.values().map(|found| found.interpolation_margin);
    let interpolation_margin = margins.fold(0.0, f64::max);
    let mut notes: Vec<String> = Vec::new();
    for note in predictor.known.values().flat_map(|found| &found.notes) {
        if !notes.iter().any(|known| known == note) {
            notes.push((*note).to_owned());
        }
    }
    Ok(Answer {
        model: chosen.model.id().into(),
        k_passive: None,
        k_active: None,
        k_net: None,
        k_net_depth: None,
        k_net_lower: None,
        k_net_upper: None,
        k_net_provenance: None,
        ends: Ends::of(request.ends, chosen.model.as_ref(), true)?,
        width_ratio: None,
        force_n: None,
        friction_law: None,
        sensitivity_percent_per_deg: None,
        inputs: inputs(request)?,
        interpolation_margin,
        notes,
        valid_range: chosen.model.valid_range().into(),
        reference: chosen.reference,
        strokes: Some(strokes),
    })
}

struct Predictor<'a> {
    request: &'a Request,
    chosen: &'a Chosen,
    loads: Loads,
    file: &'a str,
    /// By the bits of alpha, delta and depth over width: a campaign repeats few geometries many times.
    known: BTreeMap<[u64; 3], ModelPrediction>,
}

impl Predictor<'_> {
    fn stroke(&mut self, row: StrokeRow) -> Result<StrokePrediction, AppError> {
        let delta_deg = match self.request.delta()? {
            NumberOrColumn::Number(value) => value,
            NumberOrColumn::Column => self.cell(row.delta_set_deg, &row, "--delta", "delta_set_deg")?,
        };
        let density = match self.request.density_kg_m3 {
            None => None,
            Some(NumberOrColumn::Number(value)) => Some(value),
            Some(NumberOrColumn::Column) => {
                Some(self.cell(row.density_kg_m3, &row, "--density", "density_kg_m3")?)
            }
        };
        let request = self.request;
        let beta = Angle::from_degrees(request.loads.beta_deg);
        let plate = Plate::new(Angle::from_degrees(row.alpha_deg), beta, row.depth_m, row.width_m)?;
        let soil = Soil::new(Angle::from_degrees(request.phi()?), density.unwrap_or(1.0))?
            .with_cohesion(request.loads.cohesion_pa)?
            .with_gravity(request.loads.gravity_m_s2)?;
        let interface = Interface::new(Angle::from_degrees(delta_deg), request.loads.adhesion_pa)?;
        let (_, width_ratio) = self.chosen.ends(request, Some(&plate))?;
        let case = Case::of(&plate, &soil, &interface).with_width_ratio(width_ratio);
        let found = self.model_prediction(&row, delta_deg, &case)?;
        let k_net = found.k_net().0;
        let force_n = density.map(|_| found.force_n(&plate, &soil, &self.loads));
        Ok(StrokePrediction {
            line: row.line,
            stroke_id: row.stroke_id,
            alpha_deg: row.alpha_deg,
            depth_m: row.depth_m,
            k_net,
            force_n,
            measured_n: row.force_n,
            ratio: force_n.map(|force| force / row.force_n),
        })
    }

    fn model_prediction(
        &mut self,
        row: &StrokeRow,
        delta_deg: f64,
        case: &Case,
    ) -> Result<ModelPrediction, AppError> {
        let ends = case.width_ratio.depth_over_width();
        let key = [row.alpha_deg, delta_deg, ends].map(f64::to_bits);
        if let Some(found) = self.known.get(&key) {
            return Ok(found.clone());
        }
        let model = self.chosen.model.as_ref();
        let found = check_loads(model, case, &self.loads)
            .and_then(|()| model.predict(case))
            .map_err(|problem| AppError::Row { file: self.file.into(), line: row.line, problem })?;
        self.known.insert(key, found.clone());
        Ok(found)
    }

    /// A cell that an option says to use.
    fn cell(&self, value: Option<f64>, row: &StrokeRow, option: &str, column: &str) -> Result<f64, AppError> {
        value.ok_or_else(|| {
            AppError::Request(format!(
                "{}, line {}: {column} is empty or missing, but {option} is column; fill it or give {option} a number",
                self.file, row.line
            ))
        })
    }
}
