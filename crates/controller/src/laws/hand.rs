//! Parts of the law by which the plate's edge follows a hand. Velocities and ways go along the radius, along the tangent and upwards.

/// Gain in 1/s with which the rest of a way is gone when it is short: the speed then fades without an end.
const APPROACH_PER_S: f64 = 20.0;
/// Share of the acceleration that braking reckons with, so that what is left turns the motion.
const BRAKING_SHARE: f64 = 0.8;
/// Share of a load from which on pushing becomes slower; at the whole of it there is none.
const KNEE: f64 = 0.5;
/// Fastest giving way, as a share of the speed.
const RETREAT_SHARE: f64 = 0.5;

/// Speed at which to go a way that is left, so that it can end at rest without more than this acceleration: units of the
/// way a second, from the way, the most speed and the most acceleration. A way that is no number gives none.
pub(crate) fn approach_speed(way: f64, most_speed: f64, most_acceleration: f64) -> f64 {
    let way = if way > 0.0 { way } else { 0.0 };
    let braking = libm::sqrt(2.0 * BRAKING_SHARE * most_acceleration * way);
    (APPROACH_PER_S * way).min(braking).min(most_speed)
}

/// The velocity with which to go a way, in m/s.
pub(crate) fn approach(way_m: [f64; 3], most_m_s: f64, most_m_s2: f64) -> [f64; 3] {
    let length = length(way_m);
    let speed = approach_speed(length, most_m_s, most_m_s2);
    if length > 0.0 { way_m.map(|part| part / length * speed) } else { [0.0; 3] }
}

/// Takes from a velocity what pushes harder than a load allows. `away` is the direction in which the load pushes back, a unit
/// vector; `share` the load over what is allowed. Up to half of that nothing changes; then pushing gets slower, at the whole
/// it ends, and above it the edge gives way. Says whether pushing was held back for good.
pub(crate) fn give_way(velocity: [f64; 3], away: [f64; 3], share: f64, most_m_s: f64) -> ([f64; 3], bool) {
    if share.is_nan() || share <= KNEE {
        return (velocity, false);
    }
    let push = -(0..3).map(|i| velocity[i] * away[i]).sum::<f64>();
    let allowed = (most_m_s * (1.0 - share) / (1.0 - KNEE)).max(-RETREAT_SHARE * most_m_s);
    if push <= allowed {
        return (velocity, false);
    }
    let less = push - allowed;
    (std::array::from_fn(|i| velocity[i] + less * away[i]), share >= 0.9)
}

/// The velocity after a time in which it may change by so much.
pub(crate) fn bounded_change(from: [f64; 3], to: [f64; 3], most: f64) -> [f64; 3] {
    let change: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let size = length(change);
    if size <= most {
        return to;
    }
    std::array::from_fn(|i| from[i] + change[i] / size * most)
}

/// Length of a vector.
pub(crate) fn length([x, y, z]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A way that is gone with this speed ends at rest where it should, and its braking never asks for more than the acceleration.
    #[test]
    fn a_way_ends_at_rest_within_the_acceleration() {
        let (dt, most, acceleration) = (0.002, 0.08, 1.0);
        let (mut left, mut speed) = (0.1, 0.0_f64);
        for _ in 0..5000 {
            let wanted = approach_speed(left, most, acceleration);
            let next = speed + (wanted - speed).clamp(-acceleration * dt, acceleration * dt);
            assert!(next <= most && (next - speed).abs() <= acceleration * dt + 1e-15);
            assert!((wanted - next).abs() < 0.01 || wanted > next, "it brakes too late: {wanted} {next}");
            speed = next;
            left -= speed * dt;
            assert!(left > -1e-4, "it goes too far");
        }
        assert!(left.abs() < 1e-6 && speed < 1e-5, "{left} {speed}");
    }

    proptest! {
        /// Whatever is wanted: no more pushing than allowed, nothing across the load is changed, and no load changes nothing.
        #[test]
        fn giving_way(velocity in prop::array::uniform3(-0.1..0.1_f64), away in prop::array::uniform3(-1.0..1.0_f64), share in 0.0..3.0_f64) {
            let size = length(away);
            prop_assume!(size > 0.1);
            let away = away.map(|part| part / size);
            let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
            let (left, held) = give_way(velocity, away, share, 0.08);
            let push = -dot(left, away);
            if share <= KNEE {
                prop_assert_eq!(left, velocity);
            } else {
                let most = 0.08 * (1.0 - share) / 0.5;
                prop_assert!(push <= most.max(-0.04) + 1e-12);
                let across = |v: [f64; 3]| { let along = dot(v, away); [0, 1, 2].map(|i| v[i] - along * away[i]) };
                let change = [0, 1, 2].map(|i| across(left)[i] - across(velocity)[i]);
                prop_assert!(length(change) < 1e-12);
            }
            prop_assert!(!held || share >= 0.9);
        }

        #[test]
        fn changes_are_bounded(from in prop::array::uniform3(-1.0..1.0_f64), to in prop::array::uniform3(-1.0..1.0_f64), most in 1e-6..1.0_f64) {
            let after = bounded_change(from, to, most);
            let change = [0, 1, 2].map(|i| after[i] - from[i]);
            prop_assert!(length(change) <= most * (1.0 + 1e-12));
        }
    }
}
