//! What a thread asks of the system to keep time: the only place that knows how systems differ in it.
//!
//! Linux has absolute deadlines, real-time priorities and locked memory. Elsewhere a session keeps time as well as a plain sleep does,
//! and says so in its [`Timing`](crate::Timing).

#[cfg(target_os = "linux")]
mod linux;
#[cfg(any(not(target_os = "linux"), test))]
#[cfg_attr(target_os = "linux", allow(dead_code))]
mod plain;

#[cfg(target_os = "linux")]
pub(crate) use linux::{fifo, lock_memory, now_ns, sleep_until};
#[cfg(not(target_os = "linux"))]
pub(crate) use plain::{fifo, lock_memory, now_ns, sleep_until};

/// Priority of the servo thread: below threads of the kernel's interrupts.
pub(crate) const SERVO_PRIORITY: u8 = 40;
/// Priority of the server thread, through which the emergency stop and the heartbeat come.
pub(crate) const SERVER_PRIORITY: u8 = 10;

/// Whether a thread of this process may have real-time priority, as `run --real-time` asks for.
#[must_use]
pub fn may_run_in_real_time() -> bool {
    std::thread::spawn(|| fifo(SERVER_PRIORITY)).join().unwrap_or(false)
}
