//! Who may ask. A page of another origin, and a name that somebody else's name server points to this machine, may not.

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use tokio::time::timeout;

use crate::network::refusal::Refusal;
use crate::network::visitors::Visitor;
use crate::studio::Studio;

/// Names of this machine to itself.
const LOOPBACK: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// Addresses below this one are asked with the token.
const INTERFACE: &str = "/api/";

/// Refuses requests of other hosts and origins, and of the interface without the token; puts the headers of safety on every answer. The
/// body of a request is read after that, and only so many at once.
pub async fn guard(State(studio): State<Studio>, request: Request, next: Next) -> Response {
    let mut response = match admitted(&studio, &request) {
        Ok(()) => match timeout(studio.times.request, answer(&studio, request, next)).await {
            Ok(response) => response,
            Err(_) => {
                let words = format!("this request took longer than {} s", studio.times.request.as_secs_f64());
                Refusal::new(StatusCode::REQUEST_TIMEOUT, words).into_response()
            }
        },
        Err(refusal) => refusal.into_response(),
    };
    for (name, value) in [
        ("x-content-type-options", "nosniff"),
        ("referrer-policy", "no-referrer"),
        ("cross-origin-opener-policy", "same-origin"),
        ("cross-origin-resource-policy", "same-origin"),
        ("cache-control", "no-store"),
    ] {
        response.headers_mut().insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    response
}

/// The answer to a request that is admitted.
async fn answer(studio: &Studio, request: Request, next: Next) -> Response {
    let visitor = request.extensions().get::<Visitor>().cloned().unwrap_or_default();
    let path = request.uri().path();
    let (is_interface, is_report) = (path.starts_with(INTERFACE), path.starts_with("/view/"));
    let has_body = is_interface && !matches!(*request.method(), Method::GET | Method::HEAD);
    if is_interface {
        visitor.show_token();
    }
    // The semaphore is never closed.
    let _body = if has_body { studio.bodies.acquire().await.ok() } else { None };
    let response = next.run(request).await;
    if is_report && response.status().is_success() {
        // The address of a report is given for the token.
        visitor.show_token();
    }
    response
}

fn admitted(studio: &Studio, request: &Request) -> Result<(), Refusal> {
    let host = check_host(request.headers())?;
    let path = request.uri().path();
    check_origin(request.headers(), host, path == "/live")?;
    if path.starts_with(INTERFACE) {
        let given = text(request.headers(), "authorization").and_then(|value| value.strip_prefix("Bearer "));
        if !given.is_some_and(|token| studio.token.is(token)) {
            return Err(Refusal::new(StatusCode::UNAUTHORIZED, "the token of the studio is missing or wrong")
                .with_hint("open the address that `loosepin serve` printed"));
        }
    }
    Ok(())
}

fn text<'a>(headers: &'a HeaderMap, name: &str) -> Option<&'a str> {
    headers.get(name).and_then(|value| value.to_str().ok())
}

/// The host that is asked, which must be this machine by one of its own names.
fn check_host(headers: &HeaderMap) -> Result<&str, Refusal> {
    let foreign = || Refusal::new(StatusCode::FORBIDDEN, "the studio responds only to 127.0.0.1 and localhost");
    if headers.get_all("host").iter().count() != 1 {
        return Err(foreign());
    }
    let host = text(headers, "host").ok_or_else(foreign)?;
    let is_port = |port: &str| port.parse::<u16>().is_ok() && port.bytes().all(|byte| byte.is_ascii_digit());
    let is_own = LOOPBACK.iter().any(|name| {
        let rest = host.strip_prefix(name);
        rest.is_some_and(|rest| rest.is_empty() || rest.strip_prefix(':').is_some_and(is_port))
    });
    if is_own { Ok(host) } else { Err(foreign()) }
}

/// The page that asks, where it says so, must be of this server; a live connection must say so.
fn check_origin(headers: &HeaderMap, host: &str, is_live: bool) -> Result<(), Refusal> {
    let foreign = || Refusal::new(StatusCode::FORBIDDEN, "the studio responds only to its own page");
    if headers.get_all("origin").iter().count() > 1 {
        return Err(foreign());
    }
    match headers.get("origin").map(|origin| origin.to_str()) {
        None if is_live => Err(foreign()),
        None => Ok(()),
        Some(Ok(origin)) if origin.strip_prefix("http://") == Some(host) => Ok(()),
        Some(_) => Err(foreign()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(pairs: &[(&'static str, &str)]) -> HeaderMap {
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            headers.append(*name, HeaderValue::from_str(value).unwrap());
        }
        headers
    }

    #[test]
    fn foreign_hosts_are_refused() {
        for host in ["127.0.0.1", "127.0.0.1:80", "localhost:65535", "[::1]:1"] {
            assert!(check_host(&headers(&[("host", host)])).is_ok(), "{host}");
        }
        for host in [
            "evil.example",
            "127.0.0.1.evil.example",
            "localhost.",
            "127.0.0.1:",
            "127.0.0.1:+80",
            "127.0.0.1:99999",
            "user@127.0.0.1",
            "127.0.0.1/",
            "",
        ] {
            assert!(check_host(&headers(&[("host", host)])).is_err(), "{host}");
        }
        assert!(check_host(&headers(&[])).is_err());
        assert!(check_host(&headers(&[("host", "localhost"), ("host", "localhost")])).is_err());
    }

    #[test]
    fn foreign_origins_are_refused() {
        let ours = "127.0.0.1:4000";
        let is_admitted = |origin: &str, is_live| check_origin(&headers(&[("origin", origin)]), ours, is_live).is_ok();
        assert!(is_admitted("http://127.0.0.1:4000", true));
        for origin in [
            "http://127.0.0.1:40001",
            "http://127.0.0.1:4000.evil.example",
            "https://127.0.0.1:4000",
            "http://localhost:4000",
            "null",
            "",
        ] {
            assert!(!is_admitted(origin, false), "{origin}");
        }
        assert!(check_origin(&headers(&[]), ours, false).is_ok());
        assert!(check_origin(&headers(&[]), ours, true).is_err());
    }
}
