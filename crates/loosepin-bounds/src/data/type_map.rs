//! Data stored together with the rows of a table.

use std::any::{Any, TypeId};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// A value of each type, made when it is first asked for. A copy begins without: rows that are added to it are not those that are added to
/// the original.
#[derive(Default)]
pub(super) struct TypeMap(Mutex<BTreeMap<TypeId, Arc<dyn Any + Send + Sync>>>);

impl TypeMap {
    /// The stored value of this type; a new one if there is none.
    pub fn get<K: Any + Send + Sync + Default>(&self) -> Arc<K> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let own = kept.entry(TypeId::of::<K>()).or_insert_with(|| Arc::new(K::default()));
        // It is of the type that it is kept by.
        Arc::clone(own).downcast().unwrap_or_default()
    }
}

impl Clone for TypeMap {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl fmt::Debug for TypeMap {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Beside")
    }
}
