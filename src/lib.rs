//! The terramechanics service: HTTP/JSON over the model crate, its OpenAPI contract and its plotting page.
//!
//! The way of a request: bytes → `extract` → the request of a room of `api`, which checks everything and reports every fault → what
//! the model finds → the reply → bytes. A room has all of one operation; what several share is in `request` and `reply`. What an
//! answer says of its numbers comes from the table of `quantity`, what it says of itself from that of `warning`. Physics live in
//! the crate `terramechanics`, HTTP here.

mod accepted;
mod answer;
mod api;
mod body;
mod budget;
mod catalogue;
mod coding;
mod compute;
pub mod config;
mod contract;
mod docs;
mod entrance;
mod extract;
mod fixed;
mod http1;
pub mod in_process;
mod legible;
mod limits;
pub mod log;
mod metrics;
mod name;
mod observe;
mod outside;
mod packing;
mod page;
mod problem;
mod pure;
mod quantity;
mod reply;
mod request;
mod rest;
mod router;
mod rows;
mod series;
pub mod server;
mod state;
mod stream;
mod validation;
mod varied;
mod warning;
mod words;

/// What is fuzzed; there is none of it in the program.
#[cfg(fuzzing)]
pub mod fuzzing {
    /// What the reader of tables makes of the pieces of one, in words.
    #[must_use]
    pub fn csv_rows(pieces: &[&[u8]]) -> String {
        use crate::series::{ExtraColumns, Reader, all};
        let read = |extra| all(Reader::csv(extra), pieces);
        format!("{:?} {:?}", read(ExtraColumns::Refuse), read(ExtraColumns::Ignore))
    }
}

pub use contract::Contract;
pub use limits::{Begin, Limits};
pub use metrics::Metrics;
pub use outside::Outside;
pub use router::{app, contract, layered};
pub use state::Service;
