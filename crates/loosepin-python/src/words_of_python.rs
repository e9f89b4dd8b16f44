//! Diagnostics in the words of Python: arguments in place of the options of the command.

use loosepin::diagnostics::{Code, Diagnostic, Label, Place, Source};

/// What a sentence says to users of the command, and what it says to those of Python. The longer ones first.
const SENTENCES: [(&str, &str); 19] = [
    ("; --resume --most-failed SHARE goes on with the runs that are kept", ""),
    (
        "--resume --most-failed SHARE goes on with the runs that are kept",
        "a larger most_failed under [sampling] allows more of them",
    ),
    (
        "write the rows again: loosepin identify STUDY --lengths --write NEW, with this input in STUDY",
        "write the rows again: identify(lengths=True).narrowed() of a study with this input",
    ),
    (
        "threads are given on the command line, since results do not depend on them: --threads",
        "threads are an argument of each call, since results do not depend on them",
    ),
    ("Give another folder, or omit --out: then a new folder is created.", "Give another folder."),
    (
        "--resume --most-failed 0.3 continues with them. The command in the message repeats one failed run.",
        "a larger most_failed under [sampling] allows more of them.",
    ),
    (
        "`--set joint.gudgeon.radial_clearance=0.3mm`. Quote it for the shell if the value contains spaces.",
        "set={\"joint.gudgeon.radial_clearance\": \"0.3 mm\"}.",
    ),
    (", or in the folder given with --out", ", or in the folder that was given for them"),
    (" with --out", ""),
    ("run the command again with --force", "compute the result again into this folder with force=True"),
    ("run the command again", "make the call again"),
    ("the same command", "the same call"),
    ("--specimen NAME", "specimen=\"NAME\""),
    ("use --plan to see", "call plan_motion to see"),
    ("each of --threads", "each of the threads"),
    ("loosepin schema model lists them", "the reference of model files lists them"),
    ("run loosepin identify", "call identify"),
    ("`loosepin simulate`", "Model.simulate"),
    (PATH, PATHS),
];

/// The option that names one point whose path is recorded, and the argument with all of them.
const PATH: &str = "--path";
const PATHS: &str = "paths";

/// The source of settings.
const SET: &str = "--set";

/// Options without a value: in Python they are true or false.
const SWITCHES: [&str; 5] = ["force", "lengths", "posterior", "resume", "states"];

/// The diagnostic as Python tells it.
pub fn in_python(diagnostic: &Diagnostic) -> Diagnostic {
    let label = |label: &Label| Label { place: place(&label.place), text: sentence(&label.text) };
    let is_of_set = diagnostic.place.as_ref().is_some_and(|place| place.source.name() == SET);
    if is_of_set {
        // Nobody wrote the text that the place is in: it was put together from a path and a value.
        let message = format!("set: {}", sentence(&diagnostic.message));
        let in_si = if diagnostic.code == Code::MissingUnit { "; a number that is no text is in SI units" } else { "" };
        let hint = diagnostic.hint.as_deref().map(|hint| sentence(hint) + in_si);
        return Diagnostic { message, hint, place: None, labels: Vec::new(), ..diagnostic.clone() };
    }
    Diagnostic {
        message: sentence(&diagnostic.message),
        hint: diagnostic.hint.as_deref().map(sentence),
        place: diagnostic.place.as_ref().map(place),
        labels: diagnostic.labels.iter().map(label).collect(),
        ..diagnostic.clone()
    }
}

/// A place in an argument is called by the name of the argument.
fn place(place: &Place) -> Place {
    match place.source.name().strip_prefix("--") {
        Some(argument) => {
            let argument = if place.source.name() == PATH { PATHS } else { argument };
            Place::new(&Source::new(argument, place.source.text()), place.span)
        }
        None => place.clone(),
    }
}

/// A sentence as Python tells it.
pub fn sentence(text: &str) -> String {
    // A command that repeats a run is of no use in Python; the reason of the run stands in the message.
    let text = text.split_once("` repeats one; ").map_or(text, |(_, rest)| rest);
    let mut reworded = text.to_owned();
    for (of_command, of_python) in SENTENCES {
        reworded = reworded.replace(of_command, of_python);
    }
    with_arguments(&without_explain(reworded))
}

/// What `loosepin explain CODE` prints is an attribute of the diagnostic.
fn without_explain(mut text: String) -> String {
    const COMMAND: &str = "`loosepin explain ";
    while let Some(at) = text.find(COMMAND) {
        let end = text[at + COMMAND.len()..].find('`').map_or(text.len(), |length| at + COMMAND.len() + length + 1);
        text.replace_range(at..end, "the explanation of this diagnostic");
    }
    text
}

/// `--resume` as `resume=True`, `--most-failed` as `most_failed`. What is quoted is of the user and stays.
fn with_arguments(text: &str) -> String {
    let mut reworded = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("--") {
        let is_word =
            rest[..at].chars().next_back().or(reworded.chars().next_back()).is_none_or(|before| " (`".contains(before));
        let behind = &rest[at + 2..];
        let length =
            behind.find(|letter: char| !(letter.is_ascii_lowercase() || letter == '-')).unwrap_or(behind.len());
        reworded.push_str(&rest[..at]);
        if is_word && behind.starts_with(|letter: char| letter.is_ascii_lowercase()) {
            let option = &behind[..length];
            reworded.push_str(&option.replace('-', "_"));
            reworded.push_str(if SWITCHES.contains(&option) { "=True" } else { "" });
        } else {
            reworded.push_str(&rest[at..at + 2 + length]);
        }
        rest = &behind[length..];
    }
    reworded.push_str(rest);
    reworded
}
