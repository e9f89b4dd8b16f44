//! Which tolerance must be tightened: shares at the place that a study asks about, of a toggle press at the end of its stroke and of a steering
//! linkage in space, against derivatives of their closed forms and against studies without one of the scatters.

mod press;
mod two_balls;

use loosepin::study::result::{Contributors, RandomContributor};

/// Of shares: the error of a finite difference, and of a standard deviation by a study's tolerance of ± 3 standard deviations.
const SHARE_TOLERANCE: f64 = 1e-5;
/// Step of a finite difference, m.
const STEP_M: f64 = 1e-7;

/// Shares of the variance of `reading` by dimensions with these standard deviations, to first order.
fn shares<const N: usize>(reading: &dyn Fn(&[f64; N]) -> f64, nominal: [f64; N], deviations: [f64; N]) -> [f64; N] {
    let variance = |k: usize| {
        let at = |step_m: f64| {
            let mut dimensions = nominal;
            dimensions[k] += step_m;
            reading(&dimensions)
        };
        ((at(STEP_M) - at(-STEP_M)) / (2.0 * STEP_M) * deviations[k]).powi(2)
    };
    let variances: [f64; N] = std::array::from_fn(variance);
    let all: f64 = variances.iter().sum();
    variances.map(|own| own / all)
}

fn of_path<'c>(contributors: &'c Contributors, path: &str) -> &'c RandomContributor {
    contributors.random.iter().find(|own| own.paths == [path]).unwrap_or_else(|| panic!("{path}: {contributors:?}"))
}

/// The text in one line.
fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<&str>>().join(" ")
}

/// The same study without the scatter of a dimension.
fn without(text: &str, path: &str) -> String {
    text.lines().filter(|own| !own.starts_with(&format!("\"{path}\""))).map(|own| format!("{own}\n")).collect()
}
