//! Runs that were made outlive the study that failed after them.

use std::path::Path;
use std::sync::Arc;
use std::time::SystemTime;

use loosepin::files::{FolderLock, LockKind};
use loosepin::model::Model;
use loosepin::results::{Claim, Destination, InputsHasher, ResultKind};
use loosepin::store::{InputsKey, RunStore, StoreError, StoredRun};
use loosepin::study::result::StudyResult;
use loosepin::study::{ClaimOutcome, Study, StudyError, begin_in_folder, conclude, store_identity};
use loosepin::templates::find_template;

/// A study with the store of its runs in a folder.
struct Failing {
    study: Study,
    claim: Claim,
}

impl Failing {
    fn new(folder: &Path) -> Self {
        let template = find_template("four-bar").expect("the template is there");
        let model =
            Model::from_text("model.toml", template.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let study =
            Study::from_text("study.toml", template.study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let claim = Claim {
            kind: ResultKind::Study,
            name: study.name.clone(),
            inputs: InputsHasher::new(ResultKind::Study).add("study", template.study).finish(),
            destination: Destination::Folder(folder.to_owned()),
            with_force: false,
        };
        Self { study, claim }
    }

    fn store(&self, lock: &Arc<FolderLock>) -> Result<RunStore, StoreError> {
        RunStore::open(lock, &store_identity(&self.claim.inputs))
    }

    /// Makes so many runs and fails.
    fn fail_after(&self, runs: u64) {
        let begun = begin_in_folder(&self.claim, |lock| self.store(lock));
        let Ok(ClaimOutcome::Open(folder, store)) = begun else { panic!("the folder is new") };
        for place in 0..runs {
            store.keep(0, place, StoredRun { inputs: InputsKey::of(&place.to_le_bytes()), outcome: Ok(vec![1.0]) });
        }
        let error = StudyError::Loosened { path: "c".to_owned(), value_si: 1.0, reason: "impossible".to_owned() };
        let page = |_: &StudyResult| String::new();
        let concluded = conclude(&self.study, folder, store, Err(error), &page, (SystemTime::now(), 1));
        assert!(concluded.is_err_and(|diagnostics| diagnostics.to_string().contains("impossible")));
    }
}

#[test]
fn runs_are_kept_where_a_study_fails_after_them() {
    let root = tempfile::tempdir().expect("a folder");
    let folder = root.path().join("some");
    let failing = Failing::new(&folder);
    failing.fail_after(3);
    let lock = FolderLock::take(&folder, LockKind::Result, "test").expect("nobody holds it");
    assert_eq!(failing.store(&Arc::new(lock)).expect("it is there").runs_at_start(), 3);
}

#[test]
fn nothing_is_left_of_a_study_that_fails_before_any_run() {
    let root = tempfile::tempdir().expect("a folder");
    let folder = root.path().join("none");
    Failing::new(&folder).fail_after(0);
    assert!(!folder.exists());
}
