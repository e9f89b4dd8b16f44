//! From texts to what the page shows of them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use loosepin::diagnostics::Diagnostics;
use loosepin::model::Model;
use loosepin::report::{
    CurveKey, live_bands, live_curve, live_curves, live_paths, motion_drawing, motion_sentences, moving_drawing,
};
use loosepin::result::kinematics::LoopProperties;
use loosepin::result::motion::MotionRecord;
use loosepin::result::simulation::{Drawing, DrawnBody, DrawnJoint, DrawnPoint};
use loosepin::study::InputFile;
use loosepin::units::{Dimension, format_value};

use crate::drawing::dimensions::dimensions;
use crate::drawing::forces::forces;
use crate::drawing::still::{NamedPoses, placed, still_drawing};
use crate::edit::{DragOutcome, gripped, kept_closure, nearest, refused_drag, why_not};
use crate::files::folder::Folder;
use crate::messages::{
    BodyView, JointView, Look, LookAnswer, Outline, OutputView, PinView, PointView, QuantityView, View,
};
use crate::view::diagnostics::diagnostic_views;
use crate::view::limits::banded_limits;
use crate::view::quantities::quantities;
use crate::view::space_view::{seen_motion, space_outline};
use crate::view::texts::Texts;
use crate::view::title::title;

const MM_PER_M: f64 = 1e3;
/// Largest number of instants shown of a run that is followed for a drawing.
const CONTROLLED_POSITIONS: usize = 121;
/// What is said of a drag whose loops close elsewhere, where no guess of the model can be changed.
const OTHER_CLOSURE: &str = "the links close the other way round here: [assembly] guess says how, in the text";
/// Points that are traced, at most.
const MAX_TRACED: usize = 16;
/// Fewest and most positions in a turn.
const POSITIONS: [usize; 2] = [12, 720];

/// Reads the texts of the page, changed as a drag changes them. A study that cannot be read does not hide its model.
/// Where `stop` is set, it comes to its end soon, and its answer is good for nothing. Beside the answer stand the texts that it shows.
pub fn answer_look(folder: &Folder, look: &Look, stop: &AtomicBool) -> (LookAnswer, Texts) {
    let began = Instant::now();
    let before = Texts::sent(folder, look);
    let drag = look.grip.as_ref().map(|grip| match before.planar_model() {
        Ok(model) => gripped(&model, &before, grip),
        Err(refusal) => refused_drag(refusal.in_words()),
    });
    let (mut seen, mut texts, drawing) = seen_after(folder, look, &before, drag.as_ref(), stop);
    if let (Some(grip), Some(drag), Some(drawing)) = (&look.grip, &drag, &drawing)
        && let Some(kept) = kept_closure(folder, &before, grip, drag, drawing, stop)
    {
        match (kept.drag, &mut seen.reshaped) {
            (Some(drag), _) => (seen, texts, _) = seen_after(folder, look, &before, Some(&drag), stop),
            (None, Some(reshaped)) => reshaped.words.push(OTHER_CLOSURE.to_owned()),
            (None, None) => {}
        }
    }
    seen.cost_ms = began.elapsed().as_secs_f64() * 1e3;
    (seen, texts)
}

/// What is seen of texts after a drag, these texts, and the mechanism where it moves.
fn seen_after(
    folder: &Folder,
    look: &Look,
    before: &Texts,
    drag: Option<&DragOutcome>,
    stop: &AtomicBool,
) -> (LookAnswer, Texts, Option<Drawing>) {
    let texts = match drag {
        Some(drag) => before.with(folder, drag.model.as_deref(), drag.study.as_deref()),
        None => Texts { model: before.model.clone(), study: before.study.clone() },
    };
    let mut diagnostics = Diagnostics::new();
    let file = texts.read().or_else(|found| {
        diagnostics.extend(found);
        // Reading the model alone: its own diagnostics are told already.
        Texts { model: texts.model.clone(), study: None }.read()
    });
    let mut reshaped = drag.map(|drag| drag.reshaped.clone());
    let mut drawing = None;
    let view = file.ok().and_then(|file| {
        file.warnings().iter().for_each(|warning| diagnostics.push(warning.clone()));
        if let Some(model) = file.model().spatial() {
            let (record, found) = seen_motion(&file, model, stop);
            diagnostics.extend(found);
            return record.map(|record| {
                let mechanism = (space_outline(model, outputs(&record)), quantities(&model.quantities, &texts));
                view(&file, &record, mechanism, look.curve.as_ref(), &texts)
            });
        }
        let model = file.model().planar()?;
        let positions = look.positions.clamp(POSITIONS[0], POSITIONS[1]);
        match file.ideal_motion_until(positions, &[], &known_points(model, &look.traced), stop) {
            Ok(record) => {
                if let (Some(reshaped), Some(drag)) = (&mut reshaped, drag) {
                    reshaped.angle_deg = nearest(drag, &record.drawing).map(|found| found.angle_deg);
                }
                let outline = outline(model, &record.drawing, outputs(&record), &record.kinematics.loops);
                let mechanism = (outline, quantities(&model.quantities, &texts));
                let view = view(&file, &record, mechanism, look.curve.as_ref(), &texts);
                drawing = Some(record.drawing);
                Some(view)
            }
            Err(_) if stop.load(Ordering::Relaxed) => None,
            Err(found) => file
                .controlled_drawing(positions.min(CONTROLLED_POSITIONS))
                .map(|drawing| controlled((&file, model), &drawing, &texts))
                .or_else(|| {
                    let view = look.poses.as_ref().map(|poses| {
                        let mut poses = poses.clone();
                        poses.extend(reshaped.iter().flat_map(|reshaped| reshaped.poses.clone()));
                        incomplete((&file, model), &found, &poses, &texts)
                    });
                    diagnostics.extend(found);
                    view
                }),
        }
    });
    let diagnostics = diagnostic_views(&diagnostics, &texts);
    (LookAnswer { seq: look.seq, diagnostics, view, reshaped, cost_ms: 0.0, is_cut: false }, texts, drawing)
}

/// As [`answer_look`], to its end.
#[cfg(test)]
pub fn look(folder: &Folder, look: &Look) -> LookAnswer {
    answer_look(folder, look, &AtomicBool::new(false)).0
}

/// The answer to a look that took longer than it may.
pub fn cut(look: &Look, limit: Duration) -> LookAnswer {
    let cost_ms = limit.as_secs_f64() * 1e3;
    LookAnswer { seq: look.seq, diagnostics: Vec::new(), view: None, reshaped: None, cost_ms, is_cut: true }
}

/// The points among `names` that the model has.
fn known_points(model: &Model, names: &[String]) -> Vec<String> {
    let known = names.iter().filter(|name| model.points_of_paths(std::slice::from_ref(name)).is_ok());
    known.take(MAX_TRACED).cloned().collect()
}

fn view(
    file: &InputFile,
    record: &MotionRecord,
    (outline, quantities): (Outline, Vec<QuantityView>),
    curve: Option<&CurveKey>,
    texts: &Texts,
) -> View {
    let (lines, limits) = banded_limits(file, texts);
    let (drawing, space) = motion_drawing(record);
    View {
        title: title(file),
        mobility: record.mobility.clone(),
        incomplete: None,
        sentences: motion_sentences(record),
        drawing,
        space,
        bands: live_bands(record, &lines),
        paths: live_paths(record),
        curves: live_curves(record),
        curve: curve.and_then(|wanted| live_curve(record, wanted)),
        drive_range_deg: drive_range_deg(record),
        limits,
        outline,
        quantities,
    }
}

/// What actuators move has a drawing, and no band: that is of mechanisms that drives alone move.
fn controlled(file: (&InputFile, &Model), drawing: &Drawing, texts: &Texts) -> View {
    let sentence = "Its motion follows from the forces of its actuators: what play does to it is seen in a run alone.";
    let view = drawn(file, drawing, "Moved by its actuators".to_owned(), texts);
    View { sentences: vec![sentence.to_owned()], ..view }
}

/// What does not move yet is drawn where its bodies were put.
fn incomplete((file, model): (&InputFile, &Model), found: &Diagnostics, poses: &NamedPoses, texts: &Texts) -> View {
    let words = why_not(file, found);
    let view = drawn((file, model), &still_drawing(model, &placed(model, poses)), words.clone(), texts);
    View { incomplete: Some(words), ..view }
}

/// A mechanism without an ideal motion: its drawing and its texts.
fn drawn((file, model): (&InputFile, &Model), drawing: &Drawing, mobility: String, texts: &Texts) -> View {
    View {
        title: title(file),
        mobility,
        incomplete: None,
        sentences: Vec::new(),
        drawing: moving_drawing(drawing, "the cycle"),
        space: None,
        bands: Vec::new(),
        paths: Vec::new(),
        curves: Vec::new(),
        curve: None,
        drive_range_deg: None,
        limits: Vec::new(),
        outline: outline(model, drawing, named_outputs(model), &[]),
        quantities: quantities(&model.quantities, texts),
    }
}

fn named_outputs(model: &Model) -> Vec<OutputView> {
    model.outputs.iter().map(|output| OutputView { name: output.name.clone(), words: output.name.clone() }).collect()
}

fn outputs(record: &MotionRecord) -> Vec<OutputView> {
    // An error of a path belongs to its output, and has no value of its own.
    let outputs = record.outputs.iter().filter(|output| !output.value_si.is_empty());
    let outputs = outputs.map(|output| (&output.name, &output.words));
    let outputs = outputs.chain(record.efforts.iter().map(|effort| (&effort.name, &effort.words)));
    outputs.map(|(name, words)| OutputView { name: name.clone(), words: words.clone() }).collect()
}

/// The angles of the drive between which the loops close, degrees; `None` where it can go through its whole turn.
fn drive_range_deg(record: &MotionRecord) -> Option<[f64; 2]> {
    // Without a speed it is no angle that the records stand at.
    record.drive_speed_rad_s?;
    if record.is_whole_turn() {
        return None;
    }
    let (first, last) = (*record.drive_angle_rad.first()?, *record.drive_angle_rad.last()?);
    // The ends are between the angles that are recorded: they are the dead points there.
    let ends = record.singular_positions.iter().map(|end| end.drive_angle_rad);
    let lower = ends.clone().filter(|end| *end <= first).fold(f64::NEG_INFINITY, f64::max);
    let upper = ends.filter(|end| *end >= last).fold(f64::INFINITY, f64::min);
    Some(
        [(lower, first), (upper, last)]
            .map(|(end, recorded)| if end.is_finite() { end } else { recorded }.to_degrees()),
    )
}

fn outline(model: &Model, drawing: &Drawing, outputs: Vec<OutputView>, loops: &[LoopProperties]) -> Outline {
    let point =
        |point: &DrawnPoint| PointView { name: point.name.clone(), x: point.x_m * MM_PER_M, y: point.y_m * MM_PER_M };
    let part = |body: &DrawnBody| BodyView { name: body.name.clone(), points: body.points.iter().map(point).collect() };
    Outline {
        bodies: drawing.bodies.iter().filter(|body| !body.is_ground).map(|body| body.name.clone()).collect(),
        joints: drawing.joints.iter().map(|joint| seen_joint(drawing, joint)).collect(),
        drives: drawing.drives.iter().map(|drive| drive.name.clone()).collect(),
        outputs,
        forces: forces(model),
        parts: drawing.bodies.iter().map(part).collect(),
        dimensions: dimensions(model),
        loops: loops.iter().map(LoopProperties::words).collect(),
    }
}

fn seen_joint(drawing: &Drawing, joint: &DrawnJoint) -> JointView {
    let has_play = joint.radial_clearance_m > 0.0;
    let is_pin = joint.kind.turns();
    let point = drawing.bodies.get(joint.first.body).and_then(|body| body.points.get(joint.first.point));
    JointView {
        name: joint.name.clone(),
        kind: joint.kind.words(),
        play: has_play.then(|| format!("c = {}", format_value(joint.radial_clearance_m, Dimension::LENGTH))),
        takes_play: is_pin,
        pin: point.filter(|_| is_pin).map(|point| PinView {
            body: joint.first.body,
            x: point.x_m * MM_PER_M,
            y: point.y_m * MM_PER_M,
        }),
        points: [joint.first, joint.second].map(|end| {
            let body = drawing.bodies.get(end.body);
            let point = body.and_then(|body| body.points.get(end.point));
            body.zip(point).map(|(body, point)| format!("{}.{}", body.name, point.name)).unwrap_or_default()
        }),
    }
}
