//! Accepting connections, with limits of their number and duration.

use std::pin::pin;
use std::time::Duration;

use axum::Router;
use axum::extract::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio::task::yield_now;
use tokio::time::sleep;

use crate::network::stream::Stream;
use crate::network::times::Timeouts;
use crate::network::visitors::Visitors;

/// Most connections at once, live ones too; where all have shown the token, further ones wait.
const MAX_CONNECTIONS: usize = 64;
/// Largest size of a head, and of a read or write, bytes.
const BUFFER: usize = 64 << 10;
/// Rest after the system has refused a connection, for example since too many files are open.
const REST: Duration = Duration::from_millis(50);

/// Serves `router` to all who connect, for ever. Requests carry their [`Visitor`](crate::network::visitors::Visitor).
pub async fn accept(listener: TcpListener, router: Router, times: Timeouts) {
    let visitors = Visitors::new(MAX_CONNECTIONS, times.stay);
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            sleep(REST).await;
            continue;
        };
        let (place, end) = visitors.admit().await;
        let visitor = place.visitor.clone();
        let stream = Stream::new(stream, place, end, &times);
        tokio::spawn(serve(stream, router.clone(), times, move |request: &mut Request<Incoming>| {
            request.extensions_mut().insert(visitor.clone());
        }));
        // Who came first may show the token before others make it leave.
        yield_now().await;
    }
}

/// Serves the requests of one connection until its time is over.
async fn serve(stream: Stream, router: Router, times: Timeouts, sign: impl Fn(&mut Request<Incoming>)) {
    let routes = TowerToHyperService::new(router);
    let service = service_fn(move |mut request| {
        sign(&mut request);
        routes.call(request)
    });
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(times.head).max_buf_size(BUFFER);
    let mut connection = pin!(builder.serve_connection(TokioIo::new(stream), service).with_upgrades());
    // A client that is not understood has got that answer; there is nobody else to report it to.
    tokio::select! {
        _ = connection.as_mut() => return,
        () = sleep(times.connection) => connection.as_mut().graceful_shutdown(),
    }
    // The stream ends when the time for the last request is over.
    let _ = connection.await;
}
