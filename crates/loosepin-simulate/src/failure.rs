//! Why a run ends without a result.

use super::settings::MAX_ENERGY_RESIDUAL;
use loosepin_mechanics::dynamics::WithoutValue;
use loosepin_mechanics::mechanism::SampleError;
use loosepin_mechanics::model::Model;
use loosepin_text::diagnostics::{Code, Diagnostic, problems};
use loosepin_text::document::describe_path;
use loosepin_text::units::{Dimension, format_value};

problems! {
    /// The one reason why a run failed.
    #[derive(Debug, Clone, PartialEq)]
    pub enum RunFailure | Sample(SampleError) {
        /// The model says enough for its motion, and not for a run.
        NoDynamics { missing: String, others: usize } => Code::NoDynamics,
            says("the model lacks values that a run needs: {missing}{}", match others {
                0 => String::new(),
                others => format!(", and {}", if *others == 1 { "one further entry".to_owned() } else { format!("{others} further entries") }),
            }),
            hint("`loosepin motion` needs neither masses nor contacts; `loosepin check` lists what a run needs");
        /// The step became too small.
        StepTooSmall { time_s: f64, step_s: f64, smallest_s: f64 } => Code::StepTooSmall,
            says("at {} the step decreased to {step_s:.1e} s, below the smallest permitted step of {smallest_s:.1e} s", time(*time_s)),
            hint("{}", if *smallest_s > COARSE_S {
                "the drive is so slow that contacts, which last microseconds, are shorter than 1e-14 of a turn: use a higher speed, or \
                 `loosepin motion`, which needs no dynamics"
            } else {
                "look for a stiffness, mass or inertia far from those of a real part, or a tolerance below round-off"
            });
        /// A position, a velocity or a user's expression is not a number.
        NotFinite {
            time_s: f64,
            /// Path of the drive, load or control whose expression has no value, or of the beam that no step follows.
            element: Option<String>,
        } => Code::RunNotFinite,
            says("at {} {} is not a finite number", time(*time_s), match element {
                Some(path) => match of_beam(path) {
                    Some(body) => {
                        format!("the beam of {} vibrates faster than the smallest step can resolve: a position or velocity", describe_path(body))
                    }
                    None => describe_path(path),
                },
                None => "a position or velocity".to_owned(),
            }),
            hint("{}", match element {
                Some(path) if of_beam(path).is_some() => {
                    "look for a modulus, a density or a section far from those of a real part"
                }
                Some(_) => {
                    "its expression leaves the domain of log, sqrt, ^ or /: keep their arguments inside, for example \
                     log(max(x, 1e-6))"
                }
                None => {
                    "look for a stiffness, mass or inertia far from those of a real part, or a tolerance below round-off"
                }
            });
        /// The drive whose turns are counted does not turn.
        StandsStill { drive: String } => Code::DriveStandsStill,
            says("drive '{drive}' has speed zero, so its turns cannot be counted"),
            hint("give it a speed, or use another drive in [cycle]");
        /// The penetration is so deep that the pin's centre leaves the hole: no contact law means anything there.
        LeavesBearing { joint: String, penetration_m: f64, bearing_radius_m: f64, time_s: f64 } =>
            Code::PinLeavesBearing,
            says(
                "at {} the pin of joint '{joint}' is pressed {} into its hole of radius {}: beyond any contact law",
                time(*time_s),
                length(*penetration_m),
                length(*bearing_radius_m)
            ),
            hint("the contact is too soft, or the drive too fast, for these masses");
        /// The penetration is so deep that the slider's axis leaves the guide.
        LeavesGuide { joint: String, penetration_m: f64, half_height_m: f64, time_s: f64 } => Code::PinLeavesBearing,
            says(
                "at {} a corner of the slider of joint '{joint}' is pressed {} into its guide; its half-height is {}",
                time(*time_s),
                length(*penetration_m),
                length(*half_height_m)
            ),
            hint("the contact is too soft, or the drive too fast, for these masses");
        /// The slider is out of its guide: its rear corner is beyond the end of a face, or its front corner before the start.
        BeyondGuide {
            /// The corner, with the name of its joint.
            contact: String,
            joint: String,
            /// Abscissa of the corner along the guide, m.
            along_m: f64,
            /// Ends of the faces, m.
            ends_m: [f64; 2],
            time_s: f64,
        } => Code::SliderBeyondGuide,
            says(
                "at {} the slider has left its guide: its corner {contact} is at {}, and the faces reach from {} to {}",
                time(*time_s),
                length(*along_m),
                length(ends_m[0]),
                length(ends_m[1])
            ),
            hint("give the guide other ends, or none: nothing supports a slider that has left its faces");
        /// The penetration is deeper than the range of the contact law.
        BeyondLaw { joint: String, law: &'static str, penetration_m: f64, limit_m: f64, time_s: f64 } =>
            Code::BeyondContactLaw,
            says(
                "at {} the pin of joint '{joint}' is pressed {} into its hole; '{law}' gives a force only up to {}",
                time(*time_s),
                length(*penetration_m),
                length(*limit_m)
            ),
            hint("use a law without such a limit: liu or bai-zhao");
        /// The limit of evaluations is reached.
        TooManyEvaluations { time_s: f64, limit: u64 } => Code::RunTooLong,
            says("at {} the limit of {limit} evaluations was reached", time(*time_s)),
            hint("use fewer turns or a larger tolerance");
        /// The energy account does not close.
        EnergyNotBalanced { residual_j: f64, exchange_j: f64 } => Code::EnergyNotBalanced,
            says(
                "the energy balance has an error of {:.1e} of the energy exchanged ({residual_j:.3e} J of {exchange_j:.3e} J); at most \
                 {MAX_ENERGY_RESIDUAL:.0e} is accepted",
                residual_j / exchange_j
            ),
            hint("use a smaller --tolerance, or in a study a smaller tolerance under [sampling]: see `loosepin explain E0820`");
        /// A law that can only take energy gave some.
        LawGainsEnergy {
            /// Which law.
            law: &'static str,
            /// Its joint, where it is one alone.
            joint: Option<String>,
            gained_j: f64,
            exchange_j: f64,
        } => Code::LawGainsEnergy,
            says(
                "{law}{} released {gained_j:.3e} J more than it absorbed, {:.1e} of the energy exchanged: a passive law only absorbs",
                joint.as_ref().map_or(String::new(), |joint| format!(" in joint '{joint}'")),
                gained_j / exchange_j
            ),
            hint("check the coefficients of the law: see `loosepin explain E0821`");
        /// More turns than the evaluations suffice for.
        TooManyTurns {
            turns: f64,
            /// Evaluations that they take at least.
            least: f64,
            limit: u64,
        } => Code::RunTooLong,
            says("{turns} turns take at least {least:.2e} evaluations; must be at most {:.2e}", *limit as f64),
            hint("use fewer turns");
        /// More numbers than a history can hold.
        TooManyNumbers {
            rows: f64,
            /// Numbers in each row.
            numbers: usize,
            most: usize,
        } => Code::BadCount,
            says("{rows} rows of {numbers} numbers each would be recorded; must be at most {most} numbers"),
            hint("use fewer turns, fewer samples per turn or fewer outputs, or omit --states");
        /// More rows than a history can hold.
        TooManyRows {
            /// Turns times rows a turn.
            rows: f64,
            most: usize,
        } => Code::BadCount,
            says("{rows} rows would be recorded; must be at most {most}"),
            hint("use fewer turns or fewer samples per turn");
        /// Friction in an ideal joint has no solution.
        Jams { joint: String, time_s: f64 } => Code::Jams,
            says("at {} joint '{joint}' jams: no friction force agrees with its load", time(*time_s)),
            hint("use less friction, a longer guide or a smaller pin; the equations of rigid bodies have no solution here");
        /// A joint without play has no worn shape that could act back.
        WornWithoutPlay { joint: String } => Code::ConflictingKeys,
            says("joint '{joint}' has no play: with geometry = \"worn\" the shape of its surfaces needs a clearance"),
            hint("give it a radial_clearance above zero, or write geometry = \"fixed\"");
        /// More jumps over the cycles than are made.
        TooManyJumps { reached: f64, cycles: f64, most: usize } => Code::RunTooLong,
            says("the largest number of jumps, {most}, reached only {reached:.4e} of {cycles:.4e} cycles of wear"),
            hint("use a larger tolerance or fewer cycles in [wear]");
        /// Jumps no longer than N_s, which do not reach all cycles.
        JumpsTooShort { cycles: f64, stable_cycles: f64, most: usize } => Code::RunTooLong,
            says(
                "{cycles:.4e} cycles of wear need more than {most} jumps: a jump may have at most {stable_cycles:.4e} cycles \
                 here"
            ),
            hint("use fewer cycles in [wear], or check the wear coefficients: longer jumps make the worn shapes saw-toothed");
        /// Wear beyond all numbers.
        WearNotFinite { joint: String } => Code::RunNotFinite,
            says("the wear of joint '{joint}' is not a finite number"),
            hint("check its coefficients, and the cycles in [wear]: dry steel has about 1e-13 m^2/N");
        /// The observer of the run has stopped it.
        Stopped { time_s: f64 } => Code::Interrupted,
            says("stopped at {} of its time", time(*time_s));
        /// Flexible bodies that are to start settled have no stable static shape.
        NotSettled => Code::StartNotPossible,
            says("a flexible body with start = \"settled\" has no stable static shape under the forces at the start"),
            hint("it buckles or bends too far there: check its section, or omit start");
        /// Flexible bodies that are to start settled leave loops of ideal joints open.
        SettledOpen {
            /// Path of the joint or coupling that stays open.
            path: String,
        } => Code::StartNotPossible,
            says(
                "a flexible body with start = \"settled\" bends or stretches there, and the links cannot close at {}",
                describe_path(path)
            ),
            hint("all other parts of this loop are rigid: omit start, or give one of its joints play");
        /// No force presses a journal that is to rest at the start.
        NothingPresses { joint: String } => Code::StartNotPossible,
            says("joint '{joint}' carries no force at the start, so its journal does not rest on any side"),
            hint("give an offset instead of start; without one, the journal is centred");
        /// The side on which a journal is to rest is not found.
        NotResting { joint: String } => Code::StartNotPossible,
            says("joint '{joint}': the side on which its journal rests at the start was not found"),
            hint("the clearance is large compared with the links there: give an offset");
        /// A spring along a line whose ends meet.
        SpringWithoutDirection { spring: String, time_s: f64 } => Code::RunNotFinite,
            says("at {} spring '{spring}' is compressed to length zero: its force has no direction there", time(*time_s)),
            hint("give it a stop (more stiffness at the end of a table of its force), or points that stay apart");
        /// A mechanism in space has no position, or no worst case, for these values.
        NoPosition { why: String, hint: &'static str } => Code::CannotClose,
            says("{why}"),
            hint("{hint}");
        /// Parts of a mechanism in space that do not fit with all their play.
        CannotBePutTogether { why: String, hint: &'static str } => Code::CannotClose,
            says("{why}"),
            hint("{hint}");
        /// Play takes a mechanism in space to a dead centre.
        DeadCentre { why: String, hint: &'static str } => Code::CannotClose,
            says("{why}"),
            hint("{hint}");
        /// Implicit steps are for flexible bodies in absolute nodal coordinates alone.
        ImplicitWithoutNodes => Code::BeamNotPossible,
            says("implicit steps need a flexible body in absolute nodal coordinates, and this mechanism has none"),
            hint("omit --integrator: explicit steps are faster here");
        /// The drives leave nothing free that a neighbouring motion could differ in.
        NothingIsFree => Code::NothingIsFree,
            says("the drives alone determine the motion: no neighbouring motion exists, so there is no Lyapunov exponent"),
            hint("omit --lyapunov, or give a joint some play");
    }
}

/// A smallest step beyond which contacts of real parts cannot be followed, s: they last some 1e-5 s, and their ends are located to 1e-4 of that.
const COARSE_S: f64 = 1e-9;

fn time(time_s: f64) -> String {
    format_value(time_s, Dimension::TIME)
}

fn length(length_m: f64) -> String {
    format_value(length_m, Dimension::LENGTH)
}

/// Short names of all reasons, in the order of [`RunFailure::number`].
const CODES: [&str; 39] = [
    "impossible_value",
    "clearance_changes_topology",
    "cannot_close",
    "singular_position",
    "step_too_small",
    "not_finite",
    "drive_stands_still",
    "too_many_evaluations",
    "too_many_rows",
    "pin_leaves_bearing",
    "beyond_contact_law",
    "clearance_outside_fit",
    "start_contradicts",
    "roughness_outside_film",
    "nothing_is_free",
    "joint_jams",
    "slider_leaves_guide",
    "slider_beyond_guide",
    "stopped",
    "energy_not_balanced",
    "law_gains_energy",
    "too_many_turns",
    "too_many_numbers",
    "not_settled",
    "worn_without_play",
    "too_many_jumps",
    "wear_not_finite",
    "jumps_too_short",
    "point_off_section",
    "implicit_without_nodes",
    "settled_open",
    "no_dynamics",
    "length_outside_film",
    "nothing_presses",
    "not_resting",
    "spring_without_direction",
    "no_position",
    "cannot_be_put_together",
    "dead_centre",
];

/// Path of the body where a path is that of its beam.
fn of_beam(path: &str) -> Option<&str> {
    path.strip_suffix(".beam").filter(|body| body.starts_with("body."))
}

impl RunFailure {
    /// The failure of a run in which `lost`, or the state itself, has no value.
    pub(crate) fn without_value(time_s: f64, lost: Option<WithoutValue>) -> Self {
        match lost {
            Some(WithoutValue::Spring(spring)) => Self::SpringWithoutDirection { spring, time_s },
            Some(WithoutValue::Element(path)) => Self::NotFinite { time_s, element: Some(path) },
            None => Self::NotFinite { time_s, element: None },
        }
    }

    /// A short name for tables.
    pub fn code(&self) -> &'static str {
        Self::code_of(self.number())
    }

    /// A number for tables.
    pub fn number(&self) -> u16 {
        match self {
            Self::Sample(SampleError::Quantity(_) | SampleError::Period(_)) => 0,
            Self::Sample(
                SampleError::ClearanceChangesTopology { .. } | SampleError::BacklashChangesTopology { .. },
            ) => 1,
            Self::Sample(SampleError::CannotClose { .. }) => 2,
            Self::Sample(SampleError::Singular { .. }) => 3,
            Self::StepTooSmall { .. } => 4,
            Self::NotFinite { .. } | Self::Sample(SampleError::DriveWithoutValue { .. }) => 5,
            Self::StandsStill { .. } => 6,
            Self::TooManyEvaluations { .. } => 7,
            Self::TooManyRows { .. } => 8,
            Self::LeavesBearing { .. } => 9,
            Self::BeyondLaw { .. } => 10,
            Self::Sample(SampleError::ClearanceOutsideFit { .. }) => 11,
            Self::Sample(SampleError::StartContradicts { .. } | SampleError::OffsetBeyondPlay { .. }) => 12,
            Self::Sample(SampleError::RoughnessOutsideFilm { .. }) => 13,
            Self::NothingIsFree => 14,
            Self::Jams { .. } => 15,
            Self::LeavesGuide { .. } => 16,
            Self::BeyondGuide { .. } => 17,
            Self::Stopped { .. } => 18,
            Self::EnergyNotBalanced { .. } => 19,
            Self::LawGainsEnergy { .. } => 20,
            Self::TooManyTurns { .. } => 21,
            Self::TooManyNumbers { .. } => 22,
            Self::NotSettled => 23,
            Self::WornWithoutPlay { .. } => 24,
            Self::TooManyJumps { .. } => 25,
            Self::WearNotFinite { .. } => 26,
            Self::JumpsTooShort { .. } => 27,
            Self::Sample(SampleError::PointOffSection { .. }) => 28,
            Self::ImplicitWithoutNodes => 29,
            Self::SettledOpen { .. } => 30,
            Self::NoDynamics { .. } => 31,
            Self::Sample(SampleError::LengthOutsideFilm { .. }) => 32,
            Self::NothingPresses { .. } => 33,
            Self::NotResting { .. } => 34,
            Self::SpringWithoutDirection { .. } => 35,
            Self::NoPosition { .. } => 36,
            Self::CannotBePutTogether { .. } => 37,
            Self::DeadCentre { .. } => 38,
        }
    }

    /// The short name of a number that [`Self::number`] gave.
    pub fn code_of(number: u16) -> &'static str {
        CODES.get(usize::from(number)).copied().unwrap_or("unknown")
    }
}

impl RunFailure {
    /// The diagnostic about the model whose run failed, at the part that it concerns.
    pub fn diagnostic(&self, model: &Model) -> Diagnostic {
        match self {
            Self::Sample(error) => error.diagnostic(model),
            Self::StandsStill { drive } => Diagnostic::error(self, model.place(&format!("drive.{drive}.speed"))),
            Self::LeavesBearing { joint, .. }
            | Self::LeavesGuide { joint, .. }
            | Self::BeyondGuide { joint, .. }
            | Self::BeyondLaw { joint, .. }
            | Self::WornWithoutPlay { joint }
            | Self::WearNotFinite { joint }
            | Self::Jams { joint, .. } => Diagnostic::error(self, model.place(&format!("joint.{joint}"))),
            Self::NotFinite { element, .. } => {
                Diagnostic::error(self, element.as_ref().and_then(|path| model.place(path)))
            }
            Self::StepTooSmall { .. }
            | Self::TooManyEvaluations { .. }
            | Self::EnergyNotBalanced { .. }
            | Self::Stopped { .. } => Diagnostic::error(self, None),
            Self::NoDynamics { .. } => {
                let first = model.missing_for_runs.first();
                Diagnostic::error(self, first.and_then(|missing| missing.place.clone()))
            }
            Self::LawGainsEnergy { joint, .. } => {
                let place = joint.as_ref().and_then(|joint| model.place(&format!("joint.{joint}")));
                Diagnostic::error(self, place)
            }
            Self::TooManyRows { .. } | Self::TooManyNumbers { .. } | Self::TooManyTurns { .. } => {
                Diagnostic::error(self, model.place("cycle"))
            }
            Self::NothingPresses { joint } | Self::NotResting { joint } => {
                Diagnostic::error(self, model.place(&format!("initial.joint.{joint}")))
            }
            Self::SpringWithoutDirection { spring, .. } => {
                Diagnostic::error(self, model.place(&format!("spring.{spring}")))
            }
            Self::SettledOpen { path } => Diagnostic::error(self, model.place(path)),
            Self::TooManyJumps { .. } | Self::JumpsTooShort { .. } => Diagnostic::error(self, model.place("wear")),
            Self::NothingIsFree
            | Self::NotSettled
            | Self::ImplicitWithoutNodes
            | Self::NoPosition { .. }
            | Self::CannotBePutTogether { .. }
            | Self::DeadCentre { .. } => Diagnostic::error(self, None),
        }
    }
}
