//! Places of the journals from uniform numbers.

use crate::accuracy::PlayDistribution;
use crate::accuracy::play_set::PlaySet;
use crate::model::SpatialModel;
use crate::play::block::PlayPart;
use loosepin_math::sin_cos;
use std::f64::consts::TAU;

/// Uniform numbers that the place of a block is drawn from: as many as it has variables, on the rim one fewer.
fn uniforms_of(part: PlayPart, distribution: PlayDistribution) -> usize {
    match (part.size(), distribution) {
        (1, _) | (_, PlayDistribution::Inside) => part.size(),
        (size, PlayDistribution::OnTheRim) => size - 1,
    }
}

/// Uniform numbers of all blocks.
pub(super) fn uniforms(set: &PlaySet, distribution: PlayDistribution) -> usize {
    set.blocks().iter().map(|block| uniforms_of(block.part, distribution)).sum()
}

impl SpatialModel {
    /// The joints with play, each with how many of the numbers of [`crate::TurnSampler::sample_with_play`] are its own, in the order of these
    /// numbers. Clearances that are zero have theirs too.
    pub fn uniforms_of_joints(&self, distribution: PlayDistribution) -> Vec<(&str, usize)> {
        let nominal = self.quantities.nominal();
        let with_play = self.joints.iter().filter_map(|joint| {
            let blocks = joint.play?.with(&nominal).blocks();
            let numbers = blocks.iter().map(|block| uniforms_of(block.part, distribution)).sum();
            Some((joint.name.as_str(), numbers))
        });
        with_play.collect()
    }
}

/// Variables of play, m: each block uniform in its ball or on its surface, r = c ⁿ√u, between stops c (2u - 1). As many numbers in [0, 1] as
/// [`uniforms`] are taken in the order of the blocks.
pub(super) fn variables_m(set: &PlaySet, distribution: PlayDistribution, uniforms: &[f64]) -> Vec<f64> {
    let mut variables = vec![0.0; set.variables()];
    let mut rest = uniforms;
    for block in set.blocks() {
        let (own, next) = rest.split_at(uniforms_of(block.part, distribution).min(rest.len()));
        rest = next;
        let c = block.radius;
        let is_inside = distribution == PlayDistribution::Inside;
        let place = &mut variables[block.range()];
        match (place, own) {
            ([axial], [u]) => *axial = c * (2.0 * u - 1.0),
            ([x, y], [angle, rest @ ..]) => {
                let radius = if is_inside { c * rest.first().copied().unwrap_or(1.0).sqrt() } else { c };
                let (sine, cosine) = sin_cos(TAU * angle);
                (*x, *y) = (radius * cosine, radius * sine);
            }
            ([x, y, z], [angle, height, rest @ ..]) => {
                let radius = if is_inside { c * libm::cbrt(rest.first().copied().unwrap_or(1.0)) } else { c };
                // The height of a uniform point of a sphere is uniform (Archimedes).
                let height = 2.0 * height - 1.0;
                let across = (1.0 - height * height).max(0.0).sqrt();
                let (sine, cosine) = sin_cos(TAU * angle);
                (*x, *y, *z) = (radius * across * cosine, radius * across * sine, radius * height);
            }
            _ => {}
        }
    }
    variables
}
