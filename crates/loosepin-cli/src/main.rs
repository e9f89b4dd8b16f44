//! The `loosepin` command: parse arguments, call the library, print.
//!
//! Data goes to standard output, messages and progress to standard error. Exit status: 0 success; 1 a requirement of the study is not
//! met or is undecided, a number of a reference case is outside its tolerance, or no play explains the readings; 2 error; 3 the shards
//! are merged and must run another round; 4 out of memory; 130 interrupted.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod arguments;
#[cfg(feature = "studio")]
mod browser;
mod command;
mod console;
mod ending;
mod progress;
mod standard_output;
mod system_limits;

use std::io::{self, Write};
use std::process::ExitCode;

use arguments::{Arguments, Command};
use clap::Parser;
use ending::{Done, Ending, Failure};
use loosepin::diagnostics::{Code, Diagnostics};

fn main() -> ExitCode {
    system_limits::prepare();
    system_limits::with_enough_stack(run)
}

fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return print_usage_message(&error),
    };
    let ending = match &arguments.command {
        Command::New(new) => command::new::run(new),
        Command::Import(import) => command::import::run(import),
        Command::Check(check) => command::check::run(check),
        Command::Motion(motion) => command::motion::run(motion),
        Command::Simulate(simulate) => command::simulate::run(simulate),
        Command::Wear(wear) => command::wear::run(wear),
        Command::Study(study) => command::study::run(study),
        Command::Merge(merge) => command::merge::run(merge),
        Command::Sweep(sweep) => command::sweep::run(sweep),
        Command::Identify(identify) => command::identify::run(identify),
        Command::Cases(cases) => command::cases::run(cases),
        Command::Schema(schema) => command::schema::run(schema),
        Command::Explain(explain) => command::explain::run(explain),
        Command::Completions(completions) => command::completions::run(completions),
        Command::Manual(manual) => command::manual::run(manual),
        Command::Report(report) => command::report::run(report),
        #[cfg(feature = "studio")]
        Command::Serve(serve) => command::serve::run(serve),
        Command::Export(export) => command::export::run(export),
    };
    exit_code(ending)
}

/// Shows help, the version, or what is wrong with the arguments.
fn print_usage_message(message: &clap::Error) -> ExitCode {
    if message.use_stderr() {
        message.exit();
    }
    let shown = standard_output::check().and_then(|()| message.print()).and_then(|()| io::stdout().flush());
    match shown {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => exit_code(Err(Failure::Output(error))),
        _ => ExitCode::SUCCESS,
    }
}

/// Writes why a command failed, and returns its exit status.
fn exit_code(ending: Ending) -> ExitCode {
    match ending {
        Ok(Done::Well) => ExitCode::SUCCESS,
        Ok(Done::RequirementNotMet) => ExitCode::from(1),
        Ok(Done::Misfit) => ExitCode::from(1),
        Ok(Done::RunFailed) => ExitCode::from(2),
        Ok(Done::RoundOpen) => ExitCode::from(3),
        Ok(Done::Interrupted) => ExitCode::from(130),
        Err(Failure::Diagnostics(diagnostics)) => {
            console::report(&diagnostics);
            ExitCode::from(if is_out_of_memory(&diagnostics) { system_limits::OUT_OF_MEMORY_STATUS } else { 2 })
        }
        Err(Failure::Reported(status)) => ExitCode::from(status),
        Err(Failure::Output(error)) => {
            console::message(&format!(
                "error: cannot write to standard output: {}",
                loosepin::files::io_error_words(&error)
            ));
            ExitCode::from(2)
        }
    }
}

/// Whether one of the errors is that memory ran out.
fn is_out_of_memory(diagnostics: &Diagnostics) -> bool {
    diagnostics.sorted().iter().any(|diagnostic| diagnostic.code == Code::OutOfMemory)
}
