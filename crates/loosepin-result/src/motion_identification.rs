//! The record of an identification from motion: which values of the unknowns are consistent with measured features.

use crate::play_bounds::PlayBounds;
use loosepin_text::units::{SiUnit, listed};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Identification of a specimen from the features of a measured motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionSpecimen {
    /// Its name; `None` if the file does not say.
    pub name: Option<String>,
    /// Its features, in the order of the file.
    pub features: Vec<MotionFeature>,
    /// The unknowns: interval of the study, and outer interval of the consistent set. Of an empty set both are that of the study.
    pub unknowns: Vec<PlayBounds>,
    /// Members of each unknown that is one of a list.
    pub lists: Vec<ConsistentMembers>,
    /// Share of the box that is consistent: cells whose middle is, and these with all cells beside them.
    pub share_of_box: [f64; 2],
    /// Cells of the box along each unknown at the end, members of a list each one.
    #[serde(default)]
    pub grid: Vec<usize>,
    /// The cells that are consistent, the first unknown changing fastest.
    #[serde(default)]
    pub cells: Vec<usize>,
    /// Values that were tested, with what came out.
    pub points: Vec<TestedPoint>,
    /// Runs at each of them.
    pub runs_per_point: usize,
    /// Runs that failed: each counts as if it lay further off than the measurement.
    pub failed: usize,
    /// Whether the refinement ended at its budget of points and not at its resolution.
    pub is_coarse: bool,
    /// Why no value is consistent; `None` if some are.
    pub misfit: Option<MotionMisfit>,
    /// How probable the values are, where that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub posterior: Option<MotionPosterior>,
    /// Mechanisms that agree with the measurement, if requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lengths: Option<SpecimenLengths>,
}

/// The random inputs of the specimen, given the measurement: prior of the unknowns uniform over the consistent set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SpecimenLengths {
    /// Mechanisms that agree.
    Given(MechanismRows),
    /// Why there are none.
    Refused(LengthsRefusal),
}

/// Mechanisms that agree with the measurement, each with the same probability.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MechanismRows {
    /// The random inputs, in the order of the study.
    pub columns: Vec<LengthColumn>,
    /// Values of each mechanism, SI; a mechanism may be there several times.
    pub rows_si: Vec<Vec<f64>>,
    /// Mechanisms that were run.
    pub runs: usize,
    /// Runs of these that failed.
    pub failed: usize,
    /// Number of equally probable mechanisms that would say as much: (Σ w)²/Σ w².
    pub effective: f64,
    /// The same of the rows, n²/Σ m² where a mechanism is there m times.
    pub effective_rows: f64,
    /// Lengths that trade off against an unknown.
    pub tied: Vec<TiedLength>,
    /// Unknowns that trade off against lengths together, though no single one of these is determined.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tied_together: Vec<TiedToLengths>,
}

/// A random input of the series, and of the specimen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LengthColumn {
    /// Its path.
    pub path: String,
    /// Its name in sentences.
    pub name: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Mean and standard deviation in the series, SI.
    pub before_si: [f64; 2],
    /// Mean and standard deviation given the measurement, SI.
    pub after_si: [f64; 2],
}

/// A length and an unknown of which the measurement knows the one only with the other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TiedLength {
    /// Place of the length among the columns.
    pub column: usize,
    /// Place of the unknown.
    pub unknown: usize,
    /// Rank correlation (Spearman) over the mechanisms.
    pub rank_correlation: f64,
}

/// An unknown that the measurement knows only with all lengths together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TiedToLengths {
    /// Place of the unknown.
    pub unknown: usize,
    /// Multiple correlation of its rank with those of all lengths, over the mechanisms.
    pub rank_correlation: f64,
}

/// Why there are no mechanisms that agree with the measurement.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LengthsRefusal {
    /// No value of the unknowns is consistent.
    Misfit,
    /// The study has no random inputs.
    NothingRandom,
    /// A distribution has uncertain parameters, of which rows would leave nothing.
    UncertainParameter {
        /// Path of the input.
        path: String,
    },
    /// Features without independent error, which a mechanism would have to meet exactly.
    NotScattered {
        /// Names of the features.
        features: Vec<String>,
    },
    /// Too many runs failed.
    Failed {
        /// How many.
        failed: usize,
        /// Total number of runs.
        runs: usize,
        /// Largest share that is allowed.
        most: f64,
    },
    /// Too few mechanisms carry the weight.
    FewMechanisms {
        /// Number of equally probable ones that would say as much.
        effective: f64,
        /// Mechanisms that were run.
        runs: usize,
        /// Number that is needed, at least.
        least: f64,
    },
}

/// The Bayesian answer beside the set: prior uniform over the box, each member of a list as probable as any other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MotionPosterior {
    /// The posterior distribution.
    Given(Posterior),
    /// Why there is none.
    Refused(PosteriorRefusal),
}

/// A posterior distribution of the unknowns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Posterior {
    /// Probability of each credible interval.
    pub probability: f64,
    /// Number of equally probable values that would carry as much as the tested ones do: 1/Σ p².
    pub effective_values: f64,
    /// Number of runs at the effective values.
    pub effective_runs: f64,
    /// The distribution of each unknown by itself, in their order.
    pub marginals: Vec<Marginal>,
}

/// The distribution of one unknown.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Marginal {
    /// Probabilities of cells of equal width over the interval of the study, or of the members of a list.
    pub shares: Vec<f64>,
    /// Its numbers; `None` for a list.
    pub summary: Option<MarginalSummary>,
}

/// Numbers of the distribution of an unknown that is no list.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MarginalSummary {
    /// Mean, SI.
    pub mean_si: f64,
    /// Standard deviation, SI.
    pub standard_deviation_si: f64,
    /// Credible interval with equal tails, SI.
    pub credible_si: [f64; 2],
}

/// Why there is no posterior distribution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PosteriorRefusal {
    /// No tested value is consistent.
    Misfit,
    /// Neither a random input nor an independent error scatters.
    NothingScatters,
    /// Too few runs at each value for the covariance of the features.
    FewRuns {
        /// Runs that ended, at the value with the fewest.
        runs: usize,
        /// Least number of runs for these features.
        least: usize,
    },
    /// Too many of the runs that carry the weight failed.
    Failed {
        /// Share of the runs, by weight.
        share: f64,
        /// Largest share that is allowed.
        most: f64,
    },
    /// Too few values along an unknown carry the weight.
    FewValues {
        /// Place of the unknown.
        unknown: usize,
        /// Number of equally probable values that would carry as much.
        effective: f64,
        /// Number that is needed, at least.
        least: f64,
        /// Whether further values would have been tested, had `--points` not been spent; else their cells are as narrow as they become.
        #[serde(default)]
        points_are_spent: bool,
    },
}

impl fmt::Display for LengthsRefusal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Misfit => write!(formatter, "no values of the unknowns are consistent"),
            Self::NothingRandom => write!(formatter, "the study has no random inputs"),
            Self::UncertainParameter { path } => write!(
                formatter,
                "the distribution of '{path}' has uncertain parameters, which rows cannot represent; write one number for each, or the input under [epistemic]"
            ),
            Self::NotScattered { features } => {
                let quoted: Vec<String> = features.iter().map(|name| format!("'{name}'")).collect();
                let each = if features.len() == 1 { "it" } else { "each" };
                write!(
                    formatter,
                    "a mechanism would have to agree with {} exactly; give {each} a scatter, the standard deviation of its independent error",
                    listed(&quoted, "and")
                )
            }
            Self::Failed { failed, runs, most } => {
                write!(formatter, "{failed} of {runs} runs failed, which is more than {} %", 100.0 * most)
            }
            Self::FewMechanisms { effective, runs, least } => write!(
                formatter,
                "the {runs} runs are equivalent to {} equally probable mechanisms, but {least:.0} are needed; use more runs (--points) or a larger scatter of the features",
                effective.floor()
            ),
        }
    }
}

/// An unknown that is one of a list.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ConsistentMembers {
    /// Its place among the unknowns.
    pub unknown: usize,
    /// All members as the file writes them: laws by their names.
    pub before: Vec<String>,
    /// Members that are consistent; empty for an empty set.
    pub after: Vec<String>,
}

/// A feature, measured and predicted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionFeature {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Mean over the repeats, SI.
    pub measured_si: f64,
    /// Number of repeats.
    pub repeats: usize,
    /// True values that its common error allows, SI.
    pub found_si: [f64; 2],
    /// Least and largest of all runs at all tested values, independent error included, SI.
    pub predicted_before_si: [f64; 2],
    /// The same at the consistent values; `None` if there are none.
    pub predicted_after_si: Option<[f64; 2]>,
}

/// Values of the unknowns that were tested.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TestedPoint {
    /// The values, SI, in the order of the unknowns; of a law its place in the list.
    pub values_si: Vec<f64>,
    /// Whether the test keeps them.
    pub is_consistent: bool,
    /// Distance of the measurement from the runs over that of the run at the confidence; above 1 where the test rejects.
    pub distance: f64,
}

/// Features that no value of the unknowns explains.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionMisfit {
    /// The least distance of all tested values, in distances of the run at the confidence: > 1.
    pub least_distance: f64,
    /// Features that lie outside all predictions by themselves.
    pub culprits: Vec<InconsistentFeature>,
}

/// A feature that lies outside the predictions at all tested values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InconsistentFeature {
    /// Its place among the features.
    pub feature: usize,
    /// How far the measurement, with its common error, lies from the nearest prediction, SI: below it where negative.
    pub apart_si: f64,
}

/// Expected information in features, before anything is measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionPlan {
    /// Name of the study.
    pub study: String,
    /// The unknowns.
    pub unknowns: Vec<PlannedUnknown>,
    /// Remaining range by each feature alone, the most informative first.
    pub features: Vec<PlannedFeature>,
    /// Remaining range by all features together.
    pub together: PlannedFeature,
    /// Pairs of members of a list that the features do not distinguish.
    pub not_distinguishable: Vec<IndistinguishableMembers>,
    /// Values that were tried.
    pub points: usize,
    /// Measurements that were to be imagined at all of them together.
    pub imagined: usize,
    /// How many of these have none, since their run failed: they count in no mean.
    pub failed: usize,
    /// Runs at each of them.
    pub runs_per_point: usize,
}

/// An unknown of a plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlannedUnknown {
    /// Its path.
    pub path: String,
    /// Its name in sentences.
    pub name: String,
    /// Whether it is one of a list.
    pub is_list: bool,
}

/// Expected result of a feature.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlannedFeature {
    /// Its name.
    pub name: String,
    /// Mean share of the box that would be left.
    pub share_of_box: f64,
    /// Mean share of the width of each unknown that would be left.
    pub shares_of_width: Vec<f64>,
}

/// Two members of a list that imitate each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct IndistinguishableMembers {
    /// Place of the unknown.
    pub unknown: usize,
    /// The true member and the one that is taken for it, as the file writes them: laws by their names.
    pub members: [String; 2],
    /// Share of measurements of the true member in which the other one is recognised as wrong.
    pub told: f64,
}
