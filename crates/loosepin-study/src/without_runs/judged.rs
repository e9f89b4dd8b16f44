//! What judging without runs has in common, whatever the ends are that limits are held against.

use crate::file::{Requirement, Study};
use crate::response::input_limits::InputLimits;
use loosepin_mechanics::model::Setting;
use loosepin_result::motion::{MotionAllowance, MotionRequirement, MotionVerdict};

/// What is judged of a study.
#[derive(Default)]
pub(crate) struct Judgement {
    pub requirements: Vec<MotionRequirement>,
    pub allowances: Vec<MotionAllowance>,
}

/// The limits of all inputs but those that `set` gives a value.
pub(super) fn limits_unless_set(study: &Study, set: &[String]) -> Vec<InputLimits> {
    let is_set = |path: &str| set.iter().any(|text| Setting::is_of(text, path));
    study.input_limits().into_iter().filter(|input| !is_set(&input.path)).collect()
}

/// How far an output goes at a place.
pub(super) struct KnownEnds {
    /// Ends that were found; NaN where none were searched.
    pub found_si: [f64; 2],
    /// Angles of the drive at which they were found.
    pub found_at_rad: [f64; 2],
    /// Ends that nothing passes.
    pub proven_si: [f64; 2],
    /// Why nothing is proven, where that is so.
    pub reason: Option<String>,
    /// Whether only runs say how far it goes.
    pub needs_dynamics: bool,
}

/// Ends of which nothing is proven.
pub(super) const NOTHING_PROVEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// The verdict on a requirement at a place, at least `share` of all mechanisms having all inputs within their limits.
pub(super) fn judged(
    study: &Study,
    requirement: &Requirement,
    pose_rad: Option<f64>,
    share: f64,
    ends: KnownEnds,
) -> MotionRequirement {
    let output = &study.outputs[requirement.output];
    let [lower_si, upper_si] = requirement.limit.ends();
    let KnownEnds { found_si, found_at_rad, proven_si, reason, needs_dynamics } = ends;
    let is_proven = reason.is_none() && lower_si <= proven_si[0] && proven_si[1] <= upper_si;
    let is_broken = found_si[0] < lower_si || found_si[1] > upper_si;
    let verdict = if needs_dynamics {
        MotionVerdict::NeedsDynamics
    } else if is_broken {
        MotionVerdict::NotMetInTheWorstCase
    } else if is_proven && share >= requirement.probability_at_least {
        MotionVerdict::Met
    } else {
        MotionVerdict::Undecided
    };
    MotionRequirement {
        output: output.name.clone(),
        unit: output.unit.clone(),
        of: requirement.deviation,
        pose_rad,
        lower_si,
        upper_si,
        probability_at_least: requirement.probability_at_least,
        share_within_limits: share.max(0.0),
        proven_si,
        found_si,
        found_at_rad,
        verdict,
        reason,
    }
}
