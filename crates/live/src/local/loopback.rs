use std::io::{ErrorKind, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::Path;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use crate::LiveError;

/// A connection.
pub type Stream = TcpStream;

/// Bytes of a token, which is written in hexadecimal digits.
const TOKEN_BYTES: usize = 16;
/// How long one who connects has to give the token.
const PATIENCE: Duration = Duration::from_secs(2);
/// Most that may be without a token at a time; others wait for the system to let them in.
const MOST_STRANGERS: usize = 16;
/// How long a program sleeps between two looks at who has connected.
const NAP: Duration = Duration::from_millis(3);
/// Longest file that is believed to be an address.
const MOST_FILE_BYTES: u64 = 4096;

/// What is written at the path, as JSON.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Address {
    soilctl_address: SocketAddr,
    /// The first line that one who connects sends.
    token: String,
}

/// Takes those who connect to a path and know its token.
#[derive(Debug)]
pub struct Listener {
    listener: TcpListener,
    token: String,
    strangers: Vec<Stranger>,
}

/// One who has connected and not given the whole token yet.
#[derive(Debug)]
struct Stranger {
    stream: TcpStream,
    said: Vec<u8>,
    since: Instant,
}

enum Heard {
    Token,
    NotYet,
    Nonsense,
}

/// Listens on a port of the loopback address, and says in a file at `path` on which. A file whose program is gone is replaced.
///
/// # Errors
/// [`LiveError::Taken`] or [`LiveError::Socket`].
pub fn bind(path: &Path) -> Result<Listener, LiveError> {
    let failed = |error: std::io::Error| LiveError::socket(path, &error);
    let taken = |by| LiveError::Taken { path: path.to_owned(), by };
    match path.symlink_metadata() {
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        Err(error) => return Err(failed(error)),
        Ok(_) => match read(path) {
            Err(_) => return Err(taken("it is no address of a session or a driver")),
            Ok(address) => match TcpStream::connect_timeout(&address.soilctl_address, PATIENCE) {
                Ok(_) => return Err(taken("another program listens there")),
                Err(_) => std::fs::remove_file(path).map_err(failed)?,
            },
        },
    }
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).map_err(failed)?;
    listener.set_nonblocking(true).map_err(failed)?;
    let address =
        Address { soilctl_address: listener.local_addr().map_err(failed)?, token: token().map_err(failed)? };
    let text = serde_json::to_string(&address).map_err(|error| failed(error.into()))?;
    // Never over a file that came in between.
    let mut file = std::fs::File::create_new(path).map_err(failed)?;
    file.write_all((text + "\n").as_bytes()).map_err(failed)?;
    Ok(Listener { listener, token: address.token, strangers: Vec::new() })
}

/// Connects to who listens where the file at `path` says, and gives the token.
///
/// # Errors
/// The system's, if nobody listens there; [`ErrorKind::InvalidData`] for a file that is no address on this machine.
pub fn connect(path: &Path) -> std::io::Result<Stream> {
    let address = read(path)?;
    if !address.soilctl_address.ip().is_loopback() {
        return Err(std::io::Error::new(ErrorKind::InvalidData, "the file names another machine"));
    }
    let mut stream = TcpStream::connect_timeout(&address.soilctl_address, PATIENCE)?;
    stream.set_nodelay(true)?;
    stream.write_all(format!("{}\n", address.token).as_bytes())?;
    Ok(stream)
}

fn read(path: &Path) -> std::io::Result<Address> {
    let mut text = String::new();
    std::fs::File::open(path)?.take(MOST_FILE_BYTES).read_to_string(&mut text)?;
    Ok(serde_json::from_str(&text)?)
}

fn token() -> std::io::Result<String> {
    let mut bytes = [0; TOKEN_BYTES];
    getrandom::fill(&mut bytes).map_err(std::io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

impl Listener {
    /// The next who connects; waits for one.
    ///
    /// # Errors
    /// The system's.
    pub fn accept(&mut self) -> std::io::Result<Stream> {
        loop {
            if let Some(stream) = self.poll() {
                stream.set_nonblocking(false)?;
                return Ok(stream);
            }
            std::thread::sleep(NAP);
        }
    }

    /// The next who has connected and given the token, or none.
    pub fn poll(&mut self) -> Option<Stream> {
        while self.strangers.len() < MOST_STRANGERS
            && let Ok((stream, _)) = self.listener.accept()
        {
            if stream.set_nonblocking(true).is_ok() && stream.set_nodelay(true).is_ok() {
                self.strangers.push(Stranger { stream, said: Vec::new(), since: Instant::now() });
            }
        }
        let token = self.token.as_bytes();
        let mut at = 0;
        while let Some(stranger) = self.strangers.get_mut(at) {
            match stranger.hear(token) {
                Heard::Token => return Some(self.strangers.remove(at).stream),
                Heard::NotYet => at += 1,
                Heard::Nonsense => drop(self.strangers.remove(at)),
            }
        }
        None
    }
}

impl Stranger {
    /// Reads no further than the token, so that what follows is there for who uses the connection.
    fn hear(&mut self, token: &[u8]) -> Heard {
        let mut bytes = [0; 2 * TOKEN_BYTES + 1];
        let Some(room) = bytes.get_mut(self.said.len()..) else { return Heard::Nonsense };
        match self.stream.read(room) {
            Ok(0) => return Heard::Nonsense,
            Ok(count) => self.said.extend_from_slice(room.get(..count).unwrap_or_default()),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {}
            Err(_) => return Heard::Nonsense,
        }
        if self.said.len() < bytes.len() {
            return if self.since.elapsed() > PATIENCE { Heard::Nonsense } else { Heard::NotYet };
        }
        // All bytes are looked at, so that the time tells nothing of the token.
        let expected = token.iter().chain(b"\n");
        let other = expected.zip(&self.said).fold(0, |other, (a, b)| other | (a ^ b));
        if other == 0 { Heard::Token } else { Heard::Nonsense }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn soon(listener: &mut Listener) -> Option<Stream> {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(1) {
            if let Some(stream) = listener.poll() {
                return Some(stream);
            }
            std::thread::sleep(NAP);
        }
        None
    }

    #[test]
    fn who_reads_the_file_is_let_in_and_loses_no_byte() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("s");
        let mut listener = bind(&path).unwrap();
        let mut client = connect(&path).unwrap();
        client.write_all(b"hello").unwrap();
        let mut server = listener.accept().unwrap();
        let mut bytes = [0; 5];
        server.read_exact(&mut bytes).unwrap();
        assert_eq!(&bytes, b"hello");
        server.write_all(b"there").unwrap();
        client.read_exact(&mut bytes).unwrap();
        assert_eq!(&bytes, b"there");
    }

    #[test]
    fn without_the_token_nobody_is_let_in_and_others_are_not_kept_waiting() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("s");
        let mut listener = bind(&path).unwrap();
        let address = read(&path).unwrap();
        let mut wrong = TcpStream::connect(address.soilctl_address).unwrap();
        wrong.write_all(&[b'0'; 2 * TOKEN_BYTES + 1]).unwrap();
        let _silent = TcpStream::connect(address.soilctl_address).unwrap();
        assert!(listener.poll().is_none());
        let _right = connect(&path).unwrap();
        assert!(soon(&mut listener).is_some());
        assert!(listener.poll().is_none());
        wrong.set_read_timeout(Some(Duration::from_secs(1))).unwrap();
        assert!(matches!(wrong.read(&mut [0; 1]), Ok(0) | Err(_)), "hung up");
    }

    #[test]
    fn only_a_file_whose_program_is_gone_is_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("s");
        let first = bind(&path).unwrap();
        assert!(matches!(bind(&path), Err(LiveError::Taken { .. })));
        drop(first);
        assert!(connect(&path).is_err());
        drop(bind(&path).unwrap());
        let file = dir.path().join("f");
        std::fs::write(&file, "x").unwrap();
        assert!(matches!(bind(&file), Err(LiveError::Taken { .. })));
        assert!(matches!(bind(&dir.path().join("none/s")), Err(LiveError::Socket { .. })));
        let other = r#"{"soilctl_address":"192.0.2.1:9","token":"00"}"#;
        std::fs::write(&file, other).unwrap();
        assert!(connect(&file).unwrap_err().to_string().contains("another machine"));
    }
}
