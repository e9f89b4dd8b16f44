//! The work of requests of the page grows as the texts do, also for texts that were written to be slow. Counted are the bytes, names and
//! entries that were looked at and the operations that were evaluated ([`work`]), and the bytes of memory that were asked for: no time.
//!
//! `just campaign lengths` measures the times of longer texts.

mod allocated;

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use allocated::allocated_bytes;
use loosepin::templates::find_template;
use loosepin::work;

use crate::drawing::still::NamedPoses;
use crate::edit::{Edit, restructured, set_uncertainty};
use crate::files::folder::Folder;
use crate::messages::{Grip, Held, Look, SentText};
use crate::view::look::answer_look;
use crate::view::texts::Texts;

/// What a text of twice the length costs more may be this many times what the first doubling cost more: twice as much where work grows
/// as the text, four times as much where it grows as its square.
const MAX_GROWTH: f64 = 3.0;
/// Length of the shortest text, bytes: names that are suggested are looked for among 500 at most, which longer texts all have.
const SHORT: usize = 8_000;
/// What a doubling may cost more for each of its bytes in any case: so little says nothing.
const FEW: f64 = 10.0;
/// Shapes whose bodies hang on nothing: each has coordinates, and the equations of all of them are a dense matrix, of which the memory grows
/// with their square. A model has 1000 bodies at most.
const DENSE: [&str; 2] = ["links with numbers", "bodies"];
/// Shapes whose shortest text is twice as long, so that all three have more than the 1000 bodies of a model and are refused alike.
const REFUSED: [&str; 2] = ["bad names", "bodies without anything"];
/// Questions about every kind of text, and those of which each kind is asked one in turn; the others are measured only.
const ALWAYS: [&str; 2] = ["look", "remove a body"];
const IN_TURN: [&str; 4] = ["drag a pin", "know in part", "join", "rename a body"];

/// A line, or a piece of one, by its number.
type NumberedText = fn(usize) -> String;

/// A text that grows by pieces.
struct Shape {
    name: &'static str,
    /// What is put into the model: before the pieces, each of them, behind them; at the top, before the first table.
    top: Option<(&'static str, NumberedText, &'static str)>,
    /// The same at the end of the model.
    model: Option<(&'static str, NumberedText, &'static str)>,
    /// The same at the end of the study.
    study: Option<(&'static str, NumberedText, &'static str)>,
}

const PLAIN: Shape = Shape { name: "", top: None, model: None, study: None };

const fn top(name: &'static str, before: &'static str, piece: NumberedText, behind: &'static str) -> Shape {
    Shape { name, top: Some((before, piece, behind)), ..PLAIN }
}

const fn model(name: &'static str, before: &'static str, piece: NumberedText, behind: &'static str) -> Shape {
    Shape { name, model: Some((before, piece, behind)), ..PLAIN }
}

const fn study(name: &'static str, before: &'static str, piece: NumberedText, behind: &'static str) -> Shape {
    Shape { name, study: Some((before, piece, behind)), ..PLAIN }
}

/// No shape adds joints to a mechanism that moves: loops cost what they cost, and not what their text does.
const SHAPES: &[Shape] = &[
    model("one comment", "# ", |_| "x".into(), "\n"),
    model("short comments", "", |_| "#\n".into(), ""),
    model("blank lines", "", |_| "\r\n".into(), ""),
    model("spaces", "#", |_| " ".into(), "\n"),
    model("µ in comments", "", |_| "# µ𝛼ü\n".into(), ""),
    study("comments of the study", "", |_| "# µ𝛼ü\n".into(), ""),
    top("unknown keys", "", |n| format!("k{n} = {n}\n"), ""),
    top("unknown keys with CRLF", "", |n| format!("k{n} = {n}\r\n"), ""),
    top("nearly known keys", "", |n| format!("gravit{n} = {n}\n"), ""),
    model("unknown tables", "", |n| format!("[k{n}]\n"), ""),
    model("unknown keys of a body", "[body.extra]\n", |n| format!("k{n} = {n}\n"), ""),
    model("unknown keys in a line", "[body.extra]\nk = { ", |n| format!("k{n} = {n}, "), "z = 1 }\n"),
    model("µ in unknown keys", "[body.extra]\n", |n| format!("\"µ{n}\" = {n}\n"), ""),
    top("bad names", "[body]\n", |n| format!("\"b {n}\" = {{}}\n"), ""),
    top("parameters", "[parameter]\n", |n| format!("p{n} = \"{n} mm\"\n"), "\n"),
    top("locked parameters", "[parameter]\n", |n| format!("p{n} = \"{n} mm\"  # locked\n"), "\n"),
    top("parameters that are sums", "[parameter]\nq = \"1 mm\"\n", |n| format!("p{n} = \"q + {n} mm\"\n"), "\n"),
    top(
        "a chain of parameters",
        "[parameter]\np = \"1 mm\"\np0 = \"p\"\n",
        |n| format!("p{} = \"p{n}\"\n", n + 1),
        "\n",
    ),
    top("parameters of nothing", "[parameter]\n", |n| format!("p{n} = \"none{n}\"\n"), "\n"),
    top("parameters with errors", "[parameter]\n", |n| format!("p{n} = \"{n} mn\"\n"), "\n"),
    top("one long sum", "[parameter]\np = \"1 mm", |_| " + 1 mm".into(), "\"\n"),
    top("one long sum of names", "[parameter]\nq = \"1 mm\"\np = \"q", |_| " + q".into(), "\"\n"),
    top("brackets of a sum", "[parameter]\np = \"", |_| "(".into(), "\"\n"),
    top("signs of a sum", "[parameter]\np = \"", |_| "-".into(), "1 mm\"\n"),
    top("powers of a sum", "[parameter]\np = \"1", |_| "^1".into(), "\"\n"),
    top("a number of many digits", "[parameter]\np = \"", |_| "1".into(), " mm\"\n"),
    top("a unit of many letters", "[parameter]\np = \"1 ", |_| "m".into(), "\"\n"),
    top("a list of numbers", "gravity = [", |n| format!("{n}, "), "]\n"),
    top("a list of texts", "gravity = [", |n| format!("\"{n} mm\", "), "]\n"),
    top("nested lists", "gravity = ", |_| "[".into(), "\n"),
    top("nested braces", "gravity = ", |_| "{a=".into(), "\n"),
    top("texts that never end", "", |n| format!("k{n} = \"x\n"), ""),
    top("a text that never ends", "k = \"", |_| "x".into(), "\n"),
    top("three quotes that never end", "k = \"\"\"", |n| format!("x{n}\n"), "\n"),
    top("three apostrophes that never end", "k = '''", |n| format!("x{n} ''\n"), "\n"),
    top("quotes of a long text", "name = '''", |_| "\"\" ".into(), "'''\n"),
    top("escapes of a text", "name = \"", |_| "\\\"".into(), "\"\n"),
    top("quotes in a line", "", |_| "\"".into(), "\n"),
    top("apostrophes in a line", "", |_| "'".into(), "\n"),
    top("triple apostrophes in a line", "k = ", |_| "''' ".into(), "\n"),
    top("equals signs in a line", "k ", |_| "= ".into(), "\n"),
    top("commas in a line", "k = [", |_| ",".into(), "]\n"),
    top("lines of no meaning", "", |_| "?\n".into(), ""),
    top("lines of no meaning with µ", "", |n| format!("µ {n}\n"), ""),
    top("the same key", "", |_| "same = 1\n".into(), ""),
    model("the same table", "", |_| "[same]\n".into(), ""),
    top("control characters", "k = \"", |_| "\u{1}".into(), "\"\n"),
    top("a deep key", "a", |_| ".a".into(), " = 1\n"),
    model("a deep header", "[a", |_| ".a".into(), "]\nk = 1\n"),
    model("below a long header", "[a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s.t]\n", |n| format!("k{n}=1\n"), ""),
    Shape {
        name: "below a deep header",
        top: Some(("[body.extra.a", |_| ".a".into(), "]\n")),
        model: Some(("", |n| format!("k{n}=1\n"), "")),
        ..PLAIN
    },
    Shape {
        name: "expressions that use the same ones",
        top: Some((
            "[parameter]\np0 = \"1 mm\"\nq0 = \"2 mm\"\n",
            |n| format!("p{} = \"(p{n} + q{n}) / 2\"\nq{} = \"(q{n} + 2 * p{n}) / 3\"\n", n + 1, n + 1),
            "\n",
        )),
        model: Some((
            "[body.extra]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = { a = [\"0 mm\", \"0 mm\"], b = [\"p29\", \"0 mm\"] }\n",
            |_| "#\n".into(),
            "",
        )),
        ..PLAIN
    },
    top("parameters behind parameters", "[parameter]\n", |n| format!("p{n} = \"1 mm + p{}\"\n", n + 1), "\n"),
    model(
        "links with numbers",
        "",
        |n| {
            format!(
                "[body.link_{n}]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\npoints = {{ a = [\"0 mm\", \"0 mm\"] }}\n"
            )
        },
        "",
    ),
    model(
        "loads at a body",
        "",
        |n| format!("[load.l{n}]\nkind = \"torque\"\nbody = \"coupler\"\ntorque = \"1 N m\"\n"),
        "",
    ),
    top("dotted keys", "", |n| format!("a.k{n} = 1\n"), ""),
    top("dotted keys of a body", "", |n| format!("body.extra.k{n} = 1\n"), ""),
    model(
        "bodies",
        "",
        |n| format!("[body.b{n}]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\npoints = {{ a = [\"0 mm\", \"0 mm\"] }}\n"),
        "",
    ),
    model("bodies without anything", "", |n| format!("[body.b{n}]\n"), ""),
    model("bodies that are numbers", "", |n| format!("body.b{n} = {n}\n"), ""),
    model(
        "points",
        "[body.extra]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\n[body.extra.points]\n",
        |n| format!("p{n} = [\"{n} mm\", \"0 mm\"]\n"),
        "",
    ),
    model(
        "contacts",
        "",
        |n| {
            format!(
                "[contact.c{n}]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.85\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\n"
            )
        },
        "",
    ),
    model("contacts of no law", "", |n| format!("[contact.c{n}]\nlaw = \"lankarani-nikravech\"\n"), ""),
    model(
        "joints of nothing",
        "",
        |n| format!("[joint.j{n}]\nkind = \"revolute\"\nbearing = \"a.b\"\njournal = \"crank.pim\"\n"),
        "",
    ),
    model("outputs", "", |n| format!("[output.o{n}]\nangle_of = \"rocker\"\n"), ""),
    model("outputs of nothing", "", |n| format!("[output.o{n}]\nangle_of = \"rokker\"\n"), ""),
    model(
        "springs",
        "",
        |n| {
            format!(
                "[spring.s{n}]\nkind = \"linear\"\nfirst = \"ground.crank_pivot\"\nsecond = \"rocker.pin\"\nstiffness = \"1 N/mm\"\nfree_length = \"300 mm\"\n"
            )
        },
        "",
    ),
    model(
        "loads",
        "",
        |n| format!("[load.l{n}]\nkind = \"force\"\npoint = \"rocker.pin\"\nforce = \"1 N\"\ndirection = \"0 deg\"\n"),
        "",
    ),
    model("drives", "", |n| format!("[drive.d{n}]\njoint = \"crank_pivot\"\nspeed = \"600 rpm\"\n"), ""),
    model("tables that are not there", "", |n| format!("[load.l{n}]\nkind = \"force\"\nforce = \"m{n}.csv\"\n"), ""),
    study(
        "requirements",
        "",
        |_| {
            "[[require]]\noutput = \"rocker\"\nof = \"total\"\nwithin = \"0.35 deg\"\nover = \"cycle\"\nprobability_at_least = 0.95\n".into()
        },
        "",
    ),
    study("requirements of nothing", "", |n| format!("[[require]]\noutput = \"o{n}\"\n"), ""),
    study("empty requirements", "", |_| "[[require]]\n".into(), ""),
    study(
        "questions",
        "",
        |_| "[[ask]]\noutput = \"rocker\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n".into(),
        "",
    ),
    study("questions of nothing", "", |n| format!("[[ask]]\noutput = \"roker{n}\"\nstatistics = [\"meen\"]\n"), ""),
    study(
        "correlations",
        "",
        |_| "[[correlation]]\nof = [\"parameter.crank_length\", \"parameter.rocker_length\"]\nis = 0.5\n".into(),
        "",
    ),
    study("measured tables", "", |n| format!("[[measured]]\nfile = \"m{n}.csv\"\n"), ""),
    study("one table many times", "", |_| "[[measured]]\nfile = \"model.csv\"\n".into(), ""),
    study("unknown keys of the study", "[extra]\n", |n| format!("k{n} = {n}\n"), ""),
    study("unknown tables of the study", "", |n| format!("[k{n}]\n"), ""),
    study("syntax errors of the study", "", |n| format!("k{n} = \n"), ""),
    Shape {
        name: "paths that are not there",
        study: Some(("", |n| format!("\"parameter.p{n}\" = {{ interval = [\"1 mm\", \"2 mm\"] }}\n"), "")),
        ..PLAIN
    },
    Shape { name: "paths that are not one", study: Some(("", |n| format!("\"p{n}\" = 1\n"), "")), ..PLAIN },
    Shape {
        name: "parameters that are unknown",
        top: Some(("[parameter]\n", |n| format!("p{n} = \"{n}1 mm\"\n"), "\n")),
        study: Some(("", |n| format!("\"parameter.p{n}\" = {{ interval = [\"1 mm\", \"2 mm\"] }}\n"), "")),
        ..PLAIN
    },
    Shape {
        name: "parameters that scatter",
        top: Some(("[parameter]\n", |n| format!("p{n} = \"{n}1 mm\"\n"), "\n")),
        study: Some((
            "[random]\n",
            |n| format!("\"parameter.p{n}\" = {{ normal = {{ mean = \"1 mm\", standard_deviation = \"1 um\" }} }}\n"),
            "",
        )),
        ..PLAIN
    },
    Shape {
        name: "outputs that are asked for",
        model: Some(("", |n| format!("[output.o{n}]\nangle_of = \"rocker\"\n"), "")),
        study: Some((
            "[[ask]]\noutput = \"rocker\"\nstatistics = [\"mean\"]\n",
            |n| format!("[[ask]]\noutput = \"o{n}\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n"),
            "",
        )),
        ..PLAIN
    },
];

const STUDY: &str = "name = \"hostile\"\nmodel = \"model.toml\"\nseed = 1\n[sampling]\nouter = 16\ninner = 256\n\
    [[ask]]\noutput = \"rocker\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n\
    [random]\n\"parameter.crank_length\" = { normal = { mean = \"80 mm\", standard_deviation = \"0.015 mm\" } }\n\
    [epistemic]\n\"joint.rocker_pin.radial_clearance\" = { interval = [\"0.03 mm\", \"0.15 mm\"] }\n";

fn grown((before, piece, behind): (&str, NumberedText, &str), bytes: usize) -> String {
    let mut text = before.to_owned();
    let mut number = 0;
    while text.len() < bytes {
        text.push_str(&piece(number));
        number += 1;
    }
    text + behind
}

impl Shape {
    /// Model and study of about `bytes` bytes.
    fn texts(&self, bytes: usize) -> (String, String) {
        let four_bar = find_template("four-bar").unwrap().model;
        let (head, tables) = four_bar.split_once("[parameter]").unwrap();
        let of = |part: Option<(&'static str, NumberedText, &'static str)>| {
            part.map_or(String::new(), |part| grown(part, bytes))
        };
        let top = of(self.top);
        let (top, tables) = match top.strip_prefix("[parameter]") {
            // Those of the template come with them.
            Some(entries) => (String::new(), format!("[parameter]{entries}{}", tables.split_once('\n').unwrap().1)),
            None if top.starts_with('[') => (String::new(), format!("[parameter]{tables}\n{top}")),
            None => (top, format!("[parameter]{tables}")),
        };
        let model = format!("{head}{top}{tables}\n{}", of(self.model));
        let own = of(self.study);
        let study = match own.strip_prefix("[random]\n") {
            Some(entries) => STUDY.replace("[random]\n", &format!("[random]\n{entries}")),
            None => format!("{STUDY}{own}"),
        };
        (model, study)
    }
}

/// A request on texts.
type Question = (&'static str, fn(&Folder, &str, &str));

fn sent(path: &str, text: &str) -> SentText {
    SentText { path: path.to_owned(), text: text.to_owned() }
}

fn looked(folder: &Folder, model: &str, study: &str, held: Option<Held>) {
    let poses = || vec![[0.0; 3], [0.0, 0.0, 34.0], [66.0, 45.0, 40.0], [300.0, 0.0, 94.0]];
    let grip = held.map(|held| Grip { held, to_mm: [70.0, 50.0], step_mm: 1.0, is_free: false, poses: poses() });
    let (model, study) = (sent("model.toml", model), Some(sent("study.toml", study)));
    let poses = Some(NamedPoses::from([("crank".to_owned(), [0.0, 0.0, 30.0])]));
    let stop = AtomicBool::new(false);
    let (seen, _) = answer_look(folder, &Look { grip, poses, ..Look::of(model, study, 12) }, &stop);
    assert!(!serde_json::to_string(&seen).unwrap().is_empty());
}

fn edited(folder: &Folder, model: &str, study: &str, edit: serde_json::Value) {
    let edit: Edit = serde_json::from_value(edit).unwrap();
    let look = Look::of(sent("model.toml", model), Some(sent("study.toml", study)), 12);
    let _ = restructured(folder, &Texts::sent(folder, &look), &edit, &NamedPoses::new());
}

fn known(folder: &Folder, model: &str, study: &str, path: &str, text: &str) {
    let look = Look::of(sent("model.toml", model), Some(sent("study.toml", study)), 12);
    let _ = set_uncertainty(folder, &Texts::sent(folder, &look), path, text);
}

macro_rules! edit {
    ($name:literal, $($json:tt)+) => {
        ($name, |folder, model, study| edited(folder, model, study, serde_json::json!($($json)+)))
    };
}

const QUESTIONS: &[Question] = &[
    ("look", |folder, model, study| looked(folder, model, study, None)),
    ("drag a pin", |folder, model, study| {
        looked(folder, model, study, Some(Held::Joint { joint: "crank_pin".into() }));
    }),
    ("drag a point", |folder, model, study| {
        looked(folder, model, study, Some(Held::Point { body: "coupler".into(), point: "tracer".into() }));
    }),
    ("know exactly", |folder, model, study| known(folder, model, study, "parameter.crank_length", "81 mm")),
    ("know in part", |folder, model, study| known(folder, model, study, "parameter.rocker_length", "170..190 mm")),
    ("give play", |folder, model, study| known(folder, model, study, "joint.crank_pin.radial_clearance", "0.1 mm")),
    edit!("add a link", {"kind": "add_link", "from": {"at": "point", "body": "coupler", "point": "tracer"}, "to": {"at": "on", "body": "ground", "x": 300.0, "y": 300.0}}),
    edit!("add a point", {"kind": "add_point", "body": "coupler", "to": {"at": "free", "x": 1.0, "y": 2.0}}),
    edit!("join", {"kind": "join", "first": {"at": "point", "body": "coupler", "point": "tracer"}, "second": {"at": "point", "body": "ground", "point": "rocker_pivot"}, "by": {"as": "pin", "play": "0.1 mm"}}),
    edit!("add a block", {"kind": "add_block", "on": {"at": "point", "body": "coupler", "point": "tracer"}, "angle_deg": 10.0}),
    edit!("drive", {"kind": "drive", "joint": "rocker_pivot"}),
    edit!("watch", {"kind": "watch", "what": {"of": "angle", "body": "coupler"}}),
    edit!("remove a body", {"kind": "remove", "what": {"table": "body", "name": "coupler"}}),
    edit!("remove an output", {"kind": "remove", "what": {"table": "output", "name": "tracer"}}),
    edit!("rename a body", {"kind": "rename", "what": {"table": "body", "name": "rocker"}, "to": "lever"}),
    edit!("rename a point", {"kind": "rename", "what": {"table": "body", "name": "rocker", "point": "pin"}, "to": "end"}),
    edit!("lock", {"kind": "lock", "path": "parameter.crank_length", "is_locked": true}),
];

fn folder() -> (tempfile::TempDir, Folder) {
    let desk = tempfile::tempdir().unwrap();
    std::fs::write(desk.path().join("model.csv"), "1\n2\n").unwrap();
    let folder = Folder::new(desk.path()).unwrap();
    (desk, folder)
}

/// What a question has cost.
#[derive(Clone, Copy, Debug)]
struct Cost {
    /// Bytes, names and entries that were looked at, and operations that were evaluated.
    looked_at: u64,
    allocated_bytes: u64,
}

fn cost(folder: &Folder, question: &Question, (model, study): &(String, String)) -> Cost {
    let before = (work::count(), allocated_bytes());
    question.1(folder, model, study);
    Cost { looked_at: work::count() - before.0, allocated_bytes: allocated_bytes() - before.1 }
}

/// By how much more the second doubling of a text has raised a count than the first. What does not depend on the length falls out.
fn growth(counts: [u64; 3]) -> f64 {
    let [short, middle, long] = counts.map(|count| count as f64);
    (long - middle) / (middle - short).max(FEW * SHORT as f64)
}

#[test]
fn no_question_costs_the_square_of_the_length() {
    let (_desk, folder) = folder();
    let mut steep = Vec::new();
    for (number, shape) in SHAPES.iter().enumerate() {
        let is_asked = |name: &str| ALWAYS.contains(&name) || IN_TURN[number % IN_TURN.len()] == name;
        let shortest = if REFUSED.contains(&shape.name) { 2 * SHORT } else { SHORT };
        let texts = [1, 2, 4].map(|times| shape.texts(times * shortest));
        for question in QUESTIONS.iter().filter(|question| is_asked(question.0)) {
            let costs = [0, 1, 2].map(|place| cost(&folder, question, &texts[place]));
            let words = format!("{}, {}", shape.name, question.0);
            assert!(costs[0].looked_at >= SHORT as u64, "{words}: nothing was counted");
            for (what, counts) in [
                ("looked at", costs.map(|cost| cost.looked_at)),
                ("bytes allocated", costs.map(|cost| cost.allocated_bytes)),
            ] {
                let is_dense = what == "bytes allocated" && DENSE.contains(&shape.name);
                if growth(counts) > MAX_GROWTH && !is_dense {
                    steep.push(format!("{words}: {counts:?} {what}, growth {:.1}", growth(counts)));
                }
            }
        }
    }
    assert!(
        steep.is_empty(),
        "at texts of 1, 2 and 4 times {SHORT} bytes, work grows faster than the text:\n{}",
        steep.join("\n")
    );
}

/// Processor time of this thread, which other tests do not lengthen; the time by the clock where the system does not say.
fn now(began: Instant) -> Duration {
    let of_thread = std::fs::read_to_string("/proc/thread-self/schedstat");
    let nanoseconds = of_thread.ok().and_then(|text| text.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| began.elapsed(), Duration::from_nanos)
}

fn time(folder: &Folder, question: &Question, (model, study): &(String, String)) -> Duration {
    let began = Instant::now();
    let before = now(began);
    question.1(folder, model, study);
    now(began) - before
}

/// Prints the times of each length, where they grow faster than it: `just campaign lengths`.
#[test]
#[ignore = "measures for minutes"]
fn lengths_and_their_times() {
    let (_desk, folder) = folder();
    let only = std::env::var("LOOSEPIN_SHAPE").unwrap_or_default();
    let asked = std::env::var("LOOSEPIN_QUESTIONS").unwrap_or_default();
    let all = std::env::var("LOOSEPIN_ALL").is_ok();
    let sizes = std::env::var("LOOSEPIN_LENGTHS").unwrap_or_else(|_| "25000 50000 100000 200000".into());
    let sizes: Vec<usize> = sizes.split(' ').map(|bytes| bytes.parse().unwrap()).collect();
    for shape in SHAPES.iter().filter(|shape| shape.name.contains(&only)) {
        for question in
            QUESTIONS.iter().filter(|question| asked.is_empty() || asked.split(',').any(|one| one == question.0))
        {
            let mut line = format!("{:32} {:18}", shape.name, question.0);
            let mut last = 0.0;
            let mut worst = 0.0_f64;
            let mut ms = 0.0;
            for bytes in sizes.iter().copied() {
                ms = time(&folder, question, &shape.texts(bytes)).as_secs_f64() * 1e3;
                line.push_str(&format!(" {ms:9.2}"));
                if last > 4.0 {
                    worst = worst.max(ms / last);
                }
                last = ms;
                if ms > 1500.0 {
                    break;
                }
            }
            if all || worst > 2.6 || ms > 1500.0 {
                println!("{line}  worst {worst:.1}");
            }
        }
    }
}
