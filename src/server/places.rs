//! Who may be connected: places for all, a limit for each peer, and a reserve.
//!
//! A connection that waits for a head gives way to a new one: first those of the peer with the most connections, and of
//! those the one that has waited longest. Where there is none, one gives way whose client has stopped in the middle of a body
//! or of an answer. So nobody keeps others out by being silent. Where all are busy, the reserve takes who comes, to answer
//! the questions of operators and to say no to the rest.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::time::Instant;

use super::link::Link;
use super::peer::Peer;
use super::{Bounds, Reason};

/// Places of the reserve.
pub(super) const RESERVE: usize = 16;

#[derive(Debug)]
pub(super) struct Places {
    bounds: Bounds,
    taken: Mutex<Taken>,
}

#[derive(Debug, Default)]
struct Taken {
    next: u64,
    links: HashMap<u64, Arc<Link>>,
    /// Connections of each peer, without those of the reserve.
    by_peer: HashMap<Peer, usize>,
    in_reserve: usize,
}

impl Places {
    pub(super) fn new(bounds: Bounds) -> Self {
        Self { bounds, taken: Mutex::default() }
    }

    /// Every change is one statement, made after everything that could fail.
    fn taken(&self) -> MutexGuard<'_, Taken> {
        self.taken.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A place for a connection of this peer; none where even the reserve is busy.
    pub(super) fn admit(&self, peer: Peer, now: Instant) -> Option<Arc<Link>> {
        let mut taken = self.taken();
        let of_peer = taken.by_peer.get(&peer).copied().unwrap_or(0);
        let all = taken.links.len() - taken.in_reserve;
        let is_admitted = (of_peer < self.bounds.of_one_peer
            || taken.make_room(now, |link| !link.is_reserve && link.peer == peer))
            && (all < self.bounds.connections
                || of_peer >= self.bounds.of_one_peer
                || taken.make_room(now, |link| !link.is_reserve));
        if is_admitted || taken.in_reserve < RESERVE || taken.make_room(now, |link| link.is_reserve) {
            Some(taken.enter(peer, !is_admitted, self.bounds))
        } else {
            None
        }
    }

    /// Ends a connection that gives way, if there is one.
    pub(super) fn make_room(&self) -> bool {
        self.taken().make_room(Instant::now(), |_| true)
    }

    /// A connection has ended.
    pub(super) fn leave(&self, link: &Link) {
        self.taken().leave(link.id);
    }

    /// Connections on which a request is answered or an answer is taken.
    pub(super) fn busy(&self) -> usize {
        self.taken().links.values().filter(|link| link.is_busy()).count()
    }
}

impl Taken {
    fn enter(&mut self, peer: Peer, is_reserve: bool, bounds: Bounds) -> Arc<Link> {
        let link = Arc::new(Link::new(self.next, peer, is_reserve, bounds));
        self.next += 1;
        self.links.insert(link.id, link.clone());
        if is_reserve {
            self.in_reserve += 1;
        } else {
            *self.by_peer.entry(peer).or_default() += 1;
        }
        link
    }

    fn leave(&mut self, id: u64) {
        let Some(link) = self.links.remove(&id) else { return };
        if link.is_reserve {
            self.in_reserve -= 1;
        } else if let Some(count) = self.by_peer.get_mut(&link.peer) {
            *count -= 1;
            if *count == 0 {
                self.by_peer.remove(&link.peer);
            }
        }
    }

    /// Ends the connection among these that gives way first, if one of them does.
    fn make_room(&mut self, now: Instant, among: impl Fn(&Link) -> bool) -> bool {
        let waiting = self.links.values().filter(|link| among(link)).filter_map(|link| {
            let of_peer = self.by_peer.get(&link.peer).copied().unwrap_or(0);
            let (way, since) = link.gives_way(now)?;
            Some((way, Reverse(of_peer), since, link.id))
        });
        let Some((.., id)) = waiting.min() else { return false };
        if let Some(link) = self.links.get(&id) {
            link.end(Reason::MadeRoom);
        }
        self.leave(id);
        true
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    const BOUNDS: Bounds = Bounds { connections: 4, of_one_peer: 3, ..Bounds::DEFAULT };

    /// When those who have come are no longer new.
    fn soon() -> Instant {
        Instant::now() + Duration::from_secs(1)
    }

    fn peer(last: u32) -> Peer {
        Peer::V4(last)
    }

    fn enter(places: &Places, number: u32) -> Arc<Link> {
        places.admit(peer(number), soon()).expect("a place")
    }

    #[test]
    fn the_peer_with_the_most_connections_gives_way_with_its_oldest() {
        let places = Places::new(BOUNDS);
        let one = enter(&places, 1);
        let two: Vec<_> = (0..3).map(|_| enter(&places, 2)).collect();
        let three = enter(&places, 3);
        assert_eq!(two[0].reason(), Some(Reason::MadeRoom));
        assert!(!three.is_reserve && one.reason().is_none() && two[1].reason().is_none());
    }

    #[test]
    fn a_busy_connection_does_not_give_way() {
        let places = Places::new(BOUNDS);
        let two: Vec<_> = (0..3).map(|_| enter(&places, 2)).collect();
        two[0].asked();
        two[1].write_waits();
        let more = enter(&places, 2);
        assert!(!more.is_reserve && two[2].reason() == Some(Reason::MadeRoom));
        assert!(two[0].reason().is_none() && two[1].reason().is_none());
        assert_eq!(places.busy(), 2);
    }

    #[test]
    fn who_has_just_come_gives_way_last() {
        let now = Instant::now(); // before all of them, so that none is old
        let places = Places::new(Bounds { connections: 2, of_one_peer: 2, ..BOUNDS });
        let (slow, fresh) = (enter(&places, 1), enter(&places, 1));
        slow.asked();
        slow.awaits_body(now.checked_sub(Duration::from_secs(60)));
        places.admit(peer(1), now).expect("the place of the slow one").asked();
        assert!(slow.reason() == Some(Reason::MadeRoom) && fresh.reason().is_none());
        assert!(places.admit(peer(1), now).is_some_and(|link| !link.is_reserve));
        assert_eq!(fresh.reason(), Some(Reason::MadeRoom));
    }

    #[test]
    fn who_stops_in_the_middle_gives_way_after_the_idle() {
        let places = Places::new(Bounds { connections: 2, ..BOUNDS });
        let (slow, idle) = (enter(&places, 1), enter(&places, 2));
        slow.asked();
        slow.awaits_body(Some(Instant::now()));
        assert!(places.admit(peer(3), Instant::now() + Duration::from_secs(60)).is_some_and(|link| !link.is_reserve));
        assert!(idle.reason() == Some(Reason::MadeRoom) && slow.reason().is_none());
        for link in places.taken().links.values() {
            link.asked();
        }
        assert!(enter(&places, 4).is_reserve, "one second is no hesitation");
        assert!(places.admit(peer(5), Instant::now() + Duration::from_secs(60)).is_some_and(|link| !link.is_reserve));
        assert_eq!(slow.reason(), Some(Reason::MadeRoom));
    }

    #[test]
    fn a_peer_beyond_its_limit_harms_itself_alone() {
        let places = Places::new(BOUNDS);
        let one = enter(&places, 1);
        for _ in 0..3 {
            enter(&places, 2).asked();
        }
        assert!(enter(&places, 2).is_reserve && one.reason().is_none(), "its requests are all busy: it gets a refusal");
        assert!(!enter(&places, 3).is_reserve, "another peer still gets in");
    }

    #[test]
    fn the_reserve_is_full_only_of_busy_connections() {
        let places = Places::new(BOUNDS);
        for number in 0..4 {
            enter(&places, number).asked();
        }
        let reserve: Vec<_> = (0..RESERVE).map(|_| enter(&places, 9)).collect();
        assert!(reserve.iter().all(|link| link.is_reserve));
        assert!(enter(&places, 9).is_reserve && reserve[0].reason() == Some(Reason::MadeRoom));
        for link in &reserve[1..] {
            link.asked();
        }
        enter(&places, 9).asked();
        assert!(places.admit(peer(9), soon()).is_none());
        places.leave(&reserve[5]);
        assert!(enter(&places, 9).is_reserve);
    }
}
