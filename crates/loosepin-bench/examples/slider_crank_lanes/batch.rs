//! Many runs in the lanes: steps, events, readings, energy accounts, the next run where one is over.

use crate::equations::{
    CRANK, Contact, LENGTH, LOST, ROD, ROOT, SLIDER, SPEED, SUPPLIED, State, TIME, TURNING, UNKNOWNS, derivative,
    each_unknown, eccentricity, energy, gap_m2,
};
use crate::event::{first_rise, separation};
use crate::model::SliderCrank;
use crate::step::{End, STAGES, Stepper, attempt};
use crate::vector::{Lanes, Mask, WIDTH};
use std::f64::consts::TAU;

/// What a batch does.
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    /// Number of runs.
    pub runs: usize,
    /// Turns of a run.
    pub turns: usize,
    /// Times a turn at which the slider's position is read.
    pub readings_per_turn: usize,
    /// Local error allowed in a step, m.
    pub local_m: f64,
}

/// A finished run.
#[derive(Debug, Clone, PartialEq)]
pub struct FinishedRun {
    /// Which one.
    pub index: usize,
    /// Position of the slider at the times of the plan, m; none without account.
    pub readings: Vec<f64>,
    /// Largest residual of the energy account over the largest exchange; 0 without account.
    pub energy_residual: f64,
    /// Contacts that began or ended.
    pub events: u32,
    /// Position of the slider at the end, m.
    pub end_m: f64,
}

/// The runs of a plan, and how much was computed.
#[derive(Debug, Clone)]
pub struct CompletedBatch {
    /// In the order of the plan.
    pub runs: Vec<FinishedRun>,
    /// Evaluations of the equations, of the lanes with a run.
    pub evaluations: u64,
    /// Steps that were good.
    pub accepted: u64,
    /// Steps rejected for their error.
    pub rejected: u64,
    /// Steps tried in vain because of an event inside, or before the one that ends on it.
    pub onto_events: u64,
}

/// Largest step, rad: 1/96 of a turn.
const LONGEST_RAD: f64 = TAU / 96.0;
/// Largest growth from one step to the next.
const MAX_GROWTH: f64 = 6.0;
/// δ below which a contact is over, m: root of it.
const MIN_ROOT: f64 = 1e-6;
/// A step that ends that near to an onset is led there along its derivative, rad; the rest is of second order, 1e-14 m.
const NEAR_RAD: f64 = 5e-7;
/// First step in a contact over v0^-0.6, in the units of σ: the duration of Hertz's impact goes with that power.
const FIRST_STEP: f64 = 0.04;
/// Tries to end on an event.
const MAX_TRIALS: u32 = 12;
/// Passes in a row in which no run ends after which something is wrong; a run takes a thousandth of them.
const MAX_PASSES: u64 = 10_000_000;

/// A look for the place of an event: it lies between two steps, and one is tried.
#[derive(Debug, Clone, Copy)]
struct Search {
    low: f64,
    high: f64,
    trials: u32,
}

/// A run in a lane.
struct Run {
    index: usize,
    stiffness: f64,
    events: u32,
    search: Option<Search>,
    readings: Vec<[f64; WIDTH]>,
}

struct Batch<'p, const G: usize, const ACCOUNT: bool> {
    model: &'p SliderCrank,
    plan: &'p Plan,
    start: State<G>,
    slope: State<G>,
    gap_m2: [Lanes<G>; 3],
    step: Lanes<G>,
    was_rejected: Mask<G>,
    contact: Contact<G>,
    energy_at_start: Lanes<G>,
    largest_residual: Lanes<G>,
    largest_exchange: Lanes<G>,
    runs: Vec<Option<Run>>,
    active: u64,
    searching: u64,
    next: usize,
    end_rad: f64,
    /// Readings in a radian.
    readings_per_rad: f64,
    completed: CompletedBatch,
}

/// Conducts a plan on 8 · `G` lanes, the runs in its order; with `ACCOUNT` positions are read and energies kept.
#[target_feature(enable = "avx512f")]
pub fn run_batch<const G: usize, const ACCOUNT: bool>(model: &SliderCrank, plan: &Plan) -> CompletedBatch {
    let zero = Lanes::all(0.0);
    let one = Lanes::all(1.0);
    let mut batch = Batch::<G, ACCOUNT> {
        model,
        plan,
        start: [zero; LENGTH],
        slope: [zero; LENGTH],
        gap_m2: [zero; 3],
        step: zero,
        was_rejected: Mask::NONE,
        contact: Contact { clearance_m: one, stiffness: zero, damping: zero, half: zero },
        energy_at_start: zero,
        largest_residual: zero,
        largest_exchange: zero,
        runs: (0..G * WIDTH).map(|_| None).collect(),
        active: 0,
        searching: 0,
        next: 0,
        end_rad: TAU * plan.turns as f64,
        readings_per_rad: plan.readings_per_turn as f64 / TAU,
        completed: CompletedBatch {
            runs: Vec::with_capacity(plan.runs),
            evaluations: 0,
            accepted: 0,
            rejected: 0,
            onto_events: 0,
        },
    };
    for lane in 0..G * WIDTH {
        batch.begin(lane);
    }
    let mut stepper = Stepper { model, local_m: plan.local_m, stages: [[zero; LENGTH]; STAGES] };
    let mut end = End::zero();
    let mut ended = (0, 0);
    for pass in 0.. {
        if batch.active == 0 {
            break;
        }
        if ended.0 != batch.completed.runs.len() {
            ended = (batch.completed.runs.len(), pass);
        }
        assert!(pass - ended.1 < MAX_PASSES, "a run does not come to its end");
        batch.pass(&mut stepper, &mut end);
    }
    batch.completed.runs.sort_by_key(|run| run.index);
    batch.completed
}

impl<const G: usize, const ACCOUNT: bool> Batch<'_, G, ACCOUNT> {
    /// Puts the next run, if there is one, into a lane: top dead centre, journal centred, velocities of the ideal mechanism.
    #[target_feature(enable = "avx512f")]
    fn begin(&mut self, lane: usize) {
        if self.next == self.plan.runs {
            return;
        }
        let index = self.next;
        self.next += 1;
        let model = self.model;
        let clearance_m = model.clearance_of_m(index, self.plan.runs);
        let mut state = [0.0; LENGTH];
        state[CRANK[0]] = model.crank_m;
        state[ROD[0]] = model.rod_m;
        state[SLIDER] = model.crank_m + model.rod_m;
        state[TURNING] = -model.crank_m / model.rod_m;
        for (unknown, value) in state.into_iter().enumerate() {
            self.start[unknown].set(lane, value);
        }
        self.contact.clearance_m.set(lane, clearance_m);
        let rows = if ACCOUNT { (self.plan.turns * self.plan.readings_per_turn + 1).div_ceil(WIDTH) } else { 0 };
        let mut readings = vec![[0.0; WIDTH]; rows];
        if let Some(first) = readings.first_mut() {
            first[0] = state[SLIDER];
        }
        let stiffness = model.stiffness(clearance_m);
        self.runs[lane] = Some(Run { index, stiffness, events: 0, search: None, readings });
        self.active |= 1 << lane;
        self.begin_flight(lane);
        if ACCOUNT {
            let unknowns = each_unknown!(I => self.start[I].spread(lane));
            let contact = self.contact_of(lane);
            let [kinetic, all] = energy(model, &contact, &unknowns).map(|energy| energy.get(0));
            self.energy_at_start.set(lane, all);
            self.largest_residual.set(lane, 0.0);
            self.largest_exchange.set(lane, kinetic);
        }
    }

    /// The contact of a lane in eight lanes.
    #[target_feature(enable = "avx512f")]
    fn contact_of(&self, lane: usize) -> Contact<1> {
        let Contact { clearance_m, stiffness, damping, half } = &self.contact;
        Contact {
            clearance_m: clearance_m.spread(lane),
            stiffness: stiffness.spread(lane),
            damping: damping.spread(lane),
            half: half.spread(lane),
        }
    }

    /// Begins a flight in a lane: the equations change, so the derivatives and the gap are computed again.
    #[target_feature(enable = "avx512f")]
    fn begin_flight(&mut self, lane: usize) {
        self.contact.stiffness.set(lane, 0.0);
        self.contact.half.set(lane, 0.0);
        self.start[ROOT].set(lane, 1.0);
        let unknowns = each_unknown!(I => self.start[I].spread(lane));
        let contact = self.contact_of(lane);
        let e = eccentricity(&unknowns);
        let mut slope = [Lanes::all(0.0); LENGTH];
        derivative::<1, ACCOUNT>(self.model, &contact, Lanes::all(1.0), &unknowns, &e, &mut slope);
        for unknown in 0..LENGTH {
            self.slope[unknown].set(lane, slope[unknown].get(0));
        }
        for (place, value) in gap_m2(&contact, &unknowns, &e, slope[TURNING]).into_iter().enumerate() {
            // Right after a contact the gap is zero but for rounding: it begins below, or its next rise would not be one.
            self.gap_m2[place].set(lane, if place == 0 { value.get(0).min(0.0) } else { value.get(0) });
        }
        self.step.set(lane, LONGEST_RAD);
    }

    /// Begins a contact in a lane: δ = 0, and all derivatives over σ but that of √δ are zero.
    #[target_feature(enable = "avx512f")]
    fn begin_contact(&mut self, lane: usize, product_m2: f64) {
        let Some(run) = &self.runs[lane] else { return };
        let rate = product_m2 / self.contact.clearance_m.get(lane);
        let impact = rate.max(self.model.smallest_impact_m_rad);
        self.contact.stiffness.set(lane, run.stiffness);
        self.contact.damping.set(lane, self.model.damping_factor / impact);
        self.contact.half.set(lane, 0.5);
        self.start[ROOT].set(lane, 0.0);
        for slope in &mut self.slope {
            slope.set(lane, 0.0);
        }
        self.slope[ROOT].set(lane, 0.5 * rate);
        self.step.set(lane, FIRST_STEP * impact.powf(-0.6));
    }

    /// Tries a step in every lane and acts on it.
    #[target_feature(enable = "avx512f")]
    fn pass(&mut self, stepper: &mut Stepper<'_, G>, end: &mut End<G>) {
        attempt::<G, ACCOUNT>(stepper, &self.contact, &self.start, &self.slope, self.step, end);
        self.completed.evaluations += 12 * u64::from(self.active.count_ones());
        let zero = Lanes::all(0.0);
        let good = end.error.is_below(Lanes::all(1.0)).bits() & self.active;
        let is_closed = zero.is_below(self.contact.half);
        let eventful = zero.is_below(self.highest_gap(end).replaced(is_closed, zero.minus(end.state[ROOT]))).bits();
        let looked_at = (good & eventful) | (self.searching & self.active);
        let mut accepted = good & !looked_at;
        let rejected = self.active & !good & !self.searching;
        let mut switched = 0;
        for lane in lanes_of(looked_at) {
            let is_closed = is_closed.bits() >> lane & 1 != 0;
            match self.decide(lane, end, good >> lane & 1 != 0, is_closed) {
                Decision::Retry => self.completed.onto_events += 1,
                Decision::GoOn => accepted |= 1 << lane,
                Decision::Switch => {
                    accepted |= 1 << lane;
                    switched |= 1 << lane;
                }
            }
        }
        self.completed.accepted += u64::from(accepted.count_ones());
        self.completed.rejected += u64::from(rejected.count_ones());
        let chosen = Mask::from_bits(accepted);
        if ACCOUNT && accepted != 0 {
            self.close_accounts(end, chosen);
            self.read(end, accepted);
        }
        for unknown in 0..(if ACCOUNT { LENGTH } else { UNKNOWNS + 1 }) {
            self.start[unknown] = self.start[unknown].replaced(chosen, end.state[unknown]);
            self.slope[unknown] = self.slope[unknown].replaced(chosen, end.slope[unknown]);
        }
        for (start, end) in self.gap_m2.iter_mut().zip(end.gap_m2) {
            *start = start.replaced(chosen, end);
        }
        self.choose_steps(end, chosen, Mask::from_bits(rejected));
        for lane in lanes_of(switched) {
            if is_closed.bits() >> lane & 1 != 0 {
                self.begin_flight(lane);
            } else {
                self.begin_contact(lane, end.gap_m2[1].get(lane));
            }
        }
        let running = self.start[TIME].is_below(Lanes::all(self.end_rad)).bits();
        for lane in lanes_of(accepted & !running) {
            self.finish(lane);
        }
    }

    /// The largest Bernstein coefficient of the gap over the step, but the first: the gap lies below.
    #[target_feature(enable = "avx512f")]
    #[inline]
    fn highest_gap(&self, end: &End<G>) -> Lanes<G> {
        let ([p0, v0, a0], [p1, v1, a1]) = (self.gap_m2, end.gap_m2);
        let fifth = self.step.times(Lanes::all(0.2));
        let twentieth = self.step.times(self.step).times(Lanes::all(0.05));
        let second = fifth.times_plus(v0, p0);
        let third = twentieth.times_plus(a0, fifth.times_plus(v0, second));
        let fifth_one = fifth.times_from(v1, p1);
        let fourth = twentieth.times_plus(a1, fifth.times_from(v1, fifth_one));
        second.max(third).max(fourth).max(fifth_one).max(p1)
    }

    /// The next steps, by the errors.
    #[target_feature(enable = "avx512f")]
    #[inline]
    fn choose_steps(&mut self, end: &End<G>, accepted: Mask<G>, rejected: Mask<G>) {
        let most = Lanes::all(MAX_GROWTH).replaced(self.was_rejected, Lanes::all(1.0));
        let grown = self.step.times(most.min(end.growth).max(Lanes::all(0.2)));
        let shrunk = self.step.times(Lanes::all(0.9).min(end.growth).max(Lanes::all(0.1)));
        let next = self.step.replaced(accepted, grown).replaced(rejected, shrunk);
        let longest = Lanes::all(LONGEST_RAD).times(self.start[ROOT].abs().about_one_over());
        self.step = next.min(longest);
        let bits = (self.was_rejected.bits() & !accepted.bits()) | rejected.bits();
        self.was_rejected = Mask::from_bits(bits);
    }

    /// Decides about a step that may hold an event, or was to end on one.
    #[target_feature(enable = "avx512f")]
    fn decide(&mut self, lane: usize, end: &mut End<G>, is_good: bool, is_closed: bool) -> Decision {
        let Some(run) = &mut self.runs[lane] else { return Decision::Retry };
        let step = self.step.get(lane);
        let Some(mut search) = run.search else {
            let share = if is_closed {
                let jet = |state: &State<G>, slope: &State<G>| [state[ROOT].get(lane), slope[ROOT].get(lane)];
                Some(separation(jet(&self.start, &self.slope), jet(&end.state, &end.slope), step))
            } else {
                let ([p0, v0, a0], [p1, v1, a1]) = (&self.gap_m2, &end.gap_m2);
                let start = [p0.get(lane), v0.get(lane), a0.get(lane)];
                first_rise(start, [p1.get(lane), v1.get(lane), a1.get(lane)], step)
            };
            let Some(share) = share else { return Decision::GoOn };
            run.search = Some(Search { low: 0.0, high: step, trials: 0 });
            self.searching |= 1 << lane;
            self.step.set(lane, share * step);
            return Decision::Retry;
        };
        if !is_good {
            // What was a part of a good step is not: begin anew with a shorter one.
            run.search = None;
            self.searching &= !(1 << lane);
            self.step.set(lane, 0.5 * step);
            return Decision::Retry;
        }
        // How far beyond the event, and how fast.
        let (value, rate) = if is_closed {
            (-end.state[ROOT].get(lane), -end.slope[ROOT].get(lane))
        } else {
            (end.gap_m2[0].get(lane), end.gap_m2[1].get(lane))
        };
        search.trials += 1;
        let missing = -value / rate;
        let limit = if is_closed { MIN_ROOT / rate } else { NEAR_RAD };
        let is_there = rate > 0.0 && missing.abs() < limit;
        if is_there || search.trials == MAX_TRIALS {
            run.search = None;
            self.searching &= !(1 << lane);
            if !(rate > 0.0) {
                // A touch that does not quite happen.
                return Decision::GoOn;
            }
            run.events += 1;
            if !is_closed {
                lead(end, lane, missing);
            }
            return Decision::Switch;
        }
        if value > 0.0 || rate <= 0.0 {
            search.high = step;
        } else {
            search.low = step;
        }
        let newton = step + missing;
        let next = if newton > search.low && newton < search.high { newton } else { 0.5 * (search.low + search.high) };
        self.step.set(lane, next);
        run.search = Some(search);
        Decision::Retry
    }

    /// Takes the ends of steps into the energy accounts.
    #[target_feature(enable = "avx512f")]
    #[inline]
    fn close_accounts(&mut self, end: &End<G>, chosen: Mask<G>) {
        let [kinetic, all] = end.energy;
        let (supplied, lost) = (end.state[SUPPLIED], end.state[LOST]);
        let change = all.minus(self.energy_at_start);
        let residual = change.plus(lost).minus(supplied).abs();
        let exchange = change.abs().max(supplied.abs()).max(lost.abs()).max(kinetic);
        self.largest_residual = self.largest_residual.replaced(chosen, self.largest_residual.max(residual));
        self.largest_exchange = self.largest_exchange.replaced(chosen, self.largest_exchange.max(exchange));
    }

    /// Reads the slider's position in the steps of the flagged lanes: quintic polynomials over the time, eight readings at once.
    #[target_feature(enable = "avx512f")]
    #[inline]
    fn read(&mut self, end: &End<G>, accepted: u64) {
        let scale = Lanes::all(self.readings_per_rad);
        let (from, to) = (self.start[TIME].times(scale), end.state[TIME].times(scale));
        let due = from.floor().is_below(to.floor()).bits() & accepted;
        if due == 0 {
            return;
        }
        let span = end.state[TIME].minus(self.start[TIME]);
        let half = Lanes::all(0.5);
        // Derivatives over the time; where u = 0 that of the velocity is zero over zero, and zero in truth.
        let least = Lanes::all(1e-12);
        let square = span.times(span);
        let start_pace = self.start[ROOT].max(least).one_over();
        let end_pace = end.state[ROOT].max(least).one_over();
        let (p0, p1) = (self.start[SLIDER], end.state[SLIDER]);
        let (v0, v1) = (self.start[SPEED].times(span), end.state[SPEED].times(span));
        let a0 = self.slope[SPEED].times(start_pace).times(square);
        let a1 = end.slope[SPEED].times(end_pace).times(square);
        let d = p1.minus(p0).minus(v0).minus(a0.times(half));
        let dv = v1.minus(v0).minus(a0);
        let da = a1.minus(a0);
        let third = d.times(Lanes::all(10.0)).minus(dv.times(Lanes::all(4.0))).plus(da.times(half));
        let fourth = dv.times(Lanes::all(7.0)).minus(d.times(Lanes::all(15.0))).minus(da);
        let fifth = d.times(Lanes::all(6.0)).minus(dv.times(Lanes::all(3.0))).plus(da.times(half));
        let one_over_span = to.minus(from).one_over();
        let second = a0.times(half);
        let counted = Lanes::<1>::from_array([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        for lane in lanes_of(due) {
            let Some(run) = &mut self.runs[lane] else { continue };
            let (first, last) = (from.get(lane) as usize + 1, to.get(lane) as usize);
            let (from, to, one_over_span) = (from.spread(lane), to.spread(lane), one_over_span.spread(lane));
            let (c0, c1, c2) = (p0.spread(lane), v0.spread(lane), second.spread(lane));
            let (c3, c4, c5) = (third.spread(lane), fourth.spread(lane), fifth.spread(lane));
            for row in first / WIDTH..=last / WIDTH {
                let Some(values) = run.readings.get_mut(row) else { break };
                let index = Lanes::all((WIDTH * row) as f64).plus(counted);
                let share = index.minus(from).times(one_over_span);
                let value = share.times_plus(c5, c4).times_plus(share, c3).times_plus(share, c2);
                let value = value.times_plus(share, c1).times_plus(share, c0);
                let is_due = from.is_below(index).unless(to.is_below(index));
                *values = Lanes::from_array(*values).replaced(is_due, value).to_array();
            }
        }
    }

    /// Takes a finished run out of its lane and puts in the next one.
    #[target_feature(enable = "avx512f")]
    fn finish(&mut self, lane: usize) {
        let Some(run) = self.runs[lane].take() else { return };
        self.active &= !(1 << lane);
        let readings = self.plan.turns * self.plan.readings_per_turn + 1;
        let mut all = run.readings.into_flattened();
        all.truncate(readings);
        let residual = self.largest_residual.get(lane) / self.largest_exchange.get(lane);
        self.completed.runs.push(FinishedRun {
            index: run.index,
            readings: all,
            energy_residual: if ACCOUNT { residual } else { 0.0 },
            events: run.events,
            end_m: self.start[SLIDER].get(lane),
        });
        self.begin(lane);
    }
}

/// Decision on a step.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Decision {
    /// Another one is tried.
    Retry,
    /// It is good.
    GoOn,
    /// It is good and a contact begins or ends there.
    Switch,
}

/// Leads the end of a step along its derivative, which is over the time in flight.
#[target_feature(enable = "avx512f")]
fn lead<const G: usize>(end: &mut End<G>, lane: usize, span_rad: f64) {
    let change = |value: &mut Lanes<G>, rate: f64| {
        let moved = value.get(lane) + span_rad * rate;
        value.set(lane, moved);
    };
    for unknown in 0..LENGTH {
        change(&mut end.state[unknown], end.slope[unknown].get(lane));
    }
    change(&mut end.energy[1], end.slope[SUPPLIED].get(lane) - end.slope[LOST].get(lane));
    let [_, product, second] = &mut end.gap_m2;
    change(product, second.get(lane));
}

/// The lanes whose bits are set.
fn lanes_of(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        (bits != 0).then(|| {
            let lane = bits.trailing_zeros() as usize;
            bits &= bits - 1;
            lane
        })
    })
}
