//! A pass over all lanes: try a step, look at its end, take it over; and the numbers of all lanes.

use crate::depth_limit::DepthLimit;
use crate::follow::{Follow, FollowLayout};
use crate::lanes::execution::Execution;
use crate::lanes::memory::{Block, LaneLayout, Memory, MemoryBlocks, NextStepRule};
use crate::lanes::pass::Pass;
use crate::lanes::programs::numbers;
use crate::lanes::reads::ReadLayout;
use crate::lanes::recorded::Recorded;
use crate::lanes::single_lane::SingleLane;
use crate::recording::report::{EnergyAccount, FrictionLoss, FrictionPath, PlaySummary};
use crate::resume::MotionState;
use crate::settings::Settings;
use crate::stepping::gap::GapJet;
use crate::stepping::motion::{Watched, tolerances};
use loosepin_math::Quintic;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample};

/// The bit of each lane, as a number.
const POWERS_OF_TWO: [f64; 32] = {
    let mut powers = [0.0; 32];
    let mut lane = 0;
    while lane < 32 {
        powers[lane] = (1_u64 << lane) as f64;
        lane += 1;
    }
    powers
};

/// How a pass is computed.
enum Backend<'a> {
    SingleLane(Box<SingleLane<'a>>),
    Recorded(Box<Recorded<'a>>),
}

/// An instant that waits to be read at.
#[derive(Debug, Clone, Copy)]
pub struct PendingInstant {
    /// Lane of its run.
    pub lane: usize,
    /// Its index in the run.
    pub index: usize,
    /// When it is, s.
    pub instant_s: f64,
}

/// The numbers of all lanes, and what is done with them.
pub struct Core<'a> {
    mechanism: &'a Mechanism,
    /// The arithmetic, and where everything is.
    pub pass: Pass,
    memory: Memory,
    /// What the instants that wait are read from: at each place one instant, of any lane's run.
    waiting: Memory,
    backend: Backend<'a>,
    /// The lanes in which the penetration of some closed contact that may have a root of its own is read off the positions.
    reading_depths: u32,
    /// The lanes in which the root of a penetration is an unknown: their steps do not pass at an even pace.
    over_root: u32,
    /// Whether the dense output belongs to the current step.
    is_dense: bool,
}

impl<'a> Core<'a> {
    /// Room for `mechanism` with the laws of `sample`, and for what is followed.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        follow: &Follow,
        settings: &Settings,
        (execution, lanes): (Execution, usize),
    ) -> Self {
        let pass = Pass::new(mechanism, sample, follow, settings);
        let of_sample = if execution == Execution::Scalar { 0 } else { numbers(sample, arms).len() };
        let lengths = pass.block_lengths(of_sample);
        let backend = match execution {
            Execution::Scalar => {
                Backend::SingleLane(Box::new(SingleLane::new(mechanism, sample, arms, follow, settings)))
            }
            Execution::Interpreted | Execution::MachineCode(_) => {
                let recorded =
                    Recorded::new(mechanism, sample, arms, follow, &pass, lengths, (execution.level(), lanes));
                Backend::Recorded(Box::new(recorded))
            }
        };
        Self {
            mechanism,
            memory: Memory::new(lanes, lengths),
            waiting: Memory::new(lanes, lengths),
            backend,
            reading_depths: 0,
            over_root: 0,
            is_dense: false,
            pass,
        }
    }

    /// Puts a run that begins at `state` (layout of [`crate::stepping::motion::Layout`]) into a lane. It needs a restart.
    pub fn load(
        &mut self,
        lane: usize,
        sample: &Sample<f64>,
        arms: &Arms,
        state: &[f64],
        rate_1_s: f64,
        energy_j: f64,
    ) {
        self.load_numbers(lane, sample, arms);
        let tolerances = tolerances(self.mechanism, &self.pass.layout, sample, self.pass.local_m, rate_1_s, energy_j);
        for (place, tolerance) in self.pass.lane.weights().zip(tolerances) {
            self.memory.set(Block::Lane, place, lane, 1.0 / tolerance);
        }
        for (index, value) in state.iter().enumerate() {
            self.memory.set(Block::Start, index, lane, *value);
        }
        for contact in 0..self.pass.layout.roots.len() {
            self.set_contact(lane, contact, &PlayState::flight(), false);
            self.set_records(lane, contact, &PlaySummary::default());
            let limit = DepthLimit::new(sample.play_of(contact));
            let place = LaneLayout::contact(contact);
            self.set_number(lane, place + LaneLayout::MAX_GAP, limit.gap);
            self.set_number(lane, place + LaneLayout::MAX_ROOT, limit.root);
        }
    }

    /// Replaces the numbers of the run in a lane.
    pub fn load_numbers(&mut self, lane: usize, sample: &Sample<f64>, arms: &Arms) {
        match &mut self.backend {
            Backend::SingleLane(plain) => plain.load(sample, arms),
            Backend::Recorded(recorded) => recorded.load(&self.pass, &mut self.memory, lane, sample, arms),
        }
    }

    /// Puts the contacts of a resumed run into a loaded lane. Penetrations are read off the positions until the next contact begins;
    /// deflections of bristles go on as they are. The lane needs a restart.
    pub fn resume(&mut self, lane: usize, resume: &MotionState) {
        for (contact, state) in resume.contacts.iter().enumerate() {
            self.set_contact(lane, contact, state, false);
            if let Some(place) = self.pass.layout.bristles[contact] {
                self.set_state(lane, place, resume.state[place]);
            }
        }
    }

    /// Keeps the records of a contact, against which steps are judged.
    pub fn set_records(&mut self, lane: usize, contact: usize, summary: &PlaySummary) {
        let place = LaneLayout::contact(contact);
        self.memory.set(Block::Lane, place + LaneLayout::DEEPEST, lane, summary.largest_penetration_m);
        self.memory.set(Block::Lane, place + LaneLayout::STRONGEST, lane, summary.peak_force_n);
    }

    /// Sets the state of a contact in a lane. The lane needs a restart. A penetration whose root becomes an
    /// unknown begins at zero, and so does the deflection of bristles.
    pub fn set_contact(&mut self, lane: usize, contact: usize, state: &PlayState<f64>, has_root: bool) {
        let has_root_number = f64::from(u8::from(has_root));
        let values = [state.contact, state.inverse_impact_speed_s_m, state.effective_mass_kg, has_root_number];
        for (k, value) in values.into_iter().enumerate() {
            self.memory.set(Block::Lane, LaneLayout::contact(contact) + k, lane, value);
        }
        if let Backend::SingleLane(plain) = &mut self.backend {
            plain.set_contact(contact, state, has_root);
        }
        for place in [self.pass.layout.roots[contact], self.pass.layout.bristles[contact]].into_iter().flatten() {
            self.set_state(lane, place, 0.0);
        }
        let (mut reads_depth, mut is_over_root) = (false, false);
        for contact in 0..self.pass.layout.roots.len() {
            let (state, has_root) = self.contact(lane, contact);
            reads_depth |= self.pass.layout.roots[contact].is_some() && state.contact > 0.0 && !has_root;
            is_over_root |= has_root;
        }
        self.reading_depths = self.reading_depths & !(1 << lane) | u32::from(reads_depth) << lane;
        self.over_root = self.over_root & !(1 << lane) | u32::from(is_over_root) << lane;
    }

    /// The lanes whose steps do not pass at an even pace: the root of a penetration is an unknown.
    pub fn over_root(&self) -> u32 {
        self.over_root
    }

    /// Leaves a lane empty.
    pub fn leave(&mut self, lane: usize) {
        self.set_step(lane, 0.0);
        self.reading_depths &= !(1 << lane);
    }

    /// Takes the one run of `other`, of this sample, into the first lane, with all its numbers.
    pub fn take_over(&mut self, other: &Self, sample: &Sample<f64>, arms: &Arms) {
        self.load_numbers(0, sample, arms);
        self.memory.take_first_lane(&other.memory, Block::Numbers);
        (self.reading_depths, self.over_root) = (other.reading_depths, other.over_root);
        self.is_dense = false;
    }

    /// Whether attempts are machine code.
    pub fn is_machine_code(&self) -> bool {
        matches!(&self.backend, Backend::Recorded(recorded) if recorded.is_machine_code())
    }

    /// Puts the run of a lane into an empty one before it.
    pub fn move_lane(&mut self, lane: usize, to: usize) {
        self.is_dense = false;
        self.memory.move_lane(lane, to);
        for flags in [&mut self.reading_depths, &mut self.over_root] {
            move_flag(flags, lane, to);
        }
        self.set_step(lane, 0.0);
    }

    /// Computes from now on in the first `used` lanes; the others have no run.
    pub fn use_lanes(&mut self, used: usize) {
        if let Backend::Recorded(recorded) = &mut self.backend {
            recorded.use_lanes(used);
        }
    }

    /// The state of a contact in a lane, and whether the root of its penetration is an unknown.
    #[inline]
    pub fn contact(&self, lane: usize, contact: usize) -> (PlayState<f64>, bool) {
        let number = |k: usize| self.memory.get(Block::Lane, LaneLayout::contact(contact) + k, lane);
        let state = PlayState { contact: number(0), inverse_impact_speed_s_m: number(1), effective_mass_kg: number(2) };
        (state, self.pass.layout.roots[contact].is_some() && number(LaneLayout::HAS_ROOT) > 0.5)
    }

    /// Number `index` of the state of a lane at the start of the step.
    #[inline]
    pub fn state(&self, lane: usize, index: usize) -> f64 {
        self.memory.get(Block::Start, index, lane)
    }
    /// Replaces number `index` of the state of a lane at the start of the step. The lane needs a restart.
    pub fn set_state(&mut self, lane: usize, index: usize, value: f64) {
        self.memory.set(Block::Start, index, lane, value);
    }
    /// A number of a lane as read at the start of the step.
    #[inline]
    pub fn start_read(&self, lane: usize, place: usize) -> f64 {
        self.memory.get(Block::StartReads, place, lane)
    }
    /// A number of a lane as read at the end of the step.
    #[inline]
    pub fn end_read(&self, lane: usize, place: usize) -> f64 {
        self.memory.get(Block::EndReads, place, lane)
    }
    /// A number of a lane: [`LaneLayout`].
    #[inline]
    pub fn number(&self, lane: usize, place: usize) -> f64 {
        self.memory.get(Block::Lane, place, lane)
    }
    /// Replaces a number of a lane.
    #[inline]
    pub fn set_number(&mut self, lane: usize, place: usize, value: f64) {
        self.memory.set(Block::Lane, place, lane, value);
    }
    /// Whether a number of a lane that is 0 or 1 is 1.
    #[inline]
    pub fn is_set(&self, lane: usize, place: usize) -> bool {
        self.number(lane, place) > 0.5
    }
    /// The lanes in which such a number is 1, a bit for each; it must be 0 or 1 in all.
    pub fn flags(&self, place: usize) -> u32 {
        // Sums of powers of two: eight lanes at a time, without a branch.
        let numbers = self.memory.of_all_lanes(Block::Lane, place);
        let ([first, others @ ..], powers) = (numbers.as_chunks::<8>().0, POWERS_OF_TWO.as_chunks::<8>().0) else {
            // One lane alone: others come in whole vectors.
            debug_assert_eq!(numbers.len(), 1);
            return numbers[0] as u32;
        };
        let mut sums: [f64; 8] = std::array::from_fn(|k| first[k] * powers[0][k]);
        for (numbers, powers) in others.iter().zip(&powers[1..]) {
            for k in 0..8 {
                sums[k] += numbers[k] * powers[k];
            }
        }
        let [a, b, c, d, e, f, g, h] = sums;
        (((a + b) + (c + d)) + ((e + f) + (g + h))) as u32
    }
    /// The step to be tried in a lane.
    #[inline]
    pub fn step(&self, lane: usize) -> f64 {
        self.number(lane, LaneLayout::STEP)
    }
    /// Sets the step to be tried in a lane.
    #[inline]
    pub fn set_step(&mut self, lane: usize, step: f64) {
        self.set_turn(lane, NextStepRule::Set);
        self.set_number(lane, LaneLayout::STEP, step);
    }
    /// Says how the next step of a lane follows from its last attempt.
    #[inline]
    pub fn set_turn(&mut self, lane: usize, turn: NextStepRule) {
        self.set_number(lane, LaneLayout::TURN, turn.number());
    }
    /// Evaluations of the equations of motion in the run of a lane so far.
    pub fn evaluations(&self, lane: usize) -> u64 {
        self.number(lane, LaneLayout::EVALUATIONS) as u64
    }
    /// Counts further evaluations of the run of a lane.
    pub fn add_evaluations(&mut self, lane: usize, evaluations: u64) {
        self.set_number(lane, LaneLayout::EVALUATIONS, self.number(lane, LaneLayout::EVALUATIONS) + evaluations as f64);
    }

    /// Three numbers in a row of a lane at the start and at the end of the step: a value and its derivatives.
    #[inline]
    pub fn jets(&self, lane: usize, place: usize) -> [GapJet; 2] {
        // A program leaves out what is multiplied by zero, which may turn the sign of a zero: adding zero makes it positive.
        let jet = |block| {
            let [value, first, second] = self.memory.some(block, place, lane);
            GapJet { jet: [value + 0.0, first + 0.0, second + 0.0] }
        };
        [jet(Block::StartReads), jet(Block::EndReads)]
    }

    /// Largest change of a slope between the ends of the current step of a lane, in allowed errors of its unknown.
    pub fn change_of_slopes(&self, lane: usize) -> f64 {
        let end = self.pass.stepper.end_row() * self.pass.layout.length();
        let change = |(unknown, weight): (usize, usize)| {
            let slope = |row: usize| self.memory.get(Block::Stages, row + unknown, lane);
            (slope(end) - slope(0)).abs() * self.number(lane, weight)
        };
        self.pass.lane.weights().enumerate().map(change).fold(0.0, f64::max)
    }

    /// Moves the end of the current step of a lane by a small part of it: unknowns, integrals and energy by their slopes, and readings with
    /// two derivatives by these. The rest of what is read there stays until the lane is evaluated anew, as it must be before its next step.
    pub fn move_end(&mut self, lane: usize, by: f64) {
        self.is_dense = false;
        let (layout, memory) = (&self.pass.layout, &mut self.memory);
        let end = self.pass.stepper.end_row() * layout.length();
        let slope = |memory: &Memory, index: usize| memory.get(Block::Stages, end + index, lane);
        for index in 0..layout.length() {
            let moved = memory.get(Block::End, index, lane) + by * slope(memory, index);
            memory.set(Block::End, index, lane, moved);
        }
        let power = layout.account_by(|place| slope(memory, place));
        let losses = power.contact_loss_j + power.friction_loss_j + power.damping_loss_j;
        let energy_j = memory.get(Block::EndReads, ReadLayout::ENERGY, lane) + by * (power.supplied_j - losses);
        memory.set(Block::EndReads, ReadLayout::ENERGY, lane, energy_j);
        let jets = [ReadLayout::TIME].into_iter();
        let jets = jets.chain((0..layout.roots.len()).map(|contact| self.pass.reads.gap(contact)));
        let jets = jets.chain((0..layout.roots.len()).filter_map(|contact| self.pass.reads.along_slot(contact)));
        let jets = jets.chain((0..self.pass.follow.readings()).map(|output| self.pass.reads.output(output)));
        for place in jets {
            let [value, first, second] = memory.some(Block::EndReads, place, lane);
            memory.set(Block::EndReads, place, lane, value + by * (first + 0.5 * by * second));
            memory.set(Block::EndReads, place + 1, lane, first + by * second);
        }
        let step = memory.get(Block::Lane, LaneLayout::STEP, lane);
        memory.set(Block::Lane, LaneLayout::STEP, lane, step + by);
    }

    /// Evaluates the derivative at the start again in the flagged lanes, which are chosen from now on, and reads there.
    pub fn restart(&mut self, lanes: u32) {
        self.is_dense = false;
        self.memory.of_all_lanes_mut(Block::Lane, LaneLayout::CHOSEN).fill(0.0);
        for lane in lanes_of(lanes) {
            self.set_number(lane, LaneLayout::CHOSEN, 1.0);
            self.add_evaluations(lane, 1);
        }
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(plain) => {
                plain.evaluate_start(pass, memory);
                pass.take_evaluation(&mut MemoryBlocks::new(memory.blocks()));
            }
            Backend::Recorded(recorded) => {
                let first = lanes.trailing_zeros().min(u32::BITS - 1) as usize;
                recorded.restart(memory, first..(u32::BITS - lanes.leading_zeros()) as usize);
            }
        }
    }

    /// Chooses the next steps of all lanes, tries them, and says what happens with them.
    pub fn attempt(&mut self) {
        self.is_dense = false;
        let Self { pass, memory, backend, reading_depths, .. } = self;
        match backend {
            Backend::SingleLane(plain) => plain.attempt(pass, memory),
            Backend::Recorded(recorded) => recorded.attempt(memory, *reading_depths != 0),
        }
    }

    /// Makes the end of the step the start of the next one in the chosen lanes, and holds their loops. Where there are none to hold, takes it into
    /// the energy accounts; else that is left to [`Self::close_accounts`], after an evaluation there.
    pub fn accept(&mut self) {
        self.is_dense = false;
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(plain) => {
                pass.accept(&mut MemoryBlocks::new(memory.blocks()));
                if plain.holds_loops() {
                    plain.hold_loops(pass, memory);
                } else {
                    pass.close_account(&mut MemoryBlocks::new(memory.blocks()));
                }
            }
            Backend::Recorded(recorded) => recorded.accept(memory),
        }
    }

    /// Follows the current step in the chosen lanes that are recorded.
    pub fn follow(&mut self) {
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(_) => pass.follow(&mut MemoryBlocks::new(memory.blocks())),
            Backend::Recorded(recorded) => recorded.follow(memory),
        }
    }

    /// Makes the readings over the current step polynomials, in all lanes.
    pub fn spread(&mut self) {
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(_) => pass.spread(&mut MemoryBlocks::new(memory.blocks())),
            Backend::Recorded(recorded) => recorded.spread(memory),
        }
    }

    /// A reading over the current step of a lane, as a polynomial of its share.
    pub fn reading(&self, lane: usize, reading: usize) -> Quintic {
        let first = self.pass.lane.followed().start + self.pass.follow.reading(reading);
        Quintic { coefficients: self.memory.some(Block::Lane, first, lane) }
    }

    /// Puts down, from place `first` of the instants that wait on, some within the current steps of their lanes, whose readings are polynomials.
    pub fn add_pending_instants(&mut self, first: usize, awaited: &[PendingInstant]) {
        let Self { pass, memory, waiting, .. } = self;
        let followed = pass.lane.followed().start;
        let instants = waiting.of_all_lanes_mut(Block::Lane, followed + FollowLayout::INSTANT);
        for (number, one) in instants[first..].iter_mut().zip(awaited) {
            *number = one.instant_s;
        }
        for (place, one) in awaited.iter().enumerate() {
            let (lane, place) = (one.lane, first + place);
            memory.copy::<3>((Block::StartReads, ReadLayout::TIME), lane, waiting, place);
            memory.copy::<3>((Block::EndReads, ReadLayout::TIME), lane, waiting, place);
            memory.copy::<1>((Block::Lane, LaneLayout::STEP), lane, waiting, place);
            for reading in 0..pass.follow.readings() {
                let polynomial = (Block::Lane, followed + pass.follow.reading(reading));
                memory.copy::<{ FollowLayout::PER_READING }>(polynomial, lane, waiting, place);
            }
        }
    }

    /// Reads at the pending instants in the first `places` places.
    pub fn look(&mut self, places: usize) {
        let Self { pass, waiting, backend, .. } = self;
        match backend {
            Backend::SingleLane(_) => pass.look(&mut MemoryBlocks::new(waiting.blocks())),
            Backend::Recorded(recorded) => recorded.look(waiting, places),
        }
    }

    /// Reads, in all lanes, at the instants in [`FollowLayout::INSTANT`] within the current steps, whose readings are polynomials; the readings are
    /// in [`FollowLayout::VALUES`].
    pub fn look_in_place(&mut self) {
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(_) => pass.look(&mut MemoryBlocks::new(memory.blocks())),
            Backend::Recorded(recorded) => recorded.look_in_place(memory),
        }
    }

    /// A reading at all places of the instants that waited.
    pub fn looked(&self, reading: usize) -> &[f64] {
        let values = self.pass.lane.followed().start + FollowLayout::VALUES;
        self.waiting.of_all_lanes(Block::Lane, values + reading)
    }

    /// Place of a number of what is followed among the numbers of a lane.
    pub fn place_of_followed(&self, place: usize) -> usize {
        self.pass.lane.followed().start + place
    }

    /// A number of what is followed in a lane: [`crate::follow::FollowLayout`].
    #[inline]
    pub fn followed(&self, lane: usize, place: usize) -> f64 {
        self.memory.get(Block::Lane, self.pass.lane.followed().start + place, lane)
    }

    /// The lanes in which a number of what is followed, which is 0 or 1, is 1.
    pub fn followed_flags(&self, place: usize) -> u32 {
        self.flags(self.pass.lane.followed().start + place)
    }

    /// Replaces a number of what is followed in a lane.
    #[inline]
    pub fn set_followed(&mut self, lane: usize, place: usize, value: f64) {
        self.memory.set(Block::Lane, self.pass.lane.followed().start + place, lane, value);
    }

    /// Begins the energy account of a loaded and evaluated lane, with the smallest exchange that is above round-off.
    pub fn open_account(&mut self, lane: usize, smallest_exchange_j: f64) {
        let energy_j = self.start_read(lane, ReadLayout::ENERGY);
        let exchange_j = smallest_exchange_j.max(self.start_read(lane, ReadLayout::FREE_KINETIC));
        for (place, value) in [
            (LaneLayout::ENERGY_AT_START, energy_j),
            (LaneLayout::MAX_RESIDUAL, 0.0),
            (LaneLayout::MAX_EXCHANGE, exchange_j),
        ] {
            self.memory.set(Block::Lane, place, lane, value);
        }
    }

    /// Takes the end of a step into the energy accounts of the chosen lanes, where loops are held.
    pub fn close_accounts(&mut self) {
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(_) => pass.close_account(&mut MemoryBlocks::new(memory.blocks())),
            Backend::Recorded(recorded) => recorded.close_account(memory),
        }
    }

    /// The energy account of a lane after its last step.
    pub fn account(&self, lane: usize) -> EnergyAccount {
        let state: Vec<f64> = (0..self.pass.layout.length()).map(|index| self.state(lane, index)).collect();
        let account = self.pass.layout.account(&state);
        let number = |place| self.memory.get(Block::Lane, place, lane);
        EnergyAccount {
            at_start_j: number(LaneLayout::ENERGY_AT_START),
            at_end_j: self.start_read(lane, ReadLayout::ENERGY),
            supplied_j: account.supplied_j,
            contact_loss_j: account.contact_loss_j,
            friction_loss_j: account.friction_loss_j,
            damping_loss_j: account.damping_loss_j,
            largest_residual_j: number(LaneLayout::MAX_RESIDUAL),
            largest_exchange_j: number(LaneLayout::MAX_EXCHANGE),
        }
    }

    /// Heat of each monitored friction in a lane up to its last step, J.
    pub fn friction_losses(&self, lane: usize, sample: &Sample<f64>) -> Vec<FrictionLoss> {
        let loss = |(place, watched): (usize, Watched)| FrictionLoss {
            joint: watched.joint(self.mechanism, sample),
            loss_j: self.state(lane, place),
        };
        self.pass.layout.watched_losses().map(loss).collect()
    }

    /// Friction paths in a lane since the start of its run, J.
    pub fn friction_paths(&self, lane: usize) -> Vec<FrictionPath> {
        let places = self.pass.layout.friction_path_places();
        places.map(|(place, play)| FrictionPath { play, path_j: self.state(lane, place) }).collect()
    }

    /// Computes what looks inside of the current step need.
    pub fn prepare_dense(&mut self) {
        if self.is_dense {
            return;
        }
        self.is_dense = true;
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(plain) => plain.prepare_dense(pass, memory),
            Backend::Recorded(recorded) => recorded.prepare_dense(memory),
        }
    }

    /// Records the values inside the current accepted steps as far as they are recorded; returns the evaluations of this in each lane
    /// besides [`Self::evaluations_for_dense`].
    pub fn look_inside(&mut self) -> u64 {
        self.prepare_dense();
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(plain) => plain.look_inside(pass, memory),
            Backend::Recorded(recorded) => {
                recorded.look_inside(memory);
                0
            }
        }
    }

    /// Value of a reading that is looked at inside the current step of a lane, at a point.
    pub fn inside(&self, lane: usize, point: usize, reading: usize) -> f64 {
        let place = self.pass.first_inside() + self.pass.follow.inside().value(point, reading);
        self.memory.get(Block::Stages, place, lane)
    }

    /// Evaluations of the equations that the first look inside the current step costs: [`Self::prepare_dense`].
    pub fn evaluations_for_dense(&self) -> u64 {
        match &self.backend {
            Backend::SingleLane(plain) if plain.is_implicit() => 0,
            _ => self.pass.stepper.evaluations_for_dense(),
        }
    }

    /// The state of one lane at `share` in [0, 1] of the step. Inside of the step it needs [`Self::prepare_dense`].
    pub fn interpolate(&self, lane: usize, share: f64, state: &mut [f64]) {
        for (index, value) in state.iter_mut().enumerate() {
            let start = self.state(lane, index);
            let found = if share <= 0.0 {
                start
            } else if share >= 1.0 {
                self.memory.get(Block::End, index, lane)
            } else {
                let number = |place: usize| self.memory.get(Block::Stages, place, lane);
                start + self.pass.stepper.dense_change(index, share, number)
            };
            // No negative zeros: see `Self::jets`.
            *value = found + 0.0;
        }
    }

    /// Corrects the state at `share` of an implicit step, that of [`Self::interpolate`], where its forces and accelerations are looked at; gives the evaluations that
    /// it took.
    pub fn correct(&mut self, share: f64, state: &mut [f64]) -> u64 {
        let Self { pass, memory, backend, .. } = self;
        match backend {
            Backend::SingleLane(plain) if plain.is_implicit() && share > 0.0 && share < 1.0 => {
                plain.correct(pass, memory, share, state)
            }
            _ => 0,
        }
    }
}

/// The lanes that are flagged.
pub fn lanes_of(mut flags: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = flags.trailing_zeros();
        flags &= flags.wrapping_sub(1);
        (lane < u32::BITS).then_some(lane as usize)
    })
}

/// Moves the flag of a lane to another one, whose own is lost.
pub fn move_flag(flags: &mut u32, lane: usize, to: usize) {
    *flags = *flags & !(1 << to | 1 << lane) | (*flags >> lane & 1) << to;
}
