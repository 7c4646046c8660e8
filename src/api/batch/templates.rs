//! Requests in which the numbers of rows take their places.

use std::collections::HashMap;

use terramechanics_reading::{FieldFault, Path};

use super::evaluate::Common;
use crate::api::forces::ForcesCase;
use crate::rows::{Block, Shape};
use crate::varied::Template;

/// Templates that are kept; rows of more kinds are read all the same.
const MOST: usize = 64;

/// A template for all rows that have the same fields and the same words.
#[derive(Default)]
pub(super) struct Templates {
    pub(super) list: Vec<Template<ForcesCase>>,
    /// Their places by fields and words.
    places: HashMap<String, usize>,
    /// The same by the places of the words in the block under way.
    of_block: HashMap<Vec<u64>, usize>,
    key: Vec<u64>,
    /// The last row without words, and its template: most rows are like the one before.
    last: Option<(Shape, usize)>,
}

/// The places of the bits that are set.
pub(super) fn bits(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (set != 0).then(|| set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        lowest
    })
}

impl Templates {
    /// The place of the template for a row, if there is one.
    #[inline]
    pub(super) fn place_of(&mut self, block: &Block, row: usize) -> Option<usize> {
        let shape = block.shape(row);
        if let Some((_, at)) = self.last.filter(|(known, _)| *known == shape) {
            return Some(at);
        }
        let Shape { present, textual } = shape;
        self.key.clear();
        self.key.push(present);
        self.key.push(textual);
        self.key.extend(bits(textual).map(|field| block.value(field, row) as u64));
        let found = self.of_block.get(&self.key).copied();
        self.last = found.filter(|_| textual == 0).map(|at| (shape, at));
        found
    }

    /// Another block begins, whose words have other places.
    pub(super) fn begin(&mut self) {
        self.of_block.clear();
        self.last = None;
    }

    /// Adds the template for the row that was looked up last; its place.
    pub(super) fn add(&mut self, common: &Common, block: &Block, row: usize) -> Result<usize, Vec<FieldFault>> {
        let Shape { present, textual } = block.shape(row);
        let words: Vec<_> = bits(textual).map(|field| (field, block.node(field, row))).collect();
        let name = format!("{present} {words:?}");
        let at = match self.places.get(&name) {
            Some(at) => *at,
            None => {
                let told =
                    |faults: Vec<crate::varied::RowFault>| faults.into_iter().map(|of_row| of_row.fault).collect::<Vec<_>>();
                let fields = &common.columns.fields;
                let mut request = common.constants.clone();
                for (field, word) in words {
                    let blocked = |blocked: terramechanics_reading::Blocked| {
                        vec![FieldFault::new(
                            fields[field].pointer(),
                            format!("leads nowhere: `{}` is {}", blocked.pointer, blocked.found),
                        )]
                    };
                    let slot = request.slot(&fields[field]).map_err(blocked)?;
                    request.put(&slot, word);
                }
                let numbers: Vec<Path> = bits(present & !textual).map(|field| fields[field].clone()).collect();
                let template = Template::new(&request, &numbers).map_err(told)?;
                if self.list.len() >= MOST {
                    self.list.clear();
                    self.places.clear();
                    self.begin();
                }
                self.list.push(template);
                self.places.insert(name, self.list.len() - 1);
                self.list.len() - 1
            }
        };
        self.of_block.insert(self.key.clone(), at);
        Ok(at)
    }
}
