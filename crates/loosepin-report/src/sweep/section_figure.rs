//! A bifurcation diagram: for every value of the quantity the points of its Poincaré section.

use maud::{Markup, html};

use crate::charts::axes::{Axes, Axis, with_unit};
use crate::charts::figure::{Picture, csv_number, csv_text, name_of};
use crate::medium::script_data::{CHART_DIGITS, round_to_digits};
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::{count, named_words};
use loosepin_result::sweep::{SweepPoint, SweepRecord};
use loosepin_text::units::SiUnit;

/// Width and height of the picture in its own units; a unit is about a pixel.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 420.0;

/// One dot for every turn of every value, in two colours: motion that repeats itself, and motion that does not.
pub(super) fn section_figure(record: &SweepRecord, output: usize, writer: &NumberWriter) -> Markup {
    let swept = &record.outputs[output];
    let (across, up) = (writer.units.of(&record.unit), writer.units.of(&swept.unit));
    let x_axis = Axis::over(record.points.iter().map(|point| across.from_si(point.value_si)));
    let sections = || record.points.iter().filter_map(|point| Some((point, point.sections_si.get(output)?)));
    let y_axis = Axis::over(sections().flat_map(|(_, section)| section.iter().map(|v| up.from_si(*v)))).with_margin();
    let axes = Axes { width: WIDTH, height: HEIGHT, x: x_axis, y: y_axis };
    let dots = |is_wanted: &dyn Fn(&SweepPoint) -> bool| {
        let mut path = String::new();
        for (point, section) in sections().filter(|(point, _)| is_wanted(point)) {
            let x = axes.x_position(across.from_si(point.value_si));
            for value_si in section.iter().filter(|value_si| value_si.is_finite()) {
                path.push_str(&format!("M{x:.1} {:.1}h0", axes.y_position(up.from_si(*value_si))));
            }
        }
        path
    };
    let name = named_words(&swept.name, &swept.words);
    let angle =
        writer.with_tag(&Tag::Given("angle of the section")).value_trimmed(record.section_angle_rad, &SiUnit::ANGLE);
    let turns = count(u64::from(record.recorded_turns), &writer.with_tag(&Tag::Given("turns that are examined")));
    let alternative = format!(
        "Bifurcation diagram: deviation of {name} once a turn, at {angle} of {}, over {}; {turns} turns for each of {} values.",
        record.drive,
        record.path,
        record.points.len()
    );
    let drawn = html! {
        (axes.grid())
        path.irregular d=(dots(&|point| point.period_turns.is_none())) {}
        path.regular d=(dots(&|point| point.period_turns.is_some())) {}
        (axes.labels([&record.path, &across.symbol], [&format!("deviation of {}", swept.name), &up.symbol]))
    };
    let caption = html! {
                strong { "Once a turn, at " (angle) " of " (record.drive) ": the deviation of " (name) "." }
                " A dot for each of " (turns) " turns; "
                span.regular { "blue" } " if the motion repeats, "
                span.irregular { "orange" } " if not."
    };
    let name = name_of("bifurcation", &swept.name);
    Picture { name, class: "section", view: [0.0, 0.0, WIDTH, HEIGHT], below: 0.0, alternative, drawn }
        .figure(caption, Some(&csv(record, output, writer)))
}

/// The dots: a row for each value, a column for each turn. A long sweep has many: no more digits than a chart has.
fn csv(record: &SweepRecord, output: usize, writer: &NumberWriter) -> String {
    let swept = &record.outputs[output];
    let (across, up) = (writer.units.of(&record.unit), writer.units.of(&swept.unit));
    let sections = || record.points.iter().filter_map(|point| Some((point, point.sections_si.get(output)?)));
    let turns = sections().map(|(_, section)| section.len()).max().unwrap_or(0);
    let of_turn = |turn| with_unit(&format!("deviation of {}, turn {turn}", swept.name), &up.symbol);
    let heads = [with_unit(&record.path, &across.symbol), "repeats after turns".to_owned()].into_iter();
    let heads: Vec<String> = heads.chain((1..=turns).map(of_turn)).map(|head| csv_text(&head)).collect();
    let mut table = format!("{}\n", heads.join(","));
    for (point, section) in sections() {
        let period = point.period_turns.map_or(String::new(), |turns| turns.to_string());
        let number =
            |value: f64| round_to_digits(value, CHART_DIGITS).map_or(String::new(), |number| number.to_string());
        let own =
            (0..turns).map(|turn| section.get(turn).map_or(String::new(), |value_si| number(up.from_si(*value_si))));
        let cells: Vec<String> = [csv_number(across.from_si(point.value_si)), period].into_iter().chain(own).collect();
        table.push_str(&format!("{}\n", cells.join(",")));
    }
    table
}
