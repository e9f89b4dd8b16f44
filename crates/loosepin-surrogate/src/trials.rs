//! Functions with known shape, on which the surrogates are tried: for tests and for `tools/compare`. No study uses them.
//!
//! **Ishigami**: sin x_1 + 7 sin² x_2 + 0.1 x_3⁴ sin x_1, x_i uniform in \[-π, π\] (T. Ishigami and T. Homma, 1990).
//!
//! **Damped oscillator**: m ẍ + c ẋ + k x = F_0 + F cos(Ω t + φ) from x(0), ẋ(0), at 200 times evenly in \[0, 2 s\]. Twenty
//! inputs, each uniform within 25 % of its nominal value: m is a sum of 4 masses, k of 6 springs, c of 4 dampers; the others
//! are x(0), ẋ(0), F_0, F, Ω and φ. Underdamped everywhere, so with δ = c/2m, ω² = k/m - δ², z = F/(k - mΩ² + i cΩ)
//! and the particular solution p(t) = F_0/k + Re(z exp(i(Ωt + φ))),
//!
//! ```text
//! x(t) = p(t) + exp(-δt) (A cos ωt + B sin ωt),   A = x(0) - p(0),   B = (ẋ(0) - ṗ(0) + δA)/ω
//! ```

use super::input::Input;
use loosepin_uncertainty::{Distribution, RandomVariable, ScrambledSobol};

/// Times at which the oscillator is read.
pub const TIMES: usize = 200;
/// Nominal values: masses in kg, springs in N/m, dampers in N s/m, x(0) in m, ẋ(0) in m/s, F_0 and F in N, Ω in rad/s, φ in rad.
pub const OSCILLATOR_NOMINAL: [f64; 20] =
    [0.4, 0.3, 0.2, 0.1, 30.0, 22.0, 18.0, 14.0, 10.0, 6.0, 0.5, 0.35, 0.2, 0.15, 0.05, 0.3, 1.1, 2.1, 7.0, 0.4];
const SPAN_S: f64 = 2.0;
const SCATTER: f64 = 0.25;

fn uniform(lower: f64, upper: f64) -> Option<Input> {
    RandomVariable::try_new(Distribution::Uniform { lower, upper }).ok().map(Input::Random)
}

/// x_1 to x_3 of the Ishigami function.
pub fn ishigami_inputs() -> Vec<Input> {
    (0..3).filter_map(|_| uniform(-core::f64::consts::PI, core::f64::consts::PI)).collect()
}

/// The Ishigami function.
pub fn ishigami(x: &[f64]) -> f64 {
    let second = libm::sin(x[1]);
    libm::sin(x[0]) * (1.0 + 0.1 * x[2] * x[2] * x[2] * x[2]) + 7.0 * second * second
}

/// The inputs of the damped oscillator.
pub fn oscillator_inputs() -> Vec<Input> {
    OSCILLATOR_NOMINAL
        .iter()
        .filter_map(|nominal| uniform(nominal * (1.0 - SCATTER), nominal * (1.0 + SCATTER)))
        .collect()
}

/// x(t) in m at all times.
///
/// # Panics
///
/// Where `x` has fewer than 20 numbers.
pub fn oscillator(x: &[f64]) -> Vec<f64> {
    let mass: f64 = x[..4].iter().sum();
    let stiffness: f64 = x[4..10].iter().sum();
    let damping: f64 = x[10..14].iter().sum();
    let (start, speed, constant_force, force, frequency, phase) = (x[14], x[15], x[16], x[17], x[18], x[19]);
    let decay = damping / (2.0 * mass);
    let own = (stiffness / mass - decay * decay).sqrt();
    let (real, imaginary) = (stiffness - mass * frequency * frequency, damping * frequency);
    let size = force / (real * real + imaginary * imaginary);
    // z = F (real - i imaginary)/|...|²
    let particular = |t: f64| {
        let angle = frequency * t + phase;
        constant_force / stiffness + size * (real * libm::cos(angle) + imaginary * libm::sin(angle))
    };
    let particular_speed = size * frequency * (imaginary * libm::cos(phase) - real * libm::sin(phase));
    let cosine = start - particular(0.0);
    let sine = (speed - particular_speed + decay * cosine) / own;
    (0..TIMES)
        .map(|i| SPAN_S * i as f64 / (TIMES - 1) as f64)
        .map(|t| particular(t) + libm::exp(-decay * t) * (cosine * libm::cos(own * t) + sine * libm::sin(own * t)))
        .collect()
}

/// The first `count` points of a scrambled Sobol' sequence in the distributions of `inputs`; empty if there are more inputs
/// than it has dimensions.
pub fn points(inputs: &[Input], seed: u64, replicate: u32, count: usize) -> Vec<Vec<f64>> {
    let Ok(sobol) = ScrambledSobol::try_new(seed, inputs.len()) else { return Vec::new() };
    let value = |input: &Input, share: f64| match input {
        Input::Random(variable) => variable.quantile(share),
        Input::Epistemic(interval) => interval.at(share),
    };
    (0..count as u32)
        .map(|i| inputs.iter().enumerate().map(|(k, input)| value(input, sobol.point(replicate, i, k))).collect())
        .collect()
}
