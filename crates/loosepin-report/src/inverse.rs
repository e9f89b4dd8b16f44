//! What the requirements allow, and how small probabilities were estimated: sentences for pages and terminals.

use super::number::{NumberWriter, Rounding, plain_name};
use super::wording::{counted, counted_as, deviation_words, listed, place_words, statistic_words, verdict_words};
use loosepin_result::study::{
    AllocationRecord, AllocationStop, AllowanceRecord, Loosened, RareEnd, RareMethodUsed, RareRecord, StudyResult,
    Verdict,
};

/// Digits of a value that is allowed.
const ALLOWED_DIGITS: usize = 3;

/// One sentence for each input that may be loosened, then one for the cheapest combination.
pub(super) fn inverse_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let allowed = result.allowances.iter().map(|one| allowance(result, one, writer));
    allowed.chain(result.allocation.iter().map(|one| allocation(result, one, writer))).collect()
}

/// What of an input is meant: "the upper end of the gudgeon radial clearance".
fn subject(result: &StudyResult, path: &str, what: Loosened) -> String {
    let name = plain_name(path, &result.inputs);
    match what {
        Loosened::UpperEnd => format!("the upper end of the {name}"),
        Loosened::StandardDeviation => format!("the standard deviation of the {name}"),
        Loosened::Fit => format!("the fit of the {name}"),
    }
}

/// The loosest fit of a list.
fn fit_allowance(result: &StudyResult, one: &AllowanceRecord, writer: &NumberWriter) -> String {
    let name = plain_name(&one.path, &result.inputs);
    let runs = counted(one.runs, "run", writer);
    let least = |fit: &String| {
        let own = one.checks.iter().filter(|check| check.fit.as_ref() == Some(fit));
        own.min_by(|a, b| a.share.total_cmp(&b.share)).map_or_else(String::new, |check| {
            let share = writer.percent(check.share, Rounding::Down);
            format!("{share} of at least {}", writer.percent(check.required_share, Rounding::Nearest))
        })
    };
    let refused = |fit: &String| {
        let check = one.checks.iter().rev().find(|check| check.fit.as_ref() == Some(fit));
        check.map_or("nothing is known".to_owned(), |check| {
            format!("they are {} ({})", verdict_words(check.verdict), least(fit))
        })
    };
    match (&one.allowed_fit, &one.beyond_fit) {
        (Some(allowed), Some(beyond)) => format!(
            "With the rest as it is, the loosest fit of the list for the {name} is {allowed}: all requirements met, {}, and again \
             with other random numbers. With {beyond}, the next looser one, {}. From {runs}.",
            least(allowed),
            refused(beyond),
        ),
        (Some(allowed), None) => format!(
            "With the rest as it is, {allowed} may be taken for the {name}, the loosest fit of the list: all requirements met, {}, \
             and again with other random numbers. From {runs}.",
            least(allowed),
        ),
        (None, Some(tightest)) => format!(
            "With the rest as it is, no fit of the list for the {name} meets the requirements: with {tightest}, the tightest, {}. \
             From {runs}.",
            refused(tightest),
        ),
        (None, None) => format!("No fit was asked about for the {name}."),
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
            let [share, required] = [check.share, check.required_share];
            format!(
                "{} of at least {}",
                writer.percent(share, Rounding::Down),
                writer.percent(required, Rounding::Nearest)
            )
        })
    };
    let runs = counted(one.runs, "run", writer);
    match (one.allowed_si, one.beyond_si) {
        (Some(allowed), Some(beyond)) => format!(
            "With the rest as it is, {subject} may be {}: all requirements met, {}, and again with other random numbers. At {} {}. \
             From {runs}.",
            value(allowed, Rounding::Down),
            share(allowed),
            value(beyond, Rounding::Up),
            checked(beyond).map_or("nothing is known".to_owned(), |check| {
                format!("they are {} ({})", verdict_words(check.verdict), share(beyond))
            }),
        ),
        (Some(allowed), None) => format!(
            "With the rest as it is, {subject} may be {}, the largest value asked about: all requirements met, {}, and again with \
             other random numbers. From {runs}.",
            value(allowed, Rounding::Down),
            share(allowed),
        ),
        (None, _) => {
            let least = one.checks.iter().map(|check| check.value_si).fold(f64::INFINITY, f64::min);
            if checked(least).is_some_and(|check| check.verdict == Verdict::Undecided) {
                return format!(
                    "With the rest as it is, no value of {subject} that was tried is shown to meet the requirements: at {}, the \
                     least, they are undecided ({} so far), and more samples ('inner') may show it. From {runs}.",
                    value(least, Rounding::Nearest),
                    share(least)
                );
            }
            format!(
                "With the rest as it is, no value of {subject} that was tried meets the requirements, {} being the least ({}). \
                 From {runs}.",
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
                "No offer named: none of {combinations} meets the requirements, each being run and refused, or looser than such a one \
                 ({studies})."
            );
        }
        AllocationStop::TriedEnough => {
            let left = one.combinations - one.excluded;
            return format!(
                "No offer named: the search ended after {studies}. Of {combinations}, {} excluded, being run and refused, or looser \
                 than such a one; nothing is known of the {} that {} more.",
                is_or_are(one.excluded, writer),
                if left == 1 { "one".to_owned() } else { format!("{} others", writer.count(left)) },
                if left == 1 { "costs" } else { "cost" },
            );
        }
        AllocationStop::TooManyCombinations => {
            return format!(
                "No offer named: {combinations} are more than are searched. Fewer offers an input would do."
            );
        }
    }
    let choices: Vec<String> = one
        .choices
        .iter()
        .map(|choice| {
            let value = writer.value_shortest(choice.value_si, &choice.unit);
            format!("{} {value} for {}", subject(result, &choice.path, choice.what), choice.cost)
        })
        .collect();
    format!(
        "Cheapest of {combinations}: {}, together {}; every cheaper one is run and refused, or looser than such a one ({studies}).",
        listed(&choices),
        one.cost
    )
}

/// `1 is`, `24 are`.
fn is_or_are(value: u64, writer: &NumberWriter) -> String {
    format!("{} {}", writer.count(value), if value == 1 { "is" } else { "are" })
}

/// How each small probability was estimated.
pub(super) fn rare_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    result.rare.iter().map(|one| rare(result, one, writer)).collect()
}

fn rare(result: &StudyResult, one: &RareRecord, writer: &NumberWriter) -> String {
    let unit = super::answer::output_unit(result, &one.output);
    format!(
        "{} of {} ({}, {}): largest {}; smallest {}.",
        statistic_words(one.statistic, &unit, writer),
        one.output,
        deviation_words(one.of),
        place_words(one.at, writer),
        rare_end(&one.upper, writer),
        rare_end(&one.lower, writer),
    )
}

fn rare_end(end: &RareEnd, writer: &NumberWriter) -> String {
    let means = match (end.method, end.reliability_index) {
        (RareMethodUsed::Importance, Some(index)) => {
            format!("by sampling around design points at {index:.2} standard deviations")
        }
        (RareMethodUsed::Importance, None) => "by sampling around design points".to_owned(),
        (RareMethodUsed::Subset, _) => "by subset simulation".to_owned(),
    };
    let failed = if end.failed > 0 {
        format!(", {} failed and count as the event", writer.count(end.failed))
    } else {
        String::new()
    };
    let error = if end.probability > 0.0 {
        format!(", standard error {} of it", writer.percent(end.standard_error / end.probability, Rounding::Up))
    } else {
        String::new()
    };
    format!("{:.2e} {means}{error} ({}{failed})", end.probability, counted(end.runs, "run", writer))
}
