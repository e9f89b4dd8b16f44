//! Programs that run one after the other on the same blocks.

use super::error::NativeError;
use super::evaluate::Interpreted;
use super::memory::{Kernel, PlacedKernel, parts};
use super::place::Place;
use super::program::Program;
use super::{LARGEST_BLOCKS, Level};

/// A program, and its machine code where that is wanted and can be had.
#[derive(Debug, Clone)]
pub struct Routine {
    program: Program,
    kernel: Option<Kernel>,
}

impl Routine {
    /// `programs` for so many lanes: as machine code for `level`, or to be interpreted. What no machine code can be had for is
    /// interpreted as well.
    pub fn all(programs: Vec<Program>, level: Option<Level>, lanes: usize) -> Vec<Self> {
        let kernels = level.map_or_else(Vec::new, |level| match Kernel::compile_together(&programs, level, lanes) {
            Ok(kernels) => kernels.into_iter().map(Some).collect(),
            Err(_) => programs.iter().map(|program| Kernel::compile(program, level, lanes).ok()).collect(),
        });
        let kernels = kernels.into_iter().chain(std::iter::repeat(None));
        programs.into_iter().zip(kernels).map(|(program, kernel)| Self { program, kernel }).collect()
    }
}

/// Routines in an order, each on blocks that are parts of those that the sequence is run on.
#[derive(Debug, Clone)]
pub struct Sequence {
    lanes: usize,
    calls: Vec<Call>,
}

#[derive(Debug, Clone)]
enum Call {
    Machine(Box<PlacedKernel>),
    Interpreted(Interpreted),
}

impl Sequence {
    /// `calls` for so many lanes: of each the routine, and by block of its program where that lies. Places behind those that the
    /// program uses do not count, nor do those of blocks of which it uses nothing.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`], [`NativeError::TooManyBlocks`], [`NativeError::PlacesOverlap`].
    pub fn new(lanes: usize, calls: &[(&Routine, &[Place])]) -> Result<Self, NativeError> {
        let call = |&(Routine { program, kernel }, places): &(&Routine, &[Place])| {
            parts(program.values_per_block(), places, lanes)?;
            match kernel {
                Some(kernel) => Ok(Call::Machine(Box::new(PlacedKernel::new(kernel, places)?))),
                None => Ok(Call::Interpreted(Interpreted::new(&program.placed(places)))),
            }
        };
        Ok(Self { lanes, calls: calls.iter().map(call).collect::<Result<_, _>>()? })
    }

    /// Runs on `blocks`: value `i` of block `b` in lane `l` is `blocks[b][i * lanes + l]`. The bits are the same as machine code and
    /// interpreted, except for which of the numbers "not a number" a result is. `scratch` is work space, which grows to what is
    /// needed and can be used again.
    ///
    /// # Errors
    ///
    /// [`NativeError::BlockTooShort`]; what ran before has been done.
    pub fn run(&self, blocks: &mut [&mut [f64]; LARGEST_BLOCKS], scratch: &mut Vec<f64>) -> Result<(), NativeError> {
        for call in &self.calls {
            match call {
                Call::Machine(kernel) => kernel.run(blocks)?,
                Call::Interpreted(program) => program.run(self.lanes, blocks, scratch)?,
            }
        }
        Ok(())
    }
}
