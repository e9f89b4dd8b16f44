//! The page of the studio: files that its front end was built to, and the styles of figures.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use loosepin::report::figure_styles;

use crate::network::refusal::Refusal;
use crate::network::token::Token;

const INDEX: &str = include_str!("../../assets/index.html");
const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";

/// The page itself, with a fresh number by which the editor may add its styles.
pub fn index(host: &str) -> Response {
    let Ok(nonce) = Token::new() else {
        return Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, "the system gives no random bytes").into_response();
    };
    let nonce = nonce.text();
    let policy = format!(
        "default-src 'none'; script-src 'self'; style-src 'self' 'nonce-{nonce}'; img-src 'self' blob: data:; \
         connect-src 'self' ws://{host}; frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; \
         require-trusted-types-for 'script'; trusted-types loosepin-figure svelte-trusted-html"
    );
    let headers = [("content-type", "text/html; charset=utf-8"), ("content-security-policy", policy.as_str())];
    (headers, INDEX.replace("%NONCE%", nonce)).into_response()
}

/// A file beside the page.
pub fn asset(name: &str) -> Response {
    let (kind, text) = match name {
        "studio.js" => (SCRIPT, include_str!("../../assets/studio.js").to_owned()),
        "editor.js" => (SCRIPT, include_str!("../../assets/editor.js").to_owned()),
        "studio.css" => (STYLE, include_str!("../../assets/studio.css").to_owned()),
        "licences.txt" => ("text/plain; charset=utf-8", include_str!("../../assets/licences.txt").to_owned()),
        "figures.css" => (STYLE, figure_styles()),
        _ => return Refusal::new(StatusCode::NOT_FOUND, "there is no such page").into_response(),
    };
    ([("content-type", kind)], text).into_response()
}
