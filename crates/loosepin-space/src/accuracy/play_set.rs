//! The variables of all plays of a mechanism, and the set that they lie in.

use crate::kind::SpatialPlay;
use crate::kind::frames::MarkerShift;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::play::block::{Block, PlayPart};

/// A block of variables with its place in the list of all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedBlock {
    /// Number of the joint.
    pub joint: usize,
    /// What the variables are.
    pub part: PlayPart,
    /// How long they may be together, in their unit: m, and 1 of slopes.
    pub radius: f64,
    /// Number of the first variable.
    pub first: usize,
}

impl PlacedBlock {
    /// Numbers of its variables.
    pub fn range(&self) -> core::ops::Range<usize> {
        self.first..self.first + self.part.size()
    }
}

/// All variables of play: a product of intervals, discs and balls.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaySet {
    blocks: Vec<PlacedBlock>,
    variables: usize,
}

impl PlaySet {
    /// The plays of all joints in their order.
    pub(crate) fn new(mechanism: &SpatialMechanism) -> Self {
        let (mut blocks, mut first) = (Vec::new(), 0);
        for (number, joint) in mechanism.joints().iter().enumerate() {
            for Block { part, radius } in joint.play.iter().flat_map(SpatialPlay::blocks) {
                blocks.push(PlacedBlock { joint: number, part, radius, first });
                first += part.size();
            }
        }
        Self { blocks, variables: first }
    }

    /// No variables.
    #[cfg(test)]
    pub(crate) fn empty() -> Self {
        Self { blocks: Vec::new(), variables: 0 }
    }

    /// The set with one more block, of no joint.
    pub(crate) fn with_block(&self, Block { part, radius }: Block) -> Self {
        let mut other = self.clone();
        other.blocks.push(PlacedBlock { joint: usize::MAX, part, radius, first: self.variables });
        other.variables += part.size();
        other
    }

    /// Its blocks.
    pub fn blocks(&self) -> &[PlacedBlock] {
        &self.blocks
    }

    /// Number of all variables.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// The radius of the block of each variable, m.
    pub(crate) fn radii_m(&self) -> Vec<f64> {
        self.blocks.iter().flat_map(|block| vec![block.radius; block.part.size()]).collect()
    }

    /// The variables of the plays of each joint.
    fn of_joints<'a>(&self, mechanism: &SpatialMechanism, variables: &'a [f64]) -> Vec<&'a [f64]> {
        let joints = 0..mechanism.joints().len();
        joints
            .map(|joint| {
                let mut own = self.blocks.iter().filter(|block| block.joint == joint).map(PlacedBlock::range);
                let first = own.next().unwrap_or(0..0);
                let last = own.next_back().unwrap_or(first.clone());
                variables.get(first.start..last.end).unwrap_or_default()
            })
            .collect()
    }

    /// What the variables do to each joint.
    pub(crate) fn shifts(&self, mechanism: &SpatialMechanism, variables: &[f64]) -> Vec<MarkerShift> {
        let joints = mechanism.joints().iter().zip(self.of_joints(mechanism, variables));
        joints
            .map(|(joint, own)| joint.play.as_ref().map_or(MarkerShift::default(), |play| play.marker_shift(own)))
            .collect()
    }

    /// Derivatives of [`Self::shifts`] by each variable: its joint, and what it does there.
    pub(crate) fn derivatives(&self, mechanism: &SpatialMechanism, variables: &[f64]) -> Vec<(usize, MarkerShift)> {
        let joints = mechanism.joints().iter().zip(self.of_joints(mechanism, variables)).enumerate();
        joints
            .flat_map(|(number, (joint, own))| {
                let derivatives = joint.play.as_ref().map_or(Vec::new(), |play| play.derivatives(own));
                derivatives.into_iter().map(move |shift| (number, shift))
            })
            .collect()
    }

    /// Variables scaled so that each block lies in a unit ball, in m again.
    pub(crate) fn in_metres(&self, scaled: &[f64]) -> Vec<f64> {
        let mut metres = scaled.to_vec();
        for block in &self.blocks {
            metres[block.range()].iter_mut().for_each(|value| *value *= block.radius);
        }
        metres
    }

    /// Puts blocks that are outside their unit balls back onto the border.
    pub(crate) fn cut_back(&self, scaled: &mut [f64]) {
        for block in &self.blocks {
            let length = Self::length(block, scaled);
            if length > 1.0 {
                scaled[block.range()].iter_mut().for_each(|value| *value /= length);
            }
        }
    }

    /// The square of the length of a block's variables.
    pub(crate) fn square(block: &PlacedBlock, variables: &[f64]) -> f64 {
        variables.get(block.range()).unwrap_or_default().iter().map(|value| value * value).sum()
    }

    /// The length of a block's variables.
    pub(crate) fn length(block: &PlacedBlock, variables: &[f64]) -> f64 {
        Self::square(block, variables).sqrt()
    }

    /// The largest g·p of each block, over p in its ball: radius times the length of its gains. What `gains` are of scaled variables has
    /// radius one.
    pub(crate) fn support(&self, scaled_gains: &[f64]) -> Vec<f64> {
        self.blocks.iter().map(|block| Self::length(block, scaled_gains)).collect()
    }
}
