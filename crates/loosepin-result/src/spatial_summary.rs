//! `summary.json` of a motion in space: keys as those of a planar motion where they mean the same. SI.

use crate::json::to_json;
use crate::motion::{DimensionContributor, PoseEffect};
use crate::repeat::Repeat;
use crate::spatial_motion::{SpatialContributor, SpatialMotionRecord, SpatialOutputRecord, SpatialWorstCase};
use crate::spatial_picture::SpatialPicture;
use loosepin_text::VERSION;
use loosepin_text::units::SiUnit;
use serde::Serialize;

/// Motions in space and planar ones are told apart by this word.
const GEOMETRY: &str = "space";

#[derive(Serialize)]
struct Summary<'r> {
    model: &'r str,
    version: &'static str,
    geometry: &'static str,
    repeat: &'r Repeat,
    #[serde(skip_serializing_if = "Option::is_none")]
    drive: Option<&'r str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    drive_speed_rad_s: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    drive_angle_rad: Option<&'r [f64]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    time_s: Option<&'r [f64]>,
    has_play: bool,
    #[serde(skip_serializing_if = "<[usize]>::is_empty")]
    dead_centre_samples: &'r [usize],
    outputs: Vec<Output<'r>>,
    #[serde(skip_serializing_if = "<[PoseEffect]>::is_empty")]
    asked: &'r [PoseEffect],
    drawing: &'r SpatialPicture,
}

#[derive(Serialize)]
struct Output<'r> {
    name: &'r str,
    words: &'r str,
    unit: &'r SiUnit,
    value_si: &'r [f64],
    clearance: Clearance<'r>,
    #[serde(skip_serializing_if = "<[f64]>::is_empty")]
    dimensional_standard_deviation_si: &'r [f64],
    #[serde(skip_serializing_if = "<[DimensionContributor]>::is_empty")]
    dimensional_contributors: &'r [DimensionContributor],
}

#[derive(Serialize)]
struct Clearance<'r> {
    first_order_si: &'r [f64],
    standard_deviation_si: &'r [f64],
    worst: Worst<'r>,
    #[serde(skip_serializing_if = "Option::is_none")]
    worst_regular: Option<Worst<'r>>,
}

/// The position with the largest worst case of first order.
#[derive(Serialize)]
struct Worst<'r> {
    sample: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    drive_angle_rad: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    time_s: Option<f64>,
    first_order_si: f64,
    lowest_si: f64,
    highest_si: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    proven_lowest_si: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    proven_highest_si: Option<f64>,
    conditions: usize,
    contributors: Vec<Contributor<'r>>,
}

#[derive(Serialize)]
struct Contributor<'r> {
    joint: &'r str,
    first_order_si: f64,
    offset_si: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    lean_si: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    axial_si: Option<f64>,
}

/// The text of `summary.json`.
///
/// # Errors
/// A value without a form in JSON.
pub fn spatial_motion_summary(record: &SpatialMotionRecord) -> Result<String, serde_json::Error> {
    let is_drive = record.drive_speed_rad_s.is_some();
    to_json(&Summary {
        model: &record.model,
        version: VERSION,
        geometry: GEOMETRY,
        repeat: &record.repeat,
        drive: is_drive.then_some(record.input.as_str()),
        drive_speed_rad_s: record.drive_speed_rad_s,
        drive_angle_rad: is_drive.then_some(&record.inputs_si),
        time_s: (!is_drive).then_some(&record.inputs_si),
        has_play: record.has_play,
        dead_centre_samples: &record.dead_centre_samples,
        outputs: record.outputs.iter().map(|output| summary_of(record, output)).collect(),
        asked: &record.asked,
        drawing: &record.picture,
    })
}

fn summary_of<'r>(record: &SpatialMotionRecord, output: &'r SpatialOutputRecord) -> Output<'r> {
    let is_drive = record.drive_speed_rad_s.is_some();
    let worst = |own: &'r SpatialWorstCase| {
        let at = record.inputs_si.get(own.sample).copied();
        Worst {
            sample: own.sample,
            drive_angle_rad: at.filter(|_| is_drive),
            time_s: at.filter(|_| !is_drive),
            first_order_si: output.first_order_si.get(own.sample).copied().unwrap_or_default(),
            lowest_si: own.smallest_si,
            highest_si: own.largest_si,
            proven_lowest_si: own.proven_smallest_si,
            proven_highest_si: own.proven_largest_si,
            conditions: own.conditions,
            contributors: own.contributors.iter().map(contributor).collect(),
        }
    };
    Output {
        name: &output.name,
        words: &output.words,
        unit: &output.unit,
        value_si: &output.ideal_si,
        clearance: Clearance {
            first_order_si: &output.first_order_si,
            standard_deviation_si: &output.standard_deviation_si,
            worst: worst(&output.worst),
            worst_regular: output.worst_regular.as_ref().map(worst),
        },
        dimensional_standard_deviation_si: &output.scatter.standard_deviation_si,
        dimensional_contributors: &output.scatter.contributors,
    }
}

fn contributor(own: &SpatialContributor) -> Contributor<'_> {
    Contributor {
        joint: &own.joint,
        first_order_si: own.part_si,
        offset_si: own.offset_si,
        lean_si: own.lean_si,
        axial_si: own.axial_si,
    }
}
