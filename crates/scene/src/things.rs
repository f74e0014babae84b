//! What of a memory can be pointed at: which thing lies where, and how it is set off from the rest.

mod accent;

use cogmap_geometry::{DVec2, Segment, is_inside};
use cogmap_mapping::{
    Mapper,
    memory::SurfaceId,
    places::{Asr, AsrId, ExitId, Network, outline},
};

pub use self::accent::set_off;
use crate::{
    Colouring, MemoryOptions,
    network_scene::{middles, placed, supposed},
};

/// A thing in a mapper's mind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Thing {
    /// A surface that it remembers.
    Surface(SurfaceId),
    /// An exit that the robot went through.
    Exit(ExitId),
    /// An exit that it only saw, by its place among the hypotheses.
    Supposed(usize),
    /// A local space.
    Asr(AsrId),
}

/// The thing that a picture with these options shows within `reach` metres of a point of the map, the one on
/// top where there are several: spaces by their signs, then exits, then surfaces; floors last, where they are drawn.
#[must_use]
pub fn thing_at(mind: &Mapper, options: MemoryOptions, at: DVec2, reach: f64) -> Option<Thing> {
    let nodes = has_nodes(options).then(|| nearest(nodes(mind), at, reach)).flatten();
    let exits =
        || options.exits.then(|| nearest(exits(mind).chain(supposed_exits(mind)), at, reach)).flatten();
    let surfaces = || nearest(surfaces(mind), at, reach);
    let floor = || (options.colouring == Colouring::Asr).then(|| floor_at(mind, at)).flatten();
    nodes.or_else(exits).or_else(surfaces).or_else(floor)
}

/// Where a thing lies in the map, a space by its sign; `None` where the mapper has no such thing in mind.
#[must_use]
pub fn segment_of(mind: &Mapper, thing: Thing) -> Option<Segment> {
    let network = || mind.network();
    match thing {
        Thing::Surface(id) => {
            mind.mfis().get(id).filter(|_| mind.mfis().remembers(id)).map(|stored| mind.mfis().in_map(stored))
        }
        Thing::Exit(id) => network()?.exit(id).map(|exit| placed(exit, mind)),
        Thing::Supposed(number) => supposed(network()?)
            .find(|(other, _)| *other == number)
            .map(|(_, it)| mind.mfis().map_from_frame(it.frame) * it.segment),
        Thing::Asr(id) => nodes(mind).find(|(other, _)| *other == Thing::Asr(id)).map(|(_, node)| node),
    }
}

/// All things of the same kind as one, in the order of their numbers.
#[must_use]
pub fn things_like(mind: &Mapper, thing: Thing) -> Vec<Thing> {
    let things: &mut dyn Iterator<Item = (Thing, Segment)> = match thing {
        Thing::Surface(_) => &mut surfaces(mind),
        Thing::Exit(_) => &mut exits(mind),
        Thing::Supposed(_) => &mut supposed_exits(mind),
        Thing::Asr(_) => &mut nodes(mind),
    };
    things.map(|(thing, _)| thing).collect()
}

/// Whether the numbers of the local spaces stand in the picture.
fn has_nodes(options: MemoryOptions) -> bool {
    options.network || options.colouring == Colouring::Asr
}

fn nodes(mind: &Mapper) -> impl Iterator<Item = (Thing, Segment)> {
    let middles = mind.network().map(|network| middles(network, mind)).unwrap_or_default();
    middles.into_iter().map(|(asr, at)| (Thing::Asr(asr), Segment::new(at, at)))
}

fn exits(mind: &Mapper) -> impl Iterator<Item = (Thing, Segment)> + '_ {
    let exits = mind.network().into_iter().flat_map(Network::exits);
    exits.map(|exit| (Thing::Exit(exit.id), placed(exit, mind)))
}

fn supposed_exits(mind: &Mapper) -> impl Iterator<Item = (Thing, Segment)> + '_ {
    let supposed = mind.network().into_iter().flat_map(supposed);
    supposed.map(|(number, it)| (Thing::Supposed(number), mind.mfis().map_from_frame(it.frame) * it.segment))
}

fn surfaces(mind: &Mapper) -> impl Iterator<Item = (Thing, Segment)> + '_ {
    mind.mfis().remembered().map(|stored| (Thing::Surface(stored.id), mind.mfis().in_map(stored)))
}

/// Of several that are equally near the last, which is drawn on top.
fn nearest(things: impl Iterator<Item = (Thing, Segment)>, at: DVec2, reach: f64) -> Option<Thing> {
    let away = things.map(|(thing, segment)| (segment.distance_to(at), thing));
    let near = away.filter(|(away, _)| *away <= reach);
    near.reduce(|best, next| if next.0 <= best.0 { next } else { best }).map(|(_, thing)| thing)
}

/// The local space whose floor holds a point of the map.
fn floor_at(mind: &Mapper, at: DVec2) -> Option<Thing> {
    let holds = |asr: &&Asr| is_inside(&floor(mind, asr), at);
    let asrs = mind.network()?.asrs();
    asrs.iter().rev().find(holds).map(|asr| Thing::Asr(asr.id))
}

/// The floor of a local space, in the map.
fn floor(mind: &Mapper, asr: &Asr) -> Vec<DVec2> {
    let map_from_asr = mind.mfis().map_from_frame(asr.frame);
    let Some(network) = mind.network() else { return Vec::new() };
    outline(asr, network, mind.memory()).into_iter().map(|corner| map_from_asr * corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network_scene::tests::session;

    fn everything() -> MemoryOptions {
        MemoryOptions { network: true, ..MemoryOptions::default() }
    }

    #[test]
    fn what_is_on_top_is_pointed_at() {
        let session = session("consensus");
        let mind = &session.mappers()[0];
        let at = |x: f64, y: f64| thing_at(mind, everything(), DVec2::new(x, y), 0.1);
        assert_eq!(at(4.0, 0.0), Some(Thing::Exit(ExitId(0))));
        let Some(Thing::Surface(wall)) = at(1.0, 2.5) else { panic!("{:?}", at(1.0, 2.5)) };
        let line = mind.mfis().in_map(mind.mfis().get(wall).unwrap());
        assert!(line.distance_to(DVec2::new(1.0, 2.5)) < 0.1);
        let node = segment_of(mind, Thing::Asr(AsrId(1))).unwrap().midpoint();
        assert_eq!(at(node.x, node.y), Some(Thing::Asr(AsrId(1))));
        assert_eq!(at(2.0, 1.2), None);
        assert_eq!(at(f64::NAN, 0.0), None);
    }

    #[test]
    fn what_is_not_drawn_cannot_be_pointed_at() {
        let session = session("consensus");
        let mind = &session.mappers()[0];
        let node = segment_of(mind, Thing::Asr(AsrId(0))).unwrap().midpoint();
        let hidden = MemoryOptions { exits: false, network: false, ..everything() };
        assert_eq!(thing_at(mind, hidden, node, 0.05), None);
        assert_eq!(thing_at(mind, hidden, DVec2::new(4.0, 0.0), 0.05), None);
        let floors = MemoryOptions { colouring: Colouring::Asr, ..hidden };
        assert_eq!(thing_at(mind, floors, DVec2::new(1.0, 1.0), 0.05), Some(Thing::Asr(AsrId(0))));
        assert_eq!(thing_at(mind, floors, DVec2::new(7.0, 1.0), 0.05), Some(Thing::Asr(AsrId(1))));
    }

    #[test]
    fn things_are_listed_by_number_and_those_that_are_not_there_lie_nowhere() {
        let session = session("consensus");
        let mind = &session.mappers()[0];
        let surfaces = things_like(mind, Thing::Surface(SurfaceId(0)));
        assert_eq!(surfaces.len(), mind.mfis().surfaces().len());
        assert!(surfaces.is_sorted());
        assert_eq!(things_like(mind, Thing::Asr(AsrId(0))).len(), 2);
        for thing in [
            Thing::Surface(SurfaceId(9999)),
            Thing::Exit(ExitId(7)),
            Thing::Supposed(99),
            Thing::Asr(AsrId(9)),
        ] {
            assert_eq!(segment_of(mind, thing), None, "{thing:?}");
        }
    }
}
