//! The promise for a share of the box: how large it is, and what is promised.

use crate::file::problem::StudyProblem;
use crate::file::questions::ask::{Ask, Asked, PromisedEnds};
use crate::file::questions::requirement::Requirement;
use crate::file::reader::StudyReader;
use crate::file::sampling::MAX_INNER;
use loosepin_bounds::{PromiseSettings, Reading, least_promise_runs};
use loosepin_result::study::Side;
use loosepin_text::document::{Entry, Kind, Reads, Value, count};
use loosepin_text::record;
use loosepin_text::units::{Rule, format_number};
use loosepin_uncertainty::EpistemicVariable;

record! {
    /// a bound that holds in a share of the box of the intervals; it needs no model of the statistic
    pub(crate) lenient struct PromiseTable for Reads;
    /// share of the box, by volume, in which each promised bound holds
    optional share: f64 = Kind::Number { rule: Rule::Probability }, "0.99", or 0.99;
    /// confidence that this is true for all promised bounds at the same time
    optional confidence: f64 = Kind::Number { rule: Rule::Probability }, "0.99", or 0.99;
    /// runs at each point of the box
    optional inner: usize = count(1, MAX_INNER), "256", or 256;
}

impl StudyReader {
    /// The ends of the statistics of a question that are promised.
    pub(crate) fn promised_ends(&mut self, entry: Option<&Entry<'_>>, entries: &[(Entry<'_>, Asked)]) -> Vec<Side> {
        let Some(entry) = entry else { return Vec::new() };
        let Some(PromisedEnds(ends)) = PromisedEnds::read(self, entry) else { return Vec::new() };
        if !self.check_promise(entry) {
            return Vec::new();
        }
        for (asked_entry, asked) in entries {
            let quantile = match asked {
                // The half-width of a band is one number, whose upper end is promised.
                Asked::SimultaneousBand(share) => Some((*share, &[Side::Upper][..])),
                Asked::Statistic(statistic) if statistic.is_single() && statistic.is_by_shares() => {
                    statistic.probability_of_quantile().map(|probability| (probability, ends))
                }
                _ => {
                    let (entry, of) = (asked_entry.path.describe(), of_words(*asked));
                    let is_unbounded = matches!(asked, Asked::Statistic(statistic) if !statistic.is_by_shares());
                    self.report(&StudyProblem::PromiseOf { entry, of, is_unbounded }, asked_entry);
                    continue;
                }
            };
            let least = quantile.and_then(|(probability, ends)| {
                let least = ends.iter().map(|&side| least_promise_runs(probability, side)).max()?;
                Some((least, format!("the quantile at {}", format_number(probability))))
            });
            if let Some((least, of)) = least {
                self.check_promise_runs(asked_entry, least, of);
            }
        }
        ends.to_vec()
    }

    /// Whether the promise that is written at an entry can decide a requirement.
    pub(crate) fn is_decided_by_promise(&mut self, entry: &Entry<'_>, probability_at_least: f64) -> bool {
        if !self.check_promise(entry) {
            return false;
        }
        // That all mechanisms keep a limit is shown by no number of them, which has its own warning.
        if probability_at_least < 1.0 {
            let of = format!("a share of {} of the mechanisms", format_number(probability_at_least));
            // After no mechanism outside the limit of the share outside is 1 - γ^(1/N), which is small enough where p^N <= γ.
            self.check_promise_runs(entry, least_promise_runs(probability_at_least, Side::Upper), of);
        }
        true
    }

    /// That enough runs are made at each value for the limit of a statistic there.
    fn check_promise_runs(&mut self, entry: &Entry<'_>, least: usize, of: String) {
        let inner = self.promise.inner;
        if !self.random.is_empty() && inner < least {
            self.report(&StudyProblem::PromiseRuns { entry: entry.path.describe(), of, inner, least }, entry);
        }
    }

    /// That there is a box of which a share can be promised.
    fn check_promise(&mut self, entry: &Entry<'_>) -> bool {
        let has_interval = self.epistemic.iter().any(|input| input.interval().is_some());
        let beside = self.epistemic.iter().find_map(|input| match &input.variable {
            EpistemicVariable::SecondOrder(_) => Some("a parameter with a distribution"),
            EpistemicVariable::Evidence(evidence) if evidence.is_scattering() => {
                Some("a quantity that scatters in an unknown way")
            }
            _ => None,
        });
        let is_fixed = self.readings == [Reading::FixedButUnknown];
        let words = entry.path.describe();
        let problem = match (has_interval, beside) {
            (false, _) => StudyProblem::PromiseWithoutBox { entry: words },
            (_, Some(what)) => StudyProblem::PromiseBeside { entry: words, what },
            _ if !is_fixed => StudyProblem::PromiseBeside { entry: words, what: "another reading of intervals" },
            _ => return true,
        };
        self.report(&problem, entry);
        false
    }

    /// The promise, where anything is promised. `written`: the table of it; `allow`: what may be loosened, which no promise is of.
    pub fn promise(
        &mut self,
        [written, allow]: [Option<&Entry<'_>>; 2],
        asks: &[Ask],
        requirements: &[Requirement],
    ) -> Option<PromiseSettings> {
        let is_asked = asks.iter().any(|ask| !ask.promised.is_empty());
        if is_asked || requirements.iter().any(|requirement| requirement.is_promised) {
            if let Some(entry) = allow {
                let problem = StudyProblem::PromiseBeside { entry: entry.path.describe(), what: "a promise" };
                self.report(&problem, &entry.at_key());
            }
            return Some(self.promise);
        }
        if let Some(entry) = written.filter(|_| !self.reader.diagnostics.has_errors()) {
            self.report(&StudyProblem::NothingPromised { entry: entry.path.describe() }, &entry.at_key());
        }
        None
    }
}

/// What of a question cannot be promised.
fn of_words(asked: Asked) -> &'static str {
    match asked {
        Asked::Statistic(statistic) => statistic.description().with_article,
        Asked::Contributors => "contributors",
        Asked::Rare(..) => "a probability by a method",
        Asked::SimultaneousBand(_) => "a band",
    }
}
