//! Straight-line arithmetic as machine code, one run in each lane of the vector registers.
//!
//! A [`Graph`] is written down once, by the methods that the equations are made of; a [`Program`] is what some outputs need
//! of it; a [`Kernel`] is the program as machine code for x86-64 processors. A [`Sequence`] runs programs one after the other, as
//! machine code or, where none can be run, one operation at a time for all lanes (`evaluate`), with the same bits. What changes seldom
//! is taken out of programs that run often by [`Hoisted`].
//!
//! The compiler is a line of phases, each a file: order the operations (`schedule`), write them as instructions on values
//! (`lower`), give the values registers (`allocate`, `registers`), write bytes (`encode`, `assemble`), make them executable (`memory`).
//!
//! ```
//! use loosepin_tape::native::{Graph, Kernel, Level, Program, Slot};
//!
//! // y = sqrt(a² + b²), with a and b in block 0 and y in block 1.
//! let mut graph = Graph::new();
//! let a = graph.input(Slot { block: 0, index: 0 });
//! let b = graph.input(Slot { block: 0, index: 1 });
//! let square = graph.multiply(b, b);
//! let sum = graph.mul_add(a, a, square);
//! let y = graph.square_root(sum);
//! let program = Program::new(&graph, &[(Slot { block: 1, index: 0 }, y)])?;
//!
//! let lanes = 8;
//! let legs_m: Vec<f64> = [[3.0; 8], [4.0; 8]].concat();
//! let mut hypotenuse_m = vec![f64::NAN; lanes];
//! let mut legs = legs_m.clone();
//! let blocks: &mut [&mut [f64]] = &mut [&mut legs, &mut hypotenuse_m];
//! match Level::best().map(|level| Kernel::compile(&program, level, lanes)) {
//!     Some(Ok(kernel)) => kernel.run(blocks)?,
//!     _ => program.evaluate(lanes, blocks)?,
//! }
//! assert_eq!(hypotenuse_m, [5.0; 8]);
//! # Ok::<(), loosepin_tape::native::NativeError>(())
//! ```

mod allocate;
mod assemble;
mod block_start;
mod counts;
mod encode;
mod error;
mod evaluate;
mod graph;
mod hoist;
mod instruction;
mod level;
mod lower;
mod memory;
mod node;
mod program;
mod recent;
mod registers;
mod schedule;
mod sequence;
mod translate;

#[cfg(test)]
mod random_instructions;
#[cfg(test)]
mod random_programs;

pub use block_start::BlockStart;
pub use counts::OperationCounts;
pub use error::NativeError;
pub use graph::{Graph, Mask, Value};
pub use hoist::Hoisted;
pub use level::Level;
pub use memory::Kernel;
pub use node::Slot;
pub use program::Program;
pub use sequence::{Routine, Sequence};
pub use translate::KernelSize;

/// Most blocks of a program: as many as there are registers for their addresses that need not be saved for the caller.
pub const MAX_BLOCKS: usize = 8;

/// Largest stack frame of a kernel: an eighth of the stack of a thread, if that is what Rust gives one.
pub const MAX_FRAME_BYTES: usize = 1 << 18;

/// Most lanes of a kernel.
pub const MAX_LANES: usize = 1024;
