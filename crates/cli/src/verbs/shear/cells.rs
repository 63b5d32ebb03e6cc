//! Cells of the tables of `shear`.

use soilctl_app::text::four_digits;
use soilctl_soil::units::pa_to_psi;

/// Mark of an angle outside the stresses of its curve; room for it keeps columns straight.
pub(super) const EXTRAPOLATED: &str = "*";

/// A stress in psi and in kPa, a cell each.
pub(super) fn stress_cells(pa: f64) -> [String; 2] {
    [four_digits(pa_to_psi(pa)), four_digits(pa / 1000.0)]
}

/// An angle with its mark, or a dash.
pub(super) fn angle_cell(found: Option<(f64, bool)>) -> String {
    found.map_or_else(
        || "- ".into(),
        |(deg, extrapolated)| format!("{deg:.1}{}", if extrapolated { EXTRAPOLATED } else { " " }),
    )
}

/// Cells for a header whose columns end in a mark.
pub(super) fn header(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}
