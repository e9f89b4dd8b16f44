//! The three treatments side by side: band, width, share inside, promise.

use maud::{Markup, html};

use crate::answer::treatment_sentences;
use crate::number::{NumberWriter, Rounding};
use crate::still_figures::percent_of;
use crate::tag::Tag;
use crate::wording::{
    EQUALLY_PROBABLE, WIDTH_DIGITS, band_digits, band_error, has_errors, has_lists, promise_word, response_words,
    share_words, treatment_words, unknown_words,
};
use loosepin_result::study::{StudyResult, Treatment, TreatmentBand, TreatmentComparison};

pub(super) fn treatments(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Three treatments of the same inputs. Each gives a band that is meant to hold a promised share of mechanisms. The share \
             inside depends on the unknown values. It was counted at all unknown values "
            @if is_learned(result) {
                "tested, with the surrogate. The shares include the error of the surrogate."
            } @else {
                "tested, in the runs of the mixed treatment."
            }
            @if has_lists(&result.inputs) {
                " " (EQUALLY_PROBABLE)
            }
        }
        @for comparison in &result.treatments { (one(result, comparison, writer)) }
    }
}

/// Whether the bands are those of a surrogate that stands alone.
fn is_learned(result: &StudyResult) -> bool {
    result.treatments.iter().flat_map(|comparison| &comparison.bands).any(|band| band.is_by_surrogate)
}

fn one(result: &StudyResult, comparison: &TreatmentComparison, writer: &NumberWriter) -> Markup {
    let band_ends = || comparison.bands.iter().flat_map(|band| [band.lower_si, band.upper_si]);
    let (from, to) = padded(band_ends().fold(f64::INFINITY, f64::min), band_ends().fold(f64::NEG_INFINITY, f64::max));
    let promised = comparison.promised_coverage;
    let least = comparison.bands.iter().map(TreatmentBand::least_share).fold(promised, f64::min);
    let share_from = ((least - 0.5 * (1.0 - least)).max(0.0) * 20.0).floor() / 20.0;
    let given = Tag::Given("promised share");
    let promise = writer.about(&given).percent(promised, Rounding::Nearest);
    html! {
        figure.treatments {
            h3 {
                (response_words(result, (&comparison.output, comparison.of, comparison.at), writer))
            }
            table.cards {
                thead {
                    tr {
                        th scope="col" { "Treatment" }
                        th scope="col" { "Band for " (promise) " of mechanisms" }
                        @if has_errors(comparison) { th.number scope="col" { "± error" } }
                        th.number scope="col" { "Width" }
                        th scope="col" { "Share inside" }
                        th scope="col" { "Promise" }
                    }
                }
                tbody {
                    @for band in &comparison.bands {
                        tr {
                            th scope="row" { (treatment_words(band.treatment)) }
                            td data-label="Band" { (band_bar(band, comparison, from, to, writer)) }
                            @if has_errors(comparison) {
                                td.number data-label="± error" { (band_error(band, comparison, writer)) }
                            }
                            td.number data-label="Width" {
                                (writer
                                    .about(&Tag::band(comparison, band, "width"))
                                    .rounded(band.width_si(), &comparison.unit, WIDTH_DIGITS, Rounding::Nearest))
                            }
                            td data-label="Share inside" { (coverage_strip(band, comparison, share_from, writer)) }
                            td data-label="Promise" {
                                @let word = promise_word(band, promised);
                                @if band.is_promise_unknown(promised) { span.verdict.undecided { (word) } }
                                @else if band.keeps_promise(promised) { span.verdict.met { (word) } }
                                @else { span.verdict.not-met { (word) } }
                            }
                        }
                    }
                }
            }
            figcaption {
                "Bars: the bands on a common scale. Dots: the share inside at each tested value of the "
                (unknown_words(&result.inputs)) ", from " (writer.about(&Tag::Given("axis")).percent(share_from, Rounding::Nearest)) " to "
                (writer.about(&Tag::Given("axis")).percent(1.0, Rounding::Nearest)) ". Vertical line: the promised " (promise) "."
            }
        }
        ul.treatment-words {
            @for (band, sentence) in comparison.bands.iter().zip(treatment_sentences(comparison, writer)) {
                li { strong { (treatment_words(band.treatment)) ". " } (sentence) }
            }
        }
    }
}

fn padded(from: f64, to: f64) -> (f64, f64) {
    let margin = 0.04 * (to - from);
    (from - margin, to + margin)
}

fn colour(treatment: Treatment) -> &'static str {
    match treatment {
        Treatment::ProbabilityOnly => "probability",
        Treatment::IntervalOnly => "worst",
        Treatment::Mixed => "mixed",
    }
}

fn band_bar(
    band: &TreatmentBand,
    comparison: &TreatmentComparison,
    from: f64,
    to: f64,
    writer: &NumberWriter,
) -> Markup {
    let rounded = |part: &str, value_si: f64, rounding| {
        let digits = band_digits(comparison);
        writer.about(&Tag::band(comparison, band, part)).rounded(value_si, &comparison.unit, digits, rounding)
    };
    let lower = rounded("lower", band.lower_si, Rounding::Down);
    let upper = rounded("upper", band.upper_si, Rounding::Up);
    let width = percent_of(band.upper_si - band.lower_si, 0.0, to - from);
    html! {
        svg.bar width="100%" height="20" role="img" aria-label=(format!("Band from {lower} to {upper}")) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            @if from < 0.0 && to > 0.0 {
                @let zero = percent_of(0.0, from, to);
                line.zero x1=(zero) x2=(zero) y1="0" y2="20" {}
            }
            rect class=(colour(band.treatment)) x=(percent_of(band.lower_si, from, to)) y="4" width=(width) height="12"
                rx="2" {}
        }
        span.range { (lower) " to " (upper) }
    }
}

fn coverage_strip(
    band: &TreatmentBand,
    comparison: &TreatmentComparison,
    share_from: f64,
    writer: &NumberWriter,
) -> Markup {
    let range = share_words(band, comparison, writer);
    let promised = comparison.promised_coverage;
    let place = |share: f64| percent_of(share, share_from - 0.02 * (1.0 - share_from), 1.0 + 0.02 * (1.0 - share_from));
    html! {
        svg.strip width="100%" height="20" role="img" aria-label=(format!("Share inside: {range}")) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            line.range x1=(place(band.least_share())) x2=(place(band.coverage_maximum)) y1="10" y2="10" {}
            @for point in &band.coverage_at { circle cx=(place(point.coverage)) cy="10" r="2.5" {} }
            line.promise x1=(place(promised)) x2=(place(promised)) y1="1" y2="19" {}
        }
        span.range { (range) }
    }
}
