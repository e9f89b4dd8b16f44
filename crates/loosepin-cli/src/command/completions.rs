//! `loosepin completions`.

use clap::CommandFactory;

use crate::arguments::{Arguments, CompletionsArguments};
use crate::console;
use crate::ending::{Done, Ending};

/// Prints the script of a shell.
pub fn run(arguments: &CompletionsArguments) -> Ending {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "loosepin", &mut script);
    console::print(&String::from_utf8_lossy(&script))?;
    Ok(Done::Well)
}
