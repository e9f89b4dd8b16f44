//! Followed quantities of the runs on lanes.

use super::Batch;
use crate::follow::{Findings, FollowLayout, InsideLayout, LOBATTO, LaneFollow, extremes_within};
use crate::lanes::core::{Core, PendingInstant, lanes_of};
use crate::lanes::memory::LaneLayout;
use crate::lanes::reads::ReadLayout;

/// Lanes over a root with an instant in the current step from which on these are read in place, in all lanes: the others are computed in vain,
/// and that costs less than putting them by.
const FEWEST_IN_PLACE: u32 = 8;

impl Batch<'_> {
    /// Begins, or resumes, the recorded part of a run at `time_s`.
    pub(super) fn begin_record(&mut self, lane: usize, time_s: f64) {
        let Some(run) = &mut self.runs[lane] else { return };
        run.is_recorded = true;
        self.recorded |= 1 << lane;
        run.paths_before = self.core.friction_paths(lane);
        self.core.set_number(lane, LaneLayout::IS_RECORDED, 1.0);
        let Self { core, follows, follow: layout, .. } = self;
        follows[lane].begin(layout, time_s, |place, number| core.set_followed(lane, place, number));
        core.set_number(lane, LaneLayout::DUE, follows[lane].due_s());
        if layout.readings() > 0 {
            core.set_followed(lane, FollowLayout::INSTANT, follows[lane].next_s());
        }
    }

    /// Follows the current accepted steps, as far as they are recorded. Of the `watched` ones it is asked here whether another piece of the
    /// curves or an instant is due in them: their ends may have been moved.
    pub(super) fn follow(&mut self, accepted: u32, watched: u32) {
        let recorded = self.recorded;
        if accepted & recorded == 0 {
            return;
        }
        if self.follow.inside().count > 0 {
            self.look_inside(accepted & recorded);
        }
        if self.follow.readings() == 0 {
            return;
        }
        let unwatched = accepted & recorded & self.core.flags(LaneLayout::IS_DUE) & !watched;
        let mut due = unwatched;
        for lane in lanes_of(accepted & recorded & watched) {
            let is_before = self.core.end_read(lane, ReadLayout::TIME) < self.core.number(lane, LaneLayout::DUE);
            due |= u32::from(!is_before) << lane;
        }
        due |= self.ending & accepted & recorded;
        let Self { core, follows, follow: layout, .. } = self;
        if layout.reduces() {
            for lane in lanes_of(due) {
                let end_s = core.end_read(lane, ReadLayout::TIME);
                follows[lane].take_piece(layout, end_s, |place, number| core.set_followed(lane, place, number));
            }
            core.follow();
            self.take_extremes(accepted & recorded);
        }
        // Without curves nothing else is due than instants.
        let is_instant = if self.follow.reduces() { 0 } else { unwatched };
        self.look_at_instants(due, is_instant);
    }

    /// Records the values inside the current accepted steps that are `recorded`.
    fn look_inside(&mut self, recorded: u32) {
        let evaluations = self.core.evaluations_for_dense() + self.core.look_inside();
        for lane in lanes_of(recorded) {
            self.core.add_evaluations(lane, evaluations);
        }
        for lane in lanes_of(self.core.followed_flags(FollowLayout::IS_PEAK) & recorded) {
            for reading in 0..self.follow.inside().count {
                self.take_peak(lane, reading);
            }
        }
    }

    /// Locates the extremes of a reading inside the current step of a lane, where its values allow new ones.
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
        let mut evaluations = 0;
        let value = |share: f64| {
            if *viewed != run.number {
                *viewed = run.number;
                view.dynamics.sample_mut().clone_from(&run.sample);
            }
            for (contact, state) in view.states.iter_mut().enumerate() {
                *state = core.contact(lane, contact).0;
            }
            core.interpolate(lane, share, view_state);
            evaluations += core.correct(share, view_state);
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
        core.add_evaluations(lane, evaluations);
    }

    /// Locates the extremes of the steps that may hold new ones.
    fn take_extremes(&mut self, recorded: u32) {
        let Self { core, follow: layout, .. } = self;
        for lane in lanes_of(core.followed_flags(FollowLayout::IS_EXTREME) & recorded) {
            let set = |core: &mut Core<'_>, place, extreme| core.set_followed(lane, place, extreme);
            layout.take_extremes(core, |core, place| core.followed(lane, place), set);
        }
    }

    /// Reads at the instants in the current steps. In steps that pass at an even pace, as all do but those over a root, nothing is to be solved,
    /// and each may hold many: those are read at once. Of the others the first ones are read in place where there are many of them; what is
    /// left waits until it fills all lanes. Of some lanes that are `due` it is known that it `is_instant` what is due.
    fn look_at_instants(&mut self, due: u32, is_instant: u32) {
        if due == 0 {
            return;
        }
        let Self { core, follows, follow: layout, waiting, ending, .. } = self;
        let (is_last, lanes) = (|lane: usize| *ending >> lane & 1 != 0, follows.len());
        let is_within = |core: &Core<'_>, follow: &LaneFollow, lane: usize| {
            u32::from(follow.is_within(core.end_read(lane, ReadLayout::TIME), is_last(lane))) << lane
        };
        let asked = lanes_of(due & !is_instant);
        let within = asked.fold(is_instant, |within, lane| within | is_within(core, &follows[lane], lane));
        if within != 0 {
            core.spread();
        }
        let [values, instant] =
            [FollowLayout::VALUES, FollowLayout::INSTANT].map(|place| core.place_of_followed(place));
        let set_due = |core: &mut Core<'_>, follow: &LaneFollow, lane: usize| {
            core.set_number(lane, LaneLayout::DUE, follow.due_s());
            core.set_number(lane, instant, follow.next_s());
        };
        for lane in lanes_of(within & !core.over_root()) {
            let times_s = [core.start_read(lane, ReadLayout::TIME), core.end_read(lane, ReadLayout::TIME)];
            follows[lane].take_instants(times_s, is_last(lane), |reading| core.reading(lane, reading));
            set_due(core, &follows[lane], lane);
        }
        let mut left = within & core.over_root();
        if left.count_ones() >= FEWEST_IN_PLACE {
            core.look_in_place();
            for lane in lanes_of(std::mem::take(&mut left)) {
                let follow = &mut follows[lane];
                let (index, _) = follow.take_next();
                for reading in 0..layout.readings() {
                    follow.take_instant(index, reading, core.number(lane, values + reading));
                }
                left |= is_within(core, follow, lane);
                set_due(core, follow, lane);
            }
        }
        let mut before = waiting.len();
        while left != 0 {
            for lane in lanes_of(std::mem::take(&mut left)) {
                if waiting.len() == lanes {
                    core.add_pending_instants(before, &waiting[before..]);
                    look_at_all(core, follows, layout, waiting);
                    before = 0;
                }
                let follow = &mut follows[lane];
                let (index, instant_s) = follow.take_next();
                waiting.push(PendingInstant { lane, index, instant_s });
                left |= is_within(core, follow, lane);
                set_due(core, follow, lane);
            }
        }
        core.add_pending_instants(before, &waiting[before..]);
        for lane in lanes_of(due & !within) {
            set_due(core, &follows[lane], lane);
        }
    }

    /// Reads at the instants that wait. Whoever ends a run does so before.
    pub(super) fn look_at_waiting(&mut self) {
        let Self { core, follows, follow: layout, waiting, .. } = self;
        look_at_all(core, follows, layout, waiting);
    }

    /// Returns the findings in the run of a lane that is over.
    pub(super) fn findings(&mut self, lane: usize) -> Findings {
        self.look_at_waiting();
        let Self { core, follows, follow: layout, .. } = self;
        follows[lane].findings(layout, |place| core.followed(lane, place))
    }
}

/// Reads at all instants that wait.
fn look_at_all(
    core: &mut Core<'_>,
    follows: &mut [LaneFollow],
    layout: &FollowLayout,
    waiting: &mut Vec<PendingInstant>,
) {
    if waiting.is_empty() {
        return;
    }
    core.look(waiting.len());
    for reading in 0..layout.readings() {
        for (&PendingInstant { lane, index, .. }, value) in waiting.iter().zip(core.looked(reading)) {
            follows[lane].take_instant(index, reading, *value);
        }
    }
    waiting.clear();
}
