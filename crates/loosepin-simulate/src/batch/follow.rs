//! What is followed in the runs on lanes.

use super::{Batch, lanes_of};
use crate::core::Core;
use crate::follow::{Findings, FollowLayout, InsideLayout, LOBATTO, extremes_within};
use crate::lane::LaneRun;
use crate::memory::LaneLayout;
use crate::reads::ReadLayout;
use loosepin_math::Quintic;

impl Batch<'_> {
    /// Lets the recorded part of a run begin, or go on, at `time_s`.
    pub(super) fn begin_record(&mut self, lane: usize, time_s: f64) {
        let Some(run) = &mut self.runs[lane] else { return };
        run.is_recorded = true;
        run.paths_before = self.core.friction_paths(lane);
        self.core.set_number(lane, LaneLayout::IS_RECORDED, 1.0);
        let core = &mut self.core;
        run.follow.begin(&self.follow, time_s, |place, number| core.set_followed(lane, place, number));
        core.set_number(lane, LaneLayout::DUE, run.follow.due_s());
    }

    /// Follows the accepted steps at hand, those of them that are recorded; another piece of the curves and instants may be `due`.
    pub(super) fn follow(&mut self, accepted: u32, due: u32) {
        let recorded = self.core.flags(LaneLayout::IS_RECORDED);
        if accepted & recorded == 0 {
            return;
        }
        if self.follow.inside().count > 0 {
            self.look_inside(accepted & recorded);
        }
        let Self { core, runs, follow: layout, .. } = self;
        if layout.readings() == 0 {
            return;
        }
        if layout.reduces() {
            for (lane, run) in of_lanes(runs, due & recorded) {
                let end_s = core.end_read(lane, ReadLayout::TIME);
                run.follow.take_piece(layout, end_s, |place, number| core.set_followed(lane, place, number));
            }
            core.follow();
            self.take_extremes(accepted & recorded);
        }
        let left = self.look_at_even_pace(due & recorded);
        self.look_at_instants(left);
        let Self { core, runs, .. } = self;
        for (lane, run) in of_lanes(runs, due & recorded) {
            core.set_number(lane, LaneLayout::DUE, run.follow.due_s());
        }
    }

    /// Takes in the values inside the accepted steps at hand that are `recorded`.
    fn look_inside(&mut self, recorded: u32) {
        self.core.look_inside();
        let evaluations = self.core.pass.stepper.evaluations_for_dense();
        for lane in lanes_of(recorded) {
            self.core.add_evaluations(lane, evaluations);
        }
        for lane in lanes_of(self.core.followed_flags(FollowLayout::IS_PEAK) & recorded) {
            for reading in 0..self.follow.inside().count {
                self.take_peak(lane, reading);
            }
        }
    }

    /// Locates the extremes of a reading inside the step at hand of a lane, where its values allow new ones.
    fn take_peak(&mut self, lane: usize, reading: usize) {
        let Self { core, runs, view, view_projection, view_state, viewed, .. } = self;
        let (Some(run), Some(read)) = (&runs[lane], self.inside.get(reading)) else { return };
        let mut point = 0;
        let points = LOBATTO.map(|(share, _)| {
            point += 1;
            (share, core.inside(lane, point - 1, reading))
        });
        let largest = self.follow.inside().reading(reading);
        let known = [core.followed(lane, largest), core.followed(lane, largest + 1)];
        let value = |share: f64| {
            if *viewed != run.number {
                *viewed = run.number;
                view.dynamics.sample_mut().clone_from(&run.sample);
            }
            for (contact, state) in view.states.iter_mut().enumerate() {
                *state = core.contact(lane, contact).0;
            }
            core.interpolate(lane, share, view_state);
            let time_s = view_state[view.layout.time()];
            if let Some(projection) = view_projection {
                projection.hold(view, time_s, view_state);
            }
            view.evaluate(time_s, view_state);
            read.value(&run.arms, &view.dynamics)
        };
        let found = extremes_within(&points, InsideLayout::limits(&points), known, value);
        for (place, extreme) in found.into_iter().enumerate() {
            core.set_followed(lane, largest + place, extreme);
        }
    }

    /// Locates the extremes of the steps that may hold new ones.
    fn take_extremes(&mut self, recorded: u32) {
        let Self { core, follow: layout, .. } = self;
        for lane in lanes_of(core.followed_flags(FollowLayout::IS_EXTREME) & recorded) {
            let set = |core: &mut Core<'_>, place, extreme| core.set_followed(lane, place, extreme);
            layout.take_extremes(core, |core, place| core.followed(lane, place), set);
        }
    }

    /// Reads at the instants in steps that pass at an even pace, as all do but those of some contacts: each may hold many, and nothing is to be
    /// solved. Gives the lanes that are left.
    fn look_at_even_pace(&mut self, looking: u32) -> u32 {
        let Self { core, runs, follow: layout, .. } = self;
        let mut left = looking;
        for (lane, run) in of_lanes(runs, looking) {
            let time = core.jets(lane, ReadLayout::TIME).map(|end| end.jet);
            if time.iter().all(|[_, pace, change]| (*pace, *change) == (1.0, 0.0)) {
                let (length, is_last) = (core.number(lane, LaneLayout::STEP), run.is_at_end());
                let reading = |reading| {
                    let [start, end] = core.jets(lane, core.pass.reads.output(reading)).map(|end| end.jet);
                    Quintic::new(start, end, length)
                };
                run.follow.take_instants(time.map(|[time_s, ..]| time_s), is_last, (0..layout.readings()).map(reading));
                left &= !(1 << lane);
            }
        }
        left
    }

    /// Puts down the instants that lie in the steps at hand, of each lane one after the other; where they fill all lanes, reads at them.
    fn look_at_instants(&mut self, looking: u32) {
        for lane in lanes_of(looking) {
            let end_s = self.core.end_read(lane, ReadLayout::TIME);
            while let Some((index, instant_s)) = self.next_instant(lane, end_s) {
                self.core.await_instant(self.waiting.len(), lane, instant_s);
                self.waiting.push((lane, index));
                if self.waiting.len() == self.runs.len() {
                    self.look_at_waiting();
                }
            }
        }
    }

    /// The next instant within the step at hand of a lane that ends at `end_s`, and its number.
    fn next_instant(&mut self, lane: usize, end_s: f64) -> Option<(usize, f64)> {
        let run = self.runs[lane].as_mut()?;
        let is_last = run.is_at_end();
        run.follow.next_instant(end_s, is_last)
    }

    /// Reads at the instants that wait. Whoever ends a run does so before.
    pub(super) fn look_at_waiting(&mut self) {
        let Self { core, runs, follow: layout, waiting, .. } = self;
        if waiting.is_empty() {
            return;
        }
        core.look();
        for (place, (lane, index)) in waiting.drain(..).enumerate() {
            if let Some(run) = &mut runs[lane] {
                run.follow.take_instant(index, (0..layout.readings()).map(|reading| core.looked(place, reading)));
            }
        }
    }

    /// Gives out what was found in the run of a lane that is over.
    pub(super) fn findings(&mut self, lane: usize) -> Findings {
        self.look_at_waiting();
        let Self { core, runs, follow: layout, .. } = self;
        let run = runs[lane].as_mut();
        run.map_or_else(Findings::default, |run| run.follow.findings(layout, |place| core.followed(lane, place)))
    }
}

/// The runs on the flagged lanes.
fn of_lanes(runs: &mut [Option<LaneRun>], lanes: u32) -> impl Iterator<Item = (usize, &mut LaneRun)> {
    let mut rest = runs;
    let mut passed = 0;
    lanes_of(lanes).filter_map(move |lane| {
        let (run, behind) = std::mem::take(&mut rest).get_mut(lane - passed..)?.split_first_mut()?;
        (rest, passed) = (behind, lane + 1);
        Some((lane, run.as_mut()?))
    })
}
