//! What play does to an output, position by position: worst case of first order, who contributes, and the positions that are searched.

use crate::accuracy::{AccuracyError, FirstOrder, Gains, PlayDistribution, PoseAccuracy, SearchOptions};
use crate::kind::SpatialPlay;
use crate::mechanism::joint::Joint;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::play::block::PlayPart;
use crate::stop::IsStopped;
use loosepin_math::Vec3;
use loosepin_result::motion::{ClearanceAnswer, JointContributor, SearchedPosition};
use std::rc::Rc;

/// Relative difference of worst cases that is round-off.
const SAME: f64 = 1e-9;

/// Whether play moves the journal of a joint; a clearance of zero moves nothing.
pub(super) fn has_play(joint: &Joint) -> bool {
    joint.play.iter().flat_map(SpatialPlay::blocks).any(|block| block.radius > 0.0)
}

/// Radial clearance of a joint, m; 0 where it has none.
fn radial_clearance_m(joint: &Joint) -> f64 {
    let radial = joint.play.iter().flat_map(SpatialPlay::blocks).find(|block| block.part.is_radial());
    radial.map_or(0.0, |block| block.radius)
}

/// What is known of an output after some positions.
pub(super) struct Course<'a> {
    components: Vec<SpatialOutput>,
    first_order_si: Vec<f64>,
    /// Where there is a closed form.
    variances: Vec<f64>,
    /// Joints with play, by their numbers.
    contributors: Vec<(usize, JointContributor)>,
    /// The position with the largest worst case of first order.
    worst: Option<Worst<'a>>,
    /// That of the positions in which play comes near no dead centre.
    worst_regular: Option<Worst<'a>>,
}

/// The largest worst case of first order so far.
pub(super) struct Worst<'a> {
    /// Number of the position.
    pub position: usize,
    pub accuracy: Rc<PoseAccuracy<'a>>,
    size: f64,
    /// What it is of.
    along: SpatialOutput,
}

/// The worst case of first order in one position.
struct AtPosition {
    first_order: FirstOrder,
    gains: Gains,
    /// Its size; of a vector the longest that a search over directions found.
    size: f64,
    /// Where there is a closed form.
    variance: Option<f64>,
    /// What it is of: of a vector its component along the direction in which it is longest.
    along: SpatialOutput,
}

impl<'a> Course<'a> {
    pub fn new(components: Vec<SpatialOutput>, mechanism: &SpatialMechanism) -> Self {
        let joints = mechanism.joints().iter().enumerate().filter(|(_, joint)| joint.play.is_some());
        let contributor = |joint: &Joint| JointContributor {
            joint: joint.name.clone(),
            radial_clearance_m: radial_clearance_m(joint),
            ..JointContributor::default()
        };
        Self {
            components,
            first_order_si: Vec::new(),
            variances: Vec::new(),
            contributors: joints.map(|(number, joint)| (number, contributor(joint))).collect(),
            worst: None,
            worst_regular: None,
        }
    }

    pub fn components(&self) -> &[SpatialOutput] {
        &self.components
    }

    /// The position with the largest worst case of first order.
    pub fn worst(&self) -> Option<&Worst<'a>> {
        self.worst.as_ref()
    }

    /// Adds the next position. Play comes near no dead centre in one that is regular.
    pub fn add(&mut self, accuracy: &Rc<PoseAccuracy<'a>>, is_regular: bool) -> Result<(), AccuracyError> {
        let position = self.first_order_si.len();
        let AtPosition { first_order, gains, size, variance, along } = at_position(accuracy, &self.components)?;
        self.first_order_si.push(size);
        self.variances.extend(variance);
        let by_play = conditioned(accuracy, &gains, &first_order);
        for (joint, known) in &mut self.contributors {
            add_effects(known, *joint, &gains, &by_play);
            known.first_order_si.push(first_order.by_joint.get(*joint).copied().unwrap_or_default());
        }
        // Round-off decides nothing: the first of several alike.
        let is_worse = |known: &Option<Worst<'_>>| known.as_ref().is_none_or(|known| size > known.size * (1.0 + SAME));
        let worst = || Worst { position, size, along, accuracy: Rc::clone(accuracy) };
        if is_worse(&self.worst) {
            self.worst = Some(worst());
        }
        if is_regular && is_worse(&self.worst_regular) {
            self.worst_regular = Some(worst());
        }
        Ok(())
    }

    /// What is known of play, with searches in the worst positions, if a joint has any; with proven ends there on demand.
    pub fn answer(self, is_proven: bool, is_stopped: IsStopped) -> Result<ClearanceAnswer, AccuracyError> {
        if self.contributors.is_empty() {
            return Ok(self.unsearched());
        }
        let worst = self.worst.as_ref().ok_or(AccuracyError::NotAPosition)?;
        let other = self.worst_regular.as_ref().filter(|regular| regular.position != worst.position);
        let searched = [Some(worst), other].into_iter().flatten().map(|place| place.searched(is_proven, is_stopped));
        let searched = searched.collect::<Result<Vec<_>, _>>()?;
        Ok(ClearanceAnswer { searched, ..self.unsearched() })
    }

    /// What is known of play to first order.
    pub fn unsearched(self) -> ClearanceAnswer {
        let is_whole = self.variances.len() == self.first_order_si.len();
        ClearanceAnswer {
            disc_standard_deviation_si: match is_whole {
                true => self.variances.iter().map(|own| own.sqrt()).collect(),
                false => Vec::new(),
            },
            first_order_si: self.first_order_si,
            contributors: self.contributors.into_iter().map(|(_, known)| known).collect(),
            ..ClearanceAnswer::default()
        }
    }
}

impl Worst<'_> {
    fn searched(&self, is_proven: bool, is_stopped: IsStopped) -> Result<SearchedPosition, AccuracyError> {
        let exact = self.accuracy.worst_case_until(&self.along, &SearchOptions::default(), is_stopped)?;
        let proven = || self.accuracy.proven_end(&self.along).map(|ends| [ends.smallest, ends.largest]);
        Ok(SearchedPosition {
            position: self.position,
            found_si: [exact.smallest.deviation, exact.largest.deviation],
            proven_si: is_proven.then(|| proven().unwrap_or([f64::NEG_INFINITY, f64::INFINITY])),
            conditions: self.accuracy.conditions(),
        })
    }
}

fn at_position(accuracy: &PoseAccuracy<'_>, components: &[SpatialOutput]) -> Result<AtPosition, AccuracyError> {
    let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<Gains>, _>>()?;
    let deviation = |gains: &Gains| accuracy.standard_deviation(gains, PlayDistribution::Inside);
    let variance = gains.iter().map(|own| deviation(own).map(|own| own * own)).sum::<Option<f64>>();
    if let [output] = *components
        && let Some(gains) = gains.first().cloned()
    {
        let first_order = accuracy.first_order(&gains)?;
        return Ok(AtPosition { size: first_order.worst, first_order, gains, variance, along: output });
    }
    let longest = accuracy.largest_norm(&gains)?;
    let direction = <[f64; 3]>::try_from(longest.direction).map_or(None, |n| Vec3::from(n).normalised());
    let along = components.first().and_then(|first| first.component(direction.unwrap_or(Vec3::X)));
    let along = along.ok_or(AccuracyError::OutputDoesNotFit)?;
    let gains = accuracy.gains(&along)?;
    Ok(AtPosition { first_order: accuracy.first_order(&gains)?, gains, size: longest.largest, variance, along })
}

/// Gains by variables of play: g + λ·h in place of g, where the plays must meet conditions together.
fn conditioned(accuracy: &PoseAccuracy<'_>, gains: &Gains, first_order: &FirstOrder) -> Vec<f64> {
    let mut by_play = gains.by_play.clone();
    for (row, multiplier) in accuracy.conditions_by_play().iter().zip(&first_order.multipliers) {
        by_play.iter_mut().zip(row).for_each(|(gain, h)| *gain += multiplier * h);
    }
    by_play
}

/// Adds what an offset, a lean and the axial clearance of a joint do alone.
fn add_effects(known: &mut JointContributor, joint: usize, gains: &Gains, by_play: &[f64]) {
    let of = |is_it: &dyn Fn(PlayPart) -> bool| {
        let block = gains.blocks.iter().find(|block| block.joint == joint && is_it(block.part))?;
        Some((by_play.get(block.range())?, block.radius))
    };
    let of_end = |plane: usize| of(&|part| part.end_plane() == Some(plane));
    let alone = |is_it: fn(PlayPart) -> bool| of(&is_it).map(|(own, radius_m)| radius_m * length(own.iter().copied()));
    // u1 = u2 = c is an offset, u2 = -u1 a lean.
    let of_ends = of_end(0).zip(of_end(1)).map(|((first, radius_m), (second, _))| {
        let both = |sign: f64| radius_m * length(first.iter().zip(second).map(|(a, b)| a + sign * b));
        [both(1.0), both(-1.0)]
    });
    let offset = of_ends.map(|[offset, _]| offset).or_else(|| alone(PlayPart::is_offset));
    known.offset_si.push(offset.unwrap_or_default());
    known.lean_si.extend(of_ends.map(|[_, lean]| lean).or_else(|| alone(PlayPart::is_lean)));
    known.axial_si.extend(alone(PlayPart::is_axial));
}

fn length(components: impl Iterator<Item = f64>) -> f64 {
    components.map(|own| own * own).sum::<f64>().sqrt()
}
