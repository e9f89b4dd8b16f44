//! How a result is made again: command, files, and runs of single mechanisms at witnesses.

use maud::{Markup, html};

use super::number::NumberWriter;
use super::page::Section;
use loosepin_result::repeat::{Repeat, quoted};
use loosepin_result::study::{InputDescription, ResponsePoint, StudyResult, Treatment, Witness, WitnessValue};

/// Witnesses that are listed at most.
const MOST_WITNESSES: usize = 6;

/// The section, or nothing where the record does not know its inputs.
pub(super) fn repeat_section(repeat: &Repeat) -> Option<Section> {
    (!repeat.is_empty()).then(|| Section::new("inputs", "Inputs and command", body(repeat, html! {})))
}

/// The same for a study, with the commands that run its witnesses.
pub(super) fn study_repeat_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let model = result.repeat.files.iter().rev().find(|file| file.name.ends_with(".toml"))?;
    let rows: Vec<(String, String)> = witnesses(result)
        .into_iter()
        .filter_map(|witness| {
            Some((writer.witness(witness, &result.inputs), command(&model.name, witness, &result.inputs)?))
        })
        .collect();
    let witnesses = html! {
        @if !rows.is_empty() {
            h3 { "One mechanism at the unknown values where a bound is reached" }
            @for (words, command) in &rows { p.quiet { (words) } pre { (command) } }
        }
    };
    (!result.repeat.is_empty()).then(|| Section::new("inputs", "Inputs and command", body(&result.repeat, witnesses)))
}

fn body(repeat: &Repeat, more: Markup) -> Markup {
    html! {
        p { "The same files, command and version give the same result, byte for byte." }
        pre { (repeat.command) }
        @for file in &repeat.files {
            details.input data-input=(file.name) {
                summary { (file.name) }
                pre { (file.text) }
            }
        }
        (more)
    }
}

/// Different witnesses of requirements and of bounds that are no points of curves, the most important first.
fn witnesses(result: &StudyResult) -> Vec<&Witness> {
    let of_requirements = result.requirements.iter().map(|requirement| &requirement.witness);
    let is_shown = |at: ResponsePoint| !matches!(at, ResponsePoint::Curve { .. });
    let bounds = result.bounds.iter().filter(|bound| bound.treatment == Treatment::Mixed && is_shown(bound.at));
    let of_bounds = bounds.flat_map(|bound| [&bound.upper.witness, &bound.lower.witness]);
    let mut found: Vec<&Witness> = Vec::new();
    for witness in of_requirements.chain(of_bounds) {
        if !witness.is_empty() && !found.contains(&witness) {
            found.push(witness);
        }
    }
    found.truncate(MOST_WITNESSES);
    found
}

/// The command that runs one mechanism at `witness`; nothing where it names what no model has, such as a parameter of a distribution.
fn command(model: &str, witness: &Witness, inputs: &[InputDescription]) -> Option<String> {
    let mut text = format!("loosepin simulate {}", quoted(model));
    for (path, value) in witness {
        let input = inputs.iter().find(|input| input.path == *path)?;
        if path.contains(' ') {
            return None;
        }
        let value = match value {
            WitnessValue::Number(value_si) => {
                let symbol = input.unit.symbol();
                let symbol = if symbol == "1" { String::new() } else { symbol.to_owned() };
                let symbol = symbol.replace('·', " ").replace('²', "^2").replace('³', "^3");
                format!("{value_si} {symbol}").trim_end().to_owned()
            }
            // A law is changed in the file.
            WitnessValue::Choice(_) => return None,
        };
        text.push_str(&format!(" --set {}", quoted(&format!("{path}={value}"))));
    }
    Some(text)
}
