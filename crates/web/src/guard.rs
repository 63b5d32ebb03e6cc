use std::net::{IpAddr, SocketAddr};

/// Which hosts and origins are ours. A page of a foreign site reaches a loopback address, too: by its own name made to
/// point there (then `Host` tells), or from its own page (then `Origin` differs from `Host`). Ports are not asked for: a
/// tunnel's end has one of its own.
#[derive(Debug, Clone)]
pub struct Guard {
    address: SocketAddr,
    /// Further names by which this machine is known.
    names: Vec<String>,
}

impl Guard {
    /// Of a server at this address, with further names by which this machine is known.
    #[must_use]
    pub fn new(address: SocketAddr, names: Vec<String>) -> Self {
        Self { address, names }
    }

    /// Whether a `Host` field is ours.
    #[must_use]
    pub fn allows_host(&self, host: &str) -> bool {
        let name = name_of(host);
        let address = self.address.ip();
        match name.trim_matches(['[', ']']).parse::<IpAddr>() {
            // An address, unlike a name, cannot be made to point elsewhere.
            Ok(given) if address.is_unspecified() => !given.is_unspecified(),
            Ok(given) => given == address || (given.is_loopback() && address.is_loopback()),
            Err(_) => {
                (name.eq_ignore_ascii_case("localhost")
                    && (address.is_loopback() || address.is_unspecified()))
                    || self.names.iter().any(|known| known.eq_ignore_ascii_case(name))
            }
        }
    }
}

/// Whether an `Origin` field is that of the page at `host`; `https` at the front of a proxy. Programs that are no browsers
/// send none, and are no danger: nobody lures them.
pub(crate) fn is_own_origin(origin: Option<&str>, host: &str) -> bool {
    let Some(origin) = origin else { return true };
    let own = |scheme: &str, port: &str| {
        let bare = |authority: &str| authority.strip_suffix(port).unwrap_or(authority).to_ascii_lowercase();
        origin.strip_prefix(scheme).is_some_and(|authority| bare(authority) == bare(host))
    };
    own("http://", ":80") || own("https://", ":443")
}

/// A host without its port; empty if that is no number.
fn name_of(host: &str) -> &str {
    match host.rsplit_once(':') {
        Some((name, port)) if !port.ends_with(']') => {
            if port.parse::<u16>().is_ok() {
                name
            } else {
                ""
            }
        }
        _ => host,
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
        // The last two: through a tunnel.
        for ours in [
            "127.0.0.1:8470",
            "localhost:8470",
            "LOCALHOST:8470",
            "[::1]:8470",
            "localhost",
            "127.0.0.1:9000",
        ] {
            assert!(here.allows_host(ours), "{ours}");
        }
        for foreign in [
            "evil.example:8470",
            "evil.example",
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
    fn only_the_page_itself() {
        for (origin, host) in [
            ("http://localhost:8470", "localhost:8470"),
            ("http://LAB", "lab:80"),
            ("https://lab.example", "lab.example"),
            ("https://lab.example", "lab.example:443"),
        ] {
            assert!(is_own_origin(Some(origin), host), "{origin} {host}");
        }
        assert!(is_own_origin(None, "localhost:8470"));
        for foreign in [
            "null",
            "http://evil.example",
            "http://127.0.0.1:8470",
            "http://localhost:9000",
            "http://localhost",
            "ftp://localhost:8470",
            "http://localhost:8470.evil.example",
            "file://",
            "",
        ] {
            assert!(!is_own_origin(Some(foreign), "localhost:8470"), "{foreign}");
        }
    }
}
