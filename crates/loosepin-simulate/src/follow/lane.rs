//! Follower of the run of a lane, besides its numbers: tables, instants, extremes.

use super::instants::Instants;
use super::layout::FollowLayout;
use super::path::PathLayout;
use super::plan::{DeviationRange, Findings, FollowedRun};
use crate::ideal::curve::{IdealCurve, Piece};
use crate::settings::Window;
use loosepin_math::Quintic;
use loosepin_result::study::{Deviation, Reference};
use std::sync::Arc;

/// References of one run, and its findings so far.
#[derive(Debug, Clone, Default)]
pub(crate) struct LaneFollow {
    instants: Instants,
    /// End of the current piece of the curves, s.
    piece_end_s: f64,
    run: FollowedRun,
    window: Window,
    findings: Findings,
}

impl LaneFollow {
    /// An empty record.
    pub fn new(layout: &FollowLayout, run: FollowedRun, window: Window) -> Self {
        let (deviations, paths) = (layout.deviations(), layout.paths().len());
        let findings = Findings {
            at_instants: Vec::new(),
            deviations: vec![DeviationRange::NONE; deviations],
            paths: vec![[DeviationRange::NONE; 4]; paths],
            inside: vec![DeviationRange::NONE; layout.inside().count],
        };
        let instants = Instants::new(Arc::clone(&run.instants_s), layout.readings());
        Self { instants, run, window, piece_end_s: f64::INFINITY, findings }
    }

    /// Writes the numbers at the start of the recorded part, `time_s`, or at the start of a resumed run.
    pub fn begin(&mut self, layout: &FollowLayout, time_s: f64, mut set: impl FnMut(usize, f64)) {
        let begin_range = |first: usize, set: &mut dyn FnMut(usize, f64)| {
            for (k, number) in [f64::NEG_INFINITY, f64::INFINITY, 0.0, 0.0].into_iter().enumerate() {
                set(first + k, number);
            }
        };
        (0..layout.inside().count).for_each(|reading| begin_range(layout.inside().reading(reading), &mut set));
        if !layout.reduces() {
            return;
        }
        for deviation in 0..layout.deviations() {
            let first = layout.deviation(deviation);
            for (k, number) in self.reference(layout.of(deviation), time_s).into_iter().enumerate() {
                set(first + FollowLayout::BEFORE + k, number);
            }
            begin_range(first + FollowLayout::LARGEST, &mut set);
        }
        for path in layout.paths() {
            for reference in path.references() {
                let jet = self.reference(reference.curve, time_s);
                for (k, &number) in jet[3 - reference.derivatives..].iter().enumerate() {
                    set(reference.before() + k, number);
                }
            }
            (0..4).for_each(|part| begin_range(path.part(part), &mut set));
        }
        self.take_another_piece(layout, time_s, set);
    }

    /// Writes the piece of the curves that holds `time_s`, unless it is the current one.
    #[inline]
    pub fn take_piece(&mut self, layout: &FollowLayout, time_s: f64, set: impl FnMut(usize, f64)) {
        if time_s >= self.piece_end_s {
            self.take_another_piece(layout, time_s, set);
        }
    }

    fn take_another_piece(&mut self, layout: &FollowLayout, time_s: f64, mut set: impl FnMut(usize, f64)) {
        let Some(nodes) = self.run.nominal.as_ref().or(self.run.own.as_ref()).map(|curve| &curve.nodes) else {
            self.piece_end_s = f64::INFINITY;
            return;
        };
        let piece = nodes.piece(self.share(time_s));
        let [start_s, end_s] = piece.shares.map(|share| self.window.start_s + share * self.span_s());
        for deviation in 0..layout.deviations() {
            let first = layout.deviation(deviation) + FollowLayout::REFERENCE;
            set_all(first, self.quintic(layout.of(deviation), piece), &mut set);
        }
        for reference in layout.paths().iter().flat_map(PathLayout::references) {
            set_all(reference.first, self.quintic(reference.curve, piece), &mut set);
        }
        set(FollowLayout::PIECE_START, start_s);
        set(FollowLayout::PIECE_RATE, 1.0 / (end_s - start_s));
        self.piece_end_s = if piece.shares[1] < 1.0 { end_s } else { f64::INFINITY };
    }

    /// What a deviation of a reading is compared with, over a piece of the curves.
    fn quintic(&self, (reading, of): (usize, Deviation), piece: Piece) -> Quintic {
        let of_curve = |curve: &Option<Arc<IdealCurve>>| {
            curve.as_ref().map_or([f64::NAN; 6], |curve| curve.quintic(reading, piece).coefficients)
        };
        let FollowedRun { nominal, own, .. } = &self.run;
        let reference = match of.reference() {
            Reference::Zero => [0.0; 6],
            Reference::SameParts => of_curve(own),
            Reference::NominalParts => of_curve(nominal),
        };
        let coefficients = if of.has_play() {
            reference
        } else {
            // The curve is what the deviation is, not what it is compared with.
            let own = of_curve(own);
            std::array::from_fn(|k| own[k] - reference[k])
        };
        Quintic { coefficients }
    }

    /// Value, rate and acceleration at `time_s` of what a deviation is compared with.
    fn reference(&self, of: (usize, Deviation), time_s: f64) -> [f64; 3] {
        let Some(curve) = self.run.nominal.as_ref().or(self.run.own.as_ref()) else { return [0.0; 3] };
        let share = self.share(time_s);
        let piece = curve.nodes.piece(share);
        let [from, to] = piece.shares;
        let (at, length_s) = ((share - from) / (to - from), (to - from) * self.span_s());
        let quintic = self.quintic(of, piece);
        [quintic.value(at), quintic.slope(at) / length_s, quintic.curvature(at) / (length_s * length_s)]
    }

    fn span_s(&self) -> f64 {
        self.window.end_s - self.window.start_s
    }

    fn share(&self, time_s: f64) -> f64 {
        ((time_s - self.window.start_s) / self.span_s()).clamp(0.0, 1.0)
    }

    /// Steps that end from this time on need another piece of the curves or hold an instant, s.
    pub fn due_s(&self) -> f64 {
        let next_s = self.instants.next_s();
        if next_s < self.piece_end_s { next_s } else { self.piece_end_s }
    }

    /// The next instant, s; infinite where none is left.
    pub fn next_s(&self) -> f64 {
        self.instants.next_s()
    }

    /// Whether the next instant lies in a step that ends at `end_s`; any that is left does where that `is_last`.
    #[inline]
    pub fn is_within(&self, end_s: f64, is_last: bool) -> bool {
        self.instants.is_within(end_s, is_last)
    }

    /// The next instant with its index; then another one is the next.
    #[inline]
    pub fn take_next(&mut self) -> (usize, f64) {
        self.instants.take_next()
    }

    /// Takes in each `reading`, by its number, at all instants in a step between `times_s`, which passes at an even pace: share and time are one.
    #[inline]
    pub fn take_instants(&mut self, times_s: [f64; 2], is_last: bool, reading: impl Fn(usize) -> Quintic) {
        self.instants.read(times_s, is_last, reading);
    }

    /// Takes in a reading at the instant of this index.
    #[inline]
    pub fn take_instant(&mut self, index: usize, reading: usize, value: f64) {
        self.instants.set(index, reading, value);
    }

    /// Returns the findings; `get` reads the numbers of the lane.
    pub fn findings(&mut self, layout: &FollowLayout, get: impl Fn(usize) -> f64) -> Findings {
        let range = |first: usize| DeviationRange {
            largest: get(first) + 0.0,
            smallest: get(first + 1) + 0.0,
            integral: get(first + 2),
            integral_of_square: get(first + 3),
        };
        for (deviation, own) in self.findings.deviations.iter_mut().enumerate() {
            *own = range(layout.deviation(deviation) + FollowLayout::LARGEST);
        }
        for (path, own) in layout.paths().iter().zip(&mut self.findings.paths) {
            *own = [0, 1, 2, 3].map(|part| range(path.part(part)));
        }
        for (reading, own) in self.findings.inside.iter_mut().enumerate() {
            *own = range(layout.inside().reading(reading));
        }
        self.findings.at_instants = self.instants.take_values();
        std::mem::take(&mut self.findings)
    }
}

/// Puts down the coefficients of a polynomial from `first` on.
fn set_all(first: usize, polynomial: Quintic, set: &mut impl FnMut(usize, f64)) {
    for (k, coefficient) in polynomial.coefficients.into_iter().enumerate() {
        set(first + k, coefficient);
    }
}

#[cfg(test)]
mod tests {
    use super::{FollowLayout, FollowedRun, LaneFollow};
    use crate::follow::Follow;
    use crate::settings::Window;
    use loosepin_math::Quintic;
    use loosepin_mechanics::model::{BodyId, Motion, Position, Relative};

    #[test]
    fn analytic_instants_are_read_in_a_step_of_even_pace_and_at_one_in_which_time_stands_still() {
        let angle = Motion::position(Position::Angle(Relative::to_ground(BodyId(0)))).into();
        let layout = FollowLayout::new(&Follow::readings(&[angle]));
        let followed = FollowedRun { instants_s: [2.0, 2.25, 3.0].into(), ..FollowedRun::default() };
        let mut lane = LaneFollow::new(&layout, followed, Window { start_s: 2.0, end_s: 3.0 });
        // An angle of 5 rad at 2 s that grows by 4 rad/s.
        let reading = |length_s: f64| Quintic::new([5.0, 4.0, 0.0], [5.0 + 4.0 * length_s, 4.0, 0.0], length_s);
        lane.take_instants([2.0, 2.0], false, |_| reading(0.0));
        lane.take_instants([2.0, 2.5], false, |_| reading(0.5));
        // The last one counts although the step ends a little before it.
        lane.take_instants([2.5, 3.0 - 1e-15], true, |_| Quintic::new([7.0, 4.0, 0.0], [9.0, 4.0, 0.0], 0.5));
        assert_eq!(lane.findings(&layout, |_| 0.0).at_instants, [5.0, 6.0, 9.0]);
    }
}
