//! `bounds.csv`: one bound a row.

use super::FilesError;
use loosepin_result::study::{
    BoundEnd, BoundRecord, PercentileBounds, ResponsePoint, StudyResult, Witness, WitnessValue,
};

/// The columns of `bounds.csv`. `parameter` is the probability of a quantile or the limit of a probability (SI);
/// `unit` is that of the values, errors included; a witness is `path=value` joined by `;`, values in SI. `percentile` is that of a
/// statistic which is itself random, empty where the row is no percentile; `alpha` is the degree of possibility, empty where the row
/// holds for all that is possible.
pub const BOUNDS_COLUMNS: [&str; 25] = [
    "output",
    "of",
    "at",
    "pose_rad",
    "reduction",
    "statistic",
    "parameter",
    "treatment",
    "reading",
    "unit",
    "lower",
    "lower_widened",
    "lower_error_sampling",
    "lower_error_optimisation",
    "lower_error_surrogate",
    "lower_witness",
    "upper",
    "upper_widened",
    "upper_error_sampling",
    "upper_error_optimisation",
    "upper_error_surrogate",
    "upper_witness",
    "percentile",
    "guarantee",
    "alpha",
];

/// The bounds of a study as CSV (RFC 4180, UTF-8, header line, `\n` line ends). Floats are written in the shortest form
/// that reads back to the same bits; what does not apply to a row is an empty cell.
///
/// # Errors
/// A row that cannot be written.
pub fn bounds_csv(result: &StudyResult) -> Result<Vec<u8>, FilesError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(BOUNDS_COLUMNS).map_err(|source| FilesError::Csv { source })?;
    for bound in &result.bounds {
        writer.write_record(row(bound, None, None)).map_err(|source| FilesError::Csv { source })?;
    }
    for cut in &result.cuts {
        for bound in &cut.bounds {
            writer.write_record(row(bound, Some(cut.alpha), None)).map_err(|source| FilesError::Csv { source })?;
        }
    }
    for PercentileBounds { percentile, bounds } in &result.percentiles {
        for bound in bounds {
            writer.write_record(row(bound, None, Some(*percentile))).map_err(|source| FilesError::Csv { source })?;
        }
    }
    writer.into_inner().map_err(|error| FilesError::Csv { source: csv::Error::from(error.into_error()) })
}

fn row(bound: &BoundRecord, alpha: Option<f64>, percentile: Option<f64>) -> Vec<String> {
    let (statistic, parameter) = (bound.statistic.word(), bound.statistic.parameter());
    let at = match bound.at {
        ResponsePoint::Whole => "whole",
        ResponsePoint::Pose { .. } => "pose",
        ResponsePoint::Curve { .. } => "curve",
        ResponsePoint::Reduced { .. } => "reduced",
    };
    let (guarantee, confidence) = bound.guarantee.word_and_confidence();
    let mut cells = vec![
        bound.output.clone(),
        bound.of.word().to_owned(),
        at.to_owned(),
        optional(bound.at.pose_rad()),
        bound.at.reduction().map(|reduction| reduction.word().to_owned()).unwrap_or_default(),
        statistic.to_owned(),
        optional(parameter),
        bound.treatment.word().to_owned(),
        bound.reading.word().to_owned(),
        bound.unit.symbol().to_owned(),
    ];
    cells.extend(end_cells(&bound.lower));
    cells.extend(end_cells(&bound.upper));
    cells.push(optional(percentile));
    cells.push(match confidence {
        Some(confidence) => format!("{guarantee} {}", number(confidence)),
        None => guarantee.to_owned(),
    });
    cells.push(optional(alpha));
    cells
}

fn end_cells(end: &BoundEnd) -> [String; 6] {
    [
        number(end.value_si),
        number(end.widened_si),
        number(end.error.sampling_si),
        number(end.error.optimisation_si),
        number(end.error.surrogate_si),
        witness_cell(&end.witness),
    ]
}

fn witness_cell(witness: &Witness) -> String {
    let parts: Vec<String> = witness
        .iter()
        .map(|(path, value)| match value {
            WitnessValue::Number(value_si) => format!("{path}={}", number(*value_si)),
            WitnessValue::Choice(choice) => format!("{path}={choice}"),
        })
        .collect();
    parts.join(";")
}

fn optional(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// Shortest form that reads back to the same bits; the words of [`loosepin_text::units::extended`] otherwise.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}
