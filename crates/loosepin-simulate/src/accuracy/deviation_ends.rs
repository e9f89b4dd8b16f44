//! How far outputs can deviate at all while parts stay within limits and joints within their play: proven ends, and places that come near.

use super::cycle::Cycle;
use super::cycle_worst_case::driven_steps;
use super::dead_centre::{DeadCentre, dead_centre};
use super::dimension::{DimensionDirection, dimension_direction};
use super::error::AccuracyError;
use super::in_space::{InSpace, is_asked_in_space};
use super::loops::DisplacedLoops;
use super::overhang::overhanging;
use super::play_reach::PlayReach;
use super::sensitivity::dimension_derivatives;
use super::together::found_over;
use super::unproven::{Cause, UnprovenPositions};
use super::worst_case::{
    CycleOfPositions, Encloser, Ends, Moving, NotProven, Objective, Positions, Variables, WeightedOutput, best_across,
    best_of, ends_around, found_in_both_assemblies, starts_on_borders,
};
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
    /// Why nothing is proven at each position; `None` where ends are.
    pub unproven: Vec<Option<String>>,
    /// The lowest and the highest deviation that were looked for where the proven ends are furthest and where there are none, with their
    /// angles; not a number where none could be computed.
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
    /// Why nothing is proven anywhere, in words.
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
    let start = Cycle::start(mechanism, &sample, &input)?;
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
    let change_points = cycle.change_points(&input);
    let mut unproven = dimensions.iter().find_map(|(limit, direction)| asked.why_no_line(*limit, direction));
    let proven = asked.proven(questions, &mut unproven)?;
    let mut of_questions = Vec::with_capacity(questions.len());
    for (question, Proven { ends_si, causes }) in questions.iter().zip(proven) {
        let found = match is_asked_in_space(mechanism) && question.of.has_play() {
            true => asked.found_in_space(question)?,
            false => asked.found(question, &ends_si, &causes)?,
        };
        let found =
            found.map(|(row, deviation_si)| FoundDeviation { drive_angle_rad: drive_angle_rad[row], deviation_si });
        let moved_by = match (question.of.has_play(), dimensions.is_empty()) {
            (true, true) => "the play of the joints",
            (true, false) => "the play of the joints, the limits of the parts",
            (false, _) => "the limits of the parts",
        };
        let positions = UnprovenPositions {
            mechanism,
            drive_angle_rad: &drive_angle_rad,
            moved_by,
            causes,
            change_points: &change_points,
        };
        of_questions.push(DeviationEnds {
            drive_angle_rad: drive_angle_rad.clone(),
            unproven: positions.reasons(),
            proven_si: ends_si,
            found,
        });
    }
    Ok(AllDeviationEnds { of_questions, unproven, is_whole_turn: cycle.states.len() > positions })
}

/// What is proven of one question at each position.
#[derive(Clone)]
struct Proven {
    ends_si: Vec<[f64; 2]>,
    /// Why there are no ends.
    causes: Vec<Option<Cause>>,
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

    /// Proven ends of each question at each position; why there are none at all goes to `unproven`.
    ///
    /// # Errors
    /// It was stopped.
    fn proven(
        &self,
        questions: &[DeviationQuestion],
        unproven: &mut Option<String>,
    ) -> Result<Vec<Proven>, AccuracyError> {
        const NOTHING: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        let rows = self.states.len();
        let mut ends = vec![Proven { ends_si: vec![NOTHING; rows], causes: vec![None; rows] }; questions.len()];
        if unproven.is_some() {
            return Ok(ends);
        }
        if self.mechanism.ideal.is_redundant() {
            ends.iter_mut().for_each(|own| own.causes.fill(Some(Cause::Redundant)));
            return Ok(ends);
        }
        let steps = driven_steps(self.mechanism, self.sample, self.states);
        let Some(steps) = steps else {
            *unproven = Some("a drive does not run at constant speed".to_owned());
            return Ok(ends);
        };
        // Without play for what lengths do alone.
        for has_play in [true, false] {
            let of = |question: &DeviationQuestion| question.of.has_play() == has_play;
            let places: Vec<usize> = (0..questions.len()).filter(|place| of(&questions[*place])).collect();
            if places.is_empty() {
                continue;
            }
            if has_play && is_asked_in_space(self.mechanism) {
                places.iter().for_each(|place| ends[*place].causes.fill(Some(Cause::Lean)));
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
                    driven_steps: Some(Vec::new()),
                },
                readings.clone(),
            );
            for (row, state) in self.states.iter().enumerate() {
                if self.stop.load(Ordering::Relaxed) {
                    return Err(AccuracyError::Stopped);
                }
                encloser.take_steps(Some(&steps[row]));
                let of_place = |positions: &Positions, (reading, place): (usize, &usize)| {
                    let reference = questions[*place].of.reference();
                    Ends::new(balls.clone(), self.dimensions.len(), true, reference).of(positions, &[(reading, 1.0)])
                };
                let ends_of =
                    |positions: &Positions| places.iter().enumerate().map(|place| of_place(positions, place)).collect();
                let proven = ends_around(&mut encloser, state.coordinates(), ends_of);
                let over = overhanging(self.mechanism, self.sample, self.reaches, state.kinematics())
                    .next()
                    .filter(|_| has_play)
                    .map(|play| self.mechanism.model.play_name(self.mechanism.plays[play]));
                let mut dead_centre = None;
                let mut cause = |not_proven: Option<NotProven>| {
                    let not_proven = not_proven.map(|not_proven| NotProven {
                        reaches_dead_centre: has_play
                            && *dead_centre.get_or_insert_with(|| self.dead_centre(self.values, state).is_some()),
                        ..not_proven
                    });
                    Cause::of(self.mechanism, not_proven, over)
                };
                for (reading, place) in places.iter().enumerate() {
                    let own = &mut ends[*place];
                    let found = proven.as_ref().map(|all| all[reading]).map_err(|failed| NotProven::of(*failed));
                    own.causes[row] = cause(found.map_or_else(Some, |found| NotProven::of_ends(&[found])));
                    if let (Ok([low, high]), None) = (found, &own.causes[row]) {
                        let question = questions[*place];
                        let from = if question.of.is_value() { self.value(question.reading, state) } else { 0.0 };
                        own.ends_si[row] = [from + low, from + high];
                    }
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

    /// The other assembly, where play takes the mechanism to a dead centre.
    fn dead_centre(&self, values: &Values, state: &IdealMotion<'_>) -> Option<DeadCentre> {
        let mut loops = DisplacedLoops::new(self.mechanism, values);
        loops.close_near(state.coordinates()).ok()?;
        dead_centre(&mut loops, self.reaches)
    }

    /// The lowest and the highest deviation, each with its position: where the proven ends are furthest, and everywhere where there are none. Not a
    /// number where it could be computed nowhere.
    ///
    /// # Errors
    /// It was stopped.
    fn found(
        &self,
        question: &DeviationQuestion,
        ends_si: &[[f64; 2]],
        causes: &[Option<Cause>],
    ) -> Result<[(usize, f64); 2], AccuracyError> {
        let is_proven = |row: &usize| ends_si[*row].iter().all(|end| end.is_finite());
        let rows = 0..ends_si.len();
        // By play alone: the search of the whole cycle, whose number stands on the same page.
        if question.of.is_by_play_alone() && self.dimensions.is_empty() && !rows.clone().all(|row| is_proven(&row)) {
            return self.found_over_cycle(question, ends_si, causes);
        }
        let mut found = [(0, 0.0); 2];
        for (side, found) in found.iter_mut().enumerate() {
            let sign = [-1.0, 1.0][side];
            let far = |row: &usize| sign * ends_si[*row][side];
            let furthest = rows.clone().filter(is_proven).max_by(|a, b| far(a).total_cmp(&far(b)));
            let others = rows.clone().filter(|row| !is_proven(row));
            let mut best: Option<(usize, f64)> = None;
            for row in furthest.into_iter().chain(others) {
                if self.stop.load(Ordering::Relaxed) {
                    return Err(AccuracyError::Stopped);
                }
                let Some(deviation_si) = self.found_at(question, row, sign, is_open(row, ends_si, causes)) else {
                    continue;
                };
                if deviation_si.is_finite() && best.is_none_or(|(_, best)| sign * (deviation_si - best) > 0.0) {
                    best = Some((row, deviation_si));
                }
            }
            *found = best.unwrap_or((0, f64::NAN));
        }
        Ok(found)
    }

    /// As [`Self::found`], by play with the parts as they are drawn, which are within all limits: the searches of the plane count each play alone, and
    /// know no lean.
    fn found_in_space(&self, question: &DeviationQuestion) -> Result<[(usize, f64); 2], AccuracyError> {
        let is_stopped = || self.stop.load(Ordering::Relaxed);
        let space = InSpace::new(self.mechanism, self.values, self.reaches, self.mechanism.has_leaning_pins()).ok();
        // Where the value itself is lowest or highest nothing is searched.
        let space = space.filter(|_| !question.of.is_value());
        let found = space.and_then(|space| found_over(&space, self.states, question.reading, &is_stopped));
        if is_stopped() { Err(AccuracyError::Stopped) } else { Ok(found.unwrap_or([(0, f64::NAN); 2])) }
    }

    /// As [`Self::found`] by play alone.
    fn found_over_cycle(
        &self,
        question: &DeviationQuestion,
        ends_si: &[[f64; 2]],
        causes: &[Option<Cause>],
    ) -> Result<[(usize, f64); 2], AccuracyError> {
        let cycle = CycleOfPositions {
            mechanism: self.mechanism,
            values: self.values,
            reaches: self.reaches,
            readings: &[question.reading],
            coordinates: self.states.iter().map(|state| state.coordinates()).collect(),
            driven_steps: None,
        };
        let output = WeightedOutput { weights: vec![vec![(0, 1.0)]; self.states.len()], path: None };
        let is_stopped = || self.stop.load(Ordering::Relaxed);
        let open = NotProven { coordinate: None, reaches_dead_centre: false };
        let mut not_proven: Vec<Option<NotProven>> =
            (0..ends_si.len()).map(|row| is_open(row, ends_si, causes).then_some(open)).collect();
        let found = found_in_both_assemblies(&cycle, output, &mut not_proven, &is_stopped);
        let found = found.ok_or(AccuracyError::Stopped)?;
        Ok([0, 1].map(|side| {
            let deviation = |row: usize| found[row][side].deviation_si;
            let far = |row: &usize| deviation(*row).abs();
            let row = (0..found.len()).max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0);
            (row, deviation(row))
        }))
    }

    /// A deviation at one position, the lowest or highest that a search finds with every dimension at the end that moves the output furthest;
    /// in `both_assemblies` where play reaches a dead centre.
    fn found_at(&self, question: &DeviationQuestion, row: usize, sign: f64, both_assemblies: bool) -> Option<f64> {
        let state = &self.states[row];
        let mut loops = DisplacedLoops::new(self.mechanism, self.values);
        loops.set_position(state.coordinates());
        let nominal = loops.value(question.reading);
        let mut moved = Vec::new();
        if !question.of.is_by_play_alone() {
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
        let by_play = if !question.of.has_play() {
            0.0
        } else {
            let middle = vec![Vec2::zero(); self.reaches.len()];
            let borders = starts_on_borders(self.reaches);
            let starts: Vec<&[Vec2<f64>]> = std::iter::once(&middle).chain(&borders).map(Vec::as_slice).collect();
            let objective = Objective { readings: &[question.reading], weights: &[(0, 1.0)] };
            let own = best_of(&mut loops, objective, self.reaches, &starts, sign).0.deviation_si;
            let dead_centre = both_assemblies.then(|| self.dead_centre(&values, state)).flatten();
            let across = dead_centre.and_then(|dead_centre| dead_centre.other).map_or(0.0, |other| {
                let starts: Vec<&[Vec2<f64>]> =
                    std::iter::once(&other.displacements).chain(&borders).map(Vec::as_slice).collect();
                best_across(&mut loops, &other, objective, self.reaches, &starts, sign).deviation_si
            });
            if sign * (across - own) > 0.0 { across } else { own }
        };
        let from = if question.of.is_value() { nominal } else { 0.0 };
        Some(from + by_parts + by_play)
    }
}

/// Whether an end at a position is not proven, and a measure of the loops shows how near they are to a dead centre: not where joints repeat
/// each other. Whatever keeps the end from being proven, play may reach a dead centre there.
fn is_open(row: usize, ends_si: &[[f64; 2]], causes: &[Option<Cause>]) -> bool {
    causes[row] != Some(Cause::Redundant) && !ends_si[row].iter().all(|end| end.is_finite())
}
