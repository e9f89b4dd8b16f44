//! The inverse question: the loosest value that meets the requirements, and the cheapest combination of offers.

use super::super::direct::DirectSteps;
use super::super::steps::take_steps;
use super::loosened::with_loosened;
use crate::assemble::{Material, requirements};
use crate::error::StudyError;
use crate::file::{Allowance, AllowedFit, AllowedInput, Study};
use crate::planning::problem::problem;
use crate::response::study_response::StudyResponse;
use crate::runs::all_runs::Runs;
use loosepin_bounds::{Refinement, SampleTable};
use loosepin_math::sort_by_number;
use loosepin_result::study::{
    AllocatedInput, AllocationRecord, AllocationStop, AllowanceCheck, AllowanceRecord, CheckAnswer, Loosened,
    RequirementOutcome, Verdict,
};
use loosepin_text::units::SiUnit;
use loosepin_uncertainty::hash;

/// Times that the range is halved: to a 128th of it.
pub const HALVINGS: usize = 7;
/// The least standard deviation that is tried, as a share of the largest.
const MIN_DEVIATION_SHARE: f64 = 1.0 / 128.0;
/// Combinations that are run in search of the cheapest, at most.
const MAX_TRIED: usize = 24;
/// Separates the random numbers of confirmations.
const CONFIRMATION: u64 = 0x0063_6f6e_6669_726d;

/// Studies that may be run at most, for the plan.
pub fn most_studies(study: &Study) -> usize {
    let of_one = |one: &Allowance| if one.fits.is_empty() { 2 + HALVINGS } else { one.fits.len() };
    let searches = 2 * study.allowances.iter().map(of_one).sum::<usize>();
    let has_costs = study.allowances.iter().any(|allowance| !allowance.costs.is_empty());
    searches + if has_costs { 2 * MAX_TRIED } else { 0 }
}

/// Runs of one such study at most: the double loop alone.
pub fn runs_of_a_study(study: &Study) -> usize {
    let inner = if study.random.is_empty() { 1 } else { study.sampling.inner };
    let outer = if study.epistemic.is_empty() { 1 } else { study.sampling.outer };
    outer * inner
}

/// Result of a direct study.
pub struct DirectStudyResult {
    outcomes: Vec<RequirementOutcome>,
    pub runs: usize,
}

impl DirectStudyResult {
    fn verdict(&self) -> Verdict {
        // Of nothing that is required nothing is shown.
        Verdict::of_all(self.outcomes.iter().map(|outcome| outcome.verdict)).unwrap_or(Verdict::Undecided)
    }

    pub fn check(&self, is_confirmation: bool) -> CheckAnswer {
        let margin = |outcome: &&RequirementOutcome| outcome.probability[0] - outcome.probability_at_least;
        let nearest = self.outcomes.iter().min_by(|a, b| margin(a).total_cmp(&margin(b)));
        CheckAnswer {
            is_confirmation,
            share: nearest.map_or(f64::NAN, |outcome| outcome.probability[0]),
            required_share: nearest.map_or(f64::NAN, |outcome| outcome.probability_at_least),
            verdict: self.verdict(),
        }
    }
}

/// The loosest value of each input that may be loosened, one at a time.
///
/// The range is halved: values met below, not met above. Every trial is a direct study, and where that is met a second one with other
/// random numbers, so that no value is met by luck. For the upper end of an interval a larger value can only be worse, since every u of the smaller box
/// belongs to the larger one; for standard deviations this is taken for granted, and holds at the values that were run.
///
/// # Errors
/// Those of the studies.
pub fn allowances(runs: &Runs<'_>) -> Result<Vec<AllowanceRecord>, StudyError> {
    let of = |allowance: &Allowance| {
        let (mut checks, mut made) = (Vec::new(), 0);
        let is_met = |(value_si, fit): Tried<'_>| {
            is_met_twice(runs, &[(allowance, value_si)], |answer, is_confirmation| {
                made += answer.runs as u64;
                let fit = fit.map(|fit| fit.name.clone());
                checks.push(AllowanceCheck { fit, value_si, answer: answer.check(is_confirmation) });
            })
        };
        let [allowed, beyond] =
            if allowance.fits.is_empty() { loosest(allowance, is_met)? } else { loosest_fit(allowance, is_met)? };
        let (what, unit) = described(runs.study, allowance);
        let fit = |(_, fit): Tried<'_>| fit.map(|fit| fit.name.clone());
        Ok(AllowanceRecord {
            path: allowance.path.clone(),
            what,
            unit,
            up_to_si: allowance.up_to_si,
            allowed_si: allowed.map(|(value_si, _)| value_si),
            beyond_si: beyond.map(|(value_si, _)| value_si),
            allowed_fit: allowed.and_then(fit),
            beyond_fit: beyond.and_then(fit),
            checks,
            runs: made,
        })
    };
    runs.study.allowances.iter().map(of).collect()
}

/// Whether the requirements are met twice, with two sets of random numbers; `heard` gets each answer, and whether it confirms one.
pub fn is_met_twice(
    runs: &Runs<'_>,
    set: &[(&Allowance, f64)],
    mut heard: impl FnMut(&DirectStudyResult, bool),
) -> Result<bool, StudyError> {
    for is_confirmation in [false, true] {
        let answer = run(runs, set, seed(runs.study, is_confirmation))?;
        heard(&answer, is_confirmation);
        if answer.verdict() != Verdict::Met {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A value that was tried, and the fit that it belongs to.
type Tried<'a> = (f64, Option<&'a AllowedFit>);

/// The loosest fit of a list: from the loosest one on, until the requirements are met twice. So the answer holds without anything
/// being taken for granted, and the next looser one has been run and refused.
fn loosest_fit<'a>(
    allowance: &'a Allowance,
    mut is_met: impl FnMut(Tried<'a>) -> Result<bool, StudyError>,
) -> Result<[Option<Tried<'a>>; 2], StudyError> {
    let mut beyond = None;
    for fit in allowance.fits.iter().rev() {
        let tried = (fit.clearance_m[1], Some(fit));
        if is_met(tried)? {
            return Ok([Some(tried), beyond]);
        }
        beyond = Some(tried);
    }
    Ok([None, beyond])
}

/// The least value that is tried.
pub fn least_tried_si(allowance: &Allowance) -> f64 {
    match allowance.input {
        AllowedInput::UpperEnd(_) | AllowedInput::FitInterval(_) | AllowedInput::FitScatter(_) => allowance.least_si,
        AllowedInput::StandardDeviation(_) => MIN_DEVIATION_SHARE * allowance.up_to_si,
    }
}

fn loosest<'a>(
    allowance: &Allowance,
    mut is_met: impl FnMut(Tried<'a>) -> Result<bool, StudyError>,
) -> Result<[Option<Tried<'a>>; 2], StudyError> {
    let least = least_tried_si(allowance);
    if is_met((allowance.up_to_si, None))? {
        return Ok([Some((allowance.up_to_si, None)), None]);
    }
    if !is_met((least, None))? {
        return Ok([None, Some((least, None))]);
    }
    let (mut low, mut high) = (least, allowance.up_to_si);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_met((middle, None))? {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok([low, high].map(|value_si| Some((value_si, None))))
}

/// The cheapest combination of offers; `None` if no input has any.
///
/// Combinations are run in the order of their cost, each a direct study, until one meets the requirements twice, with two sets of random numbers. One that does not meet them
/// excludes every combination that is at least as loose in all inputs, since looser is never better. The first one that meets them
/// is the cheapest; where the studies run out before, none is named.
///
/// # Errors
/// Those of the studies.
pub fn allocation(runs: &Runs<'_>) -> Result<Option<AllocationRecord>, StudyError> {
    let offered: Vec<&Allowance> = runs.study.allowances.iter().filter(|a| !a.costs.is_empty()).collect();
    if offered.is_empty() {
        return Ok(None);
    }
    let (mut made, mut studies) = (0, 0);
    let costs: Vec<&[[f64; 2]]> = offered.iter().map(|allowance| &allowance.costs[..]).collect();
    let search = cheapest(&costs, MAX_TRIED, |values| {
        let set: Vec<(&Allowance, f64)> = offered.iter().copied().zip(values.iter().copied()).collect();
        is_met_twice(runs, &set, |answer, _| {
            made += answer.runs as u64;
            studies += 1;
        })
    })?;
    let choices = search.chosen.as_ref().map_or_else(Vec::new, |chosen| {
        let choice = |(allowance, &place): (&&Allowance, &usize)| {
            let (what, unit) = described(runs.study, allowance);
            let [value_si, cost] = allowance.costs[place];
            AllocatedInput { path: allowance.path.clone(), what, unit, value_si, cost }
        };
        offered.iter().zip(chosen).map(choice).collect()
    });
    Ok(Some(AllocationRecord {
        cost: if choices.is_empty() { f64::NAN } else { choices.iter().map(|choice| choice.cost).sum() },
        stop: search.stop,
        choices,
        combinations: search.combinations as u64,
        studies,
        excluded: search.excluded as u64,
        runs: made,
    }))
}

/// What the search for the cheapest combination found.
struct Cheapest {
    /// Place of the offer for each input.
    chosen: Option<Vec<usize>>,
    stop: AllocationStop,
    combinations: usize,
    /// Combinations that were run.
    tried: usize,
    excluded: usize,
}

/// With more combinations than this no search is made.
const MAX_COMBINATIONS: usize = 100_000;

/// The cheapest combination of `offers` (value and cost, tightest first) for which `is_met`, trying at most `most_tried`.
fn cheapest<E>(
    offers: &[&[[f64; 2]]],
    most_tried: usize,
    mut is_met: impl FnMut(&[f64]) -> Result<bool, E>,
) -> Result<Cheapest, E> {
    let number = offers.iter().fold(1_usize, |product, of_input| product.saturating_mul(of_input.len()));
    if number > MAX_COMBINATIONS {
        let stop = AllocationStop::TooManyCombinations;
        return Ok(Cheapest { chosen: None, stop, combinations: number, tried: 0, excluded: 0 });
    }
    let mut combinations: Vec<Vec<usize>> = vec![Vec::new()];
    for of_input in offers {
        let extended = combinations
            .iter()
            .flat_map(|known| (0..of_input.len()).map(move |place| known.iter().copied().chain([place]).collect()));
        combinations = extended.collect();
    }
    let cost = |places: &[usize]| places.iter().zip(offers).map(|(&place, of)| of[place][1]).sum::<f64>();
    sort_by_number(&mut combinations, |places| cost(places));
    let mut refused: Vec<Vec<usize>> = Vec::new();
    let stop = AllocationStop::AllExcluded;
    let mut found = Cheapest { chosen: None, stop, combinations: combinations.len(), tried: 0, excluded: 0 };
    for places in combinations {
        let is_looser = |known: &Vec<usize>| places.iter().zip(known).all(|(place, tight)| place >= tight);
        if refused.iter().any(is_looser) {
            found.excluded += 1;
            continue;
        }
        if found.tried == most_tried {
            found.stop = AllocationStop::TriedEnough;
            break;
        }
        found.tried += 1;
        let values: Vec<f64> = places.iter().zip(offers).map(|(&place, of)| of[place][0]).collect();
        if is_met(&values)? {
            found.chosen = Some(places);
            found.stop = AllocationStop::Found;
            break;
        }
        found.excluded += 1;
        refused.push(places);
    }
    Ok(found)
}

pub fn described(study: &Study, allowance: &Allowance) -> (Loosened, SiUnit) {
    match allowance.input {
        AllowedInput::UpperEnd(index) => (Loosened::UpperEnd, study.epistemic[index].unit(&study.model)),
        AllowedInput::FitInterval(_) | AllowedInput::FitScatter(_) => (Loosened::Fit, SiUnit::LENGTH),
        AllowedInput::StandardDeviation(index) => (Loosened::StandardDeviation, study.random[index].unit(&study.model)),
    }
}

/// The seed of a direct study: that of the study itself, so that studies differ by their inputs alone, or another one.
fn seed(study: &Study, is_confirmation: bool) -> u64 {
    if is_confirmation { hash(study.seed, CONFIRMATION) } else { study.seed }
}

/// The requirements of the study with other values of some inputs.
fn run(runs: &Runs<'_>, set: &[(&Allowance, f64)], seed: u64) -> Result<DirectStudyResult, StudyError> {
    let place = |allowance: &Allowance| {
        runs.study.allowances.iter().position(|known| std::ptr::eq(known, allowance)).unwrap_or(usize::MAX)
    };
    let loosened: Vec<(usize, f64)> = set.iter().map(|(allowance, value)| (place(allowance), *value)).collect();
    let mut study = with_loosened(runs.study, &loosened)?;
    study.seed = seed;
    let response = StudyResponse::new(&study)?;
    let rounds = Refinement::try_new(problem(&study, &response), Vec::new())?;
    let table = SampleTable::new(response.row_length());
    let mut own = runs.of_another(&study, &response, table);
    own.loosened = &loosened;
    let bounds = take_steps(DirectSteps::new(rounds, None), &mut own, None)?.bounds;
    let material = Material::of_bounds(&study, &response, &own.table, &bounds);
    own.close();
    Ok(DirectStudyResult { outcomes: requirements(&material), runs: own.table.len() })
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{AllocationStop, cheapest};

    #[test]
    fn analytic_the_cheapest_of_all_combinations() {
        // A budget of variances: the cheapest by trying all 27 of them.
        let offers: [&[[f64; 2]]; 3] = [
            &[[0.01, 12.0], [0.02, 7.0], [0.05, 3.0]],
            &[[0.015, 9.0], [0.03, 4.5], [0.04, 4.0]],
            &[[0.008, 20.0], [0.02, 6.5], [0.06, 2.5]],
        ];
        let fits = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>() <= 0.042_f64.powi(2);
        let mut best = f64::INFINITY;
        for a in offers[0] {
            for b in offers[1] {
                for c in offers[2] {
                    if fits(&[a[0], b[0], c[0]]) {
                        best = best.min(a[1] + b[1] + c[1]);
                    }
                }
            }
        }
        let found = cheapest(&offers, 27, |values| Ok::<bool, Infallible>(fits(values))).unwrap();
        let chosen = found.chosen.unwrap();
        let cost: f64 = chosen.iter().zip(offers).map(|(&place, of)| of[place][1]).sum();
        assert_eq!(cost, best);
        assert!(found.tried < 10 && found.stop == AllocationStop::Found, "{} of 27", found.tried);
        let starved = cheapest(&offers, 1, |values| Ok::<bool, Infallible>(fits(values))).unwrap();
        assert_eq!((starved.chosen, starved.stop, starved.tried), (None, AllocationStop::TriedEnough, 1));
        let refused = cheapest(&offers, 27, |_| Ok::<bool, Infallible>(false)).unwrap();
        assert_eq!((refused.stop, refused.excluded), (AllocationStop::AllExcluded, 27));
        let many: Vec<[f64; 2]> = (1..400).map(|place| [f64::from(place), 1.5]).collect();
        let too_many = cheapest(&[&many, &many], 27, |_| Ok::<bool, Infallible>(true)).unwrap();
        assert_eq!((too_many.stop, too_many.tried), (AllocationStop::TooManyCombinations, 0));
    }
}
