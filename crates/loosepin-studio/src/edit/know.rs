//! How well a number of the model is known, written into the two texts.
//!
//! A number that is known exactly stands in the model alone. One that scatters has an entry under `[random]` of the study, one that is
//! known only in part an entry under `[epistemic]`. Other entries of it go.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use loosepin::diagnostics::{Complaints, Source};
use loosepin::document::{describe_path, parse_toml};
use loosepin::model::{Model, Origin};
use loosepin::study::{InputFile, Study, number_and_unit};
use loosepin::units::{Dimension, format_number, format_value};

use super::knowledge::{Knowledge, Piece, knowledge, piece};
use super::rewritten::Rewritten;
use crate::files::folder::Folder;
use crate::messages::{Change, Document};
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;
use crate::view::texts::Texts;

const RANDOM: &str = "random";
const EPISTEMIC: &str = "epistemic";
/// Numbers are rounded to this many parts of a unit.
const ROUND: f64 = 1e12;
/// Of a turn, to see whether a mechanism moves.
const POSITIONS: usize = 12;
const PLAY: &str = "radial_clearance";
/// Of a bearing whose radius nobody has said, where no other joint has one.
const FIRST_RADIUS: &str = "8 mm";
/// Name and numbers of a contact that nobody has described.
const FIRST_CONTACT: &str = "\n# first guess: steel on steel\n[contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.9\n\
    youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndensity = \"7800 kg/m^3\"\n";

/// The changes that say how well the number at `path` is known, as people write it. They are not given where the texts could not be
/// read with them, or would say anything else.
///
/// # Errors
/// What cannot be read, or why this number cannot be known so.
pub fn know(folder: &Folder, texts: &Texts, path: &str, text: &str) -> Result<Vec<Change>, Refusal> {
    let (in_model, in_study) = written(folder, texts, path, text)?;
    let mut changes = in_model.changes(Document::Model);
    changes.extend(in_study.iter().flat_map(|in_study| in_study.changes(Document::Study)));
    Ok(changes)
}

/// The texts that say how well a number is known: of the model and of the study, each only where it changes.
///
/// # Errors
/// As [`know`].
pub fn known_texts(
    folder: &Folder,
    texts: &Texts,
    path: &str,
    text: &str,
) -> Result<(Option<String>, Option<String>), Refusal> {
    let (in_model, in_study) = written(folder, texts, path, text)?;
    Ok((in_model.text(), in_study.and_then(|in_study| in_study.text())))
}

/// Both texts with what is known of a number.
fn written<'t>(
    folder: &Folder,
    texts: &'t Texts,
    path: &str,
    text: &str,
) -> Result<(Rewritten<'t>, Option<Rewritten<'t>>), Refusal> {
    let model = Model::from_source(Arc::clone(&texts.model)).map_err(|_| unreadable("model"))?;
    let number = match model.quantities.id(path) {
        // A clearance of zero, without a contact, is no play yet.
        Some(id) if model.quantities[id].origin != Origin::Fixed => Number::of(&model, path)?,
        _ => Number::of_new_play(&model, path)?,
    };
    let known = knowledge(text, number.dimension, &number.unit)?;
    let mut in_model = Rewritten::new(&texts.model);
    match (&number.place, &known) {
        (Place::There(range), Knowledge::Exact(value)) => in_model.replace(range.clone(), value.quoted()),
        // The model keeps its value: the drawn one.
        (Place::There(_), _) => {}
        (Place::NewPlay(joint), Knowledge::Exact(value) | Knowledge::Interval([value, _])) => {
            give_play(&mut in_model, texts, &model, joint, &value.quoted())?;
        }
        (Place::NewPlay(joint), _) => {
            return Err(Refusal::bad(format!("the joint '{joint}' has no play yet"))
                .with_hint("write its play first, for example 0.1 mm or 0.1..0.5 mm"));
        }
    }
    let entry = entry(&known, &number, &model, path)?;
    let in_study = match (&texts.study, &entry) {
        (Some(study), _) => {
            let mut in_study = Rewritten::new(study);
            write_entry(&mut in_study, study, path, entry.as_ref())?;
            Some(in_study)
        }
        (None, None) => None,
        (None, Some(_)) => {
            return Err(Refusal::bad("a model alone says nothing of scatter and of what is unknown")
                .with_hint("open a study of it: there it stands under [random] or [epistemic]"));
        }
    };
    let new_study = in_study.as_ref().and_then(Rewritten::text);
    let new = texts.with(folder, in_model.text().as_deref(), new_study.as_deref());
    is_as_said(texts, &new, path, entry.as_ref().map(|(table, _)| *table))?;
    Ok((in_model, in_study))
}

/// Whether the new texts can be read, and know of the same numbers as the old ones but for that at `path`.
fn is_as_said(old: &Texts, new: &Texts, path: &str, table: Option<&str>) -> Result<(), Refusal> {
    let refused = |complaints: Complaints| {
        let first = complaints.sorted().into_iter().next().map(|first| (first.message.clone(), first.hint.clone()));
        let (message, hint) = first.unwrap_or_default();
        Refusal { hint, ..Refusal::bad(message) }
    };
    let after = new.read().map_err(refused)?;
    let before = old.read().map_err(|_| unreadable("study"))?;
    // Reading alone does not look at the mechanism as a whole: a driven joint can have no play.
    if before.ideal_motion(POSITIONS, &[]).is_ok() {
        after.ideal_motion(POSITIONS, &[]).map_err(refused)?;
    }
    let (InputFile::Study(before), InputFile::Study(after)) = (before, after) else { return Ok(()) };
    let paths = |study: &Study, table: &str| -> BTreeSet<String> {
        match table {
            RANDOM => study.random.iter().map(|input| input.path.clone()).collect(),
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
            return Err(Refusal::bad("the study is written in a way that this would damage")
                .with_hint("change it in the text of the study"));
        }
    }
    Ok(())
}

/// Where a number of the model stands.
enum Place {
    /// These bytes of the model, quotes and all.
    There(Range<usize>),
    /// Nowhere yet: the play of this joint.
    NewPlay(String),
}

struct Number {
    place: Place,
    dimension: Dimension,
    /// The unit in which it is written; empty for a plain number.
    unit: String,
    /// Its value; none of a play that is not there yet.
    nominal: Option<Piece>,
}

impl Number {
    fn of(model: &Model, path: &str) -> Result<Self, Refusal> {
        let quantity = model.quantities.id(path).map(|id| &model.quantities[id]).ok_or_else(|| missing(path))?;
        let span = match (&quantity.origin, quantity.span) {
            (Origin::Literal, Some(span)) => span,
            (Origin::Expression { depends_on }, _) => {
                let by: Vec<&str> = depends_on.iter().map(|id| model.quantities[*id].path.as_str()).collect();
                return Err(Refusal::bad(format!("{} follows from {}", describe_path(path), by.join(", ")))
                    .with_hint("say how well these are known instead"));
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
            place: Place::There(source.clamp(span)),
            dimension: quantity.dimension,
            unit: nominal.unit.clone(),
            nominal: Some(nominal),
        })
    }

    fn of_new_play(model: &Model, path: &str) -> Result<Self, Refusal> {
        let joint = path.strip_prefix("joint.").and_then(|rest| rest.strip_suffix(&format!(".{PLAY}")));
        let joint = joint.filter(|name| {
            let found = model.joints.iter().find(|joint| joint.name == *name);
            found.is_some_and(|joint| joint.kind.turns() && joint.kind.play().is_none())
        });
        let name = joint.ok_or_else(|| missing(path))?.to_owned();
        Ok(Self { place: Place::NewPlay(name), dimension: Dimension::LENGTH, unit: "mm".to_owned(), nominal: None })
    }
}

fn missing(path: &str) -> Refusal {
    Refusal::bad(format!("the model has no number '{path}'"))
}

/// An entry of a study: the table, and what stands behind the equals sign.
type StudyEntry = (&'static str, String);

fn entry(known: &Knowledge, number: &Number, model: &Model, path: &str) -> Result<Option<StudyEntry>, Refusal> {
    let nominal = || number.nominal.as_ref().ok_or_else(|| missing(path));
    Ok(match known {
        Knowledge::Exact(_) => None,
        Knowledge::Tolerance(own, limits) => {
            let own = own.as_ref().map(|own| format!("{own} ")).unwrap_or_default();
            nominal()?;
            Some((RANDOM, format!("{{ tolerance = \"{own}{limits}\" }}")))
        }
        Knowledge::StandardDeviation(deviation) => {
            nominal()?;
            Some((RANDOM, format!("{{ normal = {{ standard_deviation = {} }} }}", deviation.quoted())))
        }
        Knowledge::Uniform(half) => {
            let [lower, upper] = around(nominal()?, half).map(|end| end.quoted());
            Some((RANDOM, format!("{{ uniform = {{ lower = {lower}, upper = {upper} }} }}")))
        }
        Knowledge::Interval([lower, upper]) => {
            Some((EPISTEMIC, format!("{{ interval = [{}, {}] }}", lower.quoted(), upper.quoted())))
        }
        Knowledge::OneOf(values) => {
            let values: Vec<String> = values.iter().map(Piece::quoted).collect();
            Some((EPISTEMIC, format!("{{ any_of = [{}] }}", values.join(", "))))
        }
        Knowledge::Fit(fit) => {
            let radius =
                path.rsplit_once('.').and_then(|(joint, _)| model.quantities.id(&format!("{joint}.bearing_radius")));
            let radius_m = radius.map(|id| model.quantities.nominal()[id]).ok_or_else(|| {
                Refusal::bad("a fit is that of a pin in its bearing").with_hint("write it for the play of a joint")
            })?;
            let diameter = format_value(2.0 * radius_m, Dimension::LENGTH);
            Some((EPISTEMIC, format!("{{ fit = \"{fit}\", diameter = \"{diameter}\" }}")))
        }
    })
}

/// The ends that lie as far to both sides of a value, in its unit.
fn around(value: &Piece, half: &Piece) -> [Piece; 2] {
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
        Piece { number, unit: unit.clone(), value_si }
    })
}

/// Puts the entry of a number in its table, and takes other entries of it out.
fn write_entry(
    text: &mut Rewritten<'_>,
    study: &Arc<Source>,
    path: &str,
    entry: Option<&StudyEntry>,
) -> Result<(), Refusal> {
    let whole = study.text();
    let toml = parse_toml(study).map_err(|_| unreadable("study"))?;
    let mut is_written = false;
    for table in [RANDOM, EPISTEMIC] {
        let Some(entries) = toml.get_ref().get(table).and_then(|table| table.get_ref().as_table()) else { continue };
        let found = entries.iter().find(|(key, _)| key.get_ref().as_ref() as &str == path);
        let Some((key, value)) = found else { continue };
        let (key_at, value_at) = (study.clamp(key.span().into()), study.clamp(value.span().into()));
        let line = line_start(whole, key_at.start)..line_end(whole, value_at.end);
        let own_line = whole[line.start..key_at.start].trim().is_empty()
            && value_at.start >= key_at.end
            && whole[key_at.end..value_at.start].trim() == "="
            && is_end(&whole[value_at.end..line.end]);
        if !own_line {
            return Err(Refusal::bad(format!("'{path}' shares its line in the study, or has a table of its own"))
                .with_hint("change it in the text of the study"));
        }
        match entry {
            Some((due, new)) if *due == table => {
                text.replace(value_at, new.clone());
                is_written = true;
            }
            _ => text.replace(line, String::new()),
        }
    }
    let Some((table, new)) = entry.filter(|_| !is_written) else { return Ok(()) };
    if let Some(at) = end_of_table(whole, table) {
        text.replace(at..at, format!("{}\"{path}\" = {new}\n", break_before(whole, at)));
        return Ok(());
    }
    // Before the questions, where they are tables: a study reads from what is known to what is asked.
    let at = first_question(whole).unwrap_or(whole.len());
    text.replace(at..at, format!("{}[{table}]\n\"{path}\" = {new}\n\n", break_before(whole, at)));
    Ok(())
}

fn unreadable(which: &str) -> Refusal {
    Refusal::bad(format!("the {which} cannot be read"))
        .with_hint("mend its problems first; they are listed below the drawing")
}

/// What stands behind a value, where nothing else does.
fn is_end(text: &str) -> bool {
    let text = text.trim();
    text.is_empty() || text.starts_with('#')
}

/// Behind the last line with something in it of the table with this header; nothing where there is no such header.
fn end_of_table(whole: &str, table: &str) -> Option<usize> {
    let mut end = None;
    let mut at = 0;
    for line in whole.split_inclusive('\n') {
        at += line.len();
        let text = line.trim();
        let is_own = || {
            let inside = text.strip_prefix('[').and_then(|text| text.split_once(']'));
            inside.is_some_and(|(name, rest)| name.trim() == table && is_end(rest))
        };
        match end {
            None if is_own() => end = Some(at),
            None => {}
            Some(_) if text.starts_with('[') && !text.starts_with("[\"") => break,
            Some(_) if text.is_empty() || text.starts_with('#') => {}
            Some(_) => end = Some(at),
        }
    }
    end
}

/// Where the first `[[ask]]` begins, with the comment above it.
fn first_question(whole: &str) -> Option<usize> {
    let mut at = 0;
    let mut comment = None;
    for line in whole.split_inclusive('\n') {
        let text = line.trim();
        if text.starts_with("[[ask]]") {
            return Some(comment.unwrap_or(at));
        }
        comment = if text.starts_with('#') { comment.or(Some(at)) } else { None };
        at += line.len();
    }
    None
}

/// A line end, where what stands before has none.
fn break_before(whole: &str, at: usize) -> &'static str {
    if at == 0 || whole[..at].ends_with('\n') { "" } else { "\n" }
}

fn line_start(text: &str, at: usize) -> usize {
    text[..at].rfind('\n').map_or(0, |end| end + 1)
}

/// Behind the end of the line that holds a byte.
fn line_end(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |end| at + end + 1)
}

/// Gives a joint its play, with what belongs to one: the radius of the bearing and the contact.
fn give_play(text: &mut Rewritten<'_>, texts: &Texts, model: &Model, joint: &str, value: &str) -> Result<(), Refusal> {
    let source = &texts.model;
    let whole = source.text();
    let toml = parse_toml(source).map_err(|_| unreadable("model"))?;
    let table = |name: &str| toml.get_ref().get(name).and_then(|value| value.get_ref().as_table());
    let entries = table("joint").and_then(|joints| joints.get(joint)?.get_ref().as_table());
    let ends = entries.into_iter().flatten().map(|(_, value)| line_end(whole, source.clamp(value.span().into()).end));
    let at = ends.max().ok_or_else(|| missing(joint))?;
    let is_inline = entries.into_iter().flatten().next().is_some_and(|(key, _)| {
        let start = source.clamp(key.span().into()).start;
        !whole[line_start(whole, start)..start].trim().is_empty()
    });
    if is_inline {
        return Err(Refusal::bad(format!("the joint '{joint}' is written in one line"))
            .with_hint("give it its play in the text"));
    }
    let radius = model.quantities.iter().find(|(_, quantity)| {
        quantity.path.starts_with("joint.")
            && quantity.path.ends_with(".bearing_radius")
            && quantity.origin == Origin::Literal
    });
    let radius = radius.and_then(|(_, quantity)| Some(whole[unquoted(source, quantity.span?)].to_owned()));
    let radius = radius.unwrap_or_else(|| FIRST_RADIUS.to_owned());
    let contact = model.contacts.first().map(|contact| contact.name.as_str());
    let name = contact.unwrap_or("steel");
    // What is there already stays; a clearance of zero is replaced.
    let mut lines = String::new();
    let there = |key: &str| entries.and_then(|entries| entries.get(key));
    if there("bearing_radius").is_none() {
        lines.push_str(&format!("bearing_radius = \"{radius}\"  # first guess\n"));
    }
    match there(PLAY) {
        Some(zero) => text.replace(source.clamp(zero.span().into()), value.to_owned()),
        None => lines.push_str(&format!("{PLAY} = {value}\n")),
    }
    if there("contact").is_none() {
        lines.push_str(&format!("contact = \"{name}\"\n"));
    }
    if !lines.is_empty() {
        text.replace(at..at, format!("{}{lines}", break_before(whole, at)));
    }
    if contact.is_none() {
        let before = if at == whole.len() { "" } else { break_before(whole, whole.len()) };
        text.replace(whole.len()..whole.len(), format!("{before}{FIRST_CONTACT}"));
    }
    Ok(())
}
