//! Two studies compared: what is asserted here is put in by hand, so that every number is known beforehand.

use loosepin::report::{Comparison, InputPlace, Weight, compare_studies};
use loosepin::result::repeat::InputRole;
use loosepin::study::result::{Deviation, Reading, StudyResult, Verdict};
use loosepin::units::SiUnit;

use super::report_fixture::study::worn_pin;

fn changed(change: impl FnOnce(&mut StudyResult)) -> Comparison {
    let before = worn_pin();
    let mut after = worn_pin();
    change(&mut after);
    compare_studies(&before, &after)
}

#[test]
fn analytic_a_study_does_not_differ_from_itself() {
    let found = changed(|_| ());
    assert!(found.headline.ends_with("There is no difference."), "{}", found.headline);
    assert_eq!(found.warnings, ["Both studies have the same inputs."]);
    assert!(found.left_out.is_empty() && found.inputs.is_empty(), "{:?} {:?}", found.left_out, found.inputs);
    // Every bound of the fixture that is no point of a curve, with both ends.
    assert_eq!(found.statistics.len(), 6);
    for end in found.statistics.iter().flat_map(|row| &row.ends) {
        assert_eq!((end.difference_si, end.weight), (0.0, Weight::None), "{end:?}");
        assert_eq!(end.values[0], end.values[1]);
    }
    assert_eq!(found.requirements.len(), worn_pin().requirements.len());
    assert!(found.requirements.iter().all(|row| row.verdicts[0] == row.verdicts[1] && row.verdicts[0].is_some()));
}

#[test]
fn analytic_differences_are_held_against_both_errors() {
    // The mean has an error of 1.1 µm in each study, in two parts: together 2.2 µm.
    let moved = |by_m: f64| {
        let found = changed(|after| {
            after.bounds[1].upper.value_si += by_m;
            after.bounds[1].upper.widened_si += by_m;
        });
        found.statistics[1].ends[1].clone()
    };
    let within = moved(2.1e-6);
    assert_eq!(within.weight, Weight::WithinErrors);
    assert!((within.difference_si - 2.1e-6).abs() < 1e-18 && within.difference == "+0.0021\u{a0}mm", "{within:?}");
    let beyond = moved(-2.3e-6);
    assert_eq!((beyond.weight, beyond.difference.as_str()), (Weight::BeyondErrors, "−0.0023\u{a0}mm"));
    // A probability differs by points, not by a length.
    let found = changed(|after| after.bounds[3].lower.value_si -= 0.05);
    let points = &found.statistics[3].ends[0];
    assert_eq!((points.difference.as_str(), points.weight), ("−5.0 percentage points", Weight::BeyondErrors));
    let unknown = changed(|after| after.bounds[1].upper.value_si = f64::NAN).statistics[1].ends[1].clone();
    assert_eq!(unknown.weight, Weight::WithinErrors, "nothing is said of what is not known");
}

#[test]
fn analytic_the_headline_has_the_change_of_the_largest_deviation() {
    let half = changed(|after| {
        let upper = &mut after.bounds[0].upper;
        upper.value_si *= 0.5;
        upper.widened_si *= 0.5;
    });
    assert!(half.headline.ends_with("The bound of B is 50\u{a0}% smaller."), "{}", half.headline);
    let larger = changed(|after| {
        let upper = &mut after.bounds[0].upper;
        upper.value_si *= 1.25;
        upper.widened_si *= 1.25;
    });
    assert!(larger.headline.ends_with("The bound of B is 25\u{a0}% larger."), "{}", larger.headline);
    let doubled = changed(|after| {
        let upper = &mut after.bounds[0].upper;
        upper.value_si *= 2.5;
        upper.widened_si *= 2.5;
    });
    assert!(doubled.headline.ends_with("The bound of B is 2.5 times as large."), "{}", doubled.headline);
}

/// The headline where the main bound of A has the value 1 mm and of B `found_mm`, with these errors.
fn headline_of(found_mm: f64, errors_mm: [f64; 2], change: impl Fn(&mut [StudyResult; 2])) -> String {
    let mut pair = [worn_pin(), worn_pin()];
    for (result, (value_mm, error_mm)) in pair.iter_mut().zip([(1.0, errors_mm[0]), (found_mm, errors_mm[1])]) {
        let upper = &mut result.bounds[0].upper;
        upper.value_si = 1e-3 * value_mm;
        upper.widened_si = 1e-3 * (value_mm + error_mm);
        (upper.error.sampling_si, upper.error.optimisation_si, upper.error.surrogate_si) = (1e-3 * error_mm, 0.0, 0.0);
    }
    change(&mut pair);
    compare_studies(&pair[0], &pair[1]).headline
}

#[test]
fn analytic_the_headline_counts_each_error_once() {
    let same = |_: &mut [StudyResult; 2]| ();
    // 1 mm ± 0.01 mm against 1.3 mm ± 0.2 mm: they do not touch. Bounds of 1.01 and 1.5 mm.
    let apart = headline_of(1.3, [0.01, 0.2], same);
    assert!(apart.contains("±1.01\u{a0}mm in A, ±1.5\u{a0}mm in B. The bound of B is 48.5\u{a0}% larger."), "{apart}");
    // 1 mm ± 0.01 mm against 1.1 mm ± 0.2 mm: bounds of 1.01 and 1.3 mm, whose difference of 0.29 mm is more than both errors together.
    let touching = headline_of(1.1, [0.01, 0.2], same);
    let errors = "This difference may be numerical: the errors are 0.01\u{a0}mm in A, 0.2\u{a0}mm in B.";
    assert!(touching.ends_with(errors), "{touching}");
    // The larger bound has the smaller error: 1.2 mm ± 0.01 mm against 1 mm ± 0.15 mm. Bounds differ by less than both errors.
    let exact = headline_of(1.2, [0.15, 0.01], same);
    assert!(exact.contains("The bound of B is 5.2"), "{exact}");
    let unknown = headline_of(1.1, [0.01, f64::INFINITY], same);
    assert!(unknown.contains("This difference may be numerical"), "{unknown}");
}

/// The headline where the first requirement, which is the only one, has these verdicts and these bounds of the share inside.
fn headline_of_verdicts(verdicts: [Verdict; 2], shares: [[f64; 2]; 2], change: impl Fn(&mut StudyResult)) -> String {
    headline_of(1.1, [0.01, 0.2], |pair| {
        for (result, (verdict, share)) in pair.iter_mut().zip(verdicts.into_iter().zip(shares)) {
            result.requirements.truncate(1);
            let requirement = &mut result.requirements[0];
            (requirement.verdict, requirement.probability) = (verdict, share);
            (requirement.lower_si, requirement.upper_si, requirement.probability_at_least) = (-0.7e-3, 0.7e-3, 0.9);
        }
        change(&mut pair[1]);
    })
}

#[test]
fn the_headline_begins_with_the_requirement_whose_verdict_differs_and_its_shares() {
    let shares = [[0.93, 0.97], [0.31, 0.42]];
    let decided = headline_of_verdicts([Verdict::Met, Verdict::NotMet], shares, |_| ());
    let due = "Deviation of slider over the whole cycle: met in A, not met in B. Required: within ±0.7\u{a0}mm in at least \
               90\u{a0}%; shares inside: 93\u{a0}% to 97\u{a0}% in A, 31\u{a0}% to 42\u{a0}% in B; they differ by more than their errors. \
               The largest deviation";
    assert!(decided.starts_with(due), "{decided}");
    // Other limits, and a verdict that is open, say nothing of the errors.
    let looser = headline_of_verdicts([Verdict::NotMet, Verdict::Met], shares, |after| {
        (after.requirements[0].lower_si, after.requirements[0].upper_si) = (-1.4e-3, 1.4e-3);
    });
    assert!(
        looser.contains(
            "Required: within ±0.7\u{a0}mm in at least 90\u{a0}% in A, within ±1.4\u{a0}mm in at least 90\u{a0}% in B;"
        ),
        "{looser}"
    );
    let open = headline_of_verdicts([Verdict::Undecided, Verdict::NotMet], [[0.8, 0.95], shares[1]], |_| ());
    assert!(open.contains(": undecided in A, not met in B."), "{open}");
    for headline in [looser, open] {
        assert!(!headline.contains("more than their errors") && headline.ends_with("mm in B."), "{headline}");
    }
    let same = headline_of_verdicts([Verdict::Met, Verdict::Met], shares, |_| ());
    assert!(!same.contains("Required"), "{same}");
}

#[test]
fn verdicts_that_differ_are_in_the_headline_of_studies_without_a_bound_in_common() {
    let headline = headline_of_verdicts([Verdict::Met, Verdict::NotMet], [[0.93, 0.97], [0.31, 0.42]], |after| {
        after.bounds.clear();
        after.curves.clear();
    });
    assert!(headline.starts_with("Deviation of slider over the whole cycle: met in A, not met in B."), "{headline}");
    assert!(headline.ends_with("they differ by more than their errors."), "{headline}");
}

#[test]
fn the_headline_counts_the_requirements_that_it_does_not_name() {
    let mut pair = [worn_pin(), worn_pin()];
    for (result, verdict) in pair.iter_mut().zip([Verdict::Met, Verdict::NotMet]) {
        let own = result.requirements[0].clone();
        result.requirements = [0.4e-3, 0.5e-3, 0.6e-3]
            .map(|limit_m| {
                let mut requirement = own.clone();
                (requirement.lower_si, requirement.upper_si, requirement.verdict) = (-limit_m, limit_m, verdict);
                requirement
            })
            .into();
    }
    let headline = compare_studies(&pair[0], &pair[1]).headline;
    assert!(headline.starts_with("Requirements: met in A, not met in B. Deviation of slider"), "{headline}");
    assert!(
        headline.contains("±0.4") && headline.contains("±0.5") && !headline.contains("±0.6\u{a0}mm in at"),
        "{headline}"
    );
    assert!(headline.contains(" 1 more requirement has another verdict."), "{headline}");
}

#[test]
fn the_limit_of_a_study_is_rounded_as_its_own_sentence_has_it() {
    let found = changed(|after| after.bounds[0].upper.widened_si *= 1.5);
    let limit = |text: &str| {
        let rest = text.split('±').nth(1).expect("a limit");
        rest.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect::<String>()
    };
    assert_eq!(limit(&found.headline), limit(&found.sides[0].words.join(" ")), "{found:?}");
}

#[test]
fn what_does_not_mean_the_same_is_left_out_and_named() {
    let renamed = changed(|after| after.outputs[0].words = "x of rod.big_end".to_owned());
    assert!(renamed.statistics.is_empty() && renamed.bands.is_empty());
    assert!(
        renamed.left_out[0].contains("x of slider.pin [m] in A, x of rod.big_end [m] in B"),
        "{:?}",
        renamed.left_out
    );
    assert_eq!(renamed.headline, "The two studies have no answer in common.");
    let other_unit = changed(|after| after.outputs[0].unit = SiUnit::ANGLE);
    assert!(
        other_unit.statistics.is_empty() && other_unit.left_out[0].contains("[rad] in B"),
        "{:?}",
        other_unit.left_out
    );
    let read = changed(|after| after.bounds[2].reading = Reading::RandomSet);
    assert_eq!(read.statistics.len(), 5);
    assert!(read.left_out[0].contains("is not compared: intervals are"), "{:?}", read.left_out);
    let drive = changed(|after| after.cycle.drive = "motor".to_owned());
    assert!(
        drive.bands.is_empty() && drive.left_out[0].contains("another drive: crank in A, motor in B"),
        "{:?}",
        drive.left_out
    );
    assert_eq!(drive.statistics.len(), 6, "numbers over the cycle are compared, with a warning");
    assert!(drive.warnings.iter().any(|words| words == "Other cycle, drive: crank in A, motor in B."));
    let other = changed(|after| after.curves[0].of = Deviation::Clearance);
    assert_eq!(other.left_out.len(), 2, "{:?}", other.left_out);
    let many = changed(|after| {
        (after.seed, after.cycle.recorded_turns, after.counts.inner) = (7, 3.0, 512);
    });
    for words in [
        "Other seed: 1 in A, 7 in B.",
        "Other cycle, recorded turns: 1 in A, 3 in B.",
        "Other sampling: 64 × 256 runs in A, 64 × 512 runs in B.",
    ] {
        assert!(many.warnings.iter().any(|own| own == words), "{words}: {:?}", many.warnings);
    }
}

#[test]
fn inputs_are_told_in_words_and_units() {
    let found = changed(|after| {
        after.inputs[2].words = "anywhere between 0.1 mm and 0.15 mm".to_owned();
        after.inputs.remove(1);
        for file in &mut after.repeat.files {
            file.text = match file.role {
                InputRole::Study => "name = \"worn pin\"\n[sampling]\ninner = 512\n".to_owned(),
                InputRole::Model => "name = \"slider-crank\"\n[parameter]\nrod_length = \"120 mm\"\n".to_owned(),
                _ => format!("{}\n120.02\n", file.text),
            };
        }
        after.repeat.command += " --accuracy 0.01";
    });
    let told: Vec<(InputPlace, &str, Option<&str>, Option<&str>)> = found
        .inputs
        .iter()
        .map(|input| (input.place, input.path.as_str(), input.before.as_deref(), input.after.as_deref()))
        .collect();
    assert_eq!(
        told,
        [
            (
                InputPlace::Uncertain,
                "parameter.rod_length",
                Some("normal, mean 120 mm, standard deviation 0.03 mm"),
                Some("exactly 120 mm")
            ),
            (
                InputPlace::Uncertain,
                "joint.gudgeon.radial_clearance",
                Some("anywhere between 0.1 mm and 0.5 mm"),
                Some("anywhere between 0.1 mm and 0.15 mm")
            ),
            (InputPlace::Model, "parameter.rod_length", None, Some("120 mm")),
            (InputPlace::Study, "sampling.inner", None, Some("512")),
            (InputPlace::Table, "parts/rod.csv", Some("4 lines"), Some("5 lines")),
            (InputPlace::Command, "command", None, Some("--accuracy 0.01")),
        ]
    );
    assert_eq!(found.inputs[1].words, "joint 'gudgeon': radial clearance");
    // A result of an older version has kept no files.
    let old = changed(|after| after.repeat = Default::default());
    assert!(old.left_out.iter().any(|words| words.contains("older version")), "{:?}", old.left_out);
    // A text of today is not that of then.
    let broken = changed(|after| after.repeat.files[0].text = "name = ".to_owned());
    assert!(broken.left_out.iter().any(|words| words.contains("can no longer be read")), "{:?}", broken.left_out);
}

#[test]
fn requirements_stand_beside_each_other_with_their_own_limits() {
    let found = changed(|after| {
        after.requirements[0].upper_si *= 2.0;
        after.requirements[0].lower_si *= 2.0;
        after.requirements[0].verdict = Verdict::Undecided;
        after.requirements.truncate(1);
    });
    let rows = &found.requirements;
    assert_eq!(rows.len(), worn_pin().requirements.len());
    assert_eq!(rows[0].verdicts[1], Some(Verdict::Undecided));
    assert_ne!(rows[0].required[0], rows[0].required[1]);
    for row in &rows[1..] {
        assert!(row.verdicts[0].is_some() && row.verdicts[1].is_none() && row.required[1].is_none());
    }
}
