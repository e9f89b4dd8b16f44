//! Turns after the recorded ones: what a study says of them, against the same runs with more turns recorded.

use crate::silent::run_on;
use loosepin::model::Model;
use loosepin::study::result::{AnswerPart, Reduction};
use loosepin::study::{RunData, RunsTable};
use loosepin::study::{RunRows, Study, StudyRun, plan_runs};
use loosepin::templates::find_template;

/// Largest magnitude that is allowed, m: some of the runs reach it in six turns and not in one.
const LIMIT_M: f64 = 0.6e-3;

/// The slider-crank with play, which never repeats itself, recorded for so many turns.
fn study(turns: u32, play: &str) -> Study {
    let limit = format!("{} mm", 1e3 * LIMIT_M);
    let text = format!(
        "name = \"few runs\"\nmodel = \"model.toml\"\nseed = 4\n[cycle]\ntransient_turns = 1\nrecorded_turns = {turns}\n[sampling]\ninner = 8\nreplicates = 2\n\
         [random]\n\"parameter.rod_length\" = {{ normal = {{ standard_deviation = \"0.03 mm\" }} }}\n\
         [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n\
         [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"minimum\"\nstatistics = [\"mean\"]\n\
         [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n\
         [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"{limit}\"\nposes = {{ crank = [\"40 deg\", \"90 deg\"] }}\nprobability_at_least = 0.5\n\
         [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"{limit}\"\nover = \"cycle\"\nprobability_at_least = 0.5\n"
    );
    let template = find_template("slider-crank").expect("the template");
    let model = template.model.replace("radial_clearance = \"0.5 mm\"", &format!("radial_clearance = \"{play}\""));
    let model = Model::from_text("model.toml", &model).expect("a model");
    Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// [`study`] with one turn and this table after it.
fn with_table(table: &str) -> Result<Study, String> {
    with_table_and_play(table, "0.5 mm")
}

fn with_table_and_play(table: &str, play: &str) -> Result<Study, String> {
    let one = study(1, play);
    let text = format!("{}[further_turns]\n{table}\n", one.source().text());
    Study::from_text("study.toml", &text, one.model).map_err(|diagnostics| diagnostics.to_string())
}

fn conducted(study: &Study) -> StudyRun {
    run_on(2, study).expect("a result")
}

/// The first column of `runs` whose name ends so.
fn column<'r>(runs: &'r RunsTable, end: &str) -> &'r [f64] {
    let column = runs.columns.iter().find(|column| column.name.ends_with(end));
    match column.map(|column| &column.data) {
        Some(RunData::F64(values)) => values,
        other => panic!("{end}: {other:?} in {:?}", runs.columns.iter().map(|column| &column.name).collect::<Vec<_>>()),
    }
}

#[test]
fn identity_later_turns_are_those_of_the_same_runs_with_more_of_them_recorded() {
    let short = conducted(&study(1, "0.5 mm"));
    let further = short.result.further_turns.as_ref().expect("turns after the recorded ones");
    let changes = column(&short.runs, "change_over_last_turn");
    assert!(changes.iter().all(|change| *change > 1e-6), "{changes:?}");
    // The middle of each eighth of the runs, made anew by themselves.
    let chosen: Vec<usize> = (0..8).map(|k| (2 * k + 1) * changes.len() / 16).collect();
    assert_eq!((further.turns, further.runs), (5, 8));
    let rod_m = column(&short.runs, "rod_length");
    let long = RunRows::new(study(6, "0.5 mm"), 1).expect("runs");
    let rows = long.make(&[], chosen.iter().map(|&run| [vec![rod_m[run]], Vec::new()])).expect("rows");
    let own_column = |place: usize| long.asked_columns().expect("columns")[place][0];
    for (place, reduction, sign) in [(0, Reduction::Maximum, 1.0), (1, Reduction::Minimum, -1.0)] {
        let one = column(&short.runs, &format!(" {}", reduction.word()));
        let six = rows.iter().map(|row| row.as_ref().expect("a finished run")[own_column(place)]);
        let excess: Vec<f64> = chosen.iter().zip(six).map(|(&run, six)| sign * (six - one[run])).collect();
        assert!(excess.iter().all(|excess| *excess > -1e-8), "{excess:?}");
        let told = further.outputs.iter().find(|one| one.reduction == reduction).expect("an extreme");
        let mean = excess.iter().sum::<f64>() / excess.len() as f64;
        let largest = excess.iter().copied().fold(0.0, f64::max);
        assert!(largest > 1e-5, "{excess:?}");
        assert!((told.mean_excess_si - mean).abs() < 1e-8, "{mean} {told:?}");
        assert!((told.largest_excess_si - largest).abs() < 1e-8, "{largest} {told:?}");
    }
    // The magnitude of six turns follows from both extremes.
    let one = column(&short.runs, " maximum_absolute");
    let broken = chosen.iter().zip(&rows).filter(|(run, row)| {
        let row = row.as_ref().expect("a finished run");
        one[**run] <= LIMIT_M && row[own_column(0)].max(-row[own_column(1)]) > LIMIT_M
    });
    let broken = broken.count() as u64;
    // A requirement at two angles has two outcomes, which later turns do not change.
    assert_eq!(further.broken_later, [None, None, Some(broken)]);
    assert_eq!(further.broken_later.len(), short.result.requirements.len());
    assert!(broken > 0 && broken < further.runs, "{broken}");
}

#[test]
fn nothing_is_told_where_every_motion_repeats_itself() {
    let result = conducted(&study(1, "0 mm")).result;
    assert_eq!((result.further_turns, result.answers), (None, Vec::new()));
}

#[test]
fn whoever_states_further_turns_is_told_why_there_are_none() {
    let result = conducted(&with_table_and_play("count = 3", "0 mm").expect("a study")).result;
    assert_eq!(result.further_turns, None);
    let [answer] = &result.answers[..] else { panic!("{:?}", result.answers) };
    assert_eq!(answer.question, "further_turns");
    let reason = AnswerPart::from("Every motion repeats itself: further turns change nothing.");
    assert_eq!(answer.sentences, [[reason]]);
}

#[test]
fn a_study_states_how_many_runs_go_on_and_how_far() {
    let further = |table: &str| conducted(&with_table(table).expect("a study")).result.further_turns.expect("turns");
    let fewer = further("count = 2\nruns = 3");
    assert_eq!((fewer.turns, fewer.runs), (2, 3));
    // Two of the five turns cannot exceed the recorded one by more than all five.
    let five = further("runs = 3");
    assert_eq!((five.turns, five.runs), (5, 3));
    for (two, five) in fewer.outputs.iter().zip(&five.outputs) {
        assert!(two.largest_excess_si <= five.largest_excess_si, "{two:?} {five:?}");
    }
    assert!(five.outputs.iter().any(|output| output.largest_excess_si > 0.0));
    let wrong = with_table("count = 0").expect_err("no turn at all");
    assert!(wrong.contains("further turns count is 0; must be a whole number from 1"), "{wrong}");
    let mut many = with_table("count = 999").expect("a study");
    assert!(plan_runs(&many).is_ok());
    many.cycle.recorded_turns = 2.0;
    let refused = plan_runs(&many).expect_err("1001 recorded turns").diagnostic(&many).to_string();
    assert!(refused.contains("1001 turns are recorded; must be at most 1000"), "{refused}");
    let line = many.source().text().lines().position(|line| line.starts_with("count")).expect("a line") + 1;
    assert!(refused.contains(&format!("study.toml:{line}:")), "{refused}");
}
