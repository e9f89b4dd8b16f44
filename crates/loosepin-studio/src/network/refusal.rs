//! Why a request is not served.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use serde::Serialize;

/// A request that is not served: the status, what is wrong, and the way out.
#[derive(Debug)]
pub struct Refusal {
    /// Status of the answer.
    pub status: StatusCode,
    /// The problem.
    pub message: String,
    /// The way out, where one is known.
    pub hint: Option<String>,
}

/// Why nothing comes of a request, or of what somebody typed or drew.
#[derive(Debug, Serialize)]
pub struct Refused {
    /// What is wrong.
    message: String,
    /// The way out, where one is known.
    hint: Option<String>,
}

impl From<Refusal> for Refused {
    fn from(Refusal { message, hint, .. }: Refusal) -> Self {
        Self { message, hint }
    }
}

impl Refusal {
    /// Without a way out.
    pub fn new(status: StatusCode, message: impl Into<String>) -> Self {
        Self { status, message: message.into(), hint: None }
    }

    /// With a way out.
    pub fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// What is wrong, with the way out.
    pub fn in_words(&self) -> String {
        self.hint.as_ref().map_or(self.message.clone(), |hint| format!("{}: {hint}", self.message))
    }

    /// Refusal of a malformed request.
    pub fn bad(message: impl Into<String>) -> Self {
        Self::new(StatusCode::BAD_REQUEST, message)
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let status = self.status;
        (status, json(&Refused::from(self))).into_response()
    }
}

/// A record as an answer.
pub fn json<T: Serialize>(record: &T) -> Response {
    match serde_json::to_vec(record) {
        Ok(bytes) => ([("content-type", "application/json")], bytes).into_response(),
        // Records of the studio have a form in JSON; numbers that are not finite are written as null.
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response(),
    }
}
