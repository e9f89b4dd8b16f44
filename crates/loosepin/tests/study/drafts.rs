//! Bounds that a study tells before it is finished.

use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use loosepin::report::{draft_bands, draft_text};
use loosepin::study::files::{bounds_csv, runs_parquet};
use loosepin::study::result::{BoundRecord, Draft, ResponsePoint};
use loosepin::study::{Progress, RunOptions, Stage, Study, StudyRun, plan_runs, run_study};

/// Hears drafts, or nothing.
struct Listener {
    wants_drafts: bool,
    drafts: Mutex<Vec<Draft>>,
    /// Finished runs as they were told.
    finished: Mutex<Vec<usize>>,
    stages: Mutex<Vec<Stage>>,
}

impl Progress for Listener {
    fn runs(&self, finished: usize, _: usize) {
        self.finished.lock().expect("no panic").push(finished);
    }

    fn stage(&self, stage: Stage) {
        self.stages.lock().expect("no panic").push(stage);
    }

    fn wants_drafts(&self) -> bool {
        self.wants_drafts
    }

    fn draft(&self, draft: &Draft) {
        self.drafts.lock().expect("no panic").push(draft.clone());
    }
}

/// The worn pin in short runs: the largest deviation, a curve, and a requirement.
fn study() -> Study {
    let text = "name = \"watched\"\nmodel = \"model.toml\"\n\
        [cycle]\ntransient_turns = 0\nrecorded_turns = 0.25\nsamples_per_turn = 36\n\
        [sampling]\nouter = 12\ninner = 256\ntolerance = \"1e-6 m\"\n\
        [random]\n\"parameter.crank_length\" = { normal = { mean = \"50 mm\", standard_deviation = \"0.02 mm\" } }\n\
        [epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n\
        [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum_absolute\"\n\
        statistics = [\"mean\", { quantile = 0.9 }]\n\
        [[ask]]\noutput = \"slider\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n\
        [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"5 mm\"\nover = \"cycle\"\n\
        probability_at_least = 0.75\n";
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/slider_crank_worn_pin/study.toml");
    Study::from_text_at(folder, text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn run(study: &Study, wants_drafts: bool, threads: usize) -> (StudyRun, Vec<Draft>) {
    let (drafts, finished, stages) = Default::default();
    let listener = Listener { wants_drafts, drafts, finished, stages };
    let stop = AtomicBool::new(false);
    let conducted =
        run_study(study, "", &RunOptions::new(threads, &listener, &stop)).unwrap_or_else(|error| panic!("{error}"));
    // Threads tell of their runs in any order, each of 64.
    let finished = listener.finished.into_inner().expect("no panic");
    assert!(finished.windows(2).all(|pair| pair[1] + 64 * threads >= pair[0]), "{finished:?}");
    // Every round is planned before it is run, and the bounds are planned last.
    let stages = listener.stages.into_inner().expect("no panic");
    let (rounds, end) = stages.split_at(2 * conducted.result.counts.rounds as usize);
    assert!(rounds.chunks(2).all(|pair| pair == [Stage::Planning, Stage::Runs]), "{stages:?}");
    let assembling = [Stage::Assembling, Stage::Pictures, Stage::Assembling, Stage::Finished];
    let planning = end.len() - assembling.len();
    assert!(end[..planning].iter().all(|stage| *stage == Stage::Planning), "{stages:?}");
    assert_eq!(end[planning..], assembling);
    (conducted, listener.drafts.into_inner().expect("no panic"))
}

/// Bounds and runs as they are written.
fn bytes(conducted: &StudyRun) -> (Vec<u8>, Vec<u8>) {
    let bounds = bounds_csv(&conducted.result).unwrap_or_else(|error| panic!("{error}"));
    (bounds, runs_parquet(&conducted.runs).unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn identity_a_study_that_tells_drafts_has_the_bytes_of_one_that_does_not() {
    let study = study();
    let (alone, nothing) = run(&study, false, 2);
    assert!(nothing.is_empty());
    let (watched, drafts) = run(&study, true, 1);
    assert!(bytes(&watched) == bytes(&alone), "a draft changes the result");
    let [first, .., last] = &drafts[..] else { panic!("{} drafts", drafts.len()) };
    let most = plan_runs(&study).unwrap_or_else(|error| panic!("{error}"));
    assert!(first.runs * 4 <= most, "{} of {most} runs for the first draft", first.runs);
    assert!(drafts.windows(2).all(|pair| pair[0].runs < pair[1].runs));

    // The last draft comes from all runs of the bounds, and is what the study says in the end.
    let is_reduced = |bound: &&BoundRecord| matches!(bound.at, ResponsePoint::Reduced { .. });
    let bounds: Vec<&BoundRecord> = watched.result.bounds.iter().filter(is_reduced).collect();
    assert_eq!(last.bounds.iter().collect::<Vec<_>>(), bounds);
    assert_eq!(last.requirements, watched.result.requirements);
    // The band of the page is that of all runs, widened by its error.
    let band = &watched.result.curves[0].mixed;
    let so_far = &last.curves[0].band;
    assert_eq!(so_far.lower_si.len(), band.lower_si.len());
    for (own, whole) in so_far.lower_si.iter().zip(&band.lower_si) {
        assert!(own >= whole, "{own} {whole}");
    }
    for (own, whole) in so_far.upper_si.iter().zip(&band.upper_si) {
        assert!(own <= whole, "{own} {whole}");
    }
    for draft in &drafts {
        assert!(draft_text(draft).starts_with("so far: slider within ±"), "{}", draft_text(draft));
        // Each picture has the poses of a quarter turn, and says how many runs it is of.
        let bands = draft_bands(draft);
        let [curve] = &draft.curves[..] else { panic!("{} curves", draft.curves.len()) };
        assert_eq!((curve.pose_rad.len(), bands.len()), (10, 1));
        assert!(curve.unknown_values >= 3 && bands[0].figure.contains("runs so far"), "{}", bands[0].words);
        // Each is a bound of what the last one has attained.
        for (early, late) in draft.bounds.iter().zip(&last.bounds) {
            assert!(early.upper.widened_si >= late.upper.value_si, "{} runs: {early:?} {late:?}", draft.runs);
            assert!(early.lower.widened_si <= late.lower.value_si, "{} runs: {early:?} {late:?}", draft.runs);
        }
    }
}
