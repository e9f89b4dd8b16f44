//! What bands promise and what they hold, on `cases/slider_crank_worn_pin`: the three treatments of its study against fresh runs at
//! values of the unknown inputs that no study has seen.
//!
//! `just campaign worn-pin [MECHANISMS] [--write PAGE]`. For each value u of 25, a low-discrepancy set inside the box, and for its
//! corners (which the study has seen), N mechanisms with random numbers of their own (1,024 if omitted); the share c inside a band
//! has the standard error `sqrt(c (1 - c)/N)` of independent ones.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use loosepin::study::result::{
    ResponsePoint, StudyResult, Treatment, TreatmentBand, TreatmentComparison, WitnessValue,
};
use loosepin::study::{Ask, Deviation, Study, StudyRun, Where};
use loosepin_bench::run;
use loosepin_bench::worn_pin::{double_loop, low_discrepancy_fractions, run_at, study, values_at};

/// Values of u, and mechanisms at each if omitted.
const VALUES: u32 = 25;
const MECHANISMS: usize = 1024;
/// Seed of the values; those of their mechanisms count up from it. The study's own is 1.
const SEED: u64 = 2016;
/// Poses that are asked for besides, a twelfth of a turn apart.
const POSES: usize = 12;
/// A share is short of its promise where it is so by this many standard errors.
const STANDARD_ERRORS: f64 = 3.0;
/// No value may be nearer to one that a study has run, as a share of the box.
const MIN_DISTANCE: f64 = 1e-3;
const TREATMENTS: [(Treatment, &str); 3] = [
    (Treatment::ProbabilityOnly, "probability only"),
    (Treatment::IntervalOnly, "interval only"),
    (Treatment::Mixed, "mixed"),
];

/// The finished responses at one value of u, response by response.
struct Truth {
    at: Vec<f64>,
    responses: Vec<Vec<f64>>,
}

fn main() {
    let (mut mechanisms, mut page) = (MECHANISMS, None);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.parse() {
            Ok(number) => mechanisms = number,
            Err(_) if argument == "--write" => page = arguments.next().map(PathBuf::from),
            Err(_) => panic!("expected a number or --write PAGE, found {argument}"),
        }
    }
    let started = Instant::now();
    let study = of_single_numbers(study());
    let result = run(&study).result;

    let unseen = low_discrepancy_fractions(&study, SEED, VALUES);
    let distance = nearest(&study, &result, &unseen);
    assert!(distance >= MIN_DISTANCE, "a value lies {distance} of the box beside one that the study has run");
    let corners = (0..1_usize << study.epistemic.len())
        .map(|corner| (0..study.epistemic.len()).map(|k| f64::from((corner >> k & 1) as u8)).collect());
    let truths: Vec<Truth> = unseen
        .iter()
        .cloned()
        .chain(corners)
        .enumerate()
        .map(|(place, fractions)| truth(&study, mechanisms, values_at(&study, &fractions), SEED + 1 + place as u64))
        .collect();
    let text = words(&study, &result.treatments, &truths, distance);
    println!("{text}");
    if let Some(page) = page {
        std::fs::write(&page, &text).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
    }
    eprintln!("{:.0} s", started.elapsed().as_secs_f64());
}

/// The same study, asked for single numbers alone, which treatments are compared of: its own, and the deviation at poses, where it has
/// a sign. Curves have no treatments.
fn of_single_numbers(mut study: Study) -> Study {
    let step_rad = std::f64::consts::TAU / POSES as f64;
    let angles_rad = (0..POSES).map(|pose| step_rad * pose as f64).collect();
    let first = study.asks.iter().find(|ask| ask.deviation == Deviation::Total).expect("the study asks for the total");
    let poses = Ask { location: Where::Poses { angles_rad }, ..first.clone() };
    study.asks.retain(|ask| !ask.location.is_cycle());
    study.asks.push(poses);
    study.requirements.clear();
    study
}

/// Fresh mechanisms at one value of u.
fn truth(study: &Study, mechanisms: usize, at: Vec<f64>, seed: u64) -> Truth {
    let StudyRun { runs, result, .. } = run_at(study, mechanisms, &at, seed);
    let responses = result.treatments.iter().map(|of| double_loop(&runs, &column_name(of))).collect();
    Truth { at, responses }
}

/// The column of a response in the runs.
fn column_name(of: &TreatmentComparison) -> String {
    let at = match &of.at {
        ResponsePoint::Pose { pose_rad } => format!("at {} rad", (pose_rad * 1e9).round() / 1e9),
        ResponsePoint::Reduced { reduction } => reduction.word().to_owned(),
        other => panic!("{other:?} has no treatments"),
    };
    format!("{} {} {at}", of.output, of.of.word())
}

/// The least distance of the unseen values from those that the study has run, as a share of the box.
fn nearest(study: &Study, result: &StudyResult, unseen: &[Vec<f64>]) -> f64 {
    let mut least = f64::INFINITY;
    for point in &result.treatments[0].bands[0].coverage_at {
        let seen: Vec<f64> = study
            .epistemic
            .iter()
            .map(|input| match (&point.at[&input.path], input.interval()) {
                (WitnessValue::Number(value), Some(interval)) => interval.fraction_of(*value),
                other => panic!("{}: {other:?}", input.path),
            })
            .collect();
        for fractions in unseen {
            let apart = seen.iter().zip(fractions).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            least = least.min(apart);
        }
    }
    least
}

/// Share of `values` inside `band`; failed runs are outside.
fn coverage(values: &[f64], band: &TreatmentBand) -> f64 {
    let inside = values.iter().filter(|&&value| value >= band.lower_si && value <= band.upper_si).count();
    inside as f64 / values.len() as f64
}

/// Of a share of `mechanisms` independent ones.
fn standard_error(coverage: f64, mechanisms: usize) -> f64 {
    (coverage * (1.0 - coverage) / mechanisms as f64).sqrt()
}

fn is_short(coverage: f64, promised: f64, mechanisms: usize) -> bool {
    coverage + STANDARD_ERRORS * standard_error(coverage, mechanisms) < promised
}

fn band(of: &TreatmentComparison, treatment: Treatment) -> &TreatmentBand {
    of.bands.iter().find(|band| band.treatment == treatment).expect("all treatments are compared")
}

fn response_name(of: &TreatmentComparison) -> String {
    match &of.at {
        ResponsePoint::Pose { pose_rad } => format!("deviation at {:.0}°", pose_rad.to_degrees()),
        ResponsePoint::Reduced { reduction } => match reduction.word() {
            "maximum_absolute" => "largest magnitude of the turn".to_owned(),
            "rms" => "root mean square over the turn".to_owned(),
            other => other.replace('_', " "),
        },
        other => panic!("{other:?} has no treatments"),
    }
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// The whole page.
fn words(study: &Study, treatments: &[TreatmentComparison], truths: &[Truth], distance: f64) -> String {
    let mechanisms = truths[0].responses[0].len();
    let (unseen, corners) = truths.split_at(VALUES as usize);
    let mut page = String::new();
    let promised = treatments[0].promised_coverage;
    let _ = write!(
        page,
        "# What bands promise and what they hold\n\n\
         <!-- Written by `just campaign worn-pin {mechanisms} --write measured/worn-pin.md`; do not edit. -->\n\n\
         Is a band as good as it promises? D. Sun and G. Chen, European Journal of Mechanics A/Solids 58 (2016) 256-261, say: random \
         plays promise too much, interval-only bands are too wide, and the mixed treatment is right. This page tests it on \
         [the worn pin](../cases/slider_crank_worn_pin/README.md): crank and rod lengths are random, the radial play (0.1 to 0.5 mm) and \
         the restitution (0.7 to 0.9) are unknown.\n\n\
         * **Bands.** The study of the case, for its single numbers and for {POSES} poses: at most {} values of the unknown pair, {} \
         mechanisms at each. Each treatment gives a central {:.0} % band; the interval-only band holds all its values.\n\
         * **Truth.** {VALUES} other values of the pair (Sobol' points with another seed, at least {:.1} % of the box away from those of \
         the study), and {mechanisms} mechanisms at each with other random numbers. At {:.0} % inside, the standard error of the share \
         is {}.\n\
         * **Short**: the share is {STANDARD_ERRORS} standard errors or more below {:.0} %.\n\n\
         The bands are not widened by their numerical error. The numbers are the same on every machine. \
         The bounds of the study are held against about a million runs by `just campaign worn-pin-reference`.\n\n",
        study.sampling.outer,
        study.sampling.inner,
        100.0 * promised,
        100.0 * distance,
        100.0 * promised,
        percent(standard_error(promised, mechanisms)),
        100.0 * promised,
    );
    page.push_str("## In short\n\n");
    page.push_str("| treatment | width, mean of all responses | share inside, least | mean | short of its promise |\n|---|--:|--:|--:|--:|\n");
    for (treatment, name) in TREATMENTS {
        let shares = |truths: &[Truth]| -> Vec<f64> {
            let of = |truth: &Truth| {
                let each = treatments.iter().zip(&truth.responses);
                each.map(|(of, values)| coverage(values, band(of, treatment))).collect::<Vec<f64>>()
            };
            truths.iter().flat_map(of).collect()
        };
        let shares = shares(unseen);
        let widths_mm: f64 =
            treatments.iter().map(|of| 1e3 * band(of, treatment).width_si()).sum::<f64>() / treatments.len() as f64;
        let short = shares.iter().filter(|&&share| is_short(share, promised, mechanisms)).count();
        let _ = writeln!(
            page,
            "| {name} | {widths_mm:.3} mm | {} | {} | {short} of {} |",
            percent(shares.iter().copied().fold(f64::INFINITY, f64::min)),
            percent(shares.iter().sum::<f64>() / shares.len() as f64),
            shares.len(),
        );
    }
    page.push_str(
        "\n## Response by response\n\nBand and width in mm; share inside: least and greatest of the unseen values; how many of them \
         are short; and the least at the four corners of the box, which the study has run, with mechanisms that it has not.\n\n\
         | response | treatment | band | width | least | greatest | short | corners, least |\n|---|---|---|--:|--:|--:|--:|--:|\n",
    );
    for (place, of) in treatments.iter().enumerate() {
        for (treatment, name) in TREATMENTS {
            let band = band(of, treatment);
            let shares = |truths: &[Truth]| -> Vec<f64> {
                truths.iter().map(|truth| coverage(&truth.responses[place], band)).collect()
            };
            let (inside, at_corners) = (shares(unseen), shares(corners));
            let least = |shares: &[f64]| shares.iter().copied().fold(f64::INFINITY, f64::min);
            let _ = writeln!(
                page,
                "| {} | {name} | {:.3} to {:.3} | {:.3} | {} | {} | {} | {} |",
                response_name(of),
                1e3 * band.lower_si,
                1e3 * band.upper_si,
                1e3 * band.width_si(),
                percent(least(&inside)),
                percent(inside.iter().copied().fold(0.0, f64::max)),
                inside.iter().filter(|&&share| is_short(share, promised, mechanisms)).count(),
                percent(least(&at_corners)),
            );
        }
    }
    let _ = write!(
        page,
        "\n## Value by value\n\nShare inside each band, {}.\n\n| radial play | restitution |",
        response_name(&treatments[0])
    );
    for (_, name) in TREATMENTS {
        let _ = write!(page, " {name} |");
    }
    page.push_str("\n|--:|--:|--:|--:|--:|\n");
    for (place, truth) in truths.iter().enumerate() {
        let is_corner = place >= unseen.len();
        let _ = write!(
            page,
            "| {:.3} mm{} | {:.3} |",
            1e3 * truth.at[0],
            if is_corner { " (corner)" } else { "" },
            truth.at[1]
        );
        for (treatment, _) in TREATMENTS {
            let share = coverage(&truth.responses[0], band(&treatments[0], treatment));
            let mark = if is_short(share, promised, mechanisms) { ", short" } else { "" };
            let _ = write!(page, " {} ± {}{mark} |", percent(share), percent(standard_error(share, mechanisms)));
        }
        page.push('\n');
    }
    let failed = truths.iter().flat_map(|truth| &truth.responses[0]).filter(|value| !value.is_finite()).count();
    let _ = writeln!(
        page,
        "\nOf {} fresh mechanisms {failed} had no result; they count as outside.",
        truths.len() * mechanisms
    );
    page
}
