//! Identity of a number on a page or a terminal, so that no two texts give one number two values.
//!
//! A number is written by a [`NumberWriter`](crate::numbers::number::NumberWriter), and what it is stands with the writer: a [`Tag`]. In an ordinary
//! run nothing is kept of it. In [`tagged`] each number is put between two characters of no script, of which the first says which entry of the
//! list it is; digits that stand outside were written past the writer.

use loosepin_result::motion::MotionRequirement;
use loosepin_result::simulation::Extreme;
use loosepin_result::study::{
    BoundRecord, Contributors, Deviation, DeviationCurve, FurtherOutput, ProbabilityBox, RequirementOutcome,
    ResponsePoint, Statistic, TreatmentBand, TreatmentComparison,
};
use std::cell::RefCell;

use crate::numbers::rounding::Rounding;

/// The first of the characters that begin a number: private use, plane 15.
const FIRST: u32 = 0xF_0000;
/// Numbers in one text, at most.
const MAX_NUMBERS: u32 = 0xFFF0;
/// Ends a number: private use, of the basic plane.
const END: char = '\u{E000}';

/// Identity of a number. Two numbers of equal tags are one number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tag {
    /// A number of a result.
    Result(Box<ResultTag>),
    /// A number that was given, not found: a setting, a limit, a probability that was asked for, a range of an input.
    Given(&'static str),
    /// The number of something, by what is counted.
    Count(&'static str),
    /// No tag yet: what the bounds that follow are among, such as those of a degree of possibility.
    Group(String),
}

/// A number of a result.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ResultTag {
    /// The output, which deviation of it, and where in the cycle; of a joint its name.
    pub output: String,
    /// The statistic with its parameter.
    pub statistic: String,
    /// Which number of it: an end, an error, a share.
    pub part: String,
    /// How the inputs were treated, and how intervals were read.
    pub treatment: String,
    /// For which inputs, where it is not for all.
    pub inputs: String,
}

impl Tag {
    /// A number that belongs to the result as a whole.
    pub fn whole(statistic: &str, part: &str) -> Self {
        Self::joint("", statistic, part)
    }

    /// A number of a joint.
    pub fn joint(joint: &str, statistic: &str, part: &str) -> Self {
        let [output, statistic, part] = [joint, statistic, part].map(str::to_owned);
        Self::Result(Box::new(ResultTag { output, statistic, part, ..ResultTag::default() }))
    }

    /// A number of an extreme of a run: `minimum`, `maximum`, and where they are.
    pub fn extreme(extreme: &Extreme, part: &str) -> Self {
        let output = response(&extreme.name, extreme.of, ResponsePoint::Whole);
        Self::joint(&output, "extreme", part)
    }

    /// A number of a bound: `lower`, `upper`, `lower error`, `upper error` and so on.
    pub fn bound(bound: &BoundRecord, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&bound.output, bound.of, bound.at),
            statistic: statistic(bound.statistic),
            part: part.to_owned(),
            treatment: format!("{} {}", bound.treatment.word(), bound.reading.word()),
            inputs: String::new(),
        }))
    }

    /// A number of the band of a treatment.
    pub fn band(comparison: &TreatmentComparison, band: &TreatmentBand, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&comparison.output, comparison.of, comparison.at),
            statistic: format!("band {}", comparison.promised_coverage),
            part: part.to_owned(),
            treatment: format!("{}{}", band.treatment.word(), if band.is_by_surrogate { " surrogate" } else { "" }),
            inputs: String::new(),
        }))
    }

    /// A number of what treatments are compared for.
    pub fn comparison(comparison: &TreatmentComparison, part: &str) -> Self {
        Self::joint(&response(&comparison.output, comparison.of, comparison.at), "without dynamics", part)
    }

    /// A number of the bands over the cycle.
    pub fn curve(curve: &DeviationCurve, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&curve.output, curve.of, ResponsePoint::Whole),
            statistic: format!("curve {} {}", curve.probabilities[0], curve.probabilities[1]),
            part: part.to_owned(),
            ..ResultTag::default()
        }))
    }

    /// A number of turns after the recorded ones.
    pub fn further_turns(further: &FurtherOutput, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&further.output, further.of, ResponsePoint::Reduced { reduction: further.reduction }),
            statistic: "further turns".to_owned(),
            part: part.to_owned(),
            ..ResultTag::default()
        }))
    }

    /// A number of a requirement.
    pub fn requirement(requirement: &RequirementOutcome, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&requirement.output, requirement.of, requirement.at),
            statistic: format!("share from {} to {}", requirement.lower_si, requirement.upper_si),
            part: part.to_owned(),
            ..ResultTag::default()
        }))
    }

    /// A number of a requirement that is judged without dynamics.
    pub fn motion_requirement(requirement: &MotionRequirement, part: &str) -> Self {
        let at = requirement.pose_rad.map_or(ResponsePoint::Whole, |pose_rad| ResponsePoint::Pose { pose_rad });
        let output = response(&requirement.output, requirement.of, at);
        Self::joint(&output, &format!("without dynamics, {} to {}", requirement.lower_si, requirement.upper_si), part)
    }

    /// A number of the sensitivities.
    pub fn contributors(one: &Contributors, part: &str, inputs: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&one.output, one.of, one.at),
            statistic: "sensitivity".to_owned(),
            part: part.to_owned(),
            treatment: String::new(),
            inputs: inputs.to_owned(),
        }))
    }

    /// The same for the value of an input, as at a witness.
    #[must_use]
    pub fn at(&self, path: &str) -> Self {
        self.changed(|tag| tag.inputs = format!("{} {path}", tag.inputs).trim_start().to_owned())
    }

    /// A part of the same.
    #[must_use]
    pub fn part(&self, part: &str) -> Self {
        self.changed(|tag| tag.part = format!("{} {part}", tag.part).trim_start().to_owned())
    }

    /// A number of a distribution.
    pub fn distribution(pbox: &ProbabilityBox, part: &str) -> Self {
        Self::Result(Box::new(ResultTag {
            output: response(&pbox.output, pbox.of, pbox.at),
            statistic: "distribution".to_owned(),
            part: part.to_owned(),
            ..ResultTag::default()
        }))
    }

    /// The same among other bounds than those of the study.
    #[must_use]
    pub fn within(&self, which: Option<&Tag>) -> Self {
        match which {
            Some(Self::Group(which)) => self.changed(|tag| tag.inputs = format!("{which} {}", tag.inputs)),
            _ => self.clone(),
        }
    }

    fn changed(&self, change: impl FnOnce(&mut ResultTag)) -> Self {
        let mut tag = self.clone();
        if let Self::Result(of) = &mut tag {
            change(of);
        }
        tag
    }
}

/// Group of the bounds of a degree of possibility.
pub fn degree_group(alpha: f64) -> Tag {
    Tag::Group(format!("degree {alpha}"))
}

/// Group of the percentiles of statistics.
pub fn percentile_group(percentile: f64) -> Tag {
    Tag::Group(format!("percentile {percentile}"))
}

fn response(output: &str, of: Deviation, at: ResponsePoint) -> String {
    let place = match at {
        ResponsePoint::Whole => "whole".to_owned(),
        ResponsePoint::Pose { pose_rad } => format!("pose {pose_rad}"),
        ResponsePoint::Curve { pose_rad } => format!("curve {pose_rad}"),
        ResponsePoint::Reduced { reduction } => reduction.word().to_owned(),
    };
    format!("{output} {} {place}", of.word())
}

fn statistic(statistic: Statistic) -> String {
    statistic.parameter().map_or_else(|| statistic.word().to_owned(), |number| format!("{} {number}", statistic.word()))
}

/// A number as it stands in a text.
#[derive(Debug, Clone, PartialEq)]
pub struct TaggedNumber {
    /// Its identity; `None` if that was not stated.
    pub tag: Option<Tag>,
    /// The displayed digits, without unit: `97.9`, `1.2e-9`, `−0.5`, `1.2 · 10⁻⁹`.
    pub digits: String,
    /// The value of the digits, in the displayed unit.
    pub value: f64,
    /// Which way it was rounded: 0 nearest, -1 down, 1 up.
    pub rounding: i8,
}

/// A text and its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct TaggedText {
    /// The text: each number between the character of its place in the list and another.
    pub text: String,
    /// The numbers in the order in which they were made, which need not be that of the text; not all of them need be in it.
    pub numbers: Vec<TaggedNumber>,
}

thread_local! {
    /// The list while a text is made for [`tagged`].
    static NUMBERS: RefCell<Option<Vec<TaggedNumber>>> = const { RefCell::new(None) };
}

/// The text that `write` makes, with a mark at every number.
pub fn tagged(write: impl FnOnce() -> String) -> TaggedText {
    NUMBERS.with_borrow_mut(|numbers| *numbers = Some(Vec::new()));
    let text = write();
    let numbers = NUMBERS.with_borrow_mut(Option::take).unwrap_or_default();
    TaggedText { text, numbers }
}

impl TaggedText {
    /// The number that a character begins, where it does.
    pub fn begun_by(&self, character: char) -> Option<&TaggedNumber> {
        self.numbers.get(u32::from(character).checked_sub(FIRST)? as usize)
    }

    /// Whether a character ends a number.
    pub fn is_end(character: char) -> bool {
        character == END
    }
}

/// The shown number with its mark, in [`tagged`]; else as it is. `digits` stand at the beginning of `text`.
pub(crate) fn marked(text: String, digits: &str, tag: Option<&Tag>, value: f64, rounding: Rounding) -> String {
    NUMBERS.with_borrow_mut(|numbers| {
        let Some(numbers) = numbers else { return text };
        let place = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
        let Some(begin) =
            Some(place).filter(|place| *place < MAX_NUMBERS).and_then(|place| char::from_u32(FIRST + place))
        else {
            // A number without a mark is found as one.
            return text;
        };
        let rounding = match rounding {
            Rounding::Nearest => 0,
            Rounding::Down => -1,
            Rounding::Up => 1,
        };
        numbers.push(TaggedNumber { tag: tag.cloned(), digits: digits.to_owned(), value, rounding });
        format!("{begin}{text}{END}")
    })
}

/// Whether two texts read the same, whatever their marks.
pub(crate) fn same_wording(a: &str, b: &str) -> bool {
    let plain = |text: &'_ str| -> String { text.chars().filter(|c| !is_mark(*c)).collect() };
    a == b || plain(a) == plain(b)
}

fn is_mark(character: char) -> bool {
    character == END || (FIRST..FIRST + MAX_NUMBERS).contains(&u32::from(character))
}
