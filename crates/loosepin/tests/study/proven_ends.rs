//! What is proven without dynamics beside the bands of a study: the ends of `motion`, and those of the closed form.

use std::sync::atomic::AtomicBool;

use crate::silent::run;
use loosepin::model::Model;
use loosepin::study::result::{Reduction, ResponsePoint, StudyResult};
use loosepin::study::{InputFile, Study};

const MODEL: &str = include_str!("../../../../cases/slider_crank_worn_pin/model.toml");
/// Crank, rod and the largest play, mm; 3 standard deviations of the lengths.
const CRANK: f64 = 50.0;
const ROD: f64 = 120.0;
const PLAY: f64 = 0.5;
const CRANK_OFF: f64 = 0.06;
const ROD_OFF: f64 = 0.09;
/// At 90° the crank takes the slider half a degree to either side, mm: what the lengths then do more, 0.06 mm times 0.0087, and the rod's slope.
const HALF_A_STEP_MM: f64 = 2e-3;

const STUDY: &str = r#"
name = "few mechanisms"
model = "model.toml"
[cycle]
transient_turns = 0
recorded_turns = 1
[sampling]
outer = 5
inner = 16
replicates = 4
[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }
"parameter.rod_length" = { normal = { mean = "120 mm", standard_deviation = "0.03 mm" } }
[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }
[[ask]]
output = "slider"
of = "total"
poses = { crank = ["90 deg"] }
statistics = ["mean"]
[[ask]]
output = "slider"
of = "total"
reduce = "maximum_absolute"
statistics = ["mean"]
[[ask]]
output = "slider"
of = "total"
reduce = "range"
statistics = ["mean"]
[[ask]]
output = "slider_velocity"
of = "total"
reduce = "maximum_absolute"
statistics = ["mean"]
"#;
/// The same places for `motion`.
const REQUIRED: &str = r#"
[[require]]
output = "slider"
of = "total"
within = "2 mm"
poses = { crank = ["90 deg"] }
probability_at_least = 0.5
[[require]]
output = "slider"
of = "total"
within = "2 mm"
over = "cycle"
probability_at_least = 0.5
"#;

fn study(text: &str) -> Study {
    let model = Model::from_text("model.toml", MODEL).expect("a model");
    Study::from_text("study.toml", text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn proven_mm(result: &StudyResult, output: &str, is_there: impl Fn(ResponsePoint) -> bool) -> Option<[f64; 2]> {
    let mut all = result.treatments.iter();
    let own = all.find(|own| own.output == output && is_there(own.at)).expect("its treatments are compared");
    own.proven_without_dynamics_si.map(|ends| ends.map(|end| 1e3 * end))
}

/// Runs count from the middle of what is unknown, here a rod of 120.2 mm, whatever the model says.
#[test]
fn analytic_a_proof_counts_from_where_the_runs_do() {
    let text = STUDY.replace(
        "\"parameter.rod_length\" = { normal = { mean = \"120 mm\", standard_deviation = \"0.03 mm\" } }\n[epistemic]\n",
        "[epistemic]\n\"parameter.rod_length\" = { interval = [\"119.9 mm\", \"120.5 mm\"] }\n",
    );
    let result = run(&study(&text)).result;
    let at_pose = proven_mm(&result, "slider", |at| matches!(at, ResponsePoint::Pose { .. })).expect("a proof");
    let x = |crank: f64, rod: f64| (rod * rod - crank * crank).sqrt();
    let down = x(CRANK, 120.2) - x(CRANK + CRANK_OFF, 119.9 - PLAY);
    let up = x(CRANK - CRANK_OFF, 120.5 + PLAY) - x(CRANK, 120.2);
    for (proven, due) in [(-at_pose[0], down), (at_pose[1], up)] {
        assert!(due <= proven && proven <= due + HALF_A_STEP_MM, "{proven} {due}");
    }
}

#[test]
fn analytic_treatments_are_held_against_what_motion_proves() {
    let result = run(&study(STUDY)).result;
    let at_pose = proven_mm(&result, "slider", |at| matches!(at, ResponsePoint::Pose { .. })).expect("a proof");
    let reduced = |reduction| move |at| at == ResponsePoint::Reduced { reduction };
    let largest = proven_mm(&result, "slider", reduced(Reduction::MaximumAbsolute)).expect("a proof");
    let range = proven_mm(&result, "slider", reduced(Reduction::Range)).expect("a proof");
    // A velocity is no position.
    assert_eq!(proven_mm(&result, "slider_velocity", reduced(Reduction::MaximumAbsolute)), None);
    // x = √(l² - r²) at 90°: farthest down with the pin drawn along the rod, the rod short and the crank long.
    let x = |crank: f64, rod: f64| (rod * rod - crank * crank).sqrt();
    let down = x(CRANK, ROD) - x(CRANK + CRANK_OFF, ROD - ROD_OFF - PLAY);
    let up = x(CRANK - CRANK_OFF, ROD + ROD_OFF + PLAY) - x(CRANK, ROD);
    for (proven, due) in [(-at_pose[0], down), (at_pose[1], up)] {
        assert!(due <= proven && proven <= due + HALF_A_STEP_MM, "{proven} {due}");
    }
    let file = InputFile::Study(Box::new(study(&format!("{STUDY}{REQUIRED}"))));
    let motion = file.motion_answer(&[], &[], &AtomicBool::new(false)).expect("a motion");
    let [of_pose, of_cycle] = [0, 1].map(|place| motion.requirements[place].proven_si.map(|end| 1e3 * end));
    assert_eq!(at_pose, of_pose);
    assert_eq!(largest, [0.0, of_cycle[1].max(-of_cycle[0])]);
    assert!((range[1] - (of_cycle[1] - of_cycle[0])).abs() < 1e-12 && range[0] == 0.0, "{range:?} {of_cycle:?}");
}

/// Requirements of a study of `model` without dynamics.
fn judged(model: &str, study: &str) -> Vec<loosepin::accuracy::record::MotionRequirement> {
    let model = Model::from_text("model.toml", model).expect("a model");
    let study = Study::from_text("study.toml", study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let file = InputFile::Study(Box::new(study));
    file.motion_answer(&[], &[], &AtomicBool::new(false)).expect("a motion").requirements
}

/// The slider-crank is the same upside down: at 63.7 degrees of a crank that turns backwards it is where it is at -63.7 degrees of another.
#[test]
fn identity_a_drive_that_runs_backwards_is_judged_like_one_that_runs_forwards() {
    let required = REQUIRED.replace("\"90 deg\"", "\"63.7 deg\"");
    let backwards = MODEL.replace("speed = \"5000 rpm\"", "speed = \"-5000 rpm\"");
    assert_ne!(backwards, MODEL);
    let [forward, backward] = [MODEL, &backwards].map(|model| judged(model, &format!("{STUDY}{required}")));
    for (forward, backward) in forward.iter().zip(&backward) {
        assert_eq!(forward.verdict, backward.verdict);
        for side in 0..2 {
            let apart_m = (forward.proven_si[side] - backward.proven_si[side]).abs();
            assert!(apart_m < 1e-9, "{forward:?} {backward:?}");
        }
    }
}

/// r = 50 mm, l from 49.9 to 51.1 mm: where the rod is the shorter one the loops do not close near 90 degrees. The slider is at 200 mm and more
/// all the same; that nothing can be computed there is no position of 0.
#[test]
fn analytic_a_position_that_cannot_be_computed_is_no_position() {
    let model = include_str!("../../../loosepin-simulate/tests/files/mend/dead_centre.toml")
        .replace(
            "[body.ground]\npoints = { o = [\"0 mm\", \"0 mm\"] }",
            "[parameter]\nrod = \"50.5 mm\"\n[body.ground]\npoints = { o = [\"200 mm\", \"0 mm\"] }",
        )
        .replace("small_end = [\"50.5 mm\"", "small_end = [\"rod\"")
        .replace("radial_clearance = \"0.6 mm\"", "radial_clearance = \"0.05 mm\"");
    let study = "name = \"far\"\nmodel = \"model.toml\"\n[epistemic]\n\"parameter.rod\" = { interval = [\"49.9 mm\", \"51.1 mm\"] }\n\
                 [[require]]\noutput = \"slider\"\nof = \"value\"\nabove = \"100 mm\"\nover = \"cycle\"\nprobability_at_least = 0.9\n";
    let [judged] = &judged(&model, study)[..] else { panic!("one requirement") };
    assert_eq!(judged.verdict, loosepin::accuracy::record::MotionVerdict::Undecided, "{judged:?}");
    // In its other assembly, or with the crank across, the slider is at 200 mm at least.
    assert!(judged.found_si[0] > 0.19, "{judged:?}");
}
