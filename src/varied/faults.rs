//! Which fields may vary, and what is wrong with those that may not.

use terramechanics_reading::{Astray, FieldFault, Number, Object, Path, Scope, shortened};

use crate::words::HINTS;

/// A fault of all rows alike.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowFault {
    /// The varied field at fault, by its place among them; none for any other field of the request.
    pub(crate) field: Option<usize>,
    /// The fault, as the operation tells it.
    pub(crate) fault: FieldFault,
}

/// The path and the number of a field that is to vary, which `pointer` names; what is wrong with it is reported to `place`.
pub(crate) fn varied_field(object: &'static Object, pointer: &str, place: &Scope<'_>) -> Option<(Path, Number)> {
    let Some(path) = Path::of_pointer(pointer) else {
        let hint = match Path::of_dotted(pointer).map(|path| (object.number_at(&path, &HINTS), path)) {
            Some((Ok(_), path)) => format!("; did you mean `{}`?", path.pointer()),
            // One word alone is no path: what is near to it may be anywhere.
            Some((Err(Astray::Unknown { hint, .. }), path)) if path.names().len() > 1 => format!("; {hint}"),
            Some((Err(_), _)) | None => String::new(),
        };
        place.fault(format_args!(
            "must be the JSON pointer of a field of the request, such as `/slip`, not `{}`{hint}",
            shortened(pointer)
        ));
        return None;
    };
    match object.number_at(&path, &HINTS) {
        Ok(number) => Some((path, number)),
        Err(astray) => {
            place.fault(astray);
            None
        }
    }
}

/// The faults that all of some rows have, which no value of the varied fields mends.
pub(crate) fn shared(of_rows: &[Vec<FieldFault>], pointers: &[String]) -> Vec<RowFault> {
    let Some((first, others)) = of_rows.split_first() else { return Vec::new() };
    let field = |fault: &FieldFault| pointers.iter().position(|pointer| *pointer == fault.pointer);
    let is_shared = |fault: &FieldFault| {
        // A number that is out of bounds is a fault of its row.
        (field(fault).is_none() || fault.figures.is_none()) && others.iter().all(|faults| faults.contains(fault))
    };
    first.iter().filter(|fault| is_shared(fault)).map(|fault| RowFault { field: field(fault), fault: fault.clone() }).collect()
}
