//! `loosepin manual`.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error};

use crate::arguments::{Arguments, ManualArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Prints a manual page.
pub fn run(arguments: &ManualArguments) -> Ending {
    let mut program = Arguments::command();
    program.build();
    let described = match &arguments.command {
        None => program,
        Some(name) => match program.find_subcommand(name) {
            Some(command) => command.clone(),
            None => unknown(&program, name).exit(),
        },
    };
    let source = concat!("loosepin ", env!("LOOSEPIN_VERSION"));
    let mut page = Vec::new();
    clap_mangen::Man::new(described).source(source).render(&mut page).map_err(Failure::Output)?;
    console::print(&String::from_utf8_lossy(&page))?;
    Ok(Done::Well)
}

/// The error for an unknown command, in the form of every other wrong argument.
fn unknown(program: &clap::Command, name: &str) -> Error {
    let names = program.get_subcommands().map(|command| command.get_name().to_owned()).collect();
    let mut error = Error::new(ErrorKind::InvalidValue).with_cmd(program);
    error.insert(ContextKind::InvalidArg, ContextValue::String("[COMMAND]".to_owned()));
    error.insert(ContextKind::InvalidValue, ContextValue::String(name.to_owned()));
    error.insert(ContextKind::ValidValue, ContextValue::Strings(names));
    error
}
