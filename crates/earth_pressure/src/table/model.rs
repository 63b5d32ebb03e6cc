use soilctl_soil::{Angle, Provenance, SlantCoefficient, WidthRatio};

use super::PredictionTable;
use super::bracket::BracketTable;
use super::interpolate::Interpolator;
use super::section::{Lookup, TableSlice};
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
            ends_at_most: 0.0,
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
    ends: Option<EndTables<Interpolator>>,
}

impl BracketModel {
    /// A bracket in plane strain from two tables.
    #[must_use]
    pub fn new(
        id: &'static str,
        reference: &'static str,
        lower: PredictionTable,
        upper: PredictionTable,
    ) -> Self {
        let (lower, upper) = (Interpolator::new(lower), Interpolator::new(upper));
        Self { id, reference, lower, upper, ends: None }
    }

    /// The bracket of a table, with ends if it knows of them.
    ///
    /// # Errors
    /// As [`BracketTable::split`].
    pub fn of(
        id: &'static str,
        reference: &'static str,
        table: &BracketTable,
    ) -> Result<Self, EarthPressureError> {
        let (lower, upper) = table.split()?;
        let ends = table.ends()?.map(|ends| {
            let [lower, upper, term] = ends.map(Interpolator::new);
            EndTables { lower, upper, term }
        });
        Ok(Self { ends, ..Self::new(id, reference, lower, upper) })
    }
}

/// Of plates with ends: the lower bound, the upper one on wide plates, and what a depth over width of one adds to that.
#[derive(Debug, Clone)]
struct EndTables<T> {
    lower: T,
    upper: T,
    term: T,
}

/// A bound moved outwards by its margin.
fn outwards(look: Lookup, sign: f64) -> f64 {
    look.k_net * libm::exp(sign * look.margin)
}

/// Both bounds at a width over depth from tables that are each looked up, and the greatest margin.
fn bracket<T>(
    [lower, upper]: [&T; 2],
    ends: Option<&EndTables<T>>,
    width_ratio: WidthRatio,
    look: impl Fn(&T) -> Result<Lookup, EarthPressureError>,
) -> Result<((f64, f64), f64), EarthPressureError> {
    match ends.filter(|_| width_ratio.finite().is_some()) {
        Some(ends) => {
            let (low, wide, term) = (look(&ends.lower)?, look(&ends.upper)?, look(&ends.term)?);
            let upper = outwards(wide, 1.0) + width_ratio.depth_over_width() * outwards(term, 1.0);
            Ok(((outwards(low, -1.0), upper), low.margin.max(wide.margin).max(term.margin)))
        }
        None => {
            let (low, high) = (look(lower)?, look(upper)?);
            Ok(((outwards(low, -1.0), outwards(high, 1.0)), low.margin.max(high.margin)))
        }
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

    fn has_ends(&self) -> bool {
        self.ends.is_some()
    }

    fn bounds_ends(&self) -> bool {
        self.has_ends()
    }

    fn is_for_plane_strain(&self) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(self.id, case)?;
        let alpha = case.tool_angle.degrees();
        let (phi, delta) = (case.friction.degrees(), case.interface.degrees());
        let look = |table: &Interpolator| table.at(alpha)?.lookup(phi, delta);
        let (sides, margin) =
            bracket([&self.lower, &self.upper], self.ends.as_ref(), case.width_ratio, look)?;
        Ok(prediction((sides.0 * sides.1).sqrt(), sides, margin))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.valid_range().check_geometry(self.id, tool_angle, surface_slope)?;
        let slice = |table| Interpolator::slice(table, tool_angle.degrees());
        let ends = match &self.ends {
            Some(EndTables { lower, upper, term }) => {
                Some(EndTables { lower: slice(lower)?, upper: slice(upper)?, term: slice(term)? })
            }
            None => None,
        };
        Ok(Box::new(BracketSlice {
            lower: slice(&self.lower)?,
            upper: slice(&self.upper)?,
            ends,
            width_ratio,
        }))
    }
}

struct BracketSlice<'a> {
    lower: TableSlice<'a>,
    upper: TableSlice<'a>,
    ends: Option<EndTables<TableSlice<'a>>>,
    width_ratio: WidthRatio,
}

impl ModelSlice for BracketSlice<'_> {
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError> {
        let look = |table: &TableSlice<'_>| table.lookup(phi_deg, delta_deg);
        let ((weight_lower, weight_upper), _) =
            bracket([&self.lower, &self.upper], self.ends.as_ref(), self.width_ratio, look)?;
        let ends_at_most = if self.ends.is_some() && self.width_ratio.finite().is_some() {
            (weight_upper - outwards(look(&self.upper)?, 1.0)).max(0.0)
        } else {
            0.0
        };
        let factors = LoadFactors { weight: (weight_lower * weight_upper).sqrt(), ..LoadFactors::default() };
        Ok(NetFactors { weight_lower, weight_upper, ends_at_most, factors })
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

#[cfg(test)]
mod tests {
    use super::super::bracket::tests::{RULES, square};
    use super::*;
    use crate::InPlaneStrain;

    fn model(with_ends: bool) -> BracketModel {
        let mut rows = square();
        for row in rows.iter_mut().filter(|_| with_ends) {
            row.ends_lower = Some(0.99 * row.lower);
            (row.ends_upper, row.ends_term) = (Some(1.05 * row.upper), Some(0.5 * row.upper));
        }
        BracketModel::of("t", "a test", &BracketTable::new("t", RULES, rows).unwrap()).unwrap()
    }

    /// The upper bound grows with depth over width from that of wide plates; the lower one stays, and so does plane strain.
    #[test]
    fn ends_raise_the_upper_bound_by_their_term() {
        let (plain, ended) = (model(false), model(true));
        assert!(ended.has_ends() && ended.is_for_plane_strain() && !plain.has_ends());
        let case = Case::level_deg(90.0, 40.0, 10.0);
        let plane = plain.predict(&case).unwrap();
        assert_eq!(ended.predict(&case).unwrap(), plane);
        for ratio in [0.5, 1.0, 5.0, 1e9] {
            let width_ratio = WidthRatio::new(ratio).unwrap();
            let case = case.with_width_ratio(width_ratio);
            let found = ended.predict(&case).unwrap();
            let upper = plane.net_upper.0 * (1.05 + 0.5 / ratio);
            let lower = 0.99 * plane.net_lower.0;
            assert!((found.net_upper.0 / upper - 1.0).abs() < 1e-12);
            assert!((found.net_lower.0 / lower - 1.0).abs() < 1e-12);
            let slice = ended.at(case.tool_angle, case.surface_slope, width_ratio).unwrap();
            assert!((slice.net(40.0, 10.0).unwrap().weight_upper / upper - 1.0).abs() < 1e-12);
            assert_eq!(plain.predict(&case).unwrap(), plane);
            assert_eq!(InPlaneStrain::of(Box::new(ended.clone())).predict(&case).unwrap(), plane);
        }
    }

    #[test]
    fn rows_without_ends_make_a_table_of_plane_strain() {
        let mut rows = square();
        (rows[0].ends_lower, rows[0].ends_upper, rows[0].ends_term) = (Some(2.0), Some(3.0), Some(1.0));
        let table = BracketTable::new("t", RULES, rows.clone()).unwrap();
        assert!(!BracketModel::of("t", "a test", &table).unwrap().has_ends());
        rows[0].ends_term = None;
        let message = BracketTable::new("t", RULES, rows).unwrap_err().to_string();
        assert!(message.contains("ends_term go together"), "{message}");
    }
}
