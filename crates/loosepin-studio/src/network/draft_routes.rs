//! Requests of the texts that are not saved yet.

use std::time::{SystemTime, UNIX_EPOCH};

use axum::body::Bytes;
use axum::extract::State;

use crate::files::drafts::{self, Draft, Taken};
use crate::network::refusal::json;
use crate::network::requests::{KeepDraftRequest, TakeDraftAnswer, TakeDraftRequest};
use crate::network::routes::{RouteResult, in_background, parsed};
use crate::studio::Studio;

/// Keeps the unsaved texts of a tab; without any, those that were kept go.
pub async fn keep(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let KeepDraftRequest { tab, path, model, study } = parsed(&body)?;
    let at = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |since| since.as_millis() as f64);
    in_background(move || drafts::keep(&studio.folder, &tab, &Draft { at, path, model, study })).await?;
    Ok(json(&()))
}

/// The unsaved texts of a path, where they are of this tab, or of none that is there.
pub async fn take(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let TakeDraftRequest { tab, path } = parsed(&body)?;
    let tabs = studio.tabs;
    let take = move || drafts::take(&studio.folder, &tab, &path, &|other| tabs.is_live(other));
    let Taken { draft, is_elsewhere } = in_background(take).await?;
    Ok(json(&TakeDraftAnswer { draft, is_elsewhere }))
}
