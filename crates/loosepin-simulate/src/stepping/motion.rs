//! The state vector of a run, or of one run a lane, and its derivative.
//!
//! One integrates over s with dt/ds = w. Mostly w = 1 and s is the time. During a contact whose law is K δ^1.5 without
//! friction or oil, the root u = √δ is an unknown of its own and w = u: then K u³ and everything else is smooth from the beginning
//! of the contact to its end, where K δ^1.5 is not, and a method of high order keeps its order. One contact at a time is treated
//! so; contacts that begin meanwhile, or gently, take δ from the positions.

use loosepin_math::Real;
use loosepin_math::integrate::System;
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::{ContactForce, ContactUnknowns, DepthRoot, Dynamics, PlayState};
use loosepin_mechanics::mechanism::{Mechanism, PlayGeometry, Sample};
use loosepin_mechanics::model::{PlayId, SlidingVelocity};

/// Integrals of the energy account that every mechanism has: work supplied, contact loss, friction loss, J.
const ACCOUNT: usize = 3;

/// Layout of the state vector: coordinates, rates, time, roots of penetrations, deflections of bristles and integrals of errors of
/// controls; then the integrals of the energy account, and the losses of monitored frictions.
#[derive(Debug, Clone)]
pub struct Layout {
    /// Free coordinates.
    pub freedoms: usize,
    /// Place of the root of each contact that has one.
    pub roots: Vec<Option<usize>>,
    /// Place of the deflection of the bristles of each contact whose friction law has them.
    pub bristles: Vec<Option<usize>>,
    /// Place of the integral of the error of each control that has one.
    pub error_integrals: Vec<Option<usize>>,
    /// Place of the deflection of the bristles of each ideal joint whose friction law has them.
    pub joint_bristles: Vec<Option<usize>>,
    /// Unknowns without integrals.
    pub dimension: usize,
    /// Whether the loss of dampers is an integral as well, the one behind those of all mechanisms.
    pub has_dampers: bool,
    /// Frictions whose own loss is an integral, behind all others: it may come out below zero.
    pub watched: Vec<Watched>,
    /// Joints with play whose friction path ∫F_N |v_T| dt is an integral, the last ones: indices in [`Mechanism::plays`].
    pub friction_paths: Vec<usize>,
}

/// Friction that may give back more than it took: with a memory, or by another velocity than that of the materials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Watched {
    /// A joint with play: its index in [`Mechanism::plays`].
    Play(usize),
    /// Of an ideal joint: its index in [`Sample::frictions`].
    Joint(usize),
}

impl Watched {
    fn all<T: Real>(sample: &Sample<T>) -> Vec<Self> {
        let is_literal =
            |play: &PlayGeometry<T>| play.friction.acts() && play.sliding_velocity == SlidingVelocity::Literal;
        let plays = sample.plays.iter().enumerate();
        let plays = plays.filter(|(_, play)| play.friction.has_bristle() || is_literal(play));
        let joints = sample.frictions.iter().enumerate().filter(|(_, friction)| friction.law.has_bristle());
        plays.map(|(play, _)| Self::Play(play)).chain(joints.map(|(joint, _)| Self::Joint(joint))).collect()
    }

    /// The joint.
    pub fn joint(self, mechanism: &Mechanism, sample: &Sample<f64>) -> PlayId {
        match self {
            Self::Play(play) => mechanism.plays[play],
            Self::Joint(index) => PlayId::Joint(sample.frictions[index].joint),
        }
    }
}

impl Layout {
    /// The layout for `mechanism` with the contacts of `sample`.
    pub fn new<T: Real>(mechanism: &Mechanism, sample: &Sample<T>) -> Self {
        let freedoms = mechanism.real.free;
        let mut dimension = 2 * freedoms + 1;
        let mut place_if = |is_there: bool| {
            is_there.then(|| {
                dimension += 1;
                dimension - 1
            })
        };
        let has_root =
            |play: &PlayGeometry<T>| play.is_smooth_in_root() && !play.friction.acts() && play.film.is_none();
        let contacts = 0..sample.contacts.len();
        let roots = contacts.clone().map(|contact| place_if(has_root(sample.play_of(contact)))).collect();
        let bristles = contacts.map(|contact| place_if(sample.play_of(contact).friction.has_bristle())).collect();
        let joint_bristles = sample.frictions.iter().map(|friction| place_if(friction.law.has_bristle())).collect();
        let controls = sample.controls.iter();
        let error_integrals = controls.map(|control| place_if(control.integral.is_some())).collect();
        let has_dampers = mechanism.has_dampers();
        let watched = Watched::all(sample);
        let wearing = sample.plays.iter().enumerate().filter(|(_, play)| play.wears);
        let friction_paths = wearing.map(|(play, _)| play).collect();
        Self {
            freedoms,
            roots,
            bristles,
            joint_bristles,
            error_integrals,
            dimension,
            has_dampers,
            watched,
            friction_paths,
        }
    }

    /// Place of the time.
    pub fn time(&self) -> usize {
        2 * self.freedoms
    }

    /// Unknowns and integrals.
    pub fn length(&self) -> usize {
        self.dimension + self.integrals()
    }

    /// Integrals: those of the energy account, then the losses of what is watched, then friction paths.
    pub fn integrals(&self) -> usize {
        self.account_integrals() + self.watched.len() + self.friction_paths.len()
    }

    /// Integrals of the energy account.
    fn account_integrals(&self) -> usize {
        ACCOUNT + usize::from(self.has_dampers)
    }

    /// Place of the loss of each friction that is watched.
    pub fn watched_losses(&self) -> impl Iterator<Item = (usize, Watched)> + '_ {
        let first = self.dimension + self.account_integrals();
        self.watched.iter().enumerate().map(move |(index, watched)| (first + index, *watched))
    }

    /// Place of each friction path, with the index of its joint in [`Mechanism::plays`].
    pub fn friction_path_places(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let first = self.dimension + self.account_integrals() + self.watched.len();
        self.friction_paths.iter().enumerate().map(move |(index, play)| (first + index, *play))
    }

    /// The energy account in a state.
    #[inline(always)]
    pub fn account<T: Real>(&self, state: &[T]) -> EnergyTotals<T> {
        self.account_by(
            #[inline(always)]
            |place| state[place],
        )
    }

    /// The same of a state, or of its slope, whose numbers `number` reads.
    #[inline(always)]
    pub fn account_by<T: Real>(&self, number: impl Fn(usize) -> T) -> EnergyTotals<T> {
        let first = self.dimension;
        EnergyTotals {
            supplied_j: number(first),
            contact_loss_j: number(first + 1),
            friction_loss_j: number(first + 2),
            damping_loss_j: if self.has_dampers { number(first + ACCOUNT) } else { T::zero() },
        }
    }
}

/// Energy supplied and lost since time zero, J.
#[derive(Debug, Clone, Copy)]
pub struct EnergyTotals<T> {
    /// Work of drives, loads and actuators.
    pub supplied_j: T,
    /// Turned into heat by normal contact.
    pub contact_loss_j: T,
    /// Turned into heat by friction and by films of oil.
    pub friction_loss_j: T,
    /// Turned into heat by dampers.
    pub damping_loss_j: T,
}

/// Equations of motion with the time and the roots of penetrations as unknowns, and the energy account as integrals.
pub struct Motion<'a, T: Real> {
    /// The equations.
    pub dynamics: Dynamics<'a, T>,
    /// States of the contacts.
    pub states: Vec<PlayState<T>>,
    /// Roots of penetrations of the contacts that have one, and deflections of bristles.
    pub unknowns: Vec<ContactUnknowns<T>>,
    /// Layout of the state vector.
    pub layout: Layout,
    /// The time of the last evaluation, s.
    pub time_s: T,
    /// Whether any contact has a root among the unknowns; else w = 1.
    has_roots: bool,
}

impl<'a, T: Real> Motion<'a, T> {
    /// With every contact open.
    pub fn new(mechanism: &'a Mechanism, sample: &Sample<T>) -> Self {
        let layout = Layout::new(mechanism, sample);
        let known = DepthRoot { is_unknown: T::zero(), root: T::zero(), may_be_read: true };
        Self {
            dynamics: Dynamics::new(mechanism, sample),
            states: vec![PlayState::flight(); mechanism.contacts.len()],
            unknowns: layout
                .roots
                .iter()
                .zip(&layout.bristles)
                .map(|(root, bristle)| ContactUnknowns {
                    root: root.map(|_| known),
                    bristle_m: bristle.map(|_| T::zero()),
                })
                .collect(),
            has_roots: layout.roots.iter().any(Option::is_some),
            time_s: T::zero(),
            layout,
        }
    }

    /// Number of free coordinates.
    pub fn freedoms(&self) -> usize {
        self.layout.freedoms
    }

    /// Sets positions and velocities from the state vector, without forces.
    #[inline(always)]
    pub fn set_state(&mut self, time_s: T, state: &[T]) {
        let n = self.layout.freedoms;
        self.dynamics.set_state(time_s, &state[..n], &state[n..2 * n]);
    }

    /// Sets positions and velocities and evaluates all forces and accelerations.
    #[inline(always)]
    pub fn evaluate(&mut self, time_s: T, state: &[T]) {
        let n = self.layout.freedoms;
        self.time_s = time_s;
        for (contact, unknowns) in self.unknowns.iter_mut().enumerate() {
            if let (Some(root), Some(place)) = (&mut unknowns.root, self.layout.roots[contact]) {
                root.root = state[place];
            }
            if let (Some(bristle_m), Some(place)) = (&mut unknowns.bristle_m, self.layout.bristles[contact]) {
                *bristle_m = state[place];
            }
        }
        for (index, place) in self.layout.joint_bristles.iter().enumerate() {
            if let Some(place) = place {
                self.dynamics.set_joint_bristle(index, state[*place]);
            }
        }
        for (control, place) in self.layout.error_integrals.iter().enumerate() {
            if let Some(place) = place {
                self.dynamics.error_integrals_mut()[control] = state[*place];
            }
        }
        self.dynamics.evaluate_with_unknowns(time_s, &state[..n], &state[n..2 * n], &self.states, &self.unknowns);
    }

    /// Force of the contact `contact` at the state set last, with δ from the positions.
    pub fn contact_force(&self, contact: usize) -> ContactForce<T> {
        self.dynamics.contact_force(contact, &self.states[contact])
    }

    /// Power that one friction that is watched turns into heat, W: without the film of oil beside it.
    #[inline(always)]
    fn own_friction_loss_w(&self, watched: Watched) -> T {
        match watched {
            Watched::Joint(index) => self.dynamics.own_joint_friction_loss_w(index),
            Watched::Play(play) => {
                let mut loss_w = T::zero();
                let contacts = self.dynamics.mechanism().contacts.iter().zip(self.dynamics.contacts());
                for (_, force) in contacts.filter(|(at, _)| at.play == play) {
                    loss_w += force.friction_loss_w - force.film_loss_w;
                }
                loss_w
            }
        }
    }

    /// Σ F_N |v_T| over the contacts of a joint with play at the last evaluation, W.
    #[inline(always)]
    fn friction_path_w(&self, play: usize) -> T {
        let contacts = self.dynamics.mechanism().contacts.iter().zip(self.dynamics.contacts());
        contacts.filter(|(at, _)| at.play == play).fold(T::zero(), |sum, (_, force)| sum + force.friction_path_w())
    }

    /// w = dt/ds and dw/ds at the last evaluation.
    #[inline(always)]
    pub fn pace(&self) -> [T; 2] {
        let (mut pace, mut change) = (T::one(), T::zero());
        if self.has_roots {
            for (unknowns, force) in self.unknowns.iter().zip(self.dynamics.contacts()) {
                if let Some(root) = &unknowns.root {
                    let is_unknown = T::from_f64(0.5).less_than(root.is_unknown);
                    pace = T::select(is_unknown, root.root, pace);
                    change = T::select(is_unknown, T::from_f64(0.5) * force.penetration_rate_m_s, change);
                }
            }
        }
        [pace, change]
    }
}

impl<T: Real> System<T> for Motion<'_, T> {
    #[inline(always)]
    fn derivative(&mut self, state: &[T], slope: &mut [T]) {
        let n = self.layout.freedoms;
        self.evaluate(state[self.layout.time()], state);
        let [pace, change] = self.pace();
        for k in 0..n {
            slope[k] = state[n + k] * pace;
            slope[n + k] = self.dynamics.accelerations()[k] * pace;
        }
        slope[2 * n] = pace;
        for (unknowns, place) in self.unknowns.iter().zip(&self.layout.roots) {
            if let (Some(root), Some(place)) = (&unknowns.root, place) {
                // u' = δ̇/2 with dt = u ds.
                slope[*place] = change * root.is_unknown;
            }
        }
        for (contact, place) in self.layout.bristles.iter().enumerate() {
            if let Some(place) = place {
                // In flight bristles stand still.
                slope[*place] =
                    self.dynamics.contacts()[contact].bristle_rate_m_s * pace * self.states[contact].contact;
            }
        }
        for (index, place) in self.layout.joint_bristles.iter().enumerate() {
            if let Some(place) = place {
                slope[*place] = self.dynamics.joint_bristle_rate_m_s(index) * pace;
            }
        }
        for (actuator, place) in self.dynamics.actuators().iter().zip(&self.layout.error_integrals) {
            if let Some(place) = place {
                slope[*place] = actuator.error * pace;
            }
        }
        let powers = self.dynamics.powers();
        let account = self.layout.dimension;
        slope[account] = powers.drives_w * pace;
        if !self.dynamics.loads().is_empty() {
            slope[account] += powers.loads_w * pace;
        }
        if !self.dynamics.actuators().is_empty() {
            slope[account] += powers.controls_w * pace;
        }
        slope[account + 1] = powers.contact_loss_w * pace;
        slope[account + 2] = powers.friction_loss_w * pace;
        if self.layout.has_dampers {
            slope[account + ACCOUNT] = powers.damping_loss_w * pace;
        }
        for (place, watched) in self.layout.watched_losses() {
            slope[place] = self.own_friction_loss_w(watched) * pace;
        }
        for (place, play) in self.layout.friction_path_places() {
            slope[place] = self.friction_path_w(play) * pace;
        }
    }
}

/// Local error tolerances of all unknowns for a local error of `local_m` in lengths.
///
/// Angles: divided by the size of the mechanism; so the lateral shapes of a beam, whose coordinates are turns of its ends, and the slopes of nodes. Velocities: times the rate of the fastest drive. The time: the angle's over
/// that rate, and so integrals of errors of controls. Roots: one, since that of u = √δ is `local_m`/(2u) and changes with every
/// step. Deflections of bristles: the same share of their largest in steady sliding as a length has of the size. With oil, with
/// friction, whose kinks the work of friction shows one derivative earlier than the velocities, with forces that begin as
/// abruptly, and with actuators that meet their limits, also the energy account: the same share of `energy_j` as a length has of the
/// size.
pub fn tolerances(
    mechanism: &Mechanism,
    layout: &Layout,
    sample: &Sample<f64>,
    local_m: f64,
    rate_1_s: f64,
    energy_j: f64,
) -> Vec<f64> {
    let tree = &mechanism.real;
    let n = tree.free;
    let local_rad = local_m / mechanism.size_m;
    let mut tolerances = vec![1.0; layout.dimension];
    tolerances[..n].fill(local_rad);
    for link in &tree.links {
        if !link.is_driven {
            tolerances[link.lengths()].fill(local_m);
        }
    }
    for beam in &tree.beams {
        tolerances[beam.axial()].fill(local_m);
    }
    for lengths in tree.nodal_beams.iter().flat_map(|beam| beam.lengths()) {
        tolerances[lengths].fill(local_m);
    }
    for k in 0..n {
        tolerances[n + k] = tolerances[k] * rate_1_s;
    }
    tolerances[2 * n] = local_rad / rate_1_s;
    for (contact, place) in layout.bristles.iter().enumerate() {
        if let Some(place) = place {
            tolerances[*place] = local_rad * sample.play_of(contact).friction.largest_deflection_m();
        }
    }
    for (place, friction) in layout.joint_bristles.iter().zip(&sample.frictions) {
        if let Some(place) = place {
            tolerances[*place] = local_rad * friction.law.largest_deflection_m();
        }
    }
    for ((place, control), numbers) in
        layout.error_integrals.iter().zip(&mechanism.model.controls).zip(&sample.controls)
    {
        if let (Some(place), Some(_)) = (place, numbers.integral) {
            let is_length = mechanism.model.joints[control.measured.0].kind.slides();
            tolerances[*place] = if is_length { local_m } else { local_rad } / rate_1_s;
        }
    }
    let has_limits = sample.controls.iter().any(|control| control.limit.is_some());
    let is_abrupt =
        |play: &PlayGeometry<f64>| play.friction.acts() || play.film.is_some() || play.normal.has_abrupt_onset();
    if has_limits || !sample.frictions.is_empty() || sample.plays.iter().any(is_abrupt) {
        tolerances.extend(vec![local_rad * energy_j; layout.account_integrals()]);
    }
    tolerances
}
