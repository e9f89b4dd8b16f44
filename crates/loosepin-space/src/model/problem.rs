//! Errors of a model in space.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::{describe_path, listed};
use loosepin_text::units::quoted;

problems! {
    /// An error in a model file. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SpatialModelProblem {
        NotSpace { found: String } => Code::WrongKindOfFile,
            says("geometry is '{found}'; must be \"space\""),
            hint("a planar model has no key geometry, or geometry = \"plane\"");
        NoGeometry { entry: String, what: &'static str } => Code::WrongKindOfFile,
            says("{entry} {what}, which only models in space have, and the file does not say that it is one"),
            hint("add the line geometry = \"space\" at its top, or write two coordinates for each point and no axes");
        UnknownAxis { entry: String, body: String, name: String, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: body '{body}' has no axis '{name}'"),
            hint("{}", match known.is_empty() {
                true => format!("write x, y or z, three numbers, or define it under axes of body '{body}'"),
                false => format!("available: {}; or write x, y or z, or three numbers", quoted(known)),
            });
        AxisName { entry: String, name: String } => Code::BadName,
            says("{entry}: an axis cannot be called '{name}', which is an axis of the frame"),
            hint("choose another name");
        OneAxis { entry: String, given: &'static str, other: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{given}' needs '{other}'"),
            hint("give both, or 'axis' for both bodies");
        AxisTwice { entry: String, given: &'static str } => Code::ConflictingKeys,
            says("{entry}: 'axis' and '{given}' cannot be used together"),
            hint("'axis' is the axis on both bodies; give bearing_axis and journal_axis where they differ");
        NeedsAcross { entry: String, kind: &'static str } => Code::MissingKey,
            says("{entry}: a {kind} joint about an axis that is not x, y or z needs bearing_across and journal_across"),
            hint("they are directions across the axis that the joint keeps together");
        NotDrivable { entry: String, joint: String, kind: &'static str } => Code::DriveNotPossible,
            says("{entry}: joint '{joint}' is {kind} and cannot be driven"),
            hint("drive a revolute, prismatic, cylindrical or screw joint");
        CycleNeedsTurns { drive: String } => Code::DriveNotPossible,
            says("cycle: drive '{drive}' moves along its joint; its turns cannot be counted"),
            hint("use a drive of an angle, or give duration instead of drive");
        GuessOfGround => Code::UnknownReference,
            says("assembly: the ground does not move, so it needs no guess");
        NotATurn { entry: String, found: String } => Code::ExpressionSyntax,
            says("{entry} is '{found}'; must be an axis and an angle"),
            hint("for example \"x 30 deg\": a turn about the x axis of the body");
        InertiaCount { entry: String, found: usize } => Code::WrongType,
            says("{entry} has {found} entries; expected 3 or 6"),
            hint("about the centre of mass: xx, yy, zz, and xy, xz, yz where the axes of the frame are not principal axes");
        NotAnInertia { entry: String } => Code::BreaksRule,
            says("{entry} is of no body: each principal moment must be above zero and at most the sum of the other two"),
            hint("xx is the sum of m (y² + z²), xy the negative sum of m x y");
    }
}

problems! {
    /// Why values make no mechanism. `path` is that of the entry at fault.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SpatialModelError {
        NoDirection { path: String } => Code::BreaksRule,
            says("{} has length zero, so it has no direction", describe_path(path));
        AlongAxis { path: String, axis: &'static str } => Code::BreaksRule,
            says("{}: the direction across is along {axis}", describe_path(path)),
            hint("give a direction at an angle to the axis");
        NoMechanism { path: String, why: String } => Code::BreaksRule,
            says("{why}");
        /// No cycle is given, so that there is nothing to move over.
        NoCycle { names: Vec<String> } => Code::MissingKey,
            says("the file has no [cycle]"),
            hint("{}", match names.is_empty() {
                true => "a motion needs a drive and a [cycle] that counts its turns".to_owned(),
                false => format!("add [cycle] with drive = {}", listed(names, "or")),
            });
        StandsStill { path: String } => Code::DriveStandsStill,
            says("{} is zero, so the turns of its drive cannot be counted", describe_path(path)),
            hint("give it a speed, or count by duration");
    }
}

problems! {
    /// Why a mechanism in space has no motion.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SpatialMotionProblem {
        DoesNotClose { why: String } => Code::CannotClose,
            says("{why}"),
            hint("check lengths and axes; [assembly] guess says where bodies start");
        /// A way of the drives that takes too many steps.
        TooLong { why: String } => Code::BreaksRule,
            says("{why}"),
            hint("give a shorter duration, or slower drives: fewer samples_per_turn do not change it");
        Stopped => Code::Interrupted,
            says("the motion was stopped before its end");
        /// Loops that do not close with ideal joints: what the play of the joints makes of that.
        NotWithIdealJoints { why: String, by_play: String } => Code::CannotClose,
            says("{why}"),
            hint("this is the motion with ideal joints; {by_play}");
        NoAnswer {
            /// The output, or the motion, in words.
            subject: String,
            /// The input there, in words.
            at: String,
            why: String,
        } => Code::SingularPosition,
            says("{subject} at {at}: {why}"),
            hint("`loosepin check` says which freedoms are left without a drive");
        NoScatter { what: String, why: String } => Code::CannotClose,
            says("what scatters has no answer without dynamics, at {what}: {why}");
        /// The sum of turns from position to position does not tell which way round a large one went.
        CoarseTurn { output: String } => Code::BreaksRule,
            says("{output}: from one position to the next, a body may turn by a quarter of a turn at most, and a turn has at least 8 positions"),
            hint("take more samples_per_turn");
        /// A point whose path has no direction there.
        AtRest { output: String, at: String } => Code::SingularPosition,
            says("output '{output}' at {at}: the point rests, so that nothing is along or across its path"),
            hint("use component = \"magnitude\", or x, y and z");
        /// What keeps the nominal mechanism of samples from being one.
        NotSampled { why: String } => Code::CannotClose,
            says("{why}"),
            hint("give the joints more play, or smaller tilts and shifts");
        /// Play at a dead centre.
        ReachesDeadCentre { at: String } => Code::SingularPosition,
            says("at {at} play takes the mechanism to a dead centre, where it can go over to its other assembly: there is no bound"),
            hint("take less play, or a motion that stays farther from the dead centre; `loosepin motion` shows what play does there");
    }
}

impl SpatialModelError {
    /// Path of the entry at fault, if there is one.
    pub fn path(&self) -> &str {
        match self {
            Self::NoDirection { path }
            | Self::AlongAxis { path, .. }
            | Self::NoMechanism { path, .. }
            | Self::StandsStill { path } => path,
            Self::NoCycle { .. } => "",
        }
    }
}

/// The way out where a key of a model in space needs others.
pub(super) fn hint_of_needs(key: &str, _needs: &[&'static str]) -> Option<&'static str> {
    match key {
        "radial_clearance" | "bearing_length" | "axial_clearance" => Some(
            "play of a pin or a shaft needs its clearance and the length over which it leans; an ideal joint has neither",
        ),
        _ => None,
    }
}
