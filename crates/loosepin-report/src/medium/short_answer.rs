//! The answer of a page in few sentences. What it has no room for opens in a section.

use super::glue::glued;
use loosepin_text::article::{Content, Section};
use maud::{Markup, html};

/// Sentences that a page begins with, at most.
const MAX_SENTENCES: usize = 5;
/// Section of what they leave out.
const FURTHER: &str = "further";
/// Those of them that caveats have, where there are any.
const OF_CAVEATS: usize = 2;

/// How much a paragraph of an answer matters to somebody who reads a few sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weight {
    /// It is the answer.
    Answer,
    /// Without it the answer could be taken for more than it is.
    Caveat,
    /// A table or a section has it too, or few ask for it.
    Detail,
}

/// A paragraph of an answer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Said {
    pub weight: Weight,
    pub words: String,
}

impl Said {
    pub fn answer(words: String) -> Said {
        Said { weight: Weight::Answer, words }
    }

    pub fn caveat(words: String) -> Said {
        Said { weight: Weight::Caveat, words }
    }

    pub fn detail(words: String) -> Said {
        Said { weight: Weight::Detail, words }
    }
}

/// The paragraphs that matter as much as this.
pub(crate) fn of_weight(said: &[Said], weight: Weight) -> Vec<String> {
    said.iter().filter(|said| said.weight == weight).map(|said| said.words.clone()).collect()
}

/// All paragraphs, for media that have room.
pub(crate) fn words(said: Vec<Said>) -> Vec<String> {
    said.into_iter().map(|said| said.words).collect()
}

/// An answer as a page has it.
pub(crate) struct ShortAnswer {
    /// The first one is the headline.
    answers: Vec<String>,
    caveats: Vec<String>,
    /// Whether there are caveats of which nothing is shown.
    hides_caveats: bool,
    /// Paragraphs that are not shown, or not to their end.
    further: Vec<String>,
}

impl ShortAnswer {
    /// Caveats first, each with what follows from it, while they have room; then the first sentence of each answer, and more of the first ones.
    pub fn of(said: &[Said]) -> ShortAnswer {
        let short = Self::of_sentences(said, MAX_SENTENCES);
        // The line that leads to them takes the room of a sentence.
        if short.hides_caveats { Self::of_sentences(said, MAX_SENTENCES - 1) } else { short }
    }

    fn of_sentences(said: &[Said], most: usize) -> ShortAnswer {
        let paragraphs: Vec<Vec<&str>> = said.iter().map(|said| sentences(&said.words)).collect();
        let places = |weight: Weight| (0..said.len()).filter(move |place| said[*place].weight == weight);
        let mut shown = vec![0; said.len()];
        let mut show = |places: &mut dyn Iterator<Item = usize>, room: usize, most: usize| {
            let mut left = room;
            for place in places {
                let more = left.min(most).min(paragraphs[place].len() - shown[place]);
                shown[place] += more;
                left -= more;
            }
            left
        };
        let left = most - OF_CAVEATS + show(&mut places(Weight::Caveat), OF_CAVEATS, OF_CAVEATS);
        let left = show(&mut places(Weight::Answer), left, 1);
        let left = show(&mut places(Weight::Answer), left, MAX_SENTENCES);
        show(&mut places(Weight::Caveat), left, MAX_SENTENCES);
        let words_of = |weight: Weight| {
            let shown_ones = places(weight).filter(|place| shown[*place] > 0);
            shown_ones.map(|place| paragraphs[place][..shown[place]].join(" ")).collect()
        };
        let is_left = |place: &usize| shown[*place] < paragraphs[*place].len();
        let mut answers: Vec<String> = words_of(Weight::Answer);
        let headline = answers.first().map(|first| sentences(first)[0].len());
        if let Some(end) = headline.filter(|end| *end < answers[0].len()) {
            let rest = answers[0].split_off(end).trim_start().to_owned();
            answers.insert(1, rest);
        }
        ShortAnswer {
            answers,
            caveats: words_of(Weight::Caveat),
            hides_caveats: places(Weight::Caveat).any(|place| shown[place] == 0),
            further: (0..said.len()).filter(is_left).map(|place| said[place].words.clone()).collect(),
        }
    }

    /// The sentences that the page begins with, the first one as the headline.
    pub fn markup(&self) -> Markup {
        html! {
            @for (place, words) in self.answers.iter().enumerate() {
                @if place == 0 { p.headline { (glued(words)) } } @else { p { (glued(words)) } }
            }
            @if !self.caveats.is_empty() { ul.caveats { @for caveat in &self.caveats { li { (glued(caveat)) } } (self.more_caveats()) } }
        }
    }

    /// Where the caveats are that the page has no room for.
    fn more_caveats(&self) -> Markup {
        html! {
            @if self.hides_caveats {
                li { a href={ "#" (FURTHER) } { "More warnings under Further findings" } }
            }
        }
    }

    /// The others; `None` if all are shown.
    pub fn further(self) -> Option<Section> {
        let mut section = Section::headed_on_page(FURTHER, "Further findings");
        section.push(Content::sentences(self.further.clone()));
        (!self.further.is_empty()).then_some(section)
    }
}

/// The sentences of a paragraph. One ends with a point before a space and something that no sentence goes on with.
fn sentences(paragraph: &str) -> Vec<&str> {
    let begins = |c: char| !c.is_lowercase() && !c.is_whitespace();
    let ends = paragraph.match_indices(". ").map(|(at, _)| at + 1);
    let ends: Vec<usize> = ends.filter(|at| paragraph[at + 1..].starts_with(begins)).collect();
    let starts = std::iter::once(0).chain(ends.iter().map(|at| at + 1));
    starts.zip(ends.iter().copied().chain([paragraph.len()])).map(|(from, to)| &paragraph[from..to]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn short(said: &[Said]) -> ([Vec<String>; 2], Vec<String>) {
        let short = ShortAnswer::of(said);
        ([short.answers, short.caveats], short.further)
    }

    #[test]
    fn a_page_begins_with_five_sentences_and_the_others_are_kept() {
        let paragraph = |name: &str| format!("{name} is 0.5 mm. {name} is proven. 3 of {name} are left.");
        let all = vec![
            Said::answer("Met.".to_owned()),
            Said::detail("No news.".to_owned()),
            Said::answer(paragraph("A")),
            Said::caveat(paragraph("B")),
            Said::answer(paragraph("C")),
        ];
        let (shown, further) = short(&all);
        let words = |own: &[&str]| own.iter().map(|own| (*own).to_owned()).collect::<Vec<String>>();
        assert_eq!(shown[0], words(&["Met.", "A is 0.5 mm.", "C is 0.5 mm."]));
        assert_eq!(shown[1], words(&["B is 0.5 mm. B is proven."]));
        // What is cut stands there in whole, so that it can be read.
        assert_eq!(further, vec!["No news.".to_owned(), paragraph("A"), paragraph("B"), paragraph("C")]);
        // Where there are too many answers, caveats have their room.
        let many: Vec<Said> = (0..9).map(|k| Said::answer(format!("{k}."))).chain(all.clone()).collect();
        let (shown, further) = short(&many);
        assert_eq!((shown[0].len(), shown[1].len(), further.len()), (3, 1, 11));
        let caveats: Vec<Said> = (0..3).map(|k| Said::caveat(format!("Warning {k}."))).collect();
        let (shown, further) = short(&[caveats, all.clone()].concat());
        assert_eq!((shown[0].len(), shown[1].len()), (2, 2), "and the line that leads to the others: {further:?}");
        let (shown, _) = short(&[Said::answer(paragraph("A"))]);
        assert_eq!(shown[0], words(&["A is 0.5 mm.", "A is proven. 3 of A are left."]));
        assert!(ShortAnswer::of(&[Said::answer("All of it.".to_owned())]).further().is_none());
    }

    #[test]
    fn points_inside_numbers_and_names_end_no_sentence() {
        assert_eq!(
            sentences("At 0.5 mm of slider.pin, i. e. there. Next"),
            ["At 0.5 mm of slider.pin, i. e. there.", "Next"]
        );
        assert_eq!(sentences(""), [""]);
    }
}
