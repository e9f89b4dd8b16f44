//! Data for the figures of the report: curves, probability boxes, treatments, energy residuals, impacts.

use serde::{Deserialize, Serialize};

use super::bound::{NumericalError, ResponsePoint, Witness};
use crate::contact_basis::ContactBasis;
use loosepin_terms::{Deviation, Treatment};
use loosepin_text::units::{SiUnit, extended};

/// Deviation of one output over the cycle. All lists have one entry per element of `pose_rad`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DeviationCurve {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Unit of the values.
    pub unit: SiUnit,
    /// Probabilities of the two ends of the bands, for example 0.025 and 0.975.
    #[serde(with = "extended")]
    pub probabilities: [f64; 2],
    /// Epistemic inputs at which the random band stands, usually the middle of their intervals.
    pub centre: Witness,
    /// Largest numerical error of the ends of the mixed band.
    #[serde(with = "extended")]
    pub numerical_error_si: f64,
    /// Confidence in the sampling error of each end by itself. It is less than that of other bounds where ends are cut to the bound of the
    /// largest deviation: then both bounds must hold. Absent in records of older versions.
    #[serde(default, with = "extended")]
    pub confidence: Option<f64>,
    /// Angle of the drive, increasing.
    #[serde(with = "extended")]
    pub pose_rad: Vec<f64>,
    /// The output of the ideal mechanism.
    #[serde(with = "extended")]
    pub ideal_si: Vec<f64>,
    /// Deviation with nominal dimensions and the epistemic inputs of `centre`.
    #[serde(with = "extended")]
    pub nominal_si: Vec<f64>,
    /// Band of the random scatter alone, at `centre`.
    pub random: CurveRange,
    /// The band widened by the epistemic inputs: lowest lower quantile to highest upper quantile, numerical error
    /// included.
    pub mixed: CurveRange,
    /// Bands in which a share of mechanisms stays for the whole cycle, where they were asked for.
    #[serde(default)]
    pub simultaneous: Vec<SimultaneousCurve>,
    /// Bands at single values of the epistemic inputs that were run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub at_values: Vec<ValueBand>,
    /// The ideal path, where the deviation is the distance of a point from it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<PathCurve>,
}

/// The band at one value of the epistemic inputs, counted from the runs at this value, without an error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ValueBand {
    /// The value.
    pub at: Witness,
    /// Runs at this value.
    pub runs: u64,
    /// The ends, with the probabilities of the curve.
    pub band: CurveRange,
}

/// The ideal path of a point over the cycle. All lists have one entry per pose.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct PathCurve {
    /// Positions, m.
    #[serde(with = "extended")]
    pub x_m: Vec<f64>,
    /// Positions, m.
    #[serde(with = "extended")]
    pub y_m: Vec<f64>,
    /// Unit vectors along the motion.
    #[serde(with = "extended")]
    pub tangent_x: Vec<f64>,
    /// Unit vectors along the motion.
    #[serde(with = "extended")]
    pub tangent_y: Vec<f64>,
}

/// A band in which a share of mechanisms stays for the whole cycle, whatever the unknown values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SimultaneousCurve {
    /// The share, in (0, 1).
    #[serde(with = "extended")]
    pub share: f64,
    /// How many times as wide as the band of the same share at each point by itself, numerical error included; at least 1.
    #[serde(with = "extended")]
    pub factor: f64,
    /// The epistemic inputs at which most mechanisms leave it.
    pub witness: Witness,
    /// Both ends, numerical error included; empty if the runs do not determine them.
    pub band: CurveRange,
}

/// Lower and upper values over the cycle.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct CurveRange {
    /// Lower values.
    #[serde(with = "extended")]
    pub lower_si: Vec<f64>,
    /// Upper values.
    #[serde(with = "extended")]
    pub upper_si: Vec<f64>,
}

/// Bounds of the distribution function of one response. All lists have one entry per element of `value_si`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProbabilityBox {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// How the cycle was reduced to one number.
    pub at: ResponsePoint,
    /// Unit of the values.
    pub unit: SiUnit,
    /// Values of the response, increasing.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
    /// Smallest probability over the epistemic inputs that the response stays below the value.
    #[serde(with = "extended")]
    pub lower: Vec<f64>,
    /// Largest probability over the epistemic inputs that the response stays below the value.
    #[serde(with = "extended")]
    pub upper: Vec<f64>,
    /// The same probability when every interval is taken as uniformly distributed.
    #[serde(with = "extended")]
    pub probability_only: Vec<f64>,
    /// A limit that was asked about, where there is one.
    #[serde(with = "extended")]
    pub limit_si: Option<f64>,
    /// Sampling error of the probabilities, those of `probability_only` included, >= 0.
    #[serde(with = "extended")]
    pub numerical_error: f64,
}

/// The three treatments of one response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TreatmentComparison {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle, or its reduction.
    pub at: ResponsePoint,
    /// Unit of the bands.
    pub unit: SiUnit,
    /// The share of mechanisms that a band promises to hold, for example 0.95.
    #[serde(with = "extended")]
    pub promised_coverage: f64,
    /// One entry per treatment.
    pub bands: Vec<TreatmentBand>,
    /// Ends that are proven without dynamics: nothing passes them while all parts lie within their limits, those without a limit within 3
    /// standard deviations, and all joints within their play. Penetration of contacts and bending bodies add to them. Absent where nothing is
    /// proven, and in records of older versions.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "extended")]
    pub proven_without_dynamics_si: Option<[f64; 2]>,
}

/// The band that one treatment claims, and what it really holds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TreatmentBand {
    /// The treatment.
    pub treatment: Treatment,
    /// Lower end of the band.
    #[serde(with = "extended")]
    pub lower_si: f64,
    /// Upper end of the band.
    #[serde(with = "extended")]
    pub upper_si: f64,
    /// Smallest true share of mechanisms inside the band over the epistemic inputs.
    #[serde(with = "extended")]
    pub coverage_minimum: f64,
    /// Largest true share.
    #[serde(with = "extended")]
    pub coverage_maximum: f64,
    /// Numerical error of the shares.
    #[serde(with = "extended")]
    pub coverage_error: f64,
    /// Share inside the band at each value of the epistemic inputs that was run.
    pub coverage_at: Vec<CoveragePoint>,
    /// How far the ends may be off; absent in records of older versions of what direct runs gave.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[TreatmentEnd; 2]>,
    /// Whether the band is that of a surrogate; `coverage_error` then holds what its error does to the shares.
    #[serde(default)]
    pub is_by_surrogate: bool,
}

/// How far an end of a band may be off.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TreatmentEnd {
    /// The end moved outwards by the unresolved part.
    #[serde(with = "extended")]
    pub widened_si: f64,
    /// Its numerical error.
    pub error: NumericalError,
}

impl TreatmentBand {
    /// Width of the band.
    pub fn width_si(&self) -> f64 {
        self.upper_si - self.lower_si
    }

    /// Whether the shares are too uncertain to decide if the band keeps its promise: one by a surrogate whose error is larger than the
    /// share that may lie outside, or one of direct runs that is hardly known, as where many failed.
    pub fn is_promise_unknown(&self, promised_coverage: f64) -> bool {
        const HARDLY_KNOWN: f64 = 0.25;
        let most = if self.is_by_surrogate { 1.0 - promised_coverage } else { HARDLY_KNOWN };
        self.coverage_error > most && (self.coverage_minimum - promised_coverage).abs() < self.coverage_error
    }

    /// The least share inside, reduced by the error of a surrogate; counts of direct runs are not reduced.
    pub fn least_share(&self) -> f64 {
        let unknown = if self.is_by_surrogate { self.coverage_error } else { 0.0 };
        (self.coverage_minimum - unknown).max(0.0)
    }

    /// The larger part of the error of its ends that a surrogate does not know; `None` for a band of direct runs.
    pub fn surrogate_error_si(&self) -> Option<f64> {
        let ends = self.ends.as_ref().filter(|_| self.is_by_surrogate)?;
        Some(ends[0].error.surrogate_si.max(ends[1].error.surrogate_si))
    }

    /// The larger numerical error of its ends, where it is known.
    pub fn error_si(&self) -> Option<f64> {
        self.ends.as_ref().map(|ends| ends[0].error.total_si().max(ends[1].error.total_si()))
    }

    /// Whether the band holds at least `promised_coverage` whatever the epistemic inputs are, within numerical error.
    pub fn keeps_promise(&self, promised_coverage: f64) -> bool {
        self.coverage_minimum + self.coverage_error >= promised_coverage
    }
}

/// Share of mechanisms inside a band at one value of the epistemic inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CoveragePoint {
    /// The epistemic inputs.
    pub at: Witness,
    /// The share, 0 to 1.
    #[serde(with = "extended")]
    pub coverage: f64,
}

/// Relative energy residuals of the finished runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EnergyResiduals {
    /// Half of the runs stay below.
    #[serde(with = "extended")]
    pub median: f64,
    /// 90 % of the runs stay below.
    #[serde(with = "extended")]
    pub quantile_90: f64,
    /// 99 % of the runs stay below.
    #[serde(with = "extended")]
    pub quantile_99: f64,
    /// The largest of all.
    #[serde(with = "extended")]
    pub maximum: f64,
    /// How many runs lie in which decade or part of it, increasing.
    pub histogram: Vec<HistogramBin>,
}

/// One bar of a histogram over a logarithmic axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HistogramBin {
    /// Lower end, > 0.
    #[serde(with = "extended")]
    pub from: f64,
    /// Upper end.
    #[serde(with = "extended")]
    pub to: f64,
    /// Runs inside.
    pub count: u64,
}

/// A contact law of the runs of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudiedLaw {
    /// Its name.
    pub law: String,
    /// Assumptions behind its force, at the nominal values.
    pub basis: ContactBasis,
}

/// Impacts in one clearance joint over all runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointImpacts {
    /// Name of the joint.
    pub joint: String,
    /// The contact laws of the runs, one if the study has no list of them; empty in records of older versions.
    #[serde(default)]
    pub laws: Vec<StudiedLaw>,
    /// Impacts per turn: smallest, median and largest over the runs.
    #[serde(with = "extended")]
    pub impacts_per_turn: [f64; 3],
    /// Coefficient of restitution as stated: smallest and largest over the runs.
    #[serde(with = "extended")]
    pub nominal_restitution: Option<[f64; 2]>,
    /// Coefficient of restitution that free impacts deliver under the law: smallest and largest over the runs.
    #[serde(with = "extended")]
    pub delivered_restitution: Option<[f64; 2]>,
    /// Share of the impacts outside the validity limit of the law, over all runs.
    #[serde(with = "extended")]
    pub share_outside_validity: Option<f64>,
    /// Largest penetration over the radial clearance of its run, of any run.
    #[serde(with = "extended")]
    pub largest_penetration_share: f64,
    /// Largest contact force of any run.
    #[serde(with = "extended")]
    pub peak_force_n: f64,
    /// Contacts that began more slowly than the least impact speed, over all runs.
    pub floored_contacts: u64,
}
