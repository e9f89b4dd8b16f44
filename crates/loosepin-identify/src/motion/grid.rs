//! The box of the unknowns as cells, each tested at its middle, and refined where the boundary of the consistent set may be.

use super::joint_test::Verdict;

/// Cells at the start, at most, but for two along each unknown.
const FIRST_CELLS: usize = 64;
/// A cell is fine enough where it is this share of the consistent set along each unknown.
const RESOLUTION: f64 = 1.0 / 20.0;
/// Largest cell inside of the set, as a share of it along each unknown, if the inside counts as well.
const INSIDE: f64 = 1.0 / 8.0;
/// Cells along an unknown, at most.
const MAX_CELLS: usize = 512;

/// An unknown of the box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Anything between two ends.
    Continuous,
    /// One of this number of members.
    Members(usize),
}

/// A cell whose middle was tested.
#[derive(Debug, Clone)]
pub(crate) struct TestedCell {
    /// Its middle, as shares of the box; of a member its place.
    pub at: Vec<f64>,
    /// Its width along each unknown, as a share of the box.
    pub widths: Vec<f64>,
}

impl TestedCell {
    /// Whether its halves are not too many along the unknown.
    pub fn can_be_split_along(&self, unknown: usize) -> bool {
        self.widths[unknown] * MAX_CELLS as f64 > 1.0
    }

    fn halves(&self, unknown: usize) -> [Self; 2] {
        [-0.25, 0.25].map(|off| {
            let mut half = self.clone();
            half.at[unknown] += off * self.widths[unknown];
            half.widths[unknown] *= 0.5;
            half
        })
    }
}

/// All cells, the first unknown changing fastest.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub axes: Vec<Axis>,
    pub counts: Vec<usize>,
    /// Verdict of the test at the middle of each cell, or at the middle of the cell that contains it.
    pub cells: Vec<Verdict>,
    /// Whether a cell was tested at its own middle.
    is_own: Vec<bool>,
    /// Test that counts for each cell, by its index in their order.
    pub tests: Vec<usize>,
    /// Number of tests.
    settled: usize,
}

/// Half of a tested cell.
#[derive(Debug, Clone)]
pub(crate) struct Half {
    pub cell: TestedCell,
    /// Cells of the grid that it consists of.
    cells: Vec<usize>,
}

/// Tests the middles of the cells that it is given, and settles them.
pub type DecideCells<'t, E> = dyn FnMut(&mut Grid, &[usize]) -> Result<(), E> + 't;

impl Grid {
    /// Cells that were not tested.
    pub fn untested(axes: &[Axis], counts: Vec<usize>) -> Self {
        let verdict = Verdict { is_consistent: false, distance: f64::INFINITY };
        let count = counts.iter().product();
        Self {
            axes: axes.to_vec(),
            counts,
            cells: vec![verdict; count],
            is_own: vec![false; count],
            tests: vec![0; count],
            settled: 0,
        }
    }

    /// Notes what the test says of the middle of a cell.
    pub fn decide(&mut self, cell: usize, verdict: Verdict) {
        self.cells[cell] = verdict;
        self.is_own[cell] = true;
        self.tests[cell] = self.settled;
        self.settled += 1;
    }

    /// The box in cells that are fine enough beside the consistent set, and whether they are coarser since more than about `points` cells
    /// would have to be tested. `with_inside` tests cells inside the set too. `test` settles the cells that it is given.
    ///
    /// # Errors
    /// Those of `test`.
    pub fn refined<E>(
        axes: &[Axis],
        points: usize,
        with_inside: bool,
        test: &mut DecideCells<'_, E>,
    ) -> Result<(Self, bool), E> {
        let mut grid = Self::untested(axes, Self::counts_at_start(axes));
        let mut waiting: Vec<usize> = (0..grid.cells.len()).collect();
        let mut tested = 0;
        loop {
            // A cell that is kept only now has cells beside it of which a coarser one was tested: the set may go on there.
            while !waiting.is_empty() {
                test(&mut grid, &waiting)?;
                tested += waiting.len();
                waiting = grid.undecided_neighbours();
            }
            let Some((finer, open)) = grid.finer(with_inside) else { return Ok((grid, false)) };
            if tested + open.len() > points {
                return Ok((grid, true));
            }
            grid = finer;
            waiting = open;
        }
    }

    /// Cells beside the consistent ones that are rejected and were not tested at their own middle.
    fn undecided_neighbours(&self) -> Vec<usize> {
        let is_due = |cell: &usize| !self.is_own[*cell] && !self.cells[*cell].is_consistent;
        let mut due: Vec<usize> = self.consistent().flat_map(|cell| self.neighbours(cell)).filter(is_due).collect();
        due.sort_unstable();
        due.dedup();
        due
    }

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

    /// Position of a cell along each unknown.
    pub fn place(&self, cell: usize) -> Vec<usize> {
        place(&self.counts, cell)
    }

    /// Index of the cell that contains a place, in a grid of `counts` cells along each unknown.
    pub fn index_of(&self, place: &[usize], counts: &[usize]) -> usize {
        let coarse: Vec<usize> =
            place.iter().zip(counts).zip(&self.counts).map(|((at, fine), own)| at / (fine / own)).collect();
        self.index(&coarse)
    }

    /// The cell at shares of the box, for a member at its index; `None` outside.
    pub fn cell_at(&self, at: &[f64]) -> Option<usize> {
        let along = |((at, count), axis): ((&f64, &usize), &Axis)| {
            let place = match axis {
                Axis::Continuous => at * *count as f64,
                Axis::Members(_) => *at,
            };
            (place >= 0.0 && place < *count as f64).then_some(place as usize)
        };
        let place: Option<Vec<usize>> = at.iter().zip(&self.counts).zip(&self.axes).map(along).collect();
        Some(self.index(&place?))
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

    /// Width of a cell along each unknown, as a share of the box; of a member 1/n.
    pub fn widths(&self) -> Vec<f64> {
        self.counts.iter().map(|count| 1.0 / *count as f64).collect()
    }

    /// Cells that touch one, corners included; members of a list touch none.
    pub fn neighbours(&self, cell: usize) -> Vec<usize> {
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
        let beside = self.neighbours(cell);
        let own = self.cells[cell];
        let others = beside.iter().map(|other| self.cells[*other]);
        if own.is_consistent || others.clone().any(|other| other.is_consistent) {
            return !(own.is_consistent && others.clone().all(|other| other.is_consistent));
        }
        let steepest = others.map(|other| (other.distance - own.distance).abs()).fold(0.0, f64::max);
        // The middle of the cell beside is a cell away, the edge half a cell.
        own.distance - 0.5 * steepest <= 1.0
    }

    /// A cell as a share of the set along an unknown.
    fn share_of_set(&self, unknown: usize) -> f64 {
        let cells = self.extent(unknown).map_or(1, |[first, last]| last - first + 1);
        1.0 / cells as f64
    }

    /// The unknown along which cells are coarsest beside the consistent set; `None` if all are fine enough.
    fn coarsest(&self) -> Option<usize> {
        let share = |unknown: usize| self.share_of_set(unknown);
        let splittable = |unknown: &usize| self.axes[*unknown] == Axis::Continuous && self.counts[*unknown] < MAX_CELLS;
        let coarsest = (0..self.axes.len()).filter(splittable).max_by(|a, b| {
            share(*a).total_cmp(&share(*b)).then(self.counts[*b].cmp(&self.counts[*a])).then(b.cmp(a))
        })?;
        (share(coarsest) > RESOLUTION).then_some(coarsest)
    }

    /// The next finer cells, and which of them are to be tested; `None` if they are fine enough, or where none is open.
    fn finer(&self, with_inside: bool) -> Option<(Self, Vec<usize>)> {
        let unknown = self.coarsest()?;
        let is_coarse = with_inside && self.share_of_set(unknown) > INSIDE;
        let is_due = |cell: usize| (is_coarse && self.is_consistent(cell)) || self.is_open(cell);
        let is_open: Vec<bool> = (0..self.cells.len()).map(is_due).collect();
        if !is_open.contains(&true) {
            return None;
        }
        let (finer, parents) = self.doubled(unknown);
        let tested = (0..parents.len()).filter(|cell| is_open[parents[*cell]]).collect();
        Some((finer, tested))
    }

    /// The same in cells half as wide along an unknown, and of each the one that it is a half of.
    fn doubled(&self, unknown: usize) -> (Self, Vec<usize>) {
        let mut counts = self.counts.clone();
        counts[unknown] *= 2;
        let parent = |cell: usize| {
            let mut at = place(&counts, cell);
            at[unknown] /= 2;
            self.index(&at)
        };
        let parents: Vec<usize> = (0..counts.iter().product()).map(parent).collect();
        let cells: Vec<Verdict> = parents.iter().map(|parent| self.cells[*parent]).collect();
        let is_own = vec![false; cells.len()];
        let tests = parents.iter().map(|parent| self.tests[*parent]).collect();
        (Self { axes: self.axes.clone(), counts, cells, is_own, tests, settled: self.settled }, parents)
    }

    /// Halves of tested cells along an unknown, as far as their tests still count there; each is to be tested.
    /// All cells become narrow enough for them.
    pub fn halved(&mut self, tested: &[(usize, &TestedCell)], unknown: usize) -> Vec<Half> {
        let width = |(_, cell): &(usize, &TestedCell)| 0.5 * cell.widths[unknown];
        let narrowest = tested.iter().map(width).fold(f64::INFINITY, f64::min);
        // Widths are powers of 1/2 of the box: exact.
        if narrowest * (self.counts[unknown] as f64) < 1.0 {
            (*self, _) = self.doubled(unknown);
        }
        let of = |(test, cell): &(usize, &TestedCell)| {
            let parts = |half: TestedCell| Half { cells: self.cells_within(&half, *test), cell: half };
            cell.halves(unknown).map(parts)
        };
        tested.iter().flat_map(of).filter(|half| !half.cells.is_empty()).collect()
    }

    /// Cells within another for which this test counts.
    fn cells_within(&self, other: &TestedCell, test: usize) -> Vec<usize> {
        let is_within = |cell: &usize| {
            let middle = self.middle(*cell);
            let along = |k: usize| match self.axes[k] {
                Axis::Continuous => (middle[k] - other.at[k]).abs() < 0.5 * other.widths[k],
                Axis::Members(_) => middle[k] == other.at[k],
            };
            self.tests[*cell] == test && (0..self.axes.len()).all(along)
        };
        (0..self.cells.len()).filter(is_within).collect()
    }

    /// Notes what the test says of the middle of a half, for all its cells.
    pub fn decide_half(&mut self, half: &Half, verdict: Verdict) {
        for cell in &half.cells {
            self.cells[*cell] = verdict;
            self.tests[*cell] = self.settled;
        }
        self.settled += 1;
    }
}

/// Position of a cell in a grid of `counts` cells along each unknown.
pub(crate) fn place(counts: &[usize], mut cell: usize) -> Vec<usize> {
    let along = |count: &usize| {
        let at = cell % count;
        cell /= count;
        at
    };
    counts.iter().map(along).collect()
}

#[cfg(test)]
mod tests {
    use super::{Axis, Grid};
    use crate::motion::joint_test::Verdict;
    use std::convert::Infallible;

    /// A flat ellipsoid about `middle`, with half axes a along the direction and b across it. Outside, the distance tells nothing of the
    /// way to it.
    fn verdict(at: &[f64], middle: &[f64], direction: &[f64], [a, b]: [f64; 2]) -> Verdict {
        let off: Vec<f64> = at.iter().zip(middle).map(|(at, middle)| at - middle).collect();
        let along: f64 = off.iter().zip(direction).map(|(off, direction)| off * direction).sum();
        let square: f64 = off.iter().map(|off| off * off).sum();
        let is_consistent = (along / a).powi(2) + (square - along * along).max(0.0) / (b * b) <= 1.0;
        Verdict { is_consistent, distance: if is_consistent { 0.5 } else { 5.0 } }
    }

    #[test]
    fn identity_a_slanting_set_ends_where_all_cells_tested_one_by_one_end() {
        for unknowns in [2, 3] {
            // Three unknowns have so many cells that two directions have to do.
            let (trials, step) = if unknowns == 2 { (60_u32, 0.023) } else { (2, 0.2) };
            for trial in 0..trials {
                let angle = if unknowns == 2 { 0.1 } else { 0.6 } + step * f64::from(trial);
                let raw = [angle.cos(), angle.sin(), 0.4 * (3.0 * angle).sin()];
                let length = raw[..unknowns].iter().map(|part| part * part).sum::<f64>().sqrt();
                let direction: Vec<f64> = raw[..unknowns].iter().map(|part| part / length).collect();
                let middle: Vec<f64> = [0.47, 0.52, 0.49][..unknowns].to_vec();
                let half_axes = [0.42, if unknowns == 2 { 0.035 } else { 0.12 }];
                let axes = vec![Axis::Continuous; unknowns];
                let at = |grid: &Grid, cell: usize| verdict(&grid.middle(cell), &middle, &direction, half_axes);
                let (grid, is_coarse) =
                    Grid::refined(&axes, usize::MAX, false, &mut |grid: &mut Grid, waiting: &[usize]| {
                        for cell in waiting {
                            let verdict = at(grid, *cell);
                            grid.decide(*cell, verdict);
                        }
                        Ok::<(), Infallible>(())
                    })
                    .unwrap_or_else(|never| match never {});
                assert!(!is_coarse);
                let mut all = Grid::untested(&axes, grid.counts.clone());
                for cell in 0..all.cells.len() {
                    let verdict = at(&all, cell);
                    all.decide(cell, verdict);
                }
                for unknown in 0..unknowns {
                    assert_eq!(grid.extent(unknown), all.extent(unknown), "{unknowns} unknowns, trial {trial}");
                }
                assert_eq!(grid.consistent().count(), all.consistent().count(), "{unknowns} unknowns, trial {trial}");
                assert!(grid.undecided_neighbours().is_empty());
            }
        }
    }
}
