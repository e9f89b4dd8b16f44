//! Mass matrix, forces and accelerations.

use super::bodies::BodyEquations;
use super::inverse::InverseDynamics;
use crate::contact::PlayState;
use crate::dynamics::elements::beam_workspace::BeamWorkspace;
use crate::dynamics::elements::element_force::{ActuatorForce, LoadForce};
use crate::dynamics::elements::joint_friction::JointFrictions;
use crate::dynamics::elements::nodal_workspace::NodalWorkspace;
use crate::dynamics::play::contact_motion::{ContactForce, ContactUnknowns, GapMotion};
use crate::dynamics::play::motion::PlayMotion;
use crate::mechanism::constraints;
use crate::mechanism::{JointPlace, Kinematics, Mechanism, Sample, TimeDual, Twist, acceleration_at, workspace_length};
use crate::model::{ActsOn, FeedForward, PlayId, TimeCourse};
use loosepin_math::{Dual, Real, Vec2};

/// Powers that the energy account integrates, W.
#[derive(Debug, Clone, Copy)]
pub struct Powers<T> {
    /// Supplied by all drives.
    pub drives_w: T,
    /// Supplied by all loads.
    pub loads_w: T,
    /// Supplied by the actuators of all controls.
    pub controls_w: T,
    /// Turned into heat by normal contact.
    pub contact_loss_w: T,
    /// Turned into heat by friction.
    pub friction_loss_w: T,
    /// Turned into heat by dampers.
    pub damping_loss_w: T,
}

/// The equations of motion of one sample, with room for everything that an evaluation needs.
///
/// State: coordinates and rates of the real tree, free ones first; the driven ones are filled in here from the time.
#[derive(Debug, Clone)]
pub struct Dynamics<'a, T: Real> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) sample: Sample<T>,
    /// Poses, velocities and biases at the last evaluation.
    pub kinematics: Kinematics<T>,
    /// Coordinates and rates of the last evaluation, driven ones filled in.
    pub(super) coordinates: Vec<T>,
    pub(super) rates: Vec<T>,
    pub(super) driven_accelerations: Vec<T>,
    /// Slots of bearing body and journal body of each joint with play; both the ground for a coupling.
    pub(super) play_slots: Vec<[usize; 2]>,
    pub(super) plays: Vec<PlayMotion<T>>,
    /// Forces of all contacts.
    pub(super) contacts: Vec<ContactForce<T>>,
    /// Whether there are springs, loads or controls.
    has_elements: bool,
    /// Slots of first and second body of each spring.
    pub(super) spring_slots: Vec<[usize; 2]>,
    /// Power that the dampers turned into heat at the last evaluation, W.
    pub(super) damping_loss_w: T,
    /// Room for flexible bodies.
    pub(super) beam_workspaces: Vec<BeamWorkspace<T>>,
    /// Room for flexible bodies in absolute nodal coordinates.
    pub(super) nodal_workspaces: Vec<NodalWorkspace<T>>,
    /// Power that the damping of flexible bodies turned into heat at the last evaluation, W.
    pub(super) beam_loss_w: T,
    /// Loads at the last evaluation.
    pub(super) loads: Vec<LoadForce<T>>,
    /// Power of the loads at the last evaluation, W.
    pub(super) loads_w: T,
    /// Places of the actuator's and of the measured joint of each control.
    pub(super) control_places: Vec<[JointPlace; 2]>,
    /// Actuators at the last evaluation.
    pub(super) actuators: Vec<ActuatorForce<T>>,
    /// Integrals of the errors of the controls, rad s or m s.
    pub(super) error_integrals: Vec<T>,
    /// Power of the actuators at the last evaluation, W.
    pub(super) controls_w: T,
    /// The equations behind the torques that controls feed forward.
    pub(super) inverse: Option<InverseDynamics<'a, T>>,
    /// Room for the functions of loads and controls.
    pub(super) function_workspace: Vec<T>,
    /// Room for the functions of drives.
    pub(super) drive_workspace: Vec<TimeDual<T>>,
    /// Time of the last state, s.
    pub(super) time_s: T,
    /// Accelerations, constraint forces, mass matrix and forces.
    pub(super) equations: BodyEquations<T>,
    /// Friction in ideal joints, where there is any.
    pub(super) joint_frictions: Option<JointFrictions<T>>,
}

impl<'a, T: Real> Dynamics<'a, T> {
    /// Room for `mechanism` with the numbers of `sample`.
    pub fn new(mechanism: &'a Mechanism, sample: &Sample<T>) -> Self {
        let tree = &mechanism.real;
        let z = tree.coordinates();
        let kinematics = Kinematics::new(tree);
        let play_slots: Vec<[usize; 2]> = mechanism
            .plays
            .iter()
            .map(|play| match play {
                PlayId::Joint(joint) => {
                    mechanism.model.joints[joint.0].kind.points().map(|point| tree.slot_of_point(point))
                }
                // A coupling acts on the bodies of two joints.
                PlayId::Coupling(_) => [0, 0],
            })
            .collect();
        let plays: Vec<_> = play_slots
            .iter()
            .zip(&sample.plays)
            .map(|(&slots, play)| PlayMotion::between(&kinematics, slots, play))
            .collect();
        let contacts = sample
            .contacts
            .iter()
            .map(|at| plays[at.play].force(&sample.plays[at.play], at.place, &PlayState::flight()))
            .collect();
        let springs = mechanism.model.springs.iter();
        let loads = mechanism.model.loads.iter().map(|load| LoadForce {
            slot: match load.kind.acts_on() {
                ActsOn::Point(point) => tree.slot_of_point(point),
                ActsOn::Body(body) => tree.slot_of_body[body.0],
            },
            arm_m: Vec2::zero(),
            force_n: Vec2::zero(),
            torque_n_m: T::zero(),
        });
        let loads = loads.collect();
        let fed_forward = mechanism.model.controls.iter().filter_map(|control| match &control.feed_forward {
            FeedForward::TimeCourse(course) => Some(course),
            FeedForward::None | FeedForward::InverseDynamics => None,
        });
        let courses = mechanism.model.loads.iter().filter_map(|load| load.course.as_ref()).chain(fed_forward);
        let steps = courses.map(|course| match course {
            TimeCourse::Function(function) => function.steps(),
            _ => 0,
        });
        let function_steps = steps.max().unwrap_or(0);
        Self {
            mechanism,
            sample: sample.clone(),
            kinematics,
            coordinates: vec![T::zero(); z],
            rates: vec![T::zero(); z],
            driven_accelerations: vec![T::zero(); tree.drives.len()],
            play_slots,
            plays,
            contacts,
            has_elements: !(mechanism.model.springs.is_empty()
                && mechanism.model.loads.is_empty()
                && mechanism.model.controls.is_empty()),
            spring_slots: springs
                .map(|spring| match spring.kind.points() {
                    Some(points) => points.map(|point| tree.slot_of_point(point)),
                    None => spring.kind.bodies().map(|body| tree.slot_of_body[body.0]),
                })
                .collect(),
            beam_workspaces: tree
                .beams
                .iter()
                .map(|beam| BeamWorkspace::new(beam, tree.links[beam.slot - 1].dependences.len()))
                .collect(),
            nodal_workspaces: tree
                .nodal_beams
                .iter()
                .map(|beam| NodalWorkspace::new(beam.mesh.nodes(), tree.links[beam.slot - 1].dependences.len()))
                .collect(),
            beam_loss_w: T::zero(),
            damping_loss_w: T::zero(),
            loads,
            loads_w: T::zero(),
            control_places: mechanism.control_places(),
            actuators: vec![ActuatorForce::none(); mechanism.model.controls.len()],
            error_integrals: vec![T::zero(); mechanism.model.controls.len()],
            controls_w: T::zero(),
            inverse: mechanism.known_chain.as_ref().map(InverseDynamics::new),
            function_workspace: vec![T::zero(); function_steps],
            drive_workspace: vec![Dual::constant(Dual::constant(T::zero())); workspace_length(&mechanism.model)],
            time_s: T::zero(),
            equations: BodyEquations::new(tree, tree.constraint_scales()),
            joint_frictions: JointFrictions::new(mechanism, sample),
        }
    }

    /// Poses and velocities at `time_s` for the free coordinates and rates: what contact events need, without forces.
    pub fn set_state(&mut self, time_s: T, free_coordinates: &[T], free_rates: &[T]) {
        let tree = &self.mechanism.real;
        let n = tree.free;
        self.time_s = time_s;
        self.coordinates[..n].copy_from_slice(&free_coordinates[..n]);
        self.rates[..n].copy_from_slice(&free_rates[..n]);
        for (k, drive) in tree.drives.iter().enumerate() {
            let motion = self.sample.drives.motion(*drive, time_s, &mut self.drive_workspace);
            [self.coordinates[n + k], self.rates[n + k], self.driven_accelerations[k]] = motion;
        }
        self.kinematics.set_positions(tree, &self.sample.real, &self.coordinates);
        self.kinematics.set_velocities(tree, &self.rates);
        if !self.nodal_workspaces.is_empty() {
            self.set_nodes();
        }
        for ((slots, play), entry) in self.play_slots.iter().zip(&self.sample.plays).zip(&mut self.plays) {
            *entry = PlayMotion::between(&self.kinematics, *slots, play);
        }
    }

    /// Evaluates the equations of motion: accelerations, joint forces and powers.
    pub fn evaluate(&mut self, time_s: T, free_coordinates: &[T], free_rates: &[T], states: &[PlayState<T>]) {
        self.evaluate_with_unknowns(time_s, free_coordinates, free_rates, states, &[]);
    }

    /// Evaluates the equations of motion with roots of penetrations and deflections of bristles as unknowns: an entry for each
    /// contact, or none at all.
    #[inline(never)]
    pub fn evaluate_with_unknowns(
        &mut self,
        time_s: T,
        free_coordinates: &[T],
        free_rates: &[T],
        states: &[PlayState<T>],
        unknowns: &[ContactUnknowns<T>],
    ) {
        self.set_state(time_s, free_coordinates, free_rates);
        self.set_forces(states, unknowns);
        if let Some(frictions) = &mut self.joint_frictions {
            frictions.begin(&self.kinematics, &self.sample.frictions);
        }
        self.add_bodies();
        if self.has_beams() {
            self.add_beams();
        }
        if self.has_elements {
            self.add_elements();
        }
        self.add_plays();
        self.solve();
        self.add_joint_friction();
    }

    #[inline(always)]
    fn has_beams(&self) -> bool {
        !(self.beam_workspaces.is_empty() && self.nodal_workspaces.is_empty())
    }

    /// Forces of springs, loads and actuators. Not every mechanism has them: out of line, or the compiler would take many times as
    /// long for the evaluation as a whole.
    #[inline(never)]
    fn add_elements(&mut self) {
        self.add_springs();
        self.add_loads();
        self.add_controls();
    }

    /// Biases of the accelerations, and forces in the joints with play.
    #[inline(never)]
    fn set_forces(&mut self, states: &[PlayState<T>], unknowns: &[ContactUnknowns<T>]) {
        let tree = &self.mechanism.real;
        self.kinematics.set_biases(tree, &self.sample.real, &self.rates, &self.driven_accelerations);
        for (index, (force, at)) in self.contacts.iter_mut().zip(&self.sample.contacts).enumerate() {
            let unknowns = unknowns.get(index).copied().unwrap_or(ContactUnknowns::none());
            let (motion, play) = (&self.plays[at.play], &self.sample.plays[at.play]);
            *force = motion.force_with_unknowns(play, at.place, &states[index], &unknowns);
        }
    }

    /// Mass matrix and generalised forces of inertia and gravity.
    #[inline(never)]
    fn add_bodies(&mut self) {
        self.equations.begin(&self.mechanism.real, &self.sample.real, &self.kinematics);
    }

    /// Adds the forces of the joints with play.
    #[inline(never)]
    fn add_plays(&mut self) {
        for index in 0..self.contacts.len() {
            let (force, at) = (self.contacts[index], self.sample.contacts[index]);
            if self.sample.plays[at.play].shape.flanks().is_some() {
                self.add_flank_force(at.play, force.on_journal_n.x);
                continue;
            }
            let (motion, [slot_i, slot_j]) = (self.plays[at.play], self.play_slots[at.play]);
            self.add_force(slot_i, motion.bearing_arm_m, -force.on_journal_n, force.moment_on_bearing_n_m);
            self.add_force(slot_j, motion.journal_arm_m, force.on_journal_n, force.moment_on_journal_n_m);
        }
    }

    /// Adds a force that acts on the body in `slot` at `arm_m` from its origin (ground's frame), and a torque.
    #[inline(always)]
    pub(super) fn add_force(&mut self, slot: usize, arm_m: Vec2<T>, force_n: Vec2<T>, moment_n_m: T) {
        if slot == 0 {
            return;
        }
        if let Some(frictions) = &mut self.joint_frictions {
            frictions.take_force(slot, self.kinematics.poses[slot].position_m + arm_m, force_n, moment_n_m);
        }
        let about_origin_n_m = moment_n_m + arm_m.cross(force_n);
        self.kinematics.add_push(&self.mechanism.real, slot, force_n, about_origin_n_m, &mut self.equations.forces);
    }

    #[inline(never)]
    fn solve(&mut self) {
        let (tree, numbers, kinematics) = (&self.mechanism.real, &self.sample.real, &self.kinematics);
        self.equations.solve(|jacobian, biases| {
            constraints::jacobian(tree, numbers, kinematics, jacobian);
            constraints::biases(tree, numbers, kinematics, biases);
        });
    }

    /// Powers at the last evaluation. The drives' power is what their coordinates need: Σ (m a - F)·v over all bodies.
    #[inline(never)]
    pub fn powers(&self) -> Powers<T> {
        let mut powers = Powers {
            drives_w: T::zero(),
            loads_w: self.loads_w,
            controls_w: self.controls_w,
            contact_loss_w: T::zero(),
            friction_loss_w: T::zero(),
            damping_loss_w: self.damping_loss_w,
        };
        if self.has_beams() {
            powers.damping_loss_w += self.beam_loss_w;
        }
        for force in &self.contacts {
            powers.contact_loss_w += force.contact_loss_w;
            powers.friction_loss_w += force.friction_loss_w;
        }
        if self.joint_frictions.is_some() {
            powers.friction_loss_w += self.joint_friction_loss_w();
        }
        let tree = &self.mechanism.real;
        for k in 0..tree.drives.len() {
            powers.drives_w += self.drive_force(k) * self.rates[tree.free + k];
        }
        powers
    }

    /// Force (N) or torque (N m) of the tree's drive `k` along its coordinate, at the last evaluation.
    #[inline(never)]
    pub fn drive_force(&self, k: usize) -> T {
        self.equations.drive_force(k)
    }

    /// The mechanism that moves.
    pub fn mechanism(&self) -> &'a Mechanism {
        self.mechanism
    }
    /// The numbers of the mechanism.
    pub fn sample(&self) -> &Sample<T> {
        &self.sample
    }
    /// The numbers of the mechanism, to put another sample in place. The next evaluation uses them.
    pub fn sample_mut(&mut self) -> &mut Sample<T> {
        &mut self.sample
    }
    /// Free coordinates and rates at the last state that was set.
    pub fn free_state(&self) -> (&[T], &[T]) {
        let n = self.mechanism.real.free;
        (&self.coordinates[..n], &self.rates[..n])
    }
    /// Free accelerations q̈ at the last evaluation.
    pub fn accelerations(&self) -> &[T] {
        &self.equations.accelerations
    }
    /// Force of the contact `contact` at the state set last, in the contact state `state`.
    pub fn contact_force(&self, contact: usize, state: &PlayState<T>) -> ContactForce<T> {
        let at = self.sample.contacts[contact];
        self.plays[at.play].force(&self.sample.plays[at.play], at.place, state)
    }
    /// The gap function of the contact `contact` and its derivatives at the last evaluation.
    #[inline(never)]
    pub fn gap(&self, contact: usize) -> GapMotion<T> {
        let at = self.sample.contacts[contact];
        let motion = &self.plays[at.play];
        let play = &self.sample.plays[at.play];
        if let Some(flanks) = play.shape.flanks() {
            let acceleration = Vec2::new(self.flank_acceleration_m_s2(flanks), T::zero());
            return motion.gap(play, at.place, acceleration, [T::zero(); 2]);
        }
        let [i, j] = self.play_slots[at.play];
        let twists = &self.kinematics.twists;
        let (change_i, change_j) = (self.acceleration(i), self.acceleration(j));
        let acceleration = acceleration_at(&change_j, &twists[j], motion.journal_arm_m)
            - acceleration_at(&change_i, &twists[i], motion.bearing_arm_m);
        let spin_rates = [change_i.angular, change_j.angular];
        motion.gap(play, at.place, acceleration, spin_rates)
    }
    /// Slots of bearing body and journal body of the joints with play; both the ground for couplings.
    pub fn play_slots(&self) -> &[[usize; 2]] {
        &self.play_slots
    }
    /// Motion of the joints with play at the state set last.
    pub fn plays(&self) -> &[PlayMotion<T>] {
        &self.plays
    }
    /// Forces of the contacts at the last evaluation.
    pub fn contacts(&self) -> &[ContactForce<T>] {
        &self.contacts
    }
    /// Acceleration of the frame in `slot` at the last evaluation.
    #[inline(always)]
    pub fn acceleration(&self, slot: usize) -> Twist<T> {
        self.kinematics.acceleration(&self.mechanism.real, slot, &self.equations.accelerations)
    }
}

/// The loops of ideal joints at the last state that was set: what a projection onto them needs.
impl<T: Real> Dynamics<'_, T> {
    /// Residuals Φ of all constraint rows, m or sine of an angle.
    #[inline(always)]
    pub fn constraint_residuals(&self, out: &mut [T]) {
        constraints::residuals(&self.mechanism.real, &self.sample.real, &self.kinematics, out);
    }
    /// Jacobian dΦ/dz of all rows over all coordinates, row-major.
    #[inline(always)]
    pub fn constraint_jacobian(&self, out: &mut [T]) {
        constraints::jacobian(&self.mechanism.real, &self.sample.real, &self.kinematics, out);
    }
    /// Φ̇ of all rows for the present rates.
    #[inline(always)]
    pub fn constraint_rates(&self, jacobian: &[T], out: &mut [T]) {
        let columns = self.mechanism.real.coordinates();
        for (row, out) in out.iter_mut().enumerate() {
            let mut sum = T::zero();
            for (slope, rate) in jacobian[row * columns..(row + 1) * columns].iter().zip(&self.rates) {
                sum = slope.mul_add(*rate, sum);
            }
            *out = sum;
        }
    }
    /// The factors of M from the last evaluation.
    pub fn factored_mass(&self) -> &[T] {
        &self.equations.mass
    }
}
