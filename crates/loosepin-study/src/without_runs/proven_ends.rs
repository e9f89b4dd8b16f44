//! What is proven without dynamics of the numbers that a study bounds.

use super::judge::{over, proven_over_turn};
use crate::file::Study;
use crate::response::columns::ColumnPlan;
use crate::response::ends::{Ends, reduced};
use crate::response::input_targets::in_the_middle;
use loosepin_simulate::accuracy::DeviationQuestion;

/// Positions in a turn: every degree, as by `loosepin motion`.
const POSITIONS: usize = 360;

/// Ends of each of `columns` that nothing passes without dynamics; `None` where nothing is proven, as of what is no position.
pub(crate) fn proven_ends_si(study: &Study, plan: &ColumnPlan, columns: &[usize]) -> Vec<Option<[f64; 2]>> {
    // As runs count: from the middle of what is unknown. Where parts are warm there, runs count from the drawing, which is another mechanism.
    let Ok(nominal) = study.model.quantities().evaluate(&in_the_middle(study)) else {
        return vec![None; columns.len()];
    };
    let is_drawn = study.model.quantities().at_drawing(&nominal) == nominal;
    let mut questions: Vec<DeviationQuestion> = Vec::new();
    let asked: Vec<Option<usize>> = columns
        .iter()
        .map(|&column| {
            let column = &plan.columns[column];
            let counts = is_drawn || !column.deviation.is_from_drawing();
            let reading = plan.outputs[column.output].seen.position().filter(|_| counts)?;
            let question = DeviationQuestion { reading, of: column.deviation };
            Some(questions.iter().position(|known| *known == question).unwrap_or_else(|| {
                questions.push(question);
                questions.len() - 1
            }))
        })
        .collect();
    let proven = (!questions.is_empty()).then(|| proven_over_turn(study, &nominal, POSITIONS, &questions)).flatten();
    let ends_si = |(column, asked): (&usize, Option<usize>)| {
        let own = &proven.as_ref()?[asked?];
        let ends_si = plan.columns[*column].spot.turned_into(
            |pose| over(&own.drive_angle_rad, &own.proven_si, Some(pose.angle_rad)),
            |reduction| {
                let [lower, upper] = over(&own.drive_angle_rad, &own.proven_si, None);
                let Ends { lower, upper } = reduced(reduction, std::iter::once((Ends { lower, upper }, 1.0)));
                [lower, upper]
            },
        );
        ends_si.iter().all(|end| end.is_finite()).then_some(ends_si)
    };
    columns.iter().zip(asked).map(ends_si).collect()
}
