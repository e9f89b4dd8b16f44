//! The keys of a study file.

use loosepin_bounds::{MOST_OUTER, NumberKind};
use loosepin_mechanics::model::CYCLE_NUMBERS;
use loosepin_text::document::{Key, Keys, Kind, optional, required};
use loosepin_text::units::Rule;

use super::measured_keys::MEASURED_KEYS;
use super::motion_keys::MOTION_KEYS;
use super::parameter_keys::{PARAMETER_KEYS, ends, moments_of_quantity};
use super::words::{self, STATISTICS, WITH_A_NUMBER, words};
use crate::outputs::COMPONENTS;

/// What a double holds exactly, so that a seed survives every file format.
const LARGEST_SEED: u64 = (1 << 53) - 1;
/// Samples of the random inputs, at most: that many Sobol' points are distinct.
const MOST_INNER: u64 = 1 << 24;
/// Randomisations, at most.
const MOST_REPLICATES: u64 = 1024;

/// A value, or several of different dimensions.
const ACCURACY: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]);

pub(super) static STUDY_CYCLE_KEYS: Keys =
    Keys::new("what is run and recorded, where it differs from the model", &CYCLE_NUMBERS);

pub(super) static SAMPLING_KEYS: Keys = Keys::new(
    "how many runs, and how accurate",
    &[
        optional(
            "outer",
            Kind::Count { least: 1, most: MOST_OUTER as u64 },
            "64",
            "points in the box of the intervals; 64 if left out",
        ),
        optional(
            "inner",
            Kind::Count { least: 2, most: MOST_INNER },
            "256",
            "samples of the random inputs at each of them; 256 if left out",
        ),
        optional(
            "replicates",
            Kind::Count { least: 2, most: MOST_REPLICATES },
            "4",
            "independent randomisations, which tell the sampling error; 4 if left out",
        ),
        optional("tolerance", Kind::AnyQuantity, "\"1e-8 m\"", "a step may err by 0.5 % of it, in contacts that last by 10 %; 1e-8 m if left out"),
        optional(
            "most_failed",
            Kind::Number { rule: Rule::RequiredProbability },
            "0.1",
            "share of failed runs above which the study ends with an error; 0.1 if left out",
        ),
        optional(
            "accuracy",
            ACCURACY,
            "\"1 um\"",
            "what all bounds that measure the same are widened by at most: the samples grow until they are; a value or a list",
        ),
        optional(
            "budget",
            Kind::AnyQuantity,
            "\"30 min\"",
            "where the study ends although bounds are not yet as near: runs, a time, or \"12 rounds\"",
        ),
    ],
)
.with_planned(&[("threads", "threads are given on the command line, since results do not depend on them: --threads")])
.with_removed(&[(
    "reweighting",
    "leave it out; runs are made at every value of the parameters that the search looks at, as with \"never\"",
)]);

const SURROGATES: [&str; 5] = words(&words::SURROGATES);
const DIRECT_RUNS: [&str; 2] = words(&words::DIRECT_RUNS);
/// Runs that a surrogate learns from, at most: its training takes a time that grows with their third power.
const MOST_TRAINING: u64 = 2000;

pub(super) static SURROGATE_KEYS: Keys = Keys::new(
    "bounds from a function learned from few runs, beside the direct ones",
    &[
        optional(
            "kind",
            Kind::Choice(&SURROGATES),
            "\"auto\"",
            "auto (if left out) takes for each output what has the least held-out error",
        ),
        optional(
            "training_runs",
            Kind::Count { least: 4, most: MOST_TRAINING },
            "100",
            "runs to learn from; 25 for each uncertain input and at least 100 if left out",
        ),
        optional(
            "confirming_runs",
            Kind::Count { least: 2, most: MOST_INNER },
            "64",
            "direct runs at each witness, a multiple of the replicates; 16 in each if left out",
        ),
        optional(
            "direct",
            Kind::Choice(&DIRECT_RUNS),
            "\"confirming\"",
            "double-loop (if left out): the direct bounds stand beside; confirming: no direct runs but those",
        ),
    ],
);

pub(super) static PROMISE_KEYS: Keys = Keys::new(
    "a bound that a share of the box of the intervals keeps, without a model",
    &[
        optional(
            "share",
            Kind::Number { rule: Rule::Probability },
            "0.99",
            "share of the box, by volume, that keeps a promised bound, each of them; 0.99 if left out",
        ),
        optional(
            "confidence",
            Kind::Number { rule: Rule::Probability },
            "0.99",
            "confidence that this holds for all promised bounds together; 0.99 if left out",
        ),
        optional(
            "inner",
            Kind::Count { least: 1, most: MOST_INNER },
            "256",
            "runs at each value of the intervals; 256 if left out",
        ),
    ],
);

/// A parameter with a unit: a number, or what is known of it.
const PARAMETER: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::Table(&PARAMETER_KEYS)]);
/// The same, a pure number.
const SHAPE: Kind = Kind::AnyOf(&[Kind::Number { rule: Rule::Finite }, Kind::Table(&PARAMETER_KEYS)]);

pub(super) static NORMAL_KEYS: Keys = Keys::new("a normal distribution", &moments_of_quantity!(PARAMETER));
pub(super) static LOGNORMAL_KEYS: Keys = Keys::new(
    "a lognormal distribution, by mean and standard deviation of the variable itself",
    &moments_of_quantity!(PARAMETER),
);
pub(super) static TRUNCATED_NORMAL_KEYS: Keys = Keys::new(
    "a normal distribution cut to an interval; mean and standard deviation are those before the cut",
    &[moments_of_quantity!(PARAMETER)[0], moments_of_quantity!(PARAMETER)[1], ends!(PARAMETER)[0], ends!(PARAMETER)[1]],
);
pub(super) static UNIFORM_KEYS: Keys = Keys::new("a uniform distribution", &ends!(PARAMETER));
pub(super) static TRIANGULAR_KEYS: Keys = Keys::new(
    "a triangular distribution",
    &[ends!(PARAMETER)[0], required("mode", PARAMETER, "\"50 mm\"", "most likely value"), ends!(PARAMETER)[1]],
);
pub(super) static BETA_KEYS: Keys = Keys::new(
    "a beta distribution between two ends",
    &[
        required("alpha", SHAPE, "2", "first shape, from 0.001 to 1e6"),
        required("beta", SHAPE, "3", "second shape, from 0.001 to 1e6"),
        ends!(PARAMETER)[0],
        ends!(PARAMETER)[1],
    ],
);

/// The lower end of a distribution that goes on without end above it.
const FROM: Key = optional("lower", PARAMETER, "\"0 mm\"", "lower end; 0 if left out");
const SHAPE_KEY: Key = required("shape", SHAPE, "2", "shape, from 0.05 to 1e6");

pub(super) static WEIBULL_KEYS: Keys = Keys::new(
    "a Weibull distribution: a share of exp(-((x - lower)/scale)^shape) lies above x",
    &[SHAPE_KEY, required("scale", PARAMETER, "\"0.3 mm\"", "63.2 % lie less than this above the lower end"), FROM],
);
pub(super) static GAMMA_KEYS: Keys = Keys::new(
    "a gamma distribution",
    &[
        SHAPE_KEY,
        required("scale", PARAMETER, "\"0.1 mm\"", "the mean lies shape times scale above the lower end"),
        FROM,
    ],
);
pub(super) static GUMBEL_KEYS: Keys = Keys::new(
    "a Gumbel distribution of largest values: a share of exp(-exp(-(x - mode)/scale)) lies below x",
    &[
        required("mode", PARAMETER, "\"0.3 mm\"", "most likely value"),
        required("scale", PARAMETER, "\"0.02 mm\"", "scale; the standard deviation is 1.2825 times as large"),
    ],
);
pub(super) static EXPONENTIAL_KEYS: Keys = Keys::new(
    "an exponential distribution",
    &[required("mean", PARAMETER, "\"0.1 mm\"", "mean of the variable itself, above the lower end"), FROM],
);
pub(super) static DISCRETE_KEYS: Keys = Keys::new(
    "a few values with their probabilities",
    &[
        required("values", Kind::List(&Kind::AnyQuantity), "[\"0.2 mm\", \"0.3 mm\"]", "the values, each once"),
        required("probabilities", Kind::List(&Kind::AnyQuantity), "[0.4, 0.6]", "one for each value, with the sum 1"),
    ],
);
pub(super) static TRUNCATED_KEYS: Keys = Keys::new(
    "the interval that the distribution is cut to and rescaled in; at least one of the ends",
    &[
        optional("lower", Kind::AnyQuantity, "\"49.9 mm\"", "lower end"),
        optional("upper", Kind::AnyQuantity, "\"50.1 mm\"", "upper end"),
    ],
);

/// The families of distributions, in the order of the documentation.
pub(super) const FAMILIES: [&str; 11] = [
    "normal",
    "truncated_normal",
    "uniform",
    "lognormal",
    "triangular",
    "beta",
    "weibull",
    "gamma",
    "gumbel",
    "exponential",
    "discrete",
];

/// Whether a distribution of the family `name` has the value in the model for its mean where that is left out.
pub fn takes_mean_of_model(name: &str) -> bool {
    let mean = match RANDOM_KEYS.find(name).map(|key| key.kind) {
        Some(Kind::Table(keys)) => keys.find("mean"),
        _ => None,
    };
    mean.is_some_and(|mean| !mean.is_required)
}

/// Families that are fitted to samples.
pub(super) const FITTED: [&str; 6] = ["normal", "lognormal", "weibull", "gamma", "gumbel", "exponential"];

/// Everything that states a distribution.
const STATEMENTS: [&str; 14] = {
    let mut statements = [""; 14];
    let mut place = 0;
    while place < FAMILIES.len() {
        statements[place] = FAMILIES[place];
        place += 1;
    }
    statements[place] = "samples";
    statements[place + 1] = "tolerance";
    statements[place + 2] = "fit";
    statements
};

/// The fit of a hole and a shaft.
const FIT: Key = optional(
    "fit",
    Kind::Text,
    "\"H7/g6\"",
    "clearance of a hole and a shaft by ISO 286, on the radius or the diameter as the joint states it: hole in capital letters, then shaft; with diameter",
);
const DIAMETER: Key = optional("diameter", Kind::AnyQuantity, "\"20 mm\"", "nominal diameter of the fit");

pub(super) static RANDOM_KEYS: Keys = Keys::new(
    "the distribution of a quantity",
    &[
        optional(
            FAMILIES[0],
            Kind::Table(&NORMAL_KEYS),
            "{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }",
            "normal",
        ),
        optional(
            FAMILIES[1],
            Kind::Table(&TRUNCATED_NORMAL_KEYS),
            "{ mean = \"50 mm\", standard_deviation = \"0.02 mm\", lower = \"49.9 mm\", upper = \"50.1 mm\" }",
            "truncated normal",
        ),
        optional(FAMILIES[2], Kind::Table(&UNIFORM_KEYS), "{ lower = \"49.9 mm\", upper = \"50.1 mm\" }", "uniform"),
        optional(
            FAMILIES[3],
            Kind::Table(&LOGNORMAL_KEYS),
            "{ mean = \"0.3 mm\", standard_deviation = \"0.05 mm\" }",
            "lognormal",
        ),
        optional(
            FAMILIES[4],
            Kind::Table(&TRIANGULAR_KEYS),
            "{ lower = \"49.9 mm\", mode = \"50 mm\", upper = \"50.1 mm\" }",
            "triangular",
        ),
        optional(
            FAMILIES[5],
            Kind::Table(&BETA_KEYS),
            "{ alpha = 2, beta = 3, lower = \"49.9 mm\", upper = \"50.1 mm\" }",
            "beta",
        ),
        optional(FAMILIES[6], Kind::Table(&WEIBULL_KEYS), "{ shape = 2, scale = \"0.3 mm\" }", "Weibull"),
        optional(FAMILIES[7], Kind::Table(&GAMMA_KEYS), "{ shape = 4, scale = \"0.1 mm\" }", "gamma"),
        optional(
            FAMILIES[8],
            Kind::Table(&GUMBEL_KEYS),
            "{ mode = \"0.3 mm\", scale = \"0.02 mm\" }",
            "Gumbel, of largest values",
        ),
        optional(FAMILIES[9], Kind::Table(&EXPONENTIAL_KEYS), "{ mean = \"0.1 mm\" }", "exponential"),
        optional(
            FAMILIES[10],
            Kind::Table(&DISCRETE_KEYS),
            "{ values = [\"0.2 mm\", \"0.3 mm\"], probabilities = [0.4, 0.6] }",
            "a few values with their probabilities",
        ),
        optional(
            "samples",
            Kind::Text,
            "\"measured.csv\"",
            "a CSV file of measured values, its path from the folder of this file; every value is as probable as any other",
        ),
        optional("column", Kind::Text, "\"pin\"", "column of the samples, whose header has the unit: pin [mm]"),
        optional("fitted", Kind::Choice(&FITTED), "\"normal\"", "a family fitted to the samples in place of themselves"),
        optional(
            "tolerance",
            Kind::Text,
            "\"50 ± 0.05 mm\"",
            "normal, limits 3 standard deviations from the mean, times cpk; also 50 +0.02 -0.01 mm, and ± 0.05 mm about the value in the model",
        ),
        optional(
            "cpk",
            Kind::Number { rule: Rule::Finite },
            "1.33",
            "capability of the process; alone: centred; below cp: off centre by an unknown amount",
        ),
        optional("cp", Kind::Number { rule: Rule::Finite }, "1.67", "capability of the process if it were centred"),
        FIT,
        DIAMETER,
        optional(
            "truncated",
            Kind::Table(&TRUNCATED_KEYS),
            "{ upper = \"50.1 mm\" }",
            "the distribution is cut to an interval and rescaled",
        ),
    ],
)
.with_exactly_one(&[&STATEMENTS])
.with_planned(&[("empirical", "name the file: samples = \"measured.csv\", column = \"pin\"")]);

pub(super) static CORRELATION_KEYS: Keys = Keys::new(
    "how two random inputs go together (Gaussian copula)",
    &[
        required(
            "of",
            Kind::List(&Kind::Text),
            "[\"parameter.crank_length\", \"parameter.rod_length\"]",
            "paths of two random inputs",
        ),
        optional("rank", Kind::Number { rule: Rule::Finite }, "0.6", "rank correlation (Spearman)"),
        optional("linear", Kind::Number { rule: Rule::Finite }, "0.6", "linear correlation of the values (Pearson)"),
    ],
)
.with_exactly_one(&[&["rank", "linear"]]);

pub(super) static SPECIMEN_KEYS: Keys = Keys::new(
    "mechanisms that agree with what was measured",
    &[required(
        "mechanisms",
        Kind::Text,
        "\"narrowed-specimen.csv\"",
        "a CSV file, its path from the folder of this file: a column for each random input, named by its path with its unit; each row is as probable as any other",
    )],
);

pub(super) static ELEMENT_KEYS: Keys = Keys::new(
    "an interval and the mass of evidence that lies in it",
    &[
        required("interval", Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.3 mm\"]", "lower and upper end"),
        required("mass", Kind::Number { rule: Rule::Finite }, "0.4", "above 0; the masses of all elements sum to 1"),
    ],
);

pub(super) static CUT_KEYS: Keys = Keys::new(
    "a degree and the interval of all values possible to at least that degree",
    &[
        required("alpha", Kind::Number { rule: Rule::Finite }, "0.5", "the degree, from 0 to 1, increasing"),
        required("interval", Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.3 mm\"]", "lower and upper end"),
    ],
);

pub(super) static FUZZY_KEYS: Keys = Keys::new(
    "a fuzzy number",
    &[
        optional(
            "triangular",
            Kind::List(&Kind::AnyQuantity),
            "[\"0.1 mm\", \"0.2 mm\", \"0.5 mm\"]",
            "possible at all from the first to the third, to the degree 1 the second",
        ),
        optional(
            "trapezoidal",
            Kind::List(&Kind::AnyQuantity),
            "[\"0.1 mm\", \"0.2 mm\", \"0.3 mm\", \"0.5 mm\"]",
            "possible at all from the first to the fourth, to the degree 1 from the second to the third",
        ),
        optional("cuts", Kind::List(&Kind::Table(&CUT_KEYS)), "", "the cuts themselves, each within the one before"),
        optional(
            "degrees",
            Kind::List(&Kind::Number { rule: Rule::Finite }),
            "[0, 0.25, 0.5, 0.75, 1]",
            "degrees at which a triangle or trapezoid is cut; 0, 0.25, 0.5, 0.75 and 1 if left out",
        ),
    ],
)
.with_exactly_one(&[&["triangular", "trapezoidal", "cuts"]]);

pub(super) static EPISTEMIC_KEYS: Keys = Keys::new(
    "what is known of a quantity",
    &[
        optional(
            "interval",
            Kind::List(&Kind::AnyQuantity),
            "[\"0.1 mm\", \"0.5 mm\"]",
            "lower and upper end; every value between is possible, and nothing else is known",
        ),
        optional(
            "any_of",
            Kind::List(&Kind::AnyQuantity),
            "[\"lankarani-nikravesh\", \"flores\"]",
            "all values that are possible: laws for the law of a contact, else values with their unit",
        ),
        optional(
            "evidence",
            Kind::List(&Kind::Table(&ELEMENT_KEYS)),
            "",
            "intervals with masses: the true value lies in one of them, as much speaks for it as its mass says",
        ),
        optional(
            "periodic",
            Kind::List(&Kind::AnyQuantity),
            "[\"0 deg\", \"360 deg\"]",
            "one period of an angle or a phase that may have any value: its two ends are the same",
        ),
        optional("fuzzy", Kind::Table(&FUZZY_KEYS), "", "values possible to different degrees"),
        optional(
            "quantiles",
            Kind::List(&Kind::List(&Kind::AnyOf(&[Kind::Number { rule: Rule::Probability }, Kind::AnyQuantity]))),
            "[[0.05, \"0.1 mm\"], [0.5, \"0.2 mm\"], [0.95, \"0.4 mm\"]]",
            "a quantity that scatters in an unknown way, of which a few quantiles are known, and its support",
        ),
        optional(
            "mean",
            Kind::AnyQuantity,
            "\"0.2 mm\"",
            "a quantity that scatters in an unknown way, of which the mean is known, and its support",
        ),
        optional(
            "support",
            Kind::List(&Kind::AnyQuantity),
            "[\"0.05 mm\", \"0.5 mm\"]",
            "with quantiles or a mean: the least and the greatest value",
        ),
        FIT,
        DIAMETER,
    ],
)
.with_exactly_one(&[&["interval", "any_of", "fit", "evidence", "periodic", "fuzzy", "quantiles", "mean"]]);

const READINGS: [&str; 3] = words(&words::READINGS);
const TOGETHER: [&str; 2] = words(&words::TOGETHER);
const DEVIATIONS: [&str; 4] = words(&words::DEVIATIONS);
const REDUCTIONS: [&str; 6] = words(&words::REDUCTIONS);
const PLAIN_STATISTICS: [&str; words::PLAIN_STATISTICS.len()] = words(&words::PLAIN_STATISTICS);
const METHODS: [&str; 4] = words(&words::METHODS);
const PROMISED_ENDS: [&str; 3] = words(&words::PROMISED_ENDS);
const DECIDED_BY: [&str; 2] = words(&words::DECIDED_BY);

const METHOD: Key = optional(
    "method",
    Kind::Choice(&METHODS),
    "\"importance\"",
    "of a probability: count (if left out), importance or subset for small ones, automatic where too few are counted",
);
/// One for each statistic with a number, then what goes with some of them.
const OF_STATISTICS: [Key; WITH_A_NUMBER.len() + 1] = {
    let mut keys = [METHOD; WITH_A_NUMBER.len() + 1];
    let mut place = 0;
    while place < WITH_A_NUMBER.len() {
        let description = WITH_A_NUMBER[place].description();
        if let Some(number) = description.number {
            let kind = match number.kind {
                NumberKind::Share => Kind::Number { rule: Rule::Probability },
                NumberKind::Limit | NumberKind::LimitOfMagnitude => Kind::AnyQuantity,
            };
            keys[place] = optional(description.word, kind, number.example, number.meaning);
        }
        place += 1;
    }
    keys
};

pub(super) static STATISTIC_KEYS: Keys =
    Keys::new("a statistic with a number", &OF_STATISTICS).with_exactly_one(&[&STATISTICS]);

const DEVIATION_DOC: &str =
    "value: the output itself; its deviation: dimensional, by lengths alone; clearance, by play alone; total, by both";
const COMPONENT_DOC: &str = "of a path, and only there: a coordinate of the point; its error along the path, normal to it (to the left), or whole; \
    contour: its distance from the path whatever the timing";
const POSES: Kind = Kind::Values(&Kind::List(&Kind::AnyQuantity));
const POSES_EXAMPLE: &str = "{ crank = [\"60 deg\"] }";
const POSES_DOC: &str = "angles of the drive that the cycle counts";

pub(super) static ASK_KEYS: Keys = Keys::new(
    "a question: statistics of an output",
    &[
        required("output", Kind::Reference("output"), "\"slider\"", "an output of the model"),
        optional("component", Kind::Choice(&COMPONENTS), "\"normal\"", COMPONENT_DOC),
        required("of", Kind::Choice(&DEVIATIONS), "\"total\"", DEVIATION_DOC),
        optional("at", Kind::Choice(&["cycle"]), "\"cycle\"", "the whole curve over the cycle"),
        optional("poses", POSES, POSES_EXAMPLE, POSES_DOC),
        optional("reduce", Kind::Choice(&REDUCTIONS), "\"maximum_absolute\"", "one number of the whole curve"),
        required(
            "statistics",
            Kind::List(&Kind::AnyOf(&[Kind::Choice(&PLAIN_STATISTICS), Kind::Table(&STATISTIC_KEYS)])),
            "[\"mean\", { quantile = 0.975 }]",
            "statistics by name, or as tables with a number",
        ),
        optional(
            "accuracy",
            ACCURACY,
            "\"1 um\"",
            "what these bounds are widened by at most: the samples grow until they are; a value or a list",
        ),
        optional(
            "promise",
            Kind::Choice(&PROMISED_ENDS),
            "\"upper\"",
            "ends of these quantiles and probabilities that are also promised for a share of the box; none if left out",
        ),
    ],
)
.with_exactly_one(&[&["at", "poses", "reduce"]]);

/// What a requirement can limit.
pub(super) const LIMITS: [&str; 3] = ["within", "below", "above"];

pub(super) static REQUIRE_KEYS: Keys = Keys::new(
    "a requirement that must hold for every value of the epistemic inputs",
    &[
        required("output", Kind::Reference("output"), "\"slider\"", "an output of the model"),
        optional("component", Kind::Choice(&COMPONENTS), "\"normal\"", COMPONENT_DOC),
        required("of", Kind::Choice(&DEVIATIONS), "\"total\"", DEVIATION_DOC),
        optional(LIMITS[0], Kind::AnyQuantity, "\"0.6 mm\"", "limit of the magnitude"),
        optional(LIMITS[1], Kind::AnyQuantity, "\"2 kN\"", "the largest value that is allowed"),
        optional(LIMITS[2], Kind::AnyQuantity, "\"-2 kN\"", "the least value that is allowed"),
        optional("over", Kind::Choice(&["cycle"]), "\"cycle\"", "nowhere in the cycle may the limit be exceeded"),
        optional("poses", POSES, POSES_EXAMPLE, POSES_DOC),
        required(
            "probability_at_least",
            Kind::Number { rule: Rule::RequiredProbability },
            "0.9973",
            "the least probability of staying within the limit",
        ),
        optional(
            "decided_by",
            Kind::Choice(&DECIDED_BY),
            "\"promise\"",
            "search (if left out): for every value of the epistemic inputs; promise: for a share of the box, without a model",
        ),
    ],
)
.with_exactly_one(&[&LIMITS, &["over", "poses"]]);

pub(super) static ALLOW_KEYS: Keys = Keys::new(
    "what may be loosened as far as the requirements allow: the upper end of an interval, a standard deviation, or a fit",
    &[
        optional("up_to", Kind::AnyQuantity, "\"0.5 mm\"", "the largest value that is asked about"),
        optional(
            "fit",
            Kind::List(&Kind::Text),
            "[\"H7/g6\", \"H8/f7\", \"H9/e9\"]",
            "ISO 286 fits of a joint with play, in any order: the loosest of them is asked for",
        ),
        optional("diameter", Kind::AnyQuantity, "\"20 mm\"", "diameter of the fits"),
        optional(
            "cost",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0.01 mm\", 12.0], [\"0.05 mm\", 3.0]]",
            "values that are offered, each with its cost; the cheapest combination over all inputs is chosen",
        ),
    ],
)
.with_exactly_one(&[&["up_to", "fit"]]);

/// The keys of a study that all questions share.
pub(super) static SHARED_KEYS: Keys = Keys::new(
    "what is uncertain in a model, and what is asked",
    &[
        required("name", Kind::Text, "\"worn pin at 5000 rpm\"", "name of the study"),
        required("model", Kind::Text, "\"model.toml\"", "the model file, from the folder of this file"),
        optional(
            "seed",
            Kind::Count { least: 0, most: LARGEST_SEED },
            "1",
            "the same seed gives the same results; 1 if left out",
        ),
        optional(
            "cycle",
            Kind::Table(&STUDY_CYCLE_KEYS),
            "",
            "what is run and recorded, where it differs from the model",
        ),
        optional("sampling", Kind::Table(&SAMPLING_KEYS), "", "how many runs, and how accurate"),
        optional(
            "surrogate",
            Kind::AnyOf(&[Kind::Choice(&SURROGATES), Kind::Table(&SURROGATE_KEYS)]),
            "\"auto\"",
            "bounds from a function learned from few runs, beside the direct ones; none if left out",
        ),
        optional(
            "promise",
            Kind::Table(&PROMISE_KEYS),
            "",
            "a bound that a share of the box of the intervals keeps, without a model: how large; for questions with promise and requirements decided by one",
        ),
        optional(
            "random",
            Kind::Tables { keys: &RANDOM_KEYS, except: &[] },
            "",
            "quantities with known distributions, by their paths in the model",
        ),
        optional(
            "epistemic",
            Kind::Tables { keys: &EPISTEMIC_KEYS, except: &[] },
            "",
            "quantities known only as intervals, and quantities and laws known only as lists, by their paths in the model",
        ),
        optional(
            "correlation",
            Kind::List(&Kind::Table(&CORRELATION_KEYS)),
            "",
            "random inputs that go together; all others are independent",
        ),
        optional(
            "specimen",
            Kind::Table(&SPECIMEN_KEYS),
            "",
            "the mechanism that was measured: rows in place of the distributions under `[random]`; any mechanism of the series if left out",
        ),
        optional(
            "reading",
            Kind::AnyOf(&[Kind::Choice(&READINGS), Kind::List(&Kind::Choice(&READINGS))]),
            "\"fixed\"",
            "how an interval is read: one value fixed but unknown, a distribution that is unknown, or any value for each sample; fixed if left out; of several, bounds stand side by side",
        ),
        optional(
            "percentiles",
            Kind::List(&Kind::Number { rule: Rule::Probability }),
            "[0.05, 0.5, 0.95]",
            "where a parameter of a distribution has a distribution: percentiles of each statistic; 0.05, 0.5 and 0.95 if left out",
        ),
        optional("ask", Kind::List(&Kind::Table(&ASK_KEYS)), "", "questions"),
        optional("require", Kind::List(&Kind::Table(&REQUIRE_KEYS)), "", "requirements"),
        optional(
            "measured",
            Kind::List(&Kind::AnyOf(&[Kind::Table(&MEASURED_KEYS), Kind::Table(&MOTION_KEYS)])),
            "",
            "readings of a backlash test, or features of a motion, from which `loosepin identify` narrows intervals",
        ),
        optional(
            "allow",
            Kind::Tables { keys: &ALLOW_KEYS, except: &[] },
            "",
            "uncertain inputs that may be loosened as far as the requirements allow, by their paths",
        ),
        optional(
            "allow_together",
            Kind::Choice(&TOGETHER),
            "\"frontier\"",
            "the inputs of `[allow]` are loosened together: each to the same share of its `up_to`, or two of them as a curve; one at a time if left out",
        ),
    ],
);
