//! The bytes of a connection, which end where the client takes none, stays too long, sends too much without the token, or has to make room.

use std::future::Future;
use std::io::{self, ErrorKind, IoSlice};
use std::pin::Pin;
use std::task::{Context, Poll};
use std::time::Duration;

use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::TcpStream;
use tokio::sync::oneshot;
use tokio::time::{Sleep, sleep};

use crate::network::times::Timeouts;
use crate::network::visitors::ConnectionSlot;

/// Most bytes of a connection that has not shown the token: heads of requests, and a first message. Nobody else makes the studio
/// keep more than that.
const MAX_WITHOUT_TOKEN: usize = 64 << 10;

/// A connection with its place, which it has until it is dropped.
pub struct Stream {
    tcp: TcpStream,
    place: ConnectionSlot,
    /// Comes when it has to make room.
    end: oneshot::Receiver<()>,
    has_ended: bool,
    /// Time for the connection in total.
    total: Pin<Box<Sleep>>,
    /// Time until the client takes a byte; `None` if it has taken all.
    stalled: Option<Pin<Box<Sleep>>>,
    write: Duration,
    received: usize,
}

impl Stream {
    /// A connection at a place, until `end` comes.
    pub fn new(tcp: TcpStream, place: ConnectionSlot, end: oneshot::Receiver<()>, times: &Timeouts) -> Self {
        let total = Box::pin(sleep(times.connection + times.last_request));
        Self { tcp, place, end, has_ended: false, total, stalled: None, write: times.write, received: 0 }
    }

    /// Whether the connection may continue. The task is woken when it may not any more.
    fn check(&mut self, context: &mut Context<'_>) -> io::Result<()> {
        self.has_ended = self.has_ended || Pin::new(&mut self.end).poll(context).is_ready();
        if self.has_ended {
            return Err(ErrorKind::ConnectionAborted.into());
        }
        if !self.place.visitor.is_live() && self.total.as_mut().poll(context).is_ready() {
            return Err(ErrorKind::TimedOut.into());
        }
        Ok(())
    }

    /// What a write came to, unless the client has taken nothing for too long.
    fn progress(&mut self, context: &mut Context<'_>, outcome: Poll<io::Result<usize>>) -> Poll<io::Result<usize>> {
        if outcome.is_ready() {
            self.stalled = None;
            return outcome;
        }
        let write = self.write;
        let stalled = self.stalled.get_or_insert_with(|| Box::pin(sleep(write)));
        stalled.as_mut().poll(context).map(|()| Err(ErrorKind::TimedOut.into()))
    }
}

impl AsyncRead for Stream {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        self.check(context)?;
        let before = buffer.filled().len();
        let outcome = Pin::new(&mut self.tcp).poll_read(context, buffer);
        self.received = self.received.saturating_add(buffer.filled().len() - before);
        if self.received > MAX_WITHOUT_TOKEN && !self.place.visitor.has_token() {
            return Poll::Ready(Err(ErrorKind::InvalidData.into()));
        }
        outcome
    }
}

impl AsyncWrite for Stream {
    fn poll_write(mut self: Pin<&mut Self>, context: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        self.check(context)?;
        let outcome = Pin::new(&mut self.tcp).poll_write(context, bytes);
        self.progress(context, outcome)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        pieces: &[IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        self.check(context)?;
        let outcome = Pin::new(&mut self.tcp).poll_write_vectored(context, pieces);
        self.progress(context, outcome)
    }

    fn is_write_vectored(&self) -> bool {
        self.tcp.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.tcp).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.tcp).poll_shutdown(context)
    }
}
