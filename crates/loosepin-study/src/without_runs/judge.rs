//! Requirements, and what may be loosened, judged without dynamics: by play at its worst and all parts within their limits.
//!
//! A random input lies between the ends of its distribution, or where it has none within 3 standard deviations of its mean; an unknown input
//! in its interval. What the proven ends of a deviation keep is kept by every mechanism within these limits, and at least
//! 1 - Σ (1 - p_i) of all mechanisms are within them, p_i being the probability of one input, however the inputs go together.

use super::judged::{Judgement, KnownEnds, NOTHING_PROVEN, judged, limits_unless_set};
use super::widest_play::with_most_play;
use crate::file::{Allowance, AllowedInput, Study};
use crate::model::outputs::OutputSource;
use crate::model::{DeviationProofs, ProvenDeviations, StudyModel};
use crate::response::input_limits::{DEVIATIONS, InputLimits};
use loosepin_mechanics::model::{Position, Values};
use loosepin_result::motion::{MotionAllowance, MotionRequirement, MotionVerdict};
use loosepin_result::study::{Deviation, PathError};
use loosepin_simulate::accuracy::{AccuracyError, AllDeviationEnds, DeviationEnds, DeviationQuestion, DimensionLimit};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::SiUnit;
use std::sync::atomic::AtomicBool;

/// Halvings of the range of what may be loosened, as in a study.
const HALVINGS: usize = 7;

/// Judges what `study` requires over its turn in `positions` steps, until `stop` is set; inputs that `set` names have that value. Where the
/// model has no proofs, nothing is judged.
///
/// # Errors
/// As for [`super::InputFile::ideal_motion`]; that it was stopped.
pub(crate) fn judge(
    study: &Study,
    positions: usize,
    set: &[String],
    stop: &AtomicBool,
) -> Result<Judgement, Diagnostics> {
    if study.requirements.is_empty() {
        return Ok(Judgement::default());
    }
    let mut model = study.model.clone();
    let values = &model.take_settings(set)?.values;
    let Some(proofs) = model.deviation_proofs() else { return Ok(Judgement::default()) };
    let limits = limits_unless_set(study, set);
    let judge = Judge { study, model: &model, proofs, values, positions, stop };
    let requirements = judge.requirements(&limits).map_err(|error| proofs.diagnostic(&error))?;
    let allowances = judge.allowances(&limits).map_err(|error| proofs.diagnostic(&error))?;
    Ok(Judgement { requirements, allowances })
}

/// Index of the positions of a requirement among the questions.
enum Asked {
    One(usize),
    /// x and y of a point: what lies between them bounds every error of its path.
    Path([usize; 2]),
    /// The output is no position.
    No(&'static str),
}

const NO_POSITION: Asked = Asked::No("it is no position");

/// How far positions go while inputs lie within limits.
struct WithinLimits {
    ends: AllDeviationEnds,
    /// At least this share of all mechanisms has all inputs within the limits.
    share: f64,
    /// Why nothing is proven, where that is so.
    reason: Option<String>,
}

/// Proven ends of deviations of positions over the turn of `study` in `positions` steps, its inputs within their limits, counted from the
/// mechanism of `values`; each at every angle of the drive. `None` where nothing is proven.
pub(super) fn proven_over_turn(
    study: &Study,
    values: &Values,
    positions: usize,
    questions: &[DeviationQuestion],
) -> Option<Vec<DeviationEnds>> {
    let stop = &AtomicBool::new(false);
    let model = &study.model;
    let judge = Judge { study, model, proofs: model.deviation_proofs()?, values, positions, stop };
    let WithinLimits { ends, reason, .. } = judge.within_limits(&study.input_limits(), questions).ok()?;
    reason.is_none().then_some(ends.of_questions)
}

struct Judge<'s> {
    study: &'s Study,
    model: &'s StudyModel,
    proofs: &'s dyn DeviationProofs,
    values: &'s Values,
    positions: usize,
    stop: &'s AtomicBool,
}

impl Judge<'_> {
    /// How far positions go with inputs within `limits`.
    fn within_limits(
        &self,
        limits: &[InputLimits],
        questions: &[DeviationQuestion],
    ) -> Result<WithinLimits, AccuracyError> {
        let (values, mut reason) = with_most_play(self.model, self.values, limits);
        let dimensions = limits.iter().map(|input| {
            let most_si =
                f64::max((input.low_si - values[input.quantity]).abs(), (input.high_si - values[input.quantity]).abs());
            DimensionLimit { quantity: input.quantity, most_si }
        });
        let dimensions: Vec<DimensionLimit> = dimensions.collect();
        let turn = (self.study.cycle.span, self.positions);
        let ProvenDeviations { moves, ends } = self.proofs.prove(&values, turn, &dimensions, questions, self.stop)?;
        let mut miss = 0.0;
        for (input, moves) in limits.iter().zip(moves) {
            let decides_play = self.study.model.has_play_from(input.quantity);
            if moves && decides_play {
                reason.get_or_insert_with(|| format!("{} decides a play and a length", input.path));
            }
            if moves || decides_play {
                miss += 1.0 - input.share;
            }
        }
        let reason = reason
            .or_else(|| ends.unproven.clone())
            .or_else(|| (!ends.is_whole_turn).then(|| "the mechanism does not go through its whole turn".to_owned()));
        Ok(WithinLimits { ends, share: 1.0 - miss, reason })
    }

    /// The verdict on each requirement with inputs within `limits`.
    fn requirements(&self, limits: &[InputLimits]) -> Result<Vec<MotionRequirement>, AccuracyError> {
        let (questions, asked) = self.questions();
        let WithinLimits { ends, share, reason } = self.within_limits(limits, &questions)?;
        let mut outcomes = Vec::new();
        for (requirement, asked) in self.study.requirements.iter().zip(&asked) {
            for pose_rad in requirement.location.poses_rad() {
                let known = known_ends(asked, &ends, pose_rad, &reason);
                outcomes.push(judged(self.study, requirement, pose_rad, share, known));
            }
        }
        Ok(outcomes)
    }

    fn questions(&self) -> (Vec<DeviationQuestion>, Vec<Asked>) {
        let mut questions: Vec<DeviationQuestion> = Vec::new();
        let mut place = |reading: Position, of: Deviation| {
            let question = DeviationQuestion { reading, of };
            questions.iter().position(|known| *known == question).unwrap_or_else(|| {
                questions.push(question);
                questions.len() - 1
            })
        };
        let asked = self.study.requirements.iter().map(|requirement| {
            let of = requirement.deviation;
            match self.study.outputs[requirement.output].seen {
                OutputSource::Reading(reading) => match reading.position() {
                    Some(position) => Asked::One(place(position, of)),
                    None => NO_POSITION,
                },
                OutputSource::Path(coordinates, error) if !of.is_value() || error != PathError::Along => {
                    let of = if of.is_value() { Deviation::of_all_causes() } else { of };
                    match coordinates.map(|reading| reading.position()) {
                        [Some(x), Some(y)] => Asked::Path([place(x, of), place(y, of)]),
                        _ => NO_POSITION,
                    }
                }
                OutputSource::Wear(..) => Asked::No("wear needs runs"),
                OutputSource::Path(..) | OutputSource::InSpace(_) => NO_POSITION,
            }
        });
        let asked = asked.collect();
        (questions, asked)
    }

    /// What may be loosened, each input by itself.
    fn allowances(&self, limits: &[InputLimits]) -> Result<Vec<MotionAllowance>, AccuracyError> {
        self.study.allowances.iter().map(|allowance| self.allowance(allowance, limits)).collect()
    }

    fn allowance(&self, allowance: &Allowance, limits: &[InputLimits]) -> Result<MotionAllowance, AccuracyError> {
        let (path, quantity) = match allowance.input {
            AllowedInput::FitInterval(input) | AllowedInput::UpperEnd(input) => {
                (&self.study.epistemic[input].path, self.study.epistemic[input].quantity())
            }
            AllowedInput::FitScatter(input) | AllowedInput::StandardDeviation(input) => {
                (&self.study.random[input].path, self.study.random[input].quantity())
            }
        };
        let unit = quantity.map_or(SiUnit::NONE, |id| SiUnit::of_dimension(self.model.quantities()[id].dimension));
        let mut answer = MotionAllowance {
            path: path.clone(),
            unit,
            up_to_si: allowance.up_to_si,
            loosest_si: None,
            fit: None,
            reason: None,
        };
        let Some(place) = limits.iter().position(|input| &input.path == path) else {
            answer.reason = Some("it is set".to_owned());
            return Ok(answer);
        };
        if !allowance.costs.is_empty() || self.study.together.is_some() {
            answer.reason = Some("costs, and inputs that are loosened together, need loosepin study".to_owned());
            return Ok(answer);
        }
        let is_met = |low_si: Option<f64>, high_si: f64| -> Result<bool, AccuracyError> {
            let mut limits = limits.to_vec();
            let own = &mut limits[place];
            match allowance.input {
                AllowedInput::StandardDeviation(input) => {
                    let mean = self.study.random[input].variable.mean();
                    (own.low_si, own.high_si) = (mean - DEVIATIONS * high_si, mean + DEVIATIONS * high_si);
                }
                _ => (own.low_si, own.high_si) = (low_si.unwrap_or(own.low_si).min(high_si), high_si),
            }
            let outcomes = self.requirements(&limits)?;
            let mut judged =
                outcomes.iter().filter(|outcome| outcome.verdict != MotionVerdict::NeedsDynamics).peekable();
            Ok(judged.peek().is_some() && judged.all(|outcome| outcome.verdict == MotionVerdict::Met))
        };
        if !allowance.fits.is_empty() {
            for fit in allowance.fits.iter().rev() {
                if is_met(Some(fit.clearance_m[0]), fit.clearance_m[1])? {
                    answer.fit = Some(fit.name.clone());
                    answer.loosest_si = Some(fit.clearance_m[1]);
                    break;
                }
            }
            return Ok(answer);
        }
        if is_met(None, allowance.up_to_si)? {
            answer.loosest_si = Some(allowance.up_to_si);
            return Ok(answer);
        }
        let (mut met, mut refused) = (allowance.least_si, allowance.up_to_si);
        if !is_met(None, met)? {
            return Ok(answer);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (met + refused);
            if is_met(None, middle)? { met = middle } else { refused = middle }
        }
        answer.loosest_si = Some(met);
        Ok(answer)
    }
}

/// How far what is asked goes at a pose, or over the cycle; `reason` says why nothing is proven of the mechanism as a whole.
fn known_ends(asked: &Asked, ends: &AllDeviationEnds, pose_rad: Option<f64>, reason: &Option<String>) -> KnownEnds {
    let mut known = KnownEnds {
        found_si: [f64::NAN; 2],
        found_at_rad: [f64::NAN; 2],
        proven_si: NOTHING_PROVEN,
        reason: reason.clone(),
        needs_dynamics: false,
    };
    match asked {
        Asked::One(place) => {
            let own = &ends.of_questions[*place];
            known.proven_si = over(&own.drive_angle_rad, &own.proven_si, pose_rad);
            known.reason = known.reason.or_else(|| why_unproven(own, pose_rad));
            for (side, found) in own.found.iter().enumerate() {
                if pose_rad.is_none_or(|pose_rad| is_same(pose_rad, found.drive_angle_rad, 1e-9)) {
                    (known.found_si[side], known.found_at_rad[side]) = (found.deviation_si, found.drive_angle_rad);
                }
            }
        }
        Asked::Path(places) => {
            let [x, y] = places.map(|place| &ends.of_questions[place]);
            let largest = |ends: &[f64; 2]| f64::max(-ends[0], ends[1]);
            let far = x.proven_si.iter().zip(&y.proven_si).map(|(x, y)| largest(x).hypot(largest(y)));
            let rows: Vec<[f64; 2]> = far.map(|far| [-far, far]).collect();
            known.proven_si = over(&x.drive_angle_rad, &rows, pose_rad);
            known.reason = known.reason.or_else(|| [x, y].into_iter().find_map(|own| why_unproven(own, pose_rad)));
        }
        Asked::No(words) => (known.reason, known.needs_dynamics) = (Some((*words).to_owned()), true),
    }
    known
}

/// The ends over the cycle, or over what the positions around a pose stand for.
pub(super) fn over(drive_angle_rad: &[f64], ends: &[[f64; 2]], pose_rad: Option<f64>) -> [f64; 2] {
    let rows = rows_of(drive_angle_rad, pose_rad).map(|row| ends[row]);
    rows.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or(NOTHING_PROVEN)
}

/// The first reason why nothing is proven there.
fn why_unproven(ends: &DeviationEnds, pose_rad: Option<f64>) -> Option<String> {
    rows_of(&ends.drive_angle_rad, pose_rad).find_map(|row| ends.unproven[row].clone())
}

/// The positions of the cycle, or those around a pose that it may lie next to.
fn rows_of(drive_angle_rad: &[f64], pose_rad: Option<f64>) -> impl Iterator<Item = usize> + '_ {
    let steps = drive_angle_rad.windows(2).map(|pair| pair[1] - pair[0]);
    // Half a step on either side, and round-off.
    let half_rad = 0.5 * steps.fold(0.0, f64::max) * (1.0 + 1e-9);
    let counts = move |row: &usize| pose_rad.is_none_or(|pose_rad| is_same(pose_rad, drive_angle_rad[*row], half_rad));
    (0..drive_angle_rad.len()).filter(counts)
}

/// Whether two angles are the same within a turn up to `within_rad`.
fn is_same(a_rad: f64, b_rad: f64, within_rad: f64) -> bool {
    let apart = (a_rad - b_rad).rem_euclid(std::f64::consts::TAU);
    apart.min(std::f64::consts::TAU - apart) <= within_rad
}
