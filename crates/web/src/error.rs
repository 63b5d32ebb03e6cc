use std::net::SocketAddr;

use thiserror::Error;

/// Why nothing can be served.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WebError {
    /// The address could not be listened at.
    #[error("{address} cannot be listened at: {reason}; give another address, or port 0 for any free port")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// The system gave no random bytes for a token or a nonce.
    #[error("the system gives no random numbers ({0}), so there can be no token")]
    Random(String),
    /// A thread could not be started.
    #[error("the server's thread could not be started: {0}; close some programs")]
    Thread(std::io::Error),
}
