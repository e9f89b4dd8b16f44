//! The arithmetic of a step, on all lanes at once: stages, error, and everything read off the end of the step.

use super::column::{Arms, Reading};
use super::equations::Equations;
use super::gap::GapJet;
use super::motion::tolerances;
use super::reads::ReadLayout;
use super::report::{EnergyAccount, PlaySummary};
use super::resume::MotionState;
use super::settings::{STEP_SHARE, Settings};
use loosepin_math::integrate::Stepper;
use loosepin_math::{Lanes, Real};
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, PlayShape, Sample};
use loosepin_tape::native::Level;

/// What one attempted step of all lanes showed: a bit for each lane.
#[derive(Debug, Clone, Copy, Default)]
pub struct Attempt {
    /// The error is small enough.
    pub good: u32,
    /// A contact may begin or end within the step.
    pub eventful: u32,
    /// A penetration or a contact force may be the largest of its run.
    pub notable: u32,
}

/// States, steps and scratch of all lanes.
pub struct Core<'a, T> {
    /// The equations.
    pub equations: Equations<'a, T>,
    /// The integrator.
    pub stepper: Stepper<T>,
    /// Where things are in the rows below.
    pub layout: ReadLayout,
    /// What was read at the start of the step.
    pub start: Vec<T>,
    /// Tolerances of all unknowns; those of the roots are set before each step.
    tolerances: Vec<T>,
    /// Local error allowed in lengths, m.
    local_m: f64,
    order: u32,
    /// Steps to be attempted.
    pub steps: T,
    /// Error of the last attempt over what is allowed.
    pub errors: T,
    /// 0.9 · error^(-1/order): how much longer the next step may be.
    pub growth: T,
    /// Mechanical energy at the start of the run, J.
    energy_at_start_j: T,
    /// Kinetic energy at the start of the run, J, where it is read.
    kinetic_at_start_j: T,
    /// Largest residual and largest exchange of the energy account so far, J.
    largest_residual_j: T,
    largest_exchange_j: T,
    /// Largest penetration, m, and largest normal force, N, of each contact so far.
    records: Vec<[T; 2]>,
}

impl<'a, T: Lanes> Core<'a, T> {
    /// Room for `mechanism`; every lane holds `sample` until it is loaded. `readings` are followed: their values and
    /// derivatives at the ends of every step.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        readings: &[Reading],
        settings: &Settings,
        level: Option<Level>,
    ) -> Self {
        let equations = Equations::new(mechanism, sample, arms, readings, level);
        let layout = &equations.motion.layout;
        let reads = ReadLayout::new(mechanism, readings.len());
        Self {
            stepper: Stepper::with_integrals(settings.method, layout.dimension, layout.length() - layout.dimension),
            layout: reads,
            start: vec![T::zero(); reads.length()],
            tolerances: tolerances(&equations.motion, sample, 1.0, 1.0, 1.0).into_iter().map(T::from_f64).collect(),
            local_m: settings.tolerance_m * STEP_SHARE,
            order: settings.method.order,
            steps: T::zero(),
            errors: T::zero(),
            growth: T::one(),
            energy_at_start_j: T::zero(),
            kinetic_at_start_j: T::zero(),
            largest_residual_j: T::zero(),
            largest_exchange_j: T::zero(),
            records: vec![[T::zero(); 2]; mechanism.contacts.len()],
            equations,
        }
    }

    /// Puts a run that begins at `state` (layout of [`super::motion::Layout`]) into a lane. It needs a restart.
    pub fn load(
        &mut self,
        lane: usize,
        sample: &Sample<f64>,
        arms: &Arms,
        state: &[f64],
        rate_1_s: f64,
        energy_j: f64,
    ) {
        self.equations.load(lane, sample, arms);
        let tolerances = tolerances(&self.equations.motion, sample, self.local_m, rate_1_s, energy_j);
        for (to, from) in self.tolerances.iter_mut().zip(tolerances) {
            to.set_lane(lane, from);
        }
        for (to, from) in self.stepper.start_mut().iter_mut().zip(state) {
            to.set_lane(lane, *from);
        }
        for contact in 0..self.equations.motion.states.len() {
            self.set_contact(lane, contact, &PlayState::flight(), false);
            self.set_records(lane, contact, &PlaySummary::default());
        }
    }

    /// Puts the contacts of a run that goes on into a lane that was loaded. Penetrations are read off the positions until the
    /// next contact begins; deflections of bristles go on as they are. The lane needs a restart.
    pub fn resume(&mut self, lane: usize, resume: &MotionState) {
        for (contact, state) in resume.contacts.iter().enumerate() {
            self.set_contact(lane, contact, state, false);
            if let Some(place) = self.equations.motion.layout.bristles[contact] {
                self.stepper.start_mut()[place].set_lane(lane, resume.state[place]);
            }
        }
    }

    /// Keeps the records of a contact, against which steps are judged.
    pub fn set_records(&mut self, lane: usize, contact: usize, summary: &PlaySummary) {
        self.records[contact][0].set_lane(lane, summary.largest_penetration_m);
        self.records[contact][1].set_lane(lane, summary.peak_force_n);
    }

    /// Sets the state of a contact in a lane. The lane needs a restart. A penetration whose root becomes an
    /// unknown begins at zero, and so does the deflection of bristles.
    pub fn set_contact(&mut self, lane: usize, contact: usize, state: &PlayState<f64>, has_root: bool) {
        self.equations.set_contact(lane, contact, state, has_root);
        let layout = &self.equations.motion.layout;
        for place in [layout.roots[contact], layout.bristles[contact]].into_iter().flatten() {
            self.stepper.start_mut()[place].set_lane(lane, 0.0);
        }
    }

    /// Three numbers in a row of a lane at the start and at the end of the step: a value and its derivatives.
    #[inline]
    pub fn jets(&self, lane: usize, place: usize) -> [GapJet; 2] {
        // Written out: closures over arrays are not always inlined, and this is read for every step of every lane.
        let (start, end) = (&self.start[place..place + 3], &self.equations.reads[place..place + 3]);
        // Machine code leaves out what is multiplied by zero, which may turn the sign of a zero: adding zero makes it positive.
        let number = |value: &T| value.lane(lane) + 0.0;
        [
            GapJet { jet: [number(&start[0]), number(&start[1]), number(&start[2])] },
            GapJet { jet: [number(&end[0]), number(&end[1]), number(&end[2])] },
        ]
    }

    /// Evaluates the derivative at the start again in the flagged lanes, and reads there.
    pub fn restart(&mut self, lanes: u32) {
        T::vectorize(
            #[inline(always)]
            || {
                let mask = T::mask(lanes);
                self.stepper.restart_where(&mut self.equations, mask);
                self.take_reads(mask);
            },
        );
    }

    /// Tries the steps of all lanes.
    pub fn attempt(&mut self) -> Attempt {
        T::vectorize(
            #[inline(always)]
            || {
                self.set_root_tolerances();
                let errors = self.stepper.attempt(&mut self.equations, self.steps, &self.tolerances);
                if !self.stepper.finishes_by_itself() {
                    self.stepper.finish(&mut self.equations);
                }
                self.errors = errors;
                self.growth = growth(errors, self.order);
                let is_good = T::flags(errors.less_than(T::from_f64(1.0 + f64::EPSILON)));
                let (eventful, notable) = self.look_at_gaps();
                Attempt { good: is_good, eventful, notable }
            },
        )
    }

    /// Makes the end of the step the start of the next one in the flagged lanes, and holds their loops.
    pub fn accept(&mut self, lanes: u32) {
        T::vectorize(
            #[inline(always)]
            || {
                let mask = T::mask(lanes);
                self.stepper.accept_where(mask);
                self.take_reads(mask);
                self.equations.hold_loops(mask, self.stepper.start_mut());
            },
        );
    }

    /// Begins the energy account of a lane that was loaded and evaluated.
    pub fn open_account(&mut self, lane: usize) {
        self.energy_at_start_j.set_lane(lane, self.start[ReadLayout::ENERGY].lane(lane));
        if let Some(place) = self.layout.kinetic() {
            self.kinetic_at_start_j.set_lane(lane, self.start[place].lane(lane));
        }
        self.largest_residual_j.set_lane(lane, 0.0);
        self.largest_exchange_j.set_lane(lane, 0.0);
    }

    /// Takes the end of a step into the energy accounts of the flagged lanes.
    pub fn close_accounts(&mut self, lanes: u32) {
        T::vectorize(
            #[inline(always)]
            || {
                let layout = &self.equations.motion.layout;
                let account = layout.account(self.stepper.start());
                let supplied_j = account.supplied_j;
                let mut losses_j = account.contact_loss_j + account.friction_loss_j;
                if layout.has_dampers {
                    losses_j += account.damping_loss_j;
                }
                let change_j = self.start[ReadLayout::ENERGY] - self.energy_at_start_j;
                let residual_j = (change_j + losses_j - supplied_j).abs();
                let exchange_j = change_j.abs().max(supplied_j.abs()).max(losses_j.abs());
                let mask = T::mask(lanes);
                let raise = |to: &mut T, value: T| *to = T::select(mask, to.max(value), *to);
                raise(&mut self.largest_residual_j, residual_j);
                raise(&mut self.largest_exchange_j, exchange_j);
                if let Some(place) = self.layout.kinetic() {
                    raise(&mut self.largest_exchange_j, (self.start[place] - self.kinetic_at_start_j).abs());
                }
            },
        );
    }

    /// The energy account of a lane after its last step.
    pub fn account(&self, lane: usize) -> EnergyAccount {
        let account = self.equations.motion.layout.account(self.stepper.start());
        EnergyAccount {
            at_start_j: self.energy_at_start_j.lane(lane),
            at_end_j: self.start[ReadLayout::ENERGY].lane(lane),
            supplied_j: account.supplied_j.lane(lane),
            contact_loss_j: account.contact_loss_j.lane(lane),
            friction_loss_j: account.friction_loss_j.lane(lane),
            damping_loss_j: account.damping_loss_j.lane(lane),
            largest_residual_j: self.largest_residual_j.lane(lane),
            largest_exchange_j: self.largest_exchange_j.lane(lane),
        }
    }

    #[inline(always)]
    fn take_reads(&mut self, mask: T::Mask) {
        for (start, end) in self.start.iter_mut().zip(&self.equations.reads) {
            *start = T::select(mask, *end, *start);
        }
    }

    /// Computes what looks inside of the step at hand need.
    pub fn prepare_dense(&mut self) {
        T::vectorize(
            #[inline(always)]
            || self.stepper.prepare_dense(&mut self.equations),
        );
    }

    /// The error of u = √δ that moves δ by the local error allowed: that over the root's size, the larger of both ends of the
    /// step before.
    #[inline(always)]
    fn set_root_tolerances(&mut self) {
        let smallest = T::from_f64(2.0 * self.local_m.sqrt());
        for place in self.equations.motion.layout.roots.iter().flatten() {
            // A step from u = 0 on has its size from u' h.
            let slope = self.stepper.start_slope()[*place];
            let root = slope.mul_add(self.steps, self.stepper.start()[*place]).abs();
            let size = root + self.stepper.start()[*place].abs();
            self.tolerances[*place] = T::from_f64(self.local_m) / size.max(smallest);
        }
    }

    /// Lanes in which the gap of some contact may go through zero within the step in the direction of its next event (it lies
    /// below the largest Bernstein coefficient of its polynomial) or friction passes a kink; and lanes in which a penetration
    /// or a contact force may be a record.
    #[inline(always)]
    fn look_at_gaps(&self) -> (u32, u32) {
        let h = self.steps;
        let (fifth, twentieth) = (h * T::from_f64(0.2), h * h * T::from_f64(0.05));
        let (mut eventful, mut notable) = (0, 0);
        let (starts, ends) = (&self.start, &self.equations.reads);
        let motion = &self.equations.motion;
        for (contact, state) in motion.states.iter().enumerate() {
            let place = self.layout.gap(contact);
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
            let is_closed = T::from_f64(0.5).less_than(state.contact);
            let highest = highest_control_value(coefficients, is_closed);
            eventful |= !T::flags(highest.less_than(T::zero()));

            let numbers = motion.dynamics.sample().play_of(contact);
            let mut limit = coefficients[0];
            for coefficient in &coefficients[1..] {
                limit = limit.max(*coefficient);
            }
            // δ from the gap or from the root; δ̇ is below v0 or twice its values at the ends.
            let is_root = motion.unknowns[contact].root.map_or(T::zero(), |root| root.is_unknown);
            let is_root = T::from_f64(0.5).less_than(is_root);
            let (depth_m, half_rate_share) = match numbers.shape {
                PlayShape::Pin { .. } | PlayShape::Slot(_) => {
                    let clearance_m = numbers.clearance_m;
                    let distance_m = (clearance_m.mul_add(clearance_m, limit.max(T::zero()))).sqrt();
                    (limit / (distance_m + clearance_m), clearance_m)
                }
                PlayShape::Slider(_) => (limit, T::from_f64(0.5)),
            };
            let depth_m = T::select(is_root, limit * limit, depth_m);
            let pace = starts[ReadLayout::TIME + 1].min(ends[ReadLayout::TIME + 1]);
            let rate_m_s = v0.max(v1) * T::select(is_root, T::from_f64(4.0), T::one() / (half_rate_share * pace));
            let mut force_n = numbers.normal.largest_force_n(depth_m, rate_m_s, state);
            if let PlayShape::Slot(slot) = &numbers.shape {
                force_n *= slot.end_stiffening + T::one();
            }
            let [deepest_m, strongest_n] = self.records[contact];
            let is_closed = T::flags(is_closed);
            notable |= is_closed & (T::flags(deepest_m.less_than(depth_m)) | T::flags(strongest_n.less_than(force_n)));

            let place = self.layout.sliding(contact);
            let (start, end) = (starts[place], ends[place]);
            for speed in numbers.friction.kink_speeds_m_s().into_iter().flatten() {
                for level in [speed, -speed] {
                    eventful |= T::flags(((start - level) * (end - level)).less_than(T::zero()));
                }
            }
        }
        (eventful, notable)
    }
}

/// An upper limit of a polynomial of degree five, given by its Bernstein coefficients, or of its negative: the largest
/// coefficient after two subdivisions. The value at the start itself does not count: there the sign is known up to the
/// tolerance of the event before.
#[inline(always)]
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
#[inline(always)]
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

/// 0.9 · error^(-1/order). The eighth root by square roots, which are correctly rounded on every processor.
#[inline(always)]
fn growth<T: Lanes>(errors: T, order: u32) -> T {
    let nine_tenths = T::from_f64(0.9);
    if order == 8 {
        return nine_tenths / errors.sqrt().sqrt().sqrt();
    }
    let mut growth = errors;
    for lane in 0..T::COUNT {
        growth.set_lane(lane, 0.9 * libm::pow(errors.lane(lane), -1.0 / f64::from(order)));
    }
    growth
}
