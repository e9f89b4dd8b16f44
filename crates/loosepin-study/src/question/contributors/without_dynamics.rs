//! Effects of inputs without dynamics, to first order: shares that need no runs of their own.

use super::subjects::Subject;
use crate::assemble::Material;
use crate::response::linear_scatter::LinearScatter;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{PinchedEnd, Pinching};
use loosepin_result::motion::{MotionRecord, NamedEffect, OutputMotion, PoseEffect};
use loosepin_simulate::accuracy::{AskedPose, MotionPlan, Scatter};

/// Positions of the quasi-static answer in a turn.
const POSITIONS: usize = 72;
/// Angles nearer to each other are one.
const SAME_ANGLE_RAD: f64 = 1e-9;

/// The answer without dynamics with the unknown values in the middle.
pub enum WithoutDynamics {
    /// The ideal motion, with the poses of the subjects.
    Motion(Box<MotionRecord>),
    /// The scatter of a mechanism that has no runs.
    Scatter(LinearScatter),
    /// A mechanism that has neither.
    Nothing,
}

/// What inputs do to one number, to first order.
pub struct Effects<'r> {
    /// Variance by each dimension that scatters.
    variances: Vec<NamedEffect>,
    /// Effect of each joint with play; empty where these are not known.
    joints: Vec<NamedEffect>,
    /// Sum of the effects of all joints.
    of_all_joints: f64,
    /// A mechanism without dynamics, so that there is nothing else: its numbers where no part scatters.
    pub without_scatter: Option<&'r StudyResponse>,
}

impl WithoutDynamics {
    /// Of the study, with the poses of `subjects`.
    pub fn new(material: &Material<'_>, subjects: &[Subject]) -> Self {
        let study = material.study;
        if let Some(scatter) = material.response.linear_scatter(study) {
            return Self::Scatter(scatter);
        }
        let scatter = study.random.iter().filter_map(|input| {
            let standard_deviation_si = input.variable.standard_deviation();
            Some(Scatter { quantity: input.quantity()?, standard_deviation_si })
        });
        let asked = subjects.iter().filter_map(|subject| {
            let pose_rad = subject.pose_rad(material.plan())?;
            Some(AskedPose { output: name(material, subject), pose_rad, is_required: false })
        });
        let plan = MotionPlan {
            span: study.cycle.span,
            positions: POSITIONS,
            scatter: scatter.collect(),
            correlations: study.linear_correlations(),
            paths: Vec::new(),
            asked: asked.collect(),
            overrides: Vec::new(),
        };
        material.response.nominal_motion(&plan).map_or(Self::Nothing, |record| Self::Motion(Box::new(record)))
    }

    /// The effects on a subject; `None` if the answer does not know it.
    pub fn effects<'r>(&self, material: &Material<'r>, subject: &Subject) -> Option<Effects<'r>> {
        match self {
            Self::Motion(record) => {
                let name = name(material, subject);
                match subject.pose_rad(material.plan()) {
                    Some(pose_rad) => record.asked_of(&name).find(|own| own.pose_rad == pose_rad).map(of_pose),
                    None => record.outputs.iter().find(|own| own.name == name).map(|own| over_the_turn(record, own)),
                }
            }
            Self::Scatter(scatter) => {
                let response = material.response;
                let mut variances = vec![0.0; scatter.paths.len()];
                for &column in &subject.columns {
                    let own = response.variances(scatter, column);
                    variances.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
                }
                let named = scatter.paths.iter().zip(variances);
                let variances = named.map(|(name, value_si)| NamedEffect { name: name.clone(), value_si }).collect();
                Some(Effects { variances, joints: Vec::new(), of_all_joints: 0.0, without_scatter: Some(response) })
            }
            Self::Nothing => None,
        }
    }
}

/// The name that the answer without dynamics has for the output of a subject.
fn name(material: &Material<'_>, subject: &Subject) -> String {
    let plan = material.plan();
    material.study.name_without_dynamics(&plan.outputs[plan.columns[subject.columns[0]].output])
}

/// At a pose.
fn of_pose(pose: &PoseEffect) -> Effects<'static> {
    let square = |own: &NamedEffect| NamedEffect { name: own.name.clone(), value_si: own.value_si * own.value_si };
    Effects {
        variances: pose.dimensions.iter().map(square).collect(),
        joints: pose.joints.clone(),
        of_all_joints: pose.first_order_si,
        without_scatter: None,
    }
}

/// Added over the turn.
fn over_the_turn(record: &MotionRecord, output: &OutputMotion) -> Effects<'static> {
    let positions = positions(record);
    let sum = |values: &[f64], of: fn(f64) -> f64| values.iter().take(positions).map(|&value| of(value)).sum();
    let variances = output.dimensional_contributors.iter().map(|own| NamedEffect {
        name: own.path.clone(),
        value_si: sum(&own.standard_deviation_si, |value| value * value),
    });
    let joints = output
        .clearance
        .contributors
        .iter()
        .map(|own| NamedEffect { name: own.joint.clone(), value_si: sum(&own.first_order_si, |value| value) });
    Effects {
        variances: variances.collect(),
        joints: joints.collect(),
        of_all_joints: sum(&output.clearance.first_order_si, |value| value),
        without_scatter: None,
    }
}

/// Positions that count: the last one of a whole turn is the first one again.
fn positions(record: &MotionRecord) -> usize {
    let angles_rad = &record.drive_angle_rad;
    let (Some(first), Some(last)) = (angles_rad.first(), angles_rad.last()) else { return 0 };
    let is_turn = ((last - first).abs() - std::f64::consts::TAU).abs() < SAME_ANGLE_RAD;
    angles_rad.len() - usize::from(is_turn)
}

impl Effects<'_> {
    /// How much of the width of a band of these columns is scatter: from its ends to the numbers there without scatter. `None` where only runs
    /// could show that.
    pub fn scatter(&self, columns: &[usize], pinching: &Pinching) -> Option<f64> {
        let response = self.without_scatter?;
        let of_end = |column: usize, end: &PinchedEnd| {
            let row = response.without_scatter(&end.epistemic)?;
            Some((end.quantile - row[column]).abs())
        };
        let ends = columns.iter().zip(&pinching.ends);
        ends.map(|(&column, [low, high])| Some(of_end(column, low)? + of_end(column, high)?)).sum()
    }

    /// The share of a scattering quantity in the variance.
    pub fn variance_share(&self, path: &str) -> Option<f64> {
        let own = self.variances.iter().find(|own| own.name == path).map_or(0.0, |own| own.value_si);
        let total: f64 = self.variances.iter().map(|own| own.value_si).sum();
        (total > 0.0).then(|| own / total)
    }

    /// The share of `joints` in the first-order effect of all; `None` if there are none.
    pub fn play_share(&self, joints: &[String]) -> Option<f64> {
        let own: Vec<f64> =
            self.joints.iter().filter(|own| joints.contains(&own.name)).map(|own| own.value_si).collect();
        let total = self.of_all_joints;
        (total > 0.0 && !own.is_empty()).then(|| own.iter().sum::<f64>() / total)
    }
}
