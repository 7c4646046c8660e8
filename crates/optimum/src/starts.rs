//! Where to go on from.

use crate::aim::Aim;
use crate::archive::{Archive, Seen};

/// How often the distance of the starts is halved.
const ROUNDS: u32 = 4;

/// The best of all points.
pub(crate) fn best<'a>(archive: &'a Archive, aim: &Aim) -> Option<&'a Seen> {
    archive.iter().reduce(|best, seen| if aim.is_better(seen, best) { seen } else { best })
}

/// The best points that are not near each other nor near `taken`: the most promising starts, in as many places as there are.
/// Where there are too few places, nearer ones count.
pub(crate) fn promising(archive: &Archive, aim: &Aim, count: usize, taken: &[Seen]) -> Vec<Seen> {
    let mut ranked: Vec<(bool, f64, &Seen)> = archive.iter().map(|seen| (!aim.is_kept(seen), aim.rank(seen), seen)).collect();
    ranked.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let dimensions = archive.first().map_or(1, |seen| seen.shares.len());
    let mut apart = 0.5 / ((count + 1) as f64).powf(1.0 / dimensions as f64);
    let mut chosen: Vec<Seen> = Vec::with_capacity(count);
    for _ in 0..ROUNDS {
        for (.., seen) in &ranked {
            if chosen.len() == count {
                return chosen;
            }
            if chosen.iter().chain(taken).all(|other| other.distance(&seen.shares) >= apart) {
                chosen.push((*seen).clone());
            }
        }
        apart *= 0.5;
    }
    chosen
}
