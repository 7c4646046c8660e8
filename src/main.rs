//! The program: settings, log, runtime, server.

use std::io::{Read, Write};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream};
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;
use terramechanics_server::config::{Command, Config, Serve, check_environment};
use terramechanics_server::log::Log;
use terramechanics_server::server::{listen, serve, told_to_stop};
use terramechanics_server::{Service, app, contract};

/// Gives memory back to the system some seconds after a load, from a thread of its own.
#[global_allocator]
static ALLOCATOR: tikv_jemallocator::Jemalloc = tikv_jemallocator::Jemalloc;

fn main() -> ExitCode {
    let config = Config::parse();
    let result = match config.command {
        Some(Command::Openapi) => {
            std::io::stdout().write_all(contract().pretty_text().as_bytes()).map_err(|error| error.to_string())
        }
        Some(Command::Healthcheck { listen, timeout }) => healthcheck(listen, Duration::from_secs(timeout)),
        None => check_environment(std::env::vars_os().filter_map(|(name, _)| name.into_string().ok()))
            .and_then(|()| run(&config.serve)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            let _ = writeln!(std::io::stderr(), "error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(settings: &Serve) -> Result<(), String> {
    let _log = Log::start(settings)?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(settings.workers)
        .max_blocking_threads(settings.limits().blocking_threads())
        .enable_all()
        .build()
        .map_err(|error| format!("no runtime: {error}"))?;
    let cut_off = runtime.block_on(async {
        let listener = listen(settings.listen).map_err(|error| format!("cannot listen on {}: {error}", settings.listen))?;
        let address = listener.local_addr().map_err(|error| error.to_string())?;
        let stop = told_to_stop().map_err(|error| format!("cannot listen for signals: {error}"))?;
        let service = Service::seen_as(settings.limits(), settings.outside());
        let app = app(service.clone());
        // Nothing waits for whoever reads the output.
        std::thread::spawn(move || {
            writeln!(std::io::stdout(), "The page is at http://{address}/, the API explorer at http://{address}/docs")
        });
        tracing::info!(%address, version = env!("CARGO_PKG_VERSION"), "serving");
        Ok::<_, String>(serve(listener, app, service, settings.bounds(), stop).await)
    })?;
    // What still computes is bounded, but nobody waits for it any more.
    runtime.shutdown_background();
    tracing::info!("stopped");
    if cut_off == 0 { Ok(()) } else { Err(format!("{cut_off} requests did not end in time and were cut off")) }
}

/// Asks the server at `listen` whether it is ready.
fn healthcheck(listen: SocketAddr, timeout: Duration) -> Result<(), String> {
    let ip = match listen.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    let ask = || -> std::io::Result<String> {
        let mut stream = TcpStream::connect_timeout(&SocketAddr::new(ip, listen.port()), timeout)?;
        stream.set_read_timeout(Some(timeout))?;
        stream.set_write_timeout(Some(timeout))?;
        stream.write_all(format!("GET /readyz HTTP/1.1\r\nHost: {listen}\r\nConnection: close\r\n\r\n").as_bytes())?;
        let mut answer = String::new();
        stream.take(4096).read_to_string(&mut answer)?;
        Ok(answer)
    };
    match ask() {
        Ok(answer) if answer.starts_with("HTTP/1.1 200 ") => Ok(()),
        Ok(answer) => Err(format!("not ready: {}", answer.lines().next().unwrap_or("no answer"))),
        Err(error) => Err(format!("no answer from {listen}: {error}")),
    }
}
