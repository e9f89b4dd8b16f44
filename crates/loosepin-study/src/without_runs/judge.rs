//! Requirements, and what may be loosened, judged without dynamics: by play at its worst and all parts within their limits.
//!
//! A random input lies between the ends of its distribution, or where it has none within 3 standard deviations of its mean; an unknown input
//! in its interval. What the proven ends of a deviation keep is kept by every mechanism within these limits, and at least
//! 1 - Σ (1 - p_i) of all mechanisms are within them, p_i being the probability of one input, however the inputs go together.

use crate::file::{Allowance, AllowedInput, Requirement, Study};
use crate::model::outputs::OutputSource;
use crate::model::{DeviationProofs, ProvenDeviations, StudyModel};
use crate::response::input_limits::{DEVIATIONS, InputLimits};
use loosepin_mechanics::model::{Position, QuantityId, Values};
use loosepin_result::motion::{MotionAllowance, MotionRequirement, MotionVerdict};
use loosepin_result::study::{Deviation, PathError};
use loosepin_simulate::accuracy::{AccuracyError, AllDeviationEnds, DeviationEnds, DeviationQuestion, DimensionLimit};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::SiUnit;
use std::sync::atomic::AtomicBool;

/// Halvings of the range of what may be loosened, as in a study.
const HALVINGS: usize = 7;

/// Judgement of a requirement.
#[derive(Default)]
pub(crate) struct Judgement {
    pub requirements: Vec<MotionRequirement>,
    pub allowances: Vec<MotionAllowance>,
}

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
    let Some(own) = study.model.deviation_proofs().filter(|_| !study.requirements.is_empty()) else {
        return Ok(Judgement::default());
    };
    let mut model = study.model.clone();
    let values = &model.take_settings(set)?;
    let Some(proofs) = model.deviation_proofs() else { return Ok(Judgement::default()) };
    let limits = limits_unless_set(study, set);
    let judge = Judge { study, model: &model, proofs, values, positions, stop };
    let requirements = judge.requirements(&limits).map_err(|error| own.diagnostic(&error))?;
    let allowances = judge.allowances(&limits).map_err(|error| own.diagnostic(&error))?;
    Ok(Judgement { requirements, allowances })
}

/// The limits of all inputs but those that `set` gives a value.
pub(super) fn limits_unless_set(study: &Study, set: &[String]) -> Vec<InputLimits> {
    let is_set = |path: &str| set.iter().any(|text| text.split_once('=').is_some_and(|(own, _)| own.trim() == path));
    study.input_limits().into_iter().filter(|input| !is_set(&input.path)).collect()
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
        let (values, mut reason) = self.with_most_play(limits);
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
        let all = self.study.requirements.iter().zip(&asked);
        let each = all.flat_map(|(requirement, asked)| {
            let poses: Vec<Option<f64>> = match requirement.location.angles_rad() {
                Some(angles_rad) => angles_rad.iter().map(|angle| Some(*angle)).collect(),
                None => vec![None],
            };
            let reason = &reason;
            let ends = &ends;
            poses
                .into_iter()
                .map(move |pose_rad| self.outcome(requirement, asked, ends, pose_rad, share, reason.clone()))
        });
        Ok(each.collect())
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

    fn outcome(
        &self,
        requirement: &Requirement,
        asked: &Asked,
        ends: &AllDeviationEnds,
        pose_rad: Option<f64>,
        share: f64,
        mut reason: Option<String>,
    ) -> MotionRequirement {
        let output = &self.study.outputs[requirement.output];
        let [lower_si, upper_si] = requirement.limit.ends();
        let (mut proven_si, mut found_si, mut found_at_rad) =
            ([f64::NEG_INFINITY, f64::INFINITY], [f64::NAN; 2], [f64::NAN; 2]);
        match asked {
            Asked::One(place) => {
                let own = &ends.of_questions[*place];
                proven_si = over(&own.drive_angle_rad, &own.proven_si, pose_rad);
                reason = reason.or_else(|| why_unproven(own, pose_rad));
                found_si = own.found.map(|found| found.deviation_si);
                found_at_rad = own.found.map(|found| found.drive_angle_rad);
                for side in 0..2 {
                    if pose_rad.is_some_and(|pose_rad| !is_same(pose_rad, found_at_rad[side], 1e-9)) {
                        (found_si[side], found_at_rad[side]) = (f64::NAN, f64::NAN);
                    }
                }
            }
            Asked::Path(places) => {
                let [x, y] = places.map(|place| &ends.of_questions[place]);
                let largest = |ends: &[f64; 2]| f64::max(-ends[0], ends[1]);
                let far = x.proven_si.iter().zip(&y.proven_si).map(|(x, y)| largest(x).hypot(largest(y)));
                let rows: Vec<[f64; 2]> = far.map(|far| [-far, far]).collect();
                proven_si = over(&x.drive_angle_rad, &rows, pose_rad);
                reason = reason.or_else(|| [x, y].into_iter().find_map(|own| why_unproven(own, pose_rad)));
            }
            Asked::No(words) => reason = Some((*words).to_owned()),
        }
        let is_proven = lower_si <= proven_si[0] && proven_si[1] <= upper_si;
        let is_broken = found_si[0] < lower_si || found_si[1] > upper_si;
        let verdict = match asked {
            Asked::No(_) => MotionVerdict::NeedsDynamics,
            _ if is_broken => MotionVerdict::NotMetInTheWorstCase,
            _ if is_proven && reason.is_none() && share >= requirement.probability_at_least => MotionVerdict::Met,
            _ => MotionVerdict::Undecided,
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

    /// The numbers of the model with every clearance as large as `limits` allow, and why they cannot be had.
    fn with_most_play(&self, limits: &[InputLimits]) -> (Values, Option<String>) {
        let table = self.model.quantities();
        let mut set: Vec<(QuantityId, f64)> =
            table.iter().filter(|(_, quantity)| quantity.is_settable()).map(|(id, _)| (id, self.values[id])).collect();
        let with = |set: &[(QuantityId, f64)], id: QuantityId, value: f64| {
            let mut set = set.to_vec();
            set.push((id, value));
            table.evaluate(&set).ok()
        };
        let mut reason = None;
        for input in limits {
            let sum = |value: f64| {
                let values = with(&set, input.quantity, value)?;
                Some(self.model.play_from(input.quantity).iter().map(|play| values[play.quantity]).sum::<f64>())
            };
            if !self.study.model.has_play_from(input.quantity) {
                continue;
            }
            match (sum(input.low_si.max(0.0)), sum(input.high_si)) {
                (Some(low), Some(high)) => {
                    set.push((input.quantity, if high >= low { input.high_si } else { input.low_si.max(0.0) }));
                }
                _ => reason = Some(format!("{} cannot be set to its limits", input.path)),
            }
        }
        let values = table.evaluate(&set).unwrap_or_else(|_| {
            reason = Some("the largest clearances cannot be set together".to_owned());
            self.values.clone()
        });
        (values, reason)
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

/// The ends over the cycle, or over what the positions around a pose stand for.
pub(super) fn over(drive_angle_rad: &[f64], ends: &[[f64; 2]], pose_rad: Option<f64>) -> [f64; 2] {
    let nothing = [f64::NEG_INFINITY, f64::INFINITY];
    let rows = rows_of(drive_angle_rad, pose_rad).map(|row| ends[row]);
    rows.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or(nothing)
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
