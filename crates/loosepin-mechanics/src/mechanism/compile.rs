//! A model compiled for computing.

use super::error::MechanismError;
use super::loops::constraints::RowOwner;
use super::tree::assembly;
use crate::mechanism::attachment::KindOfAttachment;
use crate::mechanism::beginning::initial::{StartEquations, initial_numbers};
use crate::mechanism::beginning::nodal_start::set_undeformed;
use crate::mechanism::beginning::offset::demand_drives;
use crate::mechanism::loops::contact_place::{ContactPlace, contact_name, contact_places};
use crate::mechanism::loops::tooth_force::demand_fit;
use crate::mechanism::parts::control::KnownChain;
use crate::mechanism::parts::stressed::StressedBody;
use crate::mechanism::tree::beam_points::point_beyond_beam;
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::mobility::{self, Mobility};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{DrivenLoop, JointPlace, Tree};
use crate::model::{BodyId, Model, PlayId, Values};
use loosepin_math::Vec2;

/// A compiled mechanism: topology and nominal start, no state. Many runs share one.
#[derive(Debug, Clone)]
pub struct Mechanism {
    /// The model it was compiled from.
    pub model: Model,
    /// The tree in which every joint is ideal.
    pub ideal: Tree,
    /// The tree in which joints with play are force elements.
    pub real: Tree,
    /// Joints and couplings with play, in file order.
    pub plays: Vec<PlayId>,
    /// Places where the bodies of joints with play or the flanks of couplings may touch, one after the other.
    pub contacts: Vec<ContactPlace>,
    /// Largest distance of two points of one body, m: the size against which lengths are judged.
    pub size_m: f64,
    /// Degrees of freedom with all clearances at zero.
    pub degrees_of_freedom: usize,
    /// Degrees of freedom that move dynamically: those that play opens, without the driven ones.
    pub dynamic_freedoms: usize,
    /// Joints and couplings that repeat what others impose already, with the number of their redundant constraints.
    pub redundant: Vec<(RowOwner, usize)>,
    /// Angles of all bodies of the model in the other configurations that close the loops at the start, rad.
    pub other_assemblies_rad: Vec<Vec<f64>>,
    /// Along what its controls feed inverse dynamics forward.
    pub known_chain: Option<KnownChain>,
    /// Links whose stress is an output.
    pub stressed: Vec<StressedBody>,
    /// Coordinates of the ideal tree at the start of the nominal mechanism.
    pub(super) ideal_start: Vec<f64>,
    /// Independent constraint rows of the ideal tree.
    ideal_rows: Vec<usize>,
}

impl Mechanism {
    /// Compiles `model` with `values`: which joints have play is decided by their clearances there.
    ///
    /// # Errors
    /// See [`MechanismError`].
    pub fn new(model: &Model, values: &Values) -> Result<Self, MechanismError> {
        let driven_loop =
            |error: DrivenLoop| MechanismError::DrivenLoop { joint: model.joints[error.joint.0].name.clone() };
        let ideal = Tree::new(model, |_| true).map_err(driven_loop)?;
        if let Some((body, point)) = point_beyond_beam(model, values) {
            return Err(MechanismError::BeyondBeam { body, point });
        }
        let real = Tree::flexible(model, values, |id| !model.has_play(id, values)).map_err(driven_loop)?;
        if let Some(body) = real.misattached_beam(model) {
            return Err(MechanismError::BeamHangs { body: model.bodies[body.0].name.clone() });
        }
        let size_m = size_m(model, values);
        let geometry = TreeNumbers::new(model, &ideal, values);
        let numbers = initial_numbers(model, values);
        let equations = StartEquations::new(model, &ideal, &geometry, &numbers);
        let assembly = assembly::assemble(&equations, values, size_m)?;
        let Mobility { degrees_of_freedom, redundant, independent_rows } =
            mobility::count(model, &ideal, &geometry, &assembly.coordinates, size_m)?;
        let by_body = |angles: &Vec<f64>| ideal.slot_of_body.iter().map(|&slot| angles[slot]).collect();
        let plays: Vec<PlayId> = model.plays().filter(|&id| model.has_play(id, values)).collect();
        let mut mechanism = Self {
            model: model.clone(),
            contacts: contact_places(model, &plays),
            plays,
            size_m,
            degrees_of_freedom,
            dynamic_freedoms: 0,
            redundant,
            other_assemblies_rad: assembly.alternatives_rad.iter().map(by_body).collect(),
            known_chain: KnownChain::new(model, values)?,
            stressed: StressedBody::all(model, &real),
            ideal_start: assembly.coordinates,
            ideal_rows: independent_rows,
            ideal,
            real,
        };
        if !mechanism.is_driven() {
            demand_drives(model)?;
        }
        let mut kinematics = Kinematics::new(&mechanism.ideal);
        kinematics.set_positions(&mechanism.ideal, &geometry, &mechanism.ideal_start);
        demand_fit(model, values, &mechanism.ideal, &kinematics)?;
        let real_geometry = TreeNumbers::new(model, &mechanism.real, values);
        let (start, _) = mechanism.real_coordinates(&kinematics, &real_geometry);
        mechanism.dynamic_freedoms = mobility::open_freedoms(&mechanism.real, &real_geometry, &start, size_m);
        let rows_repeat = mechanism.real.free - mechanism.dynamic_freedoms < mechanism.real.constraint_rows();
        if rows_repeat && let Some(joint) = model.joints.iter().find(|joint| joint.friction.is_some()) {
            return Err(MechanismError::CarriedNotDetermined { joint: joint.name.clone() });
        }
        Ok(mechanism)
    }

    /// A copy with every clearance at zero and rigid bodies: its real tree is the ideal one.
    pub fn without_play(&self) -> Self {
        Self { real: self.ideal.clone(), plays: Vec::new(), contacts: Vec::new(), dynamic_freedoms: 0, ..self.clone() }
    }

    /// A copy in which every body with a beam is cut along its length, to be looked at as a rigid link by [`Mechanism::without_play`].
    pub fn with_rigid_links_cut(&self, values: &Values) -> Self {
        Self { stressed: StressedBody::rigid(&self.model, values), ..self.clone() }
    }

    /// Whether the drives alone determine the motion: they move every freedom, no joint has play, and no body is flexible.
    pub fn is_ideal(&self) -> bool {
        self.plays.is_empty() && self.real.flexible_bodies().next().is_none() && self.is_driven()
    }

    /// Whether the drives move every freedom that the mechanism has with all clearances at zero. Otherwise forces do, from
    /// the initial state that the model gives.
    pub fn is_driven(&self) -> bool {
        self.degrees_of_freedom == self.model.drives.len()
    }

    /// Whether pins with play lean out of the plane.
    pub fn has_leaning_pins(&self) -> bool {
        self.plays.iter().any(|play| self.model.has_leaning_pin(*play))
    }

    /// Whether springs or flexible bodies turn energy into heat by damping.
    pub fn has_dampers(&self) -> bool {
        let has_damper = self.model.springs.iter().any(|spring| spring.damping.is_some());
        has_damper
            || self.real.beams.iter().any(|beam| beam.is_damped)
            || self.real.nodal_beams.iter().any(|beam| beam.is_damped)
    }

    /// Index in `contacts` of the first contact of the joint with play `play`, and of the first one behind them.
    pub fn contacts_of(&self, play: usize) -> std::ops::Range<usize> {
        let behind = |play: usize| self.contacts.iter().filter(|contact| contact.play < play).count();
        behind(play)..behind(play + 1)
    }

    /// Name of the contact `contact`: that of its joint, for a slider with its corner.
    pub fn contact_name(&self, contact: usize) -> String {
        let ContactPlace { play, place } = self.contacts[contact];
        contact_name(&self.model, self.plays[play], place)
    }

    /// Places of the actuator's joint and of the measured joint of each control in the real tree.
    pub fn control_places(&self) -> Vec<[JointPlace; 2]> {
        let place = |joint| JointPlace::new(&self.model, &self.real, joint);
        self.model.controls.iter().map(|control| [place(control.joint), place(control.measured)]).collect()
    }

    /// Independent constraint rows of the ideal tree, as many as it has free coordinates.
    pub fn ideal_rows(&self) -> &[usize] {
        &self.ideal_rows
    }

    /// Coordinates and rates of the real tree when its bodies are where `ideal` kinematics puts them.
    pub fn real_coordinates(&self, ideal: &Kinematics<f64>, real: &TreeNumbers<f64>) -> (Vec<f64>, Vec<f64>) {
        let tree = &self.real;
        let (mut coordinates, mut rates) = (vec![0.0; tree.coordinates()], vec![0.0; tree.coordinates()]);
        let slot_of = |body: BodyId| self.ideal.slot_of_body[body.0];
        for (link, numbers) in tree.links.iter().zip(&real.links) {
            let own_slot = slot_of(link.body);
            let parent_slot = match link.parent_slot {
                0 => 0,
                slot => slot_of(tree.links[slot - 1].body),
            };
            let (own, parent) = (ideal.poses[own_slot], ideal.poses[parent_slot]);
            let (own_twist, parent_twist) = (ideal.twists[own_slot], ideal.twists[parent_slot]);
            let (own_coordinates, own_rates) =
                (&mut coordinates[link.coordinates.clone()], &mut rates[link.speeds.clone()]);
            let [parent, own] = [(&parent, &parent_twist), (&own, &own_twist)];
            link.attachment.coordinates_between(numbers, parent, own, own_coordinates, own_rates);
        }
        for (place, numbers) in tree.nodal_beams.iter().zip(&real.nodal_beams) {
            let slot = slot_of(place.body);
            let (own, twist) = (ideal.poses[slot], ideal.twists[slot]);
            set_undeformed(place, numbers, (&own, &twist), &mut coordinates, &mut rates);
        }
        (coordinates, rates)
    }
}

/// Largest distance of two points of one body, m; of the points of the ground, only those that joints use count.
fn size_m(model: &Model, values: &Values) -> f64 {
    let mut size_m = 0.0_f64;
    for body in &model.bodies {
        let points: Vec<Vec2<f64>> = body
            .points
            .iter()
            .map(|point| Vec2::new(values[point.position_m[0]], values[point.position_m[1]]))
            .collect();
        for (index, first) in points.iter().enumerate() {
            for second in &points[index + 1..] {
                size_m = size_m.max((*first - *second).length());
            }
        }
    }
    // A mechanism of points only (sliders) has no size of its own: a centimetre keeps the tolerances sensible.
    if size_m > 0.0 { size_m } else { 0.01 }
}
