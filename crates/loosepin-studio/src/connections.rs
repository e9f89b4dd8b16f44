//! Accepting connections: so many at once, each with a time for the heads of its requests.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;
use tokio::time::sleep;

/// Most connections at once; further ones wait.
const MOST_CONNECTIONS: usize = 64;
/// Time for the head of a request; a connection that asks for nothing is closed after it.
const HEAD_PATIENCE: Duration = Duration::from_secs(5);
/// Rest after the system has refused a connection, for example since too many files are open.
const REST: Duration = Duration::from_millis(50);

/// Serves `router` to all who connect, for ever.
pub async fn accept(listener: TcpListener, router: Router) {
    let seats = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    loop {
        // The semaphore is never closed.
        let Ok(seat) = Arc::clone(&seats).acquire_owned().await else { return };
        let Ok((stream, _)) = listener.accept().await else {
            sleep(REST).await;
            continue;
        };
        let service = TowerToHyperService::new(router.clone());
        tokio::spawn(async move {
            let mut builder = http1::Builder::new();
            builder.timer(TokioTimer::new()).header_read_timeout(HEAD_PATIENCE);
            // Whoever is not understood was told so; nobody else wants to know.
            let _ = builder.serve_connection(TokioIo::new(stream), service).with_upgrades().await;
            drop(seat);
        });
    }
}
