//! The rest of a request body when the answer is already known.
//!
//! Many clients write the whole body before they read. If the connection were closed on them, they would see a reset and not the
//! answer; so a part of what they still send is read and thrown away.

use std::pin::Pin;
use std::task::{Context, Poll, ready};
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use axum::http::HeaderMap;
use axum::http::header::EXPECT;
use http_body_util::BodyExt;
use hyper::body::{Frame, SizeHint};
use tokio::runtime::Handle;

/// Most bytes that are read of a body that nobody needs.
const MOST: usize = 64 << 20;

/// Longest for which it is read.
const LONGEST: Duration = Duration::from_secs(2);

/// A body whose rest is read when it is dropped.
struct Rest {
    /// None after its end.
    body: Option<Body>,
    /// Whether the client sends anything: after `Expect: 100-continue` it waits until the body is asked for.
    is_sent: bool,
}

/// `body`, whose rest is read, within bounds, when nobody wants it.
pub(crate) fn read_to_its_end(body: Body, headers: &HeaderMap) -> Body {
    if body.is_end_stream() {
        return body;
    }
    Body::new(Rest { body: Some(body), is_sent: !headers.contains_key(EXPECT) })
}

impl HttpBody for Rest {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        self.is_sent = true;
        let Some(body) = &mut self.body else { return Poll::Ready(None) };
        let frame = ready!(Pin::new(body).poll_frame(context));
        if !matches!(frame, Some(Ok(_))) {
            self.body = None;
        }
        Poll::Ready(frame)
    }

    fn is_end_stream(&self) -> bool {
        self.body.as_ref().is_none_or(HttpBody::is_end_stream)
    }

    fn size_hint(&self) -> SizeHint {
        self.body.as_ref().map_or_else(|| SizeHint::with_exact(0), HttpBody::size_hint)
    }
}

impl Drop for Rest {
    fn drop(&mut self) {
        let Some(mut body) = self.body.take().filter(|body| self.is_sent && !body.is_end_stream()) else { return };
        let Ok(runtime) = Handle::try_current() else { return };
        runtime.spawn(tokio::time::timeout(LONGEST, async move {
            let mut left = MOST;
            while let Some(Ok(frame)) = body.frame().await {
                match left.checked_sub(frame.data_ref().map_or(0, Bytes::len)) {
                    Some(rest) => left = rest,
                    None => break,
                }
            }
        }));
    }
}
