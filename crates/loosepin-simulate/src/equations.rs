//! The equations of all lanes: machine code where there is any, else evaluated as they stand; the bits are the same.

use super::column::{Arms, Reading};
use super::machine::Machine;
use super::motion::Motion;
use super::projection::Projection;
use super::reads::ReadLayout;
use loosepin_math::Lanes;
use loosepin_math::integrate::System;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_tape::native::Level;

/// Slopes, reads and projections of all lanes.
pub struct Equations<'a, T> {
    /// The equations as they stand, and the contact states.
    pub motion: Motion<'a, T>,
    machine: Option<Machine<'a, T>>,
    projection: Option<Projection<T>>,
    readings: Vec<Reading>,
    arms: Arms<T>,
    projected: Vec<T>,
    /// What was read at the last end of a step ([`ReadLayout`]).
    pub reads: Vec<T>,
}

impl<'a, T: Lanes> Equations<'a, T> {
    /// Every lane holds `sample` until it is loaded.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        readings: &[Reading],
        level: Option<Level>,
    ) -> Self {
        let motion = Motion::new(mechanism, &Sample::broadcast(sample));
        let layout = ReadLayout::new(mechanism, readings.len());
        Self {
            machine: level.and_then(|level| Machine::new(mechanism, sample, arms, readings, level)),
            projection: Projection::<T>::is_needed(mechanism).then(|| Projection::new(mechanism)),
            readings: readings.to_vec(),
            arms: Arms::broadcast(arms),
            projected: vec![T::zero(); motion.layout.length()],
            reads: vec![T::zero(); layout.length()],
            motion,
        }
    }

    /// Puts the numbers of a run into a lane.
    pub fn load(&mut self, lane: usize, sample: &Sample<f64>, arms: &Arms) {
        let (mut numbers, mut coordinates) = (sample.numbers().into_iter(), arms.numbers().into_iter());
        let set = |to: &mut T, from: Option<f64>| to.set_lane(lane, from.unwrap_or(f64::NAN));
        self.motion.dynamics.sample_mut().visit(&mut |number| set(number, numbers.next()));
        self.arms.visit(&mut |number| set(number, coordinates.next()));
        if let Some(machine) = &mut self.machine
            && !machine.load(lane, sample, arms)
        {
            self.machine = None;
        }
    }

    /// Sets the state of a contact in a lane.
    pub fn set_contact(&mut self, lane: usize, contact: usize, state: &PlayState<f64>, has_root: bool) {
        let to = &mut self.motion.states[contact];
        to.contact.set_lane(lane, state.contact);
        to.inverse_impact_speed_s_m.set_lane(lane, state.inverse_impact_speed_s_m);
        to.effective_mass_kg.set_lane(lane, state.effective_mass_kg);
        if let Some(root) = &mut self.motion.unknowns[contact].root {
            root.is_unknown.set_lane(lane, f64::from(u8::from(has_root)));
        }
        if let Some(machine) = &mut self.machine {
            machine.set_contact(lane, contact, state, has_root);
        }
    }

    /// The state of a contact in a lane, and whether the root of its penetration is an unknown.
    #[inline]
    pub fn contact(&self, lane: usize, contact: usize) -> (PlayState<f64>, bool) {
        let state = &self.motion.states[contact];
        let has_root = self.motion.unknowns[contact].root.is_some_and(|root| root.is_unknown.lane(lane) > 0.5);
        let state = PlayState {
            contact: state.contact.lane(lane),
            inverse_impact_speed_s_m: state.inverse_impact_speed_s_m.lane(lane),
            effective_mass_kg: state.effective_mass_kg.lane(lane),
        };
        (state, has_root)
    }

    /// Whether loops of ideal joints are to be held after every step.
    pub fn holds_loops(&self) -> bool {
        self.projection.is_some()
    }

    /// Holds the loops of `state`, at which a step has ended, in the lanes of `mask`.
    #[inline(always)]
    pub fn hold_loops(&mut self, mask: T::Mask, state: &mut [T]) {
        let Some(projection) = &mut self.projection else { return };
        let projected = match &mut self.machine {
            Some(machine) => machine.projected(state),
            None => {
                self.projected.copy_from_slice(state);
                let time_s = state[self.motion.layout.time()];
                self.motion.evaluate(time_s, state);
                projection.keep_mass(&self.motion);
                projection.apply(&mut self.motion, time_s, &mut self.projected);
                &self.projected
            }
        };
        for (value, projected) in state.iter_mut().zip(&projected[..2 * self.motion.layout.freedoms]) {
            *value = T::select(mask, *projected, *value);
        }
    }
}

impl<T: Lanes> System<T> for Equations<'_, T> {
    #[inline(always)]
    fn derivative(&mut self, place: T, state: &[T], slope: &mut [T]) {
        match &mut self.machine {
            Some(machine) => machine.slope(state, slope),
            None => self.motion.derivative(place, state, slope),
        }
    }

    #[inline(always)]
    fn derivative_at_end(&mut self, place: T, state: &[T], slope: &mut [T]) {
        match &mut self.machine {
            Some(machine) => machine.slope_and_reads(state, slope, &mut self.reads),
            None => {
                self.motion.derivative(place, state, slope);
                self.motion.read(&self.readings, &self.arms, &mut self.reads);
            }
        }
    }
}
