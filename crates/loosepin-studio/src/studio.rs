//! What all connections of a server share.

use std::sync::Arc;

use tokio::sync::Semaphore;

use crate::files::folder::Folder;
use crate::jobs::queue::Jobs;
use crate::network::tickets::Tickets;
use crate::network::times::Timeouts;
use crate::network::token::Token;

/// What all connections share.
#[derive(Clone)]
pub struct Studio {
    /// The secret of its address.
    pub token: Token,
    /// What is served.
    pub folder: Folder,
    /// Studies in the background.
    pub jobs: Arc<Jobs>,
    /// Tickets for reports.
    pub tickets: Arc<Tickets>,
    /// Live connections that may still be opened.
    pub seats: Arc<Semaphore>,
    /// Requests whose bodies may still be read at once.
    pub bodies: Arc<Semaphore>,
    /// How long whoever is connected is waited for.
    pub times: Timeouts,
}
