//! A drag as a whole: from the texts and the pointer to the changes of the texts.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use loosepin::diagnostics::Source;
use loosepin::document::parse_toml;
use loosepin::model::{BodyId, Model, PointId, QuantityId, describe_path};
use loosepin::study::{number_and_unit, states_nominal, takes_mean_of_model};

use super::behind::{Setting, behind};
use super::guide::turned;
use super::reshape::PosedMechanism;
use super::structure::Locks;
use super::toml::pieces::Replacements;
use super::written::Written;
use crate::drawing::still::Pose;
use crate::messages::{Document, DragResult, Grip, Held};
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;
use crate::view::texts::Texts;

const M_PER_MM: f64 = 1e-3;
/// A number that is not to be round is written to this share of a step.
const FREE_SHARE: f64 = 0.02;
/// Largest distance of a drag, m.
const FURTHEST_M: f64 = 1e6;
/// Most points that lie at one centre: each is looked for in all joints.
const MAX_HELD: usize = 200;
/// Most coordinates that a drag changes: for each, all expressions of the model are evaluated.
const MAX_COORDINATES: usize = 400;
/// Keys of a distribution that say where it lies, beside its nominal value with a tolerance.
const PLACES: [&str; 4] = ["mean", "lower", "upper", "mode"];
const TOLERANCE: &str = "tolerance";

/// Outcome of a drag.
#[derive(Default)]
pub struct DragOutcome {
    /// The same for the page.
    pub reshaped: DragResult,
    /// The model as it is to be; `None` if it stays.
    pub model: Option<String>,
    /// The study as it is to be; `None` if it stays.
    pub study: Option<String>,
    /// Expected position of each joint, m: the dragged one at the pointer, the others where they were. Empty if a guide turns: all moves.
    expected_m: Vec<[f64; 2]>,
    /// Poses of all bodies as the drag leaves them.
    poses: Vec<Pose>,
}

impl DragOutcome {
    /// Expected position of each joint, m; empty if unknown.
    pub fn expected_m(&self) -> &[[f64; 2]] {
        &self.expected_m
    }

    /// Angle of a body as the drag leaves it, rad.
    pub fn angle_rad(&self, body: usize) -> Option<f64> {
        self.poses.get(body).map(|pose| pose.angle_rad)
    }
}

/// A drag that changes nothing, with the reason.
pub fn refused_drag(words: String) -> DragOutcome {
    DragOutcome { reshaped: DragResult { refusal: Some(words), ..DragResult::default() }, ..DragOutcome::default() }
}

/// What a drag moves.
struct Moved {
    /// Numbers that change, and their new values, SI.
    coordinates: Vec<(QuantityId, f64)>,
    /// Where each joint is to be, m; empty if that cannot be said.
    expected_m: Vec<[f64; 2]>,
    /// Poses of all bodies afterwards.
    poses: Vec<Pose>,
    /// Values are taken exactly, and not rounded to the step of the screen.
    is_exact: bool,
}

/// What a drag moves in a mechanism at some poses.
///
/// # Errors
/// In words: it holds nothing that can be moved.
fn moved(model: &Model, grip: &Grip, poses: &[Pose]) -> Result<Moved, String> {
    let to_m = grip.to_mm.map(|mm| mm * M_PER_MM);
    let posed = PosedMechanism::new(model, poses);
    let joint_of = |name: &str| {
        let found = model.joints.iter().position(|joint| joint.name == *name);
        found.ok_or_else(|| format!("joint '{name}' no longer exists"))
    };
    let held = match &grip.held {
        Held::Guide { joint } => {
            let coordinates = vec![turned(model, poses, joint_of(joint)?, to_m, grip.is_free)?];
            return Ok(Moved { coordinates, expected_m: Vec::new(), poses: poses.to_vec(), is_exact: true });
        }
        Held::Joint { joint } => {
            let index = joint_of(joint)?;
            if !model.joints[index].kind.turns() {
                return Err(format!("{joint} is not a pin: change its numbers in the list of numbers"));
            }
            posed.together(index)
        }
        Held::Point { body, point } => {
            let index = model.bodies.iter().position(|own| own.name == *body);
            let found = index.and_then(|index| {
                let place = model.bodies[index].points.iter().position(|own| own.name == *point)?;
                Some(PointId { body: BodyId(index), point: place })
            });
            vec![found.ok_or_else(|| format!("point '{body}.{point}' no longer exists"))?]
        }
    };
    if held.len() > MAX_HELD {
        return Err(format!("{} points lie here: at most {MAX_HELD} can be moved together", held.len()));
    }
    let to_m = posed.allowed_m(&held, posed.at_m(held[0]), to_m);
    let expected_m = (0..model.joints.len()).map(|index| {
        let first = model.joints[index].kind.points()[0];
        if held.contains(&first) { to_m } else { posed.at_m(first) }
    });
    Ok(Moved {
        coordinates: posed.moved(&held, to_m),
        expected_m: expected_m.collect(),
        poses: posed.poses_after(&held, to_m),
        is_exact: false,
    })
}

/// The changes of a drag, or why there are none.
pub fn gripped(model: &Model, texts: &Texts, grip: &Grip) -> DragOutcome {
    gripped_closing(model, texts, grip, &[])
}

/// As [`gripped`], with other guesses of how the loops close: numbers of the model, and their values in whole degrees, SI.
pub fn gripped_closing(model: &Model, texts: &Texts, grip: &Grip, guesses: &[(QuantityId, f64)]) -> DragOutcome {
    let refused = refused_drag;
    let is_near = |value: &f64| value.is_finite() && value.abs() * M_PER_MM < FURTHEST_M;
    let is_sound = grip.poses.len() == model.bodies.len()
        && grip.poses.iter().flatten().chain(&grip.to_mm).all(is_near)
        && grip.step_mm > 0.0
        && is_near(&grip.step_mm);
    if !is_sound {
        return refused("this drag belongs to another model".to_owned());
    }
    let poses: Vec<Pose> = grip
        .poses
        .iter()
        .map(|[x, y, angle]| Pose { origin_m: [x * M_PER_MM, y * M_PER_MM], angle_rad: angle.to_radians() })
        .collect();
    let Moved { coordinates, expected_m, poses, is_exact } = match moved(model, grip, &poses) {
        Ok(moved) => moved,
        Err(words) => return refused(words),
    };
    if coordinates.len() > MAX_COORDINATES {
        let count = coordinates.len();
        return refused(format!("this moves {count} coordinates: at most {MAX_COORDINATES} can be changed at once"));
    }
    let mut settings: Vec<Setting> = Vec::new();
    for (coordinate, value_si) in coordinates {
        match behind(model, coordinate, value_si) {
            // A number that several lengths share has one value: that of the first of them.
            Ok(setting) if settings.iter().any(|known| known.quantity == setting.quantity) => {}
            Ok(setting) => settings.push(setting),
            Err(locked) => {
                let place = describe_path(&locked.path);
                return refused(match &locked.by[..] {
                    [] => format!("{place} is not written as a number: change it in the text"),
                    by => format!("{place} depends on {}: change one of them in the list of numbers", by.join(", ")),
                });
            }
        }
    }
    let locks = Locks::of(texts.model.text());
    let is_locked = |id: QuantityId| model.quantities[id].span.is_some_and(|span| locks.hold(span.start));
    if let Some(held) = settings.iter().find(|setting| is_locked(setting.quantity)) {
        let path = &model.quantities[held.quantity].path;
        return refused(format!("{} is locked: unlock it in the list of numbers", describe_path(path)));
    }
    let step_si = grip.step_mm * M_PER_MM * if grip.is_free { FREE_SHARE } else { 1.0 };
    let mut text = Replacements::new(texts.model.text());
    let mut shifts: BTreeMap<String, f64> = BTreeMap::new();
    let mut words = Vec::new();
    for Setting { quantity, value_si } in settings {
        let Some((range, written)) = number(model, texts, quantity) else {
            let place = describe_path(&model.quantities[quantity].path);
            return refused(format!("{place} is not written as a plain number with its unit: change it in the text"));
        };
        let new = if is_exact {
            written.moved_by_si(value_si - written.value_si())
        } else {
            written.with_value_si(value_si, step_si)
        };
        let path = &model.quantities[quantity].path;
        words.push(format!("{} {}", short(path), new.trim()));
        match Written::read(&new) {
            // What comes to the same value keeps the digits that it has.
            Some(read) if read == written => {}
            read => {
                shifts.extend(read.map(|read| (path.clone(), read.value_si() - written.value_si())));
                if let Err(refusal) = text.replace(range, &new) {
                    return refused(refusal.message);
                }
            }
        }
    }
    for (quantity, value_si) in guesses {
        if let Some((range, written)) = number(model, texts, *quantity)
            && let Err(refusal) = text.replace(range, &written.moved_by_si(value_si - written.value_si()))
        {
            return refused(refusal.message);
        }
    }
    let study = match &texts.study {
        None => None,
        Some(source) => match shifted(source, &shifts) {
            Ok((shifted, stays)) => {
                words.extend(stays.iter().map(|path| format!("{} stays as it is in the study", short(path))));
                shifted.is_changed().then_some(shifted)
            }
            Err(refusal) => return refused(refusal.message),
        },
    };
    let mut changes = text.changes(Document::Model, &texts.model);
    if let (Some(shifted), Some(source)) = (&study, &texts.study) {
        changes.extend(shifted.changes(Document::Study, source));
    }
    let named = model.bodies.iter().zip(&poses).skip(1).map(|(body, pose)| (body.name.clone(), pose.for_page()));
    let poses_of_page = named.collect();
    DragOutcome {
        reshaped: DragResult { changes, words, angle_deg: None, poses: poses_of_page, refusal: None },
        model: text.text(),
        study: study.and_then(|shifted| shifted.text()),
        expected_m,
        poses,
    }
}

fn short(path: &str) -> &str {
    path.strip_prefix("parameter.").unwrap_or(path)
}

/// The number of the text that is a quantity, with its place in bytes.
pub fn number(model: &Model, texts: &Texts, quantity: QuantityId) -> Option<(Range<usize>, Written)> {
    let range = unquoted(&texts.model, model.quantities[quantity].span?);
    let written = Written::read(&texts.model.text()[range.clone()])?;
    Some((range, written))
}

/// The study with its distributions of moved numbers moved along, and the paths of those that are stated in another way and stay. A
/// distribution without a nominal value of its own follows the model as it is.
fn shifted<'a>(
    study: &'a Arc<Source>,
    moved: &BTreeMap<String, f64>,
) -> Result<(Replacements<'a>, Vec<String>), Refusal> {
    let unreadable = |_| Refusal::bad("the study cannot be read: correct its problems first");
    let toml = parse_toml(study).map_err(unreadable)?;
    let mut text = Replacements::new(study.text());
    let mut stays = Vec::new();
    let random = toml.get_ref().get("random").and_then(|random| random.get_ref().as_table());
    for (path, entry) in random.into_iter().flatten() {
        let path: &str = path.get_ref().as_ref();
        let Some(by_si) = moved.get(path) else { continue };
        let mut open = vec![entry];
        let mut follows = false;
        while let Some(table) = open.pop().and_then(|value| value.get_ref().as_table()) {
            for (key, value) in table {
                let key: &str = key.get_ref().as_ref();
                if let Some(family) = value.get_ref().as_table() {
                    follows |= takes_mean_of_model(key) && family.get("mean").is_none();
                    open.push(value);
                }
                let range = unquoted(study, value.span().into());
                let whole = &study.text()[range.clone()];
                let new = match key {
                    TOLERANCE if !states_nominal(whole) => {
                        follows = true;
                        None
                    }
                    // `120 ± 0.1 mm` begins with the value that moves; its unit stands at the end.
                    TOLERANCE => nominal_moved(whole, *by_si),
                    _ if PLACES.contains(&key) => Written::read(whole).map(|written| written.moved_by_si(*by_si)),
                    _ => None,
                };
                if let Some(new) = new {
                    text.replace(range, &new)?;
                    follows = true;
                }
            }
        }
        if !follows {
            stays.push(path.to_owned());
        }
    }
    Ok((text, stays))
}

/// `120 ± 0.1 mm` with another first number.
fn nominal_moved(text: &str, by_si: f64) -> Option<String> {
    let (nominal, _) = number_and_unit(text)?;
    // Behind it, with its spaces as they are written.
    let limits = text.strip_prefix(nominal)?;
    let own_unit = limits.trim_start().split(|c: char| !c.is_alphabetic()).next().filter(|unit| !unit.is_empty());
    let last_unit = limits.rsplit(|c: char| !c.is_alphabetic()).next()?;
    let moved = Written::read(&format!("{nominal} {}", own_unit.unwrap_or(last_unit)))?.moved_by_si(by_si);
    let digits = moved.split(' ').next()?;
    Some(format!("{digits}{limits}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nominal_value_moves_and_its_limits_stay() {
        assert_eq!(nominal_moved("120 ± 0.09 mm", 1e-3).as_deref(), Some("121 ± 0.09 mm"));
        assert_eq!(nominal_moved("120 mm +0.02 -0.01 mm", 1e-3).as_deref(), Some("121 mm +0.02 -0.01 mm"));
        assert_eq!(nominal_moved("4 +/- 0.01 in", 0.0254).as_deref(), Some("5 +/- 0.01 in"));
        assert_eq!(nominal_moved("-10 mm ±0.1 mm", 1e-3).as_deref(), Some("-9 mm ±0.1 mm"));
        assert_eq!(nominal_moved("length ± 1 mm", 1e-3), None);
    }
}
