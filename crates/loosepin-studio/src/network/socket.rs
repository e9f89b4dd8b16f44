//! A live connection: looks up, what is seen of them down, jobs to everybody.

use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::extract::ws::{Message, Utf8Bytes, WebSocket, WebSocketUpgrade};
use axum::extract::{Extension, State};
use axum::response::Response;
use loosepin::VERSION;
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::watch;
use tokio::time::timeout;

use crate::files::folder::{Folder, MAX_TEXT};
use crate::jobs::queue::Task;
use crate::messages::{FromPage, Look, LookAnswer, ToPage};
use crate::network::checker::Checker;
use crate::network::mailbox::Mailbox;
use crate::network::time_limit::{LONGEST_LOOK, within};
use crate::network::visitors::Visitor;
use crate::studio::Studio;
use crate::view::look::{answer_look, cut};

/// Longest message: two texts, each letter escaped.
const MAX_MESSAGE: usize = 4 * MAX_TEXT;
/// Most messages in a second: twice those of a screen that drags.
const MAX_A_SECOND: u32 = 200;
/// How often the files of the last look are looked at.
const WATCH: Duration = Duration::from_secs(1);

/// Opens a live connection.
pub async fn live(
    State(studio): State<Studio>,
    Extension(visitor): Extension<Visitor>,
    upgrade: WebSocketUpgrade,
) -> Response {
    let upgrade = upgrade.max_message_size(MAX_MESSAGE).max_frame_size(MAX_MESSAGE);
    upgrade.on_upgrade(async move |socket| converse(studio, visitor, socket).await)
}

async fn converse(studio: Studio, visitor: Visitor, mut socket: WebSocket) {
    let hello = timeout(studio.times.hello, socket.recv()).await;
    let Ok(Some(Ok(Message::Text(first)))) = hello else { return };
    let tab = match serde_json::from_str(&first) {
        Ok(FromPage::Hello { token, tab }) if studio.token.is(&token) => tab,
        _ => {
            let message = "the token of the studio is missing or wrong";
            let _ = tell(&mut socket, &ToPage::Refused { message }).await;
            return;
        }
    };
    visitor.show_token();
    // Taken by those alone who have shown the token.
    let Ok(_seat) = studio.seats.try_acquire() else {
        let message = "too many pages of the studio are open: close some of them";
        let _ = tell(&mut socket, &ToPage::Refused { message }).await;
        return;
    };
    visitor.go_live();
    let _tab = tab.map(|name| studio.tabs.enter(name));
    let mut jobs = studio.jobs.listen();
    if tell(&mut socket, &ToPage::Hello { version: VERSION, jobs: studio.jobs.all() }).await.is_err() {
        return;
    }
    let mailbox = Arc::new(Mailbox::new());
    // One answer waits at most: a newer one takes its place.
    let (answers, mut seen) = watch::channel(Utf8Bytes::default());
    let (worker_box, worker_folder) = (Arc::clone(&mailbox), studio.folder.clone());
    let checker = Arc::new(Checker::new());
    let (checks, mut checked) = watch::channel(Utf8Bytes::default());
    let check_thread = Arc::clone(&checker);
    let check_on = move || check_thread.check_on(&checks);
    let worker_checker = Arc::clone(&checker);
    let look_on = move || look_on(&worker_folder, (&worker_box, &worker_checker), &answers);
    let workers = [std::thread::Builder::new().spawn(look_on), std::thread::Builder::new().spawn(check_on)];
    if workers.iter().any(Result::is_err) {
        mailbox.close();
        checker.close();
        let message = "the system refused to start a thread for this page: close other programs, and load it again";
        let _ = tell(&mut socket, &ToPage::Refused { message }).await;
        return;
    }
    let mut rate = Rate::new();
    let mut watched = Watched::default();
    let mut ticks = tokio::time::interval(WATCH);
    loop {
        let outcome = tokio::select! {
            message = socket.recv() => match message {
                // Pings count too: each is answered.
                _ if !rate.admits() => break,
                Some(Ok(Message::Text(text))) => match serde_json::from_str(&text) {
                    Ok(FromPage::Look(look)) => {
                        watched.looked(&look);
                        checker.stop();
                        mailbox.put(*look);
                        Ok(())
                    }
                    Ok(FromPage::Run { study, shown }) => {
                        add(&studio, &mut socket, Task::Study { path: study, shown }).await
                    }
                    Ok(FromPage::Simulate { result, witness }) => {
                        add(&studio, &mut socket, Task::Witness { result, witness }).await
                    }
                    Ok(FromPage::Stop { id }) => {
                        studio.jobs.stop(id);
                        Ok(())
                    }
                    Ok(FromPage::Hello { .. }) => Ok(()),
                    Err(error) => {
                        let message = format!("this message is not valid: {error}");
                        tell(&mut socket, &ToPage::Refused { message: &message }).await
                    }
                },
                Some(Ok(Message::Ping(_) | Message::Pong(_))) => Ok(()),
                _ => break,
            },
            Ok(()) = seen.changed() => {
                let text = seen.borrow_and_update().clone();
                send(&mut socket, text).await
            }
            Ok(()) = checked.changed() => {
                let text = checked.borrow_and_update().clone();
                send(&mut socket, text).await
            }
            job = jobs.recv() => match job {
                Ok(job) => tell(&mut socket, &ToPage::Job { job: &job }).await,
                // The next message on each job says how far it is.
                Err(RecvError::Lagged(_)) => Ok(()),
                Err(RecvError::Closed) => break,
            },
            _ = ticks.tick() => {
                let mut outcome = Ok(());
                for path in watched.changed(&studio.folder) {
                    outcome = outcome.and(tell(&mut socket, &ToPage::Changed { path: &path }).await);
                }
                outcome
            }
        };
        if outcome.is_err() {
            break;
        }
    }
    mailbox.close();
    checker.close();
    // They end with the look and the check that they are at.
    drop(workers);
}

/// Adds a job, or says why not.
async fn add(studio: &Studio, socket: &mut WebSocket, task: Task) -> Result<(), axum::Error> {
    match studio.jobs.add(task) {
        Ok(()) => Ok(()),
        Err(message) => tell(socket, &ToPage::Refused { message: &message }).await,
    }
}

/// Answers looks until the connection ends.
fn look_on(folder: &Folder, (mailbox, checker): (&Mailbox<Look>, &Checker), answers: &watch::Sender<Utf8Bytes>) {
    while let Some(request) = mailbox.take() {
        let in_json = |seen: &LookAnswer| serde_json::to_string(&ToPage::LookAnswer(seen)).unwrap_or_default();
        let late = || {
            let _ = answers.send(in_json(&cut(&request, LONGEST_LOOK)).into());
        };
        let seen = within(LONGEST_LOOK, late, |stop| {
            let (seen, texts) = answer_look(folder, &request, stop);
            (in_json(&seen), (seen.is_sound() && request.is_at_rest).then_some(texts))
        });
        // What came too late is answered already.
        let Some((text, to_check)) = seen else { continue };
        if answers.send(text.into()).is_err() {
            return;
        }
        if let Some(texts) = to_check {
            checker.check(request.seq, texts);
        }
    }
}

async fn tell(socket: &mut WebSocket, message: &ToPage<'_>) -> Result<(), axum::Error> {
    send(socket, serde_json::to_string(message).unwrap_or_default().into()).await
}

/// Sends a text, or ends where the page takes nothing for too long: see [`crate::network::stream`].
async fn send(socket: &mut WebSocket, text: Utf8Bytes) -> Result<(), axum::Error> {
    socket.send(Message::Text(text)).await
}

/// Messages of the second that runs.
struct Rate {
    began: Instant,
    count: u32,
}

impl Rate {
    fn new() -> Self {
        Self { began: Instant::now(), count: 0 }
    }

    fn admits(&mut self) -> bool {
        if self.began.elapsed() >= Duration::from_secs(1) {
            *self = Self::new();
        }
        self.count += 1;
        self.count <= MAX_A_SECOND
    }
}

/// The files of the last look, with what the disk had of them when it was last looked at.
#[derive(Default)]
struct Watched(Vec<(String, Option<std::time::SystemTime>)>);

impl Watched {
    fn looked(&mut self, look: &Look) {
        let paths = || std::iter::once(&look.model.path).chain(look.study.iter().map(|study| &study.path));
        if !paths().eq(self.0.iter().map(|(path, _)| path)) {
            self.0 = paths().map(|path| (path.clone(), None)).collect();
        }
    }

    /// Files that have changed since the last tick.
    fn changed(&mut self, folder: &Folder) -> Vec<String> {
        let mut changed = Vec::new();
        for (path, known) in &mut self.0 {
            let found = folder.info(path).ok().and_then(|found| found.modified);
            if known.is_some() && found != *known {
                changed.push(path.clone());
            }
            *known = found;
        }
        changed
    }
}
