//! From values to the numbers of a sample.

use super::closing::{Closing, START_LIMIT};
use super::conditioned::Conditioned;
use super::error::SamplingError;
use super::free::{Free, Room};
use super::journals::variables_m;
use super::nominal::{Base, NominalPlace, components_of, drives_at, followed, go_on};
use super::part::PlaySide;
use super::reach::Reach;
use super::reading::{PlaceReader, PlacedPart};
use super::turn_sample::TurnSample;
use super::turn_sampler::TurnSampler;
use crate::accuracy::plays::Plays;
use crate::accuracy::{AccuracyError, PoseAccuracy};
use crate::closure::assembly::Starts;
use crate::closure::error::OpenJoint;
use crate::closure::loops::Loops;
use crate::closure::newton::largest;
use crate::closure::position::Position;
use crate::closure::step::CLOSED;
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::stop::IsStopped;
use loosepin_math::Pose;
use loosepin_text::numbers::Values;

/// By how much drives may be elsewhere than nominally, rad or m, relative to one and to their place.
const DRIVE_TOLERANCE: f64 = 1e-9;

/// Smallest pivot of a sample's system relative to that of the nominal one below which it is nearer to a dead centre.
const NEARER: f64 = 0.5;

/// What is the same at all places of a sample.
struct Sample<'a> {
    sampler: &'a TurnSampler,
    loops: Loops<'a>,
    plays: Plays,
    outputs: Vec<Vec<SpatialOutput>>,
    /// Variables of play, where they are drawn, m.
    drawn: Option<Vec<f64>>,
}

impl TurnSampler {
    /// A sample with play that may do anything, or with places of the journals drawn from uniform numbers.
    pub(super) fn sampled(
        &self,
        values: &Values,
        uniforms: Option<&[f64]>,
        is_stopped: IsStopped,
    ) -> Result<TurnSample, SamplingError> {
        let mechanism = self.model.unplaced_mechanism(values)?;
        let turn_s = self.model.cycle_input(values)?.turn_s;
        for place in &self.motion.places {
            self.check_drives(values, turn_s, place)?;
        }
        // Lengths are measured by the nominal one, so that systems can be compared.
        let loops = Loops { length_m: self.motion.mechanism.characteristic_length_m(), ..Loops::new(&mechanism) };
        let plays = Plays::new(&loops);
        let outputs = self.parts.iter().map(|part| components_of(&self.model, values, part));
        let own = Sample {
            sampler: self,
            outputs: outputs.collect::<Result<_, _>>()?,
            drawn: uniforms.map(|uniforms| variables_m(&plays.set, self.distribution, uniforms)),
            loops,
            plays,
        };
        let mut sample = TurnSample::new(self.parts.len() * self.places());
        let (mut closing, mut room) = (Closing::default(), Room::default());
        // Positions of its own motion, where it had to be followed.
        let mut positions: Option<Vec<Position>> = None;
        for (number, place) in self.motion.places.iter().enumerate() {
            go_on(is_stopped, place.turn)?;
            let is_near = positions.is_none() && closing.close_ideal(&own.loops, &place.base, START_LIMIT);
            if is_near {
                own.read(place, &place.base, &closing, &mut room, number, &mut sample)?;
                continue;
            }
            let positions = match &mut positions {
                Some(positions) => positions,
                none => none.insert(self.follow(&mechanism, values, turn_s, is_stopped)?),
            };
            let base = positions.get(number).map(|position| Base::new(&own.loops, position.clone()));
            match base.filter(|base| closing.close_ideal(&own.loops, base, START_LIMIT)) {
                Some(base) => own.read(place, &base, &closing, &mut room, number, &mut sample)?,
                None => return Err(no_answer(place, "", AccuracyError::NotAPosition)),
            }
        }
        Ok(sample)
    }

    fn check_drives(&self, values: &Values, turn_s: f64, place: &NominalPlace) -> Result<(), SamplingError> {
        let at = place.turn * turn_s;
        let pairs = place.base.drives.iter().zip(&self.model.drives);
        for (nominal, drive) in pairs {
            let found = values[drive.start] + values[drive.speed] * at;
            if !((nominal - found).abs() <= DRIVE_TOLERANCE * nominal.abs().max(1.0)) {
                return Err(SamplingError::DriveElsewhere {
                    drive: drive.name.clone(),
                    turn: place.turn,
                    nominal_si: *nominal,
                    found_si: found,
                    is_length: drive.coordinate == JointCoordinate::Slide,
                });
            }
        }
        Ok(())
    }

    /// The sample's own motion at the places, from its own start, or from the nominal one where that is not the one of the file.
    fn follow(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        turn_s: f64,
        is_stopped: IsStopped,
    ) -> Result<Vec<Position>, SamplingError> {
        let mechanism = match &self.motion.start {
            Some(poses) => mechanism.with_start_poses(poses),
            None => self.model.with_starts(mechanism, values),
        };
        let turns: Vec<f64> = self.motion.places.iter().map(|place| place.turn).collect();
        let drives = |turn: f64| drives_at(&self.model, values, turn_s, turn);
        // Another assembly is none of this mechanism.
        let (positions, places) = followed(&mechanism, &turns, &drives, Starts::AsGiven, is_stopped)?;
        Ok(places.into_iter().map(|place| positions[place].clone()).collect())
    }
}

impl Sample<'_> {
    /// Reads all parts off at a place that is closed.
    fn read(
        &self,
        place: &NominalPlace,
        base: &Base,
        closing: &Closing,
        room: &mut Room,
        number: usize,
        sample: &mut TurnSample,
    ) -> Result<(), SamplingError> {
        let side = self.sampler.side;
        let fails = |why: AccuracyError| no_answer(place, "", why);
        let is_asked = side == PlaySide::Exact || self.drawn.is_some();
        if is_asked && self.is_near_dead_centre(place, base, closing) {
            let accuracy = PoseAccuracy::of_closed(self.loops.clone(), &base.position, closing.closed());
            let accuracy = accuracy.map_err(fails)?;
            // A place that is drawn may do anything but lead to the other assembly.
            let is_over = match &self.drawn {
                Some(drawn) => !accuracy.stays_at(drawn),
                None => accuracy.reaches_dead_centre(),
            };
            if is_over {
                return Err(SamplingError::DeadCentre { turn: place.turn });
            }
        }
        let has_conditions = !base.position.borders.left.is_empty() && self.plays.set.variables() > 0;
        let is_open = !(largest(&closing.apart) <= CLOSED);
        if is_open || (has_conditions && (side != PlaySide::None || self.drawn.is_some())) {
            let accuracy =
                PoseAccuracy::of_closed(self.loops.clone(), &base.position, closing.closed()).map_err(fails)?;
            let mut reach = self.conditioned(place, base, accuracy)?;
            let displaced = match &self.drawn {
                Some(_) if reach.accuracy.conditions() > 0 => {
                    return Err(SamplingError::ConditionsOnPlay { conditions: reach.accuracy.conditions() });
                }
                Some(drawn) => Some(reach.accuracy.close_at(&closing.poses, drawn, None).map_err(fails)?.poses),
                None => None,
            };
            return self.read_parts(place, &mut reach, displaced.as_deref(), number, sample);
        }
        let mut reach = Free { loops: &self.loops, base, closing, plays: &self.plays, side, room };
        let displaced = match &self.drawn {
            Some(drawn) => Some(reach.displaced(drawn).map_err(fails)?),
            None => None,
        };
        self.read_parts(place, &mut reach, displaced.as_deref(), number, sample)
    }

    /// Whether play may reach a dead centre, as far as the nominal position and the pivots tell.
    fn is_near_dead_centre(&self, place: &NominalPlace, base: &Base, closing: &Closing) -> bool {
        let has_play = self.plays.radii_m.iter().any(|radius| *radius > 0.0);
        has_play && (place.is_near_dead_centre || closing.system.pivot_ratio() < NEARER * base.pivot_ratio)
    }

    fn read_parts(
        &self,
        place: &NominalPlace,
        reach: &mut dyn Reach,
        displaced: Option<&[Pose]>,
        number: usize,
        sample: &mut TurnSample,
    ) -> Result<(), SamplingError> {
        let sampler = self.sampler;
        let reader = PlaceReader { place, nominal_mechanism: &sampler.motion.mechanism, displaced };
        for (k, part) in sampler.parts.iter().enumerate() {
            let placed =
                PlacedPart { part: part.part, components: &self.outputs[k], nominal: &sampler.outputs[k], number: k };
            let numbers = reader.read(reach, &placed);
            let numbers = numbers.map_err(|why| no_answer(place, &sampler.model.outputs[part.output].name, why))?;
            sample.set(k * sampler.places() + number, &numbers);
        }
        Ok(())
    }

    /// What the plays must make of each redundant row so that the loops close: nothing where they close with ideal joints. To first order that is
    /// h·p = h0.
    fn conditioned<'b>(
        &'b self,
        place: &NominalPlace,
        base: &Base,
        mut accuracy: PoseAccuracy<'b>,
    ) -> Result<Conditioned<'b>, SamplingError> {
        let (side, apart) = (self.sampler.side, accuracy.apart.clone());
        if largest(&apart) <= CLOSED {
            return Ok(Conditioned { accuracy, right: vec![0.0; apart.len()], side });
        }
        // What no play reaches is left as it is, where it is round-off.
        let unreached = accuracy.planes.rest(&apart);
        let right: Vec<f64> = unreached.iter().zip(&apart).map(|(unreached, apart)| unreached - apart).collect();
        let is_reached = side != PlaySide::None && largest(&unreached) <= CLOSED;
        let reserve = if is_reached { accuracy.reserve_of(&right).ok() } else { None };
        match reserve {
            Some(reserve) if reserve.factor > 1.0 => {
                accuracy.apart = unreached;
                Ok(Conditioned { accuracy, right, side })
            }
            reserve => Err(SamplingError::CannotBeAssembled {
                turn: place.turn,
                open: open_joint(&self.loops, base, &apart),
                // Which of them are open depends on the basis of the redundant directions.
                repeated: apart.len(),
                needed: reserve.map(|reserve| 1.0 / reserve.factor),
            }),
        }
    }
}

fn no_answer(place: &NominalPlace, output: &str, why: AccuracyError) -> SamplingError {
    SamplingError::NoAnswer { turn: place.turn, output: output.to_owned(), why }
}

/// The row that is farthest from closing.
fn open_joint(loops: &Loops, base: &Base, apart: &[f64]) -> OpenJoint {
    let borders = &base.position.borders.left;
    let entry = |row: usize| borders.iter().zip(apart).map(|(null, apart)| null[row] * apart).sum::<f64>().abs();
    let worst = (0..loops.rows.len()).max_by(|&a, &b| entry(a).total_cmp(&entry(b))).unwrap_or(0);
    let row = loops.rows.get(worst);
    OpenJoint {
        joint: row.map_or(String::new(), |row| loops.mechanism.joints()[row.joint].name.clone()),
        apart: row.map_or(0.0, |row| entry(worst) * loops.scale(row)),
        is_length: row.is_some_and(|row| row.row.is_length()),
    }
}
