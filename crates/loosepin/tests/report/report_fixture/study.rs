//! A study: small direct double loop over the closed form.

use std::collections::BTreeMap;

use loosepin::result::repeat::{InputRole, InputText, Repeat};
use loosepin::result::{ContactBasis, ContactShape};
use loosepin::simulate::record::Trust;
use loosepin::study::result::*;
use loosepin::study::{RunColumn, RunData, RunsTable};
use loosepin::units::{DisplayUnits, SiUnit};

use super::kinematics::{CRANK_M, Numbers, ROD_M, SPEED_RAD_S, Sample, angles_rad, drawing, orbit};

const CLEARANCE: &str = "joint.gudgeon.radial_clearance";
const RESTITUTION: &str = "contact.steel_pin.restitution";
const CLEARANCE_M: [f64; 2] = [1e-4, 5e-4];
const RESTITUTION_RANGE: [f64; 2] = [0.7, 0.9];
const INNER: usize = 256;
const POSES: usize = 181;

/// Deviations of all inner samples at one value of the epistemic inputs: `curves[pose]` sorted, `largest` sorted.
struct Outer {
    at: Witness,
    curves: Vec<Vec<f64>>,
    largest: Vec<f64>,
}

fn witness(clearance_m: f64, restitution: f64) -> Witness {
    BTreeMap::from([
        (CLEARANCE.to_owned(), WitnessValue::Number(clearance_m)),
        (RESTITUTION.to_owned(), WitnessValue::Number(restitution)),
    ])
}

fn outer(clearance_m: f64, restitution: f64, poses: &[f64]) -> Outer {
    let mut numbers = Numbers::new(1);
    let samples: Vec<Sample> = (0..INNER)
        .map(|_| Sample {
            crank_m: CRANK_M + 2e-5 * numbers.normal(),
            rod_m: ROD_M + 3e-5 * numbers.normal(),
            clearance_m,
            restitution,
            phase: numbers.normal(),
        })
        .collect();
    let nominal = Sample::nominal(0.0);
    let deviation = |sample: &Sample, angle: f64| sample.slider(angle).0 - nominal.ideal_slider(angle).0;
    let sorted = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values
    };
    let curves =
        poses.iter().map(|angle| sorted(samples.iter().map(|sample| deviation(sample, *angle)).collect())).collect();
    let largest = sorted(
        samples
            .iter()
            .map(|sample| poses.iter().map(|angle| deviation(sample, *angle).abs()).fold(0.0, f64::max))
            .collect(),
    );
    Outer { at: witness(clearance_m, restitution), curves, largest }
}

fn quantile(sorted: &[f64], probability: f64) -> f64 {
    sorted[((probability * sorted.len() as f64) as usize).min(sorted.len() - 1)]
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn standard_deviation(values: &[f64]) -> f64 {
    let centre = mean(values);
    (values.iter().map(|value| (value - centre).powi(2)).sum::<f64>() / (values.len() - 1) as f64).sqrt()
}

fn share_below(sorted: &[f64], limit: f64) -> f64 {
    sorted.partition_point(|value| *value <= limit) as f64 / sorted.len() as f64
}

/// The study of the worn pin where the restitution is one of three values, in place of an interval; the picture in the middle is that of
/// the first one.
pub fn with_list() -> StudyResult {
    let mut result = worn_pin();
    let restitution = result.inputs.iter_mut().find(|input| input.path == RESTITUTION).expect("an input");
    restitution.kind = InputKind::Choice { of: ["0.7", "0.8", "0.9"].map(str::to_owned).to_vec() };
    restitution.words = "one of 0.7, 0.8 and 0.9".to_owned();
    let curve = &mut result.curves[0];
    let first = WitnessValue::Number(RESTITUTION_RANGE[0]);
    curve.centre.insert(RESTITUTION.to_owned(), first);
    let own = curve.at_values.iter().find(|value| value.at == curve.centre).expect("the middle was run");
    curve.random = own.band.clone();
    result
}

/// The study of the worn pin with so many outputs that all do the same.
pub fn with_outputs(count: usize) -> StudyResult {
    let mut result = worn_pin();
    let (outputs, bounds, curves) = (result.outputs.clone(), result.bounds.clone(), result.curves.clone());
    for number in 2..=count {
        let name = |own: &str| format!("{own}_{number}");
        result.outputs.extend(outputs.iter().map(|own| OutputDescription { name: name(&own.name), ..own.clone() }));
        result.bounds.extend(bounds.iter().map(|own| BoundRecord { output: name(&own.output), ..own.clone() }));
        result.curves.extend(curves.iter().map(|own| DeviationCurve { output: name(&own.output), ..own.clone() }));
    }
    result
}

/// The study of the worn pin.
pub fn worn_pin() -> StudyResult {
    let poses = angles_rad(1.0, POSES);
    let steps = [0.0, 0.25, 0.5, 0.75, 1.0];
    let within = |range: [f64; 2], share: f64| range[0] + share * (range[1] - range[0]);
    let outers: Vec<Outer> = steps
        .iter()
        .flat_map(|c| [0.0, 0.5, 1.0].map(|e| (within(CLEARANCE_M, *c), within(RESTITUTION_RANGE, e))))
        .map(|(clearance_m, restitution)| outer(clearance_m, restitution, &poses))
        .collect();
    let centre = outer(within(CLEARANCE_M, 0.5), within(RESTITUTION_RANGE, 0.5), &poses);
    let pooled_largest = pooled(outers.iter().map(|outer| &outer.largest));
    StudyResult {
        accuracy: None,
        leans: false,
        format: FORMAT,
        name: "worn pin at 5000 rpm".to_owned(),
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        input_hash: "3f9a1c5e0b7d24686e0f1a2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e6f".to_owned(),
        seed: 1,
        inputs: inputs(),
        correlations: vec![CorrelationDescription {
            of: vec!["parameter.crank_length".to_owned(), "parameter.rod_length".to_owned()],
            rank: 0.6,
            linear: None,
        }],
        cycle: CycleDescription {
            drive: "crank".to_owned(),
            drive_speed_rad_s: Some(SPEED_RAD_S),
            transient_turns: 2.0,
            recorded_turns: 1.0,
            tolerance_m: 1e-8,
            method: "DOP853 with located contacts".to_owned(),
        },
        outputs: vec![OutputDescription {
            name: "slider".to_owned(),
            words: "x of slider.pin".to_owned(),
            unit: SiUnit::LENGTH,
            path: None,
            contact_force_in: None,
        }],
        counts: RunCounts {
            runs: 17_536,
            failed: 3,
            by_purpose: vec![
                PurposeRuns { purpose: Purpose::DoubleLoop, runs: 16_384 },
                PurposeRuns { purpose: Purpose::Mixture, runs: 1024 },
                PurposeRuns { purpose: Purpose::Extreme, runs: 128 },
            ],
            outer: 64,
            inner: 256,
            replicates: 8,
            rounds: 1,
        },
        gaps: Some(GapRecord { between_points: 0.0525, between_runs: 0.0031, axes: 2 }),
        failures: vec![FailureGroup {
            code: "step_below_minimum".to_owned(),
            words: "step 8.1e-15 s is under the minimum of 1e-14 s at t = 0.0213 s: grazing contact in gudgeon"
                .to_owned(),
            count: 3,
            example: ExampleRun {
                index: 4711,
                command: "loosepin simulate model.toml --set parameter.crank_length=50.0213mm --set \
                          joint.gudgeon.radial_clearance=0.1014mm --transient 2 --turns 1"
                    .to_owned(),
            },
        }],
        settled_share: Some(0.874),
        further_turns: None,
        nominal_trust: Trust::NotMeasured,
        requirements: requirements(&outers),
        allowances: allowances(),
        together: None,
        allocation: allocation(),
        bounds: bounds(&outers, &poses),
        cuts: Vec::new(),
        percentiles: Vec::new(),
        rare: Vec::new(),
        promise: None,
        surrogate: None,
        contributors: contributors(),
        answers: answers(),
        treatments: vec![treatments(&outers, &pooled_largest)],
        energy: Some(energy()),
        repeat: Repeat {
            command: "loosepin study study.toml".to_owned(),
            // Line ends of all kinds, and a last line without one.
            files: [
                ("study.toml", InputRole::Study, "name = \"worn pin\"\n"),
                ("model.toml", InputRole::Model, "name = \"slider-crank\"\r\n# mm\r\n"),
                ("parts/rod.csv", InputRole::Table, "\nrod [mm]\n119.98\n<120.01>"),
            ]
            .map(|(name, role, text)| InputText { name: name.to_owned(), role, text: text.to_owned() })
            .to_vec(),
        },
        witness_commands: Vec::new(),
        impacts: vec![JointImpacts {
            joint: "gudgeon".to_owned(),
            laws: vec![StudiedLaw {
                law: "lankarani-nikravesh".to_owned(),
                basis: ContactBasis {
                    shape: ContactShape::Point { unused_length_m: None },
                    is_law_named: true,
                    minimum_impact_speed_m_s: Some(1e-3),
                    largest_valid_speed_m_s: Some(0.05152),
                    largest_valid_penetration_m: None,
                },
            }],
            impacts_per_turn: [9.0, 13.0, 21.0],
            nominal_restitution: Some(RESTITUTION_RANGE),
            delivered_restitution: Some([0.7960, 0.9132]),
            share_outside_validity: Some(0.981),
            largest_penetration_share: 0.143,
            peak_force_n: 45_870.0,
            floored_contacts: 112,
        }],
        display_units: DisplayUnits::default(),
        curves: vec![curve(&outers, &centre, &poses)],
        boxes: vec![probability_box(&outers, &pooled_largest)],
        paths: None,
        motion: None,
        orbits: vec![
            orbit(&Sample::nominal(CLEARANCE_M[1]), "at the upper bound", 1.0),
            orbit(&Sample::nominal(CLEARANCE_M[0]), "joint.gudgeon.radial_clearance = 0.1 mm", 1.0),
        ],
        drawing: drawing(&Sample::nominal(CLEARANCE_M[1]), true),
    }
}

fn pooled<'a>(lists: impl Iterator<Item = &'a Vec<f64>>) -> Vec<f64> {
    let mut all: Vec<f64> = lists.flatten().copied().collect();
    all.sort_by(f64::total_cmp);
    all
}

fn inputs() -> Vec<InputDescription> {
    let input = |path: &str, kind: InputKind, unit: SiUnit, words: &str| InputDescription {
        path: path.to_owned(),
        kind,
        unit,
        words: words.to_owned(),
    };
    let interval = |[lower_si, upper_si]: [f64; 2]| InputKind::Interval { lower_si, upper_si };
    vec![
        input(
            "parameter.crank_length",
            InputKind::Random,
            SiUnit::LENGTH,
            "normal, mean 50 mm, standard deviation 0.02 mm",
        ),
        input(
            "parameter.rod_length",
            InputKind::Random,
            SiUnit::LENGTH,
            "normal, mean 120 mm, standard deviation 0.03 mm",
        ),
        input(CLEARANCE, interval(CLEARANCE_M), SiUnit::LENGTH, "anywhere between 0.1 mm and 0.5 mm"),
        input(RESTITUTION, interval(RESTITUTION_RANGE), SiUnit::NONE, "anywhere between 0.7 and 0.9"),
    ]
}

fn end(value_si: f64, error_si: f64, outwards: f64, [least, most]: [f64; 2], at: &Witness) -> BoundEnd {
    let widened_si = (value_si + outwards * error_si).clamp(least, most);
    // Beyond its range a number has no error.
    let error_si = (widened_si - value_si).abs();
    BoundEnd {
        value_si,
        widened_si,
        witness: at.clone(),
        error: NumericalError { sampling_si: 0.8 * error_si, optimisation_si: 0.2 * error_si, surrogate_si: 0.0 },
    }
}

fn bound(
    at: ResponsePoint,
    statistic: Statistic,
    unit: SiUnit,
    error_si: f64,
    values: &[(f64, &Witness)],
) -> BoundRecord {
    let widest = if statistic.is_probability() { [0.0, 1.0] } else { [f64::NEG_INFINITY, f64::INFINITY] };
    let by_value = |a: &&(f64, &Witness), b: &&(f64, &Witness)| a.0.total_cmp(&b.0);
    let lower = values.iter().min_by(by_value).expect("the fixture has outer points");
    let upper = values.iter().max_by(by_value).expect("the fixture has outer points");
    BoundRecord {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at,
        statistic,
        treatment: Treatment::Mixed,
        reading: Reading::FixedButUnknown,
        unit,
        lower: end(lower.0, error_si, -1.0, widest, lower.1),
        upper: end(upper.0, error_si, 1.0, widest, upper.1),
        guarantee: Guarantee::Sampled { confidence: 0.95 },
    }
}

fn bounds(outers: &[Outer], poses: &[f64]) -> Vec<BoundRecord> {
    let largest = ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute };
    let of_largest = |statistic: &dyn Fn(&[f64]) -> f64| -> Vec<(f64, &Witness)> {
        outers.iter().map(|outer| (statistic(&outer.largest), &outer.at)).collect()
    };
    let pose = poses.len() / 6;
    let at_pose = |statistic: &dyn Fn(&[f64]) -> f64| -> Vec<(f64, &Witness)> {
        outers.iter().map(|outer| (statistic(&outer.curves[pose]), &outer.at)).collect()
    };
    let limit_si = 4e-4;
    let pose_point = ResponsePoint::Pose { pose_rad: poses[pose] };
    let mut list = vec![
        bound(
            largest,
            Statistic::Quantile(0.975),
            SiUnit::LENGTH,
            4.2e-6,
            &of_largest(&|values| quantile(values, 0.975)),
        ),
        bound(largest, Statistic::Mean, SiUnit::LENGTH, 1.1e-6, &of_largest(&mean)),
        bound(largest, Statistic::StandardDeviation, SiUnit::LENGTH, 7e-7, &of_largest(&standard_deviation)),
        bound(
            largest,
            Statistic::ProbabilityAbove(limit_si),
            SiUnit::NONE,
            0.004,
            &of_largest(&|values| 1.0 - share_below(values, limit_si)),
        ),
        bound(pose_point, Statistic::Mean, SiUnit::LENGTH, 9e-7, &at_pose(&mean)),
        bound(pose_point, Statistic::StandardDeviation, SiUnit::LENGTH, 6e-7, &at_pose(&standard_deviation)),
    ];
    for (index, pose_rad) in poses.iter().enumerate() {
        let values: Vec<(f64, &Witness)> = outers.iter().map(|outer| (mean(&outer.curves[index]), &outer.at)).collect();
        let at = ResponsePoint::Curve { pose_rad: *pose_rad };
        list.push(bound(at, Statistic::Mean, SiUnit::LENGTH, 1e-6, &values));
    }
    list
}

fn requirements(outers: &[Outer]) -> Vec<RequirementOutcome> {
    let one = |limit_si: f64, probability_at_least: f64| {
        let shares = || outers.iter().map(|outer| share_below(&outer.largest, limit_si));
        let least = shares().fold(1.0, f64::min);
        let at = outers
            .iter()
            .min_by(|a, b| share_below(&a.largest, limit_si).total_cmp(&share_below(&b.largest, limit_si)))
            .expect("the fixture has outer points");
        RequirementOutcome {
            output: "slider".to_owned(),
            of: Deviation::Total,
            at: ResponsePoint::Whole,
            lower_si: -limit_si,
            upper_si: limit_si,
            probability_at_least,
            probability: [(least - 0.0004).max(0.0), shares().fold(0.0, f64::max)],
            witness: at.at.clone(),
            promised: None,
            failed_values: 0,
            counted: None,
            verdict: if least >= probability_at_least { Verdict::Met } else { Verdict::NotMet },
        }
    };
    vec![one(7e-4, 0.9973), one(5e-4, 0.99)]
}

fn curve(outers: &[Outer], centre: &Outer, poses: &[f64]) -> DeviationCurve {
    let nominal = Sample::nominal(3e-4);
    let over = |statistic: &dyn Fn(&[f64]) -> f64, lowest: bool| -> Vec<f64> {
        (0..poses.len())
            .map(|pose| {
                let values = outers.iter().map(|outer| statistic(&outer.curves[pose]));
                if lowest { values.fold(f64::INFINITY, f64::min) } else { values.fold(f64::NEG_INFINITY, f64::max) }
            })
            .collect()
    };
    let low = |values: &[f64]| quantile(values, 0.025);
    let high = |values: &[f64]| quantile(values, 0.975);
    let at_centre = |statistic: &dyn Fn(&[f64]) -> f64| -> Vec<f64> {
        centre.curves.iter().map(|values| statistic(values)).collect()
    };
    DeviationCurve {
        output: "slider".to_owned(),
        of: Deviation::Total,
        unit: SiUnit::LENGTH,
        probabilities: [0.025, 0.975],
        centre: centre.at.clone(),
        numerical_error_si: 4.2e-6,
        confidence: None,
        pose_rad: poses.to_vec(),
        ideal_si: poses.iter().map(|angle| nominal.ideal_slider(*angle).0).collect(),
        nominal_si: poses.iter().map(|angle| nominal.slider(*angle).0 - nominal.ideal_slider(*angle).0).collect(),
        random: CurveRange { lower_si: at_centre(&low), upper_si: at_centre(&high) },
        mixed: CurveRange { lower_si: over(&low, true), upper_si: over(&high, false) },
        simultaneous: Vec::new(),
        at_values: outers
            .iter()
            .map(|outer| ValueBand {
                at: outer.at.clone(),
                runs: INNER as u64,
                band: CurveRange {
                    lower_si: outer.curves.iter().map(|values| low(values)).collect(),
                    upper_si: outer.curves.iter().map(|values| high(values)).collect(),
                },
            })
            .collect(),
        path: None,
    }
}

fn probability_box(outers: &[Outer], pooled: &[f64]) -> ProbabilityBox {
    let value_si: Vec<f64> = (0..=160).map(|step| 7e-4 * f64::from(step) / 160.0).collect();
    let shares = |value: f64| outers.iter().map(move |outer| share_below(&outer.largest, value));
    ProbabilityBox {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at: ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute },
        unit: SiUnit::LENGTH,
        lower: value_si.iter().map(|value| shares(*value).fold(1.0, f64::min)).collect(),
        upper: value_si.iter().map(|value| shares(*value).fold(0.0, f64::max)).collect(),
        probability_only: value_si.iter().map(|value| share_below(pooled, *value)).collect(),
        limit_si: Some(4e-4),
        numerical_error: 0.004,
        value_si,
    }
}

fn treatments(outers: &[Outer], pooled: &[f64]) -> TreatmentComparison {
    let ends = |probability: f64, lowest: bool| {
        let values = outers.iter().map(|outer| quantile(&outer.largest, probability));
        if lowest { values.fold(f64::INFINITY, f64::min) } else { values.fold(f64::NEG_INFINITY, f64::max) }
    };
    let range = |lower_si: f64, upper_si: f64, treatment: Treatment| {
        let coverage_at: Vec<CoveragePoint> = outers
            .iter()
            .map(|outer| CoveragePoint {
                at: outer.at.clone(),
                coverage: share_below(&outer.largest, upper_si) - share_below(&outer.largest, lower_si - 1e-12),
            })
            .collect();
        TreatmentBand {
            treatment,
            lower_si,
            upper_si,
            coverage_minimum: coverage_at.iter().map(|point| point.coverage).fold(1.0, f64::min),
            coverage_maximum: coverage_at.iter().map(|point| point.coverage).fold(0.0, f64::max),
            coverage_error: 0.003,
            coverage_at,
            ends: None,
            is_by_surrogate: false,
        }
    };
    TreatmentComparison {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at: ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute },
        unit: SiUnit::LENGTH,
        promised_coverage: 0.95,
        bands: vec![
            range(quantile(pooled, 0.025), quantile(pooled, 0.975), Treatment::ProbabilityOnly),
            range(5e-5, 7.3e-4, Treatment::IntervalOnly),
            range(ends(0.025, true), ends(0.975, false), Treatment::Mixed),
        ],
        proven_without_dynamics_si: Some([0.0, 6.8636e-4]),
    }
}

fn energy() -> EnergyResiduals {
    let counts = [3, 21, 160, 922, 3105, 5210, 4180, 1900, 640, 190, 42, 8];
    EnergyResiduals {
        median: 2.1e-11,
        quantile_90: 1.7e-10,
        quantile_99: 8.8e-10,
        maximum: 6.4e-9,
        histogram: counts
            .iter()
            .enumerate()
            .map(|(index, count)| HistogramBin {
                from: 10f64.powf(-13.0 + 0.4 * index as f64),
                to: 10f64.powf(-12.6 + 0.4 * index as f64),
                count: *count,
            })
            .collect(),
    }
}

/// A few runs as a table; the last of them failed.
pub fn runs_table() -> RunsTable {
    const RUNS: usize = 500;
    let mut numbers = Numbers::new(7);
    let last = |row: usize| row == RUNS - 1;
    let mut column = |name: &str, unit: SiUnit, centre: f64, spread: f64, is_output: bool| RunColumn {
        name: name.to_owned(),
        unit,
        data: RunData::F64(
            (0..RUNS)
                .map(|row| {
                    let value = centre + spread * numbers.normal();
                    if is_output && last(row) { f64::NAN } else { value }
                })
                .collect(),
        ),
    };
    let crank = column("parameter.crank_length", SiUnit::LENGTH, CRANK_M, 2e-5, false);
    let rod = column("parameter.rod_length", SiUnit::LENGTH, ROD_M, 3e-5, false);
    let largest = column("slider.total.maximum_absolute", SiUnit::LENGTH, 4e-4, 5e-5, true);
    let words = |value: &dyn Fn(usize) -> &'static str| RunData::Text((0..RUNS).map(|row| value(row).into()).collect());
    let plain = |name: &str, data: RunData| RunColumn { name: name.to_owned(), unit: SiUnit::NONE, data };
    RunsTable {
        columns: vec![
            plain("index", RunData::U64((0..RUNS as u64).collect())),
            crank,
            rod,
            plain("contact.steel_pin.law", words(&|row| if row % 2 == 0 { "lankarani-nikravesh" } else { "flores" })),
            largest,
            plain("status", words(&|row| if last(row) { "failed" } else { "finished" })),
            plain("reason", words(&|row| if last(row) { "step_below_minimum" } else { "" })),
            plain("steps", RunData::U64((0..RUNS as u64).map(|row| 3000 + row % 97).collect())),
        ],
    }
}

/// Contributors to the largest deviation; their numbers belong to no run.
fn answers() -> Vec<QuestionAnswer> {
    let mut finer = QuestionAnswer::new("finer_steps", "What finer steps change");
    finer.add_sentence([
        "A tenth of the tolerance changes ".into(),
        AnswerPart::count("runs", 4),
        " runs by at most ".into(),
        AnswerPart::quantity("largest change", 3.2e-9, SiUnit::LENGTH),
        ".".into(),
    ]);
    vec![finer]
}

fn contributors() -> Vec<Contributors> {
    let share = |centre: f64| ShareRange { centre, error: 0.012, lower: centre - 0.03, upper: centre + 0.04 };
    let random = |path: &str, total: f64, band_share: f64| RandomContributor {
        paths: vec![path.to_owned()],
        first: share(total - 0.02),
        total: share(total),
        band_share,
        quasi_static_share: Some(total + 0.01),
    };
    let epistemic = |path: &str, band_share: [f64; 2], quasi_static_share: Option<f64>| EpistemicContributor {
        path: path.to_owned(),
        band_share,
        error: 0.015,
        quasi_static_share,
        can_be_measured: true,
    };
    vec![Contributors {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at: ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute },
        unit: SiUnit::LENGTH,
        band_width_si: 4.7e-4,
        band_width_error_si: 5e-6,
        points: vec![Witness::new(); 5],
        pairs: 256,
        left_out: 0,
        confidence: 0.95,
        random: vec![random("parameter.rod_length", 0.67, 0.07), random("parameter.crank_length", 0.33, 0.03)],
        epistemic: vec![
            epistemic("joint.gudgeon.radial_clearance", [0.71, 0.84], Some(1.0)),
            epistemic("contact.steel_pin.restitution", [0.01, 0.04], None),
        ],
    }]
}

/// How far the play may grow; its numbers belong to no run.
fn allowances() -> Vec<AllowanceRecord> {
    let check = |value_si: f64, is_confirmation: bool, share: f64, verdict: Verdict| AllowanceCheck {
        fit: None,
        value_si,
        answer: CheckAnswer { is_confirmation, share, required_share: 0.9973, verdict },
    };
    vec![AllowanceRecord {
        path: CLEARANCE.to_owned(),
        what: Loosened::UpperEnd,
        unit: SiUnit::LENGTH,
        up_to_si: 5e-4,
        allowed_si: Some(3.125e-4),
        beyond_si: Some(3.1875e-4),
        allowed_fit: None,
        beyond_fit: None,
        checks: vec![
            check(5e-4, false, 0.31, Verdict::NotMet),
            check(3.125e-4, true, 0.9991, Verdict::Met),
            check(3.1875e-4, true, 0.9962, Verdict::Undecided),
        ],
        runs: 147_456,
    }]
}

/// What is cheapest.
fn allocation() -> Option<AllocationRecord> {
    let input = |path: &str, what: Loosened, value_si: f64, cost: f64| AllocatedInput {
        path: path.to_owned(),
        what,
        unit: SiUnit::LENGTH,
        value_si,
        cost,
    };
    Some(AllocationRecord {
        choices: vec![
            input(CLEARANCE, Loosened::UpperEnd, 3e-4, 12.0),
            input("parameter.rod_length", Loosened::StandardDeviation, 5e-5, 3.5),
        ],
        cost: 15.5,
        combinations: 9,
        studies: 3,
        excluded: 4,
        stop: AllocationStop::Found,
        runs: 49_152,
    })
}

/// A study of which 276 of 2944 runs failed: its mean is that of the finished runs, and its quantile may be among the failed ones. Its mixed band
/// has no end.
pub fn with_failed_runs() -> StudyResult {
    let mut result = worn_pin();
    (result.counts.runs, result.counts.failed, result.counts.inner) = (2944, 276, 128);
    let failure = &mut result.failures[0];
    (failure.code, failure.count) = ("cannot_be_put_together".to_owned(), 276);
    failure.words = "at 0 turns the mechanism cannot be put together: 6 constraints of the joints repeat others and contradict them, joint \
                     'cross_2' is 0.122 mm apart with ideal joints; all plays would have to be 1.286 times as large"
        .to_owned();
    result.requirements.clear();
    result.curves.clear();
    result.percentiles.clear();
    result.cuts.clear();
    let mean = result.bounds.iter().find(|bound| bound.statistic == Statistic::Mean).cloned();
    let mut mean = mean.expect("a mean");
    let mut quantile = BoundRecord { statistic: Statistic::Quantile(0.95), ..mean.clone() };
    mean.guarantee = Guarantee::FinishedRuns;
    (mean.lower.value_si, mean.upper.value_si) = (1e-4, 4e-4);
    for end in [&mut mean.lower, &mut mean.upper] {
        end.error = NumericalError { sampling_si: 1e-5, ..NumericalError::default() };
    }
    (mean.lower.widened_si, mean.upper.widened_si) = (f64::NEG_INFINITY, f64::INFINITY);
    (quantile.lower.value_si, quantile.lower.widened_si) = (2e-4, 2e-4);
    (quantile.upper.value_si, quantile.upper.widened_si) = (f64::INFINITY, f64::INFINITY);
    (quantile.lower.error, quantile.upper.error) = (NumericalError::default(), NumericalError::default());
    result.bounds = vec![mean, quantile];
    result.contributors.truncate(1);
    for band in &mut result.treatments[0].bands {
        if band.treatment != Treatment::IntervalOnly {
            band.upper_si = f64::INFINITY;
        }
    }
    result
}
