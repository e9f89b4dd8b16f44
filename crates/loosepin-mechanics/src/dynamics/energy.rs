//! Kinetic, potential and stored energy.

use super::equations::Dynamics;
use loosepin_math::Real;

/// The mechanical energy of a mechanism, J.
#[derive(Debug, Clone, Copy)]
pub struct MechanicalEnergy<T> {
    /// Σ m v²/2 + I ω²/2.
    pub kinetic_j: T,
    /// The part of it in bodies that drives alone do not carry: what forces may put in and take out.
    pub free_kinetic_j: T,
    /// -Σ m g·r.
    pub potential_j: T,
    /// Σ ∫ F_el dδ over the contacts, Σ k (x - x0)²/2 + P (x - x0) over the springs, and the strain energy of flexible bodies.
    pub stored_j: T,
}

impl<T: Real> MechanicalEnergy<T> {
    /// Sum of both energies.
    pub fn total_j(&self) -> T {
        self.kinetic_j + self.potential_j + self.stored_j
    }
}

impl<T: Real> Dynamics<'_, T> {
    /// The mechanical energy at the last state that was set. `in_contact` tells which contacts hold energy.
    pub fn energy(&self, in_contact: impl Fn(usize) -> bool) -> MechanicalEnergy<T> {
        self.energy_in(|contact| if in_contact(contact) { T::one() } else { T::zero() })
    }

    /// The mechanical energy at the last state that was set; `closed` is one for contacts that are closed, zero for others.
    #[inline(always)]
    pub fn energy_in(&self, closed: impl Fn(usize) -> T) -> MechanicalEnergy<T> {
        let half = T::from_f64(0.5);
        let mut energy = MechanicalEnergy {
            kinetic_j: T::zero(),
            free_kinetic_j: T::zero(),
            potential_j: T::zero(),
            stored_j: T::zero(),
        };
        let tree = &self.mechanism.real;
        for (index, (link, numbers)) in tree.links.iter().zip(&self.sample.real.links).enumerate() {
            let slot = index + 1;
            let is_free = link.dependences.iter().any(|coordinate| *coordinate < tree.free);
            let of_beam = link.beam.map(|beam| self.beam_energy_j(beam));
            if let Some([kinetic_j, potential_j, strain_j]) =
                of_beam.or_else(|| link.nodal_beam.map(|beam| self.nodal_energy_j(beam)))
            {
                energy.kinetic_j += kinetic_j;
                energy.free_kinetic_j += kinetic_j;
                energy.potential_j += potential_j;
                energy.stored_j += strain_j;
            }
            if !link.has_own_mass {
                continue;
            }
            let pose = &self.kinematics.poses[slot];
            let twist = &self.kinematics.twists[slot];
            let arm = pose.turn(numbers.centre_of_mass_m);
            let velocity = twist.at(arm);
            let kinetic_j =
                half * (numbers.mass_kg * velocity.length_squared() + numbers.inertia_kg_m2 * twist.angular.squared());
            energy.kinetic_j += kinetic_j;
            if is_free {
                energy.free_kinetic_j += kinetic_j;
            }
            energy.potential_j -= numbers.mass_kg * self.sample.real.gravity_m_s2.dot(pose.position_m + arm);
        }
        for (contact, at) in self.sample.contacts.iter().enumerate() {
            let play = &self.sample.plays[at.play];
            let penetration_m = self.plays[at.play].penetration_at_m(play, at.place) * closed(contact);
            energy.stored_j += self.plays[at.play].stored_energy_j(play, at.place, penetration_m);
        }
        for index in 0..self.spring_slots.len() {
            energy.stored_j += self.spring_force(index).stored_j;
        }
        energy
    }
}
