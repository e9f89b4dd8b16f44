//! The terms of a page in plain words.

use maud::{Markup, html};

const TERMS: [(&str, &str); 12] = [
    (
        "Deviation",
        "Actual position minus ideal position at the same angle of the drive. The ideal mechanism has nominal dimensions \
         and no play. Total deviation = dimensional deviation (from tolerances) + clearance deviation (from play).",
    ),
    ("Random input", "Varies from part to part, with a known distribution. Example: a length within its tolerance."),
    (
        "Unknown input, an interval",
        "Fixed but unknown. Only its lower and its upper limit are known; no probability is assumed between them.",
    ),
    (
        "Unknown input, one of a list",
        "Fixed but unknown. Only the possible values or laws are known; no probabilities are assumed for them.",
    ),
    (
        "Bounds of a statistic",
        "The smallest and the largest value of a mean, a quantile or a probability over all values of the unknown inputs. The \
         true value lies between them.",
    ),
    ("Quantile", "The stated share of mechanisms stays below this value."),
    (
        "Random band, widened band",
        "The random band contains the stated share of mechanisms for the middle values of the unknown inputs. The widened band contains it for all their values.",
    ),
    (
        "Probability box",
        "Two curves. The true cumulative distribution lies between them for all values of the unknown inputs.",
    ),
    ("Attained at", "The values of the unknown inputs at which a bound is reached."),
    (
        "Numerical error",
        "The largest expected difference to the result of infinitely many runs. Its parts come from the finite number of samples, \
         from the search over the intervals, and from the surrogate if one was used. The bounds include it.",
    ),
    ("Coverage", "The share of mechanisms inside a band, for the true values of the unknown inputs."),
    (
        "Energy residual",
        "The error of the energy balance of a run, as a share of the largest energy exchanged. It checks the run.",
    ),
];

/// The list, folded on screen.
pub(crate) fn glossary() -> Markup {
    html! {
        details.glossary {
            summary { "Terms used on this page" }
            dl {
                @for (term, meaning) in TERMS {
                    dt { (term) }
                    dd { (meaning) }
                }
            }
        }
    }
}
