//! Unit conversion at the edge: exact definitions (NIST SP 811), nothing measured.

/// One inch in m.
const INCH_M: f64 = 0.0254;
/// One pound-force in N.
const LBF_N: f64 = 4.448_221_615_260_5;

/// Inches to metres.
#[must_use]
pub fn inches_to_m(inches: f64) -> f64 {
    inches * INCH_M
}

/// Metres to inches.
#[must_use]
pub fn m_to_inches(metres: f64) -> f64 {
    metres / INCH_M
}

/// Pounds-force to newtons.
#[must_use]
pub fn lbf_to_n(lbf: f64) -> f64 {
    lbf * LBF_N
}

/// Newtons to pounds-force.
#[must_use]
pub fn n_to_lbf(newtons: f64) -> f64 {
    newtons / LBF_N
}

/// Pounds-force per square inch to pascals.
#[must_use]
pub fn psi_to_pa(psi: f64) -> f64 {
    psi * (LBF_N / (INCH_M * INCH_M))
}

/// Pascals to pounds-force per square inch.
#[must_use]
pub fn pa_to_psi(pascals: f64) -> f64 {
    pascals / (LBF_N / (INCH_M * INCH_M))
}

/// Grams per cubic centimetre to kilograms per cubic metre.
#[must_use]
pub fn g_cc_to_kg_m3(g_cc: f64) -> f64 {
    g_cc * 1000.0
}

/// Kilograms per cubic metre to grams per cubic centimetre.
#[must_use]
pub fn kg_m3_to_g_cc(kg_m3: f64) -> f64 {
    kg_m3 / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_values() {
        // NIST SP 811, appendix B.8: 1 psi = 6.894 757 kPa, 1 lbf = 4.448 222 N.
        assert!((psi_to_pa(1.0) - 6_894.757).abs() < 5e-4);
        assert!((n_to_lbf(4.448_222) - 1.0).abs() < 1e-6);
        assert!((m_to_inches(inches_to_m(3.0)) - 3.0).abs() < 1e-15 * 4.0);
    }
}
