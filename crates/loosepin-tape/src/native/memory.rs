//! Machine code in memory, and calling it.
//!
//! Everything unsafe of this crate is in this file: a processor can only be told to run bytes, never shown that they are a
//! function. The bytes come from [`super::assemble`] alone; memory is written first and made executable afterwards, so
//! it is never both.
#![allow(unsafe_code, reason = "calling machine code written at run time cannot be checked by the compiler")]

use memmap2::{Mmap, MmapMut};
use std::sync::Arc;

use super::assemble::Code;
use super::error::NativeError;
use super::evaluate::check_length;
use super::program::Program;
use super::translate::{KernelSize, translate};
use super::{LARGEST_BLOCKS, Level};

/// A program as machine code for a fixed number of lanes.
///
/// Kernels may be shared between threads; the memory is given back when the kernel is dropped.
#[derive(Debug)]
pub struct Kernel {
    memory: Arc<Mmap>,
    /// Where its code begins.
    start: usize,
    lanes: usize,
    values_per_block: Vec<usize>,
    /// Numbers that each block must have.
    needed: [usize; LARGEST_BLOCKS],
    size: KernelSize,
}

impl Kernel {
    /// Compiles `program` for blocks of `lanes` lanes.
    ///
    /// # Errors
    ///
    /// [`NativeError::NotSupported`] where the processor lacks the instructions of `level`,
    /// [`NativeError::ExecutableMemoryRefused`] where the operating system allows no code of our own: then
    /// [`Program::evaluate`] gives the same numbers. [`NativeError::UnevenLanes`], [`NativeError::TooManyBlocks`],
    /// [`NativeError::BlockTooLarge`] and [`NativeError::FrameTooLarge`] for what no processor can do.
    pub fn compile(program: &Program, level: Level, lanes: usize) -> Result<Self, NativeError> {
        let (code, size) = translate(program, level, lanes)?;
        Self::new(&code, size, program.values_per_block().to_vec(), level, lanes)
    }

    /// Compiles programs that run in turn, one behind the other in memory: each on pages of its own, they would drive each other
    /// out of the processor's cache.
    ///
    /// # Errors
    ///
    /// Those of [`Self::compile`], of any program.
    pub fn compile_together(programs: &[&Program], level: Level, lanes: usize) -> Result<Vec<Self>, NativeError> {
        /// Bytes of a line of the cache.
        const LINE_BYTES: usize = 64;
        let (mut bytes, mut parts) = (Vec::new(), Vec::new());
        for program in programs {
            let (code, size) = translate(program, level, lanes)?;
            parts.push((bytes.len(), size, program.values_per_block().to_vec()));
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
        let mut needed = [0; LARGEST_BLOCKS];
        for (needed, values) in needed.iter_mut().zip(&values_per_block) {
            *needed = values * lanes;
        }
        Self { memory, start, lanes, values_per_block, needed, size }
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
    #[inline]
    pub fn run(&self, blocks: &mut [&mut [f64]]) -> Result<(), NativeError> {
        if blocks.len() < self.values_per_block.len() {
            return Err(NativeError::TooFewBlocks { given: blocks.len(), needed: self.values_per_block.len() });
        }
        let count = self.values_per_block.len();
        let mut addresses = [std::ptr::null_mut(); LARGEST_BLOCKS];
        for (block, numbers) in blocks.iter_mut().enumerate().take(count) {
            if numbers.len() < self.needed[block] {
                return check_length(block, numbers, self.values_per_block[block], self.lanes);
            }
            addresses[block] = numbers.as_mut_ptr();
        }
        // SAFETY: there is an address for each block of the program, and each points to as many numbers as its highest slot
        // needs (checked above); exclusive references do not overlap and live until the call has returned.
        unsafe { self.call(&addresses[..count]) };
        Ok(())
    }

    /// Runs the kernel without checking the blocks.
    ///
    /// # Safety
    ///
    /// `blocks` has at least as many addresses as [`Kernel::values_per_block`] has entries. Each points to at least
    /// `values_per_block()[b] * lanes()` numbers that may be read and written during the call; blocks that the program
    /// writes to overlap no other block. No alignment beyond that of `f64` is needed.
    #[inline]
    pub unsafe fn call(&self, blocks: &[*mut f64]) {
        debug_assert!(blocks.len() >= self.values_per_block.len());
        let start = self.memory[self.start..].as_ptr();
        // SAFETY: there the memory holds what `assemble` wrote for exactly this signature and is executable while `self` lives;
        // `executable` has checked that the processor has the instructions; the caller answers for the blocks.
        #[cfg(target_arch = "x86_64")]
        unsafe {
            type Entry = unsafe extern "sysv64" fn(*const *mut f64);
            let entry = std::mem::transmute::<*const u8, Entry>(start);
            entry(blocks.as_ptr());
        }
        #[cfg(not(target_arch = "x86_64"))]
        unreachable!("no kernel can be made for {start:?} here")
    }
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
