//! Answers packed on their way out, for clients that take them so.

use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};

use async_compression::Level;
use async_compression::tokio::bufread::{GzipEncoder, ZstdEncoder};
use axum::body::{Body, Bytes, HttpBody};
use axum::http::header::{CONTENT_ENCODING, CONTENT_LENGTH, CONTENT_TYPE};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::Response;
use http_body_util::{BodyDataStream, BodyExt};
use hyper::body::Frame;
use tokio::io::AsyncRead;
use tokio_util::io::{ReaderStream, StreamReader};

use crate::accepted::Accepted;
use crate::budget::{Budget, Share};
use crate::fixed::{InItsForm, SHORT};

/// What is packed on the way, the fastest first.
const OFFERED: [Accepted; 2] = [Accepted::Zstd, Accepted::Gzip];

/// Memory of a packer (bytes): that of zstd at its fastest, with a window of 512 KiB; gzip takes less.
const PACKER: usize = 1 << 20;

/// What is packed between two turns of the other connections of a thread (bytes, as they come out).
const PIECE: usize = 16 << 10;

/// The coding in which a client wants its answer.
pub(crate) fn wanted(request: &HeaderMap) -> Option<Accepted> {
    Accepted::best_of(&OFFERED, request)
}

/// Packs an answer, if it is long and of text, and there is memory for it; else it goes as it is. A stream goes as it is, because
/// its rows are not to wait for each other. Says in which coding the answer goes.
pub(crate) fn pack(response: &mut Response, coding: Accepted, budget: &Budget) -> Option<Accepted> {
    let length = response.body().size_hint().exact()?;
    let is_text = response.headers().get(CONTENT_TYPE).is_some_and(is_text);
    let is_free = !response.headers().contains_key(CONTENT_ENCODING) && response.extensions().get::<InItsForm>().is_none();
    if length < SHORT as u64 || !is_text || !is_free {
        return None;
    }
    let share = budget.share(PACKER)?;
    let body = std::mem::take(response.body_mut()).map_err(io::Error::other);
    let plain = StreamReader::new(BodyDataStream::new(body));
    *response.body_mut() = match coding {
        Accepted::Zstd => Packed::body(ZstdEncoder::with_quality(plain, Level::Fastest), share),
        Accepted::Gzip => Packed::body(GzipEncoder::with_quality(plain, Level::Fastest), share),
        Accepted::Brotli => return None,
    };
    response.headers_mut().remove(CONTENT_LENGTH);
    response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static(coding.name()));
    Some(coding)
}

fn is_text(media_type: &HeaderValue) -> bool {
    let media_type = media_type.to_str().unwrap_or("");
    media_type.starts_with("text/") || media_type.contains("json") || media_type.contains("openmetrics-text")
}

/// A body that is packed as it is taken.
struct Packed {
    pieces: Body,
    /// The others have had their turn since the last piece.
    has_yielded: bool,
    _share: Share,
}

impl Packed {
    fn body(packer: impl AsyncRead + Send + 'static, share: Share) -> Body {
        let pieces = Body::from_stream(ReaderStream::with_capacity(packer, PIECE));
        Body::new(Self { pieces, has_yielded: true, _share: share })
    }
}

impl HttpBody for Packed {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        if !std::mem::replace(&mut self.has_yielded, true) {
            context.waker().wake_by_ref();
            return Poll::Pending;
        }
        let piece = ready!(Pin::new(&mut self.pieces).poll_frame(context));
        self.has_yielded = false;
        Poll::Ready(piece)
    }
}
