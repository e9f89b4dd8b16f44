//! State of one run: its steps, its search for events, its counts. One lane follows one of these.

use crate::depth_limit::DepthLimit;
use crate::lanes::batch::RunHandle;
use crate::lanes::lane_step::LaneStep;
use crate::recording::report::{FrictionPath, PlaySummary};
use crate::settings::{STEP_SHARE, Window};
use crate::stepping::gap::{Crossing, GapJet, first_crossing};
use crate::stepping::slot_end::ENDS;
use loosepin_mechanics::mechanism::{Arms, GapMeasure, Sample};

/// Event that ends a step before its error does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// A contact begins or ends.
    Contact {
        /// Index in [`loosepin_mechanics::mechanism::Mechanism::contacts`].
        contact: usize,
        /// Which of the two.
        crossing: Crossing,
    },
    /// The sliding velocity passes a kink of the friction law, or reverses where the joint wears.
    Kink {
        /// Index in [`loosepin_mechanics::mechanism::Mechanism::contacts`].
        contact: usize,
        /// Sliding velocity at the kink, m/s.
        level_m_s: f64,
    },
    /// The pin of a slot passes from the faces into a round end, or back: the gap has a kink there.
    Passage {
        /// Index in [`loosepin_mechanics::mechanism::Mechanism::contacts`].
        contact: usize,
        /// The end, one of [`ENDS`].
        side: f64,
        /// Into the end as a contact begins, out of it as one ends.
        crossing: Crossing,
    },
    /// The time at which steps stop, while the time is no longer the variable of integration.
    Stop,
}

/// A look for the place of an event: steps are taken again until one ends on it.
#[derive(Debug, Clone, Copy)]
pub struct Search {
    /// The event that is looked for.
    pub event: Event,
    /// The event lies beyond this step.
    pub low: f64,
    /// The event lies before this step.
    pub high: f64,
    /// The step that is tried.
    pub trial: f64,
    /// Steps tried so far.
    pub trials: u32,
    /// The step tried before, and how far from the event it ended.
    pub before: (f64, f64),
}

/// Purpose of the current attempt.
#[derive(Debug, Clone, Copy)]
pub enum Phase {
    /// Continue stepping.
    Stepping,
    /// To end on an event.
    Searching(Search),
    /// To stop just before an event that dissolved on closer look.
    Stopping,
}

/// The run of a lane.
pub struct LaneRun {
    /// Runs of a batch are numbered as they start, from 1.
    pub number: u64,
    /// All numbers of the run.
    pub sample: Sample<f64>,
    /// The recorded part.
    pub window: Window,
    /// Who looks at it.
    pub observer: RunHandle,
    /// Steps that end before this time need not be shown to the observer, s.
    pub awaited_s: f64,
    /// Whether the current step lies in the recorded part.
    pub is_recorded: bool,
    /// Longest step in time, s.
    pub longest_s: f64,
    /// Smallest step in time apart from steps onto events, s.
    pub smallest_s: f64,
    /// The current attempt.
    pub phase: Phase,
    /// The last event of a contact: 0 for an onset, 1 for a separation.
    pub last_event: Option<usize>,
    /// Length of the first good step after the last onset, and what its error allowed after the last separation: the first guess for the next.
    pub after_event: [f64; 2],
    /// Positions of its points in their bodies.
    pub arms: Arms,
    /// Steps end here at the latest, s: at the start and at the end of the window, and where the pieces of a drive's motion meet.
    pub stop_s: f64,
    /// Whether the current step ends there.
    pub reaches_stop: bool,
    /// Steps in turn during which time hardly went on.
    pub stalled: u32,
    /// Contacts that began or ended.
    pub events: u64,
    /// Exchange of energy below which the account is round-off, J.
    pub smallest_exchange_j: f64,
    /// By contact.
    pub contacts: Vec<PlaySummary>,
    /// Friction paths at the start of the recorded part.
    pub paths_before: Vec<FrictionPath>,
    /// By contact: how deep it may be pressed in.
    pub depth_limits: Vec<DepthLimit>,
    /// The contact the root of whose penetration is an unknown.
    pub root: Option<usize>,
}

/// Newton steps onto an event; from the polynomial's root two or three do.
const MAX_TRIALS: u32 = 12;

/// How far from the end of a good step an event may lie, so that the end is moved there by its slopes: where slopes change evenly, states inside
/// of the step are then off by this many local errors at most, a tenth of the tolerance. The state at the end is off by far less.
const MAX_MOVED: f64 = 0.1 / STEP_SHARE;
/// The same as a share of the step.
const MAX_MOVED_SHARE: f64 = 1e-3;

/// Decision on an attempt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decision {
    /// Try another step.
    Retry(f64),
    /// The step is good; the event is at its end.
    Accept(Option<Event>),
    /// The step is good, and the event is so far behind its end, or before it, that it can be moved there.
    Move(Event, f64),
    /// The event is at the start of the step: nothing moves.
    SwitchAtStart(Event),
}

impl LaneRun {
    /// Whether the current step ends with the run.
    pub fn is_at_end(&self) -> bool {
        self.reaches_stop && self.stop_s == self.window.end_s
    }

    /// Number of [`LaneLayout::IS_FIRST`](crate::lanes::memory::LaneLayout::IS_FIRST) after the last event.
    pub fn is_first(&self) -> f64 {
        self.last_event.map_or(0.0, |kind| kind as f64 + 1.0)
    }

    /// |δ| below which a contact counts as at its beginning or end turned into the size of its gap function.
    fn gap_tolerance(&self, contact: usize, is_root: bool, event_tolerance_m: f64) -> f64 {
        match is_root {
            true => event_tolerance_m.sqrt(),
            false => GapMeasure::of(self.sample.play_of(contact)).tolerance(event_tolerance_m),
        }
    }

    /// The event of the step that comes first, with its share of the step.
    pub fn earliest_event(&self, step: &LaneStep<'_, '_>) -> Option<(Event, f64)> {
        let mut earliest: Option<(Event, f64)> = None;
        for contact in 0..step.contacts() {
            let [start, end] = &step.gap(contact, &self.sample);
            let crossing = if step.is_closed(contact) { Crossing::Separation } else { Crossing::Onset };
            if let Some(share) = first_crossing(start, end, step.length(), crossing)
                && earliest.as_ref().is_none_or(|(_, first)| share < *first)
            {
                earliest = Some((Event::Contact { contact, crossing }, share));
            }
            for side in ENDS {
                if let Some((crossing, [start, end])) = step.passage(contact, &self.sample, side)
                    && let Some(share) = first_crossing(&start, &end, step.length(), crossing)
                    && earliest.as_ref().is_none_or(|(_, first)| share < *first)
                {
                    earliest = Some((Event::Passage { contact, side, crossing }, share));
                }
            }
        }
        for contact in (0..step.contacts()).filter(|&contact| step.is_closed(contact)) {
            let [start, end] = step.slidings_m_s(contact);
            let play = self.sample.play_of(contact);
            for level_m_s in play.kink_levels_m_s() {
                let tolerance_m_s = play.kink_tolerance_m_s(level_m_s);
                let (from, to) = (start - level_m_s, end - level_m_s);
                if from * to < 0.0 && from.abs() > tolerance_m_s && to.abs() > tolerance_m_s {
                    let share = from / (from - to);
                    if earliest.as_ref().is_none_or(|(_, first)| share < *first) {
                        earliest = Some((Event::Kink { contact, level_m_s }, share));
                    }
                }
            }
        }
        if self.root.is_some() {
            let beyond = |jet: &GapJet| GapJet { jet: [jet.jet[0] - self.stop_s, jet.jet[1], jet.jet[2]] };
            let [start, end] = step.time().map(|time| beyond(&time));
            if end.jet[0] > 0.0
                && let Some(share) = first_crossing(&start, &end, step.length(), Crossing::Onset)
                && earliest.as_ref().is_none_or(|(_, first)| share < *first)
            {
                earliest = Some((Event::Stop, share));
            }
        }
        earliest
    }

    /// Decides about a good attempt in [`Phase::Stepping`] that may hold an event, or about any later attempt of a search.
    pub fn decide(&mut self, step: &LaneStep<'_, '_>, event_tolerance_m: f64) -> Decision {
        let search = match self.phase {
            Phase::Stopping => return Decision::Accept(None),
            Phase::Stepping => {
                let Some((event, share)) = self.earliest_event(step) else {
                    return Decision::Accept(None);
                };
                let length = step.length();
                let trial = share * length;
                if trial <= 0.0 {
                    return Decision::SwitchAtStart(event);
                }
                let before = match event {
                    Event::Kink { contact, level_m_s } => (length, step.slidings_m_s(contact)[1] - level_m_s),
                    _ => (0.0, 0.0),
                };
                self.phase = Phase::Searching(Search { event, low: 0.0, high: length, trial, trials: 0, before });
                return Decision::Retry(trial);
            }
            Phase::Searching(search) => search,
        };
        self.go_on_searching(search, step, event_tolerance_m)
    }

    /// Distance of an event behind the end of the step, by the value and two derivatives of its event function there.
    fn distance(&self, event: Event, [value, rate, second]: [f64; 3], step: &LaneStep<'_, '_>) -> Option<f64> {
        let straight = -value / rate;
        // The nearer root of value + rate x + second x²/2.
        let bent = 2.0 * straight / (1.0 + (1.0 + 2.0 * second * straight / rate).sqrt());
        let [end_s, pace, _] = step.time()[1].jet;
        let passes_stop = event != Event::Stop && end_s + bent * pace > self.stop_s;
        // What is not small against the straight one, or no number, is no correction.
        (!passes_stop && (bent - straight).abs() < 0.01 * straight.abs()).then_some(bent)
    }

    fn go_on_searching(&mut self, mut search: Search, step: &LaneStep<'_, '_>, event_tolerance_m: f64) -> Decision {
        search.trials += 1;
        let trial = search.trial;
        // The end of the step lies before or behind the event that is looked for; anything else found on the way comes first.
        let may_hide = step.contacts() > 1
            || self.sample.play_of(0).friction.acts()
            || self.sample.play_of(0).wears
            || self.sample.play_of(0).shape.slot().is_some()
            || step.end_s() > self.stop_s
            || !matches!(search.event, Event::Contact { .. });
        let other = if may_hide { self.earliest_event(step) } else { None };
        let other = other.filter(|(event, _)| *event != search.event);
        if let Some((event, share)) = other {
            // Another event was hidden behind this one.
            search.high = trial;
            search.trial *= share;
            search.event = event;
            search.before = (0.0, 0.0);
            search.low = search.low.min(search.trial);
            if search.trial <= 0.0 {
                return Decision::SwitchAtStart(event);
            }
        } else {
            // Of a kink no second derivative of the velocity is known.
            let (jet, value, rate, tolerance) = match search.event {
                Event::Contact { contact, crossing } => {
                    let jet = step.gap(contact, &self.sample)[1].jet;
                    let tolerance = self.gap_tolerance(contact, self.root == Some(contact), event_tolerance_m);
                    (Some(jet), crossing.sign() * jet[0], crossing.sign() * jet[1], tolerance)
                }
                Event::Passage { contact, side, crossing } => {
                    let Some((_, [_, end])) = step.passage(contact, &self.sample, side) else {
                        return Decision::Accept(None);
                    };
                    let jet = end.jet;
                    (Some(jet), crossing.sign() * jet[0], crossing.sign() * jet[1], step.passage_tolerance_m())
                }
                Event::Kink { contact, level_m_s } => {
                    let [start, end] = step.slidings_m_s(contact);
                    let value = end - level_m_s;
                    // The secant through the step tried before, or through the start.
                    let slope = if search.before.0 > 0.0 {
                        (value - search.before.1) / (trial - search.before.0)
                    } else {
                        (end - start) / trial
                    };
                    search.before = (trial, value);
                    let sign = if start < level_m_s { 1.0 } else { -1.0 };
                    (None, sign * value, sign * slope, self.sample.play_of(contact).kink_tolerance_m_s(level_m_s))
                }
                Event::Stop => {
                    let [time_s, pace, change] = step.time()[1].jet;
                    let beyond_s = time_s - self.stop_s;
                    (Some([beyond_s, pace, change]), beyond_s, pace, 4.0 * f64::EPSILON * self.stop_s)
                }
            };
            if value.abs() <= tolerance {
                return Decision::Accept(Some(search.event));
            }
            // Too far; or, where a gap turns before it reaches zero, on the way back.
            let turns = matches!(search.event, Event::Contact { .. } | Event::Passage { .. }) && rate <= 0.0;
            if !turns
                && let Some(jet) = jet
                && let Some(by) = self.distance(search.event, jet, step)
                && by.abs() <= MAX_MOVED_SHARE * trial
                && by.abs() * step.change_of_slopes() <= MAX_MOVED
            {
                return Decision::Move(search.event, by);
            }
            if value > 0.0 || turns {
                search.high = trial;
            } else {
                search.low = trial;
            }
            let newton = trial - value / rate;
            search.trial =
                if newton > search.low && newton < search.high { newton } else { 0.5 * (search.low + search.high) };
        }
        if search.trials < MAX_TRIALS {
            self.phase = Phase::Searching(search);
            return Decision::Retry(search.trial);
        }
        // A touch that does not quite happen: go to the last place before it. A half step makes sure that time goes on.
        let stop = if search.low > 0.0 { search.low } else { 0.5 * search.high };
        if stop <= self.smallest_s {
            return Decision::SwitchAtStart(search.event);
        }
        self.phase = Phase::Stopping;
        Decision::Retry(stop)
    }
}
