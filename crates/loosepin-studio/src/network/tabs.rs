//! The tabs that have a live page: what they have not saved is theirs.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Names of the tabs; one that connects anew may be there twice for a moment.
#[derive(Default)]
pub struct Tabs(Mutex<Vec<String>>);

impl Tabs {
    fn names(&self) -> MutexGuard<'_, Vec<String>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A tab is live, as long as what is returned.
    pub fn enter(self: &Arc<Self>, name: String) -> LiveTab {
        self.names().push(name.clone());
        LiveTab { tabs: Arc::clone(self), name }
    }

    /// Whether a tab is live.
    pub fn is_live(&self, name: &str) -> bool {
        self.names().iter().any(|own| own == name)
    }
}

/// A tab with a live page.
pub struct LiveTab {
    tabs: Arc<Tabs>,
    name: String,
}

impl Drop for LiveTab {
    fn drop(&mut self) {
        let mut names = self.tabs.names();
        if let Some(place) = names.iter().position(|own| *own == self.name) {
            names.swap_remove(place);
        }
    }
}
