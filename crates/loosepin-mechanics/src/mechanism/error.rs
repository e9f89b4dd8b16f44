//! Why a model is no mechanism, or a sample of it cannot be built.

use crate::mechanism::loops::constraints::LargestResidual;
use crate::model::{PeriodProblem, QuantityError, describe_path};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{Dimension, counted, format_apart, format_value, listed, quoted};

problems! {
    /// Why a model cannot be compiled.
    #[derive(Debug, Clone, PartialEq)]
    pub enum MechanismError | Quantity(QuantityError) {
        TooFewDrives {
            /// Degrees of freedom with all clearances at zero.
            mobility: usize,
            drives: usize,
            /// Bodies that can still move when the drives stand still.
            undetermined: Vec<String>,
        } => Code::TooFewDrives,
            says(
                "the mechanism has {} of freedom and {}: {} not determined",
                counted(*mobility, "degree"),
                counted(*drives, "drive"),
                undetermined_words(undetermined)
            ),
            hint("add a drive, or a joint that stops the free motion; a motion that only forces determine needs its start \
                  under [initial]");
        TooManyDrives {
            /// Degrees of freedom with all clearances at zero.
            mobility: usize,
            drives: usize,
        } => Code::TooManyDrives,
            says(
                "the mechanism has {} of freedom and {}: {}",
                counted(*mobility, "degree"),
                counted(*drives, "drive"),
                if *drives == 1 { "nothing can move" } else { "the drives contradict each other" }
            ),
            hint("remove a {}", if *mobility == 0 { "joint" } else { "drive" });
        DrivenLoop { joint: String } => Code::DrivenLoop,
            says("joint '{joint}' closes a loop in which every joint is driven"),
            hint("remove one of the drives of this loop");
        BeamHangs { body: String } => Code::BeamNotPossible,
            says("body '{body}' has a tangent frame at from, but the joints that move the body are at its other end"),
            hint("exchange from and to in [body.{body}.beam], or use frame = \"secant\" and no drive in its joint");
        BeyondBeam { body: String, point: String } => Code::BeamNotPossible,
            says("point '{point}' of body '{body}' lies beyond the ends of its beam"),
            hint("points of a flexible body lie between from and to, on the axis or beside it");
        /// A joint with friction in a mechanism whose constraint forces are not determined.
        CarriedNotDetermined { joint: String } => Code::FrictionNotPossible,
            says("joint '{joint}' has friction, but its force is not determined: constraints of ideal joints are \
                  redundant"),
            hint("remove the redundant constraint, or the friction");
        CannotClose {
            open: LargestResidual,
            at: Option<Box<DrivePlace>>,
            /// Starting positions from which the loops were to be closed.
            starts: usize,
            /// Bodies with the angles, rad, at which each of them began, by [assembly] guess.
            guesses: Box<[(String, f64)]>,
        } => Code::CannotClose,
            says(
                "the links cannot close at the start{}: {open} at best, from {} tried{}",
                at_words(at.as_deref()),
                counted(*starts, "position"),
                guess_words(guesses)
            ),
            hint("{}", if guesses.is_empty() {
                "check the lengths and the start angle; if the loop does close, give [assembly] guess an angle near the true one"
            } else {
                "check the lengths and the start angle; if the loop does close, a guess may be wrong: correct it, or remove it"
            });
        /// A line that closes only the other way round.
        ClosesTurned { path: String, bodies: [String; 2] } => Code::CannotClose,
            says(
                "the links close at the start only with '{}' and '{}' turned by 180 deg against each other in {}",
                bodies[0],
                bodies[1],
                describe_path(path)
            ),
            hint("its line points in the opposite direction: change the angle of its guide or slider by 180 deg");
        CannotCloseAsGiven { open: LargestResidual } => Code::StartNotPossible,
            says("the links cannot close at the start that [initial] gives: {open} at best"),
            hint("remove the values under [initial] that follow from the others");
        StartNotDetermined {
            /// Whether rates are missing, not positions.
            is_rate: bool,
            /// Bodies that can still be placed, or moved, in more than one way.
            bodies: Vec<String>,
        } => Code::StartNotPossible,
            says(
                "the initial state does not determine {}",
                if *is_rate { rates_of(bodies) } else { places_of(bodies) }
            ),
            hint(
                "give the {} of one of them under [initial]",
                if *is_rate { "angular velocity or velocity" } else { "angle or position" }
            );
        StartNotNeeded => Code::StartNotPossible,
            says("the drives determine the motion, so there is no initial state to give under [initial]"),
            hint("remove [initial], or a drive");
        /// A velocity or rest in the bearing where forces move the mechanism.
        OffsetOfFreeMotion { path: String } => Code::StartNotPossible,
            says("{} can be given only if the drives determine the motion", describe_path(path)),
            hint("give the offset alone, or add a drive");
        PitchCirclesApart {
            path: String,
            /// Between the centres.
            distance: String,
            /// What the pitch radii give.
            due: String,
        } => Code::TeethNotPossible,
            says(
                "{}: the centres of the gears are {distance} apart; with 'pressure_angle' this must be {due}, from the pitch radii, \
                 within 1 %",
                describe_path(path)
            ),
            hint("radii are those of the pitch circles in mesh: the distance is their sum, or for an internal mesh their \
                  difference");
        NothingToControl { control: String } => Code::ControlNotPossible,
            says("control '{control}' cannot move anything: the drives determine the motion"),
            hint("remove the drive of the motion to be controlled, or the control");
        NoInverseDynamics { control: String, reason: &'static str } => Code::ControlNotPossible,
            says("control '{control}' cannot feed inverse dynamics forward: {reason}"),
            hint("inverse dynamics is available for open chains on the ground in which every joint is driven or controlled; \
                  use an expression over time as feed_forward, or none");
        StartContradicts {
            path: String,
            given_si: f64,
            /// The nearest one, SI.
            found_si: f64,
            dimension: Dimension,
        } => Code::StartNotPossible,
            says(
                "{} cannot be {} at the start; the nearest value that the links and the other given values permit is {}",
                describe_path(path),
                format_value(*given_si, *dimension),
                format_value(*found_si, *dimension)
            ),
            hint("remove it, because it follows from the others, or change the others");
        SingularStart { bodies: Vec<String> } => Code::SingularPosition,
            says(
                "the mechanism starts in a singular position: {} can move although every drive is locked",
                if bodies.is_empty() { "a body".to_owned() } else { quoted(bodies) }
            ),
            hint("start the drive a few degrees away");
    }
}

/// Positions of bodies, in words.
fn places_of(bodies: &[String]) -> String {
    if bodies.len() == 1 { format!("where {} is", quoted(bodies)) } else { format!("where {} are", quoted(bodies)) }
}

/// How fast bodies move, in words.
fn rates_of(bodies: &[String]) -> String {
    if bodies.len() == 1 {
        format!("how fast {} moves", quoted(bodies))
    } else {
        format!("how fast {} move", quoted(bodies))
    }
}

fn undetermined_words(bodies: &[String]) -> String {
    match bodies {
        [] => "a motion is".to_owned(),
        [one] => format!("the motion of '{one}' is"),
        many => format!("the motions of {} are", quoted(many)),
    }
}

/// Position of a drive.
#[derive(Debug, Clone, PartialEq)]
pub struct DrivePlace {
    /// Name of the drive.
    pub drive: String,
    /// Its position, m, or angle, rad.
    pub position_si: f64,
    /// The dimension of that.
    pub dimension: Dimension,
}

/// The guessed angles, behind the positions that were tried.
fn guess_words(guesses: &[(String, f64)]) -> String {
    let words =
        |(body, angle_rad): &(String, f64)| format!("'{body}' at {}", format_value(*angle_rad, Dimension::ANGLE));
    match guesses {
        [] => String::new(),
        _ => format!(", all with {} as guessed", listed(&guesses.iter().map(words).collect::<Vec<_>>(), "and")),
    }
}

/// Words for the position of the drive, behind an instant; empty if it is unknown.
fn at_words(at: Option<&DrivePlace>) -> String {
    let Some(DrivePlace { drive, position_si, dimension }) = at else { return String::new() };
    let in_turn =
        if *dimension == Dimension::ANGLE { position_si.rem_euclid(std::f64::consts::TAU) } else { *position_si };
    format!(", drive '{drive}' at {}", format_value(in_turn, *dimension))
}

problems! {
    /// Why one set of values gives no motion of the ideal mechanism.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SampleError | Quantity(QuantityError) | Period(PeriodProblem) {
        /// A clearance is zero in one and above zero in the other of sample and compiled mechanism.
        ClearanceChangesTopology {
            joint: String,
            clearance_m: f64,
            /// Whether it had play when the mechanism was compiled.
            compiled_with_play: bool,
        } => Code::ClearanceTouchesZero,
            says(
                "joint '{joint}' has a radial clearance of {}; the compiled mechanism treats it as {}",
                format_value(*clearance_m, Dimension::LENGTH),
                if *compiled_with_play { "a joint with play" } else { "ideal" }
            ),
            hint("with and without play are two mechanisms; run them one by one");
        /// A backlash is zero in one and above zero in the other of sample and compiled mechanism.
        BacklashChangesTopology {
            /// Path of the table of the coupling.
            path: String,
            backlash_m: f64,
            /// Whether it had play when the mechanism was compiled.
            compiled_with_play: bool,
        } => Code::ClearanceTouchesZero,
            says(
                "{} has a backlash of {}; the compiled mechanism treats it as {}",
                describe_path(path),
                format_value(*backlash_m, Dimension::LENGTH),
                if *compiled_with_play { "a coupling with play" } else { "ideal" }
            ),
            hint("with and without play are two mechanisms; run them one by one");
        ClearanceOutsideFit {
            joint: String,
            law: &'static str,
            clearance_m: f64,
            /// Smallest and largest clearance of the fit, m.
            fitted_m: [f64; 2],
        } => Code::ClearanceOutsideFit,
            says("{}", {
                let [clearance, from, to] = format_apart([*clearance_m, fitted_m[0], fitted_m[1]], Dimension::LENGTH);
                format!("joint '{joint}' has a radial clearance of {clearance}; '{law}' was fitted to clearances from {from} to {to}")
            }),
            hint("use another law for this clearance");
        PointOffSection {
            body: String,
            point: String,
            /// Share of the length by which it lies off the section that carries it.
            share: f64,
            largest: f64,
        } => Code::BeamNotPossible,
            says(
                "point '{point}' of body '{body}' is {:.1} % of the length of its beam away from the section chosen for it; at most \
                 {:.0} % is permitted",
                100.0 * share.abs(),
                100.0 * largest
            ),
            hint("move the point in the model to this place, so that the shapes are computed for it");
        RoughnessOutsideFilm {
            joint: String,
            law: &'static str,
            roughness_m: f64,
            clearance_m: f64,
            /// Smallest and largest roughness at this clearance, m.
            allowed_m: [f64; 2],
        } => Code::RoughnessOutsideFilm,
            says("{}", {
                let [roughness, least, most] =
                    format_apart([*roughness_m, allowed_m[0], allowed_m[1]], Dimension::LENGTH);
                format!(
                    "joint '{joint}' has a film by {law} with a roughness of {roughness} at a radial clearance of {}; must be \
                     between {least} and {most}",
                    format_value(*clearance_m, Dimension::LENGTH)
                )
            }),
            hint("the roughness is the thickness below which the film does not become stiffer");
        LengthOutsideFilm {
            joint: String,
            law: &'static str,
            length_ratio: f64,
            /// The largest L/D of the law.
            longest: f64,
        } => Code::LengthOutsideFilm,
            says(
                "joint '{joint}' has a film by {law} with a bearing {} times as long as its diameter; at most {longest} times are possible",
                (1000.0 * length_ratio).round() / 1000.0
            ),
            hint("use the film \"finite-length\" or \"pinkus-sternlicht\" for such a long bearing");
        CannotClose { open: LargestResidual, time_s: f64, at: Option<Box<DrivePlace>> } => Code::CannotClose,
            says("the links cannot close at {}{}: {open}", format_value(*time_s, Dimension::TIME), at_words(at.as_deref())),
            hint("the lengths do not permit a whole turn; check them, or drive another joint");
        StartContradicts { path: String, given_si: f64, found_si: f64, dimension: Dimension } => Code::StartNotPossible,
            says("{}", {
                let [given, found] = format_apart([*given_si, *found_si], *dimension);
                format!("{} is {given}; from the links and the other given values it is {found}", describe_path(path))
            }),
            hint("remove it, because it follows from the others, or change the others");
        /// A journal that starts outside of its play.
        OffsetBeyondPlay { path: String, offset_m: f64, clearance_m: f64 } => Code::StartNotPossible,
            says("{}", {
                let [offset, clearance] = format_apart([*offset_m, *clearance_m], Dimension::LENGTH);
                format!("{} is {offset} long; must be at most the radial clearance of {clearance}", describe_path(path))
            }),
            hint("a journal that touches its bearing has an offset as long as the clearance; start = \"resting\" puts it there");
        DriveWithoutValue { drive: String, time_s: f64 } => Code::RunNotFinite,
            says(
                "at {} the motion of drive '{drive}' is not a finite number, or its speed or acceleration is not",
                format_value(*time_s, Dimension::TIME)
            ),
            hint("its expression leaves the domain of log, sqrt, ^ or /: keep their arguments inside");
        Singular { time_s: f64, at: Option<Box<DrivePlace>> } => Code::SingularPosition,
            says(
                "singular position at {}{}: the drives no longer determine the motion",
                format_value(*time_s, Dimension::TIME),
                at_words(at.as_deref())
            ),
            hint("the links can be assembled in two ways there: change a length, keep the drive away from this position, or drive another joint");
    }
}
