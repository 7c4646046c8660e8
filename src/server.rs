//! The accept loop: connections, their bounds and the graceful stop.
//!
//! hyper's own connection builder is used because `axum::serve` sets no limit on how slowly a request head may arrive.

use std::convert::Infallible;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;

use crate::state::Service;

/// Bounds of the accept loop.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Connections that may be open at once.
    pub connections: usize,
    /// Time in which the head of a request has to arrive, and for which an idle connection is kept.
    pub head_deadline: Duration,
    /// Time that open requests are given when the server stops.
    pub grace: Duration,
}

/// Pause after a failed accept: mostly there are no file descriptors left, and trying again at once would spin.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

/// Largest head of a request (bytes).
const HEAD_BYTES: usize = 64 << 10;

/// Serves `app` on `listener` until `stop` is done, then ends gracefully. A failed accept is logged and tried again.
pub async fn serve(listener: TcpListener, app: Router, service: Service, bounds: Bounds, stop: impl Future<Output = ()>) {
    let places = Arc::new(Semaphore::new(bounds.connections));
    let graceful = GracefulShutdown::new();
    let mut builder = http1::Builder::new();
    // Without `pipeline_flush`, which takes the bound off the answers that wait to be written: a slow reader of a stream could
    // then fill the memory.
    builder.timer(TokioTimer::new()).header_read_timeout(bounds.head_deadline).max_buf_size(HEAD_BYTES);
    let mut stop = std::pin::pin!(stop);
    loop {
        let accepted = tokio::select! {
            accepted = accept(&listener, &places) => accepted,
            () = &mut stop => break,
        };
        let (stream, place) = match accepted {
            Ok(accepted) => accepted,
            Err(error) => {
                tracing::warn!(%error, "a connection could not be accepted");
                tokio::time::sleep(ACCEPT_PAUSE).await;
                continue;
            }
        };
        // Answers are small: without this, each could wait for the acknowledgement of the one before.
        let _ = stream.set_nodelay(true);
        let connection = builder.serve_connection(TokioIo::new(stream), TowerToHyperService::new(app.clone()));
        let connection = graceful.watch(connection);
        let service = service.clone();
        tokio::spawn(async move {
            let _place = place;
            service.metrics().connected();
            if let Err(error) = connection.await {
                tracing::debug!(%error, "a connection broke");
            }
            service.metrics().disconnected();
        });
    }
    drop(listener);
    service.stop();
    tracing::info!("stopping: open requests are given {} s", bounds.grace.as_secs());
    if tokio::time::timeout(bounds.grace, graceful.shutdown()).await.is_err() {
        tracing::warn!("some requests did not end in time");
    }
}

async fn accept(listener: &TcpListener, places: &Arc<Semaphore>) -> io::Result<(TcpStream, tokio::sync::OwnedSemaphorePermit)> {
    let place = places.clone().acquire_owned().await.map_err(io::Error::other)?;
    let (stream, _) = listener.accept().await?;
    Ok((stream, place))
}

/// Done when the process is told to stop, by SIGTERM or Ctrl-C.
///
/// # Errors
/// Where the signals cannot be listened for.
pub fn told_to_stop() -> io::Result<impl Future<Output = ()>> {
    use tokio::signal::unix::{SignalKind, signal};
    let (mut terminate, mut interrupt) = (signal(SignalKind::terminate())?, signal(SignalKind::interrupt())?);
    Ok(async move {
        tokio::select! {
            _ = terminate.recv() => {}
            _ = interrupt.recv() => {}
        }
    })
}

/// What the app answers never fails as a service.
const _: fn() = || {
    fn infallible<T: tower::Service<hyper::Request<axum::body::Body>, Error = Infallible>>() {}
    infallible::<Router>();
};
