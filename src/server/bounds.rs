//! What a connection and all of them together may take.

use std::time::Duration;

use super::pace::Slowest;

/// Bounds of the accept loop.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Connections that may be open at once.
    pub connections: usize,
    /// Connections that one peer may have of them.
    pub of_one_peer: usize,
    /// Time in which the head of a request has to arrive, from its first byte on, and the first byte of a connection.
    pub head_deadline: Duration,
    /// Time for which a connection is kept after an answer.
    pub keep_alive: Duration,
    /// Time in which a client has to take some of an answer that waits for it.
    pub write_deadline: Duration,
    /// The slowest client that takes an answer.
    pub slowest_download: Slowest,
    /// The slowest client that sends a body.
    pub slowest_upload: Slowest,
    /// Time in which new connections are still taken once the server was told to stop.
    pub drain_delay: Duration,
    /// Time that open requests are given when the server stops.
    pub grace: Duration,
}

impl Bounds {
    /// Those of a service with the default settings.
    pub const DEFAULT: Self = Self {
        connections: 1024,
        of_one_peer: 512,
        head_deadline: Duration::from_secs(10),
        keep_alive: Duration::from_secs(75),
        write_deadline: Duration::from_secs(10),
        slowest_download: Slowest { rate: 1024, window: Duration::from_secs(30) },
        slowest_upload: Slowest { rate: 5, window: Duration::from_secs(30) },
        drain_delay: Duration::ZERO,
        grace: Duration::from_secs(10),
    };
}
