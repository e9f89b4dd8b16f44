//! How the runs of a batch are computed.

use loosepin_tape::native::Level;

/// Lanes of a batch: four vectors of eight, so that what one waits for is hidden behind the others, and so that few calls of the
/// programs are made.
const LANES: usize = 4 * LANES_OF_A_VECTOR;
/// Lanes of the widest vectors, which are computed together.
pub(crate) const LANES_OF_A_VECTOR: usize = 8;

/// How the runs of a batch are computed. A run has the same bits in all of these.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Execution {
    /// Many runs side by side, the equations as machine code for this set of instructions. What the operating system refuses
    /// as machine code is interpreted.
    MachineCode(Level),
    /// Many runs side by side, the equations written down and evaluated operation by operation, each for all runs.
    Interpreted,
    /// One run after the other, the equations as they stand.
    Scalar,
}

impl Execution {
    /// The fastest on this processor.
    pub fn best() -> Self {
        Self::available()[0]
    }

    /// All that this processor can do, the fastest first.
    pub fn available() -> Vec<Self> {
        let levels = Level::ALL.into_iter().rev().filter(|level| level.is_supported());
        levels.map(Self::MachineCode).chain([Self::Interpreted, Self::Scalar]).collect()
    }

    /// Its name.
    pub fn name(self) -> String {
        match self {
            Self::MachineCode(level) => format!("{level}"),
            Self::Interpreted => "interpreted".to_owned(),
            Self::Scalar => "scalar".to_owned(),
        }
    }

    /// Runs side by side of a batch.
    pub(crate) fn lanes(self) -> usize {
        if self == Self::Scalar { 1 } else { LANES }
    }

    /// Lanes of a run by itself: programs for one vector take half as long to translate as those for several.
    pub(crate) fn lanes_alone(self) -> usize {
        if self == Self::Scalar { 1 } else { LANES_OF_A_VECTOR }
    }

    /// The instructions of the machine code.
    pub(crate) fn level(self) -> Option<Level> {
        match self {
            Self::MachineCode(level) => Some(level),
            Self::Interpreted | Self::Scalar => None,
        }
    }
}
