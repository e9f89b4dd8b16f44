//! `loosepin check`.

use std::collections::HashSet;
use std::path::Path;

use loosepin::check::{check, warnings};
use loosepin::diagnostics::{Diagnostic, Diagnostics};
use loosepin::report::article_text;
use loosepin::study::InputFile;

use crate::arguments::CheckArguments;
use crate::console;
use crate::ending::{Done, Ending};

/// Describes each file; the remaining files are checked even if one has errors.
pub fn run(arguments: &CheckArguments) -> Ending {
    let mut diagnostics = Diagnostics::new();
    // A study repeats what its model says, which may be one of the files.
    let mut seen = HashSet::new();
    let mut gap = "";
    for path in &arguments.files {
        match describe(path, &mut seen) {
            Ok(text) => {
                console::print(&format!("{gap}{}: {text}", path.display()))?;
                gap = "\n";
            }
            Err(mut found) => {
                found.remove_repeats(&mut seen);
                diagnostics.extend(found);
            }
        }
    }
    if diagnostics.is_empty() { Ok(Done::Well) } else { Err(diagnostics.into()) }
}

fn describe(path: &Path, seen: &mut HashSet<String>) -> Result<String, Diagnostics> {
    let file = InputFile::from_path(path)?;
    warn_once(&warnings(&file), seen);
    // Lines as they are: programs look for them.
    Ok(article_text(&check(&file)?, None))
}

/// Shows the warnings that were not shown for an earlier file.
fn warn_once(warnings: &[Diagnostic], seen: &mut HashSet<String>) {
    let mut diagnostics: Diagnostics = warnings.iter().cloned().collect();
    diagnostics.remove_repeats(seen);
    if !diagnostics.is_empty() {
        console::report(&diagnostics);
    }
}
