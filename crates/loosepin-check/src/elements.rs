//! Descriptions of couplings, springs, loads and controls.

use std::fmt::Write;

use loosepin_mechanics::model::{
    Control, Elasticity, FeedForward, JointId, Load, Model, PointId, Spring, SpringKind, TableCurve, TimeCourse, Values,
};
use loosepin_text::article::{Fact, Section};
use loosepin_text::units::{Dimension, counted, format_value};

use super::names::ModelNames;

/// The couplings, each with `coupling_lines` below it, the springs, the loads and the controls, each under a line that counts them; no
/// section where there are none.
pub fn elements(model: &Model, values: &Values, coupling_lines: &[Vec<String>]) -> Vec<Section> {
    let couplings = model.couplings.iter().zip(coupling_lines).map(|(coupling, lines)| {
        let name = coupling.path.rsplit('.').next().unwrap_or_default();
        Fact::new(name, std::iter::once(coupling.words(&ModelNames { model, values })).chain(lines.iter().cloned()))
    });
    let springs = model.springs.iter().map(|spring| Fact::new(&spring.name, [spring_words(model, spring, values)]));
    let loads = model.loads.iter().map(|load| Fact::new(&load.name, [load_words(model, load, values)]));
    let controls =
        model.controls.iter().map(|control| Fact::new(&control.name, [control_words(model, control, values)]));
    [
        ("couplings", couplings.collect(), "coupling"),
        ("springs", springs.collect(), "spring"),
        ("loads", loads.collect(), "load"),
        ("controls", controls.collect(), "control"),
    ]
    .into_iter()
    .filter(|(_, facts, _): &(_, Vec<Fact>, _)| !facts.is_empty())
    .map(|(id, facts, noun)| Section::of_facts(id, counted(facts.len(), noun), facts))
    .collect()
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
    let size = match (&load.course, load.kind.size()) {
        (Some(course), Some(size)) => course_words(model, course, load.joint, size.dimension, values),
        (None, _) | (_, None) => String::new(),
    };
    load.kind.words(&ModelNames { model, values }, &size)
}

fn course_words(
    model: &Model,
    course: &TimeCourse,
    joint: Option<JointId>,
    dimension: Dimension,
    values: &Values,
) -> String {
    match course {
        TimeCourse::Constant(id) => format_value(values[*id], dimension),
        TimeCourse::Harmonic { mean, amplitude, frequency, phase_rad } => {
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
        TimeCourse::Table(table) => {
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
        TimeCourse::Function(_) => match joint {
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
        FeedForward::TimeCourse(TimeCourse::Function(_) | TimeCourse::Table(_)) => {
            words.push_str(", an expression fed forward")
        }
        FeedForward::TimeCourse(TimeCourse::Constant(id) | TimeCourse::Harmonic { mean: id, .. }) => {
            let _ = write!(words, ", {} fed forward", format_value(values[*id], effort));
        }
    }
    if let Some(id) = control.limit {
        let _ = write!(words, ", at most {}", format_value(values[id], effort));
    }
    let _ = write!(words, "; the reference goes {}", control.reference.words(&ModelNames { model, values }));
    words
}
