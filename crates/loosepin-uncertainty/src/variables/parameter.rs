//! Parameters of a distribution that are themselves uncertain: probability boxes by parameters.

use crate::variables::distribution::{Distribution, DistributionError};
use crate::variables::random_variable::RandomVariable;

macro_rules! parameters {
    ($($parameter:ident $key:literal $words:literal $doc:literal;)+) => {
        /// A parameter of a distribution.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Parameter {
            $(#[doc = $doc] $parameter,)+
        }

        impl Parameter {
            /// Every parameter of any distribution.
            pub const ALL: [Self; [$($key),+].len()] = [$(Self::$parameter),+];

            /// The name by which study files call it.
            pub fn key(self) -> &'static str {
                match self { $(Self::$parameter => $key,)+ }
            }

            /// In words, as in messages, witnesses and reports.
            pub fn words(self) -> &'static str {
                match self { $(Self::$parameter => $words,)+ }
            }
        }
    };
}

parameters! {
    Mean "mean" "mean" "Mean.";
    StandardDeviation "standard_deviation" "standard deviation" "Standard deviation.";
    Lower "lower" "lower end" "Lower end.";
    Mode "mode" "mode" "Most likely value.";
    Upper "upper" "upper end" "Upper end.";
    Alpha "alpha" "alpha" "First shape.";
    Beta "beta" "beta" "Second shape.";
    Shape "shape" "shape" "Shape, where there is one.";
    Scale "scale" "scale" "Scale.";
}

/// Says that a parameter of a random input is an epistemic input: together with the others of its kind that makes a
/// probability box, the set of all distributions of the family whose parameters lie in their intervals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EpistemicParameter {
    /// Position of the random input.
    pub random: usize,
    /// Which of its parameters.
    pub parameter: Parameter,
    /// Position of the epistemic input whose value it takes.
    pub epistemic: usize,
}

impl Distribution {
    /// The number that stands for `parameter`, of a cut distribution before the cut; `None` if the family has no such
    /// parameter.
    pub fn parameter_mut(&mut self, parameter: Parameter) -> Option<&mut f64> {
        match (self, parameter) {
            (
                Self::Normal { mean, .. }
                | Self::TruncatedNormal { mean, .. }
                | Self::Lognormal { mean, .. }
                | Self::Exponential { mean, .. },
                Parameter::Mean,
            ) => Some(mean),
            (
                Self::Normal { standard_deviation, .. }
                | Self::TruncatedNormal { standard_deviation, .. }
                | Self::Lognormal { standard_deviation, .. },
                Parameter::StandardDeviation,
            ) => Some(standard_deviation),
            (
                Self::TruncatedNormal { lower, .. }
                | Self::Uniform { lower, .. }
                | Self::Triangular { lower, .. }
                | Self::Beta { lower, .. }
                | Self::Weibull { lower, .. }
                | Self::Gamma { lower, .. }
                | Self::Exponential { lower, .. },
                Parameter::Lower,
            ) => Some(lower),
            (
                Self::TruncatedNormal { upper, .. }
                | Self::Uniform { upper, .. }
                | Self::Triangular { upper, .. }
                | Self::Beta { upper, .. },
                Parameter::Upper,
            ) => Some(upper),
            (Self::Triangular { mode, .. } | Self::Gumbel { mode, .. }, Parameter::Mode) => Some(mode),
            (Self::Weibull { shape, .. } | Self::Gamma { shape, .. }, Parameter::Shape) => Some(shape),
            (
                Self::Weibull { scale, .. } | Self::Gamma { scale, .. } | Self::Gumbel { scale, .. },
                Parameter::Scale,
            ) => Some(scale),
            (Self::Truncated { of, .. }, parameter) => of.parameter_mut(parameter),
            (Self::Beta { alpha, .. }, Parameter::Alpha) => Some(alpha),
            (Self::Beta { beta, .. }, Parameter::Beta) => Some(beta),
            _ => None,
        }
    }
}

impl RandomVariable {
    /// The same family with some parameters replaced; those that the family does not have are left out.
    ///
    /// # Errors
    ///
    /// [`DistributionError`] where the parameters describe no distribution.
    pub fn with_parameters(
        &self,
        parameters: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> Result<Self, DistributionError> {
        let mut distribution = self.distribution().clone();
        for (parameter, value) in parameters {
            if let Some(place) = distribution.parameter_mut(parameter) {
                *place = value;
            }
        }
        Self::try_new(distribution)
    }
}

#[cfg(test)]
mod tests {
    use super::Parameter;
    use crate::{Distribution, RandomVariable};

    #[test]
    fn identity_a_replaced_parameter_is_the_only_change() {
        let beta = Distribution::Beta { alpha: 2.5, beta: 3.5, lower: -0.5, upper: 4.0 };
        let variable = RandomVariable::try_new(beta).unwrap();
        let moved = variable.with_parameters([(Parameter::Alpha, 7.0), (Parameter::Upper, 4.5)]).unwrap();
        assert_eq!(*moved.distribution(), Distribution::Beta { alpha: 7.0, beta: 3.5, lower: -0.5, upper: 4.5 });
        assert!(variable.with_parameters([(Parameter::Lower, 4.0)]).is_err());
        assert_eq!(variable.with_parameters([(Parameter::Mean, f64::NAN)]).unwrap(), variable);
    }

    #[test]
    fn identity_no_two_parameters_share_a_number() {
        let mut triangular = Distribution::Triangular { lower: 0.25, mode: 0.5, upper: 0.75 };
        let found: Vec<f64> =
            Parameter::ALL.into_iter().filter_map(|parameter| triangular.parameter_mut(parameter).copied()).collect();
        assert_eq!(found, [0.25, 0.5, 0.75]);
    }
}
