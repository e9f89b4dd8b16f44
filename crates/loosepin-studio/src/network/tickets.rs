//! Tickets by which a frame of the page fetches a report, once: a frame sends no token, and a report is a file that somebody may have
//! sent by mail.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::network::token::Token;

/// How long a ticket is good.
const LIFE: Duration = Duration::from_secs(30);
/// Most tickets at once.
const MOST: usize = 64;

/// The tickets that are out.
#[derive(Default)]
pub struct Tickets(Mutex<HashMap<String, (Instant, String)>>);

impl Tickets {
    /// A ticket for the file at a path in the served folder.
    ///
    /// # Errors
    /// The system has no source of random bytes.
    pub fn issue(&self, path: String) -> Result<String, getrandom::Error> {
        let ticket = Token::new()?.text().to_owned();
        let mut tickets = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        tickets.retain(|_, (issued, _)| issued.elapsed() < LIFE);
        if tickets.len() >= MOST {
            tickets.clear();
        }
        tickets.insert(ticket.clone(), (Instant::now(), path));
        Ok(ticket)
    }

    /// The path of the file that a ticket is for; it is used up.
    pub fn redeem(&self, ticket: &str) -> Option<String> {
        let mut tickets = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (issued, path) = tickets.remove(ticket)?;
        (issued.elapsed() < LIFE).then_some(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ticket_is_good_once() {
        let tickets = Tickets::default();
        let ticket = tickets.issue("results/a/report.html".to_owned()).unwrap();
        assert_eq!(tickets.redeem("other"), None);
        assert_eq!(tickets.redeem(&ticket), Some("results/a/report.html".to_owned()));
        assert_eq!(tickets.redeem(&ticket), None);
    }
}
