//! Whether new texts say what they are to say, and what the library says of the mechanism in them.

use std::collections::{BTreeMap, BTreeSet};

use loosepin::diagnostics::Diagnostics;
use loosepin::mechanism::MechanismError;
use loosepin::model::Model;
use loosepin::study::{InputFile, Study};
use loosepin::units::counted;

use super::edit::Named;
use super::names::mentions;
use crate::edit::toml::PathPrefixes;
use crate::edit::toml::scan::scan;
use crate::messages::Document;
use crate::network::refusal::Refusal;
use crate::view::texts::{Texts, unreadable};

/// Positions in a turn, for the test whether a mechanism moves.
const POSITIONS: usize = 36;
/// Instants of a motion by actuators, for the same.
const INSTANTS: usize = 4;

/// The difference that a change is to make.
#[derive(Debug, Default)]
pub struct IntendedChange {
    /// Removed items.
    pub gone: BTreeSet<Named>,
    /// Paths that come, or get another value: with dots between their steps.
    pub added: BTreeSet<String>,
    /// The renamed item, and its new name.
    pub renamed: Option<(Named, String)>,
    /// Paths of the entries of the study that go.
    pub of_study: Vec<Vec<String>>,
    /// The output about which the study asks from now on.
    pub asked: Option<Named>,
}

/// Findings of the library on a mechanism.
#[derive(Debug, PartialEq)]
pub struct LibraryFindings {
    /// Whether it moves as its drives or actuators demand, all the way round.
    pub is_complete: bool,
    /// Degrees of freedom; what is missing, where it is not complete; what the study lacks.
    pub words: Vec<String>,
}

/// Whether the new model has all that the old one had but for what is due, and the study likewise.
///
/// # Errors
/// It has not, or cannot be read, in words.
pub fn check(old: &Texts, new: &Texts, due: &IntendedChange) -> Result<Model, Refusal> {
    let before = old.planar_model()?;
    let after = Model::from_source(new.model.clone()).map_err(|diagnostics| first_of(&diagnostics))?;
    if expected(&facts(&before), due) != beside_added(&facts(&after), due) {
        return Err(otherwise("model"));
    }
    let added = due.added.iter().filter(|path| path.matches('.').count() == 1);
    let (known, names) = (facts(&before), facts(&after));
    if !added
        .into_iter()
        .all(|path| names.keys().any(|one| is_under(one, path)) || known.keys().any(|one| is_under(one, path)))
    {
        return Err(otherwise("model"));
    }
    check_study(old, new, due, before, &after)?;
    Ok(after)
}

/// The study names what it named before, but for what is due; where it can be read, it knows of the same numbers.
fn check_study(old: &Texts, new: &Texts, due: &IntendedChange, before: Model, after: &Model) -> Result<(), Refusal> {
    let (Some(old_source), Some(new_source)) = (&old.study, &new.study) else { return Ok(()) };
    let [Some(old_scan), Some(new_scan)] = [old_source, new_source].map(|source| scan(source.text())) else {
        return Err(unreadable("study"));
    };
    let gone = PathPrefixes::of(&due.of_study);
    let goes = |path: &[String]| gone.first_of(path).is_some();
    let named = mentions(Document::Study, &old_scan).into_iter().filter(|mention| !goes(&mention.path));
    let expected_names: Vec<Named> = named.map(|mention| due.named(mention.of)).chain(due.asked.clone()).collect();
    let names: Vec<Named> = mentions(Document::Study, &new_scan).into_iter().map(|mention| mention.of).collect();
    if expected_names != names {
        return Err(otherwise("study"));
    }
    if due.gone.is_empty() && due.renamed.is_none() && old_source.text() == new_source.text() {
        return Ok(());
    }
    let path = std::path::PathBuf::from(old.model.name());
    // What an edit leaves without a question, or asks of play that went, is told, and read again when it is mended.
    if let (Ok(before), Ok(after)) =
        (Study::draft_of_model(old_source, before, &path), Study::draft_of_model(new_source, after.clone(), &path))
    {
        let of = |study: &Study| -> BTreeMap<String, String> {
            let of_model = study.random.iter().filter(|input| input.quantity().is_some());
            let random = of_model.map(|input| (input.path.clone(), "random".to_owned()));
            let epistemic = study.epistemic.iter().map(|input| (input.path.clone(), "epistemic".to_owned()));
            random.chain(epistemic).collect()
        };
        if expected(&of(&before), due) != of(&after) {
            return Err(otherwise("study"));
        }
    }
    Ok(())
}

fn otherwise(which: &str) -> Refusal {
    Refusal::bad(format!("this change would damage the text of the {which}"))
        .with_hint(format!("change it in the text of the {which}"))
}

fn first_of(diagnostics: &Diagnostics) -> Refusal {
    let first = diagnostics.sorted().into_iter().next().map(|first| (first.message.clone(), first.hint.clone()));
    let (message, hint) = first.unwrap_or_default();
    Refusal { hint, ..Refusal::bad(message) }
}

/// Everything in a model by its path, with its value or what it joins.
pub fn facts(model: &Model) -> BTreeMap<String, String> {
    let values = model.quantities.nominal();
    let mut facts = BTreeMap::new();
    for (id, quantity) in model.quantities.iter() {
        facts.insert(quantity.path.clone(), format!("{:e}", values[id]));
    }
    let point = |point: loosepin::model::PointId| {
        let body = &model.bodies[point.body.0];
        format!("{}.{}", body.name, body.points[point.point].name)
    };
    for joint in &model.joints {
        let [first, second] = joint.kind.points().map(point);
        let kind = joint.kind.word();
        facts.insert(format!("joint.{}", joint.name), format!("{kind} {first} {second}"));
    }
    for drive in &model.drives {
        facts.insert(format!("drive.{}", drive.name), format!("joint.{}", model.joints[drive.joint.0].name));
    }
    let names = model.bodies.iter().skip(1).map(|one| format!("body.{}", one.name));
    let names = names.chain(model.contacts.iter().map(|one| format!("contact.{}", one.name)));
    let names = names.chain(model.springs.iter().map(|one| format!("spring.{}", one.name)));
    let names = names.chain(model.loads.iter().map(|one| format!("load.{}", one.name)));
    let names = names.chain(model.controls.iter().map(|one| format!("control.{}", one.name)));
    let names = names.chain(model.couplings.iter().map(|one| one.path.clone()));
    let names = names.chain(model.outputs.iter().map(|one| format!("output.{}", one.name)));
    facts.extend(names.map(|name| (name, String::new())));
    facts
}

fn is_under(path: &str, of: &str) -> bool {
    path.strip_prefix(of).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

fn beside_added(facts: &BTreeMap<String, String>, due: &IntendedChange) -> BTreeMap<String, String> {
    let is_added = |path: &str| due.added.iter().any(|added| is_under(path, added));
    facts.iter().filter(|(path, _)| !is_added(path)).map(|(path, value)| (path.clone(), value.clone())).collect()
}

/// What is to be left of some facts, beside what is added.
fn expected(facts: &BTreeMap<String, String>, due: &IntendedChange) -> BTreeMap<String, String> {
    let mut gone = BTreeSet::new();
    for one in &due.gone {
        match &one.point {
            Some(point) => _ = gone.insert(format!("body.{}.points.{point}", one.name)),
            None => {
                gone.insert(format!("{}.{}", one.table, one.name));
                gone.insert(format!("initial.{}.{}", one.table, one.name));
                if one.table == "body" {
                    gone.insert(format!("assembly.guess.{}", one.name));
                }
            }
        }
    }
    let is_gone = |path: &str| {
        let mut ends = path.match_indices('.').map(|(end, _)| end).chain([path.len()]);
        ends.any(|end| gone.contains(&path[..end]))
    };
    let left = beside_added(facts, due).into_iter().filter(|(path, _)| !is_gone(path));
    left.map(|(path, value)| (due.path(&path), due.value(&value))).collect()
}

impl IntendedChange {
    /// Something under its new name.
    fn named(&self, named: Named) -> Named {
        match &self.renamed {
            Some((what, to)) if what.point.is_some() && named == *what => Named::point(&named.name, to),
            Some((what, to)) if what.point.is_none() && (&named.table, &named.name) == (&what.table, &what.name) => {
                Named { name: to.clone(), ..named }
            }
            _ => named,
        }
    }

    /// A path with the new name in it.
    fn path(&self, path: &str) -> String {
        let Some((what, to)) = &self.renamed else { return path.to_owned() };
        let name = &what.name;
        let (old, new) = match &what.point {
            Some(point) => (format!("body.{name}.points.{point}"), format!("body.{name}.points.{to}")),
            None => (format!("{}.{name}", what.table), format!("{}.{to}", what.table)),
        };
        let mut forms = vec![(old, new)];
        if what.point.is_none() {
            forms.push((format!("initial.{}.{name}", what.table), format!("initial.{}.{to}", what.table)));
            if what.table == "body" {
                forms.push((format!("assembly.guess.{name}"), format!("assembly.guess.{to}")));
            }
        }
        let found = forms.iter().find(|(old, _)| is_under(path, old));
        found.map_or_else(|| path.to_owned(), |(old, new)| format!("{new}{}", &path[old.len()..]))
    }

    /// Points and joints in a value, with the new name in them.
    fn value(&self, value: &str) -> String {
        let Some((what, to)) = &self.renamed else { return value.to_owned() };
        let words = value.split(' ').map(|word| match (&what.point, word.split_once('.')) {
            (Some(point), Some((body, own))) if *body == what.name && own == point => format!("{body}.{to}"),
            (None, Some((body, own))) if what.table == "body" && body == what.name => format!("{to}.{own}"),
            (None, Some(("joint", joint))) if what.table == "joint" && joint == what.name => format!("joint.{to}"),
            _ => word.to_owned(),
        });
        words.collect::<Vec<_>>().join(" ")
    }
}

/// Findings of the library on the mechanism in some texts after an edit, whose model can be read.
pub fn said(before: &Texts, texts: &Texts) -> LibraryFindings {
    let mut asks_nothing = None;
    let file = texts.read_to_run().or_else(|found| {
        // A study that could not run before is not said to have become one.
        let first = found.sorted().into_iter().next().filter(|_| before.read_to_run().is_ok());
        asks_nothing = first.map(|first| format!("The study cannot run: {}", first.message));
        texts.read().or_else(|_| Texts { model: texts.model.clone(), study: None }.read())
    });
    let Ok(file) = file else { return LibraryFindings { is_complete: false, words: Vec::new() } };
    let mut said = match file.ideal_motion(POSITIONS, &[]) {
        Ok(record) => {
            let singular = record.singular_positions.iter().map(|found| {
                format!("Singular at {:.1}° of the drive: {}", found.drive_angle_rad.to_degrees(), found.words)
            });
            LibraryFindings {
                is_complete: true,
                words: std::iter::once(record.mobility.clone()).chain(singular).collect(),
            }
        }
        Err(_) if file.controlled_drawing(INSTANTS).is_some() => {
            LibraryFindings { is_complete: true, words: vec!["Moved by its actuators".to_owned()] }
        }
        Err(found) => LibraryFindings { is_complete: false, words: vec![why_not(&file, &found)] },
    };
    said.words.extend(asks_nothing);
    said
}

/// Why a mechanism does not move, in words: first how many degrees of freedom are too many or too few.
pub fn why_not(file: &InputFile, found: &Diagnostics) -> String {
    let Some(check) = file.model().mobility_check() else { return found.to_string() };
    let bodies = |names: &[String]| names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    match check {
        Err(MechanismError::TooFewDrives { mobility, drives, undetermined }) => {
            let surplus = counted(mobility.saturating_sub(drives), "degree");
            format!(
                "{surplus} of freedom too many: {} can move although the drives are locked. Join a point, or add a drive.",
                bodies(&undetermined)
            )
        }
        Err(MechanismError::TooManyDrives { mobility: 0, drives: 1 }) => {
            "1 degree of freedom too few: nothing can move. Remove a joint or a link.".to_owned()
        }
        Err(MechanismError::TooManyDrives { mobility, drives }) => {
            let missing = counted(drives.saturating_sub(mobility), "degree");
            format!("{missing} of freedom too few for {}. Remove a joint or a drive.", counted(drives, "drive"))
        }
        _ => first_of(found).in_words(),
    }
}
