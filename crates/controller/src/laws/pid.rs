use crate::estimate::Estimate;
use crate::trajectory::Setpoint;
use crate::{Params, TICK_S};

/// Time in s in which an integral that rests fades to 1/e.
const FADE_S: f64 = 0.5;

/// Eq. 3.1 in joint space: proportional and damping on the motor encoders, which see no backlash and so allow a stiff loop;
/// proportional and integral on the external ones, which tell where the arm is.
///
/// `integral` holds torques in N m. It fades where it shall rest, and waits while the joint's torque is at its limit in the same direction.
pub(crate) fn joint_pid(
    params: &Params,
    wanted: &Setpoint,
    est: &Estimate,
    saturated: &[i8; 5],
    integral: &mut [f64; 5],
) -> [f64; 5] {
    let gains = &params.config().gains;
    std::array::from_fn(|i| {
        let motor_error = wanted.joints.0[i] - est.motor.0[i];
        let external_error = wanted.joints.0[i] - est.joints.0[i];
        let rate_error = wanted.rates.0[i] - est.rates.0[i];
        if wanted.rests {
            integral[i] -= integral[i] * TICK_S / FADE_S;
        } else {
            let rate = gains.external_i_nm_per_rad_s[i] * external_error;
            integrate(&mut integral[i], rate, saturated[i], gains.integral_limit_nm[i]);
        }
        gains.motor_p_nm_per_rad[i] * motor_error
            + gains.motor_d_nms_per_rad[i] * rate_error
            + gains.external_p_nm_per_rad[i] * external_error
            + integral[i]
    })
}

/// The integrals in N m with which [`joint_pid`] goes on from these torques without a jump, as far as their limits allow.
///
/// Motor and external angles differ by free play and stretch; a new wanted posture would else be a step of torque.
pub(crate) fn joint_integral(
    params: &Params,
    wanted: &Setpoint,
    est: &Estimate,
    torques_nm: &[f64; 5],
) -> [f64; 5] {
    let gains = &params.config().gains;
    std::array::from_fn(|i| {
        let proportional = gains.motor_p_nm_per_rad[i] * (wanted.joints.0[i] - est.motor.0[i])
            + gains.external_p_nm_per_rad[i] * (wanted.joints.0[i] - est.joints.0[i]);
        let limit = gains.integral_limit_nm[i];
        (torques_nm[i] - est.gravity.0[i] - proportional).max(-limit).min(limit)
    })
}

/// Velocity control: proportional-integral on the speed by the motor encoders.
pub(crate) fn velocity_pi(
    params: &Params,
    wanted: &Setpoint,
    est: &Estimate,
    saturated: &[i8; 5],
    integral: &mut [f64; 5],
) -> [f64; 5] {
    let gains = &params.config().gains;
    std::array::from_fn(|i| {
        let rate_error = wanted.rates.0[i] - est.rates.0[i];
        integrate(
            &mut integral[i],
            gains.velocity_i_nm_per_rad[i] * rate_error,
            saturated[i],
            gains.integral_limit_nm[i],
        );
        gains.velocity_p_nms_per_rad[i] * rate_error + integral[i]
    })
}

/// `rate` in N m/s.
fn integrate(integral: &mut f64, rate: f64, saturated: i8, limit: f64) {
    if rate * f64::from(saturated) <= 0.0 {
        let next = *integral + rate * TICK_S;
        // Not by `max` and `min`, which would make a limit of a NaN and hide it.
        *integral = if next > limit {
            limit
        } else if next < -limit {
            -limit
        } else {
            next
        };
    }
}
