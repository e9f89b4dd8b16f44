//! Features of a measured motion.

use crate::file::measurements::measurement::{
    FEATURES, FeatureWord, MeasuredMotion, MotionError, MotionSubject, SampledFeature,
};
use crate::file::problem::StudyProblem;
use crate::file::reader::{StudyReader, adopt};
use crate::file::words::{DEVIATIONS, words};
use crate::model::outputs::OutputSource;
use crate::response::sampled_feature::sampled_feature;
use loosepin_mechanics::model::Cycle;
use loosepin_result::simulation::Abscissa;
use loosepin_result::study::Deviation;
use loosepin_simulate::measured::MeasuredTable;
use loosepin_text::diagnostics::{Code, nearest_name, problems};
use loosepin_text::document::{Entry, Kind, Reads, Value, choice, count, listed, read_beside};
use loosepin_text::units::{Dimension, Rule, SiUnit, format_number};
use loosepin_text::{choices, record};
use std::f64::consts::TAU;

/// Share of a turn by which a table may end early: its last sample stands one sample before the end.
const ROUND_OFF: f64 = 1e-9;

/// Repeats of a motion, at most: each is a stretch of recorded turns that is simulated.
const MAX_STRETCHES: u64 = 20;
/// Highest order of a spectrum, at most: two samples a period.
const MAX_ORDER: u64 = 1000;

choices!(
    /// What was measured.
    pub(crate) struct MeasuredKind(()): "motion" => ()
);
choices!(
    /// Whether extremes are those of samples.
    pub(crate) struct IsSampled(bool): "between" => false, "samples" => true
);

record! {
    /// a feature of a motion, measured over the recorded turns: one number, or one for each repeat
    pub(crate) lenient struct MotionTable for Reads;
    /// marks the table as a feature of a motion; omitted for a backlash test
    required kind: MeasuredKind = choice::<MeasuredKind>(), "\"motion\"";
    /// the measured output of the model
    optional output: Entry<'t> = Kind::Reference("output"), "\"slider_acceleration\"";
    /// only for a path: the coordinate that was measured
    optional component: Entry<'t> = Kind::Choice(&["x", "y"]), "\"x\"";
    /// a deviation instead of the value, for a feature that is located between samples; "value" if omitted
    optional of: Entry<'t> = Kind::Choice(&words(&DEVIATIONS)), "\"total\"";
    /// instead of an output: the joint whose impacts were counted
    optional joint: Entry<'t> = Kind::Reference("joint"), "\"gudgeon\"";
    /// the number calculated from the motion of all recorded turns
    required feature: Entry<'t> = Kind::Choice(&words(&FEATURES)), "\"rms\"";
    /// for the amplitude of an order: periods per turn
    optional order: Entry<'t> = count(1, MAX_ORDER), "3";
    /// for a dwell: distance from the largest value
    optional within: Entry<'t> = Kind::AnyQuantity, "\"0.1 mm\"";
    /// low-pass filter: removes higher orders from the measured and from the simulated samples
    optional highest_order: Entry<'t> = count(1, MAX_ORDER), "40";
    /// whether extremes are located between samples, or are those of the samples (samples_per_turn of the study); samples if a curve,
    /// a filter or an order is given
    optional sampled: Entry<'t> = choice::<IsSampled>(), "\"samples\"";
    /// the measured feature: one value, or all repeats; omitted for a measurement that is only planned
    optional value: Entry<'t> =
        Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]), "[\"5210 m/s^2\", \"5340 m/s^2\"]";
    /// instead of a value: a table with the time or the drive angle and a column of the output; each group of recorded turns in it is
    /// one repeat
    optional file: Entry<'t> = Kind::Text, "\"acceleration.csv\"";
    /// with one value: the number of repeats of which it is the mean; 1 if omitted
    optional repeats: Entry<'t> = count(1, MAX_STRETCHES), "5";
    /// largest common error of all values of the instrument, of either sign, or its share of the true value; 0 if omitted
    optional error: Entry<'t> = Kind::AnyQuantity, "\"± 5 %\"";
    /// standard deviation of the independent error of one repeat, or its share of the true value; 0 if omitted
    optional scatter: Entry<'t> = Kind::AnyQuantity, "\"2 %\"";
    /// the instrument that has the common error; one for each output if omitted
    optional instrument: String = Kind::Text, "\"accelerometer\"";
    /// name of the measured mechanism; each specimen has its own lengths and plays
    optional specimen: String = Kind::Text, "\"A\"";
    /// name of the feature in messages; output and feature if omitted
    optional name: String = Kind::Text, "\"peak\"";
}

problems! {
    /// Problems of a feature of a motion. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum MotionProblem {
        NoSubject { entry: String, key: &'static str, feature: String } => Code::AskNotPossible,
            says("{entry}: the feature '{feature}' needs '{key}'"),
            hint("impacts need a joint; every other feature needs an output");
        Beside { entry: String, feature: String } => Code::AskNotPossible,
            says("{entry} has no effect on the feature '{feature}'"),
            hint("remove it");
        SeveralValues { entry: String } => Code::AskNotPossible,
            says("{entry} cannot be used with several values, each of which is one repeat"),
            hint("remove it, or write the mean of the repeats as one value");
        Between { entry: String } => Code::AskNotPossible,
            says("{entry}: a file, 'highest_order', an order and a dwell use samples, but sampled = \"between\" locates extremes between them"),
            hint("remove 'sampled'");
        DeviationNotSampled { entry: String } => Code::AskNotPossible,
            says("{entry}: a deviation has no samples, only the output itself"),
            hint("remove 'of'; or remove 'file', 'highest_order' and sampled = \"samples\", and use neither an order nor a dwell");
        OutputNotSampled { entry: String } => Code::AskNotPossible,
            says("{entry}: this output has no samples"),
            hint("remove 'file', 'highest_order' and sampled = \"samples\", and use neither an order nor a dwell");
        NoJointWithPlay { entry: String, found: String, nearest: Option<String>, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: there is no joint with play '{found}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => format!("available: {}", listed(known, "and")),
            }));
        PartOfTurn { entry: String, turns: f64 } => Code::AskNotPossible,
            says("{entry}: samples are of whole turns, and {turns} turns are recorded"),
            hint("write a whole number of recorded_turns under [cycle] of the study");
        TooHigh { entry: String, order: usize, samples: usize } => Code::AskNotPossible,
            says("{entry}: order {order} needs more than {} samples per turn; there are {samples}", 2 * order),
            hint("write a larger samples_per_turn under [cycle] of the study");
        TooShort { entry: String, found: f64, due: f64, turns: f64, samples: usize } => Code::AskNotPossible,
            says(
                "{entry}: the span of the table in turns is {}; must be at least {}: {turns} recorded turns of {samples} samples, the first to the last",
                format_number(*found),
                format_number(*due)
            ),
            hint("record fewer turns under [cycle] of the study, or measure longer");
        NoColumn { entry: String, output: String, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: the table has no column '{output}'"),
            hint("available: {}", listed(known, "and"));
        ColumnDimension { entry: String, found: Dimension, due: Dimension } => Code::WrongDimension,
            says("{entry}: the column is {found}; the output is {due}");
        Gap { entry: String } => Code::AskNotPossible,
            says("{entry}: the column has empty cells"),
            hint("shorten the table to the rows in which everything was measured");
        Twice { entry: String } => Code::AskNotPossible,
            says("{entry}: a value and a file are both given"),
            hint("remove one of them");
        TooManyStretches { entry: String, found: usize } => Code::TooMany,
            says("{entry}: {found} repeats; must be at most {MAX_STRETCHES}, each of which is simulated"),
            hint("record more turns in place of more repeats");
        WithoutError { entry: String } => Code::AskNotPossible,
            says("{entry} has no error"),
            hint("also write error = \"± 5 %\" (calibration) or scatter = \"2 %\" (standard deviation)");
        ErrorTooLarge { entry: String } => Code::AskNotPossible,
            says("{entry} is a share of 100 % or more"),
            hint("write a share below 100 %");
        AnotherError { entry: String, instrument: String } => Code::AskNotPossible,
            says("{entry} differs from the common error of an earlier value of the instrument '{instrument}'"),
            hint("write the same error, or add instrument = \"another sensor\"");
        NotPositive { entry: String } => Code::AskNotPossible,
            says("{entry}: no value with this sign is possible for the feature"),
            hint("write its magnitude");
    }
}

impl StudyReader {
    /// Reads one feature.
    pub(crate) fn motion_feature(
        &mut self,
        entry: &Entry<'_>,
        cycle: &Cycle,
        known: &[MeasuredMotion],
    ) -> Option<MeasuredMotion> {
        let motion = MotionTable::read(self, entry)?;
        let MotionTable { table, output, component, of, joint, order, within, highest_order, sampled, file, .. } =
            &motion;
        let words = || table.path.describe();
        let feature_entry = motion.feature.as_ref()?;
        let feature_word = self.reader.text(feature_entry)?.to_owned();
        let feature = self.reader.choice(feature_entry, &FEATURES)?;
        let (needed, others) = match feature {
            FeatureWord::Impacts => {
                (vec![("joint", joint)], vec![output, component, of, order, within, highest_order, sampled, file])
            }
            FeatureWord::Order => (vec![("order", order), ("output", output)], vec![joint, within]),
            FeatureWord::Dwell => (vec![("within", within), ("output", output)], vec![joint, order]),
            FeatureWord::Reduced(_) => (vec![("output", output)], vec![joint, order, within]),
        };
        if let Some((key, _)) = needed.into_iter().find(|(_, entry)| entry.is_none()) {
            let problem = MotionProblem::NoSubject { entry: words(), key, feature: feature_word };
            return self.refused(&problem, table.span);
        }
        if let Some(surplus) = others.into_iter().flatten().next() {
            let problem = MotionProblem::Beside { entry: surplus.path.describe(), feature: feature_word };
            return self.refused(&problem, surplus.key_span);
        }
        let (subject, unit, dimension, of) = if feature == FeatureWord::Impacts {
            let (play, name) = self.joint_with_play(joint.as_ref()?)?;
            (MotionSubject::Impacts { play }, SiUnit::NONE, Dimension::NUMBER, name)
        } else {
            let output = self.output(table, output, component)?;
            let known = self.outputs[output].clone();
            let subject = self.subject_of_output(&motion, output, feature, cycle)?;
            let (unit, dimension) = match feature {
                FeatureWord::Dwell => (SiUnit::ANGLE, Dimension::ANGLE),
                _ => (known.unit, known.dimension),
            };
            (subject, unit, dimension, known.name)
        };
        let (values_si, repeats) = self.feature_values(&motion, subject, dimension, cycle)?;
        let [error, scatter] =
            [&motion.error, &motion.scatter].map(|entry| self.motion_error(entry.as_ref(), dimension));
        let (error, scatter) = (error?, scatter?);
        if !values_si.is_empty() && error.size == 0.0 && scatter.size == 0.0 {
            return self.refused(&MotionProblem::WithoutError { entry: words() }, table.span);
        }
        let specimen = motion.specimen.clone();
        let instrument = motion.instrument.clone().unwrap_or_else(|| format!("that of {of}"));
        let is_of_same = |known: &&MeasuredMotion| (&known.instrument, &known.specimen) == (&instrument, &specimen);
        if known.iter().find(is_of_same).is_some_and(|known| known.error != error) {
            let at = motion.error.as_ref();
            let (place, span) = at.map_or((words(), table.span), |at| (at.path.describe(), at.span));
            return self.refused(&MotionProblem::AnotherError { entry: place, instrument }, span);
        }
        let name = motion.name.clone().unwrap_or_else(|| format!("{of}, {}", feature_word.replace('_', " ")));
        let span = motion.value.as_ref().or(file.as_ref()).map_or(table.span, |at| at.span);
        let place = self.reader.place(span);
        motion.kind?;
        Some(MeasuredMotion { name, specimen, instrument, subject, unit, values_si, repeats, error, scatter, place })
    }

    fn joint_with_play(&mut self, entry: &Entry<'_>) -> Option<(usize, String)> {
        let found = self.reader.text(entry)?.to_owned();
        let names = self.model.play_names();
        if let Some(play) = names.iter().position(|name| *name == found) {
            return Some((play, found));
        }
        let nearest = nearest_name(&found, names.iter().map(String::as_str)).map(str::to_owned);
        let known = names.iter().map(|name| format!("'{name}'")).collect();
        let problem = MotionProblem::NoJointWithPlay { entry: entry.path.describe(), found, nearest, known };
        self.refused(&problem, entry.span)
    }

    fn subject_of_output(
        &mut self,
        motion: &MotionTable<'_>,
        output: usize,
        feature: FeatureWord,
        cycle: &Cycle,
    ) -> Option<MotionSubject> {
        let table = &motion.table;
        let deviation = match &motion.of {
            Some(of) => self.deviation(Some(of), Some(output))?,
            None => Deviation::of_value(),
        };
        let written = match &motion.sampled {
            Some(entry) => Some(IsSampled::read(self, entry)?.0),
            None => None,
        };
        let needs =
            motion.file.is_some() || motion.highest_order.is_some() || !matches!(feature, FeatureWord::Reduced(_));
        let words = table.path.describe();
        if let (FeatureWord::Reduced(reduction), false) = (feature, needs || written == Some(true)) {
            return Some(MotionSubject::Located { output, deviation, reduction });
        }
        let problem = match (deviation.is_value_of_run(), self.outputs[output].seen) {
            _ if written == Some(false) => Some(MotionProblem::Between { entry: words.clone() }),
            (true, OutputSource::Reading(_)) => None,
            (true, _) => Some(MotionProblem::OutputNotSampled { entry: words.clone() }),
            (false, _) => Some(MotionProblem::DeviationNotSampled { entry: words.clone() }),
        };
        if let Some(problem) = problem {
            return self.refused(&problem, table.span);
        }
        let turns = cycle.recorded_turns;
        if turns.fract() != 0.0 || turns < 1.0 {
            return self.refused(&MotionProblem::PartOfTurn { entry: words, turns }, table.span);
        }
        let highest_order = motion.highest_order.as_ref().and_then(|entry| usize::read(self, entry));
        let feature = match feature {
            FeatureWord::Order => SampledFeature::Order(usize::read(self, motion.order.as_ref()?)?),
            FeatureWord::Dwell => {
                let dimension = self.outputs[output].dimension;
                SampledFeature::Dwell(self.reader.measured(motion.within.as_ref()?, dimension, Rule::Positive)?)
            }
            FeatureWord::Reduced(reduction) => SampledFeature::Reduced(reduction),
            FeatureWord::Impacts => return None,
        };
        let order = highest_order.into_iter().chain(match feature {
            SampledFeature::Order(order) => Some(order),
            _ => None,
        });
        let samples = cycle.samples_per_turn;
        if let Some(order) = order.max().filter(|order| 2 * order >= samples) {
            return self.refused(&MotionProblem::TooHigh { entry: words, order, samples }, table.span);
        }
        Some(MotionSubject::Sampled { output, feature, highest_order })
    }

    /// The values of the repeats, or their mean, and the number of repeats.
    fn feature_values(
        &mut self,
        motion: &MotionTable<'_>,
        subject: MotionSubject,
        dimension: Dimension,
        cycle: &Cycle,
    ) -> Option<(Vec<f64>, usize)> {
        let values_si = match (&motion.value, &motion.file) {
            (Some(entry), Some(_)) => {
                return self.refused(&MotionProblem::Twice { entry: motion.table.path.describe() }, entry.span);
            }
            (None, Some(entry)) => self.values_of_file(entry, subject, cycle)?,
            (Some(entry), None) => self.values_as_written(entry, dimension)?,
            (None, None) => Vec::new(),
        };
        let stated = match &motion.repeats {
            Some(entry) if values_si.len() > 1 => {
                return self.refused(&MotionProblem::SeveralValues { entry: entry.path.describe() }, entry.span);
            }
            Some(entry) => Some(usize::read(self, entry)?),
            None => None,
        };
        let repeats = stated.unwrap_or(values_si.len().max(1));
        // More than so many `repeats` are refused where these are read, and more stretches of a file are left out.
        if let Some(entry) = motion.value.as_ref().filter(|_| repeats as u64 > MAX_STRETCHES) {
            let problem = MotionProblem::TooManyStretches { entry: entry.path.describe(), found: repeats };
            return self.refused(&problem, entry.span);
        }
        let is_magnitude = match subject {
            MotionSubject::Impacts { .. } => true,
            MotionSubject::Located { reduction, .. }
            | MotionSubject::Sampled { feature: SampledFeature::Reduced(reduction), .. } => {
                reduction.is_never_negative()
            }
            MotionSubject::Sampled { .. } => true,
        };
        // Those of a file are magnitudes.
        if let Some(entry) = &motion.value
            && is_magnitude
            && values_si.iter().any(|value_si| *value_si < 0.0)
        {
            return self.refused(&MotionProblem::NotPositive { entry: entry.path.describe() }, entry.span);
        }
        Some((values_si, repeats))
    }

    fn values_as_written(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Vec<f64>> {
        if !entry.is_list() {
            return Some(vec![self.reader.measured(entry, dimension, Rule::Finite)?]);
        }
        let entries = self.reader.list(entry)?;
        if entries.is_empty() {
            return self.refused(&StudyProblem::Empty { entry: entry.path.describe() }, entry.span);
        }
        let read: Vec<Option<f64>> =
            entries.iter().map(|entry| self.reader.measured(entry, dimension, Rule::Finite)).collect();
        read.into_iter().collect()
    }

    /// The feature in each whole stretch of recorded turns of a table, at the samples of the study between its rows.
    fn values_of_file(&mut self, entry: &Entry<'_>, subject: MotionSubject, cycle: &Cycle) -> Option<Vec<f64>> {
        let MotionSubject::Sampled { output, feature, highest_order } = subject else { return None };
        let words = || entry.path.describe();
        let file = self.reader.text(entry)?;
        let read = read_beside(&self.reader.source, file).and_then(|source| {
            self.tables.push(source.clone());
            MeasuredTable::from_source(&source)
        });
        let table = match read {
            Ok(table) => table,
            Err(diagnostics) => {
                adopt(&mut self.reader, &diagnostics, entry.span);
                return None;
            }
        };
        let output = self.outputs[output].clone();
        let Some(column) = table.columns.iter().find(|column| column.is_of(&output.name)) else {
            let known = table.columns.iter().map(|column| format!("'{}'", column.name)).collect();
            let problem = MotionProblem::NoColumn { entry: words(), output: output.name, known };
            return self.refused(&problem, entry.span);
        };
        if column.dimension != output.dimension {
            let (found, due) = (column.dimension, output.dimension);
            return self.refused(&MotionProblem::ColumnDimension { entry: words(), found, due }, entry.span);
        }
        if column.values_si.iter().any(|value| !value.is_finite()) {
            return self.refused(&MotionProblem::Gap { entry: words() }, entry.span);
        }
        let turn = match table.abscissa {
            Abscissa::Time => self.model.input(cycle.span, &self.model.quantities().nominal()).turn_s(),
            Abscissa::DriveAngle => TAU,
        };
        let turns = cycle.recorded_turns;
        let (first, last) = (table.at_si.first()?, table.at_si.last()?);
        let samples = cycle.samples_per_turn;
        let found = (last - first) / turn;
        // The sample at the end of the last turn is that at the start of the next one.
        let interval = 1.0 / samples as f64;
        let stretches = ((found + interval) / turns + ROUND_OFF).floor() as usize;
        if stretches == 0 {
            let problem = MotionProblem::TooShort { entry: words(), found, due: turns - interval, turns, samples };
            return self.refused(&problem, entry.span);
        }
        let stretches = stretches.min(MAX_STRETCHES as usize);
        let whole = turns as usize;
        let value = |stretch: usize| {
            let at = |place: usize| first + turn * (stretch as f64 * turns + place as f64 / samples as f64);
            let sampled: Vec<f64> = (0..whole * samples).map(|place| table.value(column, at(place))).collect();
            sampled_feature(&sampled, whole, feature, highest_order)
        };
        Some((0..stretches).map(value).collect())
    }

    /// An error in the unit of the feature, or as a share of its true value; zero where it is left out.
    fn motion_error(&mut self, entry: Option<&Entry<'_>>, dimension: Dimension) -> Option<MotionError> {
        let Some(entry) = entry else { return Some(MotionError { size: 0.0, is_share: false }) };
        let is_share = entry.is_text() && self.reader.text(entry)?.trim_end().ends_with('%');
        let due = if is_share { Dimension::NUMBER } else { dimension };
        let size = self.reader.measured_beyond(entry, &["±", "+/-", "+-"], due, Rule::NonNegative)?;
        if is_share && size >= 1.0 {
            return self.refused(&MotionProblem::ErrorTooLarge { entry: entry.path.describe() }, entry.span);
        }
        Some(MotionError { size, is_share })
    }
}
