//! Drags of other things than pins, over dead centres, and in what does not move yet: what is seen of them.

use loosepin::templates::find_template;

use super::reshape::{length, minus};
use super::restructured;
use super::structure::Edit;
use super::tests::{applied, served, texts};
use crate::drawing::still::NamedPoses;
use crate::files::folder::Folder;
use crate::messages::{Grip, Held, Look, LookAnswer, SentText, View};
use crate::view::look::look;
use crate::view::texts::Texts;

const POSITIONS: usize = 361;

fn looked(folder: &Folder, of: &Texts, grip: Option<Grip>, poses: Option<NamedPoses>) -> LookAnswer {
    let sent = |path: &str, text: &str| SentText { path: path.to_owned(), text: text.to_owned() };
    let study = of.study.as_ref().map(|study| sent("study.toml", study.text()));
    let of_texts = Look::of(sent("model.toml", of.model.text()), study, POSITIONS);
    look(folder, &Look { grip, poses, ..of_texts })
}

/// The motion as the page reads it.
fn motion(view: &View) -> serde_json::Value {
    serde_json::to_value(&view.drawing.as_ref().unwrap().motion).unwrap()
}

/// How many positions a drawing has: fewer than asked for, where that is enough to be seen.
fn count(view: &View) -> usize {
    motion(view)["angle_deg"].as_array().unwrap().len()
}

/// Poses of all bodies at a position, mm and degrees, as the page has them; without play.
fn poses(view: &View, position: usize) -> Vec<[f64; 3]> {
    let motion = motion(view);
    let bodies = motion["bodies"].as_array().unwrap();
    bodies.iter().map(|body| ["x", "y", "a"].map(|key| body[key][position].as_f64().unwrap())).collect()
}

/// Position of a point of a body at a position, mm.
fn at_mm(view: &View, body: &str, point: &str, position: usize) -> [f64; 2] {
    let index = view.outline.parts.iter().position(|part| part.name == body).unwrap();
    let own = view.outline.parts[index].points.iter().find(|own| own.name == point).unwrap();
    let [x, y, degrees] = poses(view, position)[index];
    let (sine, cosine) = degrees.to_radians().sin_cos();
    [x + cosine * own.x - sine * own.y, y + sine * own.x + cosine * own.y]
}

/// The position whose drive angle is nearest to what the answer says.
fn shown(seen: &LookAnswer) -> usize {
    let angle = seen.reshaped.as_ref().unwrap().angle_deg.unwrap();
    let motion = motion(seen.view.as_ref().unwrap());
    let angles = motion["angle_deg"].as_array().unwrap();
    let far = |position: &usize| (angles[*position].as_f64().unwrap() - angle).abs();
    (0..angles.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap()
}

fn changed(folder: &Folder, of: &Texts, seen: &LookAnswer) -> Texts {
    applied(folder, of, &seen.reshaped.as_ref().unwrap().changes)
}

#[test]
fn a_pin_that_is_dragged_over_a_dead_centre_stays_at_the_pointer() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let old = texts(&folder, template.model, template.study);
    let view = looked(&folder, &old, None, None).view.unwrap();
    for position in [0, count(&view) / 4, count(&view) * 2 / 3] {
        // Mirrored at the line from the pin of the crank to the pivot of the rocker: both lengths stay as they are.
        let [crank, pivot] = [at_mm(&view, "crank", "pin", position), at_mm(&view, "ground", "rocker_pivot", position)];
        let pin = at_mm(&view, "rocker", "pin", position);
        let along = minus(pivot, crank);
        let way = minus(pin, crank);
        let share = (way[0] * along[0] + way[1] * along[1]) / (along[0].powi(2) + along[1].powi(2));
        let to_mm = [0, 1].map(|axis| 2.0 * (crank[axis] + share * along[axis]) - pin[axis]);
        let held = Held::Joint { joint: "rocker_pin".into() };
        let grip = Grip { held, to_mm, step_mm: 0.01, is_free: true, poses: poses(&view, position) };
        let seen = looked(&folder, &old, Some(grip), None);
        let new = seen.view.as_ref().unwrap();
        let far_mm = length(minus(at_mm(new, "rocker", "pin", shown(&seen)), to_mm));
        // The other closure would be twice the height of the triangle away, which is more than 100 mm.
        assert!(far_mm < 3.0, "{position}: {far_mm} mm from the pointer, {:?}", seen.reshaped);
        // One number changes: the guess, in whole degrees. The texts alone say the same.
        let text = changed(&folder, &old, &seen);
        let lines = |texts: &Texts| texts.model.text().lines().map(str::to_owned).collect::<Vec<_>>();
        let (before, after) = (lines(&old), lines(&text));
        let different: Vec<&String> =
            after.iter().zip(&before).filter(|(new, old)| new != old).map(|(new, _)| new).collect();
        assert!(before.len() == after.len() && different.len() == 1, "{different:?}");
        assert!(different[0].starts_with("guess = { rocker = \"-"), "{different:?}");
        let again = looked(&folder, &text, None, None).view.unwrap();
        let nearest = (0..count(&again)).map(|position| length(minus(at_mm(&again, "rocker", "pin", position), to_mm)));
        assert!(nearest.fold(f64::INFINITY, f64::min) < 3.0);
    }
}

#[test]
fn a_closure_that_the_model_does_not_let_be_written_is_said() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let model = template.model.replace("rocker = \"94 deg\"", "rocker = \"90 deg + 4 deg\"");
    assert!(model != template.model);
    let old = texts(&folder, &model, template.study);
    let view = looked(&folder, &old, None, None).view.unwrap();
    let [x, y] = at_mm(&view, "rocker", "pin", 0);
    let held = Held::Joint { joint: "rocker_pin".into() };
    let grip = Grip { held, to_mm: [x, -y], step_mm: 1.0, is_free: false, poses: poses(&view, 0) };
    let seen = looked(&folder, &old, Some(grip), None);
    let words = &seen.reshaped.as_ref().unwrap().words;
    assert!(words.iter().any(|words| words.contains("the other way round")), "{words:?}");
}

#[test]
fn a_guide_is_turned_in_steps_of_fifteen_degrees() {
    let (_desk, folder) = served();
    let template = find_template("slider-crank").unwrap();
    let old = texts(&folder, template.model, template.study);
    let view = looked(&folder, &old, None, None).view.unwrap();
    let turned = |degrees: f64, is_free: bool| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let held = Held::Guide { joint: "guide".into() };
        let to_mm = [80.0 * cosine, 80.0 * sine];
        looked(&folder, &old, Some(Grip { held, to_mm, step_mm: 1.0, is_free, poses: poses(&view, 0) }), None)
    };
    for (degrees, is_free, written) in [(38.0, false, "45 deg"), (37.0, false, "30 deg"), (38.4, true, "38 deg")] {
        let seen = turned(degrees, is_free);
        let text = changed(&folder, &old, &seen);
        let guide = format!("guide = {{ point = \"ground.o\", angle = \"{written}\" }}");
        assert!(text.model.text().contains(&guide), "{degrees}: {}", text.model.text());
        // The block goes along a line at this angle.
        let new = seen.view.unwrap();
        let way = minus(at_mm(&new, "slider", "pin", 0), at_mm(&new, "slider", "pin", 90));
        let angle: f64 = written.trim_end_matches(" deg").parse().unwrap();
        assert!((way[1].atan2(way[0]) - angle.to_radians()).sin().abs() < 1e-4, "{way:?}");
    }
    // A pin has no line.
    let held = Held::Guide { joint: "gudgeon".into() };
    let grip = Grip { held, to_mm: [1.0, 2.0], step_mm: 1.0, is_free: false, poses: poses(&view, 0) };
    let refusal = looked(&folder, &old, Some(grip), None).reshaped.unwrap().refusal;
    assert!(refusal.is_some_and(|words| words.contains("no line")));
}

#[test]
fn a_point_that_no_joint_holds_goes_where_it_is_dragged() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let model = template.model.replace("tracer = [\"coupler_length / 2\"", "tracer = [\"130 mm\"");
    assert!(model != template.model);
    let old = texts(&folder, &model, template.study);
    let view = looked(&folder, &old, None, None).view.unwrap();
    let [x, y] = at_mm(&view, "coupler", "tracer", 120);
    let held = Held::Point { body: "coupler".into(), point: "tracer".into() };
    let to_mm = [x + 12.0, y - 7.0];
    let grip = Grip { held, to_mm, step_mm: 0.01, is_free: true, poses: poses(&view, 120) };
    let seen = looked(&folder, &old, Some(grip), None);
    let new = seen.view.as_ref().unwrap();
    assert!(length(minus(at_mm(new, "coupler", "tracer", 120), to_mm)) < 0.1, "{:?}", seen.reshaped);
    // Nothing else moves.
    assert!(length(minus(at_mm(new, "rocker", "pin", 120), at_mm(&view, "rocker", "pin", 120))) < 1e-6);
}

#[test]
fn what_does_not_move_yet_is_dragged_where_it_lies() {
    let (_desk, folder) = served();
    let template = find_template("four-bar").unwrap();
    let old = texts(&folder, template.model, template.study);
    let view = looked(&folder, &old, None, None).view.unwrap();
    let start = |view: &View| -> NamedPoses {
        view.outline.parts.iter().map(|part| part.name.clone()).zip(poses(view, 0)).collect()
    };
    let edit: Edit = serde_json::from_value(serde_json::json!({
        "kind": "add_link", "from": {"at": "point", "body": "coupler", "point": "tracer"}, "to": {"at": "free", "x": 300.0, "y": 260.0}
    }))
    .unwrap();
    let mut places = start(&view);
    let done = restructured(&folder, &old, &edit, &places).unwrap_or_else(|refusal| panic!("{}", refusal.message));
    places.extend(done.poses.clone());
    let built = applied(&folder, &old, &done.changes);
    let view = looked(&folder, &built, None, Some(places.clone())).view.unwrap();
    assert!(view.incomplete.is_some(), "a loose link has a freedom more than there are drives");
    let part = view.outline.parts.iter().find(|part| part.name == "link_1").unwrap();
    let free = part
        .points
        .iter()
        .map(|point| point.name.clone())
        .find(|point| !view.outline.joints.iter().any(|joint| joint.points.contains(&format!("link_1.{point}"))));
    let free = free.unwrap();
    let to_mm = [250.0, 300.0];
    let grip = Grip {
        held: Held::Point { body: "link_1".into(), point: free.clone() },
        to_mm,
        step_mm: 0.01,
        is_free: true,
        poses: poses(&view, 0),
    };
    let seen = looked(&folder, &built, Some(grip), Some(places));
    let new = seen.view.as_ref().unwrap();
    assert!(new.incomplete.is_some());
    assert!(length(minus(at_mm(new, "link_1", &free, 0), to_mm)) < 0.1, "{:?}", seen.reshaped);
    // Its other end stays at the tracer.
    let other = part.points.iter().find(|point| point.name != free).unwrap();
    let gap = minus(at_mm(new, "link_1", &other.name, 0), at_mm(new, "coupler", "tracer", 0));
    assert!(length(gap) < 1e-3, "{gap:?}");
}
