//! Random parts Z of a response, whose distribution is known.
//!
//! Two of the laws have a shape k. At given m and s every statistic of m + s Z that is asked for rises or falls with k all the way: the
//! mean and the deviation of exp(k X) rise, its quantiles are exp(k q), P(exp(k X) > z) = Φ(-ln z / k); the probability of a branch falls,
//! and with it the mean, quantiles and probabilities of X + jump move towards those of X, the deviation too since it is below a half.

use super::draw::Draw;
use loosepin_uncertainty::{Distribution, hash, normal, normal_cdf, normal_quantile};

/// How Z follows from the random inputs.
#[derive(Debug, Clone)]
pub enum Law {
    /// A weighted sum of standard normal inputs, the squares of the weights adding to 1: standard normal.
    Sum(Vec<f64>),
    /// Standard normal, of which a share (standard deviation) is noise that any change of x or u draws anew, as chaotic motion.
    Chaotic {
        /// Standard deviation of the noise, in (0, 1).
        noise: f64,
    },
    /// Uniform in \[-1, 1\].
    Uniform,
    /// exp(k X), X standard normal.
    Lognormal,
    /// |X|, X standard normal.
    Absolute,
    /// One of some values.
    Discrete {
        /// Values, rising.
        values: Vec<f64>,
        /// Their probabilities.
        probabilities: Vec<f64>,
    },
    /// X + jump where a second normal input exceeds k.
    RareBranch {
        /// What the branch adds.
        jump: f64,
    },
}

impl Law {
    /// A law.
    pub fn draw(draw: &mut Draw, is_rough: bool) -> Self {
        if is_rough && draw.chance(0.5) {
            return Self::Chaotic { noise: draw.between(0.3, 0.95) };
        }
        match draw.below(10) {
            0..=2 => Self::Sum(vec![1.0]),
            3 | 4 => {
                let weights: Vec<f64> = (0..2 + draw.below(3)).map(|_| draw.between(0.2, 1.0)).collect();
                let length = weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
                Self::Sum(weights.into_iter().map(|weight| weight / length).collect())
            }
            5 => Self::Uniform,
            6 => Self::Lognormal,
            7 => Self::Absolute,
            8 => {
                let count = 2 + draw.below(4);
                let mut value = draw.between(-2.0, 0.0);
                let values = (0..count).map(|_| {
                    value += draw.between(0.3, 1.5);
                    value
                });
                let values = values.collect();
                let weights: Vec<f64> = (0..count).map(|_| draw.of_size(0.05, 1.0)).collect();
                let sum: f64 = weights.iter().sum();
                Self::Discrete { values, probabilities: weights.into_iter().map(|weight| weight / sum).collect() }
            }
            _ => Self::RareBranch { jump: draw.sign() * draw.between(2.0, 8.0) },
        }
    }

    /// A value that k may have; `None` if nothing depends on it.
    pub fn shape(&self, draw: &mut Draw) -> Option<f64> {
        match self {
            Self::Lognormal => Some(draw.of_size(0.3, 1.5)),
            Self::RareBranch { .. } => Some(-normal_quantile(draw.of_size(0.002, 0.1))),
            _ => None,
        }
    }

    /// In one word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Sum(weights) if weights.len() == 1 => "normal",
            Self::Sum(_) => "sum",
            Self::Chaotic { .. } => "chaotic",
            Self::Uniform => "uniform",
            Self::Lognormal => "lognormal",
            Self::Absolute => "absolute",
            Self::Discrete { .. } => "discrete",
            Self::RareBranch { .. } => "rare-branch",
        }
    }

    /// The random inputs.
    pub fn inputs(&self) -> Vec<Distribution> {
        let standard = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
        match self {
            Self::Sum(weights) => vec![standard; weights.len()],
            Self::Uniform => vec![Distribution::Uniform { lower: -1.0, upper: 1.0 }],
            Self::Discrete { values, probabilities } => {
                vec![Distribution::Discrete { values: values.clone(), probabilities: probabilities.clone() }]
            }
            Self::RareBranch { .. } => vec![standard; 2],
            Self::Chaotic { .. } | Self::Lognormal | Self::Absolute => vec![standard],
        }
    }

    /// Z of random inputs; of the epistemic inputs only the noise of chaotic motion depends.
    pub fn value(&self, k: f64, x: &[f64], u: &[f64]) -> f64 {
        match self {
            Self::Sum(weights) => weights.iter().zip(x).map(|(weight, x)| weight * x).sum(),
            Self::Chaotic { noise } => {
                let key = u.iter().fold(x[0].to_bits(), |key, u| hash(key, u.to_bits()));
                (1.0 - noise * noise).sqrt() * x[0] + noise * normal(key, 1)
            }
            Self::Uniform | Self::Discrete { .. } => x[0],
            Self::Lognormal => libm::exp(k * x[0]),
            Self::Absolute => x[0].abs(),
            Self::RareBranch { jump } => x[0] + if x[1] > k { *jump } else { 0.0 },
        }
    }

    /// E(Z).
    pub fn mean(&self, k: f64) -> f64 {
        match self {
            Self::Sum(_) | Self::Chaotic { .. } | Self::Uniform => 0.0,
            Self::Lognormal => libm::exp(0.5 * k * k),
            Self::Absolute => std::f64::consts::FRAC_2_PI.sqrt(),
            Self::Discrete { values, probabilities } => values.iter().zip(probabilities).map(|(v, p)| v * p).sum(),
            Self::RareBranch { jump } => jump * normal_cdf(-k),
        }
    }

    /// Standard deviation of Z.
    pub fn standard_deviation(&self, k: f64) -> f64 {
        let variance = match self {
            Self::Sum(_) | Self::Chaotic { .. } => 1.0,
            Self::Uniform => 1.0 / 3.0,
            Self::Lognormal => libm::exp(k * k) * libm::expm1(k * k),
            Self::Absolute => 1.0 - std::f64::consts::FRAC_2_PI,
            Self::Discrete { values, probabilities } => {
                let mean = self.mean(k);
                values.iter().zip(probabilities).map(|(v, p)| p * (v - mean) * (v - mean)).sum()
            }
            Self::RareBranch { jump } => {
                let probability = normal_cdf(-k);
                1.0 + jump * jump * probability * (1.0 - probability)
            }
        };
        variance.sqrt()
    }

    /// P(Z > z); at infinite `z` too.
    pub fn above(&self, k: f64, z: f64) -> f64 {
        match self {
            Self::Sum(_) | Self::Chaotic { .. } => normal_cdf(-z),
            Self::Uniform => (0.5 * (1.0 - z)).clamp(0.0, 1.0),
            Self::Lognormal if z <= 0.0 => 1.0,
            Self::Lognormal => normal_cdf(-libm::log(z) / k),
            Self::Absolute if z <= 0.0 => 1.0,
            Self::Absolute => 2.0 * normal_cdf(-z),
            Self::Discrete { values, probabilities } => {
                let above = values.iter().zip(probabilities).filter(|(value, _)| **value > z);
                above.map(|(_, probability)| probability).sum()
            }
            Self::RareBranch { jump } => {
                let probability = normal_cdf(-k);
                (1.0 - probability) * normal_cdf(-z) + probability * normal_cdf(jump - z)
            }
        }
    }

    /// The value that Z does not exceed with probability `p`.
    pub fn quantile(&self, k: f64, p: f64) -> f64 {
        match self {
            Self::Sum(_) | Self::Chaotic { .. } => normal_quantile(p),
            Self::Uniform => 2.0 * p - 1.0,
            Self::Lognormal => libm::exp(k * normal_quantile(p)),
            Self::Absolute => normal_quantile(0.5 + 0.5 * p),
            Self::Discrete { values, .. } => {
                let reached = values.iter().find(|value| 1.0 - self.above(k, **value) >= p);
                *reached.unwrap_or(&values[values.len() - 1])
            }
            Self::RareBranch { .. } => {
                let (mut low, mut high) = (-20.0, 20.0);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    if 1.0 - self.above(k, middle) < p { low = middle } else { high = middle }
                }
                0.5 * (low + high)
            }
        }
    }

    /// Whether Z and -Z are distributed alike, with one peak at 0: P(|m + s Z| > L) then rises with |m|, and with s where |m| < L.
    pub fn is_symmetric(&self) -> bool {
        matches!(self, Self::Sum(_) | Self::Chaotic { .. } | Self::Uniform)
    }
}

#[cfg(test)]
mod tests {
    use super::Law;
    use loosepin_uncertainty::{RandomVariable, hash, uniform};

    #[test]
    fn analytic_moments_probabilities_and_quantiles_are_those_of_many_numbers() {
        const COUNT: u64 = 200_000;
        /// Standard errors; there are about 60 comparisons.
        const MOST: f64 = 5.0;
        let laws = [
            (Law::Sum(vec![0.6, 0.8]), 0.0),
            (Law::Chaotic { noise: 0.7 }, 0.0),
            (Law::Uniform, 0.0),
            (Law::Lognormal, 0.6),
            (Law::Absolute, 0.0),
            (Law::Discrete { values: vec![-1.0, 0.3, 2.0], probabilities: vec![0.3, 0.5, 0.2] }, 0.0),
            (Law::RareBranch { jump: 5.0 }, 1.6),
            (Law::RareBranch { jump: -5.0 }, 2.1),
        ];
        for (law, k) in laws {
            let inputs = law.inputs().into_iter().map(|input| RandomVariable::try_new(input).expect("a distribution"));
            let inputs: Vec<RandomVariable> = inputs.collect();
            let draw = |run: u64| {
                let input = |(place, input): (u64, &RandomVariable)| input.quantile(uniform(hash(3, run), place));
                law.value(k, &(0..).zip(&inputs).map(input).collect::<Vec<f64>>(), &[0.37])
            };
            let values: Vec<f64> = (0..COUNT).map(draw).collect();
            let average = |of: &dyn Fn(f64) -> f64| {
                let mean = values.iter().map(|value| of(*value)).sum::<f64>() / COUNT as f64;
                let square = values.iter().map(|value| (of(*value) - mean).powi(2)).sum::<f64>() / COUNT as f64;
                (mean, (square / COUNT as f64).sqrt())
            };
            let check = |what: &str, (found, error): (f64, f64), exact: f64| {
                assert!((found - exact).abs() <= MOST * error, "{law:?}, {what}: {found} ± {error}, exact {exact}");
            };
            let (mean, deviation) = (law.mean(k), law.standard_deviation(k));
            check("mean", average(&|z| z), mean);
            check("variance", average(&|z| (z - mean) * (z - mean)), deviation * deviation);
            for p in [0.025, 0.5, 0.975] {
                let quantile = law.quantile(k, p);
                check("above", average(&|z| f64::from(u8::from(z > quantile))), law.above(k, quantile));
                // The values of a discrete number have probabilities.
                let below = 1.0 - law.above(k, quantile);
                let just_below = 1.0 - law.above(k, quantile - 1e-9);
                assert!(just_below <= p + 1e-8 && p <= below + 1e-8, "{law:?}: {p} {quantile} {just_below} {below}");
            }
        }
    }
}
