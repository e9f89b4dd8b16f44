//! Requests on finished results: two of them compared, the actions on one, its values taken into the texts of the page.

use std::path::Path;

use axum::body::Bytes;
use axum::extract::State;
use axum::response::Response;
use loosepin::report::compare_studies;

use crate::files::adopt::adopted;
use crate::files::stored::{doings, stored_study};
use crate::messages::Look;
use crate::network::refusal::{Refusal, json};
use crate::network::requests::{AdoptAnswer, AdoptRequest, CompareAnswer, CompareRequest, ResultRequest};
use crate::network::routes::{RouteResult, in_background, parsed};
use crate::studio::Studio;
use crate::view::texts::Texts;

/// Two studies beside each other.
pub async fn compare(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let CompareRequest { before, after } = parsed(&body)?;
    let folder = studio.folder.clone();
    let comparison = in_background(move || {
        if Path::new(&before).components().eq(Path::new(&after).components()) {
            return Err(Refusal::bad("both are the same result").with_hint("choose another one to compare it with"));
        }
        Ok(compare_studies(&stored_study(&folder, &before)?, &stored_study(&folder, &after)?))
    });
    Ok(json(&CompareAnswer(comparison.await?)))
}

/// Available actions on a result.
pub async fn result(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let ResultRequest { path } = parsed(&body)?;
    let folder = studio.folder.clone();
    Ok(json(&in_background(move || doings(&folder, &path)).await?))
}

/// Values of a result in the texts of the page. What these texts do not take is no fault of the page: a refusal is an answer.
pub async fn adopt(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let AdoptRequest { model, study, path, place } = parsed(&body)?;
    let folder = studio.folder.clone();
    let said = in_background(move || {
        let texts = Texts::sent(&folder, &Look::of(model, study, 0));
        Ok(match adopted(&folder, &texts, &path, place) {
            Ok(adopted) => AdoptAnswer { adopted: Some(adopted), refusal: None },
            Err(refusal) => AdoptAnswer { adopted: None, refusal: Some(refusal.into()) },
        })
    });
    let said: Result<Response, Refusal> = said.await.map(|said| json(&said));
    said
}
