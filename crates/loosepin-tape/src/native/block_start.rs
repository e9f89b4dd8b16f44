//! Places of the blocks of a program among those of a sequence of programs.

use super::MAX_BLOCKS;

/// Start of a block of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlockStart {
    /// Which of the blocks that a sequence is run on.
    pub block: usize,
    /// At which value of it.
    pub first: usize,
}

impl BlockStart {
    /// Each block where the block of the same number begins.
    pub const ALL: [Self; MAX_BLOCKS] = {
        let mut places = [Self { block: 0, first: 0 }; MAX_BLOCKS];
        let mut block = 0;
        while block < MAX_BLOCKS {
            places[block].block = block;
            block += 1;
        }
        places
    };
}
