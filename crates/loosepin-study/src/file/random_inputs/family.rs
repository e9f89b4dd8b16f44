//! Families of distributions, of random inputs and of parameters of distributions alike, with their keys. `distribution.rs` reads each.

use crate::file::reader::StudyReader;
use loosepin_text::document::{Entry, Key, Keys, Kind, Reads, Table, joined, optional, required};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};
use loosepin_uncertainty::Distribution;

/// A family of distributions, as a table of keys has it.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    /// Its key, of a table.
    pub key: Key,
    /// Reads the table, whose numbers have this dimension.
    read: fn(&mut StudyReader, Table<'_>, Dimension) -> Option<Distribution>,
}

/// Declares a list of families: of each what its key means, its table (in other words, where these differ) and an example. The method of
/// [`StudyReader`] with its name reads it; `$keys` makes the keys of the list from those of the table.
macro_rules! families {
    (
        $(#[$list_doc:meta])+ $list:ident, $count:ident by $keys:ident:
        $(#[doc = $doc:literal] $family:ident: $table:ident $(= $words:literal)?, $example:literal;)+
    ) => {
        pub(crate) const $count: usize = [$(stringify!($family)),+].len();
        $(#[$list_doc])+
        pub(crate) const $list: [Family; $count] = [$(Family {
            key: optional(
                stringify!($family),
                Kind::Table(&Keys {
                    doc: [$($words,)? $table::KEYS.doc][0],
                    keys: &$keys::<{ $table::KEYS.keys.len() }>(&$table::KEYS),
                    ..$table::KEYS
                }),
                $example,
                $doc.trim_ascii_start(),
            ),
            read: StudyReader::$family,
        }),+];
    };
}

families! {
    /// The families that a random input may have, in the order of the documentation.
    FAMILIES, FAMILY_COUNT by uncertain:
    /// normal
    normal: NormalTable, "{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }";
    /// truncated normal
    truncated_normal: TruncatedNormalTable,
        "{ mean = \"50 mm\", standard_deviation = \"0.02 mm\", lower = \"49.9 mm\", upper = \"50.1 mm\" }";
    /// uniform
    uniform: UniformTable, "{ lower = \"49.9 mm\", upper = \"50.1 mm\" }";
    /// lognormal
    lognormal: LognormalTable, "{ mean = \"0.3 mm\", standard_deviation = \"0.05 mm\" }";
    /// triangular
    triangular: TriangularTable, "{ lower = \"49.9 mm\", mode = \"50 mm\", upper = \"50.1 mm\" }";
    /// beta
    beta: BetaTable, "{ alpha = 2, beta = 3, lower = \"49.9 mm\", upper = \"50.1 mm\" }";
    /// Weibull
    weibull: WeibullTable, "{ shape = 2, scale = \"0.3 mm\" }";
    /// gamma
    gamma: GammaTable, "{ shape = 4, scale = \"0.1 mm\" }";
    /// Gumbel, of largest values
    gumbel: GumbelTable, "{ mode = \"0.3 mm\", scale = \"0.02 mm\" }";
    /// exponential
    exponential: ExponentialTable, "{ mean = \"0.1 mm\" }";
    /// a few values with their probabilities
    discrete: DiscreteTable, "{ values = [\"0.2 mm\", \"0.3 mm\"], probabilities = [0.4, 0.6] }";
}

families! {
    /// The families that a parameter of a distribution may have.
    FAMILIES_OF_PARAMETER, COUNT_OF_PARAMETER by known:
    /// the parameter is one value, normal as far as it is known
    normal: NormalTable = "a normal distribution of a parameter",
        "{ mean = \"120 mm\", standard_deviation = \"0.01 mm\" }";
    /// the same, lognormal
    lognormal: LognormalTable =
        "a lognormal distribution of a parameter, by mean and standard deviation of the parameter itself",
        "{ mean = \"0.02 mm\", standard_deviation = \"0.004 mm\" }";
    /// the same, normal and cut
    truncated_normal: TruncatedNormalTable =
        "a normal distribution of a parameter, cut to an interval; mean and standard deviation are those before the cut",
        "{ mean = \"120 mm\", standard_deviation = \"0.01 mm\", lower = \"119.98 mm\", upper = \"120.02 mm\" }";
    /// the same, uniform
    uniform: UniformTable = "a uniform distribution of a parameter",
        "{ lower = \"119.98 mm\", upper = \"120.02 mm\" }";
    /// the same, triangular
    triangular: TriangularTable = "a triangular distribution of a parameter",
        "{ lower = \"119.98 mm\", mode = \"120 mm\", upper = \"120.02 mm\" }";
}

/// The keys of families.
pub(crate) const fn family_keys<const COUNT: usize>(families: &[Family; COUNT]) -> [Key; COUNT] {
    let mut keys = [families[0].key; COUNT];
    let mut place = 1;
    while place < COUNT {
        keys[place] = families[place].key;
        place += 1;
    }
    keys
}

/// The names of keys.
pub(crate) const fn names<const COUNT: usize>(keys: &[Key; COUNT]) -> [&'static str; COUNT] {
    let mut names = [""; COUNT];
    let mut place = 0;
    while place < COUNT {
        names[place] = keys[place].name;
        place += 1;
    }
    names
}

record! {
    /// an uncertain parameter of a distribution: with an interval or a list, the distribution is a probability box; with a distribution of
    /// the parameter, every statistic is itself random
    pub(crate) lenient struct ParameterTable for Reads;
    /// lower and upper end; every value between them is possible, with no known probabilities
    optional interval: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"119.98 mm\", \"120.02 mm\"]";
    /// list of all possible values, with their unit
    optional any_of: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"119.98 mm\", \"120.02 mm\"]";
}

const KEYS_OF_PARAMETER: [Key; ParameterTable::KEYS.keys.len() + COUNT_OF_PARAMETER] =
    joined(&[ParameterTable::KEYS.keys, &family_keys(&FAMILIES_OF_PARAMETER)]);
/// Keys of what is known of a parameter: those of [`ParameterTable`], and its families.
pub(crate) const PARAMETER_KEYS: Keys =
    Keys { keys: &KEYS_OF_PARAMETER, exactly_one: &[&names(&KEYS_OF_PARAMETER)], ..ParameterTable::KEYS };

/// A shape of a distribution.
const SHAPE: Kind = Kind::Number { rule: Rule::Finite };

const MEAN: Key = optional("mean", Kind::AnyQuantity, "\"50 mm\"", "mean; the value in the model if omitted");
const STANDARD_DEVIATION: Key = required("standard_deviation", Kind::AnyQuantity, "\"0.02 mm\"", "standard deviation");
const LOWER: Key = required("lower", Kind::AnyQuantity, "\"49.9 mm\"", "lower end");
const UPPER: Key = required("upper", Kind::AnyQuantity, "\"50.1 mm\"", "upper end");
/// The lower end of a distribution that goes on without end above it.
const FROM: Key = optional("lower", Kind::AnyQuantity, "\"0 mm\"", "lower end; 0 if omitted");
const SHAPE_KEY: Key = required("shape", SHAPE, "2", "shape, from 0.05 to 1e6");

record! {
    /// a normal distribution
    pub(crate) lenient struct NormalTable for Reads;
    optional mean: Entry<'t> as MEAN;
    required standard_deviation: Entry<'t> as STANDARD_DEVIATION;
}

record! {
    /// a lognormal distribution, by mean and standard deviation of the variable itself
    pub(crate) lenient struct LognormalTable for Reads;
    optional mean: Entry<'t> as MEAN;
    required standard_deviation: Entry<'t> as STANDARD_DEVIATION;
}

record! {
    /// a normal distribution truncated to an interval; mean and standard deviation are those before truncation
    pub(crate) lenient struct TruncatedNormalTable for Reads;
    optional mean: Entry<'t> as MEAN;
    required standard_deviation: Entry<'t> as STANDARD_DEVIATION;
    required lower: Entry<'t> as LOWER;
    required upper: Entry<'t> as UPPER;
}

record! {
    /// a uniform distribution
    pub(crate) lenient struct UniformTable for Reads;
    required lower: Entry<'t> as LOWER;
    required upper: Entry<'t> as UPPER;
}

record! {
    /// a triangular distribution
    pub(crate) lenient struct TriangularTable for Reads;
    required lower: Entry<'t> as LOWER;
    /// most likely value
    required mode: Entry<'t> = Kind::AnyQuantity, "\"50 mm\"";
    required upper: Entry<'t> as UPPER;
}

record! {
    /// a beta distribution between two ends
    pub(crate) lenient struct BetaTable for Reads;
    /// first shape parameter, from 0.001 to 1e6
    required alpha: Entry<'t> = SHAPE, "2";
    /// second shape parameter, from 0.001 to 1e6
    required beta: Entry<'t> = SHAPE, "3";
    required lower: Entry<'t> as LOWER;
    required upper: Entry<'t> as UPPER;
}

record! {
    /// a Weibull distribution: the probability of a value above x is exp(-((x - lower)/scale)^shape)
    pub(crate) lenient struct WeibullTable for Reads;
    required shape: Entry<'t> as SHAPE_KEY;
    /// scale: 63.2 % of the values are below lower + scale
    required scale: Entry<'t> = Kind::AnyQuantity, "\"0.3 mm\"";
    optional lower: Entry<'t> as FROM;
}

record! {
    /// a gamma distribution
    pub(crate) lenient struct GammaTable for Reads;
    required shape: Entry<'t> as SHAPE_KEY;
    /// scale: the mean is lower + shape * scale
    required scale: Entry<'t> = Kind::AnyQuantity, "\"0.1 mm\"";
    optional lower: Entry<'t> as FROM;
}

record! {
    /// a Gumbel distribution of largest values: the probability of a value below x is exp(-exp(-(x - mode)/scale))
    pub(crate) lenient struct GumbelTable for Reads;
    /// most likely value
    required mode: Entry<'t> = Kind::AnyQuantity, "\"0.3 mm\"";
    /// scale; the standard deviation is 1.2825 times the scale
    required scale: Entry<'t> = Kind::AnyQuantity, "\"0.02 mm\"";
}

record! {
    /// an exponential distribution
    pub(crate) lenient struct ExponentialTable for Reads;
    /// mean of the variable itself, above the lower end
    required mean: Entry<'t> = Kind::AnyQuantity, "\"0.1 mm\"";
    optional lower: Entry<'t> as FROM;
}

record! {
    /// a few values with their probabilities
    pub(crate) lenient struct DiscreteTable for Reads;
    /// the values, each once
    required values: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.2 mm\", \"0.3 mm\"]";
    /// one probability for each value; they sum to 1
    required probabilities: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[0.4, 0.6]";
}

/// A number of a distribution with its unit: as it is, or what is known of it.
const UNCERTAIN_QUANTITY: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::Table(&PARAMETER_KEYS)]);
/// The same, a pure number.
const UNCERTAIN_SHAPE: Kind = Kind::AnyOf(&[SHAPE, Kind::Table(&PARAMETER_KEYS)]);

/// Keys of a family each of whose numbers may be uncertain.
const fn uncertain<const COUNT: usize>(keys: &Keys) -> [Key; COUNT] {
    let mut uncertain = [MEAN; COUNT];
    let mut place = 0;
    while place < COUNT {
        let key = keys.keys[place];
        let kind = match key.kind {
            Kind::AnyQuantity => UNCERTAIN_QUANTITY,
            Kind::Number { .. } => UNCERTAIN_SHAPE,
            other => other,
        };
        uncertain[place] = Key { kind, ..key };
        place += 1;
    }
    uncertain
}

/// Keys of a family whose numbers are known. No parameter has a nominal value in the model that its mean could be.
const fn known<const COUNT: usize>(keys: &Keys) -> [Key; COUNT] {
    let mut known = [required(MEAN.name, MEAN.kind, MEAN.example, "mean"); COUNT];
    let mut place = 0;
    while place < COUNT {
        if keys.keys[place].is_required {
            known[place] = keys.keys[place];
        }
        place += 1;
    }
    known
}

/// Whether a distribution of the family `name` has the value in the model for its mean where that is left out.
pub fn takes_mean_of_model(name: &str) -> bool {
    let keys = FAMILIES.iter().find(|family| family.key.name == name).map(|family| family.key.kind);
    let mean = if let Some(Kind::Table(keys)) = keys { keys.find("mean") } else { None };
    mean.is_some_and(|mean| !mean.is_required)
}

impl StudyReader {
    /// The distribution that a table states by one of `families`.
    pub(crate) fn distribution(
        &mut self,
        families: &[Family],
        table: &Table<'_>,
        dimension: Dimension,
    ) -> Option<Distribution> {
        let (family, entry) = families.iter().find_map(|family| Some((family, table.get(family.key.name)?)))?;
        let Kind::Table(keys) = family.key.kind else { return None };
        let table = self.reader.table(&entry, keys)?;
        (family.read)(self, table, dimension)
    }
}
