//! Problems of flexible links.

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
            hint("use another point as from or to");
        HalfSection { entry: String, given: &'static str, needs: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{given}' needs '{needs}'"),
            hint("also give '{needs}'");
        NoShapes { entry: String } => Code::BeamNotPossible,
            says("{entry} has neither lateral nor axial shapes"),
            hint("a body that does not deform has mass, inertia and centre_of_mass instead of beam");
        HeldInside { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at a point between its ends"),
            hint("hold it at from, with frame = \"tangent\"; between the ends use a revolute joint");
        WrongJoint { entry: String, body: String, kind: &'static str } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is flexible and cannot be held by a {kind}"),
            hint("hold it by revolute joints; at from also by a drive or a rigid joint, with frame = \"tangent\"");
        NeedsSecant { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' has a tangent frame and turns freely at from"),
            hint("use frame = \"secant\", or drive this joint");
        NeedsTangent { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' has a secant frame, but its section at from is held"),
            hint("use frame = \"tangent\" in [body.{body}.beam]");
        HeldAtTo { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at the end called to"),
            hint("exchange from and to in [body.{body}.beam], with frame = \"tangent\"");
        NotHeld { entry: String } => Code::BeamNotPossible,
            says("{entry}: frame is \"tangent\", but neither a drive nor a rigid joint holds the section at from"),
            hint("use frame = \"secant\"");
        TurnOf { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is flexible, so each of its sections has its own angle"),
            hint("use a rigid body, or a force or a spring between points");
        NoHeight { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is given by area and second moment, but the stress needs its height"),
            hint("give the section of [body.{body}.beam] by width and height, by diameter, or by outer and inner diameter");
        StressHeldAtBothEnds { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: the section of body '{body}' is held at both ends, and the stress does not include the moments there yet"),
            hint("use a revolute joint at one of its ends, or remove the stress");
        OfOtherFormulation { entry: String, key: &'static str, formulation: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{key}' belongs to formulation = \"{formulation}\""),
            hint("remove '{key}', or write formulation = \"{formulation}\"");
        NodalPointBetween { entry: String } => Code::BeamNotPossible,
            says("{entry} is not an end of the beam; in absolute nodal coordinates it has points at from and to only"),
            hint("remove the point, or write formulation = \"floating-frame\"");
        IsRigid { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: body '{body}' is rigid; stress is computed along flexible bodies"),
            hint("give it [body.{body}.beam] instead of mass, inertia and centre_of_mass");
        Beside { entry: String, body: String } => Code::BeamNotPossible,
            says("{entry}: this is not computed yet in a mechanism with a flexible body, here '{body}'"),
            hint("give body '{body}' its mass, inertia and centre_of_mass instead of beam, or remove this entry");
    }
}
