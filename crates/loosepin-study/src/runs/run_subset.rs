//! Which runs of a study are made here, where several processes share them.

use std::collections::BTreeMap;
use std::fmt;

use loosepin_store::Shard;

/// The subset of the runs of a study that is made here. Results do not depend on it.
///
/// A study asks for its runs in rounds, each of which depends on the rounds before it alone. Whoever makes a part of them keeps his
/// runs in a store, and comes no further than the first round of which a run is missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunSubset {
    /// All of it.
    Whole,
    /// The runs of a shard.
    Shard(Shard),
    /// The few runs left by the shards: rounds of at most `largest_round` runs.
    Joined {
        /// How many shards there are.
        of: u32,
        /// The largest round of which missing runs are made here.
        largest_round: usize,
    },
}

impl RunSubset {
    /// Whether a missing run at `place` of a list, in a round of `round_runs` runs, is made here.
    pub(crate) fn makes(self, place: u64, round_runs: usize) -> bool {
        match self {
            Self::Whole => true,
            Self::Shard(shard) => shard.makes(place),
            Self::Joined { largest_round, .. } => round_runs <= largest_round,
        }
    }

    /// How many shards share the study; `None` if it is made as a whole.
    pub(crate) fn shards(self) -> Option<u32> {
        match self {
            Self::Whole => None,
            Self::Shard(shard) => Some(shard.of()),
            Self::Joined { of, .. } => Some(of),
        }
    }
}

/// A round of which runs are missing that are made elsewhere.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OpenRound {
    /// Runs of the rounds before it.
    pub runs_before: usize,
    /// Its runs.
    pub runs: usize,
    /// How many of them were made here just now.
    pub made: usize,
    /// How many are missing, by the number of the shard that is to make them.
    pub missing: BTreeMap<u32, usize>,
}

impl OpenRound {
    /// Missing runs of all shards.
    pub fn missing_runs(&self) -> usize {
        self.missing.values().sum()
    }
}

/// `the round of 600 runs that follows the first 1200 lacks 14 of them`.
impl fmt::Display for OpenRound {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let missing = self.missing_runs();
        match self.runs_before {
            0 => write!(formatter, "the first round, of {} runs, lacks {missing} of them", self.runs),
            before => {
                write!(
                    formatter,
                    "the round of {} runs that follows the first {before} lacks {missing} of them",
                    self.runs
                )
            }
        }
    }
}
