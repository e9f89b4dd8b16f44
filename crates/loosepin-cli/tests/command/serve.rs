//! The studio outlives the process that serves it, and no process outlives the studio.
#![cfg(target_os = "linux")]

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use super::command_line::Desk;

const LIMIT: Duration = Duration::from_secs(60);

/// Waits for what `found` gives.
fn wait_for<T>(what: &str, mut found: impl FnMut() -> Option<T>) -> T {
    let began = Instant::now();
    loop {
        if let Some(found) = found() {
            return found;
        }
        if began.elapsed() > LIMIT {
            panic!("no {what} within {LIMIT:?}");
        }
        sleep(Duration::from_millis(20));
    }
}

fn signal(name: &str, process: u32) {
    let killed = Command::new("kill").args([name, &process.to_string()]).status().expect("kill is there");
    assert!(killed.success());
}

/// The one child of `process`, if it has one.
fn child_of(process: u32) -> Option<u32> {
    let children = fs::read_to_string(format!("/proc/{process}/task/{process}/children")).ok()?;
    children.split_whitespace().next()?.parse().ok()
}

fn is_there(process: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
    !status.is_empty() && !status.contains(") Z ")
}

/// First line of the answer to a request for the page.
fn answer(port: &str) -> Option<String> {
    let mut stream = TcpStream::connect(format!("127.0.0.1:{port}")).ok()?;
    write!(stream, "GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n").ok()?;
    let mut text = String::new();
    stream.read_to_string(&mut text).ok()?;
    text.lines().next().map(str::to_owned)
}

struct Served {
    supervisor: Child,
    address: String,
}

impl Served {
    fn new(desk: &Desk) -> Self {
        let mut supervisor = desk
            .command(&["serve", "--no-open"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap_or_else(|error| panic!("{error}"));
        let mut address = String::new();
        let output = supervisor.stdout.as_mut().expect("it is piped");
        BufReader::new(output).read_line(&mut address).unwrap_or_else(|error| panic!("{error}"));
        Self { supervisor, address: address.trim().to_owned() }
    }

    fn port(&self) -> &str {
        let (server, _) = self.address.split_once("/#token=").expect("an address with a token");
        server.rsplit_once(':').expect("it has a port").1
    }

    fn worker(&self) -> u32 {
        wait_for("a worker", || child_of(self.supervisor.id()))
    }
}

#[test]
fn a_worker_that_ends_by_an_error_is_followed_by_another_one_at_the_same_address() {
    let desk = Desk::new();
    let mut served = Served::new(&desk);
    let first = served.worker();
    assert_eq!(answer(served.port()).as_deref(), Some("HTTP/1.1 200 OK"));
    signal("-ABRT", first);
    let second = wait_for("another worker", || child_of(served.supervisor.id()).filter(|child| *child != first));
    assert_eq!(wait_for("an answer", || answer(served.port())), "HTTP/1.1 200 OK");
    signal("-TERM", served.supervisor.id());
    let status = served.supervisor.wait().expect("it ends");
    assert!(status.success(), "{status}");
    assert!(!is_there(second));
    let mut messages = String::new();
    let errors = served.supervisor.stderr.as_mut().expect("it is piped");
    errors.read_to_string(&mut messages).unwrap_or_else(|error| panic!("{error}"));
    assert!(messages.contains("ended by an internal error, and is started again"), "{messages}");
}

#[test]
fn a_worker_ends_with_its_supervisor_however_that_ends() {
    let desk = Desk::new();
    let mut served = Served::new(&desk);
    let worker = served.worker();
    signal("-KILL", served.supervisor.id());
    served.supervisor.wait().expect("it ends");
    wait_for("the end of the worker", || (!is_there(worker)).then_some(()));
}

#[test]
fn the_first_ctrl_c_ends_the_studio_also_where_its_worker_is_stopped() {
    let desk = Desk::new();
    let mut served = Served::new(&desk);
    let worker = served.worker();
    signal("-STOP", worker);
    signal("-INT", served.supervisor.id());
    let status = wait_for("an end", || served.supervisor.try_wait().expect("it can be asked"));
    assert!(status.success(), "{status}");
    assert!(!is_there(worker));
}
