//! Journals at places that are drawn, in studies of a four-bar with two balls, against closed forms.
//!
//! To first order the rocker deviates by its derivative g by the length of the coupler, times the component of the place of the ball along the
//! coupler. Of a place that is uniform in a ball of radius c that component x has the density 3/(4c) (1 - x²/c²), of one that is uniform on the
//! surface it is uniform:
//!
//! ```text
//! σ = |g| c/√5,  F(x) = (2 + 3 x/c - (x/c)³)/4     in the ball
//! σ = |g| c/√3,  F(x) = (1 + x/c)/2                on its surface
//! ```

use crate::silent::{run, run_on};
use crate::space::{COUPLER_M, rocker_rad};
use loosepin::report::study_text;
use loosepin::space::SpatialModel;
use loosepin::study::Study;
use loosepin::study::result::{BoundRecord, InputKind, StudyResult};
use loosepin::templates::find_template;

/// Clearance of the one ball that has play, so small that what is left out is: c/L = 8e-6 of the deviation.
const CLEARANCE_M: f64 = 2e-6;
/// Terms of second order, relative to the deviation.
const SECOND_ORDER: f64 = 1e-4;
const IN_BALL: &str = "uniform-in-play";
const ON_SURFACE: &str = "uniform-on-rims";

/// The four-bar with play in the ball of the rocker alone.
fn four_bar() -> SpatialModel {
    let text = find_template("spatial-four-bar").expect("template").model;
    let [crank_ball, rocker_ball]: [&str; 2] =
        text.split_inclusive("[joint.rocker_ball]").collect::<Vec<_>>().try_into().expect("two balls");
    let with = |part: &str, clearance: &str| {
        assert!(part.contains("radial_clearance = \"0.1 mm\""), "{part}");
        part.replace("radial_clearance = \"0.1 mm\"", &format!("radial_clearance = \"{clearance}\""))
    };
    let text = with(crank_ball, "0 mm") + &with(rocker_ball, "2 um");
    SpatialModel::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn study(journals: &str, rest: &str) -> Study {
    let text = format!(
        "name = \"four-bar\"\nmodel = \"model.toml\"\njournals = \"{journals}\"\n[cycle]\nsamples_per_turn = 12\n\
         [sampling]\nouter = 8\ninner = 512\nreplicates = 4\n{rest}\n"
    );
    Study::from_text("study.toml", &text, four_bar()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn ask(rest: &str) -> String {
    format!("[[ask]]\noutput = \"rocker\"\nof = \"clearance\"\n{rest}")
}

/// At 60 degrees.
fn at_pose(statistics: &str) -> String {
    ask(&format!("poses = {{ crank = [\"60 deg\"] }}\nstatistics = [{statistics}]"))
}

/// |dψ/dL| at 60 degrees, rad/m.
fn gain_rad_m() -> f64 {
    const STEP_M: f64 = 1e-6;
    let at = 60_f64.to_radians();
    ((rocker_rad(at, COUPLER_M + STEP_M) - rocker_rad(at, COUPLER_M - STEP_M)) / (2.0 * STEP_M)).abs()
}

/// Both ends are `exact` within their stated error, which says something.
fn assert_holds(bound: &BoundRecord, exact: [f64; 2]) {
    for (end, exact) in [&bound.lower, &bound.upper].into_iter().zip(exact) {
        let error_si = (end.widened_si - end.value_si).abs();
        assert!(error_si < 0.1 * exact.abs(), "{exact} {bound:?}");
        assert!((end.value_si - exact).abs() <= error_si + SECOND_ORDER * exact.abs(), "{exact} {bound:?}");
    }
}

/// Where a component of a uniform place in a unit ball has this probability.
fn quantile_in_ball(probability: f64) -> f64 {
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..60 {
        let x: f64 = 0.5 * (low + high);
        if (2.0 + 3.0 * x - x * x * x) / 4.0 < probability { low = x } else { high = x }
    }
    0.5 * (low + high)
}

#[test]
fn analytic_standard_deviation_and_quantile_of_a_place_in_a_ball_and_on_its_surface() {
    let reach = gain_rad_m() * CLEARANCE_M;
    for (journals, divisor, quantile) in [(IN_BALL, 5.0_f64, quantile_in_ball(0.9)), (ON_SURFACE, 3.0, 0.8)] {
        let result = run(&study(journals, &at_pose("\"standard_deviation\", { quantile = 0.9 }"))).result;
        assert_eq!((result.counts.failed, result.bounds.len()), (0, 2), "{:?}", result.failures);
        assert_holds(&result.bounds[0], [reach / divisor.sqrt(); 2]);
        assert_holds(&result.bounds[1], [reach * quantile; 2]);
    }
}

#[test]
fn analytic_an_unknown_clearance_bounds_the_standard_deviation() {
    let unknown = "[epistemic]\n\"joint.rocker_ball.radial_clearance\" = { interval = [\"1 um\", \"3 um\"] }\n";
    let result = run(&study(IN_BALL, &format!("{unknown}{}", at_pose("\"standard_deviation\"")))).result;
    assert_holds(&result.bounds[0], [1e-6, 3e-6].map(|clearance_m| gain_rad_m() * clearance_m / 5_f64.sqrt()));
    assert_eq!(
        result.inputs.iter().map(|input| input.path.as_str()).collect::<Vec<_>>().last(),
        Some(&"joint.rocker_ball.radial_clearance")
    );
}

#[test]
fn analytic_a_limit_to_both_sides_at_a_pose_is_judged() {
    // On the surface the share within a part of the reach is that part: 0.8.
    let limit_rad = 0.8 * gain_rad_m() * CLEARANCE_M;
    let require = |share: f64| {
        format!(
            "[[require]]\noutput = \"rocker\"\nof = \"clearance\"\nwithin = \"{limit_rad:?} rad\"\nposes = {{ crank = [\"60 deg\"] }}\n\
             probability_at_least = {share}"
        )
    };
    let result = run(&study(ON_SURFACE, &format!("{}\n{}", require(0.7), require(0.9)))).result;
    let verdicts: Vec<String> = result.requirements.iter().map(|own| format!("{:?}", own.verdict)).collect();
    assert_eq!(verdicts, ["Met", "NotMet"]);
}

#[test]
fn identity_the_standard_deviation_of_a_motion_is_that_of_a_study_at_its_poses() {
    // Both balls have their play of the template, 0.1 mm: second order is 4e-4.
    let text = find_template("spatial-four-bar").expect("template").model;
    let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let motion = model.motion_record(&model.quantities.nominal()).unwrap_or_else(|found| panic!("{found}"));
    let own = motion.outputs.iter().find(|output| output.name == "rocker").expect("output");
    let study = format!(
        "name = \"four-bar\"\nmodel = \"model.toml\"\njournals = \"{IN_BALL}\"\n[sampling]\ninner = 512\n{}",
        ask("poses = { crank = [\"0 deg\", \"60 deg\", \"200 deg\"] }\nstatistics = [\"standard_deviation\"]")
    );
    let study = Study::from_text("study.toml", &study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let result = run(&study).result;
    let step_deg = 360.0 / (motion.drive_angle_rad.len() - 1) as f64;
    for (bound, angle_deg) in result.bounds.iter().zip([0.0, 60.0, 200.0]) {
        let sample = angle_deg / step_deg;
        assert!((sample - f64::round(sample)).abs() < 1e-9, "{step_deg}");
        let due = own.clearance.disc_standard_deviation_si[sample.round() as usize];
        const SECOND_ORDER_OF_BALLS: f64 = 1e-3;
        let error_si = (bound.upper.widened_si - bound.upper.value_si).abs();
        assert!((bound.upper.value_si - due).abs() <= error_si + SECOND_ORDER_OF_BALLS * due, "{due} {bound:?}");
    }
}

#[test]
fn identity_drawn_places_are_the_same_in_every_number_of_threads_and_follow_the_seed() {
    let numbers = |result: &StudyResult| -> Vec<u64> {
        let ends = result.bounds.iter().flat_map(|bound| [&bound.lower, &bound.upper]);
        ends.flat_map(|end| [end.value_si.to_bits(), end.widened_si.to_bits()]).collect()
    };
    let questions = format!(
        "{}\n{}",
        at_pose("\"standard_deviation\", \"contributors\""),
        ask("reduce = \"range\"\nstatistics = [\"mean\", \"standard_deviation\"]")
    );
    let of = |threads: usize, seed: u64| {
        let mut study = study(IN_BALL, &questions);
        study.seed = seed;
        numbers(&run_on(threads, &study).unwrap_or_else(|error| panic!("{error}")).result)
    };
    let one = of(1, 1);
    assert_eq!(one, of(2, 1));
    assert_ne!(one, of(2, 2));
}

#[test]
fn drawn_places_are_one_input_with_its_assumption_and_one_contributor_of_each_joint() {
    let result = run(&study(IN_BALL, &at_pose("\"mean\", \"contributors\""))).result;
    let [input] = &result.inputs[..] else { panic!("{:?}", result.inputs) };
    assert_eq!((input.path.as_str(), &input.kind), ("play", &InputKind::DrawnPlay));
    assert_eq!(input.words, "journals anywhere in their play, all places alike, held over the turn");
    // The text has one line of assumptions.
    let text = study_text(&result);
    let lines = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(lines.matches(&input.words).count(), 1, "{text}");
    assert!(lines.contains(&format!("the model as written, no other random input, {}", input.words)), "{text}");
    let mut paths: Vec<String> = result.contributors[0].random.iter().map(|own| own.paths.join(" ")).collect();
    paths.sort();
    assert_eq!(paths, ["joint.crank_ball.journal", "joint.rocker_ball.journal"]);
    let share = |path: &str| {
        let own = result.contributors[0].random.iter().find(|own| own.paths == [path]);
        own.map_or(f64::NAN, |own| own.total.centre)
    };
    // All that scatters is the one ball with play.
    assert!((share("joint.rocker_ball.journal") - 1.0).abs() < 0.05 && share("joint.crank_ball.journal").abs() < 0.05);
}

/// Derivative of the rocker's angle by the length of the coupler with the crank at an angle, rad/m, times the direction of the coupler in axes of
/// the rocker: along its arm, across it, along its pin.
fn gain_vector_rad_m(crank_rad: f64) -> [f64; 3] {
    const PIVOT_M: [f64; 3] = [0.22, 0.04, 0.06];
    const AXIS: [f64; 3] = [0.6, 0.8, 0.0];
    let psi = rocker_rad(crank_rad, COUPLER_M);
    let slope = (rocker_rad(crank_rad, COUPLER_M + 1e-6) - rocker_rad(crank_rad, COUPLER_M - 1e-6)) / 2e-6;
    // From z about the axis: a × z = (0.8, -0.6, 0).
    let (sine, cosine) = psi.sin_cos();
    let arm = [0.8 * sine, -0.6 * sine, cosine];
    let across = [0.8 * cosine, -0.6 * cosine, -sine];
    let pin_m = [0.05 * crank_rad.cos(), 0.05 * crank_rad.sin(), 0.0];
    let coupler = [0, 1, 2].map(|k| (PIVOT_M[k] + 0.12 * arm[k] - pin_m[k]) / COUPLER_M);
    let dot = |a: [f64; 3]| a.iter().zip(coupler).map(|(a, b)| a * b).sum::<f64>();
    assert!((dot(coupler) - 1.0).abs() < 1e-9, "the coupler ends at the ball");
    [arm, across, AXIS].map(|direction| slope * dot(direction))
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn analytic_curves_and_the_mean_over_a_turn_in_which_journals_keep_their_places() {
    let band = ask("at = \"cycle\"\nstatistics = [\"standard_deviation\", { simultaneous_band = 0.9 }]");
    let mean = ask("reduce = \"mean\"\nstatistics = [\"standard_deviation\"]");
    let result = run(&study(ON_SURFACE, &format!("{mean}\n{band}"))).result;
    assert_eq!(result.counts.failed, 0);
    let vectors: Vec<[f64; 3]> = (0..12).map(|k| gain_vector_rad_m(f64::from(k) * 30_f64.to_radians())).collect();
    // A place e of the ball makes the mean of g u·e, which is as long as the mean of the vectors g u: far less would be left of places drawn anew at
    // each position.
    let whole = [0, 1, 2].map(|k| vectors.iter().map(|vector| vector[k]).sum::<f64>() / 12.0);
    assert_holds(&result.bounds[0], [length(whole) * CLEARANCE_M / 3_f64.sqrt(); 2]);
    let deviations: Vec<&BoundRecord> =
        result.bounds[1..].iter().filter(|bound| bound.statistic.word() == "standard_deviation").collect();
    assert_eq!(deviations.len(), 12);
    for (bound, vector) in deviations.into_iter().zip(&vectors) {
        assert_holds(bound, [length(*vector) * CLEARANCE_M / 3_f64.sqrt(); 2]);
    }
    let curve = &result.curves[0];
    let [simultaneous] = &curve.simultaneous[..] else { panic!("{:?}", curve.simultaneous) };
    assert!(simultaneous.factor >= 1.0 && simultaneous.band.lower_si.len() == curve.pose_rad.len());
    // The nominal mechanism has its journals in the middle.
    assert!(curve.nominal_si.iter().all(|value| value.abs() < 1e-9 * gain_rad_m() * CLEARANCE_M), "{curve:?}");
}
