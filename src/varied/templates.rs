//! Requests in which the numbers of rows take their places.

use std::collections::HashMap;

use terramechanics_reading::{Assumption, Blocked, FieldFault, Node, Path};

use super::faults::RowFault;
use super::row::Varied;
use super::template::Template;
use crate::rows::{Block, Shape};

/// Templates that are kept; rows of more kinds are read all the same.
const MOST: usize = 64;

/// Values that are told as assumed.
const MOST_ASSUMED: usize = 100;

/// A template for all rows that have the same fields and the same words.
pub(crate) struct Templates<R> {
    list: Vec<Template<R>>,
    /// Their places by fields and words.
    places: HashMap<String, usize>,
    /// The same by the places of the words in the block under way.
    of_block: HashMap<Vec<u64>, usize>,
    key: Vec<u64>,
    /// The last row without words, and its template: most rows are like the one before.
    last: Option<(Shape, usize)>,
    /// The numbers of a row.
    values: Vec<f64>,
}

/// The places of the bits that are set.
fn bits(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (set != 0).then(|| set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        lowest
    })
}

impl<R> Default for Templates<R> {
    fn default() -> Self {
        let (places, of_block) = (HashMap::new(), HashMap::new());
        Self { list: Vec::new(), places, of_block, key: Vec::new(), last: None, values: Vec::new() }
    }
}

impl<R: Varied> Templates<R> {
    /// The place of the template for a row, if there is one.
    #[inline]
    fn place_of(&mut self, block: &Block, row: usize) -> Option<usize> {
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
    pub(crate) fn begin(&mut self) {
        self.of_block.clear();
        self.last = None;
    }

    /// The case of a row: the request in which the columns have its values. What is assumed of it goes into `told`.
    ///
    /// # Errors
    /// The faults of that request.
    pub(crate) fn case(
        &mut self,
        constants: &Node<'static>,
        fields: &[Path],
        block: &Block,
        row: usize,
        told: &mut Vec<Assumption>,
    ) -> Result<&R, Vec<FieldFault>> {
        let at = match self.place_of(block, row) {
            Some(at) => at,
            None => self.add(constants, fields, block, row)?,
        };
        let Some(template) = self.list.get_mut(at) else { return Err(Vec::new()) };
        let Shape { present, textual } = block.shape(row);
        self.values.clear();
        self.values.extend(bits(present & !textual).map(|field| block.value(field, row)));
        let (case, assumed) = template.case_and_assumed(&self.values)?;
        for assumption in assumed {
            if told.len() < MOST_ASSUMED && !told.contains(assumption) {
                told.push(assumption.clone());
            }
        }
        Ok(case)
    }

    /// Adds the template for the row that was looked up last; its place. All rows have `constants` in common, and their columns are
    /// `fields`.
    fn add(&mut self, constants: &Node<'static>, fields: &[Path], block: &Block, row: usize) -> Result<usize, Vec<FieldFault>> {
        let Shape { present, textual } = block.shape(row);
        let words: Vec<_> = bits(textual).map(|field| (field, block.node(field, row))).collect();
        let name = format!("{present} {words:?}");
        let at = match self.places.get(&name) {
            Some(at) => *at,
            None => {
                let told = |faults: Vec<RowFault>| faults.into_iter().map(|of_row| of_row.fault).collect::<Vec<_>>();
                let mut request = constants.clone();
                for (field, word) in words {
                    let blocked = |blocked: Blocked| {
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
