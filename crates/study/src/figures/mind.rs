//! What a robot on its way home has in mind, drawn alike in all figures of §3.3.

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_navigation::Decision;
use cogmap_scene::{
    Bounds, Colouring, HomingMark, Item, LegendEntry, MemoryOptions, Panel, Role, Sample, Scene, Shape,
    memory_scene,
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
    let map_from_robot =
        session.mappers().first().and_then(|it| it.map_from_robot(session.odom_from_robot()));
    let both = session.world_from_robot().zip(map_from_robot);
    both.map_or(Pose::IDENTITY, |(world_from_robot, map_from_robot)| {
        world_from_robot * map_from_robot.inverse()
    })
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
    let mut scene = scene.within(frame.bounds);
    let letters = Letters { lines: drawn_lines(&scene), pixel: frame.pixel() };
    let letters: Vec<Item> = scene.changing.iter().filter_map(|item| letters.beside(item)).collect();
    scene.changing.extend(letters);
    scene.legend = legend(&scene, more);
    Panel { heading: heading.into(), scene, room: Some(frame.bounds) }
}

/// What part of the world a panel shows, and how many panels there are.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) bounds: Bounds,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl Frame {
    /// A rectangle of the world.
    pub(super) const fn of(min: [f64; 2], max: [f64; 2]) -> Self {
        let [min, max] = [DVec2::from_array(min), DVec2::from_array(max)];
        Self { bounds: Bounds { min, max }, columns: 1, rows: 1 }
    }

    /// Metres that a pixel of the figure is about.
    fn pixel(self) -> f64 {
        let size = self.bounds.max - self.bounds.min;
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
        let best =
            places.into_iter().reduce(|best, next| if room(next) > room(best) { next } else { best })?;
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
        Sample::Line(role)
        | Sample::Arrow(role)
        | Sample::Area(role)
        | Sample::Sign(role)
        | Sample::Robot(role) => Some(role),
        _ => None,
    };
    let words = WORDS.iter().filter(|(sample, _)| role(*sample).is_some_and(drawn));
    let all_trusted = !drawn(FORGOTTEN);
    let text =
        |sample: Sample, text| if all_trusted && sample == Sample::Line(TRUSTED) { "MFIS" } else { text };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_stands_where_no_line_runs() {
        let pose = Pose::new(2.0, 3.0, 0.0);
        let line = Segment::new(DVec2::new(-9.0, 2.6), DVec2::new(9.0, 2.6));
        let robot = Item::new(Role::BelievedRobot, Shape::Robot(pose, 0.25));
        let place = |lines: Vec<Segment>| {
            let item = Letters { lines, pixel: 0.02 }.beside(&robot).unwrap();
            let Shape::Label { at, text, .. } = item.shape else { panic!("a word") };
            assert_eq!(text, "R");
            at
        };
        assert!(place(Vec::new()).y < 3.0 && place(vec![line]).y > 3.0);
    }

    #[test]
    fn without_a_choice_the_chosen_option_looks_like_any_other() {
        let points = vec![DVec2::ZERO, DVec2::X];
        let changing = vec![
            Item::new(homing(HomingMark::Rim), Shape::Polyline(points.clone())),
            Item::new(homing(HomingMark::InMind), Shape::Polyline(points.clone())),
            Item::new(homing(HomingMark::Chosen), Shape::Arrow(points.clone())),
        ];
        let scene = without_choice(Scene { changing, ..Scene::default() });
        let line = |mark| Item::new(homing(mark), Shape::Polyline(points.clone()));
        assert_eq!(scene.changing, [line(HomingMark::Assumed), line(HomingMark::Seen)]);
    }

    #[test]
    fn only_what_is_drawn_is_explained_and_what_is_all_trusted_is_just_the_map() {
        let drawn = |role| Item::new(role, Shape::Segments(vec![Segment::new(DVec2::ZERO, DVec2::X)]));
        let text = |still| legend(&Scene { still, ..Scene::default() }, &[])[0].text.clone();
        assert_eq!(text(vec![drawn(TRUSTED)]), "MFIS");
        assert_eq!(text(vec![drawn(TRUSTED), drawn(FORGOTTEN)]), "MFIS, trusted");
    }
}
