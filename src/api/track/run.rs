//! A run over a series: samples in, rows out, in slices that are short enough to share the machine.

use std::time::Instant;

use axum::body::Bytes;
use terramechanics::{NormalStressFrom, Sample, Tracker};
use terramechanics_identification::RunningStrength;

use super::found::FoundTrack;
use super::plan::TrackPlan;
use super::reply::TrackReply;
use super::request::{TrackCase, TrackSettings};
use super::samples::Samples;
use super::table::Table;
use crate::compute::SLICE;
use crate::extract::SeriesForm;
use crate::problem::Problem;
use crate::quantity::{Beside, Row as Cells, SampleLists};
use crate::reply::{MOST_IN_COLUMNS, RowFormat};
use crate::series::{Read, Reader, Row, Unreadable};
use crate::stream::{PIECE, Progress, Work};
use terramechanics_reading::{Assumption, FieldFault};

/// A run.
#[derive(Debug)]
pub(crate) struct Run {
    source: Source,
    settings: TrackSettings,
    form: SeriesForm,
    /// What was assumed of the request; no list where nothing may be.
    assumed: Option<Vec<Assumption>>,
    /// Once the columns are known.
    started: Option<Started>,
}

#[derive(Debug)]
enum Source {
    Reader(Reader),
    Memory { samples: Samples, next: usize },
}

#[derive(Debug)]
struct Started {
    plan: TrackPlan,
    tracker: Tracker,
    strength: Option<RunningStrength>,
    sink: Sink,
    /// Rows between two readings of the clock, which takes a good part of the time of a cheap row.
    rows_per_look: usize,
}

#[derive(Debug)]
enum Sink {
    Rows(Table),
    Columns(SampleLists),
}

impl Run {
    /// A run over a streamed body in the form `body`.
    pub(crate) fn over_stream(settings: TrackSettings, body: SeriesForm, form: SeriesForm) -> Self {
        let extra = settings.extra_columns;
        let reader = if body == SeriesForm::Csv { Reader::csv(extra) } else { Reader::ndjson(extra) };
        Self { source: Source::Reader(reader), settings, form, assumed: None, started: None }
    }

    /// Over samples in memory.
    pub(crate) fn over_samples(case: TrackCase, form: SeriesForm) -> Self {
        let TrackCase { settings, samples } = case;
        Self { source: Source::Memory { samples, next: 0 }, settings, form, assumed: None, started: None }
    }

    /// With what was assumed of the request.
    pub(crate) fn assuming(self, assumed: Option<Vec<Assumption>>) -> Self {
        Self { assumed, ..self }
    }

    /// Starts once the columns are known.
    fn start(&mut self) -> Result<(), Problem> {
        if self.started.is_some() {
            return Ok(());
        }
        let (layout, rows) = match &self.source {
            Source::Reader(reader) => (reader.layout(), 0),
            Source::Memory { samples, .. } => (Some(samples.layout), samples.count),
        };
        let Some(layout) = layout else { return Ok(()) };
        let plan = self.settings.plan(layout).map_err(Problem::Invalid)?;
        let strength = self.settings.strength;
        let under_load = self.settings.has_soil && plan.normal_stress_from() == NormalStressFrom::Load;
        let beside = Beside { coupled: plan.is_coupled(), under_load, strength: strength.is_some() };
        let sink = match self.form {
            SeriesForm::Json => Sink::Columns(SampleLists::with(beside, rows)),
            SeriesForm::Csv => Sink::Rows(Table::new(RowFormat::Csv, beside)),
            SeriesForm::Ndjson => Sink::Rows(Table::new(RowFormat::Ndjson, beside)),
        };
        let rows_per_look = if self.settings.operation.model.method.is_closed_form() { 32 } else { 8 };
        self.started = Some(Started { plan, tracker: self.settings.tracker.clone(), strength, sink, rows_per_look });
        Ok(())
    }

    fn read(&mut self, input: &mut &[u8], last: bool) -> Result<Read, Problem> {
        match &mut self.source {
            Source::Reader(reader) => reader.next(input, last).map_err(Problem::Unreadable),
            Source::Memory { samples, next } => {
                *next += 1;
                Ok(if *next <= samples.count { Read::Row(samples.row(*next - 1)) } else { Read::End })
            }
        }
    }

    fn rows(&mut self, input: &mut &[u8], last: bool, output: &mut Vec<u8>) -> Result<Progress, Problem> {
        let slice_end = Instant::now() + SLICE;
        let mut rows = 0;
        loop {
            let looks = self.started.as_ref().is_some_and(|started| rows % started.rows_per_look == 0);
            if output.len() >= PIECE || (looks && Instant::now() >= slice_end) {
                return Ok(Progress::Paused);
            }
            let read = self.read(input, last)?;
            self.start()?;
            let Some(started) = &mut self.started else { return Ok(Progress::NeedsInput) };
            match read {
                Read::Row(row) => started.row(&row, output)?,
                Read::More => return Ok(Progress::NeedsInput),
                Read::End => {
                    let unreadable = match &self.source {
                        Source::Reader(reader) => reader.unreadable(),
                        Source::Memory { .. } => &Unreadable::default(),
                    };
                    return started.end(&self.settings, unreadable, self.assumed.take(), output).map(|()| Progress::Complete);
                }
            }
            rows += 1;
        }
    }
}

impl Started {
    fn row(&mut self, row: &Row, output: &mut Vec<u8>) -> Result<(), Problem> {
        let sample = Sample { unreadable: row.unreadable, ..self.plan.sample(&row.cells) };
        let is_first = self.tracker.rows() == 0;
        let row = self.tracker.push(&sample);
        let strength = self.strength.as_mut().and_then(|running| running.follow(&sample, &row));
        let cells = Cells { row: &row, strength: strength.as_ref() };
        match &mut self.sink {
            Sink::Rows(table) => {
                // Not before, so that a series without samples, or with a first one that is wrong, can be refused.
                if is_first {
                    table.head(output);
                }
                table.row(&cells, output);
            }
            Sink::Columns(_) if self.tracker.rows() > MOST_IN_COLUMNS as u64 => {
                let detail =
                    format!("an answer in columns has at most {MOST_IN_COLUMNS} rows; accept text/csv or application/x-ndjson");
                return Err(Problem::Invalid(vec![FieldFault::new("", detail)]));
            }
            Sink::Columns(lists) => lists.push(&cells),
        }
        Ok(())
    }

    fn end(
        &mut self,
        settings: &TrackSettings,
        unreadable: &Unreadable,
        assumed: Option<Vec<Assumption>>,
        output: &mut Vec<u8>,
    ) -> Result<(), Problem> {
        self.tracker.finish();
        let found = FoundTrack::of(&self.tracker, &self.plan, unreadable, self.strength.as_ref());
        let found = found.by(settings.circles, &settings.unused).assuming(assumed);
        match &mut self.sink {
            Sink::Rows(table) => {
                table.end(&found, output);
                Ok(())
            }
            Sink::Columns(lists) => {
                let reply = TrackReply::of(std::mem::take(lists).into_columns(), found);
                serde_json::to_writer(output, &reply).map_err(|error| {
                    tracing::error!(%error, "a reply could not be written");
                    Problem::Internal
                })
            }
        }
    }
}

impl Work for Run {
    fn media_type(&self) -> &'static str {
        match self.form {
            SeriesForm::Csv => "text/csv; charset=utf-8; header=present",
            form => form.media_types()[0],
        }
    }

    fn slice(&mut self, input: &mut Bytes, last: bool, output: &mut Vec<u8>) -> Result<Progress, Problem> {
        let mut left: &[u8] = input;
        let progress = self.rows(&mut left, last, output);
        *input = input.slice(input.len() - left.len()..);
        progress
    }

    fn broken(&self, problem: &Problem, output: &mut Vec<u8>) {
        if let Some(Started { sink: Sink::Rows(table), .. }) = &self.started {
            table.format().broken(&problem.detail(), output);
        }
    }
}
