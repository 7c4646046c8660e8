//! The accept loop: connections, their bounds and the graceful stop.
//!
//! hyper's own connection builder is used because `axum::serve` bounds neither a connection nor the stop. The limits are kept
//! here, not in hyper, which knows no limit for what is written and one for both an idle connection and a head that drips.

mod connection;
mod link;
mod pace;
mod peer;
mod places;
mod signals;
mod transport;
mod upload;

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use tokio::net::{TcpListener, TcpSocket, TcpStream};
use tokio::sync::watch;

use crate::state::Service;
use connection::Shared;
use link::Link;
pub use pace::Slowest;
use peer::Peer;
use places::Places;
pub use signals::told_to_stop;

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

/// Why a connection was closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reason {
    /// By the client, or after its last answer.
    Done,
    /// It broke, or what came was not HTTP.
    Broken,
    /// Nothing came.
    Idle,
    /// The head of a request did not arrive in time.
    SlowHead,
    /// The body of a request came too slowly.
    SlowBody,
    /// Nothing of an answer was taken.
    Stalled,
    /// An answer was taken too slowly.
    SlowReader,
    /// It waited for its client, and another came.
    MadeRoom,
    /// All places were taken by requests.
    NoPlace,
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

impl Reason {
    /// Every reason, so that each is counted from the start.
    pub(crate) const ALL: [Self; 9] = [
        Self::Done,
        Self::Broken,
        Self::Idle,
        Self::SlowHead,
        Self::SlowBody,
        Self::Stalled,
        Self::SlowReader,
        Self::MadeRoom,
        Self::NoPlace,
    ];

    /// Its name among the metrics.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Broken => "broken",
            Self::Idle => "idle",
            Self::SlowHead => "slow_head",
            Self::SlowBody => "slow_body",
            Self::Stalled => "stalled",
            Self::SlowReader => "slow_reader",
            Self::MadeRoom => "made_room",
            Self::NoPlace => "no_place",
        }
    }
}

/// A body that came slower than this.
#[derive(Debug)]
pub(crate) struct TooSlow(pub(crate) Slowest);

impl std::fmt::Display for TooSlow {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the body came at less than {} bytes a second over {} s", self.0.rate, self.0.window.as_secs_f64())
    }
}

impl std::error::Error for TooSlow {}

/// Pause after a failed accept: mostly there are no file descriptors left, and trying again at once would spin.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

/// Largest head of a request, and output of a connection beyond which nothing more is written (bytes). A body that waits for its
/// memory holds three times as much.
const BUFFER_BYTES: usize = 16 << 10;

/// What the system may keep of an answer for each connection (bytes; Linux takes twice as much, for its own needs). It holds
/// half a megabyte a second at 100 ms of delay. More would only hide how slow a reader is: space is given back in thirds.
const SOCKET_BYTES: u32 = 64 << 10;

/// Connections that may wait to be accepted.
const BACKLOG: u32 = 1024;

/// A socket that listens at `address`.
///
/// # Errors
/// Where it cannot.
pub fn listen(address: SocketAddr) -> io::Result<TcpListener> {
    let socket = if address.is_ipv4() { TcpSocket::new_v4() } else { TcpSocket::new_v6() }?;
    // A server that starts again must not wait until the connections of the one before are forgotten.
    socket.set_reuseaddr(true)?;
    socket.set_send_buffer_size(SOCKET_BYTES)?;
    socket.bind(address)?;
    socket.listen(BACKLOG)
}

/// Serves `app` on `listener` until `stop` is done, then ends gracefully. A failed accept is logged and tried again. Returns
/// the number of connections whose requests were cut off.
pub async fn serve(
    listener: TcpListener,
    app: Router,
    service: Service,
    bounds: Bounds,
    stop: impl Future<Output = ()>,
) -> usize {
    let (stopping, is_stopping) = watch::channel(false);
    let mut builder = http1::Builder::new();
    // Without `pipeline_flush`, which takes the bound off the answers that wait to be written: a slow reader of a stream could
    // then fill the memory.
    builder.header_read_timeout(None).max_buf_size(BUFFER_BYTES);
    let shared = Shared { builder, app, service: service.clone(), stopping: is_stopping };
    let places = Arc::new(Places::new(bounds));
    take_until(stop, &listener, &places, &shared).await;
    service.stop();
    if !bounds.drain_delay.is_zero() {
        tracing::info!("not ready any more: new connections are taken for {} s", bounds.drain_delay.as_secs());
        take_until(tokio::time::sleep(bounds.drain_delay), &listener, &places, &shared).await;
    }
    drop((listener, shared));
    tracing::info!("stopping: open requests are given {} s", bounds.grace.as_secs());
    stopping.send_replace(true);
    if tokio::time::timeout(bounds.grace, stopping.closed()).await.is_ok() {
        return 0;
    }
    places.busy()
}

/// Takes connections until `end` is done.
async fn take_until(end: impl Future<Output = ()>, listener: &TcpListener, places: &Arc<Places>, shared: &Shared) {
    let mut end = std::pin::pin!(end);
    loop {
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            () = &mut end => return,
        };
        match accepted {
            Ok((stream, address)) => take(stream, Peer::of(address.ip()), places, shared),
            Err(error) => {
                tracing::warn!(%error, "a connection could not be accepted");
                places.make_room();
                tokio::time::sleep(ACCEPT_PAUSE).await;
            }
        }
    }
}

/// Gives a connection a place and a task, or closes it where there is none.
fn take(stream: TcpStream, peer: Peer, places: &Arc<Places>, shared: &Shared) {
    let Some(link) = places.admit(peer, tokio::time::Instant::now()) else {
        tracing::debug!(%peer, "there was no place for a connection");
        shared.service.metrics().connected();
        return shared.service.metrics().disconnected(Reason::NoPlace);
    };
    // Answers are small: without this, each could wait for the acknowledgement of the one before.
    let _ = stream.set_nodelay(true);
    let open = Open::new(link.clone(), places.clone(), shared.service.clone());
    let task = tokio::spawn({
        let (link, shared) = (link.clone(), shared.clone());
        async move {
            let reason = connection::serve(stream, open.link.clone(), shared).await;
            link.close_for(reason);
        }
    });
    link.runs_as(task.abort_handle());
}

/// A connection that is open, until this is dropped.
struct Open {
    link: Arc<Link>,
    places: Arc<Places>,
    service: Service,
}

impl Open {
    fn new(link: Arc<Link>, places: Arc<Places>, service: Service) -> Self {
        service.metrics().connected();
        Self { link, places, service }
    }
}

impl Drop for Open {
    fn drop(&mut self) {
        self.places.leave(&self.link);
        let reason = self.link.reason().unwrap_or(Reason::Broken);
        tracing::debug!(peer = %self.link.peer, reason = reason.name(), "a connection was closed");
        self.service.metrics().disconnected(reason);
    }
}
