//! Objects whose fields depend on the name of a law.

use terramechanics::Law;

use crate::wire::{Entry, Scope, Variant};

/// The numbers of a tagged object: those its variant takes, checked; one it does not take is reported. Where the variant is
/// not known, what was sent is checked by its bounds alone.
pub(super) fn numbers_of<const N: usize>(
    variant: Option<&Variant>,
    entries: &[Entry<'_, f64>; N],
    place: &Scope<'_>,
) -> [Option<f64>; N] {
    entries.each_ref().map(|entry| match variant {
        None => entry.checked(place),
        Some(variant) if variant.required.contains(&entry.name) => entry.required_number(place),
        Some(variant) if variant.optional.contains(&entry.name) => entry.or_default(place),
        Some(variant) => {
            if entry.is_present() {
                let takes: Vec<&str> = variant.fields().collect();
                let takes = if takes.is_empty() { "no further field".to_owned() } else { takes.join(", ") };
                place.field(entry.name).fault(format_args!("`{}` has no such field; it takes {takes}", variant.name));
            }
            None
        }
    })
}

/// The law of that name among the model's, with the numbers of a tagged object; none where one of them was reported.
pub(super) fn made<F, const N: usize>(
    laws: &[Law<F>],
    name: &str,
    entries: &[Entry<'_, f64>; N],
    values: &[Option<f64>; N],
    place: &Scope<'_>,
) -> Option<F> {
    let Some(law) = laws.iter().find(|law| law.name == name) else { return place.unread(name) };
    let value = |name: &str| entries.iter().zip(values).find(|(entry, _)| entry.name == name).and_then(|(_, value)| *value);
    law.from_named(value).ok()
}
