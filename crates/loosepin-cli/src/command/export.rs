//! `loosepin export`.

use loosepin::study::export_networks;

use crate::arguments::ExportArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Writes the networks, and lists what is not exported.
pub fn run(arguments: &ExportArguments) -> Ending {
    let ExportArguments { results, folder, outputs, force } = arguments;
    let files = export_networks(results, outputs, folder, *force).map_err(|error| Failure::of(&error))?;
    for file in &files {
        console::message(&format!("wrote {}", file.display()));
    }
    console::message("the errors and the noise are not exported; outside the training range the values are NaN");
    Ok(Done::Well)
}
