//! Drags in the templates: where the joints are afterwards, by the library's own motion of the new texts.

use loosepin::model::{Joint, Model};
use loosepin::report::moving_drawing;
use loosepin::result::motion::MotionRecord;
use loosepin::study::InputFile;
use loosepin::templates::{TEMPLATES, find_template};

use super::reshape::{length, minus};
use super::{gripped, set_uncertainty};
use crate::files::folder::Folder;
use crate::messages::{Change, Document, Grip, Held, Look, SentText};
use crate::view::texts::Texts;

/// A quarter of a degree apart, so that no joint goes far from one to the next.
const POSITIONS: usize = 1441;

/// A served folder with nothing in it, and what keeps it.
pub fn served() -> (tempfile::TempDir, Folder) {
    let desk = tempfile::tempdir().unwrap();
    let folder = Folder::new(desk.path()).unwrap();
    (desk, folder)
}

pub fn texts(folder: &Folder, model: &str, study: &str) -> Texts {
    let sent = |path: &str, text: &str| SentText { path: path.to_owned(), text: text.to_owned() };
    let (model, study) = (sent("model.toml", model), Some(sent("study.toml", study)));
    Texts::sent(folder, &Look::of(model, study, POSITIONS))
}

fn record(texts: &Texts) -> Option<MotionRecord> {
    texts.read().and_then(|file| file.ideal_motion(POSITIONS, &[])).ok()
}

fn pin(joint: &str) -> Held {
    Held::Joint { joint: joint.to_owned() }
}

/// Poses of all bodies, mm and degrees, as the page has them.
fn poses(record: &MotionRecord, pose: usize) -> Vec<[f64; 3]> {
    let table = &record.drawing.poses;
    let bodies = 0..record.drawing.bodies.len();
    bodies
        .map(|body| {
            [1e3 * table.x_m[body][pose], 1e3 * table.y_m[body][pose], table.angle_rad[body][pose].to_degrees()]
        })
        .collect()
}

/// Where a joint is, mm.
fn at_mm(record: &MotionRecord, joint: usize, pose: usize) -> [f64; 2] {
    let end = record.drawing.joints[joint].first;
    let point = &record.drawing.bodies[end.body].points[end.point];
    let [x, y, angle] = poses(record, pose)[end.body];
    let (sine, cosine) = angle.to_radians().sin_cos();
    [x + 1e3 * (cosine * point.x_m - sine * point.y_m), y + 1e3 * (sine * point.x_m + cosine * point.y_m)]
}

/// The largest distance of a joint from where it is due, mm, at the pose where that is least.
fn furthest_mm(record: &MotionRecord, due: &[[f64; 2]]) -> f64 {
    let count = record.drawing.poses.drive_angle_rad.len();
    let worst = |pose: usize| {
        let far = (0..due.len()).map(|joint| length(minus(at_mm(record, joint, pose), due[joint])));
        far.fold(0.0, f64::max)
    };
    (0..count).map(worst).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_dragged_pin_is_where_it_was_dragged_and_the_others_stay() {
    let (_desk, folder) = served();
    let (mut dragged, mut refused) = (0, Vec::new());
    // Links of a pantograph share their lengths: more than one centre goes with each.
    for template in TEMPLATES.iter().filter(|template| template.name != "pantograph") {
        let texts = texts(&folder, template.model, template.study);
        let Some(old) = record(&texts).filter(|old| moving_drawing(&old.drawing, &old.drive).is_some()) else {
            continue;
        };
        let model = Model::from_text("model.toml", template.model).unwrap();
        // No drive is at the end of its way here.
        let pose = POSITIONS / 7;
        let here: Vec<[f64; 2]> = (0..model.joints.len()).map(|joint| at_mm(&old, joint, pose)).collect();
        let size = here.iter().flatten().fold(1.0_f64, |size, value| size.max(value.abs()));
        for (index, joint) in model.joints.iter().enumerate() {
            // A point that carries a guide too takes the guide along: then others do not stay.
            let is_pin = |joint: &Joint| joint.kind.turns();
            let points = joint.kind.points();
            let guides = model.joints.iter().filter(|other| !is_pin(other));
            let carries_guide =
                guides.flat_map(|guide| guide.kind.points()).any(|point| points.contains(&point) && point.body.0 == 0);
            if !is_pin(joint) || carries_guide {
                continue;
            }
            let to_mm = [here[index][0] + 0.01 * size, here[index][1] - 0.006 * size];
            let grip =
                Grip { held: pin(&joint.name), to_mm, step_mm: 1e-4 * size, is_free: true, poses: poses(&old, pose) };
            let drag = gripped(&model, &texts, &grip);
            if let Some(words) = &drag.reshaped.refusal {
                refused.push(format!("{}: {words}", template.name));
                continue;
            }
            let new = texts.with(&folder, drag.model.as_deref(), drag.study.as_deref());
            let Some(record) = record(&new) else { panic!("{} {}: {:?}", template.name, joint.name, drag.reshaped) };
            // Where the held point was to go: the pointer, or the nearest place on the line of a guide.
            let due: Vec<[f64; 2]> = drag.expected_m().iter().map(|[x, y]| [1e3 * x, 1e3 * y]).collect();
            let far = furthest_mm(&record, &due);
            assert!(far < 0.005 * size, "{} {}: {far} of {size}, {:?}", template.name, joint.name, drag.reshaped);
            dragged += usize::from(length(minus(due[index], here[index])) > 0.005 * size);
        }
    }
    assert!(dragged >= 20, "{dragged} pins, refused:\n{}", refused.join("\n"));
}

#[test]
fn lengths_become_round_and_the_tolerances_follow() {
    let (_desk, folder) = served();
    let template = find_template("slider-crank").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let old = record(&texts).unwrap();
    let model = Model::from_text("model.toml", template.model).unwrap();
    let pose = POSITIONS / 4;
    let index = model.joints.iter().position(|joint| joint.name == "gudgeon").unwrap();
    let [x, y] = at_mm(&old, index, pose);
    // Beside the guide, too: the pin stays on its line.
    let grip = Grip {
        held: pin("gudgeon"),
        to_mm: [x + 10.2, y + 30.0],
        step_mm: 0.7,
        is_free: false,
        poses: poses(&old, pose),
    };
    let drag = gripped(&model, &texts, &grip);
    let crank_pin = model.joints.iter().position(|joint| joint.name == "crank_pin").unwrap();
    let rod_mm = length(minus([x + 10.2, y], at_mm(&old, crank_pin, pose)));
    let written = format!("{:.0} mm", rod_mm);
    assert_eq!(drag.reshaped.words, [format!("rod_length {written}")]);
    assert!(drag.model.unwrap().contains(&format!("rod_length = \"{written}\"")));
    // Comments and all else stay: one number of the model changes. The study states no mean of its own, and follows as it is.
    let InputFile::Study(study) = texts.read().unwrap() else { panic!("a study") };
    assert!(study.random.iter().any(|input| input.path == "parameter.rod_length"));
    assert_eq!((drag.study, drag.reshaped.changes.len()), (None, 1));
}

#[test]
fn what_the_study_states_of_a_dragged_length_moves_along_or_is_told() {
    let entry = "{ normal = { standard_deviation = \"0.03 mm\" } }";
    let follows: [(&str, Option<&str>); 4] = [
        ("{ normal = { mean = \"120 mm\", standard_deviation = \"0.05 mm\" } }", Some("mean = ")),
        ("{ tolerance = \"120 ± 0.05 mm\" }", Some(" ± 0.05 mm")),
        ("{ tolerance = \"-0.01 -0.02 mm\" }", None),
        ("{ tolerance = \"+0.02 -0.01 mm\" }", None),
    ];
    for (stated, kept) in follows {
        let (_desk, folder) = served();
        let template = find_template("slider-crank").unwrap();
        let own = template.study.replace(entry, stated);
        assert!(own.contains(stated), "{own}");
        let texts = texts(&folder, template.model, &own);
        let old = record(&texts).unwrap();
        let model = Model::from_text("model.toml", template.model).unwrap();
        let pose = POSITIONS / 4;
        let index = model.joints.iter().position(|joint| joint.name == "gudgeon").unwrap();
        let [x, y] = at_mm(&old, index, pose);
        let poses = poses(&old, pose);
        let drag = gripped(
            &model,
            &texts,
            &Grip { held: pin("gudgeon"), to_mm: [x + 10.2, y], step_mm: 1.0, is_free: false, poses },
        );
        assert_eq!(drag.reshaped.words.len(), 1, "{:?}", drag.reshaped.words);
        match kept {
            None => assert_eq!(drag.study, None, "{stated}"),
            Some(kept) => {
                let study = drag.study.unwrap();
                assert!(study.contains(kept) && !study.contains(stated), "{study}");
            }
        }
    }
}

#[test]
fn a_drag_that_is_of_another_model_is_refused() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let model = Model::from_text("model.toml", template.model).unwrap();
    let good = Grip {
        held: pin(&model.joints[0].name),
        to_mm: [1.0, 2.0],
        step_mm: 1.0,
        is_free: false,
        poses: vec![[0.0; 3]; model.bodies.len()],
    };
    assert_eq!(gripped(&model, &texts, &good).reshaped.refusal, None);
    let wrong = [
        Grip { held: pin("<script>"), ..good.clone() },
        Grip { poses: Vec::new(), ..good.clone() },
        Grip { step_mm: 0.0, ..good.clone() },
        Grip { to_mm: [1e300, 0.0], ..good.clone() },
        Grip { poses: vec![[f64::MAX; 3]; model.bodies.len()], ..good.clone() },
    ];
    for grip in wrong {
        let drag = gripped(&model, &texts, &grip);
        assert!(drag.reshaped.refusal.is_some() && drag.model.is_none() && drag.study.is_none(), "{grip:?}");
    }
}

#[test]
fn a_locked_length_stays() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let locked = template.model.replace("coupler_length = \"260 mm\"", "coupler_length = \"260 mm\"  # locked");
    let texts = texts(&folder, &locked, template.study);
    let old = record(&texts).unwrap();
    let model = Model::from_text("model.toml", &locked).unwrap();
    let index = model.joints.iter().position(|joint| joint.name == "crank_pin").unwrap();
    let [x, y] = at_mm(&old, index, 100);
    let to_mm = [x + 10.0, y];
    let grip = Grip { held: pin("crank_pin"), to_mm, step_mm: 1.0, is_free: false, poses: poses(&old, 100) };
    let drag = gripped(&model, &texts, &grip);
    let words = "parameter 'coupler_length' is locked: unlock it in the list of numbers";
    assert_eq!((drag.reshaped.refusal.as_deref(), drag.model), (Some(words), None));
}

/// Both texts after some changes, as the page makes them.
pub fn applied(folder: &Folder, old: &Texts, changes: &[Change]) -> Texts {
    let model = super::applied(old.model.text(), changes, Document::Model);
    let study = old.study.as_ref().map(|study| super::applied(study.text(), changes, Document::Study));
    old.with(folder, Some(&model), study.as_deref())
}

/// Both texts after what is known of a number is said so.
fn known(folder: &Folder, old: &Texts, path: &str, text: &str) -> Texts {
    let changes =
        set_uncertainty(folder, old, path, text).unwrap_or_else(|refusal| panic!("{path} {text}: {}", refusal.message));
    applied(folder, old, &changes)
}

fn study(texts: &Texts) -> String {
    texts.study.as_ref().unwrap().text().to_owned()
}

#[test]
fn whatever_is_known_of_a_number_is_read_back_and_the_comments_stay() {
    let (_desk, folder) = served();
    let forms = ["±0.05", "+0.02 -0.01 mm", "sd 0.03", "uniform ±0.1 mm", "100..140 mm", "119, 120, 121 mm", "121 mm"];
    for template in TEMPLATES {
        let mut texts = texts(&folder, template.model, template.study);
        let model = Model::from_text("model.toml", template.model).unwrap();
        let comments = |text: &str| text.matches('#').count();
        let lengths = model.quantities.iter().filter(|(_, quantity)| {
            quantity.path.starts_with("parameter.") && quantity.path.ends_with("length") && quantity.is_settable()
        });
        for (id, quantity) in lengths {
            for form in forms {
                // Around the value that this one has.
                let nominal_mm = 1e3 * model.quantities.nominal()[id];
                let form = match form {
                    "100..140 mm" => format!("{}..{} mm", 0.9 * nominal_mm, 1.1 * nominal_mm),
                    "119, 120, 121 mm" => format!("{}, {} mm", 0.99 * nominal_mm, nominal_mm),
                    "121 mm" => format!("{nominal_mm} mm"),
                    other => other.to_owned(),
                };
                let before = comments(&study(&texts));
                texts = known(&folder, &texts, &quantity.path, &form);
                let read =
                    texts.read().unwrap_or_else(|found| panic!("{} {} {form}:\n{found}", template.name, quantity.path));
                let InputFile::Study(read) = read else { panic!("a study") };
                let is_random = read.random.iter().any(|input| input.path == quantity.path);
                let is_epistemic = read.epistemic.iter().any(|input| input.path == quantity.path);
                let due = (
                    form.contains('±') || form.contains('-') || form.contains("sd"),
                    form.contains("..") || form.contains(','),
                );
                assert_eq!((is_random, is_epistemic), due, "{} {} {form}", template.name, quantity.path);
                // A comment goes only with the line of an entry that goes.
                assert!(comments(&study(&texts)) + 1 >= before, "{}", study(&texts));
            }
        }
    }
}

#[test]
fn a_nominal_value_and_its_tolerance_are_written_in_one_field() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let old = texts(&folder, template.model, template.study);
    let texts = known(&folder, &old, "parameter.rocker_length", "181,5 ±0,2 mm");
    assert!(texts.model.text().contains("rocker_length = \"181.5 mm\""), "{}", texts.model.text());
    let InputFile::Study(read) = texts.read().unwrap_or_else(|found| panic!("{found}")) else { panic!("a study") };
    assert!(read.random.iter().any(|input| input.path == "parameter.rocker_length"));
    // The same nominal value leaves the model as it is.
    let again = known(&folder, &texts, "parameter.rocker_length", "181.5 ±0.1 mm");
    assert_eq!(again.model.text(), texts.model.text());
}

#[test]
fn a_joint_gets_play_with_a_bearing_and_a_contact() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let old = texts(&folder, template.model, template.study);
    let texts = known(&folder, &old, "joint.crank_pin.radial_clearance", "0.05..0.2 mm");
    let InputFile::Study(read) = texts.read().unwrap_or_else(|found| panic!("{found}")) else { panic!("a study") };
    assert!(read.epistemic.iter().any(|input| input.path == "joint.crank_pin.radial_clearance"));
    assert!(
        texts.model.text().contains("radial_clearance = \"0.05 mm\"\ncontact = \"steel_pin\""),
        "{}",
        texts.model.text()
    );
    // By a fit, at the diameter of the bearing; then exactly, and nothing of it stays in the study.
    let texts = known(&folder, &texts, "joint.crank_pin.radial_clearance", "H7/f7");
    assert!(study(&texts).contains("\"joint.crank_pin.radial_clearance\" = { fit = \"H7/f7\", diameter = \"16 mm\" }"));
    texts.read().unwrap_or_else(|found| panic!("{found}"));
    let texts = known(&folder, &texts, "joint.crank_pin.radial_clearance", "0.1");
    assert_eq!(study(&texts), study(&old));
    assert!(texts.model.text().contains("radial_clearance = \"0.1 mm\""));
}

#[test]
fn what_cannot_be_known_so_is_refused() {
    let (_desk, folder) = served();
    let template = find_template("slider-crank").unwrap();
    let texts = texts(&folder, template.model, template.study);
    for (path, text, words) in [
        ("parameter.nothing", "1 mm", "the model has no number 'parameter.nothing'"),
        ("body.rod.points.small_end.x", "1 mm", "follows from parameter.rod_length"),
        ("parameter.rod_length", "H7/g6", "a fit belongs to a pin in its bearing"),
        ("parameter.rod_length", "1..2 kg", "expected a length"),
        ("joint.crank_pin.radial_clearance", "±0.1 mm", "has no play yet"),
        // The motor turns this one; a value that the model does not take; a number of another kind.
        ("joint.main.radial_clearance", "0.1..0.5 mm", "cannot be driven"),
        ("joint.gudgeon.radial_clearance", "-0.1", "must be"),
        ("joint.gudgeon.bearing_radius", "H7/f7", "fit"),
        ("parameter.rod_length", "121..119", "must be"),
        ("joint.guide.radial_clearance", "0.1 mm", "the model has no number"),
    ] {
        let refusal = set_uncertainty(&folder, &texts, path, text).expect_err(path);
        assert!(refusal.message.contains(words), "{path} {text}: {}", refusal.message);
    }
    let alone = Texts { model: texts.model.clone(), study: None };
    assert!(set_uncertainty(&folder, &alone, "parameter.rod_length", "±0.1 mm").is_err());
    assert_eq!(set_uncertainty(&folder, &alone, "parameter.rod_length", "121 mm").unwrap().len(), 1);
}

#[test]
fn whatever_is_typed_the_texts_stay_toml() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let pieces = [
        "0.1", "1e308", "-3", ".", "..", "±", "+", "-", " mm", " in", " kg", "mn", ",", ", ", "H7/g6", "sd ",
        "uniform ", "\"", "'", "]", "}", "\n", "#", "\\", "\u{202e}", "😀", "=", " to ", "°", "NaN", "inf", "/",
    ];
    let paths = [
        "parameter.coupler_length",
        "joint.rocker_pin.radial_clearance",
        "joint.crank_pin.radial_clearance",
        "drive.crank.speed",
    ];
    let mut state = 7_u64;
    let mut below = |count: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % count
    };
    let mut taken = 0;
    for _ in 0..8000 {
        let text: String = (0..1 + below(6)).map(|_| pieces[below(pieces.len())]).collect();
        let path = paths[below(paths.len())];
        let Ok(changes) = set_uncertainty(&folder, &texts, path, &text) else { continue };
        taken += 1;
        let new = applied(&folder, &texts, &changes);
        for source in [Some(&new.model), new.study.as_ref()].into_iter().flatten() {
            assert!(loosepin::document::parse_toml(source).is_ok(), "{path} {text:?}:\n{}", source.text());
        }
    }
    assert!(taken > 50, "{taken} of 8000 were taken");
}

/// The study of the four-bar with these lines in place of its random inputs.
fn with_random(random: &str) -> String {
    let study = find_template("four-bar").unwrap().study;
    let (before, rest) = study.split_once("[random]").unwrap();
    let (_, after) = rest.split_once("[epistemic]").unwrap();
    format!("{before}{random}\n[epistemic]{after}")
}

#[test]
fn studies_that_are_written_otherwise_keep_all_that_they_say() {
    let (_desk, folder) = served();
    let model = find_template("four-bar").unwrap().model;
    let coupler = "{ normal = { mean = \"260 mm\", standard_deviation = \"0.05 mm\" } }";
    let texts_of = |random: &str| texts(&folder, model, &with_random(random));
    // Tables of their own, alone and behind a header, and an empty table: the new entry has its own place.
    for random in [
        "[random.\"parameter.coupler_length\"]\nnormal = { mean = \"260 mm\", standard_deviation = \"0.05 mm\" }\n",
        "[random]\n\"parameter.coupler_length\" = { normal = { mean = \"260 mm\",\n  standard_deviation = \"0.05 mm\" } }\n",
        "[random] # none yet\n",
        "[ random ]\r\n",
    ] {
        let old = texts_of(random);
        old.read().unwrap_or_else(|found| panic!("{random}: {found}"));
        let new = known(&folder, &old, "parameter.crank_length", "±0.05");
        let InputFile::Study(read) = new.read().unwrap_or_else(|found| panic!("{random}: {found}")) else {
            panic!("a study")
        };
        let has = |path: &str| read.random.iter().any(|input| input.path == path);
        assert!(has("parameter.crank_length"), "{}", study(&new));
        assert_eq!(has("parameter.coupler_length"), random.contains("coupler"), "{}", study(&new));
    }
    // All on one line: an entry goes out of it, comes into it or is written anew there, and nothing else changes.
    let line = format!(
        "random = {{ \"parameter.coupler_length\" = {coupler}, \"parameter.crank_length\" = {{ tolerance = \"80 ± 0.1 mm\" }} }}\n"
    );
    let template = find_template("four-bar").unwrap().study;
    let (head, rest) = template.split_once("[cycle]").unwrap();
    let (cycle, rest) = rest.split_once("[random]").unwrap();
    let (_, after) = rest.split_once("[epistemic]").unwrap();
    let old = texts(&folder, model, &format!("{head}{line}[cycle]{cycle}[epistemic]{after}"));
    old.read().unwrap_or_else(|found| panic!("{found}"));
    let with_random = |random: &str| study(&old).replace(&line, &format!("random = {{ {random} }}\n"));
    let crank = "\"parameter.crank_length\" = { tolerance = \"80 ± 0.1 mm\" }";
    let exact = known(&folder, &old, "parameter.coupler_length", "260");
    assert_eq!(study(&exact), with_random(crank));
    let unknown = known(&folder, &old, "parameter.coupler_length", "259..261 mm");
    assert_eq!(study(&unknown).matches("coupler_length").count(), 1, "{}", study(&unknown));
    assert!(study(&unknown).contains(crank) && study(&unknown).contains("{ interval = [\"259 mm\", \"261 mm\"] }"));
    let more = known(&folder, &old, "parameter.rocker_length", "±0.05");
    let coupler = format!("\"parameter.coupler_length\" = {coupler}");
    assert_eq!(
        study(&more),
        with_random(&format!("{coupler}, {crank}, \"parameter.rocker_length\" = {{ tolerance = \"± 0.05 mm\" }}"))
    );
    for texts in [exact, unknown, more] {
        texts.read().unwrap_or_else(|found| panic!("{found}"));
    }
}

#[test]
fn a_joint_in_braces_gets_play_too() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let (before, rest) = template.model.split_once("[joint.crank_pin]").unwrap();
    let (own, after) = rest.split_once("\n[").unwrap();
    let entries: Vec<&str> = own.lines().filter(|line| line.contains('=')).collect();
    // A joint on a line of its own stands below the header of all joints, which nothing else has here.
    let model = format!("{before}[joint]\ncrank_pin = {{ {} }}\n\n[{after}", entries.join(", "));
    let old = texts(&folder, &model, template.study);
    old.read().unwrap_or_else(|found| panic!("{found}\n{model}"));
    let new = known(&folder, &old, "joint.crank_pin.radial_clearance", "0.1 mm");
    new.read().unwrap_or_else(|found| panic!("{found}"));
    assert!(
        new.model.text().contains("radial_clearance = \"0.1 mm\", contact = \"steel_pin\" }\n"),
        "{}",
        new.model.text()
    );
}

#[test]
fn lines_end_as_they_do_in_the_text() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let [model, study_text] = [template.model, template.study].map(|text| text.replace('\n', "\r\n"));
    let texts = texts(&folder, &model, &study_text);
    for (path, text) in [("parameter.crank_length", "±0.05"), ("joint.crank_pin.radial_clearance", "0.1..0.2 mm")] {
        let new = known(&folder, &texts, path, text);
        for source in [&new.model, new.study.as_ref().unwrap()] {
            assert_eq!(source.text().matches('\n').count(), source.text().matches("\r\n").count(), "{path}");
        }
        new.read().unwrap_or_else(|found| panic!("{found}"));
    }
}

#[test]
fn a_link_that_an_actuator_turns_keeps_its_angle() {
    let (_desk, folder) = served();
    let template = find_template("two-link-arm").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let model = Model::from_text("model.toml", template.model).unwrap();
    let length_mm = 1e3 * model.quantities.nominal()[model.quantities.id("parameter.upper_length").unwrap()];
    // The upper link straight up: beside it the elbow does not go, along it the link becomes longer.
    let poses = vec![[0.0; 3], [0.0, 0.0, 90.0], [0.0, length_mm, 0.0]];
    let grip = Grip { held: pin("elbow"), to_mm: [50.0, length_mm + 20.0], step_mm: 1.0, is_free: false, poses };
    let drag = gripped(&model, &texts, &grip);
    assert_eq!(
        drag.reshaped.words.first(),
        Some(&format!("upper_length {} mm", length_mm + 20.0)),
        "{:?}",
        drag.reshaped
    );
    let view = crate::view::look::look(
        &folder,
        &Look {
            grip: Some(grip),
            ..Look::of(SentText { path: "model.toml".into(), text: template.model.into() }, None, 37)
        },
    );
    assert!(view.view.is_some_and(|view| view.drawing.is_some()) && view.diagnostics.is_empty());
}
