//! The process that serves.

use loosepin_studio::{Token, serve};
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::arguments::ServeArguments;
use crate::command::signals::stop_on_signals;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Serves until the standard input, whose first line is the token or empty, comes to its end. Prints the address, then the folder.
pub fn run(arguments: &ServeArguments) -> Ending {
    abort_on_panic();
    let stop = stop_on_signals("Ctrl-C ends the studio at once; a study that runs keeps the runs that are saved");
    let mut first_line = String::new();
    let token = match io::stdin().read_line(&mut first_line) {
        Ok(_) if !first_line.trim().is_empty() => Some(Token::from_text(first_line.trim())),
        _ => None,
    };
    stop_at_end_of_input(&stop);
    let mut printed = Ok(());
    let served = serve(&arguments.folder, arguments.port, token, &stop, |serving| {
        printed = console::print(&format!("{}\n{}\n", serving.address, serving.folder.display()));
    });
    served.map_err(|error| Failure::of(&error))?;
    printed?;
    Ok(Done::Well)
}

/// A panic of any thread ends the process, with whatever profile it was compiled: what it leaves may be broken.
fn abort_on_panic() {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        report(panic);
        std::process::abort();
    }));
}

/// Sets `stop` when the supervisor closes the standard input, or is gone.
fn stop_at_end_of_input(stop: &Arc<AtomicBool>) {
    let stop = Arc::clone(stop);
    let wait = move || {
        let _ = io::copy(&mut io::stdin(), &mut io::sink());
        stop.store(true, Ordering::Relaxed);
    };
    if let Err(error) = std::thread::Builder::new().spawn(wait) {
        console::message(&format!("warning: the studio does not see when its terminal is closed: {error}"));
    }
}
