//! Requests declared once: what a client may write is static data, from which come the reading of it with all faults at once, the
//! hints at what was meant, the JSON schema and the query parameters of the contract.
//!
//! A JSON body and a URL query become one tree, a [`Node`]. A [`Field`] says what a field is called, which [`Kind`] of value it
//! holds, whether it has to be there and what it means. An [`Object`] is made of groups of fields; a [`Tagged`] object has other
//! fields for each word of its tag. Plain functions take the fields off a [`Reader`] and make of them what they will:
//!
//! ```
//! use terramechanics_reading::*;
//!
//! #[derive(Clone, Copy, PartialEq)]
//! enum Way { Slow, Fast }
//!
//! const DISTANCE: Field<Number> = Field::required("distance_m", "How far (m).", Number::new("m", 0.0, 1e6));
//! const WAY: Field<Word<Way>> =
//!     Field::new("way", "How fast.", Word::new(&[("slow", Way::Slow), ("fast", Way::Fast)]).or(Way::Slow));
//! const WALK: Object = Object { name: "Walk", doc: "A walk.", groups: &[&[&DISTANCE, &WAY]] };
//!
//! fn seconds(walk: &Reader<'_>) -> Option<f64> {
//!     let (distance, way) = (walk.required(&DISTANCE), walk.or_default(&WAY));
//!     Some(distance? / match way? { Way::Slow => 1.0, Way::Fast => 2.0 })
//! }
//!
//! let query = Query::parse("distance_m=100&way=fast").expect("few parameters").into_node();
//! assert_eq!(read(&query, &WALK, &Hints::NONE, seconds), Ok(50.0));
//! let body = json(br#"{"way": "fats"}"#).expect("JSON");
//! let faults = read(&body, &WALK, &Hints::NONE, seconds).expect_err("two faults");
//! assert_eq!(faults[0], FieldFault::new("/distance_m", "is required"));
//! assert_eq!(faults[1], FieldFault::new("/way", "unknown name `fats`; did you mean `fast`?"));
//! ```
//!
//! Nothing that is sent can make it panic, and all it keeps is bounded: the depth of the tree, its fields, the faults.

mod assumption;
mod fault;
mod field;
mod hints;
mod json;
mod list;
mod literal;
mod nested;
mod node;
mod number;
mod object;
mod one_of;
mod path;
mod query;
mod reader;
mod slot;
mod syntax;
mod tagged;
mod word;

pub use assumption::Assumption;
pub use fault::{Faults, FieldFault, Figures, Scope, unknown_word};
pub use field::{Components, Declared, Field, Group, Kind, component_name, group};
pub use hints::{Hints, OtherUnit, shortened};
pub use json::{MOST_NODES, Unread, json};
pub use list::{Bounds, Items, Numbers, Objects, Words};
pub use nested::Nested;
pub use node::{Fields, Item, List, Node};
pub use number::{Number, in_millimetres};
pub use object::{Object, Unknown, collected, read, read_assuming};
pub use one_of::{Alternative, Either, OneOf};
pub use path::{Astray, Path, Way};
pub use query::{Query, TooManyParameters};
pub use reader::{Defaulting, Reader};
pub use slot::{Blocked, Slot};
pub use syntax::fault_in_words;
pub use tagged::{Base, Chosen, Tagged, Variant};
pub use word::{Flag, Label, Lookup, Word};
