//! Wear over the cycles of a life: numbers, clearance and deviations over the cycles, and the profile at some of them.

use maud::{Markup, html};
use std::f64::consts::TAU;

use crate::charts::chart::{Chart, Entry, Role};
use crate::charts::figure::{csv_number, name_of};
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{counted, head};
use loosepin_result::simulation::{JointLifeRecord, SurfaceLifeRecord, WearLifeRecord};
use loosepin_text::article::{Column, Content, Medium, Section, Table};
use loosepin_text::units::SiUnit;

use super::wear_picture::{DepthScale, depth_figure, shape};
use super::wear_words::units_of_wear;

/// Rows of the table over the cycles, at most.
const ROWS: usize = 9;
/// Profiles in the picture of a joint, at most.
const PROFILES: usize = 5;

/// The rows of a life that are shown: the first, the last and some between, evenly.
fn shown_rows(life: &WearLifeRecord, most: usize) -> Vec<usize> {
    let last = life.cycles.len().saturating_sub(1);
    let count = most.min(last + 1).max(1);
    let mut rows: Vec<usize> = (0..count).map(|k| if count > 1 { last * k / (count - 1) } else { 0 }).collect();
    rows.dedup();
    rows
}

/// The table over the cycles. Of every joint its friction path, greatest depths and largest clearance; then the largest deviations of the
/// outputs.
fn life_table(life: &WearLifeRecord, writer: &NumberWriter) -> Table {
    let mut columns = vec![Column::numbers(head("cycles"))];
    let is_one = life.joints.len() == 1;
    for joint in &life.joints {
        let of = |words: &str| {
            Column::numbers(if is_one { head(words) } else { format!("{}: {words}", joint.joint).into() })
        };
        columns.push(of("friction path"));
        columns.extend(joint.surfaces.iter().map(|surface| of(&format!("depth of {}", surface.surface.word()))));
        columns.push(of("clearance up to"));
    }
    // A terminal has room for one: that of the limit, or the first.
    let limited = life.limit.as_ref().and_then(|limit| life.outputs.iter().position(|own| own.name == limit.output));
    columns.extend(life.outputs.iter().enumerate().map(|(place, output)| Column {
        only: (place != limited.unwrap_or(0)).then_some(Medium::Page),
        ..Column::numbers(head(&format!("deviation of {}", output.name)))
    }));
    let row = |row: usize| {
        let mut cells = vec![writer.value_trimmed(life.cycles[row].round(), &SiUnit::NONE)];
        for joint in &life.joints {
            cells.push(writer.value(joint.friction_path_j[row], &SiUnit::ENERGY));
            let surfaces = joint.surfaces.iter();
            cells.extend(surfaces.map(|surface| writer.value(surface.greatest_depth_m[row], &SiUnit::LENGTH)));
            cells.push(writer.value(joint.largest_clearance_m[row], &SiUnit::LENGTH));
        }
        cells.extend(life.outputs.iter().map(|output| writer.value(output.deviation_si[row], &output.unit)));
        cells
    };
    Table::new(columns, shown_rows(life, ROWS).into_iter().map(row))
}

/// The cycles until the limit is passed, where there is a limit.
pub(super) fn life_sentence(life: &WearLifeRecord, writer: &NumberWriter) -> Option<String> {
    let limit = life.limit.as_ref()?;
    let most = writer.value_trimmed(limit.limit_si, &limit.unit);
    let output = &limit.output;
    let cycles = |cycles: f64| writer.value_trimmed(cycles.round(), &SiUnit::NONE);
    let all = life.cycles.last().copied().unwrap_or(0.0);
    Some(match (limit.cycles, limit.between) {
        (Some(_), Some([_, 0.0])) => {
            format!("Life: none. The largest deviation of {output} is beyond {most} without wear.")
        }
        (Some(own), Some([from, to])) => format!(
            "Life: {} cycles until the largest deviation of {output} passes {most}, by a straight line between those after {} and {} cycles.",
            cycles(own),
            cycles(from),
            cycles(to)
        ),
        _ => format!(
            "Life: more than {} cycles. The largest deviation of {output} stays within {most} over all of them.",
            cycles(all)
        ),
    })
}

/// What is to be known of a life in sentences.
fn life_sentences(life: &WearLifeRecord, writer: &NumberWriter) -> Vec<String> {
    let mut sentences: Vec<String> = life_sentence(life, writer).into_iter().collect();
    let jumps = life.cycles.len().saturating_sub(1) as u64;
    let error = writer.rounded(life.largest_error_m, &SiUnit::LENGTH, 2, Rounding::Up);
    sentences.push(format!(
        "Cycles run: {} for {}. Error of a jump in the depth of any sector: estimated at up to {error}.",
        life.runs,
        counted(jumps, "jump", writer),
    ));
    if life.largest_noise_m > 0.0 {
        let noise = writer.rounded(life.largest_noise_m, &SiUnit::LENGTH, 2, Rounding::Up);
        sentences.push(format!("The turns of a cycle differ: their standard error is up to {noise} of a jump."));
    }
    if life.longest_over_stable > 1.0 {
        let over = writer.rounded(life.longest_over_stable, &SiUnit::NONE, 2, Rounding::Up);
        sentences.push(format!(
            "The longest jump has {over} times the cycles in which wear evens out the pressure. Above 2, the profile becomes saw-toothed although the volumes look right: use more jumps."
        ));
    }
    let [_, of_volume] = units_of_wear();
    for joint in &life.joints {
        for surface in &joint.surfaces {
            let first = writer.value(surface.first_order_volume_m3, &of_volume);
            let depth = writer.value(surface.first_order_depth_m, &SiUnit::LENGTH);
            sentences.push(format!(
                "{}, {}: if all cycles were as the first one, {first} and a greatest depth of {depth}.",
                joint.joint,
                surface.surface.word()
            ));
        }
    }
    sentences
}

/// Adds what is over the cycles to the section on wear; `plain` has the units of the outputs.
pub(super) fn push_life(section: &mut Section, life: &WearLifeRecord, writer: &NumberWriter, plain: &NumberWriter) {
    section.push_on(Medium::Page, Content::Heading("Over the cycles".into()));
    section.push(Content::Table(life_table(life, writer)));
    section.push_close(Content::sentences(life_sentences(life, writer)));
    push_figure(section, writer, || {
        html! {
            div.orbits { @for joint in &life.joints { (profiles_figure(life, joint, writer)) } }
            @for joint in &life.joints { (clearance_chart(life, joint, writer).figure()) }
            @for output in &life.outputs {
                (deviation_chart(life, &output.name, &output.deviation_si, &output.unit, plain).figure())
            }
        }
    });
}

fn clearance_chart(life: &WearLifeRecord, joint: &JointLifeRecord, writer: &NumberWriter) -> Chart {
    let unit = SiUnit::LENGTH;
    let name = name_of("clearance", &joint.joint);
    let mut chart = Chart::over(name, "cycles", &life.cycles, &SiUnit::NONE, writer);
    chart.set_vertical_axis(format!("clearance of {}", joint.joint), &unit, writer);
    chart.entries = vec![
        Entry::line("largest", Role::of_index(0), false, &joint.largest_clearance_m, &unit, writer),
        Entry::line("smallest", Role::of_index(1), true, &joint.least_clearance_m, &unit, writer),
    ];
    let largest = writer.value(joint.largest_clearance_m.last().copied().unwrap_or(0.0), &unit);
    chart.caption = html! {
        "How far the journal of " strong { (joint.joint) } " can go from the centre of the bearing, over the directions. In the end up to " (largest) "."
    };
    chart.alternative = format!("Clearance of {} over the cycles, up to {largest}.", joint.joint);
    chart
}

fn deviation_chart(
    life: &WearLifeRecord,
    output: &str,
    deviation_si: &[f64],
    unit: &SiUnit,
    writer: &NumberWriter,
) -> Chart {
    let mut chart = Chart::over(name_of("life", output), "cycles", &life.cycles, &SiUnit::NONE, writer);
    chart.set_vertical_axis(format!("largest deviation of {output}"), unit, writer);
    chart.entries = vec![Entry::line("largest deviation", Role::of_index(0), false, deviation_si, unit, writer)];
    if let Some(limit) = life.limit.as_ref().filter(|limit| limit.output == output) {
        let constant = vec![limit.limit_si; life.cycles.len()];
        chart.entries.push(Entry::line("limit", Role::of_index(1), true, &constant, unit, writer));
    }
    let largest = writer.value(deviation_si.last().copied().unwrap_or(0.0), unit);
    chart.caption = html! { "Largest deviation of " strong { (output) } " from the ideal motion in a cycle. In the end " (largest) "." };
    chart.alternative = format!("Largest deviation of {output} over the cycles; {largest} in the end.");
    chart
}

/// Depths around the pin at some of the cycles.
fn profiles_figure(life: &WearLifeRecord, joint: &JointLifeRecord, writer: &NumberWriter) -> Markup {
    let greatest_m = joint.surfaces.iter().flat_map(|surface| &surface.greatest_depth_m).copied().fold(0.0, f64::max);
    let scale = DepthScale::new(greatest_m);
    let rows: Vec<usize> = shown_rows(life, PROFILES).into_iter().filter(|row| *row > 0).collect();
    let surfaces = html! {
        @for surface in &joint.surfaces {
            @for (index, row) in rows.iter().enumerate() {
                @let opacity = 0.25 + 0.75 * (index + 1) as f64 / rows.len() as f64;
                path.surface style=(format!("stroke-opacity:{opacity:.2};stroke-width:{}", 6 + 2 * index)) d=(outline(surface, *row, &scale)) {}
            }
            circle.surface r=(shape(surface.surface).0) {}
        }
    };
    let cycles: Vec<String> =
        rows.iter().map(|row| writer.value_trimmed(life.cycles[*row].round(), &SiUnit::NONE)).collect();
    let greatest = writer.value_trimmed(greatest_m, &SiUnit::LENGTH);
    let alternative = format!("Profile of wear of {} over the cycles: at most {greatest}.", joint.joint);
    let caption = html! {
        strong { (joint.joint) } ". Depth by sector after " (cycles.join(", ")) " cycles: of the bearing outwards, of the journal inwards. "
        "Greatest depth " (greatest) "."
    };
    depth_figure(name_of("profiles", &joint.joint), (alternative, caption), &surfaces, &csv(life, joint, writer))
}

/// The worn outline through the middles of the sectors.
fn outline(surface: &SurfaceLifeRecord, row: usize, scale: &DepthScale) -> String {
    let depths_m = &surface.depth_m[row];
    let mut path = String::new();
    for (sector, depth_m) in depths_m.iter().enumerate() {
        let worn = scale.worn_radius(surface.surface, *depth_m);
        let (sine, cosine) = ((sector as f64 + 0.5) * TAU / depths_m.len() as f64).sin_cos();
        path.push_str(&format!("{}{:.1} {:.1}", if path.is_empty() { "M" } else { "L" }, worn * cosine, worn * sine));
    }
    path + "Z"
}

/// Depths of all sectors at the ends of all jumps.
fn csv(life: &WearLifeRecord, joint: &JointLifeRecord, writer: &NumberWriter) -> String {
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let columns = joint.surfaces.iter().flat_map(|surface| surface.depth_m.iter().map(move |own| (surface, own)));
    let columns: Vec<(&SurfaceLifeRecord, &Vec<f64>)> = columns.collect();
    let count = life.cycles.len();
    let heads = columns.iter().enumerate().map(|(index, (surface, _))| {
        format!("{} after {} [{symbol}]", surface.surface.word(), life.cycles[index % count])
    });
    let mut table = format!("from [deg],{}\n", heads.collect::<Vec<_>>().join(","));
    let sectors = columns.first().map_or(0, |(_, depths_m)| depths_m.len());
    for sector in 0..sectors {
        let depths = columns.iter().map(|(_, depths_m)| writer.scaled(depths_m[sector], &SiUnit::LENGTH));
        let cells = std::iter::once(360.0 * sector as f64 / sectors as f64).chain(depths).map(csv_number);
        table.push_str(&format!("{}\n", cells.collect::<Vec<_>>().join(",")));
    }
    table
}
