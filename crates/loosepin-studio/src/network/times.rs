//! How long the studio waits for a client.

use std::time::Duration;

/// Times after which the studio waits no longer for a client.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Timeouts {
    /// For the head of a request, and between two requests of a connection. Default: 5 s.
    pub head: Duration,
    /// For the body of a request and the work on its answer. Default: 10 s.
    pub request: Duration,
    /// While an answer is written and the client takes no byte of it. Default: 10 s.
    pub write: Duration,
    /// For a connection in total, unless it is a live one that has shown the token: then no further request is read. Default: 60 s.
    pub connection: Duration,
    /// For the request that is served at that time; then the connection is closed. Default: 5 s.
    pub last_request: Duration,
    /// For the first message of a live connection, which holds the token. Default: 2 s.
    pub hello: Duration,
    /// A connection without the token is open for so long before it may have to make room for a new one. Default: 50 ms.
    pub stay: Duration,
}

impl Default for Timeouts {
    fn default() -> Self {
        Self {
            head: Duration::from_secs(5),
            request: Duration::from_secs(10),
            write: Duration::from_secs(10),
            connection: Duration::from_secs(60),
            last_request: Duration::from_secs(5),
            hello: Duration::from_secs(2),
            stay: Duration::from_millis(50),
        }
    }
}
