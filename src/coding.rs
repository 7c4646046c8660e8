//! Codings of a request body (RFC 9110, section 8.4): it is unpacked while it is read, so that the bounds of its readers hold for what
//! comes out.

use std::io;

use async_compression::tokio::bufread::{GzipDecoder, ZlibDecoder, ZstdDecoder};
use async_compression::zstd::DParameter;
use axum::body::{Body, HttpBody};
use axum::http::HeaderMap;
use axum::http::header::{CONTENT_ENCODING, CONTENT_LENGTH};
use http_body_util::{BodyDataStream, BodyExt};
use tokio::io::AsyncRead;
use tokio_util::io::{ReaderStream, StreamReader};

/// What is unpacked, as the header Accept-Encoding names it.
pub(crate) const TAKEN: &str = "gzip, deflate, zstd";

/// What is unpacked at a time (bytes).
const PIECE: usize = 16 << 10;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coding {
    Identity,
    Gzip,
    Deflate,
    Zstd,
}

/// Largest window of a zstd body, as a power of two (bytes): what RFC 8878 asks every decoder to take, and so its memory.
const ZSTD_WINDOW: u32 = 23;

/// A body has a coding that is not unpacked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UnknownCoding;

/// The body without its coding, and without the headers that no longer hold for it.
///
/// # Errors
/// [`UnknownCoding`] for a coding that is not unpacked, and for several on top of each other.
pub(crate) fn unpacked(body: Body, headers: &mut HeaderMap) -> Result<Body, UnknownCoding> {
    if body.is_end_stream() {
        return Ok(body); // there is nothing that could be packed
    }
    let coding = coding(headers)?;
    if headers.remove(CONTENT_ENCODING).is_none() || coding == Coding::Identity {
        return Ok(body);
    }
    headers.remove(CONTENT_LENGTH);
    let packed = StreamReader::new(BodyDataStream::new(body.map_err(io::Error::other)));
    Ok(match coding {
        Coding::Identity | Coding::Gzip => {
            let mut decoder = GzipDecoder::new(packed);
            decoder.multiple_members(true);
            streamed(decoder)
        }
        Coding::Deflate => streamed(ZlibDecoder::new(packed)),
        Coding::Zstd => {
            let mut decoder = ZstdDecoder::with_params(packed, &[DParameter::window_log_max(ZSTD_WINDOW)]);
            decoder.multiple_members(true);
            streamed(decoder)
        }
    })
}

fn streamed(decoder: impl AsyncRead + Send + 'static) -> Body {
    Body::from_stream(ReaderStream::with_capacity(decoder, PIECE))
}

fn coding(headers: &HeaderMap) -> Result<Coding, UnknownCoding> {
    let mut codings = headers.get_all(CONTENT_ENCODING).iter();
    match (codings.next(), codings.next()) {
        (None, _) => Ok(Coding::Identity),
        (Some(coding), None) => match coding.as_bytes().trim_ascii().to_ascii_lowercase().as_slice() {
            b"" | b"identity" => Ok(Coding::Identity),
            b"gzip" | b"x-gzip" => Ok(Coding::Gzip),
            b"deflate" => Ok(Coding::Deflate),
            b"zstd" => Ok(Coding::Zstd),
            _ => Err(UnknownCoding),
        },
        (Some(_), Some(_)) => Err(UnknownCoding),
    }
}
