use crate::TICK_RATE_HZ;

/// Peak over mean speed of a minimum-jerk motion.
const PEAK: f64 = 1.875;

/// Position and speed (per unit of time) of the minimum-jerk motion from 0 to 1 at `t` in 0 to 1:
/// `10 t^3 - 15 t^4 + 6 t^5`. Speed and acceleration are zero at both ends.
pub(crate) fn minimum_jerk(t: f64) -> (f64, f64) {
    let t = t.clamp(0.0, 1.0);
    let square = t * t;
    (square * t * (10.0 + t * (6.0 * t - 15.0)), 30.0 * square * (1.0 - t) * (1.0 - t))
}

/// Ticks of a minimum-jerk motion of this length with this peak speed; at least 1.
pub(crate) fn ticks_for(length: f64, peak_speed: f64) -> u32 {
    let ticks = (PEAK * length / peak_speed * TICK_RATE_HZ).ceil();
    // More than a day of ticks is a mistake elsewhere; the cast saturates and NaN gives 0.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
    let ticks = ticks.clamp(1.0, 1e8) as u32;
    ticks.max(1)
}
