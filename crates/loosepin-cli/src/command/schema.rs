//! `loosepin schema`.

use loosepin::model::model_schema;
use loosepin::study::study_schema;

use crate::arguments::{FileKind, SchemaArguments};
use crate::console;
use crate::ending::{Done, Ending};

/// Prints the schema.
pub fn run(arguments: &SchemaArguments) -> Ending {
    let schema = match arguments.kind {
        FileKind::Model => model_schema(),
        FileKind::Study => study_schema(),
    };
    // The alternate form of a JSON value is the indented one.
    console::print(&format!("{schema:#}\n"))?;
    Ok(Done::Well)
}
