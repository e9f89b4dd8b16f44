//! Loosest values that meet the requirements, and the estimates of small probabilities: sentences for pages and terminals.

use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::study::together::{ALL_ELSE, ALLOWED_DIGITS, joint_loosening_sentences, subject};
use crate::words::wording::{
    counted, counted_as, deviation_words, listed, place_words, statistic_words, verdict_words,
};
use loosepin_result::study::{
    AllocationRecord, AllocationStop, AllowanceRecord, Loosened, RareEnd, RareMethodUsed, RareRecord, StudyResult,
    Verdict,
};

/// One sentence for each input that may be loosened, then those for several together, then one for the cheapest combination.
pub(crate) fn inverse_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let allowed = result.allowances.iter().map(|one| allowance(result, one, writer));
    let together = result.together.iter().flat_map(|one| joint_loosening_sentences(result, one, writer));
    allowed.chain(together).chain(result.allocation.iter().map(|one| allocation(result, one, writer))).collect()
}

/// The loosest fit of a list.
fn fit_allowance(result: &StudyResult, one: &AllowanceRecord, writer: &NumberWriter) -> String {
    let name = plain_name(&one.path, &result.inputs);
    let runs = counted(one.runs, "run", writer);
    let least = |fit: &String| {
        let own = one.checks.iter().filter(|check| check.fit.as_ref() == Some(fit));
        own.min_by(|a, b| a.answer.share.total_cmp(&b.answer.share)).map_or_else(String::new, |check| {
            let share = writer.percent(check.answer.share, Rounding::Down);
            format!("{share}, required {}", writer.percent(check.answer.required_share, Rounding::Nearest))
        })
    };
    let refused = |fit: &String| {
        let check = one.checks.iter().rev().find(|check| check.fit.as_ref() == Some(fit));
        check.map_or("the verdict is not known".to_owned(), |check| {
            format!("they are {} ({})", verdict_words(check.answer.verdict), least(fit))
        })
    };
    match (&one.allowed_fit, &one.beyond_fit) {
        (Some(allowed), Some(beyond)) => format!(
            "The {name} may have the fit {allowed}: all requirements are met ({}), also with other random numbers. With {beyond}, the \
             next looser fit, {}. {ALL_ELSE}, {runs}.",
            least(allowed),
            refused(beyond),
        ),
        (Some(allowed), None) => format!(
            "The {name} may have the fit {allowed}, the loosest of the list: all requirements are met ({}), also with other random \
             numbers. {ALL_ELSE}, {runs}.",
            least(allowed),
        ),
        (None, Some(tightest)) => format!(
            "No fit of the list for the {name} meets the requirements: with {tightest}, the tightest fit, {}. {ALL_ELSE}, {runs}.",
            refused(tightest),
        ),
        (None, None) => format!("The study has no fit for the {name}."),
    }
}

fn allowance(result: &StudyResult, one: &AllowanceRecord, writer: &NumberWriter) -> String {
    if one.what == Loosened::Fit {
        return fit_allowance(result, one, writer);
    }
    let subject = subject(result, &one.path, one.what);
    let value = |value_si: f64, rounding| writer.rounded(value_si, &one.unit, ALLOWED_DIGITS, rounding);
    let checked = |value_si: f64| one.checks.iter().rev().find(|check| check.value_si == value_si);
    let share = |value_si: f64| {
        checked(value_si).map_or(String::new(), |check| {
            let [share, required] = [check.answer.share, check.answer.required_share];
            format!(
                "{}, required {}",
                writer.percent(share, Rounding::Down),
                writer.percent(required, Rounding::Nearest)
            )
        })
    };
    let runs = counted(one.runs, "run", writer);
    match (one.allowed_si, one.beyond_si) {
        (Some(allowed), Some(beyond)) => format!(
            "The {subject} may be {}: all requirements are met ({}), also with other random numbers. At {} {}. {ALL_ELSE}, {runs}.",
            value(allowed, Rounding::Down),
            share(allowed),
            value(beyond, Rounding::Up),
            checked(beyond).map_or("the verdict is not known".to_owned(), |check| {
                format!("they are {} ({})", verdict_words(check.answer.verdict), share(beyond))
            }),
        ),
        (Some(allowed), None) => format!(
            "The {subject} may be {}, the largest value of the range: all requirements are met ({}), also with other random numbers. \
             {ALL_ELSE}, {runs}.",
            value(allowed, Rounding::Down),
            share(allowed),
        ),
        (None, _) => {
            let least = one.checks.iter().map(|check| check.value_si).fold(f64::INFINITY, f64::min);
            if checked(least).is_some_and(|check| check.answer.verdict == Verdict::Undecided) {
                return format!(
                    "No tested value of the {subject} is shown to meet the requirements. At {}, the smallest, they are undecided \
                     ({}): increase 'inner'. {ALL_ELSE}, {runs}.",
                    value(least, Rounding::Nearest),
                    share(least)
                );
            }
            format!(
                "No tested value of the {subject} meets the requirements, not even {}, the smallest ({}). {ALL_ELSE}, {runs}.",
                value(least, Rounding::Nearest),
                share(least)
            )
        }
    }
}

fn allocation(result: &StudyResult, one: &AllocationRecord, writer: &NumberWriter) -> String {
    let combinations = counted(one.combinations, "combination", writer);
    let studies = counted_as(one.studies, "direct study", "direct studies", writer);
    match one.stop {
        AllocationStop::Found => {}
        AllocationStop::AllExcluded => {
            return format!(
                "No offer found: none of {combinations} meets the requirements. Each was run, or is looser than one that was run \
                 ({studies})."
            );
        }
        AllocationStop::TriedEnough => {
            let left = one.combinations - one.excluded;
            return format!(
                "No offer found: the search ended after {studies}. Of {combinations}, {} excluded: run without success, or looser than \
                 such a one. The {} that {} more {} not tried.",
                is_or_are(one.excluded, writer),
                if left == 1 { "one".to_owned() } else { format!("{} others", writer.count(left)) },
                if left == 1 { "costs" } else { "cost" },
                if left == 1 { "was" } else { "were" },
            );
        }
        AllocationStop::TooManyCombinations => {
            return format!("No offer found: {combinations} are too many to search. Give fewer offers for each input.");
        }
    }
    let choices: Vec<String> = one
        .choices
        .iter()
        .map(|choice| {
            let value = writer.value_shortest(choice.value_si, &choice.unit);
            format!("{} {value} (cost {})", subject(result, &choice.path, choice.what), choice.cost)
        })
        .collect();
    format!(
        "Cheapest of {combinations}: {}, total cost {}. No cheaper combination meets the requirements: each was run, or is looser than \
         one that was run ({studies}).",
        listed(&choices),
        one.cost
    )
}

/// `1 is`, `24 are`.
fn is_or_are(value: u64, writer: &NumberWriter) -> String {
    format!("{} {}", writer.count(value), if value == 1 { "is" } else { "are" })
}

/// How each small probability was estimated.
pub(crate) fn rare_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    result.rare.iter().map(|one| rare(result, one, writer)).collect()
}

fn rare(result: &StudyResult, one: &RareRecord, writer: &NumberWriter) -> String {
    let unit = crate::words::wording::output_unit(result, &one.output);
    format!(
        "{} of {} ({}, {}): upper bound {}; lower bound {}.",
        statistic_words(one.statistic, &unit, writer),
        one.output,
        deviation_words(one.of),
        place_words(one.at, writer),
        rare_end(&one.upper, "count", writer),
        rare_end(&one.lower, "do not count", writer),
    )
}

fn rare_end(end: &RareEnd, failed_count: &str, writer: &NumberWriter) -> String {
    let means = match (end.method, end.reliability_index) {
        (RareMethodUsed::Importance, Some(index)) => {
            format!("by importance sampling around design points at {index:.2} standard deviations")
        }
        (RareMethodUsed::Importance, None) => "by importance sampling around design points".to_owned(),
        (RareMethodUsed::Subset, _) => "by subset simulation".to_owned(),
    };
    let failed = if end.failed > 0 {
        format!(", {} failed and {failed_count} as beyond the limit", writer.count(end.failed))
    } else {
        String::new()
    };
    let error = if end.probability > 0.0 {
        format!(", relative standard error {}", writer.percent(end.standard_error / end.probability, Rounding::Up))
    } else {
        String::new()
    };
    format!("{:.2e} {means}{error} ({}{failed})", end.probability, counted(end.runs, "run", writer))
}
