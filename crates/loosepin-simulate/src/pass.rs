//! The arithmetic of a pass over one lane: try a step, look at its end, take it over. Written once over [`Real`]: done as it
//! stands for one run, written down for many ([`super::recorded`]).

use super::follow::{Follow, FollowLayout, StepEnds};
use super::memory::{BLOCKS, LaneLayout, Named};
use super::motion::{Layout, Motion, tolerances};
use super::projection::Projection;
use super::reads::ReadLayout;
use super::settings::{STEP_SHARE, Settings};
use loosepin_math::Real;
use loosepin_math::integrate::{StepRows, Stepper, System};
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, PlayShape, Sample};

/// Rates of a contact are taken to be no faster than this, m/s: infinite ones times a law's number that is zero are none.
const FASTEST_M_S: f64 = 1e100;

/// Parts of a pass that all lanes share.
#[derive(Debug, Clone)]
pub struct Pass {
    /// Where everything is in a state.
    pub layout: Layout,
    /// Where everything is in what is read.
    pub reads: ReadLayout,
    /// Where everything is among the numbers of a lane.
    pub lane: LaneLayout,
    /// Where everything is among the numbers of what is followed.
    pub follow: FollowLayout,
    /// The integrator.
    pub stepper: Stepper,
    /// Local error allowed in lengths, m.
    pub local_m: f64,
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
            layout,
        }
    }

    /// For each block, how many numbers a lane has in it, with so many numbers of its sample.
    pub fn block_lengths(&self, numbers: usize) -> [usize; BLOCKS] {
        let (row, reads) = (self.layout.length(), self.reads.length());
        [numbers, self.lane.length(), row, self.stepper.rows() * row, row, row, reads, reads]
    }

    /// Tries the step of the lane; `system` reads at its end.
    pub fn attempt<T: Real>(&self, rows: &mut StepRows<'_, T>, lane: &mut [T], system: &mut impl System<T>) {
        self.set_root_tolerances(rows, lane);
        let error = self.stepper.attempt(rows, lane[LaneLayout::STEP], &lane[self.lane.tolerances()], system);
        lane[LaneLayout::ERROR] = error;
        lane[LaneLayout::GROWTH] = self.stepper.growth(error);
    }

    /// Makes what was evaluated last, slope and reads, those of the start of the step, where the lane is chosen.
    pub fn take_evaluation<T: Real>(&self, blocks: &mut Named<'_, T>) {
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
    pub fn accept<T: Real>(&self, blocks: &mut Named<'_, T>) {
        self.take_evaluation(blocks);
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN]);
        for (start, end) in blocks.rows.start.iter_mut().zip(&*blocks.rows.end) {
            *start = T::select(is_chosen, *end, *start);
        }
    }

    /// Holds the loops of ideal joints at the start of the step, where the lane is chosen.
    pub fn hold_loops<T: Real>(
        &self,
        blocks: &mut Named<'_, T>,
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
    pub fn close_account<T: Real>(&self, blocks: &mut Named<'_, T>) {
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
        for (place, value) in [(LaneLayout::LARGEST_RESIDUAL, residual_j), (LaneLayout::LARGEST_EXCHANGE, exchange_j)] {
            let largest = blocks.lane[place];
            blocks.lane[place] = T::select(is_chosen, largest.max(value), largest);
        }
    }

    /// Follows the step at hand in the chosen lanes: [`FollowLayout::follow`].
    pub fn follow<T: Real>(&self, blocks: &mut Named<'_, T>) {
        let is_chosen = is_set(blocks.lane[LaneLayout::CHOSEN]);
        let (own, step) = self.followed(blocks);
        self.follow.follow(own, &step, is_chosen);
    }

    /// Reads at an instant within the step at hand: [`FollowLayout::look`].
    pub fn look<T: Real>(&self, blocks: &mut Named<'_, T>) {
        let (own, step) = self.followed(blocks);
        self.follow.look(own, &step);
    }

    /// The numbers of what is followed, and the ends of the step at hand.
    fn followed<'b, T: Real>(
        &self,
        blocks: &'b mut Named<'_, T>,
    ) -> (&'b mut [T], StepEnds<T, impl Fn(usize, usize) -> [T; 3] + 'b>) {
        let (reads, length) = (self.reads, blocks.lane[LaneLayout::STEP]);
        let sides = [&*blocks.start_reads, &*blocks.end_reads];
        let three =
            move |side: usize, place: usize| [sides[side][place], sides[side][place + 1], sides[side][place + 2]];
        let time = [0, 1].map(|side| three(side, ReadLayout::TIME));
        let reading = move |reading: usize, side: usize| three(side, reads.output(reading));
        (&mut blocks.lane[self.lane.followed()], StepEnds { length, time, reading })
    }

    /// Computes what looks inside of the step at hand need.
    pub fn prepare_dense<T: Real>(&self, rows: &mut StepRows<'_, T>, lane: &[T], system: &mut impl System<T>) {
        self.stepper.prepare_dense(rows, lane[LaneLayout::STEP], system);
    }

    /// The error of u = √δ that moves δ by the local error allowed: that over the root's size, the larger of both ends of the
    /// step before.
    fn set_root_tolerances<T: Real>(&self, rows: &StepRows<'_, T>, lane: &mut [T]) {
        let smallest = T::from_f64(2.0 * self.local_m.sqrt());
        let step = lane[LaneLayout::STEP];
        for place in self.layout.roots.iter().flatten() {
            // A step from u = 0 on has its size from u' h.
            let start = rows.start[*place];
            let root = rows.stages[*place].mul_add(step, start).abs();
            let size = root + start.abs();
            lane[self.lane.tolerances()][*place] = T::from_f64(self.local_m) / size.max(smallest);
        }
    }

    /// Notes whether the gap of some contact may go through zero within the step in the direction of its next event (it lies
    /// below the largest Bernstein coefficient of its polynomial) or friction passes a kink; and whether a penetration or a
    /// contact force may be a record.
    pub fn look_at_gaps<T: Real>(&self, sample: &Sample<T>, blocks: &mut Named<'_, T>) {
        let (zero, one) = (T::zero(), T::one());
        let h = blocks.lane[LaneLayout::STEP];
        let (fifth, twentieth) = (h * T::from_f64(0.2), h * h * T::from_f64(0.05));
        let (mut eventful, mut notable) = (zero, zero);
        let (starts, ends) = (&*blocks.start_reads, &*blocks.end_reads);
        for contact in 0..sample.contacts.len() {
            let of_lane = &blocks.lane[LaneLayout::contact(contact)..];
            let state = play_state(of_lane);
            let place = self.reads.gap(contact);
            let [p0, v0, a0] = [starts[place], starts[place + 1], starts[place + 2]];
            let [p1, v1, a1] = [ends[place], ends[place + 1], ends[place + 2]];
            let (first, last) = (fifth * v0, fifth * v1);
            let coefficients = [
                p0,
                p0 + first,
                twentieth.mul_add(a0, p0 + first + first),
                twentieth.mul_add(a1, p1 - last - last),
                p1 - last,
                p1,
            ];
            let is_closed = is_set(state.contact);
            let highest = highest_control_value(coefficients, is_closed);
            eventful = T::select(highest.less_than(zero), eventful, one);

            let numbers = sample.play_of(contact);
            let mut limit = coefficients[0];
            for coefficient in &coefficients[1..] {
                limit = limit.max(*coefficient);
            }
            // δ from the gap or from the root; δ̇ is below v0 or twice its values at the ends.
            let has_root = if self.layout.roots[contact].is_some() { of_lane[LaneLayout::HAS_ROOT] } else { zero };
            let is_root = is_set(has_root);
            let (depth_m, half_rate_share) = match numbers.shape {
                PlayShape::Pin { .. } | PlayShape::Slot(_) => {
                    let clearance_m = numbers.clearance_m;
                    let distance_m = (clearance_m.mul_add(clearance_m, limit.max(zero))).sqrt();
                    (limit / (distance_m + clearance_m), clearance_m)
                }
                PlayShape::Slider(_) => (limit, T::from_f64(0.5)),
            };
            let depth_m = T::select(is_root, limit * limit, depth_m);
            let pace = starts[ReadLayout::TIME + 1].min(ends[ReadLayout::TIME + 1]);
            let rate_m_s = v0.max(v1) * T::select(is_root, T::from_f64(4.0), one / (half_rate_share * pace));
            let rate_m_s = rate_m_s.min(T::from_f64(FASTEST_M_S)).max(T::from_f64(-FASTEST_M_S));
            let mut force_n = numbers.normal.largest_force_n(depth_m, rate_m_s, &state);
            if let PlayShape::Slot(slot) = &numbers.shape {
                force_n *= slot.end_stiffening + one;
            }
            let is_deepest = of_lane[LaneLayout::DEEPEST].less_than(depth_m);
            let is_strongest = of_lane[LaneLayout::STRONGEST].less_than(force_n);
            let is_record = T::select(is_deepest, one, T::select(is_strongest, one, notable));
            notable = T::select(is_closed, is_record, notable);

            let place = self.reads.sliding(contact);
            let (start, end) = (starts[place], ends[place]);
            for speed in numbers.friction.kink_speeds_m_s().into_iter().flatten() {
                for level in [speed, -speed] {
                    eventful = T::select(((start - level) * (end - level)).less_than(zero), one, eventful);
                }
            }
        }
        blocks.lane[LaneLayout::EVENTFUL] = eventful;
        blocks.lane[LaneLayout::NOTABLE] = notable;
    }
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
