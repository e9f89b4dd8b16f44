//! What flexible links cannot have.

use loosepin_text::diagnostics::{Code, problems};

problems! {
    /// An error about a flexible link. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum BeamProblem {
        NoSuchPoint { entry: String, body: String, point: String, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: body '{body}' has no point '{point}'"),
            hint("it has {}", if known.is_empty() { "no points".to_owned() } else { known.join(", ") });
        SamePoint { entry: String } => Code::BeamNotPossible,
            says("{entry} ends where it begins"),
            hint("name another point as from or to");
        HalfSection { entry: String, given: &'static str, needs: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{given}' needs '{needs}'"),
            hint("give '{needs}' too");
        NoShapes { entry: String } => Code::BeamNotPossible,
            says("{entry} has neither lateral nor axial shapes"),
            hint("a body that does not deform has mass, inertia and centre_of_mass in place of beam");
        HeldInside { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at a point inside"),
            hint("hold it at from, with frame = \"tangent\"; inside take a revolute joint");
        WrongJoint { entry: String, body: String, kind: &'static str } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is flexible and cannot be held by a {kind}"),
            hint("hold it by revolute joints; at from also by a drive or a rigid joint, with frame = \"tangent\"");
        NeedsSecant { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' has a tangent frame and turns freely at from"),
            hint("take frame = \"secant\", or drive this joint");
        NeedsTangent { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' has a secant frame, and its section at from is held"),
            hint("take frame = \"tangent\" in [body.{body}.beam]");
        HeldAtTo { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at the end called to"),
            hint("exchange from and to in [body.{body}.beam], with frame = \"tangent\"");
        NotHeld { entry: String } => Code::BeamNotPossible,
            says("{entry}: frame is \"tangent\", and neither a drive nor a rigid joint holds the section at from"),
            hint("take frame = \"secant\"");
        TurnOf { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is flexible; each of its sections has an angle of its own"),
            hint("let it act on a rigid body, or take a force or a spring between points");
        NoHeight { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is given by area and second moment, and the stress needs its height"),
            hint("give the section of [body.{body}.beam] by width and height, by diameter, or by outer and inner diameter");
        StressHeldAtBothEnds { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at both ends, and the couples there are not in the stress yet"),
            hint("let a revolute joint carry one of its ends, or leave the stress out");
        OfOtherFormulation { entry: String, key: &'static str, formulation: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{key}' belongs to formulation = \"{formulation}\""),
            hint("leave '{key}' out, or write formulation = \"{formulation}\"");
        NodalPointBetween { entry: String } => Code::BeamNotPossible,
            says("{entry} is not an end of the beam; in absolute nodal coordinates it has points at from and to only"),
            hint("leave the point out, or write formulation = \"floating-frame\"");
        IsRigid { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is rigid; stress is computed along flexible bodies"),
            hint("give it [body.{body}.beam] in place of mass, inertia and centre_of_mass");
        Beside { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: this is not computed yet in a mechanism with a flexible body, here '{body}'"),
            hint("give body '{body}' its mass, inertia and centre_of_mass in place of beam, or leave this out");
    }
}
