//! The log: lines on stderr for which nothing waits.
//!
//! Whoever reads stderr may be slow, stuck or gone, and a full disk takes nothing. So lines go through a bounded queue to a thread
//! of their own. A line that finds the queue full, or that cannot be written, is dropped and counted; the log tells of it when it
//! flows again.

use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, LazyLock};
use std::time::Duration;

use prometheus_client::metrics::counter::Counter;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;

use crate::config::{LogFormat, Serve};

/// Room for lines that wait to be written (bytes).
const ROOM: usize = 1 << 20;

/// What a waiting line takes beside its text (bytes).
const BESIDE: usize = 64;

/// Time that waiting lines are given when the program ends.
const LAST_LINES: Duration = Duration::from_secs(1);

/// Lines that were dropped; a process has one log.
static DROPPED: LazyLock<Counter> = LazyLock::new(Counter::default);

/// The counter of the lines that were dropped.
pub(crate) fn dropped() -> Counter {
    DROPPED.clone()
}

/// The running log. When it is dropped, the lines that wait are written, if that takes no longer than a second.
#[derive(Debug)]
pub struct Log {
    lines: Arc<Lines>,
}

impl Log {
    /// Starts the log, and sends panics there.
    ///
    /// # Errors
    /// The message to refuse a filter with, or why there is no thread.
    pub fn start(settings: &Serve) -> Result<Self, String> {
        let filter: Targets = settings.log.parse().map_err(|error| format!("--log: {error}"))?;
        let lines = Arc::new(Lines::to(io::stderr()).map_err(|error| format!("no thread for the log: {error}"))?);
        // What the subscriber has to say of itself it would print, and panic where stderr is closed.
        let log = tracing_subscriber::fmt()
            .with_max_level(LevelFilter::TRACE) // the filter decides
            .with_ansi(io::stderr().is_terminal())
            .log_internal_errors(false)
            .with_writer(lines.clone());
        match settings.log_format {
            LogFormat::Text => log.finish().with(filter).init(),
            LogFormat::Json => log.json().flatten_event(true).finish().with(filter).init(),
        }
        // The hook of the standard library writes to stderr itself, and would wait for it.
        std::panic::set_hook(Box::new(|panic| {
            let place = panic.location().map(ToString::to_string);
            tracing::error!(cause = panic.payload_as_str().unwrap_or("unknown"), place, "a thread panicked");
        }));
        Ok(Self { lines })
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        self.lines.wait_until_written(LAST_LINES);
    }
}

enum Message {
    Line(Box<[u8]>),
    /// Asks for an answer when all lines before are written.
    End(SyncSender<()>),
}

/// The way to the thread that writes.
#[derive(Debug)]
struct Lines {
    queue: Sender<Message>,
    /// What waits (bytes).
    waiting: Arc<AtomicUsize>,
}

impl Lines {
    fn to(out: impl Write + Send + 'static) -> io::Result<Self> {
        let (queue, lines) = channel();
        let waiting = Arc::new(AtomicUsize::new(0));
        let written = waiting.clone();
        std::thread::Builder::new().name("log".into()).spawn(move || write(&lines, &written, out))?;
        Ok(Self { queue, waiting })
    }

    fn put(&self, line: &[u8]) {
        let weight = line.len() + BESIDE;
        if self.waiting.fetch_add(weight, Ordering::Relaxed) + weight > ROOM
            || self.queue.send(Message::Line(line.into())).is_err()
        {
            self.waiting.fetch_sub(weight, Ordering::Relaxed);
            DROPPED.inc();
        }
    }

    fn wait_until_written(&self, patience: Duration) {
        let (written, answer) = sync_channel(1);
        if self.queue.send(Message::End(written)).is_ok() {
            let _ = answer.recv_timeout(patience);
        }
    }
}

/// The subscriber writes each line in one piece.
impl Write for &Lines {
    fn write(&mut self, line: &[u8]) -> io::Result<usize> {
        self.put(line);
        Ok(line.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn write(lines: &Receiver<Message>, waiting: &AtomicUsize, mut out: impl Write) {
    let mut told = 0;
    for message in lines {
        match message {
            Message::Line(line) => {
                let written = out.write_all(&line);
                waiting.fetch_sub(line.len() + BESIDE, Ordering::Relaxed);
                if written.is_err() {
                    DROPPED.inc();
                } else if DROPPED.get() > told {
                    told = DROPPED.get();
                    tracing::warn!(total = told, "lines of the log were dropped");
                }
            }
            Message::End(written) => {
                let _ = written.send(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes nothing before it is told to.
    struct Stuck(Receiver<()>, Arc<std::sync::Mutex<Vec<u8>>>);

    impl Write for Stuck {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let _ = self.0.recv(); // at once after the sender has gone
            self.1.lock().expect("no panic").write(bytes)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn lines_beyond_the_room_are_dropped_and_those_before_are_written() {
        let (release, wait) = channel();
        let text = Arc::new(std::sync::Mutex::new(Vec::new()));
        let lines = Lines::to(Stuck(wait, text.clone())).expect("a thread");
        let line = [b'x'; 1000];
        let before = DROPPED.get();
        let most = ROOM / (line.len() + BESIDE);
        (0..most + 10).for_each(|_| lines.put(&line));
        assert!(DROPPED.get() >= before + 10, "those that find no room");
        lines.wait_until_written(Duration::from_millis(10)); // and does not wait for longer
        drop(release);
        lines.wait_until_written(Duration::from_secs(60));
        assert_eq!(text.lock().expect("no panic").len(), most * line.len());
        lines.put(b"flows again");
        lines.wait_until_written(Duration::from_secs(60));
        assert!(text.lock().expect("no panic").ends_with(b"flows again"));
    }
}
