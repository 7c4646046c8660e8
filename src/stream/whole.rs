//! Questions that are there as a whole before their answer begins.
//!
//! A proxy may stop to send a question as soon as its answer begins: nginx does, and the rows that it had not sent are lost. Many
//! clients read nothing before they have sent all. So a question that came by a proxy is kept, in memory while it is small and else
//! in a file without a name, and answered from there when it has ended; and so is one whose length was declared, for it is no live
//! stream. Where there is no room for the latter, its answer begins early.

use std::io::{self, Cursor};
use std::pin::Pin;
use std::task::{Context, Poll};

use axum::body::Body;
use axum::http::request::Parts;
use axum::http::{HeaderMap, HeaderName, Version, header};
use http_body_util::{BodyDataStream, BodyExt};
use tokio::fs::File;
use tokio::io::{AsyncRead, AsyncReadExt, AsyncSeekExt, AsyncWriteExt, ReadBuf};
use tokio_util::io::{ReaderStream, StreamReader};

use super::incoming::Incoming;
use crate::budget::{Budget, Share};
use crate::http1::Declared;
use crate::limits::{Begin, Limits};
use crate::problem::Problem;

/// What proxies say of themselves.
const SIGNS: [HeaderName; 6] = [
    header::VIA,
    header::FORWARDED,
    HeaderName::from_static("x-forwarded-for"),
    HeaderName::from_static("x-forwarded-host"),
    HeaderName::from_static("x-forwarded-proto"),
    HeaderName::from_static("x-real-ip"),
];

/// Longest question that is kept in memory, and what goes into a file at a time (bytes).
const IN_MEMORY: usize = 256 << 10;

/// What is read of a file at a time (bytes).
const PIECE: usize = 64 << 10;

/// Whether a request came by a proxy. nginx as it comes says so only by speaking HTTP/1.0.
fn is_relayed(version: Version, headers: &HeaderMap) -> bool {
    version < Version::HTTP_11 || SIGNS.iter().any(|sign| headers.contains_key(sign))
}

/// The body to answer: the one that still arrives, or one that is there.
///
/// # Errors
/// What is wrong with a body that is awaited; [`Problem::TooLarge`] or [`Problem::Crowded`] where one that has to be whole finds no
/// room.
pub(crate) async fn ready(parts: &Parts, body: Body, room: &Budget, limits: &Limits) -> Result<Body, Problem> {
    let has_to_wait = match limits.stream_begin {
        Begin::Auto => is_relayed(parts.version, &parts.headers),
        Begin::Early => return Ok(body),
        Begin::AfterBody => true,
    };
    let is_declared = parts.headers.contains_key(header::CONTENT_LENGTH) || parts.extensions.get::<Declared>().is_some();
    if !has_to_wait && !is_declared {
        return Ok(body);
    }
    let mut question = Question { incoming: Incoming::new(body, limits), kept: Kept::default() };
    match question.keep(room, limits).await? {
        Some(no_room) if has_to_wait => Err(no_room),
        _ => question.into_body().await,
    }
}

/// A question that is being kept.
struct Question {
    incoming: Incoming,
    kept: Kept,
}

impl Question {
    /// Keeps all that comes, or as much as finds room, with the problem that this is. After an error what was kept may be incomplete.
    async fn keep(&mut self, room: &Budget, limits: &Limits) -> Result<Option<Problem>, Problem> {
        while !self.incoming.last {
            self.incoming.receive().await?;
            let piece = self.incoming.input.len();
            if self.kept.length + piece > limits.spool {
                return Ok(Some(Problem::TooLarge { limit: limits.spool }));
            }
            if self.kept.waiting.len() + piece > IN_MEMORY {
                let Some(share) = room.share(self.kept.waiting.len()) else { return Ok(Some(Problem::Crowded)) };
                self.kept.write(share).await?;
            }
            self.kept.length += piece;
            self.kept.waiting.extend_from_slice(&std::mem::take(&mut self.incoming.input));
        }
        Ok(None)
    }

    /// What was kept, and what still comes behind it.
    async fn into_body(self) -> Result<Body, Problem> {
        let Self { incoming, kept: Kept { waiting, file, .. } } = self;
        let is_whole = incoming.last && incoming.input.is_empty();
        let Some((mut file, share)) = file else {
            return Ok(if is_whole { waiting.into() } else { streamed(Cursor::new(waiting).chain(rest(incoming))) });
        };
        file.rewind().await.map_err(|error| no_room(&error))?;
        let kept = Spooled { file, _share: share }.chain(Cursor::new(waiting));
        Ok(if is_whole { streamed(kept) } else { streamed(kept.chain(rest(incoming))) })
    }
}

fn rest(incoming: Incoming) -> impl AsyncRead + Send + 'static {
    let (input, body) = incoming.into_rest();
    Cursor::new(input).chain(StreamReader::new(BodyDataStream::new(body.map_err(io::Error::other))))
}

fn streamed(reader: impl AsyncRead + Send + 'static) -> Body {
    Body::from_stream(ReaderStream::with_capacity(reader, PIECE))
}

/// What is kept of a question: first the file, then what waits to be written.
#[derive(Default)]
struct Kept {
    waiting: Vec<u8>,
    file: Option<(File, Share)>,
    length: usize,
}

impl Kept {
    /// Moves what waits to the file.
    async fn write(&mut self, share: Share) -> Result<(), Problem> {
        let file = match &mut self.file {
            Some((file, all)) => {
                all.join(share);
                file
            }
            None => {
                let made = tokio::task::spawn_blocking(tempfile::tempfile).await.map_err(io::Error::other).flatten();
                let file = File::from_std(made.map_err(|error| no_room(&error))?);
                &mut self.file.insert((file, share)).0
            }
        };
        file.write_all(&self.waiting).await.map_err(|error| no_room(&error))?;
        // The file writes behind the caller's back; only a flush tells that it could not.
        file.flush().await.map_err(|error| no_room(&error))?;
        self.waiting.clear();
        Ok(())
    }
}

/// The disk is full, or there is no directory for temporary files.
fn no_room(error: &io::Error) -> Problem {
    tracing::error!(%error, "a body could not be kept in the directory for temporary files");
    Problem::Crowded
}

/// A file with its share of the room.
struct Spooled {
    file: File,
    _share: Share,
}

impl AsyncRead for Spooled {
    fn poll_read(mut self: Pin<&mut Self>, context: &mut Context<'_>, into: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.file).poll_read(context, into)
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use axum::body::Bytes;
    use axum::http::{HeaderValue, Request};
    use http_body_util::{BodyExt, channel};

    use super::*;

    fn bytes(length: usize) -> Vec<u8> {
        (0..length).map(|i| (i % 251) as u8).collect()
    }

    fn in_pieces(whole: Vec<u8>, piece: usize) -> Body {
        let (mut sender, receiver) = channel::Channel::<Bytes, Infallible>::new(1);
        tokio::spawn(async move {
            for piece in whole.chunks(piece) {
                if sender.send_data(Bytes::copy_from_slice(piece)).await.is_err() {
                    return;
                }
            }
        });
        Body::new(receiver)
    }

    async fn keep(length: usize, piece: usize, room: &Budget, spool: usize) -> Result<Body, Problem> {
        let limits = Limits { spool, stream_begin: Begin::AfterBody, ..Limits::default() };
        let (parts, ()) = Request::new(()).into_parts();
        ready(&parts, in_pieces(bytes(length), piece), room, &limits).await
    }

    fn run<T>(work: impl Future<Output = T>) -> T {
        tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime").block_on(work)
    }

    #[test]
    fn a_question_is_read_as_it_was_sent_and_gives_its_room_back() {
        const ROOM: usize = 4 << 20;
        for (length, piece) in
            [(0, 1), (1, 1), (IN_MEMORY, 10_000), (IN_MEMORY + 1, 10_000), (3 << 20, 70_001), (2 << 20, 2 << 20)]
        {
            run(async {
                let room = Budget::new(ROOM);
                let body = keep(length, piece, &room, ROOM).await.expect("it fits");
                let taken = ROOM - room.free();
                let in_memory = length - taken.min(length);
                assert!(in_memory <= IN_MEMORY.max(piece), "{length} in {piece}: {taken} in the file");
                assert_eq!(body.collect().await.expect("a file").to_bytes(), bytes(length), "{length} in {piece}");
                assert_eq!(room.free(), ROOM);
            });
        }
    }

    #[test]
    fn a_question_that_finds_no_room_is_refused() {
        run(async {
            let room = Budget::new(1 << 20);
            assert_eq!(keep(2 << 20, 70_000, &room, 1 << 20).await.err(), Some(Problem::TooLarge { limit: 1 << 20 }));
            let others = room.share(900 << 10).expect("most of it");
            assert_eq!(keep(600 << 10, 70_000, &room, 1 << 20).await.err(), Some(Problem::Crowded));
            drop(others);
            assert_eq!(room.free(), 1 << 20);
        });
    }

    #[test]
    fn a_question_of_declared_length_that_finds_no_room_is_answered_as_it_comes() {
        run(async {
            for (length, piece, spool) in [(3 << 20, 70_001, 1 << 20), (1 << 20, 10_000, 1000), (1 << 20, 300_000, 8 << 20)] {
                let room = Budget::new(1 << 20);
                let _others = room.share(100 << 10).expect("some of it");
                let limits = Limits { spool, ..Limits::default() };
                let (mut parts, ()) = Request::new(()).into_parts();
                parts.extensions.insert(Declared);
                let body = ready(&parts, in_pieces(bytes(length), piece), &room, &limits).await.expect("an early answer");
                assert!(body.collect().await.expect("a body").to_bytes() == bytes(length), "{length} in {piece}");
            }
        });
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_disk_that_is_full_is_told_before_the_answer() {
        run(async {
            let room = Budget::new(1 << 20);
            let full = File::options().write(true).open("/dev/full").await.expect("a device that is always full");
            let share = |bytes| room.share(bytes).expect("room");
            let mut kept = Kept { waiting: bytes(1000), file: Some((full, share(1))), length: 1000 };
            assert_eq!(kept.write(share(1000)).await.err(), Some(Problem::Crowded));
        });
    }

    #[test]
    fn a_proxy_is_known_by_its_headers_or_its_version() {
        let asked = |version, name: Option<&'static str>| {
            let mut request = Request::builder().version(version);
            if let Some(name) = name {
                request = request.header(name, HeaderValue::from_static("1.1 proxy"));
            }
            let (parts, ()) = request.body(()).expect("a request").into_parts();
            is_relayed(parts.version, &parts.headers)
        };
        assert!(!asked(Version::HTTP_11, None) && !asked(Version::HTTP_11, Some("user-agent")));
        assert!(asked(Version::HTTP_10, None));
        for sign in ["Via", "Forwarded", "X-Forwarded-For", "X-Real-IP"] {
            assert!(asked(Version::HTTP_11, Some(sign)), "{sign}");
        }
    }
}
