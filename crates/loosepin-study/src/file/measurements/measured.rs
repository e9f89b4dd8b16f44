//! Readings of a backlash test.

use crate::file::measurements::measurement::{Measured, MeasuredMotion, Push, ReadingScatter};
use crate::file::problem::StudyProblem;
use crate::file::reader::StudyReader;
use loosepin_mechanics::model::{Axis, BodyId, Cycle, CycleSpan, PointId, Position};
use loosepin_text::diagnostics::{Code, nearest_name, problems};
use loosepin_text::document::{Entry, Kind, Reads, Value, count, listed, quantity};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

/// Readings of a study, at most: each is two rows of every linear programme.
const MAX_READINGS: usize = 200;
/// Largest error of a locked angle, deg: only its ends and its middle are looked at.
const MAX_POSE_ERROR_DEG: f64 = 5.0;
/// Repeats from which their scatter is estimated, at least: Student's factor for 99.9 % is 32 with three, and 637 with two.
const MIN_ESTIMATED: usize = 3;

record! {
    /// a reading of a backlash test: with the drives locked, an output is pushed back and forth, and the dead travel (lost motion) between
    /// the two positions at rest is read
    pub(crate) lenient struct ReadingTable for Reads, exactly one of [force, moment];
    /// the output that is read: a position or an angle of the model
    required output: Entry<'t> = Kind::Reference("output"), "\"slider\"";
    /// only for a path: the coordinate that is read
    optional component: Entry<'t> = Kind::Choice(&["x", "y"]), "\"x\"";
    /// locked angle of the drive that counts the cycle
    required pose: Entry<'t> = Kind::Values(&quantity(Dimension::ANGLE, Rule::Finite)), "{ crank = \"60 deg\" }";
    /// largest error of this angle, of either sign; 0 if omitted
    optional pose_error: Entry<'t> = quantity(Dimension::ANGLE, Rule::NonNegative), "\"0.5 deg\"";
    /// force of the push, the same in both directions
    optional force: Entry<'t> = quantity(Dimension::FORCE, Rule::Positive), "\"20 N\"";
    /// instead of a force: the moment on the body whose angle is read
    optional moment: Entry<'t> = quantity(Dimension::TORQUE, Rule::Positive), "\"0.5 N m\"";
    /// the point that is pushed; if omitted, the point whose coordinate is read
    optional at: Entry<'t> = Kind::Point, "\"slider.pin\"";
    /// direction of the first push, as an angle from the ground's x axis; if omitted, along the coordinate that is read
    optional direction: Entry<'t> = quantity(Dimension::ANGLE, Rule::Finite), "\"0 deg\"";
    /// travel between the two positions at rest, under load: one value, or all repeats
    required dead_travel: Entry<'t> =
        Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]),
        "[\"0.412 mm\", \"0.409 mm\", \"0.413 mm\"]";
    /// with one value: the number of readings of which it is the mean; 1 if omitted
    optional repeats: Entry<'t> = count(1, 1_000_000), "5";
    /// largest common error of all readings of the instrument, of either sign; repeats do not reduce it; 0 if omitted
    optional error: Entry<'t> = Kind::AnyQuantity, "\"± 0.005 mm\"";
    /// standard deviation of one reading; repeats reduce the error of the mean; if omitted, calculated from three or more repeats
    optional scatter: Entry<'t> = Kind::AnyQuantity, "\"0.002 mm\"";
    /// the instrument that has the common error; one for each output if omitted
    optional instrument: String = Kind::Text, "\"dial gauge\"";
    /// name of the measured mechanism; each specimen has its own lengths and plays
    optional specimen: String = Kind::Text, "\"A\"";
    /// largest coefficient of friction in the joints; every value from 0 to this is possible; if omitted, from the contacts in the model
    optional friction: f64 = Kind::Number { rule: Rule::NonNegative }, "0.15";
    /// name of the reading in messages; its position in the file if omitted
    optional name: String = Kind::Text, "\"tip, sideways\"";
}

problems! {
    /// Problems of a reading. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum MeasuredProblem {
        /// The model is in space.
        InSpace => Code::WrongKindOfFile,
            says("[[measured]] has readings of planar models, and the model of this study is in space"),
            hint("remove it: `loosepin identify` takes planar models");
        NoPosition { entry: String, output: String } => Code::AskNotPossible,
            says("{entry}: output '{output}' is neither a position nor an angle, and a dead travel must be one of these"),
            hint("add an output position_of or angle_of to the model, and use it here");
        MomentOnPoint { entry: String } => Code::AskNotPossible,
            says("{entry}: a moment turns a body, but the output is a coordinate of a point"),
            hint("write force = \"20 N\", or read the angle of the turned body");
        NoPlaceOfForce { entry: String } => Code::AskNotPossible,
            says("{entry}: the output is an angle, so 'at' and 'direction' must give the point and direction of the force"),
            hint("write at = \"rocker.tip\" and direction = \"90 deg\", or moment instead of force");
        RelativeOutput { entry: String } => Code::AskNotPossible,
            says("{entry}: the output is seen from another body, so that 'at' and 'direction' must say where and which way \
                  the push acts"),
            hint("write at = \"rocker.tip\" and direction = \"90 deg\"");
        BesideMoment { entry: String } => Code::AskNotPossible,
            says("{entry} cannot be used with a moment, which has neither point nor direction"),
            hint("remove it, or write force instead of moment");
        DirectionMissing { entry: String } => Code::AskNotPossible,
            says("{entry}: 'at' is not the point of the output, so 'direction' must give the direction of the force"),
            hint("write direction = \"90 deg\", from the ground's x axis");
        NotAPoint { entry: String, found: String } => Code::UnknownReference,
            says("{entry} is '{found}'; must be a point, body and name with a dot between them"),
            hint("for example at = \"slider.pin\"");
        UnknownPoint { entry: String, found: String, nearest: Option<String>, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: the model has no point '{found}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => format!("available: {}", listed(known, "and")),
            }));
        PointOfGround { entry: String } => Code::AskNotPossible,
            says("{entry}: a point of the ground cannot be pushed"),
            hint("use a point of a moving body");
        WithoutError { entry: String } => Code::AskNotPossible,
            says("{entry} has no error: without an error, a reading would determine a play exactly"),
            hint("write error = \"± 0.005 mm\" beside it (calibration), scatter = \"0.002 mm\" (standard deviation), or give \
                  three repeats or more");
        RepeatsOfList { entry: String, found: usize } => Code::AskNotPossible,
            says("{entry} cannot be used with a list of {found} readings, which are the repeats"),
            hint("remove it");
        NoPose { entry: String } => Code::AskNotPossible,
            says("{entry} gives no angle; must give one"),
            hint("write pose = {{ crank = \"60 deg\" }}, with the drive that the cycle counts");
        AnotherError { entry: String, instrument: String } => Code::AskNotPossible,
            says("{entry} is another common error than that of an earlier reading of the instrument '{instrument}'; an instrument \
                  has one"),
            hint("write the same error, or add instrument = \"another gauge\": two different errors of one gauge would cancel out");
        PoseErrorTooLarge { entry: String, found_deg: f64 } => Code::AskNotPossible,
            says("{entry} is {found_deg} deg; must be at most {MAX_POSE_ERROR_DEG} deg: angles between its ends are not checked"),
            hint("measure the angle of the locked drive, or use the nearest pose and a smaller error");
        NoDriveAngle { entry: String } => Code::AskNotPossible,
            says("{entry}: the cycle of the model counts time, so there is no drive angle at which to lock"),
            hint("write drive = \"crank\" instead of duration under [cycle] of the model");
        TooManyReadings { found: usize } => Code::TooMany,
            says("[[measured]] has {found} readings; must be at most {MAX_READINGS}"),
            hint("write repeats of a reading as one list");
    }
}

impl StudyReader {
    /// Reads readings of backlash tests, and features of motions.
    pub fn read_measured(
        &mut self,
        written: Option<&Entry<'_>>,
        cycle: &Cycle,
    ) -> (Vec<Measured>, Vec<MeasuredMotion>) {
        if let Some(entry) = written.filter(|_| !self.model.takes_readings()) {
            self.reader.report(&MeasuredProblem::InSpace, entry.key_span);
            return (Vec::new(), Vec::new());
        }
        let entries = self.double_brackets(written);
        if let Some(surplus) = entries.get(MAX_READINGS) {
            let problem = MeasuredProblem::TooManyReadings { found: entries.len() };
            self.reader.report(&problem, surplus.span);
            return (Vec::new(), Vec::new());
        }
        let (mut read, mut motion): (Vec<Measured>, Vec<MeasuredMotion>) = (Vec::new(), Vec::new());
        for (index, entry) in entries.iter().enumerate() {
            if entry.holds("kind") {
                let feature = self.motion_feature(entry, cycle, &motion);
                motion.extend(feature);
                continue;
            }
            let reading = ReadingTable::read(self, entry).and_then(|table| {
                let reading = self.reading_of_test(&table, index)?;
                self.refuse_another_error(&table, &reading, &read);
                Some(reading)
            });
            read.extend(reading);
        }
        (read, motion)
    }

    /// That all readings of a specimen by one instrument have its error: of two errors that differ the common part would be known to be zero.
    fn refuse_another_error(&mut self, table: &ReadingTable<'_>, reading: &Measured, before: &[Measured]) {
        let is_of_same =
            |known: &&Measured| (&known.instrument, &known.specimen) == (&reading.instrument, &reading.specimen);
        let known = before.iter().find(is_of_same);
        if known.is_some_and(|known| known.error_si != reading.error_si) {
            let (words, span) = match &table.error {
                Some(entry) => (entry.path.describe(), entry.span),
                None => (table.table.path.describe(), table.table.span),
            };
            let problem = MeasuredProblem::AnotherError { entry: words, instrument: reading.instrument.clone() };
            self.reader.report(&problem, span);
        }
    }

    fn reading_of_test(&mut self, table: &ReadingTable<'_>, index: usize) -> Option<Measured> {
        let ReadingTable { table: whole, name, specimen, instrument, friction, .. } = table;
        let output = self.output(whole, &table.output, &table.component);
        let pose_rad = table.pose.as_ref().and_then(|entry| self.locked_angle(entry));
        let pose_error_rad = table.pose_error.as_ref().map_or(Some(0.0), |entry| self.pose_error(entry));
        // Without the output neither units nor the usual place of the push are known.
        let output = self.outputs[output?].clone();
        let Some(travel) = output.seen.position() else {
            let problem = MeasuredProblem::NoPosition { entry: whole.path.describe(), output: output.name };
            return self.refused(&problem, table.output.as_ref().map_or(whole.span, |entry| entry.span));
        };
        let push = self.push(table, travel);
        let values = self.dead_travels(table, output.dimension);
        let stated = self.errors(table, output.dimension);
        let (values_si, [error_si, scatter_si]) = (values?, stated?);
        let (repeats, scatter) = self.repeats(table, &values_si, scatter_si)?;
        let entry = table.dead_travel.as_ref()?;
        // Repeats that are all equal tell of the resolution of the instrument, not of its error.
        let is_without = matches!(scatter, None | Some(ReadingScatter::Estimated(0.0)));
        if error_si.is_none() && is_without {
            return self.refused(&MeasuredProblem::WithoutError { entry: entry.path.describe() }, entry.span);
        }
        Some(Measured {
            name: name.clone().unwrap_or_else(|| format!("reading {}", index + 1)),
            specimen: specimen.clone(),
            instrument: instrument.clone().unwrap_or_else(|| format!("that of {}", output.name)),
            output: output.name,
            travel,
            unit: output.unit,
            pose_rad: pose_rad?,
            pose_error_rad: pose_error_rad?,
            push: push?,
            friction: *friction,
            dead_travel_si: values_si.iter().sum::<f64>() / values_si.len() as f64,
            repeats,
            error_si: error_si.unwrap_or(0.0),
            scatter: scatter.unwrap_or(ReadingScatter::Known(0.0)),
            place: self.reader.place(entry.span),
            pose_place: self.reader.place(table.pose.as_ref().map_or(whole.span, |pose| pose.span)),
        })
    }

    /// Largest error of the locked angle, rad.
    fn pose_error(&mut self, entry: &Entry<'_>) -> Option<f64> {
        let error_rad = self.reader.measured(entry, Dimension::ANGLE, Rule::NonNegative)?;
        if error_rad > MAX_POSE_ERROR_DEG.to_radians() {
            let problem =
                MeasuredProblem::PoseErrorTooLarge { entry: entry.path.describe(), found_deg: error_rad.to_degrees() };
            return self.refused(&problem, entry.span);
        }
        Some(error_rad)
    }

    /// The angle at which the drive is locked, rad.
    fn locked_angle(&mut self, entry: &Entry<'_>) -> Option<f64> {
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "a table such as { crank = \"60 deg\" }");
        }
        if !matches!(self.model.cycle().span, CycleSpan::Turns(_)) {
            return self.refused(&MeasuredProblem::NoDriveAngle { entry: entry.path.describe() }, entry.span);
        }
        let due = self.model.cycle_input(&self.model.quantities().nominal()).name;
        let mut angle_rad = None;
        for angle in self.reader.any_keys(entry) {
            if angle.name != due {
                let name = angle.name.to_owned();
                let problem = StudyProblem::WrongDrive { entry: angle.path.describe(), name, due: due.clone() };
                return self.refused(&problem, angle.key_span);
            }
            angle_rad = Some(self.reader.measured(&angle, Dimension::ANGLE, Rule::Finite)?);
        }
        if angle_rad.is_none() {
            self.reader.report(&MeasuredProblem::NoPose { entry: entry.path.describe() }, entry.span);
        }
        angle_rad
    }

    fn push(&mut self, table: &ReadingTable<'_>, travel: Position) -> Option<Push> {
        let ReadingTable { table: whole, force, moment, at, direction, .. } = table;
        let [force_n, moment_n_m, direction_rad] =
            [force, moment, direction].map(|entry| entry.as_ref().and_then(|entry| f64::read(self, entry)));
        let point = at.as_ref().map(|entry| self.pushed_point(entry));
        if let Some(moment) = moment {
            for beside in [at, direction].into_iter().flatten() {
                self.reader.report(&MeasuredProblem::BesideMoment { entry: beside.path.describe() }, beside.key_span);
            }
            let Position::Angle(body) = travel else {
                let problem = MeasuredProblem::MomentOnPoint { entry: moment.path.describe() };
                return self.refused(&problem, moment.span);
            };
            if body.to.is_some() {
                let problem = MeasuredProblem::RelativeOutput { entry: whole.path.describe() };
                return self.refused(&problem, moment.span);
            }
            return Some(Push::Moment { body: body.of, moment_n_m: moment_n_m? });
        }
        let entry = force.as_ref()?;
        let force_n = force_n?;
        if direction.is_some() && direction_rad.is_none() {
            return None;
        }
        let words = || whole.path.describe();
        let own = match travel {
            Position::Point(point, axis) if point.to.is_none() => {
                let along_rad = if axis == Axis::X { 0.0 } else { std::f64::consts::FRAC_PI_2 };
                Some((point.of, along_rad))
            }
            _ => None,
        };
        let problem = match (point, direction_rad, own, travel) {
            (Some(point), Some(direction_rad), ..) => {
                return Some(Push::Force { point: point?, direction_rad, force_n });
            }
            (Some(Some(point)), None, Some((own, direction_rad)), _) if point == own => {
                return Some(Push::Force { point, direction_rad, force_n });
            }
            (Some(None), ..) => return None,
            (Some(_), None, Some(_), _) => MeasuredProblem::DirectionMissing { entry: words() },
            (None, given, Some((point, along_rad)), _) => {
                return Some(Push::Force { point, direction_rad: given.unwrap_or(along_rad), force_n });
            }
            (_, _, None, Position::Angle(body)) if body.to.is_none() => {
                MeasuredProblem::NoPlaceOfForce { entry: words() }
            }
            (_, _, None, _) => MeasuredProblem::RelativeOutput { entry: words() },
        };
        self.refused(&problem, entry.span)
    }

    /// The point that an entry names as `body.point`.
    fn pushed_point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        let text = self.reader.text(entry)?.to_owned();
        if !text.contains('.') {
            return self.refused(&MeasuredProblem::NotAPoint { entry: entry.path.describe(), found: text }, entry.span);
        }
        let all = self.model.points_to_push();
        let Some((_, point)) = all.iter().find(|(name, _)| *name == text) else {
            let nearest = nearest_name(&text, all.iter().map(|(name, _)| name.as_str())).map(str::to_owned);
            let known = all.iter().map(|(name, _)| format!("'{name}'")).collect();
            let problem = MeasuredProblem::UnknownPoint { entry: entry.path.describe(), found: text, nearest, known };
            return self.refused(&problem, entry.span);
        };
        if point.body == BodyId(0) {
            return self.refused(&MeasuredProblem::PointOfGround { entry: entry.path.describe() }, entry.span);
        }
        Some(*point)
    }

    /// The readings, SI: one, or all repeats.
    fn dead_travels(&mut self, table: &ReadingTable<'_>, dimension: Dimension) -> Option<Vec<f64>> {
        let entry = table.dead_travel.as_ref()?;
        if !entry.is_list() {
            return self.reader.measured(entry, dimension, Rule::NonNegative).map(|value_si| vec![value_si]);
        }
        let entries = self.reader.list(entry)?;
        if entries.is_empty() {
            return self.refused(&StudyProblem::Empty { entry: entry.path.describe() }, entry.span);
        }
        let read: Vec<Option<f64>> =
            entries.iter().map(|entry| self.reader.measured(entry, dimension, Rule::NonNegative)).collect();
        read.into_iter().collect()
    }

    /// The common error and the standard deviation of one reading, SI, each where it is written.
    fn errors(&mut self, table: &ReadingTable<'_>, dimension: Dimension) -> Option<[Option<f64>; 2]> {
        let read = [&table.error, &table.scatter].map(|entry| {
            let Some(entry) = entry else { return Some(None) };
            self.reader.measured_beyond(entry, &["±", "+/-", "+-"], dimension, Rule::NonNegative).map(Some)
        });
        let [error_si, scatter_si] = read;
        Some([error_si?, scatter_si?])
    }

    /// The number of readings behind the mean, and their scatter where it is known.
    fn repeats(
        &mut self,
        table: &ReadingTable<'_>,
        values_si: &[f64],
        scatter_si: Option<f64>,
    ) -> Option<(usize, Option<ReadingScatter>)> {
        let stated = table.repeats.as_ref().and_then(|entry| self.reader.count_of(entry));
        if let (Some(entry), true) = (&table.repeats, table.dead_travel.as_ref().is_some_and(|entry| entry.is_list())) {
            let problem = MeasuredProblem::RepeatsOfList { entry: entry.path.describe(), found: values_si.len() };
            return self.refused(&problem, entry.span);
        }
        if table.repeats.is_some() && stated.is_none() {
            return None;
        }
        let repeats = stated.map_or(values_si.len(), |count| count as usize);
        if let Some(scatter_si) = scatter_si {
            return Some((repeats, Some(ReadingScatter::Known(scatter_si))));
        }
        if values_si.len() < MIN_ESTIMATED {
            return Some((repeats, None));
        }
        // The mean of equal numbers is off by round-off, which is no scatter.
        if values_si.iter().all(|value_si| *value_si == values_si[0]) {
            return Some((repeats, Some(ReadingScatter::Estimated(0.0))));
        }
        let mean_si = values_si.iter().sum::<f64>() / values_si.len() as f64;
        let squares: f64 = values_si.iter().map(|value_si| (value_si - mean_si) * (value_si - mean_si)).sum();
        Some((repeats, Some(ReadingScatter::Estimated((squares / (values_si.len() - 1) as f64).sqrt()))))
    }
}
