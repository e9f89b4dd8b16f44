//! Wear of the joints of a run: numbers, checks, and profiles around the pin.

use maud::{Markup, html};
use std::f64::consts::TAU;

use crate::charts::figure::{csv_number, name_of};
use crate::medium::article_page::push_figure;
use crate::numbers::number::NumberWriter;
use crate::words::wording::head;
use loosepin_result::simulation::{JointWearRecord, SimulationRecord, SurfaceWear};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

use super::life::push_life;
use super::wear_picture::{DepthScale, depth_figure, shape};
use super::wear_words::{deepest_words, life_words, units_of_wear, wear_sentences, wear_units};

/// `None` if no joint wears.
pub(super) fn wear_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Section> {
    let first = record.wear.first()?;
    let units = wear_units(&record.display_units);
    let of_wear = &writer.in_units(&units);
    let mut section = Section::headed_on_page("wear", "Wear");
    section.push(Content::sentences([life_words(record, first, of_wear)]));
    section.push(Content::Table(table(record, of_wear)));
    let short = "friction path: of a cycle; sectors: from the x axis of the body with the surface";
    section.push_close_on(Medium::Terminal, Content::Note(short.into()));
    for sentence in record.wear.iter().flat_map(|wear| wear_sentences(wear, record.life.is_some(), of_wear)) {
        section.push_close(Content::Note(sentence.into()));
    }
    push_figure(&mut section, writer, || {
        html! { div.orbits { @for wear in &record.wear { (profile_figure(wear, of_wear)) } } }
    });
    if let Some(life) = &record.life {
        push_life(&mut section, life, of_wear, writer);
    }
    Some(section)
}

/// A row for each surface that wears.
fn table(record: &SimulationRecord, writer: &NumberWriter) -> Table {
    let [of_coefficient, of_volume] = units_of_wear();
    let columns = vec![
        Column::words(head("surface")),
        Column::numbers(head("coefficient")),
        Column::numbers(Text::by_medium("Friction path of a cycle", "friction path")),
        Column::numbers(head("volume")),
        Column::numbers(head("greatest depth")),
        Column::numbers(head("in the sector from")),
    ];
    let row = |(wear, surface): (&JointWearRecord, &SurfaceWear)| -> Vec<Cell> {
        vec![
            format!("{}, {}", wear.joint, surface.surface.word()).into(),
            writer.value_trimmed(surface.coefficient_m2_n, &of_coefficient).into(),
            writer.value(wear.friction_path_j, &SiUnit::ENERGY).into(),
            writer.value(surface.volume_m3, &of_volume).into(),
            writer.value(surface.greatest_depth_m, &SiUnit::LENGTH).into(),
            deepest_words(surface, writer).into(),
        ]
    };
    let surfaces = record.wear.iter().flat_map(|wear| wear.surfaces.iter().map(move |surface| (wear, surface)));
    Table::new(columns, surfaces.map(row))
}

/// Depths around the pin.
fn profile_figure(wear: &JointWearRecord, writer: &NumberWriter) -> Markup {
    let greatest_m = wear.surfaces.iter().map(|surface| surface.greatest_depth_m).fold(0.0, f64::max);
    let scale = DepthScale::new(greatest_m);
    let surfaces = html! {
        @for surface in &wear.surfaces {
            @let (radius, class) = shape(surface.surface);
            path class=(class) fill-rule="evenodd" d=(outline(surface, &scale)) {}
            circle.surface r=(radius) {}
        }
    };
    let greatest = writer.value_trimmed(greatest_m, &SiUnit::LENGTH);
    let alternative = format!("Depth of wear around the pin of {}: at most {greatest}.", wear.joint);
    let caption = html! {
        strong { (wear.joint) } ". Depth by sector, from the x axis of each body: of the bearing outwards, of the journal inwards. "
        "Greatest depth " (greatest) "."
    };
    depth_figure(name_of("wear", &wear.joint), (alternative, caption), &surfaces, &csv(wear, writer))
}

/// The area between a surface and its worn outline: stairs over the sectors, and the circle.
fn outline(surface: &SurfaceWear, scale: &DepthScale) -> String {
    let (radius, _) = shape(surface.surface);
    let width_rad = TAU / surface.depth_m.len() as f64;
    let mut path = String::new();
    for (sector, depth_m) in surface.depth_m.iter().enumerate() {
        let worn = scale.worn_radius(surface.surface, *depth_m);
        for edge in [sector, sector + 1] {
            let (sine, cosine) = (edge as f64 * width_rad).sin_cos();
            path.push_str(&format!(
                "{}{:.1} {:.1}",
                if path.is_empty() { "M" } else { "L" },
                worn * cosine,
                worn * sine
            ));
        }
    }
    format!("{path}ZM{radius} 0A{radius} {radius} 0 1 0 -{radius} 0A{radius} {radius} 0 1 0 {radius} 0Z")
}

/// The depths: a row for each sector.
fn csv(wear: &JointWearRecord, writer: &NumberWriter) -> String {
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let heads = wear.surfaces.iter().map(|surface| format!("{} [{symbol}]", surface.surface.word()));
    let heads: Vec<String> = ["from [deg]", "to [deg]"].map(str::to_owned).into_iter().chain(heads).collect();
    let mut table = format!("{}\n", heads.join(","));
    let sectors = wear.surfaces.first().map_or(0, |surface| surface.depth_m.len());
    for sector in 0..sectors {
        let edges = [sector, sector + 1].map(|edge| 360.0 * edge as f64 / sectors as f64);
        let depths = wear.surfaces.iter().filter_map(|surface| surface.depth_m.get(sector));
        let depths = depths.map(|depth_m| writer.scaled(*depth_m, &SiUnit::LENGTH));
        let cells: Vec<String> = edges.into_iter().chain(depths).map(csv_number).collect();
        table.push_str(&format!("{}\n", cells.join(",")));
    }
    table
}
