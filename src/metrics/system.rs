//! What the process takes of the machine, by the names that Prometheus gives it, and what it was built of.

use std::sync::atomic::AtomicU64;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::info::Info;
use prometheus_client::registry::{Registry, Unit};
use rustix::param::page_size;
use rustix::time::{ClockId, clock_gettime};

use crate::catalogue;

/// A gauge of a number that is not whole.
type Number = Gauge<f64, AtomicU64>;

/// The gauges, read when they are asked for.
pub(super) struct System {
    memory: Gauge,
    processor_time: Counter<f64, AtomicU64>,
}

impl System {
    pub(super) fn registered(registry: &mut Registry) -> Self {
        let (memory, processor_time, start) = (Gauge::default(), Counter::default(), Number::default());
        start.set(SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_secs_f64());
        registry.register_with_unit("process_resident_memory", "Memory that the process takes", Unit::Bytes, memory.clone());
        registry.register_with_unit(
            "process_cpu",
            "Processor time that the process has taken",
            Unit::Seconds,
            processor_time.clone(),
        );
        registry.register_with_unit("process_start_time", "When the process began, since 1970", Unit::Seconds, start);
        let build = [
            ("version", env!("CARGO_PKG_VERSION")),
            ("model", terramechanics::VERSION),
            ("catalogue", catalogue::VERSION),
            ("build", env!("VERSION_OF_BUILD")),
        ];
        registry.register("terramechanics", "What is running", Info::new(build));
        Self { memory, processor_time }
    }

    pub(super) fn read(&self) {
        // Where there is no such file, the gauge stays at 0.
        let pages = std::fs::read_to_string("/proc/self/statm").ok().and_then(|text| text.split(' ').nth(1)?.parse::<i64>().ok());
        self.memory.set(pages.unwrap_or(0).saturating_mul(i64::try_from(page_size()).unwrap_or(0)));
        let time = Duration::try_from(clock_gettime(ClockId::ProcessCPUTime)).unwrap_or_default();
        self.processor_time.inc_by(time.as_secs_f64() - self.processor_time.get());
    }
}
