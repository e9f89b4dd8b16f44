//! A mechanism in space as a function from uncertain inputs to numbers: its loops are closed at each position, without dynamics.
//!
//! Play lets an output be anywhere between two ends at a position, whatever it is at others. So each column is an interval, by the arithmetic
//! of intervals over the positions, and the input `play` in [-1, 1] is the place in it:
//!
//! ```text
//! column = lower + (upper - lower) (1 + play)/2
//! ```
//!
//! Where the places of the journals are drawn, both ends are what these places make.

use crate::file::{Deviation, MAX_POSES, Reduction, Study};
use crate::model::outputs::OutputSource;
use crate::places::Location;
use crate::response::columns::{ColumnPlan, StudyColumn};
use crate::response::ends::{Ends, reduced};
use crate::response::extras::RunExtras;
use crate::response::input_targets::{InputTargets, in_the_middle};
use crate::response::limits::MAX_COLUMNS;
use crate::response::linear_scatter::LinearScatter;
use crate::response::planar_response::{POSE_ROUND_OFF, check_poses, check_turns};
use crate::response::problem::PrepareError;
use crate::response::recent_ends::{EndsOfSample, RecentEnds};
use loosepin_math::sort_ascending;
use loosepin_mechanics::model::CycleSpan;
use loosepin_result::study::Reference;
use loosepin_simulate::RunFailure;
use loosepin_space::{
    AccuracyError, PlayDistribution, PlaySide, SampledPart, SamplingError, SpatialModel, TurnSample, TurnSampler,
};
use loosepin_text::numbers::{QuantityError, QuantityId, Values};

/// Standard deviations of the scatter that count where the place of an extreme is sought.
const DEVIATIONS: f64 = 2.0;
/// Relative difference that is round-off.
const SAME: f64 = 1e-9;

/// A prepared study of a mechanism in space.
#[derive(Debug)]
pub struct SpatialResponse {
    /// Columns of a run.
    pub plan: ColumnPlan,
    /// Nominal values with the epistemic inputs in the middle.
    pub nominal: Values,
    /// Nominal ideal value of each column's output at its pose; NaN for reduced columns.
    pub nominal_at_pose: Vec<f64>,
    /// Turns that are looked at.
    pub recorded_turns: f64,
    targets: InputTargets,
    model: SpatialModel,
    sampler: TurnSampler,
    /// Places at which the motion is looked at, in turns, ascending.
    turns: Vec<f64>,
    /// Those of the cycle, with their weights in means; other places are poses that are asked for alone.
    grid: Vec<(usize, f64)>,
    /// The part that each column reads, and the places that it needs.
    reads: Vec<Read>,
    /// Samples that may come again with other places of their journals; `None` where these are no input.
    recent: Option<RecentEnds>,
}

/// What a column reads.
#[derive(Debug, Clone, Copy)]
struct Read {
    part: usize,
    /// The place of a pose; `None` for the whole cycle.
    place: Option<usize>,
}

impl SpatialResponse {
    /// Prepares a study of `model`.
    ///
    /// # Errors
    /// The nominal mechanism does not close over the turn; more columns than a study can bound.
    pub fn new(study: &Study, model: &SpatialModel) -> Result<Self, PrepareError> {
        let nominal = model.quantities.evaluate(&in_the_middle(study))?;
        let of_model = model.quantities.nominal();
        model.cycle_input(&of_model).map_err(|error| refused(model, &of_model, &error.into()))?;
        let input = study.model.input(study.cycle.span, &nominal);
        if input.speed_rad_s == 0.0 {
            return Err(RunFailure::StandsStill { drive: input.name }.into());
        }
        let plan = ColumnPlan::new(study, input.start_rad, input.speed_rad_s.signum());
        if plan.columns.len() > MAX_COLUMNS {
            return Err(PrepareError::TooManyColumns { columns: plan.columns.len() });
        }
        check_turns(study.cycle.transient_turns, study.cycle.recorded_turns)?;
        check_poses(study, &plan)?;
        check_drives(study, model)?;
        let recorded_turns = study.cycle.recorded_turns;
        let poses = (recorded_turns * study.cycle.samples_per_turn as f64).round().max(1.0);
        if poses > MAX_POSES as f64 {
            return Err(PrepareError::TooManyPoses { poses });
        }
        let Places { turns, grid } = Places::new(study, poses as usize, &plan);
        let mut parts: Vec<SampledPart> = Vec::new();
        let mut reads = Vec::with_capacity(plan.columns.len());
        for column in &plan.columns {
            let output = &plan.outputs[column.output];
            // Every column has its place in `reads`: none is left out.
            let OutputSource::InSpace(own) = output.seen else {
                let why = format!("output '{}' is not one of space", output.name);
                return Err(RunFailure::NoPosition { why, hint: "ask for an output of the model" }.into());
            };
            let part = parts.iter().position(|known| *known == own).unwrap_or_else(|| {
                parts.push(own);
                parts.len() - 1
            });
            let place = column.spot.pose().map(|pose| nearest(&turns, pose.turns));
            reads.push(Read { part, place });
        }
        // Play is counted to first order unless somebody asks what it makes: that needs a search.
        let is_searched = plan.columns.iter().any(|column| column.deviation.has_play());
        let side = if is_searched && study.journals.is_none() { PlaySide::Exact } else { PlaySide::FirstOrder };
        let prepared = |values: &Values| {
            let sampler = TurnSampler::new(model, values, &turns, &parts)?;
            if side == PlaySide::FirstOrder { Ok(sampler) } else { sampler.with_play_side(side) }
        };
        let mut sampler = prepared(&nominal).map_err(|error| {
            // Where the values of the model alone have no answer either, its file is at fault.
            match prepared(&of_model) {
                Ok(_) => failure(error).into(),
                Err(error) => refused(model, &of_model, &error),
            }
        })?;
        if let Some(distribution) = study.journals {
            sampler = drawing(sampler, distribution, &nominal)?;
        }
        let ideal = &sampler.nominal().ideal_si;
        let at_pose = |read: &Read| read.place.map_or(f64::NAN, |place| ideal[read.part * turns.len() + place]);
        let targets = InputTargets::new(study);
        let inputs = study.random.len() + study.epistemic.len();
        Ok(Self {
            recent: (targets.has_play()).then(|| RecentEnds::new(inputs, plan.columns.len())),
            nominal_at_pose: reads.iter().map(at_pose).collect(),
            turns,
            grid,
            targets,
            model: model.clone(),
            plan,
            nominal,
            recorded_turns,
            sampler,
            reads,
        })
    }

    /// The values of the model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    pub fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        self.targets.values(&self.model.quantities, random, epistemic)
    }

    /// The row of a run: its columns, then its extras. Where journals are drawn and `random` ends before their numbers, they are in the middle.
    ///
    /// # Errors
    /// A value breaks its rule; the loops do not close.
    pub fn row(&self, random: &[f64], epistemic: &[f64]) -> Result<Vec<f64>, RunFailure> {
        let close = || self.close(random, epistemic);
        let ends = match &self.recent {
            Some(recent) => recent.of(self.targets.of_sample(random, epistemic), close)?,
            None => close()?,
        };
        let play = self.targets.play(epistemic);
        let mut row: Vec<f64> = ends.iter().map(|ends| ends.at(play)).collect();
        let extras = RunExtras {
            energy_residual: f64::NAN,
            evaluations: 0.0,
            steps: self.turns.len() as f64,
            change_over_last_turn: f64::NAN,
            joints: Vec::new(),
        };
        extras.write(&mut row);
        Ok(row)
    }

    /// The ends of the columns, with the loops closed for these inputs. They do not depend on where in their play the journals are, where that is
    /// not known.
    fn close(&self, random: &[f64], epistemic: &[f64]) -> EndsOfSample {
        let values = self.values(random, epistemic).map_err(|error| RunFailure::Sample(error.into()))?;
        let sample = match &self.targets.journals(random)[..] {
            [] => self.sampler.sample(&values),
            drawn => self.sampler.sample_with_play(&values, drawn),
        };
        let sample = sample.map_err(failure)?;
        let columns = self.reads.iter().zip(&self.plan.columns);
        Ok(columns.map(|(read, column)| self.ends(&sample, read, column.deviation, column.spot)).collect())
    }

    /// The row of a run with all random quantities at the values of the model.
    ///
    /// # Errors
    /// As for [`Self::row`].
    pub fn without_scatter(&self, epistemic: &[f64]) -> Result<Vec<f64>, RunFailure> {
        self.row(&self.targets.of_model(&self.nominal), epistemic)
    }

    /// What random quantities do to first order, without play; `None` where nothing scatters or where it is not known.
    pub fn linear_scatter(&self, study: &Study) -> Option<LinearScatter> {
        LinearScatter::new(study, &self.model, &self.turns, self.sampler.parts())
    }

    /// The variance of a column by each random quantity: at its pose; of an extreme of the cycle at the place where play and [`DEVIATIONS`] standard
    /// deviations take it furthest, which is where samples have it; of other numbers of the cycle added over it.
    pub fn variances(&self, scatter: &LinearScatter, column: usize) -> Vec<f64> {
        let (read, StudyColumn { deviation, spot, .. }) = (self.reads[column], self.plan.columns[column]);
        let part = self.sampler.parts()[read.part];
        let quantities = 0..scatter.paths.len();
        let at = |place: usize| quantities.clone().map(move |quantity| scatter.variance(quantity, part, place));
        let reach = |reduction: Reduction, place: usize| {
            let Ends { lower, upper } = self.ends_at(self.sampler.nominal(), read.part, place, deviation);
            let scatter = DEVIATIONS * at(place).sum::<f64>().sqrt();
            reduction.reach([lower - scatter, upper + scatter])
        };
        let Some(reduction) = spot.reduction() else { return at(read.place.unwrap_or_default()).collect() };
        let mut furthest: Option<(f64, usize)> = None;
        for &(place, _) in &self.grid {
            // The first of several alike.
            let Some(own) = reach(reduction, place) else { continue };
            if furthest.is_none_or(|(most, _)| own > most + SAME * most.abs()) {
                furthest = Some((own, place));
            }
        }
        match furthest {
            Some((_, place)) => at(place).collect(),
            None => {
                let sum = |quantity: usize| {
                    self.grid.iter().map(|&(place, weight)| weight * scatter.variance(quantity, part, place)).sum()
                };
                quantities.map(sum).collect()
            }
        }
    }

    /// The ends of a part at a place.
    fn ends_at(&self, sample: &TurnSample, part: usize, place: usize, of: Deviation) -> Ends {
        let own = part * self.turns.len() + place;
        if !of.has_play() {
            return Ends::of(if of.is_value() { sample.ideal_si[own] } else { sample.from_nominal_si[own] });
        }
        match of.reference() {
            Reference::Zero => Ends {
                lower: sample.ideal_si[own] + sample.smallest_si[own],
                upper: sample.ideal_si[own] + sample.largest_si[own],
            },
            Reference::SameParts => Ends { lower: sample.smallest_si[own], upper: sample.largest_si[own] },
            Reference::NominalParts => {
                Ends { lower: sample.smallest_from_nominal_si[own], upper: sample.largest_from_nominal_si[own] }
            }
        }
    }

    fn ends(&self, sample: &TurnSample, read: &Read, of: Deviation, spot: Location) -> Ends {
        let at = |place: usize| self.ends_at(sample, read.part, place, of);
        match (read.place, spot.reduction()) {
            (None, Some(reduction)) => reduced(reduction, self.grid.iter().map(|&(place, weight)| (at(place), weight))),
            (place, _) => at(place.unwrap_or_default()),
        }
    }
}

/// The sampler for places of the journals that are drawn; samples without such places have them in the middle.
fn drawing(
    sampler: TurnSampler,
    distribution: PlayDistribution,
    nominal: &Values,
) -> Result<TurnSampler, PrepareError> {
    let sampler = sampler.with_play_distribution(distribution);
    // Whether plays must meet conditions together does not depend on where the journals are.
    let anywhere = vec![0.5; sampler.uniforms_per_sample()];
    if let Err(SamplingError::ConditionsOnPlay { conditions }) = sampler.sample_with_play(nominal, &anywhere) {
        return Err(PrepareError::JournalsTogether { conditions });
    }
    sampler.with_play_side(PlaySide::None).map_err(|error| failure(error).into())
}

/// Places at which a motion is looked at, in turns, and those of the cycle among them with their weights.
struct Places {
    turns: Vec<f64>,
    grid: Vec<(usize, f64)>,
}

impl Places {
    /// `rows` steps over the recorded turns, and the poses that are asked for between them.
    fn new(study: &Study, rows: usize, plan: &ColumnPlan) -> Self {
        let recorded_turns = study.cycle.recorded_turns;
        // A whole number of turns ends where it began; what does not has half the weight at its ends.
        let is_closed = recorded_turns.fract() == 0.0 && !matches!(study.cycle.span, CycleSpan::Duration(_));
        let last = rows - usize::from(is_closed);
        let of_cycle: Vec<f64> = (0..=last).map(|row| recorded_turns * row as f64 / rows as f64).collect();
        let asked = plan.columns.iter().filter_map(|column| Some(column.spot.pose()?.turns));
        let is_new = |turns: &f64| (of_cycle[nearest(&of_cycle, *turns)] - turns).abs() > POSE_ROUND_OFF;
        let mut turns: Vec<f64> = of_cycle.iter().copied().chain(asked.filter(is_new)).collect();
        sort_ascending(&mut turns);
        turns.dedup();
        let weight = |row: usize| if !is_closed && (row == 0 || row == last) { 0.5 } else { 1.0 };
        let grid = of_cycle.iter().enumerate().map(|(row, at)| (nearest(&turns, *at), weight(row))).collect();
        Self { turns, grid }
    }
}

/// The place of `turns`, which ascend, that is nearest to `at`.
fn nearest(turns: &[f64], at: f64) -> usize {
    let above = turns.partition_point(|known| *known < at);
    let distance = |place: usize| turns.get(place).map_or(f64::INFINITY, |known| (known - at).abs());
    let below = above.saturating_sub(1);
    if distance(below) <= distance(above) { below } else { above }
}

/// Every sample must have its drives at the same places.
fn check_drives(study: &Study, model: &SpatialModel) -> Result<(), PrepareError> {
    let random = study.random.iter().filter_map(|input| Some((&input.path, input.quantity()?)));
    let epistemic = study.epistemic.iter().filter_map(|input| Some((&input.path, input.quantity()?)));
    let counted = match study.cycle.span {
        CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => Some(drive.0),
        CycleSpan::Duration(_) => None,
    };
    for (path, quantity) in random.chain(epistemic) {
        let depends = |id: QuantityId| model.quantities.depends_on(id, quantity);
        if model.drives.iter().any(|drive| depends(drive.start)) {
            return Err(PrepareError::UncertainStart { path: path.clone() });
        }
        // Alone, the drive that the cycle counts is at the same places at any speed.
        let is_free = counted.is_some() && model.drives.len() == 1;
        let is_duration = matches!(study.cycle.span, CycleSpan::Duration(duration) if depends(duration));
        if is_duration || !is_free && model.drives.iter().any(|drive| depends(drive.speed)) {
            return Err(PrepareError::UncertainDrive { path: path.clone() });
        }
    }
    Ok(())
}

/// That the file of the model is at fault.
fn refused(model: &SpatialModel, values: &Values, error: &SamplingError) -> PrepareError {
    PrepareError::InSpace { found: Box::new(model.not_sampled(values, error)) }
}

fn failure(error: SamplingError) -> RunFailure {
    let hint = match &error {
        SamplingError::AtRest { .. } => "use component = \"magnitude\", or x, y and z",
        SamplingError::CoarseTurn { .. } => "take more samples_per_turn",
        SamplingError::DriveElsewhere { .. } => {
            "remove what changes this drive from the uncertain inputs; where the cycle counts the turns of a single drive, its speed may be \
             uncertain"
        }
        SamplingError::CannotBeAssembled { .. } => {
            "give the joints more play, or let lengths, tilts and shifts scatter less; most_failed under [sampling] says how many runs may fail"
        }
        SamplingError::DeadCentre { .. } => "take less play, or links that stay farther from the dead centre",
        SamplingError::NoAnswer { why: AccuracyError::OutputIsFree, .. } => {
            "`loosepin check` says which freedoms are left without a drive"
        }
        _ => "the values differ too much from those of the model, or they do not fit together",
    };
    let why = error.to_string();
    // What differs in kind is counted by itself.
    match error {
        SamplingError::CannotBeAssembled { .. } => RunFailure::CannotBePutTogether { why, hint },
        SamplingError::DeadCentre { .. } => RunFailure::DeadCentre { why, hint },
        _ => RunFailure::NoPosition { why, hint },
    }
}

#[cfg(test)]
mod tests {
    use super::{SpatialResponse, failure};
    use crate::file::Study;
    use loosepin_space::{SamplingError, SpatialModel};
    use loosepin_text::diagnostics::Problem;
    use std::f64::consts::FRAC_PI_2;

    const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");
    const STUDY: &str = "name = \"s\"\nmodel = \"model.toml\"\n[cycle]\nsamples_per_turn = 4\n[epistemic]\n\
        \"joint.ball.radial_clearance\" = { interval = [\"0.15 mm\", \"0.25 mm\"] }\n[[ask]]\noutput = \"rocker\"\n\
        of = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n";

    #[test]
    fn identity_all_places_of_the_journals_are_read_off_one_closing() {
        let model = SpatialModel::from_text("model.toml", FOUR_BAR).unwrap();
        let study = Study::from_text("study.toml", STUDY, model.clone()).unwrap();
        let own = SpatialResponse::new(&study, &model).unwrap();
        let anew = SpatialResponse { recent: None, ..SpatialResponse::new(&study, &model).unwrap() };
        let bits = |of: &SpatialResponse, clearance_m: f64, play: f64| {
            let row = of.row(&[], &[clearance_m, play]).unwrap();
            row.into_iter().map(f64::to_bits).collect::<Vec<_>>()
        };
        for clearance_m in [2e-4, 2.4e-4] {
            let rows =
                [0.0, -1.0, 1.0, 0.3].map(|play| (bits(&own, clearance_m, play), bits(&anew, clearance_m, play)));
            assert!(rows.iter().all(|(own, anew)| own == anew));
            assert_ne!(rows[1], rows[2]);
        }
        assert_eq!(own.recent.as_ref().map(|recent| recent.len()), Some(2));
    }

    #[test]
    fn each_failure_has_a_hint_of_its_own_and_units() {
        let turn = 0.25;
        let (nominal_si, found_si) = (FRAC_PI_2, 91_f64.to_radians());
        let elsewhere =
            SamplingError::DriveElsewhere { drive: "crank".to_owned(), turn, nominal_si, found_si, is_length: false };
        let all = [
            elsewhere,
            SamplingError::AtRest { output: "tip".to_owned(), turn },
            SamplingError::CoarseTurn { output: "rocker".to_owned() },
            SamplingError::BadTurns,
        ];
        let all = all.map(failure);
        assert!(
            all[0].to_string().starts_with("drive 'crank' at 0.25 turns: it is at 91 deg and nominally at 90 deg;"),
            "{}",
            all[0]
        );
        let hints: std::collections::HashSet<_> = all.iter().map(Problem::hint).collect();
        assert_eq!(hints.len(), all.len(), "{hints:?}");
    }
}
