//! From the readings of a study to its answer.

use super::combinations::{IdentifiableSums, identifiable_sums};
use super::consistent::{ConsistentSet, End, ReadingRow};
use super::error::{Failure, IdentifyProblem, MAX_CONFIDENCE};
use super::further::further;
use super::influence::Influence;
use super::locked::Test;
use super::misfit::misfit;
use super::motion::{MotionValues, ProgressCallback, identify_motion};
use super::rig::Rig;
use super::states::States;
use loosepin_result::identification::{
    Combination, ConsistentPlays, Identification, InputRange, Outcome, PlayBounds, Specimen, TestReading,
};
use loosepin_result::repeat::Repeat;
use loosepin_study::{Measured, Push, ReadingScatter, Study};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use loosepin_text::units::{Dimension, DisplayUnits, SiUnit, distinct, format_value};
use loosepin_uncertainty::{normal_quantile, student_factor};

/// Confidence of all bounds together, where none is stated.
pub const CONFIDENCE: f64 = 0.99;

/// Values of the unknowns at which a motion is tested, about at most, where no number is stated.
pub const POINTS: usize = 400;

/// Boxes of the plays, each smaller than the one before, at most.
const ROUNDS: usize = 6;
/// Times that the exact loops are asked at the ends of all bounds, at most: each box needs one that widens nothing, and what widens is
/// doubled.
const CHECKS: usize = 10 * ROUNDS;
/// A box is worth another round where a width is below this share of the one before.
const WORTH_A_ROUND: f64 = 0.98;

/// Options of the identification from readings.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Probability with which all bounds of a specimen hold together, at least (default: 0.99).
    pub confidence: f64,
    /// The specimen whose readings count; all, each by itself, where none is named.
    pub specimen: Option<String>,
    /// Whether the reading that would narrow most is looked for (default: yes).
    pub looks_further: bool,
    /// Values of the unknowns at which a motion is tested, about at most (default: 400).
    pub points: usize,
    /// Number of threads that runs of a motion are made on (default: all).
    pub threads: usize,
    /// Whether a posterior distribution is given beside the set of a motion (default: no).
    pub with_posterior: bool,
    /// Whether mechanisms that agree with the measured motion are drawn (default: no).
    pub with_lengths: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            confidence: CONFIDENCE,
            specimen: None,
            looks_further: true,
            points: POINTS,
            threads: 0,
            with_posterior: false,
            with_lengths: false,
        }
    }
}

/// Readings are compared with the plane alone.
pub(crate) fn refuse_lean(study: &Study) -> Result<(), Diagnostics> {
    match study.model.leans_beside_runs() {
        true => Err(Diagnostics::one(&IdentifyProblem::PinsLean, study.model.place("lean"))),
        false => Ok(()),
    }
}

/// The plays that are consistent with the readings of `study`, specimen by specimen. `heard` hears of values of the unknowns that have their runs.
///
/// # Errors
/// No readings, no play among the inputs of the study, a mechanism without ideal motion, a pose that it cannot be locked in.
pub fn identify(study: &Study, options: &Options, heard: ProgressCallback<'_>) -> Result<Identification, Diagnostics> {
    study.model.demand_planar()?;
    refuse_lean(study)?;
    let confidence = options.confidence;
    if !(0.5..=MAX_CONFIDENCE).contains(&confidence) {
        return Err(Diagnostics::one(&IdentifyProblem::Confidence { found: confidence }, None));
    }
    if study.measured.is_empty() && study.motion.is_empty() {
        let place = Place::new(study.source(), 0..0);
        return Err(Diagnostic::error(&IdentifyProblem::NoReadings, Some(place)).into());
    }
    if study.specimen.is_some() {
        let place = Place::new(study.source(), 0..0);
        return Err(Diagnostic::error(&IdentifyProblem::Conditioned, Some(place)).into());
    }
    let wanted = specimens(study, options)?;
    let is_wanted = |specimen: &Option<String>| options.specimen.is_none() || options.specimen == *specimen;
    if options.with_lengths && !study.motion.iter().any(|feature| is_wanted(&feature.specimen)) {
        let place = Place::new(study.source(), 0..0);
        return Err(Diagnostic::error(&IdentifyProblem::NoMotion, Some(place)).into());
    }
    let asked = MotionValues {
        confidence,
        points: options.points,
        threads: options.threads,
        with_posterior: options.with_posterior,
        with_lengths: options.with_lengths,
    };
    let motion = identify_motion(study, options.specimen.as_ref(), &asked, heard)?;
    let answer = |random_inputs, specimens| Identification {
        study: study.name.clone(),
        model: study.model.name().to_owned(),
        version: loosepin_text::VERSION.to_owned(),
        confidence,
        random_inputs,
        display_units: study.model.shown_in(DisplayUnits::default()),
        specimens,
        motion,
        plan: None,
        gain: None,
        repeat: Repeat::default(),
    };
    if study.measured.is_empty() {
        return Ok(answer(Vec::new(), Vec::new()));
    }
    let has_scatter = |reading: &&Measured| reading.scatter != ReadingScatter::Known(0.0);
    let scattering = study.measured.iter().filter(has_scatter).count();
    // What may go wrong is shared between random inputs and readings, and among each of them evenly (Bonferroni's inequality).
    let parts = usize::from(scattering > 0) + usize::from(!study.random.is_empty());
    let share = (1.0 - confidence) / parts.max(1) as f64;
    let rig = Rig::new(study, share / study.random.len().max(1) as f64)?;
    let of_specimen = |name: &Option<String>| {
        let readings: Vec<&Measured> = study.measured.iter().filter(|reading| reading.specimen == *name).collect();
        let scattering = readings.iter().copied().filter(|reading| has_scatter(reading)).count();
        of_readings(&rig, name, &readings, share / scattering.max(1) as f64, options.looks_further)
    };
    let specimens = wanted.iter().map(of_specimen).collect::<Result<_, Diagnostics>>()?;
    let random = rig.others.iter().filter(|other| other.is_random).map(|other| InputRange {
        path: other.path.clone(),
        unit: other.unit.clone(),
        interval_si: other.interval_si,
    });
    Ok(answer(random.collect(), specimens))
}

/// The specimens of the readings, in the order of the file, or the one that is asked for.
fn specimens(study: &Study, options: &Options) -> Result<Vec<Option<String>>, Diagnostics> {
    let found = distinct(study.measured.iter().map(|reading| reading.specimen.clone()));
    let Some(wanted) = &options.specimen else { return Ok(found) };
    if found.iter().flatten().any(|known| known == wanted) {
        return Ok(vec![Some(wanted.clone())]);
    }
    known_specimen(study, wanted)?;
    // Only its motion was measured.
    Ok(Vec::new())
}

/// Refuses the name of a specimen at which nothing was measured.
///
/// # Errors
/// No reading and no feature of a motion is of it.
pub(crate) fn known_specimen(study: &Study, wanted: &str) -> Result<(), Diagnostics> {
    let readings = study.measured.iter().filter_map(|reading| reading.specimen.as_ref());
    let mut known: Vec<String> = Vec::new();
    for name in readings.chain(study.motion.iter().filter_map(|feature| feature.specimen.as_ref())) {
        if name == wanted {
            return Ok(());
        }
        let quoted = format!("'{name}'");
        if !known.contains(&quoted) {
            known.push(quoted);
        }
    }
    Err(Diagnostics::one(&IdentifyProblem::UnknownSpecimen { name: wanted.to_owned(), known }, None))
}

/// Largest independent error of the mean of a reading, of either sign, but for `share`.
fn independent_si(reading: &Measured, share: f64) -> f64 {
    let root = (reading.repeats as f64).sqrt();
    match reading.scatter {
        ReadingScatter::Known(deviation_si) => normal_quantile(1.0 - 0.5 * share) * deviation_si / root,
        ReadingScatter::Estimated(deviation_si) => {
            student_factor(1.0 - share, reading.repeats - 1) * deviation_si / root
        }
    }
}

fn of_readings(
    rig: &Rig<'_>,
    name: &Option<String>,
    readings: &[&Measured],
    share: f64,
    looks_further: bool,
) -> Result<Specimen, Diagnostics> {
    let instruments: Vec<&str> = distinct(readings.iter().map(|reading| reading.instrument.as_str()));
    let tests: Vec<Test> = readings
        .iter()
        .map(|reading| Test {
            push: reading.push,
            travel: reading.travel,
            pose_rad: reading.pose_rad,
            pose_error_rad: reading.pose_error_rad,
            friction: reading.friction,
        })
        .collect();
    let states = readings
        .iter()
        .zip(&tests)
        .map(|(reading, test)| States::new(rig, test).map_err(|error| locked(reading, error.into())))
        .collect::<Result<Vec<States>, Diagnostics>>()?;
    // Contacts yield the more alike, and the loops are the straighter, the smaller the box of the plays is: what the readings leave
    // of it is the next box.
    let influences_in = |plays_si: &[[f64; 2]]| -> Result<Vec<Influence>, Diagnostics> {
        let of = |((reading, test), states): ((&&Measured, &Test), &States)| {
            Influence::new(rig, test, states, plays_si).map_err(|error| locked(reading, error))
        };
        readings.iter().zip(&tests).zip(&states).map(of).collect()
    };
    let mut plays_si = rig.intervals_si();
    let mut influences = influences_in(&plays_si)?;
    for (reading, influence) in readings.iter().zip(&influences) {
        if !influence.is_moved() {
            let problem = IdentifyProblem::DoesNotMove { reading: reading.name.clone() };
            return Err(Diagnostic::error(&problem, Some(reading.place.clone())).into());
        }
    }
    let independent: Vec<f64> = readings.iter().map(|reading| independent_si(reading, share)).collect();
    let set_of = |influences: &[Influence]| {
        let row = |(index, influence): (usize, &Influence)| {
            let reading = readings[index];
            let interval_si = [-1.0, 1.0].map(|sign| reading.dead_travel_si + sign * independent[index]);
            let instrument = instruments.iter().position(|known| *known == reading.instrument).unwrap_or(0);
            ReadingRow::new(rig, influence, interval_si, reading.error_si, instrument)
        };
        ConsistentSet {
            intervals_si: rig.plays.iter().map(|play| play.interval_si).collect(),
            instruments: instruments.len(),
            rows: influences.iter().enumerate().map(row).collect(),
        }
    };
    let mut set = set_of(&influences);
    let widths_si: Vec<f64> = rig.plays.iter().map(|play| play.interval_si[1] - play.interval_si[0]).collect();
    let nominal: Vec<Vec<f64>> =
        set.rows.iter().map(|row| row.factors.iter().map(|factors| factors[1]).collect()).collect();
    let mut sums_of_plays = identifiable_sums(&nominal, &widths_si);
    add_whole_sum(rig, &mut sums_of_plays);
    let is_fixed: Vec<bool> =
        (0..widths_si.len()).map(|play| sums_of_plays.is_identifiable(play) && set.fixes(play)).collect();
    // What nominal factors tell apart, and those within their bounds do not, is no play that is fixed.
    sums_of_plays.combinations.retain(|weights| match sole(weights) {
        Some(play) => is_fixed[play],
        None => true,
    });
    let units = |play: usize| -> Vec<f64> { (0..widths_si.len()).map(|k| f64::from(u8::from(k == play))).collect() };
    let mut objectives: Vec<Vec<f64>> = (0..widths_si.len()).map(units).collect();
    objectives.extend(sums_of_plays.combinations.iter().cloned());
    let mut bounds = all_bounds(&set, &objectives);
    let mut shrunk = 1;
    for _ in 0..CHECKS {
        let Some(found) = &bounds else { break };
        // The linear model must hold where the bounds are attained: the exact loops are asked there, before a box is cut by them.
        let mut is_wider = false;
        for (reading, (test, influence)) in readings.iter().zip(tests.iter().zip(&mut influences)) {
            for end in found.iter().flatten() {
                let missed =
                    influence.missed_share(rig, test, &end.plays_si).map_err(|error| locked(reading, error.into()))?;
                if missed > influence.linearisation_share {
                    influence.widen(missed);
                    is_wider = true;
                }
            }
        }
        if !is_wider {
            let left: Vec<[f64; 2]> =
                plays_si.iter().zip(found).map(|(before_si, ends)| within(*before_si, ends)).collect();
            let is_smaller =
                |(left, before): (&[f64; 2], &[f64; 2])| left[1] - left[0] < WORTH_A_ROUND * (before[1] - before[0]);
            if shrunk == ROUNDS || !left.iter().zip(&plays_si).any(is_smaller) {
                break;
            }
            plays_si = left;
            influences = influences_in(&plays_si)?;
            shrunk += 1;
        }
        set = set_of(&influences);
        bounds = all_bounds(&set, &objectives);
    }
    let outcome = match bounds {
        None => Outcome::Misfit(misfit(&set)),
        Some(bounds) => {
            let (plays, sums) = bounds.split_at(widths_si.len());
            let plays = rig.plays.iter().zip(plays).enumerate().map(|(index, (play, ends))| PlayBounds {
                path: play.path.clone(),
                name: play.name.clone(),
                unit: play.unit.clone(),
                before_si: play.interval_si,
                after_si: within(play.interval_si, ends),
                is_identifiable: is_fixed[index],
                is_interval: play.is_interval,
            });
            let plays: Vec<PlayBounds> = plays.collect();
            let combinations = sums_of_plays.combinations.iter().zip(sums).map(|(weights, ends)| {
                let before_si = before(rig, weights);
                let unit = weights.iter().zip(&rig.plays).find(|(weight, _)| **weight != 0.0);
                Combination {
                    weights: weights.clone(),
                    unit: unit.map_or(SiUnit::NONE, |(_, play)| play.unit.clone()),
                    before_si,
                    after_si: within(before_si, ends),
                }
            });
            let combinations = combinations.collect();
            let further = looks_further.then(|| further(rig, &set, &bounds, readings));
            let searched = further.as_ref().map(|(searched, _)| *searched);
            let further = further.and_then(|(_, further)| further);
            Outcome::Consistent(ConsistentPlays {
                plays,
                combinations,
                alike: sums_of_plays.alike.clone(),
                further,
                searched,
            })
        }
    };
    let parts = readings.iter().zip(&set.rows).zip(independent.iter().zip(&influences));
    let readings = parts.map(|((reading, row), (independent_si, influence))| TestReading {
        name: reading.name.clone(),
        output: reading.output.clone(),
        unit: reading.unit.clone(),
        pose_rad: reading.pose_rad,
        push: push_words(rig, &reading.push),
        dead_travel_si: reading.dead_travel_si,
        repeats: reading.repeats,
        common_error_si: reading.error_si,
        independent_error_si: *independent_si,
        factors: row.factors.clone(),
        compliance_si: compliance_si(influence),
        linearisation_share: influence.linearisation_share,
        allowed_before_si: set.allowed_si(row),
    });
    Ok(Specimen { name: name.clone(), readings: readings.collect(), outcome })
}

/// The play of a sum that holds no other.
fn sole(weights: &[f64]) -> Option<usize> {
    let mut held = weights.iter().enumerate().filter(|(_, weight)| **weight != 0.0);
    held.next().map(|(play, _)| play).filter(|_| held.next().is_none())
}

/// Adds the sum of all plays where every play is determined by itself: their sum is determined as well, and often far better.
fn add_whole_sum(rig: &Rig<'_>, sums_of_plays: &mut IdentifiableSums) {
    let plays = rig.plays.len();
    let is_of_one_unit = rig.plays.iter().all(|play| play.unit == rig.plays[0].unit);
    if plays > 1 && is_of_one_unit && sums_of_plays.combinations.len() == plays {
        sums_of_plays.combinations.push(vec![1.0; plays]);
    }
}

/// Bounds of all objectives; `None` if no plays are consistent.
fn all_bounds(set: &ConsistentSet, objectives: &[Vec<f64>]) -> Option<Vec<[End; 2]>> {
    if set.is_empty() {
        return None;
    }
    objectives.iter().map(|weights| set.bounds(weights)).collect()
}

/// The ends of a bound, cut to the interval known before.
fn within(before_si: [f64; 2], [lower, upper]: &[End; 2]) -> [f64; 2] {
    [lower.value_si.max(before_si[0]), upper.value_si.min(before_si[1])]
}

/// The interval of a sum of plays by the intervals of the study.
fn before(rig: &Rig<'_>, weights: &[f64]) -> [f64; 2] {
    let mut ends = [0.0; 2];
    for (weight, play) in weights.iter().zip(&rig.plays) {
        let products = play.interval_si.map(|end| weight * end);
        ends[0] += f64::min(products[0], products[1]);
        ends[1] += f64::max(products[0], products[1]);
    }
    ends
}

fn compliance_si(influence: &Influence) -> [f64; 2] {
    let ends = (0..influence.yields_m.len()).map(|joint| influence.yield_si(joint));
    ends.fold([0.0; 2], |[least, most], [low, high]| [least + low, most + high])
}

/// A push in words: `20 N at slider.pin along 0 deg`.
pub(crate) fn push_words(rig: &Rig<'_>, push: &Push) -> String {
    let model = &rig.mechanism.model;
    match *push {
        Push::Force { point, direction_rad, force_n } => {
            let body = &model.bodies[point.body.0];
            let (force, direction) =
                (format_value(force_n, Dimension::FORCE), format_value(direction_rad, Dimension::ANGLE));
            format!("{force} at {}.{} along {direction}", body.name, body.points[point.point].name)
        }
        Push::Moment { body, moment_n_m } => {
            format!("{} on {}", format_value(moment_n_m, Dimension::TORQUE), model.bodies[body.0].name)
        }
    }
}

/// A mechanism that cannot be locked or does not settle, at the reading that asks for it.
fn locked(reading: &Measured, failure: Failure) -> Diagnostics {
    let name = reading.name.clone();
    let (problem, place) = match failure {
        Failure::Accuracy(error) => (IdentifyProblem::Locked { reading: name, error }, &reading.pose_place),
        Failure::TooLoaded { joint } => (IdentifyProblem::TooLoaded { reading: name, joint }, &reading.place),
    };
    Diagnostic::error(&problem, Some(place.clone())).into()
}
