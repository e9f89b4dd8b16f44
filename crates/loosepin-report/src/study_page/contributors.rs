//! Sensitivity: how much narrower the band becomes by a tighter tolerance or a better measurement; one chart in two colours.

use maud::{Markup, html};

use crate::number::{NumberWriter, Rounding, plain_name};
use crate::page::cards;
use crate::still_figures::percent_of;
use crate::tag::{Tag, read_the_same};
use crate::wording::response_words;
use loosepin_result::study::{Contributors, ShareRange, StudyResult};

pub(super) fn contributors(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Each bar shows how much narrower the band of " (band_probability(writer)) " of mechanisms becomes without the uncertainty of one input: "
            span class="swatch probability line" {} " " strong { "tighter tolerance" } " (a random input without scatter) or "
            span class="swatch mixed line" {} " " strong { "better measurement" } " (an unknown value that is measured)."
        }
        @for one in &result.contributors { (figure(result, one, writer)) }
    }
}

fn figure(result: &StudyResult, one: &Contributors, writer: &NumberWriter) -> Markup {
    let tag = |part: &str, paths: &[String]| Tag::contributors(one, part, &paths.join(" "));
    let of_path = |part: &str, path: &String| Tag::contributors(one, part, path);
    let random = one.random.iter().map(|input| {
        [
            html! { (names(&input.paths, result)) },
            bar("probability", [input.band_share; 2], &writer.about(&tag("band", &input.paths))),
            html! { (share(&input.first, &writer.about(&tag("first", &input.paths)))) },
            html! { (share(&input.total, &writer.about(&tag("total", &input.paths)))) },
            html! { (known(input.quasi_static_share, &writer.about(&tag("quasi-static", &input.paths)))) },
        ]
    });
    let epistemic = one.epistemic.iter().map(|input| {
        [
            html! { (plain_name(&input.path, &result.inputs)) },
            bar("mixed", input.band_share, &writer.about(&of_path("band", &input.path))),
            html! { "–" },
            html! { "–" },
            html! { (known(input.quasi_static_share, &writer.about(&of_path("quasi-static", &input.path)))) },
        ]
    });
    html! {
        figure.treatments {
            h3 {
                (response_words(result, (&one.output, one.of, one.at), writer))
            }
            (cards(
                ["Input", "Band narrower by", "#Sobol' index, first order", "#Sobol' index, total", "#Quasi-static share"],
                random.chain(epistemic),
            ))
            figcaption { (caption(one, writer)) }
        }
    }
}

/// Meaning and error of the numbers.
fn caption(one: &Contributors, writer: &NumberWriter) -> String {
    let error = one.epistemic.iter().map(|input| input.error).fold(0.0, f64::max);
    let mut caption = format!(
        "The band is {} wide{}. For an unknown value, the reduction depends on the measured value: the bar goes from the smallest to \
         the largest. It is computed from the existing runs, with an error of {}.",
        writer.about(&Tag::contributors(one, "band width", "")).value(one.band_width_si, &one.unit),
        if one.at == loosepin_result::study::ResponsePoint::Whole { " on average over the poses" } else { "" },
        writer.about(&Tag::contributors(one, "error", "")).percent(error, Rounding::Up)
    );
    if !one.points.is_empty() {
        caption.push_str(&format!(
            " Sobol' indices are shares of the variance, at {} of the unknown inputs, errors included (confidence {}). For a random \
             input, the band is assumed to shrink with the square root of the variance.",
            crate::wording::counted(one.points.len() as u64, "value", &writer.about(&Tag::Count("values with Sobol' indices"))),
            writer.about(&Tag::Given("confidence")).percent(one.confidence, Rounding::Nearest)
        ));
    }
    caption.push_str(
        " Quasi-static share, without dynamics: share of the variance by linear scatter without play, or share of the worst case of \
         all clearances.",
    );
    caption
}

fn names(paths: &[String], result: &StudyResult) -> String {
    let names: Vec<String> = paths.iter().map(|path| plain_name(path, &result.inputs)).collect();
    crate::wording::listed(&names)
}

/// A share over the values that were tried.
pub(crate) fn share(share: &ShareRange, writer: &NumberWriter) -> String {
    if share.lower.is_finite() { writer.percent_range(share.lower, share.upper) } else { "–".to_owned() }
}

/// A share that may not exist.
pub(crate) fn known(share: Option<f64>, writer: &NumberWriter) -> String {
    share.map_or("–".to_owned(), |share| writer.percent(share, Rounding::Nearest))
}

/// The share of mechanisms that the bands hold which sensitivities are about.
pub(crate) fn band_probability(writer: &NumberWriter) -> String {
    const BAND_PROBABILITY: f64 = 0.95;
    writer.about(&Tag::Given("probability")).percent(BAND_PROBABILITY, Rounding::Nearest)
}

/// A share of the band, or its range.
pub(crate) fn band_share(share: [f64; 2], writer: &NumberWriter) -> String {
    let text = |part: &str, share: f64| {
        let tag = writer.tag().map(|tag| tag.part(part));
        writer.about_maybe(tag.as_ref()).percent((100.0 * share).round() / 100.0, Rounding::Nearest)
    };
    let (least, most) = (text("least", share[0]), text("most", share[1]));
    match share {
        [least, _] if !least.is_finite() => "–".to_owned(),
        _ if read_the_same(&least, &most) => most,
        _ => format!("{least} to {most}"),
    }
}

fn bar(colour: &'static str, share: [f64; 2], writer: &NumberWriter) -> Markup {
    let [least, most] = share.map(|share| if share.is_finite() { share } else { 0.0 });
    let text = band_share(share, writer);
    html! {
        svg.bar width="100%" height="20" role="img" aria-label=(text) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            rect class=(colour) x="0%" y="4" width=(percent_of(least, 0.0, 1.0)) height="12" rx="2" {}
            // What depends on the value that it turns out to have.
            rect class=(colour) x=(percent_of(least, 0.0, 1.0)) y="8" width=(percent_of(most - least, 0.0, 1.0)) height="4" {}
        }
        span.range { (text) }
    }
}
