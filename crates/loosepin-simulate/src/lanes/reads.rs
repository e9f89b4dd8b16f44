//! Layout of the numbers that are read at the end of a step.

use crate::stepping::motion::Motion;
use loosepin_math::{KnownAngle, Real};
use loosepin_mechanics::mechanism::{Arms, Mechanism};
use loosepin_mechanics::model::{PlayId, PlayParts, Reading};

/// Layout of the row. Time, gaps and outputs stand with their first two derivatives over the variable of integration.
#[derive(Debug, Clone, Copy)]
pub struct ReadLayout {
    contacts: usize,
    outputs: usize,
    /// Ideal joints with friction.
    frictions: usize,
    /// Whether the share of each contact in the force of its law is read as well: in a slot, and in a guide with ends, it differs from
    /// place to place; and on an elastic foundation.
    has_shares: bool,
    /// Whether the abscissas of corners are read as well, where some guide has ends.
    has_ends: bool,
    /// Whether the places of pins along their slots are read as well, with two derivatives.
    has_slots: bool,
    /// Bodies whose angle has a sine and cosine of its own.
    turning: usize,
}

impl ReadLayout {
    /// For the contacts of `mechanism` and this many followed outputs.
    pub fn new(mechanism: &Mechanism, outputs: usize) -> Self {
        let parts = mechanism.plays.iter().filter_map(|play| match *play {
            PlayId::Joint(joint) => mechanism.model.joints[joint.0].kind.play_parts(),
            PlayId::Coupling(_) => None,
        });
        let parts: Vec<PlayParts<'_>> = parts.collect();
        let has_ends = parts.iter().any(|parts| parts.has_face_ends());
        let has_slots = parts.iter().any(|parts| parts.is_in_slot());
        let is_worn = mechanism.model.has_worn_geometry();
        Self {
            contacts: mechanism.contacts.len(),
            outputs,
            frictions: mechanism.model.joints.iter().filter(|joint| joint.friction.is_some()).count(),
            has_shares: is_worn || parts.iter().any(|parts| parts.has_shares()),
            has_ends,
            has_slots,
            turning: mechanism.real.turning_slots().count(),
        }
    }
    /// Length of the row.
    pub fn length(&self) -> usize {
        self.angle(self.turning)
    }
    /// The angle of a body, rad, its sine and its cosine; by number among [`loosepin_mechanics::mechanism::Tree::turning_slots`].
    #[inline(always)]
    pub fn angle(&self, turning: usize) -> usize {
        self.friction(self.frictions) + 3 * turning
    }
    /// Bodies whose angle is read.
    pub fn turning(&self) -> usize {
        self.turning
    }
    /// The residual of an ideal joint with friction: see [`loosepin_mechanics::dynamics::Dynamics::joint_friction_residuals`].
    #[inline(always)]
    pub fn friction(&self, index: usize) -> usize {
        self.gap(self.contacts) + 3 * self.outputs + index
    }
    /// Ideal joints with friction.
    pub fn frictions(&self) -> usize {
        self.frictions
    }
    /// The time, s.
    pub const TIME: usize = 0;
    /// Mechanical energy, J.
    pub const ENERGY: usize = 3;
    /// Kinetic energy of the bodies that drives alone do not carry, J: the sum of all energies hides the exchange between them.
    pub const FREE_KINETIC: usize = 4;
    /// The gap function of a contact, or the root of its penetration where that is an unknown, √m.
    #[inline(always)]
    pub fn gap(&self, contact: usize) -> usize {
        let of_places = usize::from(self.has_shares) + usize::from(self.has_ends) + 3 * usize::from(self.has_slots);
        5 + (4 + of_places) * contact
    }
    /// Sliding velocity of a contact, m/s; zero where there is no friction.
    #[inline(always)]
    pub fn sliding(&self, contact: usize) -> usize {
        self.gap(contact) + 3
    }
    /// Force at the contact's place over that of its law, where it is read.
    #[inline(always)]
    pub fn share(&self, contact: usize) -> Option<usize> {
        self.has_shares.then_some(self.gap(contact) + 4)
    }
    /// Abscissa of a corner along its guide, m, where it is read.
    #[inline(always)]
    pub fn along(&self, contact: usize) -> Option<usize> {
        self.has_ends.then_some(self.gap(contact) + 4 + usize::from(self.has_shares))
    }
    /// ξ of a pin along its slot's line with its first two derivatives, where some joint is a slot with play; zeros of other contacts.
    #[inline(always)]
    pub fn along_slot(&self, contact: usize) -> Option<usize> {
        let before = usize::from(self.has_shares) + usize::from(self.has_ends);
        self.has_slots.then_some(self.gap(contact) + 4 + before)
    }
    /// A followed output.
    #[inline(always)]
    pub fn output(&self, output: usize) -> usize {
        self.gap(self.contacts) + 3 * output
    }
}

impl<T: Real> Motion<'_, T> {
    /// Reads times, gaps, outputs and energy off the state that was evaluated last.
    #[inline(always)]
    pub fn read(&self, readings: &[Reading], arms: &Arms<T>, row: &mut [T]) {
        let layout = ReadLayout::new(self.dynamics.mechanism(), readings.len());
        let [pace, change] = self.pace();
        let dynamics = &self.dynamics;
        // d/ds = w d/dt and d²/ds² = w² d²/dt² + w' d/dt.
        let over_s = |[value, rate, acceleration]: [T; 3]| {
            [value, rate * pace, (pace * pace).mul_add(acceleration, change * rate)]
        };
        let half = T::from_f64(0.5);
        row[..3].copy_from_slice(&[self.time_s, pace, change]);
        let energy = dynamics.energy_in(
            #[inline(always)]
            |contact| self.states[contact].contact,
        );
        row[ReadLayout::ENERGY] = energy.total_j();
        row[ReadLayout::FREE_KINETIC] = energy.free_kinetic_j;
        for (contact, (unknowns, force)) in self.unknowns.iter().zip(dynamics.contacts()).enumerate() {
            let motion = dynamics.gap(contact);
            let mut gap = over_s(motion.gap);
            if let Some(root) = &unknowns.root {
                let is_unknown = half.less_than(root.is_unknown);
                // u' = δ̇/2, u'' = w δ̈/2.
                let second = motion.penetration_acceleration_m_s2 * half * pace;
                for (value, over_root) in gap.iter_mut().zip([root.root, half * force.penetration_rate_m_s, second]) {
                    *value = T::select(is_unknown, over_root, *value);
                }
            }
            row[layout.gap(contact)..layout.gap(contact) + 3].copy_from_slice(&gap);
            row[layout.sliding(contact)] = force.sliding_m_s;
            if let Some(place) = layout.share(contact) {
                row[place] = force.force_share;
            }
            if let Some(place) = layout.along(contact) {
                row[place] = force.along_m;
            }
            if let Some(place) = layout.along_slot(contact) {
                row[place..place + 3].copy_from_slice(&over_s(motion.along));
            }
        }
        dynamics.joint_friction_residuals(
            #[inline(always)]
            |index, residual| row[layout.friction(index)] = residual,
        );
        for (k, reading) in readings.iter().enumerate() {
            let place = layout.output(k);
            row[place..place + 3].copy_from_slice(&over_s(reading.jet(arms, dynamics)));
        }
        for (turning, slot) in dynamics.mechanism().real.turning_slots().enumerate() {
            let (place, pose) = (layout.angle(turning), &dynamics.kinematics.poses[slot]);
            row[place..place + 3].copy_from_slice(&[pose.angle_rad(), pose.rotation.sine, pose.rotation.cosine]);
        }
    }

    /// Takes the angles of all bodies, with sines and cosines, from a `row` that was read at the start of a step: evaluations
    /// [near it](Self::set_near) begin there.
    #[inline(always)]
    pub fn set_known_angles(&mut self, reads: &ReadLayout, row: &[T]) {
        for (turning, slot) in self.dynamics.mechanism().real.turning_slots().enumerate() {
            let place = reads.angle(turning);
            let known = KnownAngle { angle_rad: row[place], sine: row[place + 1], cosine: row[place + 2] };
            self.dynamics.kinematics.set_known_angle(slot, known);
        }
    }

    /// Says whether states from now on lie within the step from whose start angles are known: no body turns by more than
    /// [`loosepin_math::NEAR_RAD`] in a step.
    #[inline(always)]
    pub fn set_near(&mut self, is_near: bool) {
        self.dynamics.kinematics.set_near(is_near);
    }
}
