//! A run of the solver for a page, on a thread of its own.

use std::panic::AssertUnwindSafe;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use soilctl_app::solve::Solved;
use soilctl_limit_analysis::Description;

use crate::answers::solved;
use crate::messages::{Spend, Told, Wrong};
use crate::watched::{Watched, request};

/// Most runs of all pages at a time.
const MOST_RUNS: usize = 2;

/// What a run has to say.
enum Said {
    Message(String),
    Found(Box<Solved>),
}

/// A run that may be stopped. It is stopped when this is dropped.
pub(crate) struct Run {
    stop: Arc<AtomicBool>,
    said: Receiver<Said>,
}

impl Run {
    /// Starts a run. `running` counts those of all pages.
    pub(crate) fn start(
        id: u64,
        description: Description,
        spend: Spend,
        running: &Arc<AtomicUsize>,
    ) -> Result<Self, Wrong> {
        if running.fetch_add(1, Ordering::SeqCst) >= MOST_RUNS {
            running.fetch_sub(1, Ordering::SeqCst);
            return Err(Wrong::words(format!(
                "{MOST_RUNS} problems are being solved already; stop one of them first"
            )));
        }
        let place = Place(Arc::clone(running));
        let stop = Arc::new(AtomicBool::new(false));
        let (say, said) = channel();
        let tell = say.clone();
        // A page that has gone needs no answer.
        let tell = Box::new(move |message| {
            let _ = tell.send(Said::Message(message));
        });
        let watch = Watched::new(id, Arc::clone(&stop), tell);
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get().min(1024)) as u32;
        let request = request(spend, threads);
        let work = move || {
            let _place = place;
            let ended =
                std::panic::catch_unwind(AssertUnwindSafe(|| solved(id, description, &request, &watch)));
            let words =
                "the solver broke off; this is a fault of the program. The problem is still on the page";
            let broken = || (Told::Failed { id, error: Wrong::words(words) }.text(), None);
            let (message, found) = ended.unwrap_or_else(|_| broken());
            // Before the message, after which the page may ask for it.
            if let Some(found) = found {
                let _ = say.send(Said::Found(found));
            }
            let _ = say.send(Said::Message(message));
        };
        let thread = std::thread::Builder::new().name("solve".to_owned()).spawn(work);
        thread.map_err(|problem| Wrong::words(format!("there is no thread for a run: {problem}")))?;
        Ok(Self { stop, said })
    }

    /// Asks it to end with the best bounds so far.
    pub(crate) fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// What there is to tell, and what was found; whether the run has ended.
    pub(crate) fn poll(&self, tell: &mut dyn FnMut(String), found: &mut Option<Box<Solved>>) -> bool {
        loop {
            match self.said.try_recv() {
                Ok(Said::Message(message)) => tell(message),
                Ok(Said::Found(solved)) => *found = Some(solved),
                Err(TryRecvError::Empty) => return false,
                Err(TryRecvError::Disconnected) => return true,
            }
        }
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        self.stop();
    }
}

/// A place among those who run.
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}
