//! What a robot on its way home has in mind, drawn alike in all figures of §3.3.

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_navigation::Decision;
use cogmap_scene::{
    Bounds, Colouring, HomingMark, Item, LegendEntry, MemoryOptions, Panel, Role, Sample, Scene,
    Shape, memory_scene,
};

use super::{
    draw::{lines, word},
    runs::Run,
};

/// A surface that the robot goes by.
pub(super) const TRUSTED: Role = Role::SurfaceOfAge(0);
const DEBRIS: Role = Role::DebrisOfAge(0);

/// A surface that it does not go by any more.
pub(super) const FORGOTTEN: Role = homing(HomingMark::Forgotten);

const fn homing(mark: HomingMark) -> Role {
    Role::Homing(mark)
}

/// What the marks mean, in the order in which they are explained.
const WORDS: [(Sample, &str); 14] = [
    (Sample::Robot(Role::BelievedRobot), "R, the robot"),
    (Sample::Robot(Role::Robot), "where it really is"),
    (Sample::Sign(homing(HomingMark::Home)), "T, home"),
    (Sample::Line(homing(HomingMark::Seen)), "option, seen to be free"),
    (Sample::Arrow(homing(HomingMark::Chosen)), "goes there now"),
    (Sample::Line(homing(HomingMark::Assumed)), "assumed way on to T"),
    (Sample::Line(homing(HomingMark::InMind)), "means to go on so"),
    (Sample::Line(homing(HomingMark::Barred)), "leads into a known dead end"),
    (Sample::Sign(homing(HomingMark::Waypoint)), "remembered waypoint"),
    (Sample::Line(homing(HomingMark::WayOut)), "way out, led by a person"),
    (Sample::Line(homing(HomingMark::WayHome)), "way home, alone"),
    (Sample::Line(TRUSTED), "MFIS, trusted"),
    (Sample::Line(FORGOTTEN), "MFIS, forgotten"),
    (Sample::Line(Role::Truth), "the world"),
];

/// What is drawn of a robot's mind.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Show {
    /// What it goes by.
    Trust,
    /// The same, and what it decides.
    Decision,
    /// The same, and where it has been.
    DecisionAndPath,
    /// Where it has been.
    Journey,
}

impl Show {
    /// Whether a mark of the way home belongs to it.
    fn has(self, mark: HomingMark) -> bool {
        match mark {
            HomingMark::Home | HomingMark::Forgotten => true,
            HomingMark::WayOut | HomingMark::WayHome => matches!(self, Self::DecisionAndPath | Self::Journey),
            _ => matches!(self, Self::Decision | Self::DecisionAndPath),
        }
    }
}

/// The robot's memory as it goes by it, in the world's directions. A journey lies where it began, all else
/// lies so that the robot is where it is.
pub(super) fn mind_of(run: &Run, show: Show) -> Scene {
    let options = MemoryOptions {
        path: matches!(show, Show::DecisionAndPath | Show::Journey),
        view: false,
        exits: false,
        colouring: Colouring::Age,
        ..MemoryOptions::default()
    };
    let world_from_map = if show == Show::Journey { run.world_from_map() } else { world_from_belief(run) };
    let mut scene = memory_scene(&run.session, 0, options).seen_from(world_from_map);
    let belongs = |item: &Item| match item.role {
        Role::Homing(mark) => show.has(mark),
        role => !matches!(role, Role::PathStep | Role::WeakPlacement | Role::FallbackPlacement),
    };
    scene.still.retain(belongs);
    scene.changing.retain(belongs);
    for item in &mut scene.still {
        item.role = in_ink(item.role);
    }
    if show == Show::Journey {
        scene.changing.retain(|item| item.role != Role::BelievedRobot);
        return over_the_world(run, scene);
    }
    scene
}

/// With the world beneath.
pub(super) fn over_the_world(run: &Run, mut scene: Scene) -> Scene {
    let world = run.session.solids().into_iter().flat_map(|solids| solids.segments.clone());
    scene.still.insert(0, lines(Role::Truth, world));
    scene
}

/// Where the map lies if the robot is where it believes to be.
pub(super) fn world_from_belief(run: &Run) -> Pose {
    let session = &run.session;
    let map_from_robot = session.mappers().first().and_then(|it| it.map_from_robot(session.odom_from_robot()));
    let both = session.world_from_robot().zip(map_from_robot);
    both.map_or(Pose::IDENTITY, |(world_from_robot, map_from_robot)| world_from_robot * map_from_robot.inverse())
}

/// One colour for all that is trusted: in these figures it does not matter when it was first seen.
fn in_ink(role: Role) -> Role {
    match role {
        Role::SurfaceOfAge(_) => TRUSTED,
        Role::DebrisOfAge(_) => DEBRIS,
        role => role,
    }
}

/// The option that was chosen drawn like the others.
pub(super) fn without_choice(mut scene: Scene) -> Scene {
    scene.changing.retain(|item| item.role != homing(HomingMark::Rim));
    for item in &mut scene.changing {
        match (item.role, &item.shape) {
            (Role::Homing(HomingMark::Chosen), Shape::Arrow(points)) => {
                *item = Item::new(homing(HomingMark::Seen), Shape::Polyline(points.clone()));
            }
            (Role::Homing(HomingMark::InMind), _) => item.role = homing(HomingMark::Assumed),
            _ => {}
        }
    }
    scene
}

/// The panel of a scene, cut to its frame, with letters beside the signs and a legend of what is drawn.
pub(super) fn panel(
    heading: impl Into<String>,
    scene: Scene,
    frame: Frame,
    more: &[(Sample, &str)],
) -> Panel {
    let mut scene = match frame.bounds {
        Some(bounds) => scene.within(bounds),
        None => scene,
    };
    let letters = Letters { lines: drawn_lines(&scene), pixel: frame.pixel(&scene) };
    let letters: Vec<Item> = scene.changing.iter().filter_map(|item| letters.beside(item)).collect();
    scene.changing.extend(letters);
    scene.legend = legend(&scene, more);
    Panel { heading: heading.into(), scene, room: frame.bounds }
}

/// What part of the world a panel shows, and how many panels there are.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) bounds: Option<Bounds>,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl Frame {
    pub(super) const WHOLE: Self = Self { bounds: None, columns: 1, rows: 1 };

    /// A rectangle of the world.
    pub(super) fn of(min: [f64; 2], max: [f64; 2]) -> Self {
        Self { bounds: Some(Bounds { min: min.into(), max: max.into() }), ..Self::WHOLE }
    }

    /// Metres that a pixel of the figure is about.
    fn pixel(self, scene: &Scene) -> f64 {
        let size = self.bounds.or_else(|| scene.bounds()).map_or(DVec2::ONE, |it| it.max - it.min);
        (size.x * self.columns as f64 / 700.0).max(size.y * self.rows as f64 / 400.0)
    }
}

/// Finds room for the letters of the signs.
struct Letters {
    lines: Vec<Segment>,
    /// Metres that a pixel is about.
    pixel: f64,
}

/// Where a letter may stand: below its sign, above, to the right, to the left and between these.
const ASIDE: [[f64; 2]; 8] =
    [[0.0, -1.0], [0.0, 1.0], [1.0, 0.0], [-1.0, 0.0], [0.7, -0.7], [-0.7, -0.7], [0.7, 0.7], [-0.7, 0.7]];

impl Letters {
    /// The letter beside a sign, where the lines leave most room for it.
    fn beside(&self, item: &Item) -> Option<Item> {
        let (at, away, letter) = match (item.role, &item.shape) {
            (Role::BelievedRobot, Shape::Robot(pose, radius)) => {
                (pose.position, radius.max(7.0 * self.pixel) + 11.0 * self.pixel, "R")
            }
            (Role::Homing(HomingMark::Home), Shape::Signs(at)) => (*at.first()?, 19.0 * self.pixel, "T"),
            _ => return None,
        };
        let room = |place: DVec2| {
            let nearest = self.lines.iter().map(|line| line.distance_to(place)).fold(f64::INFINITY, f64::min);
            nearest.min(ENOUGH * self.pixel)
        };
        let places = ASIDE.map(|aside| at + DVec2::from(aside) * away);
        let best = places.into_iter().reduce(|best, next| if room(next) > room(best) { next } else { best })?;
        Some(word(best, letter))
    }
}

/// A letter that is so far from all lines has room enough, pixels.
const ENOUGH: f64 = 12.0;

fn drawn_lines(scene: &Scene) -> Vec<Segment> {
    let of = |shape: &Shape| match shape {
        Shape::Segments(lines) => lines.clone(),
        Shape::Polyline(points) | Shape::Arrow(points) => {
            points.windows(2).map(|pair| Segment::new(pair[0], pair[1])).collect()
        }
        _ => Vec::new(),
    };
    scene.still.iter().chain(&scene.changing).flat_map(|item| of(&item.shape)).collect()
}

/// The words for what is drawn, and some more.
fn legend(scene: &Scene, more: &[(Sample, &str)]) -> Vec<LegendEntry> {
    let drawn = |wanted: Role| scene.still.iter().chain(&scene.changing).any(|item| item.role == wanted);
    let role = |sample: Sample| match sample {
        Sample::Line(role) | Sample::Arrow(role) | Sample::Area(role) | Sample::Sign(role) | Sample::Robot(role) => {
            Some(role)
        }
        _ => None,
    };
    let words = WORDS.iter().filter(|(sample, _)| role(*sample).is_some_and(drawn));
    let all_trusted = !drawn(FORGOTTEN);
    let text = |sample: Sample, text| if all_trusted && sample == Sample::Line(TRUSTED) { "MFIS" } else { text };
    words.chain(more).map(|&(sample, words)| LegendEntry::new(sample, text(sample, words))).collect()
}

/// How many options were for choice.
pub(super) fn open(decision: &Decision) -> usize {
    decision.options.iter().filter(|option| !option.barred).count()
}

/// What was decided last.
pub(super) fn decided(run: &Run) -> Result<&Decision, String> {
    run.session.journal().decisions.last().ok_or_else(|| "the robot decided nothing".to_owned())
}

/// What was run, for people.
pub(super) fn source(run: &Run) -> String {
    format!("the strategy faithful on the map of consensus, {}", run.words())
}
