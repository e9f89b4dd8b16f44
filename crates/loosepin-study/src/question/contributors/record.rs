//! Contributors to the answers.

use super::plan::{ContributorPlan, groups};
use crate::assemble::Material;
use crate::file::{Ask, Deviation, EpistemicInput, Reduction, Study, Where};
use crate::response::columns::{ColumnPlan, Location, StudyColumn};
use crate::response::outputs::OutputSource;
use loosepin_bounds::{DoubleLoop, Pinching};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_result::study::{
    Contributors, EpistemicContributor, PathError, RandomContributor, ResponsePoint, ShareRange,
};
use loosepin_simulate::accuracy::{MotionPlan, Scatter, motion};
use loosepin_uncertainty::contributors::{Index, Indices, SHARES_CONFIDENCE};

/// Positions of the quasi-static answer in a turn.
const POSITIONS: usize = 72;
/// Angles nearer to each other are one.
const SAME_ANGLE_RAD: f64 = 1e-9;

/// Columns whose contributors are stated together.
struct Subject<'a> {
    deviation: Deviation,
    /// One number of a run, or all poses of a curve.
    columns: &'a [usize],
    is_curve: bool,
}

/// The contributors to every question that asks for them; where none does, to the first number of each output.
pub fn contributors(
    material: &Material<'_>,
    double_loop: &DoubleLoop,
    plan: Option<&ContributorPlan>,
) -> Vec<Contributors> {
    let asks = &material.response.plan().asks;
    let is_asked = asks.iter().any(Ask::is_for_contributors);
    let first = if is_asked { Vec::new() } else { first_numbers(material.response.plan()) };
    let of_first = first.iter().map(|(deviation, column)| Subject {
        deviation: *deviation,
        columns: std::slice::from_ref(column),
        is_curve: false,
    });
    let subjects: Vec<Subject<'_>> =
        asks.iter().filter(|ask| ask.is_for_contributors()).flat_map(asked).chain(of_first).collect();
    let quasi_static = if subjects.is_empty() { None } else { quasi_static(material) };
    subjects.iter().map(|subject| of_columns(material, double_loop, plan, subject, quasi_static.as_ref())).collect()
}

/// What an ask is about: a curve as a whole, poses one by one.
fn asked(ask: &Ask) -> Vec<Subject<'_>> {
    let is_curve = ask.location == Where::Cycle;
    let parts: Vec<&[usize]> = if is_curve { vec![&ask.columns[..]] } else { ask.columns.chunks(1).collect() };
    parts.into_iter().map(|columns| Subject { deviation: ask.deviation, columns, is_curve }).collect()
}

/// A number for each output, of the first deviation that is asked of it: the largest over the cycle where there is one, which answers
/// for a curve, else the first that is asked.
fn first_numbers(plan: &ColumnPlan) -> Vec<(Deviation, usize)> {
    let mut outputs: Vec<usize> = Vec::new();
    let mut numbers = Vec::new();
    for ask in &plan.asks {
        if outputs.contains(&ask.output) {
            continue;
        }
        outputs.push(ask.output);
        let is_largest = |column: &StudyColumn| {
            (column.output, column.deviation) == (ask.output, ask.deviation)
                && matches!(column.spot, Location::Reduced(Reduction::MaximumAbsolute))
        };
        let largest = plan.columns.iter().position(is_largest);
        numbers.extend(largest.or(ask.columns.first().copied()).map(|column| (ask.deviation, column)));
    }
    numbers
}

fn of_columns(
    material: &Material<'_>,
    double_loop: &DoubleLoop,
    plan: Option<&ContributorPlan>,
    subject: &Subject<'_>,
    quasi_static: Option<&MotionRecord>,
) -> Contributors {
    let study = material.study;
    let &Subject { deviation, columns, is_curve } = subject;
    let indices = plan.map(|plan| plan.indices(material.table, columns)).unwrap_or_default();
    let pinching = double_loop.pinching(material.table, columns).ok().flatten();
    let at = if is_curve { ResponsePoint::Whole } else { material.point_of(columns[0], false) };
    let output = material.name_of(columns[0]);
    let plan_of_columns = material.response.plan();
    // To first order the distance from the path is the error across it.
    let asked = &plan_of_columns.outputs[plan_of_columns.columns[columns[0]].output];
    let still_name = match asked.seen {
        OutputSource::Path(_, PathError::Contour) => {
            let names = study.model.output_names();
            let path = names.get(asked.output).copied().unwrap_or_default();
            format!("{path} {}", PathError::Normal.word())
        }
        _ => output.clone(),
    };
    let still = quasi_static.and_then(|record| {
        Some(Still {
            record,
            output: record.outputs.iter().find(|own| own.name == still_name)?,
            spot: spot(material, subject),
        })
    });
    let share_of_scatter = pinching.as_ref().map_or(f64::NAN, |p| (p.scatter / p.width).clamp(0.0, 1.0));
    let groups = groups(study);
    let mut random: Vec<RandomContributor> = groups
        .iter()
        .enumerate()
        .map(|(group, members)| {
            let mut paths: Vec<String> =
                members.iter().map(|&input| study.random[input].whole_path().to_owned()).collect();
            paths.dedup();
            let total = range(&indices, |indices| indices.total[group]);
            let shares = still
                .as_ref()
                // Shares of a variance add up to 1 only where the inputs are independent.
                .filter(|_| deviation != Deviation::Clearance && study.correlation.is_none())
                .and_then(|still| paths.iter().map(|path| still.variance_share(path)).sum::<Option<f64>>());
            // Without indices, by the linear share. What does not enter the ideal motion, such as a mass, has an effect that only runs show.
            let linear = shares.filter(|share| *share > 0.0).unwrap_or(f64::NAN);
            let share = if total.centre.is_nan() { linear } else { total.centre };
            RandomContributor {
                paths,
                first: range(&indices, |indices| indices.first[group]),
                total,
                band_share: share_of_scatter * (1.0 - (1.0 - share).clamp(0.0, 1.0).sqrt()),
                quasi_static_share: shares,
            }
        })
        .collect();
    random.sort_by(|a, b| b.band_share.total_cmp(&a.band_share));
    let mut epistemic: Vec<EpistemicContributor> = study
        .epistemic
        .iter()
        .enumerate()
        .map(|(index, input)| {
            let (band_share, error) = pinching.as_ref().map_or(([f64::NAN; 2], f64::NAN), |p| gone(p, index));
            EpistemicContributor {
                path: input.path.clone(),
                band_share,
                error,
                quasi_static_share: still
                    .as_ref()
                    .filter(|_| deviation != Deviation::Dimensional)
                    .and_then(|still| still.play_share(&play_from(study, input))),
            }
        })
        .collect();
    epistemic.sort_by(|a, b| b.band_share[1].total_cmp(&a.band_share[1]));
    let per_pose = 1.0 / columns.len() as f64;
    Contributors {
        output,
        of: deviation,
        at,
        unit: material.unit_of(columns[0]),
        band_width_si: pinching.as_ref().map_or(f64::NAN, |p| per_pose * p.width),
        band_width_error_si: pinching.as_ref().map_or(f64::NAN, |p| per_pose * p.width_error),
        points: plan.map(|plan| plan.points.iter().map(|u| material.witness(u)).collect()).unwrap_or_default(),
        pairs: plan.map_or(0, |plan| (plan.indices.runs() / (2 + groups.len())) as u64),
        left_out: indices.iter().flatten().map(|indices| indices.left_out as u64).sum(),
        confidence: SHARES_CONFIDENCE,
        random,
        epistemic,
    }
}

/// A share at the middle and over all points that have one.
fn range(indices: &[Option<Indices>], of: impl Fn(&Indices) -> Index) -> ShareRange {
    let centre = indices.first().and_then(Option::as_ref).map(&of);
    let (mut lower, mut upper) = (f64::NAN, f64::NAN);
    for index in indices.iter().flatten().map(&of) {
        lower = lower.min((index.value - index.error).clamp(0.0, 1.0));
        upper = upper.max((index.value + index.error).clamp(0.0, 1.0));
    }
    let (centre, error) = centre.map_or((f64::NAN, f64::NAN), |index| (index.value, index.error));
    ShareRange { centre, error, lower, upper }
}

/// The least and the largest share of the band that goes where input `index` is known, and their error.
fn gone(pinching: &Pinching, index: usize) -> ([f64; 2], f64) {
    let input = &pinching.inputs[index];
    let share = |remaining: f64| (1.0 - remaining / pinching.width).clamp(0.0, 1.0);
    let error = (input.error + pinching.width_error) / pinching.width;
    ([share(input.remaining[1]), share(input.remaining[0])], error.min(1.0))
}

/// The quasi-static answer with the epistemic inputs in the middle; `None` if the mechanism has none.
fn quasi_static(material: &Material<'_>) -> Option<MotionRecord> {
    let study = material.study;
    let scatter = study
        .random
        .iter()
        .filter_map(|input| {
            let standard_deviation_si = input.variable.standard_deviation();
            Some(Scatter { quantity: input.quantity()?, standard_deviation_si })
        })
        .collect();
    let plan = MotionPlan {
        span: study.cycle.span,
        positions: POSITIONS,
        scatter,
        correlations: study.linear_correlations(),
        paths: Vec::new(),
        overrides: Vec::new(),
    };
    motion(material.response.planar()?.mechanism(), material.response.nominal(), &plan).ok()
}

/// Names of the joints and couplings whose play an input decides.
fn play_from(study: &Study, input: &EpistemicInput) -> Vec<String> {
    let plays = input.quantity().into_iter().flat_map(|id| study.model.play_from(id));
    plays.map(|play| play.name).collect()
}

/// The pose of a question at a single one.
fn spot(material: &Material<'_>, subject: &Subject<'_>) -> Option<f64> {
    match material.response.plan().columns[subject.columns[0]].spot {
        Location::Pose { angle_rad, .. } if !subject.is_curve => Some(angle_rad),
        _ => None,
    }
}

/// The quasi-static answer for one output: at one pose, or added over the turn.
struct Still<'a> {
    record: &'a MotionRecord,
    output: &'a OutputMotion,
    spot: Option<f64>,
}

impl Still<'_> {
    /// The sum over the positions that count.
    fn sum(&self, values: &[f64], of: impl Fn(f64) -> f64) -> f64 {
        let turn = |angle: f64| (angle / std::f64::consts::TAU).rem_euclid(1.0);
        match self.spot {
            None => values.iter().take(self.positions()).map(|&value| of(value)).sum(),
            Some(angle_rad) => {
                let distance = |at: f64| {
                    let apart = (turn(at) - turn(angle_rad)).abs();
                    apart.min(1.0 - apart)
                };
                let near = |a: &(usize, &f64), b: &(usize, &f64)| distance(*a.1).total_cmp(&distance(*b.1));
                let nearest = self.record.drive_angle_rad.iter().enumerate().min_by(near);
                nearest.and_then(|(position, _)| values.get(position)).map_or(f64::NAN, |&value| of(value))
            }
        }
    }

    /// Positions that count: the last one of a whole turn is the first one again.
    fn positions(&self) -> usize {
        let angles_rad = &self.record.drive_angle_rad;
        let (Some(first), Some(last)) = (angles_rad.first(), angles_rad.last()) else { return 0 };
        let is_turn = ((last - first).abs() - std::f64::consts::TAU).abs() < SAME_ANGLE_RAD;
        angles_rad.len() - usize::from(is_turn)
    }

    /// The share of a scattering quantity in the variance.
    fn variance_share(&self, path: &str) -> Option<f64> {
        let all = &self.output.dimensional_contributors;
        let square = |values: &[f64]| self.sum(values, |value| value * value);
        let own = all.iter().find(|dimension| dimension.path == path).map_or(0.0, |d| square(&d.standard_deviation_si));
        let total: f64 = all.iter().map(|dimension| square(&dimension.standard_deviation_si)).sum();
        (total > 0.0).then(|| own / total)
    }

    /// The share of `joints` in the first-order effect of all; `None` if there are none.
    fn play_share(&self, joints: &[String]) -> Option<f64> {
        let all = &self.output.clearance.contributors;
        let own: Vec<f64> = all
            .iter()
            .filter(|known| joints.contains(&known.joint))
            .map(|own| self.sum(&own.first_order_si, |value| value))
            .collect();
        let total = self.sum(&self.output.clearance.first_order_si, |value| value);
        (total > 0.0 && !own.is_empty()).then(|| own.iter().sum::<f64>() / total)
    }
}
