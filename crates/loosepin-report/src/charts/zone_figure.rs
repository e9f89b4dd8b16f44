//! The tolerance zone of a path: the ideal path, and beside it, magnified, where nearly all mechanisms stay whatever the unknown values are.

use maud::{Markup, html};

use crate::charts::figure::{Picture, csv_number};
use crate::mechanism::shapes::MM_PER_M;
use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::study::{CurveRange, Deviation, DeviationCurve, PathCurve, SimultaneousCurve};
use loosepin_text::units::SiUnit;

/// The longer side of the picture in its own units; a unit is about a pixel.
const SIDE: f64 = 640.0;
const MARGIN: f64 = 48.0;
/// The widest deviation is drawn as about this share of the size of the path.
const VISIBLE_SHARE: f64 = 0.08;
/// The bar of the scale is about this share of the picture.
const BAR_SHARE: f64 = 0.18;

/// Positions in the picture.
struct View {
    left_m: f64,
    top_m: f64,
    per_m: f64,
    width: f64,
    height: f64,
}

impl View {
    /// Around all points, each so far from the path.
    fn new(path: &PathCurve, room_m: f64) -> Self {
        let range = |values: &[f64]| {
            let low = values.iter().fold(f64::INFINITY, |low, value| low.min(*value)) - room_m;
            (low, values.iter().fold(f64::NEG_INFINITY, |high, value| high.max(*value)) + room_m)
        };
        let ((left, right), (low, high)) = (range(&path.x_m), range(&path.y_m));
        let per_m = SIDE / (right - left).max(high - low).max(f64::MIN_POSITIVE);
        let [width, height] = [right - left, high - low].map(|side| (side * per_m).max(0.3 * SIDE) + 2.0 * MARGIN);
        Self { left_m: left, top_m: high, per_m, width, height: height + MARGIN }
    }

    fn point(&self, [x_m, y_m]: [f64; 2]) -> String {
        format!("{:.1} {:.1}", MARGIN + (x_m - self.left_m) * self.per_m, MARGIN + (self.top_m - y_m) * self.per_m)
    }

    /// A line through points; whole curves are closed.
    fn line(&self, points: &[[f64; 2]]) -> String {
        let mut line = String::new();
        for (k, point) in points.iter().enumerate() {
            line.push_str(if k == 0 { "M" } else { "L" });
            line.push_str(&self.point(*point));
        }
        line
    }
}

/// The figure, or nothing where the curve is no distance from a path, or has no ends.
pub(crate) fn zone_figure(curve: &DeviationCurve, name: String, subject: &str, writer: &NumberWriter) -> Markup {
    let Some(path) = &curve.path else { return html! {} };
    let whole = curve.simultaneous.iter().find(|each| !each.band.lower_si.is_empty());
    let band = whole.map_or(&curve.mixed, |each| &each.band);
    let poses = path.x_m.len();
    let ends = [&band.lower_si, &band.upper_si];
    let is_complete = poses > 2
        && path.y_m.len() == poses
        && path.tangent_x.len() == poses
        && path.tangent_y.len() == poses
        && ends.iter().all(|end| end.len() == poses && end.iter().all(|value| value.is_finite()))
        && [&path.x_m, &path.y_m, &path.tangent_x, &path.tangent_y]
            .iter()
            .all(|list| list.iter().all(|v| v.is_finite()));
    if !is_complete {
        return html! {};
    }
    let largest_m = ends.iter().flat_map(|end| end.iter()).fold(0.0_f64, |most, value| most.max(value.abs()));
    let size_m = size_m(path);
    let magnification = round_factor(VISIBLE_SHARE * size_m / largest_m.max(1e-9 * size_m));
    let nominal_m =
        curve.nominal_si.iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, own| most.max(own.abs()));
    let view = View::new(path, magnification * largest_m.max(nominal_m));
    let beside = |offsets_m: &[f64]| -> Vec<[f64; 2]> {
        let one = |k: usize| {
            let offset_m = magnification * offsets_m[k];
            [path.x_m[k] - offset_m * path.tangent_y[k], path.y_m[k] + offset_m * path.tangent_x[k]]
        };
        (0..poses).map(one).collect()
    };
    let is_closed = is_closed(path, size_m);
    let closing = if is_closed { "Z" } else { "" };
    let [lower, upper] = ends.map(|end| beside(end));
    // One piece of the band for each step along the path, all turned the same way round: where the path is passed again, or crosses itself,
    // the pieces lie upon each other and leave no hole.
    let steps = if is_closed { poses } else { poses - 1 };
    let zone: String = (0..steps)
        .map(|k| (k, (k + 1) % poses))
        .map(|(k, next)| {
            let mut corners = [lower[k], lower[next], upper[next], upper[k]];
            if area(&corners) < 0.0 {
                corners.reverse();
            }
            format!("{}Z", view.line(&corners))
        })
        .collect();
    let borders = format!("{}{closing}{}{closing}", view.line(&upper), view.line(&lower));
    let ideal: Vec<[f64; 2]> = (0..poses).map(|k| [path.x_m[k], path.y_m[k]]).collect();
    // Scatter of the parts alone leaves nominal parts where they are.
    let has_nominal = curve.of != Deviation::Dimensional
        && curve.nominal_si.len() == poses
        && curve.nominal_si.iter().all(|value| value.is_finite());
    let nominal = has_nominal.then(|| beside(&curve.nominal_si));
    let stay = stay_words(curve, whole, writer);
    let magnified = format!("{magnification}");
    let alternative = format!(
        "The ideal path of {subject} and the zone about it in which {stay}, magnified {magnified} times; it extends {} to each side.",
        writer.rounded(largest_m, &curve.unit, 2, Rounding::Up)
    );
    let drawn = html! {
        path.band d=(zone) {}
        path.border d=(borders) {}
        @if let Some(nominal) = &nominal { path.actual d={ (view.line(nominal)) (closing) } {} }
        path.ideal d={ (view.line(&ideal)) (closing) } {}
        circle.start r="5" cx=(start(&view, &ideal[0]).0) cy=(start(&view, &ideal[0]).1) {}
        (bars(&view, magnification, writer))
    };
    let caption = html! {
                strong { "The path of " (subject) ", deviations magnified " (magnified) " times." }
                " Dashed: the ideal path; the dot is where the recorded part begins. Orange: where " (stay) ", for all unknown values, \
                 at most "
                (writer.rounded(largest_m, &curve.unit, 2, Rounding::Up)) " to a side."
                @if nominal.is_some() { " Black: nominal parts." }
                @if curve.of == Deviation::Clearance {
                    " Deviations are those of each mechanism from its own ideal path, drawn on the nominal ideal path."
                }
    };
    let csv = zone_csv(curve, path, band, writer);
    Picture { name, class: "zone", view: [0.0, 0.0, view.width, view.height], below: 0.0, alternative, drawn }
        .figure(caption, Some(&csv))
}

/// The ideal path and the ends of the zone beside it, pose by pose.
fn zone_csv(curve: &DeviationCurve, path: &PathCurve, band: &CurveRange, writer: &NumberWriter) -> String {
    let (length, own) = (writer.units.of(&SiUnit::LENGTH), writer.units.of(&curve.unit));
    let mut text =
        format!("angle [deg],ideal x [{0}],ideal y [{0}],lower end [{1}],upper end [{1}]\n", length.symbol, own.symbol);
    for (k, angle_rad) in curve.pose_rad.iter().enumerate().take(path.x_m.len()) {
        let cells = [
            Some(angle_rad.to_degrees()),
            Some(length.from_si(path.x_m[k])),
            Some(length.from_si(path.y_m[k])),
            band.lower_si.get(k).map(|value| own.from_si(*value)),
            band.upper_si.get(k).map(|value| own.from_si(*value)),
        ];
        let cells = cells.map(|cell| cell.map_or(String::new(), csv_number));
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    text
}

/// Twice the area that corners enclose, above zero against the clock.
fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

fn stay_words(curve: &DeviationCurve, whole: Option<&SimultaneousCurve>, writer: &NumberWriter) -> String {
    match whole {
        Some(each) => {
            format!("{} of mechanisms stay for the whole cycle", writer.percent(each.share, Rounding::Nearest))
        }
        None => {
            let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
            format!("{share} of mechanisms stay at each angle")
        }
    }
}

fn start(view: &View, point: &[f64; 2]) -> (String, String) {
    let text = view.point(*point);
    let (x, y) = text.split_once(' ').unwrap_or(("0", "0"));
    (x.to_owned(), y.to_owned())
}

/// Two bars: a length of the path, and a deviation from it.
fn bars(view: &View, magnification: f64, writer: &NumberWriter) -> Markup {
    let about_m = BAR_SHARE * SIDE / view.per_m;
    let bar = |length_m: f64, factor: f64, y: f64, what: &str, class: &str| {
        let length = length_m * factor * view.per_m;
        html! {
            g class={ "bar " (class) } transform=(format!("translate({MARGIN} {y:.1})")) {
                path d=(format!("M0 -4V4M0 0H{length:.1}M{length:.1} -4V4")) {}
                text x=(format!("{:.1}", length + 10.0)) y="5" {
                    (writer.value_shortest(length_m, &SiUnit::LENGTH)) " " (what)
                }
            }
        }
    };
    let (path_m, deviation_m) = (round_length_m(about_m), round_length_m(about_m / magnification));
    html! {
        (bar(path_m, 1.0, view.height - 50.0, "along the path", "of-path"))
        (bar(deviation_m, magnification, view.height - 24.0, "of deviation", "of-deviation"))
    }
}

/// The diagonal of the path's frame, m.
fn size_m(path: &PathCurve) -> f64 {
    let extent = |values: &[f64]| {
        let high = values.iter().fold(f64::NEG_INFINITY, |high, value| high.max(*value));
        high - values.iter().fold(f64::INFINITY, |low, value| low.min(*value))
    };
    extent(&path.x_m).hypot(extent(&path.y_m))
}

/// Whether the last pose lies before the first one as poses do.
fn is_closed(path: &PathCurve, size_m: f64) -> bool {
    let last = path.x_m.len() - 1;
    let between = |a: usize, b: usize| (path.x_m[a] - path.x_m[b]).hypot(path.y_m[a] - path.y_m[b]);
    let longest = (0..last).map(|k| between(k, k + 1)).fold(0.0, f64::max);
    between(last, 0) <= 1.5 * longest.max(1e-3 * size_m)
}

/// 1, 2 or 5 times a power of ten, at most `factor`; at least 1.
pub(crate) fn round_factor(factor: f64) -> f64 {
    round_down(factor).max(1.0)
}

/// 1, 2 or 5 times a power of ten millimetres, at most `length_m`.
fn round_length_m(length_m: f64) -> f64 {
    round_down(length_m * MM_PER_M) / MM_PER_M
}

fn round_down(value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= value * (1.0 + 1e-9)).unwrap_or(1.0);
    // A power of ten below one has round-off.
    format!("{:.12e}", step * power).parse().unwrap_or(step * power)
}

#[cfg(test)]
mod tests {
    use super::{is_closed, round_down, round_factor};
    use loosepin_result::study::PathCurve;

    #[test]
    fn analytic_round_numbers() {
        for (value, round) in
            [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (49.0, 20.0), (50.0, 50.0), (0.03, 0.02), (1e3, 1e3)]
        {
            assert_eq!(round_down(value), round, "{value}");
        }
        assert_eq!(round_factor(0.3), 1.0);
    }

    #[test]
    fn analytic_a_circle_is_closed_and_half_of_it_is_not() {
        let arc = |turns: f64| {
            let angle = |k: usize| std::f64::consts::TAU * turns * k as f64 / 36.0;
            PathCurve {
                x_m: (0..36).map(|k| angle(k).cos()).collect(),
                y_m: (0..36).map(|k| angle(k).sin()).collect(),
                ..PathCurve::default()
            }
        };
        assert!(is_closed(&arc(1.0), 2.0) && !is_closed(&arc(0.5), 2.0));
    }
}
