//! The accept loop: connections, their bounds and the graceful stop.
//!
//! hyper's own connection builder is used because `axum::serve` bounds neither a connection nor the stop. The limits are kept
//! here, not in hyper, which knows no limit for what is written and one for both an idle connection and a head that drips.

mod bounds;
mod connection;
mod link;
mod pace;
mod peer;
mod places;
mod reason;
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
pub use bounds::Bounds;
use connection::Shared;
use link::Link;
pub use pace::Slowest;
use peer::Peer;
use places::Places;
pub(crate) use reason::Reason;
pub use signals::told_to_stop;
pub(crate) use upload::TooSlow;

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
