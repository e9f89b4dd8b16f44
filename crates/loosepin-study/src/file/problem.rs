//! Problems of a study beyond its single entries.

use super::sizes::MAX_POSES;
use loosepin_mechanics::model::{LawError, PathError, QuantityError};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::{describe_path, listed};
use loosepin_text::units::{Dimension, format_number, format_value};
use loosepin_uncertainty::DistributionError;

/// What is meant by two ends, or by an end behind `±`, as it is to be written.
#[derive(Debug, Clone, PartialEq)]
pub enum MeantLimit {
    /// The limit of a magnitude.
    Magnitude(String),
    /// A lower and an upper limit.
    Two([String; 2]),
}

problems! {
    /// Problems of a study file. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum StudyProblem | Path(PathError) {
        /// A path written without quotes, which TOML takes apart.
        UnquotedPath { path: String } => Code::UnknownPath,
            says("'{path}' is not in quotes; TOML reads it as nested tables"),
            hint("write \"{path}\" = {{ ... }}");
        /// A statistic that is written in another form.
        StatisticForm { entry: String, word: String, form: String } => Code::AskNotPossible,
            says("{entry}: '{word}' is written {form}");
        /// An angle where the whole curve is named.
        AngleForCurve { entry: String, found: String, drive: String } => Code::AskNotPossible,
            says("{entry} is {found}; must be \"cycle\", the whole curve"),
            hint("for angles of the drive '{drive}', write poses = {{ {drive} = [\"90 deg\"] }} instead");
        /// A probability as text.
        Percent { entry: String, found: String } => Code::BadProbability,
            says("{entry} is \"{found}\"; expected a number between 0 and 1"),
            hint("probabilities are written as numbers, 97.5 % is 0.975");
        /// The part of the deviation that comes from play, where there is none.
        NoPlay { entry: String } => Code::AskNotPossible,
            says("{entry} is \"clearance\"; no joint of the model has play, so that this part of the deviation is \
                  zero"),
            hint("write of = \"dimensional\", or give a joint play in the model file");
        /// A share of all parts, where quantities scatter.
        CertaintyOfSamples { entry: String } => Code::AskNotPossible,
            says("{entry} is 1; no number of samples shows that none lies beyond the limit, so that this stays \
                  undecided"),
            hint("require a probability below 1, such as 0.9973, or give the random inputs as intervals under [epistemic]");
        /// A share that the runs at each value cannot show.
        RequirementRuns { entry: String, share: f64, inner: usize, least: usize, is_written: bool } => Code::RequirementRuns,
            says("{entry} is {share}; {inner} runs at each value can refute it, and show it only where the output is smooth in the random \
                  inputs: by counting it takes {least}"),
            hint_of(Some(match is_written {
                true => format!("write inner = {} under [sampling], or leave inner out", least.next_power_of_two()),
                false => format!("write inner = {} under [sampling], or require a smaller share", least.next_power_of_two()),
            }));
        /// A quantity both random and epistemic.
        InputTwice { path: String } => Code::InputTwice,
            says("'{path}' is both under [random] and under [epistemic]"),
            hint("keep one of the two");
        /// A parameter of a distribution that is itself uncertain.
        UncertainParameter { entry: String } => Code::NotYetSupported,
            says("{entry} is itself uncertain; this version does not support this yet"),
            hint("write one number with its unit");
        /// An uncertain parameter of the distribution of a parameter.
        ParameterOfAParameter { entry: String } => Code::BadDistribution,
            says("{entry} is itself uncertain; the distribution of a parameter has numbers for parameters"),
            hint("write one number with its unit");
        /// A distribution of a parameter beside what leaves statistics without a single value at it.
        SecondOrderBeside { path: String, beside: &'static str } => Code::BadDistribution,
            says("'{path}' has a distribution, which cannot be used with {beside}"),
            hint("give the parameter as an interval");
        /// More uncertain parameters of one distribution than are checked together.
        TooManyParameters { entry: String, found: usize, most: usize } => Code::BadDistribution,
            says("{entry} has {found} uncertain parameters; at most {most} are accepted"),
            hint("write one number for the least important ones");
        /// A number of a distribution that breaks its rule.
        DistributionRule { entry: String, found: String, rule: String } => Code::BadDistribution,
            says("{entry} {found}; must be {rule}");
        /// A distribution whose numbers are right one by one and still describe none.
        Distribution { entry: String, error: DistributionError, dimension: Dimension } => Code::BadDistribution,
            says("{entry}: {}", without_hint(error, *dimension)),
            hint_of(matches!(error, DistributionError::NothingKept { .. } | DistributionError::NothingLeft { .. })
                .then(|| "truncate nearer to the mean, or use a uniform distribution".to_owned()));
        /// An interval whose lower end lies above its upper end.
        IntervalTurnedRound { entry: String, lower: String, upper: String } => Code::IntervalTurnedRound,
            says("{entry} goes from {lower} to {upper}; the lower end must be first"),
            hint("write [\"{upper}\", \"{lower}\"]");
        /// An interval with equal ends.
        IntervalWithoutWidth { entry: String, value: String } => Code::IntervalWithoutWidth,
            says("{entry} has both ends at {value}, so nothing is uncertain"),
            hint("write the value in the model file, or widen the interval");
        /// A period of an angle after which it does not begin again.
        Period { entry: String, found: String } => Code::BadPeriod,
            says("{entry} is {found} wide; must be a whole turn (360°) or a whole fraction of it"),
            hint("for an angle between two limits, write interval = [...]");
        /// Intervals that do not fit together.
        Structure { entry: String, words: String } => Code::BadEvidence,
            says("{entry}: {words}");
        /// Corners of a fuzzy number that are too few or too many.
        Corners { entry: String, found: usize, due: usize } => Code::BadEvidence,
            says("{entry} has {found} corners; must be {due}");
        /// Degrees beside cuts that have their own.
        DegreesTwice { entry: String } => Code::BadEvidence,
            says("{entry} cannot be used with cuts, which have their own degrees"),
            hint("remove it");
        /// Quantiles or a mean without ends.
        NoSupport { entry: String } => Code::BadEvidence,
            says("{entry} needs a support: the smallest and the largest possible value"),
            hint("also write support = [smallest, largest]");
        /// A support without quantiles or a mean.
        SupportAlone { entry: String } => Code::BadEvidence,
            says("{entry} needs quantiles or a mean"),
            hint("if only two ends are known, write interval = [...]");
        /// A list with nothing to choose.
        SingleMember { entry: String } => Code::BadList,
            says("{entry} has 1 entry; give at least 2"),
            hint("write the value in the model file, or add other values");
        /// The same member again.
        MemberTwice { entry: String, value: String } => Code::BadList,
            says("{entry} contains {value} twice"),
            hint("keep one of the two");
        /// A law that the contact cannot have.
        Law { entry: String, error: LawError } => error.code(),
            says("{entry}: {error}"),
            hint_of(error.hint());
        /// A law among the random inputs.
        RandomLaw { path: String } => Code::BadList,
            says("'{path}' is a law; a law cannot have a distribution"),
            hint("write \"{path}\" = {{ any_of = [\"lankarani-nikravesh\", \"flores\"] }} under [epistemic]");
        /// A law between two ends.
        IntervalOfLaws { path: String } => Code::BadList,
            says("'{path}' is a law; it cannot have an interval"),
            hint("write \"{path}\" = {{ any_of = [\"lankarani-nikravesh\", \"flores\"] }} under [epistemic]");
        /// An interval at whose end a joint loses its clearance.
        ClearanceTouchesZero { path: String, end: String, clearance: String, is_member: bool } =>
            Code::ClearanceTouchesZero,
            says("'{path}' reaches {end}, where {} becomes 0: a joint without play is another mechanism, and one study \
                  cannot mix both", describe_path(clearance)),
            hint("{}, and run the ideal joint as a separate study",
                if *is_member { format!("remove {end}") } else { "start the interval above zero".to_owned() });
        /// A value within the inputs that is impossible.
        ImpossibleEnd { path: String, end: String, error: QuantityError } => error.code(),
            says("'{path}' reaches {end}, which is impossible: {error}"),
            hint_of(error.hint());
        /// Intervals and lists that are possible one by one and impossible together.
        ImpossibleTogether { error: QuantityError } => error.code(),
            says("a combination of values in the intervals is impossible: {error}"),
            hint_of(error.hint());
        /// A distribution too much of which is impossible.
        ImpossibleShare { path: String, share_percent: String, most_percent: f64, error: QuantityError } =>
            Code::ImpossibleShare,
            says("'{path}' is impossible with a probability of {share_percent} %; at most {most_percent} % are \
                  accepted: {error}"),
            hint("choose a distribution that stays in the range: truncated_normal, lognormal or beta");
        /// A distribution a little of which is impossible.
        ImpossibleTail { path: String, probability: f64, error: QuantityError } => Code::ImpossibleShare,
            says("'{path}' is impossible with a probability of {:.1e}, and such runs fail: {error}", probability),
            hint("choose a distribution that stays in the range: truncated_normal, lognormal or beta");
        /// A quantile that the samples do not reach.
        QuantileBeyondSamples { percent: f64, inner: usize, none_percent: f64, needed: u64 } => Code::AskNotPossible,
            says(
                "the {} % quantile needs more samples: with a probability of {:.0} %, none of inner = {inner} samples lies beyond it, and its \
                 bound will have no end",
                format_number(*percent),
                none_percent
            ),
            hint("inner = {needed} bounds it from both sides; a probability_above of a limit that matters needs fewer");
        /// An output that the model does not have.
        UnknownOutput { entry: String, name: String, nearest: Option<String>, known: Vec<String> } =>
            Code::UnknownReference,
            says("{entry}: the model has no output '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None if known.is_empty() => "the model has no outputs".to_owned(),
                None => format!("available: {}", listed(known, "and")),
            }));
        /// A question about a path of a point.
        PathOutput { entry: String, name: String, has_height: bool } => Code::AskNotPossible,
            says("{entry}: output '{name}' is a path, but 'component' is missing"),
            hint("add component: {}", if *has_height {
                "along is the error along the path, across the distance from the line along the path, magnitude the distance from the ideal \
                 place, x, y or z a coordinate"
            } else {
                "normal or along is the error across or along the path, magnitude the whole error, contour the distance from the path \
                 regardless of time, x or y a coordinate"
            });
        /// A component of an output that is one number.
        ComponentOfNoPath { entry: String, name: String } => Code::AskNotPossible,
            says("{entry}: output '{name}' is one number and has no components"),
            hint("remove component, or add an output path_of of the point to the model");
        /// An error that is compared with nothing.
        ValueOfPathError { entry: String, component: &'static str, of: &'static str } => Code::AskNotPossible,
            says("{entry}: component '{component}' is an error from the ideal {of}, not a value"),
            hint("write of = \"total\" to compare with the nominal mechanism, or of = \"clearance\" to compare with the same lengths without play");
        /// A statistic that is not largest where all mechanisms have their journals on one side.
        NotOfOneSide { entry: String } => Code::AskNotPossible,
            says("{entry} has no bound here: the journals of each mechanism may be on another side of their play"),
            hint("ask for a mean, quantiles or probabilities of one side, for the largest magnitude over the cycle, or of = \"dimensional\"; or \
                  assume that all places are alike: journals = \"uniform-in-play\" at the top of the study");
        /// Places of journals where contact forces decide them.
        JournalsInPlane => Code::AskNotPossible,
            says("'journals' is for models in space: in the plane, contact forces decide where a journal is in its play"),
            hint("remove it");
        /// Places of journals that have none.
        JournalsWithoutPlay => Code::AskNotPossible,
            says("'journals' says where journals are in their play, and no joint of the model has play"),
            hint("remove it, or give a joint play in the model file");
        /// A start-up of positions that do not depend on what was before.
        NoStartUp { entry: String } => Code::AskNotPossible,
            says("{entry}: positions in space do not depend on what was before, so that there is no start-up"),
            hint("remove it");
        /// Poses of a drive that the cycle does not count.
        WrongDrive { entry: String, name: String, due: String } => Code::AskNotPossible,
            says("{entry}: '{name}' is not the drive that the cycle counts; must be '{due}'");
        TooManyPoses { entry: String, found: usize } => Code::TooMany,
            says("{entry} has {found} poses; must be at most {MAX_POSES}"),
            hint("write at = \"cycle\" for the whole curve");
        /// Two poses whose numbers would have the same name.
        PosesTooNear { entry: String, pose: String, apart: String } => Code::AskNotPossible,
            says("{entry}: {pose} is {apart} away from another angle of the same output; must be equal, or \
                  more than 1e-9 rad away"),
            hint("write the angle in the same way in all questions");
        /// A method for what is no probability.
        MethodOfQuantile { entry: String, of: &'static str } => Code::AskNotPossible,
            says("{entry}: {of} has no method"),
            hint("methods are for probability_above, _below and _beyond");
        /// A band for whole curves of what is no curve.
        BandOfPoint { entry: String } => Code::AskNotPossible,
            says("{entry}: a simultaneous band needs a whole curve"),
            hint("write at = \"cycle\", or use two quantiles of a single number");
        /// A small probability where nothing scatters.
        NothingRandom { entry: String } => Code::AskNotPossible,
            says("{entry}: there is no random input, so there are no small probabilities"),
            hint("omit 'method'");
        /// A value of the model outside of the range of the study.
        FarFromModel { path: String, value: String, from: String, to: String } => Code::FarFromModel,
            says("'{path}' is {value} in the model, but from {from} to {to} here"),
            hint("a dimension has one nominal value, from which deviations are measured: correct the wrong one, or omit the mean to use the value \
                  of the model");
        /// A tolerance whose nominal value is another than that of the model.
        OtherNominal { entry: String, written: String, nominal: String } => Code::FarFromModel,
            says("{entry}: the nominal value is {written}; that of the model is {nominal}"),
            hint("correct the wrong one, or write only the deviations, for example \"± 0.05 mm\", about the value in the model");
        /// A study where its model is to be named.
        ModelIsStudy { file: String, is_itself: bool } => Code::WrongKindOfFile,
            says("model is '{file}', {}; must be a file with bodies and joints",
                if *is_itself { "this study itself" } else { "another study" }),
            hint("for example model = \"model.toml\"");
        /// A length that varies as no part does.
        WildScatter { path: String, found: String, nominal: String } => Code::ImplausibleNumber,
            says("'{path}' has a standard deviation of {found}, but is {nominal} in the model; usual values are below a hundredth of it"),
            hint("correct it, or ignore this warning if the value is intended");
        /// A sample of a length that holds one of the other sign.
        OtherSign { path: String, found: String, nominal: String } => Code::ImplausibleNumber,
            says("the sample of '{path}' contains {found}, but the value in the model is {nominal}"),
            hint("correct the sign or remove the value, or ignore this warning if the value is intended");
        /// A value that is set, of an input that has none.
        SetsUnknown { path: String } => Code::SetTwice,
            says("'{path}' is set, but is an unknown (epistemic) input of the study, which has no single value"),
            hint("change it under [epistemic], or remove it there");
        /// Two limits, or one with its sign, where that of a magnitude is due.
        WithinIsOneLimit { entry: String, found: String, meant: MeantLimit } => Code::WrongType,
            says("{entry} is {found}; expected one limit, that of the magnitude"),
            hint_of(Some(match meant {
                MeantLimit::Magnitude(limit) => format!("write within = \"{limit}\""),
                MeantLimit::Two([lower, upper]) => {
                    format!("write two [[require]], one with above = \"{lower}\" and one with below = \"{upper}\"")
                }
            }));
        /// Wear as a deviation from the ideal motion.
        WearOfDeviation { entry: String } => Code::AskNotPossible,
            says("{entry}: wear is not a deviation from an ideal motion; must be \"value\""),
            hint("write of = \"value\"");
        /// Wear at a pose or as another number of the cycle.
        PlaceOfWear { entry: String } => Code::AskNotPossible,
            says("{entry}: wear is one number for each run; must be reduce = \"maximum\""),
            hint("wear increases during the recorded part: its maximum is the wear after all cycles");
        /// A requirement of wear that is no upper limit.
        LimitOfWear { entry: String, is_life: bool } => Code::AskNotPossible,
            says("{entry}: {}", if *is_life {
                "a life has a lower limit over the cycle only"
            } else {
                "wear has an upper limit over the cycle only"
            }),
            hint("write over = \"cycle\" and {}", if *is_life { "above = 2000" } else { "below = \"0.2 mm^3\"" });
        /// A life longer than the cycles that are computed.
        LifeBeyondCycles { entry: String, least: String, cycles: String } => Code::AskNotPossible,
            says("{entry}: above is {least}, but lives are computed only up to the cycles of [wear], {cycles}"),
            hint("a longer life counts as all cycles: require fewer, or increase cycles in the model");
        /// A mean or a standard deviation of lives that may not have ended.
        MomentOfLife { entry: String } => Code::AskNotPossible,
            says("{entry}: a life longer than all cycles of [wear] counts as all cycles, so this may be too small"),
            hint("use quantiles below all cycles, or increase cycles in the model until all lives end");
        /// The same question again.
        AskedTwice { entry: String, what: String } => Code::AskNotPossible,
            says("{entry}: there is already a question for {what} of the same output at the same place"),
            hint("remove one of the two");
        /// An angle that stands in a list twice.
        PoseTwice { entry: String, pose: String } => Code::AskNotPossible,
            says("{entry}: {pose} is already in this list"),
            hint("remove one of the two");
        /// Percentiles over nothing.
        PercentilesOfNothing { entry: String } => Code::AskNotPossible,
            says("{entry}: no parameter of a distribution has a distribution, so there are no percentiles"),
            hint("remove it, or give a parameter of a random input a distribution");
        /// Direct runs that confirm no surrogate.
        NothingToConfirm { entry: String } => Code::AskNotPossible,
            says("{entry} is \"confirming\", but the study has no surrogate to confirm"),
            hint("remove it, or write kind = \"auto\"");
        /// A question that the surrogate alone does not answer.
        NeedsDirectRuns { entry: String, of: &'static str } => Code::AskNotPossible,
            says("{entry}: {of} need direct runs"),
            hint("write direct = \"double-loop\", or remove them");
        /// What cannot be promised.
        PromiseOf { entry: String, of: &'static str, is_unbounded: bool } => Code::AskNotPossible,
            says("{entry}: {of} cannot be promised{}",
                if *is_unbounded { "; no number of runs bounds it without a known range" } else { "" }),
            hint("use promise for quantiles and probabilities, and a separate [[ask]] for {of}");
        /// Fewer runs at each value than a limit there needs.
        PromiseRuns { entry: String, of: String, inner: usize, least: usize } => Code::AskNotPossible,
            says("{entry}: a promise of {of} needs at least {least} runs at each value; inner under [promise] is {inner}"),
            hint("write inner = {} under [promise]", least.next_power_of_two());
        /// A promise beside what is not one fixed value in an interval.
        PromiseBeside { entry: String, what: &'static str } => Code::AskNotPossible,
            says("{entry} cannot be used with {what}: a promise needs values that are fixed but unknown, and unchanged \
                  inputs"),
            hint("remove one of the two, or write two studies");
        /// A promise where no interval is.
        PromiseWithoutBox { entry: String } => Code::AskNotPossible,
            says("{entry}: no input under [epistemic] has an interval, so there is no box for a promise"),
            hint("remove it: without intervals, the bounds need no search");
        /// A promise of nothing.
        NothingPromised { entry: String } => Code::AskNotPossible,
            says("{entry}: no question and no requirement uses a promise"),
            hint("write promise = \"upper\" in an [[ask]], or decided_by = \"promise\" in a [[require]]");
        /// A small probability of which only sums over focal elements, or belief and plausibility, are wanted.
        RareOfSets { entry: String, of: &'static str } => Code::AskNotPossible,
            says("{entry}: a method searches the largest probability over fixed values; it cannot be used with {of}"),
            hint("omit 'method'");
        /// Something to loosen that is no interval and has no standard deviation.
        AllowedInput { path: String } => Code::AskNotPossible,
            says("'{path}' under [allow] is neither a plain interval of [epistemic] nor a normal, lognormal or \
                  truncated_normal of [random] with a known standard deviation"),
            hint("name the input under [epistemic] or [random] first");
        /// A value that is no looser than the least.
        AllowedRange { entry: String, found: String, least: String } => Code::AskNotPossible,
            says("{entry} {found}; must be above {least}");
        /// What may be fitted otherwise and is no fit.
        FittedInput { path: String } => Code::AskNotPossible,
            says("'{path}' under [allow] is neither a plain interval of [epistemic] nor a known normal distribution of \
                  [random]"),
            hint("name the input under [epistemic] or [random] first");
        /// A key that does not go with fits, or only with them.
        BesideFits { entry: String, has_fits: bool } => Code::AskNotPossible,
            says("{entry} {}", if *has_fits { "cannot be used with fits: they have no cost" } else { "needs fits" }),
            hint("leave it out");
        /// An offer beyond the range of the question.
        OfferBeyond { entry: String, offer: String, up_to: String } => Code::AskNotPossible,
            says("{entry} has an offer of {offer}, but the largest value to try is {up_to}"),
            hint("write up_to = \"{offer}\", or remove the offer");
        /// Prices in which what is looser costs no less.
        Costs { entry: String } => Code::AskNotPossible,
            says("{entry}: give each value once, with its cost; a looser value must cost less"),
            hint("remove offers that are not cheaper");
        /// Inputs that cannot be loosened together.
        Together { word: String, found: String } => Code::AskNotPossible,
            says(
                "allow_together = \"{word}\" needs {} under [allow] with only 'up_to'; found {found}",
                if word == "frontier" { "two inputs" } else { "two or more inputs" }
            ),
            hint("omit allow_together: each input is then loosened separately, and 'cost' finds the cheapest combination");
        /// Something to loosen as far as nothing allows.
        NothingRequired => Code::AskNotPossible,
            says("[allow] needs a requirement: without one, any value would be permitted"),
            hint("add [[require]]");
        /// An empty list.
        Empty { entry: String } => Code::AskNotPossible,
            says("{entry} is empty; give at least one");
        /// A limit of a magnitude that is negative or zero.
        Limit { entry: String, found: String, rule: &'static str } => Code::AskNotPossible,
            says("{entry} {found}; must be {rule}");
        /// No random and no epistemic input.
        NothingUncertain { has_dynamics: bool } => Code::NothingUncertain,
            says("the study has no uncertain input"),
            hint("add uncertain quantities under [random] or [epistemic]; {}", if *has_dynamics {
                "for one run use `loosepin simulate`"
            } else {
                "`loosepin motion` shows what play does to the nominal mechanism"
            });
        /// No question and no requirement.
        NothingAsked => Code::NothingAsked,
            says("the study asks no question"),
            hint("add [[ask]] or [[require]]");
    }
}

/// The text of a distribution error, with units where it says more than the rules checked before.
fn without_hint(error: &DistributionError, dimension: Dimension) -> String {
    let text = |value_si: f64| format_value(value_si, dimension);
    match *error {
        DistributionError::NothingKept { mean, standard_deviation, lower, upper, .. } => format!(
            "a normal distribution with mean {} and standard deviation {} has almost no probability between {} and {}",
            text(mean),
            text(standard_deviation),
            text(lower),
            text(upper)
        ),
        DistributionError::NothingLeft { family, lower, upper, .. } => {
            let ends = match (lower.is_finite(), upper.is_finite()) {
                (true, true) => format!("between {} and {}", text(lower), text(upper)),
                (true, false) => format!("above {}", text(lower)),
                _ => format!("below {}", text(upper)),
            };
            format!("the {family} distribution has almost no probability {ends}")
        }
        _ => error.to_string(),
    }
}
