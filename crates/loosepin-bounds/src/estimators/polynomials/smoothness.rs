//! Whether a response is smooth in the random inputs: then samples get polynomials.

use std::sync::Arc;

use super::inner_basis::{DesignMatrix, InnerBasis};
use super::known_fits::Assessment;
use super::smooth::{ROUND_OFF, Smooth, largest_magnitude};
use crate::estimators::sample::Sample;

/// The polynomials may leave at most this share of the standard deviation of a sample, or of the largest one of any sample.
const MAX_RESIDUAL: f64 = 1e-3;
const MAX_RESIDUAL_OF_ALL: f64 = 1e-6;
/// The degree is chosen at this many points u, by its error of the mean there, with about Student's factor; that of a lower degree must be less
/// than that of the highest by this factor.
const TRIAL_POINTS: usize = 8;
const FACTOR: f64 = 3.5;
const CLEARLY_LESS: f64 = 0.25;
/// Factor of the allowed residual above which lower degrees are not tried.
const HOPELESS: f64 = 100.0;
/// This many degrees are tried.
const TRIED_DEGREES: usize = 4;

/// Gives every sample its polynomials where the response is smooth at all of them and no run failed; else none has any, so that
/// all are estimated in the same way. What neighbours share is fitted once, and shared again. Where it `keeps` them, samples with their
/// polynomials, and all that is worked out of these, are there for the rounds that follow.
pub(crate) fn smooth(basis: &InnerBasis, samples: &mut [&mut Arc<Sample>], keeps: bool) {
    if samples.is_empty() || samples.iter().any(|sample| sample.failed() > 0) {
        return;
    }
    let is_as_before = |point: usize| point > 0 && Arc::ptr_eq(samples[point], samples[point - 1]);
    let deviations: Vec<f64> = samples.iter().map(|sample| sample.sums().deviation()).collect();
    let largest = deviations.iter().fold(0.0_f64, |largest, deviation| largest.max(*deviation));
    let magnitude = samples.iter().fold(0.0_f64, |most, sample| most.max(largest_magnitude(sample.values())));
    // A response that is the same in all runs may still differ in those that were not made.
    if largest <= ROUND_OFF * magnitude {
        return;
    }
    let allowed = |point: usize| (MAX_RESIDUAL * deviations[point]).max(MAX_RESIDUAL_OF_ALL * largest);
    let fitted = |design: &Arc<DesignMatrix>, point: usize| {
        let values = samples[point].values();
        let smooth = Smooth::new(design.clone(), design.fit(values));
        let error = smooth.least_error_of_mean(values, FACTOR);
        (Assessment { largest_residual: smooth.largest_residual(), error }, smooth)
    };
    let assessment =
        |design: &Arc<DesignMatrix>, point: usize| samples[point].fits().assessment(design, || fitted(design, point).0);
    // What they leave, and the error of the mean, relative to what is allowed.
    let shares = |assessment: Assessment, point: usize| {
        // Of a response that does not scatter at all, round-off is left.
        let round_off = ROUND_OFF * largest_magnitude(samples[point].values());
        [assessment.largest_residual, assessment.error]
            .map(|left| (left - round_off).max(0.0) / allowed(point).max(f64::MIN_POSITIVE))
    };
    let step = samples.len().div_ceil(TRIAL_POINTS).max(1);
    let mut chosen: Option<(&Arc<DesignMatrix>, [f64; 2])> = None;
    for design in tried_degrees(basis.designs()) {
        let least_error = chosen.map_or(f64::INFINITY, |(_, [_, error])| CLEARLY_LESS * error);
        let mut most = [0.0_f64; 2];
        for point in (0..samples.len()).step_by(step) {
            if point >= step && Arc::ptr_eq(samples[point], samples[point - step]) {
                continue;
            }
            let own = shares(assessment(design, point), point);
            most = [most[0].max(own[0]), most[1].max(own[1])];
            if most[0] > HOPELESS && chosen.is_none() {
                return;
            }
            if !(most[1] < least_error) {
                break;
            }
        }
        if most[0] <= 1.0 && most[1] < least_error || chosen.is_none() {
            chosen = Some((design, most));
        }
    }
    let Some((design, [residual, _])) = chosen else { return };
    if !(residual <= 1.0) {
        return;
    }
    let mut with_polynomials: Vec<Arc<Sample>> = Vec::with_capacity(samples.len());
    for (point, sample) in samples.iter().enumerate() {
        let as_before = with_polynomials.last().cloned().filter(|_| is_as_before(point));
        let is_allowed = |assessment: Assessment| shares(assessment, point)[0] <= 1.0;
        let own = match as_before {
            Some(known) => known,
            None => match sample.fits().sample(design) {
                Some(known) if is_allowed(assessment(design, point)) => known,
                Some(_) => return,
                None => {
                    let (assessment, smooth) = fitted(design, point);
                    if !is_allowed(assessment) {
                        return;
                    }
                    let own = Arc::new(sample.with_polynomials(smooth));
                    if keeps {
                        sample.fits().keep(design, assessment, own.clone());
                    }
                    own
                }
            },
        };
        with_polynomials.push(own);
    }
    for (sample, own) in samples.iter_mut().zip(with_polynomials) {
        **sample = own;
    }
}

/// Some of the degrees, the highest first.
fn tried_degrees(designs: &[Arc<DesignMatrix>]) -> impl Iterator<Item = &Arc<DesignMatrix>> {
    designs.iter().rev().step_by(designs.len().div_ceil(TRIED_DEGREES).max(1))
}
