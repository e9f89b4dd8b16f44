//! How well a number of the model is known, written into the two texts.
//!
//! A number that is known exactly stands in the model alone. One that scatters has an entry under `[random]` of the study, one that is
//! known only in part an entry under `[epistemic]`. Other entries of it go.

use std::ops::Range;
use std::sync::Arc;

use loosepin::diagnostics::Source;
use loosepin::document::{describe_path, parse_toml};
use loosepin::model::{JointKind, Model, Origin};
use loosepin::units::{Dimension, format_value};

use super::knowledge::{Knowledge, knowledge};
use super::rewritten::Rewritten;
use super::written::Written;
use crate::messages::{Change, Document};
use crate::places::unquoted;
use crate::refusal::Refusal;
use crate::texts::Texts;

const RANDOM: &str = "random";
const EPISTEMIC: &str = "epistemic";
const PLAY: &str = "radial_clearance";
/// Of a bearing whose radius nobody has said, where no other joint has one.
const FIRST_RADIUS: &str = "8 mm";
/// Name and numbers of a contact that nobody has described.
const FIRST_CONTACT: &str = "\n# first guess: steel on steel\n[contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.9\n\
    youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndensity = \"7800 kg/m^3\"\n";

/// The changes that say how well the number at `path` is known, as people write it.
///
/// # Errors
/// What cannot be read, or why this number cannot be known so.
pub fn know(texts: &Texts, path: &str, text: &str) -> Result<Vec<Change>, Refusal> {
    let model = Model::from_source(Arc::clone(&texts.model)).map_err(|_| {
        Refusal::bad("the model cannot be read").with_hint("mend its problems first; they are listed below the drawing")
    })?;
    let mut in_model = Rewritten::new(&texts.model);
    let number = match model.quantities.id(path) {
        Some(_) => Number::of(&model, path)?,
        None => Number::of_new_play(&model, path)?,
    };
    let known = knowledge(text, number.dimension, &number.unit)?;
    let entry = entry(&known, &number, &model, path)?;
    match (&number.place, &known) {
        (Place::There(range), Knowledge::Exact(value)) => in_model.replace(range.clone(), value.clone()),
        // The model keeps its value: the drawn one.
        (Place::There(_), _) => {}
        (Place::NewPlay(joint), Knowledge::Exact(value) | Knowledge::Interval([value, _])) => {
            give_play(&mut in_model, texts, &model, joint, value)?;
        }
        (Place::NewPlay(joint), _) => {
            return Err(Refusal::bad(format!("the joint '{joint}' has no play yet"))
                .with_hint("write its play first, for example 0.1 mm or 0.1..0.5 mm"));
        }
    }
    let mut changes = in_model.changes(Document::Model);
    match (&texts.study, &entry) {
        (Some(study), _) => {
            let mut in_study = Rewritten::new(study);
            write_entry(&mut in_study, study, path, entry.as_ref())?;
            changes.extend(in_study.changes(Document::Study));
        }
        (None, None) => {}
        (None, Some(_)) => {
            return Err(Refusal::bad("a model alone says nothing of scatter and of what is unknown")
                .with_hint("open a study of it: there it stands under [random] or [epistemic]"));
        }
    }
    Ok(changes)
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
    /// Its value as a file has it, without quotes.
    written: String,
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
        let written = source.text()[unquoted(source, span)].to_owned();
        let unit = written.trim_start_matches(|c: char| matches!(c, '0'..='9' | '.' | '-' | '+')).trim();
        let is_plain = Written::read(&written).is_some() || written.trim().parse::<f64>().is_ok();
        if !is_plain {
            return Err(Refusal::bad(format!("{} is written as '{written}', not as one number", describe_path(path)))
                .with_hint("change it in the text"));
        }
        let unit = unit.to_owned();
        Ok(Self { place: Place::There(source.clamp(span)), dimension: quantity.dimension, unit, written })
    }

    fn of_new_play(model: &Model, path: &str) -> Result<Self, Refusal> {
        let joint = path.strip_prefix("joint.").and_then(|rest| rest.strip_suffix(&format!(".{PLAY}")));
        let joint = joint.filter(|name| {
            let found = model.joints.iter().find(|joint| joint.name == *name);
            found.is_some_and(|joint| matches!(joint.kind, JointKind::Revolute { clearance: None, .. }))
        });
        let name = joint.ok_or_else(|| missing(path))?.to_owned();
        Ok(Self {
            place: Place::NewPlay(name),
            dimension: Dimension::LENGTH,
            unit: "mm".to_owned(),
            written: String::new(),
        })
    }
}

fn missing(path: &str) -> Refusal {
    Refusal::bad(format!("the model has no number '{path}'"))
}

/// An entry of a study: the table, and what stands behind the equals sign.
type StudyEntry = (&'static str, String);

fn entry(known: &Knowledge, number: &Number, model: &Model, path: &str) -> Result<Option<StudyEntry>, Refusal> {
    let written = &number.written;
    let nominal = if number.unit.is_empty() { written.clone() } else { format!("\"{written}\"") };
    Ok(match known {
        Knowledge::Exact(_) => None,
        Knowledge::Tolerance(limits) => {
            let has_nominal = limits.starts_with(|c: char| c.is_ascii_digit());
            let whole = if has_nominal { limits.clone() } else { format!("{written} {limits}") };
            Some((RANDOM, format!("{{ tolerance = \"{whole}\" }}")))
        }
        Knowledge::StandardDeviation(deviation) => {
            Some((RANDOM, format!("{{ normal = {{ mean = {nominal}, standard_deviation = {deviation} }} }}")))
        }
        Knowledge::Uniform { half, unit } => {
            let [lower, upper] = around(written, half, unit)
                .ok_or_else(|| Refusal::bad(format!("'{half} {unit}' is not in the unit of the model, '{written}'")))?;
            Some((RANDOM, format!("{{ uniform = {{ lower = {lower}, upper = {upper} }} }}")))
        }
        Knowledge::Interval([lower, upper]) => Some((EPISTEMIC, format!("{{ interval = [{lower}, {upper}] }}"))),
        Knowledge::OneOf(values) => Some((EPISTEMIC, format!("{{ any_of = [{}] }}", values.join(", ")))),
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

/// The ends that lie as far to both sides of a number as is written; nothing where the units differ.
fn around(written: &str, half: &str, unit: &str) -> Option<[String; 2]> {
    let half: f64 = half.parse().ok()?;
    if unit.is_empty() {
        let value: f64 = written.trim().parse().ok()?;
        return Some([value - half, value + half].map(loosepin::units::format_number));
    }
    let [value, half] = [Written::read(written)?, Written::read(&format!("{half} {unit}"))?];
    Some([-1.0, 1.0].map(|side| format!("\"{}\"", value.moved_by_si(side * half.value_si()))))
}

/// Puts the entry of a number in its table, and takes other entries of it out.
fn write_entry(
    text: &mut Rewritten<'_>,
    study: &Arc<Source>,
    path: &str,
    entry: Option<&StudyEntry>,
) -> Result<(), Refusal> {
    let whole = study.text();
    let toml = parse_toml(study).map_err(|_| {
        Refusal::bad("the study cannot be read").with_hint("mend its problems first; they are listed below the drawing")
    })?;
    let mut is_written = false;
    for table in [RANDOM, EPISTEMIC] {
        let Some((name, entries)) = toml.get_ref().get_key_value(table) else { continue };
        let Some(entries) = entries.get_ref().as_table() else { continue };
        // Where the last entry of the table ends: a new one comes behind it.
        let mut last = line_end(whole, study.clamp(name.span().into()).end);
        for (key, value) in entries {
            let (key_at, value_at) = (study.clamp(key.span().into()), study.clamp(value.span().into()));
            last = last.max(line_end(whole, value_at.end));
            let key: &str = key.get_ref().as_ref();
            if key != path {
                continue;
            }
            if value_at.start < key_at.end || !whole[key_at.end..value_at.start].contains('=') {
                return Err(Refusal::bad(format!("'{path}' has a table of its own in the study"))
                    .with_hint("change it in the text of the study"));
            }
            match entry {
                Some((due, new)) if *due == table => {
                    text.replace(value_at, new.clone());
                    is_written = true;
                }
                _ => text.replace(line_start(whole, key_at.start)..line_end(whole, value_at.end), String::new()),
            }
        }
        if let Some((_, new)) = entry.filter(|(due, _)| *due == table && !is_written) {
            text.replace(last..last, line_of(whole, last, path, new));
            is_written = true;
        }
    }
    if let Some((table, new)) = entry.filter(|_| !is_written) {
        // Before the questions, where there are any: a study reads from what is known to what is asked.
        let first_question =
            toml.get_ref().get_key_value("ask").map(|(key, _)| line_start(whole, study.clamp(key.span().into()).start));
        let at = first_question.unwrap_or(whole.len());
        let before = if whole[..at].ends_with('\n') || at == 0 { "" } else { "\n" };
        text.replace(at..at, format!("{before}[{table}]\n\"{path}\" = {new}\n\n"));
    }
    Ok(())
}

/// A line for an entry, at the beginning of a line or behind the last one of the text.
fn line_of(whole: &str, at: usize, path: &str, value: &str) -> String {
    let before = if whole[..at].ends_with('\n') { "" } else { "\n" };
    format!("{before}\"{path}\" = {value}\n")
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
    let toml = parse_toml(source).map_err(|_| Refusal::bad("the model cannot be read"))?;
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
    let before = if whole[..at].ends_with('\n') { "" } else { "\n" };
    text.replace(
        at..at,
        format!("{before}bearing_radius = \"{radius}\"  # first guess\n{PLAY} = {value}\ncontact = \"{name}\"\n"),
    );
    if contact.is_none() {
        let before = if whole.ends_with('\n') { "" } else { "\n" };
        text.replace(whole.len()..whole.len(), format!("{before}{FIRST_CONTACT}"));
    }
    Ok(())
}
