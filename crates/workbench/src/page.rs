//! The pages: documents, their styles and their modules, each at a path of its own.

use std::borrow::Cow;

use soilctl_web::Content;

/// The policy that allows a page its own style and modules, its own server, and pictures that it makes; nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data: blob:; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// What a file of the page is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Document,
    Style,
    Module,
}

impl Kind {
    const fn media_type(self) -> &'static str {
        match self {
            Self::Document => "text/html; charset=utf-8",
            Self::Style => "text/css; charset=utf-8",
            Self::Module => "text/javascript; charset=utf-8",
        }
    }
}

/// All files by their paths.
macro_rules! files {
    ($($path:literal $kind:ident $name:literal)*) => {
        const FILES: &[(&str, Kind, &str)] = &[$(($path, Kind::$kind, include_str!(concat!("../page/", $name)))),*];
    };
}

files! {
    "/" Document "page.html"
    "/style.css" Style "style.css"
    "/asker.js" Module "asker.js"
    "/begin.js" Module "begin.js"
    "/controls.js" Module "controls.js"
    "/dom.js" Module "dom.js"
    "/editor.js" Module "editor.js"
    "/fields.js" Module "fields.js"
    "/files.js" Module "files.js"
    "/flow.js" Module "flow.js"
    "/form.js" Module "form.js"
    "/geometry.js" Module "geometry.js"
    "/hit.js" Module "hit.js"
    "/inside.js" Module "inside.js"
    "/keep.js" Module "keep.js"
    "/link.js" Module "link.js"
    "/main.js" Module "main.js"
    "/messages.js" Module "messages.js"
    "/model.js" Module "model.js"
    "/palette.js" Module "palette.js"
    "/panel.js" Module "panel.js"
    "/plate.css" Style "plate.css"
    "/plate.html" Document "plate.html"
    "/plate.js" Module "plate.js"
    "/plate_borne.js" Module "plate_borne.js"
    "/plate_forces.js" Module "plate_forces.js"
    "/plate_section.js" Module "plate_section.js"
    "/probe.js" Module "probe.js"
    "/proof.js" Module "proof.js"
    "/scale.js" Module "scale.js"
    "/section.js" Module "section.js"
    "/sliders.js" Module "sliders.js"
    "/snap.js" Module "snap.js"
    "/solver.js" Module "solver.js"
    "/store.js" Module "store.js"
    "/strength.js" Module "strength.js"
    "/stroke_bands.js" Module "stroke_bands.js"
    "/stroke_next.js" Module "stroke_next.js"
    "/stroke_rows.js" Module "stroke_rows.js"
    "/stroke_table.js" Module "stroke_table.js"
    "/strokes.js" Module "strokes.js"
    "/symbols.js" Module "symbols.js"
    "/text.js" Module "text.js"
    "/theme.js" Module "theme.js"
    "/units.js" Module "units.js"
    "/variant.js" Module "variant.js"
    "/view.js" Module "view.js"
    "/whatif.js" Module "whatif.js"
}

/// The file at a path.
pub(crate) fn at(path: &str) -> Option<Content<'static>> {
    let (_, kind, text) = FILES.iter().find(|(known, ..)| *known == path)?;
    Some(Content {
        kind: kind.media_type(),
        policy: (*kind == Kind::Document).then(|| POLICY.to_owned()),
        bytes: Cow::Borrowed(text.as_bytes()),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// What stands between a text and the next quotation mark, wherever the text is.
    fn quoted<'a>(text: &'a str, before: &'a str, mark: char) -> impl Iterator<Item = &'a str> {
        text.split(before).skip(1).map(move |rest| rest.split(mark).next().unwrap_or_default())
    }

    #[test]
    fn everything_that_is_asked_for_is_served_and_nothing_is_asked_for_elsewhere() {
        let pages = || FILES.iter().filter(|(_, kind, _)| *kind == Kind::Document).map(|(.., text)| *text);
        let of = |before| pages().flat_map(move |page| quoted(page, before, '"'));
        let asked: Vec<_> = of("src=\"").chain(of("rel=\"stylesheet\" href=\"")).map(str::to_owned).collect();
        assert_eq!(asked.len(), 5);
        let modules = FILES.iter().flat_map(|(_, _, text)| quoted(text, "from './", '\''));
        for name in asked.into_iter().chain(modules.map(str::to_owned)) {
            assert!(at(&format!("/{name}")).is_some(), "{name}");
        }
        for (path, _, text) in FILES {
            for sign in ["http://", "https://", "@import", "import(", "eval("] {
                let found =
                    text.match_indices(sign).map(|(place, _)| &text[place..(place + 40).min(text.len())]);
                let foreign: Vec<_> = found.filter(|text| !text.starts_with("http://www.w3.org/")).collect();
                assert!(foreign.is_empty(), "{path}: {foreign:?}");
            }
        }
    }

    #[test]
    fn every_module_is_used() {
        for (path, kind, _) in FILES {
            let name = path.trim_start_matches('/');
            let used = FILES.iter().any(|(_, _, text)| {
                text.contains(&format!("./{name}'")) || text.contains(&format!("=\"{name}\""))
            });
            assert!(used || *kind == Kind::Document, "{path}");
        }
    }
}
