//! Requirements judged without runs by play at its worst, where proofs are of play alone.
//!
//! Parts that scatter are not in these proofs: nothing is proven with them, and what play alone breaks is broken.

use super::judge::{Judgement, limits_unless_set};
use crate::file::{Requirement, Study};
use crate::model::PlayProofs;
use crate::model::outputs::OutputSource;
use crate::response::input_limits::InputLimits;
use loosepin_result::motion::{MotionRequirement, MotionVerdict};
use loosepin_space::{IsStopped, PlayEnds, PlayQuestion, SampledPart};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::{QuantityId, Values};
use std::f64::consts::TAU;

/// Judges what a study requires; inputs that `set` names have that value, and in `widest` those that decide a play the one with the most of it.
///
/// # Errors
/// A setting that the model does not take; loops that do not close; that it was stopped.
pub(super) fn judge_by_play(
    study: &Study,
    proofs: &dyn PlayProofs,
    (set, widest): (&[String], &[String]),
    is_stopped: IsStopped<'_>,
) -> Result<Judgement, Diagnostics> {
    let values = study.model.clone().take_settings(widest)?;
    let limits = limits_unless_set(study, set);
    let judge = JudgeByPlay { study, proofs, parts: Parts::new(study, &values, &limits), values, is_stopped };
    let mut judgement = Judgement::default();
    for requirement in &study.requirements {
        let poses = match requirement.location.angles_rad() {
            Some(angles_rad) => angles_rad.iter().map(|angle| Some(*angle)).collect(),
            None => vec![None],
        };
        for pose_rad in poses {
            judgement.requirements.push(judge.outcome(requirement, pose_rad)?);
        }
    }
    Ok(judgement)
}

/// What inputs do to the parts while they lie within their limits.
struct Parts {
    /// At least this share of all mechanisms has all inputs within the limits.
    share: f64,
    /// An input that changes more than clearances.
    scattering: Option<String>,
    /// An input that makes one play smaller where it makes another one larger: no values have all plays at their largest.
    torn: Option<String>,
}

impl Parts {
    fn new(study: &Study, widest: &Values, limits: &[InputLimits]) -> Self {
        let quantities = study.model.quantities();
        let mut parts = Self { share: 1.0, scattering: None, torn: None };
        for input in limits {
            let plays: Vec<QuantityId> =
                study.model.play_from(input.quantity).into_iter().map(|play| play.quantity).collect();
            let is_other = |id: QuantityId, path: &str| !path.starts_with("parameter.") && !plays.contains(&id);
            let moves =
                quantities.iter().any(|(id, own)| is_other(id, &own.path) && quantities.depends_on(id, input.quantity));
            if moves || !plays.is_empty() {
                parts.share -= 1.0 - input.share;
            }
            if moves {
                parts.scattering.get_or_insert_with(|| input.path.clone());
            }
            let is_larger = |end_si: f64| {
                let values = quantities.evaluate(&[(input.quantity, end_si)]);
                let at_end = quantities.evaluate(&[(input.quantity, widest[input.quantity])]);
                let pairs = values.ok().zip(at_end.ok());
                pairs.is_none_or(|(values, at_end)| plays.iter().any(|play| values[*play] > at_end[*play]))
            };
            if !plays.is_empty() && [input.low_si.max(0.0), input.high_si].into_iter().any(is_larger) {
                parts.torn.get_or_insert_with(|| input.path.clone());
            }
        }
        parts
    }

    /// Why ends of play alone are none of the mechanisms.
    fn unproven(&self) -> Option<String> {
        let scattering = self.scattering.as_ref();
        let scattering =
            scattering.map(|path| format!("{path} is uncertain, and in space only play is bounded without runs"));
        scattering.or_else(|| {
            self.torn.as_ref().map(|path| format!("{path} makes one play larger where it makes another one smaller"))
        })
    }
}

struct JudgeByPlay<'s> {
    study: &'s Study,
    proofs: &'s dyn PlayProofs,
    values: Values,
    parts: Parts,
    is_stopped: IsStopped<'s>,
}

impl JudgeByPlay<'_> {
    fn outcome(&self, requirement: &Requirement, pose_rad: Option<f64>) -> Result<MotionRequirement, Diagnostics> {
        let output = &self.study.outputs[requirement.output];
        let [lower_si, upper_si] = requirement.limit.ends();
        let ends = match output.seen {
            OutputSource::InSpace(part) if requirement.deviation.has_play() => {
                Some(self.ends(requirement, part, pose_rad)?)
            }
            _ => None,
        };
        let is_judged = ends.is_some() || !requirement.deviation.has_play();
        let ends = ends.unwrap_or_else(|| self.without_play());
        let share = self.parts.share.max(0.0);
        let reason = ends.unproven.or_else(|| self.parts.unproven());
        let is_proven = reason.is_none() && lower_si <= ends.proven[0] && ends.proven[1] <= upper_si;
        let verdict = if !is_judged {
            MotionVerdict::NeedsDynamics
        } else if ends.found[0] < lower_si || ends.found[1] > upper_si {
            MotionVerdict::NotMetInTheWorstCase
        } else if is_proven && share >= requirement.probability_at_least {
            MotionVerdict::Met
        } else {
            MotionVerdict::Undecided
        };
        Ok(MotionRequirement {
            output: output.name.clone(),
            unit: output.unit.clone(),
            of: requirement.deviation,
            pose_rad,
            lower_si,
            upper_si,
            probability_at_least: requirement.probability_at_least,
            share_within_limits: share,
            proven_si: if reason.is_none() { ends.proven } else { [f64::NEG_INFINITY, f64::INFINITY] },
            found_si: ends.found,
            found_at_rad: ends.found_at.map(|turn| self.angle_rad(turn)),
            verdict,
            reason,
        })
    }

    /// The deviation of the parts alone: of those of the drawing, which play is all that changes, it is 0.
    fn without_play(&self) -> PlayEnds {
        PlayEnds { found: [0.0; 2], found_at: [0.0; 2], proven: [0.0; 2], unproven: None }
    }

    fn ends(
        &self,
        requirement: &Requirement,
        part: SampledPart,
        pose_rad: Option<f64>,
    ) -> Result<PlayEnds, Diagnostics> {
        let question = PlayQuestion {
            part,
            is_value: requirement.deviation.is_value(),
            turn: pose_rad.map(|pose_rad| self.turn(pose_rad)),
            limits: requirement.limit.ends(),
        };
        self.proofs.play_ends(&self.values, &question, self.is_stopped)
    }

    /// The place in the turn of an angle of the drive.
    fn turn(&self, pose_rad: f64) -> f64 {
        let input = self.study.model.input(self.study.cycle.span, &self.values);
        (input.speed_rad_s.signum() * (pose_rad - input.start_rad) / TAU).rem_euclid(1.0)
    }

    /// The angle of the drive at a place in the turn.
    fn angle_rad(&self, turn: f64) -> f64 {
        let input = self.study.model.input(self.study.cycle.span, &self.values);
        input.start_rad + input.speed_rad_s.signum() * TAU * turn
    }
}
