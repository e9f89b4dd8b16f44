//! Contacts that begin and end, and roots of penetrations that come and go with them.

use super::seats::QueueOfHandles;
use super::{Batch, next_stop_s};
use crate::lanes::lane::{Event, Phase};
use crate::lanes::memory::{LaneLayout, NextStepRule};
use crate::lanes::pass::STALLED_SHARE;
use crate::lanes::reads::ReadLayout;
use crate::observer::{Onset, Separation};
use crate::stepping::gap::Crossing;
use loosepin_math::Real;
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::GapMeasure;

/// Steps in turn that hardly move the time before the root of a penetration is given up as an unknown.
const MAX_STALLED_STEPS: u32 = 12;
/// Contacts of one joint that are within this many tolerances of their beginning or end begin together: a root that grows from
/// zero beside another would hardly move the time.
const TOGETHER_TOLERANCES: f64 = 1e3;

impl Batch<'_> {
    /// Removes the root of a penetration from the unknowns where the time stalls with it.
    pub(super) fn watch_stalling(&mut self, lane: usize) {
        let pace = self.core.start_read(lane, ReadLayout::TIME + 1);
        let step = self.core.step(lane);
        let Some(run) = &mut self.runs[lane] else { return };
        let Some(contact) = run.root else { return };
        if step * pace.abs() > STALLED_SHARE * run.longest_s {
            run.stalled = 0;
            return;
        }
        run.stalled += 1;
        if run.stalled > MAX_STALLED_STEPS {
            run.stalled = 0;
            run.root = None;
            let next = STALLED_SHARE * run.longest_s;
            self.core.set_number(lane, LaneLayout::NEXT, next);
            self.core.set_number(lane, LaneLayout::WAS_REJECTED, 0.0);
            self.core.set_turn(lane, NextStepRule::Choose);
            let (state, _) = self.core.contact(lane, contact);
            self.core.set_contact(lane, contact, &state, false);
            self.restarts |= 1 << lane;
        }
    }

    pub(super) fn count_event(&mut self, lane: usize, event: Event) {
        if let (Some(run), Event::Contact { .. }) = (&mut self.runs[lane], event) {
            run.events += 1;
        }
    }

    /// Ends the run at the end of its window, or takes the next pieces of the drives' motions.
    pub(super) fn stop(&mut self, lane: usize, queue: &mut dyn QueueOfHandles) {
        let Some(run) = &mut self.runs[lane] else { return };
        let time_s = run.stop_s;
        if time_s == run.window.end_s {
            return self.succeed(lane, queue);
        }
        run.phase = Phase::Stepping;
        run.reaches_stop = false;
        run.stop_s = next_stop_s(&run.sample, time_s, &run.window);
        self.core.set_number(lane, LaneLayout::STOP, run.stop_s);
        let is_start = time_s == run.window.start_s;
        let place = self.core.pass.layout.time();
        self.core.set_state(lane, place, time_s);
        if run.sample.take_pieces_at(time_s) {
            self.core.load_numbers(lane, &run.sample, &run.arms);
            // Whoever looks inside a step must see the new pieces.
            self.viewed = 0;
        }
        self.restarts |= 1 << lane;
        if is_start {
            self.begin_record(lane, time_s);
        }
        self.core.set_turn(lane, NextStepRule::Choose);
    }

    /// Lets a contact begin or end at the start of the step, or stops.
    pub(super) fn act(&mut self, lane: usize, event: Event, queue: &mut dyn QueueOfHandles) {
        let (contact, crossing) = match event {
            Event::Contact { contact, crossing } => (contact, crossing),
            Event::Stop => return self.stop(lane, queue),
            Event::Kink { .. } => {
                // The force goes on evenly here: the step before was only not to reach across.
                if let Some(run) = &mut self.runs[lane] {
                    run.phase = Phase::Stepping;
                }
                return self.core.set_turn(lane, NextStepRule::Choose);
            }
            Event::Passage { .. } => {
                if let Some(run) = &mut self.runs[lane] {
                    run.phase = Phase::Stepping;
                }
                // The end of the step may have been moved.
                self.restarts |= 1 << lane;
                return self.core.set_turn(lane, NextStepRule::Choose);
            }
        };
        let time_s = self.core.start_read(lane, ReadLayout::TIME);
        let speed_m_s = self.gap_rate_m_s(lane, contact);
        let has_layout_root = self.core.pass.layout.roots[contact].is_some();
        let pace = self.core.start_read(lane, ReadLayout::TIME + 1);
        let effective_mass_kg = if crossing == Crossing::Onset { self.effective_mass_kg(lane, contact) } else { 0.0 };
        let is_with_another = crossing == Crossing::Onset && self.begins_with_another(lane, contact);
        let first_step = self.core.number(lane, LaneLayout::FIRST_STEP);
        let Some(run) = &mut self.runs[lane] else { return };
        if let Some(kind) = run.last_event
            && first_step > 0.0
        {
            run.after_event[kind] = first_step;
        }
        run.phase = Phase::Stepping;
        run.stalled = 0;
        let had_root = run.root.is_some();
        let numbers = run.sample.play_of(contact);
        let (state, has_root, kind) = match crossing {
            Crossing::Onset => {
                let is_floored = !(speed_m_s > numbers.minimum_impact_speed_m_s);
                let impact_speed_m_s = Real::max(speed_m_s, numbers.minimum_impact_speed_m_s);
                if time_s >= run.window.start_s {
                    let summary = &mut run.contacts[contact];
                    summary.contacts += 1;
                    summary.floored_contacts += u64::from(is_floored);
                    summary.impacts_beyond_validity += u64::from(speed_m_s > numbers.largest_valid_impact_speed_m_s);
                }
                if let Some(observer) = queue.observer(run.observer) {
                    observer.contact_begins(&Onset { contact, time_s, speed_m_s, is_floored });
                }
                let state =
                    PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / impact_speed_m_s, effective_mass_kg };
                // One root at a time: two that vanish together would never leave zero.
                (state, has_layout_root && !had_root && !is_floored && !is_with_another, 0)
            }
            Crossing::Separation => {
                if let Some(observer) = queue.observer(run.observer) {
                    observer.contact_ends(&Separation { contact, time_s, speed_m_s: -speed_m_s });
                }
                (PlayState::flight(), false, 1)
            }
        };
        // The first step after an event is as long as the last one after such an event. Before there is one, a tenth of the
        // step that was cut, in time; from u = 0 on the time is v0 s²/4.
        let next = self.core.number(lane, LaneLayout::NEXT);
        let cut_s = 0.1 * next * if had_root { pace.abs().max(1e-3 * numbers.clearance_m.sqrt()) } else { 1.0 };
        let next = match run.after_event[kind] {
            known if known > 0.0 => known,
            _ if has_root => (4.0 * cut_s * state.inverse_impact_speed_s_m).sqrt(),
            _ => cut_s,
        };
        run.last_event = Some(kind);
        let is_first = run.is_first();
        self.core.set_number(lane, LaneLayout::IS_FIRST, is_first);
        self.core.set_number(lane, LaneLayout::FIRST_STEP, 0.0);
        self.core.set_number(lane, LaneLayout::MINIMA, 0.0);
        self.core.set_number(lane, LaneLayout::NEXT, next);
        if has_root {
            run.root = Some(contact);
        } else if run.root == Some(contact) {
            run.root = None;
        }
        self.core.set_contact(lane, contact, &state, has_root);
        self.restarts |= 1 << lane;
        self.core.set_turn(lane, NextStepRule::Choose);
    }

    /// Whether another contact of the same joint is at its beginning or end where `contact` begins.
    fn begins_with_another(&self, lane: usize, contact: usize) -> bool {
        let Some(run) = &self.runs[lane] else { return false };
        let near_m = TOGETHER_TOLERANCES * self.settings.event_tolerance_m();
        let measure = GapMeasure::of(run.sample.play_of(contact));
        self.mechanism.contacts_of(self.mechanism.contacts[contact].play).any(|other| {
            if other == contact {
                return false;
            }
            let value = self.gap(lane, other)[0].jet[0];
            let is_root = self.core.contact(lane, other).1;
            let penetration_m = if is_root { value * value } else { measure.penetration_m(value) };
            penetration_m.abs() < near_m
        })
    }

    /// The mass that a contact meets along its normal at the start of the step, kg; zero where its law does not ask for it.
    fn effective_mass_kg(&mut self, lane: usize, contact: usize) -> f64 {
        let Some(run) = &self.runs[lane] else { return 0.0 };
        if !run.sample.play_of(contact).normal.needs_effective_mass() {
            return 0.0;
        }
        if self.viewed != run.number {
            self.viewed = run.number;
            self.view.dynamics.sample_mut().clone_from(&run.sample);
        }
        self.core.interpolate(lane, 0.0, &mut self.view_state);
        for (index, state) in self.view.states.iter_mut().enumerate() {
            *state = self.core.contact(lane, index).0;
        }
        let time_s = self.view_state[self.view.layout.time()];
        self.view.evaluate(time_s, &self.view_state);
        1.0 / self.view.dynamics.inverse_mass_along_normal_1_kg(contact)
    }

    /// δ̇ at the start of the step.
    pub(super) fn gap_rate_m_s(&self, lane: usize, contact: usize) -> f64 {
        let [value, slope, _] = self.gap(lane, contact)[0].jet;
        if self.core.contact(lane, contact).1 {
            return 2.0 * slope;
        }
        let pace = self.core.start_read(lane, ReadLayout::TIME + 1);
        let Some(run) = &self.runs[lane] else { return 0.0 };
        slope / (GapMeasure::of(run.sample.play_of(contact)).rate_share(value) * pace)
    }
}
