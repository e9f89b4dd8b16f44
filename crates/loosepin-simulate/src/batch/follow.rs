//! What is followed in the runs on lanes.

use super::Batch;
use crate::follow::{Findings, FollowLayout};
use crate::lane::LaneRun;
use crate::reads::ReadLayout;
use loosepin_math::Quintic;

impl Batch<'_> {
    /// Lets the recorded part of a run begin, or go on, at `time_s`.
    pub(super) fn begin_record(&mut self, lane: usize, time_s: f64) {
        let Some(run) = &mut self.runs[lane] else { return };
        run.is_recorded = true;
        let core = &mut self.core;
        run.follow.begin(&self.follow, time_s, |place, number| core.set_followed(lane, place, number));
    }

    /// Follows the accepted steps at hand, those of them that are recorded.
    pub(super) fn follow(&mut self, accepted: u32) {
        let Self { core, runs, .. } = self;
        if core.pass.follow.readings() == 0 {
            return;
        }
        let mut recorded = 0;
        for (lane, run) in runs.iter().enumerate() {
            let is_recorded = accepted >> lane & 1 != 0 && run.as_ref().is_some_and(|run| run.is_recorded);
            recorded |= u32::from(is_recorded) << lane;
        }
        if recorded == 0 {
            return;
        }
        if core.pass.follow.deviations() > 0 {
            self.follow_deviations(recorded);
        }
        self.look_at_instants(recorded);
    }

    fn follow_deviations(&mut self, recorded: u32) {
        let Self { core, runs, follow: layout, .. } = self;
        for (lane, run) in of_lanes(runs, recorded) {
            let end_s = core.end_read(lane, ReadLayout::TIME);
            run.follow.take_piece(layout, end_s, |place, number| core.set_followed(lane, place, number));
        }
        core.follow(recorded);
        for (lane, run) in of_lanes(runs, recorded) {
            if !(core.followed(lane, FollowLayout::IS_EXTREME) > 0.5) {
                continue;
            }
            for deviation in 0..layout.deviations() {
                let first = layout.deviation(deviation);
                let polynomial = std::array::from_fn(|k| core.followed(lane, first + FollowLayout::POLYNOMIAL + k));
                let [largest, smallest] = run.follow.take_extremes(deviation, &Quintic { coefficients: polynomial });
                core.set_followed(lane, first + FollowLayout::LARGEST, largest);
                core.set_followed(lane, first + FollowLayout::SMALLEST, smallest);
            }
        }
    }

    /// Reads at the instants that lie in the steps at hand, in all lanes at once, one instant of each lane after the other.
    fn look_at_instants(&mut self, recorded: u32) {
        let Self { core, runs, follow: layout, .. } = self;
        let mut looking = recorded;
        while looking != 0 {
            let mut found = 0;
            for (lane, run) in of_lanes(runs, looking) {
                let end_s = core.end_read(lane, ReadLayout::TIME);
                let is_last = run.reaches_stop && run.stop_s == run.window.end_s;
                if let Some(instant_s) = run.follow.instant_s(end_s, is_last) {
                    core.set_followed(lane, FollowLayout::INSTANT, instant_s);
                    found |= 1 << lane;
                }
            }
            looking = found;
            if looking == 0 {
                return;
            }
            core.look();
            for (lane, run) in of_lanes(runs, looking) {
                let values = (0..layout.readings()).map(|reading| core.followed(lane, FollowLayout::VALUES + reading));
                run.follow.take_instant(values);
            }
        }
    }

    /// Gives out what was found in the run of a lane that is over.
    pub(super) fn findings(&mut self, lane: usize) -> Findings {
        let Self { core, runs, follow: layout, .. } = self;
        let run = runs[lane].as_mut();
        run.map_or_else(Findings::default, |run| run.follow.findings(layout, |place| core.followed(lane, place)))
    }
}

/// The runs on the flagged lanes.
fn of_lanes(runs: &mut [Option<LaneRun>], lanes: u32) -> impl Iterator<Item = (usize, &mut LaneRun)> {
    let flagged = runs.iter_mut().enumerate().filter(move |(lane, _)| lanes >> lane & 1 != 0);
    flagged.filter_map(|(lane, run)| Some((lane, run.as_mut()?)))
}
