use rustix::mm::{MlockAllFlags, mlockall};
use rustix::thread::{ClockId as SleepClock, clock_nanosleep_absolute};
use rustix::time::{ClockId, Timespec, clock_gettime};
use thread_priority::{
    RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy, set_thread_priority_and_policy,
    thread_native_id,
};

/// The monotonic clock.
#[allow(clippy::cast_sign_loss, reason = "the monotonic clock begins at 0")]
pub(crate) fn now_ns() -> u64 {
    let now = clock_gettime(ClockId::Monotonic);
    now.tv_sec as u64 * 1_000_000_000 + now.tv_nsec as u64
}

/// Sleeps to an instant of the monotonic clock.
pub(crate) fn sleep_until(deadline_ns: u64) {
    #[allow(clippy::cast_possible_wrap, reason = "292 years after the machine was started")]
    let deadline = Timespec {
        tv_sec: (deadline_ns / 1_000_000_000) as i64,
        tv_nsec: (deadline_ns % 1_000_000_000) as i64,
    };
    // A signal may wake it early.
    while now_ns() < deadline_ns && clock_nanosleep_absolute(SleepClock::Monotonic, &deadline).is_err() {}
}

/// Puts the calling thread under SCHED_FIFO, if that is permitted.
pub(crate) fn fifo(priority: u8) -> bool {
    let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    ThreadPriority::try_from(priority)
        .is_ok_and(|priority| set_thread_priority_and_policy(thread_native_id(), priority, policy).is_ok())
}

/// Keeps the memory of this process from being swapped out, if that is permitted.
pub(crate) fn lock_memory() -> bool {
    mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE).is_ok()
}
