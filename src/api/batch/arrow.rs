//! The answer of a batch as an Arrow stream: a record batch for each block, and an empty one at the end that says how it went.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray, new_null_array};
use arrow_buffer::NullBuffer;
use arrow_ipc::writer::StreamWriter;
use arrow_ipc::{KeyValue, KeyValueArgs, MessageBuilder, MessageHeader, RecordBatchBuilder, root_as_message};
use arrow_schema::{DataType, Field, Schema};
use flatbuffers::FlatBufferBuilder;

use super::evaluate::Answers;
use super::reply::OK;
use crate::reply::End;
use crate::rows::{Block, Columns, EchoedCell};

/// What a message begins with, before the length of its head.
const CONTINUATION: [u8; 4] = [0xff; 4];

/// Columns of an Arrow stream.
#[derive(Debug)]
pub(super) struct ArrowTable {
    schema: Arc<Schema>,
    /// The schema as a message, with which every writer begins.
    head: Vec<u8>,
}

impl ArrowTable {
    pub(super) fn new(columns: &Columns, own: impl Iterator<Item = String>) -> Self {
        let echoed = columns.echoed.iter().zip(&columns.kept);
        let echoed = echoed.map(|(name, kind)| Field::new(name, kind.clone().unwrap_or(DataType::Utf8), true));
        let mut fields: Vec<Field> = echoed.chain(own.map(|name| Field::new(name, DataType::Float64, true))).collect();
        if let Some(status) = fields.pop() {
            fields.push(status.with_data_type(DataType::Utf8).with_nullable(false));
        }
        let schema = Arc::new(Schema::new(fields));
        let head = StreamWriter::try_new(Vec::new(), &schema).map(|writer| writer.get_ref().clone()).unwrap_or_default();
        Self { schema, head }
    }

    pub(super) fn head(&self, output: &mut Vec<u8>) {
        output.extend_from_slice(&self.head);
    }

    pub(super) fn rows(&self, block: &Block, answers: &mut Answers, output: &mut Vec<u8>) {
        let echoes = block.echoes().iter().map(|echoed| match echoed.arrays() {
            [] => texts(block, |row| match echoed.cell(row) {
                EchoedCell::Nothing => None,
                EchoedCell::Literal(text) | EchoedCell::Text(text) => Some(text),
            }),
            [one] => one.clone(),
            _ => Arc::new(StringArray::new_null(0)),
        });
        let mut columns: Vec<ArrayRef> = echoes.collect();
        columns.extend(answers.numbers.iter_mut().map(|column| numbers(std::mem::take(column))));
        columns.push(texts(block, |row| Some(answers.faults[row].as_deref().unwrap_or(OK))));
        self.write(columns, output);
    }

    /// Writes a record batch.
    fn write(&self, columns: Vec<ArrayRef>, output: &mut Vec<u8>) {
        let start = output.len();
        let written = RecordBatch::try_new(self.schema.clone(), columns).and_then(|batch| {
            let mut writer = StreamWriter::try_new(&mut *output, &self.schema)?;
            writer.write(&batch)
        });
        if let Err(error) = written {
            tracing::error!(%error, "a record batch could not be written");
            output.truncate(start);
            return;
        }
        output.drain(start..start + self.head.len());
    }

    /// The end: a record batch without rows, whose message has the number of rows, the warnings and what was assumed as its
    /// metadata, and the mark after which nothing comes.
    pub(super) fn end(&self, end: &End, output: &mut Vec<u8>) {
        let columns = self.schema.fields().iter().map(|field| new_null_array(field.data_type(), 0)).collect();
        let mut empty = Vec::new();
        self.write(columns, &mut empty);
        output.extend(with_metadata(&empty, end).unwrap_or(empty));
        output.extend_from_slice(&CONTINUATION);
        output.extend_from_slice(&[0; 4]);
    }
}

fn numbers(mut values: Vec<f64>) -> ArrayRef {
    let is_whole = values.iter().all(|value| value.is_finite());
    let nulls = (!is_whole).then(|| NullBuffer::from_iter(values.iter().map(|value| value.is_finite())));
    if !is_whole {
        values.iter_mut().filter(|value| !value.is_finite()).for_each(|value| *value = 0.0);
    }
    Arc::new(Float64Array::new(values.into(), nulls))
}

fn texts<'a>(block: &Block, text: impl Fn(usize) -> Option<&'a str>) -> ArrayRef {
    Arc::new(StringArray::from_iter((0..block.rows()).map(text)))
}

/// The message of a record batch without rows, with the end of the answer as its metadata.
fn with_metadata(message: &[u8], end: &End) -> Option<Vec<u8>> {
    let of_head = message.get(8..)?;
    let head = root_as_message(of_head).ok()?;
    let batch = head.header_as_record_batch()?;
    let mut builder = FlatBufferBuilder::new();
    let nodes: Vec<_> = batch.nodes()?.iter().copied().collect();
    let buffers: Vec<_> = batch.buffers()?.iter().copied().collect();
    let (nodes, buffers) = (builder.create_vector(&nodes), builder.create_vector(&buffers));
    let counts = batch.variadicBufferCounts().map(|counts| counts.iter().collect::<Vec<_>>());
    let counts = counts.map(|counts| builder.create_vector(&counts));
    let header = {
        let mut record = RecordBatchBuilder::new(&mut builder);
        record.add_length(0);
        record.add_nodes(nodes);
        record.add_buffers(buffers);
        counts.into_iter().for_each(|counts| record.add_variadicBufferCounts(counts));
        record.finish().as_union_value()
    };
    let values = [
        ("rows", end.rows.to_string()),
        ("warnings", serde_json::to_string(&end.warnings).unwrap_or_default()),
        ("assumed", end.assumed.as_ref().map(|assumed| serde_json::to_string(assumed).unwrap_or_default()).unwrap_or_default()),
    ];
    let mut pairs = Vec::new();
    for (key, value) in values.iter().filter(|(_, value)| !value.is_empty()) {
        let (key, value) = (builder.create_string(key), builder.create_string(value));
        pairs.push(KeyValue::create(&mut builder, &KeyValueArgs { key: Some(key), value: Some(value) }));
    }
    let metadata = builder.create_vector(&pairs);
    let root = {
        let mut written = MessageBuilder::new(&mut builder);
        written.add_version(head.version());
        written.add_header_type(MessageHeader::RecordBatch);
        written.add_bodyLength(head.bodyLength());
        written.add_header(header);
        written.add_custom_metadata(metadata);
        written.finish()
    };
    builder.finish(root, None);
    let mut text = builder.finished_data().to_vec();
    // A body begins at a multiple of eight.
    text.resize(text.len().next_multiple_of(8), 0);
    let body = message.get(message.len() - usize::try_from(head.bodyLength()).ok()?..)?;
    let length = u32::try_from(text.len()).ok()?;
    Some([&CONTINUATION[..], &length.to_le_bytes(), &text, body].concat())
}
