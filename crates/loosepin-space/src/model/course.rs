//! What play does to an output, position by position: worst case of first order, who contributes, and the positions that are searched.

use crate::accuracy::{AccuracyError, FirstOrder, Gains, Longest, PlayDistribution, PoseAccuracy, Worst, WorstPlaces};
use crate::kind::SpatialPlay;
use crate::mechanism::joint::Joint;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::play::block::PlayPart;
use crate::stop::IsStopped;
use loosepin_result::motion::{ClearanceAnswer, JointContributor};
use std::rc::Rc;

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
    worst: WorstPlaces<Place<'a>>,
}

/// A position in which an output may be searched.
#[derive(Clone)]
pub(super) struct Place<'a> {
    pub accuracy: Rc<PoseAccuracy<'a>>,
    /// What is searched: of a vector its component along the direction in which it is longest.
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
            worst: WorstPlaces::default(),
        }
    }

    pub fn components(&self) -> &[SpatialOutput] {
        &self.components
    }

    /// The position with the largest worst case of first order.
    pub fn worst(&self) -> Option<&Worst<Place<'a>>> {
        self.worst.worst()
    }

    /// Adds the next position. Play comes near no dead centre in one that is regular.
    pub fn add(&mut self, accuracy: &Rc<PoseAccuracy<'a>>, is_regular: bool) -> Result<(), AccuracyError> {
        let position = self.first_order_si.len();
        let gains = self.components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<Gains>, _>>()?;
        let deviation = |gains: &Gains| accuracy.standard_deviation(gains, PlayDistribution::Inside);
        self.variances.extend(gains.iter().map(|own| deviation(own).map(|own| own * own)).sum::<Option<f64>>());
        let Longest { size, along, first_order } = accuracy.longest(&gains)?;
        self.first_order_si.push(size);
        let by_play = conditioned(accuracy, &along, &first_order);
        for (joint, known) in &mut self.contributors {
            add_effects(known, *joint, &along, &by_play);
            known.first_order_si.push(first_order.by_joint.get(*joint).copied().unwrap_or_default());
        }
        let place = Place { accuracy: Rc::clone(accuracy), along: along.output };
        self.worst.add(position, size, is_regular, &place);
        Ok(())
    }

    /// What is known of play, with searches in the worst positions, if a joint has any; with proven ends there on demand.
    pub fn answer(self, is_proven: bool, is_stopped: IsStopped) -> Result<ClearanceAnswer, AccuracyError> {
        if self.contributors.is_empty() {
            return Ok(self.unsearched());
        }
        if self.worst.worst().is_none() {
            return Err(AccuracyError::NotAPosition);
        }
        let searched = self.worst.searched().map(|Worst { position, place, .. }| {
            place.accuracy.searched(*position, &place.along, is_proven, is_stopped)
        });
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
        let block = gains.block(joint, is_it)?;
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
