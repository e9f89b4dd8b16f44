//! The arithmetic of a step, on all lanes at once: stages, error, and everything read off the end of the step.

use super::column::{Arms, Reading};
use super::motion::{Motion, tolerances};
use super::projection::Projection;
use super::settings::{STEP_SHARE, Settings};
use crate::dynamics::PlayState;
use crate::integrate::Stepper;
use crate::math::{Lanes, Real};
use crate::mechanism::{Mechanism, Sample, acceleration_at};

/// Values with their first two derivatives over the variable of integration, at one end of a step.
#[derive(Debug, Clone)]
pub struct Jets<T> {
    /// The time, s.
    pub time: [T; 3],
    /// For each joint with play g = |e|² - c², m², or the root of the penetration where that is an unknown, √m.
    pub gaps: Vec<[T; 3]>,
    /// Sliding velocity of each joint with play, m/s; zero where there is no friction.
    pub slidings_m_s: Vec<T>,
    /// The followed outputs.
    pub outputs: Vec<[T; 3]>,
}

impl<T: Real> Jets<T> {
    fn new(plays: usize, outputs: usize) -> Self {
        let zero = [T::zero(); 3];
        Self { time: zero, gaps: vec![zero; plays], slidings_m_s: vec![T::zero(); plays], outputs: vec![zero; outputs] }
    }

    #[inline(always)]
    fn take_where(&mut self, mask: T::Mask, other: &Self) {
        let choose = |to: &mut [T; 3], from: &[T; 3]| {
            for (to, from) in to.iter_mut().zip(from) {
                *to = T::select(mask, *from, *to);
            }
        };
        choose(&mut self.time, &other.time);
        for (to, from) in self.gaps.iter_mut().zip(&other.gaps) {
            choose(to, from);
        }
        for (to, from) in self.slidings_m_s.iter_mut().zip(&other.slidings_m_s) {
            *to = T::select(mask, *from, *to);
        }
        for (to, from) in self.outputs.iter_mut().zip(&other.outputs) {
            choose(to, from);
        }
    }
}

/// What one attempted step of all lanes showed: a bit for each lane.
#[derive(Debug, Clone, Copy, Default)]
pub struct Attempt {
    /// The error is small enough.
    pub good: u32,
    /// A contact may begin or end within the step.
    pub eventful: u32,
}

/// States, steps and scratch of all lanes.
pub struct Core<'a, T> {
    /// The equations.
    pub motion: Motion<'a, T>,
    /// The integrator.
    pub stepper: Stepper<T>,
    projection: Option<Projection<T>>,
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
    /// Mechanical energy at the end of the last attempt, or at the start after a projection, J.
    pub energies_j: T,
    readings: Vec<Reading>,
    arms: Arms<T>,
    /// At the start of the step.
    pub start: Jets<T>,
    /// At its end.
    pub end: Jets<T>,
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
    ) -> Self {
        let motion = Motion::new(mechanism, &Sample::broadcast(sample));
        let layout = &motion.layout;
        let stepper = Stepper::with_integrals(settings.method, layout.dimension, layout.length() - layout.dimension);
        let (plays, outputs) = (mechanism.plays.len(), readings.len());
        Self {
            stepper,
            projection: Projection::<T>::is_needed(mechanism).then(|| Projection::new(mechanism)),
            tolerances: tolerances(&motion, 1.0, 1.0, 1.0).into_iter().map(T::from_f64).collect(),
            local_m: settings.tolerance_m * STEP_SHARE,
            order: settings.method.order,
            steps: T::zero(),
            errors: T::zero(),
            growth: T::one(),
            energies_j: T::zero(),
            readings: readings.to_vec(),
            arms: Arms::broadcast(arms),
            start: Jets::new(plays, outputs),
            end: Jets::new(plays, outputs),
            motion,
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
        self.motion.dynamics.sample_mut().set_lane(lane, sample);
        self.arms.set_lane(lane, arms);
        let tolerances = tolerances(&self.motion, self.local_m, rate_1_s, energy_j);
        for (to, from) in self.tolerances.iter_mut().zip(tolerances) {
            to.set_lane(lane, from);
        }
        for (to, from) in self.stepper.start_mut().iter_mut().zip(state) {
            to.set_lane(lane, *from);
        }
        for play in 0..self.motion.states.len() {
            self.set_contact(lane, play, &PlayState::flight(), false);
        }
    }

    /// Sets the contact state of a joint with play in a lane. The lane needs a restart. A penetration whose root becomes an
    /// unknown begins at zero.
    pub fn set_contact(&mut self, lane: usize, play: usize, state: &PlayState<f64>, has_root: bool) {
        let to = &mut self.motion.states[play];
        to.contact.set_lane(lane, state.contact);
        to.inverse_impact_speed_s_m.set_lane(lane, state.inverse_impact_speed_s_m);
        if let (Some(root), Some(place)) = (&mut self.motion.roots[play], self.motion.layout.roots[play]) {
            root.is_unknown.set_lane(lane, f64::from(u8::from(has_root)));
            self.stepper.start_mut()[place].set_lane(lane, 0.0);
        }
    }

    /// The contact state of a joint with play in a lane, and whether the root of its penetration is an unknown.
    pub fn contact(&self, lane: usize, play: usize) -> (PlayState<f64>, bool) {
        let state = &self.motion.states[play];
        let has_root = self.motion.roots[play].is_some_and(|root| root.is_unknown.lane(lane) > 0.5);
        let state = PlayState {
            contact: state.contact.lane(lane),
            inverse_impact_speed_s_m: state.inverse_impact_speed_s_m.lane(lane),
        };
        (state, has_root)
    }

    /// Evaluates the derivative at the start again in the flagged lanes, and reads their jets and energy there.
    pub fn restart(&mut self, lanes: u32) {
        T::vectorize(
            #[inline(always)]
            || {
                let mask = T::mask(lanes);
                self.stepper.restart_where(&mut self.motion, mask);
                self.read_end();
                self.start.take_where(mask, &self.end);
            },
        );
    }

    /// Whether loops are held after every step: then the accepted lanes need a restart.
    pub fn holds_loops(&self) -> bool {
        self.projection.is_some()
    }

    /// Tries the steps of all lanes.
    pub fn attempt(&mut self) -> Attempt {
        T::vectorize(
            #[inline(always)]
            || {
                self.set_root_tolerances();
                let errors = self.stepper.attempt(&mut self.motion, self.steps, &self.tolerances);
                if !self.stepper.finishes_by_itself() {
                    self.stepper.finish(&mut self.motion);
                }
                if let Some(projection) = &mut self.projection {
                    projection.keep_mass(&self.motion);
                }
                self.read_end();
                self.errors = errors;
                self.growth = growth(errors, self.order);
                let is_good = T::flags(errors.less_than(T::from_f64(1.0 + f64::EPSILON)));
                Attempt { good: is_good, eventful: self.eventful() }
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
                self.start.take_where(mask, &self.end);
                if let Some(projection) = &mut self.projection {
                    let place = self.motion.layout.time();
                    projection.apply_where(mask, &mut self.motion, place, self.stepper.start_mut());
                }
            },
        );
    }

    /// Computes what looks inside of the step at hand need.
    pub fn prepare_dense(&mut self) {
        T::vectorize(
            #[inline(always)]
            || self.stepper.prepare_dense(&mut self.motion),
        );
    }

    /// The error of u = √δ that moves δ by the local error allowed: that over the root's size, the larger of both ends of the
    /// step before.
    #[inline(always)]
    fn set_root_tolerances(&mut self) {
        let smallest = T::from_f64(2.0 * self.local_m.sqrt());
        for place in self.motion.layout.roots.iter().flatten() {
            // A step from u = 0 on has its size from u' h.
            let slope = self.stepper.start_slope()[*place];
            let root = slope.mul_add(self.steps, self.stepper.start()[*place]).abs();
            let size = root + self.stepper.start()[*place].abs();
            self.tolerances[*place] = T::from_f64(self.local_m) / size.max(smallest);
        }
    }

    /// Reads times, gaps, outputs and energy off the state that was evaluated last.
    #[inline(always)]
    fn read_end(&mut self) {
        let [pace, change] = self.motion.pace();
        let dynamics = &self.motion.dynamics;
        // d/ds = w d/dt and d²/ds² = w² d²/dt² + w' d/dt.
        let over_s = |[value, rate, acceleration]: [T; 3]| {
            [value, rate * pace, (pace * pace).mul_add(acceleration, change * rate)]
        };
        let two = T::from_f64(2.0);
        for (play, gap) in self.end.gaps.iter_mut().enumerate() {
            let (motion, force) = &dynamics.plays()[play];
            let [i, j] = dynamics.play_slots()[play];
            let twists = &dynamics.kinematics.twists;
            let acceleration = acceleration_at(&dynamics.acceleration(j), &twists[j], motion.journal_arm_m)
                - acceleration_at(&dynamics.acceleration(i), &twists[i], motion.bearing_arm_m);
            let (e, rate) = (motion.eccentricity_m, motion.eccentricity_rate_m_s);
            let along = rate.length_squared() + e.dot(acceleration);
            let clearance_m = dynamics.sample().plays[play].clearance_m;
            self.end.slidings_m_s[play] = force.sliding_m_s;
            *gap = over_s([motion.gap_m2(clearance_m), two * e.dot(rate), two * along]);
            if let Some(root) = &self.motion.roots[play] {
                let is_unknown = T::from_f64(0.5).less_than(root.is_unknown);
                let half = T::from_f64(0.5);
                let speed = force.penetration_rate_m_s;
                // δ̈ from d²|e|²/dt² = 2(δ̇² + |e| δ̈).
                let length_m = e.length().max(T::from_f64(f64::MIN_POSITIVE));
                let second = (along - speed * speed) / length_m * half * pace;
                *gap = [
                    T::select(is_unknown, root.root, gap[0]),
                    T::select(is_unknown, half * speed, gap[1]),
                    T::select(is_unknown, second, gap[2]),
                ];
            }
        }
        for (output, reading) in self.end.outputs.iter_mut().zip(&self.readings) {
            *output = over_s(reading.jet(&self.arms, dynamics));
        }
        let states = &self.motion.states;
        self.energies_j = dynamics
            .energy_in(
                #[inline(always)]
                |play| states[play].contact,
            )
            .total_j();
        self.end.time = [self.motion.time_s, pace, change];
    }

    /// Lanes in which the gap of some joint may go through zero within the step in the direction of its next event (it lies
    /// below the largest Bernstein coefficient of its polynomial), or friction passes a kink.
    #[inline(always)]
    fn eventful(&self) -> u32 {
        let h = self.steps;
        let (fifth, twentieth) = (h * T::from_f64(0.2), h * h * T::from_f64(0.05));
        let mut eventful = 0;
        for (play, state) in self.motion.states.iter().enumerate() {
            let ([p0, v0, a0], [p1, v1, a1]) = (self.start.gaps[play], self.end.gaps[play]);
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
            let numbers = &self.motion.dynamics.sample().plays[play];
            if numbers.has_friction {
                let (start, end) = (self.start.slidings_m_s[play], self.end.slidings_m_s[play]);
                for speed in numbers.friction.kink_speeds_m_s() {
                    for level in [speed, -speed] {
                        eventful |= T::flags(((start - level) * (end - level)).less_than(T::zero()));
                    }
                }
            }
        }
        eventful
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
