//! Charts over the cycle: the effect of play; positions, velocities, accelerations.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::{capitalised, count, named_words};
use loosepin_result::kinematics::{MechanicalAdvantage, TransmissionAngle};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_result::point_path::PointPath;
use loosepin_text::units::SiUnit;

use super::angles::angle_chart;
use super::lean::journals_lean;
use super::moved::has_clearance;
use super::play_effect::{Shown, is_spread_anywhere, play_effect};
use super::searched::is_together;

/// Explanation of the charts, and a chart of each output but the first, whose chart stands below the answer.
pub(super) fn clearance(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    let places = match journals_lean(record) {
        true => "Each journal may be anywhere in its play: offsets, leans and axial displacements at once.",
        false => "Each journal may be anywhere in its clearance circle, as far as the loops close.",
    };
    let spread = match record.outputs.iter().any(is_spread_anywhere) {
        true => " The standard deviation assumes all places alike.",
        false => "",
    };
    html! {
        @if is_together(record) { p {
            (places) " The band is the worst case of first order. Where it is largest, a search closed the loops exactly." (spread)
            " Inertia and impacts are not included."
        } } @else { p {
            "Each journal may be anywhere in its clearance circle. The worst case is the largest deviation found by a search over all these positions, with the exact geometry of the links. No position leads beyond the proven ends. The standard deviations assume journals uniformly distributed over their circles, or over the rims. Inertia and impacts are not \
             included: use " code { "simulate" } " and " code { "study" } " for them."
        } }
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
    band("with pins that do not lean", Role::Mean, false, &answer.held_first_order_si);
    band(
        "± standard deviation, pins anywhere in the clearance",
        Role::Random,
        true,
        &answer.disc_standard_deviation_si,
    );
    band("± standard deviation, pins at its edge", Role::Mean, false, &answer.rim_standard_deviation_si);
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
    // A gap where nothing is proven.
    let known = |value: &f64| if value.is_finite() { *value } else { f64::NAN };
    let ends = ends.map(|end| end.iter().map(known).collect::<Vec<f64>>());
    if ends.iter().all(|end| end.iter().any(|value| value.is_finite())) {
        let [lower, upper] = ends.map(|values| scaled(&values, &output.unit, writer));
        chart.entries.push(Entry::new("proven ends", Role::Limit, true, EntryValues::pair(&lower, &upper)));
    }
}

/// Position, velocity and acceleration of each output and of each path: one chart at a time.
pub(super) fn ideal_motion(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    html! {
        div.charts {
            @for mover in movers(record) {
                @let charts = Derivative::ALL.into_iter().filter_map(|which| {
                    Some((which.words().to_owned(), motion_chart(record, mover, which, writer)?.figure()))
                });
                (chooser(&mover.words(), charts.collect()))
            }
        }
    }
}

/// A position or one of its first two derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Derivative {
    Position,
    Velocity,
    Acceleration,
}

impl Derivative {
    pub const ALL: [Derivative; 3] = [Derivative::Position, Derivative::Velocity, Derivative::Acceleration];

    pub fn words(self) -> &'static str {
        match self {
            Derivative::Position => "position",
            Derivative::Velocity => "velocity",
            Derivative::Acceleration => "acceleration",
        }
    }

    /// Its unit, if a position has `unit`.
    fn unit(self, unit: &SiUnit) -> SiUnit {
        let found = match self {
            Derivative::Position => Some(unit.clone()),
            Derivative::Velocity => unit.per_second(),
            Derivative::Acceleration => unit.per_second().as_ref().and_then(SiUnit::per_second),
        };
        found.unwrap_or(SiUnit::NONE)
    }
}

/// A path in words: of an output with its name.
pub(super) fn path_words(path: &PointPath) -> String {
    path.output.as_ref().map_or_else(|| path.point.clone(), |output| named_words(output, &path.point))
}

/// An output that moves by itself, or a path.
#[derive(Debug, Clone, Copy)]
pub(super) enum Mover<'r> {
    Output(&'r OutputMotion),
    Path(&'r PointPath),
}

/// All of them, outputs first.
pub(super) fn movers(record: &MotionRecord) -> impl Iterator<Item = Mover<'_>> {
    let outputs = record.outputs.iter().filter(|output| !output.is_of_path()).map(Mover::Output);
    outputs.chain(record.paths.iter().map(Mover::Path))
}

impl<'r> Mover<'r> {
    pub fn name(self) -> &'r str {
        match self {
            Mover::Output(output) => &output.name,
            Mover::Path(path) => &path.name,
        }
    }

    pub fn words(self) -> String {
        match self {
            Mover::Output(output) => named_words(&output.name, &output.words),
            Mover::Path(path) => path.point.clone(),
        }
    }

    /// The same, with its name where that is not in the words: the name of a further point is the point.
    pub fn named_words(self) -> String {
        match self {
            Mover::Output(_) => self.words(),
            Mover::Path(path) => path_words(path),
        }
    }

    /// Whether the record has this derivative of it.
    pub fn has(self, which: Derivative) -> bool {
        let values_si = match (self, which) {
            (Mover::Output(output), Derivative::Position) => &output.value_si,
            (Mover::Output(output), Derivative::Velocity) => &output.velocity_si,
            (Mover::Output(output), Derivative::Acceleration) => &output.acceleration_si,
            (Mover::Path(path), Derivative::Position) => &path.x_m,
            (Mover::Path(path), Derivative::Velocity) => &path.velocity_x_m_s,
            (Mover::Path(path), Derivative::Acceleration) => &path.acceleration_x_m_s2,
        };
        !values_si.is_empty()
    }

    fn unit(self) -> SiUnit {
        match self {
            Mover::Output(output) => output.unit.clone(),
            Mover::Path(_) => SiUnit::LENGTH,
        }
    }

    /// Its curves with their names: of a path the coordinates, and of its rates the magnitude too.
    fn lines(self, which: Derivative) -> Vec<(&'static str, Vec<f64>)> {
        match (self, which) {
            (Mover::Output(output), Derivative::Position) => vec![("", output.value_si.clone())],
            (Mover::Output(output), Derivative::Velocity) => vec![("", output.velocity_si.clone())],
            (Mover::Output(output), Derivative::Acceleration) => vec![("", output.acceleration_si.clone())],
            (Mover::Path(path), Derivative::Position) => coordinates([&path.x_m, &path.y_m, &path.z_m]),
            (Mover::Path(path), Derivative::Velocity) => {
                let mut lines = coordinates([&path.velocity_x_m_s, &path.velocity_y_m_s, &path.velocity_z_m_s]);
                lines.push(("magnitude", path.speeds_m_s()));
                lines
            }
            (Mover::Path(path), Derivative::Acceleration) => {
                let all = [&path.acceleration_x_m_s2, &path.acceleration_y_m_s2, &path.acceleration_z_m_s2];
                let mut lines = coordinates(all);
                lines.push(("magnitude", path.acceleration_magnitudes_m_s2()));
                lines
            }
        }
    }
}

/// Those of a path with their names: in the plane it has two.
fn coordinates(lists: [&Vec<f64>; 3]) -> Vec<(&'static str, Vec<f64>)> {
    let named = ["x", "y", "z"].into_iter().zip(lists);
    named.filter(|(name, list)| *name != "z" || !list.is_empty()).map(|(name, list)| (name, list.clone())).collect()
}

/// A derivative of what moves; `None` if the record does not have it.
pub(super) fn motion_chart(
    record: &MotionRecord,
    mover: Mover<'_>,
    which: Derivative,
    writer: &NumberWriter,
) -> Option<Chart> {
    let (name, words, what) = (mover.name(), mover.words(), which.words());
    let unit = &which.unit(&mover.unit());
    let lines = mover.lines(which);
    let all = || lines.iter().flat_map(|(_, values)| values);
    let tag = |part: &str| Tag::joint(name, &format!("ideal {what}"), part);
    let number = |part: &str, value_si: f64| writer.with_tag(&tag(part)).value(value_si, unit);
    let lowest = number("smallest", all().copied().reduce(f64::min)?);
    let highest = number("largest", all().copied().reduce(f64::max)?);
    let mut chart = angle_chart(record, name_of(what, name), writer);
    chart.set_vertical_axis(format!("{what} of {name}"), unit, writer);
    chart.height = 220;
    for (index, (part, values_si)) in lines.iter().enumerate() {
        let label = if part.is_empty() { format!("ideal {what}") } else { (*part).to_owned() };
        chart.entries.push(Entry::line(&label, Role::of_index(index), false, values_si, unit, writer));
    }
    let range = format!("between {lowest} and {highest}");
    chart.caption = html! { strong { "Ideal " (what) " of " (words) }  ": " (range) "." };
    chart.alternative = format!("Chart of the ideal {what} of {words} over one cycle: {range}.");
    Some(chart)
}

/// Transmission angles of the loops, and mechanical advantages of outputs and paths; `None` if neither is known.
pub(super) fn transmission(record: &MotionRecord, writer: &NumberWriter) -> Option<Markup> {
    let angles = transmission_angles(record);
    let angles = angles.map(|angle| (transmission_name(angle), transmission_chart(record, angle, writer).figure()));
    let advantages = mechanical_advantages(record);
    let advantages: Vec<_> =
        advantages.map(|each| (each.name.clone(), advantage_chart(record, each, writer).figure())).collect();
    let angles: Vec<_> = angles.collect();
    if angles.is_empty() && advantages.is_empty() {
        return None;
    }
    Some(html! {
        p {
            "The transmission angle μ lies between coupler and output link. It is best at 90°; the pressure angle of a slider is best at 0°."
            @if !advantages.is_empty() {
                " The mechanical advantage is the force on an output along its motion, or the torque on a turning one, that balances a unit \
                 torque of " (record.drive) ": A = ω/|v| by virtual power, without losses, weight, inertia, springs and loads. It is \
                 infinite in a dead centre."
            }
        }
        div.charts {
            (chooser("loops", angles))
            (chooser("outputs", advantages))
        }
    })
}

/// Those whose course is known.
pub(super) fn transmission_angles(record: &MotionRecord) -> impl Iterator<Item = &TransmissionAngle> {
    record.kinematics.transmission_angles.iter().filter(|angle| !angle.value_rad.is_empty())
}

/// Those of outputs that move, and are not the drive itself. Older records, without the least value between positions, have the drive among them:
/// its advantage is 1 all over.
pub(super) fn mechanical_advantages(record: &MotionRecord) -> impl Iterator<Item = &MechanicalAdvantage> {
    let is_one = |each: &MechanicalAdvantage| each.value_si.iter().all(|value| (value - 1.0).abs() <= 1e-9);
    record.kinematics.mechanical_advantages.iter().filter(move |each| each.least_si.is_some() || !is_one(each))
}

pub(super) fn transmission_name(angle: &TransmissionAngle) -> String {
    let [coupler, output] = &angle.bodies;
    format!("{coupler} and {output}")
}

pub(super) fn transmission_chart(record: &MotionRecord, angle: &TransmissionAngle, writer: &NumberWriter) -> Chart {
    let kind = if angle.is_pressure_angle { "pressure angle" } else { "transmission angle" };
    let name = transmission_name(angle);
    let mut chart = angle_chart(record, name_of(&kind.replace(' ', "-"), &angle.bodies.join(" ")), writer);
    chart.set_vertical_axis(kind, &SiUnit::ANGLE, writer);
    chart.height = 220;
    chart.entries.push(Entry::line(kind, Role::First, false, &angle.value_rad, &SiUnit::ANGLE, writer));
    let number = |end: usize| {
        let tag = Tag::joint(&name, kind, ["smallest", "largest"][end]);
        writer.with_tag(&tag).value(angle.extremes_rad[end], &SiUnit::ANGLE)
    };
    let range = format!("between {} and {}", number(0), number(1));
    chart.caption = html! { strong { (capitalised(kind)) " of " (name) } ": " (range) "." };
    chart.alternative = format!("Chart of the {kind} of {name} over one cycle: {range}.");
    chart
}

/// Charts show mechanical advantages up to this many times the least one: they grow beyond all limits towards dead centres.
const SHOWN_ADVANTAGE: f64 = 6.0;

pub(super) fn advantage_chart(record: &MotionRecord, each: &MechanicalAdvantage, writer: &NumberWriter) -> Chart {
    let MechanicalAdvantage { name, unit, value_si, least_si } = each;
    let mut chart = angle_chart(record, name_of("mechanical-advantage", name), writer);
    chart.set_vertical_axis("mechanical advantage", unit, writer);
    chart.height = 220;
    chart.entries.push(Entry::line("mechanical advantage", Role::First, false, value_si, unit, writer));
    let least = least_si.unwrap_or_else(|| value_si.iter().copied().fold(f64::INFINITY, f64::min));
    let most = value_si.iter().copied().fold(0.0, f64::max);
    let shown = most.min(SHOWN_ADVANTAGE * least);
    chart.y_range = Some([0.0, 1.05 * writer.scaled(shown, unit)]);
    let tag = |part: &str| Tag::joint(name, "mechanical advantage", part);
    let least_words = writer.with_tag(&tag("smallest")).value(least, unit);
    let cut = if most > shown {
        let times = writer.with_tag(&Tag::Given("shown mechanical advantage")).count(SHOWN_ADVANTAGE as u64);
        format!(" Drawn up to {times} times that.")
    } else {
        String::new()
    };
    let positions = || count(value_si.len() as u64, &writer.with_tag(&Tag::Count("positions")));
    let range = match least_si {
        Some(_) => format!("at least {least_words}"),
        // Older records do not know it between their positions.
        None => format!("the smallest of the {} positions is {least_words}", positions()),
    };
    chart.caption = html! { strong { "Mechanical advantage at " (name) } ": " (range) "." (cut) };
    chart.alternative = format!("Chart of the mechanical advantage at {name} over one cycle: {range}.");
    chart
}

/// Figures of which one is shown at a time: those of a page without its script are all there.
fn chooser(of: &str, choices: Vec<(String, Markup)>) -> Markup {
    if choices.is_empty() {
        return html! {};
    }
    html! {
        div.chooser data-chooser=(of) {
            @for (label, figure) in choices { div.choice data-choice=(label) { (figure) } }
        }
    }
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
