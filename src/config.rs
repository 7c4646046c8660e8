//! Settings: flags and environment variables, checked before anything starts.

use std::net::SocketAddr;
use std::time::Duration;

use axum::http::HeaderValue;
use clap::{Parser, Subcommand, ValueEnum};

use crate::limits::{Begin, Limits};
use crate::outside::Outside;
use crate::server::{Bounds, Slowest};

/// Forces of a wheel on soil, over HTTP: an API and a plotting page.
#[derive(Debug, Parser)]
#[command(name = "terramechanics", version, about, args_conflicts_with_subcommands = true)]
pub struct Config {
    /// What to do; without one, serve.
    #[command(subcommand)]
    pub command: Option<Command>,

    /// Settings of the server.
    #[command(flatten)]
    pub serve: Serve,
}

/// What to do instead of serving.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print the OpenAPI document.
    Openapi,
    /// Ask a running server whether it is ready; exit 0 if so, 1 if not.
    Healthcheck {
        /// Address of the server; where it listens on all interfaces, this machine's own is asked.
        #[arg(long, env = "TERRAMECHANICS_LISTEN", default_value = DEFAULT_ADDRESS)]
        listen: SocketAddr,
        /// Seconds to wait for the answer.
        #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..=60))]
        timeout: u64,
    },
}

const DEFAULT_ADDRESS: &str = "127.0.0.1:8080";

/// Settings of the server.
#[derive(Debug, Clone, clap::Args)]
pub struct Serve {
    /// Address to listen on; port 0 takes a free one.
    #[arg(long, env = "TERRAMECHANICS_LISTEN", default_value = DEFAULT_ADDRESS, value_name = "IP:PORT")]
    pub listen: SocketAddr,

    /// Where clients find the service, with the path of a proxy in front, e.g. `https://example.org/soil`. The contract names it.
    #[arg(long, env = "TERRAMECHANICS_PUBLIC_URL", value_parser = public_url, value_name = "URL")]
    pub public_url: Option<String>,

    /// Origin of pages elsewhere whose scripts may read the answers, e.g. `https://example.org`; several with commas, `*` for
    /// all. Without one, browsers let only the page of the service read them.
    #[arg(long, env = "TERRAMECHANICS_CORS_ORIGIN", value_delimiter = ',', value_parser = origin, value_name = "ORIGIN")]
    pub cors_origin: Vec<HeaderValue>,

    /// What to log, e.g. info, debug, or terramechanics_server=debug,info.
    #[arg(long, env = "TERRAMECHANICS_LOG", default_value = "info", value_name = "FILTER")]
    pub log: String,

    /// Form of the log.
    #[arg(long, env = "TERRAMECHANICS_LOG_FORMAT", default_value = "text", value_name = "FORM")]
    pub log_format: LogFormat,

    /// Threads that serve connections.
    #[arg(long, env = "TERRAMECHANICS_WORKERS", default_value_t = default_threads(), value_parser = threads, value_name = "N")]
    pub workers: usize,

    /// Threads that do long computations.
    #[arg(long, env = "TERRAMECHANICS_COMPUTE_THREADS", default_value_t = default_threads(), value_parser = threads, value_name = "N")]
    pub compute_threads: usize,

    /// Long computations that may run or wait; beyond that the answer is 503.
    #[arg(long, env = "TERRAMECHANICS_COMPUTE_PLACES", default_value_t = 64, value_parser = clap::value_parser!(u16).range(1..), value_name = "N")]
    pub compute_places: u16,

    /// Highest price of one computation that is answered as a whole, in seconds of processor time; beyond that the answer is 422.
    #[arg(long, env = "TERRAMECHANICS_PRICE_LIMIT", default_value_t = 60, value_parser = seconds(), value_name = "SECONDS")]
    pub price_limit: u64,

    /// Seconds in which a long computation has to end.
    #[arg(long, env = "TERRAMECHANICS_COMPUTE_TIMEOUT", default_value_t = 30, value_parser = seconds(), value_name = "SECONDS")]
    pub compute_timeout: u64,

    /// Seconds in which the head, from its first byte on, and then the body of a request have to arrive.
    #[arg(long, env = "TERRAMECHANICS_READ_TIMEOUT", default_value_t = 10, value_parser = seconds(), value_name = "SECONDS")]
    pub read_timeout: u64,

    /// Seconds for which a connection is kept after an answer; longer than a proxy in front keeps its own (nginx: 60).
    #[arg(long, env = "TERRAMECHANICS_KEEP_ALIVE", default_value_t = 75, value_parser = seconds(), value_name = "SECONDS")]
    pub keep_alive: u64,

    /// Seconds after which a connection is closed whose client takes nothing of an answer.
    #[arg(long, env = "TERRAMECHANICS_WRITE_TIMEOUT", default_value_t = 10, value_parser = seconds(), value_name = "SECONDS")]
    pub write_timeout: u64,

    /// Bytes a second that a client has to take of an answer that waits for it, as a mean over --rate-window; 0 bears any.
    #[arg(long, env = "TERRAMECHANICS_MIN_DOWNLOAD_RATE", default_value_t = 1024, value_name = "BYTES")]
    pub min_download_rate: u32,

    /// Bytes a second that a client has to send of a body, a stream too, while it is waited for, as a mean over --rate-window;
    /// 0 bears any. A row of 20 bytes a second is well above the default.
    #[arg(long, env = "TERRAMECHANICS_MIN_UPLOAD_RATE", default_value_t = 5, value_name = "BYTES")]
    pub min_upload_rate: u32,

    /// Seconds of waiting over which the rates are taken.
    #[arg(long, env = "TERRAMECHANICS_RATE_WINDOW", default_value_t = 30, value_parser = seconds(), value_name = "SECONDS")]
    pub rate_window: u64,

    /// Largest request body in bytes.
    #[arg(long, env = "TERRAMECHANICS_BODY_LIMIT", default_value_t = 1 << 20, value_parser = clap::value_parser!(u32).range(1024..=64 << 20), value_name = "BYTES")]
    pub body_limit: u32,

    /// Bytes of memory for all bodies that arrive, one at the least; beyond that the answer is 503. Bodies up to 8 KiB do not
    /// count, nor do streams.
    #[arg(long, env = "TERRAMECHANICS_BODY_MEMORY", default_value_t = 32 << 20, value_parser = memory(), value_name = "BYTES")]
    pub body_memory: u64,

    /// Bytes of memory for all answers that wait to be taken, one at the least; beyond that the answer is 503. Answers up to
    /// 64 KiB do not count, nor do streams.
    #[arg(long, env = "TERRAMECHANICS_ANSWER_MEMORY", default_value_t = 32 << 20, value_parser = memory(), value_name = "BYTES")]
    pub answer_memory: u64,

    /// Streams that may be open; beyond that the answer is 503.
    #[arg(long, env = "TERRAMECHANICS_STREAM_PLACES", default_value_t = 64, value_parser = clap::value_parser!(u16).range(1..), value_name = "N")]
    pub stream_places: u16,

    /// Seconds after which a stream is ended that neither sends nor takes anything.
    #[arg(long, env = "TERRAMECHANICS_STREAM_IDLE_TIMEOUT", default_value_t = 30, value_parser = seconds(), value_name = "SECONDS")]
    pub stream_idle_timeout: u64,

    /// Seconds in which a stream has to end, and the highest price of a sweep that is answered as one; its bytes are not limited.
    #[arg(long, env = "TERRAMECHANICS_STREAM_TIMEOUT", default_value_t = 3600, value_parser = clap::value_parser!(u64).range(1..=86_400), value_name = "SECONDS")]
    pub stream_timeout: u64,

    /// When the answer to a stream begins. Auto: with the first row, but after the body where its length was declared, or where
    /// a header (Via, Forwarded, X-Forwarded-…, X-Real-IP) or HTTP/1.0 tells of a proxy, which may stop to send once an answer
    /// begins.
    #[arg(long, env = "TERRAMECHANICS_STREAM_BEGIN", default_value = "auto", value_name = "WHEN")]
    pub stream_begin: Begin,

    /// Bytes of temporary files for all streams that are kept until they have ended, and for one of them. Beyond that a stream
    /// by a proxy is answered with 503 or 413, another before it has ended.
    #[arg(long, env = "TERRAMECHANICS_SPOOL_LIMIT", default_value_t = 1 << 30, value_parser = memory(), value_name = "BYTES")]
    pub spool_limit: u64,

    /// Connections that may be open at once. One more takes the place of one that waits for a request, or for 2 s for more of a
    /// body or a reader; where there is none, it has one of 16 places of a reserve, where only /healthz, /readyz and /metrics are answered, all else with 503.
    #[arg(long, env = "TERRAMECHANICS_MAX_CONNECTIONS", default_value_t = 1024, value_parser = clap::value_parser!(u16).range(1..), value_name = "N")]
    pub max_connections: u16,

    /// Connections that one address (IPv6: /64 network) may have of them; one more takes the place of its own. Half of them
    /// unless given. Behind a proxy all clients have one address: give as many as --max-connections.
    #[arg(long, env = "TERRAMECHANICS_MAX_CONNECTIONS_PER_PEER", value_parser = clap::value_parser!(u16).range(1..), value_name = "N")]
    pub max_connections_per_peer: Option<u16>,

    /// Seconds for which, once it is told to stop, the server still takes connections while /readyz says 503: as long as a
    /// load balancer needs to notice.
    #[arg(long, env = "TERRAMECHANICS_DRAIN_DELAY", default_value_t = 0, value_parser = clap::value_parser!(u64).range(0..=3600), value_name = "SECONDS")]
    pub drain_delay: u64,

    /// Seconds that open requests are given to end when the server stops.
    #[arg(long, env = "TERRAMECHANICS_GRACE", default_value_t = 10, value_parser = seconds(), value_name = "SECONDS")]
    pub grace: u64,
}

/// Form of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LogFormat {
    /// Lines for people.
    Text,
    /// JSON objects, one a line.
    Json,
}

impl Serve {
    /// The limits of the service.
    #[must_use]
    pub fn limits(&self) -> Limits {
        Limits {
            body: self.body_limit as usize,
            bodies: usize::try_from(self.body_memory).unwrap_or(usize::MAX).max(self.body_limit as usize + (64 << 10)),
            answers: usize::try_from(self.answer_memory).unwrap_or(usize::MAX),
            body_deadline: Duration::from_secs(self.read_timeout),
            compute_deadline: Duration::from_secs(self.compute_timeout),
            compute_threads: self.compute_threads,
            compute_places: usize::from(self.compute_places),
            price: Duration::from_secs(self.price_limit),
            stream_places: usize::from(self.stream_places),
            stream_idle: Duration::from_secs(self.stream_idle_timeout),
            stream_deadline: Duration::from_secs(self.stream_timeout),
            stream_begin: self.stream_begin,
            spool: usize::try_from(self.spool_limit).unwrap_or(usize::MAX),
        }
    }

    /// How the service is seen from outside.
    #[must_use]
    pub fn outside(&self) -> Outside {
        Outside { public_url: self.public_url.clone(), origins: self.cors_origin.clone() }
    }

    /// The bounds of the accept loop.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let window = Duration::from_secs(self.rate_window);
        Bounds {
            connections: usize::from(self.max_connections),
            of_one_peer: usize::from(self.max_connections_per_peer.unwrap_or(self.max_connections.div_ceil(2))),
            head_deadline: Duration::from_secs(self.read_timeout),
            keep_alive: Duration::from_secs(self.keep_alive),
            write_deadline: Duration::from_secs(self.write_timeout),
            slowest_download: Slowest { rate: self.min_download_rate, window },
            slowest_upload: Slowest { rate: self.min_upload_rate, window },
            drain_delay: Duration::from_secs(self.drain_delay),
            grace: Duration::from_secs(self.grace),
        }
    }
}

fn default_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(threads @ 1..=256) => Ok(threads),
        _ => Err("must be a whole number from 1 to 256".into()),
    }
}

/// An address without query, whose path has no slash at its end, because those of the contract begin with one.
fn public_url(text: &str) -> Result<String, String> {
    let uri: axum::http::Uri = text.parse().map_err(|_| "must be an address, such as https://example.org/soil")?;
    match (uri.scheme_str(), uri.host(), uri.query()) {
        (Some("http" | "https"), Some(_), None) if !text.contains('#') => Ok(text.trim_end_matches('/').to_owned()),
        _ => Err("must be an address with http or https, such as https://example.org/soil".into()),
    }
}

/// An origin as browsers write it: scheme, host and port, and nothing behind them.
fn origin(text: &str) -> Result<HeaderValue, String> {
    let uri: Option<axum::http::Uri> = text.parse().ok();
    let parts = uri.as_ref().and_then(|uri| Some((uri.scheme_str()?, uri.authority()?.as_str())));
    let is_origin = parts.is_some_and(|(scheme, host)| text == format!("{scheme}://{host}") && !host.contains('@'));
    match HeaderValue::from_str(text) {
        Ok(origin) if text == "*" || is_origin => Ok(origin),
        _ => Err("must be an origin, such as https://example.org or http://localhost:3000, or * for all".into()),
    }
}

fn memory() -> clap::builder::RangedU64ValueParser {
    clap::builder::RangedU64ValueParser::new().range(64 << 10..=1 << 40)
}

fn seconds() -> clap::builder::RangedU64ValueParser {
    clap::builder::RangedU64ValueParser::new().range(1..=3600)
}

/// Prefix of the environment variables that are settings.
const PREFIX: &str = "TERRAMECHANICS_";

/// Environment variables that look like settings but are none: a typo must not silently become a default.
///
/// # Errors
/// The message to refuse with.
pub fn check_environment(names: impl Iterator<Item = String>) -> Result<(), String> {
    use clap::CommandFactory;
    let command = Config::command();
    let known: Vec<&str> = command.get_arguments().filter_map(|arg| arg.get_env()?.to_str()).collect();
    for name in names.filter(|name| name.starts_with(PREFIX)) {
        if !known.contains(&name.as_str()) {
            let hint =
                crate::words::nearest(&name, &known).map_or_else(|| known.join(", "), |near| format!("did you mean {near}?"));
            return Err(format!("unknown setting in the environment: {name}; {hint}"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Config::command().debug_assert();
    }

    #[test]
    fn wrong_settings_are_refused() {
        for wrong in [
            ["--listen", "nowhere"],
            ["--listen", "127.0.0.1"],
            ["--workers", "0"],
            ["--body-limit", "10"],
            ["--compute-places", "0"],
            ["--log-format", "xml"],
            ["--stream-begin", "late"],
            ["--public-url", "example.org/soil"],
            ["--public-url", "https://example.org/soil?a=b"],
            ["--cors-origin", "example.org"],
            ["--cors-origin", "https://example.org/"],
            ["--cors-origin", "https://example.org,https://user@example.org"],
            ["--no-such", "1"],
        ] {
            assert!(Config::try_parse_from(["terramechanics"].into_iter().chain(wrong)).is_err(), "{wrong:?}");
        }
        assert!(Config::try_parse_from(["terramechanics", "--listen", "[::1]:0", "--workers", "2"]).is_ok());
    }

    #[test]
    fn a_public_address_has_no_slash_at_its_end() {
        for (given, kept) in
            [("https://example.org/soil/", "https://example.org/soil"), ("http://[::1]:8080", "http://[::1]:8080")]
        {
            let config = Config::try_parse_from(["terramechanics", "--public-url", given]).expect("an address");
            assert_eq!(config.serve.public_url.as_deref(), Some(kept));
        }
    }

    #[test]
    fn an_unknown_variable_is_refused_with_the_nearest_known() {
        let check = |name: &str| check_environment([name.to_owned(), "PATH".into()].into_iter());
        assert!(check("TERRAMECHANICS_LISTEN").is_ok());
        assert!(check("TERRAMECHANICS_LISTN").expect_err("a typo").contains("TERRAMECHANICS_LISTEN"));
    }
}
