//! What is read off the end of a step, as numbers in a row.

use super::column::{Arms, Reading};
use super::motion::Motion;
use crate::math::Real;
use crate::mechanism::{Mechanism, acceleration_at};

/// Where everything is in the row. Time, gaps and outputs stand with their first two derivatives over the variable of
/// integration.
#[derive(Debug, Clone, Copy)]
pub struct ReadLayout {
    plays: usize,
    outputs: usize,
    /// Whether the kinetic energy is read as well: forces alone may exchange it with what springs and gravity hold, so that
    /// their sum tells nothing of how much energy goes to and fro.
    has_kinetic: bool,
}

impl ReadLayout {
    /// For the joints with play of `mechanism` and this many followed outputs.
    pub fn new(mechanism: &Mechanism, outputs: usize) -> Self {
        Self { plays: mechanism.plays.len(), outputs, has_kinetic: !mechanism.is_driven() }
    }
    /// Length of the row.
    pub fn length(&self) -> usize {
        self.gap(self.plays) + 3 * self.outputs
    }
    /// The time, s.
    pub const TIME: usize = 0;
    /// Mechanical energy, J.
    pub const ENERGY: usize = 3;
    /// Kinetic energy, J, where it is read.
    #[inline(always)]
    pub fn kinetic(&self) -> Option<usize> {
        self.has_kinetic.then_some(Self::ENERGY + 1)
    }
    /// For a joint with play g = |e|² - c², m², or the root of the penetration where that is an unknown, √m.
    #[inline(always)]
    pub fn gap(&self, play: usize) -> usize {
        4 + usize::from(self.has_kinetic) + 4 * play
    }
    /// Sliding velocity of a joint with play, m/s; zero where there is no friction.
    #[inline(always)]
    pub fn sliding(&self, play: usize) -> usize {
        self.gap(play) + 3
    }
    /// A followed output.
    #[inline(always)]
    pub fn output(&self, output: usize) -> usize {
        self.gap(self.plays) + 3 * output
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
        let (half, two) = (T::from_f64(0.5), T::from_f64(2.0));
        row[..3].copy_from_slice(&[self.time_s, pace, change]);
        let energy = dynamics.energy_in(
            #[inline(always)]
            |play| self.states[play].contact,
        );
        row[ReadLayout::ENERGY] = energy.total_j();
        if let Some(place) = layout.kinetic() {
            row[place] = energy.kinetic_j;
        }
        for play in 0..self.states.len() {
            let (motion, force) = &dynamics.plays()[play];
            let [i, j] = dynamics.play_slots()[play];
            let twists = &dynamics.kinematics.twists;
            let acceleration = acceleration_at(&dynamics.acceleration(j), &twists[j], motion.journal_arm_m)
                - acceleration_at(&dynamics.acceleration(i), &twists[i], motion.bearing_arm_m);
            let (e, rate) = (motion.eccentricity_m, motion.eccentricity_rate_m_s);
            let along = rate.length_squared() + e.dot(acceleration);
            let clearance_m = dynamics.sample().plays[play].clearance_m;
            let mut gap = over_s([motion.gap_m2(clearance_m), two * e.dot(rate), two * along]);
            if let Some(root) = &self.unknowns[play].root {
                let is_unknown = half.less_than(root.is_unknown);
                let speed = force.penetration_rate_m_s;
                // δ̈ from d²|e|²/dt² = 2(δ̇² + |e| δ̈), and u' = δ̇/2, u'' = w δ̈/2.
                let length_m = e.length().max(T::from_f64(f64::MIN_POSITIVE));
                let second = (along - speed * speed) / length_m * half * pace;
                for (value, over_root) in gap.iter_mut().zip([root.root, half * speed, second]) {
                    *value = T::select(is_unknown, over_root, *value);
                }
            }
            row[layout.gap(play)..layout.gap(play) + 3].copy_from_slice(&gap);
            row[layout.sliding(play)] = force.sliding_m_s;
        }
        for (k, reading) in readings.iter().enumerate() {
            let place = layout.output(k);
            row[place..place + 3].copy_from_slice(&over_s(reading.jet(arms, dynamics)));
        }
    }
}
