//! Contributors to the answers.

use super::plan::{ContributorPlan, groups};
use super::subjects::Subject;
use super::without_dynamics::{Effects, WithoutDynamics};
use crate::assemble::Material;
use crate::file::{EpistemicInput, Study};
use loosepin_bounds::{DoubleLoop, Pinching};
use loosepin_math::sort_by_number;
use loosepin_result::study::{Contributors, EpistemicContributor, RandomContributor, ResponsePoint, ShareRange};
use loosepin_uncertainty::contributors::{Index, Indices, SHARES_CONFIDENCE};

/// The contributors to `subjects`.
pub fn contributors(
    material: &Material<'_>,
    double_loop: &DoubleLoop,
    plan: Option<&ContributorPlan>,
    subjects: &[Subject],
) -> Vec<Contributors> {
    let without_dynamics = WithoutDynamics::new(material, subjects);
    let of = |subject: &Subject| {
        let effects = without_dynamics.effects(material, subject);
        of_subject(material, double_loop, plan, subject, effects.as_ref())
    };
    subjects.iter().map(of).collect()
}

fn of_subject(
    material: &Material<'_>,
    double_loop: &DoubleLoop,
    plan: Option<&ContributorPlan>,
    subject: &Subject,
    effects: Option<&Effects<'_>>,
) -> Contributors {
    let study = material.study;
    let Subject { deviation, columns, is_curve } = subject;
    let deviation = *deviation;
    let indices = plan.map(|plan| plan.indices(material.table, columns)).unwrap_or_default();
    let pinching = double_loop.pinching(material.table, columns).ok().flatten();
    let at = if *is_curve { ResponsePoint::Whole } else { material.point_of(columns[0], false) };
    let output = material.name_of(columns[0]);
    let is_all = effects.is_some_and(|effects| effects.without_scatter.is_some());
    let scatter = |p: &Pinching| effects.and_then(|own| own.scatter(columns, p)).unwrap_or(p.scatter);
    let share_of_scatter = pinching.as_ref().map_or(f64::NAN, |p| (scatter(p) / p.width).clamp(0.0, 1.0));
    let groups = groups(study);
    let mut random: Vec<RandomContributor> = groups
        .iter()
        .enumerate()
        .map(|(group, members)| {
            let mut paths: Vec<String> =
                members.iter().map(|&input| study.random[input].whole_path().to_owned()).collect();
            paths.dedup();
            let total = range(&indices, |indices| indices.total[group]);
            let shares = effects
                // Shares of a variance add up to 1 only where the inputs are independent.
                .filter(|_| !deviation.is_by_play_alone() && study.correlation.is_none())
                .and_then(|effects| paths.iter().map(|path| effects.variance_share(path)).sum::<Option<f64>>());
            // Without indices, by the linear share. What does not enter the ideal motion, such as a mass, has an effect that only runs show.
            let linear = shares.filter(|share| *share > 0.0 || is_all).unwrap_or(f64::NAN);
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
    sort_by_number(&mut random, |a| -a.band_share);
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
                quasi_static_share: effects
                    .filter(|_| deviation.has_play())
                    .and_then(|effects| effects.play_share(&play_from(study, input))),
                can_be_measured: input.can_be_measured(),
            }
        })
        .collect();
    epistemic
        .sort_by(|a, b| b.can_be_measured.cmp(&a.can_be_measured).then(b.band_share[1].total_cmp(&a.band_share[1])));
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

/// Names of the joints and couplings whose play an input decides.
fn play_from(study: &Study, input: &EpistemicInput) -> Vec<String> {
    let plays = input.quantity().into_iter().flat_map(|id| study.model.play_from(id));
    plays.map(|play| play.name).collect()
}
