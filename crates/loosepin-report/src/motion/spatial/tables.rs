//! Outputs of a motion in space, and what each joint contributes, as tables.

use super::dead_centre::{dead_centre_sentence, regular_sentences};
use super::numbers::{shown, shown_deviation, shown_end, shown_input, span_words};
use crate::motion::contributors::share_bar;
use crate::numbers::number::NumberWriter;
use crate::words::wording::{capitalised, head};
use loosepin_result::spatial_motion::{OTHER_START, SpatialContributor, SpatialMotionRecord, SpatialOutputRecord};
use loosepin_result::study::OutputDescription;
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table};
use loosepin_text::units::{DisplayUnits, SiUnit, counted, listed};

/// Outputs on the first screen of a page, at most.
const MAX_FIRST_OUTPUTS: usize = 8;

/// All outputs, and what their numbers are.
pub(super) fn outputs_section(record: &SpatialMotionRecord, medium: Medium) -> Section {
    let mut section = Section::headed_on_page("outputs", "Outputs");
    let play = match record.has_play {
        true => "worst cases of play in the ideal position of each",
        false => "no joint has play",
    };
    let positions = counted(record.inputs_si.len(), "position");
    section.push(Content::sentences([format!("{positions} over a {}, {play}.", span_words(record))]));
    let heads =
        ["smallest", "largest", "worst case, first order", "at", "found, up", "found, down", "standard deviation"];
    let columns =
        std::iter::once(Column::words(head("output"))).chain(heads.map(|words| Column::numbers(head(words)))).collect();
    section.push(Content::Table(Table::new(columns, record.outputs.iter().map(|output| row(record, output, medium)))));
    if record.has_play {
        section.push(Content::sentences([
            "The worst case of first order is largest at the place shown, to both sides alike. There a search closes the loops exactly: up and \
             down are the largest deviations it found. The standard deviation is for journals anywhere in their play, all places alike.",
        ]));
    }
    // A page begins with it.
    if let Some(sentence) = dead_centre_sentence(record, medium).filter(|_| medium == Medium::Terminal) {
        section.push(Content::sentences([sentence]));
    }
    let regular = regular_sentences(record, medium);
    if !regular.is_empty() {
        section.push(Content::sentences(regular));
    }
    if record.is_other_start {
        section.push(Content::sentences([format!("{}.", capitalised(OTHER_START))]));
    }
    if record.has_play && record.is_proven {
        section.push(Content::sentences(proven_sentences(record, medium)));
    }
    let conditions = record.outputs.iter().map(|output| output.worst.conditions).max().unwrap_or(0);
    if conditions > 0 {
        section.push(Content::sentences([format!(
            "The plays must meet {} together so that the loops close; the worst cases are with them, and the standard deviation has no closed \
             form. What a joint contributes is then its share of the worst case, not what it does alone.",
            counted(conditions, "condition")
        )]));
    }
    let has_vector = |is_angle: bool| {
        let mut vectors = record.outputs.iter().filter(|output| output.ideal_si.is_empty());
        record.has_play && vectors.any(|output| (output.unit == SiUnit::ANGLE) == is_angle)
    };
    if has_vector(false) {
        section.push(Content::sentences([
            "Of a displacement, the worst case is the longest one that a search over directions found, up and down are along that direction, and \
             the standard deviation is the root of the sum of the variances along x, y and z.",
        ]));
    }
    if has_vector(true) {
        section.push(Content::sentences([
            "Of a rotation, the worst case is the largest angle that a search over axes found, up and down are about that axis, and the standard \
             deviation is the root of the sum of the variances about x, y and z of the body.",
        ]));
    }
    section
}

/// What the first screen of a page says of each output: how far play takes it, or between what it moves where there is none. The table with all
/// numbers opens.
pub(super) fn outputs_overview(record: &SpatialMotionRecord) -> Option<Section> {
    let (title, heads): (_, &[&str]) = match record.has_play {
        true => ("Worst cases by output", &["worst case, first order", "at", "found, up", "found, down"]),
        false => ("Ranges of the outputs", &["smallest", "largest"]),
    };
    let numbers = heads.iter().map(|words| Column::numbers(head(words)));
    let columns = std::iter::once(Column::words(head("output"))).chain(numbers).collect();
    let places: &[usize] = if record.has_play { &[0, 3, 4, 5, 6] } else { &[0, 1, 2] };
    let rows = record.outputs.iter().map(|output| {
        let all = row(record, output, Medium::Page);
        places.iter().map(|place| all[*place].clone()).collect::<Vec<Cell>>()
    });
    let mut section = Section::headed_on_page("outputs-overview", title);
    section.push(Content::Table(Table::new(columns, rows.take(MAX_FIRST_OUTPUTS))));
    let left = record.outputs.len().saturating_sub(MAX_FIRST_OUTPUTS);
    if left > 0 {
        section.push(Content::sentences([format!("{} under Outputs.", counted(left, "more output"))]));
    }
    (!record.outputs.is_empty()).then_some(section)
}

/// Ends that no deviation passes at the place shown, and the outputs that have none.
fn proven_sentences(record: &SpatialMotionRecord, medium: Medium) -> Vec<String> {
    let (mut proven, mut others) = (Vec::new(), Vec::new());
    for output in &record.outputs {
        let own = &output.worst;
        match own.proven_smallest_si.zip(own.proven_largest_si) {
            Some((smallest, largest)) => {
                let [smallest, largest] =
                    [(smallest, -1.0), (largest, 1.0)].map(|(own, side)| shown_end(own, side, output, medium));
                proven.push(format!("{} {smallest} to {largest}", output.name));
            }
            None => others.push(output.name.clone()),
        }
    }
    let mut sentences = Vec::new();
    if !proven.is_empty() {
        sentences
            .push(format!("No deviation there goes beyond these ends, which are proven: {}.", listed(&proven, "and")));
    }
    if !others.is_empty() {
        sentences.push(format!(
            "No end is proven of {}: constraints repeat others, or play comes near a singular position, where it may take the mechanism farther than \
             what was found.",
            listed(&others, "and")
        ));
    }
    sentences
}

fn row(record: &SpatialMotionRecord, output: &SpatialOutputRecord, medium: Medium) -> Vec<Cell> {
    let deviation = |value_si: f64| shown_deviation(value_si, output, medium);
    let ends = (!output.ideal_si.is_empty()).then(|| {
        let ideal = output.ideal_si.iter().copied();
        let ends = [ideal.clone().fold(f64::INFINITY, f64::min), ideal.fold(f64::NEG_INFINITY, f64::max)];
        let scale_si = ends[0].abs().max(ends[1].abs());
        ends.map(|value_si| shown(value_si, &output.unit, scale_si, medium))
    });
    let [smallest, largest] = ends.map_or([None, None], |ends| ends.map(Some));
    let worst = record.has_play.then(|| output.first_order_si.get(output.worst.sample).copied()).flatten();
    let at = worst.map(|_| place(record, output, medium));
    let sigma = worst.and_then(|_| output.standard_deviation_si.get(output.worst.sample));
    let found = worst.map(|_| [output.worst.largest_si, output.worst.smallest_si].map(deviation));
    let [up, down] = found.map_or([None, None], |found| found.map(Some));
    let name = format!("{}: {}", output.name, output.words);
    let cells =
        [Some(name), smallest, largest, worst.map(deviation), at, up, down, sigma.map(|sigma| deviation(*sigma))];
    cells.into_iter().map(Cell::from).collect()
}

/// What each joint contributes to the largest worst case of an output, on a terminal.
pub(super) fn contributors_on_terminal(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Section {
    let heading =
        format!("{}: what each joint contributes at {}", output.name, place(record, output, Medium::Terminal));
    let mut section = Section::new("contributors", heading);
    let heads = ["part", "offset alone", "lean alone", "axial"];
    let columns = std::iter::once(Column::words("joint")).chain(heads.map(Column::numbers)).collect();
    let rows = output.worst.contributors.iter().map(|own| contributor(own, output, Medium::Terminal));
    section.push_close(Content::Table(Table::new(columns, rows)));
    section
}

/// What each joint contributes to the largest worst case of each output, the largest first, on a page; `None` where no joint has play.
pub(super) fn contributors_on_page(record: &SpatialMotionRecord) -> Option<Section> {
    if !record.has_play {
        return None;
    }
    let units = DisplayUnits::default();
    let writer = &NumberWriter::for_page(&units);
    let groups = record.outputs.iter().map(|output| {
        let mut own: Vec<&SpatialContributor> = output.worst.contributors.iter().collect();
        own.sort_by(|a, b| b.part_si.total_cmp(&a.part_si));
        let rows = own.into_iter().map(|own| {
            let mut cells = contributor(own, output, Medium::Page);
            let whole = output.worst_case_si();
            cells.insert(2, share_bar(if whole > 0.0 { own.part_si / whole } else { 0.0 }, writer));
            cells
        });
        let heading = format!("{}: {}, at {}", output.name, output.words, place(record, output, Medium::Page));
        Group { heading: heading.into(), rows: rows.collect() }
    });
    let columns = vec![
        Column::words("Joint"),
        Column::numbers("Part of the worst case"),
        Column::words("Share"),
        Column::numbers("Offset alone"),
        Column::numbers("Lean alone"),
        Column::numbers("Axial"),
    ];
    let has_conditions = record.outputs.iter().any(|output| output.worst.conditions > 0);
    let shares = if has_conditions {
        " Where plays must meet conditions together, a part is the joint's share, not what it does alone."
    } else {
        ""
    };
    let caption = format!(
        "The parts of all joints add up to the linear estimate of the worst case. An offset and a lean of a journal share its clearance, so that \
                   the effects of each alone add up to more than the part of both.{shares}"
    );
    let mut section = Section::headed_on_page("contributors", "Contribution of each joint");
    section.push(Content::Table(Table {
        columns,
        groups: groups.collect(),
        caption: caption.into(),
        ..Table::default()
    }));
    Some(section)
}

/// What each joint contributes, as a section of the page of a study: play alone, unknown clearances where there is most of it.
pub(crate) fn joints_section(record: &SpatialMotionRecord) -> Option<Section> {
    let section = contributors_on_page(record)?;
    Some(Section { id: "joints", ..section })
}

/// The same of one output on a terminal: the first of those that are `asked` about, or the main one where these are parts of paths.
pub(crate) fn joints_text(record: &SpatialMotionRecord, asked: &[OutputDescription]) -> Option<Section> {
    let known = asked.iter().find_map(|asked| record.outputs.iter().find(|output| output.name == asked.name));
    let shown = known.or_else(|| record.main_output()).filter(|_| record.has_play)?;
    Some(contributors_on_terminal(record, shown))
}

/// Where the worst case of an output is largest.
pub(super) fn place(record: &SpatialMotionRecord, output: &SpatialOutputRecord, medium: Medium) -> String {
    shown_input(record, output.worst.sample, medium)
}

fn contributor(own: &SpatialContributor, output: &SpatialOutputRecord, medium: Medium) -> Vec<Cell> {
    let value = |value_si: f64| shown_deviation(value_si, output, medium);
    let cells = [
        Some(own.joint.clone()),
        Some(value(own.part_si)),
        Some(value(own.offset_si)),
        own.lean_si.map(value),
        own.axial_si.map(value),
    ];
    cells.into_iter().map(Cell::from).collect()
}
