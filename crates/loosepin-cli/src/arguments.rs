//! What may be typed. One line of help a flag, with unit and default.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use loosepin::diagnostics::Code;
use loosepin::model::Rule;
use loosepin::store::Shard;
use loosepin::templates::{TEMPLATES, Template, find_template};

/// How accurately does a mechanism move, when its parts scatter and its joints have play?
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
        Exit status: 0 done; 1 done, and a requirement of the study is not met; 2 an error; 3 merged, and shards have a \
        further round to run; 130 interrupted."
)]
pub struct Arguments {
    /// What to do.
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
    Study(StudyArguments),
    Merge(MergeArguments),
    Sweep(SweepArguments),
    Cases(CasesArguments),
    Report(ReportArguments),
    Export(ExportArguments),
    Schema(SchemaArguments),
    Explain(ExplainArguments),
    Completions(CompletionsArguments),
    Manual(ManualArguments),
}

/// Write a commented model.toml and study.toml to start from
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  loosepin new --list\n  loosepin new four-bar my_mechanism")]
pub struct NewArguments {
    /// The mechanism to start from; --list shows which there are
    #[arg(required_unless_present = "list", value_parser = template())]
    pub template: Option<&'static Template>,
    /// Folder to write into, made where there is none [default: the name of the template]
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// List the templates
    #[arg(long, conflicts_with_all = ["template", "folder"])]
    pub list: bool,
}

/// Make a model to fill in from a drawing: lines are links, circles are joints
#[derive(Debug, Args)]
#[command(
    after_help = "A polyline, or lines that share an end without a circle, are one rigid link. Circles where links meet are \
    joints, with the radius of the pin; what is on the layer 'ground' does not move; a circle that one link meets elsewhere is \
    a point of it. Masses, inertias, gravity and speed stand in model.toml as \"?\" until they are filled in.\n\n\
    Examples:\n  loosepin import sketch.dxf\n  loosepin import sketch.dxf my_mechanism --unit mm"
)]
pub struct ImportArguments {
    /// Drawing (DXF)
    #[arg(value_name = "DRAWING")]
    pub drawing: PathBuf,
    /// Folder to write model.toml into, made where there is none [default: the name of the drawing]
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Unit of the drawing [default: as its header says]
    #[arg(long)]
    pub unit: Option<String>,
    /// Distance within which ends and centres coincide, with its unit
    #[arg(long, value_name = "LENGTH", default_value = "0.01 mm", allow_hyphen_values = true)]
    pub tolerance: String,
}

/// Say in words what models and studies are, and what is wrong with them
#[derive(Debug, Args)]
#[command(
    after_help = "Reads, counts the degrees of freedom, closes the loops, moves the ideal mechanism through its cycle \
    and tries a first stretch of the dynamic run. For a study also: how many runs, and about how long they take.\n\n\
    Examples:\n  loosepin check model.toml\n  loosepin check model.toml study.toml"
)]
pub struct CheckArguments {
    /// Model or study files
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
}

/// Show the ideal motion over a turn, and what play and scatter do to it without dynamics
#[derive(Debug, Args)]
#[command(
    after_help = "Takes an instant: worst case of the play, its standard deviation, and which joint contributes what; from a \
    study also the root of the sum of squares of what scatters. Writes summary.json and report.html.\n\n\
    Examples:\n  loosepin motion model.toml\n  loosepin motion study.toml --set joint.gudgeon.radial_clearance=0.3mm"
)]
pub struct MotionArguments {
    /// Model or study file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Give a quantity of the model another value, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Run one mechanism with its play and impacts: history, impacts, energy, a report
#[derive(Debug, Args)]
#[command(after_help = "Writes history.csv, impacts.csv, summary.json and report.html.\n\n\
    Examples:\n  \
    loosepin simulate model.toml\n  \
    loosepin simulate model.toml --set joint.gudgeon.radial_clearance=0.3mm --turns 3\n  \
    loosepin simulate model.toml --states --samples 1000 --out run1")]
pub struct SimulateArguments {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Give a quantity of the model another value, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Also record position, velocity and acceleration of every body
    #[arg(long)]
    pub states: bool,
    /// Turns to record [default: as in the model]
    #[arg(long, value_name = "N", value_parser = recorded_turns, allow_negative_numbers = true)]
    pub turns: Option<f64>,
    /// Turns to run before recording [default: as in the model]
    #[arg(long, value_name = "N", value_parser = transient_turns, allow_negative_numbers = true)]
    pub transient: Option<f64>,
    /// Rows to record in a turn, 1 to 1000000 [default: as in the model]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), allow_negative_numbers = true)]
    pub samples: Option<u32>,
    /// Also measure over N turns how fast neighbouring motions part (largest Lyapunov exponent), 20 to 1000000
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(20..=1_000_000), allow_negative_numbers = true)]
    pub lyapunov: Option<u32>,
    /// Accuracy of positions over the first half turn, with its unit
    #[arg(long, value_name = "LENGTH", default_value = "1e-9 m", allow_hyphen_values = true)]
    pub tolerance: String,
    /// Table of measured curves to lay over the outputs, with a header such as "angle [deg], slider [mm]"; may be repeated
    #[arg(long, value_name = "CSV")]
    pub measured: Vec<PathBuf>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Bound how far the mechanism moves from the ideal, over everything that is uncertain
#[derive(Debug, Args)]
#[command(
    after_help = "Writes summary.json, bounds.csv, runs.parquet, timing.json and report.html. The results are the same \
    for any number of threads. Every finished run is on disk within a second: after Ctrl-C, a crash or a power failure --resume \
    goes on, and the results are the same as those of a study that nothing disturbed; a budget of time begins anew.\n\n\
    With --accuracy the samples of the study grow, round by round, until its bounds are widened by no more than that; \
    it is of all bounds that measure what it measures, or of an output or one of its statistics. Where the budget ends it \
    before, the study says what is reached and what it would take; that is no error.\n\n\
    With --shard 2/7 it makes the second of seven parts of the present round of runs, wherever the others are made, in a folder \
    of its own, RESULTS.shard-2-of-7; loosepin merge joins them.\n\n\
    Exit status 1: the study came to its end, and a requirement stated in it is not shown to be met.\n\n\
    Examples:\n  loosepin study study.toml\n  loosepin study study.toml --threads 8 --out bounds\n  \
    loosepin study study.toml --accuracy 1um --budget 30min\n  \
    loosepin study study.toml --accuracy slider.mean=1um --accuracy 0.5% --budget 200000runs\n  \
    loosepin study study.toml --shard 2/7 --resume"
)]
pub struct StudyArguments {
    /// Study file
    #[arg(value_name = "STUDY")]
    pub study: PathBuf,
    /// Go on with the finished runs of the same command, where it was stopped
    #[arg(long, conflicts_with = "force")]
    pub resume: bool,
    /// Make the runs of one shard of N alone, in a folder of its own
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// What bounds are widened by at most, with its unit; may be repeated
    #[arg(long, value_name = "[OUTPUT[.STATISTIC]=]VALUE", allow_hyphen_values = true)]
    pub accuracy: Vec<String>,
    /// Where to end although bounds are not as near: runs, a time, or rounds [default with an accuracy: 100 times the runs without, a gibibyte at most]
    #[arg(long, value_name = "RUNS|TIME|ROUNDS", allow_hyphen_values = true)]
    pub budget: Option<String>,
    /// Share of failed runs, above 0 and at most 1, above which the study ends with an error [default: as in the study]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub most_failed: Option<f64>,
    /// Threads to run on, 1 to 1024 [default: as many as the machine has]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Join the shards of a study: write the results, or open the next round of runs for them
#[derive(Debug, Args)]
#[command(
    after_help = "Takes the folders of all shards, RESULTS.shard-1-of-N to RESULTS.shard-N-of-N, and writes what a study in one \
    piece writes, byte for byte, into RESULTS. A study asks for its runs in rounds: where the shards have a further round to \
    run, it is left in RESULTS for them, and the exit status is 3; run the shards again with --resume, then merge again.\n\n\
    Exit status 1: the study came to its end, and a requirement stated in it is not shown to be met.\n\n\
    Examples:\n  loosepin merge bounds.shard-*\n  loosepin merge results/worn-pin/1a2b3c4d.shard-*"
)]
pub struct MergeArguments {
    /// Folders of all shards
    #[arg(required = true, value_name = "FOLDER")]
    pub folders: Vec<PathBuf>,
    /// Study file [default: where the shards found it]
    #[arg(long, value_name = "STUDY")]
    pub study: Option<PathBuf>,
    /// Make rounds of up to N runs here, instead of waiting for shards, at most 8192
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(0..=8192))]
    pub small_round: u32,
    /// Share of failed runs, above 0 and at most 1, above which the study ends with an error [default: as in the study]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub most_failed: Option<f64>,
    /// Threads to run on, 1 to 1024 [default: as many as the machine has]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Run one mechanism for many values of a quantity: where its motion repeats itself, how often it strikes
#[derive(Debug, Args)]
#[command(
    after_help = "Looks at the motion once a turn of the drive (Poincaré section) and draws a bifurcation diagram. Writes \
    sections.csv, sweep.csv, summary.json and report.html. The results are the same for any number of threads.\n\n\
    Examples:\n  \
    loosepin sweep model.toml --over joint.gudgeon.radial_clearance=0.05mm..0.5mm\n  \
    loosepin sweep model.toml --over drive.crank.speed=500rpm..5000rpm --points 400 --transient 300"
)]
pub struct SweepArguments {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// The quantity of the model and the values that it goes through, with their units
    #[arg(long, value_name = "PATH=FROM..TO")]
    pub over: String,
    /// Values, ends included, 2 to 100000
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    pub points: u32,
    /// Give another quantity of the model another value, with its unit; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Turns to settle before those that are looked at, at most 1000000
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    pub transient: u32,
    /// Turns to look at, 2 to 100000
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    pub turns: u32,
    /// Accuracy of positions over the first half turn, with its unit
    #[arg(long, value_name = "LENGTH", default_value = "1e-8 m", allow_hyphen_values = true)]
    pub tolerance: String,
    /// Threads to run on, 1 to 1024 [default: as many as the machine has]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024), allow_negative_numbers = true)]
    pub threads: Option<u32>,
    #[command(flatten)]
    pub output: OutputArguments,
}

/// Where results go.
#[derive(Debug, Args)]
pub struct OutputArguments {
    /// Folder for the results [default: results/NAME/HASH, HASH from all inputs]
    #[arg(long = "out", value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Run again although the results are there, and replace what is in the way
    #[arg(long)]
    pub force: bool,
}

/// List the reference cases, mechanisms whose answer is known, or run them
#[derive(Debug, Args)]
#[command(
    after_help = "Without `run` it lists them. The cases are in the repository, in its folder `cases`.\n\n\
    Examples:\n  loosepin cases\n  loosepin cases run\n  loosepin cases run slider_crank_5000 six_bar",
    args_conflicts_with_subcommands = true
)]
pub struct CasesArguments {
    /// What to do with them.
    #[command(subcommand)]
    pub action: Option<CasesAction>,
    #[command(flatten)]
    pub folder: CasesFolder,
}

/// What is done with the reference cases.
#[derive(Debug, Subcommand)]
pub enum CasesAction {
    Run(CasesRunArguments),
}

/// Run reference cases: for each number what is expected and what is obtained, difference, tolerance, source
#[derive(Debug, Args)]
#[command(after_help = "Exit status 1: a number is outside of its tolerance.\n\n\
    Examples:\n  loosepin cases run\n  loosepin cases run slider_crank_5000 six_bar\n  \
    loosepin cases run --write docs/validation.md")]
pub struct CasesRunArguments {
    /// Names of cases [default: all]
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// Also write the numbers as a page in Markdown
    #[arg(long, value_name = "PAGE")]
    pub write: Option<PathBuf>,
    #[command(flatten)]
    pub folder: CasesFolder,
}

/// Where the reference cases are.
#[derive(Debug, Args)]
pub struct CasesFolder {
    /// Folder of the cases, each in a folder of its own
    #[arg(long = "folder", value_name = "DIR", default_value = "cases")]
    pub path: PathBuf,
}

/// Write the pages of stored results again
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  loosepin report results/worn-pin/1a2b3c4d")]
pub struct ReportArguments {
    /// Folder of results
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// Write the neural networks that a study has learned as ONNX files, for other programs
#[derive(Debug, Args)]
#[command(
    after_help = "One file for each number or curve: \"inputs\", one row a mechanism, its values in SI units in the order of the \
    metadata entry `inputs`, to \"values\", SI. A row with an input outside of the range that was learned gives not-a-number, since \
    nothing is extrapolated. The standard deviation of the error, and what is left of noise, do not go along; the metadata hold the held-out \
    error.\n\nExamples:\n  loosepin export results/worn-pin/1a2b3c4d\n  loosepin export bounds/surrogates.json networks --output slider"
)]
pub struct ExportArguments {
    /// Folder of results, or its surrogates.json
    #[arg(value_name = "RESULTS")]
    pub results: PathBuf,
    /// Folder to write into, made where there is none
    #[arg(value_name = "DIR", default_value = "onnx")]
    pub folder: PathBuf,
    /// Write this output alone; may be repeated [default: all]
    #[arg(long = "output", value_name = "NAME")]
    pub outputs: Vec<String>,
}

/// Print the JSON Schema of model or study files, for editors
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
    /// What is uncertain in a model, and what is asked
    Study,
}

/// Explain an error code at length
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  loosepin explain E0303")]
pub struct ExplainArguments {
    /// The code in the brackets behind `error`, for example E0303
    #[arg(required_unless_present = "list")]
    pub code: Option<Code>,
    /// List all codes
    #[arg(long, conflicts_with = "code")]
    pub list: bool,
}

/// Print what a shell needs to complete commands and flags with the tabulator key
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    loosepin completions bash > ~/.local/share/bash-completion/completions/loosepin\n  \
    loosepin completions fish > ~/.config/fish/completions/loosepin.fish")]
pub struct CompletionsArguments {
    /// Shell
    #[arg(value_enum)]
    pub shell: Shell,
}

/// Print the manual page of loosepin, or of one of its commands, as roff
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  loosepin manual > loosepin.1\n  loosepin manual study | man -l -")]
pub struct ManualArguments {
    /// Command [default: loosepin itself]
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

/// The templates by their names.
fn template() -> impl TypedValueParser<Value = &'static Template> {
    let names = TEMPLATES.iter().map(|template| PossibleValue::new(template.name).help(template.description()));
    PossibleValuesParser::new(names).try_map(|name| find_template(&name).ok_or("no such template"))
}

fn recorded_turns(text: &str) -> Result<f64, String> {
    number(text, Rule::SomeTurns)
}

fn transient_turns(text: &str) -> Result<f64, String> {
    number(text, Rule::Turns)
}

fn share(text: &str) -> Result<f64, String> {
    number(text, Rule::RequiredProbability)
}

fn number(text: &str, rule: Rule) -> Result<f64, String> {
    text.parse().ok().filter(|&number| rule.allows(number)).ok_or_else(|| format!("must be a number {}", rule.words()))
}
