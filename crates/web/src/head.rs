use std::io::{ErrorKind, Read};
use std::time::{Duration, Instant};

/// Most bytes of a request's head.
const MOST_BYTES: usize = 8 << 10;
/// Most header fields.
const MOST_FIELDS: usize = 64;
/// How long a head may take.
const PATIENCE: Duration = Duration::from_secs(5);

/// The head of a request.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Head {
    pub(crate) method: String,
    pub(crate) path: String,
    /// Names in small letters.
    fields: Vec<(String, String)>,
    /// Bytes that came after it.
    pub(crate) rest: Vec<u8>,
}

/// Why there is no head: the status to answer with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bad {
    /// The other side went away.
    Gone,
    /// 408
    TooSlow,
    /// 431
    TooLarge,
    /// 400
    Malformed,
}

impl Head {
    /// Reads until the head is complete. The stream's own time-out decides how often the clock is looked at.
    pub(crate) fn read(stream: &mut dyn Read) -> Result<Self, Bad> {
        let (mut bytes, begin) = (Vec::new(), Instant::now());
        loop {
            if let Some(head) = Self::parse(&bytes)? {
                return Ok(head);
            }
            if bytes.len() >= MOST_BYTES {
                return Err(Bad::TooLarge);
            }
            if begin.elapsed() > PATIENCE {
                // Browsers open connections that they may never use.
                return Err(if bytes.is_empty() { Bad::Gone } else { Bad::TooSlow });
            }
            let mut more = [0; 2048];
            match stream.read(&mut more) {
                Ok(0) => return Err(Bad::Gone),
                Ok(count) => bytes.extend_from_slice(more.get(..count).unwrap_or_default()),
                Err(error) => match error.kind() {
                    ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted => {}
                    _ => return Err(Bad::Gone),
                },
            }
        }
    }

    /// The head in some bytes; none if it is not complete.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, Bad> {
        let mut fields = [httparse::EMPTY_HEADER; MOST_FIELDS];
        let mut request = httparse::Request::new(&mut fields);
        let length = match request.parse(bytes) {
            Ok(httparse::Status::Complete(length)) => length,
            Ok(httparse::Status::Partial) => return Ok(None),
            Err(httparse::Error::TooManyHeaders) => return Err(Bad::TooLarge),
            Err(_) => return Err(Bad::Malformed),
        };
        let mut head = Self {
            method: request.method.unwrap_or_default().to_owned(),
            path: request.path.unwrap_or_default().split('?').next().unwrap_or_default().to_owned(),
            fields: Vec::new(),
            rest: bytes.get(length..).unwrap_or_default().to_vec(),
        };
        for field in request.headers.iter() {
            let value = std::str::from_utf8(field.value).map_err(|_| Bad::Malformed)?;
            head.fields.push((field.name.to_ascii_lowercase(), value.trim().to_owned()));
        }
        Ok(Some(head))
    }

    /// The value of a field, if it is there once; a field that is there twice counts as malformed.
    pub(crate) fn field(&self, name: &str) -> Result<Option<&str>, Bad> {
        let mut values =
            self.fields.iter().filter(|(field, _)| field == name).map(|(_, value)| value.as_str());
        match (values.next(), values.next()) {
            (_, Some(_)) => Err(Bad::Malformed),
            (value, None) => Ok(value),
        }
    }

    /// Whether a field's list holds a word, in any letters.
    pub(crate) fn has(&self, name: &str, word: &str) -> bool {
        self.fields
            .iter()
            .filter(|(field, _)| field == name)
            .flat_map(|(_, value)| value.split(','))
            .any(|item| item.trim().eq_ignore_ascii_case(word))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_in_pieces() {
        let text = b"GET /live?x=1 HTTP/1.1\r\nHost: a:1\r\nConnection: keep-alive, Upgrade\r\n\r\nrest";
        let mut pieces = text.chunks(7).collect::<std::collections::VecDeque<_>>();
        struct Slow<'a, 'b>(&'a mut std::collections::VecDeque<&'b [u8]>);
        impl Read for Slow<'_, '_> {
            fn read(&mut self, room: &mut [u8]) -> std::io::Result<usize> {
                let piece = self.0.pop_front().unwrap_or_default();
                room[..piece.len()].copy_from_slice(piece);
                Ok(piece.len())
            }
        }
        let head = Head::read(&mut Slow(&mut pieces)).unwrap();
        assert_eq!((head.method.as_str(), head.path.as_str()), ("GET", "/live"));
        assert_eq!(head.field("host"), Ok(Some("a:1")));
        assert!(head.has("connection", "upgrade") && !head.has("connection", "close"));
    }

    #[test]
    fn what_is_no_head_is_refused() {
        assert_eq!(Head::read(&mut &b"\x16\x03\x01 what\r\n\r\n"[..]), Err(Bad::Malformed));
        assert_eq!(Head::read(&mut &b"GET / HTTP/1.1\r\nHost: a"[..]), Err(Bad::Gone));
        let long = format!("GET / HTTP/1.1\r\nX: {}", "x".repeat(20_000));
        assert_eq!(Head::read(&mut long.as_bytes()), Err(Bad::TooLarge));
        let twice = b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n";
        assert_eq!(Head::read(&mut &twice[..]).unwrap().field("host"), Err(Bad::Malformed));
    }
}
