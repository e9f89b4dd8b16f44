//! Studies of mechanisms in space against closed forms: a four-bar with two balls, whose rocker depends on the length of its coupler alone.

use crate::silent::{Silent, run};
use loosepin::space::SpatialModel;
use loosepin::study::result::{BoundRecord, Guarantee, StudyResult};
use loosepin::study::{RunOptions, Study, run_study};
use loosepin::templates::{SPATIAL_TEMPLATES, find_template};
use std::sync::atomic::AtomicBool;

const MM: f64 = 1e-3;
pub(crate) const COUPLER_M: f64 = 0.25;

/// Angle of the rocker of the four-bar with two balls for a coupler of this length, rad (shared notes of the project, closed form): D is the
/// vector from the pin of the crank to the pivot, e2 and a2 are the direction from which the angle counts and the axis.
///
/// ```text
/// P = 2k D·e2,  Q = 2k D·(a2×e2),  S = L² - k² - D·D,   ψ = atan2(Q, P) + acos(S/sqrt(P² + Q²))
/// ```
pub(crate) fn rocker_rad(crank_rad: f64, coupler_m: f64) -> f64 {
    const CRANK_M: f64 = 0.05;
    const ROCKER_M: f64 = 0.12;
    let pivot_m = [0.22, 0.04, 0.06];
    let pin_m = [CRANK_M * crank_rad.cos(), CRANK_M * crank_rad.sin(), 0.0];
    let d: Vec<f64> = pivot_m.iter().zip(pin_m).map(|(pivot, pin)| pivot - pin).collect();
    // a2 = (0.6, 0.8, 0), e2 = z: a2 × e2 = (0.8, -0.6, 0).
    let p = 2.0 * ROCKER_M * d[2];
    let q = 2.0 * ROCKER_M * (0.8 * d[0] - 0.6 * d[1]);
    let s = coupler_m * coupler_m - ROCKER_M * ROCKER_M - d.iter().map(|x| x * x).sum::<f64>();
    q.atan2(p) + (s / p.hypot(q)).acos()
}

fn four_bar() -> SpatialModel {
    let text = find_template("spatial-four-bar").expect("template").model;
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn studied(inputs: &str, question: &str) -> StudyResult {
    let text = format!(
        "name = \"four-bar\"\nmodel = \"model.toml\"\n[sampling]\nouter = 16\ninner = 512\nreplicates = 4\n{inputs}\n[[ask]]\noutput = \"rocker\"\n{question}\n"
    );
    let study = Study::from_text("study.toml", &text, four_bar()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    run(&study).result
}

fn bound(result: &StudyResult) -> &BoundRecord {
    &result.bounds[0]
}

/// Both balls have up to this much play: the coupler acts as if it were twice as much longer or shorter.
const CLEARANCE: &str = "\"joint.rocker_ball.radial_clearance\" = { interval = [\"0.05 mm\", \"0.2 mm\"] }";

#[test]
fn analytic_unknown_play_alone_reaches_the_ends_of_the_closed_form() {
    let result = studied(
        &format!("[epistemic]\n{CLEARANCE}"),
        "of = \"clearance\"\nposes = { crank = [\"60 deg\"] }\nstatistics = [\"mean\"]",
    );
    let at = 60f64.to_radians();
    let ends = [0.3, -0.3].map(|longer_mm| rocker_rad(at, COUPLER_M + longer_mm * MM) - rocker_rad(at, COUPLER_M));
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    let found = bound(&result);
    assert!((found.lower.value_si - low).abs() < 1e-9 * high, "{found:?} {low}");
    assert!((found.upper.value_si - high).abs() < 1e-9 * high, "{found:?} {high}");
}

#[test]
fn analytic_scatter_and_play_together_bound_a_quantile() {
    let result = studied(
        &format!(
            "[random]\n\"parameter.coupler_length\" = {{ normal = {{ standard_deviation = \"0.05 mm\" }} }}\n[epistemic]\n{CLEARANCE}"
        ),
        "of = \"total\"\nposes = { crank = [\"60 deg\"] }\nstatistics = [{ quantile = 0.9 }]",
    );
    let at = 60f64.to_radians();
    // The quantile of 0.9 of a normal distribution. The rocker falls or rises with the coupler: its quantile is at one end of it.
    const Z: f64 = 1.281_551_565_544_600_4;
    let of = |sign: f64, play_mm: f64| {
        rocker_rad(at, COUPLER_M + sign * Z * 0.05 * MM + play_mm * MM) - rocker_rad(at, COUPLER_M)
    };
    let rises = rocker_rad(at, COUPLER_M + MM) > rocker_rad(at, COUPLER_M);
    let sign = if rises { 1.0 } else { -1.0 };
    let (low, high) = (of(sign, -sign * 0.3), of(sign, sign * 0.3));
    let found = bound(&result);
    for (end, exact) in [(&found.lower, low), (&found.upper, high)] {
        let error_si = (end.widened_si - end.value_si).abs();
        assert!(error_si > 0.0 && error_si < 0.1 * high.abs(), "{found:?}");
        assert!((end.value_si - exact).abs() < 2.0 * error_si, "{exact} {found:?}");
    }
}

#[test]
fn analytic_lengths_alone_have_the_standard_deviation_of_their_derivative() {
    let result = studied(
        "[random]\n\"parameter.coupler_length\" = { normal = { standard_deviation = \"0.01 mm\" } }",
        "of = \"dimensional\"\nposes = { crank = [\"0 deg\"] }\nstatistics = [\"standard_deviation\"]",
    );
    let slope = (rocker_rad(0.0, COUPLER_M + 1e-6) - rocker_rad(0.0, COUPLER_M - 1e-6)) / 2e-6;
    let exact = slope.abs() * 0.01 * MM;
    let found = bound(&result);
    assert!((found.upper.value_si - exact).abs() < 0.02 * exact, "{exact} {found:?}");
}

#[test]
fn analytic_the_largest_deviation_of_a_turn_is_that_of_its_worst_position() {
    let result = studied(
        &format!("[epistemic]\n{CLEARANCE}"),
        "of = \"clearance\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\"]",
    );
    let reach = |k: usize| {
        let at = f64::from(k as u32) * 5f64.to_radians();
        let ideal = rocker_rad(at, COUPLER_M);
        [0.3, -0.3].map(|mm| (rocker_rad(at, COUPLER_M + mm * MM) - ideal).abs()).into_iter().fold(0.0, f64::max)
    };
    let largest = (0..72).map(reach).fold(0.0, f64::max);
    let found = bound(&result);
    assert!((found.upper.value_si - largest).abs() < 1e-9 * largest, "{found:?} {largest}");
    // Journals that stay in the middle make no deviation.
    assert!(found.lower.value_si.abs() < 1e-12, "{found:?}");
}

/// What reading a study of the four-bar says.
fn refused(inputs: &str, question: &str) -> String {
    let text = format!("name = \"four-bar\"\nmodel = \"model.toml\"\n{inputs}\n{question}\n");
    match Study::from_text("study.toml", &text, four_bar()) {
        Ok(study) => match run_study(&study, "", &RunOptions::new(1, &Silent, &AtomicBool::new(false))) {
            Ok(_) => panic!("{question}"),
            Err(error) => error.to_string(),
        },
        Err(found) => found.to_string(),
    }
}

#[test]
fn what_is_not_largest_on_one_side_of_all_plays_is_refused() {
    let inputs = format!("[epistemic]\n{CLEARANCE}");
    let ask = |rest: &str| format!("[[ask]]\noutput = \"rocker\"\n{rest}");
    let both = "the journals of each mechanism may be on another side of their play";
    for question in [
        ask("of = \"clearance\"\nat = \"cycle\"\nstatistics = [\"standard_deviation\"]"),
        ask("of = \"total\"\nat = \"cycle\"\nstatistics = [{ simultaneous_band = 0.95 }]"),
        "[[require]]\noutput = \"rocker\"\nof = \"total\"\nwithin = \"5 mrad\"\nposes = { crank = [\"60 deg\"] }\n\
         probability_at_least = 0.9"
            .to_owned(),
    ] {
        let said = refused(&inputs, &question);
        assert!(said.contains(both), "{question}: {said}");
    }
}

#[test]
fn what_positions_do_not_have_is_refused() {
    let ask = "[[ask]]\noutput = \"rocker\"\nof = \"clearance\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]";
    let inputs = format!("[cycle]\ntransient_turns = 0.25\n[epistemic]\n{CLEARANCE}");
    let said = refused(&inputs, ask);
    assert!(said.contains("no start-up"), "{said}");
    let inputs = "[random]\n\"drive.crank.start_angle\" = { normal = { standard_deviation = \"0.1 deg\" } }";
    let said = refused(inputs, ask);
    assert!(said.contains("is the start of the drive"), "{said}");
    let inputs = format!("[cycle]\nrecorded_turns = 0.5\n[epistemic]\n{CLEARANCE}");
    let said = refused(&inputs, &ask.replace("reduce = \"maximum\"", "poses = { crank = [\"270 deg\"] }"));
    assert!(said.contains("do not pass there"), "{said}");
}

#[test]
fn identity_numbers_of_the_cycle_do_not_depend_on_poses_that_are_asked_for() {
    let inputs = format!("[epistemic]\n{CLEARANCE}");
    let mean = "of = \"clearance\"\nreduce = \"rms\"\nstatistics = [\"mean\"]";
    let poses: Vec<String> = (1..60).map(|k| format!("\"{k}.5 deg\"")).collect();
    let further = format!(
        "{mean}\n[[ask]]\noutput = \"rocker\"\nof = \"clearance\"\nposes = {{ crank = [{}] }}\nstatistics = [\"mean\"]",
        poses.join(", ")
    );
    let ends = |question: &str| {
        let found = studied(&inputs, question).bounds[0].clone();
        [found.lower.value_si, found.upper.value_si]
    };
    let (alone, beside) = (ends(mean), ends(&further));
    assert!((alone[1] - beside[1]).abs() < 1e-12 * alone[1], "{alone:?} {beside:?}");
}

#[test]
fn every_template_in_space_has_a_study_that_runs() {
    for template in SPATIAL_TEMPLATES {
        let model =
            SpatialModel::from_text("model.toml", template.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let read = |text: &str| {
            let study = Study::from_text("study.toml", text, model.clone());
            study.unwrap_or_else(|found| panic!("{}: {found}", template.name))
        };
        let whole = read(template.study);
        assert!(whole.warnings.is_empty(), "{}: {:?}", template.name, whole.warnings);
        let small = |line: &str| match line.split(" = ").next() {
            Some("outer") => "outer = 9\n".to_owned(),
            Some("inner") => "inner = 8\n".to_owned(),
            _ => format!("{line}\n"),
        };
        let text: String = template.study.lines().map(small).collect();
        let study = read(&text);
        let result = run(&study).result;
        assert_eq!(result.counts.failed, 0, "{}: {:?}", template.name, result.failures);
        assert!(result.bounds.iter().any(|bound| bound.upper.value_si > 0.0), "{}", template.name);
    }
}

/// A driven shaft in two bearings, l = 20 mm long with c = 50 µm of clearance, D = 150 mm apart.
const SHAFT: &str = r#"
name = "shaft"
geometry = "space"
[body.ground]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"] }
[body.shaft]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"], tip = ["0 mm", "0 mm", "400 mm"] }
[joint.fixed]
kind = "revolute"
bearing = "ground.a"
journal = "shaft.a"
radial_clearance = "50 um"
bearing_length = "20 mm"
axial_clearance = "0.1 mm"
[joint.loose]
kind = "cylindrical"
bearing = "ground.b"
journal = "shaft.b"
radial_clearance = "50 um"
bearing_length = "20 mm"
[drive.motor]
joint = "fixed"
speed = "60 rpm"
start_angle = "0 deg"
[cycle]
drive = "motor"
[output.tip]
position_of = "shaft.tip"
along = "y"
"#;

/// A bearing that is off by δ takes the play c only up to δ = 2 D c/l = 0.75 mm: of normal offsets with σ = 0.4 mm, 2 (1 - Φ(1.875)) = 6.08 % are
/// more, and those shafts cannot be put in. More than the 5 % beyond a quantile of 95 % fail.
#[test]
fn analytic_parts_that_do_not_fit_fail_and_leave_a_mean_and_a_high_quantile_without_a_bound() {
    let model = SpatialModel::from_text("model.toml", SHAFT).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let words = loosepin::check::check_space(&model, &|| false)
        .map(|article| loosepin::report::article_text(&article, None))
        .unwrap();
    let text = "name = \"shafts\"\nmodel = \"model.toml\"\n[cycle]\nsamples_per_turn = 8\n[sampling]\nouter = 4\ninner = 512\nreplicates = 4\nmost_failed = 0.3\n\
                [random]\n\"body.ground.points.b.y\" = { normal = { mean = \"0 mm\", standard_deviation = \"0.4 mm\" } }\n\
                [[ask]]\noutput = \"tip\"\nof = \"total\"\nreduce = \"maximum\"\n\
                statistics = [\"mean\", { quantile = 0.5 }, { quantile = 0.95 }]\n\
                [[ask]]\noutput = \"tip\"\nof = \"total\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\"]\n";
    let study = Study::from_text("study.toml", text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let result = run(&study).result;
    const FAILED: f64 = 0.060_801;
    // Runs of worst cases, which are not drawn as the offsets scatter, fail more often.
    let share = result.counts.failed as f64 / result.counts.runs as f64;
    assert!(share > FAILED - 0.015 && share < 0.2, "{share}");
    let failure = &result.failures[0];
    assert_eq!(failure.code, "cannot_be_put_together");
    assert!(2 * failure.count > result.counts.failed, "{:?}", result.failures);
    // The constraints are those that `check` counts.
    assert!(words.contains("4 constraints of the joints repeat others"), "{words}");
    assert!(failure.words.contains("4 constraints of the joints repeat others and contradict them"), "{failure:?}");
    let [mean, median, high, magnitude] = &result.bounds[..] else { panic!("{:?}", result.bounds) };
    // What is never negative is bounded below by that alone; its numbers stay those of the finished runs.
    assert_eq!([magnitude.lower.widened_si, magnitude.upper.widened_si], [0.0, f64::INFINITY]);
    assert!(magnitude.lower.value_si > 0.0, "{magnitude:?}");
    assert!(
        [&magnitude.lower, &magnitude.upper].iter().all(|end| end.error.total_si() < 0.2 * end.value_si),
        "{magnitude:?}"
    );
    assert_eq!(mean.guarantee, Guarantee::FinishedRuns);
    assert_eq!([mean.lower.widened_si, mean.upper.widened_si], [f64::NEG_INFINITY, f64::INFINITY]);
    assert!(mean.upper.value_si.is_finite() && mean.upper.error.total_si().is_finite(), "{mean:?}");
    assert!(median.upper.widened_si.is_finite() && high.upper.widened_si.is_infinite(), "{median:?} {high:?}");
    let shown = loosepin::report::study_text(&result);
    assert!(shown.contains(" % of the runs failed (") && !shown.contains("increase 'inner'"), "{shown}");
}
