//! Extremes of columns and of their deviations over a run, located within the steps.

use crate::ideal::column::Column;
use crate::observer::Step;
use crate::recording::column_reader::{ColumnReader, Ideal};
use crate::stepping::search::{POINTS_PER_STEP, Peak, maximum_within, may_exceed};
use loosepin_result::simulation::{Extreme, ExtremePoint};
use loosepin_result::study::Deviation;

/// The times at which `step` is looked at for extremes, s.
pub fn times_s(step: &Step<'_, '_>) -> [f64; POINTS_PER_STEP] {
    let (start_s, end_s) = (step.start_s, step.end_s);
    std::array::from_fn(|k| start_s + (end_s - start_s) * k as f64 / (POINTS_PER_STEP - 1) as f64)
}

/// Minimum (negated) and maximum of each column, then of each deviation.
#[derive(Debug, Clone)]
pub struct ExtremeRecorder {
    peaks: Vec<[Peak; 2]>,
}

impl ExtremeRecorder {
    /// Of this many series; of none, nothing is sought.
    pub fn new(series: usize) -> Self {
        Self { peaks: vec![[Peak::none(); 2]; series] }
    }

    /// Takes a step in. Ideal values may come from a table while an extreme is sought; the one that is kept is solved for.
    pub fn step(&mut self, step: &mut Step<'_, '_>, reader: &mut ColumnReader<'_>) {
        if self.peaks.is_empty() {
            return;
        }
        reader.prepare_table(step);
        let times_s = times_s(step);
        let looks = times_s.map(|time_s| reader.look(step, time_s, Ideal::Tabled));
        for (series, peaks) in self.peaks.iter_mut().enumerate() {
            for (known, sign) in peaks.iter_mut().zip([-1.0, 1.0]) {
                let points: [(f64, f64); POINTS_PER_STEP] =
                    std::array::from_fn(|k| (times_s[k], sign * looks[k][series]));
                if !may_exceed(&points, known.value) {
                    continue;
                }
                let peak = maximum_within(&points, |time_s| sign * reader.look_at(step, time_s, series, Ideal::Tabled));
                if peak.value > known.value {
                    let value = sign * reader.look_at(step, peak.time_s, series, Ideal::Solved);
                    known.raise(value, peak.time_s);
                }
            }
        }
    }

    /// The extremes found of `columns`, with the angle of the drive at each time.
    pub fn records(&self, columns: &[Column], drive_angle_rad: impl Fn(f64) -> f64) -> Vec<Extreme> {
        let point = |peak: Peak, sign: f64| ExtremePoint {
            value_si: sign * peak.value,
            time_s: peak.time_s,
            drive_angle_rad: drive_angle_rad(peak.time_s),
        };
        let record = |(series, [minimum, maximum]): (usize, &[Peak; 2])| {
            let column = &columns[series % columns.len()];
            Extreme {
                name: column.name.clone(),
                of: if series < columns.len() { Deviation::of_value() } else { Deviation::of_all_causes() },
                unit: column.unit.clone(),
                minimum: point(*minimum, -1.0),
                maximum: point(*maximum, 1.0),
            }
        };
        self.peaks.iter().enumerate().map(record).collect()
    }
}
