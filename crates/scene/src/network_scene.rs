use std::collections::{BTreeMap, BTreeSet};

use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Event, Mapper, PathPoint,
    memory::LinkKind,
    places::{Asr, AsrId, Exit, ExitId, Hypothesis, Network, outline},
};
use cogmap_simulation::MapperJournal;

use crate::{Colouring, Item, MemoryOptions, PlaceMark, Role, Sample, Scene, Shape};

/// A gap is shown as a supposed exit once so many views have seen it.
const SURE: u32 = 3;

/// The floors of the local spaces, below everything else.
pub(crate) fn draw_floors(scene: &mut Scene, mind: &Mapper) {
    let Some(network) = mind.network() else { return };
    for asr in network.asrs() {
        let map_from_asr = mind.mfis().map_from_frame(asr.frame);
        let corners = outline(asr, network, mind.memory()).into_iter().map(|corner| map_from_asr * corner);
        scene.still.push(item(PlaceMark::Floor(asr.id.0), Shape::Polygon(corners.collect())));
    }
}

/// What a mapper knows about local spaces, above its surfaces.
pub(crate) fn draw(scene: &mut Scene, mind: &Mapper, journal: &MapperJournal, options: MemoryOptions) {
    if options.frames {
        draw_frames(scene, mind);
    }
    let Some(network) = mind.network() else { return };
    let middles = middles(network, mind);
    if options.network {
        draw_edges(scene, mind, &middles, &loops(journal, network));
    }
    if options.exits {
        draw_supposed_exits(scene, mind, network);
        draw_exits(scene, mind, network.exits());
    }
    if options.network || options.colouring == Colouring::Asr {
        for (asr, at) in middles {
            scene.still.push(item(PlaceMark::Node(asr.0), Shape::Signs(vec![at])));
            let label = Shape::Label { at, text: asr.0.to_string(), room: f64::INFINITY };
            scene.still.push(item(PlaceMark::Number, label));
        }
        scene.explain(Sample::Node, "local space");
    }
}

fn item(mark: PlaceMark, shape: Shape) -> Item {
    Item::new(Role::Place(mark), shape)
}

/// The exits that closed a loop, by the names that they have now.
#[must_use]
pub fn loops(journal: &MapperJournal, network: &Network) -> BTreeSet<ExitId> {
    let exit = |(_, event): (usize, &Event)| match event {
        Event::LoopClosed { exit, .. } => Some(network.exit(*exit)?.id),
        _ => None,
    };
    journal.map_events().filter_map(exit).collect()
}

/// In the map.
pub(crate) fn placed(exit: &Exit, mind: &Mapper) -> Segment {
    mind.mfis().map_from_frame(exit.frame) * exit.segment
}

/// Exits that were seen ahead or beside the way, by number, as far as the robot has not gone through them.
pub(crate) fn supposed(network: &Network) -> impl Iterator<Item = (usize, &Hypothesis)> {
    let hypotheses = network.hypotheses().iter().enumerate();
    hypotheses.filter(|(_, it)| it.confirmed.is_none() && it.views >= SURE)
}

fn draw_supposed_exits(scene: &mut Scene, mind: &Mapper, network: &Network) {
    let supposed = supposed(network).map(|(_, it)| mind.mfis().map_from_frame(it.frame) * it.segment);
    let segments: Vec<_> = supposed.collect();
    if segments.is_empty() {
        return;
    }
    scene.still.push(item(PlaceMark::SupposedExit, Shape::Segments(segments.clone())));
    let jambs = segments.iter().flat_map(|segment| [segment.a, segment.b]);
    scene.still.extend(jambs.map(|jamb| item(PlaceMark::SupposedExit, Shape::Signs(vec![jamb]))));
    scene.explain(Sample::SupposedExit, "seen, not gone through");
}

fn draw_exits(scene: &mut Scene, mind: &Mapper, exits: &[Exit]) {
    if exits.is_empty() {
        return;
    }
    let segments: Vec<_> = exits.iter().map(|exit| placed(exit, mind)).collect();
    scene.still.push(item(PlaceMark::ExitRim, Shape::Segments(segments.clone())));
    scene.still.push(item(PlaceMark::Exit, Shape::Segments(segments.clone())));
    for Segment { a, b } in segments {
        scene.still.push(item(PlaceMark::Exit, Shape::Signs(vec![a])));
        scene.still.push(item(PlaceMark::Exit, Shape::Signs(vec![b])));
    }
    scene.explain(Sample::Exit, "exit");
}

fn draw_edges(scene: &mut Scene, mind: &Mapper, middles: &BTreeMap<AsrId, DVec2>, loops: &BTreeSet<ExitId>) {
    let mut shown = [false; 2];
    for exit in mind.network().map_or(&[][..], Network::exits) {
        let [Some(from), Some(to)] = exit.between.map(|asr| middles.get(&asr).copied()) else { continue };
        let way = Shape::Polyline(vec![from, placed(exit, mind).midpoint(), to]);
        if loops.contains(&exit.id) {
            scene.still.push(item(PlaceMark::ClosedLoop, way.clone()));
            scene.still.push(item(PlaceMark::ClosedLoopGap, way));
            shown[1] = true;
        } else {
            scene.still.push(item(PlaceMark::Passage, way));
            shown[0] = true;
        }
    }
    let [passage, closed] = shown;
    if passage {
        scene.explain(Sample::Line(Role::Place(PlaceMark::Passage)), "way through an exit");
    }
    if closed {
        scene.explain(Sample::ClosedLoop, "closed a loop");
    }
}

/// Where each local space stands in the network: the place on the ways through it that is nearest to the
/// middle of all of them, in the map. A space that the robot was never in is stood for by its entrance.
pub(crate) fn middles(network: &Network, mind: &Mapper) -> BTreeMap<AsrId, DVec2> {
    let place = |point: &PathPoint| {
        let asr = network.asr_at(point.step)?;
        Some((asr, mind.mfis().map_from_frame(point.frame) * point.frame_from_robot.position))
    };
    let places: Vec<(AsrId, DVec2)> = mind.path().iter().filter_map(place).collect();
    let mut sums: BTreeMap<AsrId, (DVec2, f64)> = BTreeMap::new();
    for (asr, place) in &places {
        let (sum, count) = sums.entry(*asr).or_default();
        *sum += *place;
        *count += 1.0;
    }
    let off =
        |asr: &AsrId, place: DVec2| sums.get(asr).map_or(0.0, |(sum, count)| place.distance(*sum / *count));
    let entrance = |asr: &Asr| mind.mfis().map_from_frame(asr.frame) * asr.frame_from_entrance.position;
    let mut middles: BTreeMap<AsrId, DVec2> =
        network.asrs().iter().map(|asr| (asr.id, entrance(asr))).collect();
    let mut nearest: BTreeMap<AsrId, f64> = BTreeMap::new();
    for (asr, place) in &places {
        let off = off(asr, *place);
        if nearest.get(asr).is_none_or(|nearest| off < *nearest) {
            nearest.insert(*asr, off);
            middles.insert(*asr, *place);
        }
    }
    middles
}

fn draw_frames(scene: &mut Scene, mind: &Mapper) {
    let mfis = mind.mfis();
    let origin = |frame| mfis.map_from_frame(frame).position;
    for (kind, mark, text) in [
        (LinkKind::Passage, PlaceMark::Link, "from one local frame to the next"),
        (LinkKind::Recognised, PlaceMark::RecognisedLink, "a place recognised"),
    ] {
        let links = mfis.links().iter().filter(|link| link.kind == kind);
        let links: Vec<_> = links.map(|link| Segment::new(origin(link.from), origin(link.to))).collect();
        if !links.is_empty() {
            scene.still.push(item(mark, Shape::Segments(links)));
            scene.explain(Sample::Line(Role::Place(mark)), text);
        }
    }
    let origins = mfis.frames().iter().map(|frame| frame.map_from_frame.position).collect();
    scene.still.push(item(PlaceMark::Frame, Shape::Signs(origins)));
    scene.explain(Sample::Sign(Role::Place(PlaceMark::Frame)), "a local frame");
}

#[cfg(test)]
pub(crate) mod tests {
    use cogmap_mapping::MapperSetup;
    use cogmap_simulation::{Command, Robot, Session, SessionRecord, Source, World};

    use super::*;
    use crate::memory_scene;

    /// A robot that has driven through a door, 4 m ahead of where its map begins, into another room.
    pub(crate) fn session(mapper: &str) -> Session {
        let world: World = serde_json::from_str(
            r#"{"format": "cogmap-world/1", "name": "Two rooms", "start": {"position": [2, 2.5]},
                "walls": [[[0,0],[12,0],[12,5],[0,5],[0,0]], [[6,0],[6,2.1]], [[6,2.9],[6,5]]]}"#,
        )
        .unwrap();
        let source = Source::world(world, Robot::named("perfect").unwrap());
        let mappers = vec![MapperSetup::named(mapper).unwrap()];
        let mut session = Session::drive(SessionRecord::new(source, mappers, 1)).unwrap();
        for _ in 0..15 {
            session.command(Command::Step { turn: 0.0, travel: 0.5 });
            while session.advance() && !session.at_rest() {}
        }
        session
    }

    fn everything() -> MemoryOptions {
        MemoryOptions { network: true, frames: true, colouring: Colouring::Asr, ..MemoryOptions::default() }
    }

    fn marks(scene: &Scene) -> Vec<(PlaceMark, &Shape)> {
        let mark = |item: &'_ Item| match item.role {
            Role::Place(mark) => Some(mark),
            _ => None,
        };
        scene.still.iter().filter_map(|item| Some((mark(item)?, &item.shape))).collect()
    }

    #[test]
    fn an_exit_is_drawn_in_the_door_and_the_way_leads_through_it() {
        let scene = memory_scene(&session("consensus"), 0, everything());
        let marks = marks(&scene);
        let exits = marks.iter().filter_map(|(mark, shape)| match (mark, shape) {
            (PlaceMark::Exit, Shape::Segments(exits)) => Some(exits.clone()),
            _ => None,
        });
        let exits: Vec<Segment> = exits.flatten().collect();
        assert_eq!(exits.len(), 1);
        // The door is 4 m ahead of where the map begins.
        assert!(exits[0].midpoint().distance(DVec2::new(4.0, 0.0)) < 0.3, "{exits:?}");
        let ways = marks.iter().filter(|(mark, _)| *mark == PlaceMark::Passage);
        let middle = |shape: &Shape| matches!(shape, Shape::Polyline(way) if way[1] == exits[0].midpoint());
        assert_eq!(ways.filter(|(_, shape)| middle(shape)).count(), 1);
    }

    #[test]
    fn every_local_space_has_its_floor_and_its_number() {
        let scene = memory_scene(&session("perceptual"), 0, everything());
        let marks = marks(&scene);
        for number in 0..2 {
            let floors = marks.iter().filter(|(mark, _)| *mark == PlaceMark::Floor(number));
            assert!(
                floors.clone().all(|(_, shape)| matches!(shape, Shape::Polygon(floor) if floor.len() > 3))
            );
            assert_eq!(floors.count(), 1);
            assert!(marks.iter().any(|(mark, _)| *mark == PlaceMark::Node(number)));
            assert!(marks.iter().any(|(mark, _)| *mark == PlaceMark::Surface(number)));
        }
    }

    #[test]
    fn a_mapper_without_local_spaces_is_coloured_by_view() {
        let scene = memory_scene(&session("transform"), 0, MemoryOptions { frames: false, ..everything() });
        assert!(marks(&scene).is_empty());
        assert!(scene.still.iter().any(|item| item.role == Role::SurfaceOfView(0)));
    }
}
