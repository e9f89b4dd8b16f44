//! From the answer to the input: the narrowed study, and the reading that is named next.

use super::{answer, case, known, study, text_of};
use loosepin_identify::record::{ConsistentPlays, Outcome};
use loosepin_identify::{NO_CALLBACK, Options, identify, narrowed, write_narrowed};
use loosepin_study::Study;

fn consistent(study: &Study) -> ConsistentPlays {
    known(&answer(study)).clone()
}

#[test]
fn identity_a_narrowed_study_differs_in_its_ends_alone() {
    let (model, before) = (text_of("model.toml"), text_of("study.toml"));
    let study_before = study(&model, &before);
    let known = consistent(&study_before);
    let (after, changes) = narrowed(&study_before, &known.plays);
    assert_eq!(changes.len(), 3);
    for (old, new) in before.lines().zip(after.lines()) {
        let is_end = old.contains("radial_clearance");
        assert!(is_end || old == new, "{old} | {new}");
        if is_end {
            let comment = |line: &str| line.split_once('#').map(|(_, comment)| comment.to_owned());
            assert_eq!(comment(old), comment(new));
        }
    }
    let read = study(&model, &after);
    for (play, input) in known.plays.iter().zip(&read.epistemic) {
        let [low, high] = input.variable.ends();
        assert!(low <= play.after_si[0] && play.after_si[1] <= high, "rounded outwards: {low} {high} {play:?}");
        let slack = 1e-5 * play.after_si[1];
        assert!(
            play.after_si[0] - low < slack && high - play.after_si[1] < slack,
            "and not far: {low} {high} {play:?}"
        );
    }
    // The same readings narrow it no further than rounding gave way.
    let again = consistent(&read);
    for (play, first) in again.plays.iter().zip(&known.plays) {
        assert!((play.after_si[0] - first.after_si[0]).abs() < 1e-5 * first.after_si[1], "{play:?} {first:?}");
    }
}

#[test]
fn analytic_ends_that_the_readings_do_not_prove_stay_as_written() {
    let (model, before) = (text_of("model.toml"), text_of("first.toml"));
    let first = study(&model, &before);
    let known = consistent(&first);
    assert!(known.plays.iter().all(|play| !play.is_identifiable));
    let (after, changes) = narrowed(&first, &known.plays);
    // The sum proves an upper end for each, and no lower one.
    assert_eq!(changes.len(), 3);
    for change in &changes {
        assert_eq!(change.before[0], "0.01 mm");
        assert_eq!(change.after[0], "0.01 mm");
        assert!(change.after[1].starts_with("0.20"), "{change:?}");
    }
    assert!(after.contains("interval = [\"0.01 mm\", \"0.20"));
    // Twice the play: every end stays.
    let wide = before.replace("[\"0.2060 deg\", \"0.2066 deg\", \"0.2064 deg\"]", "\"0.55 deg\"");
    let wide = study(&model, &wide);
    let (after, changes) = narrowed(&wide, &consistent(&wide).plays);
    assert!(changes.is_empty() && after == wide.source().text());
}

#[test]
fn nothing_is_overwritten_and_the_model_stays_beside() {
    let folder = tempfile::tempdir().expect("a folder");
    for file in ["model.toml", "first.toml"] {
        std::fs::copy(case().join(file), folder.path().join(file)).expect("a copy");
    }
    let first =
        Study::from_path(&folder.path().join("first.toml")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let target = folder.path().join("narrowed.toml");
    write_narrowed(&first, &[(&target, "a = 1\n")]).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let twice = write_narrowed(&first, &[(&target, "b = 1\n")]).expect_err("it is there").to_string();
    assert!(twice.contains("exists already; nothing is overwritten"), "{twice}");
    assert_eq!(std::fs::read_to_string(&target).expect("it is there"), "a = 1\n");
    let elsewhere = tempfile::tempdir().expect("a folder");
    let error =
        write_narrowed(&first, &[(&elsewhere.path().join("narrowed.toml"), "")]).expect_err("elsewhere").to_string();
    assert!(error.contains("the folder of the study; the path of its model is relative to this folder"), "{error}");
}

#[test]
fn identity_the_named_reading_tells_apart_what_one_reading_does_not() {
    let first = study(&text_of("model.toml"), &text_of("first.toml"));
    let answer =
        identify(&first, &Options::default(), NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let Outcome::Consistent(known) = &answer.specimens[0].outcome else { panic!("it fits") };
    assert_eq!(known.alike, [[0, 1, 2]]);
    let further = known.further.as_ref().expect("there is a better place");
    assert!(further.candidates > 1000);
    let spread = further.factors.iter().fold(0.0_f64, |s, f| s.max((f - further.factors[0]).abs()));
    assert!(spread > 0.1 * further.factors[0].abs(), "it does not weigh all alike: {:?}", further.factors);
    let now: f64 = known.plays.iter().map(|play| play.after_si[1] - play.after_si[0]).sum();
    assert!(further.widths_si.iter().sum::<f64>() < 0.95 * now, "{:?}", further.widths_si);
}
