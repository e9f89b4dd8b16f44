//! Couplings, springs, loads and controls in words.

use std::fmt::Write;

use loosepin::model::{
    Control, Coupling, Course, Elasticity, FeedForward, JointId, Load, LoadKind, Model, PointId, Spring, SpringKind,
    TableCurve, Values,
};
use loosepin::units::{Dimension, format_value};

use super::names::NamesOf;
use crate::console::counted;

/// The couplings, each with `coupling_lines` below it, the springs, the loads and the controls, each under a line that counts them;
/// nothing where there are none.
pub fn push_elements(text: &mut String, model: &Model, values: &Values, coupling_lines: &[Vec<String>]) {
    let name_of = |coupling: &'_ Coupling| coupling.path.rsplit('.').next().unwrap_or_default().to_owned();
    let names: Vec<String> = model.couplings.iter().map(name_of).collect();
    let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let couplings = model.couplings.iter().zip(&names).zip(coupling_lines).map(|((coupling, name), lines)| {
        let below = lines.iter().map(|line| format!("\n{:1$}{line}", "", width + 4));
        (name.as_str(), std::iter::once(coupling.words(&NamesOf { model, values })).chain(below).collect::<String>())
    });
    push_list(text, couplings.collect(), ("coupling", "couplings"));
    let springs = model.springs.iter().map(|spring| (spring.name.as_str(), spring_words(model, spring, values)));
    push_list(text, springs.collect(), ("spring", "springs"));
    let loads = model.loads.iter().map(|load| (load.name.as_str(), load_words(model, load, values)));
    push_list(text, loads.collect(), ("load", "loads"));
    let controls = model.controls.iter().map(|control| (control.name.as_str(), control_words(model, control, values)));
    push_list(text, controls.collect(), ("control", "controls"));
}

fn push_list(text: &mut String, items: Vec<(&str, String)>, (one, many): (&str, &str)) {
    if items.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n{}", counted(items.len(), one, many));
    let width = items.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, words) in items {
        let _ = writeln!(text, "  {name:width$}  {words}");
    }
}

fn point(model: &Model, id: PointId) -> String {
    format!("{}.{}", model.bodies[id.body.0].name, model.bodies[id.body.0].points[id.point].name)
}

fn spring_words(model: &Model, spring: &Spring, values: &Values) -> String {
    let (place, stiffness, free, damping, preload) = match spring.kind {
        SpringKind::Linear { first, second } => (
            format!("linear: from {} to {}", point(model, first), point(model, second)),
            Dimension::SPRING_STIFFNESS,
            ("free length", Dimension::LENGTH),
            Dimension::DAMPING,
            Dimension::FORCE,
        ),
        SpringKind::Torsional { first, second } => (
            format!("torsional: turns {} against {}", model.bodies[second.0].name, model.bodies[first.0].name),
            Dimension::TORSIONAL_STIFFNESS,
            ("free angle", Dimension::ANGLE),
            Dimension::TORSIONAL_DAMPING,
            Dimension::TORQUE,
        ),
    };
    let (elastic, preload_si) = match &spring.elasticity {
        Elasticity::Linear { stiffness: id, free: free_id, preload } => {
            let stiffness = format_value(values[*id], stiffness);
            (format!("{stiffness}, {} {}", free.0, format_value(values[*free_id], free.1)), values[*preload])
        }
        Elasticity::Table { points, curve } => {
            (format!("by a table of {} points, {}", points.len(), curve_words(*curve)), 0.0)
        }
    };
    let mut words = format!("{place}, {elastic}");
    if let Some(id) = spring.damping {
        let _ = write!(words, ", damping {}", format_value(values[id], damping));
    }
    if preload_si != 0.0 {
        let _ = write!(words, ", preload {}", format_value(preload_si, preload));
    }
    words
}

fn curve_words(curve: TableCurve) -> &'static str {
    match curve {
        TableCurve::Monotone => "monotone",
        TableCurve::Spline => "a spline",
    }
}

fn load_words(model: &Model, load: &Load, values: &Values) -> String {
    let dimension = match load.kind {
        LoadKind::Force { .. } => Dimension::FORCE,
        LoadKind::Torque { .. } => Dimension::TORQUE,
    };
    let course = course_words(model, &load.course, load.joint, dimension, values);
    match load.kind {
        LoadKind::Force { point: id, direction_rad, follows_body } => {
            let frame = if follows_body { "of the body's x axis" } else { "from the x axis" };
            let direction = format_value(values[direction_rad], Dimension::ANGLE);
            format!("force on {}: {course}, {direction} {frame}", point(model, id))
        }
        LoadKind::Torque { body } => format!("torque on {}: {course}", model.bodies[body.0].name),
    }
}

fn course_words(
    model: &Model,
    course: &Course,
    joint: Option<JointId>,
    dimension: Dimension,
    values: &Values,
) -> String {
    match course {
        Course::Constant(id) => format_value(values[*id], dimension),
        Course::Harmonic { mean, amplitude, frequency, phase_rad } => {
            let mut words = format!(
                "{} up and down at {}",
                format_value(values[*amplitude], dimension),
                format_value(values[*frequency], Dimension::FREQUENCY)
            );
            if values[*mean] != 0.0 {
                let _ = write!(words, " about {}", format_value(values[*mean], dimension));
            }
            if values[*phase_rad] != 0.0 {
                let _ = write!(words, ", phase {}", format_value(values[*phase_rad], Dimension::ANGLE));
            }
            words
        }
        Course::Table(table) => {
            let over = match (table.variable, joint) {
                (0, _) | (_, None) => "the time".to_owned(),
                (1, Some(joint)) => {
                    let what = if table.dimensions[0] == Dimension::ANGLE { "angle" } else { "position" };
                    format!("the {what} of joint '{}'", model.joints[joint.0].name)
                }
                (_, Some(joint)) => format!("the speed of joint '{}'", model.joints[joint.0].name),
            };
            let mut words =
                format!("by a table of {} points over {over}, {}", table.points.len(), curve_words(table.curve));
            if let Some(period) = table.period {
                let _ = write!(words, ", period {}", format_value(values[period], table.dimensions[0]));
            }
            if let Some(piston) = table.piston {
                let _ = write!(words, ", pressure on {}", format_value(values[piston.area_m2], Dimension::AREA));
            }
            words
        }
        Course::Function(_) => match joint {
            Some(joint) => format!("an expression over time and joint '{}'", model.joints[joint.0].name),
            None => "an expression over time".to_owned(),
        },
    }
}

fn control_words(model: &Model, control: &Control, values: &Values) -> String {
    let name = |joint: JointId| &model.joints[joint.0].name;
    let is_prismatic = |joint: JointId| model.joints[joint.0].kind.slides();
    let effort = if is_prismatic(control.joint) { Dimension::FORCE } else { Dimension::TORQUE };
    let mut words = format!("acts in '{}'", name(control.joint));
    if control.measured != control.joint {
        let _ = write!(words, ", measures '{}'", name(control.measured));
    }
    let gain = |id| format_value(values[id], model.quantities[id].dimension);
    let _ = write!(words, ": proportional {}", gain(control.proportional));
    for (what, id) in [("integral", control.integral), ("derivative", control.derivative)] {
        if let Some(id) = id {
            let _ = write!(words, ", {what} {}", gain(id));
        }
    }
    match &control.feed_forward {
        FeedForward::None => {}
        FeedForward::InverseDynamics => words.push_str(", inverse dynamics fed forward"),
        FeedForward::Course(Course::Function(_) | Course::Table(_)) => words.push_str(", an expression fed forward"),
        FeedForward::Course(Course::Constant(id) | Course::Harmonic { mean: id, .. }) => {
            let _ = write!(words, ", {} fed forward", format_value(values[*id], effort));
        }
    }
    if let Some(id) = control.limit {
        let _ = write!(words, ", at most {}", format_value(values[id], effort));
    }
    let _ = write!(words, "; the reference goes {}", control.reference.words(&NamesOf { model, values }));
    words
}
