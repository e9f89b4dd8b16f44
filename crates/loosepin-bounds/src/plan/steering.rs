//! Statistics whose extremes steer the points of a round.

use std::collections::{BTreeMap, BTreeSet};

use crate::data::direction::Direction;
use crate::data::problem::Request;
use crate::search::models::of_points::MAX_LOCATED_TARGETS;
use loosepin_terms::Statistic;

/// A statistic, and which of its extremes are sought.
pub(super) type SoughtExtremes = (Request, Vec<Direction>);

/// Of the statistics of curves at least this many are looked at in a round: more than [`MAX_LOCATED_TARGETS`], so that they are searched as
/// those of curves.
const MIN_OF_CURVES: usize = MAX_LOCATED_TARGETS + MAX_LOCATED_TARGETS / 8;

/// Those of `searched` that steer `round`: all, but for curves with many poses every k-th pose alone, other ones each round. A pose is a
/// column beside one of which the same is searched.
///
/// A round has a few points for thousands of statistics, and those of neighbouring poses promise most at the same places. A bound
/// concedes what the models of its own statistic leave open between all points, whatever these were chosen for.
pub(super) fn in_turn(mut searched: Vec<SoughtExtremes>, round: u32) -> Vec<SoughtExtremes> {
    let mut columns: BTreeMap<usize, Vec<(Statistic, &[Direction])>> = BTreeMap::new();
    for (request, directions) in &searched {
        columns.entry(request.column).or_default().push((request.statistic, directions));
    }
    let is_pose = |&(column, own): &(&usize, &Vec<_>)| {
        let neighbours = [column.checked_sub(1), column.checked_add(1)].into_iter().flatten();
        neighbours.filter_map(|neighbour| columns.get(&neighbour)).any(|other| other == own)
    };
    let poses: Vec<(&usize, &Vec<_>)> = columns.iter().filter(is_pose).collect();
    // Whole poses, so many that none of the turns has fewer statistics.
    let of_a_pose = poses.iter().map(|(_, own)| own.len()).min().unwrap_or(1).max(1);
    let turns = (poses.len() / MIN_OF_CURVES.div_ceil(of_a_pose)).max(1);
    let is_left_out = |(pose, _): &(usize, &usize)| !(pose + round as usize).is_multiple_of(turns);
    let columns = poses.into_iter().map(|(column, _)| column).enumerate();
    let left_out: BTreeSet<usize> = columns.filter(is_left_out).map(|(_, column)| *column).collect();
    searched.retain(|(request, _)| !left_out.contains(&request.column));
    searched
}

#[cfg(test)]
mod tests {
    use super::{MIN_OF_CURVES, SoughtExtremes, in_turn};
    use crate::data::direction::Direction;
    use crate::data::problem::Request;
    use loosepin_terms::Statistic;
    use std::collections::BTreeSet;

    const OF_A_POSE: [Statistic; 3] = [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.9)];

    /// Curves with `poses` poses, followed by a single number.
    fn searched(poses: usize) -> Vec<SoughtExtremes> {
        let of = |column, statistic| (Request { column, statistic }, Direction::BOTH.to_vec());
        let curves = (0..poses).flat_map(|column| OF_A_POSE.map(|statistic| of(column, statistic)));
        curves.chain([of(poses, Statistic::Mean)]).collect()
    }

    fn columns(searched: &[SoughtExtremes]) -> BTreeSet<usize> {
        searched.iter().map(|(request, _)| request.column).collect()
    }

    #[test]
    fn identity_every_pose_has_its_turn_and_single_numbers_always() {
        let poses = 4 * MIN_OF_CURVES / 3 + 7;
        let rounds: Vec<Vec<SoughtExtremes>> = (1..=4).map(|round| in_turn(searched(poses), round)).collect();
        let mut seen = BTreeSet::new();
        for round in &rounds {
            assert!(round.len() > MIN_OF_CURVES && round.len() < MIN_OF_CURVES + 30, "{}", round.len());
            let mut own = columns(round);
            assert!(own.remove(&poses), "the single number");
            assert!(own.iter().all(|&pose| seen.insert(pose)), "a pose that had its turn");
        }
        assert_eq!(seen.len(), poses);
        // What is asked of a pose comes together, in its order.
        let all = searched(poses);
        let expected: Vec<&SoughtExtremes> =
            all.iter().filter(|own| columns(&rounds[0]).contains(&own.0.column)).collect();
        assert_eq!(rounds[0].iter().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn identity_a_round_never_has_fewer_statistics_whatever_is_asked_of_a_pose() {
        for of_a_pose in [1, 7, 85] {
            let statistics = (1..=of_a_pose).map(|k| Statistic::Quantile(f64::from(k) / 100.0));
            let of = |column| statistics.clone().map(move |statistic| Request { column, statistic });
            for poses in [11, 124, 700] {
                let all: Vec<SoughtExtremes> =
                    (0..poses).flat_map(of).map(|request| (request, Direction::BOTH.to_vec())).collect();
                for round in 1..4 {
                    let found = in_turn(all.clone(), round).len();
                    assert!(found >= MIN_OF_CURVES.min(all.len()), "{of_a_pose} of {poses}: {found}");
                }
            }
        }
    }

    #[test]
    fn identity_few_statistics_are_looked_at_in_every_round() {
        let few = searched(2 * MIN_OF_CURVES / 3 - 1);
        for round in 1..5 {
            assert_eq!(in_turn(few.clone(), round), few);
        }
    }
}
