//! Description of a mechanism.

use loosepin_mechanics::mechanism::{Drives, Mechanism};
use loosepin_mechanics::model::{
    Body, BodyId, CycleSpan, DriveId, InitialOffset, Model, OffsetPlace, Origin, PlayId, Point, Values,
};
use loosepin_result::kinematics::LoopProperties;
use loosepin_simulate::{columns, loop_properties};
use loosepin_text::article::{Article, Content, Fact, Section};
use loosepin_text::units::{Dimension, counted_or_no, format_number, format_value, listed};

use super::beams::beams;
use super::elements::elements;
use super::force_law::{force_laws, joints_with_force_output};
use super::joints::{coupling_lines, joints};
use super::names::{SHOWN_ANGLE_RAD, angle_words};
use super::trial::TrialResult;

/// Other ways of assembling that are shown: loops that close in two ways each double their number.
const SHOWN_ASSEMBLIES: usize = 16;
/// Lengths of positions are shown to this, m.
const SHOWN_LENGTH_M: f64 = 1e-8;

/// The report on a mechanism before it runs.
pub fn article(mechanism: &Mechanism, values: &Values, tried: &TrialResult) -> Article {
    let model = &mechanism.model;
    let mut sections = vec![bodies(model, values)];
    sections.extend(beams(mechanism, values, tried.turn_s));
    sections.push(joints(mechanism, values));
    sections.extend(elements(model, values, &coupling_lines(mechanism, values)));
    sections.extend([mobility(mechanism, values), start(mechanism, values, tried), run(mechanism, tried)]);
    if !tried.is_run && !model.missing_for_runs.is_empty() {
        sections.push(missing(model));
    }
    sections.extend(force_laws(model, values, joints_with_force_output(model), &[]));
    Article { title: model.name.clone(), sections }
}

fn bodies(model: &Model, values: &Values) -> Section {
    let moving = &model.bodies[1..];
    let value = |id: Option<_>, dimension, none: &str| {
        id.map_or_else(|| none.to_owned(), |id| format_value(values[id], dimension))
    };
    let of_body = |body: &Body| {
        let mass = value(body.mass_kg, Dimension::MASS, "no mass");
        let inertia = value(body.inertia_kg_m2, Dimension::INERTIA, "no inertia");
        Fact::new(&body.name, [format!("{mass}, {inertia}")])
    };
    let gravity = if matches!(model.quantities[model.gravity_m_s2].origin, Origin::Default) {
        "gravity not given".to_owned()
    } else {
        format!("gravity {} along -y", format_value(values[model.gravity_m_s2], Dimension::ACCELERATION))
    };
    let heading = format!("{} on the ground", counted_or_no(moving.len(), "moving body", "moving bodies"));
    Section::of_facts("bodies", heading, moving.iter().map(of_body).chain([Fact::nameless(gravity)]))
}

/// Loops, degrees of freedom, and the constraints that remove them.
fn mobility(mechanism: &Mechanism, values: &Values) -> Section {
    let model = &mechanism.model;
    let name = |play: &PlayId| format!("'{}'", model.play_name(*play));
    let joints: Vec<PlayId> = mechanism.plays.iter().copied().filter(|play| matches!(play, PlayId::Joint(_))).collect();
    let loops = mechanism.ideal.cuts.len();
    let held = mechanism.real.cuts.len();
    let loop_words = match (loops, joints.as_slice()) {
        (0, _) => "no closed loop".to_owned(),
        (_, []) => format!("{}, held by ideal joints", counted_or_no(loops, "closed loop", "closed loops")),
        (_, plays) => {
            let opened =
                format!("opened by the play of {}", listed(&plays.iter().map(name).collect::<Vec<_>>(), "and"));
            match (loops, held) {
                (1, 0) => format!("1 closed loop, {opened}"),
                (_, 0) => format!("{loops} closed loops, all of them {opened}"),
                (_, held) => {
                    let others = if loops - held == 1 { "the other is" } else { "the others are" };
                    format!("{loops} closed loops; {held} of them with ideal joints only, {others} {opened}")
                }
            }
        }
    };
    let freedoms = format!(
        "{} with every clearance at zero, {}: {}",
        counted_or_no(mechanism.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
        counted_or_no(model.drives.len(), "drive", "drives"),
        if mechanism.is_driven() { "the motion is determined" } else { "forces move it from its initial state" }
    );
    let mut lines = vec![loop_words, freedoms];
    let real = &mechanism.real;
    let of_floating = real.beams.iter().map(|beam| beam.coordinates.len());
    let of_beams: usize = of_floating.chain(real.nodal_beams.iter().map(|beam| beam.coordinates.len())).sum();
    let loose = mechanism.dynamic_freedoms + model.drives.len() - mechanism.degrees_of_freedom - of_beams;
    if !mechanism.plays.is_empty() {
        lines.push(format!("{loose} more for the play, limited only by contact"));
    }
    lines.extend(mechanism.redundant.iter().map(|(owner, count)| {
        format!(
            "{} repeats constraints of the others: {} of it {} redundant",
            owner.words(model),
            counted_or_no(*count, "constraint", "constraints"),
            if *count == 1 { "is" } else { "are" }
        )
    }));
    lines.extend(loop_properties(model, values).iter().map(LoopProperties::words));
    // An ideal joint at a point inside a flexible body does not carry it, and is cut.
    let is_cut = |root: BodyId| real.cuts.iter().any(|cut| model.joints[cut.joint.0].kind.bodies().contains(&root));
    let held = real.floating_roots.iter().filter(|root| !mechanism.plays.is_empty() && !is_cut(**root));
    lines.extend(held.map(|root| format!("body '{}' is held only by joints with play", model.bodies[root.0].name)));
    Section::of_sentences("mobility", lines)
}

/// Which journals a run starts elsewhere, behind the words for centred ones.
fn offset_words(model: &Model, values: &Values) -> String {
    let words = |own: &InitialOffset| {
        let name = &model.joints[own.joint.0].name;
        match own.place {
            OffsetPlace::Resting => format!("'{name}', which a run starts resting"),
            OffsetPlace::Given { offset_m, .. } => {
                let [x, y] = offset_m.map_or([0.0; 2], |ids| ids.map(|id| values[id]));
                format!(
                    "'{name}', which a run starts with an offset of {}",
                    format_value(x.hypot(y), Dimension::LENGTH)
                )
            }
        }
    };
    let all: Vec<String> = model.initial_offsets.iter().map(words).collect();
    if all.is_empty() { String::new() } else { format!(", also {}", listed(&all, "and")) }
}

/// Initial positions of the bodies, and other ways to assemble them.
fn start(mechanism: &Mechanism, values: &Values, tried: &TrialResult) -> Section {
    let model = &mechanism.model;
    let drives = (0..model.drives.len()).map(|index| start_of_drive(mechanism, DriveId(index), values));
    let given = (!mechanism.is_driven()).then(|| "as given under [initial]".to_owned());
    let starts: Vec<String> = drives.chain(given).collect();
    let heading = format!("Start, {}, journals centred{}", listed(&starts, "and"), offset_words(model, values));
    let point_words = |(point, position_m): (&Point, &[f64; 2])| {
        format!("{} ({}, {}) mm", point.name, millimetres(position_m[0]), millimetres(position_m[1]))
    };
    let places = model.bodies.iter().zip(&tried.start).skip(1).map(|(body, start)| {
        let points: Vec<String> = body.points.iter().zip(&start.points_m).map(point_words).collect();
        Fact::new(&body.name, [format!("at {}: {}", angle_words(start.angle_rad), points.join(", "))])
    });
    let mut section = Section::of_facts("start", heading, places);
    let others = &mechanism.other_assemblies_rad;
    if others.is_empty() {
        return section;
    }
    let ways = if others.len() == 1 { "in one other way" } else { "in other ways" };
    let choose = format!("The loops also close at this start {ways}; to choose, write under [assembly]");
    section.push_close(Content::sentences([choose]));
    let shown = others.iter().take(SHOWN_ASSEMBLIES).map(|other| guess_words(model, other, tried));
    let more = others.len().saturating_sub(SHOWN_ASSEMBLIES);
    let more = (more > 0).then(|| format!("and {more} more"));
    section.push_close(Content::Facts(shown.chain(more).map(Fact::nameless).collect()));
    section
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
fn guess_words(model: &Model, other_rad: &[f64], tried: &TrialResult) -> String {
    let turned = |body: usize| ((other_rad[body] - tried.start[body].angle_rad) / 2.0).sin().abs() > SHOWN_ANGLE_RAD;
    let guesses: Vec<String> = (1..model.bodies.len())
        .map(BodyId)
        .filter(|body| turned(body.0))
        .map(|body| format!("{} = \"{}\"", model.bodies[body.0].name, angle_words(other_rad[body.0])))
        .collect();
    format!("guess = {{ {} }}", guesses.join(", "))
}

/// How long a run is, what it gives, and whether a first stretch of it succeeds.
fn run(mechanism: &Mechanism, tried: &TrialResult) -> Section {
    let model = &mechanism.model;
    let cycle = &model.cycle;
    let (one, many) = match cycle.span {
        CycleSpan::Turns(_) => ("turn", "turns"),
        CycleSpan::Periods(_) => ("period", "periods"),
        CycleSpan::Duration(_) => ("span", "spans"),
    };
    let turns =
        |turns: f64, what: &str| format!("{} {}{what}", format_number(turns), if turns == 1.0 { one } else { many });
    let heading = format!(
        "A run: {} of start-up, {} of {} each, {}",
        turns(cycle.transient_turns, ""),
        turns(cycle.recorded_turns, " recorded"),
        format_value(tried.turn_s, Dimension::TIME),
        counted_or_no(cycle.samples_per_turn, &format!("row a {one}"), &format!("rows a {one}"))
    );
    let columns = columns(&mechanism.model).into_iter().map(|column| (column.name, column.words));
    let wear = mechanism.model.outputs.iter().filter_map(|output| {
        let (joint, measure) = output.kind.wear()?;
        Some((output.name.clone(), measure.words(&mechanism.model.joints[joint.0].name)))
    });
    let outputs = columns.chain(wear).map(|(name, words)| Fact::new(name, [words]));
    let mut section = Section::of_facts("run", heading, outputs);
    section.push_close(Content::sentences([ending_words(mechanism, tried)]));
    section
}

/// What the first motion showed.
fn ending_words(mechanism: &Mechanism, tried: &TrialResult) -> String {
    let closing = match tried.left_after_turns {
        None => "The loops close over the whole cycle".to_owned(),
        Some(turns) => {
            let percent = format!("{:.1e}", 100.0 * turns).parse().map_or_else(|_| String::new(), format_number);
            format!(
                "The loops close over the first {percent} % of the cycle; a drive is so fast that they were not followed further"
            )
        }
    };
    match (mechanism.is_driven(), tried.is_run) {
        (true, true) => format!("{closing}, and the first steps of the run succeed."),
        (false, true) => "The first steps of the run succeed.".to_owned(),
        (_, false) if !mechanism.model.missing_for_runs.is_empty() => format!("{closing}."),
        (is_driven, false) => {
            let closing = if is_driven { format!("{closing}. ") } else { String::new() };
            let size = mechanism.real.free;
            format!("{closing}The run was not tested: its equations of motion for {size} coordinates take too long.")
        }
    }
}

/// Entries that the model lacks for a run, one per line.
pub fn missing(model: &Model) -> Section {
    let lines = model.missing_for_runs.iter().map(|missing| {
        let line =
            missing.place.as_ref().map_or(String::new(), |place| format!("line {}: ", place.line_and_column().0));
        Fact::nameless(format!("{line}{}", missing.message))
    });
    let heading =
        "Complete for its motion (loosepin motion, the band of the studio). A run (simulate, study) also needs:";
    Section::of_facts("missing", heading, lines)
}

/// A length in mm, without the unit, free of round-off.
fn millimetres(length_m: f64) -> String {
    format_number((length_m / SHOWN_LENGTH_M).round() * SHOWN_LENGTH_M * 1e3)
}
