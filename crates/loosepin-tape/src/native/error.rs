//! Why a program cannot be compiled or run.

use super::Level;

/// Why a program cannot be compiled or run. Without machine code, [`super::Sequence`] interprets it and gives the same numbers.
#[derive(Debug, thiserror::Error)]
pub enum NativeError {
    /// This processor, or this build, cannot run the instructions.
    #[error("machine code for {level} cannot run on this processor\nhint: interpret the program instead")]
    NotSupported {
        /// The instructions asked for.
        level: Level,
    },
    /// The operating system gives no memory that may be executed.
    #[error(
        "the operating system refused {bytes} bytes of executable memory: {source}\nhint: interpret the program instead"
    )]
    ExecutableMemoryRefused {
        /// The size of the machine code.
        bytes: usize,
        /// Message of the operating system.
        source: std::io::Error,
    },
    /// The lanes do not fill whole vectors.
    #[error("{lanes} lanes for {level}; must be a positive multiple of {} up to {}", level.vector_lanes(), super::MAX_LANES)]
    UnevenLanes {
        /// The lanes asked for.
        lanes: usize,
        /// The instructions asked for.
        level: Level,
    },
    /// More blocks than there are registers for their addresses.
    #[error("the program uses {given} blocks; must be at most {}", super::MAX_BLOCKS)]
    TooManyBlocks {
        /// The blocks of the program.
        given: usize,
    },
    /// An address inside a block would not fit into an instruction.
    #[error("block {block} has {values} values of {lanes} lanes; must be below 2 GiB")]
    BlockTooLarge {
        /// Which block.
        block: usize,
        /// Its values.
        values: usize,
        /// The lanes asked for.
        lanes: usize,
    },
    /// More values are needed at a time than a stack should hold.
    #[error(
        "the machine code needs a stack frame of {bytes} bytes; must be at most {}\nhint: interpret the program instead",
        super::MAX_FRAME_BYTES
    )]
    FrameTooLarge {
        /// The size of the frame.
        bytes: usize,
    },
    /// Two outputs go to one slot.
    #[error("value {index} of block {block} is written twice; each output must have its own slot")]
    SlotWrittenTwice {
        /// Which block.
        block: u8,
        /// Which value of it.
        index: u32,
    },
    /// Two blocks of a program are to lie on the same numbers.
    #[error("two blocks of the program overlap in block {block}; each must have numbers of its own")]
    PlacesOverlap {
        /// The block in which both lie.
        block: usize,
    },
    /// Called with fewer blocks than the program uses.
    #[error("called with {given} blocks; must be at least {needed}")]
    TooFewBlocks {
        /// The blocks given.
        given: usize,
        /// The blocks that the program uses.
        needed: usize,
    },
    /// Called with a block that ends too early.
    #[error("block {block} holds {given} numbers; must hold at least {needed}")]
    BlockTooShort {
        /// Which block.
        block: usize,
        /// The numbers that it holds.
        given: usize,
        /// Values times lanes.
        needed: usize,
    },
}
