//! The ends of an attempted step of one lane: what decides about it reads no more than it needs.

use super::core::Core;
use super::gap::GapJet;
use super::memory::LaneLayout;
use super::reads::ReadLayout;

/// An attempted step of one lane.
#[derive(Clone, Copy)]
pub struct LaneStep<'s, 'a> {
    core: &'s Core<'a>,
    lane: usize,
}

impl<'s, 'a> LaneStep<'s, 'a> {
    /// The step at hand in `lane`.
    pub fn new(core: &'s Core<'a>, lane: usize) -> Self {
        Self { core, lane }
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        self.core.step(self.lane)
    }

    /// Largest change of a slope between the ends of the step, in allowed errors of the unknown: the change of the unknown itself, for each unit of the
    /// variable of integration by which the end is moved.
    pub fn change_of_slopes(&self) -> f64 {
        self.core.change_of_slopes(self.lane)
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.core.pass.layout.roots.len()
    }

    /// Time and its derivatives at both ends.
    pub fn time(&self) -> [GapJet; 2] {
        self.core.jets(self.lane, ReadLayout::TIME)
    }

    /// The time at its end, s.
    pub fn end_s(&self) -> f64 {
        self.core.end_read(self.lane, ReadLayout::TIME)
    }

    /// The gap of a contact, or the root of its penetration where that is an unknown, at both ends.
    pub fn gap(&self, contact: usize) -> [GapJet; 2] {
        self.core.jets(self.lane, self.core.pass.reads.gap(contact))
    }

    /// Sliding velocities of a contact at both ends, m/s.
    pub fn slidings_m_s(&self, contact: usize) -> [f64; 2] {
        let place = self.core.pass.reads.sliding(contact);
        [self.core.start_read(self.lane, place), self.core.end_read(self.lane, place)]
    }

    /// Whether a contact is closed.
    pub fn is_closed(&self, contact: usize) -> bool {
        self.core.number(self.lane, LaneLayout::contact(contact)) > 0.0
    }
}
