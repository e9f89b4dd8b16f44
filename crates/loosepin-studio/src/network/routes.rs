//! Plain requests: files, texts, results.

use axum::body::Bytes;
use axum::extract::{Path, Query, State};
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Response};
use loosepin::VERSION;
use loosepin::diagnostics::{Code, Problem};
use loosepin::import::{ImportError, ImportOptions, import_dxf};
use loosepin::results::REPORT_FILE;
use loosepin::templates::find_template;
use serde::de::DeserializeOwned;

use crate::edit;
use crate::files::folder::{MAX_TEXT, StoredText, tag};
use crate::messages::Look;
use crate::network::page;
use crate::network::refusal::{Refusal, json};
use crate::network::requests::{
    ExplainAnswer, HelloAnswer, ImportAnswer, ImportRequest, Limits, NewAnswer, NewRequest, OpenAnswer, OpenRequest,
    OpenedText, RestructureAnswer, RestructureRequest, SaveAnswer, SaveRequest, SetUncertaintyAnswer,
    SetUncertaintyRequest, ViewAnswer, ViewRequest,
};
use crate::studio::Studio;
use crate::view::texts::{Texts, model_beside, plain};

/// What a report may do in its frame: show itself and save figures. It has an origin of its own, so that it cannot ask the studio.
const REPORT_POLICY: &str = "sandbox allow-scripts allow-downloads; default-src 'none'; style-src 'unsafe-inline'; \
    script-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; frame-ancestors 'self'";
/// Ends and centres of an imported drawing that are one, m: as the command takes them.
const SAME_PLACE_M: f64 = 1e-5;
/// Largest page of a result that is shown, bytes.
const MAX_REPORT: usize = 64 << 20;

/// Result of a request.
pub type RouteResult = Result<Response, Refusal>;

pub async fn index(headers: HeaderMap) -> Response {
    // The guard has seen that there is one, and that it is this machine.
    page::index(headers.get("host").and_then(|host| host.to_str().ok()).unwrap_or("127.0.0.1"))
}

pub async fn asset(Path(name): Path<String>) -> Response {
    page::asset(&name)
}

pub async fn hello(State(studio): State<Studio>) -> Response {
    let folder = studio.folder.root().display().to_string();
    json(&HelloAnswer { version: VERSION, folder, limits: Limits { text_bytes: MAX_TEXT } })
}

pub async fn open(
    State(studio): State<Studio>,
    query: Result<Query<OpenRequest>, axum::extract::rejection::QueryRejection>,
) -> RouteResult {
    let Query(OpenRequest { path }) = query.map_err(|_| Refusal::bad("give the file: /api/open?path=model.toml"))?;
    let opened = |path: String, StoredText { text, tag, is_saved_here }| OpenedText { path, text, tag, is_saved_here };
    let both = in_background(move || {
        let first = studio.folder.read(&path)?;
        Ok(match model_beside(&path, &first.text) {
            None => OpenAnswer { model: Some(opened(path, first)), study: None },
            Some(model_path) => {
                let model_path = plain(&model_path);
                let model = studio.folder.read(&model_path).ok().map(|found| opened(model_path, found));
                OpenAnswer { model, study: Some(opened(path, first)) }
            }
        })
    });
    Ok(json(&both.await?))
}

pub async fn save(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let SaveRequest { path, text, tag } = parsed(&body)?;
    let tag = in_background(move || studio.folder.write(&path, &text, tag.as_deref())).await?;
    Ok(json(&SaveAnswer { tag }))
}

/// How well a number is known, written into the texts of the page.
pub async fn set_uncertainty(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let SetUncertaintyRequest { model, study, path, text } = parsed(&body)?;
    let folder = studio.folder.clone();
    let changes = in_background(move || {
        let texts = Texts::sent(&folder, &Look::of(model, study, 0));
        Ok(match edit::set_uncertainty(&folder, &texts, &path, &text) {
            Ok(changes) => SetUncertaintyAnswer { changes, refusal: None },
            Err(refusal) => SetUncertaintyAnswer { changes: Vec::new(), refusal: Some(refusal.into()) },
        })
    });
    Ok(json(&changes.await?))
}

/// Links, joints and bodies that come, go or get other names, in the texts of the page.
pub async fn restructure(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let RestructureRequest { model, study, edit, poses } = parsed(&body)?;
    let folder = studio.folder.clone();
    let done = in_background(move || {
        let texts = Texts::sent(&folder, &Look::of(model, study, 0));
        Ok(match edit::restructured(&folder, &texts, &edit, &poses) {
            Ok(done) => RestructureAnswer { done: Some(done), refusal: None },
            Err(refusal) => RestructureAnswer { done: None, refusal: Some(refusal.into()) },
        })
    });
    Ok(json(&done.await?))
}

pub async fn new(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let NewRequest { template, model, study, folder } = parsed(&body)?;
    let (model, study) = match (template, model, study) {
        (Some(template), None, None) => {
            let template = find_template(&template).ok_or_else(no_template)?;
            (template.model.to_owned(), template.study.to_owned())
        }
        (None, Some(model), Some(study)) => (model, study),
        _ => {
            return Err(Refusal::bad("a new folder is made of a template, or of a model and a study")
                .with_hint("give either template, or model and study"));
        }
    };
    let written = NewAnswer {
        model: format!("{folder}/model.toml"),
        study: format!("{folder}/study.toml"),
        model_tag: tag(&model),
        study_tag: tag(&study),
    };
    in_background(move || studio.folder.write_new_folder(&folder, &[("model.toml", &model), ("study.toml", &study)]))
        .await?;
    Ok(json(&written))
}

/// Refusal of a template that is none.
pub fn no_template() -> Refusal {
    Refusal::new(StatusCode::NOT_FOUND, "there is no such template").with_hint("GET /api/templates lists them")
}

/// A drawing in the DXF format becomes the skeleton of a model, in a new folder.
pub async fn import(
    State(studio): State<Studio>,
    query: Result<Query<ImportRequest>, axum::extract::rejection::QueryRejection>,
    drawing: Bytes,
) -> RouteResult {
    let Query(ImportRequest { folder: name, title, unit }) =
        query.map_err(|_| Refusal::bad("give the folder: /api/import?folder=press&title=press"))?;
    let folder = studio.folder.clone();
    let said = in_background(move || {
        let options = ImportOptions { unit: unit.filter(|unit| !unit.is_empty()), tolerance_m: SAME_PLACE_M };
        let imported = import_dxf(&title, &drawing, &options).map_err(|error| {
            // The hint of the command names its options.
            let hint = match error {
                ImportError::NoUnit | ImportError::ForeignUnit { .. } => {
                    Some("choose the unit beside the button".to_owned())
                }
                _ => error.hint(),
            };
            Refusal { hint, ..Refusal::bad(error.to_string()) }
        })?;
        folder.write_new_folder(&name, &[("model.toml", &imported.model)])?;
        Ok(ImportAnswer { model: format!("{name}/model.toml"), notes: imported.notes })
    });
    Ok(json(&said.await?))
}

pub async fn explain(Path(code): Path<String>) -> RouteResult {
    let code: Code = code.parse().map_err(|_| Refusal::new(StatusCode::NOT_FOUND, "there is no such error code"))?;
    let entry = code.entry();
    Ok(json(&ExplainAnswer { code: entry.text, title: entry.title, text: entry.explanation }))
}

pub async fn view(State(studio): State<Studio>, body: Bytes) -> RouteResult {
    let ViewRequest { path } = parsed(&body)?;
    let report = format!("{}/{REPORT_FILE}", path.trim_end_matches('/'));
    studio.folder.info(&report)?;
    let ticket = studio
        .tickets
        .issue(report)
        .map_err(|error| Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))?;
    Ok(json(&ViewAnswer { address: format!("/view/{ticket}") }))
}

pub async fn report(State(studio): State<Studio>, Path(ticket): Path<String>) -> RouteResult {
    let gone = || Refusal::new(StatusCode::NOT_FOUND, "this address of a report was already used, or is too old");
    let path = studio.tickets.redeem(&ticket).ok_or_else(gone)?;
    let page = in_background(move || studio.folder.bytes(&path, MAX_REPORT)).await?;
    let headers = [("content-type", "text/html; charset=utf-8"), ("content-security-policy", REPORT_POLICY)];
    Ok((headers, page).into_response())
}

pub async fn missing() -> Refusal {
    Refusal::new(StatusCode::NOT_FOUND, "the studio has no such address")
}

/// Parses a body as a request.
///
/// # Errors
/// It is something else.
pub fn parsed<T: DeserializeOwned>(body: &Bytes) -> Result<T, Refusal> {
    serde_json::from_slice(body).map_err(|error| Refusal::bad(format!("this request is not valid: {error}")))
}

/// Runs long work in the background, without blocking the other connections.
///
/// # Errors
/// That of the work.
pub async fn in_background<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Refusal> + Send + 'static,
) -> Result<T, Refusal> {
    let failed = |_| Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, "loosepin failed with an internal error");
    tokio::task::spawn_blocking(work).await.map_err(failed)?
}
