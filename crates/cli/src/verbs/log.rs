//! `soilctl log`: what is in a log, whether it is well, saving what can be saved, and tables.

use soilctl_app::log::{Answer, Content, doctor, export, info, recover};
use soilctl_app::text::{columns, number};
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
        for problem in &self.problems {
            text += &format!("problem: {problem}\n");
        }
        if self.action == "doctor" && self.is_well() {
            text += "the log is well\n";
        }
        text
    }
}

fn content_text(content: &Content) -> String {
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
