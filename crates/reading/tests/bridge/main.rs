//! A request that has a field of every kind.

mod contract;
mod declared;
mod sample;
