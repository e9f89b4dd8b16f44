//! Standard output for data, standard error for messages.

use std::env;
use std::io::{self, IsTerminal, Write};

use loosepin::diagnostics::{Colour, Diagnostics, visible};
use loosepin::report::TERMINAL_COLUMNS;

use crate::ending::Failure;
use crate::standard_output;

/// Writes data. A closed pipe is not an error: `loosepin ... | head` has the same exit status as without `head`.
///
/// # Errors
/// Standard output is full, or was closed at the start.
pub fn print(text: &str) -> Result<(), Failure> {
    standard_output::check().map_err(Failure::Output)?;
    let mut output = io::stdout().lock();
    match output.write_all(visible(text).as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        _ => Ok(()),
    }
}

/// Writes a message to standard error. A failure to write it is ignored.
pub fn message(text: &str) {
    coloured(&visible(text));
}

/// Writes a message that may have colours to standard error.
fn coloured(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Writes diagnostics: with the lines of the files on a terminal, otherwise one line each, for programs.
pub fn report(diagnostics: &Diagnostics) {
    if !io::stderr().is_terminal() {
        message(&diagnostics.to_string());
        return;
    }
    coloured(diagnostics.render(colour()).trim_end());
    if let Some(diagnostic) = diagnostics.sorted().first() {
        message(&format!("\n`loosepin explain {}` explains this error", diagnostic.code));
    }
}

/// Colours on a terminal that has them, unless NO_COLOR is set.
fn colour() -> Colour {
    let is_plain = env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
        || env::var_os("TERM").is_some_and(|terminal| terminal == "dumb");
    if is_plain { Colour::Never } else { Colour::Always }
}

/// A paragraph, wrapped to the width of a terminal.
pub fn wrapped(paragraph: &str) -> String {
    textwrap::fill(paragraph, options())
}

/// A paragraph, wrapped to the width of a terminal and indented by two columns.
pub fn indented(paragraph: &str) -> String {
    textwrap::fill(paragraph, options().initial_indent("  ").subsequent_indent("  "))
}

/// Lines of a terminal. No word is cut at a hyphen: `1e-9` is a number.
fn options() -> textwrap::Options<'static> {
    textwrap::Options::new(usize::from(TERMINAL_COLUMNS)).word_splitter(textwrap::WordSplitter::NoHyphenation)
}
