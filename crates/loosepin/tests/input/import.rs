//! Drawings become models: a four-bar drawn, imported, filled in and moved; drawings that are no mechanisms.

use std::fmt::Write;

use loosepin::import::{ImportOptions, import_dxf, write_model};
use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::simulate::{Plan, Settings, simulate};

/// Lines, polylines and circles as the text of a DXF file.
struct Sketch(String);

impl Sketch {
    /// An empty sketch in the unit of this number: 4 millimetres, 1 inches, 0 none.
    fn new(unit: u8) -> Self {
        Self(format!(
            "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n{unit}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
        ))
    }

    fn line(mut self, layer: &str, [x1, y1, x2, y2]: [f64; 4]) -> Self {
        let _ = write!(self.0, "0\nLINE\n8\n{layer}\n10\n{x1}\n20\n{y1}\n11\n{x2}\n21\n{y2}\n");
        self
    }

    fn circle(mut self, layer: &str, [x, y, radius]: [f64; 3]) -> Self {
        let _ = write!(self.0, "0\nCIRCLE\n8\n{layer}\n10\n{x}\n20\n{y}\n40\n{radius}\n");
        self
    }

    fn polygon(mut self, layer: &str, vertices: &[[f64; 2]]) -> Self {
        let _ = write!(self.0, "0\nLWPOLYLINE\n8\n{layer}\n90\n{}\n70\n1\n", vertices.len());
        for [x, y] in vertices {
            let _ = write!(self.0, "10\n{x}\n20\n{y}\n");
        }
        self
    }

    fn text(&self) -> String {
        format!("{}0\nENDSEC\n0\nEOF\n", self.0)
    }
}

const A: [f64; 2] = [3.5, -2.25];
const B: [f64; 2] = [23.5, 32.391];
const C: [f64; 2] = [103.5, 92.75];
const D: [f64; 2] = [123.5, 7.75];
const E: [f64; 2] = [63.5, 107.75];

/// A four-bar: crank AB, coupler BC with the tracer E as a triangle, rocker DC.
fn four_bar(unit: u8) -> Sketch {
    Sketch::new(unit)
        .line("0", [A[0], A[1], B[0], B[1]])
        .polygon("0", &[B, C, E])
        // The rocker in two lines: they share an end where no circle is.
        .line("0", [D[0], D[1], 115.0, 50.0])
        .line("0", [115.0, 50.0, C[0], C[1]])
        .circle("Ground", [A[0], A[1], 5.0])
        .circle("0", [B[0], B[1], 4.0])
        .circle("0", [C[0], C[1], 4.5])
        .circle("ground", [D[0], D[1], 6.0])
        .circle("0", [E[0], E[1], 1.5])
}

fn options(unit: Option<&str>) -> ImportOptions {
    ImportOptions { unit: unit.map(str::to_owned), tolerance_m: 1e-5 }
}

fn imported(sketch: &Sketch) -> String {
    import_dxf("four-bar", sketch.text().as_bytes(), &options(None)).unwrap_or_else(|error| panic!("{error}")).model
}

/// The model with its numbers filled in.
fn filled_in(text: &str) -> Model {
    let text = text
        .replace("gravity = \"?\"", "gravity = \"9.81 m/s^2\"")
        .replace("mass = \"?\"", "mass = \"0.3 kg\"")
        .replace("inertia = \"?\"", "inertia = \"2e-4 kg m^2\"")
        .replace("[\"?\", \"?\"]", "[\"21 mm\", \"2 mm\"]")
        .replace("speed = \"?\"", "speed = \"600 rpm\"");
    Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}\n{text}"))
}

fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

/// Where a circle about `p` meets one about `q`, on the left of the way from p to q.
fn crossing(p: [f64; 2], r: f64, q: [f64; 2], s: f64) -> [f64; 2] {
    let d = distance(p, q);
    let along = (d * d + r * r - s * s) / (2.0 * d);
    let across = (r * r - along * along).sqrt();
    let [ex, ey] = [(q[0] - p[0]) / d, (q[1] - p[1]) / d];
    [p[0] + along * ex - across * ey, p[1] + along * ey + across * ex]
}

#[test]
fn analytic_a_four_bar_is_drawn_imported_filled_in_and_moved() {
    let text = imported(&four_bar(4));
    let model = filled_in(&text);
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((mechanism.degrees_of_freedom, model.bodies.len(), model.joints.len()), (1, 4, 4));
    assert_eq!(values[model.quantities.id("joint.joint3.bearing_radius").expect("the radius as drawn")], 4.5e-3);
    let plan = Plan {
        cycle: model.cycle.clone(),
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    let record = simulate(&mechanism, &values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record;
    let column = |name: &str| {
        &record.outputs.iter().find(|output| output.name == name).unwrap_or_else(|| panic!("no {name}")).value_si
    };
    let (x, y) = (column("p5 x"), column("p5 y"));
    // Circles about the joints, as the drawing has them: crank at its angle, C on the same side as drawn, E fixed to BC.
    let crank = distance(A, B);
    let start_rad = (B[1] - A[1]).atan2(B[0] - A[0]);
    const TOLERANCE_MM: f64 = 1e-7; // coordinates are written to 12 digits
    for row in [0, 45, 170, 263, 360] {
        let angle_rad = start_rad + f64::from(row as u32).to_radians();
        let b = [A[0] + crank * angle_rad.cos(), A[1] + crank * angle_rad.sin()];
        let c = crossing(b, distance(B, C), D, distance(D, C));
        let e = crossing(b, distance(B, E), c, distance(C, E));
        let error = distance(e, [1e3 * x[row], 1e3 * y[row]]);
        assert!(error < TOLERANCE_MM, "row {row}: {error} mm");
    }
    assert!((1e3 * x[0] - E[0]).abs() < TOLERANCE_MM && (1e3 * y[0] - E[1]).abs() < TOLERANCE_MM);
}

#[test]
fn what_no_drawing_tells_is_asked_for_at_its_place() {
    let text = imported(&four_bar(4));
    let said = Model::from_text("model.toml", &text).expect_err("numbers are missing").to_string();
    let lines: Vec<&str> = said.lines().filter(|line| line.contains("error[")).collect();
    // Gravity, four numbers of each of three links, the speed; each at its own place.
    assert_eq!(lines.len(), 1 + 3 * 4 + 1, "{said}");
    assert!(lines.iter().all(|line| line.ends_with(" is still to be filled in")), "{said}");
    assert!(said.contains("model.toml:4:11: error[E0209]: gravity is still to be filled in"), "{said}");
    assert!(said.contains("error[E0209]: body 'link2': mass is still to be filled in"), "{said}");
}

#[test]
fn units_come_from_the_drawing_or_from_outside() {
    let drawing = four_bar(1).text();
    let inches = import_dxf("x", drawing.as_bytes(), &options(None)).unwrap_or_else(|error| panic!("{error}"));
    assert!(inches.model.contains("bearing_radius = \"5 in\""), "{}", inches.model);
    assert_eq!(inches.notes, ["3 links, 4 joints, 1 point on links; lengths in in"]);
    let given = import_dxf("x", drawing.as_bytes(), &options(Some("cm"))).unwrap_or_else(|error| panic!("{error}"));
    assert!(given.model.contains("bearing_radius = \"5 cm\""));
}

fn refused(sketch: &Sketch) -> String {
    import_dxf("x", sketch.text().as_bytes(), &options(None)).expect_err("no mechanism").to_string()
}

#[test]
fn drawings_that_are_no_mechanisms_are_told_with_their_places() {
    let error = |bytes: &[u8], unit| import_dxf("x", bytes, &options(unit)).expect_err("no drawing").to_string();
    assert_eq!(error(b"", None), "the drawing has no line, polyline or circle");
    let text = error(b"a model is no drawing\n", None);
    assert!(text.starts_with("the drawing cannot be read as DXF: "), "{text}");
    let broken = four_bar(4).text().replace("10\n23.5", "10\ntwenty");
    assert_eq!(
        error(broken.as_bytes(), None),
        "the drawing cannot be read as DXF: line 40: 'twenty' is not a number; the value of a group 10 is"
    );
    assert_eq!(refused(&four_bar(0)), "the drawing does not give its unit: $INSUNITS is not set");
    assert_eq!(refused(&four_bar(18)), "the drawing is in AstronomicalUnits, a unit that models do not support");
    assert_eq!(error(four_bar(4).text().as_bytes(), Some("kg")), "'kg' is not a unit of length");
    assert_eq!(refused(&Sketch::new(4)), "the drawing has no line, polyline or circle");
    assert_eq!(
        refused(&Sketch::new(4).circle("ground", [1.5, 2.0, 3.0])),
        "the drawing has no line or polyline beside the ground"
    );
    let line = || Sketch::new(4).line("0", [1.5, 2.0, 31.5, 2.0]);
    assert_eq!(refused(&line()), "the drawing has no circle");
    assert_eq!(refused(&line().circle("ground", [1.5, 2.5, 3.0])), "no link meets the circle at (1.5, 2.5) mm");
    assert_eq!(refused(&line().circle("0", [1.5, 2.0, 3.0])), "no circle on the layer 'ground' meets a link");
    assert_eq!(refused(&line().circle("0", [1.5, 2.0, 0.0])), "the circle at (1.5, 2) mm has no radius");
    assert_eq!(
        refused(&line().circle("ground", [1.5, 2.0, 3.0]).circle("0", [1.5, 2.0, 2.9])),
        "two circles have their centre at (1.5, 2) mm"
    );
    assert_eq!(
        refused(&line().circle("ground", [1.5, 2.0, 3.0]).line("0", [50.0, 4.0, 60.0, 4.0])),
        "the link from (50, 4) mm meets no circle"
    );
    assert_eq!(refused(&line().line("0", [5.0, 4.0, 5.0, 4.0])), "the line at (5, 4) mm has no length");
    let mirrored = line().circle("ground", [-1.5, 2.0, 3.0]).text().replace("40\n3\n", "40\n3\n230\n-1\n");
    assert!(import_dxf("x", mirrored.as_bytes(), &options(None)).is_ok(), "x of a mirrored circle is turned round");
    assert_eq!(
        error(mirrored.replace("230\n-1\n", "210\n1\n230\n1\n").as_bytes(), None),
        "the circle at (-1.5, 2) mm lies in a plane that is inclined to that of the drawing"
    );
    let lifted = line().circle("ground", [1.5, 2.0, 3.0]).text().replace("20\n2\n40", "20\n2\n30\n7\n40");
    assert_eq!(
        error(lifted.as_bytes(), None),
        "the circle at (1.5, 2) mm does not lie in the plane of the others: its z differs"
    );
}

#[test]
fn damaged_drawings_are_refused_or_read_and_never_a_panic() {
    let text = four_bar(4).text();
    for end in 0..text.len() {
        let _ = import_dxf("x", &text.as_bytes()[..end], &options(None));
    }
    for line in 0..text.lines().count() {
        for instead in ["", "-1", "999999999999", "SECTION", "é"] {
            let damaged: Vec<&str> =
                text.lines().enumerate().map(|(number, kept)| if number == line { instead } else { kept }).collect();
            let _ = import_dxf("x", damaged.join("\n").as_bytes(), &options(None));
        }
    }
}

#[test]
fn a_model_that_is_there_is_not_overwritten() {
    let folder = tempfile::tempdir().expect("a folder for the test");
    let path = write_model(&folder.path().join("new"), "name = \"x\"\n").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(std::fs::read_to_string(&path).expect("written"), "name = \"x\"\n");
    let said = write_model(&folder.path().join("new"), "name = \"y\"\n").expect_err("it is there").to_string();
    assert!(said.ends_with("model.toml already exists; it is not overwritten"), "{said}");
}
