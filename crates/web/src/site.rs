//! What a program that serves a page has to say.

use std::borrow::Cow;
use std::time::Instant;

use crate::WebError;

/// What is served.
pub trait Site: Send + Sync + 'static {
    /// What it is called in words to people: `monitor`.
    fn name(&self) -> &'static str;

    /// What is at a path, asked for by GET or HEAD; none if there is nothing.
    ///
    /// # Errors
    /// [`WebError::Random`] if a nonce cannot be made.
    fn at(&self, path: &str) -> Result<Option<Content<'_>>, WebError>;

    /// The feed of a page that connects. It stays on the thread of that page.
    ///
    /// # Errors
    /// Why there is none, in words.
    fn feed(&self) -> Result<Box<dyn Feed>, String>;

    /// Most bytes of a message from a page.
    fn most_message_bytes(&self) -> usize;
}

/// What is at a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Content<'a> {
    /// Its media type.
    pub kind: &'static str,
    /// The content security policy, of a page.
    pub policy: Option<String>,
    /// The content.
    pub bytes: Cow<'a, [u8]>,
}

/// What feeds one page.
pub trait Feed {
    /// Tells what there is to tell now; the first time, the greeting.
    fn poll(&mut self, now: Instant, tell: &mut dyn FnMut(String));

    /// Carries out what a page asks.
    fn obey(&mut self, line: &str) -> Heard;

    /// What to say to a message that is no text, or to the first of those that come too fast.
    fn refuse(&self, what: &str, too_fast: bool) -> Heard;
}

/// What came of a message.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Heard {
    /// The answer, if there is one at once.
    pub answer: Option<String>,
    /// What was refused, for the operator's notes.
    pub refused: Option<String>,
    /// Why the page is sent away, if it is.
    pub send_away: Option<&'static str>,
}
