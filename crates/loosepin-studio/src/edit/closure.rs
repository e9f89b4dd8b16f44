//! Loops that would close the other way round after a drag: the guesses of the model follow, so that they close where the drag left them.
//!
//! Lengths alone do not say on which side of a line two links meet; `[assembly] guess` does, for the start of the cycle. So the mechanism is
//! begun at the shown position, with its bodies at the angles that the drag left them at, and turned back to the start: there the angles
//! are read that the guesses become, in whole degrees.

use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use loosepin::model::{Model, QuantityId};
use loosepin::result::simulation::Drawing;

use super::grip::{DragOutcome, gripped_closing, number};
use super::nearest::{Nearest, nearest};
use super::reshape::{length, minus};
use super::toml::pieces::Replacements;
use crate::files::folder::Folder;
use crate::messages::Grip;
use crate::view::places::unquoted;
use crate::view::texts::Texts;

/// Joints that lie farther from where they were left than this share of the mechanism may be those of another closure.
const FAR_SHARE: f64 = 0.05;
/// Another closure is the one that was dragged where it leaves no more than this share of the distance.
const KEPT_SHARE: f64 = 0.5;
/// Positions on the way back to the start.
const POSITIONS: usize = 121;

/// A drag whose loops close where it left them.
pub struct PreservedClosure {
    /// The drag, with the new guesses; `None` if the model does not let them be written.
    pub drag: Option<DragOutcome>,
}

/// The drag with other guesses, where the loops of the mechanism in `drawing` close elsewhere than the drag left them, and others close
/// there.
pub fn kept_closure(
    folder: &Folder,
    before: &Texts,
    grip: &Grip,
    drag: &DragOutcome,
    drawing: &Drawing,
    stop: &AtomicBool,
) -> Option<PreservedClosure> {
    let found = nearest(drag, drawing).filter(|found| is_far(found, drag))?;
    let model = Model::from_source(Arc::clone(&before.model)).ok()?;
    let [drive] = &model.drives[..] else { return None };
    let kind = &model.joints[drive.joint.0].kind;
    let ([bearing, journal], true) = (kind.bodies(), kind.turns()) else { return None };
    let start = model.quantities.id(&format!("drive.{}.start_angle", drive.name))?;
    let shown_rad = drag.angle_rad(journal.0)? - drag.angle_rad(bearing.0)?;
    let new = before.with(folder, drag.model.as_deref(), drag.study.as_deref());
    let new_model = Model::from_source(Arc::clone(&new.model)).ok()?;
    // Begun at the shown position.
    let mut begun = Replacements::new(new.model.text());
    let mut set = |quantity: QuantityId, angle_rad: f64| {
        let span = new_model.quantities[quantity].span?;
        begun.replace(unquoted(&new.model, span), &format!("{} deg", angle_rad.to_degrees())).ok()
    };
    set(start, shown_rad)?;
    for guess in &model.guesses {
        set(guess.angle_rad, drag.angle_rad(guess.body.0)?)?;
    }
    let begun = new.with(folder, begun.text().as_deref(), None);
    let turned = begun.read().ok()?.ideal_motion_until(POSITIONS, &[], &[], stop).ok()?.drawing;
    if nearest(drag, &turned)?.far_m > KEPT_SHARE * found.far_m {
        return None;
    }
    let start_rad = new_model.quantities.nominal()[start];
    let guesses: Vec<(QuantityId, f64)> = model
        .guesses
        .iter()
        .map(|guess| Some((guess.angle_rad, whole_degrees(angle_at(&turned, guess.body.0, start_rad)?))))
        .collect::<Option<_>>()?;
    let is_written = !guesses.is_empty() && guesses.iter().all(|(id, _)| number(&model, before, *id).is_some());
    Some(PreservedClosure { drag: is_written.then(|| gripped_closing(&model, before, grip, &guesses)) })
}

fn is_far(found: &Nearest, drag: &DragOutcome) -> bool {
    let due_m = drag.expected_m();
    let apart = due_m.iter().flat_map(|one| due_m.iter().map(move |other| length(minus(*one, *other))));
    found.far_m > FAR_SHARE * apart.fold(0.0, f64::max)
}

/// The angle of a body where the drive is at `drive_rad`, or whole turns from it, rad; between two poses it goes straight.
fn angle_at(drawing: &Drawing, body: usize, drive_rad: f64) -> Option<f64> {
    let poses = &drawing.poses;
    let angles_rad = &poses.drive_angle_rad;
    let own_rad = poses.angle_rad.get(body)?;
    let (first, last) = (*angles_rad.first()?, *angles_rad.last()?);
    let turns = ((0.5 * (first + last) - drive_rad) / TAU).round();
    let due_rad = drive_rad + turns * TAU;
    (1..angles_rad.len().min(own_rad.len())).find_map(|pose| {
        let (from, to) = (angles_rad[pose - 1], angles_rad[pose]);
        let share = (due_rad - from) / (to - from);
        (0.0..=1.0).contains(&share).then(|| own_rad[pose - 1] + share * (own_rad[pose] - own_rad[pose - 1]))
    })
}

/// The nearest whole degrees within half a turn, rad.
fn whole_degrees(angle_rad: f64) -> f64 {
    let within = angle_rad - TAU * (angle_rad / TAU).round();
    within.to_degrees().round().to_radians()
}
