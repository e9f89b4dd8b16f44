//! Boxes that hold one position for each place of the play.

use crate::accuracy::play_set::PlacedBlock;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::proven::linear::product;
use crate::closure::loops::first_column;
use crate::enclosure::jet::{JOURNAL, Jet, NUMBERS, PLAY};
use crate::enclosure::position_box::{BoxCentre, PositionBox};
use loosepin_math::{Interval, Real};

/// Boxes that are tried before the proof is given up.
const MAX_BOXES: usize = 10;
/// How much larger than what they must hold they are made.
const INFLATION: f64 = 1.1;
/// Radius of the first box about the ideal position, lengths over L and rad: its round-off.
const ROUND_OFF: f64 = 1e-14;
/// Radius of a box at which it is given up.
const MAX_RADIUS: f64 = 0.5;

/// What boxes about a position have in common.
pub(super) struct LoopBox<'a> {
    pub centre: &'a BoxCentre<'a>,
    /// Blocks of the play.
    pub blocks: &'a [PlacedBlock],
    /// The first variable of the play of each joint, and how many it has.
    pub plays: Vec<(usize, usize)>,
    /// Unknowns, and variables of play.
    pub n: usize,
    pub nv: usize,
    /// Y, row by row: a number that is near the inverse of J, and as such exact.
    pub inverse: Vec<Interval>,
    /// Columns of V.
    idle: &'a [Vec<f64>],
    /// Y Φ at q = 0, v = 0.
    misclosure: Vec<Interval>,
}

/// A box of which it is shown that it holds one position for each v.
pub(super) struct Positions {
    /// A smaller box that holds all of these positions.
    pub found: Vec<Interval>,
    /// The box itself.
    pub tried: Vec<Interval>,
}

impl<'a> LoopBox<'a> {
    /// `None` if there are not as many equations as unknowns, or the system has no inverse.
    pub(super) fn new(accuracy: &'a PoseAccuracy<'_>, centre: &'a BoxCentre<'a>) -> Option<Self> {
        let (n, set) = (accuracy.loops.unknowns(), &accuracy.set);
        let idle = &accuracy.position.borders.right;
        if accuracy.loops.rows.len() + idle.len() != n {
            return None;
        }
        let mut inverse = vec![Interval::ZERO; n * n];
        for column in 0..n {
            let mut unit = vec![0.0; n];
            unit[column] = 1.0;
            let (solved, _) = accuracy.system.solve(&unit);
            for (row, entry) in solved.iter().enumerate() {
                if !entry.is_finite() {
                    return None;
                }
                inverse[row * n + column] = Interval::from_f64(*entry);
            }
        }
        let plays = (0..accuracy.loops.mechanism.joints().len()).map(|joint| {
            let own = set.blocks().iter().filter(|block| block.joint == joint);
            let first = own.clone().next().map_or(0, |block| block.first);
            (first, own.map(|block| block.part.size()).sum())
        });
        let mut own = Self {
            centre,
            blocks: set.blocks(),
            plays: plays.collect(),
            n,
            nv: set.variables(),
            inverse,
            idle,
            misclosure: Vec::new(),
        };
        let nowhere = vec![Interval::ZERO; n];
        let mut residuals = vec![Interval::ZERO; n];
        for (row, jet) in own.rows::<0>(&nowhere, 0.0) {
            residuals[row] = jet.value;
        }
        own.misclosure = product(&own.inverse, &residuals, n, 1, 0..1);
        Some(own)
    }

    /// The rows over a box and a share of the play.
    pub(super) fn rows<const C: usize>(&self, numbers: &[Interval], share: f64) -> Vec<(usize, Jet<C>)> {
        PositionBox { centre: self.centre, numbers }.rows(Interval::around_zero(share))
    }

    /// Where the numbers of a joint's jets are among all unknowns and variables of play; `None` of the ground.
    pub(super) fn places(&self, bodies: [usize; 2], play: (usize, usize)) -> [Option<usize>; NUMBERS] {
        let [bearing, journal] = bodies.map(first_column);
        core::array::from_fn(|k| {
            if k < JOURNAL {
                bearing.map(|first| first + k)
            } else if k < PLAY {
                journal.map(|first| first + k - JOURNAL)
            } else {
                (k - PLAY < play.1).then_some(self.n + play.0 + k - PLAY)
            }
        })
    }

    /// Where the numbers of a row's jets are.
    pub(super) fn places_of_row(&self, row: usize) -> [Option<usize>; NUMBERS] {
        let loops = self.centre.loops;
        let joint = loops.rows[row].joint;
        let pair = &loops.mechanism.joints()[joint];
        self.places([pair.bearing.body, pair.journal.body], self.plays[joint])
    }

    /// J and K side by side, row by row.
    pub(super) fn slopes<const C: usize>(&self, rows: &[(usize, Jet<C>)]) -> Vec<Interval> {
        let width = self.n + self.nv;
        let mut matrix = vec![Interval::ZERO; self.n * width];
        for (row, jet) in rows {
            for (place, slope) in self.places_of_row(*row).into_iter().zip(jet.slopes) {
                if let Some(place) = place {
                    matrix[row * width + place] = slope;
                }
            }
        }
        for (k, direction) in self.idle.iter().enumerate() {
            let row = self.centre.loops.rows.len() + k;
            for (place, entry) in direction.iter().enumerate() {
                matrix[row * width + place] = Interval::from_f64(*entry);
            }
        }
        matrix
    }

    /// What Y K v can be for all v with |v| <= share in each ball.
    fn reach(&self, by_play: &[Interval], share: f64) -> Vec<Interval> {
        let reach = |row: &[Interval]| {
            let blocks = self.blocks.iter().map(|block| {
                let squares = row[block.range()].iter().fold(Interval::ZERO, |sum, entry| sum + entry.squared());
                (squares.sqrt() * Interval::from_f64(share)).high()
            });
            Interval::around_zero(blocks.fold(Interval::ZERO, |sum, own| sum + Interval::from_f64(own)).high())
        };
        (0..self.n).map(|row| reach(&by_play[row * self.nv..(row + 1) * self.nv])).collect()
    }

    /// A box about the ideal position that holds one position for each v with |v| <= share in each ball; `None` if that is not shown.
    pub(super) fn positions(&self, share: f64) -> Option<Positions> {
        let (n, nv) = (self.n, self.nv);
        let width = n + nv;
        let nowhere = vec![Interval::ZERO; n];
        let at_rest = self.slopes(&self.rows::<0>(&nowhere, 0.0));
        let first = self.reach(&product(&self.inverse, &at_rest, n, width, n..width), share);
        let mut tried: Vec<Interval> =
            first.iter().map(|own| Interval::around_zero(INFLATION * own.magnitude() + ROUND_OFF)).collect();
        for _ in 0..MAX_BOXES {
            let slopes = self.slopes(&self.rows::<0>(&tried, share));
            let by_play = self.reach(&product(&self.inverse, &slopes, n, width, n..width), share);
            let by_unknowns = product(&self.inverse, &slopes, n, width, 0..n);
            let mut found = Vec::with_capacity(n);
            for row in 0..n {
                let mut sum = by_play[row] - self.misclosure[row];
                for column in 0..n {
                    let unit = Interval::from_f64(f64::from(u8::from(row == column)));
                    sum += (unit - by_unknowns[row * n + column]) * tried[column];
                }
                found.push(sum);
            }
            if found.iter().zip(&tried).all(|(found, tried)| found.is_inside(*tried)) {
                return Some(Positions { found, tried });
            }
            for (tried, found) in tried.iter_mut().zip(&found) {
                let radius = tried.magnitude().max(INFLATION * found.magnitude());
                if !(radius < MAX_RADIUS) {
                    return None;
                }
                *tried = Interval::around_zero(radius);
            }
        }
        None
    }
}
