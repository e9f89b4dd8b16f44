//! State shared by all connections of a server.

use std::sync::Arc;

use tokio::sync::Semaphore;

use crate::files::folder::Folder;
use crate::jobs::queue::Jobs;
use crate::network::tabs::Tabs;
use crate::network::tickets::Tickets;
use crate::network::times::Timeouts;
use crate::network::token::Token;

/// State shared by all connections.
#[derive(Clone)]
pub struct Studio {
    /// The secret of its address.
    pub token: Token,
    /// The served folder.
    pub folder: Folder,
    /// Studies in the background.
    pub jobs: Arc<Jobs>,
    /// Tabs with a live page.
    pub tabs: Arc<Tabs>,
    /// Tickets for reports.
    pub tickets: Arc<Tickets>,
    /// Live connections that may still be opened.
    pub seats: Arc<Semaphore>,
    /// Requests whose bodies may still be read at once.
    pub bodies: Arc<Semaphore>,
    /// Timeouts of connections.
    pub times: Timeouts,
}
