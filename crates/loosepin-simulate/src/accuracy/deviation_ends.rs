//! How far outputs can deviate at all while parts stay within limits and joints within their play: proven ends, and places that come near.

use super::cycle::Cycle;
use super::cycle_worst_case::{driven_steps, why_unproven};
use super::dimension::{DimensionDirection, dimension_direction};
use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use super::overhang::overhanging;
use super::play_reach::PlayReach;
use super::sensitivity::dimension_derivatives;
use super::worst_case::{Encloser, Ends, Moving, Objective, Reference, Variables, best_of, starts_on_borders};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{CycleSpan, Position, QuantityId, Values};
use loosepin_result::study::Deviation;
use std::sync::atomic::{AtomicBool, Ordering};

/// A quantity that may be away from its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DimensionLimit {
    /// The quantity; one that can be set.
    pub quantity: QuantityId,
    /// Largest deviation, either way, SI.
    pub most_si: f64,
}

/// Which deviation of which position is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeviationQuestion {
    /// The position.
    pub reading: Position,
    /// Kind of deviation; for the value itself the position, not its distance from another.
    pub of: Deviation,
}

/// How far one position can deviate over the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct DeviationEnds {
    /// Angle of the drive at each position.
    pub drive_angle_rad: Vec<f64>,
    /// Ends that nothing passes from half a step before the angle to half a step behind it; infinite where nothing is proven.
    pub proven_si: Vec<[f64; 2]>,
    /// The lowest and the highest deviation that were looked for where the proven ends are furthest, with their angles.
    pub found: [FoundDeviation; 2],
}

/// A deviation that parts within their limits and joints within their play do make.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundDeviation {
    /// Angle of the drive.
    pub drive_angle_rad: f64,
    /// The deviation, or the value.
    pub deviation_si: f64,
}

/// How far positions can deviate, and why nothing is proven where that is so.
#[derive(Debug, Clone, PartialEq)]
pub struct AllDeviationEnds {
    /// For each question.
    pub of_questions: Vec<DeviationEnds>,
    /// The first reason, in words.
    pub unproven: Option<String>,
    /// Whether the mechanism goes through the whole turn.
    pub is_whole_turn: bool,
}

/// Answers `questions` over one turn of `span` in `positions` steps, with the clearances that `values` has.
///
/// # Errors
/// As for [`super::motion`].
pub fn deviation_ends(
    mechanism: &Mechanism,
    values: &Values,
    (span, positions): (CycleSpan, usize),
    limits: &[DimensionLimit],
    questions: &[DeviationQuestion],
) -> Result<AllDeviationEnds, AccuracyError> {
    deviation_ends_until(mechanism, values, (span, positions), (limits, questions), &AtomicBool::new(false))
}

/// As [`deviation_ends`], until `stop` is set: it is looked at before each position.
///
/// # Errors
/// As for [`super::motion`]; [`AccuracyError::Stopped`].
pub fn deviation_ends_until(
    mechanism: &Mechanism,
    values: &Values,
    (span, positions): (CycleSpan, usize),
    (limits, questions): (&[DimensionLimit], &[DeviationQuestion]),
    stop: &AtomicBool,
) -> Result<AllDeviationEnds, AccuracyError> {
    if !mechanism.is_driven() {
        return Err(AccuracyError::NotDriven);
    }
    let input = mechanism.model.input(span, values);
    if input.speed_rad_s == 0.0 {
        return Err(AccuracyError::StandsStill { drive: input.name });
    }
    let sample = Sample::new(mechanism, values)?;
    let reaches = PlayReach::of_sample(mechanism, &sample, sample.plays.iter().map(|_| 0.0))?;
    let mut dimensions = Vec::new();
    for limit in limits.iter().filter(|limit| limit.most_si > 0.0) {
        let direction = dimension_direction(mechanism, values, limit.quantity)?;
        if !direction.leaves_motion_alone(mechanism) {
            dimensions.push((*limit, direction));
        }
    }
    let start = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    let cycle = Cycle::walk(mechanism, start, &input, positions, stop);
    if stop.load(Ordering::Relaxed) {
        return Err(AccuracyError::Stopped);
    }
    let asked = Asked {
        mechanism,
        values,
        span,
        sample: &sample,
        reaches: &reaches,
        dimensions: &dimensions,
        states: &cycle.states,
        stop,
    };
    let drive_angle_rad: Vec<f64> = cycle.states.iter().map(|state| input.angle_rad(state.time_s())).collect();
    let mut unproven = dimensions.iter().find_map(|(limit, direction)| asked.why_no_line(*limit, direction));
    let proven = asked.proven(questions, &mut unproven)?;
    let ends = questions.iter().zip(proven).map(|(question, proven_si)| {
        let found = [0, 1].map(|side| {
            let far = |row: &usize| [-1.0, 1.0][side] * proven_si[*row][side];
            let row = (0..proven_si.len()).max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0);
            let deviation_si = asked.found(question, row, [-1.0, 1.0][side]).unwrap_or(0.0);
            FoundDeviation { drive_angle_rad: drive_angle_rad[row], deviation_si }
        });
        DeviationEnds { drive_angle_rad: drive_angle_rad.clone(), proven_si, found }
    });
    let of_questions = ends.collect();
    Ok(AllDeviationEnds { of_questions, unproven, is_whole_turn: cycle.states.len() > positions })
}

struct Asked<'c, 'a> {
    mechanism: &'c Mechanism,
    values: &'c Values,
    span: CycleSpan,
    sample: &'c Sample<f64>,
    reaches: &'c [PlayReach],
    dimensions: &'c [(DimensionLimit, DimensionDirection)],
    states: &'c [IdealMotion<'a>],
    stop: &'c AtomicBool,
}

impl Asked<'_, '_> {
    /// Why the numbers of the model do not follow a dimension in a straight line, or why drives follow it.
    fn why_no_line(&self, limit: DimensionLimit, direction: &DimensionDirection) -> Option<String> {
        /// Round-off of an expression, and of its difference quotient, relative to the number.
        const ROUND_OFF: f64 = 1e-10;
        let model = &self.mechanism.model;
        let path = &model.quantities[limit.quantity].path;
        let drives = model.drives.iter().flat_map(|drive| drive.law.quantities());
        if drives.into_iter().any(|id| direction.derivatives[id] != 0.0) {
            return Some(format!("a drive depends on {path}"));
        }
        let bends = [-1.0, 1.0].into_iter().any(|sign| {
            let Some(moved) = self.with_dimensions(&[(limit.quantity, sign * limit.most_si)]) else { return true };
            DimensionDirection::shaping(self.mechanism).into_iter().any(|id| {
                let (value, slope) = (self.values[id], direction.derivatives[id]);
                let line = value + sign * limit.most_si * slope;
                (moved[id] - line).abs() > ROUND_OFF * (value.abs() + (slope * limit.most_si).abs())
            })
        });
        bends.then(|| format!("an expression of the model is not linear in {path}"))
    }

    /// The numbers of the model with quantities moved; `None` if a rule forbids them.
    fn with_dimensions(&self, moved: &[(QuantityId, f64)]) -> Option<Values> {
        let table = &self.mechanism.model.quantities;
        let mut set: Vec<(QuantityId, f64)> =
            table.iter().filter(|(_, quantity)| quantity.is_settable()).map(|(id, _)| (id, self.values[id])).collect();
        set.extend(moved.iter().map(|(id, by)| (*id, self.values[*id] + by)));
        table.evaluate(&set).ok()
    }

    /// Proven ends of each question at each position; the first reason where there is none goes to `unproven`.
    ///
    /// # Errors
    /// It was stopped.
    fn proven(
        &self,
        questions: &[DeviationQuestion],
        unproven: &mut Option<String>,
    ) -> Result<Vec<Vec<[f64; 2]>>, AccuracyError> {
        const NOTHING: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        let mut ends = vec![vec![NOTHING; self.states.len()]; questions.len()];
        if unproven.is_some() {
            return Ok(ends);
        }
        let steps = driven_steps(self.mechanism, self.sample, self.states);
        let Some(steps) = steps else {
            *unproven = Some("a drive does not run at constant speed".to_owned());
            return Ok(ends);
        };
        // Without play for what lengths do alone.
        for has_play in [true, false] {
            let of = |question: &DeviationQuestion| (question.of != Deviation::Dimensional) == has_play;
            let places: Vec<usize> = (0..questions.len()).filter(|place| of(&questions[*place])).collect();
            if places.is_empty() {
                continue;
            }
            let variables = Variables::new(if has_play { self.reaches } else { &[] });
            let readings: Vec<Position> = places.iter().map(|place| questions[*place].reading).collect();
            let balls = variables.balls.clone();
            let mut encloser = Encloser::new(
                Moving {
                    mechanism: self.mechanism,
                    values: self.values,
                    variables,
                    dimensions: self
                        .dimensions
                        .iter()
                        .map(|(limit, direction)| {
                            direction.derivatives.0.iter().map(|slope| slope * limit.most_si).collect()
                        })
                        .collect(),
                    driven_steps: Some(steps.clone()),
                },
                readings.clone(),
            );
            for (row, state) in self.states.iter().enumerate() {
                if self.stop.load(Ordering::Relaxed) {
                    return Err(AccuracyError::Stopped);
                }
                let enclosed = encloser.enclose(state.coordinates());
                let over = overhanging(self.mechanism, self.sample, self.reaches, state.kinematics())
                    .next()
                    .filter(|_| has_play)
                    .map(|play| self.mechanism.model.play_name(self.mechanism.plays[play]));
                let coordinate = enclosed.as_ref().err().map(|failed| failed.coordinate);
                if let Some(reason) = why_unproven(self.mechanism, coordinate, over) {
                    unproven.get_or_insert(reason);
                    continue;
                }
                let Ok(enclosed) = enclosed else { continue };
                for (reading, place) in places.iter().enumerate() {
                    let question = questions[*place];
                    let reference = match question.of {
                        Deviation::Value => Reference::ThisPosition,
                        Deviation::Total | Deviation::Dimensional => Reference::NominalParts,
                        Deviation::Clearance => Reference::SameParts,
                    };
                    let own = Ends::new(balls.clone(), self.dimensions.len(), true, reference);
                    let [low, high] = own.of(&enclosed, &[(reading, 1.0)]);
                    let from = if question.of == Deviation::Value { self.value(question.reading, state) } else { 0.0 };
                    ends[*place][row] = [from + low, from + high];
                }
            }
        }
        Ok(ends)
    }

    fn value(&self, reading: Position, state: &IdealMotion<'_>) -> f64 {
        let mut loops = DisplacedLoops::new(self.mechanism, self.values);
        loops.set_position(state.coordinates());
        loops.value(reading)
    }

    /// A deviation at one position, the lowest or highest that a search finds with every dimension at the end that moves the output furthest.
    fn found(&self, question: &DeviationQuestion, row: usize, sign: f64) -> Option<f64> {
        let state = &self.states[row];
        let mut loops = DisplacedLoops::new(self.mechanism, self.values);
        loops.set_position(state.coordinates());
        let nominal = loops.value(question.reading);
        let mut moved = Vec::new();
        if question.of != Deviation::Clearance {
            for (limit, direction) in self.dimensions {
                let slope = dimension_derivatives(
                    &mut loops,
                    self.mechanism,
                    self.values,
                    direction,
                    self.span,
                    state.time_s(),
                    &[question.reading],
                );
                let slope = slope.ok()?.swap_remove(0);
                moved.push((limit.quantity, (sign * slope).signum() * limit.most_si));
            }
        }
        let values = self.with_dimensions(&moved)?;
        let mut loops = DisplacedLoops::new(self.mechanism, &values);
        loops.close_near(state.coordinates()).ok()?;
        let by_parts = loops.value(question.reading) - nominal;
        let by_play = if question.of == Deviation::Dimensional {
            0.0
        } else {
            let middle = vec![Vec2::zero(); self.reaches.len()];
            let borders = starts_on_borders(self.reaches);
            let starts: Vec<&[Vec2<f64>]> = std::iter::once(&middle).chain(&borders).map(Vec::as_slice).collect();
            let objective = Objective { readings: &[question.reading], weights: &[(0, 1.0)] };
            best_of(&mut loops, objective, self.reaches, &starts, sign).0.deviation_si
        };
        let from = if question.of == Deviation::Value { nominal } else { 0.0 };
        Some(from + by_parts + by_play)
    }
}
