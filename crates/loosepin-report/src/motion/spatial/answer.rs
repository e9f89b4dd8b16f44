//! The answer of a motion in space in sentences.

use super::dead_centre::dead_centre_sentence;
use super::numbers::{shown, shown_deviation, shown_input, span_words};
use super::scatter::largest_scatter;
use super::tables::place;
use crate::medium::short_answer::Said;
use loosepin_result::spatial_motion::{SpatialContributor, SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::Medium;
use loosepin_text::units::{SiUnit, counted};

/// The largest worst case first: of the main output, then what was found of it and who contributes, then the others.
pub(super) fn all_said(record: &SpatialMotionRecord) -> Vec<Said> {
    let Some(main) = record.main_output() else { return vec![Said::answer("The model has no output.".to_owned())] };
    let others = record.outputs.iter().filter(|output| output.name != main.name);
    if !record.has_play {
        let first = range(record, main).map(Said::answer);
        let ranges = first.into_iter().chain(others.filter_map(|output| range(record, output)).map(Said::detail));
        let rest = std::iter::once("No joint has play.".to_owned()).chain(scattered(record, main));
        return ranges.chain(rest.map(Said::answer)).collect();
    }
    // Where first order says nothing, it does not come first.
    let dead_centre = dead_centre_sentence(record, Medium::Page);
    let order = if dead_centre.is_some() { "To first order, " } else { "" };
    let mut said: Vec<Said> = dead_centre.into_iter().map(Said::answer).collect();
    said.push(Said::answer(format!("{order}{} is the largest worst case of play: {}.", worst(main), at(record, main))));
    let [up, down] =
        [main.worst.largest_si, main.worst.smallest_si].map(|own| shown_deviation(own, main, Medium::Page));
    said.push(Said::answer(format!(
        "It is to first order, to both sides alike. With loops closed exactly, a search found {up} and {down} there{}.",
        along(main)
    )));
    said.extend(contribution(main).map(Said::answer));
    // A table has them.
    said.extend(others.map(|output| Said::detail(format!("{}: {}.", worst(output), at(record, output)))));
    said.extend(scattered(record, main).map(Said::answer));
    let conditions = record.outputs.iter().map(|output| output.worst.conditions).max().unwrap_or(0);
    if conditions > 0 {
        let conditions = counted(conditions, "condition");
        said.push(Said::detail(format!(
            "The plays must meet {conditions} together so that the loops close; worst cases are with them."
        )));
    }
    said
}

/// What the numbers of a search are of, where the output is a vector.
fn along(output: &SpatialOutputRecord) -> &'static str {
    match (output.ideal_si.is_empty(), output.unit == SiUnit::ANGLE) {
        (false, _) => "",
        (true, false) => ", along the longest displacement",
        (true, true) => ", about the axis of the largest rotation",
    }
}

fn worst(output: &SpatialOutputRecord) -> String {
    shown_deviation(output.worst_case_si(), output, Medium::Page)
}

fn at(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> String {
    let place = place(record, output, Medium::Page);
    format!("{} ({}), with {} at {place}", output.name, output.words, record.input)
}

/// What random dimensions do to an output.
fn scattered(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Option<String> {
    let (position, value_si) = largest_scatter(output)?;
    let value = shown(value_si, &output.unit, value_si, Medium::Page);
    let place = shown_input(record, position, Medium::Page);
    Some(format!("Random dimensions add a standard deviation of up to {value} to {}, at {place}.", output.name))
}

fn range(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Option<String> {
    let least = output.ideal_si.iter().copied().reduce(f64::min)?;
    let most = output.ideal_si.iter().copied().reduce(f64::max)?;
    let [least, most] = [least, most].map(|own| shown(own, &output.unit, own, Medium::Page));
    Some(format!("{least} to {most}: {} ({}) over the {}.", output.name, output.words, span_words(record)))
}

/// The joint that contributes most, and by what.
fn contribution(output: &SpatialOutputRecord) -> Option<String> {
    let most = output.worst.contributors.iter().max_by(|a, b| a.part_si.total_cmp(&b.part_si))?;
    let SpatialContributor { joint, part_si, offset_si, lean_si, axial_si } = most;
    let value = |own: f64| shown_deviation(own, output, Medium::Page);
    let ways = [("an offset", Some(*offset_si)), ("a lean", *lean_si), ("the axial clearance", *axial_si)];
    let ways: Vec<String> = ways
        .into_iter()
        .filter_map(|(way, own)| Some(format!("{way} makes {}", value(own.filter(|own| *own > 0.0)?))))
        .collect();
    let alone = if ways.len() > 1 { format!(": alone, {}", ways.join(", ")) } else { String::new() };
    let others = output.worst.contributors.len() > 1;
    let words = if others { "contributes most" } else { "contributes all of it" };
    Some(format!("{joint} {words}, {}{alone}.", value(*part_si)))
}
