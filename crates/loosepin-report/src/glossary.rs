//! The terms of a page in plain words.

use maud::{Markup, html};

const TERMS: [(&str, &str); 12] = [
    (
        "Deviation",
        "Actual position minus ideal position at the same angle of the drive. The ideal mechanism has nominal dimensions \
         and no play. Total = dimensional (parts off their nominal size) + clearance (play).",
    ),
    ("Random input", "Scatters from part to part, with a known distribution: a length within its tolerance."),
    (
        "Interval input",
        "Fixed but unknown: one only knows the two ends between which it lies. No value inside is taken as likelier than \
         another.",
    ),
    (
        "One of a list",
        "Fixed but unknown: one only knows which few values, or laws, are possible. None is taken as likelier than another.",
    ),
    (
        "Bounds of a statistic",
        "The smallest and the largest value that a mean, a quantile or a probability takes as the interval inputs go \
         through all their values. The truth lies between.",
    ),
    ("Quantile", "The value below which the stated share of mechanisms stays."),
    (
        "Random band, widened band",
        "The random band holds the stated share of mechanisms for one middle value of the interval inputs. The widened \
         band holds it for every value of them.",
    ),
    (
        "Probability box",
        "Two curves between which the true distribution curve lies, wherever in their intervals the unknown inputs are.",
    ),
    ("Attained at", "The values of the interval inputs at which a bound is reached."),
    (
        "Numerical error",
        "How far the stated number may be from the one that infinitely many runs would give: from the finite number of \
         samples, from the search over the intervals, and from a surrogate model where one was used. Bounds are widened \
         by it.",
    ),
    ("Coverage", "The share of mechanisms that really lie inside a band."),
    (
        "Energy residual",
        "What does not add up in the energy account of a run, as a share of the largest energy exchanged. It is each \
         run's check of itself.",
    ),
];

/// The list, folded on screen.
pub(super) fn glossary() -> Markup {
    html! {
        details.glossary {
            summary { "The terms of this page in plain words" }
            dl {
                @for (term, meaning) in TERMS {
                    dt { (term) }
                    dd { (meaning) }
                }
            }
        }
    }
}
