//! What the process is told by signals.

use std::io;

use tokio::signal::unix::{Signal, SignalKind, signal};

/// Done when the process is told to stop, by SIGTERM or SIGINT. A second one ends it at once, with 128 and the number of the
/// signal as the exit code. SIGHUP changes nothing: there is no file to be read anew.
///
/// # Errors
/// Where the signals cannot be listened for.
pub fn told_to_stop() -> io::Result<impl Future<Output = ()>> {
    let mut stops = Stops { terminate: signal(SignalKind::terminate())?, interrupt: signal(SignalKind::interrupt())? };
    let mut hang_up = signal(SignalKind::hangup())?;
    Ok(async move {
        loop {
            tokio::select! {
                _ = stops.next() => break,
                _ = hang_up.recv() => tracing::info!("SIGHUP changes nothing: settings are read at the start alone"),
            }
        }
        tokio::spawn(async move {
            let kind = stops.next().await;
            tracing::warn!("told to stop a second time: open requests are cut off");
            std::process::exit(128 + kind.as_raw_value());
        });
    })
}

struct Stops {
    terminate: Signal,
    interrupt: Signal,
}

impl Stops {
    async fn next(&mut self) -> SignalKind {
        tokio::select! {
            _ = self.terminate.recv() => SignalKind::terminate(),
            _ = self.interrupt.recv() => SignalKind::interrupt(),
        }
    }
}
