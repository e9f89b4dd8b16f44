//! Charts over the cycle: the effect of play; positions, velocities, accelerations.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::named_words;
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_text::units::SiUnit;

use super::angles::angle_chart;
use super::answer::has_clearance;
use super::play_effect::{Shown, play_effect};

/// Explanation of the charts, and a chart of each output but the first, whose chart stands below the answer.
pub(super) fn clearance(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Each journal may be anywhere in its clearance circle. The worst case is the largest deviation found by a search over all these positions, with the exact geometry of the links. No position leads beyond the proven ends. The standard deviations assume journals uniformly distributed over their circles, or over the rims. Inertia and impacts are not \
             included: use " code { "simulate" } " and " code { "study" } " for them."
        }
        @for output in record.outputs.iter().filter(|output| has_clearance(output)).skip(1) {
            (clearance_chart(record, output, writer).figure())
        }
    }
}

/// The deviation of an output by play over the cycle.
pub(super) fn clearance_chart(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Chart {
    let mut chart = angle_chart(record, name_of("clearance", &output.name), writer);
    chart.set_vertical_axis(format!("deviation of {}", output.name), &output.unit, writer);
    chart.height = 340;
    let mut band = |label: &str, role: Role, filled: bool, values_si: &[f64]| {
        if values_si.is_empty() {
            return;
        }
        let upper = scaled(values_si, &output.unit, writer);
        let lower: Vec<f64> = upper.iter().map(|value| -value).collect();
        let values = if filled { EntryValues::band(&lower, &upper) } else { EntryValues::pair(&lower, &upper) };
        chart.entries.push(Entry::new(label, role, !filled, values));
    };
    let answer = &output.clearance;
    let effect = play_effect(record, output);
    if effect.shown == Shown::FirstOrder {
        band("first order", Role::Mixed, true, &answer.first_order_si);
    }
    band("± standard deviation, anywhere in the circles", Role::Random, true, &answer.disc_standard_deviation_si);
    band("± standard deviation, on the rims", Role::Mean, false, &answer.rim_standard_deviation_si);
    band("± standard deviation of the dimensions", Role::Probability, false, &output.dimensional_standard_deviation_si);
    add_worst_case(&mut chart, output, writer);
    let words = format!("{} ({})", effect.written(output, writer), effect.words(record, output, writer));
    chart.caption = html! {
        strong { "Quasi-static effect of play on " (named_words(&output.name, &output.words)) "." } " At most " (words) "."
    };
    chart.alternative = format!(
        "Chart of the quasi-static effect of play on {} over one cycle: at most {words}.",
        named_words(&output.name, &output.words)
    );
    chart
}

/// The band between the lowest and the highest deviation found, and the proven ends where there are any.
fn add_worst_case(chart: &mut Chart, output: &OutputMotion, writer: &NumberWriter) {
    let answer = &output.clearance;
    if answer.worst_case_si.is_empty() {
        return;
    }
    let [lower, upper] = [&answer.lowest_si, &answer.highest_si].map(|values| scaled(values, &output.unit, writer));
    chart.entries.insert(0, Entry::new("worst case, found", Role::Mixed, false, EntryValues::band(&lower, &upper)));
    let ends = [&answer.proven_lowest_si, &answer.proven_highest_si];
    if ends.iter().all(|end| end.iter().all(|value| value.is_finite())) {
        let [lower, upper] = ends.map(|values| scaled(values, &output.unit, writer));
        chart.entries.push(Entry::new("proven ends", Role::Limit, true, EntryValues::pair(&lower, &upper)));
    }
}

/// Charts of each output.
pub(super) fn ideal_motion(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    html! {
        div.charts {
            @for output in &record.outputs {
                (motion_chart(record, output, "position", &output.value_si, Some(output.unit.clone()), writer))
                @let rate = output.unit.per_second();
                (motion_chart(record, output, "velocity", &output.velocity_si, rate.clone(), writer))
                @let second = rate.and_then(|rate| rate.per_second());
                (motion_chart(record, output, "acceleration", &output.acceleration_si, second, writer))
            }
        }
    }
}

fn motion_chart(
    record: &MotionRecord,
    output: &OutputMotion,
    what: &str,
    values_si: &[f64],
    unit: Option<SiUnit>,
    writer: &NumberWriter,
) -> Markup {
    let unit = unit.unwrap_or(SiUnit::NONE);
    let Some([lowest, highest]) = range(output, what, values_si, &unit, writer) else { return html! {} };
    let mut chart = angle_chart(record, name_of(what, &output.name), writer);
    chart.set_vertical_axis(format!("{what} of {}", output.name), &unit, writer);
    chart.height = 220;
    chart.entries.push(Entry::line(&format!("ideal {what}"), Role::First, false, values_si, &unit, writer));
    let name = named_words(&output.name, &output.words);
    let range = format!("between {lowest} and {highest}");
    chart.caption = html! { strong { "Ideal " (what) " of " (name) }  ": " (range) "." };
    chart.alternative = format!("Chart of the ideal {what} of {name} over one cycle: {range}.");
    chart.figure()
}

/// The smallest and the largest value of a history; `None` if it has none.
pub(super) fn range(
    output: &OutputMotion,
    what: &str,
    values_si: &[f64],
    unit: &SiUnit,
    writer: &NumberWriter,
) -> Option<[String; 2]> {
    let number = |part: &str, value_si: f64| {
        writer.with_tag(&Tag::joint(&output.name, &format!("ideal {what}"), part)).value(value_si, unit)
    };
    let lowest = values_si.iter().copied().reduce(f64::min)?;
    let highest = values_si.iter().copied().reduce(f64::max)?;
    Some([number("smallest", lowest), number("largest", highest)])
}
