//! What is kept beside the rows of a table.

use std::any::Any;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// One value, of any type, that is made when it is first asked for. A copy begins without: rows that are added to it are not those that are
/// added to the original.
#[derive(Default)]
pub(super) struct Beside(OnceLock<Arc<dyn Any + Send + Sync>>);

impl Beside {
    /// What is kept; a new one where nothing is, or where it is of another type.
    pub fn get<K: Any + Send + Sync + Default>(&self) -> Arc<K> {
        let kept = self.0.get_or_init(|| Arc::new(K::default()));
        kept.clone().downcast().unwrap_or_default()
    }
}

impl Clone for Beside {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl fmt::Debug for Beside {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Beside")
    }
}
