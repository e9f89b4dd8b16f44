//! The process that starts workers and opens the page.

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use loosepin::diagnostics::{Code, problems};

use crate::arguments::ServeArguments;
use crate::browser;
use crate::command::signals::stop_on_signals;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// How often it is looked whether the worker has ended.
const TICK: Duration = Duration::from_millis(50);
/// How long a worker that is asked to end is waited for: one that is stopped (SIGSTOP) does not hear it, and is ended then.
const LONGEST_END: Duration = Duration::from_secs(5);
/// Workers that may end by an error within [`SPAN`]; after one more none is started. A page sends its texts again to each.
const MAX_ENDED: usize = 20;
/// The time in which they are counted.
const SPAN: Duration = Duration::from_secs(60);

problems! {
    /// Why the studio does not run.
    #[derive(Debug)]
    pub enum SupervisorProblem {
        /// The system starts no process.
        NotStarted { source: io::Error } => Code::NoThreads,
            says("the process of the studio cannot be started: {source}"),
            hint("raise the limits of memory (ulimit -v, ulimit -d) or of processes (ulimit -u)");
    }
}

/// Starts workers until one ends by itself, or Ctrl-C.
pub fn run(arguments: &ServeArguments) -> Ending {
    let stop = stop_on_signals("Ctrl-C ends the studio at once; a study that runs keeps the runs that are saved");
    let mut worker = Worker::start(arguments, arguments.port, "").map_err(not_started)?;
    // Kept until the end, because the browser may read it late.
    let mut page = None;
    let address = worker.address.clone();
    if let Some(address) = &address {
        console::message(&format!("studio of {}; Ctrl-C ends it", worker.folder));
        console::print(&format!("{}\n", address.text))?;
        if !arguments.no_open {
            match browser::open(&address.text) {
                Ok(opened) => page = Some(opened),
                Err(error) => console::message(&format!("no browser opened ({error}): open the address above")),
            }
        }
    }
    let mut ended: Vec<Instant> = Vec::new();
    loop {
        let status = worker.wait(&stop).map_err(not_started)?;
        ended.retain(|instant| instant.elapsed() < SPAN);
        match (status.code(), &address) {
            (Some(0), _) => break,
            // It has said why.
            (Some(status), _) => return Err(Failure::Reported(u8::try_from(status).unwrap_or(2))),
            (None, _) if stop.load(Ordering::Relaxed) => break,
            (None, Some(address)) if ended.len() < MAX_ENDED => {
                ended.push(Instant::now());
                console::message(
                    "the studio ended by an internal error, and is started again; run a study that was running once more: its runs are saved",
                );
                worker = Worker::start(arguments, address.port, &address.token).map_err(not_started)?;
            }
            (None, _) => {
                console::message(
                    "error: the studio ended by an internal error, a fault of loosepin: please report it with the lines above and the files of the folder",
                );
                return Err(Failure::Reported(2));
            }
        }
    }
    drop(page);
    Ok(Done::Well)
}

fn not_started(source: io::Error) -> Failure {
    Failure::of(&SupervisorProblem::NotStarted { source })
}

/// A process that serves.
struct Worker {
    process: Child,
    /// `None` if it ended before it served.
    address: Option<Address>,
    folder: String,
}

/// `http://127.0.0.1:PORT/#token=TOKEN`.
#[derive(Clone)]
struct Address {
    text: String,
    port: u16,
    token: String,
}

impl Worker {
    fn start(arguments: &ServeArguments, port: u16, token: &str) -> io::Result<Self> {
        let mut process = Command::new(std::env::current_exe()?)
            .args(["serve", "--worker", "--port", &port.to_string(), "--"])
            .arg(&arguments.folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        // One that ended at once says why itself.
        let _ = process.stdin.as_mut().map(|input| writeln!(input, "{token}"));
        let mut lines = process.stdout.take().into_iter().flat_map(|output| BufReader::new(output).lines());
        let mut next_line = || lines.next().and_then(Result::ok);
        let address = next_line().and_then(|line| Address::read(&line));
        let folder = next_line().unwrap_or_default();
        Ok(Self { process, address, folder })
    }

    /// Until it has ended; asks it to where `stop` is set, and ends it where it does not.
    fn wait(&mut self, stop: &AtomicBool) -> io::Result<ExitStatus> {
        let mut asked: Option<Instant> = None;
        loop {
            if let Some(status) = self.process.try_wait()? {
                return Ok(status);
            }
            if stop.load(Ordering::Relaxed) {
                drop(self.process.stdin.take());
                if asked.get_or_insert_with(Instant::now).elapsed() > LONGEST_END {
                    self.process.kill()?;
                }
            }
            std::thread::sleep(TICK);
        }
    }
}

impl Address {
    fn read(text: &str) -> Option<Self> {
        let (server, token) = text.split_once("/#token=")?;
        let (_, port) = server.rsplit_once(':')?;
        Some(Self { text: text.to_owned(), port: port.parse().ok()?, token: token.to_owned() })
    }
}
