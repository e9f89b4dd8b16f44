//! Requirements judged without runs by play at its worst, where proofs are of play alone.
//!
//! Parts that scatter are not in these proofs: nothing is proven with them, and what play alone breaks is broken.

use super::judged::{Judgement, KnownEnds, NOTHING_PROVEN, judged, limits_unless_set};
use super::widest_play::with_most_play;
use crate::file::Study;
use crate::model::PlayProofs;
use crate::model::outputs::OutputSource;
use loosepin_space::{IsStopped, PlayEnds, PlayQuestion};
use loosepin_text::diagnostics::Diagnostics;

/// Judges what a study requires; inputs that `set` names have that value, and others that decide a play the one with the most of it.
///
/// # Errors
/// A setting that the model does not take; loops that do not close; that it was stopped.
pub(super) fn judge_by_play(
    study: &Study,
    proofs: &dyn PlayProofs,
    set: &[String],
    is_stopped: IsStopped<'_>,
) -> Result<Judgement, Diagnostics> {
    let values = study.model.clone().take_settings(set)?.values;
    let limits = limits_unless_set(study, set);
    let (values, no_such_values) = with_most_play(&study.model, &values, &limits);
    let drive = study.model.input(study.cycle.span, &values);
    let (mut share, mut scattering) = (1.0, None);
    for input in &limits {
        let moves = proofs.moves(input.quantity);
        if moves || study.model.has_play_from(input.quantity) {
            share -= 1.0 - input.share;
        }
        if moves {
            let why = || format!("{} is uncertain, and in space only play is bounded without runs", input.path);
            scattering.get_or_insert_with(why);
        }
    }
    let unproven = scattering.or(no_such_values);
    let mut answered: Vec<(PlayQuestion, PlayEnds)> = Vec::new();
    let mut judgement = Judgement::default();
    for requirement in &study.requirements {
        // A model with these proofs has no other outputs.
        let OutputSource::InSpace(part) = study.outputs[requirement.output].seen else { continue };
        for pose_rad in requirement.location.poses_rad() {
            let question = PlayQuestion {
                part,
                is_value: requirement.deviation.is_value(),
                has_play: requirement.deviation.has_play(),
                turn: pose_rad.map(|pose_rad| drive.turn_at(pose_rad)),
                limits: requirement.limit.ends(),
            };
            let ends = match answered.iter().find(|(known, _)| *known == question) {
                Some((_, ends)) => ends.clone(),
                None => {
                    let ends = proofs.play_ends(&values, &question, is_stopped)?;
                    answered.push((question, ends.clone()));
                    ends
                }
            };
            let reason = ends.unproven.or_else(|| unproven.clone());
            let ends = KnownEnds {
                found_si: ends.found,
                found_at_rad: ends.found_at.map(|turn| drive.angle_at_turn_rad(turn)),
                proven_si: if reason.is_none() { ends.proven } else { NOTHING_PROVEN },
                reason,
                needs_dynamics: false,
            };
            judgement.requirements.push(judged(study, requirement, pose_rad, share, ends));
        }
    }
    Ok(judgement)
}
