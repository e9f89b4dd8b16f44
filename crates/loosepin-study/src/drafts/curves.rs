//! Curves over the cycle from the runs so far: quantiles of the runs, without the errors of bounds.

use std::collections::BTreeMap;

use crate::file::Ask;
use crate::response::columns::BAND;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{Purpose, SampleTable, between_order_statistics};
use loosepin_math::sort_ascending;
use loosepin_result::study::{CurveRange, DraftCurve};

/// Most poses of a curve: as many as a small picture shows.
const MAX_POSES: usize = 60;

/// One curve for each ask for the whole cycle; empty if no run is of use.
pub(crate) fn draft_curves(response: &StudyResponse, table: &SampleTable) -> Vec<DraftCurve> {
    let mut runs_at: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (run, inputs) in table.inputs().iter().enumerate() {
        if inputs.purpose == Purpose::DoubleLoop && table.failure(run).is_none() {
            runs_at.entry(inputs.point).or_default().push(run);
        }
    }
    if runs_at.is_empty() {
        return Vec::new();
    }
    let runs_at: Vec<Vec<usize>> = runs_at.into_values().collect();
    let asks = response.plan().asks.iter();
    asks.filter(|ask| ask.location.is_cycle()).map(|ask| draft_curve(response, table, ask, &runs_at)).collect()
}

fn draft_curve(response: &StudyResponse, table: &SampleTable, ask: &Ask, runs_at: &[Vec<usize>]) -> DraftCurve {
    let plan = response.plan();
    let output = &plan.outputs[ask.output];
    let step = ask.columns.len().div_ceil(MAX_POSES).max(1);
    let columns: Vec<usize> = ask.columns.iter().copied().step_by(step).collect();
    let angle = |&column: &usize| plan.columns[column].spot.pose().map_or(f64::NAN, |pose| pose.angle_rad);
    let pose_rad = columns.iter().map(angle).collect();
    let (lower_si, upper_si) = columns.iter().map(|&column| ends_si(table, column, runs_at)).unzip();
    let band = CurveRange { lower_si, upper_si };
    DraftCurve {
        output: output.name.clone(),
        of: ask.deviation,
        unit: output.unit.clone(),
        probabilities: BAND,
        pose_rad,
        band,
        unknown_values: runs_at.len(),
    }
}

/// The least lower and the greatest upper quantile of a column; infinite where no run has it.
fn ends_si(table: &SampleTable, column: usize, runs_at: &[Vec<usize>]) -> (f64, f64) {
    let sorted = |runs: &Vec<usize>| {
        let values = runs.iter().map(|&run| table.values(run)[column]);
        let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        sort_ascending(&mut values);
        values
    };
    // Where no run has the number, these values of the unknown inputs say nothing of it.
    let samples = runs_at.iter().map(sorted).filter(|values| !values.is_empty());
    samples.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), values| {
        let count = values.len();
        let [lower, upper] =
            BAND.map(|share| between_order_statistics(count, share * count as f64, |place| values[place]));
        (least.min(lower), greatest.max(upper))
    })
}

#[cfg(test)]
mod tests {
    use super::{BAND, ends_si};
    use loosepin_bounds::{Failure, Purpose, RunInputs, SampleTable};

    /// Runs of one column: value of the unknown inputs, and what came out.
    fn table(runs: &[(u32, Result<f64, Failure>)]) -> SampleTable {
        let mut table = SampleTable::new(1);
        for (index, &(point, outcome)) in (0..).zip(runs) {
            let purpose = Purpose::DoubleLoop;
            let inputs = RunInputs { round: 0, purpose, point, replicate: 0, index, random: vec![], epistemic: vec![] };
            let row = outcome.map(|value| [value]);
            table.push(inputs, row.as_ref().map(|row| &row[..]).map_err(|&failure| failure)).unwrap();
        }
        table
    }

    #[test]
    fn analytic_the_band_reaches_over_quantiles_of_evenly_spaced_numbers() {
        // Order statistic k of N stands at (k - 1/2)/N, so that p of 1, 2, ... N is N p + 1/2.
        let few = (1..=40).map(|value| (3, Ok(f64::from(value))));
        let high = (1..=200).map(|value| (7, Ok(100.0 + f64::from(value))));
        let runs: Vec<(u32, Result<f64, Failure>)> = few.chain(high).collect();
        let runs_at = [(0..40).rev().collect::<Vec<usize>>(), (40..240).collect()];
        let (lower, upper) = ends_si(&table(&runs), 0, &runs_at);
        assert!((lower - (40.0 * BAND[0] + 0.5)).abs() < 1e-12, "{lower}");
        assert!((upper - (100.0 + 200.0 * BAND[1] + 0.5)).abs() < 1e-12, "{upper}");
    }

    #[test]
    fn runs_without_the_number_say_nothing_of_it() {
        let runs = [(0, Ok(f64::NAN)), (1, Ok(2.5)), (1, Ok(2.5))];
        assert_eq!(ends_si(&table(&runs), 0, &[vec![0], vec![1, 2]]), (2.5, 2.5));
        assert_eq!(ends_si(&table(&runs), 0, &[vec![0]]), (f64::INFINITY, f64::NEG_INFINITY));
    }
}
