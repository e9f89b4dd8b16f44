//! Machine code in memory, and calling it.
//!
//! Everything unsafe of this crate is in this file: a processor can only be told to run bytes, never shown that they are a
//! function. The bytes come from [`super::assemble`] alone; memory is written first and made executable afterwards, so
//! it is never both.
#![allow(unsafe_code, reason = "calling machine code written at run time cannot be checked by the compiler")]

use memmap2::{Mmap, MmapMut};
use std::ops::Range;
use std::sync::Arc;

use super::assemble::Code;
use super::block_start::BlockStart;
use super::error::NativeError;
use super::evaluate::check_blocks;
use super::program::Program;
use super::recent::translate_once;
use super::translate::KernelSize;
use super::{Level, MAX_BLOCKS};

/// Machine code as [`super::assemble`] writes it: of the table of the addresses of the blocks, and how often the instructions are to run.
#[cfg(target_arch = "x86_64")]
type Entry = unsafe extern "sysv64" fn(*const *mut f64, u32);
/// Elsewhere no kernel can be made.
#[cfg(not(target_arch = "x86_64"))]
type Entry = unsafe extern "C" fn(*const *mut f64, u32);

/// A program as machine code for a fixed number of lanes.
///
/// Kernels may be shared between threads; the memory is given back when the kernel is dropped.
#[derive(Debug, Clone)]
pub struct Kernel {
    #[expect(dead_code, reason = "it is kept for as long as its code may be called")]
    memory: Arc<Mmap>,
    /// Entry point of its code.
    entry: Entry,
    lanes: usize,
    values_per_block: Vec<usize>,
    size: KernelSize,
}

impl Kernel {
    /// Compiles `program` for blocks of `lanes` lanes.
    ///
    /// # Errors
    ///
    /// [`NativeError::NotSupported`] where the processor lacks the instructions of `level`,
    /// [`NativeError::ExecutableMemoryRefused`] where the operating system allows no code of our own: then
    /// [`super::Sequence`] interprets the program and gives the same numbers. [`NativeError::UnevenLanes`],
    /// [`NativeError::TooManyBlocks`], [`NativeError::BlockTooLarge`] and [`NativeError::FrameTooLarge`] for what no processor can do.
    pub fn compile(program: &Program, level: Level, lanes: usize) -> Result<Self, NativeError> {
        let translated = translate_once(program, level, lanes)?;
        let (code, size) = &*translated;
        Self::new(code, *size, program.values_per_block().to_vec(), level, lanes)
    }

    /// Compiles programs that run in turn, one behind the other in memory: each on pages of its own, they would drive each other
    /// out of the processor's cache.
    ///
    /// # Errors
    ///
    /// Those of [`Self::compile`], of any program.
    pub fn compile_together(programs: &[Program], level: Level, lanes: usize) -> Result<Vec<Self>, NativeError> {
        /// Bytes of a line of the cache.
        const LINE_BYTES: usize = 64;
        let (mut bytes, mut parts) = (Vec::new(), Vec::new());
        for program in programs {
            let translated = translate_once(program, level, lanes)?;
            let (code, size) = &*translated;
            parts.push((bytes.len(), *size, program.values_per_block().to_vec()));
            bytes.extend_from_slice(code.bytes());
            bytes.resize(bytes.len().next_multiple_of(LINE_BYTES), 0);
        }
        let memory = executable(&bytes, level)?;
        let part = |(start, size, values)| Self::at(Arc::clone(&memory), start, size, values, lanes);
        Ok(parts.into_iter().map(part).collect())
    }

    /// A kernel of `code`, which was translated for `level` and `lanes` and uses no more than `values_per_block`.
    pub(super) fn new(
        code: &Code,
        size: KernelSize,
        values_per_block: Vec<usize>,
        level: Level,
        lanes: usize,
    ) -> Result<Self, NativeError> {
        Ok(Self::at(executable(code.bytes(), level)?, 0, size, values_per_block, lanes))
    }

    /// The kernel whose code begins at `start` of `memory`.
    fn at(memory: Arc<Mmap>, start: usize, size: KernelSize, values_per_block: Vec<usize>, lanes: usize) -> Self {
        let code = memory[start..].as_ptr();
        // SAFETY: there the memory holds what `assemble` wrote for exactly this signature; `executable` has checked that the processor has
        // the instructions. The memory is executable while a clone of `memory` lives: `self`, or the kernel beside each `Call`.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(code) };
        Self { memory, entry, lanes, values_per_block, size }
    }

    /// The number of lanes of each value.
    pub fn lanes(&self) -> usize {
        self.lanes
    }

    /// For each block, how many values it must have at least.
    pub fn values_per_block(&self) -> &[usize] {
        &self.values_per_block
    }

    /// Number of operations of each kind in the kernel.
    pub fn size(&self) -> KernelSize {
        self.size
    }

    /// Runs the kernel on `blocks`: value `i` of block `b` in lane `l` is `blocks[b][i * lanes + l]`.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`] and [`NativeError::BlockTooShort`].
    pub fn run(&self, blocks: &mut [&mut [f64]]) -> Result<(), NativeError> {
        check_blocks(blocks, &self.values_per_block, self.lanes)?;
        let mut addresses = [std::ptr::null_mut(); MAX_BLOCKS];
        for (address, numbers) in addresses.iter_mut().zip(blocks) {
            *address = numbers.as_mut_ptr();
        }
        // SAFETY: the code is executable while `self` lives. There is an address for each block of the program, and each points to as many
        // numbers as its highest slot needs (checked above); exclusive references do not overlap and live until the call has returned.
        unsafe { (self.entry)(addresses.as_ptr(), self.size.trips as u32) };
        Ok(())
    }
}

/// A kernel whose blocks are parts of those that it is given.
#[derive(Debug, Clone)]
pub(super) struct PlacedKernel {
    kernel: Kernel,
    /// By block of the kernel, those that it does not use at the end: which block of the caller, and where in it.
    parts: [BlockRange; MAX_BLOCKS],
}

/// Numbers of a block, from the first to behind the last.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct BlockRange {
    block: usize,
    first: usize,
    end: usize,
}

impl PlacedKernel {
    /// `kernel` with block `b` at `places[b]`.
    ///
    /// # Errors
    ///
    /// Those of [`parts`].
    pub fn new(kernel: &Kernel, places: &[BlockStart]) -> Result<Self, NativeError> {
        Ok(Self { parts: parts(&kernel.values_per_block, places, kernel.lanes)?, kernel: kernel.clone() })
    }

    /// What a call of it needs.
    fn call(&self) -> Call {
        let Kernel { entry, lanes, size, .. } = self.kernel;
        let mut moved = [Moved { own: 0, block: 0, first: 0 }; MAX_BLOCKS];
        let used = self.parts.iter().enumerate().filter(|(_, part)| part.end > 0);
        let elsewhere = used.filter(|(own, part)| part.block != *own || part.first != 0);
        let mut moves = 0;
        for (moved, (own, part)) in moved.iter_mut().zip(elsewhere) {
            *moved = Moved { own: own as u8, block: part.block as u8, first: part.first };
            moves += 1;
        }
        Call { entry, trips: size.trips, lanes_of_a_trip: lanes / size.trips, moves, moved }
    }

    /// For each block, how many numbers it must have at least.
    fn needed(&self) -> [usize; MAX_BLOCKS] {
        let mut needed = [0; MAX_BLOCKS];
        for part in &self.parts {
            needed[part.block] = needed[part.block].max(part.end);
        }
        needed
    }
}

/// What a call of a kernel needs, close together: there are many calls, of short kernels.
#[derive(Debug, Clone, Copy)]
struct Call {
    entry: Entry,
    trips: usize,
    lanes_of_a_trip: usize,
    /// So many of its blocks do not begin where that of the caller with the same number does.
    moves: usize,
    /// Places of the blocks, one after the other.
    moved: [Moved; MAX_BLOCKS],
}

/// A block of a kernel that begins elsewhere.
#[derive(Debug, Clone, Copy)]
struct Moved {
    /// Its number in the kernel.
    own: u8,
    /// Which block of the caller it is in, and where in it.
    block: u8,
    first: usize,
}

impl Call {
    /// The trips that some `lanes` need, at most all, and how many lanes lie before the first of them.
    #[inline]
    fn trips_of(&self, lanes: &Range<usize>) -> (Range<usize>, usize) {
        let Self { trips, lanes_of_a_trip, .. } = *self;
        // Mostly all: divisions take as long as a short kernel.
        if lanes.start == 0 && lanes.end >= trips * lanes_of_a_trip {
            return (0..trips, 0);
        }
        let end = lanes.end.div_ceil(lanes_of_a_trip).min(trips);
        let first = (lanes.start / lanes_of_a_trip).min(end);
        (first..end, first * lanes_of_a_trip)
    }
}

/// Kernels that run one after the other on parts of the same blocks.
#[derive(Debug, Clone)]
pub(super) struct PlacedKernels {
    /// The kernels that are called: they keep their code.
    kernels: Vec<PlacedKernel>,
    calls: Vec<Call>,
    /// For each block, how many numbers it must have at least.
    needed: [usize; MAX_BLOCKS],
}

impl PlacedKernels {
    /// One kernel.
    pub fn new(kernel: PlacedKernel) -> Self {
        Self { needed: kernel.needed(), calls: vec![kernel.call()], kernels: vec![kernel] }
    }

    /// Adds `kernel` behind the others.
    pub fn push(&mut self, kernel: PlacedKernel) {
        for (needed, own) in self.needed.iter_mut().zip(kernel.needed()) {
            *needed = (*needed).max(own);
        }
        self.calls.push(kernel.call());
        self.kernels.push(kernel);
    }

    /// Runs all on the vectors of `blocks` that hold these `lanes`.
    ///
    /// # Errors
    ///
    /// [`NativeError::BlockTooShort`]; nothing has run then.
    pub fn run(&self, lanes: &Range<usize>, blocks: &mut [&mut [f64]; MAX_BLOCKS]) -> Result<(), NativeError> {
        let mut starts = [std::ptr::null_mut::<f64>(); MAX_BLOCKS];
        for (block, (numbers, &needed)) in blocks.iter_mut().zip(&self.needed).enumerate() {
            if numbers.len() < needed {
                return Err(NativeError::BlockTooShort { block, given: numbers.len(), needed });
            }
            starts[block] = numbers.as_mut_ptr();
        }
        for call in &self.calls {
            let (trips, before) = call.trips_of(lanes);
            if trips.is_empty() {
                continue;
            }
            let mut own = starts;
            if before > 0 {
                own = own.map(|start| start.wrapping_add(before));
            }
            for &Moved { own: number, block, first } in call.moved.iter().take(call.moves) {
                // The remainders are the numbers themselves, and tell that they are in range.
                let start = starts[usize::from(block) % MAX_BLOCKS];
                own[usize::from(number) % MAX_BLOCKS] = start.wrapping_add(first + before);
            }
            // SAFETY: the code is executable while its kernel, which is among those of `self`, lives. Each address that it uses points, moved by
            // the lanes of the trips before, to as many numbers as its highest
            // slot needs (checked above: no part of any kernel ends behind what is needed), within a block that is borrowed for itself
            // until all have returned; parts of one block have no number in common (checked by `PlacedKernel::new`). There are one trip
            // or more, and no more than up to the last lane (`trips_of`).
            unsafe { (call.entry)(own.as_ptr(), trips.len() as u32) };
        }
        Ok(())
    }
}

/// The ranges of a program's blocks with `values` values that lie at `places`; blocks without a value have none.
///
/// # Errors
///
/// [`NativeError::TooFewBlocks`], [`NativeError::TooManyBlocks`], and [`NativeError::PlacesOverlap`] where two blocks have numbers in
/// common.
pub(super) fn parts(
    values: &[usize],
    places: &[BlockStart],
    lanes: usize,
) -> Result<[BlockRange; MAX_BLOCKS], NativeError> {
    if places.len() < values.len() {
        return Err(NativeError::TooFewBlocks { given: places.len(), needed: values.len() });
    }
    let mut parts = [BlockRange::default(); MAX_BLOCKS];
    for (index, (place, &values)) in places.iter().zip(values).enumerate() {
        let BlockStart { block, first } = *place;
        if block >= MAX_BLOCKS || index >= MAX_BLOCKS {
            return Err(NativeError::TooManyBlocks { given: block.max(index) + 1 });
        }
        if values == 0 {
            continue;
        }
        let end = first.saturating_add(values).saturating_mul(lanes);
        let part = BlockRange { block, first: first.saturating_mul(lanes), end };
        if parts.iter().any(|other| other.block == block && other.first < part.end && part.first < other.end) {
            return Err(NativeError::PlacesOverlap { block });
        }
        parts[index] = part;
    }
    Ok(parts)
}

/// Memory that holds `bytes` and can be run.
fn executable(bytes: &[u8], level: Level) -> Result<Arc<Mmap>, NativeError> {
    if !level.is_supported() {
        return Err(NativeError::NotSupported { level });
    }
    let refused = |source| NativeError::ExecutableMemoryRefused { bytes: bytes.len(), source };
    let mut memory = MmapMut::map_anon(bytes.len()).map_err(refused)?;
    memory.copy_from_slice(bytes);
    Ok(Arc::new(memory.make_exec().map_err(refused)?))
}
