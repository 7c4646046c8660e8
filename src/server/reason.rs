//! Why connections end.

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
