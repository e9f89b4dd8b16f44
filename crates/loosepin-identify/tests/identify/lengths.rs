//! Lengths of a specimen, given its motion: conditional normal distributions in closed form, refusals, and the study that goes on.
//!
//! The slider of a crank of length r and a rod of length l stands between m + l - r and m + l + r, where m is the place of the crank: linear
//! in all three. l and m are normal, r is unknown, and the independent errors of both ends are normal.

use super::motion::ideal_model;
use super::study;
use loosepin_identify::motion_record::{LengthsRefusal, MechanismRows, SpecimenLengths};
use loosepin_identify::{Options, SpecimenStudy, UNHEARD, identify, record};
use loosepin_study::Study;
use std::path::Path;

const ROD_MM: [f64; 2] = [120.0, 0.3];
const PLACE_MM: [f64; 2] = [0.0, 0.2];
/// Standard deviation of the error of either end, mm.
const SCATTER_MM: f64 = 0.1;

fn model() -> String {
    let text = ideal_model();
    let [parameter, point] = ["rod_length = \"120 mm\"", "o = [\"0 mm\", \"0 mm\"]"];
    assert!(text.matches(parameter).count() == 1 && text.matches(point).count() == 1);
    text.replace(parameter, "rod_length = \"120 mm\"\nplace = \"0 mm\"").replace(point, "o = [\"place\", \"0 mm\"]")
}

fn end(feature: &str, value_mm: f64, errors: &str) -> String {
    format!(
        "[[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"{feature}\"\nvalue = \"{value_mm} mm\"\n\
         instrument = \"{feature}\"\n{errors}\n\n"
    )
}

/// The study with these measured ends, mm.
fn of_ends(seed: u64, ends_mm: [f64; 2]) -> Study {
    let scatter = format!("scatter = \"{SCATTER_MM} mm\"");
    with_tables(seed, &(end("minimum", ends_mm[0], &scatter) + &end("maximum", ends_mm[1], &scatter)))
}

fn with_tables(seed: u64, tables: &str) -> Study {
    let normal = |[mean, deviation]: [f64; 2]| {
        format!("{{ normal = {{ mean = \"{mean} mm\", standard_deviation = \"{deviation} mm\" }} }}")
    };
    let text = format!(
        "name = \"ends\"\nmodel = \"model.toml\"\nseed = {seed}\n\n\
         [cycle]\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 60\n\n[sampling]\nouter = 8\ninner = 256\n\n\
         [random]\n\"parameter.rod_length\" = {}\n\"parameter.place\" = {}\n\n\
         [epistemic]\n\"parameter.crank_length\" = {{ interval = [\"49 mm\", \"51 mm\"] }}\n\n\
         [[ask]]\noutput = \"slider\"\nof = \"value\"\nreduce = \"maximum\"\n\
         statistics = [{{ quantile = 0.025 }}, {{ quantile = 0.975 }}]\n\n{tables}",
        normal(ROD_MM),
        normal(PLACE_MM),
    );
    study(&model(), &text)
}

fn options() -> Options {
    Options { with_lengths: true, ..Options::default() }
}

fn answer(study: &Study, options: &Options) -> record::Identification {
    identify(study, options, UNHEARD).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn given(answer: &record::Identification) -> &MechanismRows {
    match &answer.motion[0].lengths {
        Some(SpecimenLengths::Given(rows)) => rows,
        other => panic!("{other:?}"),
    }
}

fn refused(study: &Study, options: &Options) -> LengthsRefusal {
    match answer(study, options).motion.remove(0).lengths {
        Some(SpecimenLengths::Refused(refusal)) => refusal,
        other => panic!("{other:?}"),
    }
}

/// Means and standard deviations of the two columns of rows, mm, and their correlation.
fn moments(rows: &MechanismRows) -> [f64; 5] {
    let count = rows.rows_si.len() as f64;
    let mean = |k: usize| 1e3 * rows.rows_si.iter().map(|row| row[k]).sum::<f64>() / count;
    let means = [mean(0), mean(1)];
    let product = |i: usize, j: usize| {
        rows.rows_si.iter().map(|row| (1e3 * row[i] - means[i]) * (1e3 * row[j] - means[j])).sum::<f64>() / count
    };
    let deviations = [product(0, 0).sqrt(), product(1, 1).sqrt()];
    [means[0], means[1], deviations[0], deviations[1], product(0, 1) / (deviations[0] * deviations[1])]
}

/// The same of the exact conditional distribution: with nothing known of r, half the sum of both ends is l + m with an error of SCATTER/√2.
fn exact(ends_mm: [f64; 2]) -> [f64; 5] {
    let half = 0.5 * (ends_mm[0] + ends_mm[1]);
    let (a, b, e) = (ROD_MM[1].powi(2), PLACE_MM[1].powi(2), SCATTER_MM.powi(2) / 2.0);
    let all = a + b + e;
    let off = half - ROD_MM[0] - PLACE_MM[0];
    let variances = [a - a * a / all, b - b * b / all];
    let deviations = variances.map(f64::sqrt);
    let means = [ROD_MM[0] + a / all * off, PLACE_MM[0] + b / all * off];
    [means[0], means[1], deviations[0], deviations[1], -a * b / all / (deviations[0] * deviations[1])]
}

#[test]
fn analytic_rows_have_the_conditional_normal_distribution_of_two_lengths() {
    // l + m = 120.45, r = 50.1.
    let ends_mm = [70.35, 170.55];
    let exact = exact(ends_mm);
    let seeds = 4;
    let (mut sums, mut draws) = ([0.0; 5], 0.0);
    for seed in 1..=seeds {
        let answer = answer(&of_ends(seed, ends_mm), &options());
        let rows = given(&answer);
        assert!(rows.rows_si.len() == 1000 && rows.effective >= 400.0 && rows.failed == 0, "{}", rows.effective);
        draws += rows.effective;
        for (sum, value) in sums.iter_mut().zip(moments(rows)) {
            *sum += value / seeds as f64;
        }
        // l and m trade off against each other, and not against r, which the distance of the ends tells.
        assert_eq!(rows.tied, Vec::new());
        let [before, after] = [rows.columns[0].before_si, rows.columns[0].after_si];
        assert!((before[1] - 0.3e-3).abs() < 1e-12 && (after[1] / (1e-3 * exact[2]) - 1.0).abs() < 0.15, "{after:?}");
    }
    // 4 standard deviations each: σ/√n of a mean, 1/√(2 n) of a standard deviation, (1 - ρ²)/√n of a correlation.
    let root = draws.sqrt();
    let allowed = [
        exact[2] / root,
        exact[3] / root,
        exact[2] / (2.0_f64.sqrt() * root),
        exact[3] / (2.0_f64.sqrt() * root),
        (1.0 - exact[4] * exact[4]) / root,
    ];
    println!("found {sums:?}, exact {exact:?}, {draws:.0} draws");
    for (k, ((found, exact), allowed)) in sums.iter().zip(exact).zip(allowed).enumerate() {
        assert!((found - exact).abs() < 4.0 * allowed, "{k}: {found} {exact} ± {allowed}");
    }
}

#[test]
fn analytic_a_length_that_trades_off_against_the_unknown_is_told() {
    // The upper end alone knows r + l + m. Over an interval of r that is as wide as all that l and m scatter they go against it.
    let study = with_tables(1, &end("maximum", 170.5, &format!("scatter = \"{SCATTER_MM} mm\"")));
    let answer = answer(&study, &options());
    let tied = &given(&answer).tied;
    assert_eq!(tied.len(), 2, "{tied:?}");
    assert!(tied.iter().all(|tied| tied.unknown == 0 && tied.rank_correlation < -0.3), "{tied:?}");
    assert!(tied[0].rank_correlation < tied[1].rank_correlation, "the rod scatters more: {tied:?}");
}

#[test]
fn mechanisms_are_refused_where_they_would_say_nothing() {
    let exact = end("maximum", 170.5, "error = \"± 0.1 mm\"") + &end("minimum", 70.5, "");
    let features = vec!["slider, minimum".to_owned()];
    assert_eq!(refused(&with_tables(1, &exact), &options()), LengthsRefusal::NotScattered { features });
    let far = end("maximum", 190.0, "scatter = \"0.1 mm\"");
    assert_eq!(refused(&with_tables(1, &far), &options()), LengthsRefusal::Misfit);
    let few = Options { points: 36, ..options() };
    let sharp = end("maximum", 170.5, "scatter = \"0.0005 mm\"");
    match refused(&with_tables(1, &sharp), &few) {
        LengthsRefusal::FewMechanisms { effective, runs, least } => {
            assert!(effective < 100.0 && least == 100.0 && runs <= 36 * 199, "{effective} {runs}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn identity_rows_are_the_same_for_any_number_of_threads_and_go_on_in_a_study() {
    let study = of_ends(3, [70.35, 170.55]);
    let of = |threads: usize| answer(&study, &Options { threads, points: 60, ..options() });
    let one = of(1);
    assert_eq!(one.motion, of(2).motion);
    let written = SpecimenStudy::new(&study, &one, Path::new("narrowed.toml")).unwrap_or_else(|c| panic!("{c}"));
    let Some([name, csv]) = &written.mechanisms else { panic!("they were asked for") };
    assert_eq!(name, "narrowed-specimen.csv");
    assert!(csv.starts_with("parameter.rod_length [mm], parameter.place [mm]\n"), "{}", &csv[..80]);
    assert!(written.text.ends_with("[specimen]\nmechanisms = \"narrowed-specimen.csv\"\n"), "{}", written.text);
    let rows = written.study.specimen.as_ref().expect("rows");
    for (read, drawn) in rows.rows_si.iter().zip(&given(&one).rows_si) {
        assert!(read.iter().zip(drawn).all(|(read, drawn)| (read - drawn).abs() < 1e-15), "{read:?} {drawn:?}");
    }
    // 400 draws on average leave about as many different rows.
    assert!(rows.effective > 300.0 && rows.effective < 800.0, "{}", rows.effective);
    let again = identify(&written.study, &options(), UNHEARD).expect_err("it would count twice").to_string();
    assert!(again.contains("the measurement would count twice"), "{again}");
}
