//! `loosepin explain`.

use loosepin::diagnostics::CODES;

use crate::arguments::ExplainArguments;
use crate::console;
use crate::ending::{Done, Ending};

/// Prints the long form of a code, or all codes with their titles.
pub fn run(arguments: &ExplainArguments) -> Ending {
    let text = match arguments.code {
        Some(code) => {
            let entry = code.entry();
            format!("{}: {}\n\n{}\n", entry.text, entry.title, console::wrapped(entry.explanation))
        }
        None => CODES.iter().map(|entry| format!("{}  {}\n", entry.text, entry.title)).collect(),
    };
    console::print(&text)?;
    Ok(Done::Well)
}
