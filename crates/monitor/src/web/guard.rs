use std::net::{IpAddr, SocketAddr};

/// Which hosts and origins are ours. A page of a foreign site reaches a loopback address, too: by its own name made to
/// point there (then `Host` tells), or from its own page (then `Origin` tells).
#[derive(Debug, Clone)]
pub(crate) struct Guard {
    address: SocketAddr,
    /// Further names by which this machine is known.
    names: Vec<String>,
}

impl Guard {
    pub(crate) fn new(address: SocketAddr, names: Vec<String>) -> Self {
        Self { address, names }
    }

    /// Whether a `Host` field is ours.
    pub(super) fn allows_host(&self, host: &str) -> bool {
        let (name, port) = split(host);
        let address = self.address.ip();
        let known = match name.trim_matches(['[', ']']).parse::<IpAddr>() {
            // An address, unlike a name, cannot be made to point elsewhere.
            Ok(given) if address.is_unspecified() => !given.is_unspecified(),
            Ok(given) => given == address || (given.is_loopback() && address.is_loopback()),
            Err(_) => {
                (name.eq_ignore_ascii_case("localhost")
                    && (address.is_loopback() || address.is_unspecified()))
                    || self.names.iter().any(|known| known.eq_ignore_ascii_case(name))
            }
        };
        known && port.unwrap_or(80) == self.address.port()
    }

    /// Whether an `Origin` field is ours. Programs that are no browsers send none, and are no danger: nobody lures them.
    pub(super) fn allows_origin(&self, origin: Option<&str>) -> bool {
        match origin {
            None => true,
            Some(origin) => origin.strip_prefix("http://").is_some_and(|host| self.allows_host(host)),
        }
    }
}

/// Name and port.
fn split(host: &str) -> (&str, Option<u16>) {
    match host.rsplit_once(':') {
        Some((name, port)) if !port.ends_with(']') => (name, Some(port.parse().unwrap_or(0))),
        _ => (host, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn guard(address: &str, names: &[&str]) -> Guard {
        Guard::new(address.parse().unwrap(), names.iter().map(|&name| name.to_owned()).collect())
    }

    #[test]
    fn only_our_own_hosts() {
        let here = guard("127.0.0.1:8470", &[]);
        for ours in ["127.0.0.1:8470", "localhost:8470", "LOCALHOST:8470", "[::1]:8470"] {
            assert!(here.allows_host(ours), "{ours}");
        }
        for foreign in [
            "evil.example:8470",
            "127.0.0.1",
            "127.0.0.1:80",
            "localhost.evil.example:8470",
            "10.0.0.1:8470",
            "",
            ":8470",
            "127.0.0.1:x",
        ] {
            assert!(!here.allows_host(foreign), "{foreign}");
        }
        let open = guard("0.0.0.0:80", &["lab"]);
        for ours in ["10.0.0.1", "lab", "localhost", "[fe80::1]:80"] {
            assert!(open.allows_host(ours), "{ours}");
        }
        assert!(!open.allows_host("evil.example") && !open.allows_host("0.0.0.0"));
    }

    #[test]
    fn only_our_own_origins() {
        let here = guard("127.0.0.1:8470", &[]);
        assert!(here.allows_origin(None) && here.allows_origin(Some("http://localhost:8470")));
        for foreign in
            ["null", "http://evil.example", "https://127.0.0.1:8470", "http://127.0.0.1:9000", "file://", ""]
        {
            assert!(!here.allows_origin(Some(foreign)), "{foreign}");
        }
    }
}
