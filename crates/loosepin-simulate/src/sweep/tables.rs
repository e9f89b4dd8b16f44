//! The CSV files of a sweep, SI.

use loosepin_result::sweep::SweepRecord;
use loosepin_text::units::SiUnit;
use std::fmt::Write;

/// Name of the file with one value a row.
pub const SWEEP_FILE: &str = "sweep.csv";
/// Name of the file with one turn of one value a row.
pub const SECTIONS_FILE: &str = "sections.csv";

/// `sweep.csv`: `value` of the quantity, `period_turns` (empty where the motion did not repeat itself), then for each joint with
/// play `<joint>.impacts_per_turn`, `.flight_share`, `.losses_per_turn`, `.peak_force_n`, `.largest_penetration_m`, then `failure`.
pub fn sweep_csv(record: &SweepRecord) -> String {
    let mut text = String::from("value,period_turns");
    for joint in &record.joints {
        for quantity in ["impacts_per_turn", "flight_share", "losses_per_turn", "peak_force_n", "largest_penetration_m"]
        {
            let _ = write!(text, ",{joint}.{quantity}");
        }
    }
    text.push_str(",failure\n");
    for point in &record.points {
        let _ = write!(text, "{:?},", point.value_si);
        if let Some(turns) = point.period_turns {
            let _ = write!(text, "{turns}");
        }
        for index in 0..record.joints.len() {
            match point.joints.get(index) {
                Some(joint) => {
                    let _ = write!(
                        text,
                        ",{:?},{:?},{:?}",
                        joint.impacts_per_turn, joint.flight_share, joint.losses_per_turn
                    );
                    let _ = write!(text, ",{:?},{:?}", joint.peak_force_n, joint.largest_penetration_m);
                }
                None => text.push_str(",,,,,"),
            }
        }
        let _ = match &point.failure {
            Some(words) => writeln!(text, ",\"{}\"", words.replace('"', "\"\"")),
            None => writeln!(text, ","),
        };
    }
    text
}

/// `sections.csv`: `value`, `turn`, then the deviation of each position and angle from the ideal motion at the end of that turn.
pub fn sections_csv(record: &SweepRecord) -> String {
    let mut text = String::from("value,turn");
    for output in &record.outputs {
        let suffix = if output.unit == SiUnit::ANGLE { "rad" } else { "m" };
        let _ = write!(text, ",{}_{suffix}", output.name.replace(' ', "_"));
    }
    text.push('\n');
    for point in record.points.iter().filter(|point| point.failure.is_none()) {
        for turn in 0..record.recorded_turns as usize {
            let _ = write!(text, "{:?},{}", point.value_si, turn + 1);
            for section_si in &point.sections_si {
                let _ = write!(text, ",{:?}", section_si[turn]);
            }
            text.push('\n');
        }
    }
    text
}
