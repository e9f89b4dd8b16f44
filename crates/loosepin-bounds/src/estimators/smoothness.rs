//! Whether a response is smooth in the random inputs: then samples get polynomials.

use std::sync::Arc;

use super::inner_basis::{CrossFit, DesignMatrix, InnerBasis};
use super::sample::Sample;
use super::smooth::{ROUND_OFF, Smooth, largest_magnitude};

/// The polynomials may leave at most this share of the standard deviation of a sample, or of the largest one of any sample.
const MAX_RESIDUAL: f64 = 1e-3;
const MAX_RESIDUAL_OF_ALL: f64 = 1e-6;
/// The degree is chosen at this many points u; a lower degree must leave less than the highest by this factor.
const TRIAL_POINTS: usize = 8;
const CLEARLY_LESS: f64 = 0.25;
/// Where the highest degree leaves more than this times what is allowed, lower ones are not tried.
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
    let largest_residual = |fit: &CrossFit| largest_magnitude(&fit.residuals);
    // The same relative to what is allowed.
    let share = |largest_residual: f64, point: usize| {
        // Of a response that does not scatter at all, round-off is left.
        let round_off = ROUND_OFF * largest_magnitude(samples[point].values());
        (largest_residual - round_off).max(0.0) / allowed(point).max(f64::MIN_POSITIVE)
    };
    let residual_share = |design: &Arc<DesignMatrix>, point: usize| {
        let sample = &samples[point];
        let find = || largest_residual(&design.fit(sample.values()));
        share(sample.fits().largest_residual(design, find), point)
    };
    let step = samples.len().div_ceil(TRIAL_POINTS).max(1);
    let mut chosen: Option<(&Arc<DesignMatrix>, f64)> = None;
    for design in tried_degrees(basis.designs()) {
        let known = chosen.map_or(f64::INFINITY, |(_, most)| CLEARLY_LESS * most);
        let mut most = 0.0_f64;
        for point in (0..samples.len()).step_by(step) {
            if point >= step && Arc::ptr_eq(samples[point], samples[point - step]) {
                continue;
            }
            most = most.max(residual_share(design, point));
            if most > HOPELESS {
                return;
            }
            if most >= known && chosen.is_some() {
                break;
            }
        }
        if chosen.is_none() || most < known {
            chosen = Some((design, most));
        }
    }
    let Some((design, most)) = chosen else { return };
    if !(most <= 1.0) {
        return;
    }
    let mut fitted: Vec<Arc<Sample>> = Vec::with_capacity(samples.len());
    for (point, sample) in samples.iter().enumerate() {
        let as_before = fitted.last().cloned().filter(|_| is_as_before(point));
        let own = match as_before {
            Some(known) => known,
            None => match sample.fits().sample(design) {
                Some(known) if residual_share(design, point) <= 1.0 => known,
                Some(_) => return,
                None => {
                    let fit = design.fit(sample.values());
                    let largest = largest_residual(&fit);
                    if !(share(largest, point) <= 1.0) {
                        return;
                    }
                    let own = Arc::new(sample.with_polynomials(Smooth::new(design.clone(), fit)));
                    if keeps {
                        sample.fits().keep(design, largest, own.clone());
                    }
                    own
                }
            },
        };
        fitted.push(own);
    }
    for (sample, fitted) in samples.iter_mut().zip(fitted) {
        **sample = fitted;
    }
}

/// Some of the degrees, the highest first.
fn tried_degrees(designs: &[Arc<DesignMatrix>]) -> impl Iterator<Item = &Arc<DesignMatrix>> {
    designs.iter().rev().step_by(designs.len().div_ceil(TRIED_DEGREES).max(1))
}
