//! A drag as a whole: from the texts and the pointer to the changes of the texts.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use loosepin::diagnostics::{Complaints, Source};
use loosepin::document::parse_toml;
use loosepin::model::{JointKind, Model, PointId, QuantityId, describe_path};
use loosepin::result::simulation::Drawing;
use loosepin::study::number_and_unit;

use super::behind::{Setting, behind};
use super::reshape::{Posed, length, minus};
use super::rewritten::Rewritten;
use super::structure::Locks;
use super::written::Written;
use crate::messages::{Document, Grip, Reshaped};
use crate::places::unquoted;
use crate::still::Pose;
use crate::texts::Texts;

const M_PER_MM: f64 = 1e-3;
/// A number that is not to be round is written to this share of a step.
const FREE_SHARE: f64 = 0.02;
/// Nobody drags further, m.
const FURTHEST_M: f64 = 1e6;
/// Keys of a distribution that say where it lies, beside its nominal value with a tolerance.
const PLACES: [&str; 4] = ["mean", "lower", "upper", "mode"];
const TOLERANCE: &str = "tolerance";

/// What a drag does.
pub struct Gripped {
    /// The same for the page.
    pub reshaped: Reshaped,
    /// The model as it is to be; nothing where it stays.
    pub model: Option<String>,
    /// The study as it is to be; nothing where it stays.
    pub study: Option<String>,
    /// Where each joint is to be, m: the dragged one at the pointer, the others where they were.
    expected_m: Vec<[f64; 2]>,
}

#[cfg(test)]
impl Gripped {
    pub fn expected_m(&self) -> &[[f64; 2]] {
        &self.expected_m
    }
}

/// A drag that changes nothing, with the reason.
pub fn refused_drag(words: String) -> Gripped {
    Gripped {
        reshaped: Reshaped { changes: Vec::new(), words: Vec::new(), angle_deg: None, refusal: Some(words) },
        model: None,
        study: None,
        expected_m: Vec::new(),
    }
}

/// The changes of a drag, or why there are none.
pub fn gripped(model: &Model, texts: &Texts, grip: &Grip) -> Gripped {
    let refused = refused_drag;
    let Some(joint) = model.joints.iter().position(|joint| joint.name == grip.joint) else {
        return refused(format!("there is no joint '{}' any more", grip.joint));
    };
    let is_near = |value: &f64| value.is_finite() && value.abs() * M_PER_MM < FURTHEST_M;
    let is_sound = grip.poses.len() == model.bodies.len()
        && grip.poses.iter().flatten().chain(&grip.to_mm).all(is_near)
        && grip.step_mm > 0.0
        && is_near(&grip.step_mm);
    if !is_sound {
        return refused("this drag is not of this model".to_owned());
    }
    if !matches!(model.joints[joint].kind, JointKind::Revolute { .. }) {
        return refused(format!("{} is no pin: its numbers are changed in the list of numbers", grip.joint));
    }
    let poses: Vec<Pose> = grip
        .poses
        .iter()
        .map(|[x, y, angle]| Pose { origin_m: [x * M_PER_MM, y * M_PER_MM], angle_rad: angle.to_radians() })
        .collect();
    let posed = Posed::new(model, &poses);
    let held = posed.together(joint);
    let from_m = posed.at_m(held[0]);
    let to_m = posed.allowed_m(&held, from_m, grip.to_mm.map(|mm| mm * M_PER_MM));
    let mut settings: Vec<Setting> = Vec::new();
    for (coordinate, value_si) in posed.moved(&held, to_m) {
        match behind(model, coordinate, value_si) {
            // A number that several lengths share has one value: that of the first of them.
            Ok(setting) if settings.iter().any(|known| known.quantity == setting.quantity) => {}
            Ok(setting) => settings.push(setting),
            Err(locked) => {
                let place = describe_path(&locked.path);
                return refused(match &locked.by[..] {
                    [] => format!("{place} is not written as a number: it is changed in the text"),
                    by => format!("{place} follows from {}: change one of them in the list of numbers", by.join(", ")),
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
    let mut text = Rewritten::new(&texts.model);
    let mut moved: BTreeMap<String, f64> = BTreeMap::new();
    let mut words = Vec::new();
    for Setting { quantity, value_si } in settings {
        let Some((range, written)) = number(model, texts, quantity) else {
            let place = describe_path(&model.quantities[quantity].path);
            return refused(format!(
                "{place} is not written as a plain number with its unit: it is changed in the text"
            ));
        };
        let new = written.with_value_si(value_si, step_si);
        let path = &model.quantities[quantity].path;
        if let Some(read) = Written::read(&new).filter(|read| *read != written) {
            moved.insert(path.clone(), read.value_si() - written.value_si());
        }
        words.push(format!("{} {}", short(path), new.trim()));
        text.replace(range, new);
    }
    let study = match &texts.study {
        None => None,
        Some(source) => match shifted(source, &moved) {
            Ok((shifted, stays)) => {
                words.extend(stays.iter().map(|path| format!("{} stays as it is in the study", short(path))));
                shifted.is_changed().then_some(shifted)
            }
            Err(_) => return refused("the study cannot be read: mend its problems first".to_owned()),
        },
    };
    let mut changes = text.changes(Document::Model);
    if let Some(shifted) = &study {
        changes.extend(shifted.changes(Document::Study));
    }
    let expected_m = (0..model.joints.len())
        .map(|index| {
            let first = first_point(model, index);
            let is_held = held.contains(&first);
            if is_held { to_m } else { posed.at_m(first) }
        })
        .collect();
    Gripped {
        reshaped: Reshaped { changes, words, angle_deg: None, refusal: None },
        model: text.text(),
        study: study.and_then(|shifted| shifted.text()),
        expected_m,
    }
}

fn short(path: &str) -> &str {
    path.strip_prefix("parameter.").unwrap_or(path)
}

fn first_point(model: &Model, joint: usize) -> PointId {
    model.joints[joint].kind.points()[0]
}

/// The number of the text that is a quantity, with its place in bytes.
fn number(model: &Model, texts: &Texts, quantity: QuantityId) -> Option<(Range<usize>, Written)> {
    let range = unquoted(&texts.model, model.quantities[quantity].span?);
    let written = Written::read(&texts.model.text()[range.clone()])?;
    Some((range, written))
}

/// The study with its distributions of moved numbers moved along, and the paths of those that are stated in another way and stay.
fn shifted<'a>(
    study: &'a Arc<Source>,
    moved: &BTreeMap<String, f64>,
) -> Result<(Rewritten<'a>, Vec<String>), Complaints> {
    let toml = parse_toml(study)?;
    let mut text = Rewritten::new(study);
    let mut stays = Vec::new();
    let random = toml.get_ref().get("random").and_then(|random| random.get_ref().as_table());
    for (path, entry) in random.into_iter().flatten() {
        let path: &str = path.get_ref().as_ref();
        let Some(by_si) = moved.get(path) else { continue };
        let mut open = vec![entry];
        let mut is_moved = false;
        while let Some(table) = open.pop().and_then(|value| value.get_ref().as_table()) {
            for (key, value) in table {
                let key: &str = key.get_ref().as_ref();
                if value.get_ref().as_table().is_some() {
                    open.push(value);
                }
                let range = unquoted(study, value.span().into());
                let whole = &study.text()[range.clone()];
                // `120 ± 0.1 mm` begins with the value that moves; its unit stands at the end.
                let new = match key {
                    TOLERANCE => nominal_moved(whole, *by_si),
                    _ if PLACES.contains(&key) => Written::read(whole).map(|written| written.moved_by_si(*by_si)),
                    _ => None,
                };
                if let Some(new) = new {
                    text.replace(range, new);
                    is_moved = true;
                }
            }
        }
        if !is_moved {
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

/// The angle of the drive at which joints lie nearest to where they are expected, degrees; between two poses they go straight.
pub fn shown_angle_deg(gripped: &Gripped, drawing: &Drawing) -> Option<f64> {
    let poses = &drawing.poses;
    let joints: Vec<(usize, [f64; 2])> = drawing
        .joints
        .iter()
        .map(|joint| {
            let point = drawing.bodies.get(joint.first.body)?.points.get(joint.first.point)?;
            Some((joint.first.body, [point.x_m, point.y_m]))
        })
        .collect::<Option<_>>()?;
    if joints.len() != gripped.expected_m.len() {
        return None;
    }
    let at = |pose: usize| -> Vec<[f64; 2]> {
        let placed = |(body, local): &(usize, [f64; 2])| {
            let origin_m = [poses.x_m[*body][pose], poses.y_m[*body][pose]];
            Pose { origin_m, angle_rad: poses.angle_rad[*body][pose] }.world_m(*local)
        };
        joints.iter().map(placed).collect()
    };
    let due_m = &gripped.expected_m;
    let cost = |found: &[[f64; 2]]| -> f64 {
        (0..due_m.len()).map(|joint| length(minus(found[joint], due_m[joint])).powi(2)).sum()
    };
    let count = poses.drive_angle_rad.len();
    let all: Vec<Vec<[f64; 2]>> = (0..count).map(at).collect();
    let mut best = (f64::INFINITY, None);
    for pose in 0..count {
        let angle_rad = poses.drive_angle_rad[pose];
        let own = cost(&all[pose]);
        if own < best.0 {
            best = (own, Some(angle_rad));
        }
        // The least of a parabola: the joints go straight from one pose to the next, and from the last one nowhere.
        let next = all.get(pose + 1).unwrap_or(&all[pose]);
        let next_rad = poses.drive_angle_rad.get(pose + 1).copied().unwrap_or(angle_rad);
        let (mut along, mut square) = (0.0, 0.0);
        for joint in 0..due_m.len() {
            let first = all[pose][joint];
            let (way, missing) = (minus(next[joint], first), minus(due_m[joint], first));
            along += way[0] * missing[0] + way[1] * missing[1];
            square += way[0] * way[0] + way[1] * way[1];
        }
        let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
        let between = own - share * (2.0 * along - share * square);
        if between < best.0 {
            best = (between, Some(angle_rad + share * (next_rad - angle_rad)));
        }
    }
    best.1.map(f64::to_degrees)
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
