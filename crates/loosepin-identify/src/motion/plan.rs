//! Information in features, before anything is measured.

use super::grid::{Axis, Grid, place};
use super::invert::{MotionRig, MotionValues};
use super::run_cache::ProgressCallback;
use super::unknowns::name;
use crate::error::IdentifyProblem;
use crate::identify::{known_specimen, refuse_lean};
use loosepin_math::sort_by_number;
use loosepin_result::motion_identification::{IndistinguishableMembers, MotionPlan, PlannedFeature, PlannedUnknown};
use loosepin_study::{Deviation, MeasuredMotion, MotionError, MotionSubject, OutputSource, Reduction, Study};
use loosepin_text::diagnostics::{Diagnostics, Place};
use loosepin_text::units::SiUnit;
use loosepin_uncertainty::{hash, uniform};

/// Measurements that are imagined at each value of the unknowns.
const IMAGINED: usize = 4;
/// Common error of a feature that the study does not name.
const USUAL_ERROR: MotionError = MotionError { size: 0.05, is_share: true };
/// Stream of the common errors of imagined measurements.
const ERRORS: u64 = 0x706c_616e;
/// Share of measurements in which a wrong member of a list is recognised, below which the two count as not distinguishable.
const TOLD: f64 = 0.95;

/// The features of a study, or of one of its specimens, or where it names none the largest magnitude and the rms of each output and the impacts of each joint,
/// with 5 % error.
fn candidates(study: &Study, specimen: Option<&str>) -> Vec<MeasuredMotion> {
    if !study.motion.is_empty() {
        let is_asked =
            |feature: &&MeasuredMotion| specimen.is_none_or(|wanted| feature.specimen.as_deref() == Some(wanted));
        let asked: Vec<MeasuredMotion> = study.motion.iter().filter(is_asked).cloned().collect();
        if !asked.is_empty() {
            return asked;
        }
    }
    let feature = |name: String, of: &str, subject: MotionSubject, unit: SiUnit| MeasuredMotion {
        name,
        specimen: None,
        instrument: of.to_owned(),
        subject,
        unit,
        values_si: Vec::new(),
        repeats: 1,
        error: USUAL_ERROR,
        scatter: MotionError { size: 0.0, is_share: false },
        place: Place::new(study.source(), 0..0),
    };
    let mut all = Vec::new();
    for (output, known) in study.outputs.iter().enumerate() {
        if !matches!(known.seen, OutputSource::Reading(_)) {
            continue;
        }
        for reduction in [Reduction::MaximumAbsolute, Reduction::RootMeanSquare] {
            let subject = MotionSubject::Located { output, deviation: Deviation::of_value(), reduction };
            let words = format!("{}, {}", known.name, reduction.word().replace('_', " "));
            all.push(feature(words, &known.name, subject, known.unit.clone()));
        }
    }
    for (play, joint) in study.model.play_names().iter().enumerate() {
        all.push(feature(format!("{joint}, impacts"), joint, MotionSubject::Impacts { play }, SiUnit::NONE));
    }
    all
}

/// Expected remaining share of the box by each feature of `study` alone, and by all together: the mean over imagined measurements at values
/// spread evenly over it. Of `specimen` alone, where one is named; how many values are tried does not depend on `asked`. `heard` hears of
/// values that have their runs.
///
/// # Errors
/// As of an identification.
pub fn plan_motion(
    study: &Study,
    specimen: Option<&str>,
    asked: &MotionValues,
    heard: ProgressCallback<'_>,
) -> Result<MotionPlan, Diagnostics> {
    refuse_lean(study)?;
    if let Some(wanted) = specimen {
        known_specimen(study, wanted)?;
    }
    let candidates = candidates(study, specimen);
    let features: Vec<&MeasuredMotion> = candidates.iter().collect();
    let mut rig = MotionRig::new(study, &features, asked, IMAGINED)?;
    let axes = rig.axes.clone();
    let counts = Grid::counts_at_start(&axes);
    let cells: usize = counts.iter().product();
    let grid = Grid::untested(&axes, counts.clone());
    let points: Vec<Vec<f64>> = (0..cells).map(|cell| rig.values(&grid.middle(cell))).collect();
    rig.bank.tell(heard, 0, cells);
    let all = rig.runs_at(&points)?;
    let counted = all.first().map_or(0, |runs| runs.len()) - IMAGINED;
    let has_failed = |run: &[f64]| run.iter().any(|value| !value.is_finite());
    let imagined = || all.iter().flat_map(|runs| &runs[counted..]);
    let failed = imagined().filter(|run| has_failed(run)).count();
    if failed == imagined().count() {
        return Err(Diagnostics::one(&IdentifyProblem::NothingImagined { runs: failed }, None));
    }
    // Whether each value is kept, by the true value, the measurement, and the value.
    let kept_by = |places: &[usize]| -> Vec<(usize, Vec<bool>)> {
        let mut kept = Vec::new();
        for (truth, runs) in all.iter().enumerate() {
            for imagined in 0..IMAGINED {
                let run = &runs[counted + imagined];
                // A measurement that cannot be imagined is counted, and said.
                if has_failed(run) {
                    continue;
                }
                let mut seen = rig.observation(run.clone());
                let key = hash(hash(study.seed, ERRORS), (truth * IMAGINED + imagined) as u64);
                for (place, value) in seen.values_si.iter_mut().enumerate() {
                    let share = 2.0 * uniform(key, seen.instruments[place] as u64) - 1.0;
                    let error = seen.errors[place];
                    *value =
                        if error.is_share { *value * (1.0 + share * error.size) } else { *value + share * error.size };
                }
                let verdict = |runs: &super::run_cache::Runs| rig.test(&runs[..counted], places, &seen).is_consistent;
                kept.push((truth, all.iter().map(verdict).collect()));
            }
        }
        kept
    };
    let left = |name: String, kept: &[(usize, Vec<bool>)]| {
        let count = kept.len().max(1) as f64;
        let width = |unknown: usize| {
            let of = |(_, kept): &(usize, Vec<bool>)| {
                let along = |cell: usize| place(&counts, cell)[unknown];
                let mut hit: Vec<usize> = (0..cells).filter(|cell| kept[*cell]).map(along).collect();
                hit.sort_unstable();
                hit.dedup();
                let held = match (axes[unknown], hit.first(), hit.last()) {
                    (Axis::Continuous, Some(first), Some(last)) => last - first + 1,
                    _ => hit.len(),
                };
                held as f64 / counts[unknown] as f64
            };
            kept.iter().map(of).sum::<f64>() / count
        };
        let share =
            |(_, kept): &(usize, Vec<bool>)| kept.iter().filter(|is_kept| **is_kept).count() as f64 / cells as f64;
        PlannedFeature {
            name,
            share_of_box: kept.iter().map(share).sum::<f64>() / count,
            shares_of_width: (0..axes.len()).map(width).collect(),
        }
    };
    let mut planned: Vec<PlannedFeature> =
        features.iter().enumerate().map(|(k, feature)| left(feature.name.clone(), &kept_by(&[k]))).collect();
    sort_by_number(&mut planned, |a| a.share_of_box);
    let everything = kept_by(&(0..features.len()).collect::<Vec<usize>>());
    let mut alike = Vec::new();
    for (unknown, axis) in axes.iter().enumerate() {
        let Axis::Members(members) = axis else { continue };
        for truth in 0..*members {
            for other in (0..*members).filter(|other| *other != truth) {
                let along = |cell: usize| place(&counts, cell)[unknown];
                let own: Vec<&(usize, Vec<bool>)> =
                    everything.iter().filter(|(cell, _)| along(*cell) == truth).collect();
                let is_told =
                    |(_, kept): &&&(usize, Vec<bool>)| !(0..cells).any(|cell| kept[cell] && along(cell) == other);
                let told = own.iter().filter(is_told).count() as f64 / own.len().max(1) as f64;
                if told < TOLD {
                    let written = |member: usize| {
                        let input = &study.epistemic[unknown];
                        input.written(&study.model, super::unknowns::value(input, member as f64))
                    };
                    alike.push(IndistinguishableMembers { unknown, members: [written(truth), written(other)], told });
                }
            }
        }
    }
    let unknowns = study.epistemic.iter().zip(&axes).map(|(input, axis)| PlannedUnknown {
        path: input.path.clone(),
        name: name(&input.path),
        is_list: matches!(axis, Axis::Members(_)),
    });
    Ok(MotionPlan {
        study: study.name.clone(),
        unknowns: unknowns.collect(),
        features: planned,
        together: left("all together".to_owned(), &everything),
        not_distinguishable: alike,
        points: cells,
        imagined: imagined().count(),
        failed,
        runs_per_point: counted,
    })
}
