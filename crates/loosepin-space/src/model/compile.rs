//! From values to a mechanism.

use super::direction::{Direction, vector};
use super::marker::{ModelMarker, ModelMisalignment, PointId};
use super::output::{ModelOutputKind, OutputValues};
use super::parts::{ModelCycleSpan, ModelGuess, ModelJoint, ModelOutput, SpatialModel};
use super::placing::placed;
use super::problem::SpatialModelError;
use crate::mechanism::body::Body;
use crate::mechanism::drive::{Drive, DriveValue};
use crate::mechanism::joint::Joint;
use crate::mechanism::marker::Marker;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use loosepin_math::{Pose, Quaternion, Vec3};
use loosepin_text::diagnostics::{Diagnostic, Place, Source};
use loosepin_text::numbers::Values;
use std::sync::Arc;

/// What grows evenly over a turn.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleInput {
    /// Name of the drive whose angle it is; `None` for the time.
    pub drive: Option<String>,
    /// At time zero, rad or s.
    pub start: f64,
    /// Its rate, rad/s; 1 for the time.
    pub rate: f64,
    /// Duration of the turn, s.
    pub turn_s: f64,
    /// Positions in the turn; the last is the first again.
    pub samples: usize,
}

impl CycleInput {
    /// Times at which the mechanism is looked at, s: evenly over the turn, both ends among them.
    pub fn times_s(&self) -> Vec<f64> {
        (0..=self.samples).map(|sample| self.turn_s * sample as f64 / self.samples as f64).collect()
    }

    /// Entries of the times in the order in which the input increases: a drive may run backwards.
    pub fn ascending<T>(&self, mut entries: Vec<T>) -> Vec<T> {
        if self.rate < 0.0 {
            entries.reverse();
        }
        entries
    }

    /// The input at a time.
    pub fn at(&self, time_s: f64) -> f64 {
        self.start + self.rate * time_s
    }
}

/// An output with the values of its model.
struct OfOutput<'a> {
    model: &'a SpatialModel,
    output: &'a ModelOutput,
    values: &'a Values,
}

impl OutputValues<SpatialModelError> for OfOutput<'_> {
    fn point_m(&self, point: PointId) -> Vec3 {
        self.model.position(point, self.values)
    }

    fn unit(&self, direction: Direction, key: &'static str) -> Result<Vec3, SpatialModelError> {
        unit(direction, self.values, || format!("output.{}.{key}", self.output.name))
    }
}

impl SpatialModel {
    /// The mechanism with these values, its bodies placed for the start.
    ///
    /// # Errors
    /// Directions of length zero or along the axis that they are across, and what [`SpatialMechanism::new`] refuses.
    pub fn mechanism(&self, values: &Values) -> Result<SpatialMechanism, SpatialModelError> {
        Ok(self.with_starts(&self.unplaced_mechanism(values)?, values))
    }

    /// The mechanism with these values, without the errors of manufacture that are given as tilts and shifts.
    ///
    /// # Errors
    /// As [`SpatialModel::mechanism`].
    pub fn aligned(&self, values: &Values) -> Result<SpatialMechanism, SpatialModelError> {
        let without = |marker: ModelMarker| ModelMarker { misalignment: ModelMisalignment::default(), ..marker };
        let joints = self.joints.iter().cloned();
        let joints = joints.map(|joint| ModelJoint {
            bearing: without(joint.bearing),
            journal: without(joint.journal),
            ..joint
        });
        Ok(self.with_starts(&self.unplaced(&joints.collect::<Vec<_>>(), values)?, values))
    }

    /// The mechanism with its bodies placed for the start.
    pub(crate) fn with_starts(&self, mechanism: &SpatialMechanism, values: &Values) -> SpatialMechanism {
        let mut guesses = vec![None; self.bodies.len()];
        for guess in &self.guesses {
            guesses[guess.body] = Some(pose(guess, values));
        }
        let starts: Vec<f64> = self.drives.iter().map(|drive| values[drive.start]).collect();
        mechanism.with_start_poses(&placed(mechanism, &guesses, &starts))
    }

    /// The mechanism with all bodies at the origin: for positions that are known.
    pub(crate) fn unplaced_mechanism(&self, values: &Values) -> Result<SpatialMechanism, SpatialModelError> {
        self.unplaced(&self.joints, values)
    }

    fn unplaced(&self, joints: &[ModelJoint], values: &Values) -> Result<SpatialMechanism, SpatialModelError> {
        let bodies = self.bodies.iter().map(|body| Body::new(body.name.clone(), Pose::GROUND)).collect();
        let joints: Result<Vec<Joint>, SpatialModelError> =
            joints.iter().map(|joint| self.joint(joint, values)).collect();
        let drives = self.drives.iter().map(|drive| Drive { joint: drive.joint, coordinate: drive.coordinate });
        SpatialMechanism::new(bodies, joints?, drives.collect()).map_err(|error| {
            let path = error.joint().map(|joint| format!("joint.{joint}"));
            SpatialModelError::NoMechanism { path: path.unwrap_or_default(), why: error.to_string() }
        })
    }

    /// What the drives prescribe at a time.
    pub fn drive_values(&self, values: &Values, time_s: f64) -> Vec<DriveValue> {
        let at = |speed: f64, start: f64| DriveValue::at_rate(start + speed * time_s, speed);
        self.drives.iter().map(|drive| at(values[drive.speed], values[drive.start])).collect()
    }

    /// What a turn is counted by.
    ///
    /// # Errors
    /// There is no `[cycle]`, or its drive stands still.
    pub fn cycle_input(&self, values: &Values) -> Result<CycleInput, SpatialModelError> {
        let Some(cycle) = &self.cycle else {
            let names = self.drives.iter().map(|drive| format!("\"{}\"", drive.name)).collect();
            return Err(SpatialModelError::NoCycle { names });
        };
        let samples = cycle.samples_per_turn;
        let drive = match cycle.span {
            ModelCycleSpan::Duration(duration) => {
                return Ok(CycleInput { drive: None, start: 0.0, rate: 1.0, turn_s: values[duration], samples });
            }
            ModelCycleSpan::Drive(drive) => &self.drives[drive],
        };
        let rate = values[drive.speed];
        if rate == 0.0 {
            return Err(SpatialModelError::StandsStill { path: format!("drive.{}.speed", drive.name) });
        }
        let turn_s = std::f64::consts::TAU / rate.abs();
        Ok(CycleInput { drive: Some(drive.name.clone()), start: values[drive.start], rate, turn_s, samples })
    }

    /// What an output reads off: one number, or the three components of the displacement of a point or of the rotation of a body.
    ///
    /// # Errors
    /// A direction of length zero.
    pub fn outputs_of(&self, number: usize, values: &Values) -> Result<Vec<SpatialOutput>, SpatialModelError> {
        let Some(output) = self.outputs.get(number) else { return Ok(Vec::new()) };
        output.kind.components(&OfOutput { model: self, output, values })
    }

    /// A point in the frame of its body, m.
    pub fn position(&self, point: PointId, values: &Values) -> Vec3 {
        vector(self.bodies[point.body].points[point.point].position_m, values)
    }

    /// A point as the file names it.
    pub fn point_name(&self, point: PointId) -> String {
        let body = &self.bodies[point.body];
        format!("{}.{}", body.name, body.points[point.point].name)
    }

    /// The point that an output is read off, or its body, as the file names it.
    pub fn name_of(&self, output: ModelOutputKind) -> String {
        let of_body = || self.bodies[output.body()].name.clone();
        output.point().map_or_else(of_body, |point| self.point_name(point))
    }

    /// The diagnostic of an error, at its place in the file.
    pub fn diagnostic(&self, error: &SpatialModelError) -> Diagnostic {
        let path = error.path();
        // Of a vector, its first number.
        let ids = [path.to_owned(), format!("{path}.x")].into_iter().filter_map(|path| self.quantities.id(&path));
        let of_number = ids.filter_map(|id| self.quantities[id].span).next();
        // The table of what is at fault, where it is no entry of its own.
        let tables = path.match_indices('.').map(|(end, _)| &path[..end]).chain([path]);
        let of_table = tables.filter_map(|path| self.places.get(path).copied()).next_back();
        let span = of_number.or(of_table);
        Diagnostic::error(error, span.map(|span| Place::new(&self.source, span)))
    }

    /// Where a table or a number of the file stands; the table above it where it is not written.
    pub fn place(&self, path: &str) -> Option<Place> {
        let written = self.quantities.id(path).and_then(|id| self.quantities[id].span);
        if let Some(span) = written.or_else(|| self.places.get(path).copied()) {
            return Some(Place::new(&self.source, span));
        }
        path.rsplit_once('.').and_then(|(table, _)| self.place(table))
    }

    /// The text of the file.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    fn joint(&self, joint: &ModelJoint, values: &Values) -> Result<Joint, SpatialModelError> {
        let numbers: Vec<f64> = joint.numbers.iter().map(|number| values[*number]).collect();
        let kind = joint.kind.with_numbers(&numbers);
        let bearing = self.marker(&joint.bearing, values, &joint.name, "bearing")?;
        let journal = self.marker(&joint.journal, values, &joint.name, "journal")?;
        let play = joint.play.map(|play| play.with(values));
        Ok(Joint { play, ..Joint::new(joint.name.clone(), kind, bearing, journal) })
    }

    fn marker(
        &self,
        marker: &ModelMarker,
        values: &Values,
        joint: &str,
        side: &str,
    ) -> Result<Marker, SpatialModelError> {
        let axis = unit(marker.axis, values, || format!("joint.{joint}.{side}_axis"))?;
        let (body, point_m) = (marker.point.body, self.position(marker.point, values));
        let path = || format!("joint.{joint}.{side}_across");
        let made = match marker.across {
            None => Marker::along(body, point_m, axis),
            Some(across) => Marker::new(body, point_m, axis, unit(across, values, path)?),
        };
        made.map(|made| marker.misalignment.applied_to(made, values))
            .ok_or_else(|| SpatialModelError::AlongAxis { path: path(), axis: "the axis of the joint" })
    }
}

fn unit(direction: Direction, values: &Values, path: impl Fn() -> String) -> Result<Vec3, SpatialModelError> {
    direction.vector(values).normalised().ok_or_else(|| SpatialModelError::NoDirection { path: path() })
}

/// Each turn is about an axis of the body as the turns before left it, so that it stands to the right of them.
fn pose(guess: &ModelGuess, values: &Values) -> Pose {
    let turn = guess.turned.iter().fold(Quaternion::IDENTITY, |turn, (axis, angle)| {
        turn.compose(&Quaternion::from_rotation_vector(axis.vector(values) * values[*angle]))
    });
    Pose::new(vector(guess.at_m, values), turn.normalised())
}
