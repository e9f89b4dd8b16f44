//! The arithmetic of a pass over one lane: try a step, look at its end, take it over. Written once over [`Real`]: done as it
//! stands for one run, written down for many ([`super::recorded`]).

use crate::follow::{Follow, FollowLayout, LOBATTO, StepEnds};
use crate::lanes::memory::{BLOCKS, LaneLayout, MemoryBlocks, NextStepRule};
use crate::lanes::reads::ReadLayout;
use crate::settings::{STEP_SHARE, Settings};
use crate::stepping::motion::{Layout, Motion, tolerances};
use crate::stepping::projection::Projection;
use crate::stepping::slot_end::{ENDS, continued_gap, passage};
use loosepin_math::integrate::{StepRows, Stepper, System};
use loosepin_math::{NEAR_RAD, Quintic, Real};
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample, is_front_corner};

/// The force at the edge of a guide over that of its law, 1/cos θ, up to a tilt of 33°.
const MAX_STRETCH: f64 = 1.2;
/// Rates of a contact are taken to be no faster than this, m/s: infinite ones times a law's number that is zero are none.
const FASTEST_M_S: f64 = 1e100;

/// Largest growth from one step to the next, and the smallest after a good one.
const GROWTH: [f64; 2] = [0.2, 6.0];
/// The same after a rejected attempt; after a NaN error, which comes from a step far too long, the smallest.
const SHRINKAGE: [f64; 2] = [0.1, 0.9];
/// Minima of penetrations since the last event, of all contacts together, from which on the contacts of a run count as lasting. An impact has
/// none; one that something presses on has a few.
const LASTING_MINIMA: f64 = 4.0;
/// Share of the longest step below which time hardly moves.
pub const STALLED_SHARE: f64 = 1e-7;
/// Residual of what an ideal joint with friction carries over its size: where Newton's method has not got there, there is no
/// solution, and round-off is far below.
pub const MAX_RESIDUAL: f64 = 1e-9;

/// Parts of a pass that all lanes share.
#[derive(Debug, Clone)]
pub struct Pass {
    /// Layout of a state.
    pub layout: Layout,
    /// Layout of the readings.
    pub reads: ReadLayout,
    /// Layout of the numbers of a lane.
    pub lane: LaneLayout,
    /// Layout of the numbers of the followed quantities.
    pub follow: FollowLayout,
    /// The integrator.
    pub stepper: Stepper,
    /// Local error allowed in lengths, m.
    pub local_m: f64,
    /// How much more it may be in a lasting contact.
    pub lasting_share: f64,
    /// Evaluations of a run after which it is given up.
    pub largest_evaluations: u64,
}

impl Pass {
    /// For `mechanism` with the contacts of `sample` and what is followed.
    pub fn new(mechanism: &Mechanism, sample: &Sample<f64>, follow: &Follow, settings: &Settings) -> Self {
        let (layout, follow) = (Layout::new(mechanism, sample), FollowLayout::new(follow));
        let tolerances = tolerances(mechanism, &layout, sample, 1.0, 1.0, 1.0).len();
        Self {
            reads: ReadLayout::new(mechanism, follow.readings()),
            lane: LaneLayout::new(mechanism.contacts.len(), tolerances, follow.length()),
            follow,
            stepper: Stepper::new(settings.method, layout.dimension, layout.integrals()),
            local_m: settings.tolerance_m * STEP_SHARE,
            lasting_share: settings.lasting_share(mechanism),
            largest_evaluations: settings.largest_evaluations,
            layout,
        }
    }

    /// Length of each block for a lane, with `numbers` numbers of its sample.
    pub fn block_lengths(&self, numbers: usize) -> [usize; BLOCKS] {
        let (row, reads) = (self.layout.length(), self.reads.length());
        let stages = self.first_inside() + self.follow.inside().values();
        [numbers, self.lane.length(), row, stages, row, row, reads, reads]
    }

    /// Tries the step of the lane; `system` reads at its end.
    pub fn attempt<T: Real>(&self, rows: &mut StepRows<'_, T>, lane: &mut [T], system: &mut impl System<T>) {
        self.set_root_weights(rows, lane);
        let error = self.stepper.attempt(rows, lane[LaneLayout::STEP], &lane[self.lane.weights()], system);
        let is_lasting = T::from_f64(LASTING_MINIMA - 0.5).less_than(lane[LaneLayout::MINIMA]);
        lane[LaneLayout::ERROR] = T::select(is_lasting, error * T::from_f64(1.0 / self.lasting_share), error);
    }

    /// Makes a step in which a body turns by more than [`NEAR_RAD`] one that errs too much, since sines and cosines within a step are computed
    /// from those at its start; and says by the error how much longer the next step may be. (Quintic interpolation of a circle over so long a
    /// step is 1e-10 of its radius off. Ends are looked at: a body that swings out and back within one step, whose error would tell so, is not told here.)
    pub fn limit_turns<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let mut largest = T::zero();
        for turning in 0..self.reads.turning() {
            let place = self.reads.angle(turning);
            let turn = blocks.end_reads[place] - blocks.start_reads[place];
            largest = largest.max(turn * turn);
        }
        // The eighth power, as an error of order eight: a step that is shortened by it turns by NEAR_RAD.
        let ratio = (largest * T::from_f64(1.0 / (NEAR_RAD * NEAR_RAD))).squared().squared();
        let error = blocks.lane[LaneLayout::ERROR];
        let error = T::select(error.less_than(ratio), ratio, error);
        blocks.lane[LaneLayout::ERROR] = error;
        blocks.lane[LaneLayout::GROWTH] = self.stepper.growth(error);
    }

    /// Makes the last evaluation, slope and reads, that of the start of the step, in the chosen lanes.
    pub fn take_evaluation<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN]);
        let length = self.layout.length();
        let end = self.stepper.end_row() * length;
        for i in 0..length {
            blocks.rows.stages[i] = T::select(is_chosen, blocks.rows.stages[end + i], blocks.rows.stages[i]);
        }
        for (start, end) in blocks.start_reads.iter_mut().zip(&*blocks.end_reads) {
            *start = T::select(is_chosen, *end, *start);
        }
    }

    /// Makes the end of the step the start of the next one, where the lane is chosen.
    pub fn accept<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        self.count_minima(blocks);
        self.take_evaluation(blocks);
        let lane = &mut *blocks.lane;
        lane[LaneLayout::STEPS] += lane[LaneLayout::CHOSEN];
        let is_chosen = is_set(lane[LaneLayout::CHOSEN]);
        let (is_first, step) = (lane[LaneLayout::IS_FIRST], lane[LaneLayout::STEP]);
        // A flight is smooth from its beginning on: what the error of its first step allows can be trusted. A contact may have a kink there.
        let growth = lane[LaneLayout::GROWTH].min(T::from_f64(GROWTH[1])).max(T::one());
        let first = T::select(T::from_f64(1.5).less_than(is_first), step * growth, step);
        let first_step = lane[LaneLayout::FIRST_STEP];
        lane[LaneLayout::FIRST_STEP] = T::select(is_set(is_first * lane[LaneLayout::CHOSEN]), first, first_step);
        lane[LaneLayout::IS_FIRST] = T::select(is_chosen, T::zero(), is_first);
        for (start, end) in blocks.rows.start.iter_mut().zip(&*blocks.rows.end) {
            *start = T::select(is_chosen, *end, *start);
        }
    }

    /// Counts the current step, in the chosen lanes, where a penetration has its minimum in it and the contact holds: it falls at the start of the
    /// step and rises at its end.
    fn count_minima<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        if self.lasting_share == 1.0 {
            return;
        }
        let (zero, lane) = (T::zero(), &mut *blocks.lane);
        let mut has_minimum = zero;
        for contact in 0..self.layout.roots.len() {
            let rate = self.reads.gap(contact) + 1;
            let rises = T::select(zero.less_than(blocks.end_reads[rate]), lane[LaneLayout::contact(contact)], zero);
            has_minimum = T::select(blocks.start_reads[rate].less_than(zero), has_minimum.max(rises), has_minimum);
        }
        lane[LaneLayout::MINIMA] += has_minimum * lane[LaneLayout::CHOSEN];
    }

    /// Chooses the next step of a lane by the last attempt.
    pub fn choose_step<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let (zero, one, half) = (T::zero(), T::one(), T::from_f64(0.5));
        let lane = &mut *blocks.lane;
        let turn = lane[LaneLayout::TURN];
        let is_beyond = |least: NextStepRule| T::from_f64(least.number() - 0.5).less_than(turn);
        let [error, growth, step] = [LaneLayout::ERROR, LaneLayout::GROWTH, LaneLayout::STEP].map(|place| lane[place]);
        let [least_growth, most_growth] = GROWTH.map(T::from_f64);
        let most_growth = T::select(is_set(lane[LaneLayout::WAS_REJECTED]), one, most_growth);
        let factor = T::select(
            is_beyond(NextStepRule::Shrink),
            shrinkage(error, growth),
            growth.min(most_growth).max(least_growth),
        );
        let by_error = T::select(is_beyond(NextStepRule::Grow), step * factor, lane[LaneLayout::NEXT]);
        let next = T::select(is_beyond(NextStepRule::Choose), lane[LaneLayout::NEXT], by_error);
        let was_rejected = T::select(
            is_beyond(NextStepRule::Shrink),
            one,
            T::select(is_beyond(NextStepRule::Grow), zero, lane[LaneLayout::WAS_REJECTED]),
        );
        lane[LaneLayout::WAS_REJECTED] =
            T::select(is_beyond(NextStepRule::Choose), lane[LaneLayout::WAS_REJECTED], was_rejected);
        lane[LaneLayout::NEXT] = next;

        // The time at which steps stop is met exactly, and a last crumb is joined to the step before it. Where time is not the variable of
        // integration the stop is an event.
        let left_s = lane[LaneLayout::STOP] - blocks.rows.start[self.layout.time()];
        let longest_s = lane[LaneLayout::LONGEST];
        let step_s = next.min(longest_s);
        let halved_s = T::select((half * left_s).less_than(step_s), half * left_s, step_s);
        let chosen_s = T::select((left_s * T::from_f64(1.0 - 1e-6)).less_than(step_s), left_s, halved_s);
        let pace = blocks.start_reads[ReadLayout::TIME + 1];
        let over_root = T::select(zero.less_than(pace), next.min(longest_s / pace), next);
        let chosen = T::select(is_set(self.roots(lane)), over_root, chosen_s);
        lane[LaneLayout::STEP] = T::select(is_beyond(NextStepRule::Grow), chosen, step);
        lane[LaneLayout::TURN] = T::from_f64(NextStepRule::Set.number());
    }

    /// How many roots of penetrations are unknowns in a lane.
    fn roots<T: Real>(&self, lane: &[T]) -> T {
        let mut roots = T::zero();
        for (contact, _) in self.layout.roots.iter().enumerate().filter(|(_, root)| root.is_some()) {
            roots += lane[LaneLayout::contact(contact) + LaneLayout::HAS_ROOT];
        }
        roots
    }

    /// Says what happens with the attempt of a lane: accepted, rejected, or to be looked at one by one, as it must be where something but the
    /// next step follows from it.
    fn judge<T: Real>(&self, sample: &Sample<T>, blocks: &mut MemoryBlocks<'_, T>) {
        let (zero, one) = (T::zero(), T::one());
        let (starts, ends, lane) = (&*blocks.start_reads, &*blocks.end_reads, &mut *blocks.lane);
        let evaluations = lane[LaneLayout::EVALUATIONS] + T::from_f64(self.stepper.evaluations_per_attempt() as f64);
        let has_root = self.roots(lane);
        let unless = |mask: T::Mask, number: T| T::select(mask, number, one);

        // A good step is looked at where it reaches a stop, an instant that is awaited, an event, a record or a limit.
        let end_s = ends[ReadLayout::TIME];
        let stop_s = lane[LaneLayout::STOP];
        let left_s = stop_s - blocks.rows.start[self.layout.time()];
        let step = lane[LaneLayout::STEP];
        let record = lane[LaneLayout::NOTABLE] * lane[LaneLayout::IS_RECORDED];
        let mut good = lane[LaneLayout::EVENTFUL].max(record).max(lane[LaneLayout::DEEP]);
        good = unless(end_s.less_than(stop_s), good);
        good = T::select(step.less_than(left_s), good, T::select(is_set(has_root), good, one));
        good = unless(end_s.less_than(lane[LaneLayout::AWAITED]), good);
        let moved_s = step * ends[ReadLayout::TIME + 1].abs();
        let moves = (T::from_f64(STALLED_SHARE) * lane[LaneLayout::LONGEST]).less_than(moved_s);
        good = T::select(moves, good, T::select(is_set(has_root), one, good));
        for contact in 0..sample.contacts.len() {
            let of_lane = &lane[LaneLayout::contact(contact)..];
            let is_root = is_set(of_lane[LaneLayout::HAS_ROOT]);
            let limit = T::select(is_root, of_lane[LaneLayout::MAX_ROOT], of_lane[LaneLayout::MAX_GAP]);
            good = unless(ends[self.reads.gap(contact)].less_than(limit), good);
            if let (Some([first, last]), Some(place)) =
                (sample.play_of(contact).shape.face_ends_m(), self.reads.along(contact))
            {
                // The block is out of the guide where its rear is beyond the end, or its front before the start.
                let holds = if is_front_corner(sample.contacts[contact].place) {
                    first.less_than(ends[place])
                } else {
                    ends[place].less_than(last)
                };
                good = unless(holds, good);
            }
        }
        let residual = T::from_f64(MAX_RESIDUAL);
        let mut bad = zero;
        for index in 0..self.reads.frictions() {
            let is_solved = ends[self.reads.friction(index)].less_than(residual);
            (good, bad) = (unless(is_solved, good), unless(is_solved, bad));
        }

        // One that is not good is looked at where the next would be too short.
        let [error, growth] = [LaneLayout::ERROR, LaneLayout::GROWTH].map(|place| lane[place]);
        let next = step * shrinkage(error, growth);
        let next_s = step_in_time([starts[ReadLayout::TIME + 1], starts[ReadLayout::TIME + 2]], next);
        let smallest_s = smallest_step_s(lane[LaneLayout::SMALLEST], starts[ReadLayout::TIME]);
        bad = unless(smallest_s.less_than(next_s), bad);

        let is_good = error.less_than(T::from_f64(1.0 + f64::EPSILON));
        let attention = T::select(is_good, good, bad).max(lane[LaneLayout::IS_WATCHED]);
        let attention = unless(evaluations.less_than(T::from_f64(self.largest_evaluations as f64 + 1.0)), attention);
        let is_watched = is_set(attention);
        let [set, grow, shrink] =
            [NextStepRule::Set, NextStepRule::Grow, NextStepRule::Shrink].map(|turn| T::from_f64(turn.number()));
        lane[LaneLayout::EVALUATIONS] = evaluations;
        lane[LaneLayout::REJECTIONS] += T::select(is_good, zero, one);
        lane[LaneLayout::ATTENTION] = attention;
        lane[LaneLayout::IS_DUE] =
            T::select(end_s.less_than(lane[LaneLayout::DUE]), zero, lane[LaneLayout::IS_RECORDED]);
        lane[LaneLayout::CHOSEN] = T::select(is_watched, zero, T::select(is_good, one, zero));
        lane[LaneLayout::TURN] = T::select(is_watched, set, T::select(is_good, grow, shrink));
    }

    /// Holds the loops of ideal joints at the start of the step, where the lane is chosen.
    pub fn hold_loops<T: Real>(
        &self,
        blocks: &mut MemoryBlocks<'_, T>,
        motion: &mut Motion<'_, T>,
        projection: &mut Projection<T>,
    ) {
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN]);
        let start = &mut blocks.rows.start;
        let mut held = start.to_vec();
        projection.hold(motion, held[self.layout.time()], &mut held);
        for (value, projected) in start[..2 * self.layout.freedoms].iter_mut().zip(&held) {
            *value = T::select(is_chosen, *projected, *value);
        }
    }

    /// Takes the start of the step into the energy account, where the lane is chosen.
    pub fn close_account<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let account = self.layout.account(blocks.rows.start);
        let supplied_j = account.supplied_j;
        let mut losses_j = account.contact_loss_j + account.friction_loss_j;
        if self.layout.has_dampers {
            losses_j += account.damping_loss_j;
        }
        let change_j = blocks.start_reads[ReadLayout::ENERGY] - blocks.lane[LaneLayout::ENERGY_AT_START];
        let residual_j = (change_j + losses_j - supplied_j).abs();
        let kinetic_j = blocks.start_reads[ReadLayout::FREE_KINETIC];
        let exchange_j = change_j.abs().max(supplied_j.abs()).max(losses_j.abs()).max(kinetic_j);
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN]);
        for (place, value) in [(LaneLayout::MAX_RESIDUAL, residual_j), (LaneLayout::MAX_EXCHANGE, exchange_j)] {
            let largest = blocks.lane[place];
            blocks.lane[place] = T::select(is_chosen, largest.max(value), largest);
        }
    }

    /// Follows the current step in the chosen lanes that are recorded: [`FollowLayout::follow`].
    pub fn follow<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN] * blocks.lane[LaneLayout::IS_RECORDED]);
        let (own, step) = self.followed(blocks);
        self.follow.follow(own, &step, is_chosen);
    }

    /// Makes the readings over the current step polynomials: [`FollowLayout::spread`].
    pub fn spread<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let (own, step) = self.followed(blocks);
        self.follow.spread(own, &step);
    }

    /// Reads at an instant within a step: [`FollowLayout::look`].
    pub fn look<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let (own, StepEnds { time, length, .. }) = self.followed(blocks);
        self.follow.look(own, time, length);
    }

    /// The numbers of what is followed, and the ends of the current step.
    fn followed<'b, T: Real>(&self, blocks: &'b mut MemoryBlocks<'_, T>) -> (&'b mut [T], StepEnds<'b, T>) {
        let (length, first) = (blocks.lane[LaneLayout::STEP], self.reads.output(0));
        let sides = [&*blocks.start_reads, &*blocks.end_reads];
        let time = sides.map(|reads| [0, 1, 2].map(|k| reads[ReadLayout::TIME + k]));
        let readings = sides.map(|reads| &reads[first..]);
        (&mut blocks.lane[self.lane.followed()], StepEnds { length, time, readings })
    }

    /// Offset of the values inside the current step among its slopes, behind the dense output: [`InsideLayout::value`].
    ///
    /// [`InsideLayout::value`]: crate::follow::InsideLayout::value
    pub fn first_inside(&self) -> usize {
        self.stepper.rows() * self.layout.length()
    }

    /// The state at one of Lobatto's points of the current step, whose dense output is known; with integrals where `state` has room for them.
    pub fn state_inside<T: Real>(&self, rows: &StepRows<'_, T>, point: usize, state: &mut [T]) {
        let share = T::from_f64(LOBATTO[point].0);
        for (i, value) in state.iter_mut().enumerate() {
            *value = rows.start[i] + self.stepper.dense_change(i, share, |place| rows.stages[place]);
        }
    }

    /// Takes the values inside the current step into their extremes and integrals, in the chosen lanes that are recorded.
    pub fn take_inside<T: Real>(&self, blocks: &mut MemoryBlocks<'_, T>) {
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN] * blocks.lane[LaneLayout::IS_RECORDED]);
        let jet = |reads: &[T]| [0, 1, 2].map(|k| reads[ReadLayout::TIME + k]);
        let time = Quintic::new(jet(blocks.start_reads), jet(blocks.end_reads), blocks.lane[LaneLayout::STEP]);
        let values = &blocks.rows.stages[self.first_inside()..];
        let numbers = &mut blocks.lane[self.lane.followed()];
        let is_peak = self.follow.inside().take(numbers, values, &time, is_chosen);
        numbers[FollowLayout::IS_PEAK] = is_peak;
    }

    /// Computes what looks inside of the current step need.
    pub fn prepare_dense<T: Real>(&self, rows: &mut StepRows<'_, T>, lane: &[T], system: &mut impl System<T>) {
        self.stepper.prepare_dense(rows, lane[LaneLayout::STEP], system);
    }

    /// Weights of errors of u = √δ, one over the error that moves δ by the local error allowed: that is the local error over 2u, with the mean
    /// of the root's sizes at both ends of the step.
    fn set_root_weights<T: Real>(&self, rows: &StepRows<'_, T>, lane: &mut [T]) {
        let smallest = T::from_f64(2.0 * self.local_m.sqrt());
        let step = lane[LaneLayout::STEP];
        for place in self.layout.roots.iter().flatten() {
            // A step from u = 0 on has its size from u' h.
            let start = rows.start[*place];
            let root = rows.stages[*place].mul_add(step, start).abs();
            let size = root + start.abs();
            lane[self.lane.weights()][*place] = size.max(smallest) * T::from_f64(1.0 / self.local_m);
        }
    }

    /// Notes what happens with an attempt: [`Self::judge`], by what its ends show of gaps and contacts.
    pub fn judge_attempt<T: Real>(&self, sample: &Sample<T>, blocks: &mut MemoryBlocks<'_, T>) {
        self.look_at_gaps(sample, blocks);
        self.judge(sample, blocks);
    }

    /// Notes whether the gap of some contact may go through zero within the step in the direction of its next event (it lies
    /// below the largest Bernstein coefficient of its polynomial), a pin passes between faces and ends of its slot, or friction
    /// passes a kink; whether a penetration or a contact force may be a record; and whether a penetration may be beyond what is
    /// allowed.
    fn look_at_gaps<T: Real>(&self, sample: &Sample<T>, blocks: &mut MemoryBlocks<'_, T>) {
        let (zero, one) = (T::zero(), T::one());
        let h = blocks.lane[LaneLayout::STEP];
        let (fifth, twentieth) = (h * T::from_f64(0.2), h * h * T::from_f64(0.05));
        let bernstein = |[p0, v0, a0]: [T; 3], [p1, v1, a1]: [T; 3]| {
            let (first, last) = (fifth * v0, fifth * v1);
            [
                p0,
                p0 + first,
                twentieth.mul_add(a0, p0 + first + first),
                twentieth.mul_add(a1, p1 - last - last),
                p1 - last,
                p1,
            ]
        };
        let (mut eventful, mut notable, mut deep) = (zero, zero, zero);
        let (starts, ends) = (&*blocks.start_reads, &*blocks.end_reads);
        for contact in 0..sample.contacts.len() {
            let of_lane = &blocks.lane[LaneLayout::contact(contact)..];
            let state = play_state(of_lane);
            let numbers = sample.play_of(contact);
            let has_root = if self.layout.roots[contact].is_some() { of_lane[LaneLayout::HAS_ROOT] } else { zero };
            let is_root = is_set(has_root);
            let jets = |place: usize| [starts, ends].map(|reads| [reads[place], reads[place + 1], reads[place + 2]]);
            let [start, mut end] = jets(self.reads.gap(contact));
            if let (Some(slot), Some(place)) = (numbers.shape.slot(), self.reads.along_slot(contact)) {
                let along = jets(place);
                let continued = continued_gap(end, along, slot.half_length_m);
                end = [0, 1, 2].map(|k| T::select(is_root, end[k], continued[k]));
                for side in ENDS {
                    let (is_past, [start, end]) = passage(along, slot.half_length_m, side, T::from_f64(self.local_m));
                    let highest = highest_control_value(bernstein(start, end), is_past);
                    eventful = T::select(highest.less_than(zero), eventful, one);
                }
            }
            let coefficients = bernstein(start, end);
            let [v0, v1] = [start[1], end[1]];
            let is_closed = is_set(state.contact);
            let highest = highest_control_value(coefficients, is_closed);
            eventful = T::select(highest.less_than(zero), eventful, one);

            let mut limit = coefficients[0];
            for coefficient in &coefficients[1..] {
                limit = limit.max(*coefficient);
            }
            // δ from the gap or from the root; δ̇ is below v0 or twice its values at the ends.
            let (depth_m, half_rate_share) = if numbers.foundation.is_none() && numbers.shape.is_round() {
                let clearance_m = numbers.clearance_m;
                let distance_m = (clearance_m.mul_add(clearance_m, limit.max(zero))).sqrt();
                (limit / (distance_m + clearance_m), clearance_m)
            } else {
                (limit, T::from_f64(0.5))
            };
            let depth_m = T::select(is_root, limit * limit, depth_m);
            let pace = starts[ReadLayout::TIME + 1].min(ends[ReadLayout::TIME + 1]);
            let rate_m_s = v0.max(v1) * T::select(is_root, T::from_f64(4.0), one / (half_rate_share * pace));
            let rate_m_s = rate_m_s.min(T::from_f64(FASTEST_M_S)).max(T::from_f64(-FASTEST_M_S));
            let mut force_n = numbers.normal.largest_force_n(depth_m, rate_m_s, &state);
            if let Some(slot) = numbers.shape.slot() {
                force_n *= slot.end_stiffening + one;
            }
            if numbers.shape.face_ends_m().is_some() {
                force_n *= T::from_f64(MAX_STRETCH);
            }
            if numbers.foundation.is_some() {
                // Nothing limits the force of a worn joint from its penetration alone: every step in contact is looked at.
                force_n = T::from_f64(f64::INFINITY);
            }
            let is_deepest = of_lane[LaneLayout::DEEPEST].less_than(depth_m);
            let is_strongest = of_lane[LaneLayout::STRONGEST].less_than(force_n);
            let is_record = T::select(is_deepest, one, T::select(is_strongest, one, notable));
            notable = T::select(is_closed, is_record, notable);
            let root = of_lane[LaneLayout::MAX_ROOT];
            let is_deep = T::select(depth_m.less_than(root * root), deep, one);
            deep = T::select(is_closed, is_deep, deep);

            let place = self.reads.sliding(contact);
            let (start, end) = (starts[place], ends[place]);
            for level in numbers.kink_levels_m_s() {
                eventful = T::select(((start - level) * (end - level)).less_than(zero), one, eventful);
            }
        }
        blocks.lane[LaneLayout::EVENTFUL] = eventful;
        blocks.lane[LaneLayout::NOTABLE] = notable;
        blocks.lane[LaneLayout::DEEP] = deep;
    }
}

/// How much shorter the next step is after one that was not good.
pub fn shrinkage<T: Real>(error: T, growth: T) -> T {
    let [least, most] = SHRINKAGE.map(T::from_f64);
    T::select(error.less_than(T::from_f64(f64::INFINITY)), growth.max(least).min(most), least)
}

/// How long a step lasts, s; `pace` and `change`: dt/ds and d²t/ds² at its start.
pub fn step_in_time<T: Real>([pace, change]: [T; 2], step: T) -> T {
    step * (pace + T::from_f64(0.5) * step * change).abs()
}

/// The smallest step that is tried at a time where an error asks for it, s; `smallest_s`: that of the run.
pub fn smallest_step_s<T: Real>(smallest_s: T, time_s: T) -> T {
    smallest_s.max(T::from_f64(8.0 * f64::EPSILON) * time_s)
}

/// Whether a number that is 0 or 1 is 1.
pub fn is_set<T: Real>(flag: T) -> T::Mask {
    T::from_f64(0.5).less_than(flag)
}

/// The state of the contact whose numbers these are.
pub fn play_state<T: Real>(of_lane: &[T]) -> PlayState<T> {
    PlayState { contact: of_lane[0], inverse_impact_speed_s_m: of_lane[1], effective_mass_kg: of_lane[2] }
}

/// An upper limit of a polynomial of degree five, given by its Bernstein coefficients, or of its negative: the largest
/// coefficient after two subdivisions. The value at the start itself does not count: there the sign is known up to the
/// tolerance of the event before.
fn highest_control_value<T: Real>(coefficients: [T; 6], is_negative: T::Mask) -> T {
    let mut signed = coefficients;
    for coefficient in &mut signed {
        *coefficient = T::select(is_negative, -*coefficient, *coefficient);
    }
    let (left, right) = halves(signed);
    let [(first, second), (third, fourth)] = [halves(left), halves(right)];
    let mut highest = first[1];
    for value in first[2..].iter().chain(&second[1..]).chain(&third[1..]).chain(&fourth[1..]) {
        highest = highest.max(*value);
    }
    highest
}

/// The Bernstein coefficients over both halves of the interval (de Casteljau).
fn halves<T: Real>(coefficients: [T; 6]) -> ([T; 6], [T; 6]) {
    let half = T::from_f64(0.5);
    let (mut row, mut left, mut right) = (coefficients, coefficients, coefficients);
    for level in 1..6 {
        for k in 0..6 - level {
            row[k] = half * (row[k] + row[k + 1]);
        }
        left[level] = row[0];
        right[5 - level] = row[5 - level];
    }
    (left, right)
}
