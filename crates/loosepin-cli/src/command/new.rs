//! `loosepin new`.

use std::path::PathBuf;

use loosepin::templates::{Template, all_templates, write_template};

use crate::arguments::NewArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Lists the templates, or writes one.
pub fn run(arguments: &NewArguments) -> Ending {
    let Some(template) = arguments.template else {
        console::print(&all_templates().map(described).collect::<Vec<_>>().join("\n"))?;
        return Ok(Done::Well);
    };
    let folder: PathBuf = arguments.folder.clone().unwrap_or_else(|| PathBuf::from(template.name));
    let files = write_template(template, &folder).map_err(|error| Failure::of(&error))?;
    let [model, study] = files.map(|file| file.display().to_string());
    console::message(&format!("wrote {model} and {study}\nnext: loosepin check {model} {study}"));
    Ok(Done::Well)
}

/// A template in the list: its name and description, then what to look at.
fn described(template: &Template) -> String {
    format!(
        "{}\n{}\n",
        console::wrapped(&format!("{}: {}", template.name, template.description())),
        console::indented(&template.paragraph())
    )
}
