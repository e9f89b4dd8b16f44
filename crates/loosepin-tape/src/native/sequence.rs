//! Programs that run one after the other on the same blocks.

use super::block_start::BlockStart;
use super::error::NativeError;
use super::evaluate::Interpreted;
use super::memory::{Kernel, PlacedKernel, PlacedKernels, parts};
use super::program::Program;
use super::{Level, MAX_BLOCKS};
use std::ops::Range;

/// A program, and its machine code where that is wanted and can be had.
#[derive(Debug, Clone)]
pub struct Routine {
    program: Program,
    kernel: Option<Kernel>,
    lanes: usize,
}

impl Routine {
    /// `programs` for `lanes` lanes: as machine code for `level`, or to be interpreted. What no machine code can be had for is interpreted
    /// as well.
    pub fn all(programs: Vec<Program>, level: Option<Level>, lanes: usize) -> Vec<Self> {
        let kernels = level.map_or_else(Vec::new, |level| match Kernel::compile_together(&programs, level, lanes) {
            Ok(kernels) => kernels.into_iter().map(Some).collect(),
            Err(_) => programs.iter().map(|program| Kernel::compile(program, level, lanes).ok()).collect(),
        });
        let kernels = kernels.into_iter().chain(std::iter::repeat(None));
        programs.into_iter().zip(kernels).map(|(program, kernel)| Self { program, kernel, lanes }).collect()
    }
}

/// Routines in an order, each on blocks that are parts of those that the sequence is run on.
#[derive(Debug, Clone)]
pub struct Sequence {
    calls: Vec<Call>,
}

#[derive(Debug, Clone)]
enum Call {
    Machine(PlacedKernels),
    Interpreted { program: Interpreted, lanes: usize },
}

impl Sequence {
    /// `calls`: of each the routine, and by block of its program where that lies. Places behind those that the
    /// program uses do not count, nor do those of blocks of which it uses nothing.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`], [`NativeError::TooManyBlocks`], [`NativeError::PlacesOverlap`].
    pub fn new(calls: &[(&Routine, &[BlockStart])]) -> Result<Self, NativeError> {
        let mut own: Vec<Call> = Vec::with_capacity(calls.len());
        for &(Routine { program, kernel, lanes }, places) in calls {
            let Some(kernel) = kernel else {
                parts(program.values_per_block(), places, *lanes)?;
                own.push(Call::Interpreted { program: Interpreted::new(&program.placed(places)), lanes: *lanes });
                continue;
            };
            let kernel = PlacedKernel::new(kernel, places)?;
            match own.last_mut() {
                Some(Call::Machine(kernels)) => kernels.push(kernel),
                _ => own.push(Call::Machine(PlacedKernels::new(kernel))),
            }
        }
        Ok(Self { calls: own })
    }

    /// Whether all of it is machine code.
    pub fn is_machine_code(&self) -> bool {
        self.calls.iter().all(|call| matches!(call, Call::Machine(_)))
    }

    /// Runs on `blocks`: value `i` of block `b` in lane `l` is `blocks[b][i * lanes + l]`, with the lanes of the routines. The bits are the same as machine code and
    /// interpreted, except for which of the numbers "not a number" a result is. `scratch` is work space, which grows to what is
    /// needed and can be used again.
    ///
    /// # Errors
    ///
    /// [`NativeError::BlockTooShort`]; some of what comes before may have been done.
    pub fn run(&self, blocks: &mut [&mut [f64]; MAX_BLOCKS], scratch: &mut Vec<f64>) -> Result<(), NativeError> {
        self.run_on(0..usize::MAX, blocks, scratch)
    }

    /// The same for these lanes; what happens with the others is left open: some are computed with them.
    ///
    /// # Errors
    ///
    /// [`NativeError::BlockTooShort`]; some of what comes before may have been done.
    pub fn run_on(
        &self,
        lanes: Range<usize>,
        blocks: &mut [&mut [f64]; MAX_BLOCKS],
        scratch: &mut Vec<f64>,
    ) -> Result<(), NativeError> {
        for call in &self.calls {
            match call {
                Call::Machine(kernels) => kernels.run(&lanes, blocks)?,
                Call::Interpreted { program, lanes } => program.run(*lanes, blocks, scratch)?,
            }
        }
        Ok(())
    }
}
