//! From the runs and bounds of a study to its result: names, units, curves, boxes, pictures.

mod curves;
mod describe;
mod drawing;
mod failures;
mod requirements;
mod runs_table;
mod summary;
mod treatments;

pub(super) use describe::unit;
pub(super) use failures::failures;
pub(super) use requirements::requirements;
pub use runs_table::{curve_name, runs_table, scalar_name};
pub(super) use treatments::learned_treatments;

use super::columns::{ColumnPlan, Spot, StudyColumn};
use super::file::{EpistemicInput, Reduction, Study, Where};
use super::rare::{self, Rare};
use super::response::StudyResponse;
use super::simultaneous::CurveBand;
use loosepin_bounds::{Bound, BoundPair, Bounds, Percentile, SampleTable};
use loosepin_result::study::{
    AccuracyRecord, AllocationRecord, AllowanceRecord, BoundEnd, BoundRecord, Contributors, CutBounds, FORMAT,
    Guarantee, NumericalError, PercentileBounds, ProbabilityBox, Purpose, RareEnd, RareRecord, ResponsePoint,
    Statistic, StudyResult, SurrogateRecord, Treatment, TreatmentComparison, Witness, WitnessValue,
};
use loosepin_text::units::{DisplayUnits, SiUnit};

/// Everything that a result is made from.
pub(super) struct Material<'m> {
    pub study: &'m Study,
    pub response: &'m StudyResponse,
    pub table: &'m SampleTable,
    pub bounds: &'m Bounds,
    /// Those that are looked at: what is possible at all, or to some degree.
    pub pairs: &'m [BoundPair],
    pub rare: &'m [Rare],
}

/// What is not made from the runs of the double loop.
pub(super) struct Extra {
    pub accuracy: Option<AccuracyRecord>,
    pub contributors: Vec<Contributors>,
    pub allowances: Vec<AllowanceRecord>,
    pub allocation: Option<AllocationRecord>,
    pub surrogate: Option<SurrogateRecord>,
    /// The treatments by a surrogate that stands alone.
    pub treatments: Option<Vec<TreatmentComparison>>,
    pub curve_bands: Vec<CurveBand>,
    /// Bounds by the other readings of intervals.
    pub beside: Vec<Bounds>,
}

/// Puts the result together.
pub(super) fn assemble(material: &Material<'_>, input_hash: &str, extra: Extra) -> StudyResult {
    let study = material.study;
    let pictures = drawing::pictures(material);
    let bounds = all_bounds(material, &extra);
    StudyResult {
        format: FORMAT,
        name: study.name.clone(),
        model: study.model.name.clone(),
        version: loosepin_text::VERSION.to_owned(),
        input_hash: input_hash.to_owned(),
        seed: study.seed,
        inputs: describe::inputs(study),
        correlations: describe::correlations(study),
        cycle: describe::cycle(material),
        outputs: describe::outputs(material),
        counts: summary::counts(material),
        accuracy: extra.accuracy,
        failures: failures(material.study, material.response, material.table),
        settled_share: summary::settled_share(material),
        requirements: requirements(material),
        allowances: extra.allowances,
        allocation: extra.allocation,
        bounds,
        cuts: cuts(material),
        percentiles: percentiles(material),
        rare: rare_records(material),
        surrogate: extra.surrogate,
        contributors: extra.contributors,
        treatments: extra.treatments.unwrap_or_else(|| treatments::treatments(material)),
        energy: summary::energy(material),
        impacts: summary::impacts(material),
        display_units: material.study.model.shown_in(DisplayUnits::default()),
        curves: curves::curves(material, &pictures, &extra.curve_bands),
        boxes: boxes(material),
        orbits: pictures.orbits,
        drawing: pictures.drawing,
    }
}

impl Material<'_> {
    fn plan(&self) -> &ColumnPlan {
        &self.response.shared.plan
    }

    /// The epistemic inputs by path.
    pub fn witness(&self, epistemic: &[f64]) -> Witness {
        // A percentile is attained at no single value of the parameters that it is taken over.
        let named = self.study.epistemic.iter().zip(epistemic).filter(|(_, value)| !value.is_nan());
        let shown = |input: &EpistemicInput, value: f64| match input.law(value) {
            Some(law) => WitnessValue::Choice(law.name().to_owned()),
            None => WitnessValue::Number(value),
        };
        named.map(|(input, &value)| (input.path.clone(), shown(input, value))).collect()
    }

    fn end(&self, bound: &Bound) -> BoundEnd {
        BoundEnd {
            value_si: bound.value,
            widened_si: bound.widened,
            witness: bound.witness.as_ref().map(|w| self.witness(&w.epistemic)).unwrap_or_default(),
            error: numerical_error(bound),
        }
    }

    /// The bounds of `statistic` of `column`.
    fn pair(&self, column: usize, statistic: Statistic) -> Option<&BoundPair> {
        self.pairs.iter().find(|pair| pair.column == column && pair.statistic == statistic)
    }

    /// Both ends of the bounds of `statistic` of `column`, narrowed by what is known of the largest deviation of the whole
    /// recorded part: no pose departs further, so |E d| <= E max|d| and the quantiles of d lie within those of ± max|d|. Those of
    /// magnitudes are not negative.
    pub fn ends(&self, column: usize, statistic: Statistic) -> Option<[BoundEnd; 2]> {
        let pair = self.pair(column, statistic)?;
        let (mut lower, mut upper) = (self.end(&pair.lower), self.end(&pair.upper));
        let planned = self.plan().columns[column];
        let largest = StudyColumn { spot: Spot::Reduced(Reduction::MaximumAbsolute), ..planned };
        let largest = self.plan().columns.iter().position(|known| *known == largest);
        if let (Some(largest), Spot::Pose { .. }) = (largest, planned.spot) {
            let most = |statistic| self.pair(largest, statistic).map(|pair| pair.upper.widened);
            match statistic {
                Statistic::Mean => {
                    if let Some(most) = most(Statistic::Mean) {
                        narrow(&mut lower, -most);
                        narrow(&mut upper, most);
                    }
                }
                Statistic::Quantile(probability) => {
                    if let Some(most) = most(Statistic::Quantile(probability)) {
                        narrow(&mut upper, most);
                    }
                    if let Some(most) = most(Statistic::Quantile(1.0 - probability)) {
                        narrow(&mut lower, -most);
                    }
                }
                _ => {}
            }
        }
        let is_magnitude = matches!(statistic, Statistic::Mean | Statistic::Quantile(_));
        if is_magnitude && self.is_never_negative(column) && lower.widened_si < 0.0 {
            lower.value_si = lower.value_si.max(0.0);
            set_widened(&mut lower, 0.0);
        }
        Some([lower, upper])
    }

    /// `value_si` of a column, or 0 where it is negative and the column is a magnitude.
    pub fn possible(&self, column: usize, value_si: f64) -> f64 {
        if value_si < 0.0 && self.is_never_negative(column) { 0.0 } else { value_si }
    }

    /// Whether the numbers of a column are magnitudes.
    fn is_never_negative(&self, column: usize) -> bool {
        matches!(self.plan().columns[column].spot, Spot::Reduced(reduction) if reduction.is_never_negative())
    }

    pub fn unit_of(&self, column: usize) -> SiUnit {
        self.plan().outputs[self.plan().columns[column].output].unit.clone()
    }

    pub fn name_of(&self, column: usize) -> String {
        self.plan().outputs[self.plan().columns[column].output].name.clone()
    }

    /// Where a column is taken; `in_curve` tells that it is a point of a curve.
    pub fn point_of(&self, column: usize, in_curve: bool) -> ResponsePoint {
        match self.plan().columns[column].spot {
            Spot::Pose { angle_rad: pose_rad, .. } => {
                if in_curve {
                    ResponsePoint::Curve { pose_rad }
                } else {
                    ResponsePoint::Pose { pose_rad }
                }
            }
            Spot::Reduced(reduction) => ResponsePoint::Reduced { reduction },
        }
    }
}

/// Moves the widened end of a bound back to `limit` where it lies beyond.
fn narrow(end: &mut BoundEnd, limit_si: f64) {
    let outward = if end.widened_si >= end.value_si { 1.0 } else { -1.0 };
    if outward * (end.widened_si - limit_si) > 0.0 && outward * (limit_si - end.value_si) >= 0.0 {
        set_widened(end, limit_si);
    }
}

/// Moves the widened end of a bound to `limit`, and makes its error what is left between them.
fn set_widened(end: &mut BoundEnd, limit_si: f64) {
    let room = (limit_si - end.value_si).abs();
    end.widened_si = limit_si;
    end.error.sampling_si = end.error.sampling_si.min(room);
    end.error.surrogate_si = end.error.surrogate_si.min(room - end.error.sampling_si);
    end.error.optimisation_si = room - end.error.sampling_si - end.error.surrogate_si;
}

/// Angle that the drive turned through before the recorded part in whole turns, rad: poses are shown without it.
pub(super) fn recorded_offset_rad(study: &Study, response: &StudyResponse) -> f64 {
    let sign = study.model.input(study.cycle.span, &response.nominal).speed_rad_s.signum();
    sign * std::f64::consts::TAU * study.cycle.transient_turns.floor()
}

/// The bounds at every degree of possibility.
fn cuts(material: &Material<'_>) -> Vec<CutBounds> {
    let of_level = |level: &loosepin_bounds::LevelBounds| {
        let &Material { study, response, table, bounds, .. } = material;
        // What was estimated for all that is possible says nothing of a degree: there the runs are counted.
        let bounds = asked_bounds(&Material { study, response, table, bounds, pairs: &level.pairs, rare: &[] });
        Some(CutBounds { alpha: level.alpha?, bounds })
    };
    material.bounds.levels.iter().filter_map(of_level).collect()
}

/// The percentiles of every statistic that was asked for.
fn percentiles(material: &Material<'_>) -> Vec<PercentileBounds> {
    let found = &material.bounds.percentiles;
    let probabilities: Vec<f64> =
        found.first().map_or_else(Vec::new, |first| first.percentiles.iter().map(|each| each.probability).collect());
    let of_percentile = |(place, &percentile): (usize, &f64)| {
        let pair = |pair: &BoundPair| {
            let same = found.iter().find(|each| each.column == pair.column && each.statistic == pair.statistic)?;
            let Percentile { lower, upper, .. } = same.percentiles[place].clone();
            Some(BoundPair { lower, upper, ..pair.clone() })
        };
        let pairs: Vec<BoundPair> = material.pairs.iter().filter_map(pair).collect();
        let &Material { study, response, table, bounds, .. } = material;
        let bounds = asked_bounds(&Material { study, response, table, bounds, pairs: &pairs, rare: &[] });
        PercentileBounds { percentile, bounds }
    };
    probabilities.iter().enumerate().map(of_percentile).collect()
}

/// Every bound that was asked for, in the order of the asks; within a curve pose by pose.
pub(super) fn asked_bounds(material: &Material<'_>) -> Vec<BoundRecord> {
    let mut records = Vec::new();
    for planned in &material.plan().asks {
        let in_curve = planned.ask.location == Where::Cycle;
        for &column in &planned.columns {
            for &asked in &planned.ask.statistics {
                let Some(pair) = material.pair(column, asked) else { continue };
                let Some([mut lower, mut upper]) = material.ends(column, asked) else { continue };
                let rare = material.rare.iter().find(|rare| rare.column == column && rare.statistic == asked);
                if let Some(rare) = rare {
                    [lower, upper] = rare.bounds.each_ref().map(|bound| material.end(bound));
                }
                let unit = if asked.is_probability() { SiUnit::NONE } else { material.unit_of(column) };
                records.push(BoundRecord {
                    output: material.name_of(column),
                    of: planned.ask.deviation,
                    at: material.point_of(column, in_curve),
                    statistic: asked,
                    treatment: Treatment::Mixed,
                    reading: material.bounds.reading,
                    unit,
                    lower,
                    upper,
                    guarantee: if rare.is_some_and(|rare| !rare.is_confirmed) {
                        Guarantee::Inner
                    } else {
                        pair.guarantee()
                    },
                });
            }
        }
    }
    records
}

/// Every bound: those asked for, bands for whole curves, then those asked for by each of the other readings.
fn all_bounds(material: &Material<'_>, extra: &Extra) -> Vec<BoundRecord> {
    let mut records = asked_bounds(material);
    records.extend(simultaneous_bounds(material, &extra.curve_bands));
    for bounds in &extra.beside {
        let &Material { study, response, table, .. } = material;
        // What was estimated otherwise than by counting belongs to the first reading.
        records.extend(asked_bounds(&Material { study, response, table, bounds, pairs: &bounds.pairs, rare: &[] }));
    }
    records
}

/// The bands for whole curves, pose by pose.
fn simultaneous_bounds(material: &Material<'_>, bands: &[CurveBand]) -> Vec<BoundRecord> {
    let of_band = |band: &CurveBand| -> Vec<BoundRecord> {
        let Some(found) = &band.found else { return Vec::new() };
        let record = |(place, &column): (usize, &usize)| {
            let [lower, upper] = found.ends(place).map(|bound| material.end(&bound));
            BoundRecord {
                output: material.name_of(column),
                of: material.plan().columns[column].deviation,
                at: material.point_of(column, true),
                statistic: Statistic::SimultaneousBand(band.share),
                treatment: Treatment::Mixed,
                reading: material.bounds.reading,
                unit: material.unit_of(column),
                lower,
                upper,
                guarantee: found.guarantee(),
            }
        };
        band.columns.iter().enumerate().map(record).collect()
    };
    bands.iter().flat_map(of_band).collect()
}

/// The error of a bound, part by part.
fn numerical_error(bound: &Bound) -> NumericalError {
    let error = &bound.error;
    NumericalError { sampling_si: error.sampling, optimisation_si: error.optimisation, surrogate_si: error.surrogate }
}

/// How small probabilities were estimated.
fn rare_records(material: &Material<'_>) -> Vec<RareRecord> {
    let end = |end: &rare::RareEnd| RareEnd {
        method: end.method,
        probability: end.estimate.value,
        standard_error: end.estimate.standard_error,
        reliability_index: end.index,
        runs: end.estimate.runs as u64,
        failed: end.estimate.failed as u64,
    };
    let record = |rare: &Rare| RareRecord {
        output: material.name_of(rare.column),
        of: material.plan().columns[rare.column].deviation,
        at: material.point_of(rare.column, false),
        statistic: rare.statistic,
        lower: end(&rare.ends[0]),
        upper: end(&rare.ends[1]),
    };
    material.rare.iter().map(record).collect()
}

fn boxes(material: &Material<'_>) -> Vec<ProbabilityBox> {
    let asked = |column: usize| {
        material.plan().asks.iter().any(|planned| {
            planned.columns.contains(&column) && planned.ask.statistics.contains(&Statistic::Cdf)
                || planned.ask.location != Where::Cycle && planned.columns.contains(&column)
        })
    };
    material
        .bounds
        .boxes
        .iter()
        .filter(|found| asked(found.column))
        .map(|found| {
            let column = found.column;
            let mut mixture: Vec<f64> = material
                .table
                .inputs()
                .iter()
                .enumerate()
                .filter(|(_, inputs)| inputs.purpose == mixture_purpose(material))
                .map(|(run, _)| material.table.values(run)[column])
                .filter(|value| value.is_finite())
                .collect();
            mixture.sort_by(f64::total_cmp);
            let share_below =
                |value: f64| mixture.partition_point(|&seen| seen <= value) as f64 / mixture.len().max(1) as f64;
            let limits = material.plan().asks.iter().filter(|planned| planned.columns.contains(&column));
            let limit_si = limits.flat_map(|planned| &planned.ask.statistics).find_map(|statistic| match statistic {
                Statistic::ProbabilityAbove(limit)
                | Statistic::ProbabilityBelow(limit)
                | Statistic::ProbabilityBeyond(limit) => Some(*limit),
                _ => None,
            });
            // The search error of a single share is larger where the curve is steep: there it belongs to the size, not to the
            // share.
            let error = |bound: &Bound| bound.error.sampling;
            ProbabilityBox {
                output: material.name_of(column),
                of: material.plan().columns[column].deviation,
                at: material.point_of(column, false),
                unit: material.unit_of(column),
                probability_only: found.values.iter().map(|&value| share_below(value)).collect(),
                value_si: found.values.clone(),
                lower: found.lower.iter().map(|bound| bound.value).collect(),
                upper: found.upper.iter().map(|bound| bound.value).collect(),
                limit_si,
                numerical_error: found.lower.iter().chain(&found.upper).map(error).fold(0.0, f64::max),
            }
        })
        .collect()
}

/// Runs in which everything was random: without epistemic inputs those of the double loop.
fn mixture_purpose(material: &Material<'_>) -> Purpose {
    if material.study.epistemic.is_empty() { Purpose::DoubleLoop } else { Purpose::Mixture }
}
