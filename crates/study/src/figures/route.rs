use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Mapper,
    places::{AsrId, Exit, ExitId, Network},
};
use cogmap_scene::{
    Annotation, Colouring, Item, LegendEntry, MemoryOptions, PlaceMark, Role, Sample, Scene, Shape,
};

use super::{
    Drawing, Runs,
    draw::{arrow, lines, role},
    maps::{panel_of, seen_in_the_world},
    network::{network_alone, network_of},
    outings::TOUR,
    runs::Run,
};

const OURS: &str = "consensus";

/// A route through the network, in the world.
struct Way<'a> {
    run: &'a Run,
    mapper: &'a Mapper,
    network: &'a Network,
    exits: Vec<ExitId>,
    from: AsrId,
    to: AsrId,
}

impl<'a> Way<'a> {
    /// From the first space to the one that is the most exits away.
    fn longest(run: &'a Run) -> Result<Self, String> {
        let (mapper, network) = network_of(run, OURS)?;
        let from = network.asrs().first().ok_or("there is no local space")?.id;
        let routes = network.asrs().iter().filter_map(|asr| Some((asr.id, network.route(from, asr.id)?)));
        let (to, exits) = routes.max_by_key(|(_, exits)| exits.len()).ok_or("there is no route")?;
        Ok(Self { run, mapper, network, exits, from, to })
    }

    fn crossing(&self, exit: ExitId) -> Option<(&Exit, Segment)> {
        let exit = self.network.exit(exit)?;
        let map_from_exit = self.mapper.mfis().map_from_frame(exit.frame);
        Some((exit, self.run.world_from_map() * (map_from_exit * exit.segment)))
    }

    fn middles(&self) -> Vec<DVec2> {
        self.exits.iter().filter_map(|&exit| Some(self.crossing(exit)?.1.midpoint())).collect()
    }

    /// The middle of a space as the network is drawn.
    fn node(&self, asr: AsrId, items: &[Item]) -> Option<DVec2> {
        items.iter().find_map(|item| match (item.role, &item.shape) {
            (Role::Place(PlaceMark::Node(id)), Shape::Signs(at)) if id == asr.0 => at.first().copied(),
            _ => None,
        })
    }

    /// The spaces along it.
    fn spaces(&self) -> Vec<AsrId> {
        let mut at = self.from;
        let mut spaces = vec![at];
        for exit in self.exits.iter().filter_map(|&exit| self.network.exit(exit)) {
            at = exit.leads_from(at).unwrap_or(at);
            spaces.push(at);
        }
        spaces
    }
}

fn source(run: &Run) -> String {
    format!("the consensus mapper, {}", run.words())
}

/// The route ends so far before the middle of the last node, metres, that its head can be seen.
const NODE: f64 = 0.3;

/// Fig. 2.2.
pub(super) fn through_the_network(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&TOUR)?;
    let way = Way::longest(&run)?;
    let mut scene = network_alone(&run, OURS);
    let mut points = Vec::new();
    for (space, exit) in way.spaces().into_iter().zip(way.middles()) {
        points.extend(way.node(space, &scene.still));
        points.push(exit);
    }
    let before = points.last().copied().unwrap_or_default();
    points
        .extend(way.node(way.to, &scene.still).map(|node| node - (node - before).normalize_or_zero() * NODE));
    let first_node = scene.still.iter().position(|item| matches!(item.role, Role::Place(PlaceMark::Node(_))));
    let at = first_node.unwrap_or(scene.still.len());
    scene.still.insert(at, arrow(Annotation::Movement, &points));
    scene.legend.push(LegendEntry::new(Sample::Line(role(Annotation::Movement)), "route"));
    let outcome =
        format!("Here from space {} to space {} through {} exits.", way.from.0, way.to.0, way.exits.len());
    Ok(Drawing { panels: vec![panel_of("", scene)], columns: 1, outcome, source: source(&run) })
}

/// Fig. 2.3.
pub(super) fn through_one_space(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&TOUR)?;
    let way = Way::longest(&run)?;
    let spaces = way.spaces();
    let exits_of = |asr: AsrId| way.network.asr(asr).map_or(&[][..], |asr| &asr.exits);
    let inner = spaces.windows(3).zip(way.exits.windows(2)).max_by_key(|(trio, _)| exits_of(trio[1]).len());
    let (trio, taken) = inner.ok_or("the route is too short")?;
    let lines_of = |exits: &[ExitId]| -> Vec<Segment> {
        exits.iter().filter_map(|&exit| Some(way.crossing(exit)?.1)).collect()
    };
    let mut scene = spaces_alone(&run, trio);
    scene.still.extend(drawn_exits(&lines_of(exits_of(trio[1]))));
    let middles: Vec<DVec2> = lines_of(taken).iter().map(|exit| exit.midpoint()).collect();
    scene.still.push(arrow(Annotation::Movement, &middles));
    let outcome = format!(
        "Here from space {} to space {}: of the {} exits of space {} it has to take the right one.",
        trio[0].0,
        trio[2].0,
        exits_of(trio[1]).len(),
        trio[1].0
    );
    Ok(Drawing { panels: vec![panel_of("", scene)], columns: 1, outcome, source: source(&run) })
}

/// A few spaces with their surfaces and numbers.
fn spaces_alone(run: &Run, spaces: &[AsrId]) -> Scene {
    let colouring = Colouring::Asr;
    let options = MemoryOptions { view: false, path: false, colouring, ..MemoryOptions::default() };
    let mut scene = seen_in_the_world(run, OURS, options);
    let here = |id: u32| spaces.iter().any(|asr| asr.0 == id);
    scene.still.retain(|item| match (item.role, &item.shape) {
        (Role::Place(PlaceMark::Surface(id) | PlaceMark::Debris(id)), _) => here(id),
        (Role::Place(PlaceMark::Floor(id) | PlaceMark::Node(id)), _) => here(id),
        (Role::Place(PlaceMark::Number), Shape::Label { text, .. }) => text.parse().is_ok_and(here),
        _ => false,
    });
    scene.changing.clear();
    scene.legend = vec![
        LegendEntry::new(Sample::Asrs, "a colour for each local space"),
        LegendEntry::new(Sample::Exit, "exit"),
        LegendEntry::new(Sample::Line(role(Annotation::Movement)), "from one exit to the next"),
    ];
    scene
}

fn drawn_exits(exits: &[Segment]) -> Vec<Item> {
    let (rim, line) = (Role::Place(PlaceMark::ExitRim), Role::Place(PlaceMark::Exit));
    let mut items = vec![lines(rim, exits.iter().copied()), lines(line, exits.iter().copied())];
    let jambs = exits.iter().flat_map(|exit| [exit.a, exit.b]);
    items.extend(jambs.map(|jamb| Item::new(line, Shape::Signs(vec![jamb]))));
    items
}
