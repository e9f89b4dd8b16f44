//! The box of the unknowns as cells, each tested at its middle, and refined where the boundary of the consistent set may be.

use super::joint_test::Verdict;

/// Cells at the start, at most, but for two along each unknown.
const FIRST_CELLS: usize = 64;
/// A cell is fine enough where it is this share of the consistent set along each unknown.
const RESOLUTION: f64 = 1.0 / 20.0;
/// Cells along an unknown, at most.
const MOST_CELLS: usize = 512;

/// An unknown of the box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Anything between two ends.
    Continuous,
    /// One of so many members.
    Members(usize),
}

/// All cells, the first unknown changing fastest.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub axes: Vec<Axis>,
    pub counts: Vec<usize>,
    /// What the test says of the middle of each, or of the middle of the cell that it is a part of.
    pub cells: Vec<Verdict>,
}

impl Grid {
    /// Cells of the start, not tested.
    pub fn counts_at_start(axes: &[Axis]) -> Vec<usize> {
        let mut counts: Vec<usize> = axes
            .iter()
            .map(|axis| match axis {
                Axis::Continuous => 2,
                Axis::Members(members) => *members,
            })
            .collect();
        let is_small = |counts: &[usize]| 2 * counts.iter().product::<usize>() <= FIRST_CELLS;
        while is_small(&counts) {
            // The first of the coarsest unknowns, so that all become equally fine.
            let coarsest = (0..axes.len()).filter(|k| axes[*k] == Axis::Continuous).min_by_key(|k| counts[*k]);
            let Some(coarsest) = coarsest.filter(|k| counts[*k] < FIRST_CELLS / 4) else { break };
            counts[coarsest] *= 2;
        }
        counts
    }

    /// Where a cell stands along each unknown.
    pub fn place(&self, cell: usize) -> Vec<usize> {
        place(&self.counts, cell)
    }

    fn index(&self, place: &[usize]) -> usize {
        let mut index = 0;
        for (at, count) in place.iter().zip(&self.counts).rev() {
            index = index * count + at;
        }
        index
    }

    /// Middle of a cell, as shares of the box; of a member its place.
    pub fn middle(&self, cell: usize) -> Vec<f64> {
        let of = |(k, at): (usize, usize)| match self.axes[k] {
            Axis::Continuous => (at as f64 + 0.5) / self.counts[k] as f64,
            Axis::Members(_) => at as f64,
        };
        self.place(cell).into_iter().enumerate().map(of).collect()
    }

    /// Cells that touch one, corners included; members of a list touch none.
    pub fn beside(&self, cell: usize) -> Vec<usize> {
        let mut all = vec![Vec::new()];
        for (k, at) in self.place(cell).into_iter().enumerate() {
            let range = match self.axes[k] {
                Axis::Continuous => at.saturating_sub(1)..(at + 2).min(self.counts[k]),
                Axis::Members(_) => at..at + 1,
            };
            let longer = |place: Vec<usize>| {
                range.clone().map(move |at| {
                    let mut place = place.clone();
                    place.push(at);
                    place
                })
            };
            all = all.into_iter().flat_map(longer).collect();
        }
        all.iter().map(|place| self.index(place)).filter(|other| *other != cell).collect()
    }

    fn is_consistent(&self, cell: usize) -> bool {
        self.cells[cell].is_consistent
    }

    pub fn consistent(&self) -> impl Iterator<Item = usize> {
        (0..self.cells.len()).filter(|cell| self.is_consistent(*cell))
    }

    /// First and last consistent cell along an unknown.
    pub fn extent(&self, unknown: usize) -> Option<[usize; 2]> {
        let places: Vec<usize> = self.consistent().map(|cell| self.place(cell)[unknown]).collect();
        Some([*places.iter().min()?, *places.iter().max()?])
    }

    /// Whether a cell may hold a part of the boundary: it, or one beside it, is consistent, and not all of them are; or the distance
    /// falls so fast towards it that it would be reached within the cell.
    fn is_open(&self, cell: usize) -> bool {
        let beside = self.beside(cell);
        let own = self.cells[cell];
        let others = beside.iter().map(|other| self.cells[*other]);
        if own.is_consistent || others.clone().any(|other| other.is_consistent) {
            return !(own.is_consistent && others.clone().all(|other| other.is_consistent));
        }
        let steepest = others.map(|other| (other.distance - own.distance).abs()).fold(0.0, f64::max);
        // The middle of the cell beside is a cell away, the edge half a cell.
        own.distance - 0.5 * steepest <= 1.0
    }

    /// The unknown along which cells are coarsest beside the consistent set; nothing where all are fine enough.
    fn coarsest(&self) -> Option<usize> {
        let share = |unknown: usize| {
            let cells = self.extent(unknown).map_or(1, |[first, last]| last - first + 1);
            1.0 / cells as f64
        };
        let splittable =
            |unknown: &usize| self.axes[*unknown] == Axis::Continuous && self.counts[*unknown] < MOST_CELLS;
        let coarsest = (0..self.axes.len()).filter(splittable).max_by(|a, b| {
            share(*a).total_cmp(&share(*b)).then(self.counts[*b].cmp(&self.counts[*a])).then(b.cmp(a))
        })?;
        (share(coarsest) > RESOLUTION).then_some(coarsest)
    }

    /// The next finer cells, and which of them are to be tested; nothing where they are fine enough, or where none is open.
    pub fn finer(&self) -> Option<(Self, Vec<usize>)> {
        let unknown = self.coarsest()?;
        let is_open: Vec<bool> = (0..self.cells.len()).map(|cell| self.is_open(cell)).collect();
        if !is_open.contains(&true) {
            return None;
        }
        let mut counts = self.counts.clone();
        counts[unknown] *= 2;
        let parent = |cell: usize| {
            let mut at = place(&counts, cell);
            at[unknown] /= 2;
            self.index(&at)
        };
        let parents: Vec<usize> = (0..counts.iter().product()).map(parent).collect();
        let tested = (0..parents.len()).filter(|cell| is_open[parents[*cell]]).collect();
        let cells = parents.iter().map(|parent| self.cells[*parent]).collect();
        Some((Self { axes: self.axes.clone(), counts, cells }, tested))
    }
}

/// Where a cell stands among so many along each unknown.
pub(crate) fn place(counts: &[usize], mut cell: usize) -> Vec<usize> {
    let along = |count: &usize| {
        let at = cell % count;
        cell /= count;
        at
    };
    counts.iter().map(along).collect()
}
