//! The command line as it stands in the foot of a page: what the page depends on, and nothing of the machine.

use std::ffi::OsString;
use std::path::Path;

/// Options on which no page depends: where things go, and how the work is done. Those of the second list have no value.
const LEFT_OUT: [&str; 12] = [
    "--out",
    "--report",
    "--figures",
    "--plot",
    "--plot-kind",
    "--vtu",
    "--mesh",
    "--save",
    "--threads",
    "--format",
    "--dump",
    "--max-memory",
];
const LEFT_OUT_ALONE: [&str; 2] = ["--open", "--quiet"];

/// Most characters; what is beyond, such as a list of a hundred logs, is left out of the middle.
const MOST: usize = 600;

/// The words after the program's name, as a shell would take them. Of absolute paths the last part is left.
pub(crate) fn line(words: &[OsString]) -> String {
    let mut line = "soilctl".to_owned();
    let mut words = words.iter().skip(1).map(|word| word.to_string_lossy());
    while let Some(word) = words.next() {
        if LEFT_OUT.contains(&&*word) {
            words.next();
            continue;
        }
        let name = word.split_once('=').map_or(&*word, |(name, _)| name);
        if LEFT_OUT.contains(&name) || LEFT_OUT_ALONE.contains(&name) {
            continue;
        }
        line.push(' ');
        line.push_str(&quoted(&portable(&word)));
    }
    shortened(line)
}

/// Without the folders of an absolute path, also where it stands behind an option.
fn portable(word: &str) -> String {
    let (option, value) = match word.split_once('=') {
        Some((option, value)) if option.starts_with("--") => (format!("{option}="), value),
        _ => (String::new(), word),
    };
    let path = Path::new(value);
    match path.file_name() {
        Some(name) if path.is_absolute() => option + &name.to_string_lossy(),
        _ => word.to_owned(),
    }
}

fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_=+.,:/%@".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

fn shortened(line: String) -> String {
    let count = line.chars().count();
    if count <= MOST {
        return line;
    }
    let first: String = line.chars().take(MOST / 2).collect();
    let last: String = line.chars().skip(count - MOST / 2).collect();
    format!("{first} … {last}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &[&str]) -> String {
        line(&words.iter().map(OsString::from).collect::<Vec<_>>())
    }

    #[test]
    fn where_things_go_and_folders_of_the_machine_are_left_out() {
        let root = if cfg!(windows) { "C:" } else { "" };
        let [table, robot] =
            [format!("{root}/home/x/sand/strokes.csv"), format!("--urdf={root}/home/x/arm.urdf")];
        let words = ["/usr/bin/soilctl", "report", &table, "--delta", "23", "--out", "/tmp/a.html"];
        assert_eq!(of(&words), "soilctl report strokes.csv --delta 23");
        let words = ["soilctl", "--quiet", "process", "runs/a", "--report=/tmp/b.html", &robot];
        assert_eq!(of(&words), "soilctl process runs/a --urdf=arm.urdf");
    }

    #[test]
    fn a_shell_takes_it_back_as_it_was() {
        assert_eq!(
            of(&["soilctl", "report", "my file.csv", "--title", "it's"]),
            r"soilctl report 'my file.csv' --title 'it'\''s'"
        );
    }

    #[test]
    fn long_lists_are_cut_in_the_middle() {
        let logs: Vec<String> = (0..200).map(|i| format!("log_{i}.mcap")).collect();
        let words: Vec<&str> =
            ["soilctl", "process"].into_iter().chain(logs.iter().map(String::as_str)).collect();
        let line = of(&words);
        assert!(line.chars().count() < MOST + 10 && line.ends_with("log_199.mcap"), "{line}");
    }
}
