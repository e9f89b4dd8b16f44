//! The ideal motion of one sample over the recorded turns, as a table that is read at any instant.

use loosepin_math::Quintic;
use loosepin_mechanics::mechanism::SampleError;
use loosepin_simulate::{Arms, Column, IdealReference};

/// Nodes a turn: between them a polynomial of degree five errs by (2πk/96)⁶/46080 of the k-th harmonic of the motion: 2e-12 of
/// the first, 2e-9 of the third, which is a few hundredths of the first.
const NODES_PER_TURN: usize = 96;

/// Positions and angles of an ideal mechanism over the recorded part, by share of that part.
///
/// Only outputs that are positions have a curve: the others are not smooth enough for a table.
#[derive(Debug, Clone)]
pub struct IdealCurve {
    /// Duration of the recorded part for this sample, s.
    span_s: f64,
    intervals: usize,
    /// Value, rate and acceleration of each output at each node; empty for outputs that are no positions.
    jets: Vec<Vec<[f64; 3]>>,
}

impl IdealCurve {
    /// Follows `reference` from `start_s` on for `turns` turns of duration `turn_s`.
    ///
    /// # Errors
    /// The loops cannot be closed on the way.
    pub fn new(
        reference: &mut IdealReference<'_>,
        outputs: &[Column],
        is_used: &[bool],
        arms: &Arms,
        start_s: f64,
        span_s: f64,
        turns: f64,
    ) -> Result<Self, SampleError> {
        let intervals = (turns * NODES_PER_TURN as f64).ceil().max(1.0) as usize;
        let mut jets = vec![Vec::new(); outputs.len()];
        for node in 0..=intervals {
            let time_s = start_s + span_s * node as f64 / intervals as f64;
            for (k, output) in outputs.iter().enumerate() {
                if is_used[k] && output.reading.is_position() {
                    jets[k].push(reference.jet(&output.reading, arms, time_s)?);
                }
            }
        }
        Ok(Self { span_s, intervals, jets })
    }

    /// The value of `output` at `share` in [0, 1] of the recorded part.
    #[inline]
    pub fn value(&self, output: usize, share: f64) -> f64 {
        let (quintic, tau, _) = self.piece(output, share);
        quintic.value(tau)
    }

    /// Value and first two time derivatives of `output` at `share` in [0, 1] of the recorded part.
    #[inline]
    pub fn jet(&self, output: usize, share: f64) -> [f64; 3] {
        let (quintic, tau, h) = self.piece(output, share);
        [quintic.value(tau), quintic.slope(tau) / h, quintic.curvature(tau) / (h * h)]
    }

    #[inline]
    fn piece(&self, output: usize, share: f64) -> (Quintic, f64, f64) {
        let place = share * self.intervals as f64;
        let node = (place as usize).min(self.intervals - 1);
        let jets = &self.jets[output];
        let h = self.span_s / self.intervals as f64;
        (Quintic::new(jets[node], jets[node + 1], h), place - node as f64, h)
    }
}
