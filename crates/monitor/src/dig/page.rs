//! The page on which the plate is dragged: a document, its style and its modules, each at a path of its own.

use std::borrow::Cow;

use soilctl_web::Content;

use crate::page::painter_module;

/// Where the page is.
pub(crate) const DIG_PATH: &str = "/dig";

/// The policy that allows the page its own style and modules and its own server; nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'; \
                      form-action 'none'; frame-ancestors 'none'";

const DOCUMENT: &str = "text/html; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";
const MODULE: &str = "text/javascript; charset=utf-8";

/// Where the module is that paints as the 3-D view does.
const PAINTER_PATH: &str = "/dig/xr/painter.js";

/// All files by their paths.
macro_rules! files {
    ($($path:literal $kind:ident $name:literal)*) => {
        const FILES: &[(&str, &str, &str)] = &[$(($path, $kind, include_str!(concat!("../../page/dig/", $name)))),*];
    };
}

files! {
    "/dig" DOCUMENT "page.html"
    "/dig/style.css" STYLE "style.css"
    "/dig/arm.js" MODULE "arm.js"
    "/dig/curve.js" MODULE "curve.js"
    "/dig/draw.js" MODULE "draw.js"
    "/dig/hand.js" MODULE "hand.js"
    "/dig/input.js" MODULE "input.js"
    "/dig/link.js" MODULE "link.js"
    "/dig/main.js" MODULE "main.js"
    "/dig/map.js" MODULE "map.js"
    "/dig/pad.js" MODULE "pad.js"
    "/dig/section.js" MODULE "section.js"
    "/dig/sense.js" MODULE "sense.js"
    "/dig/soil.js" MODULE "soil.js"
    "/dig/words.js" MODULE "words.js"
    "/dig/xr/board.js" MODULE "xr/board.js"
    "/dig/xr/enter.js" MODULE "xr/enter.js"
    "/dig/xr/grip.js" MODULE "xr/grip.js"
    "/dig/xr/hands.js" MODULE "xr/hands.js"
    "/dig/xr/place.js" MODULE "xr/place.js"
    "/dig/xr/stereo.js" MODULE "xr/stereo.js"
    "/dig/xr/visit.js" MODULE "xr/visit.js"
}

/// The file at a path.
pub(crate) fn at(path: &str) -> Option<Content<'static>> {
    if path == PAINTER_PATH {
        return Some(Content {
            kind: MODULE,
            policy: None,
            bytes: Cow::Owned(painter_module().into_bytes()),
        });
    }
    let (_, kind, text) = FILES.iter().find(|(known, ..)| *known == path)?;
    Some(Content {
        kind,
        policy: (*kind == DOCUMENT).then(|| POLICY.to_owned()),
        bytes: Cow::Borrowed(text.as_bytes()),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// What stands between a text and the next mark, wherever the text is.
    fn quoted<'a>(text: &'a str, before: &'a str, mark: char) -> impl Iterator<Item = &'a str> {
        text.split(before).skip(1).map(move |rest| rest.split(mark).next().unwrap_or_default())
    }

    #[test]
    fn everything_that_is_asked_for_is_served_and_nothing_is_asked_for_elsewhere() {
        let mut asked: Vec<String> = Vec::new();
        for (path, kind, text) in FILES {
            let folder = path.rsplit_once('/').unwrap().0;
            match *kind {
                DOCUMENT => asked.extend(
                    ["src=\"", "<link rel=\"stylesheet\" href=\""]
                        .iter()
                        .flat_map(|before| quoted(text, before, '"'))
                        .map(str::to_owned),
                ),
                MODULE => {
                    for before in [" from './", "import('./"] {
                        asked.extend(quoted(text, before, '\'').map(|name| format!("{folder}/{name}")));
                    }
                    asked.extend(quoted(text, " from '../", '\'').map(|name| format!("/dig/{name}")));
                }
                _ => {}
            }
            for sign in ["http://", "https://", "@import", "url("] {
                assert!(!text.contains(sign), "{sign}");
            }
        }
        assert!(asked.len() > 10);
        for path in asked {
            assert!(at(&path).is_some(), "{path}");
        }
        let painter = at(PAINTER_PATH).unwrap();
        let painter = std::str::from_utf8(&painter.bytes).unwrap();
        assert!(painter.contains("\nclass Painter {") && painter.contains("FORCE_SCALE = 0.005,"));
        assert!(at("/dig/page.html").is_none() && at("/dig/").is_none());
    }
}
