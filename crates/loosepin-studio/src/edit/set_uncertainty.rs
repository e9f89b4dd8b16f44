//! How well a number of the model is known, written into the two texts.
//!
//! A number that is known exactly stands in the model alone. One that scatters has an entry under `[random]` of the study, one that is
//! known only in part an entry under `[epistemic]`. Other entries of it go.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use loosepin::diagnostics::{Diagnostics, Source};
use loosepin::document::describe_path;
use loosepin::model::Origin;
use loosepin::study::{InputFile, Study, StudyModel, number_and_unit};
use loosepin::units::{Dimension, format_number, format_value};

use super::new_play::{PLAY, give_play};
use super::toml::change::changes;
use super::toml::lines::{EditedText, owned};
use super::uncertainty_spec::{UncertaintySpec, WrittenQuantity, piece, uncertainty_spec};
use crate::files::folder::Folder;
use crate::messages::{Change, Document};
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;
use crate::view::texts::{Texts, unreadable};

const RANDOM: &str = "random";
const EPISTEMIC: &str = "epistemic";
/// Numbers are rounded to this many parts of a unit.
const ROUND: f64 = 1e12;
/// Positions in a turn, for the test whether a mechanism moves.
const POSITIONS: usize = 12;

/// The changes that say how well the number at `path` is known, as people write it. They are not given where the texts could not be
/// read with them, or would say anything else.
///
/// # Errors
/// What cannot be read, or why this number cannot be known so.
pub fn set_uncertainty(folder: &Folder, texts: &Texts, path: &str, text: &str) -> Result<Vec<Change>, Refusal> {
    let (model, study) = known_texts(folder, texts, path, text)?;
    let of = |document, old: &Arc<Source>, new: Option<String>| new.map(|new| changes(document, old, &new));
    let mut all = of(Document::Model, &texts.model, model).unwrap_or_default();
    all.extend(texts.study.iter().filter_map(|old| of(Document::Study, old, study.clone())).flatten());
    Ok(all)
}

/// The texts that say how well a number is known: of the model and of the study, each only where it changes.
///
/// # Errors
/// As [`set_uncertainty`].
pub fn known_texts(
    folder: &Folder,
    texts: &Texts,
    path: &str,
    text: &str,
) -> Result<(Option<String>, Option<String>), Refusal> {
    let model = StudyModel::from_source(Arc::clone(&texts.model)).map_err(|_| unreadable("model"))?;
    let number = match model.quantities().id(path) {
        // A clearance of zero, without a contact, is no play yet.
        Some(id) if model.quantities()[id].origin != Origin::Fixed => Number::of(&model, path)?,
        _ => Number::of_new_play(&model, path)?,
    };
    let known = uncertainty_spec(text, number.dimension, &number.unit)?;
    let mut in_model = EditedText::new(texts.model.text());
    match (&number.place, &known) {
        (NumberLocation::There(range), UncertaintySpec::Exact(value)) => {
            in_model.replace([(range.clone(), value.quoted())])?
        }
        // One field holds nominal value and tolerance: a new nominal value goes into the model, which the tolerance must agree with.
        (NumberLocation::There(range), UncertaintySpec::Tolerance(Some(nominal), _))
            if number.nominal.as_ref().is_none_or(|old| old.value_si != nominal.value_si) =>
        {
            in_model.replace([(range.clone(), nominal.quoted())])?
        }
        // The model keeps its value: the drawn one.
        (NumberLocation::There(_), _) => {}
        (NumberLocation::NewPlay(joint), UncertaintySpec::Exact(value) | UncertaintySpec::Interval([value, _])) => {
            give_play(&mut in_model, &model, joint, &value.quoted())?;
        }
        (NumberLocation::NewPlay(joint), _) => {
            return Err(Refusal::bad(format!("the joint '{joint}' has no play yet"))
                .with_hint("write its play first, for example 0.1 mm or 0.1..0.5 mm"));
        }
    }
    let entry = entry(&known, &number, &model, path)?;
    let in_study = match (&texts.study, &entry) {
        (Some(study), _) => {
            let mut in_study = EditedText::new(study.text());
            write_entry(&mut in_study, path, entry.as_ref())?;
            Some(in_study)
        }
        (None, None) => None,
        (None, Some(_)) => {
            return Err(Refusal::bad("a model without a study has no random and no unknown values")
                .with_hint("open a study of it, which has them under [random] or [epistemic]"));
        }
    };
    let changed = |new: &EditedText, old: &Source| (new.text() != old.text()).then(|| new.text().to_owned());
    let new_model = changed(&in_model, &texts.model);
    let new_study = in_study.zip(texts.study.as_ref()).and_then(|(new, old)| changed(&new, old));
    let new = texts.with(folder, new_model.as_deref(), new_study.as_deref());
    is_as_said(texts, &new, path, entry.as_ref().map(|(table, _)| *table))?;
    Ok((new_model, new_study))
}

/// Whether the new texts can be read, and know of the same numbers as the old ones but for that at `path`.
fn is_as_said(old: &Texts, new: &Texts, path: &str, table: Option<&str>) -> Result<(), Refusal> {
    let refused = |diagnostics: Diagnostics| {
        let first = diagnostics.sorted().into_iter().next().map(|first| (first.message.clone(), first.hint.clone()));
        let (message, hint) = first.unwrap_or_default();
        Refusal { hint, ..Refusal::bad(message) }
    };
    let after = new.read().map_err(refused)?;
    let before = old.read().map_err(|_| unreadable("study"))?;
    // Reading alone does not look at the mechanism as a whole: a driven joint can have no play.
    if before.try_to_move(POSITIONS).is_ok() {
        after.try_to_move(POSITIONS).map_err(refused)?;
    }
    let (InputFile::Study(before), InputFile::Study(after)) = (before, after) else { return Ok(()) };
    let paths = |study: &Study, table: &str| -> BTreeSet<String> {
        match table {
            RANDOM => {
                let of_model = study.random.iter().filter(|input| input.quantity().is_some());
                of_model.map(|input| input.path.clone()).collect()
            }
            _ => study.epistemic.iter().map(|input| input.path.clone()).collect(),
        }
    };
    for which in [RANDOM, EPISTEMIC] {
        let mut due = paths(&before, which);
        due.remove(path);
        if table == Some(which) {
            due.insert(path.to_owned());
        }
        if paths(&after, which) != due {
            return Err(Refusal::bad("this change would damage the text of the study")
                .with_hint("change it in the text of the study"));
        }
    }
    Ok(())
}

/// Location of a number of the model.
enum NumberLocation {
    /// Bytes of the model, with quotes.
    There(Range<usize>),
    /// Nowhere yet: the play of this joint.
    NewPlay(String),
}

struct Number {
    place: NumberLocation,
    dimension: Dimension,
    /// The unit in which it is written; empty for a plain number.
    unit: String,
    /// Its value; `None` for a play that is not there yet.
    nominal: Option<WrittenQuantity>,
}

impl Number {
    fn of(model: &StudyModel, path: &str) -> Result<Self, Refusal> {
        let quantities = model.quantities();
        let quantity = quantities.id(path).map(|id| &quantities[id]).ok_or_else(|| missing(path))?;
        let span = match (&quantity.origin, quantity.span) {
            (Origin::Literal, Some(span)) => span,
            (Origin::Expression { depends_on }, _) => {
                let by: Vec<&str> = depends_on.iter().map(|id| quantities[*id].path.as_str()).collect();
                return Err(Refusal::bad(format!("{} follows from {}", describe_path(path), by.join(", ")))
                    .with_hint("set these instead"));
            }
            _ => return Err(Refusal::bad(format!("{} is not written as a number in the model", describe_path(path)))),
        };
        let source = model.source();
        let written = source.text()[unquoted(source, span)].trim();
        let split = number_and_unit(written);
        let nominal = split.and_then(|(number, unit)| piece(number, unit, quantity.dimension).ok());
        let nominal = nominal.ok_or_else(|| {
            Refusal::bad(format!("{} is written as '{written}', not as one number", describe_path(path)))
                .with_hint("change it in the text")
        })?;
        Ok(Self {
            place: NumberLocation::There(source.clamp(span)),
            dimension: quantity.dimension,
            unit: nominal.unit.clone(),
            nominal: Some(nominal),
        })
    }

    fn of_new_play(model: &StudyModel, path: &str) -> Result<Self, Refusal> {
        let joint = path.strip_prefix("joint.").and_then(|rest| rest.strip_suffix(&format!(".{PLAY}")));
        let joint = joint.filter(|name| !model.keys_of_new_play(name).is_empty());
        let name = joint.ok_or_else(|| missing(path))?.to_owned();
        Ok(Self {
            place: NumberLocation::NewPlay(name),
            dimension: Dimension::LENGTH,
            unit: "mm".to_owned(),
            nominal: None,
        })
    }
}

fn missing(path: &str) -> Refusal {
    Refusal::bad(format!("the model has no number '{path}'"))
}

/// An entry of a study: the table, and the text behind the equals sign.
type StudyEntry = (&'static str, String);

fn entry(
    known: &UncertaintySpec,
    number: &Number,
    model: &StudyModel,
    path: &str,
) -> Result<Option<StudyEntry>, Refusal> {
    let nominal = || number.nominal.as_ref().ok_or_else(|| missing(path));
    Ok(match known {
        UncertaintySpec::Exact(_) => None,
        UncertaintySpec::Tolerance(own, limits) => {
            let own = own.as_ref().map(|own| format!("{own} ")).unwrap_or_default();
            nominal()?;
            Some((RANDOM, format!("{{ tolerance = \"{own}{limits}\" }}")))
        }
        UncertaintySpec::StandardDeviation(deviation) => {
            nominal()?;
            Some((RANDOM, format!("{{ normal = {{ standard_deviation = {} }} }}", deviation.quoted())))
        }
        UncertaintySpec::Uniform(half) => {
            let [lower, upper] = around(nominal()?, half).map(|end| end.quoted());
            Some((RANDOM, format!("{{ uniform = {{ lower = {lower}, upper = {upper} }} }}")))
        }
        UncertaintySpec::Interval([lower, upper]) => {
            Some((EPISTEMIC, format!("{{ interval = [{}, {}] }}", lower.quoted(), upper.quoted())))
        }
        UncertaintySpec::OneOf(values) => {
            let values: Vec<String> = values.iter().map(WrittenQuantity::quoted).collect();
            Some((EPISTEMIC, format!("{{ any_of = [{}] }}", values.join(", "))))
        }
        UncertaintySpec::Fit(fit) => {
            let radius =
                path.rsplit_once('.').and_then(|(joint, _)| model.quantities().id(&format!("{joint}.bearing_radius")));
            let radius_m = radius.map(|id| model.quantities().nominal()[id]).ok_or_else(|| {
                Refusal::bad("a fit belongs to a pin in its bearing").with_hint("use it for the play of a joint")
            })?;
            let diameter = format_value(2.0 * radius_m, Dimension::LENGTH);
            Some((EPISTEMIC, format!("{{ fit = \"{fit}\", diameter = \"{diameter}\" }}")))
        }
    })
}

/// The ends that lie as far to both sides of a value, in its unit.
fn around(value: &WrittenQuantity, half: &WrittenQuantity) -> [WrittenQuantity; 2] {
    let number: f64 = value.number.parse().unwrap_or(0.0);
    // Of a value of 0 the unit is told by the other number.
    let (unit, unit_si) = match number {
        0.0 => (&half.unit, half.value_si / half.number.parse::<f64>().unwrap_or(1.0)),
        _ => (&value.unit, value.value_si / number),
    };
    [-1.0, 1.0].map(|side| {
        let value_si = value.value_si + side * half.value_si;
        // Digits that are round-off go.
        let number = format_number((value_si / unit_si * ROUND).round() / ROUND);
        WrittenQuantity { number, unit: unit.clone(), value_si }
    })
}

/// Puts the entry of a number in its table, and takes other entries of it out.
fn write_entry(study: &mut EditedText, path: &str, entry: Option<&StudyEntry>) -> Result<(), Refusal> {
    let mut is_written = false;
    for table in [RANDOM, EPISTEMIC] {
        let new = entry.filter(|(due, _)| *due == table).map(|(_, new)| new);
        match (new, study.value_span(&[table, path])?) {
            (Some(new), Some(span)) => {
                study.replace([(span, new.clone())])?;
                is_written = true;
            }
            _ => study.remove(&[owned(&[table, path])])?,
        }
    }
    match entry.filter(|_| !is_written) {
        Some((table, new)) => study.add_entry(&[table], &format!("\"{path}\""), new),
        None => Ok(()),
    }
}
