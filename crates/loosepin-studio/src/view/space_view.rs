//! A mechanism in space as the page shows it. It is turned and moved there; its links and joints are changed in the text.

use loosepin::space::{ModelJoint, SpatialModel};
use loosepin::units::{Dimension, format_value};

use crate::messages::{BodyView, JointView, Outline, OutputView};

/// What it consists of.
pub fn space_outline(model: &SpatialModel, outputs: Vec<OutputView>) -> Outline {
    Outline {
        bodies: model.bodies.iter().skip(1).map(|body| body.name.clone()).collect(),
        joints: model.joints.iter().map(|joint| seen_joint(model, joint)).collect(),
        drives: model.drives.iter().map(|drive| drive.name.clone()).collect(),
        outputs,
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
