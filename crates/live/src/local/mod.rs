//! Where programs of one machine meet: at a path. This is the only place that knows what lies there.
//!
//! On Unix it is a socket for its owner alone. Elsewhere it is a file that says at which port of the loopback address the program
//! listens, and a token without which nobody is let in: who may read the file may speak.

// Its tests run on Unix as well, where nothing is made public of it.
#[cfg(any(not(unix), test))]
#[cfg_attr(unix, allow(unreachable_pub))]
mod loopback;
#[cfg(unix)]
mod unix;

#[cfg(not(unix))]
pub use loopback::{Listener, Stream, bind, connect};
#[cfg(unix)]
pub use unix::{Listener, Stream, bind, connect};
