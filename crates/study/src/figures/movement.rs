use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::{
    memory::{Matching, SurfaceId, Tracked, match_views},
    perception::View,
};
use cogmap_scene::{Annotation, Item, Panel, Role, Sample};

use super::{
    Drawing, Runs,
    draw::{arrow, dashed, degrees, lines, panel, robot, role, surfaces, word},
    stage::Stage,
};

/// A room with a niche that only the second view looks into.
const ROOM: &str = r#"{"format": "cogmap-world/1", "name": "Room with a niche", "start": {"position": [1, 1]},
    "walls": [[[0, 0], [6, 0], [6, 2.2], [7.6, 2.2], [7.6, 3.6], [6, 3.6], [6, 4.6], [3.4, 4.6], [3.4, 3.5], [0, 3.5], [0, 0]]],
    "boxes": [{"center": [4.6, 0.9], "size": [0.7, 0.5]}]}"#;
const FIRST: Pose = Pose { position: DVec2::new(1.0, 1.3), heading: -0.1 };
/// The step from the first view to the second: radians, metres.
const TURN: f64 = 0.35;
const TRAVEL: f64 = 1.6;
/// What the wrong movement adds to both.
const TURN_ERROR: f64 = 6.0 * trig::PI / 180.0;
const TRAVEL_ERROR: f64 = 0.15;

/// Two views and the true movement between them.
struct Step {
    first: View,
    second: View,
}

fn moved(turn: f64, travel: f64) -> Pose {
    Pose::new(0.0, 0.0, turn) * Pose::new(travel, 0.0, 0.0)
}

fn step() -> Result<Step, String> {
    let stage = Stage::new(ROOM)?;
    Ok(Step { first: stage.view(FIRST)?, second: stage.view(FIRST * moved(TURN, TRAVEL))? })
}

impl Step {
    /// The surfaces of the second view that the first did not see.
    fn new_ones(&self) -> Vec<usize> {
        let tracked = |surface: &_| Tracked::seen(surface, Some(SurfaceId(0)));
        let previous: Vec<Tracked> = self.first.surfaces.iter().map(tracked).collect();
        let matches =
            match_views(&self.second.surfaces, &previous, moved(TURN, TRAVEL), &Matching::default());
        (0..self.second.surfaces.len()).filter(|&seen| matches.iter().all(|m| m.seen != seen)).collect()
    }

    /// The second view laid over the first by a movement, in the first robot's frame, drawn in the
    /// world's directions.
    fn laid_over(&self, by: Pose) -> Vec<Item> {
        let map = FIRST;
        vec![
            surfaces(KNOWN, map, &self.first.surfaces),
            surfaces(SECOND, map * by, &self.second.surfaces),
            arrow(Annotation::Movement, &way(map, by)),
            robot(Role::BelievedRobot, map),
            robot(Role::Robot, map * by),
        ]
    }
}

const KNOWN: Role = role(Annotation::Known);
const SECOND: Role = role(Annotation::Added);

fn way(from: Pose, by: Pose) -> Vec<DVec2> {
    let (start, end) = (from.position, (from * by).position);
    let short = (end - start).normalize_or_zero() * 0.3;
    vec![start + short, end - short]
}

const LEGEND: [(Sample, &str); 5] = [
    (Sample::Robot(Role::BelievedRobot), "robot before"),
    (Sample::Robot(Role::Robot), "robot after"),
    (Sample::Line(role(Annotation::Movement)), "movement"),
    (Sample::Line(KNOWN), "seen in the first view"),
    (Sample::Line(SECOND), "seen in the second view"),
];

/// Fig. 3.2.
pub(super) fn transformation(_: &mut Runs) -> Result<Drawing, String> {
    let step = step()?;
    let by = moved(TURN, TRAVEL);
    let first = vec![surfaces(KNOWN, FIRST, &step.first.surfaces), robot(Role::BelievedRobot, FIRST)];
    let second = vec![surfaces(SECOND, FIRST * by, &step.second.surfaces), robot(Role::Robot, FIRST * by)];
    let panels: Vec<Panel> = vec![
        panel("The first view", first, &LEGEND[..1]),
        panel("The second view", second, &LEGEND[1..2]),
        panel("One over the other", step.laid_over(by), &LEGEND),
    ];
    Ok(Drawing {
        panels,
        columns: 3,
        outcome: format!("Here it turned by {} and travelled {TRAVEL} m.", degrees(TURN)),
        source: "two views of a robot without errors in a room made for it".to_owned(),
    })
}

/// Fig. 3.3.
pub(super) fn bad_placement(_: &mut Runs) -> Result<Drawing, String> {
    let step = step()?;
    let (right, wrong) = (moved(TURN, TRAVEL), moved(TURN + TURN_ERROR, TRAVEL + TRAVEL_ERROR));
    let mut misplaced = step.laid_over(wrong);
    let new_ones = step.new_ones();
    let longest = new_ones
        .iter()
        .filter_map(|&seen| step.second.surfaces.get(seen))
        .max_by(|a, b| a.length().total_cmp(&b.length()));
    let mut distance = 0.0;
    if let Some(surface) = longest {
        let (truth, placed) = (FIRST * right * surface.segment, FIRST * wrong * surface.segment);
        distance = truth.midpoint().distance(placed.midpoint());
        misplaced.push(lines(role(Annotation::Measure), dashed(truth, 0.12)));
        let between = Segment::new(truth.midpoint(), placed.midpoint());
        misplaced.push(arrow(Annotation::Measure, &[between.a, between.b]));
        misplaced.push(word(truth.midpoint() + DVec2::new(0.45, -0.3), format!("{distance:.2} m")));
    }
    let mut legend = LEGEND.to_vec();
    legend.push((
        Sample::Line(role(Annotation::Measure)),
        "where the new surface belongs, and how far off it is",
    ));
    Ok(Drawing {
        panels: vec![
            panel("By the true movement", step.laid_over(right), &LEGEND),
            panel("By a movement that is off by 6° and 15 cm", misplaced, &legend),
        ],
        columns: 2,
        outcome: format!("The new surface ends up {distance:.2} m from where it belongs."),
        source: "two views of a robot without errors in a room made for it".to_owned(),
    })
}
