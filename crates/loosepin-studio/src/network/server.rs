//! The server: where it listens, what it shares among connections, how it ends.

use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use axum::Router;
use axum::extract::DefaultBodyLimit;
use axum::middleware::from_fn_with_state;
use axum::routing::{get, post, put};
use loosepin::diagnostics::{Code, problems};
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use crate::files::folder::{Folder, MAX_TEXT};
use crate::jobs::queue::Jobs;
use crate::network::connections::accept;
use crate::network::draft_routes;
use crate::network::guard::guard;
use crate::network::result_routes;
use crate::network::routes;
use crate::network::shelf_routes;
use crate::network::socket;
use crate::network::times::Timeouts;
use crate::network::token::Token;
use crate::studio::Studio;

/// Largest body of a request: a text, each letter escaped.
const MAX_BODY: usize = 4 * MAX_TEXT;
/// Most requests whose bodies are read at once: they hold 32 MiB together.
const MAX_BODIES: usize = 8;
/// Most live connections.
const MAX_SEATS: usize = 8;
/// How often it is looked whether the server is to end.
const TICK: Duration = Duration::from_millis(100);

problems! {
    /// Why the studio cannot be served.
    #[derive(Debug)]
    pub enum StudioError {
        Folder { folder: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot serve {}: {source}", folder.display()),
            hint("give an existing folder, for example: loosepin serve .");
        Port { port: u16, source: io::Error } => Code::FolderNotUsable,
            says("cannot listen on port {port} of this machine: {source}"),
            hint("omit --port to use a free port");
        Threads { source: io::Error } => Code::NoThreads,
            says("the system refused to start the threads of the studio"),
            hint("raise the limits of memory (ulimit -v, ulimit -d) or of processes (ulimit -u)");
        System { source: io::Error } => Code::FolderNotUsable,
            says("the system does not permit the studio to run: {source}");
    }
}

/// A server that is about to serve.
pub struct Serving<'s> {
    /// The address to open, with the token in its fragment.
    pub address: String,
    /// The folder.
    pub folder: &'s Path,
}

/// Serves the studio of `folder` on this machine alone until `stop` is set; `port` 0 takes a free one, and without a `token` a new one is
/// made. `ready` is given the address.
///
/// # Errors
/// The folder is not there; the port is in use.
pub fn serve(
    folder: &Path,
    port: u16,
    token: Option<Token>,
    stop: &AtomicBool,
    ready: impl FnOnce(&Serving<'_>),
) -> Result<(), StudioError> {
    serve_within(&Timeouts::default(), folder, (port, token), stop, ready)
}

/// As [`serve`], waiting for clients as long as `times` says.
///
/// # Errors
/// As [`serve`].
pub fn serve_within(
    times: &Timeouts,
    folder: &Path,
    (port, token): (u16, Option<Token>),
    stop: &AtomicBool,
    ready: impl FnOnce(&Serving<'_>),
) -> Result<(), StudioError> {
    let system = |source| StudioError::System { source };
    let served = Folder::new(folder).map_err(|source| StudioError::Folder { folder: folder.to_owned(), source })?;
    let new_token = || Token::new().map_err(|error| system(io::Error::other(error.to_string())));
    let token = token.map_or_else(new_token, Ok)?;
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(system)?;
    let (jobs, workers) = Jobs::begin(&served).map_err(|source| StudioError::Threads { source })?;
    let studio = Studio {
        token,
        folder: served,
        jobs: Arc::clone(&jobs),
        tabs: Arc::default(),
        tickets: Arc::default(),
        seats: Arc::new(Semaphore::new(MAX_SEATS)),
        bodies: Arc::new(Semaphore::new(MAX_BODIES)),
        times: *times,
    };
    let outcome = runtime.block_on(async {
        let wanted = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
        let listener = TcpListener::bind(wanted).await.map_err(|source| StudioError::Port { port, source })?;
        let bound = listener.local_addr().map_err(system)?;
        let address = format!("http://{bound}/#token={}", studio.token.text());
        ready(&Serving { address, folder: studio.folder.root() });
        tokio::select! {
            () = accept(listener, router(studio.clone()), *times) => {}
            () = stopped(stop) => {}
        }
        Ok(())
    });
    jobs.close();
    // A study that runs keeps its runs before the program ends.
    for worker in workers {
        let _ = worker.join();
    }
    runtime.shutdown_background();
    outcome
}

async fn stopped(stop: &AtomicBool) {
    while !stop.load(Ordering::Relaxed) {
        tokio::time::sleep(TICK).await;
    }
}

fn router(studio: Studio) -> Router {
    Router::new()
        .route("/", get(routes::index))
        .route("/{name}", get(routes::asset))
        .route("/live", get(socket::live))
        .route("/view/{ticket}", get(routes::report))
        .route("/api/hello", get(routes::hello))
        .route("/api/templates", get(shelf_routes::templates))
        .route("/api/blank", get(shelf_routes::blank))
        .route("/api/template/{name}", get(shelf_routes::template))
        .route("/api/folder", get(shelf_routes::folder))
        .route("/api/card", get(shelf_routes::card))
        .route("/api/trash", post(shelf_routes::trash))
        .route("/api/restore", post(shelf_routes::restore))
        .route("/api/duplicate", post(shelf_routes::duplicate))
        .route("/api/open", get(routes::open))
        .route("/api/file", put(routes::save))
        .route("/api/draft", put(draft_routes::keep))
        .route("/api/draft/take", post(draft_routes::take))
        .route("/api/new", post(routes::new))
        .route("/api/set-uncertainty", post(routes::set_uncertainty))
        .route("/api/restructure", post(routes::restructure))
        .route("/api/import", post(routes::import))
        .route("/api/explain/{code}", get(routes::explain))
        .route("/api/view", post(routes::view))
        .route("/api/compare", post(result_routes::compare))
        .route("/api/result", post(result_routes::result))
        .route("/api/adopt", post(result_routes::adopt))
        .fallback(routes::missing)
        .layer(DefaultBodyLimit::max(MAX_BODY))
        .layer(from_fn_with_state(studio.clone(), guard))
        .with_state(studio)
}
