//! A distribution in words.

use loosepin_text::document::listed;
use loosepin_text::units::{Dimension, format_number, format_value};
use loosepin_uncertainty::Distribution;

/// Values of a discrete distribution that are shown one by one.
const MAX_TOLD: usize = 6;

/// `distribution` in words and people's units, for example `normal, mean 50 mm, standard deviation 0.02 mm`.
pub fn distribution_words(distribution: &Distribution, dimension: Dimension) -> String {
    let show = |value_si: f64| format_value(value_si, dimension);
    let family = distribution.family();
    let from = |lower: f64| if lower == 0.0 { String::new() } else { format!(", from {} on", show(lower)) };
    match distribution {
        Distribution::Normal { mean, standard_deviation } | Distribution::Lognormal { mean, standard_deviation } => {
            format!("{family}, mean {}, standard deviation {}", show(*mean), show(*standard_deviation))
        }
        Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => format!(
            "{family}, mean {}, standard deviation {} before the cut to {} .. {}",
            show(*mean),
            show(*standard_deviation),
            show(*lower),
            show(*upper)
        ),
        Distribution::Uniform { lower, upper } => format!("{family}, {} .. {}", show(*lower), show(*upper)),
        Distribution::Triangular { lower, mode, upper } => {
            format!("{family}, {} .. {}, most likely {}", show(*lower), show(*upper), show(*mode))
        }
        Distribution::Beta { alpha, beta, lower, upper } => {
            format!("{family}, {} .. {}, shapes {alpha} and {beta}", show(*lower), show(*upper))
        }
        Distribution::Weibull { shape, scale, lower } | Distribution::Gamma { shape, scale, lower } => {
            format!("{family}, shape {}, scale {}{}", format_number(*shape), show(*scale), from(*lower))
        }
        Distribution::Gumbel { mode, scale } => {
            format!("{family}, most likely {}, scale {}", show(*mode), show(*scale))
        }
        Distribution::Exponential { mean, lower } => format!("{family}, mean {}{}", show(*mean), from(*lower)),
        Distribution::Discrete { values, probabilities } if values.len() <= MAX_TOLD => {
            let atoms = values.iter().zip(probabilities);
            let told: Vec<String> = atoms
                .map(|(value, probability)| {
                    format!("{} with probability {}", show(*value), format_number(*probability))
                })
                .collect();
            format!("{family}, {}", listed(&told, "and"))
        }
        Distribution::Discrete { values, .. } => {
            let [least, greatest] = ends(values);
            format!("{family}, {} values, {} .. {}", values.len(), show(least), show(greatest))
        }
        Distribution::Empirical { values } => {
            let [least, greatest] = ends(values);
            format!("the sample of {} values as it is, {} .. {}", values.len(), show(least), show(greatest))
        }
        Distribution::Truncated { of, lower, upper } => {
            let cut = match (lower.is_finite(), upper.is_finite()) {
                (true, true) => format!("cut to {} .. {}", show(*lower), show(*upper)),
                (true, false) => format!("cut below {}", show(*lower)),
                _ => format!("cut above {}", show(*upper)),
            };
            format!("{}; {cut}", distribution_words(of, dimension))
        }
    }
}

fn ends(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| [low.min(value), high.max(value)])
}
