//! Recorded outputs of every run of a study, by their names in results.

use crate::file::Ask;
use crate::response::columns::ColumnPlan;
use crate::runs::table::{curve_name, scalar_name};
use loosepin_text::units::SiUnit;

/// A number or a curve that every run records.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedOutput {
    /// `slider total maximum_absolute`, `slider total at 1.1 rad`, or `slider total` for a curve.
    pub name: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Angles of the drive at the points of a curve, rad; `None` for a number.
    pub pose_rad: Option<Vec<f64>>,
    /// Columns of its values in a row.
    pub columns: Vec<usize>,
}

impl RecordedOutput {
    /// Recorded outputs of the runs of a plan, each once, in the order of its questions.
    pub(crate) fn of_plan(plan: &ColumnPlan) -> Vec<Self> {
        let mut recorded: Vec<Self> = Vec::new();
        let mut push = |output: Option<Self>| {
            recorded.extend(output.filter(|output| recorded.iter().all(|known| known.name != output.name)));
        };
        let asked = plan.asks.iter().map(|ask| (ask.location.is_cycle(), &ask.columns));
        let required = plan.requirements.iter().map(|requirement| (false, &requirement.columns));
        for (is_curve, columns) in asked.chain(required) {
            if is_curve {
                push(Self::curve(plan, columns));
            } else {
                columns.iter().for_each(|&column| push(Self::number(plan, column)));
            }
        }
        recorded
    }

    /// Recorded output of one question of a plan: a curve of all its angles, or one number.
    pub(crate) fn of_ask(plan: &ColumnPlan, ask: &Ask) -> Option<Self> {
        match ask.columns[..] {
            [column] if ask.location.reduction().is_some() => Self::number(plan, column),
            _ => Self::curve(plan, &ask.columns),
        }
    }

    fn curve(plan: &ColumnPlan, columns: &[usize]) -> Option<Self> {
        let angle = |&column: &usize| plan.columns[column].spot.pose().map_or(f64::NAN, |pose| pose.angle_rad);
        let first = *columns.first()?;
        let pose_rad = Some(columns.iter().map(angle).collect());
        Some(Self { name: curve_name(plan, first), pose_rad, columns: columns.to_vec(), ..Self::number(plan, first)? })
    }

    fn number(plan: &ColumnPlan, column: usize) -> Option<Self> {
        let unit = plan.outputs[plan.columns.get(column)?.output].unit.clone();
        Some(Self { name: scalar_name(plan, column), unit, pose_rad: None, columns: vec![column] })
    }
}
