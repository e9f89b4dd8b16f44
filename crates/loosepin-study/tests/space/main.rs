//! Studies of models in space that are refused: each at its place, in the words of space. Models without `geometry`, paths of tilts.

use loosepin_space::SpatialModel;
use loosepin_study::{Progress, RunOptions, Study, StudyModel, StudyRun, estimate_cost, run_study};
use loosepin_text::diagnostics::{Code, Diagnostic, Diagnostics, Source};
use std::sync::atomic::AtomicBool;

const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");
const INPUTS: &str = "[epistemic]\n\"joint.ball.radial_clearance\" = { interval = [\"0.15 mm\", \"0.25 mm\"] }\n";
const ASK: &str =
    "[[ask]]\noutput = \"rocker\"\nof = \"total\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\"]\n";

struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
}

fn model(edits: &[(&str, &str)]) -> SpatialModel {
    let edited = edits.iter().fold(FOUR_BAR.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    SpatialModel::from_text("model.toml", &edited).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn read(edits: &[(&str, &str)], rest: &str) -> Result<Study, Diagnostics> {
    let text = format!("name = \"s\"\nmodel = \"model.toml\"\n{rest}");
    Study::from_text("study.toml", &text, model(edits))
}

/// What reading a study of the four-bar says first.
fn refused(rest: &str) -> Diagnostic {
    let found = read(&[], rest).expect_err("refused");
    found.sorted()[0].clone()
}

/// What preparing a study of an edited four-bar says, as `check` shows it.
fn not_prepared(edits: &[(&str, &str)]) -> Diagnostic {
    let study = read(edits, &format!("{INPUTS}{ASK}")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    estimate_cost(&study).expect_err("no motion").diagnostic(&study)
}

/// Name of the file and text of the line of a place.
fn place(found: &Diagnostic) -> (String, String) {
    let place = found.place.as_ref().unwrap_or_else(|| panic!("{found}"));
    let (line, _) = place.line_and_column();
    let text = place.source.text().lines().nth(line - 1).unwrap_or_default().to_owned();
    (place.source.name().to_owned(), text)
}

/// What `motion` says of the same model.
fn of_motion(edits: &[(&str, &str)]) -> Diagnostic {
    let model = model(edits);
    model.motion_record(&model.quantities.nominal()).expect_err("no motion").sorted()[0].clone()
}

#[test]
fn a_model_that_does_not_move_is_refused_in_the_words_of_motion_at_its_place() {
    let open = [("rocker = [\"250 mm\"", "rocker = [\"25 mm\"")];
    let (found, motion) = (not_prepared(&open), of_motion(&open));
    assert_eq!((&found.message, &found.hint, &found.place), (&motion.message, &motion.hint, &motion.place));
    assert_eq!(place(&found).0, "model.toml");
    assert!(place(&found).1.starts_with("[joint."), "{found}");
    let still = [("speed = \"60 rpm\"", "speed = \"0 rpm\"")];
    let (found, motion) = (not_prepared(&still), of_motion(&still));
    assert_eq!((&found.message, &found.hint, &found.place), (&motion.message, &motion.hint, &motion.place));
    assert_eq!(place(&found), ("model.toml".to_owned(), "speed = \"0 rpm\"".to_owned()));
    let without = [("[cycle]\ndrive = \"crank\"\nsamples_per_turn = 36\n", "")];
    let (found, motion) = (not_prepared(&without), of_motion(&without));
    assert_eq!((&found.message, &found.hint), (&motion.message, &motion.hint));
    assert!(found.hint.as_deref().is_some_and(|hint| hint.contains("add [cycle] with drive = \"crank\"")), "{found}");
    assert_eq!(place(&found).0, "model.toml");
}

#[test]
fn an_unknown_value_that_opens_the_loops_is_named_and_the_model_is_not() {
    // The middle of the interval is a coupler that is far too short; that of the model closes.
    let rest =
        format!("[epistemic]\n\"body.coupler.points.rocker.x\" = {{ interval = [\"10 mm\", \"250 mm\"] }}\n{ASK}");
    let study = read(&[], &rest).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let found = estimate_cost(&study).expect_err("no motion").diagnostic(&study);
    assert_eq!(place(&found).0, "study.toml");
    let due = "that is 'body.coupler.points.rocker.x' at 130 mm, which the study says and not the model";
    assert_eq!(found.hint.as_deref(), Some(due), "{found}");
}

#[test]
fn readings_of_a_rig_are_refused_before_their_keys() {
    let found = refused(&format!("{INPUTS}{ASK}[[measured]]\noutput = \"rocker\"\n"));
    assert_eq!(found.message, "[[measured]] has readings of planar models, and the model of this study is in space");
    assert_eq!(place(&found), ("study.toml".to_owned(), "[[measured]]".to_owned()));
    let all = read(&[], &format!("{INPUTS}{ASK}[[measured]]\noutput = \"rocker\"\n")).expect_err("refused");
    assert_eq!(all.sorted().len(), 1, "{all}");
}

#[test]
fn hints_have_the_words_of_space() {
    let path = ("[output.rocker]", "[output.pin]\npath_of = \"rocker.ball\"\n\n[output.rocker]");
    let ask = "[[ask]]\noutput = \"pin\"\nof = \"total\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n";
    let found = read(&[path], &format!("{INPUTS}{ask}")).expect_err("no component").sorted()[0].clone();
    let hint = found.hint.clone().unwrap_or_default();
    assert!(hint.contains("across the distance") && !hint.contains("normal") && !hint.contains("contour"), "{found}");
    let hint = refused(ASK).hint.unwrap_or_default();
    assert!(hint.ends_with("`loosepin motion` shows what play does to the nominal mechanism"), "{hint}");
}

#[test]
fn the_input_that_a_study_adds_is_no_quantity_and_no_parameter() {
    let play = format!("[epistemic]\n\"play\" = {{ interval = [\"0.1 mm\", \"0.2 mm\"] }}\n{ASK}");
    let found = refused(&play);
    assert!(
        found.message.contains("a study adds the input 'play' by itself, for the places of the journals"),
        "{found}"
    );
    // A parameter of this name has its own path, and both are inputs of the study.
    let edit = [
        ("[body.ground]", "[parameter]\nplay = \"0.2 mm\"\n\n[body.ground]"),
        ("radial_clearance = \"0.2 mm\"", "radial_clearance = \"play\""),
    ];
    let found = read(&edit, &play).expect_err("no quantity").sorted()[0].clone();
    assert_eq!(found.hint.as_deref(), Some("write 'parameter.play' for the parameter of that name"));
    let study =
        read(&edit, &play.replace("\"play\" =", "\"parameter.play\" =")).unwrap_or_else(|found| panic!("{found}"));
    let paths: Vec<&str> = study.epistemic.iter().map(|input| input.path.as_str()).collect();
    assert_eq!(paths, ["parameter.play", "play"]);
}

/// Where a diagnostic stands: file, line and column.
fn position(found: &Diagnostic) -> (String, usize, usize) {
    let place = found.place.as_ref().unwrap_or_else(|| panic!("{found}"));
    let (line, column) = place.line_and_column();
    (place.source.name().to_owned(), line, column)
}

/// A shaft in two bearings, which hold it twice over.
const SHAFT: &str = r#"
name = "shaft"
geometry = "space"
[body.ground]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"] }
[body.shaft]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"], tip = ["10 mm", "0 mm", "400 mm"] }
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
path_of = "shaft.tip"
"#;

#[test]
fn drawn_journals_are_refused_at_their_key_where_they_make_no_sense() {
    let journals = "journals = \"uniform-in-play\"\n";
    let at_key = || ("study.toml".to_owned(), 3, 1);
    let found = refused(&format!("journals = \"uniform\"\n{INPUTS}{ASK}"));
    assert!(found.message.contains("journals") && found.to_string().contains("uniform-in-play"), "{found}");
    assert_eq!(position(&found), ("study.toml".to_owned(), 3, 12));
    // No joint has play.
    let ideal = [("radial_clearance = \"0.2 mm\"\n", "")];
    let inputs = "[random]\n\"body.crank.points.pin.x\" = { normal = { standard_deviation = \"0.05 mm\" } }\n";
    let found = read(&ideal, &format!("{journals}{inputs}{ASK}")).expect_err("no play").sorted()[0].clone();
    assert_eq!(found.message, "'journals' says where journals are in their play, and no joint of the model has play");
    assert_eq!(position(&found), at_key());
    // Rows of a measured specimen take the place of all random inputs.
    let rows = "[specimen]\nmechanisms = \"rows.csv\"\n";
    let found = read(&[], &format!("{journals}{inputs}{rows}{ASK}")).expect_err("rows");
    let found = found.sorted()[0].clone();
    assert!(found.message.starts_with("journals at places that are drawn cannot be used with [specimen]"), "{found}");
    assert_eq!(position(&found), ("study.toml".to_owned(), 3, 12));
    // In the plane contact forces decide.
    let planar = include_str!("../../../../cases/slider_crank_worn_pin/model.toml");
    let planar = StudyModel::from_source(Source::new("model.toml", planar)).unwrap_or_else(|found| panic!("{found}"));
    let ask = "[[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n";
    let text = format!(
        "name = \"s\"\nmodel = \"model.toml\"\n{journals}[epistemic]\n\"joint.gudgeon.radial_clearance\" = {{ interval = [\"0.1 mm\", \"0.5 mm\"] }}\n{ask}"
    );
    let found = Study::from_text("study.toml", &text, planar).expect_err("planar").sorted()[0].clone();
    assert_eq!(
        found.message,
        "'journals' is for models in space: in the plane, contact forces decide where a journal is in its play"
    );
    assert_eq!(position(&found), at_key());
}

#[test]
fn drawn_journals_that_must_meet_conditions_together_are_refused_before_the_runs() {
    let model = SpatialModel::from_text("model.toml", SHAFT).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let text = "name = \"s\"\nmodel = \"model.toml\"\njournals = \"uniform-on-rims\"\n[[ask]]\noutput = \"tip\"\ncomponent = \"y\"\n\
                of = \"clearance\"\nreduce = \"maximum\"\nstatistics = [\"standard_deviation\"]\n";
    let study = Study::from_text("study.toml", text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let found = estimate_cost(&study).expect_err("conditions").diagnostic(&study);
    // Four rows of nine and of the drive are held twice.
    assert_eq!(
        found.message,
        "constraints of this mechanism repeat each other, so that its journals must meet 4 conditions together for the loops to close: their \
         places cannot be drawn one by one"
    );
    assert!(found.hint.as_deref().is_some_and(|hint| hint.starts_with("leave 'journals' out")), "{found}");
    assert_eq!(position(&found), ("study.toml".to_owned(), 3, 1));
}

#[test]
fn drawn_journals_take_the_place_of_the_unknown_input_and_are_enough_to_be_uncertain() {
    let ask = ASK.replace("\"mean\"", "\"standard_deviation\"");
    let of = |journals: &str| {
        read(&[], &format!("journals = \"{journals}\"\n{ask}")).map(|study| {
            let random: Vec<String> = study.random.iter().map(|input| input.path.clone()).collect();
            (random, study.epistemic.len())
        })
    };
    let numbers = |count: usize| (1..=count).map(|number| format!("joint.ball.journal.{number}")).collect::<Vec<_>>();
    assert_eq!(of("uniform-in-play").unwrap_or_else(|found| panic!("{found}")), (numbers(3), 0));
    assert_eq!(of("uniform-on-rims").unwrap_or_else(|found| panic!("{found}")), (numbers(2), 0));
    let found = of("unknown").expect_err("one side");
    assert!(found.to_string().contains("journals = \"uniform-in-play\" at the top of the study"), "{found}");
    // What is written is what is meant where nothing is written.
    let without = read(&[], &format!("{INPUTS}{ASK}")).unwrap_or_else(|found| panic!("{found}"));
    let unknown =
        read(&[], &format!("journals = \"unknown\"\n{INPUTS}{ASK}")).unwrap_or_else(|found| panic!("{found}"));
    let paths = |study: &Study| study.epistemic.iter().map(|input| input.path.clone()).collect::<Vec<_>>();
    assert_eq!((paths(&without), unknown.journals), (paths(&unknown), None));
}

#[test]
fn tilts_that_the_file_does_not_write_come_with_the_line_to_add() {
    let of = |path: &str| {
        let rest = format!("[random]\n\"{path}\" = {{ normal = {{ standard_deviation = \"0.1 mrad\" }} }}\n{ASK}");
        refused(&rest).hint.unwrap_or_default()
    };
    let due = |joint: &str, error: &str, unit: &str| {
        format!(
            "tilts and shifts are quantities only where the model file has them: add {error} = [\"0 {unit}\", \"0 {unit}\", \"0 {unit}\"] to \
             [joint.{joint}]; its numbers are then joint.{joint}.{error}.x, .y and .z"
        )
    };
    assert_eq!(of("joint.main.bearing_tilt.x"), due("main", "bearing_tilt", "mrad"));
    assert_eq!(of("joint.mian.bearing_tlt.x"), due("main", "bearing_tilt", "mrad"));
    assert_eq!(of("joint.pivot.journal_shift.z"), due("pivot", "journal_shift", "mm"));
    assert_eq!(of("joint.ball.bearing_tilt.x"), "joint 'ball' is spherical: it has shifts, and no tilts");
    assert_eq!(of("joint.ball.radial_clearence"), "did you mean 'joint.ball.radial_clearance'?");
    // Where it is written, its nearest number is meant.
    let written =
        [("journal = \"crank.o\"", "journal = \"crank.o\"\nbearing_tilt = [\"0 mrad\", \"0 mrad\", \"0 mrad\"]")];
    let rest = format!(
        "[random]\n\"joint.main.bearing_tilt.w\" = {{ normal = {{ standard_deviation = \"0.1 mrad\" }} }}\n{ASK}"
    );
    let found = read(&written, &rest).expect_err("no such number").sorted()[0].clone();
    assert_eq!(found.hint.as_deref(), Some("did you mean 'joint.main.bearing_tilt.x'?"), "{found}");
}

#[test]
fn a_model_that_does_not_say_that_it_is_in_space_has_one_error() {
    let of = |text: &str| match StudyModel::from_source(Source::new("model.toml", text)) {
        Ok(_) => panic!("a planar model"),
        Err(found) => found,
    };
    let found = of(&FOUR_BAR.replace("geometry = \"space\"\n", ""));
    assert_eq!(found.sorted().len(), 1, "{found}");
    let first = found.sorted()[0];
    assert_eq!(
        first.message,
        "body 'ground': point 'bearing' has three coordinates, which only models in space have, and the file does not say that it is one"
    );
    assert!(first.hint.as_deref().is_some_and(|hint| hint.starts_with("add the line geometry = \"space\" at its top")));
    assert!(place(first).1.starts_with("points = { bearing"), "{found}");
    // A planar file with another mistake has its own errors.
    let planar = of("name = \"p\"\n[body.ground]\npoints = { o = [\"0 mm\", \"0 mm\"] }\n");
    assert!(!planar.to_string().contains("geometry"), "{planar}");
}

fn run(study: &Study) -> StudyRun {
    let run = run_study(study, "", &RunOptions::new(2, &Silent, &AtomicBool::new(false)));
    run.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn identity_what_lengths_do_does_not_depend_on_whether_play_is_asked_for() {
    let inputs = "[sampling]\nouter = 9\ninner = 16\nreplicates = 4\n[cycle]\nsamples_per_turn = 6\n[random]\n\
                  \"body.crank.points.pin.x\" = { normal = { standard_deviation = \"0.05 mm\" } }\n[epistemic]\n\
                  \"joint.ball.radial_clearance\" = { interval = [\"0.15 mm\", \"0.25 mm\"] }\n";
    let ask = |of: &str| {
        format!(
            "[[ask]]\noutput = \"rocker\"\nof = \"{of}\"\nreduce = \"maximum\"\nstatistics = [\"mean\", {{ quantile = 0.9 }}]\n"
        )
    };
    let bounds = |questions: &str| {
        let study = read(&[], &format!("{inputs}{questions}")).unwrap_or_else(|found| panic!("{found}"));
        let all = run(&study).result.bounds;
        all[..2].iter().map(|bound| [bound.lower.value_si, bound.upper.value_si]).collect::<Vec<_>>()
    };
    let alone = bounds(&ask("dimensional"));
    assert!(alone.iter().flatten().all(|end| end.abs() > 1e-6), "{alone:?}");
    assert_eq!(alone, bounds(&format!("{}{}", ask("dimensional"), ask("total"))));
}

/// A part that is fixed to a driven arm with an error of manufacture.
const TOOL: &str = r#"
name = "tool"
geometry = "space"
[body.ground]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[body.arm]
points = { o = ["0 mm", "0 mm", "0 mm"], wrist = ["200 mm", "0 mm", "0 mm"] }
[body.tool]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[joint.pivot]
kind = "revolute"
bearing = "ground.o"
journal = "arm.o"
[joint.flange]
kind = "rigid"
bearing = "arm.wrist"
journal = "tool.o"
bearing_tilt = ["0 mrad", "0 mrad", "0 mrad"]
[drive.motor]
joint = "pivot"
speed = "60 rpm"
start_angle = "10 deg"
[cycle]
drive = "motor"
samples_per_turn = 4
[output.tool]
orientation_of = "tool"
"#;

fn tool_study(rest: &str) -> Result<Study, Diagnostics> {
    let model = SpatialModel::from_text("model.toml", TOOL).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", &format!("name = \"s\"\nmodel = \"model.toml\"\n{rest}"), model)
}

#[test]
fn analytic_a_rotation_by_three_random_tilts_has_an_angle_by_maxwell() {
    const DEVIATION: f64 = 0.01;
    let tilts = ["x", "y", "z"].map(|axis| {
        format!("\"joint.flange.bearing_tilt.{axis}\" = {{ normal = {{ standard_deviation = \"10 mrad\" }} }}\n")
    });
    // The only component may be left out.
    for component in ["", "component = \"magnitude\"\n"] {
        let study = tool_study(&format!(
            "[sampling]\ninner = 4096\nreplicates = 8\n[random]\n{}[[ask]]\noutput = \"tool\"\n{component}of = \"total\"\n\
             poses = {{ motor = [\"100 deg\"] }}\n\
             statistics = [\"mean\", \"standard_deviation\", {{ quantile = 0.95 }}, {{ probability_above = \"20 mrad\" }}]\n",
            tilts.concat()
        ));
        let study = study.unwrap_or_else(|found| panic!("{found}"));
        let result = run(&study).result;
        assert_eq!(result.outputs[0].name, "tool magnitude");
        // Of θ/σ: mean √(8/π), variance 3 - 8/π; erf(x/√2) - √(2/π) x exp(-x²/2) is 0.95 at x = 2.795483 and 0.738536 at x = 2.
        let of_maxwell =
            [1.595_769_1, 0.673_439_3, 2.795_483].map(|own| own * DEVIATION).into_iter().chain([0.261_464]);
        for (bound, expected) in result.bounds.iter().zip(of_maxwell) {
            let (lower, upper) = (bound.lower.widened_si, bound.upper.widened_si);
            assert!(lower <= expected && expected <= upper, "{lower} {expected} {upper}");
            // Of 4096 runs, and of a probability of a quarter a little more.
            assert!(upper - lower < 0.1 * expected, "{lower} {expected} {upper}");
        }
        assert_eq!(result.bounds.len(), 4);
    }
}

#[test]
fn an_angle_from_an_ideal_orientation_is_no_value_and_has_one_component() {
    let tilt = "[random]\n\"joint.flange.bearing_tilt.x\" = { normal = { standard_deviation = \"1 mrad\" } }\n";
    let refused = |key: &str| {
        let ask = format!("[[ask]]\noutput = \"tool\"\n{key}reduce = \"maximum\"\nstatistics = [\"mean\"]\n");
        tool_study(&format!("{tilt}{ask}")).expect_err("refused").sorted()[0].clone()
    };
    let found = refused("of = \"value\"\n");
    assert_eq!(
        found.message,
        "[[ask]] 1: of: component 'magnitude' is an error from the ideal orientation, not a value"
    );
    let found = refused("component = \"x\"\nof = \"total\"\n");
    assert!(found.message.contains("\"magnitude\"") || found.to_string().contains("magnitude"), "{found}");
}

/// A question: whether of the model without play, its output, its keys.
type Question = (bool, &'static str, String);

#[test]
fn what_is_explained_of_questions_that_are_not_possible_holds_in_space() {
    let explained = Code::AskNotPossible.entry().explanation;
    let outputs = (
        "[output.rocker]",
        "[output.ball]\npath_of = \"rocker.ball\"\n[output.place]\nposition_of = \"rocker.ball\"\nalong = \"x\"\n\
         [output.attitude]\norientation_of = \"rocker\"\n[output.rocker]",
    );
    let tilts =
        ("journal = \"rocker.o\"", "journal = \"rocker.o\"\nbearing_tilt = [\"0 mrad\", \"0 mrad\", \"0 mrad\"]");
    let ideal = ("radial_clearance = \"0.2 mm\"\n", "");
    let inputs = "[random]\n\"body.crank.points.pin.x\" = { normal = { standard_deviation = \"0.05 mm\" } }\n\
                  \"joint.pivot.bearing_tilt.x\" = { normal = { standard_deviation = \"0.1 mrad\" } }\n";
    let said = |is_ideal: bool, output: &str, keys: &str| {
        let edits = if is_ideal { vec![outputs, tilts, ideal] } else { vec![outputs, tilts] };
        let place = if keys.contains("poses") { "" } else { "reduce = \"maximum\"\n" };
        let ask = format!("[[ask]]\noutput = \"{output}\"\n{keys}\n{place}statistics = [\"mean\"]\n");
        read(&edits, &format!("{inputs}{ask}"))
    };
    let total = "of = \"total\"";
    let component = |word: &str| format!("component = \"{word}\"\n{total}");
    let at = |joint: &str| format!("{total}\nposes = {{ {joint} = [\"60 deg\"] }}");
    // What the text says, what is refused with this code, what is possible.
    let claims: [(&str, Vec<Question>, Vec<Question>); 5] = [
        (
            "A planar path has two columns, one in space three: name one with component, for example component = \"x\"",
            vec![(false, "ball", total.to_owned())],
            ["x", "y", "z"].map(|word| (false, "ball", component(word))).to_vec(),
        ),
        (
            "or in space \"magnitude\" for the distance from the ideal point",
            vec![(false, "ball", component("magnitude").replace("total", "value"))],
            vec![(false, "ball", component("magnitude"))],
        ),
        (
            "In space there are no runs: outputs are positions, paths, turns and orientations",
            ["place", "rocker"].map(|output| (false, output, component("magnitude"))).to_vec(),
            ["place", "rocker", "attitude"].map(|output| (false, output, total.to_owned())).to_vec(),
        ),
        (
            "their deviations come from play, dimensions and errors of manufacture",
            vec![(true, "rocker", total.replace("total", "clearance"))],
            vec![
                (false, "rocker", total.replace("total", "clearance")),
                (true, "rocker", total.replace("total", "dimensional")),
            ],
        ),
        (
            "A pose is given by the angle of the drive that the cycle counts",
            vec![(false, "rocker", at("pivot"))],
            vec![(false, "rocker", at("crank"))],
        ),
    ];
    for (claim, refused, possible) in claims {
        assert!(explained.contains(claim), "{claim}: {explained}");
        for (is_ideal, output, keys) in refused {
            let found = said(is_ideal, output, &keys).expect_err(&keys);
            assert_eq!(found.sorted()[0].code, Code::AskNotPossible, "{keys}: {found}");
        }
        for (is_ideal, output, keys) in possible {
            let study = said(is_ideal, output, &keys).unwrap_or_else(|found| panic!("{keys}: {found}"));
            assert_eq!(study.asks.len(), 1);
        }
    }
}
