//! From texts to what the page shows of them.

use std::time::Instant;

use loosepin::diagnostics::{Complaint, Complaints};
use loosepin::report::{live_bands, motion_sentences, moving_drawing};
use loosepin::result::motion::MotionRecord;
use loosepin::result::simulation::{DrawnJoint, DrawnJointKind};
use loosepin::study::InputFile;
use loosepin::units::{Dimension, format_value};

use crate::complaints::seen;
use crate::folder::Folder;
use crate::messages::{Look, Outline, Seen, SeenJoint, SeenOutput, View};
use crate::quantities::quantities;
use crate::texts::Texts;

/// Fewest and most positions in a turn.
const POSITIONS: [usize; 2] = [12, 720];

/// Reads the texts of the page. A study that cannot be read does not hide its model.
pub fn look(folder: &Folder, look: &Look) -> Seen {
    let began = Instant::now();
    let texts = Texts::sent(folder, look);
    let mut complaints = Complaints::new();
    let file = texts.read().or_else(|found| {
        complaints.extend(found);
        // Reading the model alone: its own complaints are told already.
        Texts { model: texts.model.clone(), study: None }.read()
    });
    let view = file.ok().and_then(|file| {
        let warnings = match &file {
            InputFile::Model(model) => &model.warnings,
            InputFile::Study(study) => &study.warnings,
        };
        warnings.iter().for_each(|warning: &Complaint| complaints.push(warning.clone()));
        let positions = look.positions.clamp(POSITIONS[0], POSITIONS[1]);
        match file.ideal_motion(positions, &[]) {
            Ok(record) => Some(view(&file, &record, &texts)),
            Err(found) => {
                complaints.extend(found);
                None
            }
        }
    });
    let complaints = seen(&complaints, &texts);
    Seen { seq: look.seq, complaints, view, cost_ms: began.elapsed().as_secs_f64() * 1e3 }
}

fn view(file: &InputFile, record: &MotionRecord, texts: &Texts) -> View {
    View {
        title: match file {
            InputFile::Model(model) => model.name.clone(),
            InputFile::Study(study) => study.name.clone(),
        },
        mobility: record.mobility.clone(),
        sentences: motion_sentences(record),
        drawing: moving_drawing(&record.drawing, &record.drive),
        bands: live_bands(record),
        outline: outline(record),
        quantities: quantities(file.model(), texts),
    }
}

fn outline(record: &MotionRecord) -> Outline {
    let drawing = &record.drawing;
    // An error of a path belongs to its output, and has no value of its own.
    let outputs = record.outputs.iter().filter(|output| !output.value_si.is_empty());
    let outputs = outputs.map(|output| (&output.name, &output.words));
    let outputs = outputs.chain(record.efforts.iter().map(|effort| (&effort.name, &effort.words)));
    Outline {
        bodies: drawing.bodies.iter().filter(|body| !body.is_ground).map(|body| body.name.clone()).collect(),
        joints: drawing.joints.iter().map(joint).collect(),
        drives: drawing.drives.iter().map(|drive| drive.name.clone()).collect(),
        outputs: outputs.map(|(name, words)| SeenOutput { name: name.clone(), words: words.clone() }).collect(),
    }
}

fn joint(joint: &DrawnJoint) -> SeenJoint {
    let has_play = joint.radial_clearance_m > 0.0;
    SeenJoint {
        name: joint.name.clone(),
        kind: match joint.kind {
            DrawnJointKind::Revolute => "revolute joint",
            DrawnJointKind::RevoluteWithClearance => "revolute joint with play",
            DrawnJointKind::Prismatic => "sliding joint",
            DrawnJointKind::Slot => "pin in a slot",
            DrawnJointKind::Rigid => "rigid connection",
        },
        play: has_play.then(|| format!("c = {}", format_value(joint.radial_clearance_m, Dimension::LENGTH))),
    }
}
