//! Which finished result belongs to which study of the folder, and whether the texts have changed since. Texts are compared, not times.

use std::collections::HashMap;

use loosepin::result::repeat::{InputRole, Repeat};
use loosepin::results::ResultKind;

use crate::files::folder::{Folder, tag};
use crate::files::listed::{KnownTexts, NewestResult, ReadFile, ReadResult, ResultTexts, TextState};
use crate::files::record_head::entry_of;
use crate::messages::Document;
use crate::view::texts::tables_of;

/// Most bytes of a record that are read for its texts, and of all records for one listing; what then is not known yet comes with the next one.
const MAX_RECORD_BYTES: u64 = 16 << 20;
const MAX_RECORDS_BYTES: u64 = 48 << 20;
/// Most results of which the texts are remembered.
const MAX_KNOWN: usize = 4096;

impl ResultTexts {
    fn of(repeat: &Repeat) -> Option<Self> {
        let text = |role| repeat.file_of(role).map(|file| tag(&file.text));
        let tables = repeat.files.iter().filter(|file| file.role == InputRole::Table);
        Some(Self {
            model: text(InputRole::Model)?,
            study: text(InputRole::Study)?,
            tables: tables.map(|file| tag(&file.text)).collect(),
        })
    }
}

/// Gives each study the newest result of its texts as they are, or else the newest result of its name. Both lists begin with the newest.
///
/// Results do not say which file they were computed from. One of other texts belongs to a study if that is the only one of its name.
pub fn assign(folder: &Folder, files: &mut [ReadFile], results: &mut [ReadResult], known: &mut KnownTexts) {
    if known.len() > MAX_KNOWN {
        known.clear();
    }
    let mut left_bytes = MAX_RECORDS_BYTES;
    let mut studies: HashMap<String, Vec<usize>> = HashMap::new();
    for (place, file) in files.iter().enumerate().filter(|(_, file)| file.listed.kind == Document::Study) {
        studies.entry(file.listed.title.clone()).or_default().push(place);
    }
    let mut others: HashMap<usize, NewestResult> = HashMap::new();
    for result in results.iter_mut().filter(|result| result.listed.kind == ResultKind::Study) {
        let Some(places) = studies.get(&result.listed.title) else { continue };
        if !known.contains_key(&result.inputs) && left_bytes > 0 {
            let repeat = entry_of(folder, &result.listed.path, "repeat", MAX_RECORD_BYTES, &mut left_bytes);
            known.insert(result.inputs.clone(), repeat.and_then(|repeat| ResultTexts::of(&repeat)));
        }
        let texts = known.get(&result.inputs).and_then(Option::as_ref);
        let same: Vec<usize> = match texts {
            Some(texts) => places.iter().copied().filter(|place| is_of(folder, files, *place, texts)).collect(),
            None => Vec::new(),
        };
        let state = match texts {
            None => TextState::Unknown,
            Some(_) if same.is_empty() => TextState::Changed,
            Some(_) => TextState::Same,
        };
        result.listed.texts = Some(state);
        let newest = NewestResult {
            path: result.listed.path.clone(),
            verdict: result.listed.verdict,
            at_ms: result.listed.at_ms,
            texts: state,
        };
        for place in &same {
            files[*place].listed.result.get_or_insert_with(|| newest.clone());
        }
        if let ([place], true) = (places.as_slice(), same.is_empty()) {
            others.entry(*place).or_insert(newest);
        }
    }
    for (place, newest) in others {
        files[place].listed.result.get_or_insert(newest);
    }
}

/// Whether the texts of a study, its model and its tables are these.
fn is_of(folder: &Folder, files: &[ReadFile], place: usize, texts: &ResultTexts) -> bool {
    let study = &files[place];
    let Some(model_path) = &study.listed.model else { return false };
    if study.tag != texts.study {
        return false;
    }
    let listed = files.iter().find(|file| file.listed.path == *model_path).map(|file| file.tag.clone());
    let model = listed.or_else(|| folder.read(model_path).ok().map(|read| read.tag));
    if model.as_ref() != Some(&texts.model) {
        return false;
    }
    if texts.tables.is_empty() {
        return true;
    }
    let tables: Vec<String> =
        [&study.listed.path, model_path].into_iter().flat_map(|path| tables_of(folder, path)).collect();
    let tags: Vec<String> = tables.iter().map(|text| tag(text)).collect();
    texts.tables.iter().all(|table| tags.contains(table))
}
