//! Errors of a model beyond its single entries.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::listed;
use loosepin_text::numbers::EntryProblem;
use loosepin_text::units::{Dimension, counted};

problems! {
    /// An error in a model file. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum ModelProblem | Entry(EntryProblem) {
        InSpace => Code::WrongKindOfFile,
            says("this command works on planar models; a model in space is known to check, motion and study");
        NotAnActuator {
            entry: String,
            text: String,
            /// The drive or control of this name, as it is written.
            meant: Option<String>,
        } => Code::UnknownReference,
            says("{entry} is '{text}'; must be drive.NAME or control.NAME"),
            hint_of(Some(match meant {
                Some(meant) => format!("did you mean '{meant}'?"),
                None => "for example \"drive.crank\": the drive 'crank'".to_owned(),
            }));
        WrongEffort {
            entry: String,
            /// With its name, in words.
            actuator: String,
            joint: String,
            /// Whether the joint is a revolute one.
            turns: bool,
            /// The drive or control as it is written.
            text: String,
        } => Code::ConflictingKeys,
            says("{entry}: {actuator} {} joint '{joint}', so it has a {}",
                if *turns { "turns" } else { "pushes along" }, if *turns { "torque, not a force" } else { "force, not a torque" }),
            hint("write {} = \"{text}\"", if *turns { "torque_of" } else { "force_of" });
        StiffnessTwice { entry: String, material: &'static str, given: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{material}' and '{given}' cannot be used together; the stiffness comes either from \
                  materials or from '{given}'");
        NoStiffness { entry: String } => Code::MissingKey,
            says("{entry}: the stiffness is missing"),
            hint("give youngs_modulus and poisson_ratio, or stiffness and exponent");
        /// A material value for both parts and for one of them.
        MaterialTwice { entry: String, both: &'static str, one: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{both}' and '{one}' cannot be used together");
        FilmNeedsLength { entry: String } => Code::ConflictingKeys,
            says("{entry}: 'contact' needs 'bearing_length'"),
            hint("the contact has a film of oil, whose force depends on the length of the bearing");
        LeanNeedsLength { entry: String } => Code::MissingKey,
            says("{entry}: a pin that leans needs 'bearing_length'"),
            hint("lean = \"free\" lets pins with play lean in their bearings, the more the shorter these are; for example bearing_length = \"20 mm\"");
        NothingWears { entry: String } => Code::MissingKey,
            says("{entry}: neither 'bearing' nor 'journal' has a coefficient"),
            hint("for example bearing = {{ coefficient = \"1e-15 m^2/N\" }}");
        WearByLiteral { entry: String, contact: String } => Code::ConflictingKeys,
            says("{entry} cannot be used with contact '{contact}', whose sliding_velocity is \"literal\""),
            hint("wear depends on the sliding of the materials: write sliding_velocity = \"material\"");
        WearNeedsMaterials { entry: String, contact: String } => Code::ConflictingKeys,
            says("{entry}: Hertzian pressure needs the materials of contact '{contact}', but its stiffness is given"),
            hint("give youngs_modulus and poisson_ratio instead of the stiffness, or write pressure = \"concentrated\"");
        /// A contact whose worn shape cannot act back.
        WornContact { entry: String, joint: String, contact: String, what: &'static str } => Code::ConflictingKeys,
            says("{entry}: geometry = \"worn\" cannot be used with joint '{joint}': its contact '{contact}' {what}"),
            hint("the worn shape changes the forces through an elastic foundation; geometry = \"fixed\" keeps the unworn shape");
        /// A key of worn geometry beside a fixed one.
        OnlyWorn { entry: String, key: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{key}' needs geometry = \"worn\""),
            hint("with the unworn geometry, wear is proportional to the cycles, and outputs do not change");
        /// A key of fixed geometry beside a worn one.
        OnlyFixed { entry: String, key: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{key}' cannot be used with geometry = \"worn\""),
            hint("remove it: the elastic foundation distributes the pressure");
        /// The output of a limit.
        NoLimitedOutput { entry: String, output: String } => Code::UnknownReference,
            says("{entry}: there is no output '{output}' with its own history"),
            hint("use an output of a motion, force or torque; for a path, use its coordinates");
        /// A measure of wear that a fixed geometry does not have.
        MeasureOfWornGeometry { output: String, measure: &'static str, needs: &'static str } => Code::ConflictingKeys,
            says("output.{output}: component = \"{measure}\" needs {needs} in [wear]");
        NoJointWears => Code::MissingKey,
            says("no joint of the model wears"),
            hint("give a joint with play its wear, for example wear.bearing.coefficient = \"1e-15 m^2/N\"");
        DoesNotWear { entry: String, joint: String } => Code::UnknownReference,
            says("{entry}: joint '{joint}' does not wear"),
            hint("give it [joint.{joint}.wear]");
        /// A key without effect in this combination.
        RelativeToItself { entry: String, body: String } => Code::ConflictingKeys,
            says("{entry}: body '{body}' does not move relative to itself"),
            hint("use another body, or omit relative_to to measure from the ground");
        NoBodies { entry: String } => Code::MissingKey,
            says("{entry}: the two bodies are missing"),
            hint("give a revolute joint as joint, or two bodies as first and second");
        DoesNotTurn { entry: String, joint: String } => Code::UnknownReference,
            says("{entry}: joint '{joint}' does not turn; a torsional spring needs a revolute joint"),
            hint("give a revolute joint, or two bodies as first and second");
        /// A clearance on the radius and one on the diameter.
        ClearanceTwice { entry: String } => Code::ConflictingKeys,
            says("{entry}: 'radial_clearance' and 'diametral_clearance' cannot be used together"),
            hint("keep one of the two; the diametral clearance is twice the radial clearance");
        LoadOnGround { entry: String } => Code::UnknownReference,
            says("{entry} acts on the ground, which does not move");
        DoesNotMove { entry: String, joint: String, why: &'static str } => Code::UnknownReference,
            says("{entry}: joint '{joint}' {why}, so it has neither angle nor position");
        JointNotRead { entry: String, key: &'static str } => Code::ConflictingKeys,
            says("{entry}: 'joint' has no effect here; '{key}' is not an expression of its angle, position or speed");
        NotOfJoint { entry: String, word: &'static str, names: Vec<&'static str> } => Code::ConflictingKeys,
            says("{entry} is '{word}'; must be {}", listed(&names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>(), "or")),
            hint("{}", match names.len() {
                1 => "angle, position and speed need a joint: add joint = \"...\"",
                _ => "a revolute joint has angle and speed, a prismatic joint or a slot position and speed",
            });
        NameTaken { entry: String, name: &'static str } => Code::BadName,
            says("{entry}: '{name}' is both a parameter of this file and a variable of this expression"),
            hint("give the parameter another name, for example {name}_value");
        InverseFunction { entry: String } => Code::FunctionNotPossible,
            says("{entry}: inverse trigonometric functions cannot be used with values that change in time"),
            hint("define the constant part under [parameter], and use its name");
        NotForPlanes {
            entry: String,
            contact: String,
            /// The numbers of it that do not apply, in words.
            what: String,
            what_touches: &'static str,
        } => Code::ConflictingKeys,
            says("{entry}: contact '{contact}' has {what}, which cannot be used for {what_touches}"),
            hint("use a point-contact or linear law without a film, and the material sliding velocity");
        NotDrivable { entry: String, joint: String, why: &'static str, hint: &'static str } => Code::DriveNotPossible,
            says("{entry}: joint '{joint}' {why} and cannot be driven"),
            hint("{hint}");
        CsvColumns { found: usize, text: String } => Code::TableNotReadable,
            says("a row has {}; expected two", counted(*found, "column")),
            hint_of(Some(if text.contains(';') {
                format!("columns are separated by commas, and numbers have a decimal point: write '{text}' as '{}'",
                    text.replace(',', ".").replace(';', ","))
            } else if *found > 2 {
                "a comma separates columns; decimal numbers have a point".to_owned()
            } else {
                "for example: time [s], angle [deg]".to_owned()
            }));
        CsvHeader { text: String } => Code::TableNotReadable,
            says("the header is '{text}'; must be a name with a unit in brackets"),
            hint("for example: time [s], angle [deg]");
        CsvDimension { text: String, due: Dimension } => Code::TableNotReadable,
            says("the column '{text}' must contain {due}");
        CsvNumber { text: String } => Code::TableNotReadable,
            says("'{text}' is not a number"),
            hint("{}", if text.contains(';') {
                "columns are separated by commas, and numbers have a decimal point"
            } else {
                "write numbers with a decimal point and no thousands separator, for example 0.25 or 1e-3"
            });
        SameJoint { entry: String, joint: String } => Code::SameBody,
            says("{entry} couples joint '{joint}' to itself");
        WrongJoint { entry: String, joint: String, due: &'static str } => Code::CouplingNotPossible,
            says("{entry}: joint '{joint}' is not {due}");
        NoCarrier { entry: String, first: String, second: String } => Code::CouplingNotPossible,
            says("{entry}: joints '{first}' and '{second}' must have exactly one body in common, which carries both \
                  wheels"),
            hint("mount both wheels on the same body: the frame, or the carrier of a planetary gear; kind = \"ratio\" \
                  couples any two joints");
        BacklashNeedsRadii { entry: String } => Code::PlayOfCoupling,
            says("{entry}: 'backlash' cannot be used with 'teeth'; it is a length on the pitch circles"),
            hint("give the pitch radii as radii instead of teeth");
        ForceNeedsRadii { entry: String } => Code::TeethNotPossible,
            says("{entry}: 'pressure_angle' cannot be used with 'teeth'; the force of teeth is a torque over a pitch radius"),
            hint("give the pitch radii as radii instead of teeth");
        ForceOnPlay { entry: String, joint: String } => Code::TeethNotPossible,
            says("{entry}: 'pressure_angle' cannot be used if joint '{joint}' has play; the effect of the tooth force on the \
                  position of its pin is not modelled"),
            hint("remove pressure_angle, or the clearance of this joint");
        ForceOnFriction { entry: String, joint: String } => Code::TeethNotPossible,
            says("{entry}: 'pressure_angle' cannot be used if joint '{joint}' has friction; the effect of the tooth force on \
                  this friction is not modelled"),
            hint("remove pressure_angle, or the friction of this joint");
        ForceOnSlot { entry: String, joint: String } => Code::TeethNotPossible,
            says("{entry}: 'pressure_angle' cannot be used if joint '{joint}' is a slot; a slot does not keep \
                  the rack parallel to its line"),
            hint("remove pressure_angle, or guide the rack in a prismatic joint");
        NotForFlanks {
            entry: String,
            contact: String,
            /// What of it does not apply, in words.
            what: String,
            what_touches: &'static str,
        } => Code::PlayOfCoupling,
            says("{entry}: contact '{contact}' has {what}, which cannot be used for {what_touches}"),
            hint("use a contact with a given stiffness (stiffness and exponent, or a linear law), without friction and without a film");
        FollowerTurns { entry: String, joint: String } => Code::PlayOfCoupling,
            says("{entry}: joint '{joint}' turns; only a follower that slides can lift off"),
            hint("omit contact, or use a prismatic joint as follower");
        CamPeriod { entry: String, from: String, to: String, whole: String } => Code::BreaksRule,
            says(
                "{entry}: its points go from {from} to {to}, which is one period of the profile; a period must be one turn, a whole number of \
                 turns, or one turn divided by a whole number"
            ),
            hint("continue the points to {whole}: the profile is not defined between the last point and this one");
        ControlledTwice { entry: String, joint: String, other: String } => Code::DrivenTwice,
            says("{entry}: {other} already moves joint '{joint}'");
        CycleNeedsTurns { drive: String } => Code::DriveNotPossible,
            says("cycle: drive '{drive}' moves a prismatic joint; its turns cannot be counted"),
            hint("use a drive of a revolute joint, or give duration instead of drive");
        CycleNeedsPeriod { drive: String, kind: &'static str } => Code::DriveNotPossible,
            says("cycle: drive '{drive}' follows a motion of kind {kind}, which has neither turns nor a period to \
                  count"),
            hint("give duration instead of drive");
        TooFewPoints { entry: String, least: usize } => Code::BadCount,
            says("{entry} has too few entries; it needs at least {least}");
        InitialOfGround => Code::UnknownReference,
            says("initial: the ground does not move, so it has no initial state");
        WrongCoordinate { entry: String, key: String } => Code::ConflictingKeys,
            says("{entry}: '{key}' does not fit this kind of joint"),
            hint("a revolute joint has angle and angular_velocity, a prismatic joint position and velocity");
        OffsetWithoutPlay { entry: String, key: String, joint: String } => Code::ConflictingKeys,
            says("{entry}: '{key}' needs a journal in its bearing; joint '{joint}' is not a revolute joint with a clearance"),
            hint("give it a radial_clearance, or remove the key");
        GuessOfGround => Code::UnknownReference,
            says("assembly: the ground does not move, so its angle needs no guess");
        WrongUnit { entry: String, unit: String, due: Dimension } => Code::WrongDimension,
            says("{entry} is '{unit}'; must be a unit of {due}");
    }
}

/// A key that needs others.
pub(in crate::model) fn needs_keys(entry: String, key: &'static str, needs: Vec<&'static str>) -> EntryProblem {
    let hint = hint_of_needs(key, &needs);
    EntryProblem::NeedsKeys { entry, key, needs, hint }
}

/// The way out where a key of a planar model needs others.
pub(in crate::model) fn hint_of_needs(key: &str, needs: &[&'static str]) -> Option<&'static str> {
    match key {
        "thermal_expansion" => Some("give it here, or at the top of the file for all parts"),
        "contact" if needs.contains(&"bearing_length") => {
            Some("the contact has a line-contact law, whose force is proportional to the length")
        }
        "contact" if needs.contains(&"corner_radius") => {
            Some("the stiffness of the contact comes from the materials: a sphere of that radius on a plane")
        }
        _ if needs.contains(&"radial_clearance") => {
            Some("or give 'diametral_clearance', which is twice the radial clearance")
        }
        "radial_clearance" | "diametral_clearance" | "clearance" => {
            Some("a joint without play has no clearance, or a clearance of \"0 mm\"")
        }
        _ => None,
    }
}
