//! What a study writes reads back to the same values, repeats byte for byte, and has the columns that docs/files/study-results.md
//! names.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use loosepin::diagnostics::Problem;
use loosepin::result::json::Stored;
use loosepin::results::{Claim, Destination, InputsHasher, LOCK_FILE, MARKER_FILE, ResultKind};
use loosepin::study::files::{
    BOUNDS_COLUMNS, BOUNDS_FILE, FilesError, RUNS_FILE, SUMMARY_FILE, TIMING_FILE, Timing, bounds_csv,
    read_runs_parquet, read_summary, runs_parquet, write_study,
};
use loosepin::study::result::{StudyResult, Witness, WitnessValue};
use loosepin::study::{RunColumn, RunData, RunsTable};
use loosepin::units::SiUnit;

use super::report_fixture::{
    self,
    study::{runs_table, worn_pin},
};

fn timing() -> Timing {
    Timing {
        started_utc: "2026-11-20T04:00:00Z".to_owned(),
        elapsed_s: 61.25,
        runs_per_second_and_thread: 138.3,
        threads: 2,
        processor: "a processor".to_owned(),
        platform: "linux x86_64".to_owned(),
    }
}

#[test]
fn identity_summary_reads_back_to_the_same_result() {
    let mut result = worn_pin();
    // The values that JSON has no number for, and floats whose shortest form is long.
    result.bounds[0].upper.widened_si = f64::INFINITY;
    result.bounds[0].lower.widened_si = f64::NEG_INFINITY;
    result.bounds[1].upper.value_si = 0.1 + 0.2;
    result.bounds[1].lower.value_si = f64::MIN_POSITIVE;
    let text = result.to_json().expect("the result has a form in JSON");
    let read = StudyResult::from_json(&text).expect("what was written can be read");
    assert!(read == result, "what is read differs from what was written");
    assert!(read.to_json().expect("it can be written again") == text, "writing repeats byte for byte");
    // Order of keys and layout are part of the format.
    assert!(text.starts_with("{\n  \"format\": 2,\n  \"name\": \"worn pin at 5000 rpm\",\n"), "{}", &text[..80]);
    assert!(text.contains("\"widened_si\": \"inf\""));
    assert!(text.ends_with("}\n"));
    let longest_depth = text.lines().filter(|line| line.trim_start().starts_with(|c: char| c.is_ascii_digit())).count();
    assert_eq!(longest_depth, 0, "lists of numbers stand on one line");
}

#[test]
fn a_record_without_what_newer_versions_draw_is_read() {
    let result = worn_pin();
    let mut value: serde_json::Value =
        serde_json::from_str(&result.to_json().expect("the result has a form in JSON")).expect("it is JSON");
    let remove = |value: &mut serde_json::Value, key: &str| {
        assert!(value.as_object_mut().expect("an object").remove(key).is_some(), "{key} is written");
    };
    for key in ["drives", "output_points"] {
        remove(&mut value["drawing"], key);
    }
    for orbit in value["orbits"].as_array_mut().expect("a list") {
        remove(orbit, "drive_angle_rad");
        remove(orbit, "force_n");
    }
    let read = StudyResult::from_json(&value.to_string()).expect("an old record can be read");
    assert!(read.drawing.drives.is_empty() && read.drawing.output_points.is_empty());
    assert!(read.orbits.iter().all(|orbit| orbit.drive_angle_rad.is_empty() && orbit.force_n.is_empty()));
    assert!(read.drawing.joints == result.drawing.joints);
}

#[test]
fn identity_numbers_that_json_has_not_read_back_everywhere() {
    let mut result = worn_pin();
    result.bounds[0].upper.value_si = f64::NAN;
    result.curves[0].mixed.lower_si[3] = f64::NEG_INFINITY;
    result.boxes[0].limit_si = Some(f64::INFINITY);
    result.requirements[0].probability = [f64::NAN, 1.0];
    result.impacts[0].impacts_per_turn[2] = f64::INFINITY;
    result.drawing.poses.x_m[1][2] = f64::NAN;
    let text = result.to_json().expect("the result has a form in JSON");
    let read = StudyResult::from_json(&text).expect("what was written can be read");
    assert!(read.bounds[0].upper.value_si.is_nan());
    assert!(read.curves[0].mixed.lower_si[3] == f64::NEG_INFINITY);
    assert_eq!(read.boxes[0].limit_si, Some(f64::INFINITY));
    assert!(read.requirements[0].probability[0].is_nan());
    assert!(read.impacts[0].impacts_per_turn[2] == f64::INFINITY);
    assert!(read.drawing.poses.x_m[1][2].is_nan());
    assert!(read.to_json().expect("it can be written again") == text, "writing repeats byte for byte");
}

#[test]
fn words_that_stand_for_no_number_are_refused() {
    let text = worn_pin().to_json().expect("the result has a form in JSON").replacen(
        "\"lower_si\": -0.0007",
        "\"lower_si\": \"low\"",
        1,
    );
    let error = StudyResult::from_json(&text).expect_err("'low' is no number").to_string();
    assert!(
        error.contains("invalid value: string \"low\", expected a number, \"inf\", \"-inf\" or \"nan\" at line"),
        "{error}"
    );
}

#[test]
fn every_record_reads_back_from_json() {
    let simulation = report_fixture::simulation::worn_pin();
    let text = simulation.to_json().expect("a run has a form in JSON");
    assert!(loosepin::simulate::record::SimulationRecord::from_json(&text).ok() == Some(simulation));
    let motion = report_fixture::motion::worn_pin();
    let text = motion.to_json().expect("a motion has a form in JSON");
    assert!(loosepin::accuracy::record::MotionRecord::from_json(&text).ok() == Some(motion));
}

#[test]
fn foreign_summary_is_refused_with_its_place() {
    let source = StudyResult::from_json("{\n  \"format\": 1,\n  \"name\": 5\n}\n").expect_err("a number is no name");
    let error = FilesError::Layout { what: SUMMARY_FILE.to_owned(), source };
    assert_eq!(
        error.to_string(),
        "summary.json cannot be read: invalid type: integer `5`, expected a string at line 3 column 11"
    );
    assert_eq!(error.hint().as_deref(), Some("run the study again, or use the version that wrote it"));
}

#[test]
fn identity_bounds_table_reads_back_to_the_same_numbers() {
    let result = worn_pin();
    let bytes = bounds_csv(&result).expect("the bounds have a form in CSV");
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    assert_eq!(reader.headers().expect("there is a header").iter().collect::<Vec<_>>(), BOUNDS_COLUMNS);
    let rows: Vec<BTreeMap<String, String>> =
        reader.deserialize().collect::<Result<_, _>>().expect("every row has the columns of the header");
    assert_eq!(rows.len(), result.bounds.len());
    for (row, bound) in rows.iter().zip(&result.bounds) {
        let number = |column: &str| row[column].parse::<f64>().expect("a number");
        assert_eq!(number("lower").to_bits(), bound.lower.value_si.to_bits());
        assert_eq!(number("upper_widened").to_bits(), bound.upper.widened_si.to_bits());
        assert_eq!(number("upper_error_sampling").to_bits(), bound.upper.error.sampling_si.to_bits());
        assert_eq!(row["unit"], bound.unit.symbol());
        assert_eq!(witness_of(&row["upper_witness"]), bound.upper.witness);
    }
    assert_eq!(rows[0]["statistic"], "quantile");
    assert_eq!(rows[0]["parameter"], "0.975");
    assert_eq!(rows[0]["reduction"], "maximum_absolute");
    assert_eq!(rows[0]["pose_rad"], "");
    assert_eq!(rows[0]["guarantee"], "sampled 0.95");
}

fn witness_of(cell: &str) -> Witness {
    cell.split(';')
        .map(|part| {
            let (path, value) = part.split_once('=').expect("path=value");
            (path.to_owned(), WitnessValue::Number(value.parse().expect("a number")))
        })
        .collect()
}

#[test]
fn identity_runs_read_back_to_the_same_table() {
    let table = runs_table();
    let bytes = runs_parquet(&table).expect("the runs have a form in Parquet");
    assert!(runs_parquet(&table).expect("again") == bytes, "writing repeats byte for byte");
    let read = read_runs_parquet(&bytes).expect("what was written can be read");
    assert_eq!(read.columns.len(), table.columns.len());
    for (read, written) in read.columns.iter().zip(&table.columns) {
        assert_eq!((&read.name, &read.unit), (&written.name, &written.unit));
        match (&read.data, &written.data) {
            // Not-a-number is not equal to itself; its bits are.
            (RunData::F64(read), RunData::F64(written)) => {
                assert!(
                    read.iter().zip(written).all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
                );
            }
            (read, written) => assert_eq!(read, written),
        }
    }
}

#[test]
fn identity_a_table_without_runs_reads_back() {
    for table in [
        RunsTable::default(),
        RunsTable {
            columns: vec![RunColumn { name: "index".to_owned(), unit: SiUnit::NONE, data: RunData::U64(Vec::new()) }],
        },
    ] {
        let bytes = runs_parquet(&table).expect("an empty table has a form in Parquet");
        assert_eq!(read_runs_parquet(&bytes).expect("it can be read"), table);
    }
}

#[test]
fn crooked_tables_are_refused_in_words() {
    let column = |name: &str, rows: usize| RunColumn {
        name: name.to_owned(),
        unit: SiUnit::LENGTH,
        data: RunData::F64(vec![0.25; rows]),
    };
    let refused = |columns| runs_parquet(&RunsTable { columns }).expect_err("the table is crooked").to_string();
    assert_eq!(
        refused(vec![column("a", 3), column("b", 2)]),
        "column 'b' of the runs has 2 rows; must be 3, as in column 'a'"
    );
    assert_eq!(
        refused(vec![column("a", 3), column("a", 3)]),
        "column 'a' of the runs appears twice; names must differ"
    );
}

/// Asks for `folder`.
fn claim(folder: &Path) -> Claim {
    Claim {
        kind: ResultKind::Study,
        name: "worn pin".to_owned(),
        inputs: InputsHasher::new(ResultKind::Study).finish(),
        destination: Destination::Folder(folder.to_owned()),
        with_force: false,
    }
}

#[test]
fn a_folder_holds_the_four_files_and_no_partial_ones() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (result, runs) = (worn_pin(), runs_table());
    let mut results = claim(folder.path()).take().expect("an empty folder");
    write_study(&mut results, &result, &runs, &timing()).expect("the folder can be written");
    let mut names: Vec<String> = fs::read_dir(folder.path())
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, [BOUNDS_FILE, MARKER_FILE, LOCK_FILE, RUNS_FILE, SUMMARY_FILE, TIMING_FILE]);
    assert!(read_summary(&results.finished()).expect("the summary can be read") == result);
    let text = fs::read_to_string(folder.path().join(TIMING_FILE)).expect("the times can be read");
    assert_eq!(serde_json::from_str::<Timing>(&text).ok(), Some(timing()));
}

#[test]
fn another_format_is_refused_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(SUMMARY_FILE);
    // What the other one holds does not matter.
    let mut results = claim(folder.path()).take().expect("an empty folder");
    results.write(SUMMARY_FILE, b"{\"format\": 1, \"study\": \"older\"}").expect("writable");
    let error = read_summary(&results.finished()).expect_err("an older format");
    assert_eq!(error.to_string(), format!("{} has format 1; this version reads format 2", path.display()));
    assert_eq!(error.hint().as_deref(), Some("run the study again, or use the version that wrote it"));
}

#[test]
fn what_cannot_be_written_is_named() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let removed = folder.path().join("removed");
    let mut results = claim(&removed).take().expect("a new folder");
    fs::remove_dir_all(&removed).expect("removable");
    let error = write_study(&mut results, &worn_pin(), &runs_table(), &timing()).expect_err("the folder is not there");
    assert!(error.to_string().starts_with(&format!("cannot write {}", removed.join(BOUNDS_FILE).display())), "{error}");
    let error = read_summary(&results.finished()).expect_err("nothing was written");
    assert!(error.to_string().contains("summary.json is not a file of the study"), "{error}");
}
