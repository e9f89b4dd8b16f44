//! Wear of the joints of a run: numbers, checks, and profiles around the pin.

use super::figure::{csv_number, name_of};
use super::life_section::life_part;
use super::number::NumberWriter;
use super::page::cards;
use super::wear_picture::{DepthScale, depth_figure, shape};
use super::wear_words::{deepest_words, life_words, units_of_wear, wear_sentences, wear_units};
use loosepin_result::simulation::{JointWearRecord, SimulationRecord, SurfaceWear};
use loosepin_text::units::SiUnit;
use maud::{Markup, html};
use std::f64::consts::TAU;

/// The section.
pub(super) fn wear_section(record: &SimulationRecord) -> Markup {
    let units = wear_units(&record.display_units);
    let writer = NumberWriter::for_page(&units);
    let [of_coefficient, of_volume] = units_of_wear();
    let rows = record.wear.iter().flat_map(|wear| wear.surfaces.iter().map(move |surface| (wear, surface)));
    let rows = rows.map(|(wear, surface)| {
        [
            html! { (wear.joint) ", " (surface.surface.word()) },
            html! { (writer.value_trimmed(surface.coefficient_m2_n, &of_coefficient)) },
            html! { (writer.value(wear.friction_path_j, &SiUnit::ENERGY)) },
            html! { (writer.value(surface.volume_m3, &of_volume)) },
            html! { (writer.value(surface.greatest_depth_m, &SiUnit::LENGTH)) },
            html! { (deepest_words(surface, &writer)) },
        ]
    });
    let heads =
        ["Surface", "#Coefficient", "#Friction path of a cycle", "#Volume", "#Greatest depth", "#In the sector from"];
    let told: Vec<String> =
        record.wear.iter().flat_map(|wear| wear_sentences(wear, record.life.is_some(), &writer)).collect();
    html! {
        @if let Some(wear) = record.wear.first() { p { (life_words(record, wear, &writer)) } }
        (cards(heads, rows))
        @for sentence in &told { p.quiet { (sentence) } }
        div.orbits { @for wear in &record.wear { (profile_figure(wear, &writer)) } }
        @if let Some(life) = &record.life { (life_part(record, life)) }
    }
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
