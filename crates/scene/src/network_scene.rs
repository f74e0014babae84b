use std::collections::BTreeSet;

use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Event, Mapper,
    memory::LinkKind,
    places::{Asr, AsrId, Exit, ExitId, Network, outline},
};
use cogmap_simulation::MapperJournal;

use crate::{Colouring, Item, MemoryOptions, PlaceMark, Role, Sample, Scene, Shape};

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
    if options.network {
        draw_edges(scene, mind, network, &loops(journal, network));
    }
    if options.exits && !network.exits().is_empty() {
        draw_exits(scene, mind, network.exits());
    }
    if options.network || options.colouring == Colouring::Asr {
        for asr in network.asrs() {
            let at = middle(asr, network, mind);
            scene.still.push(item(PlaceMark::Node(asr.id.0), Shape::Signs(vec![at])));
            let label = Shape::Label { at, text: asr.id.0.to_string(), room: f64::INFINITY };
            scene.still.push(item(PlaceMark::Number, label));
        }
        scene.explain(Sample::Sign(Role::Place(PlaceMark::Node(0))), "local space");
    }
}

fn item(mark: PlaceMark, shape: Shape) -> Item {
    Item::new(Role::Place(mark), shape)
}

/// The exits that closed a loop.
fn loops(journal: &MapperJournal, network: &Network) -> BTreeSet<ExitId> {
    let exit = |(_, event): &(usize, Event)| match event {
        Event::LoopClosed { exit, .. } => Some(network.exit(*exit)?.id),
        _ => None,
    };
    journal.events.iter().filter_map(exit).collect()
}

/// In the map.
fn placed(exit: &Exit, mind: &Mapper) -> Segment {
    mind.mfis().map_from_frame(exit.frame) * exit.segment
}

fn draw_exits(scene: &mut Scene, mind: &Mapper, exits: &[Exit]) {
    let segments: Vec<_> = exits.iter().map(|exit| placed(exit, mind)).collect();
    scene.still.push(item(PlaceMark::ExitRim, Shape::Segments(segments.clone())));
    scene.still.push(item(PlaceMark::Exit, Shape::Segments(segments.clone())));
    for Segment { a, b } in segments {
        scene.still.push(item(PlaceMark::Exit, Shape::Signs(vec![a])));
        scene.still.push(item(PlaceMark::Exit, Shape::Signs(vec![b])));
    }
    scene.explain(Sample::Exit, "exit");
}

fn draw_edges(scene: &mut Scene, mind: &Mapper, network: &Network, loops: &BTreeSet<ExitId>) {
    let place = |id: AsrId| Some(middle(network.asr(id)?, network, mind));
    let mut shown = [false; 2];
    for exit in network.exits() {
        let [Some(from), Some(to)] = exit.between.map(place) else { continue };
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

/// Where a local space stands in the network: the place on the way through it that is nearest to the
/// middle of all of them, in the map. A space that was never in is stood for by its entrance.
fn middle(asr: &Asr, network: &Network, mind: &Mapper) -> DVec2 {
    let within = mind.path().iter().filter(|point| network.asr_at(point.step) == Some(asr.id));
    let places: Vec<DVec2> = within.map(|point| mind.mfis().place_of(point).position).collect();
    let mean = places.iter().sum::<DVec2>() / places.len().max(1) as f64;
    let nearest = places.into_iter().min_by(|a, b| a.distance(mean).total_cmp(&b.distance(mean)));
    let entrance = mind.mfis().map_from_frame(asr.frame) * asr.frame_from_entrance;
    nearest.unwrap_or(entrance.position)
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
