//! Network: access, connections and their limits, routes, the live connection. It hands texts and requests on and knows no mechanism.

pub(crate) mod checker;
pub(crate) mod connections;
pub(crate) mod draft_routes;
pub(crate) mod guard;
pub(crate) mod mailbox;
pub(crate) mod page;
pub(crate) mod refusal;
pub(crate) mod requests;
pub(crate) mod result_routes;
pub(crate) mod routes;
pub(crate) mod server;
pub(crate) mod shelf_routes;
pub(crate) mod socket;
pub(crate) mod stream;
pub(crate) mod tabs;
pub(crate) mod tickets;
pub(crate) mod time_limit;
pub(crate) mod times;
pub(crate) mod token;
pub(crate) mod visitors;
