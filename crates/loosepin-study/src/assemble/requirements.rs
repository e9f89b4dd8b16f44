//! Requirements against the bounds of the shares that keep their limits.

use super::material::Material;
use crate::file::Requirement;
use loosepin_bounds::{BoundPair, Statistic};
use loosepin_result::study::{CountedMechanisms, KnownShare, RequirementOutcome, ResponsePoint, Verdict, Witness};

/// One outcome for each pose of each requirement, or for the whole cycle. A share without a bound may be anything: such a requirement
/// is undecided.
pub fn requirements(material: &Material<'_>) -> Vec<RequirementOutcome> {
    material.plan().required().map(|(required, column)| outcome(material, required, column)).collect()
}

fn outcome(material: &Material<'_>, requirement: &Requirement, column: usize) -> RequirementOutcome {
    let broken = requirement.limit.broken();
    let pair = material.pair(column, broken);
    // The ends that the bounds of the same probability have elsewhere.
    let ends = material.ends_or_unknown(column, broken);
    let [fewest, most] = ends.each_ref().map(|end| end.widened_si);
    let share = pair.map_or(KnownShare::NOTHING, |pair| known_share(pair, most));
    let [lower_si, upper_si] = requirement.limit.ends();
    RequirementOutcome {
        output: material.name_of(column),
        of: requirement.deviation,
        at: if requirement.location.is_cycle() { ResponsePoint::Whole } else { material.point_of(column, false) },
        lower_si,
        upper_si,
        probability_at_least: requirement.probability_at_least,
        probability: [share.least.max(0.0), (1.0 - fewest).min(1.0)],
        witness: pair.map_or_else(Witness::new, |pair| material.end(&pair.upper).witness),
        promised: None,
        failed_values: 0,
        counted: pair.and_then(|pair| counted(material, pair)),
        verdict: Verdict::of(share, requirement.probability_at_least),
    }
}

/// The share inside, from the bounds of the share outside: one minus it, so that the ends change places. `most_outside`: its upper end.
fn known_share(outside: &BoundPair, most_outside: f64) -> KnownShare {
    // Failed runs are taken as inside here: only what was really seen outside refutes.
    let seen = outside.seen.iter().copied().filter(|share| share.is_finite()).fold(0.0, f64::max);
    let surrogate = outside.lower.error.surrogate.max(outside.upper.error.surrogate);
    KnownShare { least: 1.0 - most_outside, seen: 1.0 - (seen - surrogate).max(0.0) }
}

/// The mechanisms at the witness of the largest share outside.
fn counted(material: &Material<'_>, outside: &BoundPair) -> Option<CountedMechanisms> {
    let witness = outside.upper.witness.as_ref()?;
    let sampling_error = outside.upper.error.sampling;
    let is_alone = material.study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
    if is_alone {
        // The mechanisms are drawn from the surrogate, no rows of the table.
        let mechanisms = material.sampling.inner as u64;
        let outside = (outside.upper.value * mechanisms as f64).round() as u64;
        return Some(CountedMechanisms { mechanisms, outside, sampling_error });
    }
    let runs = material.table.inputs().iter().enumerate();
    let at_witness = runs.filter(|(_, inputs)| (inputs.purpose, inputs.point) == (witness.purpose, witness.point));
    let values: Vec<f64> = at_witness.map(|(run, _)| material.table.values(run)[outside.column]).collect();
    let count = values.iter().filter(|&&value| is_outside(value, outside.statistic)).count();
    Some(CountedMechanisms { mechanisms: values.len() as u64, outside: count as u64, sampling_error })
}

/// Whether `value` is where `broken` counts, or not known.
fn is_outside(value: f64, broken: Statistic) -> bool {
    broken.event().is_some_and(|event| event.holds(value) || value.is_nan())
}

#[cfg(test)]
mod tests {
    use super::{known_share, requirements};
    use crate::assemble::Material;
    use crate::file::Study;
    use crate::planning::problem::problem;
    use crate::response::study_response::StudyResponse;
    use loosepin_bounds::{
        BoundPair, Bounds, DoubleLoop, Problem, Reading, Request, SampleTable, Sampling, Statistic, execute,
    };
    use loosepin_result::study::{CountedMechanisms, KnownShare, RequirementOutcome, Verdict};
    use loosepin_uncertainty::{Distribution, RandomVariable};
    use std::path::Path;

    const MIN_SHARE: f64 = 0.75;

    /// The slider-crank with a worn pin in few and short runs, one requirement that is met easily.
    fn study() -> Study {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
        let text = format!(
            "name = \"required\"\nmodel = \"model.toml\"\n\
             [cycle]\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 36\n\
             [sampling]\nouter = 4\ninner = 32\ntolerance = \"1e-6 m\"\n\
             [random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
             [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"5 mm\"\nover = \"cycle\"\n\
             probability_at_least = {MIN_SHARE}\n"
        );
        let path = folder.join("study.toml");
        Study::from_text_at(&path.display().to_string(), &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
    }

    fn outcomes(
        study: &Study,
        response: &StudyResponse,
        (bounds, table): (&Bounds, &SampleTable),
        pairs: &[BoundPair],
    ) -> Vec<RequirementOutcome> {
        requirements(&Material::of_bounds(study, response, table, bounds).with_pairs(pairs))
    }

    #[test]
    fn a_requirement_without_a_bound_is_undecided_and_not_dropped() {
        let study = study();
        let response = StudyResponse::new(&study).unwrap();
        let plan = DoubleLoop::try_new(problem(&study, &response)).unwrap();
        let mut table = SampleTable::new(response.row_length());
        // Nothing is epistemic: one round is all.
        execute(plan.next_round(&table).unwrap(), &response, &mut table).unwrap();
        let bounds = plan.results(&table).unwrap();
        let [met] = &outcomes(&study, &response, (&bounds, &table), &bounds.pairs)[..] else {
            panic!("one is required")
        };
        assert_eq!(met.verdict, Verdict::Met);
        let Some(CountedMechanisms { mechanisms, outside, sampling_error }) = met.counted else { panic!("{met:?}") };
        assert_eq!((mechanisms, outside, 1.0 - sampling_error), (32, 0, met.probability[0]));
        let [unknown] = &outcomes(&study, &response, (&bounds, &table), &[])[..] else { panic!("it was dropped") };
        assert_eq!((unknown.verdict, unknown.probability, unknown.counted), (Verdict::Undecided, [0.0, 1.0], None));
        assert_eq!(Verdict::of_all([unknown.verdict]), Some(Verdict::Undecided));
    }

    /// Bounds of the share outside, where `outside` of 64 runs at the only value of the epistemic inputs are.
    fn counted_outside(outside: usize) -> BoundPair {
        let uniform = Distribution::Uniform { lower: 0.0, upper: 1.0 };
        let plan = DoubleLoop::try_new(Problem {
            random: vec![RandomVariable::try_new(uniform).unwrap()],
            epistemic: Vec::new(),
            parameters: Vec::new(),
            copula: None,
            reading: Reading::FixedButUnknown,
            readings_beside: Vec::new(),
            columns: 1,
            requests: vec![Request { column: 0, statistic: Statistic::ProbabilityAbove(0.5) }],
            compared_columns: Vec::new(),
            band_probability: 0.95,
            cut_standard_deviations: 3.0,
            percentiles: Vec::new(),
            sampling: Sampling { inner: 64, confidence: CONFIDENCE, ..Sampling::default() },
        });
        let plan = plan.unwrap();
        let mut table = SampleTable::new(1);
        for (run, inputs) in plan.next_round(&table).unwrap().into_iter().enumerate() {
            table.push(inputs, Ok(&[f64::from(u8::from(run < outside))])).unwrap();
        }
        assert_eq!(table.len(), 64);
        plan.results(&table).unwrap().pairs.remove(0)
    }

    const CONFIDENCE: f64 = 0.99;

    #[test]
    fn analytic_a_requirement_is_refuted_by_the_lower_end_of_the_share_outside() {
        const TOLERANCE: f64 = 1e-12;
        let pair = counted_outside(60);
        // The interval of Clopper and Pearson of 60 in 64 is longer downwards than upwards: (0.816, 0.990). At its lower end 60 or more
        // of 64 have the probability 0.005, C(64, k) p^k (1 - p)^(64 - k) summed.
        let share = known_share(&pair, pair.upper.widened);
        let (p, mut term, mut at_least) = (1.0 - share.seen, 1.0, 0.0);
        for (misses, runs) in (0..=4).zip((60..=64).rev()) {
            at_least += term * p.powi(runs) * share.seen.powi(misses);
            term *= f64::from(runs) / f64::from(misses + 1);
        }
        assert!((at_least - 0.5 * (1.0 - CONFIDENCE)).abs() < TOLERANCE, "{share:?} {at_least}");
        assert_eq!(Verdict::of(share, 0.12), Verdict::Undecided);
        assert_eq!(Verdict::of(share, 0.19), Verdict::NotMet);
        // With the upper half-width instead it would be refuted.
        let upwards = KnownShare { seen: 1.0 - (pair.upper.value - pair.upper.error.sampling), ..share };
        assert_eq!(Verdict::of(upwards, 0.12), Verdict::NotMet);
    }
}
