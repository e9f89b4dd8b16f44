//! `loosepin serve`.

use loosepin_studio::serve;

use super::signals::stop_on_signals;
use crate::arguments::ServeArguments;
use crate::browser;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Serves the studio until Ctrl-C.
pub fn run(arguments: &ServeArguments) -> Ending {
    let stop = stop_on_signals("Ctrl-C ends the studio at once; a study that runs keeps the runs that are saved");
    // Kept until the end, because the browser may read it late.
    let mut page = None;
    let mut printed = Ok(());
    let served = serve(&arguments.folder, arguments.port, &stop, |serving| {
        console::message(&format!("studio of {}; Ctrl-C ends it", serving.folder.display()));
        printed = console::print(&format!("{}\n", serving.address));
        if !arguments.no_open {
            match browser::open(&serving.address) {
                Ok(opened) => page = Some(opened),
                Err(error) => console::message(&format!("no browser opened ({error}): open the address above")),
            }
        }
    });
    served.map_err(|error| Failure::of(&error))?;
    printed?;
    Ok(Done::Well)
}
