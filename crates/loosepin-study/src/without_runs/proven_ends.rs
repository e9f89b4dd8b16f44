//! What is proven without dynamics of the numbers that a study bounds.

use super::judge::{over, proven_over_turn};
use crate::file::{Reduction, Study};
use crate::response::columns::{ColumnPlan, Location};
use loosepin_simulate::accuracy::DeviationQuestion;

/// Positions in a turn: every degree, as by `loosepin motion`.
const POSITIONS: usize = 360;

/// Ends of each of `columns` that nothing passes without dynamics; `None` where nothing is proven, as of what is no position.
pub(crate) fn proven_ends_si(study: &Study, plan: &ColumnPlan, columns: &[usize]) -> Vec<Option<[f64; 2]>> {
    let mut questions: Vec<DeviationQuestion> = Vec::new();
    let asked: Vec<Option<usize>> = columns
        .iter()
        .map(|&column| {
            let column = &plan.columns[column];
            let reading = plan.outputs[column.output].seen.position()?;
            let question = DeviationQuestion { reading, of: column.deviation };
            Some(questions.iter().position(|known| *known == question).unwrap_or_else(|| {
                questions.push(question);
                questions.len() - 1
            }))
        })
        .collect();
    let proven = (!questions.is_empty()).then(|| proven_over_turn(study, POSITIONS, &questions)).flatten();
    let ends_si = |(column, asked): (&usize, Option<usize>)| {
        let own = &proven.as_ref()?[asked?];
        let ends_si = match plan.columns[*column].spot {
            Location::Pose { angle_rad, .. } => over(&own.drive_angle_rad, &own.proven_si, Some(angle_rad)),
            Location::Reduced(reduction) => reduced(reduction, over(&own.drive_angle_rad, &own.proven_si, None)),
        };
        ends_si.iter().all(|end| end.is_finite()).then_some(ends_si)
    };
    columns.iter().zip(asked).map(ends_si).collect()
}

/// Between what a number of the cycle lies where the curve lies between `lowest` and `highest` everywhere.
fn reduced(reduction: Reduction, [lowest, highest]: [f64; 2]) -> [f64; 2] {
    match reduction {
        Reduction::Maximum | Reduction::Minimum | Reduction::Mean => [lowest, highest],
        Reduction::MaximumAbsolute | Reduction::RootMeanSquare => [0.0, highest.max(-lowest)],
        Reduction::Range => [0.0, highest - lowest],
    }
}

#[cfg(test)]
mod tests {
    use super::reduced;
    use crate::file::Reduction;

    #[test]
    fn analytic_numbers_of_a_curve_between_two_ends() {
        // A curve that is at one end half of the time and at the other the other half: rms² = (3² + 5²)/2 <= 5².
        let of = |reduction| reduced(reduction, [-3.0, 5.0]);
        assert_eq!([of(Reduction::MaximumAbsolute), of(Reduction::RootMeanSquare)], [[0.0, 5.0]; 2]);
        assert_eq!(of(Reduction::Range), [0.0, 8.0]);
        assert_eq!([of(Reduction::Maximum), of(Reduction::Minimum), of(Reduction::Mean)], [[-3.0, 5.0]; 3]);
        assert_eq!(reduced(Reduction::MaximumAbsolute, [-7.0, 5.0]), [0.0, 7.0]);
    }
}
