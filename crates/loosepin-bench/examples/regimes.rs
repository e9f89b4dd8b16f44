//! Bounds by surrogates beside direct ones where the motion is smooth, where it is chaotic, and between: `just campaign regimes
//! [REPETITIONS [KIND [REGIME]]]`, KIND being auto, chaos, kriging or network.
//!
//! The mechanism is that of `cases/slider_crank_worn_pin`; each [`Regime`] has a friction, a play and a restitution of its own. A direct
//! study with [`REFERENCE`] times the runs at each value of the unknown inputs is the reference, its errors small. Then the study
//! is made again with other seeds, by surrogates alone; every bound of it is held against the reference:
//!
//! ```text
//! agrees      |value - reference| <= error + error of the reference
//! too narrow  widened < reference - error of the reference         (upwards; the other way for a lower bound)
//! ```

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use std::fmt::Write as _;
use std::time::Instant;

use loosepin::model::Model;
use loosepin::report::study_text;
use loosepin::study::Study;
use loosepin::study::result::{BoundEnd, BoundRecord, ResponsePoint, Statistic, StudyResult, SurrogateVerdict};
use loosepin_bench::{case_file, largest, median, run};

/// Repetitions of each study by surrogate, if omitted; of them, the least number whose bounds agree: 29 of 30.
const REPETITIONS: usize = 30;
const MIN_AGREEING: f64 = 29.0 / 30.0;
/// Values of the unknown inputs, and mechanisms at each, of the study; and how many times as many mechanisms the reference has.
const OUTER: usize = 64;
const INNER: usize = 256;
const REFERENCE: usize = 4;
/// Seed of the reference; those of the repetitions count up from 1.
const REFERENCE_SEED: u64 = 2016;
/// Direct studies of the usual size, in the smooth regime, whose errors are held against those of a twentieth of the runs.
const DIRECT_STUDIES: u64 = 3;

/// The kind of surrogate, if omitted, and how it is made: runs to learn from, and direct runs at each witness.
const KIND: &str = "kriging";
const TRAINING: usize = 120;
const CONFIRMING: usize = 48;
/// Mechanisms at each value of the unknown inputs in the double loop on the surrogate, which costs no runs.
const INNER_ON_SURROGATE: usize = 1024;
/// The direct study makes at least so many times the runs of one by surrogate.
const MIN_RATIO: f64 = 10.0;
const MIN_RATIO_SMOOTH: f64 = 20.0;

/// What is known of the contact.
struct Regime {
    name: &'static str,
    /// Coefficient of Ambrósio's friction; none where it is 0.
    friction: f64,
    clearance_mm: [f64; 2],
    restitution: [f64; 2],
}

const REGIMES: [Regime; 3] = [
    Regime { name: "smooth", friction: 0.1, clearance_mm: [0.29, 0.31], restitution: [0.1, 0.3] },
    Regime { name: "between", friction: 0.03, clearance_mm: [0.2, 0.4], restitution: [0.4, 0.6] },
    Regime { name: "chaotic", friction: 0.0, clearance_mm: [0.1, 0.5], restitution: [0.7, 0.9] },
];

/// What all repetitions said of one bound.
#[derive(Default)]
struct Tally {
    name: String,
    agree: usize,
    narrow: usize,
    /// Too narrow, and the noise test found no noise.
    unsaid: usize,
    /// Both ends: error, and distance from the reference, over the width of the reference.
    errors: Vec<f64>,
    distances: Vec<f64>,
    /// Width as stated over that of the reference.
    widths: Vec<f64>,
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let repetitions = given.first().map_or(REPETITIONS, |word| word.parse().expect("a number of repetitions"));
    let kind = given.get(1).map_or(KIND, String::as_str);
    let only = given.get(2);
    let started = Instant::now();
    let mut diagnostics: Vec<String> = Vec::new();
    for regime in REGIMES.iter().filter(|regime| only.is_none_or(|name| name == regime.name)) {
        let reference = run(&regime.study(REFERENCE_SEED, INNER * REFERENCE, "")).result;
        let runs = OUTER * INNER;
        println!(
            "\n{}: friction {}, play {} to {} mm, restitution {} to {}; reference of {} runs ({:.0} s)",
            regime.name,
            regime.friction,
            regime.clearance_mm[0],
            regime.clearance_mm[1],
            regime.restitution[0],
            regime.restitution[1],
            reference.counts.runs,
            started.elapsed().as_secs_f64()
        );
        let direct = if regime.name == "smooth" { direct_studies(regime, &reference) } else { Vec::new() };
        let tallies = surrogate_studies(regime, kind, &reference, (repetitions, runs), &mut diagnostics);
        if regime.name == "smooth" {
            compare(kind, &direct, &tallies, &mut diagnostics);
        }
        println!("({:.0} s)", started.elapsed().as_secs_f64());
        if regime.name == "chaotic" {
            words(regime, &mut diagnostics);
        }
    }
    println!("\n{:.0} s", started.elapsed().as_secs_f64());
    for diagnostic in &diagnostics {
        println!("not met: {diagnostic}");
    }
    if !diagnostics.is_empty() {
        std::process::exit(1);
    }
    println!("every line is met");
}

impl Regime {
    /// The study; `further` stands beside its tables.
    fn study(&self, seed: u64, inner: usize, further: &str) -> Study {
        let case = case_file("slider_crank_worn_pin", "model.toml");
        let mut model = std::fs::read_to_string(&case).unwrap_or_else(|error| panic!("{}: {error}", case.display()));
        if self.friction > 0.0 {
            let written = format!("friction = {{ law = \"ambrosio\", coefficient = {} }}\ndensity =", self.friction);
            assert!(model.contains("density ="), "the contact of the case has a density");
            model = model.replacen("density =", &written, 1);
        }
        let mut text = format!(
            r#"
            name = "{}"
            model = "model.toml"
            seed = {seed}
            [cycle]
            transient_turns = 2
            recorded_turns = 1
            samples_per_turn = 180
            [sampling]
            outer = {OUTER}
            inner = {inner}
            tolerance = "1e-7 m"
            [random]
            "parameter.crank_length" = {{ normal = {{ mean = "50 mm", standard_deviation = "0.02 mm" }} }}
            "parameter.rod_length" = {{ normal = {{ mean = "120 mm", standard_deviation = "0.03 mm" }} }}
            [epistemic]
            "joint.gudgeon.radial_clearance" = {{ interval = ["{} mm", "{} mm"] }}
            "contact.steel_pin.restitution" = {{ interval = [{}, {}] }}
            "#,
            self.name, self.clearance_mm[0], self.clearance_mm[1], self.restitution[0], self.restitution[1]
        );
        for place in [r#"poses = { crank = ["60 deg"] }"#, r#"reduce = "rms""#, r#"reduce = "maximum_absolute""#] {
            let _ = write!(
                text,
                r#"
                [[ask]]
                output = "slider"
                of = "total"
                {place}
                statistics = ["mean", "standard_deviation", {{ quantile = 0.975 }}]
                "#
            );
        }
        text.push_str(further);
        let model = Model::from_text("model.toml", &model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
    }
}

/// Direct studies of the usual size against the reference.
fn direct_studies(regime: &Regime, reference: &StudyResult) -> Vec<Tally> {
    let mut tallies = tallies(reference);
    for seed in 1..=DIRECT_STUDIES {
        let result = run(&regime.study(seed, INNER, "")).result;
        for (tally, (found, exact)) in tallies.iter_mut().zip(result.bounds.iter().zip(&reference.bounds)) {
            tally.add(found, exact, None);
        }
    }
    print_table(&format!("direct, {DIRECT_STUDIES} seeds"), &tallies, DIRECT_STUDIES as usize, &[]);
    tallies
}

/// Studies by surrogates alone against the reference.
fn surrogate_studies(
    regime: &Regime,
    kind: &str,
    reference: &StudyResult,
    (repetitions, direct_runs): (usize, usize),
    diagnostics: &mut Vec<String>,
) -> Vec<Tally> {
    let further = format!(
        "[surrogate]\nkind = \"{kind}\"\ntraining_runs = {TRAINING}\nconfirming_runs = {CONFIRMING}\ndirect = \"confirming\"\n"
    );
    let mut tallies = tallies(reference);
    let mut verdicts: Vec<Vec<SurrogateVerdict>> = vec![Vec::new(); tallies.len()];
    let (mut most_runs, mut all_agree) = (0, 0);
    for seed in 1..=repetitions as u64 {
        let result = run(&regime.study(seed, INNER_ON_SURROGATE, &further)).result;
        most_runs = most_runs.max(result.counts.runs);
        let mut is_agreeing = true;
        for (place, (found, exact)) in result.bounds.iter().zip(&reference.bounds).enumerate() {
            let verdict = verdict(&result, found);
            is_agreeing &= tallies[place].add(found, exact, verdict);
            verdicts[place].extend(verdict);
        }
        all_agree += usize::from(is_agreeing);
        eprintln!(
            "{} {kind} seed {seed}: {} runs, {}",
            regime.name,
            result.counts.runs,
            if is_agreeing { "all agree" } else { "not all agree" }
        );
    }
    let ratio = direct_runs as f64 / most_runs as f64;
    let title = format!(
        "{kind}: {TRAINING} training runs, {most_runs} in all at most, 1/{ratio:.1} of the direct ones; all statistics agree in {all_agree} of {repetitions}"
    );
    print_table(&title, &tallies, repetitions, &verdicts);
    let least_ratio = if regime.name == "smooth" { MIN_RATIO_SMOOTH } else { MIN_RATIO };
    if ratio < least_ratio {
        diagnostics.push(format!("{}, {}: {most_runs} runs are too many", regime.name, kind));
    }
    for tally in &tallies {
        if (tally.agree as f64) < MIN_AGREEING * repetitions as f64 {
            diagnostics
                .push(format!("{}, {}, {}: {} of {repetitions} agree", regime.name, kind, tally.name, tally.agree));
        }
        if tally.unsaid > 0 {
            diagnostics.push(format!(
                "{}, {}, {}: too narrow in {} without the noise test",
                regime.name, kind, tally.name, tally.unsaid
            ));
        }
    }
    tallies
}

/// What was said of what a bound is a statistic of.
fn verdict(result: &StudyResult, bound: &BoundRecord) -> Option<SurrogateVerdict> {
    let outputs = &result.surrogate.as_ref()?.outputs;
    outputs.iter().find(|output| output.of == bound.of && output.at == bound.at)?.verdict
}

fn tallies(reference: &StudyResult) -> Vec<Tally> {
    reference.bounds.iter().map(|bound| Tally { name: name(bound), ..Tally::default() }).collect()
}

fn name(bound: &BoundRecord) -> String {
    let place = match bound.at {
        ResponsePoint::Pose { pose_rad } => format!("at {:.0}°", pose_rad.to_degrees()),
        ResponsePoint::Reduced { reduction } => reduction.word().replace('_', " "),
        other => panic!("{other:?} is not asked for"),
    };
    match bound.statistic {
        Statistic::Quantile(probability) => format!("{place}, {probability} quantile"),
        other => format!("{place}, {}", other.word().replace('_', " ")),
    }
}

impl Tally {
    /// Adds one repetition; whether both ends agree with the reference.
    fn add(&mut self, found: &BoundRecord, exact: &BoundRecord, verdict: Option<SurrogateVerdict>) -> bool {
        let width = exact.upper.value_si - exact.lower.value_si;
        let (mut agrees, mut is_narrow, mut error, mut distance) = (true, false, 0.0_f64, 0.0_f64);
        let ends: [(&BoundEnd, &BoundEnd, f64); 2] =
            [(&found.lower, &exact.lower, -1.0), (&found.upper, &exact.upper, 1.0)];
        for (found, exact, sign) in ends {
            let apart = found.value_si - exact.value_si;
            let (own, of_reference) = (found.error.total_si(), exact.error.total_si());
            agrees &= apart.abs() <= own + of_reference;
            is_narrow |= sign * (found.widened_si - exact.value_si) < -of_reference;
            (error, distance) = (error.max(own / width), distance.max(apart.abs() / width));
        }
        self.agree += usize::from(agrees);
        self.narrow += usize::from(is_narrow);
        self.unsaid += usize::from(is_narrow && !verdict.is_some_and(SurrogateVerdict::keeps_residual));
        self.errors.push(error);
        self.distances.push(distance);
        self.widths.push((found.upper.widened_si - found.lower.widened_si) / width);
        agrees
    }
}

fn print_table(title: &str, tallies: &[Tally], repetitions: usize, verdicts: &[Vec<SurrogateVerdict>]) {
    println!("\n{title}\nerror, distance and width over the width of the reference, in the median; greatest distance");
    println!(
        "{:40} {:>7} {:>7} {:>7} {:>9} {:>9} {:>9} {:>7}  verdicts",
        "statistic", "agree", "narrow", "unsaid", "error", "distance", "greatest", "width"
    );
    for (place, tally) in tallies.iter().enumerate() {
        println!(
            "{:40} {:>4}/{:<2} {:>7} {:>7} {:>9.4} {:>9.4} {:>9.4} {:>7.3}  {}",
            tally.name,
            tally.agree,
            repetitions,
            tally.narrow,
            tally.unsaid,
            median(&tally.errors),
            median(&tally.distances),
            largest(&tally.distances),
            median(&tally.widths),
            verdicts.get(place).map_or(String::new(), |said| counted(said))
        );
    }
}

/// "resolved 12, falling 18".
fn counted(said: &[SurrogateVerdict]) -> String {
    let mut counts: Vec<(SurrogateVerdict, usize)> = Vec::new();
    for verdict in said {
        match counts.iter_mut().find(|(known, _)| known == verdict) {
            Some((_, count)) => *count += 1,
            None => counts.push((*verdict, 1)),
        }
    }
    let words = counts.iter().map(|(verdict, count)| format!("{verdict:?} {count}").to_lowercase());
    words.collect::<Vec<_>>().join(", ")
}

/// That bounds from a twentieth of the runs lie as near to the reference as a direct study states that its own do.
fn compare(kind: &str, direct: &[Tally], by_surrogate: &[Tally], diagnostics: &mut Vec<String>) {
    println!(
        "\n{kind}, a twentieth of the runs: nearer to the reference than the direct study states; ratios of medians"
    );
    println!("{:40} {:>7} {:>13} {:>9}", "statistic", "nearer", "stated error", "distance");
    for (direct, own) in direct.iter().zip(by_surrogate) {
        let stated = median(&direct.errors);
        let nearer = own.distances.iter().filter(|&&distance| distance <= stated).count();
        println!(
            "{:40} {:>4}/{:<2} {:>13.2} {:>9.2}",
            own.name,
            nearer,
            own.distances.len(),
            median(&own.errors) / stated,
            median(&own.distances) / median(&direct.distances)
        );
        if (nearer as f64) < MIN_AGREEING * own.distances.len() as f64 {
            diagnostics.push(format!("smooth, {kind}, {}: {nearer} as near as a direct study states", own.name));
        }
    }
}

/// That the program says of the history in words that the surrogate saves nothing for it.
fn words(regime: &Regime, diagnostics: &mut Vec<String>) {
    let further = "
        [[ask]]
        output = \"slider\"
        of = \"total\"
        at = \"cycle\"
        statistics = [\"mean\"]
        [surrogate]
        kind = \"kriging\"
        direct = \"confirming\"
        ";
    let text = study_text(&run(&regime.study(1, INNER, further)).result);
    let text: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    println!("\nwhat it says\n{text}");
    for sentence in ["The surrogate is of no use for this history.", "It is used for statistics of the cycle"] {
        if !text.contains(sentence) {
            diagnostics.push(format!("chaotic: the program does not say '{sentence}'"));
        }
    }
}
