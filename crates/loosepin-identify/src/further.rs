//! The reading that would narrow the plays most: found by trying, not from a table.
//!
//! Every point of a body that moves is pushed in twelve directions, every body is turned by a moment, at a pose every 15°; read are the
//! outputs of the model, and both coordinates of the point or the angle of the body that is pushed. All are ranked by how much a reading
//! with the error of the ones that were made would shrink the plays if all were normal (aᵀ M⁻¹ a/e², M the information so far); the
//! best of each place and output are then computed in full, as if the reading came out in the middle of what is possible.

use super::consistent::{ConsistentSet, End, ReadingRow};
use super::influence::Influence;
use super::locked::{Test, locked_at, pushed};
use super::nominal::Nominal;
use super::rig::Rig;
use super::states::States;
use loosepin_math::solve_square;
use loosepin_mechanics::model::{Axis, BodyId, Motion, PointId, Position, Relative};
use loosepin_result::identification::{FurtherReading, ReadingSearch};
use loosepin_simulate::accuracy::{PositionOutput, position_outputs};
use loosepin_simulate::{Reading, relative_words};
use loosepin_study::{Measured, Push};
use loosepin_text::units::SiUnit;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

/// Poses in a turn: every 15°.
const POSES: usize = 24;
/// Directions of a push in half a turn: every 15°.
const DIRECTIONS: usize = 12;
/// Candidates that are computed in full.
const IN_FULL: usize = 12;
/// A pose at which the exact loops miss the linear model by more than this share is too near a dead point.
const MAX_MISSED: f64 = 0.05;
/// Widths of all plays together have to become smaller by this share at least for a reading to be worth naming.
const MIN_GAIN: f64 = 0.05;

/// A reading that could be made.
#[derive(Debug, Clone)]
struct Candidate {
    test: Test,
    read: Read,
    /// Factors of the play inputs.
    factors: Vec<f64>,
    gain: f64,
}

/// What is read.
#[derive(Debug, Clone)]
struct Read {
    position: Position,
    words: String,
    has_output: bool,
    unit: SiUnit,
}

/// The errors and forces of the readings so far, which a further one is taken to have.
struct Usual {
    length_error_m: f64,
    angle_error_rad: f64,
    force_n: f64,
    moment_n_m: f64,
    /// Largest coefficient that a reading states; that of the model where none does.
    friction: Option<f64>,
}

/// The examined readings, and the best; `None` if none narrows a bound. Poses in which the mechanism cannot be locked are left out.
pub(crate) fn further(
    rig: &Rig<'_>,
    set: &ConsistentSet,
    bounds: &[[End; 2]],
    readings: &[&Measured],
) -> (ReadingSearch, Option<FurtherReading>) {
    let usual = Usual::of(rig, set, readings);
    let information = information(set);
    let (candidates, tried) = candidates(rig, &usual, &information);
    let searched = ReadingSearch { candidates: tried, in_full: candidates.len() };
    let middle = middle(bounds);
    let now: Vec<f64> = bounds[..rig.plays.len()].iter().map(|[low, high]| high.value_si - low.value_si).collect();
    let mut best: Option<(f64, FurtherReading)> = None;
    let plays_si: Vec<[f64; 2]> =
        bounds[..rig.plays.len()].iter().map(|[low, high]| [low.value_si, high.value_si]).collect();
    for candidate in candidates {
        let influence = match States::new(rig, &candidate.test) {
            Ok(states) => Influence::new(rig, &candidate.test, &states, &plays_si),
            Err(error) => Err(error.into()),
        };
        let Ok(influence) = influence else { continue };
        if influence.linearisation_share > MAX_MISSED {
            continue;
        }
        let error_si = usual.error_si(&candidate.read.unit);
        // An instrument of its own: nothing is known of what it has in common with the others.
        let mut with = set.clone();
        let mut row = ReadingRow::new(rig, &influence, [0.0; 2], error_si, with.instruments);
        with.instruments += 1;
        let at = |which: usize| -> f64 {
            row.constant_si[which / 2] + row.factors.iter().zip(&middle).map(|(f, play)| f[which] * play).sum::<f64>()
        };
        row.interval_si = [0.5 * (at(0) + at(2)); 2];
        with.rows.push(row);
        let unit = |play: usize| -> Vec<f64> { (0..now.len()).map(|k| f64::from(u8::from(k == play))).collect() };
        let left: Option<Vec<f64>> = (0..now.len())
            .map(|play| with.bounds(&unit(play)).map(|[low, high]| (high.value_si - low.value_si).min(now[play])))
            .collect();
        let Some(left) = left else { continue };
        let shares = left.iter().zip(&now).map(|(left, now)| if *now > 0.0 { left / now } else { 1.0 });
        let score = shares.sum::<f64>() / now.len() as f64;
        if best.as_ref().is_none_or(|(least, _)| score < *least) {
            best = Some((score, described(rig, &candidate, error_si, left, tried)));
        }
    }
    (searched, best.filter(|(score, _)| *score <= 1.0 - MIN_GAIN).map(|(_, further)| further))
}

impl Usual {
    fn of(rig: &Rig<'_>, set: &ConsistentSet, readings: &[&Measured]) -> Self {
        let size_m = rig.mechanism.size_m;
        let least = |unit: SiUnit| {
            let of_unit = readings.iter().zip(&set.rows).filter(|(reading, _)| reading.unit == unit);
            let errors = of_unit.map(|(_, row)| row.common_si + 0.5 * (row.interval_si[1] - row.interval_si[0]));
            errors.reduce(f64::min)
        };
        let (length, angle) = (least(SiUnit::LENGTH), least(SiUnit::ANGLE));
        let forces = readings.iter().filter_map(|reading| match reading.push {
            Push::Force { force_n, .. } => Some(force_n),
            Push::Moment { .. } => None,
        });
        let moments = readings.iter().filter_map(|reading| match reading.push {
            Push::Moment { moment_n_m, .. } => Some(moment_n_m),
            Push::Force { .. } => None,
        });
        let (force, moment) = (forces.reduce(f64::max), moments.reduce(f64::max));
        let of_force = |force_n: f64| force_n * size_m;
        Self {
            length_error_m: length.or(angle.map(|error_rad| error_rad * size_m)).unwrap_or(0.0),
            angle_error_rad: angle.or(length.map(|error_m| error_m / size_m)).unwrap_or(0.0),
            force_n: force.or(moment.map(|moment_n_m| moment_n_m / size_m)).unwrap_or(0.0),
            moment_n_m: moment.or(force.map(of_force)).unwrap_or(0.0),
            friction: readings.iter().filter_map(|reading| reading.friction).reduce(f64::max),
        }
    }

    fn error_si(&self, unit: &SiUnit) -> f64 {
        if *unit == SiUnit::ANGLE { self.angle_error_rad } else { self.length_error_m }
    }
}

/// Information on the plays in their widths: the identity for the intervals, and a aᵀ/e² for each reading.
fn information(set: &ConsistentSet) -> Vec<f64> {
    let n = set.intervals_si.len();
    let mut matrix = vec![0.0; n * n];
    (0..n).for_each(|k| matrix[k * n + k] = 1.0);
    for row in &set.rows {
        let nominal: Vec<f64> = row.factors.iter().map(|factors| factors[1]).collect();
        let scaled = in_widths(set, &nominal);
        let error_si = row.common_si + 0.5 * (row.interval_si[1] - row.interval_si[0]);
        // Factors that are not known exactly make an error as well.
        let loose: f64 =
            row.factors.iter().zip(&set.intervals_si).map(|(f, [_, high])| 0.5 * (f[2] - f[0]) * high).sum();
        let error_si = (error_si + loose).max(f64::MIN_POSITIVE.sqrt());
        for i in 0..n {
            for j in 0..n {
                matrix[i * n + j] += scaled[i] * scaled[j] / (error_si * error_si);
            }
        }
    }
    matrix
}

fn in_widths(set: &ConsistentSet, factors: &[f64]) -> Vec<f64> {
    factors.iter().zip(&set.intervals_si).map(|(factor, [low, high])| factor * (high - low)).collect()
}

/// The mean of all points at which bounds are attained: a point of the consistent set, far from its ends.
fn middle(bounds: &[[End; 2]]) -> Vec<f64> {
    let points: Vec<&Vec<f64>> = bounds.iter().flatten().map(|end| &end.plays_si).collect();
    let plays = points.first().map_or(0, |point| point.len());
    (0..plays).map(|play| points.iter().map(|point| point[play]).sum::<f64>() / points.len() as f64).collect()
}

/// The best candidates, each with another place of the push or another output, and the number of all.
fn candidates(rig: &Rig<'_>, usual: &Usual, information: &[f64]) -> (Vec<Candidate>, usize) {
    let outputs = position_outputs(&rig.mechanism);
    let mut best: HashMap<String, Candidate> = HashMap::new();
    let mut tried = 0;
    for step in 0..POSES {
        let pose_rad = TAU * step as f64 / POSES as f64;
        let Ok(coordinates) = locked_at(&rig.mechanism, &rig.values, pose_rad) else { continue };
        for push in pushes(rig, usual) {
            for read in reads(rig, &outputs, &push) {
                let nominal = Nominal::of_position(
                    &rig.mechanism,
                    &rig.values,
                    coordinates.clone(),
                    &pushed(&push),
                    &[(read.position, 1.0)],
                );
                let Ok(nominal) = nominal else { continue };
                tried += 1;
                let factors = factors_of_plays(rig, &nominal.factors);
                let gain = gain(rig, information, &factors, usual.error_si(&read.unit));
                let test =
                    Test { push, travel: read.position, pose_rad, pose_error_rad: 0.0, friction: usual.friction };
                let key = format!("{} {}", pushed_words(rig, &push), read.words);
                let candidate = Candidate { test, read, factors, gain };
                match best.get(&key) {
                    Some(known) if known.gain >= gain => {}
                    _ => {
                        best.insert(key, candidate);
                    }
                }
            }
        }
    }
    let mut ranked: Vec<(String, Candidate)> = best.into_iter().filter(|(_, candidate)| candidate.gain > 0.0).collect();
    ranked.sort_by(|(a_key, a), (b_key, b)| b.gain.total_cmp(&a.gain).then_with(|| a_key.cmp(b_key)));
    (ranked.into_iter().take(IN_FULL).map(|(_, candidate)| candidate).collect(), tried)
}

/// aᵀ M⁻¹ a/e²: how much a reading adds to what is known.
fn gain(rig: &Rig<'_>, information: &[f64], factors: &[f64], error_si: f64) -> f64 {
    let n = factors.len();
    let widths = rig.plays.iter().map(|play| play.interval_si[1] - play.interval_si[0]);
    let scaled: Vec<f64> = factors.iter().zip(widths).map(|(factor, width)| factor * width).collect();
    let mut solution = scaled.clone();
    solve_square(&mut information.to_vec(), n, &mut solution);
    let gain = scaled.iter().zip(&solution).map(|(a, b)| a * b).sum::<f64>() / (error_si * error_si);
    if gain.is_finite() { gain } else { 0.0 }
}

fn factors_of_plays(rig: &Rig<'_>, of_joints: &[f64]) -> Vec<f64> {
    let of_play = |play: usize| of_joints.iter().zip(&rig.clearances).map(|(f, c)| f * c.slopes[play]).sum();
    (0..rig.plays.len()).map(of_play).collect()
}

/// Everything that can be pushed.
fn pushes(rig: &Rig<'_>, usual: &Usual) -> Vec<Push> {
    let model = &rig.mechanism.model;
    let mut pushes = Vec::new();
    for (body, known) in model.bodies.iter().enumerate().skip(1) {
        let body = BodyId(body);
        pushes.push(Push::Moment { body, moment_n_m: usual.moment_n_m });
        for point in 0..known.points.len() {
            for step in 0..DIRECTIONS {
                let direction_rad = PI * step as f64 / DIRECTIONS as f64;
                pushes.push(Push::Force { point: PointId { body, point }, direction_rad, force_n: usual.force_n });
            }
        }
    }
    pushes
}

/// What can be read beside a push: the outputs of the model, and what is pushed itself.
fn reads(rig: &Rig<'_>, outputs: &[PositionOutput], push: &Push) -> Vec<Read> {
    let model = &rig.mechanism.model;
    let mut reads: Vec<Read> = outputs
        .iter()
        .map(|output| Read {
            position: output.reading,
            words: output.name.clone(),
            has_output: true,
            unit: output.unit.clone(),
        })
        .collect();
    let own: Vec<(Position, SiUnit)> = match *push {
        Push::Force { point, .. } => {
            let point = Relative::to_ground(point);
            [Axis::X, Axis::Y].map(|axis| (Position::Point(point, axis), SiUnit::LENGTH)).to_vec()
        }
        Push::Moment { body, .. } => vec![(Position::Angle(Relative::to_ground(body)), SiUnit::ANGLE)],
    };
    for (position, unit) in own {
        if !reads.iter().any(|known| known.position == position) {
            let words = Reading::from(Motion::position(position)).words(model);
            reads.push(Read { position, words, has_output: false, unit });
        }
    }
    reads
}

fn pushed_words(rig: &Rig<'_>, push: &Push) -> String {
    let model = &rig.mechanism.model;
    match *push {
        Push::Force { point, .. } => relative_words(model, Relative::to_ground(point)),
        Push::Moment { body, .. } => model.bodies[body.0].name.clone(),
    }
}

fn described(
    rig: &Rig<'_>,
    candidate: &Candidate,
    error_si: f64,
    widths_si: Vec<f64>,
    candidates: usize,
) -> FurtherReading {
    let direction_rad = match candidate.test.push {
        Push::Force { direction_rad, .. } => Some(direction_rad),
        Push::Moment { .. } => None,
    };
    FurtherReading {
        reads: candidate.read.words.clone(),
        has_output: candidate.read.has_output,
        pose_rad: candidate.test.pose_rad,
        pushed: pushed_words(rig, &candidate.test.push),
        direction_rad,
        error_si,
        unit: candidate.read.unit.clone(),
        factors: candidate.factors.clone(),
        widths_si,
        candidates,
    }
}
