//! The exact worst case.

use crate::accuracy::dead_centre::DeadCentre;
use crate::accuracy::error::AccuracyError;
use crate::accuracy::extreme::{Extreme, SearchOptions};
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::search::{Climb, random_starts};
use crate::output::SpatialOutput;
use crate::stop::{IsStopped, NEVER};

/// The largest and the smallest deviation found.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstCase {
    /// The largest.
    pub largest: Extreme,
    /// The smallest.
    pub smallest: Extreme,
    /// Starts of each search.
    pub starts: usize,
    /// How many of them ended at the largest, and at the smallest, to 1e-6 of it or of the sum of all plays.
    pub agreeing: [usize; 2],
    /// Conditions that the plays must meet together. With 0 all starts of well-behaved mechanisms end alike; with more it is a search among
    /// many extremes, and the numbers are the largest and the smallest found.
    pub conditions: usize,
    /// Whether a place of the journals was found that takes the loops to a dead centre. The extremes are then the largest found on the branch of
    /// the ideal position and on the other one that begins there.
    pub reaches_dead_centre: bool,
}

/// Extremes that are nearer to each other than this share count as one.
const AGREEMENT: f64 = 1e-6;

impl PoseAccuracy<'_> {
    /// The exact worst case of an output: the largest and the smallest deviation over all places of the journals within their play, loops
    /// closed exactly, drives held. Both are reached by their witness; that no place makes more is not proven.
    ///
    /// Each search goes from the gradient g at the closed position to the place that is best for it (each block on its border along g; with
    /// redundant rows under h·p = 0, brought back to it exactly), and again. Steps that do not improve are shortened. Extremes are local, so
    /// it starts from several places.
    ///
    /// # Errors
    ///
    /// Those of [`Self::gains`], and [`AccuracyError::NoPlace`] if no start closes the loops.
    pub fn worst_case(&self, output: &SpatialOutput, options: &SearchOptions) -> Result<WorstCase, AccuracyError> {
        self.worst_case_until(output, options, NEVER)
    }

    /// The same, until it is stopped: that is asked before each start.
    ///
    /// # Errors
    ///
    /// As for [`Self::worst_case`]; [`AccuracyError::Stopped`].
    pub fn worst_case_until(
        &self,
        output: &SpatialOutput,
        options: &SearchOptions,
        is_stopped: IsStopped,
    ) -> Result<WorstCase, AccuracyError> {
        let gains = self.gains(output)?;
        let scaled = self.scaled_gains(&gains);
        let reach = self.unconditioned_worst(&gains);
        let mut objectives = vec![scaled.clone()];
        // Where the loops hardly follow, journals that take them away from there allow the others more.
        let weakest = self.weakest_gains();
        objectives.push(weakest.iter().map(|gain| -gain).collect());
        objectives.push(weakest);
        objectives.extend(random_starts(self.play_set().variables(), options));
        let dead_centre = self.dead_centre();
        let find = |sign: f64| {
            let climb = Climb { accuracy: self, output, sign };
            let mut ends: Vec<Extreme> = Vec::new();
            ends.extend(climb.climb_from_middle());
            ends.extend(options.starts_m.iter().filter_map(|start| climb.climb_from_variables(start)));
            for (number, objective) in objectives.iter().enumerate() {
                if is_stopped() {
                    return Err(AccuracyError::Stopped);
                }
                let direction = if number == 0 { sign } else { 1.0 };
                let objective: Vec<f64> = objective.iter().map(|gain| gain * direction).collect();
                ends.extend(climb.climb_from_objective(&objective));
            }
            if let Some(DeadCentre { scaled, other: Some(other) }) = &dead_centre {
                ends.extend(climb.climb(scaled.clone(), other.start()));
            }
            let best = ends.iter().max_by(|a, b| (sign * a.deviation).total_cmp(&(sign * b.deviation))).cloned();
            let best = best.ok_or(AccuracyError::NoPlace)?;
            let tolerance = AGREEMENT * best.deviation.abs().max(reach);
            let agreeing = ends.iter().filter(|end| (end.deviation - best.deviation).abs() <= tolerance).count();
            Ok((best, agreeing))
        };
        let (largest, of_largest) = find(1.0)?;
        let (smallest, of_smallest) = find(-1.0)?;
        Ok(WorstCase {
            largest,
            smallest,
            starts: objectives.len()
                + 1
                + options.starts_m.len()
                + usize::from(dead_centre.as_ref().is_some_and(|own| own.other.is_some())),
            agreeing: [of_largest, of_smallest],
            conditions: self.conditions(),
            reaches_dead_centre: dead_centre.is_some(),
        })
    }
}
