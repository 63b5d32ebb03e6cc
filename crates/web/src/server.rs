use std::io::ErrorKind;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use tungstenite::handshake::derive_accept_key;
use tungstenite::protocol::{Role, WebSocket};

use crate::guard::is_own_origin;
use crate::head::{Bad, Head};
use crate::response::{answer, words};
use crate::serving::Shared;
use crate::socket;

/// Most connections at a time.
const MOST_CONNECTIONS: usize = 64;
/// How long a read or write waits: so often everybody looks around.
const TURN: Duration = Duration::from_millis(8);
/// Between two looks for a new connection.
const NAP: Duration = Duration::from_millis(5);
/// Where the WebSocket is.
const SOCKET_PATH: &str = "/socket";

/// Accepts connections.
pub(crate) struct Server {
    pub(crate) listener: TcpListener,
    pub(crate) shared: Arc<Shared>,
}

impl Server {
    /// Serves until it is told to stop, and every page has gone.
    pub(crate) fn run(self) {
        while !self.shared.stop.load(Ordering::Relaxed) {
            match self.listener.accept() {
                Ok((stream, peer)) => self.begin(stream, peer),
                Err(_) => std::thread::sleep(NAP),
            }
        }
        drop(self.listener);
        for _ in 0..200 {
            if self.shared.open.load(Ordering::Relaxed) == 0 {
                break;
            }
            std::thread::sleep(NAP);
        }
    }

    fn begin(&self, mut stream: TcpStream, peer: SocketAddr) {
        let ready = stream
            .set_nonblocking(false)
            .and_then(|()| stream.set_read_timeout(Some(TURN)))
            .and_then(|()| stream.set_write_timeout(Some(Duration::from_secs(2))))
            .and_then(|()| stream.set_nodelay(true));
        if ready.is_err() {
            return;
        }
        if self.shared.open.load(Ordering::Relaxed) >= MOST_CONNECTIONS {
            self.shared.refuse(peer, "too many connections");
            let _ = words(&mut stream, "503 Service Unavailable", "too many connections; close some pages");
            return;
        }
        let shared = Arc::clone(&self.shared);
        shared.open.fetch_add(1, Ordering::Relaxed);
        let serve = move || {
            // The count goes down whatever happens.
            let open = Open(shared);
            connection(stream, peer, &open.0);
        };
        if std::thread::Builder::new().name("page".to_owned()).spawn(serve).is_err() {
            self.shared.note("there is no thread left for a page");
        }
    }
}

struct Open(Arc<Shared>);

impl Drop for Open {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}

fn connection(mut stream: TcpStream, peer: SocketAddr, shared: &Shared) {
    let refuse = |stream: &mut TcpStream, status: &str, what: &str| {
        shared.refuse(peer, what);
        let _ = words(stream, status, what);
    };
    let head = match Head::read(&mut stream) {
        Ok(head) => head,
        Err(Bad::Gone) => return,
        Err(Bad::TooSlow) => {
            return refuse(&mut stream, "408 Request Timeout", "the request came too slowly");
        }
        Err(Bad::TooLarge) => {
            return refuse(&mut stream, "431 Request Header Fields Too Large", "the request is too large");
        }
        Err(Bad::Malformed) => return refuse(&mut stream, "400 Bad Request", "the request is malformed"),
    };
    let (Ok(host), Ok(origin)) = (head.field("host"), head.field("origin")) else {
        return refuse(&mut stream, "400 Bad Request", "the request has two hosts or origins");
    };
    let host = host.unwrap_or_default();
    if !shared.guard.allows_host(host) {
        let what = format!("the host `{host}` is not served here; give --host if it should be");
        return refuse(&mut stream, "421 Misdirected Request", &what);
    }
    if !is_own_origin(origin, host) {
        let what =
            format!("pages from `{}` may not use this {}", origin.unwrap_or_default(), shared.site.name());
        return refuse(&mut stream, "403 Forbidden", &what);
    }
    let served = match (head.method.as_str(), head.path.as_str()) {
        ("GET", SOCKET_PATH) => return upgrade(stream, peer, &head, shared),
        ("GET" | "HEAD", path) => send(&mut stream, path, head.method == "GET", shared),
        (method, _) => {
            let what = format!("the method {method} is not served here");
            return refuse(&mut stream, "405 Method Not Allowed", &what);
        }
    };
    if let Err(error) = served
        && error.kind() != ErrorKind::BrokenPipe
    {
        shared.refuse(peer, &format!("it did not take its answer: {error}"));
    }
}

fn send(stream: &mut TcpStream, path: &str, with_content: bool, shared: &Shared) -> std::io::Result<()> {
    match shared.site.at(path) {
        Ok(Some(found)) => {
            let mut fields = vec![("Content-Type", found.kind)];
            fields.extend(found.policy.as_deref().map(|policy| ("Content-Security-Policy", policy)));
            answer(stream, "200 OK", &fields, &found.bytes, with_content)
        }
        Ok(None) => words(stream, "404 Not Found", &format!("there is nothing at {path}; the page is at /")),
        Err(problem) => words(stream, "500 Internal Server Error", &problem.to_string()),
    }
}

fn upgrade(mut stream: TcpStream, peer: SocketAddr, head: &Head, shared: &Shared) {
    let key = head.field("sec-websocket-key").ok().flatten();
    let version = head.field("sec-websocket-version").ok().flatten();
    let (true, true, Some(key), Some("13")) =
        (head.has("upgrade", "websocket"), head.has("connection", "upgrade"), key, version)
    else {
        shared.refuse(peer, "this is no WebSocket of version 13");
        let fields = [("Sec-WebSocket-Version", "13")];
        let _ = answer(&mut stream, "426 Upgrade Required", &fields, b"", true);
        return;
    };
    let accept = derive_accept_key(key.as_bytes());
    let head_back = format!(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: {accept}\r\n\r\n"
    );
    if std::io::Write::write_all(&mut stream, head_back.as_bytes()).is_err()
        || stream.set_write_timeout(Some(TURN)).is_err()
    {
        return;
    }
    match shared.site.feed() {
        Ok(feed) => {
            shared.pages.fetch_add(1, Ordering::Relaxed);
            let config = Some(socket::config(shared.site.most_message_bytes()));
            let socket = WebSocket::from_partially_read(stream, head.rest.clone(), Role::Server, config);
            socket::Page::new(socket, feed, peer, shared).run();
        }
        Err(problem) => shared.refuse(peer, &problem),
    }
}
