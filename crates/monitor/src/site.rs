//! What the monitor serves: its page, meshes, and a feed for each page.

use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

use soilctl_live::protocol::{MOST_LINE_BYTES, Problem};
use soilctl_web::{Content, Feed as PageFeed, Heard, Site, WebError, random_hex};

use crate::MonitorError;
use crate::dig;
use crate::feed::{Feed, Rights, refuse};
use crate::page::{page, policy};

/// Where meshes are, by their numbers.
const MESH_PATH: &str = "/mesh/";
/// Tokens that a page may try.
const MOST_WRONG_TOKENS: u32 = 5;

/// What all pages of a monitor share.
pub(crate) struct Shown {
    /// The token that allows commands; none if they are off.
    pub(crate) token: Option<Arc<str>>,
    /// Makes the feed of a new page.
    pub(crate) feed: Box<dyn Fn() -> Result<Feed, MonitorError> + Send + Sync>,
    /// What a page is greeted with, beside its feed.
    pub(crate) greeting: Vec<String>,
    /// Whether there is a session, whose plate may be led.
    pub(crate) may_dig: bool,
    /// Meshes by their numbers.
    pub(crate) meshes: Vec<Arc<[u8]>>,
}

impl Site for Shown {
    fn name(&self) -> &'static str {
        "monitor"
    }

    fn at(&self, path: &str) -> Result<Option<Content<'_>>, WebError> {
        if path == "/" {
            let nonce = random_hex::<16>()?;
            return Ok(Some(Content {
                kind: "text/html; charset=utf-8",
                policy: Some(policy(&nonce)),
                bytes: Cow::Owned(page(&nonce).into_bytes()),
            }));
        }
        if self.may_dig && path.starts_with(dig::DIG_PATH) {
            return Ok(dig::at(path));
        }
        // A page never says the name of a file.
        let number = path.strip_prefix(MESH_PATH).and_then(|number| number.parse::<usize>().ok());
        let mesh = number.and_then(|number| self.meshes.get(number));
        Ok(mesh.map(|mesh| Content {
            kind: "application/octet-stream",
            policy: None,
            bytes: Cow::Borrowed(mesh),
        }))
    }

    fn feed(&self) -> Result<Box<dyn PageFeed>, String> {
        let feed = (self.feed)().map_err(|problem| problem.to_string())?;
        let rights = Rights { token: self.token.clone(), ..Rights::default() };
        Ok(Box::new(Page { feed, rights, greeting: self.greeting.clone() }))
    }

    fn most_message_bytes(&self) -> usize {
        MOST_LINE_BYTES
    }
}

/// A page of the monitor.
struct Page {
    feed: Feed,
    rights: Rights,
    /// What it has not been greeted with yet.
    greeting: Vec<String>,
}

impl PageFeed for Page {
    fn poll(&mut self, now: Instant, tell: &mut dyn FnMut(String)) {
        self.greeting.drain(..).for_each(&mut *tell);
        self.feed.poll(now, tell);
    }

    fn obey(&mut self, line: &str) -> Heard {
        let (answer, refused) = self.feed.obey(line, &mut self.rights);
        let send_away = (self.rights.wrong_tokens > MOST_WRONG_TOKENS).then_some("too many wrong tokens");
        Heard { answer, refused, send_away }
    }

    fn refuse(&self, what: &str, too_fast: bool) -> Heard {
        let problem = if too_fast { Problem::TooFast } else { Problem::Malformed };
        let (answer, refused) = refuse(None, problem, what);
        Heard { answer, refused, send_away: None }
    }
}
