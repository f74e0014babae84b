//! Two scenes that show every role, drawn by hand.

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_scene::{Item, LegendEntry, PlaceMark, Role, Sample, Scene, Shape};

fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
    Segment::new(DVec2::from(a), DVec2::from(b))
}

fn points(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().copied().map(DVec2::from).collect()
}

fn rectangle([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Shape {
    Shape::Polygon(points(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]))
}

fn label(at: [f64; 2], text: &str, room: f64) -> Item {
    Item::new(Role::RoomLabel, Shape::Label { at: DVec2::from(at), text: text.to_owned(), room })
}

/// The walls of three rooms along a corridor.
fn walls() -> Vec<Segment> {
    [
        ([0.0, 0.0], [12.0, 0.0]),
        ([12.0, 0.0], [12.0, 7.0]),
        ([12.0, 7.0], [0.0, 7.0]),
        ([0.0, 7.0], [0.0, 0.0]),
        ([0.0, 4.6], [1.6, 4.6]),
        ([2.5, 4.6], [6.6, 4.6]),
        ([7.5, 4.6], [9.4, 4.6]),
        ([10.3, 4.6], [12.0, 4.6]),
        ([4.4, 4.6], [4.4, 7.0]),
        ([8.4, 4.6], [8.4, 7.0]),
        ([0.0, 2.8], [5.0, 2.8]),
        ([5.9, 2.8], [12.0, 2.8]),
        ([7.2, 0.0], [7.2, 2.8]),
    ]
    .map(|(a, b)| segment(a, b))
    .to_vec()
}

fn way() -> Vec<[f64; 2]> {
    vec![
        [1.0, 1.2],
        [1.8, 1.3],
        [2.7, 1.4],
        [3.6, 1.5],
        [4.6, 1.6],
        [5.4, 2.1],
        [5.5, 2.9],
        [5.6, 3.7],
        [6.4, 3.8],
        [7.2, 3.7],
        [8.1, 3.6],
        [9.0, 3.7],
        [9.8, 3.9],
        [9.9, 4.7],
        [10.0, 5.5],
    ]
}

/// What stands still.
fn building() -> Vec<Item> {
    vec![
        Item::new(Role::Room, rectangle([0.0, 0.0], [12.0, 7.0])),
        Item::new(Role::Furniture, rectangle([0.2, 2.0], [1.8, 2.7])),
        Item::new(Role::Furniture, rectangle([3.0, 0.1], [4.8, 0.8])),
        Item::new(Role::Furniture, rectangle([10.3, 6.6], [10.85, 7.0])),
        Item::new(Role::Furniture, Shape::Disc(DVec2::new(9.2, 1.1), 0.03)),
        Item::new(Role::Furniture, Shape::Disc(DVec2::new(9.9, 1.1), 0.03)),
        Item::new(Role::Furniture, Shape::Disc(DVec2::new(2.4, 5.8), 0.4)),
        Item::new(Role::Wall, Shape::Segments(walls())),
        Item::new(Role::DoorSwing, Shape::Polyline(swing([1.6, 4.6], 0.9))),
        Item::new(Role::Door, Shape::Segments(vec![segment([1.6, 4.6], [1.6, 5.5])])),
        Item::new(Role::Door, Shape::Segments(vec![segment([6.6, 4.6], [7.5, 4.6])])),
        label([2.6, 1.9], "Office", 7.0),
        label([9.6, 1.8], "Meeting room", 4.6),
        label([3.2, 3.7], "Corridor", 12.0),
        label([2.9, 6.4], "Copy room", 4.2),
        label([6.4, 5.8], "Archive", 3.8),
        label([9.4, 5.4], "Kitchen", 3.4),
    ]
}

pub(crate) fn world() -> Scene {
    let heading = 1.2;
    let robot = Pose::new(10.0, 5.5, heading);
    let fan = [
        [10.0, 5.5],
        [12.0, 4.75],
        [12.0, 7.0],
        [10.9, 7.0],
        [10.85, 6.6],
        [10.3, 6.6],
        [10.3, 7.0],
        [8.4, 7.0],
        [8.4, 6.15],
    ];
    let hits: Vec<_> = (0..=20).map(|i| DVec2::new(12.0, 4.75 + 0.11 * f64::from(i))).collect();
    let changing = [
        Item::new(Role::LaserFan, Shape::Polygon(points(&fan))),
        Item::new(Role::LaserHit, Shape::Signs(hits)),
        Item::new(Role::TruePath, Shape::Polyline(points(&way()))),
        Item::new(Role::Robot, Shape::Robot(robot, 0.25)),
    ];
    let legend = vec![
        LegendEntry::new(Sample::Robot(Role::Robot), "robot"),
        LegendEntry::new(Sample::Line(Role::TruePath), "its way"),
        LegendEntry::new(Sample::Area(Role::LaserFan), "what the laser sees"),
        LegendEntry::new(Sample::Line(Role::Door), "door"),
        LegendEntry::new(Sample::Area(Role::Furniture), "furniture"),
    ];
    let (title, note) = ("Sample office".to_owned(), "The world · 15 views · 12.4 m".to_owned());
    Scene { title, note, still: building(), changing: changing.to_vec(), views: 15, legend }
}

fn swing([x, y]: [f64; 2], length: f64) -> Vec<DVec2> {
    let turn = |i: u32| Pose::new(x, y, f64::from(i) * cogmap_geometry::trig::FRAC_PI_2 / 12.0);
    (0..=12).map(|i| turn(i) * DVec2::new(length, 0.0)).collect()
}

/// A memory that drifts a little with every view, so that walls seen twice lie apart.
pub(crate) fn memory() -> Scene {
    let drift = |view: usize| Pose::new(0.02 * view as f64, 0.01 * view as f64, 0.006 * view as f64);
    let mut still = vec![Item::new(Role::Truth, Shape::Segments(walls()))];
    for (index, wall) in walls().into_iter().enumerate() {
        for (part, view) in [(0.0, index), (0.55, (index + 3).min(14))] {
            let piece = Segment::new(wall.a.lerp(wall.b, part), wall.a.lerp(wall.b, part + 0.42));
            still.push(Item::new(Role::SurfaceOfView(view), Shape::Segments(vec![drift(view) * piece])));
        }
        let crumb = segment([0.8 * index as f64, 2.0], [0.8 * index as f64 + 0.15, 2.1]);
        still.push(Item::new(Role::DebrisOfView(index), Shape::Segments(vec![crumb])));
    }
    let way = points(&way());
    let last = DVec2::new(10.2, 5.7);
    still.push(Item::new(Role::Path, Shape::Polyline(way.clone())));
    still.push(Item::new(Role::PathStep, Shape::Signs(way.clone())));
    still.push(Item::new(Role::WeakPlacement, Shape::Signs(vec![way[8]])));
    still.push(Item::new(Role::FallbackPlacement, Shape::Signs(vec![way[10]])));
    let known = drift(8) * segment([8.4, 4.8], [8.4, 7.0]);
    let seen = drift(8) * segment([8.42, 5.1], [8.41, 6.95]);
    let changing = vec![
        Item::new(Role::SeenNow, Shape::Segments(vec![segment([9.0, 7.15], [10.6, 7.2]), seen])),
        Item::new(Role::ReferenceKnown, Shape::Segments(vec![known])),
        Item::new(Role::ReferenceSeen, Shape::Segments(vec![seen])),
        Item::new(Role::ReferenceSeen, Shape::Signs(vec![seen.a, seen.b])),
        Item::new(Role::Path, Shape::Polyline(vec![way[14], last])),
        Item::new(Role::BelievedRobot, Shape::Robot(Pose::new(last.x, last.y, 1.2), 0.25)),
        Item::new(Role::Robot, Shape::Robot(Pose::new(8.0, 1.2, 3.0), 0.25)),
    ];
    let (title, note) = ("The robot’s memory".to_owned(), "perceptual · bad robot · 15 views".to_owned());
    Scene { title, note, still, changing, views: 15, legend: memory_legend() }
}

/// The local spaces of the same building: a colour for each, exits, and the network with a closed loop.
pub(crate) fn network() -> Scene {
    let nodes = [[3.6, 1.5], [7.2, 3.7], [10.0, 5.5], [6.4, 5.8]].map(DVec2::from);
    let exits = [([5.9, 2.8], [5.0, 2.8]), ([9.4, 4.6], [10.3, 4.6]), ([7.5, 4.6], [6.6, 4.6])]
        .map(|(a, b)| segment(a, b));
    let mut still = local_spaces();
    still.extend(ways(&nodes, &exits));
    still.push(place(PlaceMark::ExitRim, Shape::Segments(exits.to_vec())));
    still.extend(gates(PlaceMark::Exit, &exits));
    still.extend(gates(PlaceMark::SupposedExit, &[segment([1.6, 4.6], [2.5, 4.6])]));
    for (asr, at) in (0..).zip(nodes) {
        still.push(place(PlaceMark::Node(asr), Shape::Signs(vec![at])));
        let text = asr.to_string();
        still.push(place(PlaceMark::Number, Shape::Label { at, text, room: 1.0 }));
    }
    still.push(place(PlaceMark::Link, line([1.0, 1.2], [9.0, 3.7])));
    still.push(place(PlaceMark::RecognisedLink, line([9.0, 3.7], [9.6, 5.0])));
    still.push(place(PlaceMark::Frame, Shape::Signs(points(&[[1.0, 1.2], [9.0, 3.7], [9.6, 5.0]]))));
    let (title, note) = ("The robot’s memory".to_owned(), "4 local spaces · 3 exits".to_owned());
    Scene { title, note, still, views: 15, legend: network_legend(), ..Scene::default() }
}

fn place(mark: PlaceMark, shape: Shape) -> Item {
    Item::new(Role::Place(mark), shape)
}

fn line(a: [f64; 2], b: [f64; 2]) -> Shape {
    Shape::Segments(vec![segment(a, b)])
}

/// Floors, and surfaces in every colour of a space and of an age.
fn local_spaces() -> Vec<Item> {
    let floors = [
        [[0.1, 0.1], [7.1, 2.7]],
        [[0.1, 2.9], [11.9, 4.5]],
        [[8.5, 4.7], [11.9, 6.9]],
        [[4.5, 4.7], [8.3, 6.9]],
    ];
    let floor = |(asr, [low, high]): (u32, [[f64; 2]; 2])| place(PlaceMark::Floor(asr), rectangle(low, high));
    let mut items: Vec<Item> = (0..).zip(floors).map(floor).collect();
    for (asr, wall) in (0..4).cycle().zip(walls()) {
        items.push(place(PlaceMark::Surface(asr), Shape::Segments(vec![wall])));
    }
    for number in 4..8 {
        let x = 1.0 + 0.5 * f64::from(number);
        items.push(place(PlaceMark::Surface(number), line([x, 1.9], [x, 2.4])));
        items.push(place(PlaceMark::Debris(number), line([x + 0.2, 1.9], [x + 0.2, 2.2])));
    }
    for age in 0..4 {
        let x = 0.4 + 0.4 * f64::from(age);
        items.push(Item::new(Role::SurfaceOfAge(age), line([x, 5.0], [x, 6.0])));
        items.push(Item::new(Role::DebrisOfAge(age), line([x + 0.2, 5.0], [x + 0.2, 6.0])));
    }
    items
}

fn ways(nodes: &[DVec2; 4], exits: &[Segment; 3]) -> Vec<Item> {
    let ends = [[0, 1], [1, 2], [3, 1]];
    let way = |(exit, [from, to]): (&Segment, [usize; 2])| {
        let way = Shape::Polyline(vec![nodes[from], exit.midpoint(), nodes[to]]);
        match from {
            3 => vec![place(PlaceMark::ClosedLoop, way.clone()), place(PlaceMark::ClosedLoopGap, way)],
            _ => vec![place(PlaceMark::Passage, way)],
        }
    };
    exits.iter().zip(ends).flat_map(way).collect()
}

fn gates(mark: PlaceMark, exits: &[Segment]) -> Vec<Item> {
    let jambs = exits.iter().flat_map(|exit| [exit.a, exit.b]);
    let signs = jambs.map(|jamb| place(mark, Shape::Signs(vec![jamb])));
    std::iter::once(place(mark, Shape::Segments(exits.to_vec()))).chain(signs).collect()
}

fn network_legend() -> Vec<LegendEntry> {
    let place = |mark| Role::Place(mark);
    vec![
        LegendEntry::new(Sample::Asrs, "a colour for each local space"),
        LegendEntry::new(Sample::Age, "first seen just now … long ago"),
        LegendEntry::new(Sample::Exit, "exit"),
        LegendEntry::new(Sample::SupposedExit, "seen, not gone through"),
        LegendEntry::new(Sample::Node, "local space"),
        LegendEntry::new(Sample::Line(place(PlaceMark::Passage)), "way through an exit"),
        LegendEntry::new(Sample::ClosedLoop, "closed a loop"),
        LegendEntry::new(Sample::Line(place(PlaceMark::Link)), "from one local frame to the next"),
        LegendEntry::new(Sample::Line(place(PlaceMark::RecognisedLink)), "a place recognised"),
        LegendEntry::new(Sample::Sign(place(PlaceMark::Frame)), "a local frame"),
    ]
}

fn memory_legend() -> Vec<LegendEntry> {
    vec![
        LegendEntry::new(Sample::Run, "first seen in view 1–15"),
        LegendEntry::new(Sample::Line(Role::SeenNow), "seen now"),
        LegendEntry::new(Sample::Line(Role::ReferenceKnown), "reference, known"),
        LegendEntry::new(Sample::Line(Role::ReferenceSeen), "reference, seen"),
        LegendEntry::new(Sample::Sign(Role::WeakPlacement), "placed with a guess"),
        LegendEntry::new(Sample::Sign(Role::FallbackPlacement), "placed by odometry"),
        LegendEntry::new(Sample::Robot(Role::BelievedRobot), "robot, where it believes it is"),
        LegendEntry::new(Sample::Robot(Role::Robot), "where it is"),
        LegendEntry::new(Sample::Line(Role::Truth), "the world"),
    ]
}
