//! Measured curves over a run, and tables that cannot be read.

use loosepin::measured::{MeasuredTable, compare_with_measured};
use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::report::{simulation_page, simulation_text};
use loosepin::simulate::record::{Abscissa, SimulationRecord};
use loosepin::simulate::{Plan, Settings, columns, simulate};
use loosepin::templates::find_template;

const CRANK_M: f64 = 0.05;
const ROD_M: f64 = 0.12;

/// The slider-crank of the template without play: its motion has a closed form.
fn ideal_run(transient_turns: f64) -> SimulationRecord {
    let text = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let set = model.set_values(&["joint.gudgeon.radial_clearance=0mm".to_owned()]);
    let set = set.unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let mechanism = Mechanism::new(&set.model, &set.values).expect("it compiles");
    let mut cycle = model.cycle.clone();
    (cycle.transient_turns, cycle.recorded_turns) = (transient_turns, 1.0);
    let plan = Plan {
        cycle,
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    simulate(&mechanism, &set.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

/// x = r cos θ + √(l² - r² sin² θ)
fn slider_m(angle_rad: f64) -> f64 {
    let (sine, cosine) = angle_rad.sin_cos();
    CRANK_M * cosine + (ROD_M * ROD_M - (CRANK_M * sine).powi(2)).sqrt()
}

/// The closed form every 7.5 degrees, in millimetres, 0.3 mm too large at 90 degrees.
fn table() -> String {
    let mut text = "crank angle [deg], slider [mm]\n".to_owned();
    for step in 0..48 {
        let angle_deg = 7.5 * f64::from(step);
        let error_mm = if step == 12 { 0.3 } else { 0.0 };
        text.push_str(&format!("{angle_deg},{}\n", 1e3 * slider_m(angle_deg.to_radians()) + error_mm));
    }
    text
}

/// Straight lines between 500 samples a turn: (2π/500)²/8 of 50 mm is 1e-6 m.
const INTERPOLATION_M: f64 = 2e-6;

#[test]
fn analytic_residuals_of_a_closed_form_are_the_error_put_into_it() {
    // After two turns to start up the angles of the run begin at 720 degrees.
    for transient_turns in [0.0, 2.0] {
        let mut record = ideal_run(transient_turns);
        let table = MeasuredTable::from_text("measured.csv", &table()).unwrap_or_else(|wrong| panic!("{wrong}"));
        compare_with_measured(&table, &mut record).unwrap_or_else(|wrong| panic!("{wrong}"));
        let curve = &record.measured[0];
        assert_eq!((curve.output.as_str(), curve.abscissa, curve.at_si.len()), ("slider", Abscissa::DriveAngle, 48));
        assert!((curve.largest_si - 3e-4).abs() < INTERPOLATION_M, "{}", curve.largest_si);
        let at_rad = std::f64::consts::FRAC_PI_2 + transient_turns * std::f64::consts::TAU;
        assert!((curve.largest_at_si - at_rad).abs() < 1e-9, "{}", curve.largest_at_si);
        assert!((curve.rms_si - 3e-4 / 48.0_f64.sqrt()).abs() < INTERPOLATION_M, "{}", curve.rms_si);
        let page = simulation_page(&record);
        assert!(page.contains("Measured against computed") && page.contains("data-figure=\"residual."));
        assert!(simulation_text(&record).contains("residual: measured minus computed"));
    }
}

#[test]
fn analytic_times_and_empty_cells() {
    let mut record = ideal_run(0.0);
    // 5000 rpm: 12 ms a turn.
    let mut text = "time [ms], slider_speed [m/s], slider [cm]\n".to_owned();
    for step in 0..25 {
        let angle_rad = f64::from(step) / 24.0 * std::f64::consts::TAU;
        let slider = if step % 2 == 0 { String::new() } else { format!("{}", 1e2 * slider_m(angle_rad) - 0.01) };
        text.push_str(&format!("{},, {slider}\n", 12.0 * f64::from(step) / 24.0));
    }
    let table = MeasuredTable::from_text("measured.csv", &text).unwrap_or_else(|wrong| panic!("{wrong}"));
    compare_with_measured(&table, &mut record).unwrap_or_else(|wrong| panic!("{wrong}"));
    let [speed, slider] = &record.measured[..] else { panic!("two columns") };
    assert_eq!((speed.at_si.len(), slider.at_si.len()), (0, 12));
    assert!((slider.rms_si - 1e-4).abs() < INTERPOLATION_M && slider.largest_si < 0.0, "{}", slider.rms_si);
}

fn refused(text: &str) -> String {
    MeasuredTable::from_text("m.csv", text).expect_err("a wrong table").to_string()
}

#[test]
fn wrong_tables_are_told_with_their_places() {
    assert_eq!(
        refused(""),
        "m.csv:1:1: error[E1001]: the table has no header\nhint: for example a first line: angle [deg], slider [mm]"
    );
    assert_eq!(
        refused("angle [deg], slider\n0, 1\n"),
        "m.csv:1:14: error[E1001]: the header 'slider' is not written name [unit]\n\
         hint: for example: angle [deg], slider [mm]; a pure number has [1]"
    );
    assert_eq!(
        refused("angle [deg]; slider [mm]\n0; 1\n"),
        "m.csv:1:1: error[E1001]: the columns are separated by semicolons; must be commas, with a decimal point in numbers\nhint: write '0; 1' as '0, 1'; spreadsheets do this with the region English (United States)"
    );
    assert_eq!(
        refused("# bench 3\nangle [deg], slider [mm]\n0, 1\n"),
        "m.csv:1:1: error[E1001]: the header '# bench 3' is not written name [unit]\n\
         hint: a table must not have comment lines: delete the #, or remove the line"
    );
    assert_eq!(
        refused("angle [deg], slider [mm]\n# at noon\n0,5, 1,25\n1,\"1,5\"\n2, \u{2212}1\n"),
        "m.csv:2:1: error[E1001]: a table must not have comment lines\nhint: remove the line\n\
         m.csv:3:1: error[E1001]: the row has 4 cells; the header has 2\n\
         hint: a comma separates columns; decimal numbers have a point\n\
         m.csv:4:1: error[E1001]: '1,5' is not a finite number\nhint: decimal numbers have a point\n\
         m.csv:5:4: error[E1001]: '\u{2212}1' is not a finite number\n\
         hint: use the hyphen of the keyboard as the minus sign"
    );
    assert_eq!(
        refused("angle [degr], slider [mm]\n0, 1\n"),
        "m.csv:1:1: error[E0302]: 'degr' is not a known unit\nhint: did you mean 'deg'?"
    );
    assert_eq!(
        refused("angle [deg], slider [mm]\r\n0, 1\r\n\r\n1, 2x\r\n"),
        "m.csv:4:4: error[E1001]: '2x' is not a finite number\nhint: write a number; a cell of a measured curve may be empty if nothing was measured"
    );
    assert_eq!(
        refused("x [mm], slider [mm]\n0, 1\n"),
        "m.csv:1:1: error[E1001]: the first column 'x' is a length; it must be a time or an angle of the drive"
    );
    assert_eq!(
        refused("angle [deg], slider [mm], slider [mm]\n0, 1x, 2\n1, 2\n0.5, 3, inf\n"),
        "m.csv:1:27: error[E1001]: the column 'slider' appears twice\n\
         m.csv:2:4: error[E1001]: '1x' is not a finite number\nhint: write a number; a cell of a measured curve may be empty if nothing was measured\n\
         m.csv:3:1: error[E1001]: the row has 2 cells; the header has 3\n\
         m.csv:4:9: error[E1001]: 'inf' is not a finite number\nhint: write a number; a cell of a measured curve may be empty if nothing was measured"
    );
    assert_eq!(
        refused("angle [deg], slider [mm]\n10, 1\n5, 2\n"),
        "m.csv:3:1: error[E1001]: angle 5 follows 10; the first column must increase from row to row"
    );
    assert_eq!(
        refused("angle [deg], slider [mm]\n"),
        "m.csv:1:1: error[E1001]: the table has no row below its header\n\
         hint: for example a first line: angle [deg], slider [mm]"
    );
}

#[test]
fn columns_that_are_no_outputs_and_rows_outside_are_told() {
    let text = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let mechanism = Mechanism::new(&model, &model.quantities.nominal()).expect("it compiles");
    let outputs = columns(&mechanism.model);
    let outputs: Vec<_> = outputs.iter().map(|column| (column.name.as_str(), &column.unit)).collect();
    let table =
        MeasuredTable::from_text("m.csv", "angle [deg], slidr [mm], pin_force [mm]\n0, 1, 2\n").expect("a table");
    assert_eq!(
        table.check(&outputs).expect_err("other columns").to_string(),
        "m.csv:1:14: error[E1001]: the model has no output 'slidr'\nhint: did you mean 'slider'?\n\
         m.csv:1:26: error[E1001]: the column 'pin_force' is a length; the output is in N"
    );
    let table = MeasuredTable::from_text("m.csv", "angle [deg], slider [mm]\n10, 1\n400, 2\n").expect("a table");
    assert_eq!(
        compare_with_measured(&table, &mut ideal_run(0.0)).expect_err("beyond a turn").to_string(),
        "m.csv:3:1: error[E1002]: angle 400 deg is outside the recorded range, 0 deg to 360 deg\n\
         hint: record more turns with --turns, or shorten the table"
    );
}
