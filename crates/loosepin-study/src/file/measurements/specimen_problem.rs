//! Problems of the rows of a measured specimen.

use loosepin_mechanics::model::QuantityError;
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{Dimension, counted, format_number};

problems! {
    /// Problems of `[specimen]`.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SpecimenProblem {
        /// No random input that the rows could belong to.
        NothingRandom => Code::NothingUncertain,
            says("the study has no random inputs for the values in the rows"),
            hint("remove [specimen], or keep the tables under [random] of the original study");
        /// A column that is no random input.
        UnknownColumn { name: String, nearest: Option<String> } => Code::MeasuredTable,
            says("the column '{name}' is not a random input of this study"),
            hint_of(nearest.as_ref().map(|nearest| format!("did you mean '{nearest}'?")));
        /// A random input without a column.
        NoColumn { path: String, file: String } => Code::MeasuredTable,
            says("{file} has no column '{path}', a random input of this study; the rows must contain all random inputs"),
            hint("write the rows again: loosepin identify STUDY --lengths --write NEW, with this input in STUDY");
        /// A column of another dimension than its input.
        ColumnDimension { name: String, found: Dimension, due: Dimension } => Code::MeasuredTable,
            says("the column '{name}' is {found}; it must be {due}");
        /// Too few rows.
        FewRows { found: usize, least: usize } => Code::BadSample,
            says("the table has {}; must be at least {least}", counted(*found, "row")),
            hint("each end of a 95 % interval depends on 2.5 % of the rows");
        /// A row that is no mechanism.
        ImpossibleRow { rows: usize, error: QuantityError } => error.code(),
            says("{} is not a possible mechanism of the model: {error}", match rows {
                1 => "this row".to_owned(),
                rows => format!("this row, the first of {rows},"),
            }),
            hint_of(error.hint());
        /// What has no answer for a joint sample.
        Beside { what: &'static str } => Code::AskNotPossible,
            says("{what} cannot be used with [specimen]: its rows replace the distributions"),
            hint("remove one of the two");
        /// A distribution with uncertain parameters, of which the rows would leave nothing.
        UncertainParameter { path: String } => Code::AskNotPossible,
            says("'{path}' has a distribution with uncertain parameters, which [specimen] cannot replace"),
            hint("write one number for each parameter, or the input under [epistemic]");
        /// A small probability.
        Rare { entry: String } => Code::AskNotPossible,
            says("{entry}: methods for small probabilities cannot be used with [specimen]: n rows have no probabilities below 1/n"),
            hint("omit method: the rows are counted");
        /// Effective number of the rows.
        Finite { rows: usize, effective: f64 } => Code::BadSample,
            says("{rows} rows of the specimen say as much as {} mechanisms: a share of 95 % of them is known to ± {} %, \
                  a share of one half to ± {} % (2 standard deviations); no bound holds this error",
                effective.floor(), percent(0.95, *effective), percent(0.5, *effective));
    }
}

/// Two standard deviations of a share of independent rows, percent, two digits, upwards.
fn percent(share: f64, effective: f64) -> String {
    /// Below this share of its last digit a number is round.
    const ROUND_OFF: f64 = 1e-9;
    let error = 200.0 * (share * (1.0 - share) / effective).sqrt();
    let last_digit = 10.0_f64.powf(error.log10().floor() - 1.0);
    let up = (error / last_digit - ROUND_OFF).ceil() * last_digit;
    format_number(format!("{up:.1e}").parse().unwrap_or(up))
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn analytic_two_standard_deviations_of_a_share() {
        // 2 √(0.25/400) = 5 %; 2 √(0.0475/400) = 2.179 %.
        assert_eq!((percent(0.5, 400.0).as_str(), percent(0.95, 400.0).as_str()), ("5", "2.2"));
        // 2.248 %.
        assert_eq!(percent(0.95, 376.0), "2.3");
    }
}
