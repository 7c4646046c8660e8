//! Tasks whose solutions are known, and tasks that have none.

mod awkward;
mod fronts;
mod published;
mod tasks;
