//! What one connection waits for, since when, and for how long it may.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use tokio::task::AbortHandle;
use tokio::time::Instant;

use super::pace::Pace;
use super::peer::Peer;
use super::{Bounds, Reason};

/// How long the connections of the reserve may stay silent. They are there for those who ask at once.
const RESERVE_WAIT: Duration = Duration::from_secs(2);

/// How long a head that has begun may take to arrive once the server stops.
const STOP_WAIT: Duration = Duration::from_secs(1);

/// Time after which a silent connection readily gives way to another. A new connection is about to send its request.
const FRESH: Duration = Duration::from_millis(20);

/// How long a client may leave the server waiting in the middle of a body or of an answer, before its connection may give way.
const HESITATION: Duration = Duration::from_secs(2);

/// How long a client may go on sending what nobody reads, so that it comes to read its answer.
const LINGER: Duration = Duration::from_secs(2);

/// A connection as the rest of the server sees it.
#[derive(Debug)]
pub(super) struct Link {
    pub(super) id: u64,
    pub(super) peer: Peer,
    /// Whether it has a place of the reserve.
    pub(super) is_reserve: bool,
    bounds: Bounds,
    state: Mutex<State>,
    /// Ends the task of the connection.
    task: OnceLock<AbortHandle>,
}

#[derive(Debug)]
struct State {
    phase: Phase,
    /// How fast the client takes output.
    output: Pace,
    /// Since when a body is waited for.
    upload: Option<Instant>,
    /// Whether a body was left before its end.
    is_unread: bool,
    /// Since when the server stops.
    stopping: Option<Instant>,
    reason: Option<Reason>,
}

/// Why a connection may give way to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Way {
    /// It waits for a head, or only to be closed.
    Idle,
    /// It neither sends nor takes what it began.
    Hesitant,
    /// It waits for a head, but has only just begun to.
    Fresh,
}

/// What is awaited.
#[derive(Debug, Clone, Copy)]
enum Phase {
    /// The first byte of a head.
    Silent { since: Instant, limit: Duration },
    /// The rest of a head.
    Head { silent: Instant, since: Instant },
    /// The server itself. Bodies have limits of their own.
    Answer,
    /// The end of what the client sends.
    Lingering { since: Instant },
}

impl Link {
    pub(super) fn new(id: u64, peer: Peer, is_reserve: bool, bounds: Bounds) -> Self {
        let limit = if is_reserve { RESERVE_WAIT.min(bounds.head_deadline) } else { bounds.head_deadline };
        let state = State {
            phase: Phase::Silent { since: Instant::now(), limit },
            output: Pace::new(bounds.slowest_download),
            upload: None,
            is_unread: false,
            stopping: None,
            reason: None,
        };
        Self { id, peer, is_reserve, bounds, state: Mutex::new(state), task: OnceLock::new() }
    }

    /// The state is consistent after each statement, so a panic elsewhere does not damage it.
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// The task of the connection, by which it can be ended.
    pub(super) fn runs_as(&self, task: AbortHandle) {
        let _ = self.task.set(task);
    }

    /// Ends the connection, whatever it does.
    pub(super) fn end(&self, reason: Reason) {
        self.close_for(reason);
        if let Some(task) = self.task.get() {
            task.abort();
        }
    }

    /// Notes why the connection is closed. The first reason counts.
    pub(super) fn close_for(&self, reason: Reason) {
        self.state().reason.get_or_insert(reason);
    }

    pub(super) fn reason(&self) -> Option<Reason> {
        self.state().reason
    }

    /// How readily the connection gives way to another, the least first; none where the server works for it.
    pub(super) fn gives_way(&self, now: Instant) -> Option<(Way, Instant)> {
        let state = self.state();
        let hesitates = |since: Instant| (since + HESITATION <= now).then_some((Way::Hesitant, since));
        if let Some(since) = state.output.since() {
            return hesitates(since);
        }
        match state.phase {
            Phase::Silent { since, .. } | Phase::Head { silent: since, .. } | Phase::Lingering { since } => {
                Some((if since + FRESH <= now { Way::Idle } else { Way::Fresh }, since))
            }
            Phase::Answer => state.upload.and_then(hesitates),
        }
    }

    /// Whether a request is being answered, or its answer taken.
    pub(super) fn is_busy(&self) -> bool {
        let state = self.state();
        matches!(state.phase, Phase::Answer) || state.output.since().is_some()
    }

    /// Something was read.
    pub(super) fn read(&self) {
        let mut state = self.state();
        if let Phase::Silent { since, .. } = state.phase {
            state.phase = Phase::Head { silent: since, since: Instant::now() };
        }
    }

    /// A request is there.
    pub(super) fn asked(&self) {
        self.state().phase = Phase::Answer;
    }

    /// The answer is complete. Some of it may still wait to be taken.
    pub(super) fn answered(&self) {
        self.state().phase = Phase::Silent { since: Instant::now(), limit: self.bounds.keep_alive };
    }

    /// The server waits for more of a body, or no longer.
    pub(super) fn awaits_body(&self, since: Option<Instant>) {
        self.state().upload = since;
    }

    /// A body was left before its end.
    pub(super) fn left_unread(&self) {
        self.state().is_unread = true;
    }

    /// The client took `bytes` of the output.
    pub(super) fn wrote(&self, bytes: usize) {
        let mut state = self.state();
        let waited = state.output.since().is_some();
        state.output.moved(bytes, Instant::now);
        if waited && let Phase::Silent { since, .. } = &mut state.phase {
            *since = Instant::now(); // the client read until now
        }
    }

    pub(super) fn output_waits(&self) -> bool {
        self.state().output.since().is_some()
    }

    /// Output waits for the client.
    pub(super) fn write_waits(&self) {
        self.state().output.wait(Instant::now);
    }

    /// Whether something that the client sent is to be read after the answer: closing over it would reset the connection,
    /// and the client might lose the answer.
    pub(super) fn lingers(&self) -> bool {
        let mut state = self.state();
        if state.is_unread && !matches!(state.phase, Phase::Lingering { .. }) {
            state.phase = Phase::Lingering { since: Instant::now() };
        }
        state.is_unread
    }

    /// From now on a head that has begun has little time.
    pub(super) fn stopping(&self) {
        self.state().stopping.get_or_insert_with(Instant::now);
    }

    /// When the connection is to be closed, should nothing happen until then.
    pub(super) fn deadline(&self) -> Option<Instant> {
        let state = self.state();
        if let Some(since) = state.output.since() {
            let stalled = since + self.bounds.write_deadline;
            return Some(state.output.judged_at().map_or(stalled, |judged| stalled.min(judged)));
        }
        let limit = match state.phase {
            Phase::Silent { since, limit } => since + limit,
            Phase::Head { since, .. } => since + self.bounds.head_deadline,
            Phase::Answer => return None,
            Phase::Lingering { since } => since + LINGER,
        };
        Some(state.stopping.map_or(limit, |stopping| limit.min(stopping + STOP_WAIT)))
    }

    /// Why the connection is to be closed now that its deadline has come; none if it may go on.
    pub(super) fn overdue(&self, now: Instant) -> Option<Reason> {
        let mut state = self.state();
        if let Some(since) = state.output.since() {
            let is_stalled = since + self.bounds.write_deadline <= now;
            return if is_stalled { Some(Reason::Stalled) } else { state.output.is_too_slow(now).then_some(Reason::SlowReader) };
        }
        let phase = state.phase;
        drop(state);
        if self.deadline().is_none_or(|deadline| deadline > now) {
            return None;
        }
        match phase {
            Phase::Silent { .. } => Some(Reason::Idle),
            Phase::Head { .. } => Some(Reason::SlowHead),
            Phase::Answer => None,
            Phase::Lingering { .. } => Some(Reason::Done),
        }
    }
}
