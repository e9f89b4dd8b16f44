//! A mechanism in words.

use std::fmt::Write;

use loosepin::contact::{NormalContact, NormalDescription, NormalLaw};
use loosepin::mechanism::{Drives, Mechanism, Sample};
use loosepin::model::{
    BodyId, Contact, Coupling, CycleSpan, DriveId, Friction, InitialOffset, JointId, JointPlay, JointWear, Model,
    OffsetPlace, Origin, OutputKind, PlayId, QuantityId,
};
use loosepin::model::{SlidingVelocity, Stiffness, Values};
use loosepin::simulate::columns;
use loosepin::units::{Dimension, format_number, format_value, listed};

use super::beams::push_beams;
use super::elements::push_elements;
use super::force_law::{joints_of_forces, push_force_laws};
use super::names::{NamesOf, SHOWN_ANGLE_RAD, angle};
use super::trial::Trial;
use crate::console::counted;

/// Other ways of assembling that are shown: loops that close in two ways each double their number.
const SHOWN_ASSEMBLIES: usize = 16;
/// Lengths of positions are shown to this, m.
const SHOWN_LENGTH_M: f64 = 1e-8;

/// All that is known of a mechanism before it runs.
pub fn words(mechanism: &Mechanism, values: &Values, tried: &Trial) -> String {
    let model = &mechanism.model;
    let mut text = format!("{}\n", model.name);
    push_bodies(&mut text, model, values);
    push_beams(&mut text, mechanism, values, tried.turn_s);
    push_joints(&mut text, mechanism, values);
    push_elements(&mut text, model, values, &coupling_lines(mechanism, values));
    push_mobility(&mut text, mechanism);
    push_start(&mut text, mechanism, values, tried);
    push_cycle(&mut text, mechanism, tried);
    push_force_laws(&mut text, model, values, joints_of_forces(model), &[]);
    text
}

fn push_bodies(text: &mut String, model: &Model, values: &Values) {
    let moving = &model.bodies[1..];
    let _ = writeln!(text, "\n{} on the ground", counted(moving.len(), "moving body", "moving bodies"));
    let width = moving.iter().map(|body| body.name.chars().count()).max().unwrap_or(0);
    for body in moving {
        let value = |id: Option<_>, dimension, none: &str| {
            id.map_or_else(|| none.to_owned(), |id| format_value(values[id], dimension))
        };
        let _ = writeln!(
            text,
            "  {:width$}  {}, {}",
            body.name,
            value(body.mass_kg, Dimension::MASS, "no mass"),
            value(body.inertia_kg_m2, Dimension::INERTIA, "no inertia")
        );
    }
    if matches!(model.quantities[model.gravity_m_s2].origin, Origin::Default) {
        let _ = writeln!(text, "  gravity not given");
    } else {
        let gravity = format_value(values[model.gravity_m_s2], Dimension::ACCELERATION);
        let _ = writeln!(text, "  gravity {gravity} along -y");
    }
}

fn push_joints(text: &mut String, mechanism: &Mechanism, values: &Values) {
    let model = &mechanism.model;
    let with_play = mechanism.plays.iter().filter(|play| matches!(play, PlayId::Joint(_))).count();
    let _ = writeln!(text, "\n{}, {with_play} with play", counted(model.joints.len(), "joint", "joints"));
    let width = model.joints.iter().map(|joint| joint.name.chars().count()).max().unwrap_or(0);
    let sample = Sample::<f64>::new(mechanism, values).ok();
    for (index, joint) in model.joints.iter().enumerate() {
        let joint_id = JointId(index);
        let _ = writeln!(
            text,
            "  {:width$}  {}{}",
            joint.name,
            joint.kind.words(&NamesOf { model, values }),
            drive_words(model, joint_id, values)
        );
        let indent = " ".repeat(width + 4);
        if let Some(friction) = &joint.friction {
            let what = if joint.kind.slides() { "a guide length of" } else { "a pin radius of" };
            let size = format_value(values[friction.size_m], Dimension::LENGTH);
            let _ = writeln!(text, "{indent}{}, at {what} {size}", friction_words(model, &friction.friction, values));
        }
        if let Some(wear) = &joint.wear {
            let _ = writeln!(text, "{indent}{}", wear_words(model, wear, values));
        }
        let Some(JointPlay { contact, .. }) = joint.kind.play() else { continue };
        let Some(play) = mechanism.plays.iter().position(|play| *play == PlayId::Joint(joint_id)) else {
            let which = joint.kind.clearance_key().replace('_', " ");
            let _ = writeln!(text, "{indent}ideal, since its {which} is 0 mm");
            continue;
        };
        let numbers = sample.as_ref().map(|sample| &sample.plays[play]);
        let play = joint.kind.play_words(&NamesOf { model, values });
        let contact = &model.contacts[contact.0];
        let length = joint.kind.pin_clearance().and_then(|clearance| clearance.bearing_length_m);
        for line in play.into_iter().chain(contact_lines(model, contact, length, values, numbers)) {
            let _ = writeln!(text, "{indent}{line}");
        }
    }
}

/// What the play of each coupling is; no line for those that have none.
fn coupling_lines(mechanism: &Mechanism, values: &Values) -> Vec<Vec<String>> {
    let model = &mechanism.model;
    let sample = Sample::<f64>::new(mechanism, values).ok();
    let lines = |(index, coupling): (usize, &Coupling)| {
        let Some(play) = coupling.play else { return Vec::new() };
        let Some(place) = mechanism.plays.iter().position(|play| *play == PlayId::Coupling(index)) else {
            return vec!["ideal, since its backlash is 0 mm".to_owned()];
        };
        let words = play.words(&NamesOf { model, values });
        let numbers = sample.as_ref().map(|sample| &sample.plays[place]);
        let contact = contact_lines(model, &model.contacts[play.contact.0], None, values, numbers);
        std::iter::once(words).chain(contact).collect()
    };
    model.couplings.iter().enumerate().map(lines).collect()
}

fn drive_words(model: &Model, joint: JointId, values: &Values) -> String {
    let Some(drive) = model.drives.iter().find(|drive| drive.joint == joint) else { return String::new() };
    format!(", driven by '{}' {}", drive.name, drive.law.words(&NamesOf { model, values }))
}

fn wear_words(model: &Model, wear: &JointWear, values: &Values) -> String {
    let surfaces = ["bearing", "journal"].into_iter().zip(wear.coefficients_m2_n);
    let surfaces = surfaces.filter_map(|(surface, coefficient)| {
        let coefficient = format_value(values[coefficient?], Dimension::WEAR_COEFFICIENT);
        Some(format!("{surface} {coefficient}"))
    });
    let surfaces = surfaces.collect::<Vec<String>>().join(", ");
    let cycles = model.wear.map_or(1.0, |life| values[life.cycles]);
    let word = if cycles == 1.0 { "cycle" } else { "cycles" };
    format!(
        "wear: {surfaces}, in {} sectors; stated after {} {word}",
        wear.sectors,
        format_value(cycles, Dimension::NUMBER)
    )
}

fn contact_lines(
    model: &Model,
    contact: &Contact,
    bearing_length_m: Option<QuantityId>,
    values: &Values,
    numbers: Option<&loosepin::mechanism::PlayGeometry<f64>>,
) -> Vec<String> {
    if contact.is_missing {
        return vec!["no contact is named".to_owned()];
    }
    let mut lines = Vec::new();
    let default = if contact.is_law_named { "" } else { " by default" };
    let mut law = format!("contact '{}': {}{default}", contact.name, contact.law.name());
    if let (NormalDescription::Line(_), Some(damping)) = (contact.law, contact.damping) {
        law.push_str(&format!(", energy loss of {}", damping.name));
    }
    match (contact.restitution, contact.damping_coefficient_n_s_m) {
        (Some(restitution), _) => {
            law.push_str(&format!(", restitution {}", format_number(values[restitution])));
            if let Some(delivered) = numbers.and_then(|numbers| numbers.delivered_restitution) {
                law.push_str(&format!(" (a free impact gives {delivered:.4})"));
            }
        }
        (None, Some(damping)) => {
            let damping = format_value(values[damping], Dimension::DAMPING);
            law.push_str(&format!(", damping {damping} (the restitution of a free impact depends on the masses)"));
        }
        (None, None) => {}
    }
    lines.push(law);
    let stiffness =
        numbers.map_or(String::new(), |numbers| stiffness_words(contact, bearing_length_m, numbers, values));
    let friction = match &contact.friction {
        None => "no friction".to_owned(),
        Some(friction) => friction_words(model, friction, values),
    };
    lines.push(format!("{stiffness}{friction}"));
    if let Some(film) = &contact.film {
        let length = |id| format_value(values[id], Dimension::LENGTH);
        let bearing = bearing_length_m.map_or(String::new(), |id| format!(", {} of bearing", length(id)));
        lines.push(format!(
            "film of oil by {}: viscosity {}, roughness {}{bearing}",
            film.law.name,
            format_value(values[film.viscosity_pa_s], Dimension::VISCOSITY),
            length(film.roughness_m)
        ));
    }
    if let Some(limit_m_s) =
        numbers.map(|numbers| numbers.largest_valid_impact_speed_m_s).filter(|limit| limit.is_finite())
    {
        let about_m_s = numbers.zip(fastest_drive_rad_s(model, values)).map(|(own, rate)| rate * own.clearance_m);
        let expected = match about_m_s.filter(|speed| *speed > limit_m_s) {
            Some(speed) => {
                format!("drive speed times clearance is {} already, so expect faster ones", rounded_speed(speed))
            }
            None => "a run gives the share of faster ones".to_owned(),
        };
        lines.push(format!("the law is valid for impacts up to {}; {expected}", rounded_speed(limit_m_s)));
    }
    lines
}

/// Speed of the fastest drive that turns at a constant one, rad/s.
fn fastest_drive_rad_s(model: &Model, values: &Values) -> Option<f64> {
    let rotary = model.drives.iter().filter(|drive| model.joints[drive.joint.0].kind.turns());
    let speeds = rotary.filter_map(|drive| Some(values[drive.law.steady()?.speed].abs()));
    speeds.max_by(f64::total_cmp)
}

fn stiffness_words(
    contact: &Contact,
    bearing_length_m: Option<QuantityId>,
    numbers: &loosepin::mechanism::PlayGeometry<f64>,
    values: &Values,
) -> String {
    match (&numbers.normal, bearing_length_m) {
        (NormalLaw::Point(point), _) => {
            let k = format_value(point.stiffness_n_m_n, Dimension::contact_stiffness(point.exponent));
            let origin = match contact.stiffness {
                Stiffness::Material { .. } => "from the materials",
                Stiffness::Given { .. } | Stiffness::Linear { .. } => "as given",
            };
            match numbers.shape.slot() {
                Some(slot) if slot.end_stiffening > 0.0 => {
                    let in_ends = point.stiffness_n_m_n * (1.0 + slot.end_stiffening);
                    let in_ends = format_value(in_ends, Dimension::contact_stiffness(point.exponent));
                    format!("stiffness {k} at the faces and {in_ends} in the ends, {origin}; ")
                }
                _ => format!("stiffness {k} {origin}; "),
            }
        }
        (NormalLaw::Linear(linear), _) => {
            format!("stiffness {} as given; ", format_value(linear.stiffness_n_m, Dimension::contact_stiffness(1.0)))
        }
        (normal, Some(length)) => {
            let limit = normal.limit_m().map_or(String::new(), |limit_m| {
                format!(", valid up to a penetration of {}", format_value(limit_m, Dimension::LENGTH))
            });
            format!("line contact over {}{limit}; ", format_value(values[length], Dimension::LENGTH))
        }
        _ => String::new(),
    }
}

fn friction_words(model: &Model, friction: &Friction, values: &Values) -> String {
    let reading = match friction.sliding_velocity {
        SlidingVelocity::Material => "",
        SlidingVelocity::Literal => ", sliding velocity by the literal reading",
    };
    let numbers: Vec<String> = friction
        .law
        .numbers
        .iter()
        .zip(&friction.numbers)
        .map(|(number, id)| {
            let value = format_value(values[*id], model.quantities[*id].dimension);
            format!("{} {value}", number.name().replace('_', " "))
        })
        .collect();
    format!("friction by {}: {}{reading}", friction.law.name, numbers.join(", "))
}

fn push_mobility(text: &mut String, mechanism: &Mechanism) {
    let model = &mechanism.model;
    let name = |play: &PlayId| format!("'{}'", model.play_name(*play));
    let joints: Vec<PlayId> = mechanism.plays.iter().copied().filter(|play| matches!(play, PlayId::Joint(_))).collect();
    let loops = mechanism.ideal.cuts.len();
    let held = mechanism.real.cuts.len();
    let _ = writeln!(text);
    let loop_words = match (loops, joints.as_slice()) {
        (0, _) => "no closed loop".to_owned(),
        (_, []) => format!("{}, held by ideal joints", counted(loops, "closed loop", "closed loops")),
        (_, plays) => {
            let opened =
                format!("opened by the play of {}", listed(&plays.iter().map(name).collect::<Vec<_>>(), "and"));
            match (loops, held) {
                (1, 0) => format!("1 closed loop, {opened}"),
                (_, 0) => format!("{loops} closed loops, all of them {opened}"),
                (_, held) => {
                    let others = if loops - held == 1 { "the other is" } else { "the others are" };
                    format!("{loops} closed loops; ideal joints alone hold {held} of them, {others} {opened}")
                }
            }
        }
    };
    let _ = writeln!(text, "{loop_words}");
    let _ = writeln!(
        text,
        "{} with every clearance at zero, {}: {}",
        counted(mechanism.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
        if model.drives.is_empty() { "no drive".to_owned() } else { counted(model.drives.len(), "drive", "drives") },
        if mechanism.is_driven() { "the motion is determined" } else { "forces move it from its initial state" }
    );
    let real = &mechanism.real;
    let of_floating = real.beams.iter().map(|beam| beam.coordinates.len());
    let of_beams: usize = of_floating.chain(real.nodal_beams.iter().map(|beam| beam.coordinates.len())).sum();
    let loose = mechanism.dynamic_freedoms + model.drives.len() - mechanism.degrees_of_freedom - of_beams;
    if !mechanism.plays.is_empty() {
        let _ = writeln!(text, "{} more for the play, held by contact alone", loose);
    }
    for (owner, count) in &mechanism.redundant {
        let _ = writeln!(
            text,
            "{} repeats what the others impose already: {} of it {} redundant",
            owner.words(model),
            counted(*count, "constraint", "constraints"),
            if *count == 1 { "is" } else { "are" }
        );
    }
    // An ideal joint at a point inside a flexible body does not carry it, and is cut.
    let is_cut = |root: BodyId| real.cuts.iter().any(|cut| model.joints[cut.joint.0].kind.bodies().contains(&root));
    for root in real.floating_roots.iter().filter(|root| !mechanism.plays.is_empty() && !is_cut(**root)) {
        let _ = writeln!(text, "body '{}' is held by joints with play alone", model.bodies[root.0].name);
    }
}

/// Which journals a run starts elsewhere, behind the words for centred ones.
fn offset_words(model: &Model, values: &Values) -> String {
    let words = |own: &InitialOffset| {
        let name = &model.joints[own.joint.0].name;
        match own.place {
            OffsetPlace::Resting => format!("'{name}', which a run starts resting"),
            OffsetPlace::Given { offset_m, .. } => {
                let [x, y] = offset_m.map_or([0.0; 2], |ids| ids.map(|id| values[id]));
                format!("'{name}', which a run starts {} off", format_value(x.hypot(y), Dimension::LENGTH))
            }
        }
    };
    let all: Vec<String> = model.initial_offsets.iter().map(words).collect();
    if all.is_empty() { String::new() } else { format!(", also {}", listed(&all, "and")) }
}

fn push_start(text: &mut String, mechanism: &Mechanism, values: &Values, tried: &Trial) {
    let model = &mechanism.model;
    let drives = (0..model.drives.len()).map(|index| start_of_drive(mechanism, DriveId(index), values));
    let given = (!mechanism.is_driven()).then(|| "as given under [initial]".to_owned());
    let starts: Vec<String> = drives.chain(given).collect();
    let _ = writeln!(text, "\nStart, {}, journals centred{}", listed(&starts, "and"), offset_words(model, values));
    let width = model.bodies[1..].iter().map(|body| body.name.chars().count()).max().unwrap_or(0);
    for (body, start) in model.bodies.iter().zip(&tried.start).skip(1) {
        let points: Vec<String> = body
            .points
            .iter()
            .zip(&start.points_m)
            .map(|(point, position_m)| {
                format!("{} ({}, {}) mm", point.name, millimetres(position_m[0]), millimetres(position_m[1]))
            })
            .collect();
        let _ = writeln!(text, "  {:width$}  at {}: {}", body.name, angle(start.angle_rad), points.join(", "));
    }
    let others: Vec<&Vec<f64>> = mechanism.other_assemblies_rad.iter().collect();
    if others.is_empty() {
        return;
    }
    let ways = if others.len() == 1 { "in one other way" } else { "in other ways" };
    let _ = writeln!(text, "The loops close at this start {ways} as well; to choose, write under [assembly]");
    for other in others.iter().take(SHOWN_ASSEMBLIES) {
        let _ = writeln!(text, "  {}", guess_words(model, other, tried));
    }
    if others.len() > SHOWN_ASSEMBLIES {
        let _ = writeln!(text, "  and {} more", others.len() - SHOWN_ASSEMBLIES);
    }
}

fn start_of_drive(mechanism: &Mechanism, id: DriveId, values: &Values) -> String {
    let model = &mechanism.model;
    let drive = &model.drives[id.0];
    let start = match drive.law.steady() {
        Some(steady) => values[steady.start],
        None => Drives::new(model, values).at(model, id, 0.0)[0],
    };
    let dimension = model.joints[drive.joint.0].kind.coordinate().unwrap_or(Dimension::ANGLE);
    format!("'{}' at {}", drive.name, format_value(start, dimension))
}

/// The guess that picks another assembly: the angles of all bodies that stand differently in it.
fn guess_words(model: &Model, other_rad: &[f64], tried: &Trial) -> String {
    let turned = |body: usize| ((other_rad[body] - tried.start[body].angle_rad) / 2.0).sin().abs() > SHOWN_ANGLE_RAD;
    let guesses: Vec<String> = (1..model.bodies.len())
        .map(BodyId)
        .filter(|body| turned(body.0))
        .map(|body| format!("{} = \"{}\"", model.bodies[body.0].name, angle(other_rad[body.0])))
        .collect();
    format!("guess = {{ {} }}", guesses.join(", "))
}

fn push_cycle(text: &mut String, mechanism: &Mechanism, tried: &Trial) {
    let model = &mechanism.model;
    let cycle = &model.cycle;
    let (one, many) = match cycle.span {
        CycleSpan::Turns(_) => ("turn", "turns"),
        CycleSpan::Periods(_) => ("period", "periods"),
        CycleSpan::Duration(_) => ("span", "spans"),
    };
    let turns =
        |turns: f64, what: &str| format!("{} {}{what}", format_number(turns), if turns == 1.0 { one } else { many });
    let _ = writeln!(
        text,
        "\nA run: {} of start-up, {} of {} each, {}",
        turns(cycle.transient_turns, ""),
        turns(cycle.recorded_turns, " recorded"),
        format_value(tried.turn_s, Dimension::TIME),
        counted(cycle.samples_per_turn, &format!("row a {one}"), &format!("rows a {one}"))
    );
    let columns = columns(&mechanism.model).into_iter().map(|column| (column.name, column.words));
    let wear = mechanism.model.outputs.iter().filter_map(|output| match output.kind {
        OutputKind::Wear { joint, measure } => {
            Some((output.name.clone(), measure.words(&mechanism.model.joints[joint.0].name)))
        }
        _ => None,
    });
    let outputs: Vec<(String, String)> = columns.chain(wear).collect();
    let width = outputs.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, words) in &outputs {
        let _ = writeln!(text, "  {name:width$}  {words}");
    }
    let _ = writeln!(
        text,
        "{}",
        match (mechanism.is_driven(), tried.is_run) {
            (true, true) => "The loops close all the way round, and the first steps of the run succeed.".to_owned(),
            (false, true) => "The first steps of the run succeed.".to_owned(),
            (_, false) if !mechanism.model.missing_for_runs.is_empty() => {
                format!("The loops close all the way round.\n\n{}", missing_words(&mechanism.model))
            }
            (is_driven, false) => {
                let closing = if is_driven { "The loops close all the way round. " } else { "" };
                let size = mechanism.real.free;
                format!("{closing}The run was not tried: its equations of motion for {size} coordinates take too long.")
            }
        }
    );
}

/// What the model lacks for a run, a line for each entry.
pub fn missing_words(model: &Model) -> String {
    let lines = model.missing_for_runs.iter().map(|missing| {
        let line =
            missing.place.as_ref().map_or(String::new(), |place| format!("line {}: ", place.line_and_column().0));
        format!("\n  {line}{}", missing.message)
    });
    format!(
        "Complete for its motion (loosepin motion, the band of the studio). A run (simulate, study) needs more:{}",
        lines.collect::<String>()
    )
}

/// A speed with two digits, however small it is.
fn rounded_speed(speed_m_s: f64) -> String {
    let rounded: f64 = format!("{speed_m_s:.1e}").parse().unwrap_or(speed_m_s);
    format_value(rounded, Dimension::VELOCITY)
}

/// A length in mm, without the unit, free of round-off.
fn millimetres(length_m: f64) -> String {
    format_number((length_m / SHOWN_LENGTH_M).round() * SHOWN_LENGTH_M * 1e3)
}

#[cfg(test)]
mod tests {
    use super::rounded_speed;

    #[test]
    fn a_slow_speed_keeps_its_digits() {
        assert_eq!(
            [0.050_31, 0.002_14, 12.34, 3e-7].map(rounded_speed),
            ["0.05 m/s", "0.0021 m/s", "12 m/s", "3e-7 m/s"]
        );
    }
}
