//! Figures of a report, rendered for all uses when they are added.

use super::{RichText, Shown};
use crate::error::FigureError;
use crate::model::{Figure, Motion, Size};
use crate::{draw, escape, interactive};

/// A figure on the page.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drawn {
    number: usize,
    shown: Shown,
    caption: RichText,
    /// Without title: the page shows that as text, which wraps on narrow screens.
    svg: String,
    live: Live,
    json: String,
}

/// What takes the place of the still figure where scripts run.
#[derive(Debug, Clone, PartialEq)]
enum Live {
    /// A plot that pans and zooms.
    Plot,
    /// Things that move over these axes.
    Motion { axes: String },
}

fn untitled(figure: &Figure) -> Figure {
    Figure { title: String::new(), ..figure.clone() }
}

/// Before the names in a figure's picture.
fn prefix(number: usize) -> String {
    format!("figure-{number}-")
}

impl Drawn {
    pub(crate) fn figure(shown: Shown, caption: RichText, number: usize) -> Result<Self, FigureError> {
        let untitled = untitled(&shown.figure);
        let mut json = untitled.to_plotly_json();
        json["layout"]["margin"]["t"] = 34.into();
        let svg = draw::to_svg(&untitled, shown.size, &prefix(number))?;
        Ok(Self { number, shown, caption, svg, live: Live::Plot, json: escape::script_json(&json) })
    }

    pub(crate) fn motion(
        motion: &Motion,
        size: Size,
        caption: RichText,
        number: usize,
    ) -> Result<Self, FigureError> {
        let shown = Shown { number, figure: motion.at(1.0)?, size };
        let untitled = untitled(&shown.figure);
        let (axes, frame) = draw::axes_of(&untitled, size)?;
        let json = interactive::motion_to_json(motion, &frame);
        Ok(Self {
            number,
            svg: draw::to_svg(&untitled, size, &prefix(number))?,
            shown,
            caption,
            live: Live::Motion { axes },
            json: escape::script_json(&json),
        })
    }

    pub(crate) fn shown(&self) -> &Shown {
        &self.shown
    }

    pub(crate) const fn is_plot(&self) -> bool {
        matches!(self.live, Live::Plot)
    }

    pub(crate) fn to_html(&self, still: bool) -> String {
        let Self { number, svg, json, shown, .. } = self;
        let title = escape::html(shown.figure.title());
        let (width, height) = (shown.size.width(), shown.size.height());
        let colon = if title.is_empty() { "" } else { ": " };
        if still {
            return format!(
                "<figure id=\"figure-{number}\">\n<p class=\"figure-title\">Figure {number}{colon}{title}</p>\n\
                 <div class=\"static\" style=\"max-width:{width}px\">{svg}</div>\n<figcaption>{caption}</figcaption>\n</figure>\n",
                caption = self.caption.to_html(),
            );
        }
        let (kind, live) = match &self.live {
            Live::Plot => (
                "plotted",
                format!(
                    "<div class=\"plot\" id=\"plot-{number}\" role=\"group\" aria-labelledby=\"figure-{number}-title\" \
                     style=\"aspect-ratio:{width}/{height}\"></div>"
                ),
            ),
            Live::Motion { axes } => ("moving", controls(*number, axes, width)),
        };
        format!(
            "<figure id=\"figure-{number}\" class=\"{kind}\">\n\
             <p class=\"figure-title\" id=\"figure-{number}-title\">Figure {number}{colon}{title}</p>\n\
             <div class=\"static\" style=\"max-width:{width}px\">{svg}</div>\n{live}\n\
             <script type=\"application/json\" class=\"figure-data\">{json}</script>\n\
             <figcaption>{caption} <span class=\"save\">Save figure {number} as <a download=\"figure-{number}.csv\" \
             href=\"{link}\" aria-label=\"Data of figure {number} (CSV)\">CSV</a></span></figcaption>\n</figure>\n",
            caption = self.caption.to_html(),
            link = escape::data_uri("text/csv", &shown.figure.to_csv()),
        )
    }
}

/// The stage of a motion: its axes, what moves over them, and how to play it. All of it works by keyboard.
fn controls(number: usize, axes: &str, width: u32) -> String {
    format!(
        "<div class=\"motion\" style=\"max-width:{width}px\"><div class=\"stage\">{axes}\
         <canvas role=\"img\" aria-labelledby=\"figure-{number}-title\"></canvas></div>\
         <p class=\"controls\"><button type=\"button\" class=\"play\">Play</button>\
         <label>Moved <input type=\"range\" min=\"0\" max=\"100\" value=\"100\"></label> <output>100 %</output></p></div>"
    )
}
