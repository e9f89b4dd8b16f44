//! Standard deviations against samples of exact poses.

use super::drawn::CLASSES;
use super::poses::PoseSet;
use super::{at_rest, drawn_case};
use crate::random::Random;
use loosepin_space::{PlayDistribution, PoseAccuracy};

/// Standard errors by which a sampled standard deviation may be off.
const ERRORS: f64 = 4.0;
/// Second order: the square of the leans and of deviations over lengths, relative.
const SECOND_ORDER: f64 = 3e-3;

/// Standard deviation of a sample, and its standard error from the fourth moment.
fn deviation(sample: &[f64]) -> (f64, f64) {
    let count = sample.len() as f64;
    let mean = sample.iter().sum::<f64>() / count;
    let moment = |power: i32| sample.iter().map(|value| (value - mean).powi(power)).sum::<f64>() / count;
    let (second, fourth) = (moment(2), moment(4));
    let sigma = second.sqrt();
    (sigma, ((fourth - second * second) / count).sqrt() / (2.0 * sigma))
}

/// Random places: each block uniform in its ball, by rejection from the cube, or on its surface; intervals stay uniform.
fn places(set: &PoseSet, random: &mut Random, is_on_rim: bool) -> Vec<f64> {
    let mut all = Vec::new();
    for (_, size) in &set.blocks {
        loop {
            let own: Vec<f64> = (0..*size).map(|_| random.number()).collect();
            let length = own.iter().map(|value| value * value).sum::<f64>().sqrt();
            if length <= 1.0 && length > 0.0 {
                let share = if is_on_rim && *size > 1 { 1.0 / length } else { 1.0 };
                all.extend(own.iter().map(|value| value * share));
                break;
            }
        }
    }
    all
}

#[test]
fn identity_standard_deviations_are_those_of_sampled_poses() {
    const SAMPLES: usize = 6000;
    let mut random = Random(31);
    for name in ["RSSR", "RSRC", "RSSP", "RCCC", "open arm"] {
        let class = CLASSES.iter().position(|(own, _)| *own == name).unwrap();
        let (mechanism, output) = drawn_case(class, &mut random, usize::MAX);
        let position = at_rest(&mechanism);
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        let gains = accuracy.gains(&output).unwrap();
        let set = PoseSet::new(&mechanism, &output);
        for (distribution, is_on_rim) in [(PlayDistribution::Inside, false), (PlayDistribution::OnTheRim, true)] {
            let found = accuracy.standard_deviation(&gains, distribution).unwrap();
            let sample: Vec<f64> = (0..SAMPLES)
                .map(|_| set.at_places(&places(&set, &mut random, is_on_rim)).expect("the loops close").output)
                .collect();
            let (expected, error) = deviation(&sample);
            let tolerance = ERRORS * error + SECOND_ORDER * expected;
            assert!((found - expected).abs() < tolerance, "{name}: {found} {expected} ± {error}");
            assert!(tolerance < 0.06 * expected, "{name}: {tolerance} of {expected} tells nothing");
        }
    }
}

#[test]
fn identity_standard_deviations_of_overconstrained_loops_are_those_of_sampled_poses() {
    const ACCEPTED: usize = 3000;
    const MAX_DIMENSIONS: usize = 5;
    let mut random = Random(32);
    for name in ["Cardan shafts", "spherical four-bar", "Bennett", "planar four-bar", "planar slider-crank"] {
        let class = CLASSES.iter().position(|(own, _)| *own == name).unwrap();
        let (mechanism, output) = loop {
            let (mechanism, output) = drawn_case(class, &mut random, usize::MAX);
            if PoseSet::new(&mechanism, &output).dimensions() <= MAX_DIMENSIONS {
                break (mechanism, output);
            }
        };
        let position = at_rest(&mechanism);
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        assert!(accuracy.conditions() > 0);
        let found = accuracy.sampled_deviation(&accuracy.gains(&output).unwrap(), 100_000, 5);
        let set = PoseSet::new(&mechanism, &output);
        // |t| is the length of all places together, to first order.
        let reach = (set.blocks.len() as f64).sqrt();
        let mut sample = Vec::new();
        while sample.len() < ACCEPTED {
            let t: Vec<f64> = (0..set.dimensions()).map(|_| reach * random.number()).collect();
            let Some(at) = set.reach(&t) else { continue };
            let length = |(first, size): &(usize, usize)| super::linear::length(&at.places[*first..first + size]);
            if set.blocks.iter().all(|block| length(block) <= 1.0) {
                sample.push(at.output);
            }
        }
        let (expected, error) = deviation(&sample);
        let tolerance = ERRORS * error.hypot(found.standard_error) + SECOND_ORDER * expected;
        let sigma = found.standard_deviation;
        assert!((sigma - expected).abs() < tolerance, "{name}: {sigma} {expected} ± {error}");
        assert!(tolerance < 0.1 * expected, "{name}: {tolerance} of {expected} tells nothing");
    }
}
