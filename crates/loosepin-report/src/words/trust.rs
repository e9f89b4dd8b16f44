//! How long the positions of a history can be trusted: sentences, facts and a chart.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, EntryValues, Role};
use crate::medium::short_answer::Said;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::study::answer::turn_word;
use crate::words::wording::{count, listed};
use loosepin_result::simulation::{MeasuredTrust, Trust, TrustHorizon};
use loosepin_result::study::StudyResult;
use loosepin_text::article::Fact;
use loosepin_text::units::SiUnit;

/// The run that sentences speak of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrustedRun<'r> {
    /// Its trust.
    pub trust: &'r Trust,
    /// The subject of the sentences: `Positions`, with what run they are of where that is not clear.
    pub subject: &'r str,
    /// Whether turns count from the end of a start-up.
    pub has_start_up: bool,
    /// Speed of the drive where it is constant: else cycles are counted.
    pub drive_speed_rad_s: Option<f64>,
}

fn trust_tag(statistic: &str, part: &str) -> Tag {
    Tag::whole(&format!("trust, {statistic}"), part)
}

impl TrustedRun<'_> {
    /// How long its positions can be trusted; empty if they are not integrated.
    pub fn sentences(&self, writer: &NumberWriter) -> Vec<String> {
        match self.trust {
            Trust::Solved => Vec::new(),
            Trust::NotMeasured => vec!["It was not measured how long the positions can be trusted.".to_owned()],
            Trust::Measured(measured) => self.measured_sentences(measured, writer),
        }
    }

    /// The same with what they matter: a caveat where positions are right to no length until the end.
    pub fn said(&self, writer: &NumberWriter) -> Vec<Said> {
        let is_lost = matches!(self.trust, Trust::Measured(measured) if measured.whole_m.is_none());
        let said = |words: String| if is_lost { Said::caveat(words) } else { Said::answer(words) };
        // Each follows from the one before.
        Some(self.sentences(writer).join(" ")).filter(|words| !words.is_empty()).map(said).into_iter().collect()
    }

    fn measured_sentences(&self, measured: &MeasuredTrust, writer: &NumberWriter) -> Vec<String> {
        let length = |length_m: f64| {
            writer.with_tag(&trust_tag("whole run", "length")).rounded(length_m, &SiUnit::LENGTH, 1, Rounding::Up)
        };
        let whole = measured.whole_m.map(|whole_m| format!("to {} until the end of the run", length(whole_m)));
        let given = |horizon: &TrustHorizon| {
            writer.with_tag(&Tag::Given("length of a horizon")).value_trimmed(horizon.length_m, &SiUnit::LENGTH)
        };
        let until = |horizon: &TrustHorizon| {
            let instant = self.instant(horizon.length_m, horizon.until_s?, horizon.turns, writer);
            Some(format!("to {} until {instant}", given(horizon)))
        };
        // A length to which it is right to its end is larger than that to which all of it is.
        let is_shown = |horizon: &&TrustHorizon| !horizon.is_end || whole.is_none();
        let horizons = measured.horizons.iter().filter(is_shown).filter_map(until);
        let parts: Vec<String> = whole.iter().cloned().chain(horizons).collect();
        // Of lengths to which nothing is right the largest one says it of all.
        let never = measured.horizons.iter().filter(|horizon| horizon.until_s.is_none());
        let coarsest = never.max_by(|a, b| a.length_m.total_cmp(&b.length_m));
        let is_never = parts.is_empty() && coarsest.is_some() && measured.failure.is_none();
        if is_never {
            return vec![format!(
                "{} are chaotic: single ones are not reproducible to {}; statistics are.",
                self.subject,
                coarsest.map(given).unwrap_or_default()
            )];
        }
        let mut sentences = vec![match (parts.is_empty(), coarsest.map(given)) {
            (true, Some(never)) => format!("{} are not numerically accurate to {never}.", self.subject),
            (_, Some(never)) => {
                format!("{} are numerically accurate {}; never to {never}.", self.subject, listed(&parts))
            }
            (_, None) => format!("{} are numerically accurate {}.", self.subject, listed(&parts)),
        }];
        match (&measured.failure, measured.time_s.last()) {
            (Some(failure), Some(&last_s)) => sentences.push(format!(
                "Nothing is known about positions after {}: the second run that measures this did not finish ({failure}).",
                writer.with_tag(&trust_tag("second run", "end")).rounded(last_s, &SiUnit::TIME, 4, Rounding::Down)
            )),
            (Some(failure), None) => sentences.push(format!(
                "Nothing is known about positions: the second run that measures this did not start ({failure})."
            )),
            (None, _) if measured.whole_m.is_none() => sentences.push(
                "After that the run shows one of many possible histories. Statistics over many turns do not need exact positions."
                    .to_owned(),
            ),
            (None, _) => {}
        }
        sentences
    }

    fn instant(&self, length_m: f64, until_s: f64, turns: Option<f64>, writer: &NumberWriter) -> String {
        let tag = |part: &str| trust_tag("horizon", part).at(&length_m.to_string());
        let time = writer.with_tag(&tag("time")).rounded(until_s, &SiUnit::TIME, 4, Rounding::Down);
        let Some(turns) = turns else { return time };
        let recorded = if self.has_start_up { "recorded " } else { "" };
        let turns = writer.with_tag(&tag("turns")).rounded(turns, &SiUnit::NONE, 2, Rounding::Down);
        format!("{time} ({turns} {recorded}{}s)", turn_word(self.drive_speed_rad_s))
    }

    /// How that was measured.
    pub fn fact(&self, writer: &NumberWriter) -> Fact {
        let words = match self.trust {
            Trust::Solved => "positions follow from the drives at each instant; nothing is integrated".to_owned(),
            Trust::NotMeasured => "not measured: there was no second run".to_owned(),
            Trust::Measured(measured) => {
                let given = Tag::Given("tolerance of the second run");
                let tolerance = writer.with_tag(&given).value_shortest(measured.tolerance_m, &SiUnit::LENGTH);
                let evaluations = measured.evaluations.map_or(String::new(), |evaluations| {
                    let number = count(evaluations, &writer.with_tag(&Tag::Count("evaluations of the second run")));
                    format!(", {number} evaluations of the equations of motion")
                });
                let share =
                    writer.with_tag(&Tag::Given("share of a horizon")).percent(measured.share, Rounding::Nearest);
                format!(
                    "measured by a second run: {}, tolerance {tolerance}{evaluations}. A position counts as correct within a length while the two runs differ by at most {share} of this length",
                    measured.method
                )
            }
        };
        Fact::new("Accuracy of positions", [words])
    }

    /// The section of the page; `None` if nothing was measured.
    pub fn section(&self, writer: &NumberWriter) -> Option<Markup> {
        /// Tolerances between which the statistics of the reference study were held against each other, m (`docs/theory/time.md`).
        const COARSEST_M: f64 = 1e-6;
        const FINEST_M: f64 = 1e-10;
        let Trust::Measured(measured) = self.trust else { return None };
        let tolerance = |tolerance_m: f64| {
            writer
                .with_tag(&Tag::Given("tolerance of the reference study"))
                .value_shortest(tolerance_m, &SiUnit::LENGTH)
        };
        Some(html! {
            @for sentence in self.sentences(writer) { p { (sentence) } }
            @if measured.time_s.len() > 1 { (difference_chart(measured, writer)) }
            p {
                "A tolerance limits the error of each step, not that of the history: each impact amplifies it. So the run was made again, with \
                a smaller tolerance and by a method of another order. The two runs diverge as fast as each diverges from the exact motion."
            }
            p {
                "Means and quantiles over many turns do not need exact positions: in a reference study most of their bounds change by less than their stated \
                errors between tolerances of " (tolerance(COARSEST_M)) " and " (tolerance(FINEST_M)) ". Close to a computed chaotic motion, there is usually an exact motion with a slightly different start (shadowing)."
            }
        })
    }
}

/// The run of a study with nominal dimensions, in a sentence and why its statistics do not need it; empty if nothing was measured, or
/// where positions are not integrated.
pub(crate) fn nominal_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    if !matches!(result.nominal_trust, Trust::Measured(_)) {
        return Vec::new();
    }
    let run = TrustedRun {
        trust: &result.nominal_trust,
        subject: "In the run with nominal dimensions, positions",
        has_start_up: result.cycle.transient_turns > 0.0,
        drive_speed_rad_s: result.cycle.drive_speed_rad_s,
    };
    run.sentences(writer)
}

/// Differences of the runs over time, as powers of ten.
fn difference_chart(measured: &MeasuredTrust, writer: &NumberWriter) -> Markup {
    /// Below this, m, a difference is round-off.
    const MIN_M: f64 = 1e-16;
    let powers: Vec<f64> =
        measured.difference_m.iter().map(|&difference_m| libm::log10(difference_m.max(MIN_M))).collect();
    Chart {
        y_label: "powers of ten of a metre".to_owned(),
        entries: vec![Entry::new("largest difference of a position", Role::First, false, EntryValues::line(&powers))],
        height: 240,
        caption: html! {
            strong { "Largest difference of a position between the two runs, in powers of ten of a metre." }
            " Minus six is a thousandth of a millimetre."
        },
        alternative:
            "Chart of the largest difference of a position between two runs over time, in powers of ten of a metre."
                .to_owned(),
        ..Chart::over("trust-difference".to_owned(), "time", &measured.time_s, &SiUnit::TIME, writer)
    }
    .figure()
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_text::units::DisplayUnits;

    fn horizon(length_m: f64, until_s: Option<f64>, is_end: bool) -> TrustHorizon {
        TrustHorizon { length_m, until_s, turns: until_s.map(|until_s| until_s / 0.012), is_end }
    }

    fn measured(horizons: &[TrustHorizon], whole_m: Option<f64>, failure: Option<&str>) -> Trust {
        Trust::Measured(MeasuredTrust {
            tolerance_m: 1e-10,
            method: "Tsitouras 5(4)".into(),
            evaluations: None,
            share: 0.2,
            horizons: horizons.into(),
            whole_m,
            failure: failure.map(str::to_owned),
            time_s: vec![0.0, 0.0199],
            difference_m: vec![0.0, 1e-9],
        })
    }

    fn words(trust: &Trust, has_start_up: bool) -> String {
        let units = DisplayUnits::for_duration_s(0.024);
        let run = TrustedRun { trust, subject: "Positions", has_start_up, drive_speed_rad_s: Some(523.6) };
        run.sentences(&NumberWriter::for_terminal(&units)).join(" ").replace('\u{a0}', " ")
    }

    #[test]
    fn horizons_are_told_by_length_with_time_and_turns() {
        let parted =
            [horizon(1e-5, Some(0.0151), false), horizon(1e-6, Some(0.0132), false), horizon(1e-7, None, false)];
        assert_eq!(
            words(&measured(&parted, None, None), true),
            "Positions are numerically accurate to 0.01 mm until 15.10 ms (1.2 recorded turns) and to 0.001 mm until 13.20 ms (1.1 recorded turns); \
             never to 0.0001 mm. After that the run shows one of many possible histories. Statistics over many turns do not need exact positions."
        );
    }

    #[test]
    fn what_is_right_at_no_instant_is_told_once() {
        let none = [1e-5, 1e-6, 1e-7].map(|length_m| horizon(length_m, None, false));
        assert_eq!(
            words(&measured(&none, None, None), false),
            "Positions are chaotic: single ones are not reproducible to 0.01 mm; statistics are."
        );
        let one = [horizon(1e-5, Some(0.0151), false), horizon(1e-6, None, false), horizon(1e-7, None, false)];
        let told = words(&measured(&one, None, None), false);
        assert!(
            told.starts_with(
                "Positions are numerically accurate to 0.01 mm until 15.10 ms (1.2 turns); never to 0.001 mm."
            ),
            "{told}"
        );
        let stopped = words(&measured(&none, None, Some("no memory")), false);
        assert!(stopped.starts_with("Positions are not numerically accurate to 0.01 mm."), "{stopped}");
    }

    #[test]
    fn what_holds_until_the_end_is_told_once() {
        let most =
            [horizon(1e-5, Some(0.024), true), horizon(1e-6, Some(0.024), true), horizon(1e-7, Some(0.0132), false)];
        assert_eq!(
            words(&measured(&most, Some(6.21e-7), None), false),
            "Positions are numerically accurate to 0.0007 mm until the end of the run and to 0.0001 mm until 13.20 ms (1.1 turns)."
        );
        let all = most.map(|horizon| TrustHorizon { until_s: Some(0.024), is_end: true, ..horizon });
        assert_eq!(
            words(&measured(&all, Some(1e-9), None), false),
            "Positions are numerically accurate to 1e-6 mm until the end of the run."
        );
    }

    #[test]
    fn what_is_not_known_is_told() {
        let until = [horizon(1e-5, Some(0.0199), false)];
        assert_eq!(
            words(&measured(&until, None, Some("the limit of 1000 evaluations was reached")), false),
            "Positions are numerically accurate to 0.01 mm until 19.90 ms (1.6 turns). Nothing is known about positions after 19.90 ms: the second run that measures this did not finish (the limit of 1000 evaluations was reached)."
        );
        assert_eq!(words(&Trust::NotMeasured, false), "It was not measured how long the positions can be trusted.");
        assert_eq!(words(&Trust::Solved, false), "");
    }
}
