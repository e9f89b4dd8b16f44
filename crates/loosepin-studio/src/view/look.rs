//! From texts to what the page shows of them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use loosepin::diagnostics::Diagnostics;
use loosepin::report::{
    CurveKey, live_bands, live_curve, live_curves, live_paths, motion_drawing, motion_sentences, moving_drawing,
};
use loosepin::result::motion::MotionRecord;
use loosepin::result::simulation::Drawing;
use loosepin::study::{InputFile, StudyModel};

use crate::drawing::still::NamedPoses;
use crate::edit::{DragOutcome, gripped, kept_closure, nearest, refused_drag, why_not};
use crate::files::folder::Folder;
use crate::messages::{Look, LookAnswer, Outline, OutputView, QuantityView, View};
use crate::view::diagnostics::diagnostic_views;
use crate::view::limits::banded_limits;
use crate::view::quantities::quantities;
use crate::view::seen_model::{Moved, seen};
use crate::view::texts::Texts;
use crate::view::title::title;

/// Largest number of instants shown of a run that is followed for a drawing.
const CONTROLLED_POSITIONS: usize = 121;
/// What is said of a drag whose loops close elsewhere, where no guess of the model can be changed.
const OTHER_CLOSURE: &str = "the links close the other way round here: [assembly] guess says how, in the text";
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
        let model = seen(file.model());
        let positions = look.positions.clamp(POSITIONS[0], POSITIONS[1]);
        let (record, found) = file.ideal_motion_with_findings(positions, &model.traced_points(&look.traced), stop);
        if let Some(record) = record {
            diagnostics.extend(found);
            if let (Some(reshaped), Some(drag), true) = (&mut reshaped, drag, model.takes_drags()) {
                reshaped.angle_deg = nearest(drag, &record.drawing).map(|found| found.angle_deg);
            }
            let outline = model.outline(Moved::of(&record), outputs(&record));
            let quantities = quantities(file.model().quantities(), &texts);
            let view = view(&file, &record, outline, quantities, look.curve.as_ref(), &texts);
            drawing = Some(record.drawing).filter(|_| model.takes_drags());
            return Some(view);
        }
        if stop.load(Ordering::Relaxed) {
            diagnostics.extend(found);
            return None;
        }
        let controlled = file.controlled_drawing(positions.min(CONTROLLED_POSITIONS));
        controlled.map(|drawing| controlled_view(&file, &drawing, &texts)).or_else(|| {
            let view = look.poses.as_ref().and_then(|poses| {
                let mut poses = poses.clone();
                poses.extend(reshaped.iter().flat_map(|reshaped| reshaped.poses.clone()));
                incomplete(&file, &found, &poses, &texts)
            });
            diagnostics.extend(found);
            view
        })
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

fn view(
    file: &InputFile,
    record: &MotionRecord,
    outline: Outline,
    quantities: Vec<QuantityView>,
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
fn controlled_view(file: &InputFile, drawing: &Drawing, texts: &Texts) -> View {
    let sentence = "Its motion follows from the forces of its actuators: what play does to it is seen in a run alone.";
    let view = drawn(file, drawing, "Moved by its actuators".to_owned(), texts);
    View { sentences: vec![sentence.to_owned()], ..view }
}

/// What does not move yet is drawn where its bodies were put, if it can be.
fn incomplete(file: &InputFile, found: &Diagnostics, poses: &NamedPoses, texts: &Texts) -> Option<View> {
    let drawing = seen(file.model()).still_drawing(poses)?;
    let words = why_not(file, found);
    let view = drawn(file, &drawing, words.clone(), texts);
    Some(View { incomplete: Some(words), ..view })
}

/// A mechanism without an ideal motion: its drawing and its texts.
fn drawn(file: &InputFile, drawing: &Drawing, mobility: String, texts: &Texts) -> View {
    let model = file.model();
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
        outline: seen(model).outline(Moved { drawing, loops: &[] }, named_outputs(model)),
        quantities: quantities(model.quantities(), texts),
    }
}

fn named_outputs(model: &StudyModel) -> Vec<OutputView> {
    let name = |name: &str| OutputView { name: name.to_owned(), words: name.to_owned() };
    model.output_names().into_iter().map(name).collect()
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
