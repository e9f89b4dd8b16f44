//! One row of the parameter table: all numbers of one sample of a mechanism.

use super::compile::Mechanism;
use super::error::SampleError;
use super::play_shape::{CircularSlotShape, PinShape, PlayShape, SliderBlock, SlotShape, flank_radii_m};
use crate::contact::{
    Film, FilmBearing, FilmDescription, Foundation, FrictionLaw, NormalContact, NormalLaw, TouchingParts,
};
use crate::mechanism::beginning::initial::initial_numbers;
use crate::mechanism::beginning::offset::{StartOffset, start_offsets};
use crate::mechanism::loops::contact_place::ContactPlace;
use crate::mechanism::loops::coupling_geometry::CouplingGeometry;
use crate::mechanism::parts::control::ControlGeometry;
use crate::mechanism::parts::drive::Drives;
use crate::mechanism::parts::flanks::Flanks;
use crate::mechanism::parts::foundation::foundation;
use crate::mechanism::parts::joint_friction::JointFriction;
use crate::mechanism::parts::load::LoadGeometry;
use crate::mechanism::parts::spring::SpringGeometry;
use crate::mechanism::parts::stressed::SectionNumbers;
use crate::mechanism::tree::beam_points::point_off_section;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::points::{direction, point_m};
use crate::model::{Contact, JointId, JointKind, JointPlay, PlayId, PlayParts, QuantityId, SlidingVelocity, Values};
use loosepin_math::{Numbers, Real, Vec2, numbers};
use std::sync::Arc;

/// Numbers of a joint with play.
#[derive(Debug, Clone)]
pub struct PlayGeometry<T> {
    /// Centre P_i of the bearing (hole), or the point of the guide, in its body's frame, m.
    pub bearing_arm_m: Vec2<T>,
    /// Centre P_j of the journal (pin), or of the slider, in its body's frame, m.
    pub journal_arm_m: Vec2<T>,
    /// Pin, slider, slot or flanks, with its numbers.
    pub shape: PlayShape<T>,
    /// Clearance c, m: radial of a pin, on each side of a slider, half the backlash of a coupling.
    pub clearance_m: T,
    /// Normal force.
    pub normal: NormalLaw<T>,
    /// Friction.
    pub friction: FrictionLaw<T>,
    /// Film of oil, if any.
    pub film: Option<Film<T>>,
    /// Reading of eq. (7).
    pub sliding_velocity: SlidingVelocity,
    /// Elastic foundation between worn surfaces, which then has the place of the normal force's law.
    pub foundation: Option<Arc<Foundation>>,
    /// Whether its friction path ∫F_N |v_T| dt is integrated, because it wears.
    pub wears: bool,
    /// Floor v_min of the impact speed, m/s.
    pub minimum_impact_speed_m_s: T,
    /// Impact speed beyond which the law is not meant to hold, m/s; infinite where no density is given.
    pub largest_valid_impact_speed_m_s: f64,
    /// Restitution that a free impact delivers; `None` if it depends on the masses that meet.
    pub delivered_restitution: Option<f64>,
}

numbers!(struct PlayGeometry {
    bearing_arm_m, journal_arm_m, shape, clearance_m, normal, friction, film, minimum_impact_speed_m_s;
    sliding_velocity, foundation, wears, largest_valid_impact_speed_m_s, delivered_restitution
});

/// Sliding velocity of a wearing joint up to which |v_T| counts as zero, m/s: by then nothing is worn.
const REVERSAL_TOLERANCE_M_S: f64 = 1e-8;

impl<T: Real> PlayGeometry<T> {
    /// Whether the normal force is smooth in the root of the penetration.
    pub fn is_smooth_in_root(&self) -> bool {
        self.foundation.is_none() && self.normal.is_smooth_in_root()
    }

    /// Sliding velocities at which what is integrated has a kink while the contact is closed, m/s: those of the friction law, in both
    /// directions, and zero where the joint wears.
    #[inline(always)]
    pub fn kink_levels_m_s(&self) -> impl Iterator<Item = T> {
        let of_friction = self.friction.kink_speeds_m_s().into_iter().flatten().flat_map(|speed| [speed, -speed]);
        of_friction.chain(self.wears.then(T::zero))
    }
}

impl PlayGeometry<f64> {
    /// Difference of sliding velocities below which a kink at `level_m_s` counts as met, m/s.
    pub fn kink_tolerance_m_s(&self, level_m_s: f64) -> f64 {
        let of_friction_m_s = self.friction.kink_tolerance_m_s();
        if level_m_s == 0.0 && self.wears { of_friction_m_s.min(REVERSAL_TOLERANCE_M_S) } else { of_friction_m_s }
    }
}

/// The numbers of one sample: the ideal mechanism, the real one, its contacts, springs, loads and drives.
#[derive(Debug, Clone)]
pub struct Sample<T: Real> {
    /// For the tree in which every joint is ideal.
    pub ideal: TreeNumbers<T>,
    /// For the tree in which joints with play are force elements.
    pub real: TreeNumbers<T>,
    /// Joints and couplings with play, in the order of [`Mechanism::plays`].
    pub plays: Vec<PlayGeometry<T>>,
    /// Contacts of the joints, in the order of [`Mechanism::contacts`].
    pub contacts: Vec<ContactPlace>,
    /// Ideal joints with friction, in the order of the model.
    pub frictions: Vec<JointFriction<T>>,
    /// Springs, in the order of the model.
    pub springs: Vec<SpringGeometry<T>>,
    /// Loads, in the order of the model.
    pub loads: Vec<LoadGeometry<T>>,
    /// Drives, in the order of the model.
    pub drives: Drives<T>,
    /// Controls, in the order of the model.
    pub controls: Vec<ControlGeometry<T>>,
    /// References of the controls, in the order of the model.
    pub references: Drives<T>,
    /// The given numbers of the initial state, in the order of the model.
    pub initial: Vec<f64>,
    /// Places of journals in their bearings at the start, in the order of the model.
    pub offsets: Vec<StartOffset>,
    /// Links whose stress is an output, in the order of [`Mechanism::stressed`].
    pub sections: Vec<SectionNumbers>,
}

impl<T: Real> Sample<T> {
    /// Lays out `values` for `mechanism`.
    ///
    /// # Errors
    /// [`SampleError::ClearanceChangesTopology`] where a clearance is zero in one of the two only,
    /// [`SampleError::ClearanceOutsideFit`] where a law was not fitted to a clearance,
    /// [`SampleError::RoughnessOutsideFilm`] where no film goes with a roughness,
    /// [`SampleError::LengthOutsideFilm`] where a bearing is longer than its film allows,
    /// [`SampleError::PointOffSection`] where a point of a beam lies far from where it was when the mechanism was compiled,
    /// [`SampleError::Period`] where the points of a load do not fit its period.
    pub fn new(mechanism: &Mechanism, values: &Values) -> Result<Self, SampleError> {
        let model = &mechanism.model;
        for (index, joint) in model.joints.iter().enumerate() {
            if let Some(JointPlay { clearance_m: clearance, contact, .. }) = joint.kind.play() {
                let clearance_m = values[clearance];
                let compiled_with_play = mechanism.plays.contains(&PlayId::Joint(JointId(index)));
                if (clearance_m > 0.0) != compiled_with_play {
                    return Err(SampleError::ClearanceChangesTopology {
                        joint: joint.name.clone(),
                        clearance_m,
                        compiled_with_play,
                    });
                }
                let contact = &model.contacts[contact.0];
                if clearance_m > 0.0 {
                    refuse_film(&joint.name, &joint.kind, contact, values)?;
                }
                if let Some(law) = contact.law.line()
                    && let Some(fitted_m) = law.fitted_clearances_m
                    && clearance_m > 0.0
                    && !(fitted_m[0]..=fitted_m[1]).contains(&clearance_m)
                {
                    let (joint, law) = (joint.name.clone(), law.name);
                    return Err(SampleError::ClearanceOutsideFit { joint, law, clearance_m, fitted_m });
                }
            }
        }
        for (index, coupling) in model.couplings.iter().enumerate() {
            if let Some(backlash_m) = coupling.play.and_then(|play| play.backlash_m).map(|backlash| values[backlash]) {
                let compiled_with_play = mechanism.plays.contains(&PlayId::Coupling(index));
                if (backlash_m > 0.0) != compiled_with_play {
                    let path = coupling.path.clone();
                    return Err(SampleError::BacklashChangesTopology { path, backlash_m, compiled_with_play });
                }
            }
        }
        if let Some(error) = point_off_section(model, &mechanism.real.beams, values) {
            return Err(error);
        }
        let plays = mechanism.plays.iter().filter_map(|&id| match id {
            PlayId::Joint(joint) => play(mechanism, values, joint),
            PlayId::Coupling(index) => flanks(mechanism, values, index),
        });
        let plays = plays.collect();
        let drives = Drives::broadcast(&Drives::new(model, values));
        let loads = model.loads.iter().map(|load| LoadGeometry::new(model, load, values));
        let loads = loads.collect::<Result<_, _>>()?;
        Ok(Self {
            ideal: TreeNumbers::new(model, &mechanism.ideal, values),
            real: TreeNumbers::new(model, &mechanism.real, values),
            plays,
            contacts: mechanism.contacts.clone(),
            frictions: JointFriction::all(model, values),
            springs: model.springs.iter().map(|spring| SpringGeometry::new(model, spring, values)).collect(),
            loads,
            drives,
            controls: model.controls.iter().map(|control| ControlGeometry::new(model, control, values)).collect(),
            references: Drives::broadcast(&Drives::of_controls(model, values)),
            initial: initial_numbers(model, values),
            offsets: start_offsets(model, &mechanism.plays, values)?,
            sections: mechanism.stressed.iter().map(|stressed| SectionNumbers::new(model, stressed, values)).collect(),
        })
    }
}

impl Sample<f64> {
    /// The first time after `time_s` at which the pieces of a motion of a drive or a reference meet, or those of a load's table, s;
    /// infinite where there is none.
    pub fn next_break_s(&self, time_s: f64) -> f64 {
        let motions_s = self.drives.next_break_s(time_s).min(self.references.next_break_s(time_s));
        self.loads.iter().map(|load| load.next_break_s(time_s)).fold(motions_s, f64::min)
    }

    /// Puts every table of a drive or a reference into the piece that holds `time_s`. True where there are tables.
    pub fn take_pieces_at(&mut self, time_s: f64) -> bool {
        let [drives, references] =
            [&mut self.drives, &mut self.references].map(|motions| motions.take_pieces_at(time_s));
        drives || references
    }
}

impl<T: Real> Sample<T> {
    /// The sample for [`Mechanism::without_play`].
    pub fn without_play(self) -> Self {
        Self { real: self.ideal.clone(), plays: Vec::new(), contacts: Vec::new(), offsets: Vec::new(), ..self }
    }

    /// The numbers of the joint that the contact `contact` belongs to.
    #[inline(always)]
    pub fn play_of(&self, contact: usize) -> &PlayGeometry<T> {
        &self.plays[self.contacts[contact].play]
    }
}

/// A film needs a roughness that goes with the clearance, and a bearing that is not too long for it.
fn refuse_film(joint: &str, kind: &JointKind, contact: &Contact, values: &Values) -> Result<(), SampleError> {
    let Some((description, bearing)) = film_bearing(kind, contact, values) else { return Ok(()) };
    let FilmBearing { roughness_m, clearance_m, .. } = bearing;
    let (joint, law) = (joint.to_owned(), description.name);
    let allowed_m = description.roughness_m(clearance_m);
    if !(allowed_m[0]..=allowed_m[1]).contains(&roughness_m) {
        return Err(SampleError::RoughnessOutsideFilm { joint, law, roughness_m, clearance_m, allowed_m });
    }
    let (length_ratio, longest) = (bearing.length_ratio(), description.longest);
    if length_ratio > longest {
        return Err(SampleError::LengthOutsideFilm { joint, law, length_ratio, longest });
    }
    Ok(())
}

fn play<T: Real>(mechanism: &Mechanism, values: &Values, joint: JointId) -> Option<PlayGeometry<T>> {
    let model = &mechanism.model;
    let kind = &model.joints[joint.0].kind;
    let JointPlay { clearance_m, contact, .. } = kind.play()?;
    let contact = &model.contacts[contact.0];
    let [bearing, journal] = kind.points();
    let clearance_m = values[clearance_m];
    let number = |id: QuantityId| T::from_f64(values[id]);
    let (shape, parts): (PlayShape<T>, _) = match kind.play_parts()? {
        PlayParts::Pin(clearance) => {
            let bearing_length_m = clearance.bearing_length_m.map(|id| values[id]);
            let bearing_radius_m = values[clearance.bearing_radius_m];
            let shape = PinShape { bearing_radius_m: T::from_f64(bearing_radius_m) };
            (shape.into(), TouchingParts::Pin { bearing_radius_m, clearance_m, bearing_length_m })
        }
        PlayParts::Block { clearance, guide_angle_rad, slider_angle_rad } => {
            let block = SliderBlock {
                half_length_m: number(clearance.half_length_m),
                half_height_m: number(clearance.half_height_m),
                line: direction(number(guide_angle_rad)),
                axis: direction(number(slider_angle_rad)),
                ends_m: clearance.ends_m.map(|ends| ends.map(number)),
            };
            let radius_m = clearance.corner_radius_m.map(|id| values[id]);
            (block.into(), TouchingParts::OnPlane { radius_m })
        }
        PlayParts::Slot { clearance, slot_angle_rad } => {
            let end_radius_m = values[clearance.end_radius_m];
            // K of eq. (9) over its limit for R_i without bounds.
            let end_stiffening = contact.law.materials().map_or(0.0, |_| (end_radius_m / clearance_m).sqrt() - 1.0);
            let slot = SlotShape {
                half_length_m: number(clearance.half_length_m),
                end_radius_m: T::from_f64(end_radius_m),
                line: direction(number(slot_angle_rad)),
                end_stiffening: T::from_f64(end_stiffening),
            };
            let radius_m = Some(end_radius_m - clearance_m);
            (slot.into(), TouchingParts::OnPlane { radius_m })
        }
        PlayParts::CircularSlot { clearance, radius_m } => {
            let half_width_m = clearance.half_width_m;
            let [outer_m, inner_m] = flank_radii_m(values[radius_m], values[half_width_m], clearance_m);
            // What is given is given for both flanks.
            let inner_share = if contact.law.materials().is_some() { (inner_m / outer_m).sqrt() } else { 1.0 };
            let [radius_m, half_width_m] = [radius_m, half_width_m].map(number);
            let slot = CircularSlotShape { radius_m, half_width_m, inner_share: T::from_f64(inner_share) };
            (slot.into(), TouchingParts::OnPlane { radius_m: Some(outer_m) })
        }
    };
    let normal = contact.law.normal(values, &parts)?;
    let friction = contact.friction.as_ref().map_or(FrictionLaw::None, |friction| {
        let numbers: Vec<f64> = friction.numbers.iter().map(|number| values[*number]).collect();
        friction.law.law(&numbers)
    });
    Some(PlayGeometry {
        bearing_arm_m: point_m(model, values, bearing),
        journal_arm_m: point_m(model, values, journal),
        shape,
        clearance_m: T::from_f64(clearance_m),
        normal: NormalLaw::broadcast(&normal),
        friction: FrictionLaw::broadcast(&friction),
        film: film_bearing(kind, contact, values)
            .map(|(description, bearing)| Film::new(description, &bearing))
            .as_ref()
            .map(Film::broadcast),
        sliding_velocity: contact.friction.as_ref().map_or(SlidingVelocity::Material, |f| f.sliding_velocity),
        foundation: foundation(model, values, joint, &normal, &friction).map(Arc::new),
        wears: model.joints[joint.0].wear.is_some(),
        minimum_impact_speed_m_s: T::from_f64(values[contact.minimum_impact_speed_m_s]),
        largest_valid_impact_speed_m_s: contact.largest_valid_impact_speed_m_s(values),
        delivered_restitution: contact.law.delivered_restitution(values),
    })
}

/// A coupling with play. Its contact has a stiffness that is given, and neither friction nor a film.
fn flanks<T: Real>(mechanism: &Mechanism, values: &Values, index: usize) -> Option<PlayGeometry<T>> {
    let model = &mechanism.model;
    let coupling = &model.couplings[index];
    let play = coupling.play?;
    let contact = &model.contacts[play.contact.0];
    let number = |id: QuantityId| T::from_f64(values[id]);
    let half = T::from_f64(0.5);
    let normal = contact.law.normal(values, &TouchingParts::OnPlane { radius_m: None })?;
    Some(PlayGeometry {
        bearing_arm_m: Vec2::zero(),
        journal_arm_m: Vec2::zero(),
        shape: PlayShape::Flanks(Flanks {
            coupling: CouplingGeometry::new(model, coupling, &number),
            places: mechanism.real.coupling_place(model, index),
            is_one_sided: play.backlash_m.is_none(),
        }),
        clearance_m: play.backlash_m.map_or(T::zero(), |backlash| half * number(backlash)),
        normal: NormalLaw::broadcast(&normal),
        friction: FrictionLaw::None,
        film: None,
        sliding_velocity: SlidingVelocity::Material,
        foundation: None,
        wears: false,
        minimum_impact_speed_m_s: number(contact.minimum_impact_speed_m_s),
        largest_valid_impact_speed_m_s: contact.largest_valid_impact_speed_m_s(values),
        delivered_restitution: contact.law.delivered_restitution(values),
    })
}

/// The film of oil in a joint, and the bearing that it is in.
fn film_bearing(
    kind: &JointKind,
    contact: &Contact,
    values: &Values,
) -> Option<(&'static FilmDescription, FilmBearing)> {
    let clearance = kind.pin_clearance()?;
    let (film, length) = contact.film.as_ref().zip(clearance.bearing_length_m)?;
    let bearing = FilmBearing {
        viscosity_pa_s: values[film.viscosity_pa_s],
        radius_m: values[clearance.bearing_radius_m],
        length_m: values[length],
        clearance_m: values[clearance.radial_clearance_m],
        roughness_m: values[film.roughness_m],
    };
    Some((film.law, bearing))
}
