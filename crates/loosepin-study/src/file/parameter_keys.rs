//! The keys of what is known of a parameter of a distribution: an interval, a list, or a distribution of its own.

use loosepin_text::document::{Keys, Kind, optional, required};

/// The ends that most distributions have; `$kind` is a number with its unit, or more.
macro_rules! ends {
    ($kind:expr) => {
        [required("lower", $kind, "\"49.9 mm\"", "lower end"), required("upper", $kind, "\"50.1 mm\"", "upper end")]
    };
}

/// Mean and standard deviation of a parameter of a distribution.
macro_rules! moments {
    ($kind:expr) => {
        [
            required("mean", $kind, "\"50 mm\"", "mean"),
            required("standard_deviation", $kind, "\"0.02 mm\"", "standard deviation"),
        ]
    };
}

/// Mean and standard deviation of a quantity of the model; `$kind` is a number with its unit, or more.
macro_rules! moments_of_quantity {
    ($kind:expr) => {
        [
            optional("mean", $kind, "\"50 mm\"", "mean; the value in the model if left out"),
            required("standard_deviation", $kind, "\"0.02 mm\"", "standard deviation"),
        ]
    };
}

pub(super) use {ends, moments_of_quantity};

static NORMAL: Keys = Keys::new("a normal distribution of a parameter", &moments!(Kind::AnyQuantity));
static LOGNORMAL: Keys = Keys::new(
    "a lognormal distribution of a parameter, by mean and standard deviation of the parameter itself",
    &moments!(Kind::AnyQuantity),
);
static TRUNCATED_NORMAL: Keys = Keys::new(
    "a normal distribution of a parameter, cut to an interval; mean and standard deviation are those before the cut",
    &[
        moments!(Kind::AnyQuantity)[0],
        moments!(Kind::AnyQuantity)[1],
        ends!(Kind::AnyQuantity)[0],
        ends!(Kind::AnyQuantity)[1],
    ],
);
static UNIFORM: Keys = Keys::new("a uniform distribution of a parameter", &ends!(Kind::AnyQuantity));
static TRIANGULAR: Keys = Keys::new(
    "a triangular distribution of a parameter",
    &[
        ends!(Kind::AnyQuantity)[0],
        required("mode", Kind::AnyQuantity, "\"50 mm\"", "most likely value"),
        ends!(Kind::AnyQuantity)[1],
    ],
);

/// Families that a parameter may have.
pub(super) const PARAMETER_FAMILIES: [&str; 5] = ["normal", "lognormal", "truncated_normal", "uniform", "triangular"];

/// What is known of a parameter of a distribution.
pub(super) static PARAMETER_KEYS: Keys = Keys::new(
    "what is known of a parameter of a distribution: with an interval or a list the distribution is a probability box, with a distribution \
     of the parameter every statistic is itself random",
    &[
        optional(
            "interval",
            Kind::List(&Kind::AnyQuantity),
            "[\"119.98 mm\", \"120.02 mm\"]",
            "lower and upper end; every value between is possible, and nothing else is known",
        ),
        optional(
            "any_of",
            Kind::List(&Kind::AnyQuantity),
            "[\"119.98 mm\", \"120.02 mm\"]",
            "all values that are possible, with their unit",
        ),
        optional(
            PARAMETER_FAMILIES[0],
            Kind::Table(&NORMAL),
            "{ mean = \"120 mm\", standard_deviation = \"0.01 mm\" }",
            "the parameter is one value, normal as far as it is known",
        ),
        optional(
            PARAMETER_FAMILIES[1],
            Kind::Table(&LOGNORMAL),
            "{ mean = \"0.02 mm\", standard_deviation = \"0.004 mm\" }",
            "the same, lognormal",
        ),
        optional(
            PARAMETER_FAMILIES[2],
            Kind::Table(&TRUNCATED_NORMAL),
            "{ mean = \"120 mm\", standard_deviation = \"0.01 mm\", lower = \"119.98 mm\", upper = \"120.02 mm\" }",
            "the same, normal and cut",
        ),
        optional(
            PARAMETER_FAMILIES[3],
            Kind::Table(&UNIFORM),
            "{ lower = \"119.98 mm\", upper = \"120.02 mm\" }",
            "the same, uniform",
        ),
        optional(
            PARAMETER_FAMILIES[4],
            Kind::Table(&TRIANGULAR),
            "{ lower = \"119.98 mm\", mode = \"120 mm\", upper = \"120.02 mm\" }",
            "the same, triangular",
        ),
    ],
)
.with_exactly_one(&[&["interval", "any_of", "normal", "lognormal", "truncated_normal", "uniform", "triangular"]]);
