use soilctl_soil::{Angle, Provenance, SlantCoefficient, WidthRatio};

use super::PredictionTable;
use super::interpolate::Interpolator;
use super::section::TableSlice;
use crate::model::{ForceModel, ModelSlice, NetFactors, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const INTERPOLATED: &str = "interpolated in the table; see the margin";

/// A force model read from one table.
#[derive(Debug, Clone)]
pub struct TableModel {
    id: &'static str,
    reference: &'static str,
    table: Interpolator,
}

impl TableModel {
    /// A model with an id and a reference of its own.
    #[must_use]
    pub fn new(id: &'static str, reference: &'static str, table: PredictionTable) -> Self {
        Self { id, reference, table: Interpolator::new(table) }
    }

    /// The table behind the model.
    #[must_use]
    pub const fn table(&self) -> &PredictionTable {
        self.table.table()
    }
}

impl ForceModel for TableModel {
    fn id(&self) -> &'static str {
        self.id
    }

    fn reference(&self) -> &'static str {
        self.reference
    }

    fn valid_range(&self) -> ValidRange {
        range_of(self.table.table())
    }

    fn interpolates(&self) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(self.id, case)?;
        let section = self.table.at(case.tool_angle.degrees())?;
        let look = section.lookup(case.friction.degrees(), case.interface.degrees())?;
        Ok(prediction(look.k_net, (look.k_net, look.k_net), look.margin))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        _width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.valid_range().check_geometry(self.id, tool_angle, surface_slope)?;
        Ok(Box::new(PointSlice(self.table.slice(tool_angle.degrees())?)))
    }
}

struct PointSlice<'a>(TableSlice<'a>);

impl ModelSlice for PointSlice<'_> {
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError> {
        let k = self.0.lookup(phi_deg, delta_deg)?.k_net;
        Ok(NetFactors {
            weight_lower: k,
            weight_upper: k,
            factors: LoadFactors { weight: k, ..LoadFactors::default() },
        })
    }
}

/// A force model that is a bracket: a table of lower bounds and one of upper bounds, each moved outwards by its
/// interpolation margin.
#[derive(Debug, Clone)]
pub struct BracketModel {
    id: &'static str,
    reference: &'static str,
    lower: Interpolator,
    upper: Interpolator,
}

impl BracketModel {
    /// A bracket from two tables.
    #[must_use]
    pub fn new(
        id: &'static str,
        reference: &'static str,
        lower: PredictionTable,
        upper: PredictionTable,
    ) -> Self {
        Self { id, reference, lower: Interpolator::new(lower), upper: Interpolator::new(upper) }
    }
}

impl ForceModel for BracketModel {
    fn id(&self) -> &'static str {
        self.id
    }

    fn reference(&self) -> &'static str {
        self.reference
    }

    fn provenance(&self) -> Provenance {
        Provenance { lower: self.lower.table().name().into(), upper: self.upper.table().name().into() }
    }

    fn valid_range(&self) -> ValidRange {
        let (a, b) = (range_of(self.lower.table()), range_of(self.upper.table()));
        let inner = |x: (f64, f64), y: (f64, f64)| (x.0.max(y.0), x.1.min(y.1));
        ValidRange {
            alpha_deg: inner(a.alpha_deg, b.alpha_deg),
            beta_deg: inner(a.beta_deg, b.beta_deg),
            phi_deg: inner(a.phi_deg, b.phi_deg),
            delta_deg: inner(a.delta_deg, b.delta_deg),
        }
    }

    fn interpolates(&self) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(self.id, case)?;
        let alpha = case.tool_angle.degrees();
        let sections = (self.lower.at(alpha)?, self.upper.at(alpha)?);
        let (phi, delta) = (case.friction.degrees(), case.interface.degrees());
        let (low, high) = (sections.0.lookup(phi, delta)?, sections.1.lookup(phi, delta)?);
        let ends = (low.k_net * libm::exp(-low.margin), high.k_net * libm::exp(high.margin));
        Ok(prediction((ends.0 * ends.1).sqrt(), ends, low.margin.max(high.margin)))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        _width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.valid_range().check_geometry(self.id, tool_angle, surface_slope)?;
        let alpha = tool_angle.degrees();
        Ok(Box::new(BracketSlice { lower: self.lower.slice(alpha)?, upper: self.upper.slice(alpha)? }))
    }
}

struct BracketSlice<'a> {
    lower: TableSlice<'a>,
    upper: TableSlice<'a>,
}

impl ModelSlice for BracketSlice<'_> {
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError> {
        let low = self.lower.lookup(phi_deg, delta_deg)?;
        let high = self.upper.lookup(phi_deg, delta_deg)?;
        let (weight_lower, weight_upper) =
            (low.k_net * libm::exp(-low.margin), high.k_net * libm::exp(high.margin));
        let factors = LoadFactors { weight: (weight_lower * weight_upper).sqrt(), ..LoadFactors::default() };
        Ok(NetFactors { weight_lower, weight_upper, factors })
    }
}

fn range_of(table: &PredictionTable) -> ValidRange {
    let ends = |axis: &Vec<f64>| (axis[0], axis[axis.len() - 1]);
    let [alpha, phi, delta] = table.axes();
    ValidRange { alpha_deg: ends(alpha), beta_deg: (0.0, 0.0), phi_deg: ends(phi), delta_deg: ends(delta) }
}

fn prediction(k: f64, ends: (f64, f64), margin: f64) -> Prediction {
    Prediction {
        passive: None,
        active: None,
        net: LoadFactors { weight: k, ..LoadFactors::default() },
        net_lower: SlantCoefficient(ends.0),
        net_upper: SlantCoefficient(ends.1),
        interpolation_margin: margin,
        notes: if margin > 0.0 { vec![INTERPOLATED] } else { Vec::new() },
    }
}
