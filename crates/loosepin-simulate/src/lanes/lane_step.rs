//! The ends of an attempted step of one lane: what decides about it reads no more than it needs.

use crate::lanes::core::Core;
use crate::lanes::memory::LaneLayout;
use crate::lanes::reads::ReadLayout;
use crate::stepping::gap::{Crossing, GapJet};
use crate::stepping::slot_end::{continued_gap, passage};
use loosepin_mechanics::mechanism::Sample;

/// An attempted step of one lane.
#[derive(Clone, Copy)]
pub struct LaneStep<'s, 'a> {
    core: &'s Core<'a>,
    lane: usize,
}

impl<'s, 'a> LaneStep<'s, 'a> {
    /// The current step in `lane`.
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

    /// The gap of a contact of this `sample`, or the root of its penetration where that is an unknown, at both ends. In a slot it is that of the wall at
    /// which the step begins.
    #[inline]
    pub fn gap(&self, contact: usize, sample: &Sample<f64>) -> [GapJet; 2] {
        let [start, end] = self.core.jets(self.lane, self.core.pass.reads.gap(contact));
        match self.along_slot(contact, sample) {
            Some((along, half_length_m)) if !self.core.contact(self.lane, contact).1 => {
                [start, GapJet { jet: continued_gap(end.jet, along, half_length_m) }]
            }
            _ => [start, end],
        }
    }

    /// Direction in which the pin of a slot can pass the end on this side, and the event function there, at both ends; `None` if there is
    /// no slot.
    #[inline]
    pub fn passage(&self, contact: usize, sample: &Sample<f64>, side: f64) -> Option<(Crossing, [GapJet; 2])> {
        let (along, half_length_m) = self.along_slot(contact, sample)?;
        let (is_past, jets) = passage(along, half_length_m, side, self.core.pass.local_m);
        let crossing = if is_past { Crossing::Separation } else { Crossing::Onset };
        Some((crossing, jets.map(|jet| GapJet { jet })))
    }

    /// Place along the slot and its derivatives at both ends, and the half-length of the slot.
    #[inline]
    fn along_slot(&self, contact: usize, sample: &Sample<f64>) -> Option<([[f64; 3]; 2], f64)> {
        // Mostly no joint is a slot: then its shape need not be looked up.
        let place = self.core.pass.reads.along_slot(contact)?;
        let slot = sample.play_of(contact).shape.slot()?;
        Some((self.core.jets(self.lane, place).map(|along| along.jet), slot.half_length_m))
    }

    /// How far from a passage a step may end, m.
    pub fn passage_tolerance_m(&self) -> f64 {
        0.5 * self.core.pass.local_m
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
