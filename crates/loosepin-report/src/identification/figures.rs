//! Pictures of an identification: maps of the consistent set, ranges before and after, shares that features would leave.

use maud::{Markup, html};

use crate::charts::axes::{Axes, Axis, with_unit};
use crate::charts::figure::{Picture, csv_number, csv_text};
use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::motion_identification::{MotionPlan, MotionSpecimen, PlannedFeature, TestedPoint};
use loosepin_text::units::SiUnit;

/// Width of the pictures in their own units; a unit is about a pixel.
const WIDTH: f64 = 960.0;
/// Heights of a map of one unknown and of two.
const STRIP_HEIGHT: f64 = 320.0;
const MAP_HEIGHT: f64 = 480.0;
/// Distances beyond this are drawn there: how much further they are does not matter.
const MAX_DISTANCE: f64 = 4.0;
/// Rows of a picture of ranges: where bars begin and end, how high a row is.
const BAR_LEFT: f64 = 330.0;
const BAR_RIGHT: f64 = WIDTH - 30.0;
const ROW: f64 = 56.0;
const BAR: f64 = 16.0;
/// Room at both ends of a row, as a share of what it shows.
const ROOM: f64 = 0.05;
/// Digits at the ends of a range.
const DIGITS: usize = 4;

/// Dots of tested values.
fn dots(points: &[TestedPoint], is_wanted: bool, at: impl Fn(&TestedPoint) -> Option<[f64; 2]>) -> String {
    let wanted = points.iter().filter(|point| point.is_consistent == is_wanted).filter_map(at);
    wanted.map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect()
}

/// Numbers behind a map: the tested values with what came out.
fn tested_csv(specimen: &MotionSpecimen, writer: &NumberWriter<'_>) -> String {
    let heads = specimen.unknowns.iter().map(|unknown| with_unit(&unknown.name, &writer.symbol(&unknown.unit)));
    let heads: Vec<String> =
        heads.chain(["distance".to_owned(), "consistent".to_owned()]).map(|head| csv_text(&head)).collect();
    let mut table = format!("{}\n", heads.join(","));
    for point in &specimen.points {
        let values = point.values_si.iter().zip(&specimen.unknowns);
        let values = values.map(|(value_si, unknown)| csv_number(writer.scaled(*value_si, &unknown.unit)));
        let told = [csv_number(point.distance), if point.is_consistent { "yes" } else { "no" }.to_owned()];
        table.push_str(&format!("{}\n", values.chain(told).collect::<Vec<String>>().join(",")));
    }
    table
}

/// The tested values of one unknown: how far the measurement is from the runs at each, and the interval that is left.
pub(super) fn strip(specimen: &MotionSpecimen, unknown: usize, name: String, writer: &NumberWriter<'_>) -> Markup {
    let own = &specimen.unknowns[unknown];
    let scaled = |value_si: f64| writer.scaled(value_si, &own.unit);
    let axes = Axes {
        width: WIDTH,
        height: STRIP_HEIGHT,
        x: Axis::over(own.before_si.map(scaled).into_iter()).with_margin(),
        y: Axis::over([0.0, MAX_DISTANCE].into_iter()),
    };
    let at = |point: &TestedPoint| {
        let value = point.values_si.get(unknown)?;
        Some([axes.x_position(scaled(*value)), axes.y_position(point.distance.min(MAX_DISTANCE))])
    };
    let [left, right] = own.after_si.map(|end_si| axes.x_position(scaled(end_si)));
    let [top, bottom] = [MAX_DISTANCE, 0.0].map(|distance| axes.y_position(distance));
    let [from, to] = own.before_si.map(|end_si| axes.x_position(scaled(end_si)));
    let limit = axes.y_position(1.0);
    let drawn = html! {
        (axes.grid())
        @if specimen.misfit.is_none() {
            rect.cell x=(format!("{left:.1}")) y=(top) width=(format!("{:.1}", (right - left).max(1.0))) height=(bottom - top) {}
        }
        line.limit x1=(format!("{from:.1}")) x2=(format!("{to:.1}")) y1=(format!("{limit:.1}")) y2=(format!("{limit:.1}")) {}
        path.irregular d=(dots(&specimen.points, false, at)) {}
        path.regular d=(dots(&specimen.points, true, at)) {}
        (axes.labels([&own.name, &writer.symbol(&own.unit)], ["distance over that allowed", ""]))
    };
    let alternative = format!(
        "Map of {}: distance of the measurement from the runs at {} tested values; {} consistent.",
        own.name,
        specimen.points.len(),
        specimen.points.iter().filter(|point| point.is_consistent).count()
    );
    let caption = html! {
        strong { "Distance of the measurement from the runs, at each tested value of " (own.name) "." }
        " Below the dashed line, the test accepts the value (" span.regular { "blue" } "), above it the test rejects the value (" span.irregular { "orange" }
        "). Distances above " (MAX_DISTANCE) " are drawn there."
        @if specimen.misfit.is_none() { " Shaded: the remaining interval." }
    };
    Picture { name, class: "map", view: [0.0, 0.0, WIDTH, STRIP_HEIGHT], below: 0.0, alternative, drawn }
        .figure(caption, Some(&tested_csv(specimen, writer)))
}

/// Cells of two unknowns: those that are consistent for some values of the others, and the tested values.
pub(super) fn map(
    specimen: &MotionSpecimen,
    [across, up]: [usize; 2],
    name: String,
    writer: &NumberWriter<'_>,
) -> Markup {
    let unknowns = [&specimen.unknowns[across], &specimen.unknowns[up]];
    let scaled = |which: usize, value_si: f64| writer.scaled(value_si, &unknowns[which].unit);
    let axis = |which: usize| Axis::over(unknowns[which].before_si.map(|end| scaled(which, end)).into_iter());
    let axes = Axes { width: WIDTH, height: MAP_HEIGHT, x: axis(0), y: axis(1) };
    let at = |point: &TestedPoint| {
        let (x, y) = (point.values_si.get(across)?, point.values_si.get(up)?);
        Some([axes.x_position(scaled(0, *x)), axes.y_position(scaled(1, *y))])
    };
    let place = |mut cell: usize, wanted: usize| {
        for count in &specimen.grid[..wanted] {
            cell /= (*count).max(1);
        }
        cell % specimen.grid[wanted].max(1)
    };
    let mut cells: Vec<[usize; 2]> =
        specimen.cells.iter().map(|&cell| [place(cell, across), place(cell, up)]).collect();
    cells.sort_unstable();
    cells.dedup();
    let edge = |which: usize, unknown: usize, place: usize| {
        let [low, high] = unknowns[which].before_si;
        scaled(which, low + (high - low) * place as f64 / specimen.grid[unknown].max(1) as f64)
    };
    let squares: String = cells
        .iter()
        .map(|&[x, y]| {
            let [left, right] = [x, x + 1].map(|place| axes.x_position(edge(0, across, place)));
            let [bottom, top] = [y, y + 1].map(|place| axes.y_position(edge(1, up, place)));
            format!("M{left:.1} {bottom:.1}H{right:.1}V{top:.1}H{left:.1}Z")
        })
        .collect();
    let drawn = html! {
        (axes.grid())
        path.cell d=(squares) {}
        path.irregular d=(dots(&specimen.points, false, at)) {}
        path.regular d=(dots(&specimen.points, true, at)) {}
        (axes.labels(
            [&unknowns[0].name, &writer.symbol(&unknowns[0].unit)],
            [&unknowns[1].name, &writer.symbol(&unknowns[1].unit)]
        ))
    };
    let alternative = format!(
        "Map of {} and {}: {} tested values; consistent cells: {}.",
        unknowns[0].name,
        unknowns[1].name,
        specimen.points.len(),
        cells.len()
    );
    let caption = html! {
        strong { (unknowns[0].name) " and " (unknowns[1].name) "." }
        " Shaded: cells whose values the test accepts"
        @if specimen.unknowns.len() > 2 { ", for some value of the other unknowns" }
        ". Dots: tested values, " span.regular { "blue" } " kept, " span.irregular { "orange" } " rejected."
    };
    Picture { name, class: "map", view: [0.0, 0.0, WIDTH, MAP_HEIGHT], below: 0.0, alternative, drawn }
        .figure(caption, Some(&tested_csv(specimen, writer)))
}

/// A row of a picture of ranges.
pub(super) struct RangeRow {
    pub label: String,
    pub unit: SiUnit,
    pub before_si: [f64; 2],
    pub after_si: Option<[f64; 2]>,
    /// The measured value, with its common error.
    pub measured_si: Option<(f64, [f64; 2])>,
}

/// Ranges before and after, each row at its own scale.
pub(super) fn ranges(
    rows: &[RangeRow],
    name: String,
    (alternative, caption): (String, Markup),
    writer: &NumberWriter<'_>,
) -> Markup {
    let row = |(place, row): (usize, &RangeRow)| {
        let found = row.measured_si.map(|(_, found_si)| found_si);
        let all = [Some(row.before_si), row.after_si, found].into_iter().flatten().flatten();
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let size = if high > low { high - low } else { low.abs().max(f64::MIN_POSITIVE) };
        let (low, high) = (low - ROOM * size, high + ROOM * size);
        let at = |value_si: f64| BAR_LEFT + (value_si - low) / (high - low) * (BAR_RIGHT - BAR_LEFT);
        let top = ROW * place as f64 + 12.0;
        let bar = |ends_si: [f64; 2]| {
            let [left, right] = ends_si.map(at);
            (format!("{left:.1}"), format!("{:.1}", (right - left).max(2.0)))
        };
        let [left, right] = row.before_si.map(at);
        let ends = [(row.before_si[0], Rounding::Down), (row.before_si[1], Rounding::Up)];
        let [least, most] = ends.map(|(value_si, rounding)| writer.rounded(value_si, &row.unit, DIGITS, rounding));
        html! {
            text.label x=(BAR_LEFT - 14.0) y=(top + 13.0) text-anchor="end" { (row.label) }
            @let (x, width) = bar(row.before_si);
            rect.before x=(x) y=(top) width=(width) height=(BAR) {}
            @if let Some(after_si) = row.after_si {
                @let (x, width) = bar(after_si);
                rect.after x=(x) y=(top + 3.0) width=(width) height=(BAR - 6.0) {}
            }
            @if let Some((value_si, found_si)) = row.measured_si {
                @let ([from, to], middle) = (found_si.map(at), top + 0.5 * BAR);
                line.measured x1=(format!("{from:.1}")) x2=(format!("{to:.1}")) y1=(middle) y2=(middle) {}
                circle.measured cx=(format!("{:.1}", at(value_si))) cy=(middle) r="5" {}
            }
            text x=(format!("{left:.1}")) y=(top + BAR + 15.0) text-anchor="start" { (least) }
            text x=(format!("{right:.1}")) y=(top + BAR + 15.0) text-anchor="end" { (most) }
        }
    };
    let drawn = html! { @for each in rows.iter().enumerate().map(row) { (each) } };
    let mut csv = "what,unit,before from,before to,after from,after to,measured,measured from,measured to\n".to_owned();
    for row in rows {
        let number = |value_si: Option<f64>| {
            value_si.map_or_else(String::new, |value_si| csv_number(writer.scaled(value_si, &row.unit)))
        };
        let cells = [
            csv_text(&row.label),
            writer.symbol(&row.unit),
            number(Some(row.before_si[0])),
            number(Some(row.before_si[1])),
            number(row.after_si.map(|ends| ends[0])),
            number(row.after_si.map(|ends| ends[1])),
            number(row.measured_si.map(|(value_si, _)| value_si)),
            number(row.measured_si.map(|(_, found_si)| found_si[0])),
            number(row.measured_si.map(|(_, found_si)| found_si[1])),
        ];
        csv.push_str(&format!("{}\n", cells.join(",")));
    }
    let view = [0.0, 0.0, WIDTH, ROW * rows.len() as f64 + 8.0];
    Picture { name, class: "ranges", view, below: 0.0, alternative, drawn }.figure(caption, Some(&csv))
}

/// The share of the box that each feature alone would leave, and all together.
pub(super) fn shares(plan: &MotionPlan, name: String, writer: &NumberWriter<'_>) -> Markup {
    let features: Vec<&PlannedFeature> = plan.features.iter().chain([&plan.together]).collect();
    let row = |(place, feature): (usize, &&PlannedFeature)| {
        let top = 34.0 * place as f64 + 10.0;
        let share = feature.share_of_box.clamp(0.0, 1.0);
        let width = (share * (BAR_RIGHT - BAR_LEFT - 70.0)).max(2.0);
        let class = if place + 1 == features.len() { "after" } else { "before" };
        html! {
            text.label x=(BAR_LEFT - 14.0) y=(top + 13.0) text-anchor="end" { (feature.name) }
            rect class=(class) x=(BAR_LEFT) y=(top) width=(format!("{width:.1}")) height=(BAR) {}
            text x=(format!("{:.1}", BAR_LEFT + width + 8.0)) y=(top + 13.0) {
                (writer.percent(feature.share_of_box, Rounding::Up))
            }
        }
    };
    let drawn = html! { @for each in features.iter().enumerate().map(row) { (each) } };
    let first = features.first().map_or_else(String::new, |feature| feature.name.clone());
    let alternative =
        format!("Bars: share of the box that each of {} features would leave; least: {first}.", plan.features.len());
    let caption = html! {
        strong { "Share of the box that each feature alone would leave; the last bar is for all features together." }
        " Mean over simulated measurements at " (plan.points) " values of the unknowns. A shorter bar means that the feature narrows the unknowns more."
    };
    let mut csv = "feature,share of the box left".to_owned();
    for unknown in &plan.unknowns {
        csv.push_str(&format!(",{}", csv_text(&format!("share of {} left", unknown.name))));
    }
    csv.push('\n');
    for feature in &features {
        let numbers = std::iter::once(&feature.share_of_box).chain(&feature.shares_of_width);
        let cells = std::iter::once(csv_text(&feature.name)).chain(numbers.map(|share| csv_number(*share)));
        csv.push_str(&format!("{}\n", cells.collect::<Vec<String>>().join(",")));
    }
    let view = [0.0, 0.0, WIDTH, 34.0 * features.len() as f64 + 8.0];
    Picture { name, class: "ranges", view, below: 0.0, alternative, drawn }.figure(caption, Some(&csv))
}
