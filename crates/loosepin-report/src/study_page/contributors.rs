//! What would make the band narrower: tighter parts, or better measurement; one chart in two colours.

use maud::{Markup, html};

use crate::number::{NumberWriter, Rounding, plain_name};
use crate::still_figures::percent_of;
use crate::wording::response_words;
use loosepin_result::study::{Contributors, ShareRange, StudyResult};

pub(super) fn contributors(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "How much narrower the band that holds 95 % of mechanisms, whatever the unknown values are, would be without each input: "
            span class="swatch probability line" {} " " strong { "tighter parts" } " (a random input that did not scatter) or "
            span class="swatch mixed line" {} " " strong { "better measurement" } " (an unknown value that were known)."
        }
        @for one in &result.contributors { (figure(result, one, writer)) }
    }
}

fn figure(result: &StudyResult, one: &Contributors, writer: &NumberWriter) -> Markup {
    html! {
        figure.treatments {
            h3 {
                (response_words(result, (&one.output, one.of, one.at), writer))
            }
            table.cards {
                thead {
                    tr {
                        th scope="col" { "Input" }
                        th scope="col" { "Part of the band that would go" }
                        th.number scope="col" { "Share of the variance: alone" }
                        th.number scope="col" { "in all" }
                        th.number scope="col" { "Quasi-static share" }
                    }
                }
                tbody {
                    @for input in &one.random {
                        tr {
                            th scope="row" { (names(&input.paths, result)) }
                            td data-label="Part of the band" { (bar("probability", [input.band_share; 2], writer)) }
                            td.number data-label="Variance alone" { (share(&input.first, writer)) }
                            td.number data-label="Variance in all" { (share(&input.total, writer)) }
                            td.number data-label="Quasi-static share" { (known(input.quasi_static_share, writer)) }
                        }
                    }
                    @for input in &one.epistemic {
                        tr {
                            th scope="row" { (plain_name(&input.path, &result.inputs)) }
                            td data-label="Part of the band" { (bar("mixed", input.band_share, writer)) }
                            td.number data-label="Variance alone" { "–" }
                            td.number data-label="Variance in all" { "–" }
                            td.number data-label="Quasi-static share" { (known(input.quasi_static_share, writer)) }
                        }
                    }
                }
            }
            figcaption { (caption(one, writer)) }
        }
    }
}

/// What the numbers are and how far they can be trusted.
fn caption(one: &Contributors, writer: &NumberWriter) -> String {
    let error = one.epistemic.iter().map(|input| input.error).fold(0.0, f64::max);
    let mut caption = format!(
        "The band is {} wide{}. Known inputs: from the least to the most over the values that they may have, from the existing runs; \
         error {}.",
        writer.value(one.band_width_si, &one.unit),
        if one.at == loosepin_result::study::ResponsePoint::Whole { " in the mean over the poses" } else { "" },
        writer.percent(error, Rounding::Up)
    );
    if !one.points.is_empty() {
        caption.push_str(&format!(
            " Shares of the variance: Sobol' indices, first order and total, over {} of the unknown inputs with their errors \
             (confidence {}); their part of the band takes the scatter to shrink with the square root of the variance.",
            crate::wording::counted(one.points.len() as u64, "value", writer),
            writer.percent(one.confidence, Rounding::Nearest)
        ));
    }
    caption.push_str(
        " Quasi-static: of the variance by linear scatter without play, or of the worst case of all clearances, without dynamics.",
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

/// A share of the band, or its range.
pub(crate) fn band_share(share: [f64; 2], writer: &NumberWriter) -> String {
    let text = |share: f64| writer.percent((100.0 * share).round() / 100.0, Rounding::Nearest);
    match share {
        [least, _] if !least.is_finite() => "–".to_owned(),
        [least, most] if text(least) == text(most) => text(most),
        [least, most] => format!("{} to {}", text(least), text(most)),
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
