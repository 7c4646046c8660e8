//! Rows as an Arrow stream: record batches, and an empty one at the end that says how it went.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray, new_null_array};
use arrow_buffer::NullBuffer;
use arrow_ipc::writer::StreamWriter;
use arrow_ipc::{KeyValue, KeyValueArgs, MessageBuilder, MessageHeader, RecordBatchBuilder, root_as_message};
use arrow_schema::{DataType, Field, Schema};
use flatbuffers::FlatBufferBuilder;

use super::rows::End;

/// What a message begins with, before the length of its head.
const CONTINUATION: [u8; 4] = [0xff; 4];

/// The columns of an Arrow stream.
#[derive(Debug)]
pub(crate) struct ArrowStream {
    schema: Arc<Schema>,
    /// The schema as a message, with which every writer begins.
    head: Vec<u8>,
}

impl ArrowStream {
    /// Columns that may have nulls, and at the end the status of each row.
    pub(crate) fn new(columns: impl Iterator<Item = (String, DataType)>, status: &str) -> Self {
        let status = Field::new(status, DataType::Utf8, false);
        let fields: Vec<Field> = columns.map(|(name, kind)| Field::new(name, kind, true)).chain([status]).collect();
        let schema = Arc::new(Schema::new(fields));
        let head = StreamWriter::try_new(Vec::new(), &schema).map(|writer| writer.get_ref().clone()).unwrap_or_default();
        Self { schema, head }
    }

    /// What stands before the first rows.
    pub(crate) fn head(&self, output: &mut Vec<u8>) {
        output.extend_from_slice(&self.head);
    }

    /// Writes a record batch.
    pub(crate) fn rows(&self, columns: Vec<ArrayRef>, output: &mut Vec<u8>) {
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
    pub(crate) fn end(&self, end: &End, output: &mut Vec<u8>) {
        let columns = self.schema.fields().iter().map(|field| new_null_array(field.data_type(), 0)).collect();
        let mut empty = Vec::new();
        self.rows(columns, &mut empty);
        output.extend(with_metadata(&empty, end).unwrap_or(empty));
        output.extend_from_slice(&CONTINUATION);
        output.extend_from_slice(&[0; 4]);
    }
}

/// A column of numbers; null where they are not finite.
pub(crate) fn numbers(mut values: Vec<f64>) -> ArrayRef {
    let is_whole = values.iter().all(|value| value.is_finite());
    let nulls = (!is_whole).then(|| NullBuffer::from_iter(values.iter().map(|value| value.is_finite())));
    if !is_whole {
        values.iter_mut().filter(|value| !value.is_finite()).for_each(|value| *value = 0.0);
    }
    Arc::new(Float64Array::new(values.into(), nulls))
}

/// A column of texts, some of which may be absent.
pub(crate) fn texts<'a>(texts: impl Iterator<Item = Option<&'a str>>) -> ArrayRef {
    Arc::new(StringArray::from_iter(texts))
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
