//! Implicit steps, and the motion inside of them.
//!
//! ```text
//! p(θ), w(θ)      cubics through both ends of the step, of q with the rates there, of the rates with the accelerations there
//! (μ - J) x = (0, a(p, w) - ẇ),   (q, v) = (p, w) + x,   μ = γ/h
//! ```
//!
//! Stiff directions are in balance at the ends of a step. Inside they are off by the error of p, of which their stiffness ω² makes an acceleration; x takes that
//! error off: a(q, v) comes to ẇ where ω² is far above μ², and q stays p elsewhere. So forces and accelerations inside err by some thousandths where the cubics alone err by more (measured/integrators.md). A polynomial of higher degree
//! for p, with accelerations at its ends, is worse: their errors in stiff directions times h² become displacements.

use crate::lanes::memory::{LaneLayout, MemoryBlocks};
use crate::lanes::pass::Pass;
use crate::stepping::motion::Motion;
use crate::stepping::projection::Projection;
use loosepin_math::integrate::Radau;

/// Corrections at an instant: stiff directions have turned a little since the factors were taken, and each leaves some hundredths of what was off.
const CORRECTIONS: u64 = 2;

/// Implicit steps of a run.
pub struct Implicit {
    /// The method.
    pub radau: Radau,
    /// Whether the current step is one of it.
    pub is_at_hand: bool,
    /// The last look inside the current step: its share and the corrected coordinates and rates there.
    looked: Option<(f64, Vec<f64>)>,
}

impl Implicit {
    /// No step yet.
    pub fn new(radau: Radau) -> Self {
        Self { radau, is_at_hand: false, looked: None }
    }

    /// Begins another attempt, an implicit one or not.
    pub fn begin(&mut self, is_at_hand: bool) {
        (self.is_at_hand, self.looked) = (is_at_hand, None);
        if !is_at_hand {
            self.radau.restart();
        }
    }

    /// Corrects the state at `share` of the current step, which is that of the cubics; gives the evaluations that it took.
    pub fn correct(
        &mut self,
        (pass, motion, projection): (&Pass, &mut Motion<'_, f64>, Option<&mut Projection<f64>>),
        named: &MemoryBlocks<'_, f64>,
        share: f64,
        state: &mut [f64],
    ) -> u64 {
        let n = pass.layout.freedoms;
        if let Some((known, corrected)) = &self.looked
            && *known == share
        {
            state[..2 * n].copy_from_slice(corrected);
            return 0;
        }
        let time_s = state[pass.layout.time()];
        if let Some(projection) = projection {
            projection.hold(motion, time_s, state);
        }
        let (rows, step_s) = (&named.rows, named.lane[LaneLayout::STEP]);
        let end = pass.stepper.end_row() * pass.layout.length();
        for _ in 0..CORRECTIONS {
            motion.evaluate(time_s, state);
            let found = motion.dynamics.accelerations();
            let difference: Vec<f64> = (n..2 * n)
                .zip(found)
                .map(|(rate, found)| {
                    let change = (rows.end[rate] - rows.start[rate]) / step_s;
                    found - slope_of_cubic(change, [rows.stages[rate], rows.stages[end + rate]], share)
                })
                .collect();
            for (value, change) in state.iter_mut().zip(self.radau.stiff_share(&difference)) {
                *value += change;
            }
        }
        self.looked = Some((share, state[..2 * n].to_vec()));
        CORRECTIONS
    }
}

/// Parts of a step between which the gaps of contacts that may meet another wall are looked at.
const PARTS: u32 = 16;
/// Error and growth of a step that is too long for its contacts.
pub const TOO_LONG: (f64, f64) = (2.0, 0.5);

/// Whether a contact closes and opens again inside a step without any sign of it in the gap and its derivatives at both ends: in a slot, in a guide with ends
/// and between worn surfaces another wall may be met there, and implicit steps are long enough to miss it.
pub fn hides_contact(
    pass: &Pass,
    motion: &mut Motion<'_, f64>,
    named: &mut MemoryBlocks<'_, f64>,
    state: &mut [f64],
) -> bool {
    let meets_walls = |contact: &usize| {
        let play = motion.dynamics.sample().play_of(*contact);
        play.shape.has_walls() || play.foundation.is_some()
    };
    let contacts: Vec<usize> = (0..motion.states.len()).filter(meets_walls).collect();
    if contacts.is_empty() {
        return false;
    }
    pass.stepper.prepare_cubic(&mut named.rows, named.lane[LaneLayout::STEP]);
    let at = |reads: &[f64]| contacts.iter().map(|contact| reads[pass.reads.gap(*contact)]).collect::<Vec<f64>>();
    let mut rows = vec![at(named.start_reads)];
    for part in 1..PARTS {
        let share = f64::from(part) / f64::from(PARTS);
        for (i, value) in state.iter_mut().enumerate() {
            let change = pass.stepper.dense_change(i, share, |place| named.rows.stages[place]);
            *value = named.rows.start[i] + change;
        }
        motion.set_state(state[pass.layout.time()], state);
        rows.push(contacts.iter().map(|contact| motion.dynamics.gap(*contact).gap[0]).collect());
    }
    rows.push(at(named.end_reads));
    // One that is closed at the end is seen there.
    (0..contacts.len()).any(|k| {
        rows[rows.len() - 1][k] < 0.0 && rows.windows(3).any(|three| top([three[0][k], three[1][k], three[2][k]]) > 0.0)
    })
}

/// Top of the parabola through three values at equal distances where the middle one is the largest; else the middle one.
fn top([before, middle, after]: [f64; 3]) -> f64 {
    let (slope, bend) = (0.5 * (after - before), before + after - 2.0 * middle);
    if middle >= before.max(after) && bend < 0.0 { middle - 0.5 * slope * slope / bend } else { middle }
}

/// Slope at `share` of the cubic over an interval with this mean slope and these slopes at its ends.
fn slope_of_cubic(mean: f64, [first, last]: [f64; 2], share: f64) -> f64 {
    let rest = 1.0 - share;
    first * rest * (1.0 - 3.0 * share) + last * share * (3.0 * share - 2.0) + 6.0 * mean * share * rest
}

#[cfg(test)]
mod tests {
    use super::{slope_of_cubic, top};

    /// 3 - 2 (t - 0.2)² at -1, 0 and 1.
    #[test]
    fn analytic_top_of_a_parabola() {
        let value = |t: f64| 3.0 - 2.0 * (t - 0.2) * (t - 0.2);
        assert!((top([value(-1.0), value(0.0), value(1.0)]) - 3.0).abs() < 1e-14);
        assert_eq!(top([0.3, 0.2, 0.1]), 0.2);
    }

    /// t³ - 2 t² over [0.3, 1.1].
    #[test]
    fn analytic_slope_of_a_cubic() {
        let (value, slope) = (|t: f64| t * t * (t - 2.0), |t: f64| t * (3.0 * t - 4.0));
        let mean = (value(1.1) - value(0.3)) / 0.8;
        for share in [0.0, 0.2, 0.7, 1.0] {
            let found = slope_of_cubic(mean, [slope(0.3), slope(1.1)], share);
            assert!((found - slope(0.3 + 0.8 * share)).abs() < 1e-14, "{share}: {found}");
        }
    }
}
