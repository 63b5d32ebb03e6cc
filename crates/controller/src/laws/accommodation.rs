/// What of a force lies beyond a dead-zone: 0 inside, the rest outside. Force and zone in N.
#[must_use]
pub fn beyond_dead_zone(force_n: f64, dead_zone_n: f64) -> f64 {
    if force_n > dead_zone_n {
        force_n - dead_zone_n
    } else if force_n < -dead_zone_n {
        force_n + dead_zone_n
    } else {
        0.0
    }
}

/// Speed in m/s with which the plate gives way along its normal, `r' = k_F F_n` (first row of eq. 5.1, `theta_4` being
/// held), at most `most_m_s`.
///
/// `normal_force_n` is the soil's force on the plate along the sensor's z axis. In the base frame the speed has the parts
/// `r = cos theta' r'`, `z = -sin theta' r'` with `theta' = n1 - pi` (eq. 5.2; erratum: its second column is dropped,
/// because theta' is held).
#[must_use]
pub fn accommodation_speed(normal_force_n: f64, dead_zone_n: f64, gain_m_s_per_n: f64, most_m_s: f64) -> f64 {
    (gain_m_s_per_n * beyond_dead_zone(normal_force_n, dead_zone_n)).max(-most_m_s).min(most_m_s)
}
