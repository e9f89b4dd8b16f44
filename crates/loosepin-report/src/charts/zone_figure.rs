//! The tolerance zone of a path: the ideal path, and beside it, magnified, where nearly all mechanisms stay whatever the unknown values are.

use maud::{Markup, html};

use crate::charts::figure::{Picture, csv_number};
use crate::charts::plane_view::{PlaneView, bars, is_closed, magnification, size_m};
use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::study::{CurveRange, DeviationCurve, PathCurve, SimultaneousCurve};
use loosepin_text::units::SiUnit;

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
    let xy_m = [path.x_m.as_slice(), path.y_m.as_slice()];
    let size_m = size_m(xy_m);
    let magnification = magnification(size_m, largest_m);
    let nominal_m =
        curve.nominal_si.iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, own| most.max(own.abs()));
    let view = PlaneView::new(xy_m, magnification * largest_m.max(nominal_m));
    let beside = |offsets_m: &[f64]| -> Vec<[f64; 2]> {
        let one = |k: usize| {
            let offset_m = magnification * offsets_m[k];
            [path.x_m[k] - offset_m * path.tangent_y[k], path.y_m[k] + offset_m * path.tangent_x[k]]
        };
        (0..poses).map(one).collect()
    };
    let is_closed = is_closed(xy_m, size_m);
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
    let has_nominal = curve.of.has_play()
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
        circle.start r="5" cx=(format!("{:.1}", view.place(ideal[0])[0])) cy=(format!("{:.1}", view.place(ideal[0])[1])) {}
        (bars(&view, Some(magnification), writer))
    };
    let caption = html! {
                strong { "The path of " (subject) ", deviations magnified " (magnified) " times." }
                " Dashed: the ideal path; the dot is where the recorded part begins. Orange: where " (stay) ", for all unknown values, \
                 at most "
                (writer.rounded(largest_m, &curve.unit, 2, Rounding::Up)) " to a side."
                @if nominal.is_some() { " Black: nominal parts." }
                @if curve.of.is_by_play_alone() {
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
