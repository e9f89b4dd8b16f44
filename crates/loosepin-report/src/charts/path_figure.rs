//! The path of a point over the cycle, and about it, magnified, the zone in which play and scatter let it be.

use maud::{Markup, html};

use crate::charts::axes::with_unit;
use crate::charts::figure::{Picture, csv_number, csv_text, name_of};
use crate::charts::plane_view::{PlaneView, bars, is_closed, magnification, size_m};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use loosepin_result::point_path::{ELLIPSE_SHARE, PointPath};
use loosepin_text::units::SiUnit;

/// Pieces of which the drawn zone consists, at most: the path bends little between two of them.
const MAX_PIECES: usize = 120;
/// Angles of the drive between two marks on the path, degrees.
const TICK_DEG: f64 = 30.0;
/// Room that the label of a mark needs, in units of the picture.
const LABEL_ROOM: f64 = 44.0;
/// From the zone to the middle of a label.
const LABEL_GAP: f64 = 20.0;
/// A mark stands at the position that is nearest to its angle, within this share of a step.
const HALF_STEP: f64 = 0.5;

/// The figure; empty if the record is not whole, or the point neither moves nor strays.
pub(crate) fn path_figure(path: &PointPath, drive: &str, drive_angle_rad: &[f64], writer: &NumberWriter) -> Markup {
    let positions = path.positions();
    let xy_m = [path.x_m.as_slice(), path.y_m.as_slice()];
    // A path in space is drawn with its mechanism.
    let is_whole = path.is_complete()
        && !path.is_in_space()
        && positions > 2
        && drive_angle_rad.len() == positions
        && xy_m.iter().all(|list| list.iter().all(|value| value.is_finite()));
    let size_m = size_m(xy_m);
    let largest_m = largest_reach_m(path);
    let has_zone = path.has_zone();
    // The size of a path without motion is round-off.
    if !is_whole || !largest_m.is_finite() || (path.always_stands_still() && !has_zone) {
        return html! {};
    }
    let magnification = magnification(size_m, largest_m);
    let view = PlaneView::new(xy_m, magnification * largest_m);
    let closing = if is_closed(xy_m, size_m) { "Z" } else { "" };
    let ideal: Vec<[f64; 2]> = (0..positions).map(|k| [path.x_m[k], path.y_m[k]]).collect();
    let about = |k: usize, corners_m: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let [x_m, y_m] = ideal[k];
        corners_m.iter().map(|[x, y]| view.place([x_m + magnification * x, y_m + magnification * y])).collect()
    };
    let marks = if path.always_stands_still() { Vec::new() } else { marks(drive_angle_rad) };
    let zone = if has_zone { swept(positions, &|k| about(k, &path.zone_m(k))) } else { String::new() };
    let plays: String = marks.iter().map(|(k, _)| outline(&about(*k, &path.play_zone_m(*k)))).collect();
    let [x0, y0] = view.place([0.0, 0.0]);
    let length = writer.units.of(&SiUnit::LENGTH);
    let per_length = view.per_m / length.per_si;
    let words = Words::new(path, drive, magnification, writer);
    let drawn = html! {
        @if has_zone {
            path.zone d=(zone) {}
            path.outline d=(plays) {}
            @if path.has_scatter() {
                @for (k, _) in &marks { (ellipse(path, *k, view.place(ideal[*k]), magnification * view.per_m)) }
            }
        }
        path.ideal d={ (view.line(&ideal)) (closing) } data-x0=(format!("{x0:.3}")) data-y0=(format!("{y0:.3}"))
            data-scale=(format!("{per_length:.6e}")) data-magnification=(magnification) {}
        path.ticks d=(marks.iter().map(|(k, _)| format!("M{}h0", view.point(ideal[*k]))).collect::<String>()) {}
        (labels(path, &marks, &ideal, &view, magnification))
        (bars(&view, has_zone.then_some(magnification), writer))
    };
    let caption = html! {
        strong { "The path of " (path.point) @if magnification > 1.0 { ", zone magnified " (words.magnification) " times" } "." } " " (words.sentences)
        " " span.reading {}
    };
    let csv = csv(path, drive_angle_rad, writer);
    let view = [0.0, 0.0, view.width, view.height];
    Picture {
        name: name_of("path", &path.name),
        class: "trace",
        view,
        below: 0.0,
        alternative: words.alternative,
        drawn,
    }
    .figure(caption, Some(&csv))
}

/// A path of a run: positions with play, and those of the ideal motion at the same times; empty where there is none.
pub(crate) struct RunCourse<'r> {
    pub name: &'r str,
    pub point: &'r str,
    pub xy_m: [&'r [f64]; 2],
    pub ideal_m: [&'r [f64]; 2],
    /// Position tolerance of the run: smaller deviations count as none.
    pub tolerance_m: f64,
    /// Angles of the drive as in the charts; empty where these are over time.
    pub drive_angle_rad: Vec<f64>,
}

/// Share of the coordinates of a run below which a difference is round-off.
const ROUND_OFF_OF_RUN: f64 = 1e-12;

/// Points of a drawn line, at most.
const MAX_POINTS: usize = 4000;

/// The path of a point in a run: where it has an ideal path, its deviation from there is magnified. Empty if it does not move.
pub(crate) fn run_path_figure(course: &RunCourse<'_>, writer: &NumberWriter) -> Markup {
    let samples = course.xy_m[0].len();
    let has_ideal = course.ideal_m.iter().all(|list| list.len() == samples);
    let from_m = if has_ideal { course.ideal_m } else { course.xy_m };
    let is_finite = |list: &&[f64]| list.iter().all(|value| value.is_finite());
    if samples < 3 || course.xy_m[1].len() != samples || !from_m.iter().chain(&course.xy_m).all(is_finite) {
        return html! {};
    }
    let size_m = size_m(from_m);
    let strays = (0..samples).map(|k| [0, 1].map(|axis| course.xy_m[axis][k] - from_m[axis][k]));
    let strays_m: Vec<[f64; 2]> = strays.collect();
    let largest_m = strays_m.iter().fold(0.0, |most: f64, [x, y]| most.max(x.hypot(*y)));
    // Coordinates far from the origin have larger round-off.
    let distance_m = from_m.iter().flat_map(|list| list.iter()).fold(size_m, |most, value| most.max(value.abs()));
    let round_off_m = course.tolerance_m.max(ROUND_OFF_OF_RUN * distance_m);
    let is_straying = has_ideal && largest_m > round_off_m;
    if size_m <= ROUND_OFF_OF_RUN * distance_m && !is_straying {
        return html! {};
    }
    let drawn_m = if is_straying { largest_m } else { 0.0 };
    let magnification = magnification(size_m, drawn_m);
    let view = PlaneView::new(from_m, magnification * drawn_m);
    let step = samples.div_ceil(MAX_POINTS).max(1);
    let line = |factor: f64| {
        let place = |k: usize| [0, 1].map(|axis| from_m[axis][k] + factor * strays_m[k][axis]);
        view.line(&(0..samples).step_by(step).map(place).collect::<Vec<_>>())
    };
    let [x0, y0] = view.place([0.0, 0.0]);
    let per_length = view.per_m / writer.units.of(&SiUnit::LENGTH).per_si;
    let tag = |part: &str| Tag::joint(course.name, "path", part);
    let magnified = writer.with_tag(&tag("magnification")).count(magnification as u64);
    let largest = writer.with_tag(&tag("deviation")).rounded(largest_m, &SiUnit::LENGTH, 2, Rounding::Up);
    let sentence = if is_straying {
        format!(
            "Dashed: the ideal path. Line: the path with play, up to {largest} from where it should be at the same time."
        )
    } else if has_ideal {
        let least = writer.with_tag(&tag("deviation")).rounded(round_off_m, &SiUnit::LENGTH, 1, Rounding::Up);
        format!("It is the ideal path: no deviation above {least}.")
    } else {
        "As it was recorded.".to_owned()
    };
    let drawn = html! {
        path.actual d=(line(magnification)) {}
        path.ideal.dashed[is_straying] d=(line(0.0)) data-x0=(format!("{x0:.3}")) data-y0=(format!("{y0:.3}"))
            data-scale=(format!("{per_length:.6e}")) data-magnification=(magnification) {}
        (bars(&view, is_straying.then_some(magnification), writer))
    };
    let caption = html! {
        strong { "The path of " (course.point) @if is_straying { ", deviations magnified " (magnified) " times" } "." } " " (sentence)
        " " span.reading {}
    };
    let alternative = format!("The path of {}. {sentence}", course.point);
    let csv = run_csv(course, has_ideal, writer);
    let view = [0.0, 0.0, view.width, view.height];
    Picture { name: name_of("path", course.name), class: "trace", view, below: 0.0, alternative, drawn }
        .figure(caption, Some(&csv))
}

/// Positions of the drawn samples.
fn run_csv(course: &RunCourse<'_>, has_ideal: bool, writer: &NumberWriter) -> String {
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let lists = course.xy_m.into_iter().chain(if has_ideal { course.ideal_m.to_vec() } else { Vec::new() });
    let heads = ["x", "y", "ideal x", "ideal y"].map(|words| with_unit(words, &symbol));
    let mut columns: Vec<(String, Vec<f64>)> = Vec::new();
    if course.drive_angle_rad.len() == course.xy_m[0].len() {
        let degrees = course.drive_angle_rad.iter().map(|angle_rad| angle_rad.to_degrees()).collect();
        columns.push(("angle [deg]".to_owned(), degrees));
    }
    let scaled = |list: &[f64]| list.iter().map(|value| writer.scaled(*value, &SiUnit::LENGTH)).collect();
    columns.extend(heads.into_iter().zip(lists.map(scaled)));
    table(&columns, course.xy_m[0].len().div_ceil(MAX_POINTS).max(1))
}

/// Columns as comma-separated values, every `step`-th row.
fn table(columns: &[(String, Vec<f64>)], step: usize) -> String {
    let heads: Vec<String> = columns.iter().map(|(head, _)| csv_text(head)).collect();
    let mut table = format!("{}\n", heads.join(","));
    for row in (0..columns[0].1.len()).step_by(step) {
        let cells: Vec<String> = columns.iter().map(|(_, values)| csv_number(values[row])).collect();
        table.push_str(&format!("{}\n", cells.join(",")));
    }
    table
}

/// The largest reach of the zone at any angle, m.
pub(crate) fn largest_reach_m(path: &PointPath) -> f64 {
    let reaches = (0..path.positions()).flat_map(|k| path.zone_m(k));
    // Beyond the reaches themselves by a corner of the polygon: what is drawn has room.
    let longest_m = path.play_longest_m.iter().copied().fold(0.0, f64::max);
    reaches.fold(longest_m, |most: f64, [x, y]| most.max(x.hypot(y)))
}

/// Reach along and across the motion, m, at each position: 0 where the point of a path that moves stands still; where it never moves, how
/// far from its place it may be, twice.
pub(crate) fn along_and_across_m(path: &PointPath) -> [Vec<f64>; 2] {
    let always_still = path.always_stands_still();
    [0, 1].map(|part| {
        let reach = |k: usize| {
            if path.stands_still(k) && !always_still { 0.0 } else { path.along_and_across_m(k)[part] }
        };
        (0..path.positions()).map(reach).collect()
    })
}

/// How far the zone reaches: along and across the motion, and where the point stands still, from its place.
pub(crate) fn extent_words(path: &PointPath, writer: &NumberWriter) -> String {
    let largest_m = largest_reach_m(path);
    let written = |part: &str, most_m: f64| {
        let tag = Tag::joint(&path.name, "path", part);
        writer.with_tag(&tag).rounded(without_round_off(most_m, largest_m), &SiUnit::LENGTH, 2, Rounding::Up)
    };
    let still = (0..path.positions()).filter(|k| path.stands_still(*k)).map(|k| path.along_and_across_m(k)[0]);
    let still = still.reduce(f64::max).map(|most_m| written("at rest", most_m));
    if path.always_stands_still() {
        let still = still.unwrap_or_default();
        return format!("It stands still, so that no direction is along its motion: up to {still} from its place.");
    }
    let [along, across] = along_and_across_m(path).map(|list| list.into_iter().fold(0.0, f64::max));
    let moving = format!(
        "Up to {} along its motion and {} across it, to either side.",
        written("along", along),
        written("across", across)
    );
    match still {
        Some(still) => format!("{moving} Where it stands still it has no direction: up to {still} from its place."),
        None => moving,
    }
}

/// A reach, or zero where it is round-off beside the largest one.
pub(crate) fn without_round_off(reach_m: f64, largest_m: f64) -> f64 {
    const ROUND_OFF: f64 = 1e-6;
    if reach_m <= ROUND_OFF * largest_m { 0.0 } else { reach_m }
}

/// What a figure says of its path.
struct Words {
    magnification: String,
    sentences: String,
    alternative: String,
}

impl Words {
    fn new(path: &PointPath, drive: &str, magnification: f64, writer: &NumberWriter) -> Self {
        let tag = |part: &str| Tag::joint(&path.name, "path", part);
        let magnified = writer.with_tag(&tag("magnification")).count(magnification as u64);
        let tick = writer.with_tag(&Tag::Given("marks of a path")).value_trimmed(TICK_DEG.to_radians(), &SiUnit::ANGLE);
        let marks = format!("Marks: every {tick} of {drive}.");
        if !path.has_zone() {
            let play = match path.is_play_known() {
                true => "Neither play nor scatter moves it.",
                false => "What play does to it is not known.",
            };
            return Self {
                sentences: format!("{play} {marks}"),
                alternative: format!("The path of {}.", path.point),
                magnification: magnified,
            };
        }
        let reach = extent_words(path, writer);
        let share = writer.with_tag(&Tag::Given("share of the ellipse")).percent(ELLIPSE_SHARE, Rounding::Nearest);
        let (has_play, has_scatter) = (path.has_play(), path.has_scatter());
        let cause = match (has_play, has_scatter) {
            (true, true) => format!("play and {share} of the scatter let"),
            (false, true) => format!("{share} of the scatter lets"),
            _ => "play lets".to_owned(),
        };
        let outlines = match (has_play, has_scatter) {
            (true, true) => format!(" Orange lines: play alone, blue ellipses: {share} of the scatter, at the marks."),
            (false, true) => format!(" Blue ellipses: {share} of the scatter, at the marks."),
            _ => String::new(),
        };
        Self {
            sentences: if path.always_stands_still() {
                format!("Orange: where {cause} it be, by a linear estimate. {reach}")
            } else {
                format!("Orange: where {cause} it be, by a linear estimate. {reach}{outlines} {marks}")
            },
            alternative: if magnification > 1.0 {
                format!("The path of {} and the zone about it, magnified {magnified} times. {reach}", path.point)
            } else {
                format!("The path of {} and the zone about it. {reach}", path.point)
            },
            magnification: magnified,
        }
    }
}

/// Positions at multiples of an angle, with this angle in degrees. Of both ends of a turn the first.
fn marks(drive_angle_rad: &[f64]) -> Vec<(usize, f64)> {
    let degrees: Vec<f64> = drive_angle_rad.iter().map(|angle_rad| angle_rad.to_degrees()).collect();
    let mut found: Vec<(usize, f64)> = Vec::new();
    for (k, degree) in degrees.iter().enumerate() {
        let step = degrees.get(k + 1).map_or_else(|| degree - degrees[k - 1], |next| next - degree).abs();
        // A zero has no sign.
        let angle = (degree / TICK_DEG).round() * TICK_DEG + 0.0;
        let is_known = |known: &(usize, f64)| known.1 == angle || (known.1 - angle).abs() == 360.0;
        if (degree - angle).abs() <= HALF_STEP * step && !found.iter().any(is_known) {
            found.push((k, angle));
        }
    }
    found
}

/// The zone over all positions: the hulls of neighbouring zones, all turned the same way round, so that they leave no hole.
fn swept(positions: usize, corners: &dyn Fn(usize) -> Vec<[f64; 2]>) -> String {
    let step = (positions - 1).div_ceil(MAX_PIECES).max(1);
    let mut drawn = String::new();
    let mut last = corners(0);
    let mut k = 0;
    while k + 1 < positions {
        k = (k + step).min(positions - 1);
        let next = corners(k);
        drawn.push_str(&outline(&hull(last.iter().chain(&next))));
        last = next;
    }
    drawn
}

/// A closed line to a tenth of a unit; corners that fall together are one.
fn outline(corners: &[[f64; 2]]) -> String {
    let mut texts: Vec<String> = corners.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    texts.dedup();
    format!("M{}Z", texts.join("L"))
}

/// The convex hull of places to a tenth of a unit, by Andrew's chain.
fn hull<'p>(places: impl Iterator<Item = &'p [f64; 2]>) -> Vec<[f64; 2]> {
    let mut sorted: Vec<[f64; 2]> = places.map(|place| place.map(|value| (10.0 * value).round() / 10.0)).collect();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |places: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for place in places {
            while let [.., a, b] = chain[..]
                && (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]) <= 0.0
            {
                chain.pop();
            }
            chain.push(*place);
        }
        chain.pop();
        chain
    };
    let mut chain = half(&mut sorted.iter());
    chain.extend(half(&mut sorted.iter().rev()));
    chain
}

/// The ellipse of the scatter at a position.
fn ellipse(path: &PointPath, k: usize, [x, y]: [f64; 2], per_m: f64) -> Markup {
    let [major, minor] = [path.scatter_major_m[k], path.scatter_minor_m[k]].map(|axis_m| axis_m * per_m);
    let turn_deg = -path.scatter_angle_rad[k].to_degrees();
    html! {
        ellipse.scatter rx=(format!("{major:.1}")) ry=(format!("{minor:.1}"))
            transform=(format!("translate({x:.1} {y:.1}) rotate({turn_deg:.1})")) {}
    }
}

/// Angles of the drive beside the zone, where there is room: outside of the path, or else inside.
fn labels(
    path: &PointPath,
    marks: &[(usize, f64)],
    ideal_m: &[[f64; 2]],
    view: &PlaneView,
    magnification: f64,
) -> Markup {
    let places: Vec<[f64; 2]> = ideal_m.iter().map(|place| view.place(*place)).collect();
    let middle = [0, 1].map(|axis| places.iter().map(|place| place[axis]).sum::<f64>() / places.len() as f64);
    let mut placed: Vec<[f64; 2]> = Vec::new();
    let mut texts = Vec::new();
    for (k, angle_deg) in marks {
        let [x, y] = places[*k];
        let normal = match [path.tangent_x[*k], path.tangent_y[*k]] {
            [0.0, 0.0] => [0.0, -1.0],
            // Upwards is below zero in a picture.
            [along_x, along_y] => [-along_y, -along_x],
        };
        let [_, across_m] = path.along_and_across_m(*k);
        let away = across_m * magnification * view.per_m + LABEL_GAP;
        let outwards = (1.0_f64).copysign((x - middle[0]) * normal[0] + (y - middle[1]) * normal[1]);
        let sides = [outwards, -outwards].map(|side| [x + side * away * normal[0], y + side * away * normal[1]]);
        let is_free = |place: &&[f64; 2]| {
            distance_to(&places, **place) > away - 0.3 * LABEL_GAP
                && placed.iter().all(|other| distance_to(&[*other], **place) >= LABEL_ROOM)
        };
        if let Some(place) = sides.iter().find(is_free) {
            placed.push(*place);
            texts.push((*place, angle_deg.rem_euclid(360.0)));
        }
    }
    html! {
        @for ([x, y], angle_deg) in texts {
            text x=(format!("{x:.1}")) y=(format!("{:.1}", y + 4.0)) text-anchor="middle" { (format!("{angle_deg:.0}°")) }
        }
    }
}

/// Distance to the nearest of `places`.
fn distance_to(places: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    places.iter().fold(f64::INFINITY, |least, place| least.min((place[0] - x).hypot(place[1] - y)))
}

/// Position, direction and zone at each angle; the script reads the places from it.
fn csv(path: &PointPath, drive_angle_rad: &[f64], writer: &NumberWriter) -> String {
    let scaled = |value_m: f64| writer.scaled(value_m, &SiUnit::LENGTH);
    // What is round-off beside the path, or beside the largest reach, is zero.
    let size_m = size_m([&path.x_m, &path.y_m]);
    let place = |value_m: &f64| if value_m.abs() < 1e-12 * size_m { 0.0 } else { scaled(*value_m) };
    let largest_m = largest_reach_m(path);
    let reach = |value_m: &f64| scaled(without_round_off(*value_m, largest_m));
    let list = |values: &[f64], of: &dyn Fn(&f64) -> f64| -> Vec<f64> { values.iter().map(of).collect() };
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let tangents = path.tangent_x.iter().zip(&path.tangent_y);
    let direction = |(x, y): (&f64, &f64)| if *x == 0.0 && *y == 0.0 { f64::NAN } else { y.atan2(*x).to_degrees() };
    let mut columns = vec![
        ("angle [deg]".to_owned(), drive_angle_rad.iter().map(|angle_rad| angle_rad.to_degrees()).collect()),
        (with_unit("x", &symbol), list(&path.x_m, &place)),
        (with_unit("y", &symbol), list(&path.y_m, &place)),
        ("direction of motion [deg]".to_owned(), tangents.map(direction).collect()),
        (with_unit("play along", &symbol), list(&path.play_along_m, &reach)),
        (with_unit("play across", &symbol), list(&path.play_across_m, &reach)),
    ];
    if !path.scatter_major_m.is_empty() {
        columns.push((with_unit("ellipse major", &symbol), list(&path.scatter_major_m, &reach)));
        columns.push((with_unit("ellipse minor", &symbol), list(&path.scatter_minor_m, &reach)));
        let turns = path.scatter_angle_rad.iter().map(|angle_rad| angle_rad.to_degrees()).collect::<Vec<f64>>();
        columns.push(("ellipse angle [deg]".to_owned(), turns));
    }
    table(&columns, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_the_hull_of_two_squares_has_six_corners() {
        let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0], [x + 0.5, 0.5]];
        let both: Vec<[f64; 2]> = square(0.0).into_iter().chain(square(3.0).map(|[x, y]| [x, y + 2.0])).collect();
        let corners = hull(both.iter());
        assert_eq!(corners, [[0.0, 0.0], [1.0, 0.0], [4.0, 2.0], [4.0, 3.0], [3.0, 3.0], [0.0, 1.0]]);
        assert_eq!(hull([[1.0, 2.0], [1.0, 2.0]].iter()), [[1.0, 2.0]]);
    }

    fn circle() -> PointPath {
        let angles: Vec<f64> = (0..36).map(|k| std::f64::consts::TAU * f64::from(k) / 36.0).collect();
        let [zeros, reach_m] = [36, 36 * loosepin_result::point_path::REACH_DIRECTIONS].map(|count| vec![0.0; count]);
        PointPath {
            name: "tip".to_owned(),
            point: "arm.tip".to_owned(),
            x_m: angles.iter().map(|angle| 0.3 * angle.cos()).collect(),
            y_m: angles.iter().map(|angle| 0.3 * angle.sin()).collect(),
            tangent_x: angles.iter().map(|angle| -angle.sin()).collect(),
            tangent_y: angles.iter().map(|angle| angle.cos()).collect(),
            play_reach_m: reach_m,
            play_along_m: zeros.clone(),
            play_across_m: zeros,
            ..PointPath::default()
        }
    }

    fn figure_of(path: &PointPath) -> String {
        let angles: Vec<f64> = (0..36).map(|k| std::f64::consts::TAU * f64::from(k) / 36.0).collect();
        let units = loosepin_text::units::DisplayUnits::default();
        path_figure(path, "crank", &angles, &NumberWriter::for_page(&units)).into_string()
    }

    #[test]
    fn the_scale_of_deviations_is_drawn_where_there_are_some() {
        let ideal = figure_of(&circle());
        assert!(ideal.contains("along the path") && !ideal.contains("of deviation"), "{ideal}");
        let mut loose = circle();
        loose.play_reach_m.iter_mut().for_each(|reach_m| *reach_m = 2e-4);
        let drawn = figure_of(&loose);
        assert!(drawn.contains("along the path") && drawn.contains("of deviation"), "{drawn}");
    }

    #[test]
    fn a_zone_that_is_not_known_is_not_said_to_be_none() {
        let mut unknown = circle();
        for reach_m in [&mut unknown.play_reach_m, &mut unknown.play_along_m, &mut unknown.play_across_m] {
            reach_m.fill(f64::NAN);
        }
        let drawn = figure_of(&unknown);
        assert!(drawn.contains("What play does to it is not known.") && !drawn.contains("Neither"), "{drawn}");
        assert!(!drawn.contains("NaN") && !drawn.contains("of deviation"), "{drawn}");
        assert!(figure_of(&circle()).contains("Neither play nor scatter moves it."));
    }

    #[test]
    fn a_point_that_stands_still_is_said_to() {
        let mut still = circle();
        // Round-off of a place.
        still.x_m = (0..36).map(|k| 0.2 + 1e-17 * f64::from(k % 3)).collect();
        (still.y_m, still.tangent_x, still.tangent_y) = (vec![0.1; 36], vec![0.0; 36], vec![0.0; 36]);
        assert_eq!(figure_of(&still), "", "no path and no zone");
        still.play_reach_m.iter_mut().for_each(|reach_m| *reach_m = 2e-4);
        (still.play_along_m, still.play_across_m) = (vec![2e-4; 36], vec![2e-4; 36]);
        let drawn = figure_of(&still);
        let words = "It stands still, so that no direction is along its motion: up to 0.20\u{a0}mm from its place.";
        assert!(drawn.contains(words) && !drawn.contains("Marks:") && !drawn.contains("across it"), "{drawn}");
    }

    fn figure_of_run(strays_m: f64, tolerance_m: f64) -> String {
        let PointPath { x_m, y_m, .. } = circle();
        let strayed: Vec<f64> = x_m.iter().map(|x| x + strays_m).collect();
        let course = RunCourse {
            name: "tip",
            point: "arm.tip",
            xy_m: [&strayed, &y_m],
            ideal_m: [&x_m, &y_m],
            tolerance_m,
            drive_angle_rad: Vec::new(),
        };
        let units = loosepin_text::units::DisplayUnits::default();
        run_path_figure(&course, &NumberWriter::for_page(&units)).into_string()
    }

    #[test]
    fn deviations_within_the_tolerance_of_a_run_are_not_magnified() {
        let off = figure_of_run(1e-4, 1e-9);
        assert!(off.contains("magnified") && off.contains("of deviation"), "{off}");
        for exact in [figure_of_run(0.0, 1e-9), figure_of_run(5e-10, 1e-9), figure_of_run(2e-17, 0.0)] {
            assert!(exact.contains("It is the ideal path") && !exact.contains("magnified"), "{exact}");
            assert!(!exact.contains("of deviation"), "{exact}");
        }
    }

    #[test]
    fn analytic_marks_stand_at_multiples_of_their_angle_and_once_a_turn() {
        let turn: Vec<f64> = (0..=360).map(|degree| f64::from(degree).to_radians()).collect();
        let found = marks(&turn);
        assert_eq!(found.len(), 12);
        assert_eq!((found[0], found[11]), ((0, 0.0), (330, 330.0)));
        // Just below zero is zero, without a sign.
        let before: Vec<f64> = (0..=12).map(|step| (f64::from(30 * step) - 1e-9).to_radians()).collect();
        assert!(marks(&before)[0].1.is_sign_positive());
        let late: Vec<f64> = (0..90).map(|step| (f64::from(step) + 44.6).to_radians()).collect();
        assert_eq!(marks(&late), [(15, 60.0), (45, 90.0), (75, 120.0)]);
    }
}
