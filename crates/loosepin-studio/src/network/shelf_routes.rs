//! Requests of the gallery: the templates, what is in the folder, its pictures; copies, deletion and the way back.

use axum::body::Bytes;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Path, Query, State};
use axum::http::StatusCode;
use loosepin::templates::find_template;

use crate::files::blank::{BLANK_MODEL, BLANK_STUDY};
use crate::files::duplicate::{Copied, duplicate as copied};
use crate::files::gallery::{OwnCard, cards, own_card};
use crate::files::listing::listing;
use crate::files::trash;
use crate::network::refusal::{Refusal, json};
use crate::network::requests::{
    DuplicateAnswer, DuplicateRequest, OpenRequest, RestoreAnswer, RestoreRequest, TemplateTexts, TrashRequest,
};
use crate::network::routes::{RouteResult, in_background, no_template, parsed};
use crate::network::time_limit::{LONGEST_LOOK, within};
use crate::studio::Studio;

pub async fn templates(State(studio): State<Studio>) -> RouteResult {
    let folder = studio.folder.clone();
    let cards = in_background(move || Ok(cards(&folder))).await?;
    Ok(json(&cards))
}

/// The texts of a template, to be looked at without a file.
pub async fn template(Path(name): Path<String>) -> RouteResult {
    let template = find_template(&name).ok_or_else(no_template)?;
    Ok(json(&TemplateTexts { model: template.model, study: template.study }))
}

/// The texts of a mechanism of which nothing is drawn yet.
pub async fn blank() -> RouteResult {
    Ok(json(&TemplateTexts { model: BLANK_MODEL, study: BLANK_STUDY }))
}

pub async fn folder(State(studio): State<Studio>) -> RouteResult {
    let folder = studio.folder.clone();
    let listing = in_background(move || Ok(listing(&folder))).await?;
    Ok(json(&listing))
}

/// The small picture of a model or study.
pub async fn card(State(studio): State<Studio>, query: Result<Query<OpenRequest>, QueryRejection>) -> RouteResult {
    let Query(OpenRequest { path }) = query.map_err(|_| Refusal::bad("give the file: /api/card?path=model.toml"))?;
    let folder = studio.folder.clone();
    let card = in_background(move || {
        let seen = within(LONGEST_LOOK, || {}, |stop| own_card(&folder, &path, stop));
        seen.unwrap_or_else(|| {
            let error = Some(format!("its analysis took longer than {} s", LONGEST_LOOK.as_secs()));
            Ok(OwnCard { error, ..OwnCard::default() })
        })
    });
    Ok(json(&card.await?))
}

/// Moves a model, a study with its model, or a result into the trash.
pub async fn trash(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let TrashRequest { path } = parsed(&body)?;
    let trashed = in_background(move || {
        let paths = trash::paths_of(&studio.folder, &path)?;
        if let Some(open) = paths.iter().find(|path| studio.jobs.is_open(path)) {
            return Err(Refusal::new(
                StatusCode::CONFLICT,
                format!("a run of '{open}' is not finished; nothing was deleted"),
            )
            .with_hint("stop the run, or wait for its end"));
        }
        trash::trash(&studio.folder, paths)
    });
    Ok(json(&trashed.await?))
}

/// Moves what was deleted back.
pub async fn restore(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let RestoreRequest { entry, paths } = parsed(&body)?;
    let folder = studio.folder.clone();
    let restored = in_background(move || {
        trash::restore(&folder, &entry, &paths)?;
        Ok(paths.len())
    });
    Ok(json(&RestoreAnswer { restored: restored.await? }))
}

/// Copies a model, or a study with its model, beside it.
pub async fn duplicate(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let DuplicateRequest { path } = parsed(&body)?;
    let folder = studio.folder.clone();
    let Copied { model, study } = in_background(move || copied(&folder, &path)).await?;
    Ok(json(&DuplicateAnswer { model, study }))
}
