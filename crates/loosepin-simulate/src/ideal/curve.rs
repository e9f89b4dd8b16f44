//! The ideal motion of one sample over the recorded turns, as a table that is read at any instant.

use loosepin_math::Quintic;
use std::sync::Arc;

/// Nodes a turn, at least: between them a polynomial of degree five errs by (2πk/96)⁶/46080 of the k-th harmonic of the motion: 2e-12 of
/// the first, 2e-9 of the third, which is a few hundredths of the first.
const NODES_PER_TURN: usize = 96;
/// Pieces into which the interval between two of these nodes is divided, at most. Where that is not enough, as at a jump of a velocity, the
/// table errs beside the jump alone, by at most 4e-5 rad of the drive times the jump of the slope in m/rad.
const MAX_PIECES: usize = 256;
/// Places in a piece at which the table is held against the motion, as shares of the piece.
const CHECKED: [f64; 3] = [0.25, 0.5, 0.75];

/// Nodes of the tables of a study: equal intervals of the recorded part, each divided into equal pieces.
///
/// Rough places, as on cams, have more pieces. They are found once, for the nominal mechanism, and used for all samples.
#[derive(Debug, Clone)]
pub struct IdealNodes {
    /// Pieces of each interval.
    pieces: Vec<usize>,
    /// Index of the first node of each interval.
    first: Vec<usize>,
}

impl IdealNodes {
    /// Halves the pieces of each interval until the table differs by at most `largest_error` from the motion: `jets` gives its positions at
    /// a share of the recorded part, which lasts `span_s`, with their first two derivatives over time.
    ///
    /// # Errors
    /// That of the motion.
    pub fn new<E>(
        turns: f64,
        span_s: f64,
        largest_error: f64,
        mut jets: impl FnMut(f64) -> Result<Vec<[f64; 3]>, E>,
    ) -> Result<Self, E> {
        let intervals = (turns * NODES_PER_TURN as f64).ceil().max(1.0) as usize;
        let (mut pieces, mut first) = (Vec::with_capacity(intervals), Vec::with_capacity(intervals));
        let mut nodes = 0;
        for interval in 0..intervals {
            let mut own = 1;
            let share = |place: f64| (interval as f64 + place) / intervals as f64;
            let length_s = span_s / intervals as f64;
            while own < MAX_PIECES && differs(own, length_s, largest_error, |place| jets(share(place)))? {
                own *= 2;
            }
            first.push(nodes);
            pieces.push(own);
            nodes += own;
        }
        Ok(Self { pieces, first })
    }

    /// Pieces of each interval.
    pub fn pieces(&self) -> &[usize] {
        &self.pieces
    }

    /// The times of all nodes, s, where the recorded part begins at `start_s` and lasts `span_s`.
    pub(crate) fn times_s(&self, start_s: f64, span_s: f64) -> impl Iterator<Item = f64> {
        let intervals = self.pieces.len() as f64;
        let of_interval = |(interval, &pieces): (usize, &usize)| {
            (0..pieces).map(move |piece| interval as f64 + piece as f64 / pieces as f64)
        };
        let places = self.pieces.iter().enumerate().flat_map(of_interval).chain([intervals]);
        places.map(move |place| start_s + span_s * place / intervals)
    }

    /// The piece that holds `share` in [0, 1] of the recorded part; at a node the one that begins there.
    pub fn piece(&self, share: f64) -> Piece {
        let intervals = self.pieces.len();
        let place = share * intervals as f64;
        let interval = (place as usize).min(intervals - 1);
        let pieces = self.pieces[interval];
        let piece = (((place - interval as f64) * pieces as f64) as usize).min(pieces - 1);
        let end = |piece: usize| (interval as f64 + piece as f64 / pieces as f64) / intervals as f64;
        Piece { index: self.first[interval] + piece, shares: [end(piece), end(piece + 1)] }
    }

    /// Length of each of the `pieces` of an interval, s, where the recorded part lasts `span_s`.
    #[inline]
    fn length_s(&self, span_s: f64, pieces: usize) -> f64 {
        span_s / self.pieces.len() as f64 / pieces as f64
    }
}

/// Whether polynomials over `pieces` pieces of an interval differ from the motion anywhere by more than `largest_error`. `jets` are those at
/// a share of the interval.
fn differs<E>(
    pieces: usize,
    length_s: f64,
    largest_error: f64,
    mut jets: impl FnMut(f64) -> Result<Vec<[f64; 3]>, E>,
) -> Result<bool, E> {
    let mut start = jets(0.0)?;
    for piece in 0..pieces {
        let place = |share: f64| (piece as f64 + share) / pieces as f64;
        let end = jets(place(1.0))?;
        for share in CHECKED {
            for ((start, end), exact) in start.iter().zip(&end).zip(jets(place(share))?) {
                let table = Quintic::new(*start, *end, length_s / pieces as f64).value(share);
                if (table - exact[0]).abs() > largest_error {
                    return Ok(true);
                }
            }
        }
        start = end;
    }
    Ok(false)
}

/// Positions and angles of an ideal mechanism over the recorded part, by share of that part.
///
/// Nothing else has a curve: other outputs are not smooth enough for a table.
#[derive(Debug, Clone)]
pub struct IdealCurve {
    /// Its nodes.
    pub nodes: Arc<IdealNodes>,
    /// Each reading between the nodes, over [0, 1] of each piece.
    quintics: Vec<Vec<Quintic>>,
}

/// A piece of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    index: usize,
    /// Both ends, as shares of the recorded part.
    pub shares: [f64; 2],
}

impl IdealCurve {
    /// From value, rate and acceleration of each reading at each node.
    pub(crate) fn of_jets(span_s: f64, nodes: Arc<IdealNodes>, jets: &[Vec<[f64; 3]>]) -> Self {
        let lengths_s =
            || nodes.pieces.iter().flat_map(|&pieces| std::iter::repeat_n(nodes.length_s(span_s, pieces), pieces));
        let between = |jets: &Vec<[f64; 3]>| {
            let pairs = jets.windows(2).zip(lengths_s());
            pairs.map(|(pair, length_s)| Quintic::new(pair[0], pair[1], length_s)).collect()
        };
        let quintics = jets.iter().map(between).collect();
        Self { nodes, quintics }
    }

    /// Numbers of the table.
    pub fn numbers(&self) -> usize {
        self.quintics.iter().map(|quintics| 6 * quintics.len()).sum()
    }

    /// The value of a reading at `share` in [0, 1] of the recorded part.
    #[inline]
    pub fn value(&self, reading: usize, share: f64) -> f64 {
        let piece = self.nodes.piece(share);
        let [from, to] = piece.shares;
        self.quintic(reading, piece).value((share - from) / (to - from))
    }

    /// Value, rate and acceleration of a reading at `share` in [0, 1] of the recorded part, which lasts `span_s`.
    pub fn jet(&self, reading: usize, share: f64, span_s: f64) -> [f64; 3] {
        let piece = self.nodes.piece(share);
        let [from, to] = piece.shares;
        let (place, per_s, quintic) =
            ((share - from) / (to - from), 1.0 / ((to - from) * span_s), self.quintic(reading, piece));
        [quintic.value(place), quintic.slope(place) * per_s, quintic.curvature(place) * per_s * per_s]
    }

    /// A reading over a piece of a curve with these nodes.
    pub fn quintic(&self, reading: usize, piece: Piece) -> &Quintic {
        &self.quintics[reading][piece.index]
    }
}

#[cfg(test)]
mod tests {
    use super::{IdealCurve, IdealNodes};
    use std::convert::Infallible;
    use std::f64::consts::{PI, TAU};
    use std::sync::Arc;

    const TURN_S: f64 = 0.25;
    const MAX_ERROR_M: f64 = 1e-9;

    /// The table of a motion over one turn: its position and two derivatives over the angle of the drive.
    fn table(motion: impl Fn(f64) -> [f64; 3]) -> IdealCurve {
        let rate = TAU / TURN_S;
        let jet = |share: f64| {
            let [value, slope, curvature] = motion(TAU * share);
            [value, slope * rate, curvature * rate * rate]
        };
        let nodes = IdealNodes::new(1.0, TURN_S, MAX_ERROR_M, |share| Ok::<_, Infallible>(vec![jet(share)])).unwrap();
        let jets = vec![nodes.times_s(0.0, 1.0).map(jet).collect()];
        IdealCurve::of_jets(TURN_S, Arc::new(nodes), &jets)
    }

    /// Largest difference between a table and its motion, m.
    fn largest_error_m(curve: &IdealCurve, motion: impl Fn(f64) -> [f64; 3]) -> f64 {
        const LOOKS: usize = 20_011;
        let shares = (0..=LOOKS).map(|k| k as f64 / LOOKS as f64);
        shares.map(|share| (curve.value(0, share) - motion(TAU * share)[0]).abs()).fold(0.0, f64::max)
    }

    /// A crank of 50 mm that turns `k` times in a turn of the drive.
    fn crank(k: f64) -> impl Fn(f64) -> [f64; 3] {
        move |angle: f64| {
            let (sine, cosine) = (k * angle).sin_cos();
            [0.05 * cosine, -0.05 * k * sine, -0.05 * k * k * cosine]
        }
    }

    #[test]
    fn analytic_a_crank_that_turns_once_needs_no_more_than_96_nodes() {
        let curve = table(crank(1.0));
        assert_eq!(curve.nodes.pieces, [1; 96]);
        assert!(largest_error_m(&curve, crank(1.0)) < MAX_ERROR_M);
    }

    #[test]
    fn analytic_a_crank_that_turns_twenty_times_has_enough_nodes() {
        let curve = table(crank(20.0));
        assert!(largest_error_m(&curve, crank(20.0)) < 1.1 * MAX_ERROR_M);
        let [_, slope, curvature] = crank(20.0)(TAU * 0.31);
        let piece = curve.nodes.piece(0.31);
        let quintic = curve.quintic(0, piece);
        let [from, to] = piece.shares;
        let (tau, length_s) = ((0.31 - from) / (to - from), (to - from) * TURN_S);
        let jet = [quintic.value(tau), quintic.slope(tau) / length_s, quintic.curvature(tau) / (length_s * length_s)];
        let rate = TAU / TURN_S;
        assert!(
            (jet[1] / (slope * rate) - 1.0).abs() < 1e-6 && (jet[2] / (curvature * rate * rate) - 1.0).abs() < 1e-4
        );
    }

    #[test]
    fn analytic_a_lift_with_jumps_of_acceleration_has_nodes_beside_them() {
        // A rise of 10 mm from 50° to 110° with a cosine: the acceleration jumps at both ends.
        let rise = |angle: f64| {
            let along = ((angle - 50.0_f64.to_radians()) / 60.0_f64.to_radians()).clamp(0.0, 1.0);
            let (sine, cosine) = (PI * along).sin_cos();
            let is_rising = along > 0.0 && along < 1.0;
            let curvature = if is_rising { 0.005 * 9.0 * cosine } else { 0.0 };
            [0.005 * (1.0 - cosine), 0.005 * 3.0 * sine, curvature]
        };
        let curve = table(rise);
        let divided = curve.nodes.pieces.iter().filter(|&&pieces| pieces > 16).count();
        assert_eq!(divided, 2, "{:?}", curve.nodes.pieces);
        assert!(largest_error_m(&curve, rise) < 1.6 * MAX_ERROR_M);
    }
}
