//! The numbers of all lanes while a batch runs, in blocks: what the arithmetic of a step reads and writes.

use loosepin_math::integrate::StepRows;

/// How many blocks there are.
pub const BLOCKS: usize = 8;

/// A block of the memory; the number is that of the block in a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// Numbers of the sample and of the points of bodies, then what is computed from these alone.
    Numbers,
    /// Numbers of a lane and of its contacts: [`LaneLayout`].
    Lane,
    /// State at the start of the step.
    Start,
    /// Slopes and dense output: [`StepRows::stages`].
    Stages,
    /// Point of the next evaluation of the slope.
    Point,
    /// State at the end of the step.
    End,
    /// Numbers read at the start of the step: `ReadLayout`.
    StartReads,
    /// Numbers of the last reading, mostly at the end of the step.
    EndReads,
}

/// How the next step follows from the last attempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NextStepRule {
    /// Already set.
    Set,
    /// The last one was good: it may be longer.
    Grow,
    /// The last one was not: it is shorter.
    Shrink,
    /// [`LaneLayout::NEXT`] stays.
    Choose,
}

impl NextStepRule {
    /// The number that stands for it in [`LaneLayout::TURN`].
    pub fn number(self) -> f64 {
        f64::from(self as u8)
    }
}

/// Layout of [`Block::Lane`].
#[derive(Debug, Clone, Copy)]
pub struct LaneLayout {
    contacts: usize,
    weights: usize,
    followed: usize,
}

impl LaneLayout {
    /// The step to be tried.
    pub const STEP: usize = 0;
    /// 1 in the chosen lanes, else 0.
    pub const CHOSEN: usize = 1;
    /// Error of the last attempt over the allowed error.
    pub const ERROR: usize = 2;
    /// How much longer the next step may be by that error.
    pub const GROWTH: usize = 8;
    /// 1 where an event may lie in the last attempt.
    pub const EVENTFUL: usize = 3;
    /// 1 where a penetration or a contact force of the last attempt may be a record of its run.
    pub const NOTABLE: usize = 4;
    /// Mechanical energy at the start of the run, J.
    pub const ENERGY_AT_START: usize = 5;
    /// Largest residual of the energy account so far, J.
    pub const MAX_RESIDUAL: usize = 6;
    /// Largest exchange of the energy account so far, J.
    pub const MAX_EXCHANGE: usize = 7;
    /// Steps end here at the latest, s.
    pub const STOP: usize = 9;
    /// Longest step in time, s.
    pub const LONGEST: usize = 10;
    /// Smallest step in time apart from steps onto events, s.
    pub const SMALLEST: usize = 11;
    /// Next step by the errors of those before.
    pub const NEXT: usize = 12;
    /// 1 where the last attempt was rejected: the next step does not grow.
    pub const WAS_REJECTED: usize = 13;
    /// How the next step follows from the last attempt: one of the numbers of `Turn`.
    pub const TURN: usize = 14;
    /// Good steps that end from this time on are looked at one by one, s.
    pub const AWAITED: usize = 15;
    /// 1 where every attempt is looked at, as in a search for an event.
    pub const IS_WATCHED: usize = 16;
    /// 1 where the last attempt must be looked at; elsewhere it is accepted or rejected without.
    pub const ATTENTION: usize = 17;
    /// 1 where the current step lies in the recorded part.
    pub const IS_RECORDED: usize = 18;
    /// Evaluations of the equations of motion in the run so far.
    pub const EVALUATIONS: usize = 19;
    /// Accepted steps of the run so far.
    pub const STEPS: usize = 20;
    /// Rejected steps of the run so far.
    pub const REJECTIONS: usize = 21;
    /// 1 where a penetration of the last attempt may be beyond the allowed range.
    pub const DEEP: usize = 22;
    /// Steps that end from this time on hold an instant, or need another piece of the curves that are followed, s.
    pub const DUE: usize = 23;
    /// 1 where that is so in the last attempt.
    pub const IS_DUE: usize = 24;
    /// 1 until the first good step after a contact has begun, 2 after it has ended: one that no event cuts. Then 0.
    pub const IS_FIRST: usize = 25;
    /// Length of that first good step, after an end as long as its error would have allowed; 0 until there is one.
    pub const FIRST_STEP: usize = 26;
    /// Factorizations of implicit steps in the run so far, each of a real and of a complex matrix.
    pub const FACTORIZATIONS: usize = 27;
    /// Minima of penetrations, the contacts holding, since one began or ended.
    pub const MINIMA: usize = 28;
    const CONTACTS: usize = 29;
    /// Numbers of a contact, from [`Self::contact`] on: 1 where it is closed, 1/v0, effective mass, 1 where the root of its
    /// penetration is an unknown; then the records of its run, and how far it may go.
    const PER_CONTACT: usize = 8;
    /// Within the numbers of a contact: whether the root is an unknown.
    pub const HAS_ROOT: usize = 3;
    /// Within the numbers of a contact: its largest penetration so far, m.
    pub const DEEPEST: usize = 4;
    /// Within the numbers of a contact: its largest normal force so far, N.
    pub const STRONGEST: usize = 5;
    /// Within the numbers of a contact: the gap function at the largest penetration that is allowed.
    pub const MAX_GAP: usize = 6;
    /// Within the numbers of a contact: the root of that penetration, √m.
    pub const MAX_ROOT: usize = 7;

    /// Layout for `contacts` contacts, `weights` unknowns with a tolerance and `followed` numbers of followed quantities.
    pub fn new(contacts: usize, weights: usize, followed: usize) -> Self {
        Self { contacts, weights, followed }
    }

    /// Offset of the numbers of a contact.
    pub fn contact(contact: usize) -> usize {
        Self::CONTACTS + Self::PER_CONTACT * contact
    }

    /// Range of the weights of the errors of the unknowns, one over their tolerances.
    pub fn weights(&self) -> std::ops::Range<usize> {
        let first = Self::contact(self.contacts);
        first..first + self.weights
    }

    /// Range of the numbers of the followed quantities: `FollowLayout`.
    pub fn followed(&self) -> std::ops::Range<usize> {
        let first = self.weights().end;
        first..first + self.followed
    }

    /// Length of the block.
    pub fn length(&self) -> usize {
        self.followed().end
    }
}

/// The blocks of one lane as numbers of any kind, or those of all lanes.
pub type Blocks<'m, T> = [&'m mut [T]; BLOCKS];

/// The blocks by what they hold.
pub struct MemoryBlocks<'m, T> {
    /// [`Block::Lane`].
    pub lane: &'m mut [T],
    /// The numbers of a step.
    pub rows: StepRows<'m, T>,
    /// [`Block::StartReads`].
    pub start_reads: &'m mut [T],
    /// [`Block::EndReads`].
    pub end_reads: &'m mut [T],
}

impl<'m, T> MemoryBlocks<'m, T> {
    /// Names `blocks`.
    pub fn new(blocks: Blocks<'m, T>) -> Self {
        let [_, lane, start, stages, point, end, start_reads, end_reads] = blocks;
        Self { lane, rows: StepRows { start, end, point, stages }, start_reads, end_reads }
    }
}

/// Numbers of a cache line.
const LINE: usize = 8;

/// Numbers that begin on a cache line.
struct Aligned {
    numbers: Vec<f64>,
    first: usize,
    length: usize,
}

impl Aligned {
    fn zeros(length: usize) -> Self {
        let numbers = vec![0.0; length + LINE];
        let first = numbers.as_ptr().align_offset(LINE * size_of::<f64>()).min(LINE);
        Self { numbers, first, length }
    }

    #[inline(always)]
    fn all(&mut self) -> &mut [f64] {
        &mut self.numbers[self.first..self.first + self.length]
    }
}

/// The blocks of all lanes: number i of lane l is at `i * lanes + l` of its block.
pub struct Memory {
    lanes: usize,
    blocks: [Aligned; BLOCKS],
}

impl Memory {
    /// Zeros for this number of numbers in each block.
    pub fn new(lanes: usize, lengths: [usize; BLOCKS]) -> Self {
        Self { lanes, blocks: lengths.map(|length| Aligned::zeros(length * lanes)) }
    }

    /// Extends a block to this number of numbers for each lane, with zeros behind.
    pub fn lengthen(&mut self, block: Block, length: usize) {
        let old = &mut self.blocks[block as usize];
        if old.length < length * self.lanes {
            let mut longer = Aligned::zeros(length * self.lanes);
            longer.all()[..old.length].copy_from_slice(old.all());
            *old = longer;
        }
    }

    /// Number `index` of a block in a lane.
    #[inline]
    pub fn get(&self, block: Block, index: usize, lane: usize) -> f64 {
        let block = &self.blocks[block as usize];
        block.numbers[block.first + index * self.lanes + lane]
    }

    /// Some numbers in a row of a block in a lane, from number `index` on.
    #[inline]
    pub fn some<const N: usize>(&self, block: Block, index: usize, lane: usize) -> [f64; N] {
        let (block, lanes) = (&self.blocks[block as usize], self.lanes);
        let first = block.first + index * lanes + lane;
        std::array::from_fn(|k| block.numbers[first + k * lanes])
    }

    /// Replaces number `index` of a block in a lane.
    #[inline]
    pub fn set(&mut self, block: Block, index: usize, lane: usize, value: f64) {
        let block = &mut self.blocks[block as usize];
        block.numbers[block.first + index * self.lanes + lane] = value;
    }

    /// Copies `N` numbers of a block in a lane, from number `index` on, to `place` of another memory with as many lanes.
    #[inline(always)]
    pub fn copy<const N: usize>(&self, (block, index): (Block, usize), lane: usize, other: &mut Self, place: usize) {
        let (own, other, lanes) = (&self.blocks[block as usize], &mut other.blocks[block as usize], self.lanes);
        let [from, to] = [(own.first, lane), (other.first, place)].map(|(first, lane)| first + index * lanes + lane);
        let length = N.saturating_sub(1) * lanes + 1;
        let (own, other) = (&own.numbers[from..from + length], &mut other.numbers[to..to + length]);
        for k in 0..N {
            other[k * lanes] = own[k * lanes];
        }
    }

    /// Takes all numbers of the first lane from another memory, apart from those of a block.
    pub fn take_first_lane(&mut self, other: &Self, apart_from: Block) {
        let (lanes, lanes_of_other) = (self.lanes, other.lanes);
        for (index, (own, other)) in self.blocks.iter_mut().zip(&other.blocks).enumerate() {
            if index == apart_from as usize {
                continue;
            }
            let numbers = other.numbers[other.first..other.first + other.length].iter().step_by(lanes_of_other);
            for (own, number) in own.all().iter_mut().step_by(lanes).zip(numbers) {
                *own = *number;
            }
        }
    }

    /// Copies all numbers of a lane to another one.
    pub fn move_lane(&mut self, lane: usize, to: usize) {
        for block in &mut self.blocks {
            for numbers in block.all().chunks_exact_mut(self.lanes) {
                numbers[to] = numbers[lane];
            }
        }
    }

    /// One number of a block in all lanes.
    #[inline]
    pub fn of_all_lanes(&self, block: Block, index: usize) -> &[f64] {
        let block = &self.blocks[block as usize];
        let first = block.first + index * self.lanes;
        &block.numbers[first..first + self.lanes]
    }

    /// Replaces one number of a block in all lanes.
    #[inline]
    pub fn of_all_lanes_mut(&mut self, block: Block, index: usize) -> &mut [f64] {
        let block = &mut self.blocks[block as usize];
        let first = block.first + index * self.lanes;
        &mut block.numbers[first..first + self.lanes]
    }

    /// All blocks.
    #[inline(always)]
    pub fn blocks(&mut self) -> Blocks<'_, f64> {
        // Written out: it is done before every program, and a map over an array is not inlined.
        let [a, b, c, d, e, f, g, h] = &mut self.blocks;
        [a.all(), b.all(), c.all(), d.all(), e.all(), f.all(), g.all(), h.all()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_blocks_begin_on_cache_lines_and_do_not_overlap() {
        let lengths = [3, 1, 0, 7, 2, 5, 4, 9];
        for lanes in [1, 16] {
            let mut memory = Memory::new(lanes, lengths);
            for (number, block) in memory.blocks().into_iter().enumerate() {
                assert_eq!(block.len(), lengths[number] * lanes);
                assert_eq!(block.as_ptr().align_offset(64), 0, "block {number}");
                block.fill(number as f64);
            }
            memory.set(Block::Stages, 6, lanes - 1, 0.3);
            for (number, block) in memory.blocks().into_iter().enumerate() {
                let others = block.iter().filter(|value| **value != number as f64).count();
                assert_eq!(others, usize::from(number == Block::Stages as usize), "block {number}");
            }
            assert_eq!(memory.get(Block::Stages, 6, lanes - 1), 0.3);
            assert_eq!(memory.of_all_lanes(Block::Stages, 6)[lanes - 1], 0.3);
        }
    }
}
