//! Lists of objects.

use serde::de::{IgnoredAny, SeqAccess};
use utoipa::ToSchema;
use utoipa::openapi::schema::ArrayBuilder;
use utoipa::openapi::{RefOr, Schema};

use super::{Entry, Field, Nested, Object, Scope, Spec, Wire};

/// The items of a list, and one more than allowed where there are too many.
pub(super) fn items<'de, A: SeqAccess<'de>, T: Wire>(list: &mut A, most: usize) -> Result<Vec<Field<T>>, A::Error> {
    let mut items = Vec::new();
    while items.len() <= most {
        match list.next_element()? {
            Some(item) => items.push(item),
            None => return Ok(items),
        }
    }
    while list.next_element::<IgnoredAny>()?.is_some() {}
    Ok(items)
}

/// A list of objects as it was sent.
#[derive(Debug, Clone)]
pub(crate) struct List<T>(Vec<Field<T>>);

/// How many objects a list may have.
pub(crate) struct ListSpec<T> {
    doc: &'static str,
    fewest: usize,
    most: usize,
    required: bool,
    item: Nested<T>,
}

impl<T> ListSpec<T> {
    /// A list that has to be there.
    pub(crate) const fn required(doc: &'static str, fewest: usize, most: usize) -> Self {
        Self { doc, fewest, most, required: true, item: Nested::required("One of the list.") }
    }

    /// A list that may be left out.
    pub(crate) const fn optional(doc: &'static str, most: usize) -> Self {
        Self { required: false, ..Self::required(doc, 0, most) }
    }
}

impl<T: ToSchema + Object> Spec for ListSpec<T> {
    fn schema(&self) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some(self.doc))
            .items(self.item.schema())
            .min_items((self.fewest > 0).then_some(self.fewest))
            .max_items(Some(self.most))
            .into()
    }

    fn schemas(&self, found: &mut Vec<(String, RefOr<Schema>)>) {
        self.item.schemas(found);
    }

    fn is_required(&self) -> bool {
        self.required
    }
}

/// Objects that are kept of any list; the checks allow fewer.
const MOST_KEPT: usize = 64;

impl<T: Wire + ToSchema + Object + 'static> Wire for List<T> {
    type Spec = ListSpec<T>;
    const EXPECTED: &'static str = "an array of objects";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        items(&mut list, MOST_KEPT).map(Self).map(Some)
    }
}

impl<T: Wire + ToSchema + Object + 'static> Entry<'_, List<T>> {
    /// What `check` makes of every object; nothing of a list that may be left out and is.
    pub(crate) fn each<U>(&self, object: &Scope<'_>, mut check: impl FnMut(&T, &Scope<'_>) -> Option<U>) -> Option<Vec<U>> {
        if !self.is_present() && !self.spec.required {
            return Some(Vec::new());
        }
        let List(items) = self.required(object)?;
        let list = object.field(self.name);
        let ListSpec { fewest, most, .. } = self.spec;
        if !(*fewest..=*most).contains(&items.len()) {
            list.fault(format_args!("must have from {fewest} to {most} items"));
            return None;
        }
        let checked: Vec<Option<U>> = items
            .iter()
            .enumerate()
            .map(|(i, item)| match item {
                Field::Given(item) => check(item, &list.item(i)),
                Field::Wrong(found) => {
                    list.item(i).fault(format_args!("must be {}, not {found}", T::EXPECTED));
                    None
                }
                Field::Absent => None,
            })
            .collect();
        checked.into_iter().collect()
    }
}
