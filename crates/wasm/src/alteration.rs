//! What a person changes in a building while a robot is in it, and where.

mod walker;

use cogmap_geometry::{DVec2, Segment, is_inside};
use cogmap_simulation::{BoxObstacle, Command, Door, Noise, Room, Session, World, WorldChange};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use walker::walker;

/// Length and width of a carton, metres.
const CARTON: f64 = 0.4;
/// A carton that is dropped before the robot lies so far from its middle, metres.
const AHEAD: f64 = 1.0;
/// Somebody who comes before the robot comes so far from its middle, metres.
const PERSON_AHEAD: f64 = 2.0;
/// A room is searched for a free place at so many points in each direction.
const PLACES: usize = 24;

/// What a person does to a building, or to a robot that must not notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Tool {
    /// Shuts a door, or opens it.
    Door,
    /// Drops a carton.
    Drop,
    /// Takes a carton or a piece of furniture away.
    Remove,
    /// Carries the robot off, unseen by its odometry.
    Carry,
    /// Lets somebody come who walks to and fro.
    Person,
    /// Makes the robot's errors larger or smaller; it works on no place.
    Noise,
}

/// Something that a person wants changed, in terms that leave the metres to the engine.
#[derive(Clone, Debug, PartialEq, Deserialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Alteration {
    /// What a tool does at a pixel of the view of the world.
    At {
        /// Which.
        tool: Tool,
        /// From the left.
        x: f64,
        /// From the top.
        y: f64,
    },
    /// Shuts or opens a door.
    Door {
        /// Its name.
        name: String,
    },
    /// Drops a carton 1 m ahead of the robot.
    DropAhead,
    /// Takes away the carton or piece of furniture that is nearest to the robot.
    RemoveNearest,
    /// Lets somebody come 2 m ahead of the robot.
    PersonAhead,
    /// Makes the robot's errors so many times its own.
    Noise {
        /// Those of its odometry.
        odometry: f64,
        /// Those of its laser.
        laser: f64,
    },
    /// Carries the robot to a room.
    CarryTo {
        /// Which, counted from 0; without one, to where the run began.
        room: Option<usize>,
    },
}

/// What speaks against a change.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Objection {
    /// Only a building that is simulated can be changed.
    NoBuilding,
    /// There is no door there.
    NoDoor,
    /// There is nothing there that could be taken away.
    NoBox,
    /// The room has no place left for the robot.
    NoPlace,
    /// A carton cannot be dropped there.
    Drop {
        /// Why.
        reason: String,
    },
    /// The door cannot be moved.
    Door {
        /// Which.
        name: String,
        /// Why.
        reason: String,
    },
    /// Nobody can come there.
    Person {
        /// Why.
        reason: String,
    },
    /// The robot cannot be set down there.
    Carry {
        /// Why.
        reason: String,
    },
}

/// Where a person points: a point of the world, and how far from it counts as there, metres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pointer {
    pub(crate) at: DVec2,
    pub(crate) reach: f64,
}

/// What the session is told; `pointer` knows where pixels of the view of the world are.
pub(crate) fn command(
    session: &Session,
    alteration: &Alteration,
    pointer: impl Fn(DVec2) -> Pointer,
) -> Result<Command, Objection> {
    let world = session.world().ok_or(Objection::NoBuilding)?;
    let robot = session.world_from_robot().ok_or(Objection::NoBuilding)?;
    match *alteration {
        Alteration::At { tool, x, y } => pointed(session, world, tool, pointer(DVec2::new(x, y))),
        Alteration::Door { ref name } => {
            world.doors.iter().find(|door| door.name == *name).map(swung).ok_or(Objection::NoDoor)
        }
        Alteration::DropAhead => Ok(dropped(robot * DVec2::new(AHEAD, 0.0), robot.heading.to_degrees())),
        Alteration::RemoveNearest => {
            let anywhere = Pointer { at: robot.position, reach: f64::INFINITY };
            nearest_box(session.boxes(), anywhere).map(removed).ok_or(Objection::NoBox)
        }
        Alteration::PersonAhead => walker(session, robot * DVec2::new(PERSON_AHEAD, 0.0)),
        Alteration::Noise { odometry, laser } => {
            Ok(Command::Change(WorldChange::Noise(Noise { odometry, laser })))
        }
        Alteration::CarryTo { room: None } => Ok(carried(session, world.start.position.into())),
        Alteration::CarryTo { room: Some(room) } => {
            let places = world.rooms.get(room).map(places).unwrap_or_default();
            let mut there = places.into_iter().map(|place| carried(session, place));
            there.find(|there| session.refusal(there).is_none()).ok_or(Objection::NoPlace)
        }
    }
}

/// What a tool does where a person points.
fn pointed(session: &Session, world: &World, tool: Tool, pointer: Pointer) -> Result<Command, Objection> {
    match tool {
        Tool::Door => nearest_door(&world.doors, pointer).map(swung).ok_or(Objection::NoDoor),
        Tool::Drop => Ok(dropped(pointer.at, 0.0)),
        Tool::Remove => nearest_box(session.boxes(), pointer).map(removed).ok_or(Objection::NoBox),
        Tool::Carry => Ok(carried(session, pointer.at)),
        Tool::Person => walker(session, pointer.at),
        Tool::Noise => Ok(Command::Change(WorldChange::Noise(session.noise()))),
    }
}

/// What a refused command is answered with.
pub(crate) fn objection(command: &Command, reason: String) -> Objection {
    match command {
        Command::Change(WorldChange::Door { name, .. }) => Objection::Door { name: name.clone(), reason },
        Command::Change(WorldChange::RemoveBox { .. }) => Objection::NoBox,
        Command::Change(WorldChange::AddPerson(_)) => Objection::Person { reason },
        Command::Kidnap { .. } => Objection::Carry { reason },
        _ => Objection::Drop { reason },
    }
}

fn swung(door: &Door) -> Command {
    Command::Change(WorldChange::Door { name: door.name.clone(), open: !door.open })
}

fn dropped(center: DVec2, heading_deg: f64) -> Command {
    let (center, heading_deg) = (to_millimetres(center), to_tenths(heading_deg));
    Command::Change(WorldChange::AddBox { center, size: [CARTON; 2], heading_deg })
}

fn removed(index: usize) -> Command {
    Command::Change(WorldChange::RemoveBox { index })
}

/// The robot set down elsewhere, facing as it did.
fn carried(session: &Session, to: DVec2) -> Command {
    let heading = session.world_from_robot().map_or(0.0, |pose| pose.heading);
    Command::Kidnap { position: to_millimetres(to), heading_deg: to_tenths(heading.to_degrees()) }
}

fn to_millimetres(point: DVec2) -> [f64; 2] {
    [point.x, point.y].map(|metres| (metres * 1000.0).round() / 1000.0)
}

fn to_tenths(degrees: f64) -> f64 {
    (degrees * 10.0).round() / 10.0
}

/// The door whose leaf or threshold is nearest to where a person points.
fn nearest_door(doors: &[Door], Pointer { at, reach }: Pointer) -> Option<&Door> {
    let away = |door: &Door| {
        let threshold = Segment::new(door.hinge.into(), door.latch.into());
        door.leaf().distance_to(at).min(threshold.distance_to(at))
    };
    let near = doors.iter().map(|door| (away(door), door)).filter(|(away, _)| *away <= reach);
    near.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, door)| door)
}

/// The number of the box that is nearest to where a person points, of several the one set down last.
fn nearest_box(boxes: &[Option<BoxObstacle>], Pointer { at, reach }: Pointer) -> Option<usize> {
    let away = |carton: &BoxObstacle| match carton.contains(at) {
        true => 0.0,
        false => carton.edges().iter().map(|edge| edge.distance_to(at)).fold(f64::INFINITY, f64::min),
    };
    let standing =
        boxes.iter().enumerate().rev().filter_map(|(index, carton)| Some((index, carton.as_ref()?)));
    let near = standing.map(|(index, carton)| (away(carton), index)).filter(|(away, _)| *away <= reach);
    near.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, index)| index)
}

/// Places all over a room, from its middle outwards.
fn places(room: &Room) -> Vec<DVec2> {
    let corners: Vec<DVec2> = room.outline.iter().copied().map(DVec2::from).collect();
    let Some(low) = corners.iter().copied().reduce(DVec2::min) else { return Vec::new() };
    let high = corners.iter().copied().fold(low, DVec2::max);
    let share = |step: usize| (step as f64 + 0.5) / PLACES as f64;
    let all = (0..PLACES * PLACES).map(|n| DVec2::new(share(n % PLACES), share(n / PLACES)));
    let mut places: Vec<DVec2> =
        all.map(|shares| low + (high - low) * shares).filter(|place| is_inside(&corners, *place)).collect();
    let middle = low.midpoint(high);
    places.sort_by(|one, other| one.distance_squared(middle).total_cmp(&other.distance_squared(middle)));
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pointer(x: f64, y: f64, reach: f64) -> Pointer {
        Pointer { at: DVec2::new(x, y), reach }
    }

    #[test]
    fn a_door_is_found_by_its_leaf_and_by_its_threshold() {
        let door = |name: &str, x: f64| Door {
            name: name.to_owned(),
            hinge: [x, 0.0],
            latch: [x + 1.0, 0.0],
            open: true,
        };
        let doors = [door("west", 0.0), door("east", 3.0)];
        let found = |x: f64, y: f64| nearest_door(&doors, pointer(x, y, 0.4)).map(|door| &*door.name);
        assert_eq!(found(0.1, 0.9), Some("west"), "by the leaf, which stands open");
        assert_eq!(found(3.9, 0.1), Some("east"), "by the threshold");
        assert_eq!(found(2.0, 0.6), None);
        assert_eq!(found(f64::NAN, 0.0), None);
    }

    #[test]
    fn of_boxes_upon_each_other_the_last_is_taken_away_and_none_that_is_gone() {
        let carton = |x: f64| Some(BoxObstacle { center: [x, 0.0], size: [0.4, 0.4], heading_deg: 0.0 });
        let boxes = [carton(0.0), carton(0.1), None, carton(2.0)];
        assert_eq!(nearest_box(&boxes, pointer(0.0, 0.0, 0.1)), Some(1));
        assert_eq!(nearest_box(&boxes, pointer(1.7, 0.0, 0.2)), Some(3));
        assert_eq!(nearest_box(&boxes, pointer(1.0, 0.0, 0.2)), None);
        assert_eq!(nearest_box(&boxes[2..3], pointer(0.0, 0.0, f64::INFINITY)), None);
    }

    #[test]
    fn places_lie_within_a_bent_room_and_begin_in_its_middle() {
        let outline = vec![[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [1.0, 2.0], [1.0, 5.0], [0.0, 5.0]];
        let room = Room { name: "bent".to_owned(), outline };
        let places = places(&room);
        assert!(places.iter().all(|place| place.y < 2.0 || place.x < 1.0));
        let from_middle = |place: &DVec2| place.distance(DVec2::new(3.0, 2.5));
        assert!(places.windows(2).all(|pair| from_middle(&pair[0]) <= from_middle(&pair[1])));
        assert!(from_middle(&places[0]) < 0.7, "{:?}", places[0]);
        assert!(super::places(&Room { name: String::new(), outline: Vec::new() }).is_empty());
    }
}
