//! Long work: without the interpreter's lock, on all cores, and Ctrl-C ends it.

use std::num::NonZero;

use pyo3::prelude::*;

use crate::array::place;
use crate::error::{Answer, Fail};

/// Elements between two looks at Ctrl-C.
const BLOCK: usize = 1 << 14;
/// Fewer elements than this are not worth another thread.
const SHARE: usize = 1 << 11;

/// `answer(i)` for all elements of a shape, in order; the first element that fails is named in the message.
///
/// Elements do not see each other, so the result is the same for any number of threads.
pub(crate) fn each<T, E>(
    py: Python<'_>,
    shape: &[usize],
    answer: impl Fn(usize) -> Result<T, E> + Sync,
) -> Answer<Vec<T>>
where
    T: Send,
    E: Send + std::fmt::Display + Into<Fail>,
{
    let mut all = Vec::with_capacity(shape.iter().product());
    in_blocks(py, shape, answer, |found| all.extend(found))?;
    Ok(all)
}

/// The same, handed over in short pieces that are still at hand, for those who keep only a part of each.
pub(crate) fn in_blocks<T, E>(
    py: Python<'_>,
    shape: &[usize],
    answer: impl Fn(usize) -> Result<T, E> + Sync,
    mut take: impl FnMut(Vec<T>),
) -> Answer<()>
where
    T: Send,
    E: Send + std::fmt::Display + Into<Fail>,
{
    let count: usize = shape.iter().product();
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get);
    for start in (0..count).step_by(BLOCK) {
        let end = count.min(start + BLOCK);
        let found = py.detach(|| block(start..end, threads, &answer));
        for part in found {
            take(part.map_err(|(index, problem)| named(py, problem, &place(index, shape)))?);
        }
        py.check_signals()?;
    }
    Ok(())
}

type Part<T, E> = Result<Vec<T>, (usize, E)>;

fn block<T: Send, E: Send>(
    range: std::ops::Range<usize>,
    threads: usize,
    answer: &(impl Fn(usize) -> Result<T, E> + Sync),
) -> Vec<Part<T, E>> {
    let run = |part: std::ops::Range<usize>| -> Part<T, E> {
        part.map(|index| answer(index).map_err(|problem| (index, problem))).collect()
    };
    let shares = (range.len() / SHARE).clamp(1, threads);
    if shares == 1 {
        return vec![run(range)];
    }
    let step = range.len().div_ceil(shares);
    std::thread::scope(|scope| {
        let parts = range.clone().step_by(step);
        let handles: Vec<_> =
            parts.map(|from| scope.spawn(move || run(from..range.end.min(from + step)))).collect();
        handles
            .into_iter()
            .map(|handle| handle.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

/// The same exception with the place in front of its message.
fn named<E: std::fmt::Display + Into<Fail>>(py: Python<'_>, problem: E, place: &str) -> Fail {
    let message = format!("{place}{problem}");
    let fail: Fail = problem.into();
    Fail(PyErr::from_type(fail.0.get_type(py), message))
}
