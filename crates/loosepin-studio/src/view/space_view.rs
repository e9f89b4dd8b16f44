//! A mechanism in space as the page shows it. It is turned and moved there; its links and joints are changed in the text.

use std::sync::atomic::{AtomicBool, Ordering};

use loosepin::check::mobility_in_space;
use loosepin::diagnostics::Diagnostics;
use loosepin::report::{live_spatial_bands, spatial_motion_drawing, spatial_motion_sentences};
use loosepin::result::spatial_motion::SpatialMotionRecord;
use loosepin::space::{ModelJoint, SpatialModel};
use loosepin::study::InputFile;
use loosepin::units::{Dimension, format_value};

use super::limits::banded_limits;
use super::quantities::quantities;
use super::texts::Texts;
use super::title::title;
use crate::messages::{BodyView, JointView, Outline, OutputView, View};

/// The view, and what is wrong although there is one: the motion without what scatters, where that has no answer. Where `stop` is set, it
/// comes to its end soon, and is good for nothing.
pub fn space_view(
    file: &InputFile,
    model: &SpatialModel,
    texts: &Texts,
    stop: &AtomicBool,
) -> (Option<View>, Diagnostics) {
    let is_stopped = || stop.load(Ordering::Relaxed);
    match file.play_in_space(model, &[], false, &is_stopped) {
        Ok(mut record) => {
            let found = file.add_scatter(model, &[], &mut record, &is_stopped).err().unwrap_or_default();
            (Some(view(file, model, &record, texts)), found)
        }
        Err(found) => (None, found),
    }
}

fn view(file: &InputFile, model: &SpatialModel, record: &SpatialMotionRecord, texts: &Texts) -> View {
    let (lines, limits) = banded_limits(file, texts);
    View {
        title: title(file),
        mobility: mobility_in_space(model).unwrap_or_default(),
        incomplete: None,
        sentences: spatial_motion_sentences(record),
        drawing: None,
        space: spatial_motion_drawing(record),
        bands: live_spatial_bands(record, &lines),
        paths: Vec::new(),
        curves: Vec::new(),
        curve: None,
        drive_range_deg: None,
        limits,
        outline: outline(model, record),
        quantities: quantities(&model.quantities, texts),
    }
}

fn outline(model: &SpatialModel, record: &SpatialMotionRecord) -> Outline {
    let outputs = record.outputs.iter();
    Outline {
        bodies: model.bodies.iter().skip(1).map(|body| body.name.clone()).collect(),
        joints: model.joints.iter().map(|joint| seen_joint(model, joint)).collect(),
        drives: model.drives.iter().map(|drive| drive.name.clone()).collect(),
        outputs: outputs.map(|own| OutputView { name: own.name.clone(), words: own.words.clone() }).collect(),
        forces: Vec::new(),
        parts: model.bodies.iter().map(|body| BodyView { name: body.name.clone(), points: Vec::new() }).collect(),
        dimensions: Vec::new(),
        loops: Vec::new(),
    }
}

fn seen_joint(model: &SpatialModel, joint: &ModelJoint) -> JointView {
    let values = model.quantities.nominal();
    let radial = joint.play.and_then(|play| play.clearances_m()[0]).map(|id| values[id]);
    let play = radial.filter(|clearance_m| *clearance_m > 0.0);
    JointView {
        name: joint.name.clone(),
        kind: joint.kind.word(),
        play: play.map(|clearance_m| format!("c = {}", format_value(clearance_m, Dimension::LENGTH))),
        takes_play: !joint.kind.play_keys().is_empty(),
        pin: None,
        points: [joint.bearing.point, joint.journal.point].map(|point| model.point_name(point)),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use crate::files::folder::Folder;
    use crate::messages::{Look, SentText};
    use crate::view::look::answer_look;
    use loosepin::templates::find_template;

    #[test]
    fn a_look_at_a_mechanism_in_space_ends_where_it_is_stopped() {
        let desk = tempfile::tempdir().unwrap();
        let folder = Folder::new(desk.path()).unwrap();
        let template = find_template("six-axis-arm").unwrap();
        let sent = |path: &str, text: &str| SentText { path: path.to_owned(), text: text.to_owned() };
        let look = Look::of(sent("model.toml", template.model), Some(sent("study.toml", template.study)), 36);
        let seen = |is_stopped: bool| answer_look(&folder, &look, &AtomicBool::new(is_stopped)).0;
        assert!(seen(false).view.is_some());
        let stopped = seen(true);
        assert!(stopped.view.is_none() && stopped.diagnostics[0].message.contains("stopped"), "{stopped:?}");
    }
}
