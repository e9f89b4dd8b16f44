//! The page of the ideal motion: outputs, the quasi-static worst case and its contributors, the mechanism.

use maud::{Markup, html};

use super::chart::{Chart, Entry, EntryValues, Role, scaled};
use super::figure::name_of;
use super::mechanism_figure::mechanism_figure;
use super::motion_angles::{largest, told_rad, turn_angle};
use super::motion_verdicts::{verdict_headline, verdict_sentences};
use super::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use super::page::{Page, Section, cards, facts, sentences};
use super::play_effect::{Shown, play_effect, unproven_sentences};
use super::repeat_section::repeat_section;
use super::still_figures::percent_of;
use super::wording::{listed, named_words};
use loosepin_result::motion::{EffortMotion, GuideOverhang, MotionRecord, OutputMotion, PathMotion};
use loosepin_result::study::PathError;
use loosepin_text::units::SiUnit;

/// The page of an ideal motion as one HTML text that needs no network: position, velocity and acceleration of the
/// outputs, the quasi-static worst case and standard deviations of the clearances, and what each joint contributes.
/// Text from files is escaped.
pub fn motion_page(record: &MotionRecord) -> String {
    let writer = NumberWriter::for_page(&record.display_units);
    let first = record.outputs.iter().position(has_clearance);
    let below = match first {
        Some(index) => clearance_chart(record, &record.outputs[index], &writer).figure(),
        None => record
            .outputs
            .iter()
            .find(|output| has_scatter(output))
            .map_or_else(Markup::default, |output| scatter_chart(record, output, &writer).figure()),
    };
    let shown_scatter = if first.is_some() { None } else { record.outputs.iter().position(has_scatter) };
    let mut sections = Vec::new();
    if record.outputs.iter().any(has_clearance) {
        sections.push(Section::new("clearance", "Effect of play", clearance(record, first, &writer)));
        sections.push(Section::new("contributors", "Contribution of each joint", contributors(record, &writer)));
    }
    if record.outputs.iter().any(has_scatter) {
        sections.push(Section::new("scatter", "Effect of part scatter", scatter(record, shown_scatter, &writer)));
    }
    sections.push(Section::new("motion", "Ideal motion", motion(record, &writer)));
    if !record.efforts.is_empty() {
        sections.push(Section::new("efforts", "What the drives must do", efforts(record, &writer)));
    }
    sections.push(Section::new("method", "How this was computed", method(record, &writer)));
    sections.extend(repeat_section(&record.repeat));
    Page {
        title: record.model.clone(),
        kicker: "Ideal motion and quasi-static accuracy",
        subtitle: html! {
            (record.mobility)
            @if let Some(speed) = record.drive_speed_rad_s {
                " · " (record.drive) " at " (writer.value_shortest(speed, &SiUnit::ANGULAR_VELOCITY))
            }
            @for change in &record.overrides { " · " code { (change.path) " = " (change.written) } }
        },
        answer: sentences(&headline_sentences(record, &writer)),
        is_answer_short: true,
        beside: mechanism_figure(&record.drawing, &record.drive),
        below,
        sections,
        identity: "motion".to_owned(),
        version: record.version.clone(),
    }
    .into_html()
}

fn has_clearance(output: &OutputMotion) -> bool {
    output.clearance.first_order_si.iter().any(|value| *value != 0.0)
}

fn has_scatter(output: &OutputMotion) -> bool {
    output.dimensional_standard_deviation_si.iter().any(|value| *value != 0.0)
}

/// The answer in sentences, the most important first; for pages and terminals alike.
pub(super) fn headline_sentences(record: &MotionRecord, writer: &NumberWriter) -> Vec<String> {
    let judged = verdict_headline(record).map(|headline| format!("{headline}."));
    let verdicts: Vec<String> = judged.into_iter().chain(verdict_sentences(record, writer)).collect();
    let mut sentences: Vec<String> = record
        .outputs
        .iter()
        .filter(|output| has_clearance(output))
        .map(|output| {
            let effect = play_effect(record, output);
            let (_, rim_si) = largest(record, &output.clearance.rim_standard_deviation_si);
            format!(
                "Play alone moves the {} by up to {} ({}). If every contact direction is equally likely, the standard deviation is at \
                 most {}.",
                moved_words(output),
                effect.written(output, writer),
                effect.words(record, output, writer),
                writer.rounded(rim_si, &output.unit, PLAIN_DIGITS, Rounding::Up),
            )
        })
        .collect();
    if sentences.is_empty() {
        let is_ideal = !record.outputs.iter().any(has_scatter);
        let words = if record.outputs.is_empty() {
            "No output is a position or an angle: no effect of play is shown."
        } else if is_ideal {
            "No joint has play and no part scatters: the motion is ideal."
        } else {
            "No joint has play."
        };
        sentences.push(words.to_owned());
    }
    sentences.extend(record.outputs.iter().filter(|output| has_scatter(output)).map(|output| {
        let (angle_rad, deviation_si) = largest(record, &output.dimensional_standard_deviation_si);
        format!(
            "Part scatter moves the {} with a standard deviation of at most {} (at {}).",
            moved_words(output),
            writer.rounded(deviation_si, &output.unit, PLAIN_DIGITS, Rounding::Up),
            turn_angle(record, angle_rad, 3, writer),
        )
    }));
    for position in &record.singular_positions {
        sentences.push(format!(
            "Singular at {} of {}: {}.",
            writer.value_trimmed(told_rad(record, position.drive_angle_rad), &SiUnit::ANGLE),
            record.drive,
            position.words
        ));
    }
    sentences.extend(unproven_sentences(record, writer));
    sentences.extend(record.guide_overhangs.iter().map(|overhang| overhang_sentence(record, overhang, writer)));
    verdicts.into_iter().chain(sentences).collect()
}

/// `Joint guide: the block may overhang an end of its guide at 20° to 50° of crank. …`
fn overhang_sentence(record: &MotionRecord, overhang: &GuideOverhang, writer: &NumberWriter) -> String {
    let spans: Vec<String> = overhang
        .spans_rad
        .iter()
        .map(|[from_rad, to_rad]| {
            let [from, to] =
                [from_rad, to_rad].map(|angle_rad| writer.value_trimmed(told_rad(record, *angle_rad), &SiUnit::ANGLE));
            if from == to { from } else { format!("{from} to {to}") }
        })
        .collect();
    format!(
        "Joint {}: the block may overhang an end of its guide at {} of {}. It can tilt further there than the worst case assumes, so \
         that the effect of play may be larger than stated.",
        overhang.joint,
        listed(&spans),
        record.drive
    )
}

/// What moves in words: the output, or for an error of a path the point along or across it.
pub(super) fn moved_words(output: &OutputMotion) -> String {
    let Some(PathMotion { path, part }) = &output.path_error else { return output.name.clone() };
    match part {
        PathError::Along => format!("{path} along its path"),
        PathError::Normal => format!("{path} across its path"),
        // The quasi-static answer has no other parts.
        PathError::Magnitude | PathError::Contour => output.name.clone(),
    }
}

fn angle_chart(record: &MotionRecord, id: String, writer: &NumberWriter) -> Chart {
    Chart::over_angle(id, &record.drive, &record.drive_angle_rad, writer)
}

fn clearance(record: &MotionRecord, shown: Option<usize>, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Each journal may lie anywhere in its clearance circle. The worst case is the largest deviation that a search over all \
             these places finds, with the links as they are and not to first order; beyond the proven ends no place leads. The standard deviations assume journals spread evenly over their circles, or over the rims. Inertia and impacts are not \
             included: use " code { "simulate" } " and " code { "study" } " for them."
        }
        @for (index, output) in record.outputs.iter().enumerate() {
            @if has_clearance(output) && Some(index) != shown { (clearance_chart(record, output, writer).figure()) }
        }
    }
}

fn clearance_chart(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Chart {
    let mut chart = angle_chart(record, name_of("clearance", &output.name), writer);
    chart.y_label = format!("deviation of {}", output.name);
    chart.y_symbol = writer.symbol(&output.unit);
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

fn contributors(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    html! {
        @for output in record.outputs.iter().filter(|output| has_clearance(output)) {
            (contributor_table(record, output, writer))
        }
    }
}

fn contributor_table(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Markup {
    let (worst_angle_rad, worst_si) = largest(record, &output.clearance.first_order_si);
    let pose = record.drive_angle_rad.iter().position(|angle_rad| *angle_rad == worst_angle_rad).unwrap_or(0);
    let mut joints: Vec<(f64, _)> = output
        .clearance
        .contributors
        .iter()
        .map(|joint| (joint.first_order_si.get(pose).copied().unwrap_or(0.0), joint))
        .collect();
    joints.sort_by(|a, b| b.0.total_cmp(&a.0));
    let rows = joints.into_iter().map(|(part_si, joint)| {
        [
            html! { (joint.joint) },
            html! { (writer.value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH)) },
            html! { (writer.value(part_si, &output.unit)) },
            share_bar(part_si, worst_si, writer),
        ]
    });
    html! {
        figure.treatments {
            h3 { (named_words(&output.name, &output.words)) }
            (cards(["Joint", "#Radial clearance", "#Effect, first order", "Share"], rows))
            figcaption {
                "Shares of the sum of the first-order effects at " (turn_angle(record, worst_angle_rad, 3, writer))
                ", where it is largest."
            }
        }
    }
}

fn scatter(record: &MotionRecord, shown: Option<usize>, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Root sum of squares of the effects of all dimensions, correlations included. First order, without play."
        }
        @for (index, output) in record.outputs.iter().enumerate().filter(|(_, output)| has_scatter(output)) {
            @if Some(index) != shown { (scatter_chart(record, output, writer).figure()) }
            (scatter_table(record, output, writer))
        }
    }
}

fn scatter_chart(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Chart {
    let mut chart = angle_chart(record, name_of("scatter", &output.name), writer);
    chart.y_label = format!("deviation of {}", output.name);
    chart.y_symbol = writer.symbol(&output.unit);
    let upper = scaled(&output.dimensional_standard_deviation_si, &output.unit, writer);
    let lower: Vec<f64> = upper.iter().map(|value| -value).collect();
    let values = EntryValues::band(&lower, &upper);
    chart.entries.push(Entry::new("± standard deviation of the dimensions", Role::Random, false, values));
    let (angle_rad, deviation_si) = largest(record, &output.dimensional_standard_deviation_si);
    let words = format!(
        "at most {}, at {}",
        writer.rounded(deviation_si, &output.unit, PLAIN_DIGITS, Rounding::Up),
        turn_angle(record, angle_rad, 3, writer)
    );
    chart.caption = html! {
        strong { "Scatter of " (named_words(&output.name, &output.words)) " due to part scatter." } " Standard deviation: " (words) "."
    };
    chart.alternative = format!(
        "Chart of the standard deviation of {} over one cycle: {words}.",
        named_words(&output.name, &output.words)
    );
    chart
}

fn scatter_table(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Markup {
    let mut dimensions: Vec<(f64, &str)> = output
        .dimensional_contributors
        .iter()
        .map(|dimension| (largest(record, &dimension.standard_deviation_si).1, dimension.path.as_str()))
        .collect();
    dimensions.sort_by(|a, b| b.0.total_cmp(&a.0));
    let row = |(deviation_si, path)| [html! { code { (path) } }, html! { (writer.value(deviation_si, &output.unit)) }];
    cards(["Dimension", "#Largest standard deviation"], dimensions.into_iter().map(row))
}

fn share_bar(part_si: f64, whole_si: f64, writer: &NumberWriter) -> Markup {
    let share = if whole_si > 0.0 { part_si / whole_si } else { 0.0 };
    let words = writer.percent(share, Rounding::Nearest);
    html! {
        svg.bar width="100%" height="20" role="img" aria-label=(words) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            rect.mixed x="0" y="4" width=(percent_of(share, 0.0, 1.0)) height="12" rx="2" {}
        }
        span.range { (words) }
    }
}

fn motion(record: &MotionRecord, writer: &NumberWriter) -> Markup {
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
    if values_si.is_empty() {
        return html! {};
    }
    let mut chart = angle_chart(record, name_of(what, &output.name), writer);
    chart.height = 220;
    chart.y_label = format!("{what} of {}", output.name);
    chart.y_symbol = writer.symbol(&unit);
    chart.entries.push(Entry::line(&format!("ideal {what}"), Role::First, false, values_si, &unit, writer));
    let range = range_words(values_si, &unit, writer);
    chart.caption =
        html! { strong { "Ideal " (what) " of " (named_words(&output.name, &output.words)) }  ": " (range) "." };
    chart.alternative =
        format!("Chart of the ideal {what} of {} over one cycle: {range}.", named_words(&output.name, &output.words));
    chart.figure()
}

/// Between which values a history lies.
fn range_words(values_si: &[f64], unit: &SiUnit, writer: &NumberWriter) -> String {
    let lowest = values_si.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = values_si.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    format!("between {} and {}", writer.value(lowest, unit), writer.value(highest, unit))
}

fn efforts(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "What inertia, weight, springs, loads and friction in joints without play need to make the ideal motion. Play and impacts \
             are not included: use " code { "simulate" } " for them."
        }
        div.charts { @for effort in &record.efforts { (effort_chart(record, effort, writer)) } }
    }
}

fn effort_chart(record: &MotionRecord, effort: &EffortMotion, writer: &NumberWriter) -> Markup {
    let EffortMotion { name, words, unit, value_si } = effort;
    if value_si.is_empty() {
        return html! {};
    }
    let mut chart = angle_chart(record, name_of("effort", name), writer);
    chart.height = 220;
    chart.y_label.clone_from(name);
    chart.y_symbol = writer.symbol(unit);
    chart.entries.push(Entry::line(name, Role::First, false, value_si, unit, writer));
    let range = range_words(value_si, unit, writer);
    chart.caption = html! { strong { (named_words(name, words)) } ": " (range) "." };
    chart.alternative = format!("Chart of {} over one cycle: {range}.", named_words(name, words));
    chart.figure()
}

fn method(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    let mut rows = vec![
        ("Mobility".to_owned(), html! { (record.mobility) }),
        (
            "Ideal motion".to_owned(),
            html! { "loops closed at position, velocity and acceleration level, " (record.drive_angle_rad.len()) " positions" },
        ),
        (
            "Effect of play".to_owned(),
            html! {
                "to first order an eccentricity e within |e| ≤ c moves the output by g·e, with g from the mechanism's own \
                 Jacobian: Σ c|g| at most; variance Σ c²|g|²/4 (anywhere in the disc), Σ c²|g|²/2 (on the rim)"
            },
        ),
    ];
    if record.outputs.iter().any(|output| !output.clearance.worst_case_si.is_empty()) {
        rows.push(("Worst case".to_owned(), worst_case_method(record)));
    }
    for position in &record.singular_positions {
        rows.push((
            "Singular position".to_owned(),
            html! { (writer.value_trimmed(told_rad(record, position.drive_angle_rad), &SiUnit::ANGLE)) ": " (position.words) },
        ));
    }
    rows.push(("Version".to_owned(), html! { "loosepin " (record.version) }));
    facts(&rows)
}

fn worst_case_method(record: &MotionRecord) -> Markup {
    html! {
        "found: searches from several starts over all places of the joints, the loops closed exactly, at each angle shown. Proven: no place \
         of rigid parts within their play leads beyond; Taylor's formula of second degree with its remainder on intervals that are rounded \
         outwards, "
        @if record.is_proven_between_angles { "at all angles of the drive" } @else { "at the angles shown" }
    }
}
