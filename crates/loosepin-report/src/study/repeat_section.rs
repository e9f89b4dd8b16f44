//! How a result is made again: command, files, and runs of single mechanisms at witnesses.

use maud::{Markup, html};

use crate::medium::page::Section;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use loosepin_result::repeat::Repeat;
use loosepin_result::study::StudyResult;

/// The section, or nothing where the record does not know its inputs.
pub(crate) fn repeat_section(repeat: &Repeat) -> Option<Section> {
    (!repeat.is_empty()).then(|| Section::new("inputs", "Inputs and command", body(repeat, html! {})))
}

/// The same for a study, with the commands that run its witnesses.
pub(crate) fn study_repeat_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let witnesses = html! {
        @if !result.witness_commands.is_empty() {
            h3 { "One mechanism at the unknown values where a bound is reached" }
            @for (place, run) in result.witness_commands.iter().enumerate() {
                @let tag = Tag::whole("command of a witness", &place.to_string());
                p.quiet { (writer.with_tag(&tag).witness(&run.witness, &result.inputs)) }
                pre { (run.command) }
            }
        }
    };
    (!result.repeat.is_empty()).then(|| Section::new("inputs", "Inputs and command", body(&result.repeat, witnesses)))
}

fn body(repeat: &Repeat, more: Markup) -> Markup {
    let are_in_folders = repeat.files.iter().any(|file| file.name.contains('/'));
    html! {
        p { "The same files, command and version give the same result, byte for byte." }
        pre { (repeat.command) }
        @if are_in_folders {
            p.quiet { "Keep the files in the folders that their names show, or save all as one archive." }
        }
        @for file in &repeat.files {
            details.input data-input=(file.name) data-exact=[exact(&file.text)] {
                summary { (file.name) }
                pre { (file.text) }
            }
        }
        (more)
    }
}

/// The text as JSON where a page would not give it back: a browser turns carriage returns into line ends, and drops zeros and an empty
/// first line.
fn exact(text: &str) -> Option<String> {
    let is_kept = !text.contains(['\r', '\0']) && !text.starts_with('\n');
    if is_kept { None } else { serde_json::to_string(text).ok() }
}
