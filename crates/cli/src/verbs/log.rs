//! `soilctl log`: what is in a log, whether it is well, saving what can be saved, and tables.

use soilctl_app::log::{Answer, Content, Found, Topic, doctor, export, info, recover};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Exit code 1: doctor found problems in a whole file. Exit code 3: the file is damaged, and the answer is \
    about what could be read of it. What a log holds is described in docs/logs.md."
)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, clap::Subcommand)]
enum Action {
    Info(info::Request),
    Doctor(doctor::Request),
    Recover(recover::Request),
    Export(export::Request),
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = match &args.action {
        Action::Info(request) => info::run(request, output),
        Action::Doctor(request) => doctor::run(request, output),
        Action::Recover(request) => recover::run(request, output),
        Action::Export(request) => export::run(request, output),
    }?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = self.content.as_ref().map_or_else(String::new, content_text);
        if let Some(written) = &self.written {
            let what = match (&written.topic, written.columns) {
                (Some(topic), Some(columns)) => {
                    format!("{} rows, {columns} columns of {topic}", written.rows)
                }
                _ => format!("{} messages", written.rows),
            };
            text += &format!("written: {}, {what}\n", written.file);
        }
        for damage in &self.damage {
            text += &format!("damaged: {damage}\n");
        }
        let told = self.content.as_ref().and_then(|content| content.found.as_ref());
        let told = |problem: &&String| {
            !told.is_some_and(|found| {
                found.oddities.iter().chain(&found.implausible).any(|one| one == *problem)
            })
        };
        for problem in self.problems.iter().filter(told) {
            text += &format!("problem: {problem}\n");
        }
        if self.action == "doctor" && self.is_well() {
            text += "the log is well\n";
        }
        text
    }
}

fn content_text(content: &Content) -> String {
    if let Some(found) = &content.found {
        return foreign_text(content, found);
    }
    let mut text = String::new();
    for (key, value) in &content.session {
        text += &format!("{key}: {value}\n");
    }
    if let (Some(start), Some(end)) = (content.start_s, content.end_s) {
        text += &format!("time: {} to {} s\n", number(start), number(end));
    }
    text += &format!(
        "steps: {}, {} missing, {} key frames\n",
        content.steps, content.missing_steps, content.keyframes
    );
    let rows = content
        .topics
        .iter()
        .map(|topic| vec![topic.messages.to_string(), topic.topic.clone(), topic.message_type.clone()]);
    text += &columns(&rows.collect::<Vec<_>>());
    for stroke in &content.strokes {
        let words: Vec<String> = stroke.iter().map(|(key, value)| format!("{key} {value}")).collect();
        text += &format!("stroke: {}\n", words.join(", "));
    }
    for name in &content.attachments {
        text += &format!("attachment: {name}\n");
    }
    text
}

/// A recording of another program.
fn foreign_text(content: &Content, found: &Found) -> String {
    let mut text = format!("container: {}", found.container);
    if !found.compression.is_empty() {
        text += &format!(", {}", found.compression.join(", "));
    }
    if !found.library.is_empty() {
        text += &format!(", by {}", found.library);
    }
    let [start_s, end_s] = [content.start_s, content.end_s].map(number_or_dash);
    text += &format!("\ntime: {start_s} to {end_s} s ({} s)", number(found.duration_s));
    text += &match found.clock_origin_s {
        0 => "\n".to_owned(),
        origin_s => format!("; times count from {origin_s} s of the stamps\n"),
    };
    let heading = ["messages", "Hz", "gaps", "longest s", "topic", "type", ""].map(str::to_owned);
    let rows = std::iter::once(heading.to_vec()).chain(content.topics.iter().map(topic_row));
    text += &columns(&rows.collect::<Vec<_>>());
    text += if found.has_urdf { "URDF: yes\n" } else { "URDF: none\n" };
    for name in &content.attachments {
        text += &format!("attachment: {name}\n");
    }
    for (what, all) in [("odd", &found.oddities), ("implausible", &found.implausible)] {
        for words in all {
            text += &format!("{what}: {words}\n");
        }
    }
    text
}

fn topic_row(topic: &Topic) -> Vec<String> {
    let gaps = topic.longest_gaps.iter().flatten().map(|gap| gap.to_s - gap.from_s);
    vec![
        topic.messages.to_string(),
        number_or_dash(topic.rate_hz),
        topic.gaps.unwrap_or(0).to_string(),
        number_or_dash(gaps.max_by(f64::total_cmp)),
        topic.topic.clone(),
        topic.message_type.clone(),
        topic.problem.clone().or(topic.kind.map(str::to_owned)).unwrap_or_default(),
    ]
}
