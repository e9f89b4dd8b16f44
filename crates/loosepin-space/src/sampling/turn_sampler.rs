//! From values to the numbers of a sample.

use super::error::SamplingError;
use super::journals::{uniforms, variables_m};
use super::nominal::{Nominal, NominalPlace, components_of, drives_at, followed};
use super::part::{PlaySide, SampledPart};
use super::reading::{PlacePlay, PlaceReader, PlacedPart};
use super::turn_sample::TurnSample;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::{AccuracyError, PlayDistribution, PoseAccuracy};
use crate::closure::error::OpenJoint;
use crate::closure::loops::Loops;
use crate::closure::newton::{Closed, close, largest};
use crate::closure::position::Position;
use crate::closure::step::CLOSED;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::model::SpatialModel;
use crate::output::SpatialOutput;
use loosepin_text::numbers::Values;

/// What Newton's method may move from a nominal position, lengths over the characteristic length and rad: more is a hint at another branch.
const LARGEST_CORRECTION: f64 = 0.1;
/// By how much drives may be elsewhere than nominally, rad or m, relative to one and to their place.
const DRIVE_TOLERANCE: f64 = 1e-9;

/// Samples of a model over its turn: what is the same for all of them.
///
/// A sample is closed at each place by Newton's method from the nominal position there. That is the same branch where the determinant of the
/// bordered loop equations has kept its sign and the way was short; otherwise the sample is followed from place to place by [`crate::cycle`].
#[derive(Debug, Clone)]
pub struct TurnSampler {
    model: SpatialModel,
    parts: Vec<SampledPart>,
    side: PlaySide,
    distribution: PlayDistribution,
    values: Values,
    motion: Nominal,
    outputs: Vec<Vec<SpatialOutput>>,
    nominal: TurnSample,
}

impl TurnSampler {
    /// Samples of `model` at `turns`, places in the motion in turns of the cycle since time zero, ascending; `parts` are read off. Play is counted
    /// to first order ([`Self::with_play_side`]).
    ///
    /// # Errors
    ///
    /// [`SamplingError`]: places, parts, and a nominal motion that has no answer.
    pub fn new(
        model: &SpatialModel,
        nominal: &Values,
        turns: &[f64],
        parts: &[SampledPart],
    ) -> Result<Self, SamplingError> {
        let motion = Nominal::new(model, nominal, turns, parts)?;
        let outputs = parts.iter().map(|part| components_of(model, nominal, part)).collect::<Result<_, _>>()?;
        let sampler = Self {
            model: model.clone(),
            parts: parts.to_vec(),
            side: PlaySide::default(),
            distribution: PlayDistribution::Inside,
            values: nominal.clone(),
            motion,
            outputs,
            nominal: TurnSample::default(),
        };
        let of_nominal = sampler.sample(nominal)?;
        Ok(Self { nominal: of_nominal, ..sampler })
    }

    /// The same samples with play counted otherwise.
    ///
    /// # Errors
    ///
    /// [`SamplingError`], where the nominal motion has no answer then.
    pub fn with_play_side(self, side: PlaySide) -> Result<Self, SamplingError> {
        let sampler = Self { side, ..self };
        let of_nominal = sampler.sample(&sampler.values)?;
        Ok(Self { nominal: of_nominal, ..sampler })
    }

    /// The same samples with other places of the journals in [`Self::sample_with_play`], which are [`PlayDistribution::Inside`] of their play
    /// before.
    pub fn with_play_distribution(self, distribution: PlayDistribution) -> Self {
        Self { distribution, ..self }
    }

    /// The nominal values as a sample.
    pub fn nominal(&self) -> &TurnSample {
        &self.nominal
    }

    /// Number of places in the turn.
    pub fn places(&self) -> usize {
        self.motion.places.len()
    }

    /// What is read off at each place.
    pub fn parts(&self) -> &[SampledPart] {
        &self.parts
    }

    /// One sample.
    ///
    /// # Errors
    ///
    /// [`SamplingError`]: values that make no mechanism, drives that are elsewhere than nominally, loops that do not close or cannot be put
    /// together, outputs without an answer.
    pub fn sample(&self, values: &Values) -> Result<TurnSample, SamplingError> {
        self.sampled(values, None)
    }

    /// One sample with the journals in places that are drawn from uniform numbers in [0, 1) and that they keep over the turn, loops closed
    /// exactly. Smallest and largest numbers are alike: what these places make.
    ///
    /// # Errors
    ///
    /// Those of [`Self::sample`]; [`SamplingError::BadUniforms`]; [`SamplingError::ConditionsOnPlay`] where the plays must meet conditions
    /// together.
    pub fn sample_with_play(&self, values: &Values, uniforms: &[f64]) -> Result<TurnSample, SamplingError> {
        let expected = self.uniforms_per_sample();
        let found = uniforms.iter().filter(|uniform| (0.0..1.0).contains(*uniform)).count();
        if found != expected || uniforms.len() != expected {
            return Err(SamplingError::BadUniforms { expected, found });
        }
        self.sampled(values, Some(uniforms))
    }

    /// How many numbers [`Self::sample_with_play`] takes: of each ball three, of each end plane two, of each axial play one; on the rims one
    /// fewer of balls and end planes.
    pub fn uniforms_per_sample(&self) -> usize {
        uniforms(&PlaySet::new(&self.motion.mechanism), self.distribution)
    }

    fn sampled(&self, values: &Values, drawn: Option<&[f64]>) -> Result<TurnSample, SamplingError> {
        let mechanism = self.model.mechanism(values)?;
        let turn_s = self.model.cycle_input(values)?.turn_s;
        for place in &self.motion.places {
            self.check_drives(values, turn_s, place)?;
        }
        let outputs: Vec<Vec<SpatialOutput>> =
            self.parts.iter().map(|part| components_of(&self.model, values, part)).collect::<Result<_, _>>()?;
        let mut sample = TurnSample::new(self.parts.len() * self.places());
        // Positions of the sample's own motion, where it had to be followed.
        let mut own: Option<Vec<Position>> = None;
        for (number, place) in self.motion.places.iter().enumerate() {
            let loops = Loops { length_m: self.motion.mechanism.characteristic_length_m(), ..Loops::new(&mechanism) };
            let (closed, position) = match self.close_from_nominal(&loops, place).filter(|_| own.is_none()) {
                Some(closed) => (closed, place.position.clone()),
                None => {
                    if own.is_none() {
                        own = Some(self.follow(&mechanism, values, turn_s)?);
                    }
                    let position = own.as_ref().and_then(|own| own.get(number)).unwrap_or(&place.position).clone();
                    let drives = position.drive_values();
                    let closed = close(&loops, &position.poses, &[], &drives, &position.borders, None)
                        .map_err(|_| no_answer(place, "", AccuracyError::NotAPosition))?;
                    (closed, position)
                }
            };
            let open = open_joint(&loops, &position, &closed);
            let mut accuracy =
                PoseAccuracy::of_closed(loops, &position, closed).map_err(|why| no_answer(place, "", why))?;
            let right = self.right_hand_side(place, &mut accuracy, open)?;
            let displaced = match drawn {
                None => None,
                Some(_) if accuracy.conditions() > 0 => {
                    return Err(SamplingError::ConditionsOnPlay { conditions: accuracy.conditions() });
                }
                Some(drawn) => {
                    let variables = variables_m(&accuracy.set, self.distribution, drawn);
                    let closed = accuracy.close_at(&accuracy.position.poses, &variables, None);
                    Some(closed.map_err(|why| no_answer(place, "", why))?.poses)
                }
            };
            let reader = PlaceReader {
                place,
                nominal_mechanism: &self.motion.mechanism,
                accuracy: &accuracy,
                right: &right,
                play: displaced.as_deref().map_or(PlacePlay::Any(self.side), PlacePlay::Displaced),
            };
            for (k, part) in self.parts.iter().enumerate() {
                let placed =
                    PlacedPart { part: part.part, components: &outputs[k], nominal: &self.outputs[k], number: k };
                let numbers =
                    reader.read(&placed).map_err(|why| no_answer(place, &self.model.outputs[part.output].name, why))?;
                sample.set(k * self.places() + number, &numbers);
            }
        }
        Ok(sample)
    }

    fn check_drives(&self, values: &Values, turn_s: f64, place: &NominalPlace) -> Result<(), SamplingError> {
        let found = drives_at(&self.model, values, turn_s, place.turn);
        let pairs = place.position.drives.iter().zip(&found).zip(&self.model.drives);
        for ((nominal, found), drive) in pairs {
            let tolerance = DRIVE_TOLERANCE * nominal.value.abs().max(1.0);
            if !((nominal.value - found.value).abs() <= tolerance) {
                return Err(SamplingError::DriveElsewhere {
                    drive: drive.name.clone(),
                    turn: place.turn,
                    nominal_si: nominal.value,
                    found_si: found.value,
                });
            }
        }
        Ok(())
    }

    /// By Newton's method from the nominal position. `None` if that may be another branch.
    fn close_from_nominal(&self, loops: &Loops, place: &NominalPlace) -> Option<Closed> {
        let position = &place.position;
        let drives = position.drive_values();
        let closed = close(loops, &position.poses, &[], &drives, &position.borders, None).ok()?;
        (closed.way <= LARGEST_CORRECTION && closed.system.sign() == place.sign).then_some(closed)
    }

    /// The sample's own motion at the places.
    fn follow(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        turn_s: f64,
    ) -> Result<Vec<Position>, SamplingError> {
        let turns: Vec<f64> = self.motion.places.iter().map(|place| place.turn).collect();
        let (positions, places) = followed(mechanism, &turns, &|turn| drives_at(&self.model, values, turn_s, turn))?;
        Ok(places.into_iter().map(|place| positions[place].clone()).collect())
    }

    /// What the plays must make of each redundant row so that the loops close: nothing where they close with ideal joints.
    fn right_hand_side(
        &self,
        place: &NominalPlace,
        accuracy: &mut PoseAccuracy,
        open: OpenJoint,
    ) -> Result<Vec<f64>, SamplingError> {
        let apart = accuracy.apart.clone();
        if largest(&apart) <= CLOSED {
            return Ok(vec![0.0; apart.len()]);
        }
        // What no play reaches is left as it is, where it is round-off.
        let unreached = accuracy.planes.rest(&apart);
        let right: Vec<f64> = unreached.iter().zip(&apart).map(|(unreached, apart)| unreached - apart).collect();
        let is_reached = self.side != PlaySide::None && largest(&unreached) <= CLOSED;
        let reserve = if is_reached { accuracy.reserve_of(&right).ok() } else { None };
        accuracy.apart = unreached;
        match reserve {
            Some(reserve) if reserve.factor > 1.0 => Ok(right),
            reserve => Err(SamplingError::CannotBeAssembled {
                turn: place.turn,
                open,
                rows: apart.iter().filter(|apart| apart.abs() > CLOSED).count(),
                needed: reserve.map(|reserve| 1.0 / reserve.factor),
            }),
        }
    }
}

fn no_answer(place: &NominalPlace, output: &str, why: AccuracyError) -> SamplingError {
    SamplingError::NoAnswer { turn: place.turn, output: output.to_owned(), why }
}

/// The row that is farthest from closing.
fn open_joint(loops: &Loops, position: &Position, closed: &Closed) -> OpenJoint {
    let entry = |row: usize| {
        position.borders.left.iter().zip(&closed.apart).map(|(null, apart)| null[row] * apart).sum::<f64>().abs()
    };
    let worst = (0..loops.rows.len()).max_by(|&a, &b| entry(a).total_cmp(&entry(b))).unwrap_or(0);
    let row = loops.rows.get(worst);
    OpenJoint {
        joint: row.map_or(String::new(), |row| loops.mechanism.joints()[row.joint].name.clone()),
        apart: row.map_or(0.0, |row| entry(worst) * loops.scale(row)),
        is_length: row.is_some_and(|row| row.row.is_length()),
    }
}
