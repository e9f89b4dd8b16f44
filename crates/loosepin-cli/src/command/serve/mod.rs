//! `loosepin serve`: a supervisor, which opens the page, and a worker process, which serves it. An error of ours ends the worker; the supervisor
//! starts another one at the same address, and pages connect again by themselves.

mod supervisor;
mod worker;

use crate::arguments::ServeArguments;
use crate::ending::Ending;

/// Serves the studio until Ctrl-C.
pub fn run(arguments: &ServeArguments) -> Ending {
    if arguments.worker { worker::run(arguments) } else { supervisor::run(arguments) }
}
