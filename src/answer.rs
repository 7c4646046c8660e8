//! Answers as text, JSON or a table.
//!
//! A large one is written in pieces, each of which is freed as soon as its client has taken it. All that wait to be taken
//! have to fit into one budget of memory, whoever reads however slowly.

use std::collections::VecDeque;
use std::io;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll};

use axum::body::{Body, Bytes, HttpBody};
use axum::http::header::CONTENT_TYPE;
use axum::http::{HeaderName, HeaderValue};
use axum::response::{IntoResponse, Response};
use hyper::body::{Frame, SizeHint};
use serde::Serialize;

use crate::budget::{Budget, Share};
use crate::extract::Format;
use crate::problem::Problem;
use crate::quantity::write_table;
use crate::reply::Reply;

/// The media type of an answer in JSON, and of one that is a table.
pub(crate) const JSON: &str = "application/json";
pub(crate) const CSV: &str = "text/csv; charset=utf-8; header=present";

/// The codes of the warnings of an answer that is a table.
pub(crate) const WARNINGS: HeaderName = HeaderName::from_static("x-warnings");

/// Largest piece, and largest answer that needs no share of the budget (bytes).
const PIECE: usize = 64 << 10;

/// Room that an answer is begun with (bytes): enough for most.
const FIRST: usize = 2 << 10;

/// A reply in the format that was asked for.
pub(crate) fn written<R: Reply>(reply: &R, format: Format) -> Result<Response, Problem> {
    match format {
        Format::Json => json(reply),
        Format::Csv => {
            let mut response = csv_text(text(|pieces| write_table(&reply.columns(), pieces))?);
            // A table has no place for warnings, so their codes travel beside it, each once.
            let mut codes: Vec<&str> = Vec::new();
            for warning in reply.warnings() {
                if !codes.contains(&warning.code()) {
                    codes.push(warning.code());
                }
            }
            if let Ok(codes) = HeaderValue::from_str(&codes.join(", "))
                && !codes.is_empty()
            {
                response.headers_mut().insert(WARNINGS, codes);
            }
            Ok(response)
        }
    }
}

/// A value as JSON.
pub(crate) fn json<T: Serialize>(value: &T) -> Result<Response, Problem> {
    text(|pieces| serde_json::to_writer(pieces, value).map_err(io::Error::from)).map(json_text)
}

/// A text that is a table.
pub(crate) fn csv_text(text: impl IntoResponse) -> Response {
    ([(CONTENT_TYPE, HeaderValue::from_static(CSV))], text).into_response()
}

/// A text that is JSON.
pub(crate) fn json_text(text: impl IntoResponse) -> Response {
    ([(CONTENT_TYPE, HeaderValue::from_static(JSON))], text).into_response()
}

/// An answer that was written, as it may be sent: a large one takes its share of the budget, piece by piece.
///
/// # Errors
/// [`Problem::Crowded`] where the others that wait to be taken leave too little.
pub(crate) fn admitted(mut response: Response, budget: &Budget) -> Result<Response, Problem> {
    let Some(Large(pieces)) = response.extensions_mut().remove() else { return Ok(response) };
    let mut pieces = pieces.lock().unwrap_or_else(PoisonError::into_inner);
    let mut share = budget.share(pieces.bytes()).ok_or(Problem::Crowded)?;
    // From the end: where the answer is larger than the whole budget, its last pieces hold it until all were taken.
    for piece in pieces.0.iter_mut().rev() {
        let _share = share.split(piece.len());
        let bytes = std::mem::take(piece);
        *piece = Bytes::from_owner(Held { bytes, _share });
    }
    drop(pieces);
    Ok(response)
}

/// What `write` writes.
fn text(write: impl FnOnce(&mut Writer) -> io::Result<()>) -> Result<Response, Problem> {
    let mut writer = Writer { done: VecDeque::new(), piece: Vec::with_capacity(FIRST) };
    write(&mut writer).map_err(|error| {
        tracing::error!(%error, "a reply could not be written");
        Problem::Internal
    })?;
    if writer.done.is_empty() {
        return Ok(Body::from(writer.piece).into_response());
    }
    writer.done.push_back(writer.piece.into());
    let pieces = Arc::new(Mutex::new(Pieces(writer.done)));
    let mut response = Body::new(Sending(pieces.clone())).into_response();
    response.extensions_mut().insert(Large(pieces));
    Ok(response)
}

/// Collects a text in pieces.
struct Writer {
    done: VecDeque<Bytes>,
    piece: Vec<u8>,
}

impl io::Write for Writer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.piece.len() + bytes.len() > PIECE && !self.piece.is_empty() {
            self.done.push_back(std::mem::replace(&mut self.piece, Vec::with_capacity(PIECE)).into());
        }
        // What is longer than a piece comes in several.
        let bytes = &bytes[..bytes.len().min(PIECE)];
        self.piece.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn write_all(&mut self, mut bytes: &[u8]) -> io::Result<()> {
        // Nearly always at once: an answer is written in bits of a few bytes.
        while self.piece.len() + bytes.len() > PIECE {
            let written = self.write(bytes)?;
            bytes = &bytes[written..];
        }
        self.piece.extend_from_slice(bytes);
        Ok(())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The pieces of an answer that are still to be sent.
struct Pieces(VecDeque<Bytes>);

impl Pieces {
    fn bytes(&self) -> usize {
        self.0.iter().map(Bytes::len).sum()
    }
}

/// Marks an answer that needs a share of the budget.
#[derive(Clone)]
struct Large(Arc<Mutex<Pieces>>);

/// A piece with its share of the budget, both given back when it was sent.
struct Held {
    bytes: Bytes,
    _share: Option<Share>,
}

impl AsRef<[u8]> for Held {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

/// A body of pieces.
struct Sending(Arc<Mutex<Pieces>>);

impl HttpBody for Sending {
    type Data = Bytes;
    type Error = std::convert::Infallible;

    fn poll_frame(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, Self::Error>>> {
        let piece = self.0.lock().unwrap_or_else(PoisonError::into_inner).0.pop_front();
        Poll::Ready(piece.map(|piece| Ok(Frame::data(piece))))
    }

    fn is_end_stream(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).0.is_empty()
    }

    fn size_hint(&self) -> SizeHint {
        SizeHint::with_exact(self.0.lock().unwrap_or_else(PoisonError::into_inner).bytes() as u64)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use axum::body::to_bytes;

    use super::*;

    fn runtime() -> tokio::runtime::Runtime {
        tokio::runtime::Builder::new_current_thread().build().expect("a runtime")
    }

    /// A text of three pieces and a bit.
    fn long() -> Vec<u8> {
        (0..3 * PIECE + 100).map(|i| b'a' + (i % 26) as u8).collect()
    }

    #[test]
    fn a_long_text_comes_whole_however_it_is_written() {
        for step in [1, 1000, PIECE, PIECE + 1, 4 * PIECE] {
            let response = text(|out| long().chunks(step).try_for_each(|part| out.write_all(part))).expect("text");
            let body = response.into_body();
            assert_eq!(body.size_hint().exact(), Some(long().len() as u64));
            assert_eq!(runtime().block_on(to_bytes(body, usize::MAX)).expect("bytes"), long(), "in steps of {step}");
        }
    }

    #[test]
    fn the_share_of_a_piece_is_free_when_it_was_sent() {
        let budget = Budget::new(1 << 20);
        let response = admitted(text(|out| out.write_all(&long())).expect("text"), &budget).expect("room");
        let taken = |budget: &Budget| (1 << 20) - budget.free();
        assert!(taken(&budget) >= long().len());
        let mut body = response.into_body();
        let mut frame = || runtime().block_on(http_body_util::BodyExt::frame(&mut body)).expect("a frame").expect("no fault");
        let first = frame();
        let (before, length) = (taken(&budget), first.data_ref().expect("data").len());
        drop(first);
        assert_eq!(before - taken(&budget), length);
        drop(body);
        assert_eq!(taken(&budget), 0);
    }

    #[test]
    fn without_room_a_large_answer_is_refused_and_a_small_one_is_not() {
        let budget = Budget::new(1 << 20);
        let all = budget.share(1 << 20);
        let large = || text(|out| out.write_all(&long())).expect("text");
        assert_eq!(admitted(large(), &budget).err(), Some(Problem::Crowded));
        assert!(admitted(text(|out| out.write_all(b"small")).expect("text"), &budget).is_ok());
        drop(all);
        assert!(admitted(large(), &budget).is_ok());
    }
}
