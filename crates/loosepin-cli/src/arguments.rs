//! Commands and flags. One line of help per flag, with unit and default.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use loosepin::diagnostics::Code;
use loosepin::model::Rule;
use loosepin::simulate::EXPONENT_TURNS;
use loosepin::store::Shard;
use loosepin::sweep::{SWEEP_POINTS, SWEEP_TRANSIENT_TURNS, SWEEP_TURNS};
use loosepin::templates::{Template, all_templates, find_template};

/// Accuracy of mechanisms with tolerances and joint play
#[derive(Debug, Parser)]
#[command(
    name = "loosepin",
    version = env!("LOOSEPIN_VERSION"),
    propagate_version = false,
    max_term_width = 110,
    disable_help_subcommand = true,
    after_help = "Start with:\n  \
        loosepin new slider-crank my_mechanism\n  \
        loosepin check my_mechanism/model.toml\n  \
        loosepin simulate my_mechanism/model.toml\n  \
        loosepin study my_mechanism/study.toml\n\n\
        Exit status: 0 success; 1 a requirement of the study is not met or is undecided, or no play explains the readings; 2 error; 3 the \
        shards are merged and must run another round; 4 out of memory; 130 interrupted."
)]
pub struct Arguments {
    /// Command.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    New(NewArguments),
    Import(ImportArguments),
    Check(CheckArguments),
    Motion(MotionArguments),
    Simulate(SimulateArguments),
    Wear(WearArguments),
    Study(StudyArguments),
    Merge(MergeArguments),
    Sweep(SweepArguments),
    Identify(IdentifyArguments),
    Cases(CasesArguments),
    Report(ReportArguments),
    #[cfg(feature = "studio")]
    Serve(ServeArguments),
    Export(ExportArguments),
    Schema(SchemaArguments),
    Explain(ExplainArguments),
    Completions(CompletionsArguments),
    Manual(ManualArguments),
}

/// Write a model.toml and a study.toml from a template
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  loosepin new --list\n  loosepin new four-bar my_mechanism")]
pub struct NewArguments {
    /// Template; --list shows all templates
    #[arg(required_unless_present = "list", value_parser = template())]
    pub template: Option<&'static Template>,
    /// Output folder, created if it does not exist [default: the name of the template]
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// List the templates
    #[arg(long, conflicts_with_all = ["template", "folder"])]
    pub list: bool,
}

/// Make a model.toml from a drawing (DXF) or a robot description (URDF, MJCF)
#[derive(Debug, Args)]
#[command(
    after_help = "Drawings: lines are links, circles are joints. A polyline is one rigid link; so are lines that share an end without a \
    circle. A circle where links meet is a joint; its radius is that of the pin. A circle on one link only is a point of that link. The \
    layer 'ground' does not move. Masses, inertias, gravity and speed are written as \"?\": fill them in.\n\n\
    Robot descriptions become models in space. The root link is the ground, every joint that can be driven has a drive, and below each \
    joint stand the keys of its play as comments. The root element says whether a file is URDF or MJCF.\n\n\
    Examples:\n  loosepin import sketch.dxf\n  loosepin import sketch.dxf my_mechanism --unit mm\n  loosepin import robot.urdf my_robot"
)]
pub struct ImportArguments {
    /// Drawing (DXF) or robot description (URDF, MJCF)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Output folder for model.toml, created if it does not exist [default: the name of the file]
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Unit of the drawing [default: from its header]
    #[arg(long)]
    pub unit: Option<String>,
    /// Distance, with its unit, below which ends and centres coincide
    #[arg(long, value_name = "LENGTH", default_value = "0.01 mm", allow_hyphen_values = true)]
    pub tolerance: String,
}

/// Check model and study files and describe them in words
#[derive(Debug, Args)]
#[command(
    after_help = "Counts the degrees of freedom, closes the loops, moves the ideal mechanism through its cycle and starts the \
    dynamic run. For a study, it also shows the number of runs and the time they need.\n\n\
    Examples:\n  loosepin check model.toml\n  loosepin check model.toml study.toml"
)]
pub struct CheckArguments {
    /// Model or study files
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
}

/// Show the ideal motion and the quasi-static effect of play and tolerances
#[derive(Debug, Args)]
#[command(
    after_help = "Takes about a second; in space, proofs for requirements take longer. Shows the worst case of the play (the largest \
    deviation found, and a proven limit), its standard deviation, and the contribution of each joint. For a study, it also shows the \
    root sum of squares of the random inputs, and checks [[require]] without dynamics, in the plane also [allow]. Writes motion.csv, \
    summary.json and report.html.\n\n\
    Exit status 1: a requirement is not met in the worst case, or cannot be decided without dynamics.\n\n\
    Examples:\n  loosepin motion model.toml\n  loosepin motion model.toml --path coupler.tool\n  \
    loosepin motion study.toml --set joint.gudgeon.radial_clearance=0.3mm"
)]
pub struct MotionArguments {
    /// Model or study file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Change a quantity of the model, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Show the path of a point with the zone that play and scatter leave it, beside those of outputs; may be repeated
    #[arg(long = "path", value_name = "BODY.POINT")]
    pub path: Vec<String>,
    #[command(flatten)]
    pub shown: ShownArguments,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Simulate one mechanism with play and impacts
#[derive(Debug, Args)]
#[command(after_help = "Writes history.csv, impacts.csv, spectrum.csv, summary.json and report.html.\n\n\
    A second run, with a tenth of the tolerance and a method of another order, shows how long the positions can be trusted. It stops \
    where the two runs differ.\n\n\
    Examples:\n  \
    loosepin simulate model.toml\n  \
    loosepin simulate model.toml --set joint.gudgeon.radial_clearance=0.3mm --turns 3\n  \
    loosepin simulate model.toml --states --samples 1000 --out run1")]
pub struct SimulateArguments {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Change a quantity of the model, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Also record the path of a point, its velocity and its acceleration; may be repeated
    #[arg(long = "path", value_name = "BODY.POINT")]
    pub path: Vec<String>,
    /// Also record position, velocity and acceleration of every body
    #[arg(long)]
    pub states: bool,
    /// Turns to record [default: from the model]
    #[arg(long, value_name = "N", value_parser = recorded_turns, allow_negative_numbers = true)]
    pub turns: Option<f64>,
    /// Turns to run before recording [default: from the model]
    #[arg(long, value_name = "N", value_parser = transient_turns, allow_negative_numbers = true)]
    pub transient: Option<f64>,
    /// Samples in each turn, 1 to 1000000 [default: from the model]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), allow_negative_numbers = true)]
    pub samples: Option<u32>,
    /// Measure the largest Lyapunov exponent over N turns, 20 to 1000000
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(EXPONENT_TURNS), allow_negative_numbers = true)]
    pub lyapunov: Option<u32>,
    /// Error tolerance of positions, with its unit. The error of one step is limited to 0.5 % of it; impacts amplify errors
    #[arg(long, value_name = "LENGTH", default_value = "1e-9 m", allow_hyphen_values = true)]
    pub tolerance: String,
    /// Skip the second run, which shows how long the positions can be trusted
    #[arg(long)]
    pub no_second_run: bool,
    /// Integrator: explicit, or implicit for flexible bodies in absolute nodal coordinates whose motion is slow compared with the
    /// frequencies of their mesh
    #[arg(long, value_name = "KIND", value_enum, hide_possible_values = true, default_value_t = IntegratorKind::Explicit)]
    pub integrator: IntegratorKind,
    /// Measured curves to compare with the outputs, with a header such as "angle [deg], slider [mm]"; may be repeated
    #[arg(long, value_name = "CSV")]
    pub measured: Vec<PathBuf>,
    #[command(flatten)]
    pub shown: ShownArguments,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Integrators of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum IntegratorKind {
    /// Needs the fewest evaluations for rigid bodies, bodies with few mode shapes, and contacts
    Explicit,
    /// Between contacts, the frequencies of a mesh do not limit its steps
    Implicit,
}

/// Simulate a cycle and show the wear of its joints
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "Needs a joint with [joint.NAME.wear] in the model. Shows the friction path of one cycle, and the worn volumes and \
    largest depths after the cycles of [wear]. The geometry stays unworn, or with geometry = \"worn\" it wears during the cycles. Makes \
    the same run and files as loosepin simulate; wear.csv contains the depth of every sector.\n\n\
    Examples:\n  loosepin wear model.toml\n  loosepin wear model.toml --set wear.cycles=1e6 --turns 4"
)]
pub struct WearArguments {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Change a quantity of the model, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Turns in one cycle [default: from the model]
    #[arg(long, value_name = "N", value_parser = recorded_turns, allow_negative_numbers = true)]
    pub turns: Option<f64>,
    /// Turns to run before the cycle [default: from the model]
    #[arg(long, value_name = "N", value_parser = transient_turns, allow_negative_numbers = true)]
    pub transient: Option<f64>,
    /// Error tolerance of positions, with its unit. The error of one step is limited to 0.5 % of it; impacts amplify errors
    #[arg(long, value_name = "LENGTH", default_value = "1e-9 m", allow_hyphen_values = true)]
    pub tolerance: String,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Compute bounds of the deviation under all uncertain inputs
#[derive(Debug, Args)]
#[command(
    after_help = "Writes summary.json, bounds.csv, runs.parquet, timing.json and report.html. The results are the same \
    for any number of threads.\n\n\
    --resume continues after Ctrl-C, a crash or a power failure, with the same results. Finished runs are saved within a second. A \
    time budget starts again from zero.\n\n\
    --accuracy increases the samples, round by round, until the numerical error of the bounds is small enough. A value alone applies \
    to all bounds with this unit; OUTPUT=VALUE and OUTPUT.STATISTIC=VALUE apply to one output or statistic. If the budget ends first, the study shows the \
    accuracy reached and the runs needed; this is not an error.\n\n\
    --shard 2/7 runs the second of seven parts of the current round, in the folder RESULTS.shard-2-of-7. loosepin merge joins the \
    parts.\n\n\
    Exit status 1: the study is complete, and a requirement is not met or is undecided.\n\n\
    Examples:\n  loosepin study study.toml\n  loosepin study study.toml --threads 8 --out bounds\n  \
    loosepin study study.toml --accuracy 1um --budget 30min\n  \
    loosepin study study.toml --accuracy slider.mean=1um --accuracy 0.5% --budget 200000runs\n  \
    loosepin study study.toml --path coupler.tool\n  loosepin study study.toml --set parameter.crank_length=51mm\n  \
    loosepin study study.toml --shard 2/7 --resume"
)]
pub struct StudyArguments {
    /// Study file
    #[arg(value_name = "STUDY")]
    pub study: PathBuf,
    /// Continue a stopped study and keep its finished runs
    #[arg(long, conflicts_with = "force")]
    pub resume: bool,
    /// Run only shard I of N, in its own folder
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Change a quantity of the model, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", conflicts_with = "shard")]
    pub set: Vec<String>,
    /// Largest numerical error of the bounds, with its unit; may be repeated
    #[arg(long, value_name = "[OUTPUT[.STATISTIC]=]VALUE", allow_hyphen_values = true)]
    pub accuracy: Vec<String>,
    /// Limit of runs, time or rounds [default with --accuracy: 100 times the runs of a study without it, at most 1 GiB of results]
    #[arg(long, value_name = "RUNS|TIME|ROUNDS", allow_hyphen_values = true)]
    pub budget: Option<String>,
    /// Largest share of failed runs before the study ends with an error, above 0 and at most 1 [default: from the study]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub most_failed: Option<f64>,
    /// Show the path of a point with the zone that play and scatter leave it, without dynamics, beside those of outputs; may be repeated
    #[arg(long = "path", value_name = "BODY.POINT", conflicts_with = "shard")]
    pub path: Vec<String>,
    /// Number of threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub shown: ShownArguments,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Join the shards of a study
#[derive(Debug, Args)]
#[command(
    after_help = "Reads the folders of all shards, RESULTS.shard-1-of-N to RESULTS.shard-N-of-N. Writes the same bytes into RESULTS as \
    a study on one machine.\n\n\
    Exit status 3: the study needs another round. Run the shards again with --resume, then merge again.\n\n\
    Exit status 1: the study is complete, and a requirement is not met or is undecided.\n\n\
    Examples:\n  loosepin merge bounds.shard-*\n  loosepin merge results/worn-pin/1a2b3c4d.shard-*"
)]
pub struct MergeArguments {
    /// Folders of all shards
    #[arg(required = true, value_name = "FOLDER")]
    pub folders: Vec<PathBuf>,
    /// Study file [default: the study of the shards]
    #[arg(long, value_name = "STUDY")]
    pub study: Option<PathBuf>,
    /// Run rounds of up to N runs here instead of in shards; N is at most 8192
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(0..=8192))]
    pub small_round: u32,
    /// Largest share of failed runs before the study ends with an error, above 0 and at most 1 [default: from the study]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub most_failed: Option<f64>,
    /// Number of threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub shown: ShownArguments,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Simulate one mechanism for many values of one quantity
#[derive(Debug, Args)]
#[command(
    after_help = "Shows for each value whether the motion is periodic, and its impacts and forces. Samples the motion once a turn \
    (Poincaré section) and draws a bifurcation diagram. Writes \
    sections.csv, sweep.csv, summary.json and report.html. The results are the same for any number of threads.\n\n\
    Examples:\n  \
    loosepin sweep model.toml --over joint.gudgeon.radial_clearance=0.05mm..0.5mm\n  \
    loosepin sweep model.toml --over drive.crank.speed=500rpm..5000rpm --points 400 --transient 300"
)]
pub struct SweepArguments {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Quantity of the model with its first and last value, with units
    #[arg(long, value_name = "PATH=FROM..TO")]
    pub over: String,
    /// Number of values, both ends included, 2 to 100000
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(SWEEP_POINTS))]
    pub points: u32,
    /// Change another quantity of the model, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Turns of start-up, not examined, at most 1000000
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(SWEEP_TRANSIENT_TURNS))]
    pub transient: u32,
    /// Turns to examine, 2 to 100000
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(SWEEP_TURNS))]
    pub turns: u32,
    /// Error tolerance of positions, with its unit. The error of one step is limited to 0.5 % of it; impacts amplify errors
    #[arg(long, value_name = "LENGTH", default_value = "1e-8 m", allow_hyphen_values = true)]
    pub tolerance: String,
    /// Number of threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// How much of a result is printed.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct ShownArguments {
    /// Print all of the result; otherwise the answer, warnings and main tables
    #[arg(long)]
    pub all: bool,
}

/// Where results go.
#[derive(Debug, Clone, Args)]
pub struct OutputArguments {
    /// Output folder [default: results/NAME/HASH; HASH depends on all inputs]
    #[arg(long = "out", value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Run again and replace existing results
    #[arg(long)]
    pub force: bool,
}

/// List or run the reference cases with known answers
#[derive(Debug, Args)]
#[command(
    after_help = "Without `run`, the command lists the cases. They are in the folder `cases` of the repository.\n\n\
    Examples:\n  loosepin cases\n  loosepin cases run\n  loosepin cases run slider_crank_5000 six_bar",
    args_conflicts_with_subcommands = true
)]
pub struct CasesArguments {
    /// Action.
    #[command(subcommand)]
    pub action: Option<CasesAction>,
    #[command(flatten)]
    pub folder: CasesFolder,
}

/// Actions on the reference cases.
#[derive(Debug, Subcommand)]
pub enum CasesAction {
    Run(CasesRunArguments),
}

/// Run reference cases and compare each number with the expected one
#[derive(Debug, Args)]
#[command(after_help = "Exit status 1: a number is outside its tolerance.\n\n\
    Examples:\n  loosepin cases run\n  loosepin cases run slider_crank_5000 six_bar\n  \
    loosepin cases run --write measured/validation.md")]
pub struct CasesRunArguments {
    /// Names of cases [default: all]
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// Also write the numbers as a Markdown page
    #[arg(long, value_name = "PAGE")]
    pub write: Option<PathBuf>,
    #[command(flatten)]
    pub folder: CasesFolder,
}

/// Where the reference cases are.
#[derive(Debug, Args)]
pub struct CasesFolder {
    /// Folder of the cases
    #[arg(long = "folder", value_name = "DIR", default_value = "cases")]
    pub path: PathBuf,
}

/// Write the report of stored results again, or save a figure of it
#[derive(Debug, Args)]
#[command(
    group = clap::ArgGroup::new("saved").multiple(true),
    after_help = "Without options, the command writes the page again. --figure selects one picture. --svg saves it in the colours of the \
    page on white, --csv saves its numbers with units in the header.\n\nExamples:\n  loosepin report results/worn-pin/1a2b3c4d\n  \
    loosepin report results/worn-pin/1a2b3c4d --list\n  \
    loosepin report results/worn-pin/1a2b3c4d --figure deviation.slider --svg band.svg --csv band.csv --width 84mm"
)]
pub struct ReportArguments {
    /// Folder of results
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    #[command(flatten)]
    pub shown: ShownArguments,
    /// List the figures
    #[arg(long, conflicts_with_all = ["figure", "svg", "csv", "width", "all"])]
    pub list: bool,
    /// Name of the figure to save, as shown by --list
    #[arg(long, value_name = "NAME", requires = "saved", conflicts_with = "all")]
    pub figure: Option<String>,
    /// Save the picture in this file
    #[arg(long, value_name = "FILE", requires = "figure", group = "saved")]
    pub svg: Option<PathBuf>,
    /// Save the numbers of the picture in this file
    #[arg(long, value_name = "FILE", requires = "figure", group = "saved")]
    pub csv: Option<PathBuf>,
    /// Width of the picture, with its unit
    #[arg(long, value_name = "LENGTH", requires = "svg", default_value = "160 mm")]
    pub width: String,
}

/// Open the studio: edit mechanisms and studies in the browser
#[cfg(feature = "studio")]
#[derive(Debug, Args)]
#[command(
    after_help = "Serves a page to this machine only, until Ctrl-C. The address contains a secret: anyone who has it can read and write \
    the .toml files of the folder. Results are written to its subfolder results, as by `loosepin study`.\n\n\
    Examples:\n  loosepin serve\n  loosepin serve my_mechanisms --no-open --port 8080"
)]
pub struct ServeArguments {
    /// Folder with models and studies
    #[arg(value_name = "DIR", default_value = ".")]
    pub folder: PathBuf,
    /// Port on 127.0.0.1 [default: a free one]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Print the address and do not open a browser
    #[arg(long)]
    pub no_open: bool,
    /// Serve in this process, for the one that reads its output
    #[arg(long, hide = true)]
    pub worker: bool,
}

/// Export the neural networks of a study (ONNX), or a model in space (URDF, MJCF)
#[derive(Debug, Args)]
#[command(
    after_help = "Without --to, writes one ONNX file for each number or curve. Its tensor \"inputs\" has one row for each mechanism, in SI \
    units, in the order of the metadata entry `inputs`; \"values\" is in SI units too. A row outside the training range gives NaN: there is \
    no extrapolation. The metadata contain the error on held-out runs. The standard deviation of the error and the remaining noise are not \
    exported.\n\n\
    With --to, writes the robot description of a model in space with its nominal values. URDF has trees of joints; MJCF also closes loops. \
    Play is not exported.\n\n\
    Examples:\n  loosepin export results/worn-pin/1a2b3c4d\n  loosepin export bounds/surrogates.json networks --output slider\n  \
    loosepin export model.toml --to mjcf"
)]
pub struct ExportArguments {
    /// Folder of results, or its surrogates.json; with --to, a model in space
    #[arg(value_name = "RESULTS_OR_MODEL")]
    pub source: PathBuf,
    /// Output folder, created if it does not exist [default: onnx, urdf or mjcf]
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Write the robot description of a model in space
    #[arg(long, value_name = "FORMAT", conflicts_with = "outputs")]
    pub to: Option<RobotFormatArgument>,
    /// Write only this output; may be repeated [default: all]
    #[arg(long = "output", value_name = "NAME")]
    pub outputs: Vec<String>,
    /// Replace another export
    #[arg(long)]
    pub force: bool,
}

/// Format of a robot description.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RobotFormatArgument {
    /// Links that hang on each other by joints
    Urdf,
    /// The format of MuJoCo, with loops
    Mjcf,
}

/// Bound the play in joints, or other unknowns, from readings of a rig
#[derive(Debug, Args)]
#[command(
    after_help = "The study has [[measured]] tables. For a reading, the drives are locked, an output is pushed back and forth, and its \
    dead travel (lost motion) is measured. The command prints the bounds of every play and of every sum of plays that the readings \
    determine, and the next reading that would narrow them most. Tables of kind = \"motion\" contain features of a measured motion. For \
    them, the command prints which values of the inputs under [epistemic] are consistent with the features.\n\n\
    Exit status: 0 readings and motion are explained; 1 no values of the plays or of other unknowns explain them; 2 error.\n\n\
    --out also shows which features of the motion narrow the unknowns most, and writes summary.json and report.html. --compare runs the \
    study as it is and with the narrowed intervals, and compares the bounds.\n\n\
    Examples:\n  loosepin identify study.toml\n  loosepin identify study.toml --write narrowed.toml --compare\n  \
    loosepin identify study.toml --out identified\n  loosepin identify study.toml --plan"
)]
pub struct IdentifyArguments {
    /// Study file with [[measured]] tables
    #[arg(value_name = "STUDY")]
    pub study: PathBuf,
    /// Write the study with narrowed intervals to FILE, in the folder of the study; comments are kept
    #[arg(long, value_name = "FILE")]
    pub write: Option<PathBuf>,
    /// Run the study as it is and with the narrowed intervals, and compare their bounds
    #[arg(long, conflicts_with = "plan")]
    pub compare: bool,
    /// Output folder for summary.json and report.html, created if it does not exist
    #[arg(long, value_name = "DIR", conflicts_with_all = ["plan", "json"])]
    pub out: Option<PathBuf>,
    /// Run again and replace existing results
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Use only the readings and features of this specimen [default: all specimens, each separately]
    #[arg(long, value_name = "NAME")]
    pub specimen: Option<String>,
    /// Probability that all bounds of a specimen hold at the same time
    #[arg(long, value_name = "SHARE", default_value = "0.99", value_parser = share)]
    pub confidence: f64,
    /// Before any measurement, show which features of the motion would narrow the unknowns
    #[arg(long, conflicts_with_all = ["write", "points"])]
    pub plan: bool,
    /// Approximate limit of the number of points (values of the unknowns) at which a motion is tested
    #[arg(long, value_name = "N", default_value = "400", value_parser = points)]
    pub points: usize,
    /// Also compute a posterior distribution of the unknowns, from the same runs
    #[arg(long, conflicts_with = "plan")]
    pub posterior: bool,
    /// Sample mechanisms whose lengths agree with the motion, with the remaining points; --write saves them next to the study, which uses them
    #[arg(long, conflicts_with = "plan")]
    pub lengths: bool,
    /// Number of threads for the runs of a motion, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

/// Print the JSON Schema of model or study files
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  loosepin schema model > model.schema.json")]
pub struct SchemaArguments {
    /// Kind of file
    #[arg(value_enum)]
    pub kind: FileKind,
}

/// The kinds of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FileKind {
    /// A mechanism with its nominal values
    Model,
    /// The uncertain inputs of a model, and the questions
    Study,
}

/// Explain an error code
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  loosepin explain E0303")]
pub struct ExplainArguments {
    /// Code in the brackets after `error`, for example E0303
    #[arg(required_unless_present = "list")]
    pub code: Option<Code>,
    /// List all codes
    #[arg(long, conflicts_with = "code")]
    pub list: bool,
}

/// Print the completion script of a shell
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    loosepin completions bash > ~/.local/share/bash-completion/completions/loosepin\n  \
    loosepin completions fish > ~/.config/fish/completions/loosepin.fish")]
pub struct CompletionsArguments {
    /// Shell
    #[arg(value_enum)]
    pub shell: Shell,
}

/// Print the manual page of loosepin or of a command (roff)
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  loosepin manual > loosepin.1\n  loosepin manual study | man -l -")]
pub struct ManualArguments {
    /// Command [default: loosepin itself]
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

/// A parser of template names.
fn template() -> impl TypedValueParser<Value = &'static Template> {
    let names = all_templates().map(|template| PossibleValue::new(template.name).help(template.description()));
    PossibleValuesParser::new(names).try_map(|name| find_template(&name).ok_or("no such template"))
}

fn recorded_turns(text: &str) -> Result<f64, String> {
    number(text, Rule::SomeTurns)
}

fn transient_turns(text: &str) -> Result<f64, String> {
    number(text, Rule::Turns)
}

/// A number of points.
fn points(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(points) if (1..=1_000_000).contains(&points) => Ok(points),
        _ => Err("must be a whole number from 1 to 1000000".to_owned()),
    }
}

fn share(text: &str) -> Result<f64, String> {
    number(text, Rule::RequiredProbability)
}

fn number(text: &str, rule: Rule) -> Result<f64, String> {
    text.parse().ok().filter(|&number| rule.allows(number)).ok_or_else(|| format!("must be a number {}", rule.words()))
}
