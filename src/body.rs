//! Bodies that are read whole, within a time and a memory.

use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use http_body_util::BodyExt;
use tokio::time::{Instant, timeout, timeout_at};

use crate::budget::{Budget, Share};
use crate::problem::Problem;
use crate::server::TooSlow;
use crate::state::Service;

/// Largest body that needs no share of the budget (bytes). Most bodies are smaller, so they get in even when large ones use all
/// of it.
const SMALL: usize = 8 << 10;

/// A body that was read, with its share of the budget.
pub(crate) struct Text {
    pub(crate) bytes: Bytes,
    _share: Option<Share>,
}

/// The whole of a body; its head declares a length of `declared` bytes, if any.
///
/// # Errors
/// [`Problem::TooLarge`], [`Problem::SlowBody`], [`Problem::BrokenBody`], and [`Problem::Crowded`] where the bodies of others
/// left too little memory for as long as a body may take to arrive.
pub(crate) async fn read(body: Body, declared: Option<usize>, service: &Service) -> Result<Text, Problem> {
    let (limit, time) = (service.limits().body, service.limits().body_deadline);
    if declared.is_some_and(|length| length > limit) {
        return Err(Problem::TooLarge { limit });
    }
    collected(body, declared.unwrap_or(limit), service.bodies(), time).await
}

/// The whole of a body of at most so many bytes. A large one takes its share for all of them as soon as it is known to be large:
/// bodies that waited for more while they hold a part could keep each other waiting. That wait is no fault of the client, and
/// does not count against the time in which the body has to arrive.
async fn collected(mut body: Body, most: usize, budget: &Budget, time: Duration) -> Result<Text, Problem> {
    let mut deadline = Instant::now() + time;
    let mut bytes = Vec::new();
    let mut share = None;
    while let Some(frame) = timeout_at(deadline, body.frame()).await.map_err(|_| Problem::SlowBody(time))? {
        let Ok(data) = frame.map_err(|error| problem(&error))?.into_data() else { continue };
        let length = bytes.len() + data.len();
        if length > most {
            return Err(Problem::TooLarge { limit: most });
        }
        if length > SMALL && share.is_none() {
            let asked = Instant::now();
            share = Some(timeout(time, budget.share_when_free(most)).await.map_err(|_| Problem::Crowded)?);
            deadline += asked.elapsed();
            bytes.reserve_exact(most - bytes.len());
        } else if bytes.is_empty() && body.is_end_stream() {
            return Ok(Text { bytes: data, _share: None });
        }
        bytes.extend_from_slice(&data);
    }
    Ok(Text { bytes: bytes.into(), _share: share })
}

/// Why a body could not be received.
pub(crate) fn problem(error: &axum::Error) -> Problem {
    // Each reader on the way may have wrapped it.
    let causes = std::iter::successors(std::error::Error::source(error), |cause| cause.source());
    match causes.into_iter().find_map(|cause| cause.downcast_ref()) {
        Some(TooSlow(slowest)) => Problem::Crawling(*slowest),
        None => Problem::BrokenBody,
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;

    const LIMIT: usize = 1 << 20;
    const LONG: Duration = Duration::from_secs(60);

    fn in_pieces(whole: &'static [u8], piece: usize) -> Body {
        let (mut sender, receiver) = http_body_util::channel::Channel::<Bytes, Infallible>::new(1);
        tokio::spawn(async move {
            for piece in whole.chunks(piece) {
                if sender.send_data(Bytes::from_static(piece)).await.is_err() {
                    return;
                }
            }
        });
        Body::new(receiver)
    }

    fn collect(whole: &'static [u8], piece: usize, most: usize, budget: &Budget, time: Duration) -> Result<Text, Problem> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build().expect("a runtime");
        runtime.block_on(async { collected(in_pieces(whole, piece), most, budget, time).await })
    }

    static WHOLE: [u8; LIMIT] = {
        let mut whole = [0; LIMIT];
        let mut i = 0;
        while i < LIMIT {
            whole[i] = (i % 251) as u8;
            i += 1;
        }
        whole
    };

    #[test]
    fn a_body_in_pieces_comes_whole_and_gives_its_share_back() {
        for (length, piece) in [(0, 1), (100, 100), (100, 7), (SMALL, 1000), (SMALL + 1, 1000), (LIMIT, 30_000), (LIMIT, LIMIT)] {
            for most in [LIMIT, length] {
                let budget = Budget::new(2 * LIMIT);
                let text = collect(&WHOLE[..length], piece, most, &budget, LONG).expect("a body");
                assert_eq!(text.bytes, WHOLE[..length]);
                let taken = 2 * LIMIT - budget.free();
                assert!(if length > SMALL { taken >= most } else { taken == 0 }, "{length} in {piece}: {taken}");
                drop(text);
                assert_eq!(budget.free(), 2 * LIMIT);
            }
        }
    }

    #[test]
    fn a_body_that_finds_no_memory_is_refused_unless_it_is_small() {
        let budget = Budget::new(LIMIT);
        let _all = budget.share(LIMIT);
        assert_eq!(collect(&WHOLE, 30_000, LIMIT, &budget, Duration::from_millis(20)).err(), Some(Problem::Crowded));
        assert!(collect(&WHOLE[..SMALL], 1000, LIMIT, &budget, LONG).is_ok());
    }

    #[test]
    fn a_body_without_a_length_is_taken_up_to_the_limit() {
        let too_long: &'static [u8] = vec![0; LIMIT + 1].leak();
        assert_eq!(collect(too_long, 1000, LIMIT, &Budget::new(2 * LIMIT), LONG).err(), Some(Problem::TooLarge { limit: LIMIT }));
    }
}
