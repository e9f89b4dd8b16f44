//! Inputs that are loosened together: the sentences, and the frontier of two as a chart.

use maud::html;

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::words::wording::{counted, counted_as, listed, verdict_words};
use loosepin_result::study::{Loosened, StudyResult, Together, TogetherCheck, TogetherRecord};

/// Digits of a value that is allowed.
pub(crate) const ALLOWED_DIGITS: usize = 3;
/// Begin of the last sentence of an allowance.
pub(crate) const ALL_ELSE: &str = "All other inputs as stated";

/// The loosened number of an input: "upper limit of the gudgeon radial clearance".
pub(crate) fn subject(result: &StudyResult, path: &str, what: Loosened) -> String {
    let name = plain_name(path, &result.inputs);
    match what {
        Loosened::UpperEnd => format!("upper limit of the {name}"),
        Loosened::StandardDeviation => format!("standard deviation of the {name}"),
        Loosened::Fit => format!("fit of the {name}"),
    }
}

/// Results of the studies, in sentences.
pub(crate) fn joint_loosening_sentences(
    result: &StudyResult,
    one: &TogetherRecord,
    writer: &NumberWriter,
) -> Vec<String> {
    let spent = format!(
        "{ALL_ELSE}, {}, {}.",
        counted_as(one.checks.len() as u64, "direct study", "direct studies", writer),
        counted(one.runs, "run", writer)
    );
    let Some(first) = one.allowed_si.first() else {
        let least: Vec<f64> = one.inputs.iter().map(|input| input.least_si).collect();
        return vec![format!(
            "Not even the smallest values together meet the requirements: with {}, {}. {spent}",
            values(result, one, &least, Rounding::Nearest, writer),
            refused(one, &least, writer)
        )];
    };
    if one.inputs.iter().zip(first).all(|(input, value)| *value == input.up_to_si) {
        return vec![format!(
            "Together, {} are allowed, the largest values to try: all requirements are met ({}), also with other \
             random numbers. {spent}",
            values(result, one, first, Rounding::Nearest, writer),
            shares(one, first, writer)
        )];
    }
    match one.how {
        Together::Proportional => {
            let share = one.inputs.iter().zip(first).map(|(input, value)| value / input.up_to_si).fold(1.0, f64::min);
            let beyond = &one.beyond_si[0];
            vec![format!(
                "Together, each at {} of its largest value or at its smallest: {} are permitted. All requirements are met ({}), also with \
                 other random numbers. With {} {}. {spent}",
                writer.percent(share, Rounding::Down),
                values(result, one, first, Rounding::Down, writer),
                shares(one, first, writer),
                values(result, one, beyond, Rounding::Up, writer),
                refused(one, beyond, writer),
            )]
        }
        Together::Frontier => {
            let [x, y] = [0, 1].map(|index| {
                let input = &one.inputs[index];
                (subject(result, &input.path, input.what), &input.unit)
            });
            let pairs: Vec<String> = one
                .allowed_si
                .iter()
                .map(|pair| {
                    format!(
                        "{} and {}",
                        writer.rounded(pair[0], x.1, ALLOWED_DIGITS, Rounding::Down),
                        writer.rounded(pair[1], y.1, ALLOWED_DIGITS, Rounding::Down)
                    )
                })
                .collect();
            vec![
                format!(
                    "One against the other: {} and {} together may be at most {}. All requirements are met with each of these pairs that \
                     was run, also with other random numbers.",
                    x.0,
                    y.0,
                    pairs.join("; ")
                ),
                format!(
                    "A looser value is assumed to be never better. A pair that is tighter in both values than a pair that meets the requirements also counts as meeting them. A pair that is looser in both than a rejected pair counts as not shown to meet them. Such pairs were not run. {spent}"
                ),
            ]
        }
    }
}

/// `upper limit of the gudgeon radial clearance 0.1 mm and standard deviation of the rod length 0.02 mm`.
fn values(
    result: &StudyResult,
    one: &TogetherRecord,
    values_si: &[f64],
    rounding: Rounding,
    writer: &NumberWriter,
) -> String {
    let words: Vec<String> = one
        .inputs
        .iter()
        .zip(values_si)
        .map(|(input, value_si)| {
            let value = writer.rounded(*value_si, &input.unit, ALLOWED_DIGITS, rounding);
            format!("{} {value}", subject(result, &input.path, input.what))
        })
        .collect();
    listed(&words)
}

/// The least share of the studies at these values, and what is required.
fn shares(one: &TogetherRecord, values_si: &[f64], writer: &NumberWriter) -> String {
    of(one, values_si).min_by(|a, b| a.answer.share.total_cmp(&b.answer.share)).map_or_else(String::new, |check| {
        format!(
            "{}, required {}",
            writer.percent(check.answer.share, Rounding::Down),
            writer.percent(check.answer.required_share, Rounding::Nearest)
        )
    })
}

/// `they are not met (93 %, required 95 %)`; a combination that is looser than a refused one is not run itself.
fn refused(one: &TogetherRecord, values_si: &[f64], writer: &NumberWriter) -> String {
    of(one, values_si).last().map_or_else(
        || "they are not shown to be met, as at a tighter combination that was run".to_owned(),
        |check| format!("they are {} ({})", verdict_words(check.answer.verdict), shares(one, values_si, writer)),
    )
}

fn of<'a>(one: &'a TogetherRecord, values_si: &'a [f64]) -> impl Iterator<Item = &'a TogetherCheck> {
    one.checks.iter().filter(move |check| check.values_si == values_si)
}

/// The frontier of two inputs as steps: only combinations that met the requirements, and those that follow from them, are drawn as met.
///
/// With the pairs (a_k, b_k) that are met and (a_k, r_k) that are refused, a rising, the requirements are met at a pair that is tighter
/// than a met one: up to b_(k+1) over (a_k, a_(k+1)]. They are not shown to be met at one that is looser than a refused one: from r_k on over
/// [a_k, a_(k+1)). So each a has two rows, what is to its left and what is to its right.
pub(crate) fn frontier(result: &StudyResult, one: &TogetherRecord, writer: &NumberWriter) -> Option<Chart> {
    let is_curve = one.how == Together::Frontier && one.allowed_si.len() > 1;
    let [x, y] = <&[_; 2]>::try_from(&one.inputs[..]).ok().filter(|_| is_curve)?;
    let refused_si =
        |first_si: f64| one.beyond_si.iter().find(|pair| pair[0] == first_si).map_or(f64::NAN, |pair| pair[1]);
    let mut rows_si: Vec<[f64; 3]> = Vec::new();
    for (column, pair) in one.allowed_si.iter().enumerate() {
        let before = &one.allowed_si[column.saturating_sub(1)];
        let after = one.allowed_si.get(column + 1).unwrap_or(pair);
        rows_si.push([pair[0], pair[1], refused_si(before[0])]);
        rows_si.push([pair[0], after[1], refused_si(pair[0])]);
    }
    let column_si = |index: usize| -> Vec<f64> { rows_si.iter().map(|row| row[index]).collect() };
    let [x_words, y_words] = [x, y].map(|input| subject(result, &input.path, input.what));
    let in_page = |values_si: &[f64]| scaled(values_si, &y.unit, writer);
    let least = vec![y.least_si; rows_si.len()];
    let mut chart = Chart::over("frontier".to_owned(), &x_words, &column_si(0), &x.unit, writer);
    chart.set_vertical_axis(y_words.clone(), &y.unit, writer);
    chart.entries = vec![
        Entry::new(
            "requirements met",
            Role::Random,
            false,
            EntryValues::band(&in_page(&least), &in_page(&column_si(1))),
        ),
        Entry::new("from here on not shown to be met", Role::Limit, true, EntryValues::line(&in_page(&column_si(2)))),
    ];
    chart.caption = html! {
        strong { "One against the other." }
        " How large the " (y_words) " may be, over the " (x_words) ", so that every requirement holds. "
        (one.allowed_si.len()) " values of it were tested; between two of them, the next larger one applies. Between both lines, the result is not known."
    };
    chart.alternative = format!(
        "Chart of the largest allowed {y_words} over the {x_words}, in steps; it never rises from left to right."
    );
    Some(chart)
}
