use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

use crate::JobsError;

/// Does pieces of work on so many threads, in the order given, and hands each result to `done` in the calling thread as soon as
/// it is there. `work` says `None` if it was stopped before its end.
///
/// The first failure, of `work` or `done`, sets `stop`, which ends the others; what they still hand over is not lost.
///
/// # Errors
/// That first failure; [`JobsError::Thread`] if no thread could be started or one ended unexpectedly.
pub fn each<T: Sync, R: Send, E: Send + From<JobsError>>(
    todo: &[T],
    threads: usize,
    stop: &AtomicBool,
    work: impl Fn(&T) -> Result<Option<R>, E> + Sync,
    mut done: impl FnMut(&T, R) -> Result<(), E>,
) -> Result<(), E> {
    if cfg!(target_family = "wasm") {
        // In browsers there are no threads to be had.
        return alone(todo, stop, work, done);
    }
    let next = AtomicUsize::new(0);
    let (work, next) = (&work, &next);
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        let mut team = Vec::new();
        for _ in 0..threads.max(1).min(todo.len()) {
            let sender = sender.clone();
            let worker = move || {
                while !stop.load(Ordering::Relaxed)
                    && let Some(piece) = todo.get(next.fetch_add(1, Ordering::Relaxed))
                    && let Some(result) = work(piece).transpose()
                {
                    if result.is_err() {
                        stop.store(true, Ordering::Relaxed);
                    }
                    if sender.send((piece, result)).is_err() {
                        break;
                    }
                }
            };
            match std::thread::Builder::new().spawn_scoped(scope, worker) {
                Ok(member) => team.push(member),
                Err(problem) if team.is_empty() => {
                    return Err(JobsError::Thread(format!("could not be started: {problem}")).into());
                }
                // Fewer do the same work.
                Err(_) => break,
            }
        }
        drop(sender);
        let mut result = Ok(());
        for (piece, found) in receiver {
            if let Err(problem) = found.and_then(|found| done(piece, found)) {
                stop.store(true, Ordering::Relaxed);
                result = result.and(Err(problem));
            }
        }
        for member in team {
            if member.join().is_err() {
                result = result.and(Err(JobsError::Thread("ended unexpectedly".into()).into()));
            }
        }
        result
    })
}

/// The same in the calling thread.
fn alone<T, R, E>(
    todo: &[T],
    stop: &AtomicBool,
    work: impl Fn(&T) -> Result<Option<R>, E>,
    mut done: impl FnMut(&T, R) -> Result<(), E>,
) -> Result<(), E> {
    for piece in todo {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let ended = work(piece).and_then(|found| found.map(|found| done(piece, found)).transpose());
        match ended {
            Ok(Some(())) => {}
            Ok(None) => break,
            Err(problem) => {
                stop.store(true, Ordering::Relaxed);
                return Err(problem);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn squares(threads: usize, bad: Option<u32>) -> (Result<(), JobsError>, Vec<u32>, bool) {
        let (stop, mut found) = (AtomicBool::new(false), Vec::new());
        let todo: Vec<u32> = (0..200).collect();
        let work = |n: &u32| match bad {
            Some(bad) if bad == *n => Err(JobsError::Shard),
            _ => Ok(Some(n * n)),
        };
        let result = each(&todo, threads, &stop, work, |_, square| {
            found.push(square);
            Ok(())
        });
        found.sort_unstable();
        (result, found, stop.into_inner())
    }

    #[test]
    fn every_piece_is_done_once_however_many_threads_there_are() {
        for threads in [0, 1, 3, 1000] {
            let (result, found, stopped) = squares(threads, None);
            assert!(result.is_ok() && !stopped);
            assert_eq!(found, (0..200).map(|n| n * n).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_failure_ends_the_others_and_keeps_what_was_done() {
        let (result, found, stopped) = squares(1, Some(50));
        assert!(matches!(result, Err(JobsError::Shard)) && stopped);
        assert_eq!(found.len(), 50);
    }

    #[test]
    fn a_panic_is_an_error() {
        let work = |n: &u32| if *n == 2 { std::panic::resume_unwind(Box::new(())) } else { Ok(Some(())) };
        let result: Result<(), JobsError> =
            each(&[1, 2, 3], 1, &AtomicBool::new(false), work, |_, ()| Ok(()));
        assert!(result.unwrap_err().to_string().contains("ended unexpectedly"));
    }
}
