//! Readings that no play explains, and what cannot be computed.

use super::{answer, known, misfit, study, text_of};
use loosepin_identify::{IdentifyProblem, NO_CALLBACK, Options, identify};

#[test]
fn analytic_a_reading_beyond_the_intervals_is_told_by_itself() {
    // The rocker alone, 1 degree where the intervals allow 0.84.
    let text = text_of("first.toml").replace("[\"0.2060 deg\", \"0.2066 deg\", \"0.2064 deg\"]", "\"1 deg\"");
    let specimen = answer(&study(&text_of("model.toml"), &text));
    let misfit = misfit(&specimen);
    let [culprit] = misfit.culprits.as_slice() else { panic!("{misfit:?}") };
    assert!(culprit.is_alone && culprit.reading == 0);
    let apart = culprit.found_si[0] - culprit.expected_si[1];
    assert!((culprit.apart_si - apart).abs() < 1e-15 && apart > 0.002, "{culprit:?}");
    // The common error is part of what is expected: allowed without error, plus it.
    let allowed = specimen.readings[0].allowed_before_si[1] + specimen.readings[0].common_error_si;
    assert!((culprit.expected_si[1] - allowed).abs() < 1e-12, "{culprit:?}");
}

#[test]
fn analytic_one_wrong_reading_among_four_is_named() {
    let text = text_of("study.toml")
        .replace("[\"0.1501 mm\", \"0.1492 mm\", \"0.1493 mm\"]", "[\"0.0701 mm\", \"0.0692 mm\", \"0.0693 mm\"]");
    let specimen = answer(&study(&text_of("model.toml"), &text));
    let misfit = misfit(&specimen);
    let wrong = misfit.culprits.iter().find(|culprit| culprit.reading == 3).unwrap_or_else(|| panic!("{misfit:?}"));
    assert!(!wrong.is_alone && wrong.found_si[1] < wrong.expected_si[0]);
    assert!(misfit.error_factor.is_some_and(|factor| factor > 1.5), "{misfit:?}");
    assert!(misfit.strained.contains(&3), "{misfit:?}");
}

#[test]
fn identity_readings_of_other_specimens_do_not_count() {
    let model = text_of("model.toml");
    let one = text_of("study.toml");
    let alone = answer(&study(&model, &one));
    // The same readings, and a wrong one of another specimen.
    let mut named = one.replace("[[measured]]\n", "[[measured]]\nspecimen = \"A\"\n");
    named.push_str(
        "\n[[measured]]\nspecimen = \"B\"\noutput = \"ear\"\npose = { crank = \"60 deg\" }\nforce = \"15 N\"\n\
         dead_travel = \"0.4 mm\"\nerror = \"0.01 mm\"\n",
    );
    let options = Options { looks_further: false, specimen: Some("A".to_owned()), ..Options::default() };
    let both = study(&model, &named);
    let of_a = identify(&both, &options, NO_CALLBACK).unwrap_or_else(|complaints| panic!("{complaints}"));
    assert_eq!(of_a.specimens.len(), 1);
    assert_eq!(known(&of_a.specimens[0]).plays, known(&alone).plays);
    let all = identify(&both, &Options { specimen: None, ..options.clone() }, NO_CALLBACK)
        .unwrap_or_else(|complaints| panic!("{complaints}"));
    assert_eq!(all.specimens.len(), 2);
    let unknown = identify(&both, &Options { specimen: Some("C".to_owned()), ..options }, NO_CALLBACK)
        .expect_err("no such specimen");
    let problem =
        IdentifyProblem::UnknownSpecimen { name: "C".to_owned(), known: vec!["'A'".to_owned(), "'B'".to_owned()] };
    assert!(unknown.to_string().contains(&problem.to_string()), "{unknown}");
}

#[test]
fn refusals_say_what_is_missing() {
    let model = text_of("model.toml");
    let refused = |text: &str| {
        let error = identify(&study(&model, text), &Options::default(), NO_CALLBACK).expect_err("it is refused");
        error.to_string()
    };
    let text = text_of("first.toml");
    let without = &text[..text.find("[[measured]]").expect("a reading")];
    assert!(refused(without).contains("the study has no readings"), "{}", refused(without));
    let no_play = {
        let start = text.find("\"joint.").expect("plays");
        let end = text.find("\n[sampling]").expect("the end of the plays");
        format!("{}\"contact.bush.restitution\" = {{ interval = [0.7, 0.9] }}\n{}", &text[..start], &text[end..])
    };
    assert!(refused(&no_play).contains("no input of the study is the play of a joint"), "{}", refused(&no_play));
    // The crank is locked: nothing gives way to a push on it.
    let locked = text
        .replace("output = \"rocker\"\n", "output = \"rocker\"\nat = \"crank.pin\"\ndirection = \"0 deg\"\n")
        .replace("moment = \"1.5 N m\"", "force = \"15 N\"");
    assert!(refused(&locked).contains("this push moves no play"), "{}", refused(&locked));
}

#[test]
fn analytic_two_contradicting_pairs_are_told_as_pairs() {
    // The ear said twice and the tool said twice, each time with two travels that exclude each other: whichever reading is left out,
    // one pair is left.
    let text = text_of("first.toml");
    let head = &text[..text.find("# A reading of readings.py.").expect("the reading")];
    let reading = |name: &str, output: &str, travel: &str| {
        format!(
            "[[measured]]\nname = \"{name}\"\noutput = \"{output}\"\npose = {{ crank = \"60 deg\" }}\nforce = \"15 N\"\n\
             dead_travel = \"{travel}\"\nerror = \"0.003 mm\"\n\n"
        )
    };
    let tool = |name: &str, travel: &str| reading(name, "tool", travel).replace("pose =", "component = \"x\"\npose =");
    let all = [
        reading("ear small", "ear", "0.14 mm"),
        reading("ear large", "ear", "0.17 mm"),
        tool("tool small", "0.30 mm"),
        tool("tool large", "0.34 mm"),
    ];
    let specimen = answer(&study(&text_of("model.toml"), &format!("{head}{}", all.concat())));
    let found = misfit(&specimen);
    assert!(found.culprits.is_empty(), "{found:?}");
    assert_eq!(found.pairs, [[0, 1], [2, 3]]);
    // One of the pairs alone has culprits, and no pair is looked for.
    let specimen = answer(&study(&text_of("model.toml"), &format!("{head}{}", all[..3].concat())));
    let found = misfit(&specimen);
    assert!(found.culprits.iter().any(|culprit| culprit.reading < 2) && found.pairs.is_empty(), "{found:?}");
}
