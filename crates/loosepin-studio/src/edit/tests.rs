//! Drags in the templates: where the joints are afterwards, by the library's own motion of the new texts.

use loosepin::model::{Joint, JointKind, Model};
use loosepin::report::moving_drawing;
use loosepin::result::motion::MotionRecord;
use loosepin::study::InputFile;
use loosepin::templates::{TEMPLATES, find_template};

use super::gripped;
use super::reshape::{length, minus};
use crate::folder::Folder;
use crate::messages::{Grip, Look, SentText};
use crate::texts::Texts;

/// A quarter of a degree apart, so that no joint goes far from one to the next.
const POSITIONS: usize = 1441;

fn texts(folder: &Folder, model: &str, study: &str) -> Texts {
    let sent = |path: &str, text: &str| SentText { path: path.to_owned(), text: text.to_owned() };
    let (model, study) = (sent("model.toml", model), Some(sent("study.toml", study)));
    Texts::sent(folder, &Look { seq: 0, model, study, positions: POSITIONS, grip: None })
}

fn record(texts: &Texts) -> Option<MotionRecord> {
    texts.read().and_then(|file| file.ideal_motion(POSITIONS, &[])).ok()
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
    let desk = tempfile::tempdir().unwrap();
    let folder = Folder::new(desk.path()).unwrap();
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
            let is_pin = |joint: &Joint| matches!(joint.kind, JointKind::Revolute { .. });
            let points = joint.kind.points();
            let guides = model.joints.iter().filter(|other| !is_pin(other));
            let carries_guide =
                guides.flat_map(|guide| guide.kind.points()).any(|point| points.contains(&point) && point.body.0 == 0);
            if !is_pin(joint) || carries_guide {
                continue;
            }
            let to_mm = [here[index][0] + 0.01 * size, here[index][1] - 0.006 * size];
            let grip = Grip {
                joint: joint.name.clone(),
                to_mm,
                step_mm: 1e-4 * size,
                is_free: true,
                poses: poses(&old, pose),
            };
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
    let desk = tempfile::tempdir().unwrap();
    let folder = Folder::new(desk.path()).unwrap();
    let template = find_template("slider-crank").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let old = record(&texts).unwrap();
    let model = Model::from_text("model.toml", template.model).unwrap();
    let pose = POSITIONS / 4;
    let index = model.joints.iter().position(|joint| joint.name == "gudgeon").unwrap();
    let [x, y] = at_mm(&old, index, pose);
    // Beside the guide, too: the pin stays on its line.
    let grip = Grip {
        joint: "gudgeon".into(),
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
    // Comments and all else stay: one number of the model changes, and its place in the study.
    let InputFile::Study(study) = texts.read().unwrap() else { panic!("a study") };
    let is_scattered = study.random.iter().any(|input| input.path == "parameter.rod_length");
    assert_eq!(drag.study.is_some(), is_scattered);
    assert_eq!(drag.reshaped.changes.len(), if is_scattered { 2 } else { 1 });
}

#[test]
fn a_drag_that_is_of_another_model_is_refused() {
    let desk = tempfile::tempdir().unwrap();
    let folder = Folder::new(desk.path()).unwrap();
    let template = find_template("four-bar").unwrap();
    let texts = texts(&folder, template.model, template.study);
    let model = Model::from_text("model.toml", template.model).unwrap();
    let good = Grip {
        joint: model.joints[0].name.clone(),
        to_mm: [1.0, 2.0],
        step_mm: 1.0,
        is_free: false,
        poses: vec![[0.0; 3]; model.bodies.len()],
    };
    assert_eq!(gripped(&model, &texts, &good).reshaped.refusal, None);
    let wrong = [
        Grip { joint: "<script>".into(), ..good.clone() },
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
