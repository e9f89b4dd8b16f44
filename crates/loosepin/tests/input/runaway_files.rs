//! Short files that would take all time or all memory there is: each is complained about at once, and what is only large is planned
//! without being made.

use std::sync::LazyLock;

use loosepin::model::Model;
use loosepin::study::{Study, plan_runs};
use loosepin::templates::{Template, find_template};
use loosepin::units::counted;

static TEMPLATE: LazyLock<&Template> = LazyLock::new(|| find_template("slider-crank").expect("a template"));

/// What is uncertain and asked, besides what a test is about.
const ASKED: &str = "[random]\n\
    \"parameter.crank_length\" = { normal = { mean = \"50 mm\", standard_deviation = \"0.02 mm\" } }\n\
    [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\"]\n";

fn study_of(model: &str, text: &str) -> Study {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|complaints| panic!("{complaints}"));
    let text = format!("name = \"runaway\"\nmodel = \"model.toml\"\n{text}\n{ASKED}");
    Study::from_text("study.toml", &text, model).unwrap_or_else(|complaints| panic!("{complaints}"))
}

/// What `loosepin check` says of a study with this text in it.
fn said(text: &str) -> String {
    let study = study_of(TEMPLATE.model, text);
    plan_runs(&study).expect_err("it is refused").complaint(&study).to_string()
}

#[test]
fn more_turns_than_anybody_waits_for_are_refused() {
    assert_eq!(
        said("[cycle]\nrecorded_turns = 1e6"),
        "study.toml:4:18: error[E0608]: 1000000 turns are recorded; must be at most 1000\n\
         hint: transient_turns and recorded_turns stand in the [cycle] of the study, or of its model"
    );
    assert_eq!(
        said("[cycle]\ntransient_turns = 987654.25\nrecorded_turns = 0.5"),
        "study.toml:4:19: error[E0608]: 987654.75 turns are run; must be at most 10000\n\
         hint: transient_turns and recorded_turns stand in the [cycle] of the study, or of its model"
    );
}

#[test]
fn analytic_more_runs_than_anybody_waits_for_are_refused() {
    // 512 points of 2^24 runs, 1024 of the probability-only treatment and 128 of the interval-only one; at most 2^30.
    let sampling = "[sampling]\nouter = 512\ninner = 16777216\n\
        [epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }";
    assert_eq!(
        said(sampling),
        "study.toml:3:2: error[E0611]: 8589935744 runs; must be at most 1073741824\n\
         hint: smaller outer and inner under [sampling] need fewer runs"
    );
}

/// 64 points of 2^22 runs are 2^28, of 15 numbers each, which are in a file: 400 bytes a run, 1600 a number and point, 128 MiB,
/// 8 MiB, and one for each thread are 100.14 GiB on 2 threads.
#[test]
fn a_plan_larger_than_the_memory_at_hand_is_refused() {
    let at_hand_gib = std::fs::read_to_string("/proc/meminfo").ok().and_then(|text| {
        let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
        line.split_whitespace().next()?.parse::<f64>().ok()
    });
    if at_hand_gib.is_some_and(|kib| kib > 90e6) {
        return;
    }
    let said = said(
        "[sampling]\nouter = 64\ninner = 4194304\n\
         [epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }",
    );
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let needed_mib = (268_436_608_u64 * 400 + 64 * 15 * 1600) as f64 / f64::from(1 << 20) + (128 + 8 + threads) as f64;
    let needed = format!("{:.2} GiB of memory; ", needed_mib / 1024.0);
    let (begin, end) = said.split_once(needed.as_str()).expect("the need is told");
    let threads = counted(threads, "thread");
    assert_eq!(
        begin,
        format!("study.toml:3:2: error[E0817]: 268436608 runs of 15 numbers each on {threads} need about ")
    );
    assert!(end.contains(" GiB are at hand\nhint: smaller outer and inner under [sampling] need fewer runs"), "{end}");
}

/// The poses of a question are counted before they are compared with one another.
#[test]
fn more_poses_than_are_bounded_are_refused_at_the_first_too_many() {
    let model = Model::from_text("model.toml", TEMPLATE.model).expect("a model");
    let poses: Vec<String> = (0..50_000).map(|k| format!("\"{}.{:03} deg\"", k / 1000 * 7, k % 1000)).collect();
    let text = format!(
        "name = \"runaway\"\nmodel = \"model.toml\"\n{}[[ask]]\noutput = \"slider\"\nof = \"total\"\n\
         poses = {{ crank = [{}] }}\nstatistics = [\"mean\"]\n",
        ASKED.split("[[ask]]").next().expect("what is uncertain"),
        poses.join(", ")
    );
    let complaints = Study::from_text("study.toml", &text, model).expect_err("too many poses").to_string();
    let column = "poses = { crank = [".len() + poses[..2000].iter().map(|pose| pose.len() + 2).sum::<usize>() + 1;
    assert_eq!(
        complaints,
        format!(
            "study.toml:8:{column}: error[E0210]: [[ask]] 1: poses crank has 50000 poses; must be at most 2000\n\
             hint: write at = \"cycle\" for the whole curve"
        )
    );
}

/// A model with `bodies` moving bodies without joints, one on each line.
fn crowd(bodies: usize) -> String {
    let body = |k: usize| {
        format!("[body.b{k}]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\ncentre_of_mass = [\"0 m\", \"0 m\"]\n")
    };
    let bodies: String = (0..bodies).map(body).collect();
    format!("name = \"crowd\"\ngravity = \"0 m/s^2\"\n[body.ground]\n{bodies}[cycle]\nduration = \"1 s\"\n")
}

#[test]
fn more_bodies_than_are_computed_are_refused_at_the_first_too_many() {
    assert!(Model::from_text("model.toml", &crowd(1000)).is_ok());
    // Three lines, then four for each body.
    assert_eq!(
        Model::from_text("model.toml", &crowd(1003)).expect_err("too many").to_string(),
        format!(
            "model.toml:{}:7: error[E0210]: the file has 1003 moving bodies; at most 1000 are permitted",
            4 + 4 * 1000
        )
    );
}

#[test]
fn more_joints_than_are_computed_are_refused_at_the_first_too_many() {
    let joint = |k: usize| format!("[joint.j{k}]\nkind = \"revolute\"\n");
    let joints: String = (0..2001).map(joint).collect();
    assert_eq!(
        Model::from_text("model.toml", &format!("{}{joints}", crowd(1))).expect_err("too many").to_string(),
        format!(
            "model.toml:{}:8: error[E0210]: the file has 2001 joints; at most 2000 are permitted",
            3 + 4 + 2 + 1 + 2 * 2000
        )
    );
}

#[test]
fn analytic_a_large_sample_is_counted_without_being_drawn() {
    // Without intervals the double loop has one point, and the other treatments are none.
    let inner = 1_572_864;
    let study = study_of(TEMPLATE.model, &format!("[sampling]\ninner = {inner}"));
    let of_extremes = plan_runs(&study).expect("a plan") - inner;
    let small = plan_runs(&study_of(TEMPLATE.model, "[sampling]\ninner = 48")).expect("a plan");
    assert_eq!(of_extremes, small - 48);
}

#[test]
fn more_combinations_of_laws_than_mechanisms_are_made_of_are_refused() {
    let contact = TEMPLATE.model.split("[contact.steel_pin]").nth(1).and_then(|rest| rest.split("\n[").next());
    let contact = contact.expect("the contact of the template");
    let names: Vec<String> = (0..9).map(|index| format!("further_{index}")).collect();
    let further: String = names.iter().map(|name| format!("\n[contact.{name}]{contact}\n")).collect();
    let laws: String = names
        .iter()
        .map(|name| {
            format!("\"contact.{name}.law\" = {{ any_of = [\"lankarani-nikravesh\", \"flores\", \"johnson\"] }}\n")
        })
        .collect();
    let study = study_of(&format!("{}\n{further}", TEMPLATE.model), &format!("[epistemic]\n{laws}"));
    assert_eq!(
        plan_runs(&study).expect_err("it is refused").complaint(&study).to_string(),
        "study.toml:1:1: error[E0608]: 19683 combinations of contact laws; must be at most 64\nhint: shorten the lists of laws"
    );
}

/// A file whose names are all wrong costs its length, not the square of it: what was meant is looked for among so many names only.
#[test]
fn a_file_of_wrong_names_is_complained_about() {
    const WRONG: u64 = 2000;
    let name = |index: u64| -> String {
        let mut state = index.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let letter = |_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            char::from(b'a' + (state >> 59) as u8 % 26)
        };
        (0..90).map(letter).collect()
    };
    let lines: String = (0..WRONG).map(|index| format!("{} = \"{}\"\n", name(index), name(index + WRONG))).collect();
    let complaints = Model::from_text("model.toml", &format!("[parameter]\n{lines}")).expect_err("no model");
    assert!(complaints.len() as u64 >= WRONG, "{}", complaints.len());
}

/// Files that say that they have no bytes and have a great many.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_made_up_as_it_is_read_is_not_read_to_its_end() {
    let path = std::path::Path::new("/proc/kallsyms");
    // Some systems do not have it, or hide what is in it.
    if std::fs::metadata(path).map_or(1, |metadata| metadata.len()) > 0
        || std::fs::read(path).map_or(0, |bytes| bytes.len()) <= 1 << 20
    {
        return;
    }
    let said = Model::from_path(path).expect_err("no model").to_string();
    assert_eq!(said, "error[E0103]: /proc/kallsyms has 1048577 bytes; must be at most 1048576");
}
